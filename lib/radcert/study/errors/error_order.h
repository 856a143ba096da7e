// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "radcert/scalar/approximation.h"

namespace radcert {

/// Whether an error stands so far above its radius that orders are made of it.
/// Maths     positive and finite, with a radius of at most a twentieth of it: the ratio of two such errors is
///           known within about a tenth, and an order from h to h/2 within 0.15
/// Result    false for one without a radius: nothing is known of what it is made of
[[nodiscard]] bool stands_above_radius(const Approximation& error);

/// The ratio of the errors of two levels, the coarser first.
/// Result    none where there are not both errors, or one does not stand above its radius
[[nodiscard]] std::optional<double> error_ratio(const std::optional<Approximation>& before,
                                                const std::optional<Approximation>& now);

/// The exponent of the mesh size by which an error falls from one level to the next: of all tables and files
/// the one that tells it.
/// Maths     log(e_before / e_now) / log(h_before / h_now)
/// Result    none where there is no ratio of the errors, or where h does not fall
/// Limits    of two levels: says nothing about the limit
[[nodiscard]] std::optional<double> error_order(const std::optional<Approximation>& before, double h_before,
                                                const std::optional<Approximation>& now, double h_now);

}  // namespace radcert
