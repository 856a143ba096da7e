// SPDX-License-Identifier: GPL-3.0-or-later

// Lemmas 5, 6 and 8 with constants, for all functions. L' = I - L, p_k the Taylor polynomial of g about the
// middle of the hypotenuse, which is the centre of the square; Phi_0 and Phi_1 the polynomials of degree 0
// and 1 with the mean value, and the mean derivatives, of Phi. mean_value_bounds.h bounds g - p_k and Phi -
// Phi_i. As L reproduces degree r, (14),
//   Lemmas 6, 8:  Int Phi L'g = Int (Phi - Phi_0) L'(g - p_r) + Phi_0 Int L'(g - p_(r+1))
//                               + Phi_0 Int L' p_(r+1),
//   Lemma 5:      Int Phi L'g = Int (Phi - Phi_1) L'(g - p_r) + Int (Phi_1 - Phi_0) L'(g - p_(r+1))
//                               + Phi_0 Int L'(g - p_(r+2)) + Int Phi_1 L' p_(r+1)
//                               + Phi_0 Int L'(p_(r+2) - p_(r+1)),
// where all terms with L' p are zero: over tau Int L' p vanishes up to the degree r + 1 for alpha_0; over the
// square for even r and every alpha; over the square for alpha_0 also for r + 2, and with a linear factor for
// r + 1. As |x|_1 <= h the rest is at most (1 + norm of L) h^(r+1+gained) sum_j c_j Int |D^(gained-j) Phi|
// max |D^(r+1+j) g|, gained = 2 or 1. c_0 = 1/(r+1)! is the largest: the lemmas hold with c = (1 + norm of
// L)/(r+1)!.
//
// Checked      these zeros, exactly: for alpha_0 as remainders by its polynomial, 6 alpha - 1 for r = 1 and
//              15 alpha^2 - 14 alpha + 1 for r = 3, all odd r up to 11 that have one; for r = 0, 2, 4 and 6
//              (8 beyond quick) as identities in alpha. The bounds of mean_value_bounds.h, line by line. c,
//              with the norm of L enclosed. That no power is given away: the next integral is not zero. Both
//              sides for Phi = 1/(1 + x + y) and g = exp(x + 2y), which are no polynomials, enclosed, r = 1,
//              2 and 3, h = 1 and 1/64. Rejected: alpha = 1/10 for odd r; for even r two mirror images,
//              a kite, in the place of the square. On one triangle, r even, the remark after Lemma 8: no more
//              than the degree r at alpha = 1/10; but r = 0 has a degree more, and r = 2 has two alpha with
//              one.
// Not checked  that the inequalities for smooth Phi go over to those with derivatives in L^1 only. Odd r
//              above 11 and even r above 8. The remark on general triangles: an affine map takes B to a
//              multiple of itself; the derivatives are then those of g and Phi behind the map.

#include <algorithm>

#include "radcert/enclosure/polygon_integral.h"
#include "radcert/polynomial/basis_facts.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/nodes/superconvergent_inset.h"
#include "verification/claims/m06/section_3/interpolation_error.h"
#include "verification/claims/mean_value_bounds.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// Of which alpha_0 is a zero.
RationalPolynomial polynomial_of_alpha_0(int r) {
  const RationalPolynomial a = RationalPolynomial::variable();
  return r == 1 ? 6 * a - 1 : 15 * a * a - 14 * a + 1;
}

// The same for an alpha that is given.
RationalPolynomial polynomial_of(const Rational& alpha) { return RationalPolynomial::variable() - alpha; }

const RationalPolynomial every_alpha{};

Ball alpha_0(int r) {
  const Rational width = 1 / power(Rational(10), 50);
  const NearInset near = superconvergent_inset(r, width).value();
  if (near.is_exact) return Ball(near.value);
  return hull(Ball(near.value - width), Ball(near.value + width));
}

// (1 + norm of L)/(r+1)!, the largest of interpolation_factors on a right triangle: with legs h and |x|_1 <=
// h.
Ball constant(int r, int gained, const Ball& alpha) {
  const Rational near = Rational::exactly(alpha.to_double());
  const LagrangeFunctions functions = lagrange_functions(inset_nodes<Rational>(r, near)).value();
  const BasisFacts facts =
      at_true_nodes(basis_facts(functions, Rational(1, 10000)), functions, inset_nodes<Ball>(r, alpha))
          .value();
  Ball largest = 0;
  for (const Ball& factor : interpolation_factors<Ball>(r, gained, Ball(1), Ball(1)))
    largest = max(largest, factor);
  return (Ball(1) + hull(Ball(facts.norm.lower), Ball(facts.norm.upper))) * largest;
}

// Phi (g - L g) on one half of the square, or on the triangle alone, with sides h.
struct Integrand {
  int r;
  Ball alpha;
  Rational h;
  bool turned = false;
  bool mirrored = false;

