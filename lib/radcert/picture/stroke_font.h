// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/picture/camera.h"

namespace radcert {

/// A letter as lines.
/// Maths     coordinates on a grid: x from 0, y upwards from the base line; capital letters are 8 high
/// Source    drawn for radcert
/// Requires  -
/// Result    plain data
/// Limits    -
struct StrokeLetter {
  double advance = 0;  ///< to the next letter
  std::vector<std::vector<ImagePoint>> strokes;
};

/// How high a capital letter is in these units.
inline constexpr double stroke_capital_height = 8;

/// The letter of a character; ContractViolation unless it is printable ASCII.
[[nodiscard]] const StrokeLetter& stroke_letter(char c);

}  // namespace radcert
