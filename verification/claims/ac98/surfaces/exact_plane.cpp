// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/exact_plane.h"

#include <algorithm>

#include "radcert/scalar/real.h"

namespace radcert::verification::ac98 {
namespace {

// The coordinates s, t, u of (56) as polynomials in x and y, in the order of the vertices v_1, v_2, v_3.
std::array<ExactPolynomial, 3> coordinates(const PlanarTriangle& v) {
  const auto doubled = [](const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  };
  const Rational area = doubled(v[0], v[1], v[2]);
  const ExactPolynomial x = ExactPolynomial::monomial(1, 0);
  const ExactPolynomial y = ExactPolynomial::monomial(0, 1);
  std::array<ExactPolynomial, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const PlanarPoint& a = v.at((i + 1) % 3);
    const PlanarPoint& b = v.at((i + 2) % 3);
    result.at(i) = ExactPolynomial(1 / area) *
                   (ExactPolynomial(a.y - b.y) * (x - a.x) + ExactPolynomial(b.x - a.x) * (y - a.y));
  }
  return result;
}

}  // namespace

ExactPolynomial::ExactPolynomial(const Rational& constant) {
  if (constant.sign() != 0) terms_[{0, 0}] = constant;
}

ExactPolynomial ExactPolynomial::monomial(int a, int b) {
  ExactPolynomial result;
  result.terms_[{a, b}] = 1;
  return result;
}

Rational ExactPolynomial::operator()(const PlanarPoint& p) const {
  Rational sum = 0;
  for (const auto& [exponents, c] : terms_)
    sum += c * power(p.x, exponents.first) * power(p.y, exponents.second);
  return sum;
}

ExactPolynomial ExactPolynomial::by_x() const {
  ExactPolynomial result;
  for (const auto& [exponents, c] : terms_)
    if (exponents.first > 0)
      result.terms_[{exponents.first - 1, exponents.second}] = c * Rational(exponents.first);
  return result;
}

ExactPolynomial ExactPolynomial::by_y() const {
  ExactPolynomial result;
  for (const auto& [exponents, c] : terms_)
    if (exponents.second > 0)
      result.terms_[{exponents.first, exponents.second - 1}] = c * Rational(exponents.second);
  return result;
}

Rational ExactPolynomial::integral_over(const std::vector<PlanarPoint>& polygon) const {
  Rational sum = 0;
  for (const auto& [exponents, c] : terms_) sum += c * integral(polygon, exponents.first, exponents.second);
  return sum;
}

ExactPolynomial& ExactPolynomial::operator+=(const ExactPolynomial& other) {
  for (const auto& [exponents, c] : other.terms_) {
    Rational& mine = terms_[exponents];
    mine += c;
    if (mine.sign() == 0) terms_.erase(exponents);
  }
  return *this;
}

ExactPolynomial ExactPolynomial::operator-() const {
  ExactPolynomial result = *this;
  for (auto& [exponents, c] : result.terms_) c = -c;
  return result;
}

ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b) {
  ExactPolynomial result;
  for (const auto& [p, c] : a.terms_)
    for (const auto& [q, d] : b.terms_) {
      const std::pair<int, int> exponents{p.first + q.first, p.second + q.second};
      Rational& sum = result.terms_[exponents];
      sum += c * d;
      if (sum.sign() == 0) result.terms_.erase(exponents);
    }
  return result;
}

std::vector<ExactPolynomial> derivatives(const ExactPolynomial& f, int order) {
  std::vector<ExactPolynomial> result{f};
  for (int k = 0; k < order; ++k) {
    const ExactPolynomial last = result.back().by_y();
    for (ExactPolynomial& each : result) each = each.by_x();
    result.push_back(last);
  }
  return result;
}

ExactPolynomial taylor(const ExactPolynomial& f, const PlanarPoint& about, int degree) {
  const ExactPolynomial dx = ExactPolynomial::monomial(1, 0) - about.x;
  const ExactPolynomial dy = ExactPolynomial::monomial(0, 1) - about.y;
  const auto over_factorial = [](const ExactPolynomial& d, int exponent) {
    ExactPolynomial result(1);
    for (int m = 1; m <= exponent; ++m) result = ExactPolynomial(Rational(1, m)) * result * d;
    return result;
  };
  ExactPolynomial sum;
  for (int k = 0; k <= degree; ++k) {
    const std::vector<ExactPolynomial> of_order = derivatives(f, k);
    for (int b = 0; b <= k; ++b)
      sum += ExactPolynomial(of_order.at(static_cast<std::size_t>(b))(about)) * over_factorial(dx, k - b) *
             over_factorial(dy, b);
  }
  return sum;
}

ExactPolynomial interpolant(const PlanarTriangle& triangle, const Rational& alpha, const ExactPolynomial& f) {
  const auto [s, t, u] = coordinates(triangle);
  const std::vector<PlanarPoint> nodes = printed_rule(triangle, alpha).points;
  const ExactPolynomial scale(1 / (1 - 3 * alpha));
  return ExactPolynomial(f(nodes[0])) * scale * (u - alpha) +
         ExactPolynomial(f(nodes[1])) * scale * (t - alpha) +
         ExactPolynomial(f(nodes[2])) * scale * (s - alpha);
}

Rational interpolation_error(const ExactPolynomial& phi, const ExactPolynomial& f,
                             const std::vector<PlanarTriangle>& triangles, const Rational& alpha) {
  Rational sum = 0;
  for (const PlanarTriangle& triangle : triangles)
    sum += (phi * (f - interpolant(triangle, alpha, f))).integral_over({triangle.begin(), triangle.end()});
  return sum;
}

std::vector<ExactPolynomial> monomials(int largest_degree) {
  std::vector<ExactPolynomial> result;
  for (int degree = 0; degree <= largest_degree; ++degree)
    for (int b = 0; b <= degree; ++b) result.push_back(ExactPolynomial::monomial(degree - b, b));
  return result;
}

Rational products_missed(int order, const std::vector<PlanarTriangle>& triangles, const Rational& alpha) {
  long count = 0;
  for (int i = 0; i <= order; ++i)
    for (int b = 0; b <= i; ++b)
      for (const ExactPolynomial& phi : monomials(order - i))
        if (interpolation_error(phi, ExactPolynomial::monomial(i - b, b), triangles, alpha) != 0) ++count;
  return {count};
}

Rational largest_at(const std::vector<PlanarPoint>& points, const std::vector<ExactPolynomial>& functions) {
  Rational largest = 0;
  for (const PlanarPoint& p : points)
    for (const ExactPolynomial& f : functions) largest = std::max(largest, abs(f(p)));
  return largest;
}

}  // namespace radcert::verification::ac98
