// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/plane_element.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/work_limit.h"
#include "tests/closed_form/kernel_quadrature.h"
#include "tests/closed_form/plane_element_excess.h"
#include "tests/closed_form/polar_kernel_integral.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Exact = Vector<Rational>;
using Point = Vector<double>;
using Polynomial = PlanePolynomial<Rational>;
using Route = PlaneElement::Route;

Polynomial monomial(int i, int j) {
  Polynomial q(i + j);
  q(i, j) = 1;
  return q;
}

std::vector<Polynomial> monomials(int degree) {
  std::vector<Polynomial> all;
  for (int n = 0; n <= degree; ++n) {
    for (int j = 0; j <= n; ++j) all.push_back(monomial(n - j, j));
  }
  return all;
}

/// One function of that degree: s^degree, or a product.
std::vector<Polynomial> one_function(int degree, std::size_t kind) {
  if (kind == 0) return {monomial(degree, 0)};
  if (kind == 1) return {monomial(0, degree)};
  Polynomial q(degree);
  q(0, 0) = 1;
  q(degree, 0) += 1;
  q(0, degree) += 2;
  return {q};
}

Rational decimal(const char* text) { return Rational::parse(text).value(); }

PlanePolygon triangle() { return plane_polygon({Exact{0, 0, 0}, {1, 0, 0}, {Rational(1, 4), 1, 0}}).value(); }

/// Not convex, in an oblique plane, with a hole.
PlanePolygon ring() {
  const PolygonLoop outer{{0, 0}, {1, 0}, {1, 1}, {Rational(1, 2), Rational(5, 8)}, {0, 1}};
  const PolygonLoop hole{
      {Rational(1, 4), Rational(1, 4)}, {Rational(1, 2), Rational(1, 4)}, {Rational(1, 4), Rational(1, 2)}};
  return plane_polygon({Rational(1, 8), 0, 1}, {1, Rational(1, 4), 0}, {0, 1, Rational(1, 2)}, {outer, hole})
      .value();
}

/// A triangle a million times longer than wide.
PlanePolygon sliver() {
  return plane_polygon({Exact{0, 0, 0}, {1, 0, 0}, {Rational(1, 3), decimal("1e-6"), 0}}).value();
}

double largest(const PlanePolygon& polygon, const Polynomial& q) {
  double size = 0;
  for (const PolygonLoop& loop : polygon.loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto edge = loop[(k + 1) % loop.size()] - loop[k];
      for (int i = 0; i < 16; ++i) {
        const auto at = loop[k] + Rational(i, 16) * edge;
        size = std::max(size, std::abs(q.value(at.s, at.t).to_double()));
      }
    }
  }
  return size;
}

class Sweep {
public:
  explicit Sweep(double accuracy = 1e-14) : accuracy_(accuracy) {}

  /// Compares with balls: the error is at most accuracy Int |G| max |q|.
  void check(const PlanePolygon& polygon, const std::vector<Polynomial>& functions, const Point& p,
             const Point& normal) {
    const PlaneElement element(polygon, functions, accuracy_);
    check(polygon, functions, element, p, normal);
  }
  void check(const PlanePolygon& polygon, const std::vector<Polynomial>& functions,
             const PlaneElement& element, const Point& p, const Point& normal) {
    std::vector<double> values(functions.size());
    const Route route = element.integrals(p, normal, values);
    ++routes[static_cast<std::size_t>(route)];
    // Enough for degree 8 and a sliver a million diameters away.
    const BallPrecision precision(768);
    int degree = 0;
    for (const Polynomial& q : functions) degree = std::max(degree, q.degree());
    const std::vector<Ball> moments =
        point_to_polygon_moments<Ball>(exactly(p), exactly(normal), polygon, degree);
    for (std::size_t k = 0; k < functions.size(); ++k) {
      Ball exact;
      for (std::size_t n = 0; n < functions[k].coefficients().size(); ++n) {
        exact += Ball(functions[k].coefficients()[n]) * moments[n];
      }
      const double size = abs(moments[0]).upper_double() * largest(polygon, functions[k]);
      ASSERT_LE(exact.radius(), 1e-18 * size);
      const double error = abs(Ball(values[k]) - exact).upper_double();
      ASSERT_LE(error, accuracy_ * size)
          << "P = " << shortest(p.x) << " " << shortest(p.y) << " " << shortest(p.z)
          << ", n = " << shortest(normal.x) << " " << shortest(normal.y) << " " << shortest(normal.z)
          << ", function " << k << ", route " << static_cast<int>(route);
      if (size > 0) worst = std::max(worst, error / size);
    }
  }

