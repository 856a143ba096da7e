// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/apex_rule.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "radcert/core/lazy_table.h"
#include "radcert/core/work_limit.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/quadrature/bernstein.h"
#include "radcert/quadrature/even_shape.h"

namespace radcert {
namespace {

/// Where the orders start for the finest tolerance, and for any.
constexpr int first_order_at_finest = 6;
constexpr int smallest_first_order = 4;
template <Real R>
constexpr int last_order = std::is_same_v<R, double> ? 22 : 70;
constexpr int order_step = 6;
/// The finer rule has this many points more in each variable. Where the chart is not analytic, or does not
/// change evenly, the rules converge so slowly that two points more leave an error larger than the
/// difference.
constexpr int check_step_analytic = 2;
constexpr int check_step_slow = 6;
constexpr double admissible_ellipse = 3.0;
const WorkLimit deepest_bisection("quadrature/apex_rule: bisections of a side", 60, 0,
                                  "all that the element may hold joins the radius");
const WorkLimit deepest_halving("quadrature/apex_rule: halvings of a rectangle", 40, 0,
                                "all that the element may hold joins the radius");
const WorkLimit most_rectangles("quadrature/apex_rule: rectangles", 1000, 0,
                                "all that the element may hold joins the radius");

/// Points of [0,1] with their distances from both ends, free of cancellation; padded to whole blocks by zero
/// weights.
template <Real R>
struct Nodes {
  std::size_t count = 0;
  std::vector<R> from_zero;
  std::vector<R> from_one;
  std::vector<R> weights;
};

/// Gauss-Legendre on [0,1]; graded: x = B(y), B' = 51480 y^7 (1-y)^7, so that powers of the distance from
/// either end become eight times as smooth. 51480 = 1/Beta(8,8).
template <Real R>
Nodes<R> make_nodes(int points, bool graded) {
  const IntervalRule<R> gauss = gauss_rule<R>(graded ? 2 * points : points, IntervalWeight::one);
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
    nodes.from_zero.push_back(graded ? from_end(y) : y);
    nodes.from_one.push_back(graded ? from_end(R(1) - y) : R(1) - y);
    nodes.weights.push_back(graded ? gauss.weights[i] * R(51480) * power(y * (R(1) - y), 7)
                                   : gauss.weights[i]);
  }
  nodes.count = nodes.weights.size();
  for (std::size_t i = nodes.count; i < padded<R>(nodes.count); ++i) {
    nodes.from_zero.push_back(nodes.from_zero.back());
    nodes.from_one.push_back(nodes.from_one.back());
    nodes.weights.push_back(R(0));
  }
  return nodes;
}

template <Real R>
const Nodes<R>& nodes(int points, bool graded) {
  constexpr std::size_t sizes = last_order<R> + check_step_slow + 1;
  constexpr int most_graded = std::is_same_v<R, double> ? 32 : 80;
  static LazyTable<Nodes<R>, 2 * sizes> tables;
  const int n = graded ? std::min(points, most_graded) : points;
  return tables.at((graded ? sizes : 0) + static_cast<std::size_t>(n),
                   [&] { return make_nodes<R>(n, graded); });
}

/// Where the rays from the collocation point through the side (a, b) enter or leave the element.
enum class Extent {
  to_side,      ///< from p itself to the side: p lies in the element
  up_to_side,   ///< from another side to this one, the far one
  beyond_side,  ///< from this side, the near one, to another
};

/// What the rays from the collocation point through a side (a, b) meet of the element.
/// Maths     p + l ((1-m) (a-p) + m (b-p)), 0 <= m <= 1, l between 1 and cut(m), the place of the other
///           side's line on the ray: cut(m) = offset / ((1-m) slope_a + m slope_b); 0 where p lies in the
///           element
template <Real R>
struct ApexTriangle {
  ParameterPoint<R> to_a;  ///< a - p
  ParameterPoint<R> to_b;
  Barycentric<R> at_p;  ///< in the element's coordinates
  Barycentric<R> at_a;
  Barycentric<R> at_b;
  Extent extent = Extent::to_side;
  R offset{};   ///< n . (c - p) for the other side's line through c, normal to n
  R slope_a{};  ///< n . (a - p)
  R slope_b{};

