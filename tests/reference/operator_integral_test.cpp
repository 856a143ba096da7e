// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/operator_integral.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"

namespace radcert::reference {
namespace {

using Point = Vector<double>;
using Place = SurfacePoint<double>;
using Triangle = std::array<ParameterPoint<double>, 3>;

double one(const Place&, const Point&) { return 1; }
double exp_z(const Place&, const Point& q) { return std::exp(q.z); }
double smooth(const Place&, const Point& q) { return std::exp(q.x) * std::cos(q.y); }

/// Int G |u| of the smooth density, what its radii are small against.
double size_of_smooth(const Surface& surface, const Place& p) {
  const auto size = [](const Place& at, const Point& q) { return std::abs(smooth(at, q)); };
  return operator_integral(surface, p, size).value;
}

/// For densities of one sign: the value is right within its radius, and the radius is worth having.
void expect_encloses(const Approximation& estimate, double truth, const std::string& what,
                     double relative_radius = 1e-12) {
  EXPECT_LE(std::abs(estimate.value - truth), estimate.radius) << what;
  EXPECT_LE(estimate.radius, relative_radius * std::abs(estimate.value)) << what;
}

std::string text(const Surface& surface, const Place& p) {
  return surface.name + " chart " + std::to_string(p.chart) + " at " + description(p.at.s) + " " +
         description(p.at.t);
}

/// Parameters of which most lie near or on the border of the domain.
class RandomPlaces {
public:
  explicit RandomPlaces(const Surface& surface, unsigned seed) : surface_(surface), stream_(seed) {}

