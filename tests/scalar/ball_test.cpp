// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/ball.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/scalar/mpfr_real.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Reference = Mpfr<200>;

static_assert(Real<Ball>);
static_assert(Enclosing<Ball> && !Enclosing<double> && !Enclosing<Reference>);
static_assert(std::is_nothrow_move_constructible_v<Ball> && std::is_nothrow_move_assignable_v<Ball>);
// 0.1 would enter as a double unnoticed, and an order of balls would be misused.
static_assert(!std::is_convertible_v<double, Ball> && !std::is_constructible_v<Ball, bool> &&
              !std::is_constructible_v<Ball, float>);
template <class T>
concept Ordered = requires(const T& a) {
  a < a;
}
|| requires(const T& a) { a == a; };
static_assert(!Ordered<Ball>);

constexpr std::array precisions{2L, 24L, 53L, 64L, 128L, 300L};

Ball around(const Draw::Interval& x) { return hull(Ball(x.low), Ball(x.high)); }

std::string shown(const Draw::Interval& x) { return "[" + shortest(x.low) + ", " + shortest(x.high) + "]"; }

/// A number that Rational can hold without filling the memory.
bool is_moderate(const Reference& x) {
  return x.is_finite() &&
         (x == 0 || (abs(x) < power(Reference(2), 20000) && abs(x) > power(Reference(2), -20000)));
}

/// Whether a ball contains a number that the reference knows up to its own rounding.
bool contains_up_to_rounding(const Ball& ball, const Reference& value) {
  const BallPrecision exactly(1000);
  const Ball exact(value.to_rational());
  return overlaps(ball, widened(exact, 4 * power(Ball(2), -Reference::bits) * exact));
}

struct Function {
  const char* name;
  std::function<Ball(const Ball&)> ball;
  std::function<Reference(const Reference&)> reference;
  std::function<bool(double)> defined;
  /// How much one rounding of the result, or of a quantity of size one on the way, may show: in units of
  /// 2^-bits max(|f|, absolute).
  double absolute = 0;
  bool increasing = false;
};

bool everywhere(double) { return true; }

std::vector<Function> functions() {
  return {
      {"negation", [](const Ball& x) { return -x; }, [](const Reference& x) { return -x; }, everywhere},
      {"sqrt", [](const Ball& x) { return sqrt(x); }, [](const Reference& x) { return sqrt(x); },
       [](double x) { return x >= 0; }, 0, true},
      {"exp", [](const Ball& x) { return exp(x); }, [](const Reference& x) { return exp(x); },
       [](double x) { return std::abs(x) < 1e4; }, 0, true},
      {"log", [](const Ball& x) { return log(x); }, [](const Reference& x) { return log(x); },
       [](double x) { return x > 0; }, 0, true},
      {"sin", [](const Ball& x) { return sin(x); }, [](const Reference& x) { return sin(x); }, everywhere, 1},
      {"cos", [](const Ball& x) { return cos(x); }, [](const Reference& x) { return cos(x); }, everywhere, 1},
      {"atan", [](const Ball& x) { return atan(x); }, [](const Reference& x) { return atan(x); }, everywhere,
       0, true},
      {"abs", [](const Ball& x) { return abs(x); }, [](const Reference& x) { return abs(x); }, everywhere},
      {"square", [](const Ball& x) { return x * x; }, [](const Reference& x) { return x * x; }, everywhere},
      {"cube", [](const Ball& x) { return power(x, 3); }, [](const Reference& x) { return power(x, 3); },
       everywhere, 0, true},
      {"fourth power", [](const Ball& x) { return power(x, 4); },
       [](const Reference& x) { return power(x, 4); }, everywhere},
      {"reciprocal", [](const Ball& x) { return reciprocal(x); }, [](const Reference& x) { return 1 / x; },
       [](double x) { return x != 0; }},
      {"x^-3", [](const Ball& x) { return power(x, -3); }, [](const Reference& x) { return 1 / (x * x * x); },
       [](double x) { return x != 0; }},
      {"x^-2", [](const Ball& x) { return power(x, -2); }, [](const Reference& x) { return 1 / (x * x); },
       [](double x) { return x != 0; }},
  };
}

