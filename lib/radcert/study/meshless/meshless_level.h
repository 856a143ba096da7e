// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/study/problem.h"
#include "radcert/study/study.h"

namespace radcert {

/// Solves a problem with a meshless basis at one level.
/// Maths     (I - R) lambda = epsilon at the sites p_i, u_n = sum_j lambda_j phi_j; E = u - Ku at the sites
/// Source    [psg10, (6), (19), section VII]
/// Requires  a checked problem with a meshless basis
/// Result    node_error = max over the sites of |u - u_n|; uniform_error over the points that collocation at
///           this level looks at; discretisation_error is absent: point lights are no K(I-P_n). elements and
///           unknowns: sites; mesh_size: site_spacing. The same bits for any number of threads. Throws
///           InputError at the place in /basis that leaves no basis, or where a point of S has no site in
///           reach, at /reflectivity for an albedo from 1; AccuracyNotReached where the reflections would
///           grow; Interrupted when asked to stop
/// Limits    radii are estimates, of the route, of integrated weights as if their errors were independent,
///           and of the solver. On an open surface norm_K is an estimate from the point lights, at most the
///           largest reflectivity
[[nodiscard]] LevelOutcome meshless_level(const Problem& problem, int level, const OperatorRoute& route);

}  // namespace radcert
