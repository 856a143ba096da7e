// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/meshless/meshless_choice.h"
#include "radcert/meshless/site.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// Sites anywhere on a surface, with equal chance by area.
/// Maths     density 1/area: a parameter cell with probability |cell| B, B >= |D_s F x D_t F| on the cell, a
///           point of it, kept with probability |D_s F x D_t F| / B
/// Source    rejection sampling
/// Result    exactly `count` sites, the same bits on every machine: the raw std::mt19937_64, and + - * / sqrt
///           alone decide. A point that exceeds B, which is a sampled bound on curved charts, raises it and
///           starts anew, so that what is returned obeyed its bounds. Refused: count = 0
/// Limits    sites may be as close as they like
[[nodiscard]] Outcome<SiteSet> uniform_sites(const Surface& surface, const UniformSites& choice);

/// Sites at least `separation` apart, until there is no room for another.
/// Maths     |p_i^ - p_j^| >= separation for i != j; maximal: every point of S is nearer than separation (1 +
///           2^-10) to a site
/// Source    dart throwing in the cells that are not covered yet, which are divided: Ebeida et al., Efficient
///           maximal Poisson-disk sampling, 2011
/// Result    each new site uniform by area on what is not covered, as in plain dart throwing; the same bits
///           on every machine. On plane charts maximality is exact but for that factor; on curved ones a cell
///           counts as covered if its corners are, by a margin of four times the deviations of the sides'
///           midpoints from the chords. Refused: a separation that is not a positive number, or so small that
///           S is more than 2^22 cells of that size
/// Limits    distances are Euclidean, also around edges and through thin walls
[[nodiscard]] Outcome<SiteSet> poisson_disk_sites(const Surface& surface, const PoissonDiskSites& choice);

/// The one or the other.
[[nodiscard]] Outcome<SiteSet> make_sites(const Surface& surface, const SiteChoice& choice);

}  // namespace radcert
