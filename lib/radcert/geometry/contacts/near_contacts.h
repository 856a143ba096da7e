// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// Two groups of a mesh that face each other across next to nothing.
struct NearContact {
  std::string one;  ///< names of the groups, "" for what has no name
  std::string other;
  double gap = 0;  ///< the largest distance of a corner of the one from the plane of the other, rounded
  Vector<double> at =
      {};                 ///< a point of what the two triangles with the least gap have before them in common
  std::size_t pairs = 0;  ///< of triangles that face each other so
  bool may_be_rounding = false;  ///< whether the digits of the file leave the gap open
};

/// Where faces of a mesh probably were meant to touch, and rounded coordinates leave a gap.
/// Maths     pairs of triangles of different planes whose fronts look at each other, of which the one lies
///           in front of the other's plane, its corners at most g away, and that overlap, seen along the
///           normal, by more than g in each direction; g = 10^-9 times the diagonal of the mesh, or 8
///           times the rounding of its coordinates where that is more
/// Source    ours: such a gap is no contact for without_contacts, which asks for equality; what lies between
///           takes part in the exchange of light
/// Requires  no degenerate triangle. right_hand: see without_contacts; precision: of MeshFile
/// Result    of each two groups the pair of triangles with the least gap, and how many pairs there are, in
///           the order of the groups
/// Limits    a remark for the reader, decided in doubles: nothing is changed
[[nodiscard]] std::vector<NearContact> near_contacts(const TriangleMesh& mesh, bool right_hand,
                                                     double precision);

/// What coordinates are off by where a file's precision tells of rounding.
/// Maths     u, but 0 where u > 2 10^-4 of the extent: three digits or fewer are the author's own, as in 2.5
[[nodiscard]] inline double rounding_of(double precision, double extent) {
  return precision <= 2e-4 * extent ? precision : 0;
}

/// The largest gap that coordinates of a precision may leave between faces that were to touch.
/// Maths     8 u: corners are off by 3^(1/2) u each, and a plane by more beyond them
[[nodiscard]] inline double rounded_gap(double precision) { return 8 * precision; }

}  // namespace radcert
