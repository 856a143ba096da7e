// SPDX-License-Identifier: GPL-3.0-or-later
// One formula, several arithmetics: what is written once agrees in all of them, and the ball contains it.
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "radcert/expression/parse.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert {
namespace {

double in_double(double x) { return x; }
double in_double(long double x) { return static_cast<double>(x); }
double in_double(const Ball& x) { return x.to_double(); }
template <int Digits>
double in_double(const Mpfr<Digits>& x) {
  return x.to_double();
}

template <class R>
void append(std::vector<R>& numbers, const Vector<R>& v) {
  numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

/// Frames, a chord and both kernels of a chart's formula.
template <class R, class Formula>
void append_chart(std::vector<R>& numbers, const Formula& formula) {
  const ChartOf<R, Formula> chart(formula, Orientation::against_the_cross_product);
  const ParameterPoint<R> p{R(1) / R(5), R(1) / R(3)};
  const ParameterPoint<R> w{R(1) / R(7), R(1) / R(9)};
  const Frame<R> at_p = chart.frame(p);
  const Frame<R> at_q = chart.frame(p + w);
  append(numbers, at_p.point);
  append(numbers, at_p.tangent_s);
  append(numbers, at_p.tangent_t);
  append(numbers, unit_normal(at_p));
  const Chord<R> chord = chart.chord(p, w);
  append(numbers, chord.difference);
  append(numbers, chord.bend_p);
  append(numbers, chord.bend_q);
  numbers.push_back(chord_kernel(chord, unit_normal(at_p), at_q.area_normal));
  numbers.push_back(geometric_kernel(at_p.point, unit_normal(at_p), at_q.point, at_q.area_normal));
}

/// Every formula that is a template in a header, at some point.
template <class R>
std::vector<R> numbers() {
  std::vector<R> numbers;
  for (const Rational& exponent : {Rational(2), Rational(7, 3), Rational(3, 2)})
    append_chart<R>(numbers, PowerRoof<R>(exponent));
  append_chart<R>(numbers, EllipsoidOctant<R>(1, 2, Rational(1, 3), Octant{1, -1, 1}));
  append_chart<R>(numbers, Rectangle<R>({0, 0, 0}, {1, 0, Rational(1, 3)}, {0, 1, 0}));

  const InsetBasis<R> basis(3, from_rational<R>(Rational(1, 10)));
  for (const Barycentric<R>& node : basis.nodes())
    numbers.insert(numbers.end(), node.x.begin(), node.x.end());
  std::vector<R> functions(basis.size());
  basis.values({{R(1) / R(2), R(1) / R(3), R(1) / R(6)}}, std::span<R>(functions));
  numbers.insert(numbers.end(), functions.begin(), functions.end());

  for (const char* text : {"1/sqrt(x^2 + y^2 + (z-1/2)^2)", "exp(-x^2/2) * sin(pi*y) + cos(z)^3",
                           "log(1+x) - atan(y/z) + tan(x*y)", "abs(x - y) + min(x, y*z) - max(x^2, z)",
                           "x^(5/2) + y^z + 2^-3", "0.1 - 1/3 + pi"}) {
    const Expression e = parse_expression(text, ExpressionVariables::space).value();
    const Variables<R> at{R(1) / R(3), R(2) / R(3), R(3) / R(2)};
    numbers.push_back(e.template evaluate<R>(at));
    const Variables<Dual<R>> dual{{at.x, R(1), R(0)}, {at.y, R(0), R(1)}, Dual<R>(at.z)};
    const Dual<R> differentiated = e.template evaluate<Dual<R>>(dual);
    numbers.insert(numbers.end(), {differentiated.value, differentiated.by_s, differentiated.by_t});
  }
  return numbers;
}

const std::vector<Mpfr<200>>& reference() {
  static const std::vector<Mpfr<200>> values = numbers<Mpfr<200>>();
  return values;
}

template <class R>
void expect_near_the_reference(double relative) {
  const std::vector<R> values = numbers<R>();
  ASSERT_EQ(values.size(), reference().size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double truth = reference()[i].to_double();
    EXPECT_NEAR(in_double(values[i]), truth, relative * (1 + std::abs(truth))) << i;
  }
}

TEST(Arithmetics, AgreeOnEveryFormula) {
  expect_near_the_reference<double>(1e-13);
  expect_near_the_reference<long double>(1e-15);
  expect_near_the_reference<Mpfr<50>>(1e-15);
  expect_near_the_reference<Ball>(1e-15);
}

template <int Digits>
void expect_digits(int lost) {
  const std::vector<Mpfr<Digits>> values = numbers<Mpfr<Digits>>();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Mpfr<200> difference = Mpfr<200>(values[i].to_rational()) - reference()[i];
    EXPECT_LE(abs(difference), power(Mpfr<200>(10), lost - Digits) * (1 + abs(reference()[i]))) << i;
  }
}

TEST(Arithmetics, OfMoreDigitsHaveThem) {
  expect_digits<50>(3);
  expect_digits<100>(3);
}

TEST(Arithmetics, OfBallsEncloseTheValue) {
  for (const long bits : {64L, 128L, 400L}) {
    const BallPrecision precision(bits);
    const std::vector<Ball> balls = numbers<Ball>();
    ASSERT_EQ(balls.size(), reference().size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
      ASSERT_TRUE(balls[i].is_finite()) << i << " " << balls[i].failure();
      const BallPrecision exactly(1000);
      const Ball truth = widened(Ball(reference()[i].to_rational()), power(Ball(10), -195));
      EXPECT_TRUE(overlaps(balls[i], truth))
          << i << " at " << bits << " bits: " << balls[i].to_text(50) << " " << reference()[i].to_text(50);
      const Ball narrow = power(Ball(2), 20 - bits) * (1 + abs(truth));
      EXPECT_TRUE(certainly_at_most(balls[i].radius_ball(), narrow)) << i << " " << balls[i].to_text(50);
    }
  }
}

}  // namespace
}  // namespace radcert
