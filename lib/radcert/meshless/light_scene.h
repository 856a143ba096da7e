// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/meshless/site.h"
#include "radcert/surface/surface.h"
#include "radcert/visibility/round_blockers.h"

namespace radcert {

/// A round body or disk that stands in the way, and the piece of the surface that is its skin, if any.
/// Maths     the ball, seen from outside, or the disk
/// Requires  `piece` is empty or the name of a piece of the scene's surface whose inner normals leave the
///           ball
/// Result    plain data. It hides nothing from a point of its own piece: a convex body hides from its skin
///           what lies behind the tangent plane, where the kernel is 0, and a rounded point of the skin may
///           lie inside
struct RoundBlocker {
  std::variant<BallBlocker, DiskBlocker> shape;
  std::string piece;
};

/// Where light is: a point of a surface, as doubles.
struct LitPoint {
  Site<double> site;
  std::size_t chart = 0;
};

/// The point of a surface at parameters of a chart.
[[nodiscard]] LitPoint lit_point(const Surface& surface, const SurfacePoint<double>& at);

/// A surface that scatters light on the side of its inner normals, and what stands in the way.
/// Maths     S, beta(x) constant on each chart, V(x,y)
/// Source    [psg10, section II]
/// Result    immutable, shared by threads. V = 1 for a surface without occlusion, exact for meshes and for
///           round blockers
/// Limits    a curved surface that hides parts of itself needs blockers: they are its own author's statement
class LightScene {
public:
  /// One albedo for all charts, or one a chart. Refused: an albedo outside [0,1); a curved surface that hides
  /// parts of itself without blockers; blockers that `hides` does not take, or of a piece that is not there.
  [[nodiscard]] static Outcome<LightScene> make(Surface surface, std::vector<double> albedo,
                                                std::vector<RoundBlocker> blockers = {});

  [[nodiscard]] const Surface& surface() const;
  [[nodiscard]] double albedo(std::size_t chart) const;
  /// Whether nothing stands between two points; what lies behind a point's own chart is not asked for.
  [[nodiscard]] bool visible(const LitPoint& p, const LitPoint& q) const;
  /// Whether nothing stands between a point and one of free space.
  [[nodiscard]] bool visible(const LitPoint& p, const Vector<double>& from) const;
  /// A length above every distance within the scene, up to the cells on which curved charts are looked at.
  [[nodiscard]] double reach() const;

private:
  struct Parts;
  explicit LightScene(std::shared_ptr<const Parts> parts);
  std::shared_ptr<const Parts> parts_;
};

}  // namespace radcert
