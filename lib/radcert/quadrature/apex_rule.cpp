// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/apex_rule.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/gauss.h"
#include "radcert/quadrature/bernstein.h"

namespace radcert {
namespace {

constexpr int first_order = 10;
constexpr int last_order = 22;
constexpr int order_step = 6;
/// The finer rule has this many points more in each variable. Where the chart is not analytic the gathered rules converge
/// so slowly that two points more leave an error larger than the difference.
constexpr int check_step_analytic = 2;
constexpr int check_step_gathered = 6;
constexpr double admissible_ellipse = 3.0;
constexpr int deepest_bisection = 60;  // of a side
constexpr int deepest_halving = 40;    // of a rectangle

/// Points of [0,1] with their distances from both ends, free of cancellation.
template <Real R>
struct Nodes {
  std::vector<R> from_zero;
  std::vector<R> from_one;
  std::vector<R> weights;
};

/// Gauss-Legendre on [0,1]; gathered: x = B(y), B' = 51480 y^7 (1-y)^7, so that powers of the distance from either end
/// become eight times as smooth. 51480 = 1/Beta(8,8).
template <Real R>
Nodes<R> make_nodes(int points, bool gathered) {
  const IntervalRule<R> gauss = gauss_rule<R>(gathered ? 2 * points : points, IntervalWeight::one);
  // B(y) = y^8 sum_k C(7+k, 7) (1-y)^k, k = 0..7: the distribution function of Beta(8,8).
  const auto from_end = [](const R& y) {
    R sum = R(0);
    R term = R(1);
    for (int k = 0; k < 8; ++k) {
      sum += term;
      term = term * (R(1) - y) * R(8 + k) / R(k + 1);
    }
    return power(y, 8) * sum;
  };
  Nodes<R> nodes;
  for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
    const R& y = gauss.nodes[i];
    nodes.from_zero.push_back(gathered ? from_end(y) : y);
    nodes.from_one.push_back(gathered ? from_end(R(1) - y) : R(1) - y);
    nodes.weights.push_back(gathered ? gauss.weights[i] * R(51480) * power(y * (R(1) - y), 7)
                                     : gauss.weights[i]);
  }
  return nodes;
}

template <Real R>
const Nodes<R>& nodes(int points, bool gathered) {
  static const auto tables = [] {
    std::array<std::vector<Nodes<R>>, 2> result;
    for (const bool gather : {false, true})
      for (int n = 1; n <= last_order + check_step_gathered; ++n)
        result[gather ? 1 : 0].push_back(make_nodes<R>(gather ? std::min(n, 32) : n, gather));
    return result;
  }();
  return tables[gathered ? 1 : 0][static_cast<std::size_t>(points - 1)];
}

/// A triangle (p, a, b) with its apex at the observer.
template <Real R>
struct ApexTriangle {
  ParameterPoint<R> to_a;  ///< a - p
  ParameterPoint<R> to_b;
  Barycentric<R> at_p;  ///< in the element's coordinates
  Barycentric<R> at_a;
  Barycentric<R> at_b;

  /// Twice its area in the parameter plane.
  R size() const {
    using std::abs;
    return abs(cross(to_a, to_b));
  }
};

/// A rectangle of the variables (l, m).
template <Real R>
struct Rectangle {
  R l0, l1, m0, m1;
};

template <Real R>
class ApexIntegrator {
public:
  ApexIntegrator(const Observer<R>& p, const Chart& chart, const InsetBasis<R>& basis)
      : p_(p),
        formula_(chart.in<R>()),
        basis_(basis),
        singular_(chart.facts().singular != SingularLine::none),
        check_step_(singular_ ? check_step_gathered : check_step_analytic),
        at_p_(formula_.frame(p.at.at)) {}

  CheckedSums<R> integrate(const ApexTriangle<R>& triangle) {
    CheckedSums<R> result(basis_.size());
    integrate_sides(triangle, R(0), R(1), 0, result);
    return result;
  }

private:
  /// Bisects the side until its Bernstein ellipse stays clear of the poles.
  void integrate_sides(const ApexTriangle<R>& triangle, const R& m0, const R& m1, int depth,
                       CheckedSums<R>& result) {
    const double rho = ellipse(triangle, m0, m1);
    if (rho < admissible_ellipse && depth < deepest_bisection) {
      const R middle = (m0 + m1) / R(2);
      integrate_sides(triangle, m0, middle, depth + 1, result);
      integrate_sides(triangle, middle, m1, depth + 1, result);
      return;
    }
    integrate_rectangle(triangle, {R(0), R(1), m0, m1}, points_for(rho, basis_.degree()), 0, result);
  }

