// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/continuous/enclosure_search.h"
#include "radcert/continuous/observer_cells.h"
#include "radcert/continuous/trial.h"
#include "radcert/scalar/approximation.h"

namespace radcert {

/// What is proved of the residuals on one element X.
/// Maths     norms[k] >= (Int_X rho t_k^2)^(1/2);  products[k] encloses Int_X w_k t_0
struct ElementResidual {
  std::vector<double> norms;
  std::vector<Approximation> products;
};

/// What a proof needs of the residuals t_k = T w_k - q_k of a Trial.
/// Maths     norms[k] >= (Int rho t_k^2)^(1/2);  products[i n + k] encloses Int w_k t_i, n the number of
///           functions; i = 0 alone where no more residuals are asked for
struct ResidualSums {
  std::vector<double> norms;
  std::vector<Approximation> products;
  double sampling = 0;    ///< the part of the products' radius from radii of samples
  double truncation = 0;  ///< from the rules of cells
  double strips = 0;      ///< from strips
  double shade = 0;       ///< from what is shaded
  std::size_t samples = 0;
  std::vector<ElementResidual> elements = {};  ///< where they are asked for
};

/// Sums over cells of observers.
/// Maths     ||t||_X <= (Gauss sum of t^2)^(1/2) + 2 sqrt|X| e, e the cell's interpolation bound: ||f - If||
///           <= 2 sqrt|X| (e_s + e_t), since Gauss rules with n nodes integrate |If|^2 (1-t) exactly and have
///           positive weights; strips by |t| <= sup|w| + sup|q|. Int w_k T w_i by the cells' rules, Int w_k
///           q_i exactly up to rounding. Where parts are shaded from a cell, f is F of Penumbra, and what it
///           leaves of T w is added, in the mean with |w_k| <= sup|w_k| on the element
/// Requires  cells of this trial; products with so many residuals, one where they are by element
/// Result    norms rounded up, products proved; the same bits for any number of threads, and whatever the
///           work has kept of an earlier run
[[nodiscard]] ResidualSums residual_sums(const Trial& trial, std::span<const ObserverCell> cells,
                                         const CellDemand& demand, bool by_element = false,
                                         MeshWork* work = nullptr, std::size_t residuals = 1);

/// The largest values of |t_0| on cells.
/// Maths     |t| <= supremum of the interpolant + L_s L_t times the samples' radius + interpolation_error, L
///           the Lebesgue constants; at an edge of F - q, and |T w - F|
/// Requires  cells of this trial
/// Result    by cell, proved; the same bits for any number of threads
[[nodiscard]] std::vector<double> largest_residuals(const Trial& trial, std::span<const ObserverCell> cells,
                                                    const LargestDemand& demand, MeshWork* work = nullptr);

/// About the norms of the residuals, by one rule on each element.
/// Maths     tensor Gauss rules of degree + 2 nodes, between those at which trial_functions interpolates
/// Result    no bound: what a mesh may be expected to reach
[[nodiscard]] std::vector<double> expected_norms(const Trial& trial);
/// About the largest values of |t_0|, by element, by the same rules.
/// Result    no bound; 0 where nothing reflects
[[nodiscard]] std::vector<double> expected_largest(const Trial& trial);

}  // namespace radcert