/// f(ball) contains f(point) for every point, and has failed where f is not defined at one of them.
void expect_enclosure(const Function& f, const Ball& result, const std::vector<double>& points) {
  for (const double x : points) {
    if (!f.defined(x)) {
      if (std::string(f.name) != "exp") {
        EXPECT_FALSE(result.is_finite()) << "not defined at " << shortest(x);
      }
      continue;
    }
    const Reference value = f.reference(Reference(x));
    if (!is_moderate(value)) continue;
    EXPECT_TRUE(contains_up_to_rounding(result, value))
        << "at " << shortest(x) << ": " << value.to_text(60) << " is not in " << result.to_text(60);
  }
}

TEST(Ball, ContainsTheValuesOfAFunctionAtThePointsOfABall) {
  for (const Function& f : functions()) {
    Draw draw(1);
    for (int trial = 0; trial < 2500; ++trial) {
      const BallPrecision precision(precisions[draw.below(precisions.size())]);
      const Draw::Interval x = draw.interval();
      SCOPED_TRACE(std::string(f.name) + " of " + shown(x) + " at " +
                   std::to_string(BallPrecision::current()) + " bits");
      expect_enclosure(f, f.ball(around(x)), draw.points(x));
      if (HasFailure()) return;
    }
  }
}

TEST(Ball, IsNarrowForExactOperands) {
  for (const Function& f : functions()) {
    Draw draw(2);
    for (int trial = 0; trial < 2000; ++trial) {
      const BallPrecision precision(precisions[1 + draw.below(precisions.size() - 1)]);
      const double x = draw.number();
      if (!f.defined(x)) continue;
      const Ball result = f.ball(Ball(x));
      const Ball unit = power(Ball(2), -BallPrecision::current());
      const Ball allowed = 8 * unit * (abs(result.midpoint()) + Ball(f.absolute));
      ASSERT_TRUE(result.is_finite()) << f.name << " at " << shortest(x) << ": " << result.to_text();
      ASSERT_TRUE(certainly_at_most(result.radius_ball(), allowed))
          << f.name << " at " << shortest(x) << ", " << BallPrecision::current()
          << " bits: " << result.to_text();
    }
  }
}

TEST(Ball, OfAMonotoneFunctionIsItsRangeUpToRounding) {
  for (const Function& f : functions()) {
    if (!f.increasing) continue;
    Draw draw(3);
    for (int trial = 0; trial < 2000; ++trial) {
      const Draw::Interval x = draw.interval();
      if (!f.defined(around(x).lower_double()) || !f.defined(x.high)) continue;
      const Ball result = f.ball(around(x));
      const Ball low = f.ball(around(x).lower());
      const Ball high = f.ball(around(x).upper());
      const Ball range = hull(low, high);
      SCOPED_TRACE(std::string(f.name) + " of " + shown(x));
      ASSERT_TRUE(result.is_finite());
      // Radii have 30 bits, and some of Arb's bounds for them fewer; midpoints have 128.
      const double wide_excess = 0.002;
      const Ball slack = range.radius_ball() * Ball(wide_excess) + abs(range).upper() * Ball(1e-36);
      ASSERT_TRUE(certainly_at_most(result.radius_ball(), range.radius_ball() + slack))
          << result.to_text() << " for " << range.to_text();
    }
  }
}

struct BinaryFunction {
  const char* name;
  std::function<Ball(const Ball&, const Ball&)> ball;
  std::function<Rational(const Rational&, const Rational&)> exact;
};