  /// The ellipse about [m0,m1] through the zeros of |DF(p) w(m)|^2, a quadratic in m.
  double ellipse(const ApexTriangle<R>& triangle, const R& m0, const R& m1) const {
    const Vector<R> start = along(triangle.to_a);
    const Vector<R> side = along(triangle.to_b - triangle.to_a);
    const auto squared = static_cast<double>(dot(side, side));
    const double real_part = -static_cast<double>(dot(start, side)) / squared;
    const double imaginary_part = static_cast<double>(norm(cross(start, side))) / squared;
    const auto middle = static_cast<double>((m0 + m1) / R(2));
    const auto half = static_cast<double>((m1 - m0) / R(2));
    return bernstein_radius({(real_part - middle) / half, imaginary_part / half});
  }

  Vector<R> along(const ParameterPoint<R>& w) const { return w.s * at_p_.tangent_s + w.t * at_p_.tangent_t; }

  void integrate_rectangle(const ApexTriangle<R>& triangle, const Rectangle<R>& area, int across, int depth,
                           CheckedSums<R>& result) {
    CheckedSums<R> best(basis_.size());
    for (int order = first_order; order <= last_order; order += order_step) {
      const int side_order = std::clamp(across + order - first_order, 4, last_order);
      best.sums = sums(triangle, area, order + check_step_, side_order + check_step_);
      const KernelSums<R> coarser = sums(triangle, area, order, side_order);
      if (compare(best, coarser)) {
        result += best;
        return;
      }
    }
    if (depth >= deepest_halving) {
      result += best;
      return;
    }
    for (const Rectangle<R>& half : halves(triangle, area, across, best.sums))
      integrate_rectangle(triangle, half, across, depth + 1, result);
  }

  /// The rectangle cut across the variable in which fewer points cost more.
  std::array<Rectangle<R>, 2> halves(const ApexTriangle<R>& triangle, const Rectangle<R>& area, int across,
                                     const KernelSums<R>& best) const {
    const int fine = last_order + check_step_;
    const int side = std::clamp(across + last_order - first_order, 4, last_order);
    const R by_l = largest_difference(sums(triangle, area, last_order / 2, side + check_step_), best);
    const R by_m = largest_difference(sums(triangle, area, fine, side / 2), best);
    const R l = (area.l0 + area.l1) / R(2);
    const R m = (area.m0 + area.m1) / R(2);
    if (by_l > by_m)
      return {Rectangle<R>{area.l0, l, area.m0, area.m1}, Rectangle<R>{l, area.l1, area.m0, area.m1}};
    return {Rectangle<R>{area.l0, area.l1, area.m0, m}, Rectangle<R>{area.l0, area.l1, m, area.m1}};
  }

  static R largest_difference(const KernelSums<R>& a, const KernelSums<R>& b) {
    using std::abs;
    R largest = R(0);
    for (std::size_t j = 0; j < a.functions; ++j) largest = std::max(largest, abs(a.value[j] - b.value[j]));
    return largest;
  }

  /// Notes the differences; true if they are negligible beside what has been summed up so far.
  bool compare(CheckedSums<R>& fine, const KernelSums<R>& coarse) {
    using std::abs;
    R largest_difference = R(0);
    R noise = R(0);
    for (std::size_t j = 0; j < basis_.size(); ++j) {
      fine.difference[j] = abs(fine.sums.value[j] - coarse.value[j]);
      largest_difference = std::max(largest_difference, fine.difference[j]);
      largest_size_ = std::max(largest_size_, fine.sums.size[j]);
      noise = std::max(noise, R(4) * unit_roundoff<R>() * fine.sums.tilt[j]);
    }
    return largest_difference <= R(converged_difference) * largest_size_ + noise;
  }

