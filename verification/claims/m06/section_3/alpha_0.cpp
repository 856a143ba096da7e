// SPDX-License-Identifier: GPL-3.0-or-later

// Whether there is an alpha_0 of 0 < alpha_0 < 1/3 for which (28) has degree of precision r + 1, r odd. The
// defects of the monomials of degree r + 1 are polynomials in alpha over a power of 1 - 3 alpha; an inset
// gains the degree if and only if it is a zero of their greatest common divisor. Where that is 1, cofactors
// with sum cofactor_t D_t = 1 prove that there is none, real or complex.
//
// Checked      r = 1: 1/6 and no other; r = 3: (7 - sqrt 34)/15 and no other; by Sturm's theorem. r = 5 and 7
//              (9 and 11 beyond quick): none. Every certificate is checked again, and its defects are
//              compared with those of the rule at as many alpha as settle it. Over a rectangle: what is odd
//              about the centre costs nothing, for every alpha and r = 1, 3 and 5; degree r + 2 at alpha_0, r
//              at alpha = 1/10; for even r and every alpha r + 1 and, r <= 8, no more.
// Not checked  odd r > 11.

#include "radcert/polynomial/basis_facts.h"
#include "radcert/polynomial/nodes/superconvergent_inset.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/claims/m06/section_3/interpolation_error.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// "At least one": minus their number is at most -1.
constexpr AtMost at_least_one{.value = -1, .slack = 0, .why = ""};

Approximation minus_the_number(const SuperconvergentInsets& answer) {
  return {.value = 0 - static_cast<double>(answer.insets.size()), .radius = 0, .guaranteed = true};
}

// How many of (0, 1/3) are exact of a degree.
Approximation minus_the_number_exact_of(int degree, int r) {
  const RationalPolynomial condition = InsetFamily(r).condition(Region::triangle, degree);
  const int zeros = zeros_between(condition, 0, Rational(1, 3)) - (condition(Rational(1, 3)) == 0 ? 1 : 0);
  return {.value = 0 - static_cast<double>(zeros), .radius = 0, .guaranteed = true};
}

Rational fails(const SuperconvergentInsets& answer) { return {recheck(answer) ? 0 : 1}; }

// Defects of a certificate that are not the rule's at one of so many alpha as settle it: their numerators
// have the degree 2r + 1 at most. The rule's first weight is moved.
Rational defects_off(const SuperconvergentInsets& answer, const Rational& moved) {
  long count = 0;
  const int r = answer.degree;
  const InsetFamily family(r);
  for (int k = 0; k <= 2 * r + 1; ++k) {
    const Rational alpha(k, 6 * r + 7);
    TriangleRule<Rational> rule;
    for (std::size_t j = 0; j < family.size(); ++j) {
      const auto node = family.node(j);
      rule.points.push_back({{node[0](alpha), node[1](alpha), node[2](alpha)}});
      rule.weights.push_back(family.weight(j)(alpha));
    }
    rule.weights.front() += moved;
    for (const InsetDefect& each : answer.defects)
      if (each.defect(alpha) != defect(rule, answer.region, each.monomial)) ++count;
  }
  return {count};
}

int precision_at(int r, const Rational& alpha, Region region) {
  const InsetFamily family(r);
  TriangleRule<Rational> rule;
  for (std::size_t j = 0; j < family.size(); ++j) {
    const auto node = family.node(j);
    rule.points.push_back({{node[0](alpha), node[1](alpha), node[2](alpha)}});
    rule.weights.push_back(family.weight(j)(alpha));
  }
  return degree_of_precision(rule, region).degree;
}

}  // namespace

Finding alpha_0_for_r_1_and_3(const Bench&) {
  Finding finding;
  for (const int r : {1, 3}) {
    const std::string of = ", r = " + std::to_string(r);
    const SuperconvergentInsets answer = superconvergent_insets(r, Region::triangle);
    finding.require("steps of the certificate that fail" + of, IsExactly{0}, fails(answer));
    finding.require("minus the number of insets that gain a degree" + of, at_least_one,
                    minus_the_number(answer));
    finding.require("insets that gain a degree" + of, IsExactly{1},
                    Rational(static_cast<long>(answer.insets.size())));
    finding.require("defects that are not those of the rule at some alpha" + of, IsExactly{0},
                    defects_off(answer, 0));
    finding.control("minus the number of insets that are exact of degree r + 2" + of, at_least_one,
                    minus_the_number_exact_of(r + 2, r));
    finding.require("degree of precision there" + of, IsExactly{r + 1},
                    precision_at_superconvergent_inset(r, Region::triangle).degree);
    finding.control("degree of precision at 1/10" + of, IsExactly{r + 1},
                    precision_at(r, Rational(1, 10), Region::triangle));
  }
  // 15 alpha^2 - 14 alpha + 1 is the polynomial of (7 - sqrt 34)/15.
  const RationalPolynomial a = RationalPolynomial::variable();
  const RationalPolynomial cubic_condition = superconvergent_insets(3, Region::triangle).condition;
  finding.require("r = 3: remainder of the condition by 15 alpha^2 - 14 alpha + 1", IsExactly{-1},
                  divide(cubic_condition, 15 * a * a - 14 * a + 1).remainder.degree());
  finding.control("r = 3: remainder of the condition by 15 alpha^2 - 13 alpha + 1", IsExactly{-1},
                  divide(cubic_condition, 15 * a * a - 13 * a + 1).remainder.degree());
  finding.require("r = 1: condition at alpha = 1/6", IsExactly{0},
                  superconvergent_insets(1, Region::triangle).condition(Rational(1, 6)));
  return finding;
}

