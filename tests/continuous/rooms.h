// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "radcert/continuous/elements/panel.h"
#include "radcert/continuous/polyhedron_problem.h"

namespace radcert::test {

using Corners = std::vector<Vector<Rational>>;

/// The corners run counterclockwise as seen from the inside.
inline Panel panel_with(std::size_t piece, Corners corners) {
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : corners) sum = sum + corner;
  const Vector<Rational> normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const Rational share(1, static_cast<long>(corners.size()));
  return {.piece = piece, .corners = std::move(corners), .centre = share * sum, .normal = normal};
}

/// A room over the square of the side 2 without that part of it where x > 1 and y > 1, of the height 1.
/// Result    floor, ceiling, south, west, east, north, and the two walls at the edge that looks inwards
inline std::vector<Panel> l_room() {
  std::vector<Panel> panels;
  const auto flat = [&](std::size_t piece, long x0, long x1, long y0, long y1, bool up) {
    Corners c{{x0, y0, up ? 0 : 1}, {x1, y0, up ? 0 : 1}, {x1, y1, up ? 0 : 1}, {x0, y1, up ? 0 : 1}};
    if (!up) std::reverse(c.begin(), c.end());
    panels.push_back(panel_with(piece, std::move(c)));
  };
  const auto wall = [&](std::size_t piece, long x0, long y0, long x1, long y1) {
    panels.push_back(panel_with(piece, {{x0, y0, 0}, {x0, y0, 1}, {x1, y1, 1}, {x1, y1, 0}}));
  };
  flat(0, 0, 2, 0, 1, true);
  flat(0, 0, 1, 1, 2, true);
  flat(1, 0, 2, 0, 1, false);
  flat(1, 0, 1, 1, 2, false);
  wall(2, 0, 0, 2, 0);
  wall(3, 0, 2, 0, 0);
  wall(4, 2, 0, 2, 1);
  wall(5, 1, 2, 0, 2);
  wall(6, 2, 1, 1, 1);
  wall(7, 1, 1, 1, 2);
  return panels;
}

/// A cube of the side 3 about one of the side 1.
/// Result    the six faces outside, then those inside
inline std::vector<Panel> cube_in_a_cube() {
  std::vector<Panel> panels;
  const auto faces = [&](long from, long to, bool inwards) {
    const std::array<long, 2> at{from, to};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t end = 0; end < 2; ++end) {
        Corners c;
        for (const auto& [u, v] : {std::array<long, 2>{from, from}, {to, from}, {to, to}, {from, to}}) {
          std::array<long, 3> p{};
          p[axis] = at[end];
          p[(axis + 1) % 3] = u;
          p[(axis + 2) % 3] = v;
          c.push_back({p[0], p[1], p[2]});
        }
        if ((end == 0) != inwards) std::reverse(c.begin(), c.end());
        panels.push_back(panel_with(panels.size(), std::move(c)));
      }
  };
  faces(0, 3, true);
  faces(1, 2, false);
  return panels;
}

/// Cut along the planes of all.
inline std::vector<Panel> cut(const std::vector<Panel>& panels) { return cut_panels(panels, 300).value(); }

/// Constants on the panels of a room whose parts hide each other.
inline PolyhedronProblem occluded_problem(std::vector<Panel> blockers, const std::vector<Rational>& rho,
                                          const std::vector<Rational>& emission) {
  PolyhedronProblem out;
  out.panels = cut(blockers);
  for (const Panel& panel : out.panels) {
    out.reflectivity.push_back(rho[panel.piece]);
    out.emission.push_back(constant_polynomial(emission[panel.piece]));
  }
  out.blockers = std::move(blockers);
  return out;
}

}  // namespace radcert::test