  std::array<int, 4> routes{};
  double worst = 0;

private:
  double accuracy_;
};

void record(const Sweep& sweep) {
  ::testing::Test::RecordProperty("worst", shortest(sweep.worst));
  ::testing::Test::RecordProperty("closed_form", sweep.routes[1]);
  ::testing::Test::RecordProperty("rule", sweep.routes[2]);
  ::testing::Test::RecordProperty("ball", sweep.routes[3]);
}

Point direction(Draw& draw) {
  const double z = 2 * draw.unit() - 1;
  const double turn = 2 * std::numbers::pi * draw.unit();
  const double flat = std::sqrt(1 - z * z);
  return {flat * std::cos(turn), flat * std::sin(turn), z};
}

TEST(PlaneElement, StaysWithinItsErrorAtEveryDistance) {
  Draw draw(11);
  Sweep sweep;
  for (const PlanePolygon& polygon : {triangle(), ring()}) {
    for (const int degree : {0, 1, 2}) {
      const std::vector<Polynomial> functions = monomials(degree);
      const PlaneElement element(polygon, functions);
      for (const double distance : {1e-9, 1e-3, 0.1, 0.5, 1.0, 2.0, 5.0, 20.0, 1e3, 1e6}) {
        for (int i = 0; i < 3; ++i) {
          Point away = direction(draw);
          if (i == 0) away.z = 1;
          const Point centre{0.5, 0.4, polygon.origin().z.to_double()};
          const Point p = centre + distance * away;
          const Point normal = i == 1 ? direction(draw) : Point{-away.x, -away.y, -1 - away.z};
          sweep.check(polygon, functions, element, p, normal);
        }
      }
    }
  }
  record(sweep);
  EXPECT_GT(sweep.routes[1], 10);
  EXPECT_GT(sweep.routes[2], 60);
}

TEST(PlaneElement, StaysWithinItsErrorUpToDegreeEight) {
  Draw draw(12);
  Sweep sweep;
  for (int degree = 3; degree <= 8; ++degree) {
    for (std::size_t kind = 0; kind < 3; ++kind) {
      const std::vector<Polynomial> functions = one_function(degree, kind);
      const PlaneElement element(triangle(), functions);
      for (const double distance : {1e-2, 0.3, 1.0, 4.0, 30.0, 1e6}) {
        Point away = direction(draw);
        away.z = distance < 1 ? 1 : away.z;
        const Point normal = distance < 1 ? Point{0, 0, -1} : -away;
        sweep.check(triangle(), functions, element, Point{0.4, 0.4, 0} + distance * away, normal);
      }
    }
  }
  record(sweep);
  EXPECT_GT(sweep.routes[1], 5);
  EXPECT_GT(sweep.routes[2], 20);
}

TEST(PlaneElement, StaysWithinItsErrorNextToEdgesCornersAndThePlane) {
  Draw draw(13);
  Sweep sweep;
  for (const int degree : {0, 1, 2, 8}) {
    const std::vector<Polynomial> functions = degree == 8 ? one_function(8, 2) : monomials(degree);
    for (const PlanePolygon& polygon : {triangle(), sliver()}) {
      const PlaneElement element(polygon, functions);
      for (const Point& p : {Point{0.5, 0, 1e-12},
                             {0.5, -1e-12, 1e-12},
                             {0.5, 1e-12, 0.5},
                             {2, 0, 0.25},
                             {2, 0, 1e-12},
                             {0, 0, 0.5},
                             {0, 0, 1e-12},
                             {1, 0, 0.001},
                             {0.5, -0.5, 1e-12},
                             {0.25, 0.25, 1e-12},
                             {0.3, 0.3, -1e-12},
                             {1e6, 1, 1e-3},
                             {-1e6, 3e5, 2e5},
                             {0.5, -1e-12, 1}}) {
        sweep.check(polygon, functions, element, p, direction(draw));
        sweep.check(polygon, functions, element, p, {0.5 - p.x, 0.2 - p.y, -p.z});
        sweep.check(polygon, functions, element, p, {0, 1, 0});
      }
    }
  }
  record(sweep);
}

