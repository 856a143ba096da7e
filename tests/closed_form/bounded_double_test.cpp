// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/bounded_double.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "radcert/scalar/mpfr_real.h"

namespace radcert {
namespace {

using Wide = Mpfr<100>;

/// A number with a bound, and a number within it.
struct Operand {
  BoundedDouble bounded;
  Wide exact;
};

/// Sizes from 2^-40 to 2^40, some of them whole, some zero; bounds from 0 to a part of the size, reached or
/// not.
class Operands {
public:
  explicit Operands(unsigned seed) : bits_(seed) {}
  Operand next() {
    double value = std::ldexp(fraction(), static_cast<int>(bits_() % 81) - 40);
    if (bits_() % 4 == 0) value = static_cast<double>(static_cast<long>(bits_() % 17) - 8);
    if (bits_() % 16 == 0) value = 0;
    constexpr std::array<double, 5> parts{0, 1e-18, 1e-16, 1e-10, 1e-3};
    const double error = (std::abs(value) + (bits_() % 8 == 0 ? 1e-5 : 0)) * parts[bits_() % parts.size()];
    constexpr std::array<double, 5> places{-1, -0.5, 0, 0.75, 1};
    return {{value, error}, Wide(value) + Wide(error) * Wide(places[bits_() % places.size()])};
  }

private:
  double fraction() { return std::ldexp(static_cast<double>(bits_() >> 11U), -52) - 1; }
  std::mt19937_64 bits_;
};

bool encloses(const BoundedDouble& found, const Wide& exact) {
  if (!(found.error() < std::numeric_limits<double>::infinity())) return true;
  return abs(Wide(found.value()) - exact) <= Wide(found.error());
}

struct Operation {
  std::string name;
  std::function<BoundedDouble(const BoundedDouble&, const BoundedDouble&)> bounded;
  std::function<Wide(const Wide&, const Wide&)> exact;
  bool has_a_value_everywhere = true;
};

template <class Formula>
Operation operation(const std::string& name, Formula formula, bool everywhere = true) {
  return {name, [formula](const BoundedDouble& a, const BoundedDouble& b) { return formula(a, b); },
          [formula](const Wide& a, const Wide& b) { return Wide(formula(a, b)); }, everywhere};
}

std::vector<Operation> operations() {
  return {operation("a + b", [](const auto& a, const auto& b) { return a + b; }),
          operation("a - b", [](const auto& a, const auto& b) { return a - b; }),
          operation("a * b", [](const auto& a, const auto& b) { return a * b; }),
          operation(
              "a / b", [](const auto& a, const auto& b) { return a / b; }, false),
          operation(
              "sqrt(a)", [](const auto& a, const auto&) { return sqrt(a); }, false),
          operation(
              "log(a)", [](const auto& a, const auto&) { return log(a); }, false),
          operation(
              "exp(min(max(a, -8), 8))",
              [](const auto& a, const auto&) {
                using T = std::decay_t<decltype(a)>;
                return exp(min(max(a, T(-8)), T(8)));
              },
              false),
          operation("sin(a)", [](const auto& a, const auto&) { return sin(a); }),
          operation("cos(a)", [](const auto& a, const auto&) { return cos(a); }),
          operation(
              "tan(a)", [](const auto& a, const auto&) { return tan(a); }, false),
          operation("atan(a)", [](const auto& a, const auto&) { return atan(a); }),
          operation("abs(a)", [](const auto& a, const auto&) { return abs(a); }),
          operation("min(a, b)", [](const auto& a, const auto& b) { return min(a, b); }),
          operation("max(a, b)", [](const auto& a, const auto& b) { return max(a, b); }),
          operation(
              "pow(a, 3 / 4)",
              [](const auto& a, const auto&) { return pow(a, std::decay_t<decltype(a)>(3) / 4); }, false)};
}

TEST(BoundedDouble, ContainsTheExactValue) {
  Operands random(11);
  for (const Operation& operation : operations())
    for (int trial = 0; trial < 4000; ++trial) {
      const Operand a = random.next();
      const Operand b = random.next();
      const BoundedDouble found = operation.bounded(a.bounded, b.bounded);
      const bool known = std::isfinite(found.error());
      ASSERT_TRUE(known || !operation.has_a_value_everywhere) << operation.name;
      if (!known) continue;
      ASSERT_TRUE(encloses(found, operation.exact(a.exact, b.exact)))
          << operation.name << ", a = " << a.exact.to_text(30) << " in " << a.bounded.value() << " +- "
          << a.bounded.error() << ", b = " << b.exact.to_text(30) << " in " << b.bounded.value() << " +- "
          << b.bounded.error() << ": " << found.value() << " +- " << found.error();
    }
}

TEST(BoundedDouble, IsNarrowForExactOperands) {
  Operands random(12);
  for (const Operation& operation : operations())
    for (int trial = 0; trial < 1000; ++trial) {
      const BoundedDouble a = BoundedDouble::exactly(random.next().bounded.value());
      const BoundedDouble b = BoundedDouble::exactly(random.next().bounded.value());
      const BoundedDouble found = operation.bounded(a, b);
      if (!std::isfinite(found.error())) continue;
      // A power passes on what the product in the exponent has lost, a tangent both of its parts.
      const double size = std::abs(found.value()) * (1 + std::abs(found.value()));
      EXPECT_LE(found.error(), 1e-13 * size + 1e-280)
          << operation.name << ", " << a.value() << ", " << b.value();
    }
}

TEST(BoundedDouble, CountsWhatUnderflows) {
  const BoundedDouble small = BoundedDouble::exactly(1e-200);
  const BoundedDouble large = BoundedDouble::exactly(1e200);
  EXPECT_TRUE(
      encloses((small * small) * large * large, Wide(1e-200) * Wide(1e-200) * Wide(1e200) * Wide(1e200)));
  EXPECT_TRUE(
      encloses(exp(BoundedDouble(-1000)) * large * large, exp(Wide(-1000)) * Wide(1e200) * Wide(1e200)));
  EXPECT_TRUE(encloses((small / large) * large * large, Wide(1e-200) * Wide(1e200)));
}

TEST(BoundedDouble, CountsWhatUnderflowsInItsBound) {
  // The product of the quotient and the divisor's error is no normal number, and is divided by a small one.
  const BoundedDouble tiny(1e-100, 1e-101);
  EXPECT_GE((BoundedDouble(1e-240, 0) / tiny).error(), 1e-142);
  EXPECT_GE((BoundedDouble(1e-315, 0) / BoundedDouble(1e-40, 1e-41)).error(), 1e-277);
  // The same to nothing at all: 1e-160 times 1e-165.
  EXPECT_GE((BoundedDouble(1e-320, 0) / BoundedDouble(1e-160, 1e-165)).error(), 0.99e-165);
  // The square root of a small number with a small error.
  EXPECT_GE(sqrt(BoundedDouble(1e-220, 1e-221)).error(), 4.9e-112);
  EXPECT_GE(BoundedDouble::rounded(5e-324).error(), 2.5e-324);
  // An angle whose squared distance from the origin is no normal number.
  const BoundedDouble angle = atan2(BoundedDouble(1e-170, 1e-180), BoundedDouble(1e-165, 0));
  EXPECT_GE(angle.error(), 1e-15);
  EXPECT_GE(atan2(BoundedDouble(1e-240, 1e-250), BoundedDouble(1e-120, 0)).error(), 1e-130);
  EXPECT_FALSE(std::isfinite(atan2(BoundedDouble(1e200, 1e190), BoundedDouble(1e200, 0)).error()));
}

TEST(BoundedDouble, ContainsTheValuesOfWideNumbers) {
  // Errors of the size of the number itself: the first order does not bound what they do.
  for (const double value : {0.5, 1.0, 2.0, 7.0})
    for (const double part : {0.1, 0.5, 0.9, 0.99}) {
      const BoundedDouble x(value, part * value);
      for (const double end : {-1.0, 1.0}) {
        const Wide at = Wide(value) + Wide(end * part * value);
        EXPECT_TRUE(encloses(exp(x), exp(at))) << value << " " << part;
        EXPECT_TRUE(encloses(log(x), log(at))) << value << " " << part;
        EXPECT_TRUE(encloses(sqrt(x), sqrt(at))) << value << " " << part;
        EXPECT_TRUE(encloses(atan(x), atan(at))) << value << " " << part;
        EXPECT_TRUE(encloses(BoundedDouble(1) / x, Wide(1) / at)) << value << " " << part;
      }
      EXPECT_TRUE(std::isfinite(log(x).error()) && std::isfinite(atan(x).error()));
    }
}

TEST(BoundedDouble, PassesErrorsOnRoundedUp) {
  // Beside a value of 0 nothing hides how the errors are added and multiplied.
  std::mt19937_64 random(13);
  const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11U), -53); };
  for (int trial = 0; trial < 300; ++trial) {
    const double first = unit();
    const double second = unit();
    const BoundedDouble sum = BoundedDouble(1, first) - BoundedDouble(1, second);
    EXPECT_GE(Wide(sum.error()), Wide(first) + Wide(second));
    const double value = unit();
    const BoundedDouble product = BoundedDouble(0, first) * BoundedDouble(value, second);
    EXPECT_GE(Wide(product.error()), Wide(first) * (Wide(value) + Wide(second)));
    EXPECT_LE(product.error(), first * (value + second) * (1 + 1e-14));
  }
}

