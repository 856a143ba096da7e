// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "radcert/closed_form/polygon_to_polygon.h"
#include "radcert/core/parallel.h"
#include "radcert/geometry/plane_polygon.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "tests/galerkin/setting.h"

namespace radcert {
namespace {

/// An element of a plane chart, exactly.
PlanePolygon polygon_of(const Surface& surface, const ParameterTriangle& triangle) {
  std::vector<Vector<Rational>> corners;
  for (const ParameterPoint<double>& v : triangle.vertices) {
    const Vector<double> p = surface.charts[triangle.chart].in<double>().frame(v).point;
    corners.push_back({Rational::exactly(p.x), Rational::exactly(p.y), Rational::exactly(p.z)});
  }
  const Frame<double> frame = surface.charts[triangle.chart].in<double>().frame(triangle.vertices[0]);
  const Vector<Rational> first = corners[1] - corners[0];
  const Vector<Rational> second = corners[2] - corners[0];
  const Vector<Rational> normal = cross(first, second);
  const bool agrees = normal.x.to_double() * frame.area_normal.x +
                          normal.y.to_double() * frame.area_normal.y +
                          normal.z.to_double() * frame.area_normal.z >
                      0;
  const auto point = [](int s, int t) { return ParameterPoint<Rational>{Rational(s), Rational(t)}; };
  return plane_polygon(corners[0], agrees ? first : second, agrees ? second : first,
                       {{point(0, 0), point(1, 0), point(0, 1)}})
      .value();
}

double area_of(const Surface& surface, const ParameterTriangle& triangle) {
  std::array<Vector<double>, 3> p;
  for (std::size_t i = 0; i < 3; ++i)
    p[i] = surface.charts[triangle.chart].in<double>().frame(triangle.vertices[i]).point;
  return norm(cross(p[1] - p[0], p[2] - p[0])) / 2;
}

/// psi = area^(-1/2), so that the entry is F_kl sqrt(A_k / A_l): by dilogarithms, which share no rule.
double entry_of_constants(const GalerkinSetting& setting, std::size_t k, std::size_t l) {
  const BallPrecision precision(200);
  const ParameterTriangle& from = setting.triangulation.triangles[k];
  const ParameterTriangle& to = setting.triangulation.triangles[l];
  const Ball factor = polygon_to_polygon(polygon_of(setting.surface, from), polygon_of(setting.surface, to));
  return factor.to_double() * std::sqrt(area_of(setting.surface, from) / area_of(setting.surface, to));
}

TEST(GalerkinMatrix, IsTheConfigurationFactorOfPlaneElementsAtDegreeZero) {
  for (const int level : {0, 1}) {
    const GalerkinSetting setting(box(1, 2, 3), level, 0);
    const PairIntegrals pairs(setting.surface, setting.triangulation, setting.functions, 1e-9);
    const GalerkinMatrix matrix = setting.matrix(1e-9);
    const auto& triangles = setting.triangulation.triangles;
    const std::size_t step = level == 0 ? 5 : 23;
    for (std::size_t k = 0; k < triangles.size(); k += step)
      for (std::size_t l = 0; l < triangles.size(); ++l) {
        const double exact = entry_of_constants(setting, k, l);
        const PairBlock block = pairs.block(k, l);
        EXPECT_EQ(matrix.entries(k, l), matrix.entries(l, k));
        EXPECT_NEAR(matrix.entries(k, l), exact, 2e-13) << level << ": " << k << ", " << l;
        EXPECT_LT(block.radius(0, 0), 1e-12) << level << ": " << k << ", " << l;
        EXPECT_LE(std::abs(block.value(0, 0) - exact), block.radius(0, 0) + 1e-15)
            << level << ": " << k << ", " << l;
      }
  }
}

TEST(GalerkinMatrix, KnowsWhatCoarseRulesMissOfPlaneElements) {
  // psi_0 is constant for every degree: its entry is that of constants. Two coarse rules may agree by chance.
  for (const Surface& surface : {box(1, Rational(1, 10), 1), box(3, Rational(1, 20), 1)}) {
    const GalerkinSetting setting(surface, 0, 1);
    const PairIntegrals pairs(setting.surface, setting.triangulation, setting.functions, 0.9);
    const auto& triangles = setting.triangulation.triangles;
    for (std::size_t k = 0; k < triangles.size(); k += 3)
      for (std::size_t l = 0; l < triangles.size(); ++l) {
        const double exact = entry_of_constants(setting, k, l);
        const PairBlock block = pairs.block(k, l);
        EXPECT_LE(std::abs(block.value(0, 0) - exact), block.radius(0, 0) + 1e-15) << k << ", " << l;
      }
  }
}

TEST(GalerkinMatrix, TakesOneToOneOnClosedSurfacesAtEveryDegree) {
  // Int G(P,Q) dS_Q = pi: A times the coefficients of 1 are the coefficients of 1.
  for (const Surface& surface : {cube(), ellipsoid(1, 2, 3)})
    for (int degree = 0; degree <= 4; ++degree) {
      const GalerkinSetting setting(surface, degree == 0 ? 1 : 0, degree);
      const GalerkinMatrix matrix = setting.matrix(1e-5);
      const std::vector<double> one = setting.moments([](const Vector<double>&) { return 1.0; });
      double largest = 0;
      for (const double value : one) largest = std::max(largest, std::abs(value));
      double radius = 0;
      double error = 0;
      for (std::size_t i = 0; i < one.size(); ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < one.size(); ++j) sum += matrix.entries(i, j) * one[j];
        // The moments themselves come from rules.
        EXPECT_LE(std::abs(sum - one[i]), matrix.row_radius[i] * largest + 1e-10)
            << surface.name << " degree " << degree << " row " << i;
        radius = std::max(radius, matrix.row_radius[i]);
        error = std::max(error, std::abs(sum - one[i]));
      }
      EXPECT_LT(radius, 1e-3) << surface.name << " degree " << degree;
      EXPECT_LT(error, 1e-6) << surface.name << " degree " << degree;
    }
}

TEST(GalerkinMatrix, HasTransposedBlocksWithinTheirRadii) {
  // The other order of integration uses other points on both elements.
  for (const Surface& surface : {box(1, 2, 3), ellipsoid(1, 2, 3)}) {
    const GalerkinSetting setting(surface, 0, 2);
    const PairIntegrals pairs(surface, setting.triangulation, setting.functions, 1e-6);
    const std::size_t elements = setting.functions.elements();
    for (std::size_t k = 0; k < elements; ++k)
      for (std::size_t l = 0; l < k; l += 3) {
        const PairBlock one = pairs.block(k, l);
        const PairBlock other = pairs.block(l, k);
        for (std::size_t a = 0; a < one.value.rows(); ++a)
          for (std::size_t b = 0; b < one.value.columns(); ++b)
            EXPECT_LE(std::abs(one.value(a, b) - other.value(b, a)),
                      one.radius(a, b) + other.radius(b, a) + 1e-15)
                << surface.name << " " << k << ", " << l << ": " << a << ", " << b;
      }
  }
}

TEST(GalerkinMatrix, HasTheSameBitsForAnyNumberOfThreads) {
  const GalerkinSetting setting(ellipsoid(1, 2, 3), 0, 1);
  const GalerkinMatrix matrix = setting.matrix(1e-6);
  const ThreadLimit one(1);
  const GalerkinMatrix alone = setting.matrix(1e-6);
  for (std::size_t i = 0; i < matrix.entries.rows(); ++i) {
    EXPECT_EQ(matrix.row_radius[i], alone.row_radius[i]);
    for (std::size_t j = 0; j < matrix.entries.columns(); ++j)
      EXPECT_EQ(matrix.entries(i, j), alone.entries(i, j));
  }
}

TEST(DefinitenessAsStored, IsAttainedByOneUnknown) {
  // W = 1 + defect, A* = rho W, A = A* + radius.
  for (const double absorptivity : {1.0, 0.5, 0.1, 1e-3, 1e-9})
    for (const double radius : {0.0, 1e-15, 3e-10, 7e-5, 0.3})
      for (const double defect : {0.0, 1e-15, 2e-7, 0.01}) {
        const Rational exact = Rational::exactly(absorptivity) -
                               (1 - Rational::exactly(absorptivity)) * Rational::exactly(defect) -
                               Rational::exactly(radius);
        const double bound = definiteness_as_stored(absorptivity, radius, defect);
        EXPECT_LE(Rational::exactly(bound), exact) << absorptivity << " " << radius << " " << defect;
        EXPECT_NEAR(bound, exact.to_double(), 1e-15) << absorptivity << " " << radius << " " << defect;
      }
}

}  // namespace
}  // namespace radcert