TEST(Ball, ContainsSumsProductsAndQuotientsExactly) {
  const std::vector<BinaryFunction> operations{
      {"+", [](const Ball& a, const Ball& b) { return a + b; },
       [](const Rational& a, const Rational& b) { return a + b; }},
      {"-", [](const Ball& a, const Ball& b) { return a - b; },
       [](const Rational& a, const Rational& b) { return a - b; }},
      {"*", [](const Ball& a, const Ball& b) { return a * b; },
       [](const Rational& a, const Rational& b) { return a * b; }},
      {"/", [](const Ball& a, const Ball& b) { return a / b; },
       [](const Rational& a, const Rational& b) { return a / b; }},
      {"+=", [](Ball a, const Ball& b) { return a += b; },
       [](const Rational& a, const Rational& b) { return a + b; }},
      {"-=", [](Ball a, const Ball& b) { return a -= b; },
       [](const Rational& a, const Rational& b) { return a - b; }},
      {"*=", [](Ball a, const Ball& b) { return a *= b; },
       [](const Rational& a, const Rational& b) { return a * b; }},
      {"/=", [](Ball a, const Ball& b) { return a /= b; },
       [](const Rational& a, const Rational& b) { return a / b; }},
      {"fma", [](const Ball& a, const Ball& b) { return fma(a, b, a); },
       [](const Rational& a, const Rational& b) { return a * b + a; }},
      {"min", [](const Ball& a, const Ball& b) { return min(a, b); },
       [](const Rational& a, const Rational& b) { return a < b ? a : b; }},
      {"max", [](const Ball& a, const Ball& b) { return max(a, b); },
       [](const Rational& a, const Rational& b) { return a < b ? b : a; }},
      {"hull", [](const Ball& a, const Ball& b) { return hull(a, b); },
       [](const Rational& a, const Rational& b) { return (a + b) / Rational(2); }},
      {"widened", [](const Ball& a, const Ball& b) { return widened(a, b); },
       [](const Rational& a, const Rational& b) { return a + b; }},
      {"select_less", [](const Ball& a, const Ball& b) { return select_less(a, b, a + 1, b - 1); },
       [](const Rational& a, const Rational& b) { return a < b ? a + 1 : b - 1; }},
  };
  for (const BinaryFunction& f : operations) {
    Draw draw(4);
    for (int trial = 0; trial < 1500; ++trial) {
      const BallPrecision precision(precisions[draw.below(precisions.size())]);
      const Draw::Interval x = draw.interval();
      const Draw::Interval y = draw.interval();
      const Ball a = around(x);
      const Ball b = around(y);
      const Ball result = f.ball(a, b);
      SCOPED_TRACE(std::string(f.name) + " of " + shown(x) + " and " + shown(y) + " at " +
                   std::to_string(BallPrecision::current()) + " bits");
      for (const double s : draw.points(x))
        for (const double t : draw.points(y)) {
          if (f.name[0] == '/' && t == 0) {
            ASSERT_FALSE(result.is_finite());
            continue;
          }
          ASSERT_TRUE(result.contains(f.exact(Rational::exactly(s), Rational::exactly(t))))
              << "at " << shortest(s) << ", " << shortest(t) << ": " << result.to_text(40);
        }
      if (a.is_exact() && b.is_exact() && f.name[0] != 'h' && f.name[0] != 'w' && result.is_finite() &&
          BallPrecision::current() > 2) {
        const Ball unit = power(Ball(2), -BallPrecision::current());
        // fma and select_less round sums that may cancel: relative to the larger operand.
        const Ball size = max(abs(result), f.name[0] == 's' ? max(abs(a), abs(b)) : Ball());
        ASSERT_TRUE(certainly_at_most(result.radius_ball(), 4 * unit * size.upper())) << result.to_text();
      }
    }
  }
}