/// The angle of (x, y) in (-pi, pi].
Wide angle_of(const Wide& y, const Wide& x) {
  const Wide half = Wide::pi() / Wide(2);
  if (abs(y) > abs(x)) return (y > Wide(0) ? half : -half) - atan(x / y);
  if (x > Wide(0)) return atan(y / x);
  return atan(y / x) + (y < Wide(0) ? -Wide::pi() : Wide::pi());
}

TEST(BoundedDouble, ContainsAnglesOfPoints) {
  std::mt19937_64 random(14);
  const auto part = [&] { return std::ldexp(static_cast<double>(random() >> 11U), -52) - 1; };
  double narrowest = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double x = part();
    const double y = part();
    const double size = std::abs(x) + std::abs(y);
    const double off_x = trial % 3 == 0 ? 0 : size * std::ldexp(1.0, -8 - static_cast<int>(random() % 40));
    const double off_y = trial % 3 == 1 ? 0 : size * std::ldexp(1.0, -8 - static_cast<int>(random() % 40));
    const BoundedDouble angle = atan2(BoundedDouble(y, off_y), BoundedDouble(x, off_x));
    if (!std::isfinite(angle.error())) {
      // The ray to the left may be met.
      EXPECT_TRUE(x - off_x <= 0 && std::abs(y) <= off_y) << x << " " << y;
      continue;
    }
    for (const double s : {-1.0, 1.0})
      for (const double t : {-1.0, 1.0}) {
        const Wide exact = angle_of(Wide(y) + Wide(s * off_y), Wide(x) + Wide(t * off_x));
        ASSERT_TRUE(encloses(angle, exact)) << y << " +- " << off_y << ", " << x << " +- " << off_x;
        narrowest = std::max(narrowest, (abs(Wide(angle.value()) - exact) / Wide(angle.error())).to_double());
      }
  }
  EXPECT_GT(narrowest, 0.8);
}