  Place next() {
    const std::size_t chart = stream_() % surface_.chart_count();
    double s = coordinate();
    double t = coordinate();
    if (surface_.charts[chart].facts().domain == ChartDomain::unit_triangle) {
      if (stream_() % 2 == 0) t = std::max(0.0, 1 - s - t);
      t *= s + t > 1 ? 1 - s : 1;
      if (s + t > 1) t = 1 - s;
    }
    return {chart, {s, t}};
  }

private:
  double uniform() { return static_cast<double>(stream_() >> 11U) * 0x1p-53; }
  double coordinate() {
    const double small = std::pow(10, -8 * uniform());
    switch (stream_() % 3) {
      case 0: return uniform();
      case 1: return small;
      default: return 1 - small;
    }
  }
  const Surface& surface_;
  std::mt19937_64 stream_;
};

/// [Lambert 1760]: Int G over a polygon = 1/2 sum over the sides of their angle at P times n_P . unit(a x b);
/// the polygon counterclockwise as seen from the side to which its normal points, whole above P's horizon.
long double polygon_integral(const Vector<long double>& p, const Vector<long double>& n,
                             const std::vector<Vector<long double>>& corners) {
  long double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<long double> a = corners[i] - p;
    const Vector<long double> b = corners[(i + 1) % corners.size()] - p;
    const Vector<long double> c = cross(a, b);
    const long double length = norm(c);
    if (length == 0) continue;
    sum += std::atan2(length, dot(a, b)) * dot(c, n) / length;
  }
  return std::abs(sum) / 2;
}

Vector<long double> in_long_double(const Point& x) { return {x.x, x.y, x.z}; }

// --- Closed forms
// ---------------------------------------------------------------------------------------------------

TEST(OperatorIntegral, IsPiForTheUnitDensityOnClosedConvexSurfaces) {
  const std::vector<Surface> surfaces{cube(), box(1, 2, 5), box(1, 1, Rational(1, 50)), sphere(),
                                      ellipsoid(1, 2, 5)};
  unsigned seed = 1;
  for (const Surface& surface : surfaces) {
    RandomPlaces places(surface, seed++);
    for (int k = 0; k < 80; ++k) {
      const Place p = places.next();
      expect_encloses(operator_integral(surface, p, one), std::numbers::pi, text(surface, p));
    }
  }
}

TEST(OperatorIntegral, CopesWithEdgesAndCornersAtAllDistances) {
  for (const Surface& surface : {cube(), box(1, 2, 5)})
    for (const double d : {0.02, 1e-3, 1e-5, 1e-8, 1e-12})
      for (std::size_t chart = 0; chart < 6; ++chart)
        for (const ParameterPoint<double>& at :
             {ParameterPoint<double>{d, 0.3}, {0.7, 1 - d}, {d, d}, {1 - d, 3 * d}}) {
          const Place p{chart, at};
          expect_encloses(operator_integral(surface, p, one), std::numbers::pi, text(surface, p), 1e-13);
        }
}

TEST(OperatorIntegral, CopesWithSmoothSeamsAtAllDistances) {
  for (const Surface& surface : {sphere(), ellipsoid(1, 2, 5)})
    for (const double d : {1e-2, 1e-5, 1e-8, 1e-10, 0.0})
      for (std::size_t chart = 0; chart < 8; chart += 3)
        for (const ParameterPoint<double>& at :
             {ParameterPoint<double>{d, 0.3}, {0.6, d}, {0.625 - d, 0.375}, {d, d * d}}) {
          const Place p{chart, at};
          expect_encloses(operator_integral(surface, p, one), std::numbers::pi, text(surface, p));
        }
}

TEST(OperatorIntegral, OfExpZOnTheSphereIsItsMeanValue) {
  // G = 1/4, and Int exp(z) dS = 4 pi sinh 1.
  const double truth = std::numbers::pi * std::sinh(1.0);
  const Surface surface = sphere();
  RandomPlaces places(surface, 7);
  for (int k = 0; k < 60; ++k) {
    const Place p = places.next();
    expect_encloses(operator_integral(surface, p, exp_z), truth, text(surface, p));
  }
}

TEST(OperatorIntegral, HasTheClosedFormsOfTwoSquares) {
  // [ac98, (22)-(24)] at x = 1/3, z = 1/7, evaluated to 24 digits and more.
  const Surface surface = two_squares();
  const Place p{0, {1.0 / 3, 1.0 / 7}};
  const auto xi_minus_x = [](const Place&, const Point& q) { return q.x - 1.0 / 3; };
  const auto eta = [](const Place&, const Point& q) { return q.y; };
  expect_encloses(operator_integral(surface, p, one), 1.19901694200745466, "(22)", 1e-13);
  // Of both signs: its size is that of (22), of which |xi - x| <= 2/3 is a part.
  expect_encloses(operator_integral(surface, p, xi_minus_x), 0.03587048430574663, "(23)", 1e-12);
  expect_encloses(operator_integral(surface, p, eta), 0.29708137306324787, "(24)", 1e-13);
}

TEST(OperatorIntegral, AgreesWithLambertsFormulaNearAnEdge) {
  const Surface surface = two_squares();
  const std::vector<Vector<long double>> floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const double x : {0.0, 1e-9, 1.0 / 3, 0.5, 0.99, 1.0})
    for (const double z : {1.0, 0.25, 1e-2, 1e-4, 1e-8, 1e-12}) {
      const Place p{0, {x, z}};
      const long double truth = polygon_integral({x, 0, z}, {0, 1, 0}, floor);
      expect_encloses(operator_integral(surface, p, one), static_cast<double>(truth), text(surface, p),
                      2e-13);
    }
}

TEST(OperatorIntegral, HasTheConfigurationFactorsOfTheCube) {
  const Surface surface = cube();
  const Place centre{0, {0.5, 0.5}};
  const auto face = [&](std::size_t chart) {
    const Approximation lower =
        operator_integral(surface, centre, chart, Triangle{{{0, 0}, {1, 0}, {1, 1}}}, one);
    const Approximation upper =
        operator_integral(surface, centre, chart, Triangle{{{0, 0}, {0, 1}, {1, 1}}}, one);
    return lower + upper;
  };
  // Four quarters of a parallel square at distance 1, each with a corner opposite to P and the side 1/2; and
  // the rest.
  const double opposite = 4 / std::sqrt(5.0) * std::atan(1 / std::sqrt(5.0));
  expect_encloses(face(1), opposite, "opposite", 1e-13);
  expect_encloses(face(2), (std::numbers::pi - opposite) / 4, "adjacent", 1e-13);
}

// --- A second computation, in long double
// ---------------------------------------------------------------------------

