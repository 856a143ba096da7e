// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/geometry/mesh_file/face_triangulation.h"
#include "radcert/geometry/mesh_file/mesh_file.h"
#include "radcert/geometry/triangle_mesh.h"

namespace radcert::sample {

/// Vertices and faces as they stand in a file.
struct Polyhedron {
  std::vector<Vector<double>> vertices;
  std::vector<std::vector<std::size_t>> faces;
};

inline std::string off_text(const Polyhedron& polyhedron) {
  std::string out = "OFF\n" + std::to_string(polyhedron.vertices.size()) + " " +
                    std::to_string(polyhedron.faces.size()) + " 0\n";
  for (const Vector<double>& v : polyhedron.vertices)
    out += shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z) + "\n";
  for (const auto& face : polyhedron.faces) {
    out += std::to_string(face.size());
    for (const std::size_t v : face) out += " " + std::to_string(v);
    out += "\n";
  }
  return out;
}

inline TriangleMesh mesh_of(const Polyhedron& polyhedron) {
  return triangulate_faces(parse_mesh_file(off_text(polyhedron), "sample.off")).mesh;
}

/// The faces run counterclockwise as seen from outside, here and below.
inline Polyhedron cube() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

inline Polyhedron tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// `top` is the height of the upper vertex: 1 makes it regular, a negative one dents it.
inline Polyhedron octahedron(double top = 1) {
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, top}, {0, 0, -1}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
}

/// A column over a polygon of the plane, its lower side first.
inline Polyhedron column(const std::vector<std::pair<double, double>>& base, double height) {
  Polyhedron out;
  const std::size_t n = base.size();
  for (const double z : {0.0, height})
    for (const auto& [x, y] : base) out.vertices.push_back({x, y, z});
  std::vector<std::size_t> floor;
  std::vector<std::size_t> ceiling;
  for (std::size_t i = 0; i < n; ++i) {
    floor.push_back(n - 1 - i);
    ceiling.push_back(n + i);
    out.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  out.faces.push_back(floor);
  out.faces.push_back(ceiling);
  return out;
}

inline Polyhedron l_shaped_room() { return column({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1); }

/// Both as one, no vertex shared; `turned` reverses the triangles of the second.
inline Polyhedron together(const Polyhedron& first, const Polyhedron& second, bool turned) {
  Polyhedron out = first;
  out.vertices.insert(out.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (std::vector<std::size_t> face : second.faces) {
    for (std::size_t& v : face) v += first.vertices.size();
    if (turned) std::reverse(face.begin(), face.end());
    out.faces.push_back(face);
  }
  return out;
}

/// The unit cube as a room with a cube of the given side in it, its lowest corner at `at`.
inline Polyhedron cube_in_cube(double side, const Vector<double>& at, bool turned = true) {
  Polyhedron inner = cube();
  for (Vector<double>& v : inner.vertices) v = at + side * v;
  return together(cube(), inner, turned);
}

inline Polyhedron cylinder(int sides) {
  std::vector<std::pair<double, double>> base;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    base.emplace_back(std::cos(angle), std::sin(angle));
  }
  return column(base, 1);
}

/// The octahedron, each triangle divided into four and pushed out to the sphere, several times.
inline Polyhedron sphere(int level) {
  Polyhedron out = octahedron();
  for (int k = 0; k < level; ++k) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    std::vector<std::vector<std::size_t>> finer;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [at, added] = middles.try_emplace(std::minmax(a, b), out.vertices.size());
      if (added) {
        const Vector<double> sum = out.vertices[a] + out.vertices[b];
        out.vertices.push_back((1 / norm(sum)) * sum);
      }
      return at->second;
    };
    for (const auto& f : out.faces) {
      const std::size_t ab = middle(f[0], f[1]);
      const std::size_t bc = middle(f[1], f[2]);
      const std::size_t ca = middle(f[2], f[0]);
      finer.insert(finer.end(), {{f[0], ab, ca}, {ab, f[1], bc}, {ca, bc, f[2]}, {ab, bc, ca}});
    }
    out.faces = std::move(finer);
  }
  return out;
}

/// A grid of n by m squares whose sides are glued; `crooked` glues one pair the other way round, as in
/// Klein's bottle.
inline Polyhedron glued_grid(std::size_t n, std::size_t m, bool crooked) {
  Polyhedron out;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const double u = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      const double v = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(m);
      out.vertices.push_back({(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)});
    }
  const auto at = [&](std::size_t i, std::size_t j) {
    const bool around = i == n;
    const std::size_t row = j % m;
    return (i % n) * m + (around && crooked ? (m - row) % m : row);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      out.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      out.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return out;
}

}  // namespace radcert::sample