TEST(Ball, ContainsPowers) {
  Draw draw(5);
  int finite = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const BallPrecision precision(precisions[draw.below(precisions.size())]);
    const Draw::Interval x = draw.interval();
    Draw::Interval y = draw.interval();
    if (draw.below(2) == 0)
      y.low = y.high = std::round(10 * draw.unit() - 5) / static_cast<double>(1 + draw.below(2));
    const Ball base = around(x);
    const Ball exponent = around(y);
    const Ball result = pow(base, exponent);
    finite += result.is_finite() ? 1 : 0;
    SCOPED_TRACE(shown(x) + "^" + shown(y) + " at " + std::to_string(BallPrecision::current()) + " bits");
    for (const double s : draw.points(x))
      for (const double t : draw.points(y)) {
        const bool whole = t == std::floor(t);
        const bool defined = s > 0 || (s == 0 && t >= 0) || (s < 0 && whole);
        if (!defined) {
          ASSERT_FALSE(result.is_finite()) << shortest(s) << "^" << shortest(t) << " is not defined";
        } else if (s == 0 || std::abs(t * std::log(std::abs(s))) < 5000) {
          const Reference value = pow(Reference(s), Reference(t));
          ASSERT_TRUE(contains_up_to_rounding(result, value))
              << shortest(s) << "^" << shortest(t) << " = " << value.to_text(40) << " in "
              << result.to_text(40);
        }
      }
    const bool inside = (certainly_positive(base) || (x.low == 0 && y.low > 0)) && std::abs(y.low) < 1e4 &&
                        std::abs(y.high) < 1e4;
    if (inside && BallPrecision::current() > 2) {
      ASSERT_TRUE(result.is_finite()) << result.to_text();
      ASSERT_FALSE(certainly_negative(result.lower()));
    }
  }
  EXPECT_GT(finite, 5000);
}

TEST(Ball, OfAPowerOfAPointIsNarrow) {
  for (const double x : {1e-30, 0.3, 1.0, 1.7, 1e20})
    for (const Rational& e : {Rational(3, 2), Rational(-7, 2), Rational(1, 2), Rational(11, 8)}) {
      const Ball result = pow(Ball(x), Ball(e));
      EXPECT_GT(result.accurate_bits(), 120) << shortest(x) << " " << e.to_text();
    }
  // [0, h]^(3/2) = [0, h^(3/2)]
  const Ball to_zero = pow(hull(Ball(0), Ball(0.25)), Ball(1.5));
  EXPECT_TRUE(to_zero.contains(0.0) && to_zero.contains(0.125));
  EXPECT_LT(to_zero.upper_double(), 0.1251);
  EXPECT_GE(to_zero.lower_double(), 0);
}

TEST(Ball, OfTheTangentStopsAtItsPoles) {
  Draw draw(6);
  int finite = 0;
  for (int trial = 0; trial < 10000; ++trial) {
    const Draw::Interval x = draw.interval();
    const Ball result = tan(around(x));
    finite += result.is_finite() ? 1 : 0;
    SCOPED_TRACE(shown(x));
    for (const double s : draw.points(x)) {
      ASSERT_TRUE(contains_up_to_rounding(result, tan(Reference(s))))
          << shortest(s) << ": " << result.to_text();
    }
    if (x.low == x.high) {
      ASSERT_TRUE(result.is_finite());
    }
    if (x.high - x.low > 3.2) {
      ASSERT_FALSE(result.is_finite());
    }
  }
  EXPECT_GT(finite, 5000);
  EXPECT_FALSE(tan(hull(Ball(1.5), Ball(1.6))).is_finite());
  EXPECT_TRUE(tan(hull(Ball(-1.5), Ball(1.5))).is_finite());
}

TEST(Ball, OfRationalsAndPiEncloses) {
  Draw draw(7);
  for (int trial = 0; trial < 2000; ++trial) {
    const BallPrecision precision(precisions[draw.below(precisions.size())]);
    const Rational q(static_cast<long>(draw.bits()) >> (draw.below(63)),
                     1 + static_cast<long>(draw.below(1000000)));
    const Ball ball = from_rational<Ball>(q);
    ASSERT_TRUE(ball.contains(q)) << q.to_text();
    ASSERT_TRUE(
        certainly_at_most(ball.radius_ball(), 8 * power(Ball(2), -BallPrecision::current()) * abs(ball)));
    const Rational beside = q + Rational(1, 1000000000L) * (q.sign() == 0 ? Rational(1) : abs(q));
    if (BallPrecision::current() > 60) {
      ASSERT_FALSE(ball.contains(beside));
    }
  }
  for (const long bits : precisions) {
    const BallPrecision precision(bits);
    EXPECT_TRUE(pi<Ball>().contains(Reference::pi().to_rational()));
    EXPECT_GE(pi<Ball>().accurate_bits(), bits - 2);
  }
  EXPECT_TRUE(Ball(Rational(3, 8)).is_exact());
  EXPECT_TRUE(Ball(0.1).is_exact());
  EXPECT_FALSE(Ball(0.1).contains(Rational(1, 10)));
  EXPECT_TRUE(Ball(std::numeric_limits<long>::min()).contains(Rational(std::numeric_limits<long>::min())));
  EXPECT_TRUE(Ball(std::numeric_limits<unsigned long>::max())
                  .contains(Rational(std::numeric_limits<unsigned long>::max())));
}

