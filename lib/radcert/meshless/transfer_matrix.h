// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "radcert/core/matrix.h"
#include "radcert/core/memory_plan.h"
#include "radcert/meshless/light_scene.h"
#include "radcert/meshless/site.h"

namespace radcert {

/// The light that a surface element at one site sends to another, with V = 1.
/// Maths     max(0, n_p.(q-p)) max(0, n_q.(p-q)) / |p-q|^4
/// Source    [psg10, (3)-(5)]: cos cos' / d^2
/// Requires  unit normals
/// Result    rounded; 0 for p = q
/// Limits    unbounded where the two come together at an angle
[[nodiscard]] double site_kernel(const Site<double>& p, const Site<double>& q);

/// The radiance of the sites by light scattered once from point lights at the sites.
/// Maths     N_ij = beta_i/pi site_kernel(p_i, p_j) V(p_i, p_j) w_j
/// Source    [psg10, section VII]; a surface of albedo beta scatters beta of what arrives, with the print,
///           rho = 2 beta times the 1/(4 pi) of K, half of that
/// Requires  sites of the scene's surface, as many weights
/// Result    n by n, rounded; each pair is looked at once, V is exact for the sites' doubles. The same bits
///           for any number of threads; Interrupted when asked to stop; InputError if n^2 numbers exceed the
///           memory that is available
/// Limits    point lights: entries grow without bound where sites come together in a corner; see
///           transfer_sums
[[nodiscard]] Matrix<double> point_light_transfer(const LightScene& scene, const SiteSet& sites,
                                                  std::span<const double> weights);

/// The same with an albedo for each site in place of the scene's; as many albedos as sites, else
/// ContractViolation.
[[nodiscard]] Matrix<double> point_light_transfer(const LightScene& scene, const SiteSet& sites,
                                                  std::span<const double> albedos,
                                                  std::span<const double> weights);

/// What `matrices` matrices of n sites take, in bytes.
[[nodiscard]] MemoryPlan transfer_memory(std::size_t sites, std::size_t matrices);

/// How a matrix acts on what it is iterated on.
struct TransferSums {
  double largest_row_sum = 0;  ///< max_i |sum_j a_ij|
  std::size_t row = 0;         ///< where
  double largest_entry = 0;    ///< max |a_ij|
  /// (|R^k x| / |R^(k-d) x|)^(1/d) in the maximum norm: an estimate of the spectral radius, no bound.
  double spectral_radius = 0;
};

/// Row sums and an estimate of the spectral radius.
/// Maths     power iteration from a vector of both long and short waves; the geometric mean over the last ten
///           of thirty steps evens out what comes and goes with complex eigenvalues, or with signs
/// Source    R. von Mises (1929)
/// Requires  a square matrix, not empty, of finite numbers
/// Result    rounded; 0 where a power vanishes
/// Limits    an estimate. find_contraction (solve/contraction.h) has a bound from above, of |R|
[[nodiscard]] TransferSums transfer_sums(const Matrix<double>& r);

}  // namespace radcert
