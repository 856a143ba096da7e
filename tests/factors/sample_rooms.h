// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "radcert/factors/factor_matrix.h"
#include "radcert/geometry/triangle_mesh.h"

namespace radcert::sample {

using Quadrangle = std::array<Vector<double>, 4>;

/// Two triangles for each quadrangle, along its first diagonal; equal points are one vertex.
inline TriangleMesh mesh_of(const std::vector<Quadrangle>& faces) {
  TriangleMesh mesh;
  mesh.group_names = {""};
  std::map<std::array<double, 3>, std::size_t> numbers;
  const auto number = [&](const Vector<double>& p) {
    const auto [at, fresh] = numbers.emplace(std::array<double, 3>{p.x, p.y, p.z}, mesh.vertices.size());
    if (fresh) mesh.vertices.push_back(p);
    return at->second;
  };
  for (const Quadrangle& face : faces)
    for (const std::array<std::size_t, 3>& k : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
      mesh.triangles.push_back({number(face[k[0]]), number(face[k[1]]), number(face[k[2]])});
      mesh.group.push_back(0);
      mesh.face.push_back(mesh.face.size() / 2);
    }
  return mesh;
}

/// The faces of a box: x low, x high, y low, ..., looking outwards or inwards.
inline std::vector<Quadrangle> box(const std::array<double, 3>& low, const std::array<double, 3>& high,
                                   bool inwards) {
  std::vector<Quadrangle> faces;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const auto corner = [&](bool second, bool third) {
        std::array<double, 3> p{};
        p[axis] = upper ? high[axis] : low[axis];
        p[(axis + 1) % 3] = second ? high[(axis + 1) % 3] : low[(axis + 1) % 3];
        p[(axis + 2) % 3] = third ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
        return Vector<double>{p[0], p[1], p[2]};
      };
      const Quadrangle face = upper == inwards ? Quadrangle{corner(false, false), corner(false, true),
                                                            corner(true, true), corner(true, false)}
                                               : Quadrangle{corner(false, false), corner(true, false),
                                                            corner(true, true), corner(false, true)};
      faces.push_back(face);
    }
  return faces;
}

/// A cube of side 1/2 in the unit cube, its lower face so far above the floor.
inline TriangleMesh cube_in_cube(double gap) {
  std::vector<Quadrangle> faces = box({0, 0, 0}, {1, 1, 1}, true);
  for (const Quadrangle& face : box({0.25, 0.25, gap}, {0.75, 0.75, gap + 0.5}, false)) faces.push_back(face);
  return mesh_of(faces);
}

/// The unit cube with two boxes: two of their faces lie in one plane, and their shadows meet.
inline TriangleMesh room_with_two_boxes() {
  std::vector<Quadrangle> faces = box({0, 0, 0}, {1, 1, 1}, true);
  for (const Quadrangle& face : box({0.125, 0.25, 0.25}, {0.375, 0.5, 0.75}, false)) faces.push_back(face);
  for (const Quadrangle& face : box({0.5, 0.25, 0.125}, {0.75, 0.625, 0.5}, false)) faces.push_back(face);
  return mesh_of(faces);
}

/// Unit squares z = 0 looking up and z = 1 looking down, and the square [0, 1/2]^2 at z = 1/2.
inline TriangleMesh obstructed_squares() {
  return mesh_of({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                  {{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}},
                  {{{0, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0.5}, {0, 0.5, 0.5}}}});
}

/// The same squares, and at z = 1/2 a wall over [0,1]^2 with the hole [1/4, 5/8] x [3/8, 3/4], or the plug
/// that fits it.
inline TriangleMesh squares_past_a_wall(bool plug) {
  std::vector<Quadrangle> faces{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                                {{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}}};
  const std::array<double, 4> x{0, 0.25, 0.625, 1};
  const std::array<double, 4> y{0, 0.375, 0.75, 1};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if ((i == 1 && j == 1) == plug)
        faces.push_back(
            {{{x[i], y[j], 0.5}, {x[i + 1], y[j], 0.5}, {x[i + 1], y[j + 1], 0.5}, {x[i], y[j + 1], 0.5}}});
  return mesh_of(faces);
}

/// A unit for each two triangles, as mesh_of makes them.
inline FactorUnits by_face(const TriangleMesh& mesh) {
  FactorUnits units;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    units.of_triangle.push_back(t / 2);
    if (t % 2 == 0) units.names.push_back("face " + std::to_string(t / 2));
  }
  return units;
}

}  // namespace radcert::sample
