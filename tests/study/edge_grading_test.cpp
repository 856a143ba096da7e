// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/edge_grading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "radcert/closed_form/edge/corner_exponent.h"
#include "radcert/core/errors.h"
#include "radcert/surface/catalogue.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using namespace testing;

EdgeGrading grading_of(const Problem& problem) { return edge_grading(problem, surface_of(problem)); }

Problem of_degree(int degree, const std::string& surface, const std::string& rho) {
  Problem problem = sample_problem(surface);
  problem.method = Collocation{{.degree = degree, .alpha = Rational(1, 10)}};
  problem.reflectivity = everywhere(rho);
  return problem;
}

TEST(EdgeGrading, OfTheCubeAsksForItsCorners) {
  for (const auto& [rho, corner] : {std::pair{"1/2", 0.5}, {"9/10", 0.9}})
    for (int degree = 0; degree <= 4; ++degree) {
      const EdgeGrading found = grading_of(of_degree(degree, "cube", rho));
      ASSERT_EQ(found.edges.size(), 12U);
      ASSERT_EQ(found.corners.size(), 8U);
      const Approximation least = octant_exponent({corner, corner, corner});
      for (const GradedEdge& edge : found.edges) {
        EXPECT_NEAR(edge.degrees, 90, 1e-12);
        EXPECT_GT(edge.exponent, least.value);
        EXPECT_GE(edge.grading.to_double() * edge.exponent, degree + 1);
        EXPECT_LE((edge.grading.to_double() - 1.0 / 64) * edge.exponent, degree + 1);
        EXPECT_LE(edge.grading, found.grading);
      }
      for (const GradedCorner& corner_there : found.corners) EXPECT_EQ(corner_there.grading, found.grading);
      const double wanted = (degree + 1) / least.value;
      EXPECT_GE(found.grading.to_double(), wanted);
      EXPECT_LE(found.grading.to_double(), wanted * 1.001 + 1.0 / 64);
    }
}

TEST(EdgeGrading, OfTwoSquaresAsksForTheirEdge) {
  const EdgeGrading found = grading_of(of_degree(1, "two_squares", "1/2"));
  ASSERT_EQ(found.edges.size(), 1U);
  EXPECT_TRUE(found.corners.empty());
  EXPECT_NEAR(found.edges[0].exponent, 0.76336207521951359, 1e-11);
  EXPECT_EQ(found.grading, Rational(static_cast<long>(std::ceil(64 * 2 / 0.76336207521951359)), 64));
}

TEST(EdgeGrading, TakesTheReflectivitiesOfBothFacesAndTheLargestOnTheEdge) {
  Problem problem = of_degree(0, "two_squares", "1/2");
  problem.reflectivity = by_piece({{"xy", "9/10"}, {"xz", "1/4"}});
  EdgeGrading found = grading_of(problem);
  EXPECT_EQ(found.edges[0].reflectivities[0] * found.edges[0].reflectivities[1], Rational(9, 40));
  problem.reflectivity = everywhere("x*(1-x)");  // at most 1/4, at x = 1/2
  found = grading_of(problem);
  EXPECT_EQ(found.edges[0].reflectivities[0], Rational(1, 4));
  // One black face: r log r. Two: u = E.
  problem.reflectivity = by_piece({{"xy", "1/2"}, {"xz", "0"}});
  EXPECT_EQ(grading_of(problem).edges[0].exponent, 1);
  problem.reflectivity = everywhere("0");
  EXPECT_TRUE(grading_of(problem).edges.empty());
  EXPECT_EQ(grading_of(problem).grading, Rational(1));
}

TEST(EdgeGrading, IsKnownWhateverTheProblemTakes) {
  Problem problem = of_degree(1, "two_squares", "1/2");
  const Rational asked = grading_of(problem).grading;
  problem.triangulation.grading = 7;
  EXPECT_EQ(known_edge_grading(problem, surface_of(problem)).value().grading, asked);
  EXPECT_FALSE(known_edge_grading(sample_problem("sphere"), surface_of(sample_problem("sphere"))));
}

TEST(EdgeGrading, OfABoxIsThatOfTheCube) {
  Problem box = sample_problem("box", {{"a", Rational(1, 3)}, {"b", Rational(2, 7)}, {"c", 3}});
  EXPECT_EQ(grading_of(box).edges.size(), 12U);
  EXPECT_EQ(grading_of(box).grading, grading_of(sample_problem("cube")).grading);
}

TEST(EdgeGrading, IsRefusedByNameWhereItIsNotPossible) {
  for (const char* surface : {"sphere", "tetrahedron", "two_piece", "cylinder"}) {
    const SurfaceDescription& description = *find_surface(surface);
    std::vector<SurfaceParameter> parameters;
    for (const ParameterDescription& parameter : description.parameters)
      parameters.push_back({parameter.name, Rational(2)});
    try {
      static_cast<void>(grading_of(sample_problem(surface, parameters)));
      FAIL() << surface;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("/triangulation/grading"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("plane unit square"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(static_cast<void>(grading_of(of_degree(1, "two_squares", "1"))), InputError);
  EXPECT_THROW(static_cast<void>(grading_of(of_degree(1, "two_squares", "2*x"))), InputError);
}

}  // namespace
}  // namespace radcert
