// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/density_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/expression/parse.h"
#include "radcert/reference/box_value.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/surface/default_surface.h"

namespace radcert::reference {
namespace {

std::vector<DensityCell> cells_of(const Surface& surface, const std::string& u) {
  return density_cells(surface, std::vector<Expression>(surface.chart_count(), parse_expression(u).value()));
}

/// Fewer halvings than usual.
std::unique_ptr<LoweredWorkLimit> few_halvings(long count) {
  for (const WorkLimit* limit : work_limits())
    if (limit->name() == "reference/density_cells: halvings")
      return std::make_unique<LoweredWorkLimit>(*limit, count);
  return nullptr;
}

bool holds(const Polygon& polygon, const Parameters& at) {
  for (std::size_t i = 0; i < polygon.count; ++i)
    if (cross(polygon[i + 1] - polygon[i], at - polygon[i]) < -1e-15) return false;
  return true;
}

/// Largest error of the polynomial of degree 63 through 64 Chebyshev nodes of a segment: at most (1 + Lambda)
/// times the best one's, Lambda <= 2/pi log 64 + 1 (Trefethen, Approximation Theory and Approximation
/// Practice, Theorem 15.2).
double interpolation_error(const std::function<double(double)>& g) {
  constexpr int n = 64;
  std::vector<double> x(n);
  std::vector<double> values(n);
  for (int k = 0; k < n; ++k) {
    x[k] = std::cos(std::numbers::pi * (k + 0.5) / n);
    values[k] = g(x[k]);
  }
  double largest = 0;
  for (int i = 1; i < 200; ++i) {
    const double at = -1 + i / 100.0 + 1e-4;
    double above = 0;
    double below = 0;
    for (int k = 0; k < n; ++k) {
      const double weight = (k % 2 == 0 ? 1 : -1) * std::sin(std::numbers::pi * (k + 0.5) / n) / (at - x[k]);
      above += weight * values[k];
      below += weight;
    }
    largest = std::max(largest, std::abs(above / below - g(at)));
  }
  return largest;
}

constexpr double one_and_lebesgue = 1 + 3.65;

/// On segments of its cells u is as near to a polynomial as its cells say.
void expect_deviations(const Surface& surface, const std::string& u) {
  const Expression f = parse_expression(u).value();
  std::mt19937 stream(7);
  for (const DensityCell& cell : cells_of(surface, u)) {
    const ChartIn<double>& chart = surface.charts[cell.chart].in<double>();
    const auto corner = [&] { return cell.polygon[stream() % cell.polygon.count]; };
    const Parameters from = corner();
    Parameters to = corner();
    if (from == to) to = 0.5 * (cell.polygon[0] + cell.polygon[2]);
    double size = 0;
    const double error = interpolation_error([&](double x) {
      const Vector<double> q = chart.frame(from + (1 + x) / 2 * (to - from)).point;
      EXPECT_LE(std::abs(q.x - cell.centre.x), cell.half.x + 1e-15) << u;
      EXPECT_LE(std::abs(q.y - cell.centre.y), cell.half.y + 1e-15) << u;
      EXPECT_LE(std::abs(q.z - cell.centre.z), cell.half.z + 1e-15) << u;
      const double value = f.evaluate<double>({q.x, q.y, q.z});
      size = std::max(size, std::abs(value));
      return value;
    });
    EXPECT_LE(error, one_and_lebesgue * cell.deviation + 1e-12 * size + 1e-15)
        << u << " on chart " << cell.chart << " of " << surface.name << " about (" << cell.centre.x << ", "
        << cell.centre.y << ", " << cell.centre.z << ")";
  }
}

const std::vector<std::string> sharp{"1 + exp(-1e6*((x-0.3)^2 + (y-0.4)^2 + z^2))",
                                     "abs(x - y*0.7 - 0.1)",
                                     "max(0, 0.001 - abs(x-0.3) - abs(y-0.4) - z)",
                                     "1/(1e-5 + (x-1)^2 + (y-0.2)^2)",
                                     "sqrt(z)",
                                     "cos(300*x*y)"};

TEST(DensityCells, IsOneCellAChartWhereTheDensityIsSmooth) {
  for (const std::string& u : std::vector<std::string>{"2", "exp(x/2 + y/3 - z/4)", "x^4*y",
                                                       "cos(3*x)*sin(y - z)", "1/sqrt(x^2 + y^2 + (z-6)^2)"})
    for (const Surface& surface : {cube(), two_piece(1)}) {
      const std::vector<DensityCell> cells = cells_of(surface, u);
      EXPECT_EQ(cells.size(), surface.chart_count()) << u << " on " << surface.name;
      for (const DensityCell& cell : cells) {
        EXPECT_TRUE(cell.is_whole);
        EXPECT_LE(cell.deviation, 1e-12) << u << " on " << surface.name;
      }
    }
}

TEST(DensityCells, CoversEveryChartOnce) {
  std::mt19937 stream(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto few = few_halvings(200);
  for (const Surface& surface : {cube(), ellipsoid(1, 2, 3), two_piece(1)})
    for (const std::string& u : sharp) {
      const std::vector<DensityCell> cells = cells_of(surface, u);
      for (int i = 0; i < 100; ++i) {
        const std::size_t chart = stream() % surface.chart_count();
        Parameters at{uniform(stream), uniform(stream)};
        if (surface.charts[chart].facts().domain == ChartDomain::unit_triangle && at.s + at.t > 1)
          at = {1 - at.s, 1 - at.t};
        EXPECT_EQ(std::ranges::count_if(cells,
                                        [&](const DensityCell& cell) {
                                          return cell.chart == chart && holds(cell.polygon, at);
                                        }),
                  1)
            << u << " on " << surface.name;
      }
    }
}

TEST(DensityCells, BoundsHowFarTheDensityIsFromAPolynomial) {
  for (const long halvings : {40, 150}) {
    const auto few = few_halvings(halvings);
    for (const Surface& surface : {cube(), box(Rational(3, 10), 1, 7), two_piece(1)})
      for (const std::string& u : sharp) expect_deviations(surface, u);
  }
}

TEST(DensityCells, ResolvesPeaksAndLinesAlongTheSides) {
  for (const std::string& u : std::vector<std::string>{sharp[0], sharp[2], "sqrt(z)", "abs(x - 0.3)"}) {
    double left = 0;
    for (const DensityCell& cell : cells_of(cube(), u)) left += cell.deviation * cell.area;
    EXPECT_LE(left, 1e-11) << u;
  }
}

TEST(DensityCells, BoundsWhatTaylorsPolynomialLeaves) {
  // u = 1/(c + a - x) on a side of half-length 1/2 about c: its Taylor polynomial of degree 63 about c is off
  // by (2a)^-64 / (a - 1/2) at the end. With a = 1.1 the disks of twice the radius are free of the pole.
  const auto few = few_halvings(0);
  const double a = 1.1;
  const double left = std::pow(0.5 / a, 64) / (a - 0.5);
  int seen = 0;
  for (const DensityCell& cell : cells_of(cube(), "1/(1.6 - x)")) {
    if (cell.half.x < 0.4) continue;
    EXPECT_GE(cell.deviation, left);
    EXPECT_LE(cell.deviation, 1e6 * left);
    ++seen;
  }
  EXPECT_EQ(seen, 4);
}

TEST(DensityCells, KnowWhatRoundingOfEachCoordinateDoes) {
  // A triangle of size 1 of which one coordinate is about 1000, and u that coordinate: eight roundings of it.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto vertex = [axis](double along, double first, double second) {
      std::array<double, 3> x{};
      x[axis] = 1000 + along;
      x[(axis + 1) % 3] = first;
      x[(axis + 2) % 3] = second;
      return Vector<double>{x[0], x[1], x[2]};
    };
    const TriangleMesh mesh{.vertices = {vertex(0, 0, 0), vertex(1, 0, 1), vertex(0, 1, 0)},
                            .triangles = {{0, 1, 2}},
                            .group = {0},
                            .group_names = {"one"},
                            .face = {0}};
    const std::vector<std::size_t> pieces{0};
    const std::vector<std::string> names{"one"};
    const Surface surface = mesh_surface(
        "one", mesh, pieces, names,
        {.orientation = Orientation::along_the_cross_product, .closed = false, .unoccluded = false});
    const std::string name(1, "xyz"[axis]);
    for (const std::string& u : {name + " - 1000", "exp(" + name + " - 1000)"})
      for (const DensityCell& cell : cells_of(surface, u)) {
        EXPECT_GE(cell.rounding, 8 * 0x1p-53 * 1001) << u;
        EXPECT_LE(cell.rounding, 100 * 0x1p-53 * 1001) << u;
      }
  }
}

TEST(DensityCells, DeviateOnceAtEachPointAndOnceInTheRule) {
  const DensityCell cell{
      .deviation = 0.25, .rounding = 0.125, .centre = {1, 2, 3}, .half = {0.5, 0.5, 0.5}, .area = 2};
  const double change = 2 * 0.25 + 0.125;
  EXPECT_DOUBLE_EQ(deviation_at(cell, {1, 2, 3.25}), change * std::numbers::pi);  // within the box
  EXPECT_DOUBLE_EQ(deviation_at(cell, {1, 2, 4}), change * std::numbers::pi);     // pi is less than 8
  EXPECT_DOUBLE_EQ(deviation_at(cell, {1, 2, 7.5}), change * 2 / 16);             // at the distance 4
  EXPECT_DOUBLE_EQ(deviation_at(cell, {4.5, 6.5, 3}), change * 2 / (9 + 16));     // at the distance 5
}

TEST(DensityCells, HasABoxAboutAllOfACurvedPart) {
  for (const long halvings : {0, 20}) {
    const auto few = few_halvings(halvings);
    for (const Surface& surface : {ellipsoid(1, 2, 3), two_piece(2)})
      for (const DensityCell& cell : cells_of(surface, "abs(x - y*0.7 - 0.1)")) {
        const ChartIn<double>& chart = surface.charts[cell.chart].in<double>();
        const auto expect_inside = [&](const Parameters& at) {
          const Vector<double> q = chart.frame(at).point;
          constexpr double rounding = 1e-15;
          EXPECT_LE(std::abs(q.x - cell.centre.x), cell.half.x + rounding) << surface.name;
          EXPECT_LE(std::abs(q.y - cell.centre.y), cell.half.y + rounding) << surface.name;
          EXPECT_LE(std::abs(q.z - cell.centre.z), cell.half.z + rounding) << surface.name;
        };
        const Polygon& polygon = cell.polygon;
        for (std::size_t i = 0; i < polygon.count; ++i)
          for (const double along : {0.0, 0.25, 0.5, 0.75})
            expect_inside(polygon[i] + along * (polygon[i + 1] - polygon[i]));
      }
  }
}

TEST(BoxValue, IsAnalyticWhereOneBranchHolds) {
  const auto over = [](double low, double high) {
    const Ball range = hull(Ball(low), Ball(high));
    return BoxValue(range, ComplexBall(range));
  };
  const BoxValue half(Rational(1, 2));
  EXPECT_TRUE(min(over(0, 0.25), half).on_disks.is_finite());
  EXPECT_TRUE(max(over(0, 0.25), half).on_disks.is_finite());
  EXPECT_TRUE(abs(over(-1, -0.5)).on_disks.is_finite());
  for (const BoxValue& value : {min(over(0, 1), half), min(half, over(0, 1)), max(over(0, 1), half),
                                max(half, over(0, 1)), abs(over(-1, 1))}) {
    EXPECT_TRUE(value.on_box.is_finite());
    EXPECT_FALSE(value.on_disks.is_finite());
  }
}

TEST(DensityCells, HasNoBoundWhereTheFormulaHasNoValue) {
  double largest = 0;
  for (const DensityCell& cell : cells_of(cube(), "1/(x - 0.3)")) largest = std::max(largest, cell.deviation);
  EXPECT_TRUE(std::isinf(largest));
  EXPECT_THROW(density_cells(cube(), {}), ContractViolation);
}

/// On the whole catalogue a smooth density has small bounds: each chart's images are enclosed.
TEST(DensityCells, KnowsTheCatalogue) {
  for (const SurfaceDescription& description : surface_catalogue()) {
    const Surface surface = default_surface(description);
    double left = 0;
    const std::vector<DensityCell> cells = cells_of(surface, "exp(x/2 + y/3 - z/4)");
    for (const DensityCell& cell : cells) left += cell.deviation * cell.area;
    EXPECT_LE(left, 1e-10) << description.name;
    EXPECT_LE(cells.size(), 8 * surface.chart_count()) << description.name;
  }
}

/// Int G V u for u = 1 + exp(-a |Q - Q_0|^2), Q_0 amid a plane part, less that for 1: pi/a G(P, Q_0) V(P,
/// Q_0) (1 + O(1/a)), the factor from G'' at distances of 1/2 and more.
void expect_peak(const Surface& surface, const SurfacePoint<double>& p, const Vector<double>& q,
                 const Vector<double>& normal_q, bool is_seen, double without_peak) {
  const Frame<double> frame = surface.charts[p.chart].in<double>().frame(p.at);
  for (const double a : {1e4, 1e10}) {
    const auto square = [](const char* name, double at) {
      return "(" + std::string(name) + " - " + std::to_string(at) + ")^2";
    };
    const Expression u = parse_expression("1 + exp(-" + std::to_string(a) + "*(" + square("x", q.x) + " + " +
                                          square("y", q.y) + " + " + square("z", q.z) + "))")
                             .value();
    const std::vector<Expression> formulas(surface.chart_count(), u);
    const Density density = [&](const SurfacePoint<double>&, const Vector<double>& point) {
      return u.evaluate<double>({point.x, point.y, point.z});
    };
    const Approximation found = AppliedOperator(surface, density, formulas)(p);
    const Vector<double> d = q - frame.point;
    const double g = is_seen ? dot(d, unit_normal(frame)) * -dot(d, normal_q) / (dot(d, d) * dot(d, d)) : 0;
    EXPECT_NEAR(found.value - without_peak, std::numbers::pi / a * g, found.radius + 100 / (a * a)) << a;
    EXPECT_LE(found.radius, 1e-12) << a;
  }
}

TEST(AppliedOperator, SeesPeaksNarrowerThanItsPoints) {
  expect_peak(cube(), {5, {0.4, 0.7}}, {0.3, 0.4, 0}, {0, 0, 1}, true, std::numbers::pi);
}

/// A floor and a ceiling with a plate between them.
Surface plate_in_a_room() {
  const TriangleMesh mesh{.vertices = {{0, 0, 0},
                                       {2, 0, 0},
                                       {2, 2, 0},
                                       {0, 2, 0},
                                       {0, 0, 2},
                                       {2, 0, 2},
                                       {2, 2, 2},
                                       {0, 2, 2},
                                       {0.5, 0.5, 1},
                                       {1.5, 0.5, 1},
                                       {1, 1.5, 1}},
                          .triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}, {8, 9, 10}},
                          .group = {0, 0, 1, 1, 2},
                          .group_names = {"floor", "ceiling", "plate"},
                          .face = {0, 1, 2, 3, 4}};
  const std::vector<std::size_t> pieces{0, 0, 1, 1, 2};
  const std::vector<std::string> names{"floor", "ceiling", "plate"};
  return mesh_surface(
      "plate", mesh, pieces, names,
      {.orientation = Orientation::along_the_cross_product, .closed = false, .unoccluded = false});
}

TEST(AppliedOperator, SeesPeaksPastOccludersOnly) {
  const Surface surface = plate_in_a_room();
  const SurfacePoint<double> p{2, {0.3, 0.4}};  // on the ceiling, at (1.4, 0.6, 2)
  const Density one = [](const SurfacePoint<double>&, const Vector<double>&) { return 1.0; };
  const double without_peak = AppliedOperator(surface, one)(p).value;
  const Vector<double> up{0, 0, 1};
  expect_peak(surface, p, {0.25, 1.75, 0}, up, true, without_peak);
  expect_peak(surface, p, {0.625, 1, 0}, up, false, without_peak);
  expect_peak(surface, p, {1.75, 0.25, 0}, up, true, without_peak);
}

}  // namespace
}  // namespace radcert::reference
