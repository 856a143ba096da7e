// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/scalar/rational.h"

namespace radcert::verification::ac98 {

/// A point of the plane.
struct PlanarPoint {
  Rational x;
  Rational y;
};

/// A rule in the plane, exactly.
struct PlanarRule {
  std::vector<PlanarPoint> points;
  std::vector<Rational> weights;
};

/// The rule of a triangle as it is printed, and not as the library makes it.
/// Maths     Area/3 sum g(mu(q_i)), mu(s,t) = u v_3 + t v_2 + s v_1, {q_i} = {(a,a), (a,1-2a), (1-2a,a)}, a =
///           alpha
/// Source    [ac98, (33), (56), (58)]
/// Result    exact; the vertices may run either way round
[[nodiscard]] PlanarRule printed_rule(const std::array<PlanarPoint, 3>& triangle, const Rational& alpha);

/// Both rules together: an integral over both regions.
[[nodiscard]] PlanarRule together(const PlanarRule& a, const PlanarRule& b);

/// The integral of a monomial over a polygon by Green's theorem.
/// Maths     Int x^a y^b = 1/(a + 1) sum over the sides of Int x^(a+1) y^b dy, positive for a = b = 0
/// Source    Green; no triangle and no barycentric coordinate
/// Requires  a simple polygon, either way round, of area other than zero
/// Result    exact
/// Limits    whether the polygon is simple is not looked at
[[nodiscard]] Rational integral(const std::vector<PlanarPoint>& polygon, int a, int b);

/// The rule minus the integral over the polygon, for x^a y^b.
[[nodiscard]] Rational missed(const PlanarRule& rule, const std::vector<PlanarPoint>& polygon, int a, int b);

/// The degree of precision of a rule for a polygon; -1: not even for constants.
[[nodiscard]] int precision(const PlanarRule& rule, const std::vector<PlanarPoint>& polygon);

}  // namespace radcert::verification::ac98
