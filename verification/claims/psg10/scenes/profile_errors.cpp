// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/scenes/profile_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"

namespace radcert::verification::psg10 {
namespace {

// The charts of sphere_over_disk_surface: eight of the sphere, then four of the disk.
constexpr std::size_t sphere_chart = 0;
constexpr std::size_t disk_chart = 8;

CircleValues values_on(const std::function<std::optional<double>(const LitPoint&)>& radiance,
                       const ProfilePoint& at, std::size_t azimuths) {
  CircleValues circle;
  std::vector<double> values;
  values.reserve(azimuths);
  for (std::size_t k = 0; k < azimuths; ++k) {
    const double phi = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(azimuths);
    const double x = std::cos(phi);
    const double y = std::sin(phi);
    const std::optional<double> value =
        radiance({.site = {.point = {at.distance * x, at.distance * y, at.height},
                           .normal = {at.radial * x, at.radial * y, at.axial}},
                  .chart = at.chart});
    if (!value) {
      ++circle.without_value;
      continue;
    }
    if (k == 0) circle.ray = *value;
    circle.largest_error = std::max(circle.largest_error, std::abs(*value - at.truth));
    values.push_back(*value);
  }
  if (values.empty()) return circle;
  const auto count = static_cast<double>(values.size());
  for (const double value : values) circle.mean += value / count;
  double squares = 0;
  for (const double value : values) squares += (value - circle.mean) * (value - circle.mean);
  circle.oscillation = std::sqrt(squares / count);
  return circle;
}

}  // namespace

std::vector<ProfilePoint> sphere_profile(double radius, double height, std::size_t count,
                                         const std::function<double(double)>& truth) {
  std::vector<ProfilePoint> profile;
  const double area = 4 * std::numbers::pi * radius * radius / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = (2 * static_cast<double>(k) + 1) / static_cast<double>(count) - 1;
    const double cosine = std::sqrt((1 - t) * (1 + t));
    profile.push_back({.distance = radius * cosine,
                       .height = height + radius * t,
                       .radial = cosine,
                       .axial = t,
                       .chart = sphere_chart,
                       .area = area,
                       .truth = truth(t)});
  }
  return profile;
}

std::vector<ProfilePoint> disk_profile(double disk_radius, std::size_t count,
                                       const std::function<double(double)>& truth) {
  std::vector<ProfilePoint> profile;
  const double step = disk_radius / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double u = (static_cast<double>(k) + 0.5) * step;
    profile.push_back({.distance = u,
                       .height = 0,
                       .radial = 0,
                       .axial = 1,
                       .chart = disk_chart,
                       .area = 2 * std::numbers::pi * u * step,
                       .truth = truth(u)});
  }
  return profile;
}

ProfileErrors profile_errors(const std::function<std::optional<double>(const LitPoint&)>& radiance,
                             std::span<const ProfilePoint> profile, std::size_t azimuths) {
  expects(azimuths >= 1, "azimuths >= 1", named("azimuths", azimuths));
  ProfileErrors errors;
  errors.circles.resize(profile.size());
  parallel_for(profile.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) errors.circles[k] = values_on(radiance, profile[k], azimuths);
  });
  double area = 0;
  double covered = 0;
  double bias_squares = 0;
  double oscillation_squares = 0;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    const CircleValues& circle = errors.circles[k];
    const double share = static_cast<double>(azimuths - circle.without_value) / static_cast<double>(azimuths);
    const double weight = profile[k].area * share;
    area += profile[k].area;
    covered += weight;
    errors.max = std::max(errors.max, circle.largest_error);
    if (share == 0) continue;
    const double bias = circle.mean - profile[k].truth;
    errors.mean += weight * bias;
    bias_squares += weight * bias * bias;
    oscillation_squares += weight * circle.oscillation * circle.oscillation;
  }
  if (covered > 0) {
    errors.mean /= covered;
    errors.bias = std::sqrt(bias_squares / covered);
    errors.oscillation = std::sqrt(oscillation_squares / covered);
    errors.l2 = std::hypot(errors.bias, errors.oscillation);
  }
  if (area > 0) errors.without_value = 1 - covered / area;
  return errors;
}

}  // namespace radcert::verification::psg10
