// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace radcert {

/// Above the roundings of a bound, which is made of a few dozen products, quotients and sums of positive
/// numbers.
/// Result    2^-40 is 8192 units: a sum of more terms has a factor of its own
inline constexpr double upward = 1 + 0x1p-40;

}  // namespace radcert
