// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/polynomial/barycentric.h"
#include "radcert/polynomial/triangle_basis.h"

namespace radcert {

/// The interpolation of one degree on a triangle.
/// Maths     D_n the orthonormal polynomials, x_a the interpolation nodes, V_an = D_n(x_a); a polynomial of
///           the degree has the modes c = V^-1 f, f its values at the nodes
/// Result    modes_of_values = V^-1 and its transpose, rows padded by zeros to whole packs; rounded
struct ModeInterpolation {
  std::vector<Barycentric<double>> nodes;
  Matrix<double> modes_of_values;
  Matrix<double> values_of_modes_transposed;  ///< V^-T: from moments to weights of the nodes
};

/// Constants of all triangles: interpolation of each degree, and what takes modes of a triangle to those of
/// its children.
/// Maths     transfer[c](n, m) = mean over the child c of D_n(x) D_m(y), x the coordinates in the parent and
///           y those in the child, so that D_n = sum_m transfer[c](n, m) D_m there; 0 where m has a higher
///           degree than n.  Children in the order of symmetric refinement: at v_1, v_2, v_3, the middle
/// Source    Dubiner polynomials of triangle_modes; integrals by Gauss rules that are exact for them
/// Result    up to largest_mode_degree; computed once and shared; the same bits for any number of threads
class ModeTables {
public:
  static const ModeTables& instance();

  [[nodiscard]] const ModeInterpolation& interpolation(int degree) const {
    return interpolations_[static_cast<std::size_t>(degree)];
  }
  /// From moments of the children to those of the parent, without the factor 1/4 of the area.
  [[nodiscard]] const Matrix<double>& to_parent(std::size_t child) const { return to_parent_[child]; }
  [[nodiscard]] const Matrix<double>& to_child(std::size_t child) const { return to_child_[child]; }

private:
  ModeTables();

  std::vector<ModeInterpolation> interpolations_;
  std::array<Matrix<double>, 4> to_parent_;
  std::array<Matrix<double>, 4> to_child_;
};

/// The corners of the four children of a triangle in its barycentric coordinates.
/// Source    see Triangulation
std::array<std::array<Barycentric<double>, 3>, 4> children_of_triangle(
    const std::array<Barycentric<double>, 3>& corners);

/// Points of each of the parts that some symmetric refinements make of a triangle, in its coordinates.
/// Requires  0 <= refinements
/// Result    part by part, in the order of Triangulation
std::vector<Barycentric<double>> points_of_parts(int refinements,
                                                 std::span<const Barycentric<double>> points);

/// Constants of all leaves: clusters of 4^refinements elements.
/// Maths     moments(n, k p + j) = mean over the leaf of l_j on its element k times D_n, 0 elsewhere;
///           values(k p + j, n) = D_n at node j of element k.  absolute_moments: the same with |l_j|
/// Source    moments by Gauss rules that are exact; those of |l_j| by a positive rule on each of 256 parts of
///           an element
/// Requires  0 <= refinements
/// Result    rows padded by zeros to whole packs; moments and values rounded, the two of |l_j| estimated
struct LeafTables {
  LeafTables(const TriangleBasis<double>& basis, int refinements, int degree);
  /// Zeros, to be filled.
  LeafTables(std::size_t unknowns, int degree);

  std::size_t unknowns;
  Matrix<double> moments;
  Matrix<double> absolute_moments;
  Matrix<double> values;
  std::vector<double> moments_of_one;  ///< mean over the leaf of D_n on its elements, what is not there is 0
};

/// How large the functions of a basis are together.
/// Maths     the root of the mean of (sum_j |l_j|)^2 over the triangle
/// Result    estimated, by a positive rule on each of 256 parts
[[nodiscard]] double size_of_functions(const TriangleBasis<double>& basis);

}  // namespace radcert