// The pair of the first lines was off by 5244 radii: the height of its nodes is a part 1e-17 of their
// coordinates.
TEST(PlaneElement, StaysWithinItsErrorNextToTrianglesInAlmostOnePlane) {
  using Four = std::array<std::array<long, 3>, 4>;
  const std::vector<Four> bodies{
      {{{0, 0, 0},
        {73591740, -99815289, 78673275},
        {6575550, -8551461, -59501208},
        {78413712, -106117383, 40683702}}},
      {{{0, 0, 0}, {1000003, 7, 3}, {11, 1000033, 5}, {1000014, 1000040, 9}}},
      {{{0, 0, 0}, {134217689, 3, 134217593}, {134217649, 134217617, 7}, {268435338, 134217620, 134217601}}},
      {{{0, 0, 0}, {1L << 40, 0, 0}, {0, 1L << 40, 0}, {1L << 40, 1L << 40, 1}}},
      {{{0, 0, 0}, {1L << 50, 0, 0}, {0, 1L << 50, 0}, {1L << 50, 1L << 50, 1}}},
  };
  for (const Four& body : bodies) {
    std::array<Point, 4> c;
    for (std::size_t k = 0; k < 4; ++k)
      c[k] = {static_cast<double>(body[k][0]), static_cast<double>(body[k][1]),
              static_cast<double>(body[k][2])};
    // In thirds the centroids are doubles.
    for (const std::size_t own : {0U, 3U}) {
      const std::size_t other = 3 - own;
      const auto times_three = [&](std::size_t k) { return Rational(3) * exactly(c[k]); };
      for (const bool reversed : {false, true}) {
        const PlanePolygon polygon =
            plane_polygon({times_three(other), times_three(reversed ? 2 : 1), times_three(reversed ? 1 : 2)})
                .value();
        const Point p = c[own] + c[1] + c[2];
        const Exact normal = cross(exactly(c[1] - c[own]), exactly(c[2] - c[own]));
        const Point n{normal.x.to_double(), normal.y.to_double(), normal.z.to_double()};
        for (const double accuracy : {1e-14, 1e-12, 1e-3}) {
          const PlaneElement element(polygon, monomials(0), accuracy);
          EXPECT_LE(excess(polygon, element, accuracy, p, n), 1) << body[1][0] << " " << own;
          EXPECT_LE(excess(polygon, element, accuracy, p, -n), 1) << body[1][0] << " " << own;
        }
      }
    }
  }
}

// Heights of P down to 1e-18 of the size, over the polygon, next to its edges and beyond, in an oblique plane
// far from the origin.
TEST(PlaneElement, StaysWithinItsErrorAtEveryHeight) {
  Draw draw(17);
  double worst = 0;
  for (const double far : {0.0, 1.0, 1e6, 1e11}) {
    for (int trial = 0; trial < 60; ++trial) {
      const Point at = far * direction(draw);
      const Point a = at + direction(draw);
      const Point b = at + direction(draw);
      const Point c = at + direction(draw);
      // Not a double's corner: a quarter of the polygons is cut off at a third, one has a notch.
      PolygonLoop loop{{0, 0}, {1, 0}, {0, 1}};
      if (trial % 4 == 1)
        loop = {{0, 0}, {Rational(1, 3), 0}, {Rational(1, 3), Rational(1, 7)}, {0, Rational(1, 3)}};
      if (trial % 4 == 2) loop = {{0, 0}, {1, 0}, {Rational(1, 3), Rational(1, 3)}, {0, 1}};
      const Outcome<PlanePolygon> polygon =
          plane_polygon(exactly(a), exactly(b) - exactly(a), exactly(c) - exactly(a), {loop});
      if (!polygon) continue;
      const PlaneElement element(*polygon, monomials(0));
      const Point up = cross(b - a, c - a);
      for (int i = 0; i < 6; ++i) {
        const double height = std::pow(10.0, -18 * draw.unit());
        const std::array<double, 6> places{0.3, 0.0, 1.0, 1e-9, -1e-13, 1 + 1e-16};
        const Point p = a + places[draw.below(6)] * (b - a) + places[draw.below(6)] * (c - a) + height * up;
        const Exact offset = exactly(p) - exactly(a);
        if (dot(offset, cross(exactly(b) - exactly(a), exactly(c) - exactly(a))).sign() == 0) continue;
        for (const Point& normal :
             {-up, direction(draw), cross(b - p, c - p), up + 1e-12 * direction(draw)}) {
          if (normal == Point{0, 0, 0}) continue;
          const double found = excess(*polygon, element, 1e-14, p, normal);
          worst = std::max(worst, found);
          EXPECT_LE(found, 1) << "P = " << shortest(p.x) << " " << shortest(p.y) << " " << shortest(p.z)
                              << ", n = " << shortest(normal.x) << " " << shortest(normal.y) << " "
                              << shortest(normal.z) << ", trial " << trial << " at " << far;
        }
      }
    }
  }
  RecordProperty("worst", shortest(worst));
}

