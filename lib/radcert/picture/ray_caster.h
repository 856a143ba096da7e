// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "radcert/core/outcome.h"
#include "radcert/meshless/light_scene.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The first intersection of a ray with a scene.
struct RayHit {
  LitPoint at;
  double distance = 0;   ///< from the eye, in lengths of the step from the eye to `through`
  std::size_t face = 0;  ///< a number for each plane of a mesh, then for each round body
};

/// Finds the first point of a surface along a ray.
/// Maths     the least t > 0 for which e + t (q - e) lies on a face whose lit side it comes from
/// Source    [psg10, section II], the operation x up-arrow v
/// Requires  the eye is on no face; coordinates of at most Scene::largest_coordinate; eye and through differ
/// Result    triangles: whether the line meets one, side and vertex included, is exact for the given doubles,
///           so that no ray passes between neighbours; which comes first is rounded. The point is moved by
///           2^-40 of the triangle towards its middle, so that it is not rounded beyond the next wall. Balls
///           and disks: rounded, a ray within rounding of the rim may go either way. Immutable, shared by
///           threads
/// Limits    backs let through: one looks into a closed room from outside. Of a round piece `chart` is the
///           first one
class RayCaster {
public:
  /// Of a mesh, or of a surface each piece of which is the skin of a ball or a disk. Refused: other curved
  /// surfaces.
  [[nodiscard]] static Outcome<RayCaster> make(const Surface& surface,
                                               std::span<const RoundBlocker> bodies = {});

  [[nodiscard]] std::optional<RayHit> first(const Vector<double>& eye, const Vector<double>& through) const;
  /// Whether a point of the surface, on a side with this normal, is seen from the eye.
  [[nodiscard]] bool sees(const Vector<double>& eye, const Site<double>& site) const;

private:
  struct Parts;
  explicit RayCaster(std::shared_ptr<const Parts> parts);
  std::shared_ptr<const Parts> parts_;
};

}  // namespace radcert