  /// Twice its area in the parameter plane, that of the triangle (p, a, b).
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
  ApexIntegrator(const CollocationPoint<R>& p, const Chart& chart, const TriangleBasis<R>& basis,
                 const Tolerance& tolerance)
      : p_(p),
        formula_(chart.in<B>()),
        scalar_formula_(chart.in<R>()),
        basis_(basis),
        tolerance_(tolerance),
        first_order_(first_order(tolerance)),
        singular_(chart.facts().singular != SingularLine::none),
        check_step_(singular_ ? check_step_slow : check_step_analytic),
        at_p_(chart.in<R>().frame(p.at.at)) {}

  CheckedSums<R> integrate(const ApexTriangle<R>& triangle) {
    CheckedSums<R> result(basis_.size());
    integrate_sides(triangle, R(0), R(1), 0, result);
    return result;
  }

private:
  using B = typename Block<R>::Type;

  static int first_order(const Tolerance& tolerance) {
    const double digits =
        std::log(tolerance.intended_truncation()) / std::log(Tolerance().intended_truncation());
    return std::max(smallest_first_order, static_cast<int>(std::ceil(digits * first_order_at_finest)));
  }

  /// Bisects the side until its Bernstein ellipse stays clear of the poles.
  void integrate_sides(const ApexTriangle<R>& triangle, const R& m0, const R& m1, int depth,
                       CheckedSums<R>& result) {
    const double rho = ellipse(triangle, m0, m1);
    if (!(rho >= admissible_ellipse)) {
      if (depth >= deepest_bisection_) {
        result.complete = false;
        return;
      }
      const R middle = (m0 + m1) / R(2);
      integrate_sides(triangle, m0, middle, depth + 1, result);
      integrate_sides(triangle, middle, m1, depth + 1, result);
      return;
    }
    integrate_rectangle(triangle, {R(0), R(1), m0, m1},
                        points_for(rho, basis_.degree(), tolerance_.intended_truncation()), 0, result);
  }

  /// The smaller ellipse about [m0,m1] of those through the zeros of |DF(p) w(m)|^2, a quadratic in m, and
  /// through the pole of the cut.
  double ellipse(const ApexTriangle<R>& triangle, const R& m0, const R& m1) const {
    const Vector<R> start = along(triangle.to_a);
    const Vector<R> side = along(triangle.to_b - triangle.to_a);
    const auto squared = nearest_double<R>(dot(side, side));
    const double real_part = -nearest_double<R>(dot(start, side)) / squared;
    const double imaginary_part = nearest_double<R>(norm(cross(start, side))) / squared;
    const auto middle = nearest_double<R>((m0 + m1) / R(2));
    const auto half = nearest_double<R>((m1 - m0) / R(2));
    const double rho = bernstein_radius({(real_part - middle) / half, imaginary_part / half});
    if (triangle.extent == Extent::to_side) return rho;
    const auto change = nearest_double<R>(triangle.slope_a - triangle.slope_b);
    if (change == 0) return rho;
    const double pole_of_cut = nearest_double<R>(triangle.slope_a) / change;
    return std::min(rho, bernstein_radius({(pole_of_cut - middle) / half, 0}));
  }

  Vector<R> along(const ParameterPoint<R>& w) const { return w.s * at_p_.tangent_s + w.t * at_p_.tangent_t; }

