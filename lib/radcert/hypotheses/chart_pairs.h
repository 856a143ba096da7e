// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "radcert/hypotheses/chart_patch.h"

namespace radcert {

/// The result of a search over pairs of boxes.
struct PairSearch {
  std::size_t boxes_left =
      0;  ///< pairs of boxes not decided: with none and no witness the statement is proved
  std::optional<std::pair<ParameterPoint<double>, ParameterPoint<double>>> witness =
      std::nullopt;  ///< p and q with a product certainly negative
};

/// Whether one chart lies on the inner side of all tangent planes of another.
/// Maths     g(p, q) = (F_B(q) - F_A(p)) . N_A(p) > 0 over a pair of boxes X, Y: by the enclosure of g, or by
///           its mean value form
///             g(X,Y) in g(x,y) + D F_B(Y) . N_A(X) (Y - y) + (F_B(Y) - F_A(X)) . D N_A(X) (X - x),
///           x, y the centres, for N_A . D F_A = 0. Of one chart also g >= 0, if N(p) . D^2 F(r)(w,w) is
///           positive definite for all p, r of the box about X and Y: g(p, p + w) = int_0^1 (1 - l) N(p) .
///           D^2 F(p + l w)(w,w) dl
/// Source    R. E. Moore, R. B. Kearfott, M. J. Cloud, "Introduction to Interval Analysis", 2009, section
///           6.3; Taylor's formula
/// Requires  tables of charts with formulas in balls; for one chart both tables are the same object
/// Result    pairs are bisected first come, first served: across the side that the mean value form owes most
///           of its width to; near the diagonal across the longest, and a box with itself in both
/// Limits    at most `limit` pairs; ends without a proof where the charts touch
[[nodiscard]] PairSearch search_pairs(PatchTable& of_p, PatchTable& of_q, std::size_t limit,
                                      std::size_t& boxes);

}  // namespace radcert
