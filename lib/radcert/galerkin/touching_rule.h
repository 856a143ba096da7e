// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/polynomial/barycentric.h"

namespace radcert {

/// A point on each of two triangles, with a weight.
struct PointPair {
  Barycentric<double> first;
  Barycentric<double> second;
  double weight = 0;
};

/// A rule for the integral over two triangles that touch, of a kernel that is singular where they do.
/// Maths     Int_T Int_T f(x,y) dx dy, T the reference triangle, ~ sum weight f(first, second). The four
///           variables are xi, the size of the configuration, and three that say its shape; T x T is cut into
///           6, 5 or 2 parts on each of which x and y are polynomials of them, with the Jacobian xi^3 times
///           powers of the others. Where triangles have a vertex or a side in common, it makes g |x - y|^-2
///           with a smooth g an analytic function of the four; where they are one, a bounded function of the
///           direction of x - y. Gauss rules in each variable
/// Source    Sauter, Schwab, Boundary Element Methods, 2011, 5.2: identical panels, common edge, common
///           vertex. The parts are checked by tests: they integrate polynomials of x and y exactly
/// Requires  1 to 3 vertices in common, 1 <= order <= 192, else ContractViolation
/// Result    weights sum to 1/4; `common` vertices of both triangles are the first of each, in the same
///           order; order^4 points a part
/// Limits    the errors fall exponentially with the order where the triangles' angles are not small, and the
///           angle between them is not
[[nodiscard]] std::vector<PointPair> touching_rule(std::size_t common, int order);

}  // namespace radcert
