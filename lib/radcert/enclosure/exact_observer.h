// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"

namespace radcert {

/// The point P of the radiosity equation with its normal, known exactly.
/// Maths     P = F_j(s,t) with the inner normal of the chart j; or any point with any normal
/// Source    [ac98, (2)]
/// Requires  see the two ways to make it
/// Result    immutable
class ExactObserver {
public:
  /// A point of a surface, by each of its names: a point of a seam lies on several charts, and the integral
  /// over a chart that contains P ends only where that chart is named. The normal is that of the first name.
  /// At least one name, in the domain of its chart, else ContractViolation where it is used.
  [[nodiscard]] static ExactObserver on_surface(std::vector<SurfacePoint<Rational>> names);
  /// A point off the surface; the normal is brought to unit length. normal != 0, else ContractViolation.
  [[nodiscard]] static ExactObserver off_surface(const Vector<Rational>& position,
                                                 const Vector<Rational>& normal);

  [[nodiscard]] const std::vector<SurfacePoint<Rational>>& names() const { return names_; }
  /// The parameters in a chart that is named.
  [[nodiscard]] std::optional<ParameterPoint<Rational>> on_chart(std::size_t chart) const;
  /// Whether G vanishes on a chart because P lies in its plane: exact where P is off the surface or on a flat
  /// chart.
  [[nodiscard]] bool in_plane_of(const Surface& surface, std::size_t chart) const;

  /// Enclosed at the current precision.
  [[nodiscard]] Vector<Ball> position(const Surface& surface) const;
  [[nodiscard]] Vector<Ball> normal(const Surface& surface) const;

private:
  std::vector<SurfacePoint<Rational>> names_;
  Vector<Rational> position_;
  Vector<Rational> normal_;
};

}  // namespace radcert