TEST(Ball, HasTheEndsOfItsHull) {
  Draw draw(8);
  for (int trial = 0; trial < 5000; ++trial) {
    const Draw::Interval x = draw.interval();
    const Ball ball = around(x);
    SCOPED_TRACE(shown(x));
    ASSERT_LE(ball.lower_double(), x.low);
    ASSERT_GE(ball.upper_double(), x.high);
    ASSERT_TRUE(ball.contains(x.low) && ball.contains(x.high));
    ASSERT_TRUE(certainly_at_most(ball.lower(), Ball(x.low)) &&
                certainly_at_most(Ball(x.high), ball.upper()));
    const Ball third = ball / 3;
    ASSERT_TRUE(certainly_at_most(Ball(third.lower_double()), third.lower()) ||
                third.lower_double() == -HUGE_VAL);
    ASSERT_TRUE(certainly_at_most(third.upper(), Ball(third.upper_double())) ||
                third.upper_double() == HUGE_VAL);
    // A ball on one side of zero does not leave it.
    if (x.low >= 0) {
      ASSERT_FALSE(certainly_negative(ball.lower()));
      ASSERT_TRUE(sqrt(ball).is_finite());
    }
    if (x.high <= 0) {
      ASSERT_FALSE(certainly_positive(ball.upper()));
    }
    const Rational half_width = (Rational::exactly(x.high) - Rational::exactly(x.low)) / Rational(2);
    const double slack = 1e-8 * half_width.to_double() + 1e-37 * std::max(std::abs(x.low), std::abs(x.high));
    ASSERT_LE(ball.radius(), half_width.to_double() + slack + 1e-300);
    ASSERT_NEAR(ball.to_double(), x.low / 2 + x.high / 2,
                2e-9 * ball.radius() + 1e-15 * std::abs(x.low) + 1e-323);
    // Neither the hull with a part nor the common part with a whole changes a ball.
    const Ball inner(draw.points(x).back());
    ASSERT_LE(hull(ball, inner).radius(), ball.radius());
    ASSERT_TRUE(intersection(ball, inner).is_exact());
  }
}

TEST(Ball, CommonPartContainsWhatBothContain) {
  Draw draw(9);
  int meetings = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const Draw::Interval x = draw.interval();
    const Draw::Interval y = draw.interval();
    const Ball a = around(x);
    const Ball b = around(y);
    if (!overlaps(a, b)) {
      ASSERT_TRUE(certainly_less(a, b) || certainly_less(b, a)) << shown(x) << shown(y);
      ASSERT_THROW((void)intersection(a, b), ContractViolation);
      continue;
    }
    ++meetings;
    const Ball common = intersection(a, b);
    for (const double s : draw.points(x))
      if (b.contains(s)) {
        ASSERT_TRUE(common.contains(s)) << shown(x) << shown(y) << shortest(s);
      }
    ASSERT_LE(common.radius(), a.radius());
    ASSERT_LE(common.radius(), b.radius());
    const double half_width = std::min(x.high, y.high) / 2 - std::max(x.low, y.low) / 2;
    const double size = std::max(std::abs(std::min(x.high, y.high)), std::abs(std::max(x.low, y.low)));
    // The ends of a and b themselves are off by the last of 30 bits of their radii.
    const double slack = 1e-8 * std::min(a.radius(), b.radius()) + 1e-8 * half_width + 1e-15 * size;
    ASSERT_LE(common.radius(),
              std::max(half_width, 0.0) + slack + 2e-9 * std::max(a.radius(), b.radius()) + 1e-300)
        << shown(x) << shown(y);
  }
  EXPECT_GT(meetings, 500);
  const Ball failed = 1 / Ball(0);
  EXPECT_EQ(intersection(failed, Ball(2)).to_double(), 2);
  EXPECT_EQ(intersection(Ball(2), failed).to_double(), 2);
}

