// SPDX-License-Identifier: GPL-3.0-or-later
// Kernel, charts, basis, rules and expressions in double, pack, fifty digits and balls. RADCERT_LAWS=N
// multiplies the random inputs: N = 1 makes about a million containment checks, N = 100 a hundred million.
#include "arithmetic_laws.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <tuple>

#include "radcert/expression/expression.h"
#include "radcert/expression/parse.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/surface/catalogue/cone.h"
#include "radcert/surface/catalogue/disk.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/spherical_cap.h"
#include "radcert/surface/catalogue/torus.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "tests/repeats.h"

namespace radcert {
namespace {

/// Exact random inputs, the same with every standard library.
class Inputs {
public:
  explicit Inputs(std::uint64_t seed) : bits_(seed) {}

  /// A number of [0, 1], often an end or close to one.
  Rational unit() {
    const std::uint64_t kind = bits_() % 8;
    if (kind == 0) return 0;
    if (kind == 1) return 1;
    const Rational x = Rational(static_cast<long>(bits_() % 1000003)) / Rational(1000003);
    if (kind == 2) return x * small();
    if (kind == 3) return Rational(1) - x * small();
    return x;
  }
  /// 10^-k, k up to 12.
  Rational small() { return Rational(1) / power(Rational(10), static_cast<long>(bits_() % 13)); }
  /// A length from 10^-9 to 10^9, of either sign.
  Rational length() {
    const Rational x = Rational(static_cast<long>(1 + bits_() % 999983)) / Rational(999983);
    const Rational scaled =
        bits_() % 2 == 0 ? x : x * power(Rational(10), static_cast<long>(bits_() % 19) - 9);
    return bits_() % 2 == 0 ? scaled : -scaled;
  }

private:
  std::mt19937_64 bits_;
};

/// Says how much has been checked. A running error without a bound is rare: at most one in `exception`.
void report(const laws::Checks& checks, std::size_t exception) {
  std::cout << checks.containments << " containment checks; without a bound " << checks.unbounded_doubles
            << " doubles, " << checks.unbounded_fifty_digits << " of fifty digits\n";
  EXPECT_LE(checks.unbounded_doubles * exception, checks.containments);
  EXPECT_LE(checks.unbounded_fifty_digits * exception, checks.containments);
}

struct Kernel {
  template <class R>
  std::vector<R> operator()(std::span<const R> x) const {
    return {geometric_kernel<R>({x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]},
                                {x[9], x[10], x[11]})};
  }
};

TEST(ArithmeticLaws, HoldForTheKernel) {
  Inputs inputs(1);
  laws::Checks checks;
  for (std::size_t draw = 0; draw < test::repeats(60000); ++draw) {
    std::vector<Rational> x;
    for (int i = 0; i < 12; ++i) x.push_back(inputs.length());
    if (draw % 2 == 0)  // P near Q
      for (std::size_t i = 0; i < 3; ++i) x[i + 6] = x[i] + x[i] * inputs.small() / Rational(7);
    ASSERT_TRUE(laws::holds_in_every_arithmetic(Kernel(), x, checks));
  }
  report(checks, 1000);
}

/// Frame and chord of a chart's formula, and G by the chord.
template <template <class> class Formula, class... Parameters>
class ChartValues {
public:
  explicit ChartValues(Parameters... parameters) : parameters_(parameters...) {}

