// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/geometry/triangle_mesh.h"
#include "radcert/visibility/scene.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert::sample {

/// Numbers for tests: the raw stream and own mappings.
class Numbers {
public:
  explicit Numbers(unsigned seed) : stream_(seed) {}
  /// In [0,1).
  double fraction() { return static_cast<double>(stream_() >> 11U) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * fraction(); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(stream_() % count); }
  /// A multiple of 1/steps in [0,1].
  double on_grid(std::size_t steps) {
    return static_cast<double>(below(steps + 1)) / static_cast<double>(steps);
  }

private:
  std::mt19937_64 stream_;
};

/// A box that looks outwards, each side cut into n by n squares.
inline Polyhedron grid_box(const Vector<double>& low, const Vector<double>& high, std::size_t n = 1) {
  Polyhedron out;
  const auto at = [&](double a, double b, std::size_t k) {
    return k == n ? b : a + (b - a) * (static_cast<double>(k) / static_cast<double>(n));
  };
  const auto coordinate = [](const Vector<double>& v, std::size_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t first = (axis + 1) % 3;
    const std::size_t second = (axis + 2) % 3;
    for (const bool upper : {false, true}) {
      const std::size_t begin = out.vertices.size();
      for (std::size_t i = 0; i <= n; ++i)
        for (std::size_t j = 0; j <= n; ++j) {
          std::array<double, 3> x{};
          x[axis] = coordinate(upper ? high : low, axis);
          x[first] = at(coordinate(low, first), coordinate(high, first), i);
          x[second] = at(coordinate(low, second), coordinate(high, second), j);
          out.vertices.push_back({x[0], x[1], x[2]});
        }
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          const std::size_t a = begin + i * (n + 1) + j;
          const std::size_t b = a + n + 1;
          if (upper) {
            out.faces.push_back({a, b, b + 1, a + 1});
          } else {
            out.faces.push_back({a, a + 1, b + 1, b});
          }
        }
    }
  }
  return out;
}

inline Polyhedron turned(Polyhedron body) {
  for (auto& face : body.faces) std::reverse(face.begin(), face.end());
  return body;
}

inline Polyhedron both(Polyhedron a, const Polyhedron& b) {
  const std::size_t begin = a.vertices.size();
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (auto face : b.faces) {
    for (std::size_t& v : face) v += begin;
    a.faces.push_back(std::move(face));
  }
  return a;
}

/// The faces, each from its first corner as a fan.
inline TriangleMesh fans_of(const Polyhedron& body) {
  TriangleMesh mesh;
  mesh.vertices = body.vertices;
  for (const auto& face : body.faces)
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      mesh.triangles.push_back({face[0], face[k], face[k + 1]});
  mesh.group.assign(mesh.triangles.size(), 0);
  mesh.group_names = {""};
  mesh.face.assign(mesh.triangles.size(), 0);
  return mesh;
}

inline Scene cube_room() { return Scene(fans_of(turned(cube()))); }

inline Scene l_room() {
  TriangleMesh mesh = mesh_of(turned(l_shaped_room()));
  return Scene(std::move(mesh));
}

/// A cube in a cube: the inner one stands away from the floor of the outer one by the gap.
inline Scene cube_in_cube(double gap) {
  return Scene(fans_of(
      both(turned(grid_box({0, 0, 0}, {1, 1, 1})), grid_box({0.25, 0.25, gap}, {0.75, 0.75, gap + 0.5}))));
}

/// Squares that look at each other, and an opaque one between that looks up: triangles 0, 1 below, 2, 3
/// above, 4, 5 between.
inline Scene occluded_squares() {
  Polyhedron out{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                 {{0, 1, 2, 3}, {4, 7, 6, 5}}};
  return Scene(
      fans_of(both(out, {{{0, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0.5}, {0, 0.5, 0.5}}, {{0, 1, 2, 3}}})));
}

/// Boxes in the cells of a 3 by 3 by 3 grid of the unit cube: on the grid of 1/32, or anywhere.
inline Scene boxes_in_box(unsigned seed, bool on_grid, std::size_t most = 8, std::size_t wall_squares = 1) {
  Numbers random(seed);
  Polyhedron all = turned(grid_box({0, 0, 0}, {1, 1, 1}, wall_squares));
  std::vector<std::size_t> cells(27);
  for (std::size_t k = 0; k < 27; ++k) cells[k] = k;
  for (std::size_t k = 0; k < most; ++k) {
    std::swap(cells[k], cells[k + random.below(27 - k)]);
    const auto interval = [&](std::size_t cell) {
      // Cell c is (1 + 10 c, 11 + 10 c) / 32.
      const double begin = 1 + 10 * static_cast<double>(cell);
      if (on_grid) {
        const double low = begin + static_cast<double>(1 + random.below(4));
        return std::pair{low / 32, (low + static_cast<double>(1 + random.below(4))) / 32};
      }
      const double low = begin + random.between(0.5, 5);
      return std::pair{low / 32, (low + random.between(0.01, 4.5)) / 32};
    };
    const auto [x0, x1] = interval(cells[k] % 3);
    const auto [y0, y1] = interval(cells[k] / 3 % 3);
    const auto [z0, z1] = interval(cells[k] / 9);
    all = both(std::move(all), grid_box({x0, y0, z0}, {x1, y1, z1}));
  }
  return Scene(fans_of(all));
}

inline Vector<double> normal_of(const Scene& scene, std::size_t triangle) {
  const auto [a, b, c] = scene.corners(triangle);
  return cross(b - a, c - a);
}

/// A point of a triangle, rounded.
inline Vector<double> point_of(const Scene& scene, std::size_t triangle, double s, double t) {
  const auto [a, b, c] = scene.corners(triangle);
  return a + s * (b - a) + t * (c - a);
}

/// A point of a triangle, its weights multiples of 1/steps and none 0 where inside.
inline ParameterPoint<double> random_parameters(Numbers& random, std::size_t steps) {
  const std::size_t i = 1 + random.below(steps - 2);
  const std::size_t j = 1 + random.below(steps - 1 - i);
  return {static_cast<double>(i) / static_cast<double>(steps),
          static_cast<double>(j) / static_cast<double>(steps)};
}

}  // namespace radcert::sample
