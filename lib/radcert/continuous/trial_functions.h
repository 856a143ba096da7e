// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/graded_elements.h"
#include "radcert/continuous/sector.h"
#include "radcert/continuous/tensor_legendre.h"

namespace radcert {

/// The data of the radiosity equation on panels: one reflectivity, several emissions.
/// Maths     rho and E_k constant on each panel
struct PanelData {
  std::vector<double> reflectivity;            ///< by panel
  std::vector<std::vector<double>> emissions;  ///< by function, panel
};

/// w_k = E_k + rho q_k, rounded.
/// Result    each coefficient within 2 u of |E_k| + rho |q_k|'s
[[nodiscard]] SectorFunctions densities(const SectorScene& scene, std::span<const SectorElement> elements,
                                        const PanelData& data, const SectorFunctions& q);

/// Functions q_k for which q_k = T(E_k + rho q_k) nearly holds.
/// Maths     interpolation at the tensor Gauss nodes of each element: q = P T (E + rho q), by GMRES for each
///           k, the products with T for all at once
/// Source    K. Atkinson, "The Numerical Solution of Integral Equations of the Second Kind", 1997, chapter 3
/// Requires  0 <= degree < most_gauss_nodes, else ContractViolation
/// Result    floating point, no guarantee: what a proof needs is enclosed afterwards from the functions as
///           they are. The same bits for any number of threads
[[nodiscard]] SectorFunctions trial_functions(const SectorScene& scene,
                                              std::span<const SectorElement> elements, const PanelData& data,
                                              int degree, double tolerance);

}  // namespace radcert
