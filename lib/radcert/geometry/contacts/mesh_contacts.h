// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// Two groups of a mesh that touch in a plane.
struct MeshContact {
  std::string one;  ///< names of the groups, "" for what has no name
  std::string other;
  double area = 0;  ///< of what they cover of each other, rounded
};

/// A mesh without the parts of its faces that other bodies cover.
struct UncoveredMesh {
  TriangleMesh mesh;
  std::vector<MeshContact> contacts;
  std::size_t cut = 0;  ///< triangles that lose nothing and are cut along sides of others that lie in them
  [[nodiscard]] bool is_as_it_was() const { return contacts.empty() && cut == 0; }
};

/// Takes out of a mesh where a body stands on a face: a cupboard on a floor, a box against a wall. Cuts faces
/// that others stand on with a side alone, a partition on a floor, along that.
/// Maths     in each plane let A and B be the unions of triangles of opposite sides that overlap, pair by
///           pair of different sets of triangles, of which one at least is a body: closed, its front outside.
///           A becomes A minus B, B becomes B minus A. Proof that nothing leaves or arrives there: where both
///           are, the front of the one looks into the body of the other, and the front of that one at the
///           back of the first, which hides from both sides. Proof that nothing passes there that did not:
///           a body that touches something holds nothing, all else having no point inside it. So no ray
///           begins within bodies that touch, and none enters where they cover each other alone. What a
///           body covers of an open face opens the body to what is behind that face; a ray that comes in
///           must leave through another plane that is opened so. What it covers of a room that holds all
///           else, but for what lies on its walls, opens it to the outside, where nothing is but other
///           bodies that are opened so. Bodies with two planes of open faces, or one and walls in another,
///           with something beyond, are refused. Two sides of a plate without thickness are no body, and
///           stay
/// Source    ours; polygon differences by a constrained Delaunay triangulation of CGAL whose sides are cut
///           where they cross, exactly; what is inside of what by RayCrossings
/// Requires  no degenerate triangle. right_hand: the front is the side from which the corners run
///           counterclockwise
/// Result    exact: triangles that overlap nothing are as they were, in their order; the others are cut
///           anew, each with group and face of one that held it, behind them, and joined_sides cuts those on
///           whose sides others end now; vertices with equal coordinates are one. A reason where light would
///           pass through a body or reach what is inside, or a difference has a corner that no doubles hold,
///           for then no plane would hold it either; the mesh as it was where more than a million pairs of
///           triangles meet
/// Limits    overlapping triangles of one side, and bodies that cross, stay as they are
[[nodiscard]] Outcome<UncoveredMesh> without_contacts(const TriangleMesh& mesh, bool right_hand);

}  // namespace radcert
