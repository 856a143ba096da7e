// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/work_limit.h"
#include "radcert/geometry/triangle_mesh.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The verdict on the statement that S lies in the boundary of a convex body, with its reason.
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
/// Result    exact: P is the centroid of a triangle, Q a vertex of the mesh; whoever doubts it computes
///           product anew from p, q and the triangle's vertices
/// Limits    one pair of many: the one whose Q lies deepest behind P's plane
struct ContainmentWitness {
  std::size_t triangle = 0;
  std::size_t vertex = 0;
  Vector<Rational> p;
  Vector<Rational> q;
  Vector<Rational> inner_normal;
  Rational product;
};

/// Two points of a surface of charts of which the second lies behind the first.
/// Maths     (Q - P) . n < 0 with P = F_chart(at), Q likewise, n the inner normal at P with the length of the
///           area element
/// Source    [m06, Lemma 1] needs (Q - P) . n_P >= 0 for all P, Q
/// Result    parameters exact, the rest enclosed: product is certainly negative. Whoever doubts it evaluates
///           the two charts there
/// Limits    one pair of many
struct ChartWitness {
  std::size_t chart_p = 0;
  ParameterPoint<Rational> at_p;
  std::size_t chart_q = 0;
  ParameterPoint<Rational> at_q;
  Vector<Ball> p;
  Vector<Ball> q;
  Vector<Ball> inner_normal;
  Ball product;
};

/// A step of a certificate: what it says, and how it was proved.
struct ContainmentStep {
  std::string says;
  std::string proof;
};

/// Two charts for whose pairs of points, P on one and Q on the other, a statement was not decided. The charts
/// may be the same.
struct OpenPair {
  std::size_t chart_p = 0;
  std::size_t chart_q = 0;
  std::size_t boxes = 0;  ///< not decided when the work ended; 0: not begun
};

/// Whether a surface lies in the boundary of its convex hull with its inner normals pointing into it.
/// Maths     certified: (Q - P) . n_P >= 0 for all P, Q in S, P inside a triangle. depth = the largest
///           distance by which a vertex lies behind a triangle's plane, relative to the diagonal of the box
///           about S (between the diameter and sqrt(3) of it)
/// Source    the hypothesis of [m06, Lemma 1] and [ac98, section 1]: S is a part of the boundary of a convex
///           body
/// Result    witness or chart_witness: where refuted. relative_depth: rounded, 0 where not refuted; of charts
///           that of the witness. within_precision: to first order, moving each coordinate by no more than
///           the unit given could bring the deepest vertex of every plane back to its side. steps: of charts,
///           what was proved and what of the charts' stated structure was not; open: of charts, what is left
///           where undecided
/// Limits    only certified says that nothing hides anything
struct ConvexContainment {
  Containment verdict = Containment::undecided;
  std::string reason;
  std::optional<ContainmentWitness> witness = std::nullopt;
  std::optional<ChartWitness> chart_witness = std::nullopt;
  double relative_depth = 0;
  std::size_t planes = 0;  ///< different ones
  std::size_t violated_planes = 0;
  bool within_precision = false;
  std::vector<ContainmentStep> steps = {};
  std::vector<OpenPair> open = {};
  std::size_t boxes = 0;  ///< of charts, that were looked at
};

/// The same, decided for a mesh.
/// Maths     for each different plane of the mesh: no vertex strictly behind it
/// Source    exact predicates on the file's coordinates; a tree of boxes about the vertices finds who could
///           be behind a plane
/// Requires  no degenerate triangle, else ContractViolation; unit >= 0
/// Result    certified or refuted, never undecided; exact for the given doubles. About n log n steps where
///           the triangles are well shaped, at most planes times vertices
/// Limits    says nothing of triangles that overlap in one plane: see mesh_defects
[[nodiscard]] ConvexContainment convex_containment(const TriangleMesh& mesh, Orientation orientation,
                                                   double unit);

extern const WorkLimit most_boxes_a_pair;
extern const WorkLimit most_containment_boxes;

/// How much work a certificate may take: boxes of parameters, or pairs of them, that are looked at.
struct ContainmentBudget {
  std::size_t boxes_a_pair = most_boxes_a_pair.count();  ///< of charts
  std::size_t boxes = most_containment_boxes.count();    ///< in all
};

/// The same for a surface of charts.
/// Maths     P on a flat chart: l(Q) >= 0, l its plane's form. P on a quadric with a convex inside: q(Q) <= 0
///           is enough, since 0 >= q(Q) >= grad q(P) . (Q - P) and n_P has the direction of -grad q(P). P and
///           Q on one ruled chart: convexity of the profile. Otherwise, and for what is not proved of the
///           stated structure: (Q - P) . n_P > 0 over pairs of boxes of parameters by the mean value form,
///           and near the diagonal of one chart n_P . D^2 F positive definite, which is enough by Taylor's
///           formula
/// Source    [m06, Lemma 1]; the first inequality is that of convex functions. No statement of a chart's
///           author is believed: see prove_shape
/// Requires  budget positive, else ContractViolation
/// Result    deterministic; the boxes are bisected in a fixed order. refuted: a pair of points whose balls
///           prove it
/// Limits    charts of unknown shape that touch another stay undecided, the touching points being at the
///           border of the truth; so does a chart without a formula in balls
[[nodiscard]] ConvexContainment convex_containment(const Surface& surface,
                                                   const ContainmentBudget& budget = {});

}  // namespace radcert
