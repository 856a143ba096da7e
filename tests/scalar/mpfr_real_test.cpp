// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/mpfr_real.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

template <class R>
class MpfrOf : public testing::Test {};
using Sizes = testing::Types<Mpfr<50>, Mpfr<100>, Mpfr<200>>;
TYPED_TEST_SUITE(MpfrOf, Sizes);

static_assert(Real<Mpfr<50>> && Real<Mpfr<100>> && Real<Mpfr<200>>);
static_assert(std::is_trivially_copyable_v<Mpfr<50>>);
static_assert(!std::is_convertible_v<double, Mpfr<50>> && !std::is_constructible_v<Mpfr<50>, bool>);

template <class R>
Rational unit() {
  return power(Rational(2), -R::bits);
}

/// |x - exact| <= 2^-bits |exact|: what rounding to nearest leaves.
template <class R>
bool is_rounded(const R& x, const Rational& exact) {
  return abs(x.to_rational() - exact) <= unit<R>() * abs(exact);
}

TYPED_TEST(MpfrOf, HasThePrecisionThatItsDigitsAskFor) {
  using R = TypeParam;
  EXPECT_LT(power(Rational(2), -R::bits), power(Rational(10), -R::digits) / Rational(2));
  EXPECT_EQ(unit_roundoff<R>().to_rational(), unit<R>());
  EXPECT_EQ(R(1) + unit_roundoff<R>(), R(1));  // a tie goes to even
  EXPECT_NE(R(1) + 2 * unit_roundoff<R>(), R(1));
}

TYPED_TEST(MpfrOf, HasTheKnownDigits) {
  using R = TypeParam;
  const auto expect_digits = [](const R& x, const char* digits) {
    const int known = std::min(R::digits, 110);
    const Rational truth = Rational::parse(digits).value();
    EXPECT_LE(abs(x.to_rational() - truth), power(Rational(10), 1 - known)) << x.to_text() << "\n" << digits;
  };
  // mpmath 1.3, mp.dps = 130
  expect_digits(pi<R>(),
                "3.1415926535897932384626433832795028841971693993751058209749"
                "4459230781640628620899862803482534211706798214808651328230");
  expect_digits(exp(R(1)),
                "2.7182818284590452353602874713526624977572470936999595749669"
                "6762772407663035354759457138217852516642742746639193200305");
  expect_digits(sqrt(R(2)),
                "1.4142135623730950488016887242096980785696718753769480731766"
                "7973799073247846210703885038753432764157273501384623091229");
  expect_digits(log(R(2)),
                "0.6931471805599453094172321214581765680755001343602552541206"
                "8000949339362196969471560586332699641868754200148102057068");
  expect_digits(atan(R(1) / 5),
                "0.1973955598498807583700497651947902934475851037878521015176"
                "8894024103396997824378573269782803728804411262811807369136");
  expect_digits(sin(R(1)),
                "0.8414709848078965066525023216302989996225630607983710656727"
                "5170999191040439123966894863974354305269585434903790792067");
  expect_digits(cos(R(1)),
                "0.5403023058681397174009366074429766037323104206179222276700"
                "9725538110039477447176451795185608718308934357173116003008");
  expect_digits(tan(R(1)),
                "1.5574077246549022305069748074583601730872507723815200383839"
                "4660569886139715172728955509996520224298380463382141174816");
  expect_digits(pow(R(2), R(1) / 3),
                "1.2599210498948731647672106072782283505702514647015079800819"
                "7511215529967651395948372939656243625509415431025603561566");
}

TYPED_TEST(MpfrOf, RoundsSumsProductsAndQuotientsToNearest) {
  using R = TypeParam;
  Draw draw(31);
  for (int trial = 0; trial < 3000; ++trial) {
    const double a = draw.number();
    const double b = draw.number();
    const R x = from_rational<R>(Rational::exactly(a) / Rational(3));
    const R y = from_rational<R>(Rational::exactly(b) / Rational(7));
    const Rational p = x.to_rational();
    const Rational q = y.to_rational();
    SCOPED_TRACE(shortest(a) + ", " + shortest(b));
    ASSERT_TRUE(is_rounded(x, Rational::exactly(a) / Rational(3)));
    ASSERT_TRUE(is_rounded(x + y, p + q));
    ASSERT_TRUE(is_rounded(x - y, p - q));
    ASSERT_TRUE(is_rounded(x * y, p * q));
    ASSERT_TRUE(is_rounded(fma(x, y, x), p * q + p));
    if (b != 0) {
      ASSERT_TRUE(is_rounded(x / y, p / q));
      R in_place = x;
      in_place /= y;
      ASSERT_EQ(in_place, x / y);
    }
    R in_place = x;
    ASSERT_EQ(in_place += y, x + y);
    ASSERT_EQ(in_place -= y, x + y - y);
    ASSERT_EQ(in_place *= y, (x + y - y) * y);
    ASSERT_EQ((-x).to_rational(), -p);
    ASSERT_EQ(abs(x).to_rational(), abs(p));
    const R root = sqrt(abs(x));
    ASSERT_TRUE(abs(root.to_rational() * root.to_rational() - abs(p)) <= Rational(3) * unit<R>() * abs(p));
    ASSERT_EQ(x < y, p < q);
    ASSERT_EQ(x <= y, p <= q);
    ASSERT_EQ(x == y, p == q);
    ASSERT_EQ(min(x, y).to_rational(), p < q ? p : q);
    ASSERT_EQ(max(x, y).to_rational(), p < q ? q : p);
  }
}

