// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A convex polygon of a polyhedron, exactly.
/// Maths     the corners run counterclockwise as seen from the side of the inner normal, no three of them on
///           a line; centre is their mean; normal = (c_1 - c_0) x (c_2 - c_0) up to a positive factor
struct Panel {
  std::size_t piece = 0;  ///< its place in Surface::piece_names()
  std::vector<Vector<Rational>> corners;
  Vector<Rational> centre;
  Vector<Rational> normal;
};

/// A polyhedron as convex polygons.
/// Maths     the plane charts of one piece that lie in one plane are one panel where their union is convex:
///           its convex hull has the sum of their areas. Otherwise each chart is a panel
/// Requires  charts of one plane that do not overlap
/// Result    exact; refused with the name of a chart that is not plane, or not known in exact arithmetic
[[nodiscard]] Outcome<std::vector<Panel>> convex_panels(const Surface& surface);

/// The faces of the convex hull of an open surface that are not there.
/// Maths     black, and dark, they close the surface and change nothing on it: u = 0 there
/// Requires  panels in the boundary of their convex hull, which do not overlap
/// Result    exact, of this piece; refused where a face is there in part alone, or all lies in one plane
[[nodiscard]] Outcome<std::vector<Panel>> closing_panels(const std::vector<Panel>& panels, std::size_t piece);

/// Panels cut along the planes of all.
/// Maths     each part is on one side of every panel's plane, or in it; of one piece, those of one plane
///           which are on the same sides of all are one where their union is convex. Where an edge belongs to
///           two faces, the parts on both sides have the same ends
/// Result    exact, in the order of the panels; refused where they are more than `most`, or the pieces on the
///           way more than ten times as many
[[nodiscard]] Outcome<std::vector<Panel>> cut_panels(const std::vector<Panel>& panels, std::size_t most);

/// Panels whose sides no corner of another lies inside.
/// Maths     from such a point, which a face of several pieces beside an edge leaves there, a panel is cut to
///           one of its own corners: that which makes the smaller part largest. No corners are added
/// Result    exact, each part in the place of its panel
[[nodiscard]] std::vector<Panel> with_edges_matched(std::vector<Panel> panels);

/// Whether the planes of two panels are one.
[[nodiscard]] bool in_one_plane(const Panel& a, const Panel& b);

}  // namespace radcert
