// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/reference/reference_value.h"
#include "verification/claims/psg10/sphere_over_disk/solution.h"

namespace radcert::verification::psg10 {

/// The scene's parameters, as --set names them, in the order radius, disk_radius, height, albedo, intensity.
[[nodiscard]] std::span<const reference::ValueParameter> sphere_over_disk_parameters();
/// The scene of their values; some that are allowed one by one make none: see allows().
[[nodiscard]] SphereOverDiskScene sphere_over_disk_scene(const reference::Arguments& arguments);

/// A point of the scene.
/// Maths     sphere: the latitude place + poles pi/2 in radians; disk: the distance `place` from the axis
/// Result    plain data
/// Limits    a pole is place = 0, poles = -1 or 1
struct SphereOverDiskPoint {
  enum class Part { sphere, disk };
  Part part = Part::sphere;
  Rational place;
  int poles = 0;
};

/// Whether the point is one of the scene: latitudes in [-pi/2, pi/2], distances in [0, disk_radius].
[[nodiscard]] bool allows(const SphereOverDiskScene& scene, const SphereOverDiskPoint& point);

/// A radiance with an estimated error.
/// Maths     midpoints and radii; total = emission + indirect
/// Source    [psg10, (20)-(21)]
/// Result    total, emission and indirect by the two equations, second: the total by cubature in double;
///           routes: how each was found
/// Limits    the radii are estimates
struct EstimatedRadiance {
  Ball total;
  Ball emission;
  Ball indirect;
  Ball second;
};

/// How the two numbers of an EstimatedRadiance are found.
[[nodiscard]] const std::string& sphere_over_disk_route();
[[nodiscard]] const std::string& sphere_over_disk_second_route();

inline constexpr int most_sphere_over_disk_digits = 24;

/// The radiance at points of the sphere over the disk, by two routes.
/// Maths     with Mpfr<50>, 8 + 2 digits nodes a panel, 8 more, and then a third more each time, until at
///           every point two neighbouring discretisations differ by at most 10^-digits / 2: the difference is
///           the radius, and that of the coarser of the two, so that the finer is better by some digits. The
///           second route's radius is the largest change of its value when its rule or its discretisation is
///           made coarser, and 10^-13 of the intensity for rounding
/// Source    SphereOverDisk, indirect_on_sphere, indirect_on_disk
/// Requires  allows(scene), allows(scene, point) for each, 1 <= digits <= most_sphere_over_disk_digits, else
///           ContractViolation
/// Result    in the order of the points; or why not: the radius that was reached, or routes that do not agree
/// Limits    nothing is proved
[[nodiscard]] Outcome<std::vector<EstimatedRadiance>> estimate(const SphereOverDiskScene& scene,
                                                               std::span<const SphereOverDiskPoint> points,
                                                               int digits);

/// One point of a curve.
struct CurvePoint {
  SphereOverDiskPoint::Part part;
  double place;  ///< latitude or distance
  bool lit;
  double total;
  double emission;
  double indirect;
};

/// Both curves of figure 10.
/// Maths     B at `count` latitudes from -pi/2 to pi/2, D at `count` distances from 0 to disk_radius, equally
///           spaced with the ends; D at u = radius on both sides of the shadow's rim besides
/// Source    [psg10, figure 10]
/// Requires  allows(scene), 2 <= count, else ContractViolation
/// Result    the sphere first, each ascending; rounded to double from a discretisation in Mpfr<50> that meets
///           10^-14 in the paper's scene
/// Limits    no radii: estimate() gives them
[[nodiscard]] std::vector<CurvePoint> curves(const SphereOverDiskScene& scene, int count);

}  // namespace radcert::verification::psg10