  template <class R>
  std::vector<R> operator()(std::span<const R> x) const {
    const ChartOf<R, Formula<R>> chart(
        std::apply([](const auto&... p) { return Formula<R>(p...); }, parameters_),
        Orientation::along_the_cross_product);
    const Frame<R> f = chart.frame({x[0], x[1]});
    const Chord<R> c = chart.chord({x[0], x[1]}, {x[2], x[3]});
    std::vector<R> values;
    for (const Vector<R>& v :
         {f.point, f.tangent_s, f.tangent_t, f.area_normal, c.difference, c.bend_p, c.bend_q})
      values.insert(values.end(), {v.x, v.y, v.z});
    values.push_back(chord_kernel(c, f.area_normal, chart.frame({x[0] + x[2], x[1] + x[3]}).area_normal));
    return values;
  }

private:
  std::tuple<Parameters...> parameters_;
};

/// Two different points of the unit triangle, often on its border or close to each other.
std::vector<Rational> two_parameter_points(Inputs& inputs, std::size_t draw) {
  const auto point = [&inputs] {
    const Rational s = inputs.unit();
    return std::pair{s, inputs.unit() * (Rational(1) - s)};
  };
  const auto [ps, pt] = point();
  auto [qs, qt] = point();
  while (qs == ps && qt == pt) std::tie(qs, qt) = point();
  const Rational step = draw % 2 == 0 ? inputs.small() : Rational(1);
  return {ps, pt, step * (qs - ps), step * (qt - pt)};
}

template <class Chart>
void expect_of_chart(const Chart& chart, std::uint64_t seed, std::size_t draws,
                     std::size_t exception = 1000) {
  Inputs inputs(seed);
  laws::Checks checks;
  for (std::size_t draw = 0; draw < test::repeats(draws); ++draw)
    ASSERT_TRUE(laws::holds_in_every_arithmetic(chart, two_parameter_points(inputs, draw), checks));
  report(checks, exception);
}

TEST(ArithmeticLaws, HoldForTheRectangle) {
  const Vector<Rational> origin{Rational(1, 3), 0, Rational(-2, 7)};
  expect_of_chart(ChartValues<Rectangle, Vector<Rational>, Vector<Rational>, Vector<Rational>>(
                      origin, {1, Rational(1, 10), 0}, {0, Rational(3, 7), 1000000}),
                  2, 12000);
}

TEST(ArithmeticLaws, HoldForRoofsOfWholePowers) {
  for (const int p : {2, 3, 7}) expect_of_chart(ChartValues<PowerRoof, Rational>(p), 3, 4000);
}

TEST(ArithmeticLaws, HoldForRoofsOfOtherPowers) {
  for (const Rational& p : {Rational(3, 2), Rational(11, 10), Rational(7, 2)})
    // Where q is on s = 0 its rounded s may be negative: about one in a hundred outputs.
    expect_of_chart(ChartValues<PowerRoof, Rational>(p), 8, 1000, 50);
}

/// Numbers and fractions in a text.
std::vector<Rational> numbers(const std::string& text) {
  std::istringstream in(text);
  std::vector<Rational> values;
  for (std::string number; in >> number;) values.push_back(Rational::parse(number).value());
  return values;
}

/// The ball's midpoint is exact after an operation, so that its radius at 53 or 168 bits is less than what
/// the double or the fifty digits lose there.
TEST(ArithmeticLaws, HoldForRoofsWhereABallRoundsNothing) {
  laws::Checks checks;
  for (const char* inputs : {"624940356/625001875 53382127946/625003750005625 -10032991/390626171875000 "
                             "59566868645179/6250037500056250000000",
                             "369961/1000003 0 196039/1000003 207758538109/1000006000009"})
    for (const Rational& p : {Rational(3, 2), Rational(11, 10), Rational(7, 2), Rational(3)})
      EXPECT_TRUE(
          laws::holds_in_every_arithmetic(ChartValues<PowerRoof, Rational>(p), numbers(inputs), checks))
          << p.to_text();
  report(checks, 1000);
}

TEST(ArithmeticLaws, HoldForEllipsoids) {
  expect_of_chart(
      ChartValues<EllipsoidOctant, Rational, Rational, Rational, Octant>(1, 1, 1, Octant{1, -1, 1}), 4, 6000);
  expect_of_chart(ChartValues<EllipsoidOctant, Rational, Rational, Rational, Octant>(Rational(1, 1000), 2,
                                                                                     500, Octant{-1, 1, 1}),
                  5, 6000);
}

TEST(ArithmeticLaws, HoldForDisksMantlesCapsAndTori) {
  const Quadrant quadrant{-1, 1};
  expect_of_chart(ChartValues<DiskQuadrant, Rational, Rational, Quadrant>(Rational(3, 7), 2, quadrant), 9,
                  800);
  expect_of_chart(
      ChartValues<ConeMantle, Rational, Rational, Rational, Quadrant>(2, Rational(1, 3), 5, quadrant), 10,
      800);
  expect_of_chart(ChartValues<ParaboloidQuadrant, Quadrant>(quadrant), 11, 800);
  expect_of_chart(ChartValues<SphericalCapQuadrant, Rational, Quadrant>(Rational(9, 10), quadrant), 12, 800);
  expect_of_chart(
      ChartValues<TorusPatch, Rational, Rational, Quadrant, Quadrant>(3, Rational(1, 4), quadrant, {1, -1}),
      13, 800);
}

/// All basis functions of a degree; the inset is the last input.
struct Basis {
  int degree;

