// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// The vertices of a closed polygonal line of the parameter plane, the first not repeated.
using PolygonLoop = std::vector<ParameterPoint<Rational>>;

/// Whether a point lies in a simple polygon of the parameter plane, its border included.
/// Source    CGAL, exact arithmetic
/// Requires  at least three vertices, not all on one line
/// Result    exact, whichever way the polygon runs
[[nodiscard]] bool contains(std::span<const ParameterPoint<Rational>> polygon,
                            const ParameterPoint<Rational>& point);

/// The parameters of a vector in the plane of two others.
/// Maths     p = s first + t second
/// Requires  first, second independent, p in their plane
/// Result    exact
[[nodiscard]] ParameterPoint<Rational> coordinates(const Vector<Rational>& p, const Vector<Rational>& first,
                                                   const Vector<Rational>& second);

/// The convex hull of points of the parameter plane.
/// Source    CGAL's convex_hull_2, exact arithmetic
/// Requires  at least three points, not all on one line
/// Result    its vertices counterclockwise, no three of them on a line; exact
[[nodiscard]] PolygonLoop convex_hull(std::span<const ParameterPoint<Rational>> points);

/// Twice the area of a polygon of the parameter plane, positive where it runs counterclockwise; exact.
[[nodiscard]] Rational doubled_area(std::span<const ParameterPoint<Rational>> loop);

/// A plane polygon in space, convex or not, with holes or without, exactly.
/// Maths     { origin + s first + t second : (s,t) inside loops[0] and outside of the others };
///           its inner normal has the direction of first x second
/// Source    the R_j of [ac98, (13)] under an affine F_j
/// Requires  first, second independent; each loop simple, of at least three vertices, no two in a row equal,
///           of nonzero area; the holes inside loops[0], outside of each other, no loop touching another.
///           Loops may run either way
/// Result    exact and immutable: loops()[0] runs counterclockwise in (s,t), the holes clockwise, so that the
///           polygon lies to the left of all of them. plane_polygon() decides the requirements in exact
///           arithmetic and says which is broken, and where
/// Limits    three vertices in a row may lie on a line. first and second need be neither orthogonal nor of
///           unit length
class PlanePolygon {
public:
  [[nodiscard]] const Vector<Rational>& origin() const { return origin_; }
  [[nodiscard]] const Vector<Rational>& first() const { return first_; }
  [[nodiscard]] const Vector<Rational>& second() const { return second_; }
  /// first x second: not of unit length; its length is the area element of (s,t).
  [[nodiscard]] Vector<Rational> normal() const { return cross(first_, second_); }
  [[nodiscard]] const std::vector<PolygonLoop>& loops() const { return loops_; }
  /// origin + s first + t second.
  [[nodiscard]] Vector<Rational> point(const ParameterPoint<Rational>& at) const {
    return origin_ + at.s * first_ + at.t * second_;
  }
  /// The area in the parameter plane; that of the polygon is |normal()| times it.
  [[nodiscard]] Rational parameter_area() const;

private:
  friend Outcome<PlanePolygon> plane_polygon(const Vector<Rational>& origin, const Vector<Rational>& first,
                                             const Vector<Rational>& second, std::vector<PolygonLoop> loops);
  PlanePolygon() = default;

  Vector<Rational> origin_;
  Vector<Rational> first_;
  Vector<Rational> second_;
  std::vector<PolygonLoop> loops_;
};

/// The polygon of these loops, or what is wrong with them: "loop 0: edges 0 and 2 cross", "loop 1 touches
/// loop 0", ...
[[nodiscard]] Outcome<PlanePolygon> plane_polygon(const Vector<Rational>& origin,
                                                  const Vector<Rational>& first,
                                                  const Vector<Rational>& second,
                                                  std::vector<PolygonLoop> loops);

/// The polygon with these corners in space; they are numbered counterclockwise as seen from the side of its
/// inner normal.
/// Maths     origin = corners[0]; first, second along two edges from it that are not parallel
/// Requires  as PlanePolygon; the corners in one plane exactly
/// Result    the polygon, or what is wrong: "the corners 0, 1, 2 and 4 do not lie in one plane"
/// Limits    one loop
[[nodiscard]] Outcome<PlanePolygon> plane_polygon(const std::vector<Vector<Rational>>& corners);

}  // namespace radcert
