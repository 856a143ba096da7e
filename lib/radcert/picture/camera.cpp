// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/camera.h"

#include <cmath>
#include <numbers>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

bool is_finite(const Vector<double>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Vector<double> unit(const Vector<double>& v) { return (1 / norm(v)) * v; }

}  // namespace

PinholeCamera::PinholeCamera(const CameraPose& pose)
    : position_(pose.position), half_height_(std::tan(pose.vertical_angle / 2)) {
  expects(pose.vertical_angle > 0 && pose.vertical_angle < std::numbers::pi, "a vertical angle in (0, pi)",
          named("angle", pose.vertical_angle));
  const Vector<double> axis = pose.look_at - pose.position;
  const Vector<double> side = cross(axis, pose.up);
  expects(is_finite(pose.position) && is_finite(axis) && is_finite(side), "finite coordinates");
  expects(norm(axis) > 0 && norm(side) > 0, "a direction to look into, and another one upwards",
          named("distance", norm(axis)));
  forward_ = unit(axis);
  right_ = unit(side);
  up_ = cross(right_, forward_);
}

Vector<double> PinholeCamera::through(const ImagePoint& at, const ImageRegion& picture) const {
  const double scale = 2 * half_height_ / static_cast<double>(picture.height);
  const double a = scale * (at.x - static_cast<double>(picture.x) - static_cast<double>(picture.width) / 2);
  const double b = scale * (static_cast<double>(picture.y) + static_cast<double>(picture.height) / 2 - at.y);
  return position_ + forward_ + a * right_ + b * up_;
}

std::optional<ImagePoint> PinholeCamera::image_of(const Vector<double>& point,
                                                  const ImageRegion& picture) const {
  const Vector<double> step = point - position_;
  const double depth = dot(step, forward_);
  if (!(depth > 0)) return std::nullopt;
  const double scale = static_cast<double>(picture.height) / (2 * half_height_ * depth);
  return ImagePoint{
      static_cast<double>(picture.x) + static_cast<double>(picture.width) / 2 + scale * dot(step, right_),
      static_cast<double>(picture.y) + static_cast<double>(picture.height) / 2 - scale * dot(step, up_)};
}

}  // namespace radcert
