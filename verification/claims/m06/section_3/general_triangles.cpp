// SPDX-License-Identifier: GPL-3.0-or-later

// The remark after Lemma 6: Lemmas 5 and 6 on general triangles. The bounds of mean_value_bounds.h hold on
// every triangle and every parallelogram with sides a and b; what enters is S with |a|_1, |b|_1 <= S h, and R
// with |d|_1 <= R h for the distance d from the middle of the diagonal. With h the diameter S = sqrt 2 will
// do, as |x| + |y| <= sqrt 2 (x^2 + y^2)^(1/2), and R = sqrt 2 for a triangle and for a parallelogram with h
// the larger diagonal. The zeros are those of the right triangle: an affine map takes polynomials to
// polynomials of the same degree, L to L, and the half turn of a parallelogram to a half turn. So (30) and
// (31) hold with the constants
//   (1 + norm of L) max_j c_j(sqrt 2, sqrt 2),
// and neither (33) nor the shape of the triangle enters. Derivatives are by x and y; m_tau is not in the
// bound.
//
// Checked      2 (x^2 + y^2) - (x + y)^2 = (x - y)^2, as an identity; the zeros on the right triangle and the
//              square, exactly, and that a kite, two mirror images, does not have them: "rectangle" needs a
//              parallelogram. The bounds of mean_value_bounds.h. On triangles with the vertices (0,0), (1,0)
//              and (1,t), t = 1 to 2^-20, for products of monomials: both sides of (31), exactly, are within
//              the bound for r = 1, where the norm of L is 7/3. Rejected: alpha = 1/10 on small triangles.
// Not checked  odd r other than 1 and 3.

#include <algorithm>

#include "verification/claims/ac98/surfaces/exact_plane.h"
#include "verification/claims/m06/section_3/interpolation_error.h"
#include "verification/claims/mean_value_bounds.h"
#include "verification/claims/proved_number.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using ac98::ExactPolynomial;
using ac98::PlanarPoint;

// 2 (x^2 + y^2) - (x + y)^2 - (x - y)^2, or with x^2 + y^2 once.
Rational terms_of_norms(int factor) {
  const Polynomial x = Polynomial::variable("x");
  const Polynomial y = Polynomial::variable("y");
  return differing_terms(factor * (x * x + y * y) - (x + y) * (x + y) - (x - y) * (x - y), 0);
}

// The largest size at the vertices of derivatives of one order: those of monomials have their largest there,
// as the triangles lie in x, y >= 0.
Rational largest_derivative(const ExactPolynomial& f, int order, const std::vector<PlanarPoint>& vertices) {
  return ac98::largest_at(vertices, ac98::derivatives(f, order));
}

// Of the integral of the largest derivative of one order a lower bound: the largest of the integrals.
Rational least_integral(const ExactPolynomial& phi, int order, const std::vector<PlanarPoint>& vertices) {
  Rational largest = 0;
  for (const ExactPolynomial& each : ac98::derivatives(phi, order))
    largest = std::max(largest, abs(each.integral_over(vertices)));
  return largest;
}

// The largest of |Int Phi (I - L) g|/[h^3 Int (|Phi| + |D Phi|) max {|D^2 g|, |D^3 g|}] over monomials g of
// degree 2 to 4 and Phi of degree <= 2, on the triangle (0,0), (1,0), (1,thin) times `length`: h is at least
// the length.
Rational largest_quotient(const Rational& alpha, const Rational& thin, const Rational& length) {
  const std::vector<PlanarPoint> tau{{0, 0}, {length, 0}, {length, thin * length}};
  Rational largest = 0;
  for (const ExactPolynomial& g : ac98::monomials(4)) {
    const Rational of_g = std::max(largest_derivative(g, 2, tau), largest_derivative(g, 3, tau));
    if (of_g == 0) continue;
    for (const ExactPolynomial& phi : ac98::monomials(2)) {
      const Rational size = least_integral(phi, 0, tau) + least_integral(phi, 1, tau);
      const Rational error = abs(ac98::interpolation_error(phi, g, {{tau[0], tau[1], tau[2]}}, alpha));
      largest = std::max(largest, error / (power(length, 3) * size * of_g));
    }
  }
  return largest;
}

}  // namespace

Finding remark_general_triangles(const Bench&) {
  const BallPrecision precision(128);
  const IsExactly none{0};
  Finding finding;
  require_mean_values(finding, 1);
  finding.require("terms of 2 (x^2 + y^2) - (x + y)^2 - (x - y)^2", none, terms_of_norms(2));
  finding.control("terms of x^2 + y^2 - (x + y)^2 - (x - y)^2", none, terms_of_norms(1));
  const RationalPolynomial a = RationalPolynomial::variable();
  for (const int r : {1, 3}) {
    const std::string of = ", alpha_0, r = " + std::to_string(r);
    const InterpolationError error(r);
    const RationalPolynomial of_alpha_0 = r == 1 ? 6 * a - 1 : 15 * a * a - 14 * a + 1;
    finding.require("coefficients left of B over a triangle, Phi = 1, g of degree r + 1" + of, none,
                    error.coefficients_left(Over::triangle, 0, r + 1, of_alpha_0));
    finding.require("coefficients left of B over a parallelogram, Phi = 1, g of degree r + 2" + of, none,
                    error.coefficients_left(Over::square, 0, r + 2, of_alpha_0));
    finding.require("coefficients left of B over a parallelogram, Phi of degree 1, g of degree r + 1" + of,
                    none, error.coefficients_left(Over::square, 1, r + 1, of_alpha_0));
    finding.control("coefficients left of B over a kite, Phi = 1, g of degree r + 2" + of, none,
                    error.coefficients_left(Over::kite, 0, r + 2, of_alpha_0));
  }
  // (1 + 7/3) times the largest factor, for r = 1.
  Ball constant = 0;
  for (const Ball& factor : interpolation_factors<Ball>(1, 1, sqrt(Ball(2)), sqrt(Ball(2))))
    constant = max(constant, Ball(Rational(10, 3)) * factor);
  finding.remark("constant of (31) on any triangle, r = 1", proved(constant));
  const AtMost not_above{};
  const Rational small(1, 1000);
  for (const int k : {0, 5, 20}) {
    const Rational thin = 1 / power(Rational(2), k);
    const std::string of = ", an angle near 2^-" + std::to_string(k);
    for (const Rational& length : {Rational(1), small})
      finding.require(
          "largest quotient of both sides of (31) less the constant, length " + length.to_text() + of,
          not_above, proved(Ball(largest_quotient(Rational(1, 6), thin, length)) - constant));
    finding.control("the same for alpha = 1/10, length 1/100000" + of, not_above,
                    proved(Ball(largest_quotient(Rational(1, 10), thin, Rational(1, 100000))) - constant));
  }
  return finding;
}

}  // namespace radcert::verification::m06