TEST(Ball, ComparesOnlyWhatIsCertain) {
  Draw draw(10);
  for (int trial = 0; trial < 5000; ++trial) {
    const Draw::Interval x = draw.interval();
    const Draw::Interval y = draw.interval();
    const Ball a = around(x);
    const Ball b = around(y);
    SCOPED_TRACE(shown(x) + shown(y));
    if (certainly_less(a, b)) {
      ASSERT_LT(x.high, y.low);
    }
    if (certainly_at_most(a, b)) {
      ASSERT_LE(x.high, y.low);
    }
    if (a.is_exact() && b.is_exact()) {
      ASSERT_EQ(certainly_less(a, b), x.low < y.low);
      ASSERT_EQ(certainly_at_most(a, b), x.low <= y.low);
    }
    ASSERT_EQ(certainly_positive(a), certainly_less(Ball(0), a));
    ASSERT_EQ(certainly_negative(a), certainly_less(a, Ball(0)));
    ASSERT_EQ(certainly_zero(a), x.low == 0 && x.high == 0);
  }
}

TEST(Ball, OfASquareIsNeverNegative) {
  const Ball wide = hull(Ball(-1), Ball(3));
  EXPECT_GE((wide * wide).lower_double(), 0);
  EXPECT_LE((wide * wide).upper_double(), 9.0001);
  const Ball copy = wide;
  EXPECT_LE((wide * copy).lower_double(), -3);  // two numbers, not one
  Ball in_place = wide;
  in_place *= in_place;
  EXPECT_GE(in_place.lower_double(), 0);
  EXPECT_LE(in_place.upper_double(), 9.0001);
  const Ball away = hull(Ball(1), Ball(3));
  EXPECT_GT((away * away).lower_double(), 0.9999);
  EXPECT_GE(fma(wide, wide, Ball(0)).lower_double(), 0);
}

TEST(Ball, SaysWhichOperationFailedFirst) {
  const Ball zero;
  const Ball around_zero = hull(Ball(-1), Ball(1));
  const std::vector<std::pair<const char*, Ball>> failures{
      {"division", 1 / around_zero},
      {"division", 1 / zero},
      {"division", reciprocal(around_zero)},
      {"negative power", power(around_zero, -2)},
      {"sqrt", sqrt(around_zero)},
      {"log", log(around_zero)},
      {"log", log(zero)},
      {"tan", tan(hull(Ball(1), Ball(2)))},
      {"pow", pow(around_zero, Ball(0.5))},
      {"pow", pow(Ball(-2), Ball(0.5))},
      {"pow", pow(Ball(-2), Ball(Rational(1, 3)))},
      {"power", pow(zero, Ball(-1))},
      {"pow", pow(zero, around_zero)},
      {"exp", exp(exp(exp(Ball(1000))))},
      {"double", Ball(HUGE_VAL)},
      {"double", Ball(std::numeric_limits<double>::quiet_NaN())},
  };
  for (const auto& [word, failed] : failures) {
    ASSERT_FALSE(failed.is_finite()) << word << ": " << failed.to_text();
    EXPECT_NE(std::string(failed.failure()).find(word), std::string::npos) << failed.failure();
    EXPECT_NE(failed.to_text().find(failed.failure()), std::string::npos);
    EXPECT_TRUE(failed.contains(1e300) && failed.contains(Rational(-1, 7)) && failed.contains(around_zero));
    EXPECT_EQ(failed.radius(), HUGE_VAL);
    EXPECT_EQ(failed.lower_double(), -HUGE_VAL);
    EXPECT_EQ(failed.upper_double(), HUGE_VAL);
    EXPECT_FALSE(certainly_less(failed, Ball(1)) || certainly_less(Ball(1), failed) ||
                 certainly_at_most(failed, failed) || certainly_positive(failed) ||
                 certainly_negative(failed) || certainly_zero(failed));
    EXPECT_THROW((void)failed.to_double(), ContractViolation);
    EXPECT_THROW((void)failed.decimal(10), ContractViolation);
    EXPECT_THROW((void)failed.midpoint_binary(), ContractViolation);
    const Ball other = log(Ball(-1));
    Ball sum = Ball(1);
    sum += failed;
    Ball difference = Ball(1);
    difference -= failed;
    Ball product = zero;
    product *= failed;
    Ball moved_from = failed;
    const Ball moved = std::move(moved_from);
    for (const Ball& kept : {failed + 1,
                             1 - failed,
                             zero * failed,
                             failed * failed,
                             failed / 3,
                             3 / failed,
                             -failed,
                             sum,
                             difference,
                             product,
                             moved,
                             sqrt(failed),
                             exp(failed),
                             log(failed),
                             sin(failed),
                             cos(failed),
                             tan(failed),
                             atan(failed),
                             abs(failed),
                             power(failed, 0),
                             power(failed, 2),
                             power(failed, -1),
                             pow(failed, zero),
                             pow(Ball(1), failed),
                             min(failed, Ball(1)),
                             max(Ball(1), failed),
                             hull(Ball(1), failed),
                             widened(failed, Ball(1)),
                             widened(Ball(1), failed),
                             fma(Ball(1), Ball(1), failed),
                             fma(zero, failed, Ball(1)),
                             reciprocal(failed),
                             failed.midpoint(),
                             failed.lower(),
                             failed.upper(),
                             failed.radius_ball(),
                             select_less(failed, Ball(1), Ball(2), Ball(3)),
                             failed + other,
                             failed * other,
                             failed / other,
                             min(failed, other),
                             pow(failed, other),
                             hull(failed, other),
                             intersection(failed, other)}) {
      EXPECT_FALSE(kept.is_finite());
      EXPECT_EQ(kept.failure(), failed.failure());
    }
  }
  EXPECT_EQ(Ball(1).failure(), "");
  EXPECT_EQ((1 / Ball(3)).failure(), "");
}

