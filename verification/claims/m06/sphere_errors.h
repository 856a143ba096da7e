// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "verification/claims/m06/interpolation_remainder.h"
#include "verification/framework/observed_order.h"

namespace radcert::verification::m06 {

/// The errors of collocation on the unit sphere, without a matrix.
/// Maths     G = 1/4, so that K f = rho M f, M the mean. With rho = 1/2 and w = (I - P_n)u = (I - P_n)E: u =
///           E + M E, u_n = P_n E + M P_n E, u - u_n = w + M w, and u(v_i) - u_n(v_i) = M w at every node
/// Source    [m06, (15)-(21)]; G: [m06, Lemma 1 (d)]
/// Requires  u even in each coordinate, so that the first octant stands for all: triangulation and nodes are
///           reflected from one to the next. E = u - (1/2) M u is as smooth as u
/// Result    nodes: |M w| by a conical rule of order 10 on each element, with the distance to order 8 and
///           rounding for its radius; uniform: max |w + M w| over the 45 points k/8 of every element, a
///           sample, with radius 0
struct SphereErrors {
  LevelErrors nodes;
  LevelErrors uniform;
};
[[nodiscard]] SphereErrors errors_on_the_sphere(const TriangleBasis<double>& basis, Solution u,
                                                const std::vector<int>& levels);

/// x^4. The triangulation of the sphere has the symmetry of the octahedron: of the harmonics of degree 1 to 3
/// no mean is left over at any level, whatever the nodes.
[[nodiscard]] double fourth_power(const Vector<double>& q);

}  // namespace radcert::verification::m06
