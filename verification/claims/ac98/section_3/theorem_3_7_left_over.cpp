// SPDX-License-Identifier: GPL-3.0-or-later

// The proof of Theorem 3.7 has the error over a triangle without a partner as O(h^5) times the norm of D^3 u.
// Lemma 3.2, which it names, has the larger of |D^2 f| and |D^3 f|, and the second derivatives cannot be left
// out: for f = x^2, whose third ones are 0, and Phi = x the error is not 0. The order in h is right.
//
// Checked      on the triangle (0,0), (h,0), (0,h), alpha = 1/6: Int Phi (I - L)f for Phi = x and f = x^2 is
//              no 0; it is -h^5/1080 for every h, as a polynomial identity; it is 0 for linear f and any Phi
//              of degree 3 at most, and for constant Phi and f of degree 2. With alpha = 1/10 constant Phi
//              leaves an error.
// Not checked  nothing is left out.

#include <array>

#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/exact_plane.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

Rational error_over(const Rational& h, const ExactPolynomial& phi, const ExactPolynomial& f,
                    const Rational& alpha) {
  return interpolation_error(
      phi, f, {PlanarTriangle{PlanarPoint{0, 0}, PlanarPoint{h, 0}, PlanarPoint{0, h}}}, alpha);
}

// Products of a Phi and an f of these degrees whose error over the unit triangle is not 0.
Rational products_with_an_error(int of_phi, int of_f, const Rational& alpha) {
  long count = 0;
  for (const ExactPolynomial& phi : monomials(of_phi))
    for (const ExactPolynomial& f : monomials(of_f))
      if (error_over(1, phi, f, alpha) != 0) ++count;
  return {count};
}

}  // namespace

Finding theorem_3_7_left_over(const Bench&) {
  Finding finding;
  const Rational sixth(1, 6);
  const ExactPolynomial x = ExactPolynomial::monomial(1, 0);
  const ExactPolynomial square = ExactPolynomial::monomial(2, 0);
  finding.require("error for Phi = x and f = x^2, D^3 f = 0, on the unit triangle", IsExactly{0},
                  error_over(1, x, square, sixth));
  using One = std::array<Rational, 1>;
  const auto at = [&](const One& h) { return error_over(h[0], x, square, sixth); };
  const auto power_of = [](int exponent) {
    return [exponent](const One& h) { return Rational(-1, 1080) * power(h[0], exponent); };
  };
  finding.instead("values of h where that error is not -h^5/1080", IsExactly{0},
                  differing_on_grid<1>(6, at, power_of(5)));
  finding.control("values of h where it is not -h^4/1080", IsExactly{0},
                  differing_on_grid<1>(6, at, power_of(4)));
  finding.instead("products of a Phi of degree 3 at most and a linear f with an error", IsExactly{0},
                  products_with_an_error(3, 1, sixth));
  finding.instead("products of a constant Phi and an f of degree 2 at most with an error", IsExactly{0},
                  products_with_an_error(0, 2, sixth));
  finding.control("the same for alpha = 1/10", IsExactly{0}, products_with_an_error(0, 2, Rational(1, 10)));
  return finding;
}

}  // namespace radcert::verification::ac98