TYPED_TEST(MpfrOf, TakesAndGivesDoubles) {
  using R = TypeParam;
  Draw draw(32);
  for (int trial = 0; trial < 3000; ++trial) {
    const double a = draw.number();
    ASSERT_EQ(R(a).to_double(), a);
    ASSERT_EQ(R(a).to_rational(), Rational::exactly(a));
    const Rational q = Rational::exactly(a) / Rational(3) + Rational::exactly(draw.number());
    ASSERT_EQ(R(q).to_double(), R(q).to_rational().to_double());
  }
  EXPECT_EQ(R(HUGE_VAL).to_double(), HUGE_VAL);
  EXPECT_TRUE(std::isnan(R(std::numeric_limits<double>::quiet_NaN()).to_double()));
  EXPECT_EQ(R(std::numeric_limits<long>::min()).to_rational(), Rational(std::numeric_limits<long>::min()));
  EXPECT_EQ(R(std::numeric_limits<unsigned long>::max()).to_rational(),
            Rational(std::numeric_limits<unsigned long>::max()));
  EXPECT_EQ((R(1e300) * R(1e300)).to_double(), HUGE_VAL);
  EXPECT_EQ((R(1e-300) * R(1e-300)).to_double(), 0);
}

TYPED_TEST(MpfrOf, AgreesWithLongDouble) {
  using R = TypeParam;
  Draw draw(33);
  const auto expect_near = [](const char* name, const R& x, long double truth) {
    if (!std::isfinite(truth) || truth == 0) return;
    const auto head = static_cast<double>(truth);
    const R exact = R(head) + R(static_cast<double>(truth - static_cast<long double>(head)));
    ASSERT_TRUE(abs(x - exact) <= R(4e-19) * abs(exact))
        << name << ": " << x.to_text() << " " << exact.to_text();
  };
  for (int trial = 0; trial < 3000; ++trial) {
    const double a = draw.number();
    const double b = 8 * draw.unit() - 4;
    const auto x = static_cast<long double>(a);
    SCOPED_TRACE(shortest(a));
    if (std::abs(a) < 1e3) {
      if (std::abs(a) < 600) expect_near("exp", exp(R(a)), std::exp(x));
      expect_near("sin", sin(R(a)), std::sin(x));
      expect_near("cos", cos(R(a)), std::cos(x));
    }
    if (a > 0) {
      expect_near("log", log(R(a)), std::log(x));
      expect_near("sqrt", sqrt(R(a)), std::sqrt(x));
      if (std::abs(b * std::log(a)) < 600)
        expect_near("pow", pow(R(a), R(b)), std::pow(x, static_cast<long double>(b)));
    }
    expect_near("atan", atan(R(a)), std::atan(x));
  }
}

TYPED_TEST(MpfrOf, SatisfiesTheFunctionalEquations) {
  using R = TypeParam;
  Draw draw(34);
  const R u = unit_roundoff<R>();
  for (int trial = 0; trial < 300; ++trial) {
    const R x = from_rational<R>(Rational::exactly(4 * draw.unit()) / Rational(3));
    const R y = from_rational<R>(Rational::exactly(4 * draw.unit()) / Rational(7));
    ASSERT_LE(abs(exp(x) * exp(y) / exp(x + y) - 1), 16 * u);
    ASSERT_LE(abs(log(exp(x)) - x), 16 * u * (1 + x));
    ASSERT_LE(abs(sin(x) * sin(x) + cos(x) * cos(x) - 1), 8 * u);
    ASSERT_LE(abs(tan(x) * cos(x) - sin(x)), 8 * u);
    ASSERT_LE(abs(tan(atan(x)) - x), 32 * u * (1 + x * x));
    ASSERT_LE(abs(pow(1 + x, y) - exp(y * log(1 + x))), 64 * u * exp(y * log(1 + x)));
    ASSERT_LE(abs(power(x, 5) - pow(x, R(5))), 16 * u * power(x, 5));
  }
  EXPECT_LE(abs(4 * atan(R(1)) - pi<R>()), 8 * u);
}

