// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/visibility/events/event_edges.h"
#include "radcert/visibility/scene.h"

namespace radcert {

/// A plane as the scene's vertices see it.
/// Result    by vertex: 1 on one side of the plane, -1 on the other, 0 in it; 0 for vertices of no triangle
using PlaneSigns = std::vector<int>;

/// The signs of the plane through three points. Requires points that are not on one line.
[[nodiscard]] PlaneSigns plane_signs(const Scene& scene, const EventEdges& edges, const Vector<double>& a,
                                     const Vector<double>& b, const Vector<double>& c);

/// The lines of a plane through one point, between two directions.
struct PencilFrame {
  Vector<Rational> centre;
  Vector<Rational> from;  ///< a direction, and
  Vector<Rational> to;    ///< another one that is independent of it: of the lines between them
};

/// A point of an event plane: its exact coordinates, and the same rounded to nearest, or infinite where that
/// is so small or large that a product of two might not be a normal number.
/// Maths     centre + x from + y to
struct PencilPoint {
  Rational x;
  Rational y;
  ParameterPoint<double> rounded;
};
[[nodiscard]] PencilPoint pencil_point(Rational x, Rational y);

/// The sign of a x b.
/// Maths     each rounded product has three relative errors of at most u = 2^-53, two of its factors and its
///           own, and the difference one more: with those of the computed size less than 8 u size in all.
///           What is within that or not finite is decided exactly
/// Result    exact
[[nodiscard]] int cross_sign(const PencilPoint& a, const PencilPoint& b);

/// A triangle that crosses the plane.
struct PlaneCrossing {
  std::size_t triangle = 0;
  PencilPoint p;
  PencilPoint q;
  ParameterPoint<Rational> at_p;  ///< in the triangle's parameters
  ParameterPoint<Rational> at_q;
  ParameterPoint<Rational> normal;  ///< as EventPlane::normal

  /// Whether a line that runs forwards (way = 1) or backwards (way = -1) meets its front.
  [[nodiscard]] bool faces(const PencilPoint& direction, int way) const {
    return way * (direction.x * normal.s + direction.y * normal.t).sign() < 0;
  }
};

/// An edge that lies in the plane.
struct PlaneContact {
  PencilPoint p;
  PencilPoint q;
  bool blocks = false;  ///< else a line touches it and goes on
};

/// Where a line of the pencil ends: in a triangle's interior, or at an edge in the plane.
struct SightEnd {
  Rational distance;  ///< from the centre, in units of the direction's length; negative behind the centre
  std::optional<std::size_t> crossing;  ///< the place of the triangle among the crossings
};

/// What a plane has of a scene, seen along the lines of a pencil.
/// Maths     a line has the direction (1 - l) from + l to, 0 < l < 1. Between two neighbouring `turns` all
///           lines meet the same triangles in the same order
/// Requires  a closed scene; the frame lies in the plane of the signs
/// Result    exact
/// Limits    what lies beside the pencil is left out
class EventPlane {
public:
  EventPlane(const Scene& scene, const EventEdges& edges, const PlaneSigns& signs, PencilFrame frame);

  [[nodiscard]] std::span<const PlaneCrossing> crossings() const { return crossings_; }
  /// The l at which lines pass an end of what lies in the plane, from 0 to 1.
  [[nodiscard]] std::vector<Rational> turns() const;

  /// The products of a triangle's normal to its front with from and to.
  [[nodiscard]] ParameterPoint<Rational> normal(std::size_t triangle) const;

  [[nodiscard]] static PencilPoint direction(const Rational& l);
  /// The places of the crossings that a line meets, both ways. Requires a direction between two turns.
  [[nodiscard]] std::vector<std::size_t> met(const PencilPoint& direction) const;
  /// What ends the line from the centre forwards (way = 1) and backwards (way = -1), if anything does.
  [[nodiscard]] std::optional<SightEnd> end(const PencilPoint& direction, int way) const;
  /// In the parameters of the crossing's triangle, where a line or, at a turn, its limit meets it.
  [[nodiscard]] ParameterPoint<Rational> place(const PencilPoint& direction,
                                               const PlaneCrossing& crossing) const;

private:
  [[nodiscard]] PencilPoint point(const Vector<Rational>& from_centre) const;
  void cross(std::size_t triangle);
  void touch(const EventEdge& edge);

  const Scene* scene_;
  const PlaneSigns* signs_;
  PencilFrame frame_;
  Vector<Rational> plane_normal_;
  std::vector<PlaneCrossing> crossings_;
  std::vector<PlaneContact> contacts_;
};

}  // namespace radcert
