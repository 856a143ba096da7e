// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/meshless/site.h"
#include "radcert/scalar/ball.h"

namespace radcert::verification::psg10 {

/// The site at the origin with the normal e_z.
[[nodiscard]] inline Site<Ball> upright_site() { return {{0, 0, 0}, {0, 0, 1}}; }

/// All points of a square 1 above it whose normals have a cosine with e_z in an interval.
[[nodiscard]] inline Site<Ball> sites_with_cosine(const Ball& cosine) {
  const Ball any = hull(Ball(-1), Ball(1));
  return {{Ball(100) * any, Ball(100) * any, 1}, {any, any, cosine}};
}

/// Cosines of 90 degrees or more.
/// Result    0, and intervals that cover [-1, -2^-60]
[[nodiscard]] inline std::vector<Ball> cosines_turned_away() {
  std::vector<Ball> cosines{Ball(0)};
  Ball largest(-1);
  for (int k = 0; k < 60; ++k) {
    const Ball next = largest / Ball(2);
    cosines.push_back(hull(largest, next));
    largest = next;
  }
  return cosines;
}

}  // namespace radcert::verification::psg10