  template <class R>
  ParameterPoint<R> place(const ParameterPoint<R>& at) const {
    const R length = from_rational<R>(h);
    if (turned) return {length * (R(1) - at.s), length * (R(1) - at.t)};
    return {mirrored ? -(length * at.s) : length * at.s, length * at.t};
  }
  template <class R>
  static R g(const ParameterPoint<R>& at) {
    return exp(at.s + R(2) * at.t);
  }
  /// x + y for Phi = 1/(1 + x + y), with |x|: the kite has it too.
  template <class R>
  R phi(const ParameterPoint<R>& at) const {
    return R(1) / (R(1) + (mirrored ? -at.s : at.s) + at.t);
  }
  template <class R>
  R operator()(const ParameterPoint<R>& at) const {
    const InsetBasis<R> basis(r, R(alpha));
    std::vector<R> values(basis.size());
    basis.values(Barycentric<R>{{R(1) - at.s - at.t, at.t, at.s}}, std::span<R>(values));
    const std::vector<Barycentric<Ball>> nodes = inset_nodes<Ball>(r, alpha);
    R rest = g(place(at));
    for (std::size_t j = 0; j < nodes.size(); ++j)
      rest -= R(g(place(ParameterPoint<Ball>{nodes[j].x[2], nodes[j].x[1]}))) * values[j];
    return phi(place(at)) * rest;
  }
};

// |D^k Phi|, k = 0, 1, 2, together: k!/(1 + |x| + |y|)^(k+1).
struct SizeOfPhi {
  int orders;
  Rational h;
  bool turned = false;

  template <class R>
  R operator()(const ParameterPoint<R>& at) const {
    const R sum = turned ? R(2) - at.s - at.t : at.s + at.t;
    const R inverse = R(1) / (R(1) + from_rational<R>(h) * sum);
    R total = inverse + inverse * inverse;
    if (orders == 2) total += R(2) * inverse * inverse * inverse;
    return total;
  }
};

// |Int Phi (I - L) g| over h^(r+1+gained) Int (|Phi| + ...) max |D^i g|, i up to r + 1 + gained: the largest
// of these is 2^i exp(x + 2y), at the corner (h,h) of the square and (0,h) of the others. The two areas h^2
// cancel.
Ball quotient(int r, const Ball& alpha, Over region, int gained, const Rational& h) {
  const ParameterPolygon sigma{{0, 0}, {1, 0}, {0, 1}};
  // The integral is of the size h^(r+1) at least where the power is not reached, and of h^highest else.
  const int highest = r + 1 + gained;
  const Demand demand{.radius = 1e-10 * power(h.to_double(), highest)};
  const bool is_square = region == Over::square;
  Ball left = known(integral_over_polygon(Integrand{r, alpha, h}, sigma, demand));
  Ball size = known(integral_over_polygon(SizeOfPhi{gained, h}, sigma, {.radius = 1e-12}));
  if (region != Over::triangle) {
    left += known(integral_over_polygon(Integrand{r, alpha, h, is_square, !is_square}, sigma, demand));
    size += known(integral_over_polygon(SizeOfPhi{gained, h, is_square}, sigma, {.radius = 1e-12}));
  }
  const Ball of_g = power(Ball(2), highest) * exp(Ball((is_square ? 3 : 2) * h));
  return abs(left) / (Ball(power(h, highest)) * size * of_g);
}

std::string with(int r, const std::string& alpha) { return ", r = " + std::to_string(r) + ", " + alpha; }

const std::vector<Rational>& lengths() {
  static const std::vector<Rational> all{1, Rational(1, 64)};
  return all;
}

// Both sides for the sample functions, and a region or an alpha for which the bound must fail.
void require_inequality(Finding& finding, int r, const Ball& alpha, Over region, int gained,
                        const Ball& other_alpha, Over other_region) {
  const BallPrecision precision(448);
  const Ball c = constant(r, gained, alpha);
  const std::string of = ", r = " + std::to_string(r);
  finding.remark("c = (1 + norm of L)/(r+1)!" + of, proved(c));
  const AtMost not_above{};
  for (const Rational& h : lengths())
    finding.require("|Int Phi (I - L) g| over its bound, less c, h = " + h.to_text() + of, not_above,
                    proved(quotient(r, alpha, region, gained, h) - c));
  const Rational little = 1 / power(Rational(2), 24);
  finding.control(
      "the same for " + std::string(other_region == region ? "alpha = 1/10" : "two mirror images") +
          ", h = 2^-24" + of,
      not_above,
      proved(quotient(r, other_alpha, other_region, gained, little) - constant(r, gained, other_alpha)));
}

void require_zero(Finding& finding, const InterpolationError& error, Over region, int of_phi, int of_g,
                  const RationalPolynomial& modulus, const std::string& of) {
  finding.require("coefficients left of B, Phi of degree " + std::to_string(of_phi) + ", g of degree " +
                      std::to_string(of_g) + of,
                  IsExactly{0}, error.coefficients_left(region, of_phi, of_g, modulus));
}