  template <class R>
  std::vector<R> operator()(std::span<const R> x) const {
    const Barycentric<R> at{{x[0], x[1], R(1) - x[0] - x[1]}};
    std::vector<R> values(InsetBasis<Rational>(degree, 0).size());
    if constexpr (std::is_same_v<R, Pack>)  // a basis in double is evaluated in packs
      InsetBasis<double>(degree, x[2].lane(0)).values(at, std::span<R>(values));
    else
      InsetBasis<R>(degree, x[2]).values(at, std::span<R>(values));
    return values;
  }
};

TEST(ArithmeticLaws, HoldForTheBasis) {
  Inputs inputs(6);
  laws::Checks checks;
  for (int degree = 1; degree <= 8; ++degree)
    for (std::size_t draw = 0; draw < test::repeats(1000); ++draw) {
      const Rational s = inputs.unit();
      const Rational alpha = draw % 3 == 0
                                 ? inputs.unit() * inputs.small() / Rational(4)
                                 : Rational(1, 3) - inputs.unit() / Rational(3) - Rational(1, 100000);
      const std::vector<Rational> x{s, inputs.unit() * (Rational(1) - s), std::max(alpha, Rational(0))};
      ASSERT_TRUE(laws::holds_in_every_arithmetic(Basis{degree}, x, checks)) << degree;
    }
  report(checks, 1000);
}

/// The numbers of a rule that carry a relative error, and those with an absolute one.
template <class R>
struct RuleNumbers {
  std::vector<R> relative;
  std::vector<R> absolute;
};
template <class R>
RuleNumbers<R> numbers_of(const IntervalRule<R>& rule) {
  RuleNumbers<R> numbers{.relative = rule.nodes, .absolute = {}};
  numbers.relative.insert(numbers.relative.end(), rule.weights.begin(), rule.weights.end());
  return numbers;
}
template <class R>
RuleNumbers<R> numbers_of(const TriangleRule<R>& rule) {
  RuleNumbers<R> numbers{.relative = rule.weights, .absolute = {}};
  for (const Barycentric<R>& point : rule.points)
    numbers.absolute.insert(numbers.absolute.end(), point.x.begin(), point.x.end());
  return numbers;
}

/// So many units in the last place.
struct Units {
  double of_doubles;
  double of_fifty_digits;
};

/// The ball contains the truth and is narrow; the rounded numbers are within so many units of it.
::testing::AssertionResult is_enclosed(const Ball& truth, const Ball& ball, double in_double,
                                       const Mpfr<50>& in_fifty, const Units& units, double size) {
  const BallPrecision exactly(700);
  const auto fails = [&](const char* law) {
    return ::testing::AssertionFailure() << law << ": " << truth.to_text(60) << " in " << ball.to_text(60);
  };
  if (!truth.is_finite()) return fails("no value");
  if (!ball.contains(truth)) return fails("the ball contains the value");
  if (!(ball.radius() <= 0x1p-120 * size)) return fails("the ball is narrow");
  if (!(abs(Ball(in_double) - truth).upper_double() <= units.of_doubles * 0x1p-52 * size))
    return fails("the double is within its error");
  const double fifty = units.of_fifty_digits * std::ldexp(1.0, 1 - Mpfr<50>::bits) * size;
  if (!(abs(Ball(in_fifty.to_rational()) - truth).upper_double() <= fifty))
    return fails("fifty digits are right");
  return ::testing::AssertionSuccess();
}

template <class Rule>
void expect_of_rule(const Rule& rule, const Units& relative, const Units& absolute, laws::Checks& checks) {
  const auto balls_at = [&rule](long bits) {
    const BallPrecision precision(bits);
    return numbers_of(rule.template operator()<Ball>());
  };
  const RuleNumbers<Ball> truth = balls_at(700);
  const RuleNumbers<Ball> balls = balls_at(128);
  const RuleNumbers<double> doubles = numbers_of(rule.template operator()<double>());
  const RuleNumbers<Mpfr<50>> fifty = numbers_of(rule.template operator()<Mpfr<50>>());
  for (std::size_t k = 0; k < truth.relative.size(); ++k)
    ASSERT_TRUE(is_enclosed(truth.relative[k], balls.relative[k], doubles.relative[k], fifty.relative[k],
                            relative, std::abs(truth.relative[k].to_double())))
        << k;
  for (std::size_t k = 0; k < truth.absolute.size(); ++k)
    ASSERT_TRUE(is_enclosed(truth.absolute[k], balls.absolute[k], doubles.absolute[k], fifty.absolute[k],
                            absolute, 1))
        << k;
  checks.containments += truth.relative.size() + truth.absolute.size();
}

TEST(ArithmeticLaws, HoldForTheGaussRules) {
  laws::Checks checks;
  for (const IntervalWeight weight : {IntervalWeight::one, IntervalWeight::variable})
    for (const int points : {1, 2, 3, 4, 5, 7, 8, 13, 20, 31, 48, 64})
      expect_of_rule([points, weight]<class R>() { return gauss_rule<R>(points, weight); },
                     {.of_doubles = 1, .of_fifty_digits = 4.0 * points * points}, {}, checks);
  std::cout << checks.containments << " containment checks\n";
}

TEST(ArithmeticLaws, HoldForTheConicalRules) {
  laws::Checks checks;
  for (const int order : {1, 2, 3, 5, 8, 12})
    for (const Grading grading : {Grading::none, Grading::apex, Grading::base}) {
      const double points = std::max(8, 2 * order);
      expect_of_rule([order, grading]<class R>() { return conical_rule<R>(order, grading); },
                     {.of_doubles = 24, .of_fifty_digits = 8 * 4 * points * points + 24},
                     {.of_doubles = 2, .of_fifty_digits = 24}, checks);
    }
  std::cout << checks.containments << " containment checks\n";
}

TEST(ArithmeticLaws, EncloseRulesThatAreExact) {
  // Int_0^1 x^k w = 1/(k + 1 + b): the balls' sum contains it up to the degree of precision, and not one
  // degree further.
  for (const int points : {1, 2, 5, 11, 24})
    for (const int b : {0, 1}) {
      const IntervalRule<Ball> rule =
          gauss_rule<Ball>(points, b == 0 ? IntervalWeight::one : IntervalWeight::variable);
      for (int k = 0; k <= 2 * points; ++k) {
        Ball sum;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * power(rule.nodes[i], k);
        EXPECT_EQ(sum.contains(Rational(1, k + 1 + b)), k < 2 * points) << points << " points, x^" << k;
      }
    }
}

struct Evaluation {
  const Expression* expression;

