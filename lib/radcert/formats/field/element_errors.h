// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/study/study.h"

namespace radcert {

/// |u - u_n| at the corners of each element, or that of the iterated solution.
using CornerErrors = std::vector<std::array<double, 3>>;

/// The error at the corners of elements, for pictures.
/// Maths     |u - u_n| at the three corners, u_n as the element has it
/// Requires  elements of that problem
/// Result    in the order of the elements; none without a solution, or where u is not finite at a corner
/// Limits    rounded; a picture's figure, the largest of them is no bound of the error
[[nodiscard]] std::optional<CornerErrors> corner_errors(const Problem& problem,
                                                        std::span<const ElementValue> elements);

/// The same of the iterated solution; none where it was not taken.
/// Maths     |u - E - K u_n|
[[nodiscard]] std::optional<CornerErrors> iterated_corner_errors(const Problem& problem,
                                                                 std::span<const ElementValue> elements);

/// The names of the pieces of elements, each once, in the order of appearance.
[[nodiscard]] std::vector<std::string> pieces_of(std::span<const ElementValue> elements);

}  // namespace radcert