  void integrate_rectangle(const ApexTriangle<R>& triangle, const Rectangle<R>& area, int across, int depth,
                           CheckedSums<R>& result) {
    CheckedSums<R> best(basis_.size());
    if (++rectangles_ > most_rectangles_) {
      result.complete = false;
      return;
    }
    if (const auto halves = halves_of_uneven(triangle, area)) {
      if (depth >= deepest_halving_) {
        result.complete = false;
        return;
      }
      for (const Rectangle<R>& half : *halves) integrate_rectangle(triangle, half, across, depth + 1, result);
      return;
    }
    for (int order = first_order_; order <= last_order<R>; order += order_step) {
      const int side_order = std::clamp(across + order - first_order_, 4, last_order<R>);
      best.sums = sums(triangle, area, order + check_step_, side_order + check_step_);
      const KernelSums<R> coarser = sums(triangle, area, order, side_order);
      if (compare(best, coarser)) {
        result += best;
        return;
      }
    }
    if (depth >= deepest_halving_) {
      result.complete = false;
      return;
    }
    for (const Rectangle<R>& half : halves(triangle, area, across, best.sums))
      integrate_rectangle(triangle, half, across, depth + 1, result);
  }

  static std::array<Rectangle<R>, 2> halves_along_l(const Rectangle<R>& area) {
    const R l = (area.l0 + area.l1) / R(2);
    return {Rectangle<R>{area.l0, l, area.m0, area.m1}, Rectangle<R>{l, area.l1, area.m0, area.m1}};
  }
  static std::array<Rectangle<R>, 2> halves_along_m(const Rectangle<R>& area) {
    const R m = (area.m0 + area.m1) / R(2);
    return {Rectangle<R>{area.l0, area.l1, area.m0, m}, Rectangle<R>{area.l0, area.l1, m, area.m1}};
  }

  /// The normal at a point of a rectangle, from_cut of the way from the cut to the side on the ray m.
  Vector<R> normal_at(const ApexTriangle<R>& triangle, const R& from_cut, const R& m) const {
    const R other = R(1) - m;
    R l = from_cut;
    if (triangle.extent != Extent::to_side) {
      const R cut = triangle.offset / (other * triangle.slope_a + m * triangle.slope_b);
      l = cut + from_cut * (R(1) - cut);
    }
    ParameterPoint<R> w = l * (other * triangle.to_a + m * triangle.to_b);
    if (singular_) w.s = std::max(w.s, -p_.at.at.s);
    return scalar_formula_.frame(p_.at.at + w).area_normal;
  }

  /// The halves of a rectangle on which the chart does not change evenly along three lines of either
  /// direction; sets the step of checks.
  std::optional<std::array<Rectangle<R>, 2>> halves_of_uneven(const ApexTriangle<R>& triangle,
                                                              const Rectangle<R>& area) {
    std::array<std::array<Vector<R>, 3>, 3> normal;  // by l, by m
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        normal[i][k] = normal_at(triangle, area.l0 + R(static_cast<int>(i)) / R(2) * (area.l1 - area.l0),
                                 area.m0 + R(static_cast<int>(k)) / R(2) * (area.m1 - area.m0));
    R along_l = R(0);
    R along_m = R(0);
    for (std::size_t k = 0; k < 3; ++k) {
      along_l = std::max(along_l, unevenness(normal[0][k], normal[1][k], normal[2][k]));
      along_m = std::max(along_m, unevenness(normal[k][0], normal[k][1], normal[k][2]));
    }
    const R largest = std::max(along_l, along_m);
    if (!(largest < R(uneven_for_close_rules))) check_step_ = check_step_slow;
    if (!(largest < R(uneven_for_any_rule)))
      return along_l >= along_m ? halves_along_l(area) : halves_along_m(area);
    return std::nullopt;
  }

  /// The rectangle cut across the variable in which fewer points cost more.
  std::array<Rectangle<R>, 2> halves(const ApexTriangle<R>& triangle, const Rectangle<R>& area, int across,
                                     const KernelSums<R>& best) const {
    const int fine = last_order<R> + check_step_;
    const int side = std::clamp(across + last_order<R> - first_order_, 4, last_order<R>);
    const R by_l = largest_difference(sums(triangle, area, last_order<R> / 2, side + check_step_), best);
    const R by_m = largest_difference(sums(triangle, area, fine, side / 2), best);
    return by_l > by_m ? halves_along_l(area) : halves_along_m(area);
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
    share_largest_difference(fine, R(tolerance_.intended_truncation()));
    return largest_difference <= R(tolerance_.converged()) * largest_size_ + noise;
  }

