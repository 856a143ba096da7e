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
    errors.sphere = std::max(errors.sphere, std::abs(sums.sphere[i] - truth.sphere(t).total()));
  }
  for (std::size_t j = 0; j < sums.disk.size(); ++j) {
    const double u = std::min(sums.distances[j], truth.scene().disk_radius);
    errors.disk = std::max(errors.disk, std::abs(sums.disk[j] - truth.disk(u).total()));
  }
  return errors;
}

}  // namespace radcert::verification::psg10
