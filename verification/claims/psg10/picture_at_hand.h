// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "radcert/scalar/approximation.h"

namespace radcert::verification::psg10 {

/// A number that would have to be read off a figure of [psg10]. The text at hand has no pictures.
/// Result    without a value or a radius: it leaves what it is held against open
[[nodiscard]] inline Approximation read_off_the_picture() {
  return Approximation::without_radius(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace radcert::verification::psg10
