// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/study/computed_function.h"

namespace radcert {

/// The computed function u_n on a surface: nodal values over a triangulation.
/// Maths     u_n(m_k(x)) = sum_j u_n(v_{k,j}) l_j(x)
/// Source    [ac98, (39)]
/// Requires  values in the order of collocation_nodes; of the elements that are here, where ranks share them
/// Result    rounded; refers to surface, triangulation, values and ranks, which outlive it
/// Limits    two-valued on the sides of triangles unless the inset is 0
class NodalFunction {
public:
  NodalFunction(const Surface& surface, const Triangulation& triangulation, TriangleBasis<double> basis,
                std::span<const double> values, const Ranks& ranks = one_rank())
      : surface_(surface),
        triangulation_(triangulation),
        basis_(std::move(basis)),
        values_(values),
        ranks_(ranks) {}

  double at(std::size_t element, const Barycentric<double>& x) const;
  const TriangleBasis<double>& basis() const { return basis_; }
  double value(std::size_t element, std::size_t j) const { return values_[element * basis_.size() + j]; }
  const Surface& surface() const { return surface_; }
  const Triangulation& triangulation() const { return triangulation_; }
  /// The same, for what is asked of every method. Refers to this.
  ComputedFunction computed() const;

private:
  const Surface& surface_;
  const Triangulation& triangulation_;
  TriangleBasis<double> basis_;
  std::span<const double> values_;
  const Ranks& ranks_;
};

/// The order of the rule on each element by which means are taken.
inline constexpr int nodal_mean_order = 12;

/// A radius of the mean over every piece, for nodal values within `node_radius`.
/// Maths     the mean is sum_kj c_kj u_kj, c_kj = Int_{Delta_k} l_j dS / Int_piece dS: nodal values within r
///           move it by r sum |c_kj| at most. What the rule leaves out of the c_kj: on plane charts nothing,
///           elsewhere the difference from the rule of order 16; n terms are rounded by (n + 64) u of the sum
///           of their sizes
/// Requires  node_radius >= 0
/// Result    the largest over the pieces; an estimate where charts are not plane
/// Limits    two rules that are wrong in the same way are not seen
double radius_of_means(const NodalFunction& u_n, double node_radius);

}  // namespace radcert
