// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/collocation/certified/certified_entries.h"
#include "radcert/polynomial/lagrange_functions.h"

namespace radcert {

/// The place of each node when the second and third barycentric coordinates change places, if that is a
/// permutation of the nodes and of their functions.
/// Maths     l_j(x1,x3,x2) = l_place[j](x1,x2,x3): that the nodes are symmetric does not make a space of
///           one's own so
/// Requires  nothing
/// Result    exact
[[nodiscard]] std::optional<std::vector<std::size_t>> places_when_exchanged(
    const LagrangeFunctions& functions);

/// A matrix that was made with the second and third corners of some elements exchanged, its rows and columns
/// back in the order of their nodes.
/// Requires  `exchanged` of places_when_exchanged, one flag an element
[[nodiscard]] CertifiedEntries reordered(const CertifiedEntries& matrix,
                                         const std::vector<bool>& is_exchanged,
                                         std::span<const std::size_t> exchanged);

}  // namespace radcert
