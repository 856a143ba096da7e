// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/geometry/mesh_file/mesh_file.h"

namespace radcert {

/// A mesh file whose faces are parallel to the axes, so that those that were to touch do.
struct AlignedFile {
  MeshFile file;
  double degrees = 0;  ///< by which it was turned; 0: not at all
  double moved = 0;    ///< bounds the distance of a corner from where the turn had brought it
};

/// Turns a mesh to the axes and makes coordinates equal that differ by rounding alone.
/// Maths     R is the rotation nearest to the identity that takes to axes the direction of normals that the
///           largest area has, and that with the largest area of those at right angles to it; directions
///           within 10^-3 are one, their mean by area. Of R x, coordinates that follow each other within 8 u
///           become one, u the rounding of the file's coordinates; within 5/2 u where nothing is turned
/// Source    ours. A room that was turned, and written with a few digits, has no two walls in one plane, and
///           what stands against a wall does not touch it: doubles hold neither. Configuration factors are
///           those of the room as it was before it was turned
/// Requires  a file as read_mesh_file returns it
/// Result    none where no two directions are at right angles, where the coordinates of one value would
///           spread over more than that, or where a face would lose a corner, with the reason. What is equal
///           already stays as it is; a mesh that lies along the axes is not turned
/// Limits    another mesh than that of the file: what is proved of it is proved of it. The 256 directions of
///           the largest faces are looked at
[[nodiscard]] Outcome<AlignedFile> aligned(MeshFile file);

}  // namespace radcert
