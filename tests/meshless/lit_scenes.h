// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"
#include "radcert/surface/mesh_surface.h"

namespace radcert::test {

/// An axis-parallel box by twelve triangles whose cross products point outwards, or inwards.
inline void add_box(TriangleMesh& mesh, const Vector<double>& low, const Vector<double>& high,
                    bool outwards) {
  const std::size_t first = mesh.vertices.size();
  for (const double z : {low.z, high.z})
    for (const double y : {low.y, high.y})
      for (const double x : {low.x, high.x}) mesh.vertices.push_back({x, y, z});
  // Corner k has the bits of x, y, z; each face counterclockwise from outside.
  constexpr std::array<std::array<std::size_t, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& [a, b, c, d] : faces) {
    if (outwards) {
      mesh.triangles.push_back({first + a, first + b, first + c});
      mesh.triangles.push_back({first + a, first + c, first + d});
    } else {
      mesh.triangles.push_back({first + a, first + c, first + b});
      mesh.triangles.push_back({first + a, first + d, first + c});
    }
  }
}

inline constexpr Vector<double> block_low{1.25, 1.5, 0.5};
inline constexpr Vector<double> block_high{2.0, 2.25, 1.75};

/// The room [0,4] x [0,3] x [0,2.5] with a block that floats in it; light is in between.
inline Surface room_with_block() {
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {4, 3, 2.5}, true);
  add_box(mesh, block_low, block_high, false);
  std::vector<std::size_t> pieces(24, 0);
  for (std::size_t k = 12; k < 24; ++k) pieces[k] = 1;
  const std::vector<std::string> names{"walls", "block"};
  return mesh_surface("room", mesh, pieces, names,
                      {.orientation = Orientation::against_the_cross_product, .closed = true});
}

}  // namespace radcert::test