// A foot that lies inside by less than the rounding of its coordinates is not outside.
TEST(PlaneElement, FindsTheFootInsideByALittle) {
  const Point a{1.0 / 3, 1.0 / 7, 1.0 / 11};
  const Point b{-2.0 / 3, 5.0 / 7, 13.0 / 11};
  const Point c{8.0 / 3, -1.0 / 9, 2.0 / 13};
  const PlanePolygon polygon = plane_polygon({exactly(a), exactly(b), exactly(c)}).value();
  const Exact up = cross(exactly(b) - exactly(a), exactly(c) - exactly(a));
  const Exact in = cross(up, exactly(c) - exactly(b));
  Draw draw(18);
  const PlaneElement element(polygon, monomials(1), 1e-4);
  for (int trial = 0; trial < 4000; ++trial) {
    const Rational part = Rational::exactly(0.1 + 0.8 * draw.unit());
    const Rational little = power(Rational(1, 2), 56 + static_cast<long>(draw.below(6)));
    const Exact exact_p = exactly(b) + part * (exactly(c) - exactly(b)) + little * in + Rational(1, 50) * up;
    const Point p{exact_p.x.to_double(), exact_p.y.to_double(), exact_p.z.to_double()};
    ASSERT_LE(excess(polygon, element, 1e-4, p, -1.0 * cross(b - a, c - a)), 1) << trial;
  }
}

TEST(PlaneElement, RoundsIntegralsBelowTheNormalNumbers) {
  const PlaneElement element(triangle(), monomials(0));
  std::array<double, 1> value{1};
  // The triangle rises above the tangent plane by 5e-324.
  EXPECT_EQ(element.integrals({0, 0, -0.5}, {5e-324, -0.5, 0}, value), Route::ball);
  EXPECT_LE(std::abs(value[0]), 1e-320);
}

// Functions of higher degree, by the polar integral: a nearly coplanar pair, a cut polygon far from the
// origin, a low foot.
TEST(PlaneElement, AgreesWithAPolarIntegral) {
  struct Case {
    std::array<Point, 3> corners;
    Point p;
    Point normal;
  };
  const std::vector<Case> cases{
      {{Point{0, 0, 0}, {1 << 20, 3, 0}, {5, 1 << 20, 0}}, {1 << 19, 1 << 20, 1e-6}, {1, 2, -1e-10}},
      {{Point{1e9, 0, 1}, {1e9 + 1, 0.5, 1}, {1e9, 1, 2}}, {1e9 - 0.5, 0.25, 3}, {1, 0.25, -1.5}},
      {{Point{0, 0, 0}, {1, 0, 0}, {0.25, 1, 0}}, {-0.5, 0.5, 1e-9}, {1, 0.125, 0}},
      {{Point{0, 0, 0}, {1, 0, 1e-7}, {0.25, 1, 0}}, {0.5, 0.25, 0.75}, {0, 0.5, -1}},
  };
  for (const Case& one : cases) {
    const auto& c = one.corners;
    const PlanePolygon polygon = plane_polygon({exactly(c[0]), exactly(c[1]), exactly(c[2])}).value();
    const judge::Polygon judged =
        judge::triangle(triple(exactly(c[0])), triple(exactly(c[1])), triple(exactly(c[2])));
    for (const int degree : {1, 2, 5}) {
      const std::vector<Polynomial> functions = degree == 5 ? one_function(5, 2) : monomials(degree);
      const PlaneElement element(polygon, functions);
      std::vector<double> values(functions.size());
      (void)element.integrals(one.p, one.normal, values);
      const BallPrecision precision(320);
      const judge::PolarIntegral integral(judged, triple(exactly(one.p)), triple(exactly(one.normal)), degree,
                                          96);
      for (std::size_t k = 0; k < functions.size(); ++k) {
        const Polynomial& q = functions[k];
        Ball exact;
        for (int i = 0; i <= q.degree(); ++i)
          for (int j = 0; i + j <= q.degree(); ++j)
            if (q(i, j).sign() != 0) exact += Ball(q(i, j)) * integral.moment(i, j);
        const Ball allowed = Ball(1e-14) * abs(integral.moment(0, 0)) * Ball(largest(polygon, q));
        EXPECT_LE(exact.radius(), 1e-3 * allowed.lower_double());
        EXPECT_TRUE(certainly_at_most(abs(Ball(values[k]) - exact).lower(), allowed.upper()))
            << "degree " << degree << ", function " << k << ": " << values[k] << ", " << exact.to_text();
      }
    }
  }
}