TEST(Ball, IsAValue) {
  for (const long bits : {64L, 128L, 1000L}) {  // beyond 128 bits on the heap
    const BallPrecision precision(bits);
    Ball a(Rational(1, 3));
    const Ball third = a;
    Ball b = a;
    b += 1;
    EXPECT_TRUE(a.contains(Rational(1, 3)));
    EXPECT_TRUE(b.contains(Rational(4, 3)));
    Ball c = std::move(b);
    EXPECT_TRUE(c.contains(Rational(4, 3)));
    b = Ball(5);  // a moved-from ball may be assigned to
    EXPECT_EQ(b.to_double(), 5);
    swap(a, c);
    EXPECT_TRUE(a.contains(Rational(4, 3)) && c.contains(Rational(1, 3)));
    Ball& same = a;
    a = same;
    a = std::move(same);
    EXPECT_TRUE(a.contains(Rational(4, 3)) && a.is_finite());
    a += a;
    EXPECT_TRUE(a.contains(Rational(8, 3)));
    a -= a;
    EXPECT_TRUE(a.contains_zero());
    a = third / third;
    a /= a;
    EXPECT_TRUE(a.contains(1.0));
    Ball failed = 1 / Ball(0);
    a = failed;
    EXPECT_FALSE(a.is_finite());
    a = third;
    EXPECT_TRUE(a.is_finite());
    std::vector<Ball> many;
    for (int i = 1; i < 100; ++i) many.emplace_back(Rational(1, i));
    EXPECT_TRUE(many[50].contains(Rational(1, 51)));
    many.erase(many.begin(), many.begin() + 50);
    EXPECT_TRUE(many[0].contains(Rational(1, 51)));
  }
}

TEST(Ball, KnowsItsAccuracy) {
  const BallPrecision precision(128);
  EXPECT_GE(Ball(Rational(1, 3)).accurate_bits(), 126);
  EXPECT_LE(Ball(Rational(1, 3)).accurate_bits(), 130);
  EXPECT_GT(Ball(3).accurate_bits(), 1000000);
  EXPECT_LE(hull(Ball(-1), Ball(2)).accurate_bits(), 0);
}

}  // namespace
}  // namespace radcert