  /// A point of a ray.
  struct OnRay {
    B l;
    B rest;    ///< 1 - l
    B length;  ///< of the ray between cut and side, in l
  };

  /// The point of ray m that lies from_cut of the way from the cut to the side.
  static OnRay along_ray(const ApexTriangle<R>& triangle, const B& m, const B& other, const B& from_cut,
                         const B& from_side) {
    if (triangle.extent == Extent::to_side) return {from_cut, from_side, B(R(1))};
    const B cut = B(triangle.offset) / (other * B(triangle.slope_a) + m * B(triangle.slope_b));
    const B rest_of_cut = B(R(1)) - cut;
    const B length = triangle.extent == Extent::up_to_side ? rest_of_cut : -rest_of_cut;
    return {from_side * cut + from_cut, from_side * rest_of_cut, length};
  }

  KernelSums<R> sums(const ApexTriangle<R>& triangle, const Rectangle<R>& area, int radial,
                     int across) const {
    using std::max;
    const Nodes<R>& l_nodes = nodes<R>(radial, singular_);
    const Nodes<R>& m_nodes = nodes<R>(across, singular_);
    const R jacobian = triangle.size() * (area.l1 - area.l0) * (area.m1 - area.m0);
    const ParameterPoint<B> at_p{B(p_.at.at.s), B(p_.at.at.t)};
    const Vector<B> normal_p{B(p_.normal.x), B(p_.normal.y), B(p_.normal.z)};
    KernelSumsByLane<R> by_lane(basis_.size());
    std::array<B, KernelSums<R>::most_functions> values;
    for (std::size_t i = 0; i < l_nodes.count; ++i) {
      const B from_cut = B(area.l0 + (area.l1 - area.l0) * l_nodes.from_zero[i]);
      const B from_side = B((R(1) - area.l1) + (area.l1 - area.l0) * l_nodes.from_one[i]);
      const B l_weight = B(l_nodes.weights[i] * jacobian);
      for (std::size_t k = 0; k < m_nodes.weights.size(); k += Block<R>::lanes) {
        const B m = B(area.m0) + B(area.m1 - area.m0) * Block<R>::load(&m_nodes.from_zero[k]);
        const B other = B(R(1) - area.m1) + B(area.m1 - area.m0) * Block<R>::load(&m_nodes.from_one[k]);
        const auto [l, rest, length] = along_ray(triangle, m, other, from_cut, from_side);
        ParameterPoint<B> w{l * (other * B(triangle.to_a.s) + m * B(triangle.to_b.s)),
                            l * (other * B(triangle.to_a.t) + m * B(triangle.to_b.t))};
        if (singular_) w.s = max(w.s, -at_p.s);  // rounding must not cross the line s = 0
        const Frame<B> q = formula_.frame(at_p + w);
        const RoundedKernel<B> g = rounded_kernel<B>(formula_.chord(at_p, w), normal_p, q.area_normal);
        const B weight = l * length * l_weight * Block<R>::load(&m_nodes.weights[k]);
        Barycentric<B> x;
        for (std::size_t c = 0; c < 3; ++c)
          x.x[c] =
              rest * B(triangle.at_p.x[c]) + l * (other * B(triangle.at_a.x[c]) + m * B(triangle.at_b.x[c]));
        basis_.values(x, std::span<B>(values));
        by_lane.add(weight * g.value, weight * g.lean, [&values](std::size_t j) { return values[j]; });
      }
    }
    return by_lane.sums(l_nodes.count + m_nodes.count);
  }

