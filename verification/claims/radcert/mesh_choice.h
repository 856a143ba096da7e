// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "radcert/study/problem.h"
#include "radcert/surface/mesh_surface.h"

namespace radcert::verification::radcert {

/// A mesh that a claim makes, as the surface of a problem.
/// Requires  as mesh_surface; a name that no other mesh has, by which results are stored
inline SurfaceChoice mesh_choice(const std::string& name, const TriangleMesh& mesh,
                                 const std::vector<std::size_t>& piece_of_triangle,
                                 const std::vector<std::string>& pieces, const MeshFacts& facts) {
  return {.name = name,
          .parameters = {},
          .mesh = MeshChoice{.file = name,
                             .digest = name,
                             .angle = 20,
                             .repair = {},
                             .mended = {},
                             .surface = std::make_shared<const Surface>(
                                 mesh_surface(name, mesh, piece_of_triangle, pieces, facts))}};
}

}  // namespace radcert::verification::radcert
