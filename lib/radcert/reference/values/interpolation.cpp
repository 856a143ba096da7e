// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers of the collocation methods themselves: norms of interpolation, and insets with a degree of
// precision more.
#include "radcert/polynomial/lebesgue_constant.h"
#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/real_zeros.h"
#include "radcert/reference/values/families.h"

namespace radcert::reference::values {
namespace {

/// Branch and bound over the triangle for the Lebesgue function of three nodes.
Outcome<Ball> norm_by_branch_and_bound(const Arguments& a, const Rational& radius) {
  const Rational& alpha = a[0];
  const Rational rest = Rational(1) - Rational(2) * alpha;
  const std::vector<Barycentric<Rational>> nodes = {
      {{rest, alpha, alpha}}, {{alpha, rest, alpha}}, {{alpha, alpha, rest}}};
  const LebesgueConstant norm = lebesgue_constant(lagrange_functions(nodes).value(), radius);
  if (!norm.reached)
    return because("branch and bound ended with a width of " + (norm.upper - norm.lower).to_text());
  const BallPrecision precision(bits_for(radius) + 64);
  return hull(Ball(norm.lower), Ball(norm.upper));
}

/// The zeros in (0, 1/3) of the polynomial whose vanishing gives the rule of that degree one degree of
/// precision more.
Outcome<Ball> inset_by_sturm(int degree, const Rational& radius) {
  const RationalPolynomial condition = InsetFamily(degree).condition(Region::triangle, degree + 1);
  const std::vector<RealZero> zeros = real_zeros(condition, 0, Rational(1, 3), radius);
  std::vector<RealZero> inside;
  for (const RealZero& zero : zeros)
    if (zero.upper.sign() > 0 && zero.lower < Rational(1, 3)) inside.push_back(zero);
  if (inside.size() != 1) return because(std::to_string(inside.size()) + " zeros in (0, 1/3)");
  const BallPrecision precision(bits_for(radius) + 64);
  return hull(Ball(inside.front().lower), Ball(inside.front().upper));
}

ValueFamily superconvergent(int degree, const std::string& formula, std::function<Ball()> value) {
  return {.name = "superconvergent_inset_of_degree_" + std::to_string(degree),
          .summary = "the inset for which the rule of degree " + std::to_string(degree) +
                     " has one degree of precision more on the triangle",
          .formula = formula,
          .source = degree == 1 ? "ac98 (53)-(54)" : "m06 (28), Theorem 7",
          .parameters = {},
          .route = by_formula("radicals", [value](const Arguments&) { return value(); }),
          .second_route = {
              .how = "zero of the rule's defect as a polynomial of the inset, isolated by Sturm's theorem",
              .enclose = [degree](const Arguments&, const Rational& radius) {
                return inset_by_sturm(degree, radius);
              }}};
}

}  // namespace

Theme interpolation() {
  Theme theme;
  theme.families = {
      {.name = "linear_interpolation_norm",
       .summary = "norm of linear interpolation at nodes inset by alpha",
       .formula = "(1 + alpha)/(1 - 3 alpha)",
       .source = "ac98 (37)",
       .parameters = {from_to_below("alpha", "1/6", 0, Rational(1, 3))},
       .route = by_formula("closed form, ac98 (37)",
                           [](const Arguments& a) {
                             return Ball((Rational(1) + a[0]) / (Rational(1) - Rational(3) * a[0]));
                           }),
       .second_route = {.how = "branch and bound over the triangle",
                        .enclose = norm_by_branch_and_bound,
                        .most_digits = 20}},
      superconvergent(1, "1/6", [] { return Ball(Rational(1, 6)); }),
      superconvergent(3, "(7 - sqrt(34))/15", [] { return (Ball(7) - sqrt(Ball(34))) / Ball(15); }),
  };
  theme.named = {
      {"norm_of_linear_interpolation_alpha_1/6", "linear_interpolation_norm", {Rational(1, 6)}},
      {"norm_of_linear_interpolation_alpha_1/10", "linear_interpolation_norm", {Rational(1, 10)}},
      {"superconvergent_inset_1", "superconvergent_inset_of_degree_1", {}},
      {"superconvergent_inset_3", "superconvergent_inset_of_degree_3", {}},
  };
  return theme;
}

}  // namespace radcert::reference::values