void control_zero(Finding& finding, const InterpolationError& error, Over region, int of_phi, int of_g,
                  const RationalPolynomial& modulus, const std::string& of) {
  finding.control("coefficients left of B, Phi of degree " + std::to_string(of_phi) + ", g of degree " +
                      std::to_string(of_g) + of,
                  IsExactly{0}, error.coefficients_left(region, of_phi, of_g, modulus));
}

// "Not all zero": minus the number of what is left is at most -1.
void require_not_zero(Finding& finding, const InterpolationError& error, Over region, int of_phi, int of_g,
                      const RationalPolynomial& modulus, const std::string& of) {
  finding.require(
      "minus the coefficients left of B, Phi of degree " + std::to_string(of_phi) + ", g of degree " +
          std::to_string(of_g) + of,
      AtMost{.value = -1, .slack = 0, .why = ""},
      Approximation{.value = 0 - error.coefficients_left(region, of_phi, of_g, modulus).to_double(),
                    .radius = 0,
                    .guaranteed = true});
}

}  // namespace

Finding lemma_5(const Bench&) {
  Finding finding;
  require_mean_values(finding, 1);
  for (const int r : {1, 3}) {
    const InterpolationError error(r);
    const RationalPolynomial here = polynomial_of_alpha_0(r);
    require_zero(finding, error, Over::square, 0, r + 1, here, with(r, "alpha_0"));
    require_zero(finding, error, Over::square, 0, r + 2, here, with(r, "alpha_0"));
    require_zero(finding, error, Over::square, 1, r + 1, here, with(r, "alpha_0"));
    require_not_zero(finding, error, Over::square, 1, r + 2, here, with(r, "alpha_0"));
    control_zero(finding, error, Over::square, 0, r + 1, polynomial_of(Rational(1, 10)),
                 with(r, "alpha = 1/10"));
    control_zero(finding, error, Over::kite, 0, r + 2, here, with(r, "alpha_0, a kite"));
    require_inequality(finding, r, alpha_0(r), Over::square, 2, Ball(Rational(1, 10)), Over::square);
  }
  return finding;
}

Finding lemma_6(const Bench&) {
  Finding finding;
  require_mean_values(finding, 0);
  for (const int r : {1, 3}) {
    const InterpolationError error(r);
    const RationalPolynomial here = polynomial_of_alpha_0(r);
    require_zero(finding, error, Over::triangle, 0, r + 1, here, with(r, "alpha_0"));
    control_zero(finding, error, Over::triangle, 0, r + 1, polynomial_of(Rational(1, 10)),
                 with(r, "alpha = 1/10"));
    require_not_zero(finding, error, Over::triangle, 0, r + 2, here, with(r, "alpha_0"));
    require_inequality(finding, r, alpha_0(r), Over::triangle, 1, Ball(Rational(1, 10)), Over::triangle);
  }
  return finding;
}

Finding lemma_8(const Bench& bench) {
  const int largest_degree = bench.budget == Budget::quick ? 6 : 8;
  Finding finding;
  require_mean_values(finding, 0);
  for (int r = 0; r <= largest_degree; r += 2) {
    const InterpolationError error(r);
    require_zero(finding, error, Over::square, 0, r + 1, every_alpha, with(r, "every alpha"));
    // The centroid is exact of degree 1 on any triangle.
    if (r > 0)
      control_zero(finding, error, Over::kite, 0, r + 1, every_alpha, with(r, "every alpha, a kite"));
    require_not_zero(finding, error, Over::square, 0, r + 2, every_alpha, with(r, "every alpha"));
  }
  const Ball tenth(Rational(1, 10));
  require_inequality(finding, 2, tenth, Over::square, 1, tenth, Over::kite);
  return finding;
}

Finding lemma_8_one_triangle(const Bench&) {
  const auto gaining = [](int r) {
    const SuperconvergentInsets answer = superconvergent_insets(r, Region::triangle);
    // A certificate that fails counts as well.
    return Rational(static_cast<long>(answer.insets.size()) + (recheck(answer) ? 0 : 1));
  };
  const auto vanishes = [](int r, const RationalPolynomial& modulus) {
    return Rational(InterpolationError(r).coefficients_left(Over::triangle, 0, r + 1, modulus) == 0 ? 1 : 0);
  };
  const IsExactly none{0};
  Finding finding;
  finding.require("whether B vanishes over one triangle, Phi = 1, g of degree 1, r = 0", none,
                  vanishes(0, every_alpha));
  finding.require("alpha in (0, 1/3) for which one triangle has a degree more, r = 2", none, gaining(2));
  for (const int r : {2, 4, 6})
    finding.instead("whether B vanishes over one triangle, Phi = 1, g of degree r + 1, alpha = 1/10, r = " +
                        std::to_string(r),
                    none, vanishes(r, polynomial_of(Rational(1, 10))));
  finding.instead("alpha in (0, 1/3) for which one triangle has a degree more, r = 8", none, gaining(8));
  finding.control("alpha in (-10, 10) for which one triangle has a degree more, r = 2", none,
                  zeros_between(superconvergent_insets(2, Region::triangle).condition, -10, 10));
  return finding;
}

}  // namespace radcert::verification::m06
