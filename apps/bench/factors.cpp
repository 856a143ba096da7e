// SPDX-License-Identifier: GPL-3.0-or-later
// Configuration factors: the whole matrix of a cube of 768 triangles, and one row of a room with boxes in it.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "radcert/factors/factor_matrix.h"
#include "radcert/factors/factor_mesh.h"
#include "radcert/surface/catalogue.h"

namespace radcert::bench {
namespace {

void matrix_of_cube(benchmark::State& state) {
  constexpr int level = 3;
  const FactorMesh mesh = factor_mesh(find_surface("cube")->make({}), level);
  const FacetScene scene(mesh.mesh);
  const FactorUnits units = factor_units(mesh, FactorUnit::triangle);
  double defect = 0;
  for (auto step : state) {
    const FactorMatrix matrix = factor_matrix(scene, units, {}, {});
    defect = matrix.closure_defect(matrix.worst_row());
  }
  state.counters["triangles"] = static_cast<double>(scene.facet_count());
  state.counters["closure"] = defect;
}
BENCHMARK(matrix_of_cube)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The faces of a box, each cut into 2 n^2 triangles, looking outwards or inwards.
void add_box(TriangleMesh& mesh, const std::array<double, 3>& low, const std::array<double, 3>& high,
             std::size_t n, bool inwards) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const std::size_t begin = mesh.vertices.size();
      const std::size_t first = (axis + 1) % 3;
      const std::size_t second = (axis + 2) % 3;
      const auto between = [&](std::size_t k, std::size_t along) {
        const double part = static_cast<double>(k) / static_cast<double>(n);
        return low[along] + part * (high[along] - low[along]);
      };
      for (std::size_t i = 0; i <= n; ++i)
        for (std::size_t j = 0; j <= n; ++j) {
          std::array<double, 3> x{};
          x[axis] = upper ? high[axis] : low[axis];
          x[first] = between(i, first);
          x[second] = between(j, second);
          mesh.vertices.push_back({x[0], x[1], x[2]});
        }
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          std::size_t a = begin + i * (n + 1) + j;
          std::size_t b = a + 1;
          std::size_t across = a + n + 2;
          std::size_t d = a + n + 1;
          if (upper != inwards) std::swap(b, d);
          mesh.triangles.push_back({a, b, across});
          mesh.triangles.push_back({a, across, d});
        }
    }
}

/// A room of 4 by 4 by 3 with four boxes, 1536 triangles, coordinates with few binary digits.
FacetScene room() {
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {4, 4, 3}, 8, true);
  constexpr std::size_t fine = 4;
  add_box(mesh, {0.5, 0.5, 0.25}, {1.25, 1, 1}, fine, false);
  add_box(mesh, {2, 2.25, 0.5}, {3, 3, 1.25}, fine, false);
  add_box(mesh, {2.5, 0.5, 1}, {3.25, 1.5, 2}, fine, false);
  add_box(mesh, {0.75, 2.5, 1.25}, {1.5, 3.25, 2.5}, fine, false);
  mesh.group.assign(mesh.triangles.size(), 0);
  mesh.group_names = {""};
  mesh.face.assign(mesh.triangles.size(), 0);
  return FacetScene(std::move(mesh));
}

/// A row of it: the argument is the binary exponent of the accuracy.
void row_of_room(benchmark::State& state) {
  const FacetScene scene = room();
  double accuracy = 1;
  for (std::int64_t k = 0; k < state.range(0); ++k) accuracy /= 2;
  constexpr std::size_t row = 5;
  Approximation sum = Approximation::exact(0);
  for (auto step : state) {
    sum = {};
    for (std::size_t k = 0; k < scene.facet_count(); ++k)
      if (k != row) sum += pair_exchange(scene, row, k, {.accuracy = accuracy}).area;
  }
  state.counters["triangles"] = static_cast<double>(scene.facet_count());
  state.counters["row sum less 1"] = sum.value / scene.area(row) - 1;
  state.counters["radius"] = sum.radius / scene.area(row);
}
BENCHMARK(row_of_room)->ArgName("accuracy 2^-")->Arg(17)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace radcert::bench
