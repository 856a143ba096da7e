// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/certified_chart_entries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/collocation/certified/certified_operator.h"
#include "radcert/collocation/certified/lagrange_on_elements.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/quadrature/certified/certified_kernel_sums.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/spherical_cap.h"
#include "radcert/surface/catalogue/torus.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/triangulation/interpolated_surface.h"
#include "tests/collocation/certified_samples.h"
#include "tests/quadrature/one_and_coordinate.h"

namespace radcert {
namespace {

constexpr double demand = 1e-11;

/// The same as densities on one element.
std::array<DensityFormula, 2> densities(const ParameterTriangle& element) {
  std::array<ParameterPoint<Rational>, 3> v;
  for (std::size_t i = 0; i < 3; ++i)
    v[i] = {Rational::exactly(element.vertices[i].s), Rational::exactly(element.vertices[i].t)};
  const ParameterPoint<Rational> side = v[2] - v[0];
  const Rational area = cross(v[1] - v[0], side);
  // x_2 = (at - v_1) x (v_3 - v_1) / ((v_2 - v_1) x (v_3 - v_1))
  const Rational by_s = side.t / area;
  const Rational by_t = -side.s / area;
  const Rational constant = -(by_s * v[0].s + by_t * v[0].t);
  return {unit_density(), density([=]<Real R>(const DensityPoint<R>& q) {
            return from_rational<R>(constant) + from_rational<R>(by_s) * q.at.s +
                   from_rational<R>(by_t) * q.at.t;
          })};
}

ParameterPolygon polygon_of(const ParameterTriangle& element) {
  ParameterPolygon polygon;
  for (const ParameterPoint<double>& v : element.vertices)
    polygon.push_back({Rational::exactly(v.s), Rational::exactly(v.t)});
  return polygon;
}

struct Enclosures {
  std::vector<double> values;
  std::vector<double> radius;
};

Enclosures sums_over(const Surface& surface, const ParameterTriangle& element,
                     const std::vector<SurfacePoint<Rational>>& points, double demanded = demand) {
  const sample::OneAndCoordinate functions;
  const Triangulation triangulation{{element}};
  const CertifiedKernelSums sums(surface, triangulation, functions, points, demanded);
  Enclosures found{std::vector<double>(2 * points.size()), std::vector<double>(2 * points.size())};
  const Outcome<void> outcome = sums.element(0, found.values, found.radius);
  EXPECT_TRUE(outcome.has_value()) << (outcome ? "" : outcome.reason());
  return found;
}

bool encloses(double value, double radius, const Ball& exact) {
  return overlaps(widened(Ball(value), Ball(radius)), exact);
}

/// Random numbers of the unit interval with few digits, often at its ends and near to a given one.
class Fractions {
public:
  explicit Fractions(unsigned seed) : bits_(seed) {}
  Rational next(long denominator) {
    return {static_cast<long>(bits_() % static_cast<unsigned long>(denominator + 1)), denominator};
  }
  ParameterPoint<Rational> in_square() { return {next(96), next(96)}; }
  ParameterPoint<Rational> in_triangle() {
    ParameterPoint<Rational> p = in_square();
    if (p.s + p.t > 1) p = {1 - p.s, 1 - p.t};
    return p;
  }

private:
  std::mt19937_64 bits_;
};

struct Case {
  const char* name;
  Surface surface;
  ParameterTriangle element;
  std::vector<SurfacePoint<Rational>> points;  ///< in the element, beside it, far away
};

Rational q(long n, long d) { return {n, d}; }

std::vector<Case> cases() {
  const ParameterTriangle small{1, {{{0.25, 0.25}, {0.5, 0.25}, {0.5, 0.5}}}};
  const std::vector<SurfacePoint<Rational>> roof{
      {1, {q(5, 12), q(1, 3)}}, {1, {q(13, 24), q(3, 8)}}, {1, {q(1, 2), q(1, 4)}}, {0, {q(1, 3), q(1, 3)}}};
  const ParameterTriangle part{0, {{{0.25, 0.25}, {0.5, 0.25}, {0.25, 0.5}}}};
  const std::vector<SurfacePoint<Rational>> octants{
      {0, {q(1, 3), q(1, 3)}}, {0, {q(5, 24), q(1, 3)}}, {7, {q(1, 3), q(1, 3)}}};
  const ParameterTriangle cap{4, {{{0.25, 0.5}, {0.5, 0.5}, {0.25, 0.75}}}};
  const ParameterTriangle mantle{8, {{{0.0, 0.0}, {0.25, 0.0}, {0.25, 0.25}}}};
  return {
      {"two_piece 2", two_piece(2), small, roof},
      {"two_piece 3", two_piece(3), small, roof},
      {"two_piece 2, floor", two_piece(2), {0, small.vertices}, {{1, {q(1, 3), q(1, 3)}}}},
      {"ellipsoid", ellipsoid(1, 2, 3), part, octants},
      {"sphere", sphere(), part, octants},
      {"paraboloid_cap",
       paraboloid_cap(),
       cap,
       {{4, {q(1, 3), q(13, 24)}},
        {4, {q(1, 3), q(11, 24)}},
        {0, {q(5, 12), q(1, 2)}},
        {6, {q(1, 6), q(1, 6)}}}},
      {"cylinder",
       cylinder(1, 2),
       mantle,
       {{8, {q(1, 6), q(1, 12)}},
        {8, {q(1, 3), q(1, 6)}},
        {0, {q(3, 4), q(1, 8)}},
        {10, {q(1, 2), q(1, 2)}}}},
  };
}

TEST(CertifiedKernelSums, ContainTheKernelIntegrals) {
  for (const Case& c : cases()) {
    const Enclosures found = sums_over(c.surface, c.element, c.points);
    const std::array<DensityFormula, 2> functions = densities(c.element);
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const std::size_t j = i % 2;
      const std::size_t place = j * c.points.size() + i;
      const BallPrecision precision(70);
      const Enclosure exact =
          kernel_integral(ExactObserver::on_surface({c.points[i]}), c.surface, c.element.chart,
                          polygon_of(c.element), functions[j], {.radius = 1e-14});
      ASSERT_TRUE(exact.has_value()) << c.name << exact.reason().to_text();
      EXPECT_TRUE(encloses(found.values[place], found.radius[place], exact->value))
          << c.name << ", point " << i << ", function " << j << ": " << found.values[place] << " +/- "
          << found.radius[place] << ", " << exact->value.to_text();
      EXPECT_LE(found.radius[place], demand / 16) << c.name << ", point " << i << ", function " << j;
    }
  }
}

/// Far from the origin the coordinates are rounded by 1e-10 of the element: the radii tell.
TEST(CertifiedKernelSums, BoundTheRoundingOfLargeCoordinates) {
  const Surface surface = cylinder(1, 1L << 20);
  const ParameterTriangle element{8, {{{0.0, 0.5}, {0.5, 0.5}, {0.0, 0.5 + 0x1p-20}}}};
  const std::vector<SurfacePoint<Rational>> points{{10, {q(1, 3), q(1, 2) + Rational(1, 3L << 20)}},
                                                   {9, {q(2, 3), q(1, 2) + Rational(2, 3L << 20)}}};
  const Enclosures found = sums_over(surface, element, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const BallPrecision precision(120);
    const Enclosure exact = kernel_integral(ExactObserver::on_surface({points[i]}), surface, 8,
                                            polygon_of(element), unit_density(), {.radius = 1e-14});
    ASSERT_TRUE(exact.has_value()) << exact.reason().to_text();
    EXPECT_TRUE(encloses(found.values[i], found.radius[i], exact->value))
        << found.values[i] << " +/- " << found.radius[i] << ", " << exact->value.to_text();
  }
}

/// Rules of low order, of which the truncation is what is seen.
TEST(CertifiedKernelSums, BoundTheTruncation) {
  const Surface surface = two_piece(2);
  const ParameterTriangle element{1, {{{0.25, 0.25}, {1.0, 0.25}, {0.5, 1.0}}}};
  // In the element, beside it, far away.
  const std::vector<SurfacePoint<Rational>> points{{1, {q(1, 2), q(1, 2)}},
                                                   {1, {q(3, 8), q(5, 16)}},
                                                   {1, {q(7, 8), q(3, 4)}},
                                                   {1, {q(1, 8), q(1, 2)}},
                                                   {0, {q(1, 3), q(1, 3)}},
                                                   {0, {q(9, 10), q(1, 10)}},
                                                   {0, {1, 1}}};
  const std::array<DensityFormula, 2> functions = densities(element);
  const BallPrecision precision(70);
  std::vector<Ball> exact;
  for (const DensityFormula& function : functions)
    for (const SurfacePoint<Rational>& point : points)
      exact.push_back(kernel_integral(ExactObserver::on_surface({point}), surface, element.chart,
                                      polygon_of(element), function, {.radius = 1e-12})
                          .value()
                          .value);
  for (const double demanded : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    const Enclosures found = sums_over(surface, element, points, demanded);
    for (std::size_t place = 0; place < exact.size(); ++place)
      EXPECT_TRUE(encloses(found.values[place], found.radius[place], exact[place]))
          << "place " << place << ", demand " << demanded << ": " << found.values[place] << " +/- "
          << found.radius[place] << ", " << exact[place].to_text();
  }
}

/// 1, as far as 1/1000.
class AboutOne final : public ElementFunctions {
public:
  std::size_t size() const override { return 1; }
  void values(const ElementPoint<BoundedDouble>&, std::span<BoundedDouble> out) const override {
    out[0] = {1, 1e-3};
  }
  double bound(const ElementPoint<TaylorModel>&) const override { return 1.001; }
};

/// All functions within the bounds have their integrals within the radii, the extreme ones too: no radius may
/// be half as large.
TEST(CertifiedKernelSums, HoldForAllFunctionsWithinTheirBounds) {
  const AboutOne functions;
  for (const Case& c : cases()) {
    const Triangulation triangulation{{c.element}};
    constexpr double loose = 1e-7;
    const CertifiedKernelSums sums(c.surface, triangulation, functions, c.points, loose);
    std::vector<double> values(c.points.size());
    std::vector<double> radius(c.points.size());
    ASSERT_TRUE(sums.element(0, values, radius).has_value()) << c.name;
    const Enclosures one = sums_over(c.surface, c.element, c.points, loose);
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const double least = 1e-3 * (std::abs(one.values[i]) - one.radius[i]);
      EXPECT_GE(radius[i], least) << c.name << ", point " << i;
      EXPECT_LE(radius[i], 4 * least + loose) << c.name << ", point " << i;
    }
  }
}