/// Int G q over a triangle by a product of Gauss rules of 16 points, for P so far away that this is enough.
class FixedRule {
public:
  FixedRule() {
    constexpr int points = 16;
    for (int k = 0; k < points; ++k) {
      double x = std::cos(std::numbers::pi * (k + 0.75) / (points + 0.5));
      double slope = 1;
      for (int step = 0; step < 6; ++step) {
        double before = 1;
        double value = x;
        for (int n = 2; n <= points; ++n) {
          const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
          before = value;
          value = next;
        }
        slope = points * (x * value - before) / (x * x - 1);
        x -= value / slope;
      }
      node_.push_back((1 + x) / 2);
      weight_.push_back(1 / ((1 - x * x) * slope * slope));
    }
  }
  /// Over (0,0,0), (1,0,0), (1/4,1,0) of s^i t^j, with the parameters s = x - y/4, t = y.
  [[nodiscard]] double integral(const Point& p, const Point& normal, int i, int j) const {
    double sum = 0;
    for (std::size_t a = 0; a < node_.size(); ++a) {
      for (std::size_t b = 0; b < node_.size(); ++b) {
        const double s = node_[a] * (1 - node_[b]);
        const double t = node_[a] * node_[b];
        const Point d{s + t / 4 - p.x, t - p.y, -p.z};
        const double w = dot(d, d);
        sum +=
            weight_[a] * weight_[b] * node_[a] * (dot(d, normal) / w) * (p.z / w) * power(s, i) * power(t, j);
      }
    }
    return sum / norm(normal);
  }

private:
  std::vector<double> node_;
  std::vector<double> weight_;
};

TEST(PlaneElement, TakesTheClosedFormMoreOftenWhereLessIsAsked) {
  std::array<int, 2> closed{};
  for (const std::size_t rough : {0, 1}) {
    Draw draw(16);
    Sweep sweep(rough == 0 ? 1e-14 : 1e-12);
    for (int i = 0; i < 40; ++i) {
      const Point p{draw.unit(), draw.unit(), 0.05 + 0.4 * draw.unit()};
      sweep.check(triangle(), monomials(2), p, {0.4 - p.x, 0.4 - p.y, -p.z});
    }
    closed[rough] = sweep.routes[1];
  }
  EXPECT_GT(closed[1], closed[0] + 10);
}

