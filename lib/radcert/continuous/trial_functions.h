// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/enclosure_search.h"
#include "radcert/continuous/reflectivity.h"

namespace radcert {

/// Functions that are constant on panels.
/// Maths     values by function, panel
[[nodiscard]] SectorFunctions panel_functions(const SectorScene& scene,
                                              std::span<const SectorElement> elements,
                                              const std::vector<std::vector<double>>& values, int degree);

/// w_k = E_k + rho q_k, rounded.
/// Requires  E of the degree of q and that of rho together, else ContractViolation
/// Result    off by ElementReflectivity::rounding on each element
[[nodiscard]] SectorFunctions densities(const ElementReflectivity& reflectivity,
                                        const SectorFunctions& emissions, const SectorFunctions& q);

/// Functions q_k for which q_k = T(E_k + rho q_k) nearly holds, polynomials of the degree of E less that of
/// rho.
/// Maths     interpolation at the tensor Gauss nodes of each element: q = P T (E + rho q), by GMRES for each
///           k, the products with T for all at once; q = 0 on elements on which rho is
/// Source    K. Atkinson, "The Numerical Solution of Integral Equations of the Second Kind", 1997, chapter 3
/// Requires  degrees from that of rho to below most_gauss_nodes, else ContractViolation
/// Result    floating point, no guarantee: what a proof needs is enclosed afterwards from the functions as
///           they are. The same bits for any number of threads
[[nodiscard]] SectorFunctions trial_functions(const SectorScene& scene,
                                              std::span<const SectorElement> elements,
                                              const Reflectivity& reflectivity,
                                              const SectorFunctions& emissions, double tolerance);

/// The functions that find() gives, or those that the work on a mesh has kept of them; so many, of this
/// degree.
template <class Find>
[[nodiscard]] SectorFunctions kept_functions(const MeshWork& work, std::size_t count, int degree,
                                             std::size_t elements, const Find& find) {
  SectorFunctions out(elements, count, degree);
  const std::vector<double> numbers = work.numbers("functions", out.all().size(), [&] {
    const SectorFunctions found = find();
    return std::vector<double>(found.all().begin(), found.all().end());
  });
  std::copy(numbers.begin(), numbers.end(), out.all().begin());
  return out;
}

}  // namespace radcert