/// On the sphere G is 1/4: every point has the same integrals, which take no kernel.
TEST(CertifiedKernelSums, AreAQuarterOfTheAreaOnTheSphere) {
  const Surface surface = sphere();
  const ParameterTriangle element{3, {{{0.25, 0.25}, {0.375, 0.25}, {0.25, 0.375}}}};
  Fractions random(71);
  std::vector<SurfacePoint<Rational>> points;
  for (std::size_t k = 0; k < 300; ++k) points.push_back({k % 8, random.in_triangle()});
  const Enclosures found = sums_over(surface, element, points);
  // Here hardly more than rounding is in the radii.
  const Enclosures rounding = sums_over(surface, element, points, 1e-15);
  const std::array<DensityFormula, 2> functions = densities(element);
  for (std::size_t j = 0; j < 2; ++j) {
    const BallPrecision precision(100);
    const auto integrand = [&]<Real R>(const ParameterPoint<R>& at) {
      const Frame<R> frame = surface.charts[3].in<R>().frame(at);
      const DensityPoint<R> point{3, at, frame.point};
      if constexpr (std::same_as<R, Ball>) {
        return area_element(frame) * functions[j].in_balls(point) / R(4);
      } else {
        return area_element(frame) * functions[j].in_models(point) / R(4);
      }
    };
    const Enclosure exact = integral_over_polygon(integrand, polygon_of(element), {.radius = 1e-21});
    ASSERT_TRUE(exact.has_value());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t place = j * points.size() + i;
      ASSERT_TRUE(encloses(found.values[place], found.radius[place], exact->value))
          << "chart " << points[i].chart << " (" << points[i].at.s.to_text() << ", "
          << points[i].at.t.to_text() << "), function " << j << ": " << found.values[place] << " +/- "
          << found.radius[place] << ", " << exact->value.to_text();
      ASSERT_TRUE(encloses(rounding.values[place], rounding.radius[place], exact->value))
          << rounding.values[place] << " +/- " << rounding.radius[place] << ", " << exact->value.to_text();
    }
  }
}

