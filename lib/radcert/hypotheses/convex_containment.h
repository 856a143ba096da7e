// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "radcert/geometry/triangle_mesh.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// What is known of the statement that S lies in the boundary of a convex body.
enum class Containment {
  certified,  ///< proved
  refuted,    ///< disproved, by a witness
  undecided,  ///< neither; the reason says what is left
};

/// The word for it: "certified", "refuted", "undecided".
[[nodiscard]] std::string containment_word(Containment verdict);

/// Two points of S of which the second lies behind the first.
/// Maths     (Q - P) . n < 0, where n is normal to S at P, inwards, and not of unit length
/// Source    [m06, Lemma 1] needs (Q - P) . n_P >= 0 for all P, Q
/// Requires  -
/// Result    exact: P is the centroid of a triangle, Q a vertex of the mesh; whoever doubts it computes product anew from p, q and
///           the triangle's vertices
/// Limits    one pair of many: the one whose Q lies deepest behind P's plane
struct ContainmentWitness {
  std::size_t triangle = 0;
  std::size_t vertex = 0;
  Vector<Rational> p;
  Vector<Rational> q;
  Vector<Rational> inner_normal;
  Rational product;
};

/// Whether a surface lies in the boundary of its convex hull with its inner normals pointing into it.
/// Maths     certified: (Q - P) . n_P >= 0 for all P, Q in S, P inside a triangle. depth = the largest distance by which a vertex
///           lies behind a triangle's plane, relative to the diagonal of the box about S (between the diameter and sqrt(3) of it)
/// Source    the hypothesis of [m06, Lemma 1] and [ac98, section 1]: S is a part of the boundary of a convex body
/// Requires  -
/// Result    witness: where refuted. relative_depth: rounded, 0 where not refuted. within_precision: to first order, moving each
///           coordinate by no more than the unit given could bring the deepest vertex of every plane back to its side
/// Limits    only certified says that nothing hides anything
struct ConvexContainment {
  Containment verdict = Containment::undecided;
  std::string reason;
  std::optional<ContainmentWitness> witness;
  double relative_depth = 0;
  std::size_t planes = 0;  ///< different ones
  std::size_t violated_planes = 0;
  bool within_precision = false;
};

/// The same, decided for a mesh.
/// Maths     for each different plane of the mesh: no vertex strictly behind it
/// Source    exact predicates on the file's coordinates; a tree of boxes about the vertices finds who could be behind a plane
/// Requires  no degenerate triangle, else ContractViolation; unit >= 0
/// Result    certified or refuted, never undecided; exact for the given doubles. About n log n steps where the triangles are well
///           shaped, at most planes times vertices
/// Limits    says nothing of triangles that overlap in one plane: see mesh_defects
[[nodiscard]] ConvexContainment convex_containment(const TriangleMesh& mesh, Orientation orientation,
                                                   double unit);

/// The same for a surface of charts: undecided, for no chart is looked at.
[[nodiscard]] ConvexContainment convex_containment(const Surface& surface);

}  // namespace radcert
