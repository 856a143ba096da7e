// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/geometry/vector.h"
#include "radcert/polynomial/triangle_basis.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A positive function on a surface, by the chart and the point in space.
using SurfaceWeight = std::function<double(std::size_t chart, const Vector<double>& point)>;

/// The piecewise polynomials of a degree on a triangulation, element by element orthonormal in L2 with a
/// weight.
/// Maths     psi_a on the element k is a polynomial of degree r in the parameters, zero elsewhere, with
///           Int_k w psi_a psi_b dS = delta_ab: the modes D_m of triangle_modes, whose mass matrix is W = Int
///           w D_m D_n dS, by W = L L^T and psi = L^-1 D. Given as psi_a = sum_c coefficients(k)(a, c) l_c in
///           the Lagrange functions l_c of a basis of the same degree, since D_m = sum_c D_m(q_c) l_c
/// Source    modes: triangle_modes; Cholesky's factors: Golub, Van Loan, Matrix Computations, 4.2
/// Requires  a weight that is positive at the points of the rules, else ContractViolation
/// Result    rounded. defect(k) is an estimate of how far the mass matrix of the psi_a is from the identity,
///           the largest row sum: what two rules differ by, and rounding
/// Limits    degree <= 10
class LocalFunctions {
public:
  LocalFunctions(const Surface& surface, const Triangulation& triangulation,
                 const TriangleBasis<double>& basis, const SurfaceWeight& weight);

  [[nodiscard]] std::size_t elements() const { return coefficients_.size(); }
  [[nodiscard]] std::size_t functions() const { return basis_.size(); }  ///< on an element
  [[nodiscard]] const TriangleBasis<double>& basis() const { return basis_; }
  [[nodiscard]] const Matrix<double>& coefficients(std::size_t element) const {
    return coefficients_[element];
  }
  [[nodiscard]] double defect(std::size_t element) const { return defects_[element]; }

private:
  TriangleBasis<double> basis_;
  std::vector<Matrix<double>> coefficients_;
  std::vector<double> defects_;
};

/// The order of the coarser of the two conical rules by which masses are taken, for a degree.
[[nodiscard]] constexpr int mass_order(int degree) { return degree + 12; }

}  // namespace radcert
