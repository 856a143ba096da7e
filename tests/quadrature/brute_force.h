// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/basis_limits.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"
#include "radcert/surface/surface_point.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

using Long = long double;

/// The charts of a surface of the catalogue in long double.
inline std::vector<std::unique_ptr<ChartIn<Long>>> long_charts(const Surface& surface) {
  std::vector<std::unique_ptr<ChartIn<Long>>> charts;
  const auto add = [&]<class Formula>(const Formula& formula) {
    const Orientation orientation = surface.charts[charts.size()].facts().orientation;
    charts.push_back(std::make_unique<ChartOf<Long, Formula>>(formula, orientation));
  };
  const auto parameter = [&](std::size_t i) { return surface.parameters.at(i).value; };
  if (surface.name == "cube" || surface.name == "box") {
    const bool unit = surface.name == "cube";
    const std::array<Rational, 3> side{unit ? Rational(1) : parameter(0), unit ? Rational(1) : parameter(1),
                                       unit ? Rational(1) : parameter(2)};
    const std::array<Vector<Rational>, 3> sides{{{side[0], 0, 0}, {0, side[1], 0}, {0, 0, side[2]}}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const Vector<Rational>& origin : {Vector<Rational>{0, 0, 0}, sides[axis]})
        add(Rectangle<Long>(origin, sides[(axis + 1) % 3], sides[(axis + 2) % 3]));
  } else if (surface.name == "sphere" || surface.name == "ellipsoid") {
    const bool unit = surface.name == "sphere";
    for (const int z : {1, -1})
      for (const int y : {1, -1})
        for (const int x : {1, -1})
          add(EllipsoidOctant<Long>(unit ? Rational(1) : parameter(0), unit ? Rational(1) : parameter(1),
                                    unit ? Rational(1) : parameter(2), Octant{x, y, z}));
  } else if (surface.name == "two_piece") {
    add(Rectangle<Long>({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    add(PowerRoof<Long>(parameter(0)));
  } else if (surface.name == "two_squares") {
    add(Rectangle<Long>({0, 0, 0}, {1, 0, 0}, {0, 0, 1}));
    add(Rectangle<Long>({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  } else {
    throw std::invalid_argument("no charts in long double for " + surface.name);
  }
  return charts;
}

/// How much work the brute force does.
struct Effort {
  int points = 18;           ///< Gauss points a variable and cell
  Long ratio = 2.4L;         ///< a cell is cut until the observer is that many radii away from its centre
  Long stretch = 0.22L;      ///< and on curved charts until it is no wider than this in the parameters
  int gathered_points = 36;  ///< a variable and half interval on a chart that is not analytic
};

/// Int_Delta G(P,Q) l_j(Q) dS_Q in long double, by rules that share nothing with the library's.
/// Maths     P off the element: the triangle is sliced along s, slices are cut in s and t towards P,
///           Gauss-Legendre in both; on the chart with the singular line s = 0: in sqrt(s), which makes a
///           half-integer power analytic. P on the element: polar coordinates about P, the opposite side cut
///           towards P
/// Requires  a surface that `long_charts` knows; powers whole or 3/2
/// Result    about 1e-18 of Int |G l_j|, or the rounding of long double where that is worse; P is the image
///           of the exact parameters, not a rounded point
/// Limits    slow
class BruteForce {
public:
  struct Integral {
    std::vector<Long> value;
    std::vector<Long> size;  ///< Int |G l_j|
    /// What moving P against Q by X would do to the numerator of G, to first order, X the largest coordinate
    /// of P and of the element's vertices: Int X (|(Q-P).n_P| + |(P-Q).n_Q|) |l_j| / |P-Q|^4; `around` leaves
    /// it 0
    std::vector<Long> moved;
    Long total = 0;  ///< Int G

    explicit Integral(std::size_t functions) : value(functions), size(functions), moved(functions) {}
  };

  explicit BruteForce(const Surface& surface) : charts_(long_charts(surface)) {
    for (const Chart& chart : surface.charts) {
      flat_.push_back(chart.facts().plane.has_value());
      singular_.push_back(chart.facts().singular != SingularLine::none);
    }
    if (surface.name == "sphere" || surface.name == "ellipsoid")
      for (const int z : {1, -1})
        for (const int y : {1, -1})
          for (const int x : {1, -1}) octants_.push_back({x, y, z});
  }

  const ChartIn<Long>& chart(std::size_t index) const { return *charts_[index]; }

  /// By the cheaper method that is accurate.
  Integral integrate(const SurfacePoint<double>& p, const ParameterTriangle& element,
                     const InsetBasis<Long>& basis, const Effort& effort = {}) const {
    const Place seen = seen_from(element.chart, p);
    const bool own = seen.chart == element.chart && least_coordinate(seen, element) > -1e-10L;
    const bool graded = singular_[element.chart] && p.at.s > 1e-6;
    return own && !graded ? around(p, element, basis, effort) : away(p, element, basis, effort);
  }

  /// Polar coordinates: P on the element, or off it by a rounding (then one of the triangles counts
  /// negative).
  Integral around(const SurfacePoint<double>& p, const ParameterTriangle& element,
                  const InsetBasis<Long>& basis, const Effort& effort = {}) const {
    const Sum sum(*this, seen_from(element.chart, p), element, basis, effort);
    return sum.around();
  }

  /// Cells cut towards P. Cells smaller than 1e-12 of the element are left out: they hold 1e-23 of its area.
  Integral away(const SurfacePoint<double>& p, const ParameterTriangle& element,
                const InsetBasis<Long>& basis, const Effort& effort = {}) const {
    const Sum sum(*this, seen_from(element.chart, p), element, basis, effort);
    return sum.away();
  }

private:
  using Point = ParameterPoint<Long>;

  static Point exactly(const ParameterPoint<double>& p) {
    return {static_cast<Long>(p.s), static_cast<Long>(p.t)};
  }

  /// A point by its chart and parameters in long double.
  using Place = SurfacePoint<Long>;

  /// P as the element's chart sees it where it can: octants continue one another analytically, since
  /// F(s,t) = diag(a,b,c) e/|e| with e = (1-s-t, s, t) up to signs does not depend on the length of e.
  Place seen_from(std::size_t chart, const SurfacePoint<double>& p) const {
    const Place same{p.chart, exactly(p.at)};
    if (octants_.empty() || p.chart == chart) return same;
    const Octant& a = octants_[p.chart];
    const Octant& b = octants_[chart];
    const Long u = static_cast<Long>(a.x * b.x) * (1 - same.at.s - same.at.t);
    const Long s = static_cast<Long>(a.y * b.y) * same.at.s;
    const Long t = static_cast<Long>(a.z * b.z) * same.at.t;
    const Long sum = u + s + t;
    return sum < 0.5L ? same : Place{chart, {s / sum, t / sum}};
  }

  static Long least_coordinate(const Place& p, const ParameterTriangle& element) {
    std::array<Point, 3> v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = exactly(element.vertices[i]);
    Long least = 1;
    for (std::size_t i = 0; i < 3; ++i)
      least = std::min(least,
                       cross(v[(i + 1) % 3] - p.at, v[(i + 2) % 3] - p.at) / cross(v[1] - v[0], v[2] - v[0]));
    return least;
  }

  /// The part of a triangle between two lines s = const: lower and upper ends of the slices at s0 and s1.
  struct Half {
    Long s0, s1;
    std::array<Long, 2> lower, upper;
  };
  /// A part of a Half: x runs along s (or sqrt(s)), y along t.
  struct Patch {
    Long x0, x1, y0, y1;
  };

  static const IntervalRule<Long>& gauss(int points) {
    static const std::vector<IntervalRule<Long>> rules = [] {
      std::vector<IntervalRule<Long>> all;
      for (int n = 1; n <= 48; ++n) all.push_back(gauss_rule<Long>(n, IntervalWeight::one));
      return all;
    }();
    return rules[static_cast<std::size_t>(points - 1)];
  }

  class Sum {
  public:
    Sum(const BruteForce& force, const Place& p, const ParameterTriangle& element,
        const InsetBasis<Long>& basis, const Effort& effort)
        : chart_(*force.charts_[element.chart]),
          flat_(force.flat_[element.chart]),
          singular_(force.singular_[element.chart]),
          same_chart_(p.chart == element.chart),
          p_(p.at),
          at_p_(force.charts_[p.chart]->frame(p_)),
          normal_(unit_normal(at_p_)),
          basis_(basis),
          effort_(effort) {
      for (std::size_t i = 0; i < 3; ++i) v_[i] = exactly(element.vertices[i]);
      whole_ = cross(v_[1] - v_[0], v_[2] - v_[0]);
      const auto note = [this](const Vector<Long>& x) {
        largest_coordinate_ = std::max({largest_coordinate_, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
      };
      note(at_p_.point);
      for (const Point& v : v_) note(chart_.frame(v).point);
    }

    Integral away() const {
      Integral result(basis_.size());
      std::array<Point, 3> v = v_;
      std::sort(v.begin(), v.end(), [](const Point& a, const Point& b) { return a.s < b.s; });
      // The long side's t above the middle vertex.
      const Long middle = v[0].t + (v[2].t - v[0].t) * ((v[1].s - v[0].s) / (v[2].s - v[0].s));
      if (v[1].s > v[0].s) cut({v[0].s, v[1].s, {v[0].t, v[0].t}, {v[1].t, middle}}, result);
      if (v[2].s > v[1].s) cut({v[1].s, v[2].s, {v[1].t, middle}, {v[2].t, v[2].t}}, result);
      return result;
    }

    Integral around() const {
      Integral result(basis_.size());
      for (std::size_t i = 0; i < 3; ++i) {
        const Point a = v_[i] - p_;
        const Point b = v_[(i + 1) % 3] - p_;
        if (std::abs(cross(a, b)) < 1e-19L * whole_) continue;
        cut_side(a, b, 0, 1, 0, result);
      }
      return result;
    }

  private:
    void add(const Point& q, const Point& w, Long weight, bool count_movement, Integral& result) const {
      const Frame<Long> frame = chart_.frame(q);
      const Long g =
          weight * (same_chart_ ? chord_kernel(chart_.chord(p_, w), normal_, frame.area_normal)
                                : geometric_kernel(at_p_.point, normal_, frame.point, frame.area_normal));
      Barycentric<Long> x;
      for (std::size_t i = 0; i < 3; ++i) x.x[i] = cross(v_[(i + 1) % 3] - q, v_[(i + 2) % 3] - q) / whole_;
      Long movement = 0;
      if (count_movement) {
        const Vector<Long> d = frame.point - at_p_.point;
        const Long tilted =
            std::abs(dot(d, normal_)) * norm(frame.area_normal) + std::abs(dot(d, frame.area_normal));
        movement = std::abs(weight) * largest_coordinate_ * tilted / power(norm(d), 4);
      }
      std::array<Long, most_basis_functions> l;
      basis_.values(x, l);
      result.total += g;
      for (std::size_t j = 0; j < basis_.size(); ++j) {
        result.value[j] += g * l[j];
        result.size[j] += std::abs(g * l[j]);
        result.moved[j] += movement * std::abs(l[j]);
      }
    }

    /// The point of a half at (x, y), and the Jacobian ds dt / dx dy in `jacobian`.
    Point at(const Half& half, Long x, Long y, Long& jacobian) const {
      Long s;
      Long slope;
      if (singular_) {
        const Long r0 = std::sqrt(half.s0);
        const Long r1 = std::sqrt(half.s1);
        const Long r = r0 + (r1 - r0) * x;
        s = r * r;
        slope = 2 * r * (r1 - r0);
      } else {
        s = half.s0 + (half.s1 - half.s0) * x;
        slope = half.s1 - half.s0;
      }
      const Long part = (s - half.s0) / (half.s1 - half.s0);
      const Long a = half.lower[0] + (half.upper[0] - half.lower[0]) * part;
      const Long b = half.lower[1] + (half.upper[1] - half.lower[1]) * part;
      jacobian = slope * std::abs(b - a);
      return {s, a + (b - a) * y};
    }

    void cut(const Half& half, Integral& result) const {
      const Long smallest = 1e-12L * extents(half, {0, 1, 0, 1}).radius;
      std::vector<Patch> pending{{0, 1, 0, 1}};
      while (!pending.empty()) {
        const Patch patch = pending.back();
        pending.pop_back();
        const Extents e = extents(half, patch);
        if (e.radius < smallest) continue;
        const bool far = norm(at_p_.point - e.centre) >= effort_.ratio * e.radius;
        if (far && (flat_ || std::max(e.parameter_x, e.parameter_y) <= effort_.stretch)) {
          integrate_patch(half, patch, result);
          continue;
        }
        const bool by_x = far ? e.parameter_x > e.parameter_y : e.x > e.y;
        const Long x = (patch.x0 + patch.x1) / 2;
        const Long y = (patch.y0 + patch.y1) / 2;
        if (by_x) {
          pending.push_back({patch.x0, x, patch.y0, patch.y1});
          pending.push_back({x, patch.x1, patch.y0, patch.y1});
        } else {
          pending.push_back({patch.x0, patch.x1, patch.y0, y});
          pending.push_back({patch.x0, patch.x1, y, patch.y1});
        }
      }
    }

    struct Extents {
      Vector<Long> centre;
      Long radius;
      Long x, y;  ///< lengths of the image along x and along y
      Long parameter_x, parameter_y;
    };

    Extents extents(const Half& half, const Patch& patch) const {
      const auto place = [&](int i, int k) {
        Long unused;
        return at(half, patch.x0 + (patch.x1 - patch.x0) * static_cast<Long>(i) / 2,
                  patch.y0 + (patch.y1 - patch.y0) * static_cast<Long>(k) / 2, unused);
      };
      std::array<std::array<Point, 3>, 3> q;
      std::array<std::array<Vector<Long>, 3>, 3> image;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          q[i][k] = place(static_cast<int>(i), static_cast<int>(k));
          image[i][k] = chart_.frame(q[i][k]).point;
        }
      Extents e{image[1][1], 0, 0, 0, 0, 0};
      const auto length = [](const Point& a) { return std::hypot(a.s, a.t); };
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) e.radius = std::max(e.radius, norm(image[i][k] - e.centre));
        e.x = std::max(e.x, norm(image[2][i] - image[0][i]));
        e.y = std::max(e.y, norm(image[i][2] - image[i][0]));
        e.parameter_x = std::max(e.parameter_x, length(q[2][i] - q[0][i]));
        e.parameter_y = std::max(e.parameter_y, length(q[i][2] - q[i][0]));
      }
      return e;
    }

    void integrate_patch(const Half& half, const Patch& patch, Integral& result) const {
      const IntervalRule<Long>& rule = gauss(effort_.points);
      const Long area = (patch.x1 - patch.x0) * (patch.y1 - patch.y0);
      for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
          Long jacobian;
          const Point q = at(half, patch.x0 + (patch.x1 - patch.x0) * rule.nodes[i],
                             patch.y0 + (patch.y1 - patch.y0) * rule.nodes[k], jacobian);
          add(q, q - p_, rule.weights[i] * rule.weights[k] * area * jacobian, true, result);
        }
    }

    Vector<Long> along(const Point& w) const { return w.s * at_p_.tangent_s + w.t * at_p_.tangent_t; }

    /// The part m0 <= m <= m1 of the triangle (p, p + a, p + b).
    void cut_side(const Point& a, const Point& b, Long m0, Long m1, int depth, Integral& result) const {
      const Long m = (m0 + m1) / 2;
      const Vector<Long> side = along(b - a);
      const Long half = (m1 - m0) / 2;
      const bool far = norm(along(a + m * (b - a))) >= effort_.ratio * half * norm(side);
      const bool short_enough = half * std::hypot((b - a).s, (b - a).t) <= effort_.stretch;
      if ((!far || !short_enough) && depth < 70) {
        cut_side(a, b, m0, m, depth + 1, result);
        cut_side(a, b, m, m1, depth + 1, result);
        return;
      }
      const std::vector<std::array<Long, 3>> radial = radial_rule(a, b);
      const std::vector<std::array<Long, 3>> across = singular_ ? graded() : plain(1);
      const Long jacobian = cross(a, b) * (m1 - m0);
      for (const auto& [l, rest_l, weight_l] : radial)
        for (const auto& [y, rest_y, weight_y] : across) {
          const Long to_b = m0 + (m1 - m0) * y;
          const Long to_a = (1 - m1) + (m1 - m0) * rest_y;
          Point w = l * (to_a * a + to_b * b);
          if (singular_) {
            // s of q is a sum of non-negative terms: no digits are lost near s = 0.
            const Long s = rest_l * p_.s + l * (to_a * (p_.s + a.s) + to_b * (p_.s + b.s));
            add({std::max(s, 0.0L), p_.t + w.t}, {std::max(w.s, -p_.s), w.t},
                weight_l * weight_y * l * jacobian, false, result);
          } else {
            add(p_ + w, w, weight_l * weight_y * l * jacobian, false, result);
          }
        }
    }

    /// Triples (y, 1 - y, weight) on [0,1] in equal panels.
    std::vector<std::array<Long, 3>> plain(int panels) const {
      const IntervalRule<Long>& rule = gauss(effort_.points);
      std::vector<std::array<Long, 3>> all;
      for (int i = 0; i < panels; ++i)
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
          const Long y = (static_cast<Long>(i) + rule.nodes[k]) / static_cast<Long>(panels);
          all.push_back({y, 1 - y, rule.weights[k] / static_cast<Long>(panels)});
        }
      return all;
    }

    /// Two halves, y = x^8/2 and 1 - y = x^8/2.
    std::vector<std::array<Long, 3>> graded() const {
      const IntervalRule<Long>& rule = gauss(effort_.gathered_points);
      std::vector<std::array<Long, 3>> all;
      for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const Long x = rule.nodes[k];
        const Long y = power(x, 8) / 2;
        const Long weight = 4 * power(x, 7) * rule.weights[k];
        all.push_back({y, 1 - y, weight});
        all.push_back({1 - y, y, weight});
      }
      return all;
    }

    std::vector<std::array<Long, 3>> radial_rule(const Point& a, const Point& b) const {
      if (singular_) return graded();
      const Long longest = std::max(std::hypot(a.s, a.t), std::hypot(b.s, b.t));
      return plain(std::max(1, static_cast<int>(std::ceil(longest / effort_.stretch))));
    }

    const ChartIn<Long>& chart_;
    bool flat_;
    bool singular_;
    bool same_chart_;
    Point p_;
    Frame<Long> at_p_;
    Vector<Long> normal_;
    const InsetBasis<Long>& basis_;
    Effort effort_;
    std::array<Point, 3> v_;
    Long whole_;
    Long largest_coordinate_ = 0;
  };

  std::vector<std::unique_ptr<ChartIn<Long>>> charts_;
  std::vector<bool> flat_;
  std::vector<bool> singular_;
  std::vector<Octant> octants_;  ///< of each chart; empty on other surfaces
};

}  // namespace radcert