/// From points of the roof to an element of the floor there is a closed form.
TEST(CertifiedKernelSums, ContainTheClosedFormOfPlaneElements) {
  const Surface surface = two_piece(2);
  const ParameterTriangle element{0, {{{0.5, 0.0}, {1.0, 0.5}, {0.5, 0.5}}}};
  Fractions random(72);
  std::vector<SurfacePoint<Rational>> points;
  for (int k = 0; k < 1000; ++k) points.push_back({1, random.in_square()});
  const Enclosures found = sums_over(surface, element, points);
  const ParameterPolygon corners = polygon_of(element);
  const auto in_space = [](const ParameterPoint<Rational>& p) { return Vector<Rational>{p.s, p.t, 0}; };
  const Vector<Rational> origin = in_space(corners[0]);
  const PlanePolygon polygon = plane_polygon(origin, in_space(corners[1]) - origin,
                                             in_space(corners[2]) - origin, {{{0, 0}, {1, 0}, {0, 1}}})
                                   .value();
  const BallPrecision precision(100);
  double widest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [s, t] = points[i].at;
    // In the order of PlanePolynomial: 1, s, t.
    const std::vector<Ball> exact =
        point_to_polygon_moments<Ball>({s, t, 2 - s * s}, {-2 * s, 0, -1}, polygon, 1);
    for (std::size_t j = 0; j < 2; ++j) {
      const std::size_t place = j * points.size() + i;
      ASSERT_TRUE(encloses(found.values[place], found.radius[place], exact[j]))
          << "(" << s.to_text() << ", " << t.to_text() << "), function " << j << ": " << found.values[place]
          << " +/- " << found.radius[place] << ", " << exact[j].to_text();
      widest = std::max(widest, found.radius[place]);
    }
  }
  EXPECT_LT(widest, 1e-13);
}

