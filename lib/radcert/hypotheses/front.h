// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/geometry/mesh_defects.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/triangle_mesh.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// How the front of a triangle, where light travels, follows from the order of its corners.
enum class FrontRule {
  automatic,   ///< closed scenes: the inside; open ones: right_hand
  right_hand,  ///< the side from which the corners run counterclockwise, that of the cross product
  left_hand,   ///< the other
};

/// The rules' words, in the order of FrontRule.
inline constexpr std::array<std::string_view, 3> front_words = {"auto", "right-hand", "left-hand"};

/// How the front of a mesh was found.
enum class InnerSide {
  by_volume,  ///< the mesh is closed, and a room: its inside
  by_file,    ///< as the file has it, by the right-hand rule
  by_choice,  ///< as was asked for
};

/// Where the light of a mesh is.
/// Result    encloses: no light leaves. misoriented: first triangles of components whose front is on a side
///           where the fronts of the others say that there is no light; of closed meshes that do not cross
///           themselves. undecided: both readings in words, where the mesh is not accepted without a rule
struct MeshFront {
  Orientation orientation = Orientation::along_the_cross_product;
  InnerSide known_by = InnerSide::by_file;
  bool encloses = false;
  std::vector<std::size_t> misoriented;
  std::optional<std::string> undecided;
};

/// Decides where the front of a mesh is, or that its file does not say.
/// Maths     a closed mesh is read as a room: its front is the inside, told by the sign of its volume; with a
///           rule, what is left is whether the light is within (misoriented_components) or around the bodies,
///           and leaves. Of an open mesh the file is trusted. Undecided are closed bodies beside each other
///           whose triangles run counterclockwise as seen from outside: rooms of their own, or what stands in
///           the open; bodies whose volumes cancel; and meshes without an open edge, but with edges of more
///           than two triangles, unless each edge has as many triangles one way as the other and the
///           right-hand rule has the light inside, which misoriented_components tells as well
/// Source    ours
/// Requires  the topology and the defects of this mesh
/// Result    vertices with equal coordinates count as one; exact
[[nodiscard]] MeshFront mesh_front(const TriangleMesh& mesh, const MeshTopology& topology,
                                   const MeshDefects& defects, FrontRule rule);

}  // namespace radcert
