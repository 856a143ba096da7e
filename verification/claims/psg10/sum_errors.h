// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/claims/psg10/sphere_over_disk/sums.h"

namespace radcert::verification::psg10 {

/// The differences between the paper's sums and the solution of (21), at the points of the sums: the largest,
/// and their root mean squares.
struct SumErrors {
  double sphere = 0;
  double disk = 0;
  double sphere_mean = 0;
  double disk_mean = 0;
};

/// Maths     b_i - B(zeta_i), d_j - D(u_j) in the paper's scene
/// Source    [psg10, (20)-(25)]
/// Requires  counts of at least 2
/// Result    rounded; the sums are iterated until they stand still, 100 times at most, and B, D are good to
///           1e-13
[[nodiscard]] SumErrors sum_errors(const SumReading& reading);

}  // namespace radcert::verification::psg10