TEST(PlaneElement, AgreesWithAFixedRuleOnManyConfigurations) {
  Draw draw(14);
  const PlanePolygon polygon =
      plane_polygon(Exact{0, 0, 0}, {1, 0, 0}, {Rational(1, 4), 1, 0}, {{{0, 0}, {1, 0}, {0, 1}}}).value();
  const std::array elements{PlaneElement(polygon, monomials(0)), PlaneElement(polygon, monomials(1)),
                            PlaneElement(polygon, monomials(2))};
  const FixedRule rule;
  int compared = 0;
  for (int i = 0; i < 100000; ++i) {
    const int degree = static_cast<int>(draw.below(3));
    const double distance = 2.5 / (0.02 + draw.unit());
    const Point away = direction(draw);
    const Point p = Point{0.4, 0.4, 0} + distance * away;
    // All of the triangle is in front: the angle between -away and the normal stays well below a right one.
    const Point normal = 0.4 * direction(draw) - away;
    const PlaneElement& element = elements[static_cast<std::size_t>(degree)];
    std::vector<double> values(element.function_count());
    const Route route = element.integrals(p, normal, values);
    if (route == Route::zero || route == Route::ball) continue;
    bool in_front = true;
    for (const Point& corner : {Point{0, 0, 0}, {1, 0, 0}, {0.25, 1, 0}})
      in_front = in_front && dot(corner - p, normal) > 0;
    if (!in_front) continue;
    ++compared;
    const std::size_t k = draw.below(values.size());
    static constexpr std::array<std::array<int, 2>, 6> powers{
        {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
    const double expected = rule.integral(p, normal, powers[k][0], powers[k][1]);
    const double whole = rule.integral(p, normal, 0, 0);
    ASSERT_NEAR(values[k], expected, 1e-13 * std::abs(whole))
        << shortest(p.x) << " " << shortest(p.y) << " " << shortest(p.z) << " function " << k;
  }
  EXPECT_GT(compared, 80000);
}

TEST(PlaneElement, AgreesWithQuadratureCloseBy) {
  Draw draw(15);
  const PlanePolygon polygon = ring();
  const Polynomial q = one_function(2, 2)[0];
  const PlaneElement element(polygon, {monomial(0, 0), q});
  const KernelQuadrature quadrature(polygon, q);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const Point p{draw.unit(), draw.unit(), 2 + draw.unit()};
    const Point normal{0.2 * draw.unit(), 0.2 * draw.unit(), -1};
    std::array<double, 2> values{};
    (void)element.integrals(p, normal, values);
    const KernelQuadrature::Value expected = quadrature.integral(exactly(p), exactly(normal));
    if (!expected.converged) continue;
    ++compared;
    ASSERT_NEAR(values[1], static_cast<double>(expected.signed_part),
                1e-13 * static_cast<double>(expected.absolute));
  }
  EXPECT_GT(compared, 30);
}

TEST(PlaneElement, SeesNothingBehindItAndRefusesPointsOnThePolygon) {
  const PlaneElement element(triangle(), monomials(1));
  std::vector<double> values(3, 1.0);
  EXPECT_EQ(element.integrals({0.3, 0.3, 1}, {0, 0, 1}, values), Route::zero);
  EXPECT_EQ(values, std::vector<double>(3, 0.0));
  EXPECT_EQ(element.integrals({3, 3, 0}, {-1, 0, 1}, values), Route::zero);
  EXPECT_EQ(element.integrals({0.3, 0.3, 0}, {0, 0, 2}, values), Route::zero);
  EXPECT_THROW((void)element.integrals({0.3, 0.3, 0}, {0, 0, -2}, values), ContractViolation);
  EXPECT_THROW((void)element.integrals({0.5, 0, 0}, {0, 1, 1}, values), ContractViolation);
  EXPECT_THROW((void)element.integrals({0, 0, 1}, {0, 0, 0}, values), ContractViolation);
  EXPECT_THROW((void)element.integrals({0, 0, HUGE_VAL}, {0, 0, 1}, values), ContractViolation);
  std::vector<double> few(2);
  EXPECT_THROW((void)element.integrals({0, 0, 1}, {0, 0, -1}, few), ContractViolation);
  EXPECT_THROW(PlaneElement(triangle(), {}), ContractViolation);
  EXPECT_THROW(PlaneElement(triangle(), {Polynomial(9)}), ContractViolation);
  EXPECT_THROW(PlaneElement(triangle(), {Polynomial(1)}), ContractViolation);
  EXPECT_THROW(PlaneElement(triangle(), monomials(0), 1e-15), ContractViolation);
  EXPECT_THROW(PlaneElement(triangle(), monomials(0), 0.1), ContractViolation);
}

TEST(PlaneElement, RefusesByNameWhatBallsDoNotEnclose) {
  // A normal this short leaves the closed form to balls, whose first ones have 128 bits.
  const PlaneElement element(triangle(), monomials(1));
  std::vector<double> values(3);
  const Vector<double> p{0.3, 0.3, 0.5};
  const Vector<double> normal{0, 0, -1e-70};
  EXPECT_EQ(element.integrals(p, normal, values), Route::ball);
  for (const WorkLimit* limit : work_limits())
    if (limit->name() == "closed_form/plane_element: bits of a ball") {
      const LoweredWorkLimit lowered(*limit, 127);
      EXPECT_THROW((void)element.integrals(p, normal, values), AccuracyNotReached);
    }
}

}  // namespace
}  // namespace radcert