TYPED_TEST(MpfrOf, TextReadsBack) {
  using R = TypeParam;
  Draw draw(35);
  for (int trial = 0; trial < 2000; ++trial) {
    const R x = from_rational<R>(Rational::exactly(draw.number()) / Rational(3));
    ASSERT_EQ(R::parse(x.to_text(R::round_trip_digits)).value(), x) << x.to_text(R::round_trip_digits);
    const int digits = 1 + static_cast<int>(draw.below(40));
    const Rational rounded = Rational::parse(x.to_text(digits)).value();
    ASSERT_LE(abs(rounded - x.to_rational()), abs(rounded) * Rational(1, 2) * power(Rational(10), 1 - digits))
        << x.to_text(digits);
  }
  EXPECT_EQ(R(120).to_text(3), "120");
  EXPECT_EQ(R(-12.5).to_text(3), "-12.5");
  EXPECT_EQ(R(1024).to_text(2), "1.0e3");
  EXPECT_EQ(R(-0.25).to_text(2), "-2.5e-1");
  EXPECT_EQ(R(7).to_text(1), "7");
  EXPECT_EQ(R().to_text(), "0");
  EXPECT_THROW((void)R(1).to_text(0), ContractViolation);
  EXPECT_EQ(R::parse("1/8").value(), R(0.125));
  for (const char* text : {"", "x", "1e", "nan", "inf", "1/0"})
    EXPECT_FALSE(R::parse(text).has_value()) << text;
}

TYPED_TEST(MpfrOf, HasInfinitiesAndNaNAsDoubleHas) {
  using R = TypeParam;
  const R infinity = 1 / R(0);
  const R nan = R(0) / R(0);
  EXPECT_EQ(infinity.to_text(), "inf");
  EXPECT_EQ((-infinity).to_text(), "-inf");
  EXPECT_EQ(nan.to_text(), "nan");
  EXPECT_FALSE(infinity.is_finite() || nan.is_finite());
  EXPECT_TRUE(nan.is_nan() && !infinity.is_nan());
  EXPECT_TRUE(R(1) < infinity && -infinity < R(1));
  EXPECT_FALSE(nan < R(1) || R(1) < nan || nan == nan || nan <= nan);
  EXPECT_FALSE(certainly_less(nan, R(1)) || certainly_at_most(nan, nan) || certainly_zero(nan));
  EXPECT_TRUE(certainly_less(R(1), R(2)) && certainly_positive(R(1)) && certainly_negative(-R(1)) &&
              certainly_zero(R()));
  EXPECT_TRUE(min(nan, R(1)).is_nan() && min(R(1), nan).is_nan() && max(nan, R(1)).is_nan() &&
              max(R(1), nan).is_nan());
  EXPECT_TRUE(sqrt(R(-1)).is_nan() && log(R(-1)).is_nan() && (infinity - infinity).is_nan());
  EXPECT_EQ(pow(R(0), R(0)), R(1));
  EXPECT_EQ(exp(-infinity), R(0));
  EXPECT_THROW((void)nan.to_rational(), ContractViolation);
}

TYPED_TEST(MpfrOf, IsAValue) {
  using R = TypeParam;
  R a = from_rational<R>(Rational(1, 3));
  const R third = a;
  R b = a;
  b += 1;
  EXPECT_EQ(a, third);
  R c = std::move(b);
  std::swap(a, c);
  EXPECT_EQ(c, third);
  EXPECT_EQ(a, third + 1);
  R& same = a;
  a = same;
  a = a - a;
  EXPECT_EQ(a, R());
  a = third;
  a *= a;
  EXPECT_EQ(a, third * third);
  a = a / a;
  EXPECT_EQ(a, R(1));
  std::vector<R> many;
  for (int i = 1; i < 100; ++i) many.push_back(R(1) / i);
  EXPECT_EQ(many[2], third);
}

TEST(Mpfr, GivesTheSameBitsInEveryThread) {
  const auto value = [] { return (exp(Mpfr<100>(1)) * log(Mpfr<100>(3)) + pi<Mpfr<100>>()).to_text(100); };
  const std::string here = value();
  std::array<std::string, 8> there;
  std::vector<std::thread> workers;
  for (std::string& text : there) workers.emplace_back([&text, &value] { text = value(); });
  for (std::thread& worker : workers) worker.join();
  for (const std::string& text : there) EXPECT_EQ(text, here);
}

}  // namespace
}  // namespace radcert
