// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "radcert/scalar/rational.h"
#include "verification/claims/ac98/surfaces/planar_rule.h"

namespace radcert::verification::ac98 {

/// A polynomial of the coordinates x and y of the plane.
/// Maths     sum c_ab x^a y^b
/// Requires  exponents >= 0
/// Result    exact; terms with c_ab = 0 are not kept, so that size() counts the coefficients that are not
///           zero
class ExactPolynomial {
public:
  ExactPolynomial() = default;
  ExactPolynomial(const Rational& constant);  // NOLINT(google-explicit-constructor): exact
  ExactPolynomial(int constant)
      : ExactPolynomial(Rational(constant)) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] static ExactPolynomial monomial(int a, int b);

  [[nodiscard]] std::size_t size() const { return terms_.size(); }
  [[nodiscard]] Rational operator()(const PlanarPoint& p) const;
  [[nodiscard]] ExactPolynomial by_x() const;
  [[nodiscard]] ExactPolynomial by_y() const;
  /// Int over a simple polygon.
  [[nodiscard]] Rational integral_over(const std::vector<PlanarPoint>& polygon) const;

  ExactPolynomial& operator+=(const ExactPolynomial& other);
  [[nodiscard]] ExactPolynomial operator-() const;
  [[nodiscard]] friend ExactPolynomial operator+(ExactPolynomial a, const ExactPolynomial& b) {
    return a += b;
  }
  [[nodiscard]] friend ExactPolynomial operator-(ExactPolynomial a, const ExactPolynomial& b) {
    return a += -b;
  }
  friend ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b);

private:
  std::map<std::pair<int, int>, Rational> terms_;
};

/// The derivatives of one order: D_x^i D_y^(order-i) f, i = order, ..., 0.
[[nodiscard]] std::vector<ExactPolynomial> derivatives(const ExactPolynomial& f, int order);

/// The Taylor polynomial of f about a point.
[[nodiscard]] ExactPolynomial taylor(const ExactPolynomial& f, const PlanarPoint& about, int degree);

using PlanarTriangle = std::array<PlanarPoint, 3>;

/// Linear interpolation as it is printed, and not as the library makes it.
/// Maths     L f = sum f(mu(q_i)) l_i, mu(s,t) = u v_3 + t v_2 + s v_1, l_1 = (u - a)/(1 - 3a), l_2 = (t -
///           a)/(1 - 3a), l_3 = (s - a)/(1 - 3a), {q_i} = {(a,a), (a,1-2a), (1-2a,a)}, a = alpha
/// Source    [ac98, (33)-(34), (56)]
/// Requires  alpha != 1/3, a triangle with an area
/// Result    exact
[[nodiscard]] ExactPolynomial interpolant(const PlanarTriangle& triangle, const Rational& alpha,
                                          const ExactPolynomial& f);

/// Int phi (f - L f) over the triangles, each with its own interpolant.
[[nodiscard]] Rational interpolation_error(const ExactPolynomial& phi, const ExactPolynomial& f,
                                           const std::vector<PlanarTriangle>& triangles,
                                           const Rational& alpha);

/// All monomials with degree at most this.
[[nodiscard]] std::vector<ExactPolynomial> monomials(int largest_degree);

/// How many products of monomials, phi of degree j and f of degree i with i + j <= order, are not integrated
/// exactly.
/// Maths     Int phi (f - L f) != 0. Over h times the triangles, the origin staying in its place, the
///           coefficient of h^(i+j+2) in the error is a sum of such integrals with phi and f homogeneous: 0
///           proves that the error of every pair of polynomials has no power of h below order + 3
/// Result    exact
[[nodiscard]] Rational products_missed(int order, const std::vector<PlanarTriangle>& triangles,
                                       const Rational& alpha);

/// Largest of |f| over the vertices: a lower bound of its maximum.
[[nodiscard]] Rational largest_at(const std::vector<PlanarPoint>& points,
                                  const std::vector<ExactPolynomial>& functions);

}  // namespace radcert::verification::ac98