  KernelSums<R> sums(const ApexTriangle<R>& triangle, const Rectangle<R>& area, int radial,
                     int across) const {
    using std::abs;
    using std::max;
    const Nodes<R>& l_nodes = nodes<R>(radial, singular_);
    const Nodes<R>& m_nodes = nodes<R>(across, singular_);
    const R jacobian = cross(triangle.to_a, triangle.to_b) * (area.l1 - area.l0) * (area.m1 - area.m0);
    KernelSums<R> result(basis_.size());
    std::array<R, KernelSums<R>::most_functions> values;
    for (std::size_t i = 0; i < l_nodes.weights.size(); ++i) {
      const R l = area.l0 + (area.l1 - area.l0) * l_nodes.from_zero[i];
      const R rest = (R(1) - area.l1) + (area.l1 - area.l0) * l_nodes.from_one[i];
      for (std::size_t k = 0; k < m_nodes.weights.size(); ++k) {
        const R m = area.m0 + (area.m1 - area.m0) * m_nodes.from_zero[k];
        const R other = (R(1) - area.m1) + (area.m1 - area.m0) * m_nodes.from_one[k];
        ParameterPoint<R> w = l * (other * triangle.to_a + m * triangle.to_b);
        if (singular_) w.s = max(w.s, -p_.at.at.s);  // rounding must not cross the line s = 0
        const Frame<R> q = formula_.frame(p_.at.at + w);
        const Chord<R> chord = formula_.chord(p_.at.at, w);
        const R weight = l * l_nodes.weights[i] * m_nodes.weights[k] * jacobian;
        const R g = weight * chord_kernel(chord, p_.normal, q.area_normal);
        const R lean = abs(weight) * chord_lean(chord, p_.normal, q.area_normal);
        Barycentric<R> x;
        for (std::size_t c = 0; c < 3; ++c)
          x.x[c] = rest * triangle.at_p.x[c] + l * (other * triangle.at_a.x[c] + m * triangle.at_b.x[c]);
        basis_.values(x, values);
        result.total += g;
        result.total_size += abs(g);
        for (std::size_t j = 0; j < basis_.size(); ++j) {
          const R term = g * values[j];
          result.value[j] += term;
          result.size[j] += abs(term);
          result.tilt[j] += lean * abs(values[j]);
        }
      }
    }
    result.points = l_nodes.weights.size() + m_nodes.weights.size();
    return result;
  }

  const Observer<R>& p_;
  const ChartIn<R>& formula_;
  const InsetBasis<R>& basis_;
  bool singular_;
  int check_step_;
  Frame<R> at_p_;
  R largest_size_{};
};

}  // namespace

template <Real R>
CheckedSums<R> integrate_around(const Observer<R>& p, const Chart& chart, const Cell<R>& element,
                                const InsetBasis<R>& basis) {
  const auto& v = element.vertices;
  const R whole = cross(v[1] - v[0], v[2] - v[0]);
  Barycentric<R> at_p;
  for (std::size_t i = 0; i < 3; ++i) {
    const R part = cross(v[(i + 1) % 3] - p.at.at, v[(i + 2) % 3] - p.at.at) / whole;
    for (std::size_t c = 0; c < 3; ++c) at_p.x[c] += part * element.corners[i].x[c];
  }
  std::vector<ApexTriangle<R>> triangles;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const ApexTriangle<R> triangle{v[i] - p.at.at, v[j] - p.at.at, at_p, element.corners[i],
                                   element.corners[j]};
    // A triangle that thin is the rounding of an observer on the side: what it holds is below 16 u of the element's
    // integral, and `rounding` allows for 60 u.
    if (triangle.size() > R(16) * unit_roundoff<R>() * whole) triangles.push_back(triangle);
  }
  // The largest first: it sets the scale at which the others count as converged.
  std::sort(triangles.begin(), triangles.end(),
            [](const ApexTriangle<R>& a, const ApexTriangle<R>& b) { return a.size() > b.size(); });
  ApexIntegrator<R> integrator(p, chart, basis);
  CheckedSums<R> result(basis.size());
  for (const ApexTriangle<R>& triangle : triangles) result += integrator.integrate(triangle);
  return result;
}

template CheckedSums<double> integrate_around<double>(const Observer<double>&, const Chart&,
                                                      const Cell<double>&, const InsetBasis<double>&);

}  // namespace radcert
