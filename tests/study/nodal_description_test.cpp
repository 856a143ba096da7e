// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/nodal_description.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "radcert/study/collocation/level_geometry.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

/// The description of u_n = 1 on the cube, all values with the radius 1/8 but that at node 3.
LevelResult described(double radius_at_one_node) {
  const Problem problem = testing::with_emission(testing::sample_problem("cube"), "1/2");
  const TriangleBasis<double> basis = triangle_basis(triangle_basis_of(problem.method));
  const LevelGeometry geometry(problem, 0, basis);
  const std::size_t nodes = geometry.data().nodes.size();
  std::vector<Approximation> u_n(nodes, Approximation::estimated(1, 0.125));
  u_n.at(3).radius = radius_at_one_node;
  const std::vector<double> emission(nodes, 0.5);
  LevelOutcome outcome;
  outcome.result = level_header(
      problem, 0,
      {.elements = geometry.data().triangulation.triangles.size(), .unknowns = nodes, .mesh_size = 1});
  describe_collocation(problem, geometry.data(), basis, {.u_n = u_n, .emission = emission, .u = {}}, outcome);
  return outcome.result;
}

TEST(NodalDescription, TakesTheLargestRadius) {
  const LevelResult level = described(0.25);
  EXPECT_EQ(level.solution_radius, 0.25);
  for (const auto& [piece, mean] : level.piece_means) EXPECT_GE(mean.radius, 0.25) << piece;
}

TEST(NodalDescription, HasNoRadiusWhereOneValueHasNone) {
  for (const double none :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    const LevelResult level = described(none);
    EXPECT_FALSE(level.solution_radius) << none;
    EXPECT_EQ(level.piece_means.size(), 6u);
    for (const auto& [piece, mean] : level.piece_means) EXPECT_FALSE(mean.has_radius()) << piece;
  }
}

}  // namespace
}  // namespace radcert
