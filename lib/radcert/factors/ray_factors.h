// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "radcert/factors/factor_matrix.h"

namespace radcert {

/// How the factors between units are integrated by rays.
struct RayDemand {
  double accuracy = 1e-4;               ///< of each factor and of each row's sum
  bool open_to_space = false;           ///< what a ray does not bring to a front goes to space
  std::uint64_t most_points = 1 << 26;  ///< of each replicate of a row, at most
};

/// The configuration factors between units by rays, whole units at once.
/// Maths     F_IJ = 1/A_I Int_I Int_{u in the hemisphere} [the first triangle along u is of J, and its front]
///           cos / pi du dP, an integral over the cube of four dimensions: a point of I, uniform in area, and
///           a direction, uniform in the disk that the hemisphere covers. Each of 32 replicates takes the
///           points of a SobolNet of its own, with a shift for each row. The exchange areas found from I and
///           from J are put together with weights as the numbers of rays over the areas, so that
///           A_I F_IJ = A_J F_JI
/// Source    randomised quasi-Monte Carlo: Owen, Monte Carlo theory, chapter 17; the disk by Shirley & Chiu,
///           1997
/// Requires  as factor_matrix; accuracy > 0
/// Result    the radius is an estimate: the quantile of Student's distribution that one mean of 32 replicates
///           in 10,000 leaves, times their standard error, and 10 hits over the number of rays, which covers
///           what was hit rarely. The points of a row grow by half until all its radii are at most the
///           accuracy, or the most points are reached: then the radii are what they are. A row's sum has the
///           radius of the replicates' sums. Triangles of one plane and one unit are joined to convex
///           polygons first. Which of these a ray meets is rounded, but none passes between neighbours that
///           have both ends of a side in common; what lies in the plane of its start it does not meet, and
///           of the two sides of a plate it meets the one that looks at it. Hits are whole numbers: the same
///           bits for any number of threads
/// Limits    a unit that is seen through a slit of less than the tenth of the accuracy may be missed: it lies
///           within the radius. Holds 32 whole numbers for each pair of units
[[nodiscard]] FactorMatrix ray_factors(const FacetScene& scene, const FactorUnits& units,
                                       const RayDemand& demand, const FactorProgress& progress);

/// What that will take, from a first round of rays; `pairs` is the number of rays.
[[nodiscard]] FactorPlan ray_plan(const FacetScene& scene, const FactorUnits& units, const RayDemand& demand);

}  // namespace radcert
