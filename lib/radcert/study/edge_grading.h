// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "radcert/scalar/approximation.h"
#include "radcert/scalar/rational.h"
#include "radcert/study/problem.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// An edge at which two faces see each other, and what it asks of a mesh.
struct GradedEdge {
  std::array<std::string, 2> pieces;
  double degrees = 0;                      ///< the dihedral angle, rounded
  std::array<Rational, 2> reflectivities;  ///< the largest on the edge
  double exponent = 1;                     ///< with which u departs from smooth functions
  Rational grading = 1;                    ///< that this edge alone asks for
};

/// A corner of three faces at right angles to each other, likewise.
struct GradedCorner {
  std::array<std::string, 3> pieces;
  Approximation exponent;
  Rational grading = 1;
};

/// The grading that the exponents of edges and corners ask for: the largest of theirs.
struct EdgeGrading {
  Rational grading = 1;
  std::vector<GradedEdge> edges;
  std::vector<GradedCorner> corners;
};

/// The grading of `"grading": "edges"`.
/// Maths     (r + 1)/b, rounded up to a multiple of 1/64 and at least 1, b the least exponent of all edges
///           and corners, r the degree of the basis: with vertices at c^q u ~ r^b is interpolated with the
///           error h^(q b) beside an edge, and h^(r+1) is the order of smooth functions. One exponent serves
///           the whole triangulation. At an edge b is the smallest exponent, with the largest reflectivities
///           on the edge: those of constant functions, or of 65 points of it; 1, that of r log r, where one
///           face reflects nothing. At a corner of three faces at right angles it is octant_exponent, an
///           estimate; where two faces meet at the end of their edge, they send no more to each other than in
///           an infinite wedge
/// Source    ours; edge_exponents.h, corner_exponent.h
/// Requires  the problem's surface
/// Result    or InputError at /triangulation/grading: a basis without degree, a face that is no plane unit
///           square, a corner of other faces, a reflectivity not below 1, an exponent that was not found
/// Limits    faces that share a part of a side only are not looked at. Where u has no limit at a corner no
///           grading makes it converge there. Of the light that leaves the three faces at a right-angled
///           corner each receives 3/4, of constant functions; so u has the limit (E + rho s)/(1 - 3 rho/4)
///           there if all three have the same E, rho and light s from elsewhere, and in general none: on the
///           cube E = 1 + x has one limit at each corner, s two
[[nodiscard]] EdgeGrading edge_grading(const Problem& problem, const Surface& surface);

/// The same, for a record of what edges and corners ask for, whatever the grading of the problem is.
/// Result    nothing where edge_grading refuses
[[nodiscard]] std::optional<EdgeGrading> known_edge_grading(const Problem& problem, const Surface& surface);

}  // namespace radcert
