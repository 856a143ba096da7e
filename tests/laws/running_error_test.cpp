// SPDX-License-Identifier: GPL-3.0-or-later
// The bound of each operation against the ends of its operands' error intervals, in 200 digits.
#include "running_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <utility>

namespace radcert {
namespace {

/// An operation of two operands, of which a function of one leaves the second aside.
struct Operation {
  const char* name;
  bool positive;  ///< the first operand must be
  bool sharp;     ///< the bound is attained, but for terms of second order
};

constexpr Operation operations[] = {
    {"add", false, true},  {"subtract", false, true}, {"multiply", false, true}, {"divide", false, true},
    {"fma", false, true},  {"sqrt", true, true},      {"exp", false, true},      {"log", true, true},
    {"sin", false, false}, {"cos", false, false},     {"tan", false, true},      {"atan", false, true},
    {"pow", true, true},   {"abs", false, true},      {"min", false, true},      {"max", false, true}};

template <class T>
T result_of(std::size_t operation, const T& a, const T& b) {
  switch (operation) {
    case 0: return a + b;
    case 1: return a - b;
    case 2: return a * b;
    case 3: return a / b;
    case 4: return fma(a, b, T(3));
    case 5: return sqrt(a);
    case 6: return exp(a);
    case 7: return log(a);
    case 8: return sin(a);
    case 9: return cos(a);
    case 10: return tan(a);
    case 11: return atan(a);
    case 12: return pow(a, b);
    case 13: return abs(a);
    case 14: return min(a, b);
    default: return max(a, b);
  }
}

Mpfr<200> exactly(double x) { return Mpfr<200>(x); }
Mpfr<200> exactly(const Mpfr<50>& x) { return Mpfr<200>(x.to_rational()); }

/// Operands from 1/64 to 64, whose errors are a share of them.
class Operands {
public:
  double size() {
    return std::ldexp(1 + static_cast<double>(bits_() % 1000003) / 1000003,
                      static_cast<int>(bits_() % 12) - 6);
  }
  double signed_size() { return bits_() % 2 == 0 ? size() : -size(); }
  double error(double of) {
    constexpr double shares[] = {0, 0x1p-52, 0x1p-30, 0x1p-10, 0.3, 1.1};
    return shares[bits_() % 6] * std::abs(of);
  }

private:
  std::mt19937_64 bits_{11};
};

template <class R>
void expect_bounds_at_the_ends() {
  Operands operands;
  std::size_t bounded = 0;
  for (int draw = 0; draw < 800; ++draw)
    for (std::size_t k = 0; k < std::size(operations); ++k) {
      const double a = operations[k].positive ? operands.size() : operands.signed_size();
      const double b = operands.signed_size();
      const double error_a = operands.error(a);
      const double error_b = operands.error(b);
      using Number = laws::RunningError<R>;
      const Number result =
          result_of(k, Number::exactly(R(a)).widened(error_a), Number::exactly(R(b)).widened(error_b));
      SCOPED_TRACE(::testing::Message() << operations[k].name << " " << a << " +/- " << error_a << ", " << b
                                        << " +/- " << error_b << " has " << result.to_text());
      if (!std::isfinite(result.bound())) continue;
      ++bounded;
      double worst = 0;
      for (const double end_a : {-error_a, error_a})
        for (const double end_b : {-error_b, error_b}) {
          const Mpfr<200> truth = result_of(k, exactly(a) + exactly(end_a), exactly(b) + exactly(end_b));
          ASSERT_TRUE(truth.is_finite());
          worst = std::max(worst, std::abs((exactly(result.value()) - truth).to_double()));
        }
      ASSERT_LE(worst, result.bound());
      const double rounding = nearest_double(unit_roundoff<R>()) * std::abs(nearest_double(result.value()));
      const bool small = error_a <= 0x1p-10 * std::abs(a) && error_b <= 0x1p-10 * std::abs(b);
      if (operations[k].sharp && small) {
        ASSERT_LE(result.bound(), 2 * worst + 4 * rounding);
      }
    }
  EXPECT_GT(bounded, 8000U);
}

TEST(RunningError, BoundsDoublesAtTheEndsOfTheirErrors) { expect_bounds_at_the_ends<double>(); }
TEST(RunningError, BoundsFiftyDigitsAtTheEndsOfTheirErrors) { expect_bounds_at_the_ends<Mpfr<50>>(); }

TEST(RunningError, HasNoBoundWhereTheDomainMayBeLeft) {
  using Number = laws::RunningError<double>;
  const Number wide = Number::exactly(0.5).widened(0.5);
  const Number across = Number::exactly(0.5).widened(1);
  for (const Number& x :
       {Number(1) / wide, log(wide), pow(wide, Number(2)), sqrt(across), pow(-across, Number(2)),
        tan(Number::exactly(1.5).widened(0.1)), exp(Number(1000)), Number(1) / Number(0)})
    EXPECT_TRUE(std::isinf(x.bound())) << x.to_text();
}

TEST(RunningError, IsZeroWhereNothingIsRounded) {
  using Number = laws::RunningError<double>;
  const Number third(1.0 / 3, Rational(1, 3));
  EXPECT_GT(third.bound(), 0);
  for (const Number& x :
       {Number(0) * third, Number(0) / third, Number(5) - Number(5), sqrt(Number(0)), Number(7)})
    EXPECT_EQ(x.bound(), 0) << x.to_text();
  EXPECT_EQ((Number(0) + third).bound(), third.bound());
}

TEST(RunningError, BoundsBothBranches) {
  using Number = laws::RunningError<double>;
  const Number near = Number::exactly(1).widened(0.5);
  EXPECT_GE(select_less(near, Number::exactly(1.25), Number(3), Number(7)).bound(), 4);
  EXPECT_EQ(select_less(near, Number::exactly(2), Number(3), Number(7)).bound(), 0);
}

}  // namespace
}  // namespace radcert
