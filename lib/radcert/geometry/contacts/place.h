// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "radcert/geometry/vector.h"

namespace radcert {

/// The doubles of a point as a key; zeros without a sign, so that equal points are equal keys.
using Place = std::array<double, 3>;

/// The key of a point.
[[nodiscard]] inline Place place_of(const Vector<double>& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

}  // namespace radcert
