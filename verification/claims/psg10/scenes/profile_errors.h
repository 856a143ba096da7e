// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "radcert/meshless/light_scene.h"

namespace radcert::verification::psg10 {

/// A circle about the z-axis on a surface of revolution, and the radiance that is right there.
/// Maths     points (distance cos phi, distance sin phi, height), normals (radial cos phi, radial sin phi,
///           axial)
/// Source    [psg10, section VIII]
/// Requires  distance >= 0, radial^2 + axial^2 = 1, area > 0
/// Result    plain data; area: of the part of the surface that the circle stands for
struct ProfilePoint {
  double distance = 0;
  double height = 0;
  double radial = 0;
  double axial = 1;
  std::size_t chart = 0;  ///< any of the piece
  double area = 1;
  double truth = 0;
};

/// `count` parallels of the sphere of sphere_over_disk_surface, in the middles of equal parts of the sine t
/// of the latitude: equal areas.
[[nodiscard]] std::vector<ProfilePoint> sphere_profile(double radius, double height, std::size_t count,
                                                       const std::function<double(double t)>& truth);
/// `count` circles of its disk, in the middles of equal parts of the distance u.
[[nodiscard]] std::vector<ProfilePoint> disk_profile(double disk_radius, std::size_t count,
                                                     const std::function<double(double u)>& truth);

/// What a radiance is on one circle.
struct CircleValues {
  double ray = 0;          ///< at the azimuth 0: the red lines of figures 11-13
  double mean = 0;         ///< over the azimuths: the black ones
  double oscillation = 0;  ///< root of the mean square of value - mean
  double largest_error = 0;
  std::size_t without_value = 0;  ///< azimuths at which the radiance has none
};

/// How far a radiance is from the right one on circles.
/// Maths     max: max |L - truth|; mean: the mean of L - truth; l2^2 = bias^2 + oscillation^2, the means of
///           squares of L - truth, of (mean over the circle) - truth and of L - (mean over the circle); all
///           means by area
/// Source    [psg10, section VIII-B and IX]: systematic errors and oscillations
/// Result    rounded; over the points where the radiance has a value
struct ProfileErrors {
  double max = 0;
  double l2 = 0;
  double mean = 0;
  double bias = 0;
  double oscillation = 0;
  double without_value = 0;  ///< the part of the area
  std::vector<CircleValues> circles;
};

/// Compares a radiance with the right one.
/// Maths     azimuths 2 pi k / azimuths, k = 0, ..., azimuths - 1
/// Requires  azimuths >= 1, else ContractViolation; a radiance that threads may ask for at the same time
/// Result    see ProfileErrors; the same bits for any number of threads
/// Limits    max is over the points that are looked at
[[nodiscard]] ProfileErrors profile_errors(
    const std::function<std::optional<double>(const LitPoint&)>& radiance,
    std::span<const ProfilePoint> profile, std::size_t azimuths);

}  // namespace radcert::verification::psg10
