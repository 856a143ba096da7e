// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/triangulation/interpolated_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "tests/laws/interpolation_laws.h"

namespace radcert {
namespace {

double area(const InterpolatedSurface& interpolant) {
  const TriangleRule<double> rule = conical_rule<double>(12, Grading::none);
  double sum = 0;
  for (const ParameterTriangle& element : interpolant.triangulation.triangles) {
    const auto& v = element.vertices;
    const double parallelogram = cross(v[1] - v[0], v[2] - v[0]);
    for (std::size_t q = 0; q < rule.weights.size(); ++q)
      sum += rule.weights[q] * parallelogram *
             area_element(
                 interpolant.surface.charts[element.chart].in<double>().frame(element.at(rule.points[q].x)));
  }
  return sum;
}

/// log_2 of the ratio of an error at two levels of refinement.
double order(const std::function<double(int)>& error, int level) {
  return std::log2(error(level) / error(level + 1));
}

TEST(Interpolate, GivesAChartToEachElementOfACurvedChartAndKeepsTheFlatOnes) {
  const Surface surface = two_piece(3);
  const Triangulation triangulation = triangulate(surface, 1);
  const InterpolatedSurface interpolant = interpolate(surface, triangulation, 2);
  EXPECT_EQ(interpolant.surface.charts.size(), 1U + 8U);
  EXPECT_EQ(interpolant.surface.diagonals.size(), 9U);
  EXPECT_EQ(interpolant.surface.piece_names(), surface.piece_names());
  EXPECT_FALSE(interpolant.surface.charts_join_smoothly);
  ASSERT_EQ(interpolant.triangulation.triangles.size(), 16U);
  for (std::size_t k = 0; k < 16; ++k) {
    const ParameterTriangle& element = interpolant.triangulation.triangles[k];
    EXPECT_EQ(element.chart, k < 8 ? 0U : k - 7U);
    if (k < 8) {
      EXPECT_EQ(element.vertices, triangulation.triangles[k].vertices);
    }
  }
}

TEST(Interpolate, LeavesASurfaceOfFlatChartsAsItIs) {
  for (const Surface& surface : {cube(), two_piece(1)}) {
    const Triangulation triangulation = triangulate(surface, 2);
    const InterpolatedSurface interpolant = interpolate(surface, triangulation, 4);
    EXPECT_TRUE(interpolant.surface.charts_join_smoothly);
    ASSERT_EQ(interpolant.surface.charts.size(), surface.charts.size());
    EXPECT_EQ(interpolant.surface.diagonals, surface.diagonals);
    for (std::size_t k = 0; k < triangulation.triangles.size(); ++k) {
      EXPECT_EQ(interpolant.triangulation.triangles[k].chart, triangulation.triangles[k].chart);
      EXPECT_EQ(interpolant.triangulation.triangles[k].vertices, triangulation.triangles[k].vertices);
    }
  }
}

TEST(Interpolate, RefusesDegreesOutOfRange) {
  for (const Surface& surface : {cube(), sphere()})
    for (const int degree : {-1, 0, 7})
      EXPECT_THROW(interpolate(surface, triangulate(surface, 0), degree), ContractViolation) << degree;
}

TEST(Interpolate, HasErrorsOfTheOrdersThatThePaperStates) {
  // (87) h^(r+1), (88) h^r times h for derivatives in the element's own coordinates, (90) h^r; two-sided.
  for (const Surface& surface : {ellipsoid(1, 2, 3), two_piece(7)})
    for (int degree = 1; degree <= 6; ++degree) {
      constexpr int level = 4;
      const auto error = [&](double laws::InterpolationError::*figure) {
        return order(
            [&](int k) {
              const Triangulation triangulation = triangulate(surface, k);
              return laws::interpolation_error(surface, triangulation,
                                               interpolate(surface, triangulation, degree)).*
                     figure;
            },
            level);
      };
      EXPECT_NEAR(error(&laws::InterpolationError::point), degree + 1, 0.3) << surface.name << degree;
      EXPECT_NEAR(error(&laws::InterpolationError::derivative), degree + 1, 0.3) << surface.name << degree;
      EXPECT_NEAR(error(&laws::InterpolationError::normal), degree, 0.3) << surface.name << degree;
    }
}

TEST(Interpolate, HasAnAreaThatConverges) {
  // The error of the area is h^(r+1), one order better for even r, where it cancels between elements.
  for (int degree = 1; degree <= 4; ++degree) {
    const auto error = [&](int level) {
      const Surface surface = sphere();
      return std::abs(area(interpolate(surface, triangulate(surface, level), degree)) - 4 * std::numbers::pi);
    };
    const double expected = degree % 2 == 0 ? degree + 2 : degree + 1;
    EXPECT_NEAR(order(error, 2), expected, 0.35) << degree;
  }
  // Degree 2 is exact on S(2): 1 + sqrt(5)/2 + asinh(2)/4.
  const Surface roof = two_piece(2);
  EXPECT_NEAR(area(interpolate(roof, triangulate(roof, 2), 2)), 1 + std::sqrt(5.0) / 2 + std::asinh(2.0) / 4,
              1e-13);
}

TEST(Interpolate, StaysClosed) {
  // Int n dS over the patches of a closed surface vanishes because its sides coincide.
  for (const int degree : {1, 2, 3, 6}) {
    const Surface surface = ellipsoid(1, 2, 5);
    const InterpolatedSurface interpolant = interpolate(surface, triangulate(surface, 1), degree);
    EXPECT_TRUE(interpolant.surface.closed);
    const TriangleRule<double> rule = conical_rule<double>(12, Grading::none);
    Vector<double> sum{};
    for (const ParameterTriangle& element : interpolant.triangulation.triangles)
      for (std::size_t q = 0; q < rule.weights.size(); ++q)
        sum = sum + rule.weights[q] * interpolant.surface.charts[element.chart]
                                          .in<double>()
                                          .frame(element.at(rule.points[q].x))
                                          .area_normal;
    EXPECT_LE(norm(sum), 1e-12) << degree;
  }
}

}  // namespace
}  // namespace radcert
