// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "radcert/core/outcome.h"
#include "radcert/core/work_limit.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/iteration.h"

namespace radcert {

/// The largest number of Krylov vectors that GMRES holds, the first not counted.
extern const WorkLimit krylov_dimension;

/// The collocation system by GMRES, refined until the error bound is small enough.
/// Maths     d minimises ||r - (I - K) d||_2 over span{r, K r, ..., K^(m-1) r}, m growing until the residual
///           has fallen to 2^-36 of r, or to the goal, or m = krylov_dimension; v <- v + d with the residual
///           r of v in twice the precision, so that the rounding of d does not limit v
/// Source    Saad, Schultz (1986); orthogonalised twice by modified Gram-Schmidt: Giraud, Langou, Rozloznik
///           (2005)
/// Requires  as iterate
/// Result    as iterate; `iterations` counts Krylov vectors
/// Limits    holds krylov_dimension + 1 vectors and no second matrix. Written out here, because library
///           versions stop by the 2-norm of a residual that they update and do not compute, and sum in an
///           order that depends on the machine
Outcome<IterativeSolution, NotReached> solve_by_gmres(const SystemProducts& k, const Contraction& contraction,
                                                      std::span<const double> e,
                                                      std::optional<double> tolerance = std::nullopt,
                                                      KeptNumbers* kept = nullptr);

}  // namespace radcert
