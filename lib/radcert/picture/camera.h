// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "radcert/geometry/vector.h"
#include "radcert/picture/image.h"

namespace radcert {

/// A place in an image: x pixels from its left edge, y from its upper one.
struct ImagePoint {
  double x = 0;
  double y = 0;
};

/// Where a pinhole camera stands and looks.
struct CameraPose {
  Vector<double> position;
  Vector<double> look_at;        ///< seen in the middle of the picture
  Vector<double> up{0, 0, 1};    ///< shown upwards
  double vertical_angle = 0.75;  ///< between the rays of the upper and the lower edge, in radians
};

/// A pinhole camera.
/// Maths     a point e + d (f + a r + b u) with d > 0 is shown at (w/2 + a h/(2 tan(v/2)), h/2 - b h/(2
///           tan(v/2))): e the position, f, r, u unit vectors forward, to the right and upwards, v the
///           vertical angle, w by h the picture
/// Source    central projection
/// Requires  position and look_at differ, up is not parallel to the direction between them, 0 <
///           vertical_angle < pi, all finite, else ContractViolation
/// Result    rounded; pixels are square, whatever the picture's sides
/// Limits    no lens
class PinholeCamera {
public:
  explicit PinholeCamera(const CameraPose& pose);

  [[nodiscard]] const Vector<double>& position() const { return position_; }
  /// A point of the ray through a place of a picture of that size, at distance 1 along the axis.
  [[nodiscard]] Vector<double> through(const ImagePoint& at, const ImageRegion& picture) const;
  /// Where a point is shown, inside the picture or not; nothing where it is not in front of the camera.
  [[nodiscard]] std::optional<ImagePoint> image_of(const Vector<double>& point,
                                                   const ImageRegion& picture) const;

private:
  Vector<double> position_;
  Vector<double> forward_;
  Vector<double> right_;
  Vector<double> up_;
  double half_height_;  ///< of the picture, at distance 1: tan(v/2)
};

}  // namespace radcert
