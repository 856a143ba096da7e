// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "radcert/scalar/rational.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/rational_function.h"

namespace radcert::verification::m06 {

/// Points and triangles of a parameter plane, in fractions or with variables for coordinates.
template <class R>
using CornerOf = std::array<R, 2>;
template <class R>
using TriangleOf = std::array<CornerOf<R>, 3>;
using Corner = CornerOf<Rational>;
using Triangle = TriangleOf<Rational>;

/// The triangles into which symmetric refinement divides one, written down once more.
/// Maths     p_ij = v_i + part (v_j - v_i), part = 1/2: (v_1, p_12, p_31), (p_12, v_2, p_23), (p_31, p_23,
///           v_3), (p_23, p_31, p_12). With variables for the coordinates what is found of them holds for all
///           triangles, and by induction at all levels
/// Source    [m06, section 3.1, before Theorem 7]
/// Result    exact; another part than 1/2 is meant for controls
template <class R>
std::array<TriangleOf<R>, 4> children(const TriangleOf<R>& v, const Rational& part = Rational(1, 2)) {
  const auto between = [&part](const CornerOf<R>& a, const CornerOf<R>& b) {
    return CornerOf<R>{a[0] + R(part) * (b[0] - a[0]), a[1] + R(part) * (b[1] - a[1])};
  };
  const CornerOf<R> p12 = between(v[0], v[1]);
  const CornerOf<R> p23 = between(v[1], v[2]);
  const CornerOf<R> p31 = between(v[2], v[0]);
  return {TriangleOf<R>{v[0], p12, p31}, {p12, v[1], p23}, {p31, p23, v[2]}, {p23, p31, p12}};
}

/// Twice the area of a triangle that runs counterclockwise.
template <class R>
R twice_area(const CornerOf<R>& a, const CornerOf<R>& b, const CornerOf<R>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

/// A triangle with six variables for its coordinates.
[[nodiscard]] TriangleOf<Polynomial> any_triangle();

/// How the sides of the children differ from halves of those of their parent, for any triangle.
/// Result    the terms that are left of child's side -+ parent's side/2, all sides of all children: zero if
///           every child is its parent halved, the fourth turned by a half turn as well. Then the largest
///           diameter is halved, angles and ratios of lengths stay, and areas are divided by four
[[nodiscard]] Rational terms_of_halved_sides(const Rational& part = Rational(1, 2));

/// The parameter triangles of a chart at a level, exactly.
[[nodiscard]] std::vector<Triangle> triangles_of(const Surface& surface, int level, std::size_t chart,
                                                 const TriangulationOptions& options = {});

/// How many triangles of the levels 1 to `levels`, on all charts, are not the children of those of the level
/// before, each in its place.
[[nodiscard]] Rational differing_children(const Surface& surface, int levels,
                                          const TriangulationOptions& options = {});

/// A triangulation of a parameter domain.
struct Domain {
  std::string name;
  std::vector<Corner> corners;  ///< of the domain, counterclockwise
  std::vector<Triangle> triangles;
};

/// The triangulations that all of the catalogue begin with, refined: of the unit triangle, and of the unit
/// square with either diagonal.
[[nodiscard]] std::vector<Domain> domains(int level);

/// ", unit triangle, level 2".
[[nodiscard]] std::string named(const Domain& domain, int level);

}  // namespace radcert::verification::m06
