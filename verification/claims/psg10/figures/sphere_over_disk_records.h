// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radcert/formats/result/reference_json.h"
#include "verification/claims/psg10/sphere_over_disk/estimate.h"

namespace radcert::verification::psg10 {

/// The name under which radcert reference gives the radiance of the sphere over the disk.
inline constexpr std::string_view sphere_over_disk_name = "sphere_over_disk";

/// What the user wants of the sphere over the disk.
struct SphereOverDiskWish {
  reference::Arguments arguments;  ///< in the order of sphere_over_disk_parameters()
  std::vector<std::string> at;     ///< "B:LATITUDE", "D:DISTANCE"
  std::string curve;               ///< a CSV file for both curves, or empty
  std::string points;              ///< of each curve
  int digits = 0;
};

/// The values at the points asked for; InputError for points that are none of the scene, AccuracyNotReached.
std::vector<ReferenceRecord> sphere_over_disk_records(const SphereOverDiskWish& wish);

/// Both curves as CSV: curve, place, lit, total, emission, indirect.
std::string sphere_over_disk_csv(const SphereOverDiskWish& wish);

}  // namespace radcert::verification::psg10
