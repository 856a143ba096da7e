// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/surface/surface.h"

namespace radcert {

/// The piece of every chart of a surface, for work on all of them: Surface::piece_of looks for one.
/// Result    chart_pieces(s)[k] = s.piece_of(k)
[[nodiscard]] std::vector<std::size_t> chart_pieces(const Surface& surface);

}  // namespace radcert
