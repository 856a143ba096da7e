// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "radcert/scalar/real.h"

namespace radcert {

/// Barycentric coordinates on a triangle.
/// Maths     x_1 + x_2 + x_3 = 1; the point x_1 v_1 + x_2 v_2 + x_3 v_3.  On the reference triangle sigma of
///           the papers (x_1, x_2, x_3) = (u, t, s), u = 1 - s - t, so that v_1, v_2, v_3 are numbered as in
///           [m06, (12)]
/// Source    [m06, (12)]; [ac98, (29)] numbers the same vertices v_3, v_2, v_1: see papers/notation.md
/// Result    plain coordinates; nothing is normalised
template <Field R>
struct Barycentric {
  std::array<R, 3> x{};

  friend bool operator==(const Barycentric& a, const Barycentric& b) = default;
};

}  // namespace radcert