// With the nodes (1/4, 3/8, 3/8) and their like l_1 = -5 x_1 + 3 x_2 + 3 x_3: the largest coefficient is a
// negative one, and l_1 is as large as the bound at a corner and nearly so on the line beyond it.
TEST(LagrangeOnElements, AreNotBeyondTheirBound) {
  std::vector<Barycentric<Rational>> nodes(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) nodes[i].x[k] = i == k ? q(1, 4) : q(3, 8);
  const LagrangeFunctions functions = lagrange_functions(nodes).value();
  const LagrangeOnElements on_elements(functions);
  for (const Rational& beyond : {Rational(0), q(1, 64), Rational(1), Rational(40)}) {
    const std::array<Rational, 3> x{1 + beyond, -beyond, 0};
    ElementPoint<TaylorModel> of_models;
    ElementPoint<BoundedDouble> of_doubles;
    for (std::size_t k = 0; k < 3; ++k) {
      of_models.in_element.x[k] = TaylorModel(x[k]);
      of_doubles.in_element.x[k] = from_rational<BoundedDouble>(x[k]);
    }
    const double largest = (5 + 8 * beyond).to_double();
    EXPECT_GE(on_elements.bound(of_models), largest);
    EXPECT_LE(on_elements.bound(of_models), (5 + 10 * beyond).to_double() * (1 + 1e-12));
    std::array<BoundedDouble, 3> values;
    on_elements.values(of_doubles, values);
    EXPECT_EQ(values[0].value(), -largest);
  }
}

