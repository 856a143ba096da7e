// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "radcert/surface/catalogue/triangle.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The boundary of a regular tetrahedron, whose corners are four of the cube [-1,1]^3.
/// Maths     corners (1,1,1), (1,-1,-1), (-1,1,-1), (-1,-1,1); edges of length 2 sqrt(2), centre 0
/// Source    two faces of it exchange 1/3: see regular_tetrahedron in closed_form/factor_catalogue.h
/// Requires  -
/// Result    pieces face_mmm, face_mpp, face_pmp, face_ppm, each named by the signs of its outer normal, and opposite to the
///           corner in the other direction
/// Limits    one size: the corners of a regular tetrahedron are rational at few others
inline Surface tetrahedron() {
  const std::array<Vector<Rational>, 4> corners{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  Surface surface;
  surface.name = "tetrahedron";
  for (std::size_t opposite = 0; opposite < corners.size(); ++opposite) {
    std::string name = "face_";
    for (const Rational& x : {corners[opposite].x, corners[opposite].y, corners[opposite].z})
      name += x.sign() < 0 ? 'p' : 'm';
    const auto corner = [&](std::size_t i) { return corners[(opposite + i) % corners.size()]; };
    surface.charts.push_back(
        make_triangle({.name = name, .piece = name}, corner(1), corner(2), corner(3), {0, 0, 0}));
    surface.diagonals.push_back(Diagonal::main);
  }
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

}  // namespace radcert