TEST(BoundedDouble, ContainsTheDilogarithm) {
  using Fine = Mpfr<50>;
  std::mt19937_64 random(15);
  const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11U), -53); };
  for (int trial = 0; trial < 400; ++trial) {
    // Near the branch point at 1, and anywhere; off by much and by little, or not at all.
    const bool near_one = trial % 2 == 0;
    const double radius = near_one ? 1 - (trial % 4 == 0 ? 0 : unit() * 1e-3) : unit();
    const double angle =
        near_one ? (2 * unit() - 1) * std::ldexp(1.0, -static_cast<int>(random() % 20)) : 6 * unit() - 3;
    const double off_radius =
        trial % 3 == 0 || trial % 5 == 0 ? 0 : std::ldexp(1.0, -4 - static_cast<int>(random() % 40));
    const double off_angle =
        trial % 3 == 1 || trial % 5 == 0 ? 0 : std::ldexp(1.0, -4 - static_cast<int>(random() % 40));
    const BoundedDouble found =
        dilogarithm_imaginary(BoundedDouble(radius, off_radius), BoundedDouble(angle, off_angle));
    for (const double s : {-1.0, 0.0, 1.0})
      for (const double t : {-1.0, 0.0, 1.0}) {
        const Fine of_radius = Fine(radius) + Fine(s * off_radius);
        if (of_radius < Fine(0) || of_radius > Fine(1)) continue;
        const Fine exact = dilogarithm_imaginary(of_radius, Fine(angle) + Fine(t * off_angle));
        ASSERT_LE(abs(Fine(found.value()) - exact), Fine(found.error()))
            << radius << " +- " << off_radius << ", " << angle << " +- " << off_angle;
      }
  }
}