TEST(CertifiedChartEntries, AreWithinTheDemandAndHoldTheReflectivity) {
  const Surface surface = two_piece(2);
  const Triangulation triangulation = triangulate(surface, 0);
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 6));
  const std::size_t n = triangulation.triangles.size() * functions.size();
  std::vector<double> reflectivity(n, 1.0);
  reflectivity[2] = 0.25;
  reflectivity[7] = 0;
  const Outcome<CertifiedEntries> found =
      certified_chart_entries(surface, triangulation, functions, reflectivity, 1e-7);
  ASSERT_TRUE(found.has_value()) << found.reason();
  const std::vector<SurfacePoint<Rational>> nodes = exact_collocation_nodes(triangulation, functions);
  const Outcome<CertifiedValues> rows =
      certified_operator(surface, triangulation, unit_density(), nodes, 1e-7);
  ASSERT_TRUE(rows.has_value()) << rows.reason();
  for (std::size_t i = 0; i < n; ++i) {
    Ball sum;
    double radius = 0;
    for (std::size_t j = 0; j < n; ++j) {
      sum += widened(Ball(found->entries(i, j)), Ball(found->radius(i, j)));
      radius += found->radius(i, j);
    }
    EXPECT_LE(radius, 1e-7 * reflectivity[i]);
    const Ball row =
        widened(Ball(rows->values[i]), Ball(rows->radius[i])) * Ball(reflectivity[i]) / Ball::pi();
    EXPECT_TRUE(overlaps(sum, row)) << "row " << i << ": " << sum.to_text() << ", " << row.to_text();
  }
  EXPECT_EQ(found->entries(7, 0), 0);
  // Within the floor G vanishes, exactly.
  EXPECT_EQ(found->entries(0, 3), 0);
  EXPECT_EQ(found->radius(0, 3), 0);
}

TEST(CertifiedChartEntries, AreRefusedWhereRoundingsAreWiderThanTheDemand) {
  const Surface surface = two_piece(2);
  const Triangulation triangulation = triangulate(surface, 0);
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 6));
  const std::size_t n = triangulation.triangles.size() * functions.size();
  int given = 0;
  int refused = 0;
  for (const double wanted : {1e-11, 1e-12, 3e-13, 1e-13, 3e-14, 1e-14}) {
    const Outcome<CertifiedEntries> found =
        certified_chart_entries(surface, triangulation, functions, std::vector<double>(n, 1.0), wanted);
    ++(found ? given : refused);
    if (!found) continue;
    for (std::size_t i = 0; i < n; ++i) {
      double radius = 0;
      for (std::size_t j = 0; j < n; ++j) radius += found->radius(i, j);
      EXPECT_LE(radius, wanted) << "row " << i;
    }
  }
  EXPECT_GE(given, 1);
  EXPECT_GE(refused, 1);
}

