// SPDX-License-Identifier: GPL-3.0-or-later
// Configuration factors: the whole matrix of a cube of 768 triangles, one row of a room with boxes in it, and
// by rays a furnished room, beside a plain ray caster.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "plain_rays.h"
#include "radcert/factors/factor_matrix.h"
#include "radcert/factors/factor_mesh.h"
#include "radcert/factors/ray_factors.h"
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

/// Every triangle so far that has no group goes to a new one.
void name_group(TriangleMesh& mesh, const std::string& name) {
  mesh.group_names.push_back(name);
  mesh.group.resize(mesh.triangles.size(), mesh.group_names.size() - 1);
  mesh.face.resize(mesh.triangles.size(), 0);
}

/// A room of 4 by 4 by 3 with four boxes, 1536 triangles, coordinates with few binary digits; a group each.
TriangleMesh boxes_in_room() {
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {4, 4, 3}, 8, true);
  name_group(mesh, "room");
  constexpr std::size_t fine = 4;
  add_box(mesh, {0.5, 0.5, 0.25}, {1.25, 1, 1}, fine, false);
  name_group(mesh, "chest");
  add_box(mesh, {2, 2.25, 0.5}, {3, 3, 1.25}, fine, false);
  name_group(mesh, "shelf");
  add_box(mesh, {2.5, 0.5, 1}, {3.25, 1.5, 2}, fine, false);
  name_group(mesh, "board");
  add_box(mesh, {0.75, 2.5, 1.25}, {1.5, 3.25, 2.5}, fine, false);
  name_group(mesh, "locker");
  return mesh;
}

/// A ball of flat triangles, looking outwards: 2 around (bands - 1) of them.
void add_ball(TriangleMesh& mesh, const Vector<double>& centre, double radius, std::size_t around,
              std::size_t bands) {
  const std::size_t begin = mesh.vertices.size();
  const auto at = [&](std::size_t band, std::size_t turn) {
    const double polar = std::numbers::pi * static_cast<double>(band) / static_cast<double>(bands);
    const double angle = 2 * std::numbers::pi * static_cast<double>(turn) / static_cast<double>(around);
    return centre + radius * Vector<double>{std::sin(polar) * std::cos(angle),
                                            std::sin(polar) * std::sin(angle), std::cos(polar)};
  };
  mesh.vertices.push_back(centre + Vector<double>{0, 0, radius});
  for (std::size_t band = 1; band < bands; ++band)
    for (std::size_t turn = 0; turn < around; ++turn) mesh.vertices.push_back(at(band, turn));
  mesh.vertices.push_back(centre - Vector<double>{0, 0, radius});
  const std::size_t last = mesh.vertices.size() - 1;
  const auto ring = [&](std::size_t band, std::size_t turn) {
    return begin + 1 + (band - 1) * around + turn % around;
  };
  for (std::size_t turn = 0; turn < around; ++turn) {
    mesh.triangles.push_back({begin, ring(1, turn), ring(1, turn + 1)});
    for (std::size_t band = 1; band + 1 < bands; ++band) {
      mesh.triangles.push_back({ring(band, turn), ring(band + 1, turn), ring(band + 1, turn + 1)});
      mesh.triangles.push_back({ring(band, turn), ring(band + 1, turn + 1), ring(band, turn + 1)});
    }
    mesh.triangles.push_back({ring(bands - 1, turn), last, ring(bands - 1, turn + 1)});
  }
}

/// The same with four balls: 6432 triangles in nine groups.
TriangleMesh furnished_room() {
  TriangleMesh mesh = boxes_in_room();
  constexpr std::size_t around = 36;
  constexpr std::size_t bands = 18;
  add_ball(mesh, {2, 2, 2.5}, 0.25, around, bands);
  name_group(mesh, "lamp");
  add_ball(mesh, {3.25, 3.25, 1.5}, 0.125, around, bands);
  name_group(mesh, "globe");
  add_ball(mesh, {1.75, 0.75, 0.5}, 0.375, around, bands);
  name_group(mesh, "pouf");
  add_ball(mesh, {0.625, 1.75, 0.5}, 0.3125, around, bands);
  name_group(mesh, "vase");
  return mesh;
}

/// The factors between its groups by rays: the argument is the power of ten of the accuracy.
void rays_of_room(benchmark::State& state) {
  const TriangleMesh mesh = furnished_room();
  const FacetScene scene(mesh);
  const FactorUnits units{.of_triangle = mesh.group, .names = mesh.group_names};
  FactorMatrix matrix;
  for (auto step : state)
    matrix = ray_factors(scene, units, {.accuracy = std::pow(10, -static_cast<double>(state.range(0)))}, {});
  double radius = 0;
  for (const ConfigurationFactor& entry : matrix.entries) radius = std::max(radius, entry.factor.radius);
  state.counters["triangles"] = static_cast<double>(scene.facet_count());
  state.counters["rays"] = static_cast<double>(matrix.rays);
  state.counters["radius"] = radius;
}
BENCHMARK(rays_of_room)
    ->ArgName("accuracy 10^-")
    ->Arg(3)
    ->Arg(4)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The same by the plain ray caster: its time for few rays, and how many it would need for a radius of 1e-4.
void plain_rays_of_room(benchmark::State& state) {
  const TriangleMesh mesh = furnished_room();
  constexpr std::size_t rays = 3000;
  constexpr double quantile = 3.9;  // what one normal number in 10,000 exceeds
  double needed = 0;
  for (auto step : state) {
    needed = 0;
    for (std::size_t group = 0; group < mesh.group_names.size(); ++group) {
      const std::vector<double> errors = plain_factor_row(mesh, group, rays).errors;
      const double radius = quantile * *std::max_element(errors.begin(), errors.end());
      needed += rays * (radius / 1e-4) * (radius / 1e-4);
    }
  }
  state.counters["rays"] = static_cast<double>(rays * mesh.group_names.size());
  state.counters["rays to 1e-4"] = needed;
}
BENCHMARK(plain_rays_of_room)->Unit(benchmark::kMillisecond);

/// A row of it: the argument is the binary exponent of the accuracy.
void row_of_room(benchmark::State& state) {
  const FacetScene scene(boxes_in_room());
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