/// Gauss's rule with 16 points on [0,1], by Newton's method on Legendre's polynomial.
struct Gauss {
  static constexpr int n = 16;
  std::array<long double, n> x{};
  std::array<long double, n> w{};
  Gauss() {
    for (int i = 0; i < n; ++i) {
      long double z = std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (n + 0.5L));
      long double slope = 1;
      for (int step = 0; step < 100; ++step) {
        long double p = 1;
        long double before = 0;
        for (int k = 1; k <= n; ++k) {
          const long double next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
          before = p;
          p = next;
        }
        slope = n * (before - z * p) / (1 - z * z);
        const long double move = p / slope;
        z -= move;
        if (std::abs(move) < 1e-19L) break;
      }
      x[static_cast<std::size_t>(i)] = 0.5L * (1 - z);
      w[static_cast<std::size_t>(i)] = 1 / ((1 - z * z) * slope * slope);
    }
  }
};

/// Int over the unit square of a function that is not smooth at one point and on s = 0: cells halved towards
/// both.
long double brute_force(const std::function<long double(const ParameterPoint<long double>&)>& f,
                        const ParameterPoint<long double>& bad_point, bool bad_line) {
  static const Gauss gauss;
  const std::function<long double(long double, long double, long double, long double)> cell =
      [&](long double s, long double t, long double width, long double height) -> long double {
    const long double distance = std::hypot(std::max({s - bad_point.s, bad_point.s - s - width, 0.0L}),
                                            std::max({t - bad_point.t, bad_point.t - t - height, 0.0L}));
    const bool near_point = distance < 0.7L * std::max(width, height) && std::max(width, height) > 0x1p-25L;
    const bool near_line = bad_line && s < 0.5L * width && width > 0x1p-28L;
    if ((near_point && width >= height) || near_line)
      return cell(s, t, width / 2, height) + cell(s + width / 2, t, width / 2, height);
    if (near_point) return cell(s, t, width, height / 2) + cell(s, t + height / 2, width, height / 2);
    long double sum = 0;
    for (std::size_t i = 0; i < Gauss::n; ++i)
      for (std::size_t j = 0; j < Gauss::n; ++j)
        sum += gauss.w[i] * gauss.w[j] * f({s + gauss.x[i] * width, t + gauss.x[j] * height});
    return sum * width * height;
  };
  return cell(0, 0, 1, 1);
}

