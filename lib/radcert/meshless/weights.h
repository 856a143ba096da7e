// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/core/work_limit.h"
#include "radcert/meshless/radial_basis.h"
#include "radcert/scalar/ball.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The integral of a mother function over the plane.
/// Maths     2 pi int_0^support Phi(r) r dr;  spline: 3 pi / 10;  Gaussian: 2 pi (1 - exp(-support^2 / 2))
/// Source    [psg10, section VII], "a fixed constant"
/// Result    enclosed. Refused: Shepard's, which diverges; an expression, which has no closed form here
[[nodiscard]] Outcome<Ball> plane_integral(const MotherFunction& mother);

/// Estimates of w_j = int phi_j dS that look at the sites alone.
/// Maths     plane: constant alpha_j^2, of an element that is not normalised, as if S were a plane;
///           neighbours: pi alpha_j^2 / m, of a normalised one: alpha_j the distance of the m-th other site
/// Source    [psg10, section VII]; the distances of a Poisson process make m the t without bias
/// Result    rounded. plane is refused where plane_integral is, and for absolute radii; neighbours where
///           neighbour_radii is
/// Limits    estimates: nothing bounds them
[[nodiscard]] Outcome<std::vector<double>> plane_weights(const RadialBasis& basis);
[[nodiscard]] Outcome<std::vector<double>> neighbour_weights(const RadialBasis& basis, std::size_t m = 10);
/// 1/delta, delta = n / area everywhere. ContractViolation unless area > 0.
[[nodiscard]] std::vector<double> mean_density_weights(const RadialBasis& basis, double area);

extern const WorkLimit most_integration_points;

/// How far an integration goes.
struct IntegrationDemand {
  double relative_error = 1e-3;                               ///< of each w_j against the mean |w_j|
  std::size_t most_points = most_integration_points.count();  ///< at which elements are evaluated
};

/// Integrals of basis functions over a surface.
struct BasisIntegrals {
  std::vector<double> weights;  ///< w_j
  std::vector<double> errors;   ///< an estimate of the error of each
  double area = 0;              ///< of S, by the same rule
  double area_error =
      std::numeric_limits<double>::infinity();  ///< its difference from that of the cells before
  double uncovered_area = 0;                    ///< of the part of S where the basis has no value
  std::size_t points = 0;
  bool reached = false;  ///< whether the demand was met
};

/// w_j = int phi_j dS by a rule on triangles that are halved until they agree.
/// Maths     sum over cells of the rule of degree 3, cells smaller than h, h/2, h/4, ...
/// Requires  the sites belong to the surface; demand positive, else ContractViolation
/// Result    w_j of the finest cells; errors: the difference from the cells before, and the root mean square
///           of these differences, and the rounding of the sums; infinite where the points did not suffice
///           for cells to compare. Same bits for every number of threads
/// Limits    an estimate, not a bound: elements have edges at the rim of their supports
[[nodiscard]] BasisIntegrals integrate_basis(const RadialBasis& basis, const Surface& surface,
                                             const IntegrationDemand& demand = {});

}  // namespace radcert
