// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/superconvergent_inset.h"

#include <utility>

#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

const Rational& one_third() {
  static const Rational third(1, 3);
  return third;
}

// How wide the enclosures are: narrow enough that each prints a dozen digits.
const Rational& enclosure_width() {
  static const Rational width = 1 / power(Rational(2), 40);
  return width;
}

bool is_inside(const RealZero& zero) {
  return !zero.is_exact() || (zero.lower.sign() > 0 && zero.lower < one_third());
}

std::vector<RealZero> zeros_inside(const RationalPolynomial& p, const Rational& width) {
  std::vector<RealZero> inside;
  for (const RealZero& zero : real_zeros(p, 0, one_third(), width)) {
    // The last enclosure may hold the end 1/3 itself.
    if (is_inside(zero) && !(zero.upper == one_third() && p(one_third()).sign() == 0)) inside.push_back(zero);
  }
  return inside;
}

int count_inside(const RationalPolynomial& p) {
  return zeros_between(p, 0, one_third()) - (p(one_third()).sign() == 0 ? 1 : 0);
}

bool has_zero_in(const RationalPolynomial& p, const RealZero& enclosure) {
  return enclosure.is_exact() ? p(enclosure.lower).sign() == 0
                              : zeros_between(p, enclosure.lower, enclosure.upper) > 0;
}

// g = gcd(a, b) = u a + v b, by Euclid's algorithm with the quotients kept.
struct Bezout {
  RationalPolynomial divisor;
  RationalPolynomial of_a;
  RationalPolynomial of_b;
};

Bezout bezout(RationalPolynomial a, RationalPolynomial b) {
  RationalPolynomial of_a = 1;
  RationalPolynomial of_b;
  RationalPolynomial next_of_a;
  RationalPolynomial next_of_b = 1;
  while (!b.is_zero()) {
    Division division = divide(a, b);
    a = std::exchange(b, std::move(division.remainder));
    of_a = std::exchange(next_of_a, of_a - division.quotient * next_of_a);
    of_b = std::exchange(next_of_b, of_b - division.quotient * next_of_b);
  }
  if (a.is_zero()) return {a, of_a, of_b};
  const RationalPolynomial scale(1 / a.leading());
  return {a * scale, of_a * scale, of_b * scale};
}

// sqrt(x) = root sqrt(radicand) with a square-free whole radicand.
struct SquareRoot {
  Rational root;
  long radicand = 1;
};

std::optional<SquareRoot> square_root(const Rational& x) {
  const std::optional<long> whole = (x.numerator() * x.denominator()).to_long();
  if (!whole || *whole < 0) return std::nullopt;
  SquareRoot result{.root = 1 / x.denominator(), .radicand = *whole};
  for (long f = 2; f <= result.radicand / f; ++f)
    while (result.radicand % (f * f) == 0) {
      result.radicand /= f * f;
      result.root *= f;
    }
  return result;
}

// The zero of a polynomial of degree 2 in an enclosure.
std::optional<std::string> quadratic_form(const RationalPolynomial& p, const RealZero& zero) {
  const Rational centre = -p.coefficient(1) / (2 * p.leading());
  const std::optional<SquareRoot> root = square_root(centre * centre - p.coefficient(0) / p.leading());
  if (!root) return std::nullopt;
  // Left of both zeros p has the sign of its leading coefficient; a lower end is not the zero that is
  // enclosed.
  const std::string sign = p(zero.lower).sign() == p.leading().sign() ? " - " : " + ";
  const std::string factor = root->root == 1 ? "" : root->root.to_text() + " ";
  return centre.to_text() + sign + factor + "sqrt(" + std::to_string(root->radicand) + ")";
}

std::optional<std::string> closed_form(const RationalPolynomial& p, const RealZero& zero) {
  if (zero.is_exact()) return zero.lower.to_text();
  if (p.degree() == 2) return quadratic_form(p, zero);
  return std::nullopt;
}

// Takes in the defect of one more monomial.
void combine(SuperconvergentInsets& answer, InsetDefect next) {
  const RationalPolynomial& numerator = next.defect.numerator;
  const bool is_new = answer.condition.is_zero() ? !numerator.is_zero()
                                                 : !divide(numerator, answer.condition).remainder.is_zero();
  RationalPolynomial cofactor;
  if (is_new) {
    Bezout step = bezout(answer.condition, numerator);
    for (RationalPolynomial& earlier : answer.cofactors) earlier *= step.of_a;
    cofactor = std::move(step.of_b);
    answer.condition = std::move(step.divisor);
  }
  answer.cofactors.push_back(std::move(cofactor));
  answer.defects.push_back(std::move(next));
}

