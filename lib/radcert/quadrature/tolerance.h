// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace radcert {

/// The relative difference of two rules at which an integral counts as converged: a few hundred roundings, so that the
/// difference is seldom the larger part of the radius.
inline constexpr double converged_difference = 2e-14;

/// What is asked of the error model when an order is chosen: rho^(-2 order) below it.
inline constexpr double intended_truncation = 1e-15;

}  // namespace radcert
