// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/core/work_limit.h"
#include "radcert/solve/system_matrix.h"

namespace radcert {

extern const WorkLimit conjugate_directions;

/// A vector near the solution of a symmetric positive definite system, and how near.
struct DefiniteSolution {
  std::vector<double> values;
  std::size_t iterations = 0;
  double residual = 0;      ///< >= ||b - (I - K) v||_2, proved
  double error_bound = 0;   ///< >= ||x - v||_2
  double energy_bound = 0;  ///< >= ||x - v||_S, the square root of (x - v)^T S (x - v), S = I - K
};

/// A symmetric positive definite system by conjugate gradients.
/// Maths     S x = b, S = I - K. Theorem: if v^T S v >= lower v^T v for all v, then with r = b - S v
///             ||x - v||_2 <= ||r||_2 / lower,   ||x - v||_S <= ||r||_2 / sqrt(lower).
///           Proof: S (x - v) = r. With e = x - v: lower ||e||_2^2 <= e^T S e = e^T r <= ||e||_2 ||r||_2,
///           which gives the first, and with it e^T S e <= ||r||_2^2 / lower, the second.
///           Steps from a residual in twice the precision, restarted from one until the bound reaches the
///           tolerance or rounding ends the descent
/// Source    Hestenes, Stiefel, Methods of conjugate gradients for solving linear systems, 1952; the residual
///           as accurate_residual, whose errors are counted in `residual`: in the 2-norm u ||r|| + ((n + 4)
///           u)^2 (||b|| + ||v|| + kappa ||v||), kappa the largest row sum of |K|, which bounds the norm of
///           |K| since |K| is symmetric. The right-hand side is scaled by a power of two, its largest entry
///           to at least 1 and below 2, which moves no bit within the normal range; the rounding of v below
///           it is counted
/// Requires  K symmetric, lower > 0 as above, which is the caller's to prove; tolerance absent or > 0
/// Result    with a tolerance error_bound <= tolerance ||v||_2, without one until it no longer halves.
///           Refused where the tolerance is not reached, where numbers are not finite, or where a direction d
///           shows d^T S d <= 0: then lower was no bound. The same bits for any number of threads;
///           Interrupted when asked to stop
/// Limits    the matrix and b are taken as exact; with an operator its rounding() is counted
[[nodiscard]] Outcome<DefiniteSolution> solve_by_conjugate_gradients(const SystemProducts& k,
                                                                     std::span<const double> b, double lower,
                                                                     std::optional<double> tolerance);

}  // namespace radcert