// How far the rule is exact at an inset that is enclosed.
int precision_at(const InsetFamily& family, Region region, int precision, RationalPolynomial condition,
                 const RealZero& enclosure) {
  while (has_zero_in(condition, enclosure)) {
    ++precision;
    condition = greatest_common_divisor(condition, family.condition(region, precision + 1));
  }
  return precision;
}

}  // namespace

std::string SuperconvergentInsets::to_text() const {
  if (!insets.empty()) {
    std::string text;
    for (const SuperconvergentInset& inset : insets) {
      if (!text.empty()) text += ", ";
      text += inset.closed_form
                  ? *inset.closed_form
                  : "the zero of " + condition.to_text("alpha") + " in (" + inset.enclosure.lower.to_text() +
                        ", " + inset.enclosure.upper.to_text() + "]";
    }
    return text;
  }
  if (condition.degree() > 0) return "none: " + condition.to_text("alpha") + " has no zero in (0, 1/3)";
  std::string used;
  for (std::size_t t = 0; t < defects.size(); ++t)
    if (!cofactors[t].is_zero()) used += (used.empty() ? "" : ", ") + defects[t].monomial.to_text();
  return "none: the defects of " + used + " have no common zero";
}

SuperconvergentInsets superconvergent_insets(int degree, Region region) {
  const InsetFamily family(degree);
  SuperconvergentInsets answer;
  answer.degree = degree;
  answer.region = region;
  // An interpolatory rule is exact up to its degree.
  answer.precision = degree - 1;
  do {
    ++answer.precision;
    answer.defects.clear();
    answer.cofactors.clear();
    for (int t = 0; t <= answer.precision + 1 && answer.condition.degree() != 0; ++t) {
      const Monomial monomial{answer.precision + 1 - t, t};
      combine(answer, {monomial, family.defect(region, monomial)});
    }
  } while (answer.condition.is_zero());
  for (const RealZero& zero : zeros_inside(answer.condition, enclosure_width()))
    answer.insets.push_back(
        {.enclosure = zero,
         .precision = precision_at(family, region, answer.precision, answer.condition, zero),
         .closed_form = closed_form(answer.condition, zero)});
  return answer;
}

Outcome<void> recheck(const SuperconvergentInsets& answer) {
  if (answer.condition.is_zero()) return because("the condition is zero: every inset gains a degree");
  if (answer.cofactors.size() != answer.defects.size()) return because("not one cofactor for each defect");
  if (answer.condition.degree() > 0 &&
      answer.defects.size() != static_cast<std::size_t>(answer.precision) + 2)
    return because("not the defects of all monomials of one degree");
  RationalPolynomial sum;
  for (std::size_t t = 0; t < answer.defects.size(); ++t) {
    const RationalPolynomial& numerator = answer.defects[t].defect.numerator;
    sum += answer.cofactors[t] * numerator;
    if (!divide(numerator, answer.condition).remainder.is_zero())
      return because("the condition does not divide the defect of " + answer.defects[t].monomial.to_text());
  }
  if (!(sum == answer.condition)) return because("the cofactors do not combine the defects to the condition");
  if (count_inside(answer.condition) != static_cast<int>(answer.insets.size()))
    return because("the condition has " + std::to_string(count_inside(answer.condition)) +
                   " zeros in (0, 1/3)");
  Rational last = 0;
  for (const SuperconvergentInset& inset : answer.insets) {
    const RealZero& zero = inset.enclosure;
    if (zero.lower < last || zero.upper > one_third()) return because("enclosures out of order");
    const bool right = zero.is_exact() ? answer.condition(zero.lower).sign() == 0
                                       : zeros_between(answer.condition, zero.lower, zero.upper) == 1;
    if (!right) return because("not one zero from " + zero.lower.to_text() + " to " + zero.upper.to_text());
    last = zero.upper;
  }
  return {};
}

Outcome<NearInset> superconvergent_inset(int degree, const Rational& width) {
  expects(degree >= 1, "degree >= 1: degree 0 has no inset", named("degree", degree));
  const SuperconvergentInsets answer = superconvergent_insets(degree, Region::parallelogram);
  if (answer.insets.empty()) {
    const std::string proof =
        "it is proven that no alpha in (0, 1/3) gains a degree of precision on the parallelogram at degree " +
        std::to_string(degree) + " (" + answer.to_text() + ")";
    if (degree % 2 == 0)
      return because(proof + "; every alpha has degree of precision " + std::to_string(answer.precision) +
                     " there and order " + std::to_string(degree + 2) + " at the nodes");
    return because(proof);
  }
  const RealZero& first = answer.insets.front().enclosure;
  if (first.is_exact()) return NearInset{.value = first.lower, .is_exact = true};
  const RealZero zero = real_zeros(answer.condition, first.lower, first.upper, width).back();
  return NearInset{.value = zero.upper, .is_exact = zero.is_exact()};
}

}  // namespace radcert