/// Two enclosures of the same numbers meet.
TEST(CertifiedCollocation, IsTheMatrixAndTheOperator) {
  const Surface surface = two_piece(3);
  const Triangulation triangulation = triangulate(surface, 0);
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 10));
  const std::size_t n = triangulation.triangles.size() * functions.size();
  const DensityFormula u = density([](const auto& p) { return 1 + exp(p.point.x) * p.point.z / 4; });
  constexpr double wanted = 1e-9;
  const Outcome<CertifiedCollocation> both =
      certified_collocation(surface, triangulation, functions, u, 2.5, wanted);
  ASSERT_TRUE(both.has_value()) << both.reason();
  const CertifiedEntries matrix =
      certified_chart_entries(surface, triangulation, functions, std::vector<double>(n, 1.0), wanted).value();
  const CertifiedValues integrals =
      certified_operator(surface, triangulation, u, exact_collocation_nodes(triangulation, functions),
                         10 * wanted)
          .value();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      EXPECT_LE(std::abs(both->matrix.entries(i, j) - matrix.entries(i, j)),
                both->matrix.radius(i, j) + matrix.radius(i, j))
          << i << ", " << j;
    EXPECT_LE(std::abs(both->integrals.values[i] - integrals.values[i]),
              both->integrals.radius[i] + integrals.radius[i])
        << i;
    EXPECT_LE(both->integrals.radius[i], 3.2 * 2.5 * wanted);
  }
  EXPECT_THROW(static_cast<void>(certified_collocation(surface, triangulation, functions, u, 0, wanted)),
               ContractViolation);
  // Not analytic at x = 1/3.
  const DensityFormula kink = density([]<Real R>(const DensityPoint<R>& p) {
    const R x = p.point.x - from_rational<R>(Rational(1, 3));
    return sqrt(x * x);
  });
  EXPECT_FALSE(certified_collocation(surface, triangulation, functions, kink, 1, wanted).has_value());
}

TEST(CertifiedCollocation, HasIntegralsThatScaleWithTheDensity) {
  const Surface surface = two_piece(2);
  const std::vector<ParameterTriangle> all = triangulate(surface, 0).triangles;
  const Triangulation triangulation{{all.front(), all.back()}};
  const LagrangeFunctions functions = inset_functions(0, 0);
  const auto integrals = [&](int factor) {
    const DensityFormula u = density([factor]<Real R>(const DensityPoint<R>& p) {
      return from_rational<R>(Rational(factor)) * (1 + p.point.x / 4);
    });
    return certified_collocation(surface, triangulation, functions, u, 1.25 * factor, 1e-3).value().integrals;
  };
  const CertifiedValues small = integrals(1);
  const CertifiedValues large = integrals(1024);
  for (std::size_t i = 0; i < small.values.size(); ++i) {
    EXPECT_LE(std::abs(large.values[i] - 1024 * small.values[i]), large.radius[i] + 1024 * small.radius[i]);
    EXPECT_NEAR(large.radius[i], 1024 * small.radius[i], 1024e-3 * small.radius[i]) << i;
  }
}

/// Within a closed surface the kernel sums to pi.
TEST(CertifiedOperator, SumsToPiInAClosedSurface) {
  const Surface surface = paraboloid_cap();
  const std::vector<SurfacePoint<Rational>> points{{0, {q(1, 6), q(1, 3)}}, {5, {q(1, 3), q(1, 3)}}};
  const Outcome<CertifiedValues> found =
      certified_operator(surface, triangulate(surface, 0), unit_density(), points, 1e-7);
  ASSERT_TRUE(found.has_value()) << found.reason();
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_TRUE(encloses(found->values[i], found->radius[i], Ball::pi()))
        << found->values[i] << " +/- " << found->radius[i];
}

