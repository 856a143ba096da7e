// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/sum_errors.h"

#include <algorithm>
#include <cmath>

namespace radcert::verification::psg10 {

SumErrors sum_errors(const SumReading& reading) {
  static const SphereOverDisk<double> truth({}, {.nodes = 32, .points = 64});
  const SumSolution sums = sum_solution({}, reading, 100, 1e-15);
  SumErrors errors;
  for (std::size_t i = 0; i < sums.sphere.size(); ++i) {
    const double t = std::clamp(std::sin(sums.latitudes[i]), -1.0, 1.0);
    const double error = std::abs(sums.sphere[i] - truth.sphere(t).total());
    errors.sphere = std::max(errors.sphere, error);
    errors.sphere_mean += error * error;
  }
  for (std::size_t j = 0; j < sums.disk.size(); ++j) {
    const double u = std::min(sums.distances[j], truth.scene().disk_radius);
    const double error = std::abs(sums.disk[j] - truth.disk(u).total());
    errors.disk = std::max(errors.disk, error);
    errors.disk_mean += error * error;
  }
  errors.sphere_mean = std::sqrt(errors.sphere_mean / static_cast<double>(sums.sphere.size()));
  errors.disk_mean = std::sqrt(errors.disk_mean / static_cast<double>(sums.disk.size()));
  return errors;
}

}  // namespace radcert::verification::psg10
