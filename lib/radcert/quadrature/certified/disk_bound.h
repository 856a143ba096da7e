// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>

namespace radcert {

/// What a Taylor model of a part of a chart says of the kernel's integrand for all P that are far enough.
/// Maths     Q = c + r + e on a disk, r a real vector times one complex number and real ones, |r| <= L, e
///           complex, |e| <= E. With w = Q - P and d = |c - P| > L: w.w has the two factors of a real line
///           for c - P + r, each at least d - L, so that |w.w| >= (d-L)^2 - 2 (d+L) E - E^2, and |w| is at
///           most d + L + E: |G| <= (|w| / |w.w|)^2 times |area normal|
/// Source    see CertifiedKernelSums
/// Result    rounded up
struct DiskBound {
  std::size_t ellipse = 0;
  double linear = 0;   ///< L
  double rest = 0;     ///< E
  double weight = 0;   ///< of |area normal| times Jacobian times max |f_j|
  double allowed = 0;  ///< the same times what an error may be relative to instead of max |f_j|

  /// d^2 times the bound of the integrand, infinity where there is none.
  [[nodiscard]] double scaled(double d) const {
    // More than the roundings of the few operations below.
    constexpr double up = 1 + 0x1p-40;
    constexpr double down = 1 - 0x1p-40;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double nearest = (d - linear) * down;
    if (!(nearest > 0)) return infinity;
    const double farthest = (d + linear) * up;
    const double least = nearest * nearest * down - (2 * farthest * rest + rest * rest) * up;
    if (!(least > 0)) return infinity;
    const double ratio = (farthest + rest) * d / least;
    return ratio * ratio * weight * up;
  }
};

}  // namespace radcert
