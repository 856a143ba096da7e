// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "radcert/geometry/plane_polygon.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// The kernel integrated by brute force, in long double: signed fans of triangles over the loops, each halved
/// until a product of Gauss rules sees no change. Nothing behind the tangent plane is cut off.
class KernelQuadrature {
public:
  using Number = long double;
  struct Value {
    Number signed_part = 0;
    Number absolute = 0;  ///< of the integrand, cancelling triangles counted twice
    bool converged = true;
  };

  KernelQuadrature(const PlanePolygon& polygon, const PlanePolynomial<Rational>& q)
      : origin_(rounded(polygon.origin())),
        first_(rounded(polygon.first())),
        second_(rounded(polygon.second())),
        normal_(cross(first_, second_)),
        q_(q.degree()) {
    for (int n = 0; n <= q.degree(); ++n) {
      for (int j = 0; j <= n; ++j) q_(n - j, j) = from_rational<Number>(q(n - j, j));
    }
    for (const PolygonLoop& loop : polygon.loops()) {
      std::vector<Corner> corners;
      for (const auto& at : loop)
        corners.push_back({from_rational<Number>(at.s), from_rational<Number>(at.t)});
      for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        triangles_.push_back({corners[0], corners[k], corners[k + 1]});
      }
    }
    gauss_rule();
  }

  [[nodiscard]] Value integral(const Vector<Rational>& p, const Vector<Rational>& normal) const {
    const Vector<Number> unit = rounded(normal);
    Value sum;
    for (const Triangle& triangle : triangles_) {
      const Value part = refined(triangle, over(triangle, rounded(p), unit), rounded(p), unit, 0);
      sum.signed_part += part.signed_part;
      sum.absolute += part.absolute;
      sum.converged = sum.converged && part.converged;
    }
    const Number length = std::sqrt(dot(unit, unit));
    sum.signed_part /= length;
    sum.absolute /= length;
    return sum;
  }

private:
  using Corner = ParameterPoint<Number>;
  using Triangle = std::array<Corner, 3>;
  static constexpr std::size_t points = 16;

  static Vector<Number> rounded(const Vector<Rational>& a) {
    return {from_rational<Number>(a.x), from_rational<Number>(a.y), from_rational<Number>(a.z)};
  }

  void gauss_rule() {
    for (std::size_t k = 0; k < points; ++k) {
      Number x = std::cos(std::numbers::pi_v<Number> * (static_cast<Number>(k) + 0.75L) / (points + 0.5L));
      Number slope = 0;
      for (int step = 0; step < 6; ++step) {
        Number before = 1;
        Number value = x;
        for (std::size_t n = 2; n <= points; ++n) {
          const auto m = static_cast<Number>(n);
          const Number next = ((2 * m - 1) * x * value - (m - 1) * before) / m;
          before = value;
          value = next;
        }
        slope = points * (x * value - before) / (x * x - 1);
        x -= value / slope;
      }
      node_[k] = (1 + x) / 2;
      weight_[k] = 1 / ((1 - x * x) * slope * slope);
    }
  }

  [[nodiscard]] Value over(const Triangle& triangle, const Vector<Number>& p,
                           const Vector<Number>& normal) const {
    Value sum;
    const Corner u = triangle[1] - triangle[0];
    const Corner v = triangle[2] - triangle[1];
    const Number jacobian = cross(u, v);
    for (std::size_t i = 0; i < points; ++i) {
      for (std::size_t j = 0; j < points; ++j) {
        const Corner at = triangle[0] + node_[i] * (u + node_[j] * v);
        const Vector<Number> d = origin_ + at.s * first_ + at.t * second_ - p;
        const Number squared = dot(d, d);
        const Number term = weight_[i] * weight_[j] * node_[i] * jacobian * (dot(d, normal) / squared) *
                            (-dot(d, normal_) / squared) * q_.value(at.s, at.t);
        sum.signed_part += term;
        sum.absolute += std::abs(term);
      }
    }
    return sum;
  }

  [[nodiscard]] Value refined(const Triangle& triangle, const Value& coarse, const Vector<Number>& p,
                              const Vector<Number>& normal, int depth) const {
    const auto middle = [&](std::size_t a, std::size_t b) { return 0.5L * (triangle[a] + triangle[b]); };
    const Corner ab = middle(0, 1);
    const Corner bc = middle(1, 2);
    const Corner ca = middle(2, 0);
    const std::array<Triangle, 4> parts{Triangle{triangle[0], ab, ca}, Triangle{ab, triangle[1], bc},
                                        Triangle{ca, bc, triangle[2]}, Triangle{ab, bc, ca}};
    std::array<Value, 4> values;
    Value sum;
    for (std::size_t k = 0; k < 4; ++k) {
      values[k] = over(parts[k], p, normal);
      sum.signed_part += values[k].signed_part;
      sum.absolute += values[k].absolute;
    }
    if (std::abs(sum.signed_part - coarse.signed_part) <= 1e-14L * sum.absolute) return sum;
    constexpr int deepest = 8;
    if (depth == deepest) {
      sum.converged = false;
      return sum;
    }
    Value result;
    for (std::size_t k = 0; k < 4; ++k) {
      const Value part = refined(parts[k], values[k], p, normal, depth + 1);
      result.signed_part += part.signed_part;
      result.absolute += part.absolute;
      result.converged = result.converged && part.converged;
    }
    return result;
  }

  Vector<Number> origin_;
  Vector<Number> first_;
  Vector<Number> second_;
  Vector<Number> normal_;
  PlanePolynomial<Number> q_;
  std::vector<Triangle> triangles_;
  std::array<Number, points> node_{};
  std::array<Number, points> weight_{};
};

}  // namespace radcert
