// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// The diagonal along which a unit square is cut into two triangles.
enum class Diagonal {
  main,  ///< from (0,0) to (1,1)
  anti,  ///< from (1,0) to (0,1)
};

/// The value of one named parameter of a surface.
struct SurfaceParameter {
  std::string name;
  Rational value;
};

/// A piecewise smooth surface S = S_1 u ... u S_J with what is known of it as a whole.
/// Maths     charts F_j : R_j -> S_j; pieces group the charts that belong to one smooth patch
/// Source    [ac98, (13)-(14)]
/// Requires  normals point inwards; what the facts say holds by construction (catalogue) or has been proved
/// Result    immutable
/// Limits    facts are statements of the surface's author until `hypotheses` can certify them
struct Surface {
  std::string name;
  std::vector<SurfaceParameter> parameters;
  std::vector<Chart> charts;
  /// Of each chart; the published coarse triangulation; ignored on triangular domains.
  std::vector<Diagonal> diagonals;
  bool closed = false;                ///< S is the whole boundary of a body
  bool unoccluded = true;             ///< V = 1: S lies in the boundary of a convex body
  bool pieces_meet_at_angle = false;  ///< two pieces share an edge across which the normal jumps
  bool charts_join_smoothly = true;   ///< within a piece; not so the interpolants of elements
  std::shared_ptr<const TriangleMesh> mesh = nullptr;  ///< where S is one: chart k is its triangle k

  std::size_t chart_count() const { return charts.size(); }
  /// The names of the pieces in the order in which the charts name them first.
  std::vector<std::string> piece_names() const;
  /// The position of a chart's piece in `piece_names()`.
  std::size_t piece_of(std::size_t chart) const;
};

/// Whether G vanishes between two charts because both lie in one plane; decided on exact coefficients.
bool in_one_plane(const Chart& a, const Chart& b);

}  // namespace radcert