void compare_two_piece_with_long_double(const Rational& exponent, const std::vector<Place>& places) {
  using LongPoint = Vector<long double>;
  const ChartOf<long double, Rectangle<long double>> lower(
      Rectangle<long double>({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), Orientation::along_the_cross_product);
  const ChartOf<long double, PowerRoof<long double>> upper(PowerRoof<long double>{exponent},
                                                           Orientation::against_the_cross_product);
  const std::array<const ChartIn<long double>*, 2> charts{&lower, &upper};
  const Surface surface = two_piece(exponent);
  for (const Place& p : places) {
    const ParameterPoint<long double> at{p.at.s, p.at.t};
    const Frame<long double> here = charts[p.chart]->frame(at);
    const LongPoint normal = unit_normal(here);
    long double truth = 0;
    for (const std::size_t chart : {0U, 1U}) {
      if (chart == 0 && p.chart == 0) continue;  // one plane: G = 0
      const auto integrand = [&](const ParameterPoint<long double>& q) {
        const Frame<long double> there = charts[chart]->frame(q);
        return geometric_kernel(here.point, normal, there.point, there.area_normal) *
               std::exp(there.point.x) * std::cos(there.point.y);
      };
      const ParameterPoint<long double> far_off{100, 100};
      truth += brute_force(integrand, chart == p.chart ? at : far_off, chart == 1 && !exponent.is_integer());
    }
    expect_encloses(operator_integral(surface, p, smooth), static_cast<double>(truth), text(surface, p),
                    1e-13);
  }
}

TEST(OperatorIntegral, AgreesWithLongDoubleOnTheTwoPieceSurface) {
  compare_two_piece_with_long_double(
      2, {{0, {0.3, 0.4}}, {0, {1, 0}}, {1, {0.3, 0.4}}, {1, {1e-6, 0.7}}, {1, {0.999, 1}}});
}

TEST(OperatorIntegral, AgreesWithLongDoubleAtASingularLine) {
  compare_two_piece_with_long_double(
      Rational(3, 2), {{0, {0.2, 0.9}}, {0, {0, 0.5}}, {1, {0.3, 0.4}}, {1, {0.01, 0.7}}, {1, {0.999, 1}}});
}

TEST(OperatorIntegral, IsContinuousUpToASingularLine) {
  for (const Rational& exponent : {Rational(3, 2), Rational(7, 3)}) {
    const Surface surface = two_piece(exponent);
    const Approximation on_it = operator_integral(surface, {1, {0, 0.3}}, smooth);
    const Approximation beside_it = operator_integral(surface, {1, {1e-14, 0.3}}, smooth);
    const double size = size_of_smooth(surface, {1, {0, 0.3}});
    EXPECT_NEAR(on_it.value, beside_it.value, 1e-5 * size) << exponent.to_text();
    EXPECT_LE(on_it.radius, 1e-12 * size);
    EXPECT_LE(beside_it.radius, 1e-12 * size);
  }
}

// --- Laws
// -----------------------------------------------------------------------------------------------------------

/// The domain of a chart in 2 or 1 times 4^levels triangles, on dyadic points.
std::vector<Triangle> triangles_of(ChartDomain domain, int levels) {
  std::vector<Triangle> all{{{{0, 0}, {1, 0}, {0, 1}}}};
  if (domain == ChartDomain::unit_square) all.push_back({{{1, 1}, {1, 0}, {0, 1}}});
  for (int level = 0; level < levels; ++level) {
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : all) {
      const ParameterPoint<double> ab = 0.5 * (a + b);
      const ParameterPoint<double> bc = 0.5 * (b + c);
      const ParameterPoint<double> ca = 0.5 * (c + a);
      for (const Triangle& part :
           {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
        finer.push_back(part);
    }
    all = finer;
  }
  return all;
}

TEST(OperatorIntegral, OverTrianglesSumsToTheWhole) {
  for (const Surface& surface : {box(1, 2, 5), ellipsoid(1, 2, 5), two_piece(2), two_piece(Rational(3, 2))}) {
    RandomPlaces places(surface, 11);
    for (int k = 0; k < 8; ++k) {
      const Place p = places.next();
      const Approximation whole = operator_integral(surface, p, smooth);
      const double size = size_of_smooth(surface, p);
      Approximation sum = Approximation::exact(0);
      for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
        for (const Triangle& triangle : triangles_of(surface.charts[chart].facts().domain, 1)) {
          const Approximation part = operator_integral(surface, p, chart, triangle, smooth);
          EXPECT_LE(part.radius, 1e-12 * size) << text(surface, p);
          sum += part;
        }
      EXPECT_LE(std::abs(sum.value - whole.value), sum.radius + whole.radius) << text(surface, p);
    }
  }
}

/// The sum over the triangles of the domains' refinement: other nearest points, other parts, smaller ones.
Approximation finer_integral(const Surface& surface, const Place& p, int levels, const Density& u) {
  Approximation sum = Approximation::exact(0);
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    for (const Triangle& triangle : triangles_of(surface.charts[chart].facts().domain, levels)) {
      const Approximation part = operator_integral(surface, p, chart, triangle, u);
      sum += part;
    }
  return sum;
}

/// Places 1e-3 from an edge and from a corner of each chart's domain, and on nodes of inset 1e-3.
std::vector<Place> degenerate_places(const Surface& surface) {
  std::vector<Place> places;
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    for (const ParameterPoint<double>& at : {ParameterPoint<double>{1e-3, 0.4},
                                             {0.3, 1e-3},
                                             {1e-3, 1e-3},
                                             {0.998, 1e-3},
                                             {1e-3, 0.998},
                                             {0.4995, 0.2505}})
      places.push_back({chart, at});
  return places;
}

TEST(OperatorIntegral, IsWithinItsRadiusOfAFinerComputation) {
  for (const Surface& surface : {cube(), box(1, 2, 5), sphere(), ellipsoid(1, 2, 5), two_squares(),
                                 two_piece(Rational(3, 2)), two_piece(2), two_piece(3)}) {
    std::vector<Place> places = degenerate_places(surface);
    RandomPlaces random(surface, 17);
    for (int k = 0; k < 12; ++k) places.push_back(random.next());
    const AppliedOperator applied(surface, smooth);
    for (std::size_t k = 0; k < places.size(); k += 1 + surface.chart_count() / 3) {
      const Place& p = places[k];
      const Approximation finer = finer_integral(surface, p, 1, smooth);
      for (const Approximation& estimate : {operator_integral(surface, p, smooth), applied(p)}) {
        EXPECT_LE(std::abs(estimate.value - finer.value), estimate.radius) << text(surface, p);
        EXPECT_LE(estimate.radius, 5e-12 * size_of_smooth(surface, p)) << text(surface, p);
      }
    }
  }
}

/// The cube with each face cut into n times n squares.
Surface cube_of_small_squares(long n) {
  const std::array<Vector<Rational>, 3> sides{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Surface surface;
  surface.name = "cube_of_small_squares";
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const long end : {0, 1})
      for (long i = 0; i < n; ++i)
        for (long j = 0; j < n; ++j) {
          const Vector<Rational>& first = sides[(axis + 1) % 3];
          const Vector<Rational>& second = sides[(axis + 2) % 3];
          surface.charts.push_back(
              make_rectangle({.name = std::to_string(surface.charts.size()),
                              .piece = std::to_string(2 * axis + static_cast<std::size_t>(end)),
                              .orientation = end == 0 ? Orientation::along_the_cross_product
                                                      : Orientation::against_the_cross_product},
                             Rational(end) * sides[axis] + Rational(i, n) * first + Rational(j, n) * second,
                             Rational(1, n) * first, Rational(1, n) * second));
        }
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

TEST(AppliedOperator, DoesNotDependOnHowASurfaceIsCutIntoCharts) {
  const Surface coarse = cube();
  constexpr long n = 4;  // dyadic: the charts are exact, and so are the places on them
  const Surface fine = cube_of_small_squares(n);
  const AppliedOperator applied(fine, smooth);
  const AppliedOperator of_one(fine, one);
  RandomPlaces places(coarse, 23);
  for (int k = 0; k < 20; ++k) {
    const Place p = places.next();
    const double s = std::min(std::floor(n * p.at.s), n - 1.0);
    const double t = std::min(std::floor(n * p.at.t), n - 1.0);
    const Place q{p.chart * n * n + static_cast<std::size_t>(s * n + t), {n * p.at.s - s, n * p.at.t - t}};
    if (p.at.s == 0 || p.at.t == 0 || p.at.s == 1 || p.at.t == 1) continue;
    const Approximation whole = operator_integral(coarse, p, smooth);
    const Approximation parts = applied(q);
    EXPECT_LE(std::abs(whole.value - parts.value), whole.radius + parts.radius) << text(coarse, p);
    expect_encloses(of_one(q), std::numbers::pi, text(fine, q), 2e-13);
  }
}

TEST(AppliedOperator, RefinesWhatItsSamplesDoNotResolve) {
  const Surface surface = cube_of_small_squares(4);
  const auto wild = [](const Place&, const Point& q) {
    return std::cos(60 * q.x) + std::exp(20 * (q.z - 1));
  };
  const AppliedOperator applied(surface, wild);
  for (const Place& p : {Place{3, {0.3, 0.4}}, {40, {0.5, 0.1}}, {90, {0.9, 0.7}}}) {
    const Approximation finer = finer_integral(surface, p, 2, wild);
    expect_encloses(applied(p), finer.value, text(surface, p), 1e-12);
  }
}

TEST(Density, GivesTheSameByPointsAndByBlocks) {
  const Density by_block = [](const PointBlock& q, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::exp(q.x[i]) * std::cos(q.y[i]);
  };
  for (const Surface& surface : {cube(), sphere(), two_piece(Rational(3, 2))}) {
    const Place p{1, {0.3, 0.4}};
    const Approximation blocks = operator_integral(surface, p, by_block);
    const Approximation points = operator_integral(surface, p, smooth);
    EXPECT_EQ(blocks.value, points.value);
    EXPECT_EQ(blocks.radius, points.radius);
  }
  EXPECT_FALSE(static_cast<bool>(Density()));
  EXPECT_EQ(by_block(Place{}, Point{0, 0, 0}), 1);
}

TEST(OperatorIntegral, OverATriangleAgreesWithLambertsFormula) {
  const Surface surface = cube();
  RandomPlaces places(surface, 5);
  RandomPlaces corners(surface, 6);
  for (int k = 0; k < 100; ++k) {
    const Place p = places.next();
    const Triangle triangle{corners.next().at, corners.next().at, corners.next().at};
    const std::size_t chart = (p.chart + 1 + static_cast<std::size_t>(k) % 5) % 6;
    const Frame<double> frame = surface.charts[p.chart].in<double>().frame(p.at);
    std::vector<Vector<long double>> polygon;
    for (const ParameterPoint<double>& corner : triangle)
      polygon.push_back(in_long_double(surface.charts[chart].in<double>().frame(corner).point));
    const long double truth =
        polygon_integral(in_long_double(frame.point), in_long_double(unit_normal(frame)), polygon);
    const Approximation estimate = operator_integral(surface, p, chart, triangle, one);
    EXPECT_LE(std::abs(estimate.value - static_cast<double>(truth)), estimate.radius + 1e-17L)
        << text(surface, p) << " to chart " << chart;
    // Not 1e-13: the point nearest to P on a slanting side is rounded off it.
    EXPECT_LE(estimate.radius, 1e-12 * std::abs(estimate.value) + 1e-14)
        << text(surface, p) << " to chart " << chart;
  }
}

TEST(OperatorIntegral, CountsTheStripBesideASlantingSideThroughItsApex) {
  const Surface surface = cube();
  const Place p{3, {1.3811321121724655e-05, 0.99999158509369213}};
  const Approximation sum = finer_integral(surface, p, 0, one);
  EXPECT_GT(std::abs(sum.value - std::numbers::pi), 2e-13) << "or the place shows nothing";
  expect_encloses(sum, std::numbers::pi, text(surface, p), 1e-11);
}

TEST(OperatorIntegral, DoesNotDependOnTheOrderOfTheCorners) {
  const Surface surface = sphere();
  const Place p{0, {0.3, 0.3}};
  const ParameterPoint<double> a{0.25, 0.25};
  const ParameterPoint<double> b{0.5, 0.25};
  const ParameterPoint<double> c{0.25, 0.5};
  const Approximation there = operator_integral(surface, p, 0, {a, b, c}, smooth);
  const Approximation back = operator_integral(surface, p, 0, {c, b, a}, smooth);
  EXPECT_GT(there.value, 0);
  EXPECT_LE(std::abs(there.value - back.value), there.radius + back.radius);
}

TEST(OperatorIntegral, IsLinearAndSeesTheSign) {
  const Surface surface = cube();
  const Place p{2, {0.1, 0.8}};
  const auto odd = [](const Place&, const Point& q) { return q.z - 0.5; };
  const auto shifted = [](const Place&, const Point& q) { return 3 * (q.z - 0.5) - 2; };
  const Approximation first = operator_integral(surface, p, odd);
  const Approximation second = operator_integral(surface, p, shifted);
  EXPECT_LE(std::abs(second.value - (3 * first.value - 2 * std::numbers::pi)),
            second.radius + 3 * first.radius);
  const auto size = [&odd](const Place& at, const Point& q) { return std::abs(odd(at, q)); };
  EXPECT_LT(std::abs(first.value), 0.9 * operator_integral(surface, p, size).value);
}

TEST(OperatorIntegral, GivesTheDensityPointsOfItsChart) {
  const Surface surface = ellipsoid(1, 2, 5);
  double worst = 0;
  const auto checked = [&](const Place& q, const Point& point) {
    const Point expected = surface.charts.at(q.chart).in<double>().frame(q.at).point;
    worst = std::max(worst, norm(expected - point));
    return 1.0;
  };
  operator_integral(surface, {3, {0.2, 0.1}}, checked);
  EXPECT_LT(worst, 1e-14);
  worst = 0;
  const Surface solid = box(1, 2, 5);
  const auto checked_on_box = [&](const Place& q, const Point& point) {
    worst = std::max(worst, norm(solid.charts.at(q.chart).in<double>().frame(q.at).point - point));
    return 1.0;
  };
  operator_integral(solid, {3, {0.2, 0.1}}, checked_on_box);
  EXPECT_LT(worst, 1e-14);
}

TEST(OperatorIntegral, HasARadiusThatCoversADensityItCannotResolve) {
  const Surface surface = two_squares();
  const auto step = [](const Place&, const Point& q) { return q.x < std::numbers::inv_pi ? 1.0 : 0.0; };
  const double z = 0.25;
  const std::vector<Vector<long double>> strip{
      {0, 0, 0}, {std::numbers::inv_pi, 0, 0}, {std::numbers::inv_pi, 1, 0}, {0, 1, 0}};
  const long double truth = polygon_integral({0.5, 0, z}, {0, 1, 0}, strip);
  const Approximation estimate = operator_integral(surface, {0, {0.5, z}}, step);
  EXPECT_LE(std::abs(estimate.value - static_cast<double>(truth)), estimate.radius);
  EXPECT_LE(estimate.radius, 0.1);
}

TEST(OperatorIntegral, HasARadiusThatGrowsWhereRoundingDoes) {
  // A wall below the edge s = 1 of a curved roof: near P the rounding of the roof's points shows.
  Surface surface = two_piece(2);
  surface.charts[0] = make_rectangle({.name = "wall", .piece = "wall"}, {1, 0, 1}, {0, 1, 0}, {0, 0, -1});
  const auto at_distance = [&](double d) { return operator_integral(surface, {0, {0.5, d}}, one); };
  const Approximation near = at_distance(1e-8);
  EXPECT_GE(near.radius, 1e-10);
  EXPECT_LE(near.radius, 1e-6);
  EXPECT_NEAR(near.value, at_distance(1e-7).value, 1e-5);
  // The points of the roof are off by rounding, at most of its largest coordinate: over the distance that is
  // what the kernel is off by, for all points at once if these err alike.
  for (const double d : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const Approximation found = at_distance(d);
    EXPECT_GE(found.radius, 0x1p-53 / d * found.value) << d;
  }
  const ChartOf<long double, PowerRoof<long double>> roof(PowerRoof<long double>{Rational(2)},
                                                          Orientation::against_the_cross_product);
  const long double d = 0x1p-7L;
  const auto integrand = [&](const ParameterPoint<long double>& q) {
    const Frame<long double> there = roof.frame(q);
    return geometric_kernel<long double>({1, 0.5L, 1 - d}, {-1, 0, 0}, there.point, there.area_normal);
  };
  const long double truth = brute_force(integrand, {1, 0.5L}, false);
  expect_encloses(at_distance(0x1p-7), static_cast<double>(truth), "beside a curved roof");
}

TEST(OperatorIntegral, IsZeroInOnePlaneAndOnADegenerateTriangle) {
  const Surface flat = two_piece(1);
  EXPECT_EQ(operator_integral(flat, {1, {0.5, 0.5}}, 1, {{{0, 0}, {1, 0}, {0, 1}}}, one).value, 0);
  EXPECT_EQ(operator_integral(flat, {1, {0.5, 0.5}}, 0, {{{0, 0}, {0.5, 0.5}, {1, 1}}}, one).value, 0);
}

TEST(OperatorIntegral, RefusesWhatItDoesNotRequire) {
  const Surface surface = cube();
  EXPECT_THROW(operator_integral(surface, {6, {0.5, 0.5}}, one), ContractViolation);
  EXPECT_THROW(operator_integral(surface, {0, {1.5, 0.5}}, one), ContractViolation);
  EXPECT_THROW(operator_integral(surface, {0, {std::nan(""), 0.5}}, one), ContractViolation);
  EXPECT_THROW(operator_integral(surface, {0, {0, 0.5}}, one), ContractViolation) << "P on an edge";
  EXPECT_THROW(operator_integral(surface, {0, {0.5, 0.5}}, 1, {{{0, 0}, {2, 0}, {0, 1}}}, one),
               ContractViolation);
  const auto broken = [](const Place&, const Point&) { return std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_THROW(operator_integral(surface, {0, {0.5, 0.5}}, broken), ContractViolation);
  EXPECT_THROW(operator_integral(surface, {0, {0.5, 0.5}}, Density()), ContractViolation);
  EXPECT_THROW(AppliedOperator(surface, broken), ContractViolation);
  EXPECT_THROW(AppliedOperator(surface, Density()), ContractViolation);
  EXPECT_THROW(AppliedOperator(surface, one)({0, {0, 0.5}}), ContractViolation) << "P on an edge";
}

}  // namespace
}  // namespace radcert::reference
