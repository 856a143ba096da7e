// SPDX-License-Identifier: GPL-3.0-or-later
// Exact visibility: what V(P,Q) costs among many triangles, and what a point's view of a triangle costs, by
// how much is seen, in a room with boxes in it.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "radcert/visibility/point_view.h"
#include "radcert/visibility/visibility.h"

namespace radcert::bench {
namespace {

class Numbers {
public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(stream_() >> 11U) * 0x1p-53);
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(stream_() % count); }

private:
  std::mt19937_64 stream_{1};
};

/// Adds a box, each face cut into 2 n^2 triangles, that looks outwards or inwards.
void add_box(TriangleMesh& mesh, const std::array<double, 3>& low, const std::array<double, 3>& high,
             std::size_t n, bool inwards) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      const std::size_t begin = mesh.vertices.size();
      const std::size_t first = (axis + 1) % 3;
      const std::size_t second = (axis + 2) % 3;
      const auto at = [&](std::size_t k, std::size_t along) {
        return k == n ? high[along]
                      : low[along] +
                            (high[along] - low[along]) * (static_cast<double>(k) / static_cast<double>(n));
      };
      for (std::size_t i = 0; i <= n; ++i)
        for (std::size_t j = 0; j <= n; ++j) {
          std::array<double, 3> x{};
          x[axis] = upper ? high[axis] : low[axis];
          x[first] = at(i, first);
          x[second] = at(j, second);
          mesh.vertices.push_back({x[0], x[1], x[2]});
        }
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          const std::size_t a = begin + i * (n + 1) + j;
          const std::size_t b = a + n + 1;
          if (upper != inwards) {
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
          } else {
            mesh.triangles.push_back({a, b + 1, b});
            mesh.triangles.push_back({a, a + 1, b + 1});
          }
        }
    }
  }
}

/// The unit cube, and a box in each of 20 cells of a grid of 3 by 3 by 3.
Scene room(std::size_t wall_squares) {
  TriangleMesh mesh;
  Numbers random;
  add_box(mesh, {0, 0, 0}, {1, 1, 1}, wall_squares, true);
  constexpr std::size_t boxes = 20;
  for (std::size_t k = 0; k < boxes; ++k) {
    std::array<double, 3> low{};
    std::array<double, 3> high{};
    const std::array<std::size_t, 3> cell{k % 3, k / 3 % 3, k / 9};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = (static_cast<double>(cell[axis]) + random.between(0.05, 0.4)) / 3;
      high[axis] = (static_cast<double>(cell[axis]) + random.between(0.5, 0.95)) / 3;
    }
    add_box(mesh, low, high, 1, false);
  }
  mesh.group.assign(mesh.triangles.size(), 0);
  mesh.group_names = {""};
  mesh.face.assign(mesh.triangles.size(), 0);
  return Scene(std::move(mesh));
}

ScenePoint point(const Scene& scene, Numbers& random) {
  const std::size_t triangle = random.below(scene.triangle_count());
  const auto [a, b, c] = scene.corners(triangle);
  return {a + random.between(0, 0.5) * (b - a) + random.between(0, 0.5) * (c - a), triangle};
}

/// One query on about 10,000 triangles.
void line_of_sight(benchmark::State& state) {
  const Scene scene = room(static_cast<std::size_t>(state.range(0)));
  Numbers random;
  std::vector<std::pair<ScenePoint, ScenePoint>> pairs;
  constexpr std::size_t count = 10000;
  for (std::size_t k = 0; k < count; ++k) pairs.emplace_back(point(scene, random), point(scene, random));
  std::size_t k = 0;
  for (auto step : state) {
    benchmark::DoNotOptimize(visible(scene, pairs[k].first, pairs[k].second));
    k = (k + 1) % count;
  }
  state.counters["triangles"] = static_cast<double>(scene.triangle_count());
}
BENCHMARK(line_of_sight)->ArgName("wall squares")->Arg(12)->Arg(28);

/// One pair of a point and a triangle of which nothing (0), a part (1) or the whole (2) is seen.
void view_of_triangle(benchmark::State& state) {
  const Scene scene = room(12);
  const auto sight = static_cast<Sight>(state.range(0));
  Numbers random;
  struct View {
    std::unique_ptr<PointView> view;
    std::vector<std::size_t> triangles;
  };
  std::vector<View> views;
  std::size_t pairs = 0;
  constexpr int points = 8;
  for (int k = 0; k < points; ++k) {
    const ScenePoint p = point(scene, random);
    const auto [a, b, c] = scene.corners(*p.triangle);
    View one{std::make_unique<PointView>(scene, Viewpoint{p.at, cross(b - a, c - a), p.triangle}), {}};
    for (std::size_t t = 0; t < scene.triangle_count(); ++t)
      if (one.view->region(t).sight == sight) one.triangles.push_back(t);
    pairs += one.triangles.size();
    views.push_back(std::move(one));
  }
  std::size_t done = 0;
  for (auto step : state) {
    for (View& one : views) {
      for (const std::size_t t : one.triangles) {
        const VisibleRegion region = one.view->region(t);
        benchmark::DoNotOptimize(region.parts.data());
      }
    }
    done += pairs;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(done));
  state.counters["triangles"] = static_cast<double>(scene.triangle_count());
}
BENCHMARK(view_of_triangle)->ArgName("sight")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace radcert::bench
