// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "radcert/scalar/approximation.h"

namespace radcert {

/// The ratio of the errors of two levels, the coarser first.
/// Result    none without both errors, or where the finer one is not positive
[[nodiscard]] std::optional<double> error_ratio(const std::optional<Approximation>& before,
                                                const std::optional<Approximation>& now);

/// The exponent of the mesh size by which an error falls from one level to the next: of all tables and files
/// the one that tells it.
/// Maths     log(e_before / e_now) / log(h_before / h_now)
/// Result    none where there is no positive ratio of the errors, or where h does not fall
/// Limits    of two levels: says nothing about the limit
[[nodiscard]] std::optional<double> error_order(const std::optional<Approximation>& before, double h_before,
                                                const std::optional<Approximation>& now, double h_now);

}  // namespace radcert
