// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/visibility/scene.h"

namespace radcert {

/// From where a scene is seen: all doubles are exact.
struct Viewpoint {
  Vector<double> point;
  Vector<double> normal;  ///< not of unit length; nothing is seen where normal . (Q - point) < 0
  /// The triangle that the point was taken from, if any; rounding may have put the point beside its plane.
  std::optional<std::size_t> triangle;
};

/// How much of a triangle is seen.
enum class Sight { nothing, part, whole };

/// A plane through the viewpoint that bounds what is seen: by a side of a triangle, or by the horizon.
struct SightPlane {
  std::size_t from = horizon;  ///< the smaller number of two vertices, as Scene::vertices has them
  std::size_t to = horizon;    ///< the larger
  /// Which side is seen: that of sign (from - P) x (to - P), for the horizon that of sign times the normal.
  int sign = 1;

  static constexpr std::size_t horizon = static_cast<std::size_t>(-1);
  friend bool operator==(const SightPlane& a, const SightPlane& b) = default;
};

/// A convex piece of a triangle that is seen.
/// Maths     corner (s,t) is the point c_0 + s (c_1 - c_0) + t (c_2 - c_0) of the triangle; planes[k] holds
///           the side from corners[k] to corners[k + 1], and corners[k] has the direction of m_k x m_(k-1),
///           m_k the normal of planes[k] into the piece
/// Result    at least three corners, counterclockwise as the triangle's own; each coordinate within 2^-51 of
///           the exact one and in [0,1]. Adjacent planes differ; three corners never lie on one line exactly
/// Limits    rounded corners of a very thin piece may coincide: exact_corners() has them apart
struct VisiblePart {
  std::vector<ParameterPoint<double>> corners;
  std::vector<SightPlane> planes;
};

/// The part of a triangle that a point sees.
/// Maths     the union of the parts, whose interiors have no point in common, is the closure of what is seen
/// Result    whole: one part, the triangle; nothing: none. The parts are those of the exact geometry
/// Limits    cut into parts as the search went: no two scenes' parts need compare
struct VisibleRegion {
  Sight sight = Sight::nothing;
  std::vector<VisiblePart> parts;
};

/// The visible parts of a scene's triangles from one point, exactly.
/// Maths     Q of a triangle T is seen from P where P lies in front of T, n . (Q - P) >= 0 and V(P,Q) = 1, up
///           to sets without area. On the sphere of directions about P every border is a plane through P and
///           a side of a triangle, or the horizon; a corner is the direction in which two of them meet, and
///           every decision the sign of det(n_i, n_j, n_k). What T shows is its cone, cut by the horizon,
///           minus the cones of the triangles that stand before it, one after the other. As triangles of a
///           scene do not cross, which of two stands before the other is the same in all directions that they
///           share
/// Source    the sign of a determinant in doubles with a bounded error, then in whole numbers. Sides that
///           triangles share are one plane, so no gap opens between them
/// Requires  the scene outlives the view; coordinates of at most Scene::largest_coordinate, normal != 0, a
///           triangle that is there, else ContractViolation
/// Result    exact for the given doubles. P with a triangle: the plane of that triangle hides nothing and
///           shows nothing, a triangle T on the front side of that plane is not cut by the horizon, for P
///           stands for a point of the plane; one behind it is not seen. One that crosses the plane is cut by
///           the horizon through P
/// Limits    one view belongs to one thread; any number of views may look at a scene. Where scene_faults()
///           finds crossing triangles, a triangle may be seen through another
class PointView {
public:
  PointView(const Scene& scene, const Viewpoint& from);
  PointView(PointView&&) noexcept;
  PointView& operator=(PointView&&) noexcept;
  ~PointView();

  [[nodiscard]] const Scene& scene() const;
  [[nodiscard]] const Viewpoint& viewpoint() const;

  [[nodiscard]] VisibleRegion region(std::size_t triangle);

private:
  class Search;
  std::unique_ptr<Search> search_;
};

/// The same for one triangle.
[[nodiscard]] VisibleRegion visible_region(const Scene& scene, const Viewpoint& from, std::size_t triangle);

/// The corners of a visible part, exactly.
/// Maths     as VisiblePart
/// Requires  the scene, viewpoint and triangle that the part was made of, else the result means nothing, or
///           ContractViolation
/// Result    exact
/// Limits    slow: rational numbers of some hundred digits
[[nodiscard]] std::vector<ParameterPoint<Rational>> exact_corners(const Scene& scene, const Viewpoint& from,
                                                                  std::size_t triangle,
                                                                  const VisiblePart& part);

}  // namespace radcert