  template <class R>
  std::vector<R> operator()(std::span<const R> x) const {
    return {expression->evaluate<R>(Variables<R>{x[0], x[1], x[2]})};
  }
};

TEST(ArithmeticLaws, HoldForExpressions) {
  Inputs inputs(7);
  laws::Checks checks;
  for (const char* text : {"1/sqrt(x^2 + y^2 + (z-1/2)^2 + 1e-6)", "x^2 + y^2 + z^2",
                           "exp(-x^2) * sin(3*y) - cos(z)", "log(1 + x^2 + y^2) * atan(z)",
                           "x^3 - 2*x*y + 0.1*z", "min(x, y) + max(y, z) - abs(x - z)", "tan(x/4)^2"}) {
    const Expression expression = parse_expression(text).value();
    for (std::size_t draw = 0; draw < test::repeats(5000); ++draw) {
      const std::vector<Rational> x{inputs.unit(), inputs.unit(), inputs.unit()};
      ASSERT_TRUE(laws::holds_in_every_arithmetic(Evaluation{&expression}, x, checks)) << text;
    }
  }
  report(checks, 1000);
}

TEST(ArithmeticLaws, HoldForAnExpressionWhereABallRoundsNothing) {
  laws::Checks checks;
  const Expression expression = parse_expression("x^2 + y^2 + z^2").value();
  EXPECT_TRUE(
      laws::holds_in_every_arithmetic(Evaluation{&expression}, numbers("509360/1000003 1 1"), checks));
  report(checks, 1000);
}

}  // namespace
}  // namespace radcert