TEST(CertifiedOperator, IsThatOfTheWholeSurfaceAndOfItsInterpolant) {
  const Surface exact = two_piece(3);
  const InterpolatedSurface interpolated = interpolate(exact, triangulate(exact, 0), 2);
  const DensityFormula u = density([](const auto& p) { return exp(p.point.x) * p.point.z; });
  const std::vector<SurfacePoint<Rational>> points{{1, {q(1, 4), q(1, 2)}}, {0, {q(1, 3), q(1, 3)}}};
  const auto agrees = [&](const Surface& surface, const Triangulation& triangulation) {
    const Outcome<CertifiedValues> found = certified_operator(surface, triangulation, u, points, 1e-10);
    ASSERT_TRUE(found.has_value()) << found.reason();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const BallPrecision precision(80);
      const Enclosure whole =
          kernel_integral(ExactObserver::on_surface({points[i]}), surface, u, {.radius = 1e-14});
      ASSERT_TRUE(whole.has_value()) << whole.reason().to_text();
      EXPECT_TRUE(encloses(found->values[i], found->radius[i], whole->value))
          << surface.name << ", point " << i << ": " << found->values[i] << " +/- " << found->radius[i]
          << ", " << whole->value.to_text();
    }
  };
  agrees(exact, triangulate(exact, 0));
  agrees(interpolated.surface, interpolated.triangulation);
}

TEST(CertifiedOperator, HasTheSameBitsForAnyNumberOfThreads) {
  const Surface surface = two_piece(2);
  const std::vector<SurfacePoint<Rational>> points{{1, {0, 1}}, {1, {q(1, 2), q(1, 2)}}, {0, {q(1, 3), 1}}};
  const auto values = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return certified_operator(surface, triangulate(surface, 1), unit_density(), points, 1e-8).value();
  };
  const CertifiedValues one = values(1);
  const CertifiedValues two = values(2);
  EXPECT_EQ(one.values, two.values);
  EXPECT_EQ(one.radius, two.radius);
}

TEST(CertifiedOperator, RefusesWithAReason) {
  // A point of a seam lies on elements of other charts.
  const Surface cap = spherical_cap(Rational(1, 4));
  const Outcome<CertifiedValues> on_seam = certified_operator(
      cap, triangulate(cap, 0), unit_density(), std::vector{SurfacePoint<Rational>{0, {q(1, 2), 0}}}, 1e-6);
  ASSERT_FALSE(on_seam.has_value());
  EXPECT_NE(on_seam.reason().find("border"), std::string::npos) << on_seam.reason();
  const Surface roof = two_piece(2);
  const std::vector<SurfacePoint<Rational>> floor{{0, {q(1, 2), q(1, 3)}}};
  const Outcome<CertifiedValues> sharper =
      certified_operator(roof, triangulate(roof, 0), unit_density(), floor, 1e-16);
  ASSERT_FALSE(sharper.has_value());
  EXPECT_NE(sharper.reason().find("demanded"), std::string::npos) << sharper.reason();
  // |x - 1/3| is not analytic.
  const DensityFormula kink = density([]<Real R>(const DensityPoint<R>& p) {
    const R x = p.point.x - from_rational<R>(Rational(1, 3));
    return sqrt(x * x);
  });
  const Outcome<CertifiedValues> not_smooth =
      certified_operator(roof, triangulate(roof, 0), kink, floor, 1e-6);
  ASSERT_FALSE(not_smooth.has_value());
}

TEST(CertifiedOperator, RequiresUnoccludedSurfacesAndPointsOfThem) {
  const Surface ring = torus(1, Rational(1, 2));
  const std::vector<SurfacePoint<Rational>> inside{{0, {q(1, 2), q(1, 2)}}};
  EXPECT_THROW(
      static_cast<void>(certified_operator(ring, triangulate(ring, 0), unit_density(), inside, 1e-6)),
      ContractViolation);
  const Surface surface = two_piece(2);
  const std::vector<SurfacePoint<Rational>> outside{{0, {q(3, 2), q(1, 2)}}};
  EXPECT_THROW(
      static_cast<void>(certified_operator(surface, triangulate(surface, 0), unit_density(), outside, 1e-6)),
      ContractViolation);
  EXPECT_THROW(
      static_cast<void>(certified_operator(surface, triangulate(surface, 0), unit_density(), inside, 0)),
      ContractViolation);
}

}  // namespace
}  // namespace radcert
