// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/quadrature/collocation_point.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A triangulated surface with the collocation nodes on it.
struct NodedSurface {
  Surface surface;
  Triangulation triangulation;
  std::vector<CollocationPoint<double>> nodes;
};

/// The geometry of one level: where its data live, and where its collocation integrals are taken.
/// Maths     data: the points v_i at which rho, E and u are taken, and the surface of Ku. integrals: Int
///           G(v~_i,Q) l_j(Q) dS_Q with P, n_P, Q, n_Q and the area element on it. Both have the same
///           elements and nodes in the same order. With exact geometry they are one; else integrals is the
///           interpolant, and data is S or, if so chosen, the interpolant too
/// Source    [ac98, (40), (91)]
/// Requires  a checked problem
/// Result    mesh_size is that of the triangulation of S
class LevelGeometry {
public:
  LevelGeometry(const Problem& problem, int level, const TriangleBasis<double>& basis);

  const NodedSurface& data() const { return data_; }
  const NodedSurface& integrals() const { return interpolant_ ? *interpolant_ : data_; }
  double mesh_size() const { return mesh_size_; }

private:
  NodedSurface data_;
  std::optional<NodedSurface> interpolant_;  ///< absent where data and integrals are one
  double mesh_size_;
};

/// The number of a level, its sizes and the memory that was planned: all that is known before it is solved.
[[nodiscard]] LevelResult level_header(const Problem& problem, int level, const LevelGeometry& geometry,
                                       std::size_t unknowns);

}  // namespace radcert
