// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "radcert/core/outcome.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/iteration.h"

namespace radcert {

/// The collocation system by the Neumann series: light reflected once more in each step.
/// Maths     v_0 = e, v_{m+1} = e + K v_m = v_m + r_m, r_m = e - (I - K) v_m; ||r_m||_w <= theta^m ||r_0||_w
/// Source    [psg10] (its iteration); the bound and the rule for stopping: iterate
/// Requires  as iterate
/// Result    as iterate; `iterations` counts reflections, at most log(goal)/log(theta) of them but for
///           rounding
/// Limits    slow where the spectral radius of K is near 1: GMRES needs a fraction of the products
Outcome<IterativeSolution, NotReached> solve_by_neumann(const SystemProducts& k,
                                                        const Contraction& contraction,
                                                        std::span<const double> e,
                                                        std::optional<double> tolerance = std::nullopt,
                                                        KeptNumbers* kept = nullptr);

}  // namespace radcert
