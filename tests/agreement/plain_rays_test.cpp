// SPDX-License-Identifier: GPL-3.0-or-later
// Configuration factors by rays against a plain ray caster.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "apps/bench/plain_rays.h"
#include "radcert/factors/ray_factors.h"

namespace radcert {
namespace {

/// A cube of the side 3, seen from inside, and one of the side 1 within it, a group for each face.
TriangleMesh nested_cubes() {
  TriangleMesh mesh;
  for (const bool inner : {false, true})
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        const double low = inner ? 0.5 : 0;
        const double high = inner ? 1.5 : 3;
        const std::size_t begin = mesh.vertices.size();
        for (const auto& [s, t] : std::array<std::array<double, 2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) {
          std::array<double, 3> x{};
          x[axis] = upper ? high : low;
          x[(axis + 1) % 3] = low + s * (high - low);
          x[(axis + 2) % 3] = low + t * (high - low);
          mesh.vertices.push_back({x[0], x[1], x[2]});
        }
        const bool turned = upper != inner;
        for (const std::size_t k : {1U, 2U})
          mesh.triangles.push_back({begin, begin + (turned ? k + 1 : k), begin + (turned ? k : k + 1)});
        mesh.group.insert(mesh.group.end(), 2, mesh.group_names.size());
        mesh.face.insert(mesh.face.end(), 2, mesh.group_names.size());
        mesh.group_names.push_back("face " + std::to_string(mesh.group_names.size()));
      }
  return mesh;
}

TEST(PlainRays, AgreeWithRays) {
  const TriangleMesh mesh = nested_cubes();
  const FacetScene scene(mesh);
  const FactorUnits units{.of_triangle = mesh.group, .names = mesh.group_names};
  const FactorMatrix matrix = ray_factors(scene, units, {.accuracy = 1e-3}, {});
  for (const std::size_t row : {0U, 3U, 7U}) {
    constexpr std::size_t rays = 40000;
    const bench::PlainRow plain = bench::plain_factor_row(mesh, row, rays);
    double sum = 0;
    for (const ConfigurationFactor& entry : matrix.entries) {
      if (entry.from != row) continue;
      sum += entry.factor.value;
      EXPECT_NEAR(entry.factor.value, plain.factors[entry.to],
                  entry.factor.radius + 5 * plain.errors[entry.to] + 10.0 / rays)
          << row << " to " << entry.to;
    }
    EXPECT_NEAR(sum, 1, 2e-3);
  }
}

}  // namespace
}  // namespace radcert