TEST(BoundedDouble, SaysNothingOfAnAngleAcrossTheCut) {
  // Points on either side of the ray to the left, and on it, whose angles are pi and -pi.
  for (const double y : {-1e-12, 0.0, 1e-12})
    for (const double off : {1e-12, 1e-6})
      EXPECT_FALSE(std::isfinite(atan2(BoundedDouble(y, off), BoundedDouble(-1)).error())) << y << " " << off;
  EXPECT_TRUE(std::isfinite(atan2(BoundedDouble(1e-12, 0.99e-12), BoundedDouble(-1)).error()));
}

TEST(BoundedDouble, IsNotSmallerThanItsSmallestSize) {
  const BoundedDouble x(1, 0x1p-54);
  EXPECT_LE(Wide(x.smallest_size()), Wide(1) - Wide(0x1p-54));
}

TEST(BoundedDouble, SaysNothingOutsideTheDomain) {
  const BoundedDouble about_zero(0, 1e-300);
  for (const BoundedDouble& x : {BoundedDouble(1) / about_zero, sqrt(BoundedDouble(-1)), sqrt(about_zero),
                                 log(about_zero), pow(BoundedDouble(-2), BoundedDouble(1) / 3)}) {
    EXPECT_FALSE(std::isfinite(x.error()));
    // It stays so.
    EXPECT_FALSE(std::isfinite((0 * x).error()));
    EXPECT_FALSE(std::isfinite(min(x, BoundedDouble(1)).error()));
    EXPECT_FALSE(std::isfinite(max(BoundedDouble(1), x * 0).error()));
    EXPECT_FALSE(std::isfinite(abs(x + 1).error()));
  }
}

TEST(BoundedDouble, TakesRationalNumbers) {
  EXPECT_EQ(from_rational<BoundedDouble>(Rational(3, 4)).error(), 0);
  EXPECT_EQ(from_rational<BoundedDouble>(Rational(-7)).value(), -7);
  const BoundedDouble third = from_rational<BoundedDouble>(Rational(1, 3));
  EXPECT_TRUE(encloses(third, Wide(1) / Wide(3)));
  EXPECT_TRUE(encloses(pi<BoundedDouble>(), Wide::pi()));
  EXPECT_TRUE(encloses(from_rational<BoundedDouble>(Rational((1L << 60) + 1)), Wide((1L << 60) + 1)));
}

}  // namespace
}  // namespace radcert