Finding alpha_0_for_larger_r(const Bench& bench) {
  const int largest = bench.budget == Budget::quick ? 7 : 11;
  Finding finding;
  for (int r = 5; r <= largest; r += 2) {
    const std::string of = ", r = " + std::to_string(r);
    const SuperconvergentInsets answer = superconvergent_insets(r, Region::triangle);
    finding.instead("steps of the certificate that fail" + of, IsExactly{0}, fails(answer));
    finding.require("minus the number of insets that gain a degree" + of, at_least_one,
                    minus_the_number(answer));
  }
  for (const int r : {1, 3})
    finding.instead("minus the number of insets that gain a degree, r = " + std::to_string(r), at_least_one,
                    minus_the_number(superconvergent_insets(r, Region::triangle)));
  finding.control("minus the number of insets that are exact of degree 3, r = 1", at_least_one,
                  minus_the_number_exact_of(3, 1));
  return finding;
}

Finding alpha_0_for_5_to_11(const Bench& bench) {
  const int largest = bench.budget == Budget::quick ? 7 : 11;
  const IsExactly none{0};
  Finding finding;
  for (int r = 5; r <= largest; r += 2) {
    const std::string of = ", r = " + std::to_string(r);
    const SuperconvergentInsets answer = superconvergent_insets(r, Region::triangle);
    finding.require("steps of the certificate that fail" + of, none, fails(answer));
    finding.require("degree of the condition that alpha_0 must meet: 0 for a constant" + of, none,
                    answer.condition.degree());
    finding.require("defects that are not those of the rule at some alpha" + of, none,
                    defects_off(answer, 0));
    finding.control("the same with one weight of the rule moved" + of, none,
                    defects_off(answer, Rational(1, 1000)));
  }
  for (const int r : {1, 3})
    finding.control("degree of the condition that alpha_0 must meet, r = " + std::to_string(r), none,
                    superconvergent_insets(r, Region::triangle).condition.degree());
  return finding;
}

Finding odd_degree_over_a_rectangle(const Bench&) {
  Finding finding;
  // Whatever alpha is: what is odd about the centre costs nothing, so that r + 1 gives r + 2.
  for (const int r : {1, 3, 5}) {
    const std::string of = ", every alpha, r = " + std::to_string(r);
    const InterpolationError error(r);
    finding.require("coefficients in alpha of the error over a rectangle, degree r + 2 about its centre" + of,
                    IsExactly{0}, error.coefficients_left(Over::square, 0, r + 2, {}));
    finding.control("the same, degree r + 1" + of, IsExactly{0},
                    error.coefficients_left(Over::square, 0, r + 1, {}));
  }
  for (const int r : {1, 3}) {
    const std::string of = ", r = " + std::to_string(r);
    finding.require("degree of precision over a rectangle, alpha_0" + of, IsExactly{r + 2},
                    precision_at_superconvergent_inset(r, Region::parallelogram).degree);
    finding.control("degree of precision over a rectangle, alpha = 1/10" + of, IsExactly{r + 2},
                    precision_at(r, Rational(1, 10), Region::parallelogram));
  }
  finding.require("degree of precision over a rectangle, alpha = 1/6, r = 1", IsExactly{3},
                  precision_at(1, Rational(1, 6), Region::parallelogram));
  return finding;
}

Finding even_degree_over_a_rectangle(const Bench&) {
  Finding finding;
  for (const int r : {2, 4, 6, 8}) {
    const InsetFamily family(r);
    const std::string of = ", r = " + std::to_string(r);
    for (int degree = 0; degree <= r + 1; ++degree)
      finding.require("coefficients in alpha of the defects of degree " + std::to_string(degree) + of,
                      IsExactly{0},
                      ac98::differing_coefficients({family.condition(Region::parallelogram, degree), 0}, {}));
    finding.control("coefficients in alpha of the defects of degree r + 2" + of, IsExactly{0},
                    ac98::differing_coefficients({family.condition(Region::parallelogram, r + 2), 0}, {}));
    finding.control("coefficients in alpha of the defects of degree r + 1 over a triangle" + of, IsExactly{0},
                    ac98::differing_coefficients({family.condition(Region::triangle, r + 1), 0}, {}));
  }
  finding.require("degree of precision over a rectangle, r = 0", IsExactly{1},
                  degree_of_precision({.points = {{{Rational(1, 3), Rational(1, 3), Rational(1, 3)}}},
                                       .weights = {Rational(1, 2)}},
                                      Region::parallelogram)
                      .degree);
  return finding;
}

}  // namespace radcert::verification::m06
