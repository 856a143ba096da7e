// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "radcert/hypotheses/convex_containment.h"

namespace radcert {

/// A pair of parameters as a witness, if it is one.
/// Maths     (F_q(w) - F_p(v)) . N_p(v), enclosed
/// Requires  charts with formulas in balls; parameters in their domains
/// Result    a witness exactly if the product is certainly negative at 192 bits
[[nodiscard]] std::optional<ChartWitness> witness_at(const Surface& surface, std::size_t chart_p,
                                                     const ParameterPoint<double>& p, std::size_t chart_q,
                                                     const ParameterPoint<double>& q);

/// A witness among the pairs of a lattice on all charts: the pair with the smallest (Q - P) . n_P / |Q - P|.
/// Maths     parameters that are multiples of a power of two, about 1500 points in all
/// Source    a search in doubles, confirmed in balls
/// Result    nothing where that pair is none
/// Limits    finds what is far from convex
[[nodiscard]] std::optional<ChartWitness> witness_on_lattices(const Surface& surface);

/// A witness near the points of the same lattice: along the direction in which the second fundamental form is
/// least, and across points that two charts have in common.
/// Maths     the steps are halved down to 2^-40 of the domain
/// Source    as witness_on_lattices
/// Result    nothing where none is found
/// Limits    dents and creases that meet no point of the lattice are missed
[[nodiscard]] std::optional<ChartWitness> witness_nearby(const Surface& surface);

/// How deep a witness lies.
/// Maths     -product / (|n| d), d the diagonal of the box about the points of the lattice
/// Requires  a witness of the surface
/// Result    rounded
[[nodiscard]] double relative_depth(const Surface& surface, const ChartWitness& witness);

}  // namespace radcert
