// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "verification/claims/psg10/sphere_over_disk/solution.h"

namespace radcert::verification::psg10 {

/// Where "equally spaced" points of an interval lie.
enum class Spacing {
  midpoints,  ///< of equal parts: the weights of (22)-(23) are then those of a rule
  with_ends,  ///< both ends among the points; the weights of (22)-(23) add up to more than the interval
};

/// Which matrix is iterated.
enum class SumWeights {
  /// That of (22)-(23): R/n u_j 2 pi/k from the disk, pi/m r^2 cos zeta_i 2 pi/k from the sphere
  of_the_sums,
  as_in_the_text,  ///< (25) to the letter: beta and the sum over the azimuths, no other factor
  with_the_radii,  ///< (25) with the factor u_j in M alone
};

/// How the paper's sums are read.
/// Maths     form_factor: F = form_factor cos cos'/(pi d^2) where the points face each other. 1: a surface of
///           albedo beta reflects beta of what arrives; 1/2: rho G of section II is 2 beta cos cos'/(4 pi
///           d^2); 1/4: G of section II alone
/// Source    [psg10, (2)-(5), (21)-(25)]
/// Requires  counts >= 2
/// Result    plain data; the defaults are n = m = k = 100 and the physical factor
struct SumReading {
  int rings = 100;      ///< n
  int parallels = 100;  ///< m
  int azimuths = 100;   ///< k
  Spacing spacing = Spacing::midpoints;
  SumWeights weights = SumWeights::of_the_sums;
  Rational form_factor = 1;
};

/// What the sums give.
struct SumSolution {
  std::vector<double> latitudes;  ///< zeta_i
  std::vector<double> distances;  ///< u_j
  std::vector<double> sphere;     ///< b_i
  std::vector<double> disk;       ///< d_j
  std::vector<double> changes;    ///< of lambda in each iteration, in the maximum norm
};

/// The paper's discretisation of the scene, by iteration.
/// Maths     lambda <- epsilon + R lambda from lambda = 0, R of (24)
/// Source    [psg10, (20)-(25)]
/// Requires  allows(scene), counts of at least 2, 1 <= iterations, 0 <= tolerance, else ContractViolation
/// Result    after the iteration whose change is at most the tolerance, or the last; rounded
/// Limits    an iteration that diverges is seen by its changes
[[nodiscard]] SumSolution sum_solution(const SphereOverDiskScene& scene, const SumReading& reading,
                                       int iterations, double tolerance);

}  // namespace radcert::verification::psg10
