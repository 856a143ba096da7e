// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/planar_rule.h"

#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/scalar/real.h"

namespace radcert::verification::ac98 {
namespace {

Rational signed_area(const std::vector<PlanarPoint>& polygon) {
  Rational twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanarPoint& p = polygon[i];
    const PlanarPoint& q = polygon[(i + 1) % polygon.size()];
    twice += p.x * q.y - q.x * p.y;
  }
  return twice / 2;
}

RationalPolynomial to_the(int exponent, const RationalPolynomial& base) {
  RationalPolynomial result = 1;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

Rational integral_from_0_to_1(const RationalPolynomial& p) {
  Rational sum = 0;
  for (int k = 0; k <= p.degree(); ++k) sum += p.coefficient(static_cast<std::size_t>(k)) / (k + 1);
  return sum;
}

}  // namespace

PlanarRule printed_rule(const std::array<PlanarPoint, 3>& triangle, const Rational& alpha) {
  const Rational far = 1 - 2 * alpha;
  const std::vector<PlanarPoint> nodes{{alpha, alpha}, {alpha, far}, {far, alpha}};  // (s,t)
  PlanarRule rule;
  for (const auto& [s, t] : nodes) {
    const Rational u = 1 - s - t;
    rule.points.push_back({u * triangle[2].x + t * triangle[1].x + s * triangle[0].x,
                           u * triangle[2].y + t * triangle[1].y + s * triangle[0].y});
    rule.weights.push_back(abs(signed_area({triangle.begin(), triangle.end()})) / 3);
  }
  return rule;
}

PlanarRule together(const PlanarRule& a, const PlanarRule& b) {
  PlanarRule both = a;
  both.points.insert(both.points.end(), b.points.begin(), b.points.end());
  both.weights.insert(both.weights.end(), b.weights.begin(), b.weights.end());
  return both;
}

Rational integral(const std::vector<PlanarPoint>& polygon, int a, int b) {
  const RationalPolynomial z = RationalPolynomial::variable();
  Rational sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanarPoint& p = polygon[i];
    const PlanarPoint& q = polygon[(i + 1) % polygon.size()];
    const RationalPolynomial x = RationalPolynomial(q.x - p.x) * z + p.x;
    const RationalPolynomial y = RationalPolynomial(q.y - p.y) * z + p.y;
    sum += integral_from_0_to_1(to_the(a + 1, x) * to_the(b, y)) * (q.y - p.y);
  }
  return sum / (a + 1) * signed_area(polygon).sign();
}

Rational missed(const PlanarRule& rule, const std::vector<PlanarPoint>& polygon, int a, int b) {
  Rational sum = 0;
  for (std::size_t j = 0; j < rule.points.size(); ++j)
    sum += rule.weights[j] * power(rule.points[j].x, a) * power(rule.points[j].y, b);
  return sum - integral(polygon, a, b);
}

int precision(const PlanarRule& rule, const std::vector<PlanarPoint>& polygon) {
  for (int degree = 0;; ++degree)  // ends: no rule with n points is exact of degree 2n
    for (int b = 0; b <= degree; ++b)
      if (missed(rule, polygon, degree - b, b) != 0) return degree - 1;
}

}  // namespace radcert::verification::ac98