  const CollocationPoint<R>& p_;
  const ChartIn<B>& formula_;
  const ChartIn<R>& scalar_formula_;
  const TriangleBasis<R>& basis_;
  const Tolerance& tolerance_;
  int first_order_;
  bool singular_;
  int check_step_;
  Frame<R> at_p_;
  R largest_size_{};
  std::size_t rectangles_ = 0;
  const std::size_t most_rectangles_ = most_rectangles.count();
  const long deepest_bisection_ = deepest_bisection.value();
  const long deepest_halving_ = deepest_halving.value();
};

/// The lines of sight from p through the sides of the element.
template <Real R>
std::vector<ApexTriangle<R>> seen_from(const ParameterPoint<R>& p, const ElementPart<R>& element) {
  using std::abs;
  const auto& v = element.vertices;
  const R whole = cross(v[1] - v[0], v[2] - v[0]);
  // A triangle that thin is the rounding of a collocation point on the side's line: what it holds is below 16
  // u of the element's integral, and `rounding` allows for 60 u.
  const R negligible = R(16) * unit_roundoff<R>() * whole;
  Barycentric<R> at_p;
  std::array<R, 3> part;  // of side i: positive on its inner side
  std::size_t near_sides = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    part[i] = cross(v[i] - p, v[(i + 1) % 3] - p);
    if (part[i] < -negligible) ++near_sides;
    for (std::size_t c = 0; c < 3; ++c) at_p.x[c] += part[i] / whole * element.corners[(i + 2) % 3].x[c];
  }
  std::vector<ApexTriangle<R>> triangles;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    ApexTriangle<R> triangle{.to_a = v[i] - p,
                             .to_b = v[j] - p,
                             .at_p = at_p,
                             .at_a = element.corners[i],
                             .at_b = element.corners[j]};
    if (!(triangle.size() > negligible)) continue;
    const bool is_near = part[i] < R(0);
    if (near_sides == 1 && is_near) continue;   // the rays through the two far sides start at it
    if (near_sides == 2 && !is_near) continue;  // the rays through the two near sides end at it
    if (near_sides != 0) {
      std::size_t other = 0;  // the only side of the other kind
      for (std::size_t k = 0; k < 3; ++k)
        if ((part[k] < -negligible) != is_near && abs(part[k]) > negligible) other = k;
      const ParameterPoint<R> along = v[(other + 1) % 3] - v[other];
      triangle.extent = is_near ? Extent::beyond_side : Extent::up_to_side;
      triangle.offset = part[other];
      triangle.slope_a = cross(triangle.to_a, along);
      triangle.slope_b = cross(triangle.to_b, along);
    }
    triangles.push_back(triangle);
  }
  // The largest first: it sets the scale at which the others count as converged.
  std::sort(triangles.begin(), triangles.end(),
            [](const ApexTriangle<R>& a, const ApexTriangle<R>& b) { return a.size() > b.size(); });
  return triangles;
}

}  // namespace

template <Real R>
CheckedSums<R> integrate_around(const CollocationPoint<R>& p, const Chart& chart,
                                const ElementPart<R>& element, const TriangleBasis<R>& basis,
                                const Tolerance& tolerance) {
  ApexIntegrator<R> integrator(p, chart, basis, tolerance);
  CheckedSums<R> result(basis.size());
  for (const ApexTriangle<R>& triangle : seen_from(p.at.at, element))
    result += integrator.integrate(triangle);
  return result;
}

template CheckedSums<double> integrate_around<double>(const CollocationPoint<double>&, const Chart&,
                                                      const ElementPart<double>&,
                                                      const TriangleBasis<double>&, const Tolerance&);
template CheckedSums<Mpfr<50>> integrate_around<Mpfr<50>>(const CollocationPoint<Mpfr<50>>&, const Chart&,
                                                          const ElementPart<Mpfr<50>>&,
                                                          const TriangleBasis<Mpfr<50>>&, const Tolerance&);

}  // namespace radcert
