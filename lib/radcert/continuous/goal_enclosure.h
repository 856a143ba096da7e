// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/enclosure_search.h"
#include "radcert/continuous/polyhedron_problem.h"
#include "radcert/continuous/residual.h"
#include "radcert/scalar/approximation.h"

namespace radcert {

/// What an enclosure was concluded from, on the last mesh.
/// Maths     E and u are 2^exponent times those that q[0] and what belongs to it approximate, the j_k of
///           goals 2^exponents[k] times those of q[1+k], the q_k; of values q_k + j_kh, and what j_kh leaves
///           of j_k is in the norms
struct GoalProof {
  std::vector<SectorElement> elements;
  SectorFunctions q;
  int exponent = 0;
  std::vector<int> exponents;
  std::vector<ElementResidual> residuals;  ///< by element
  std::vector<double> norms;               ///< of all residuals
  std::vector<double> radii;               ///< of J_k(u), and what was wanted of them
  double wanted = 0;
};

/// Enclosures of numbers that depend linearly on the solution itself.
struct GoalEnclosure {
  std::vector<Approximation> numbers;  ///< by emission, then by piece, or by point; proved
  double width = 0;                    ///< twice the largest radius
  EnclosureProgress last;
  std::string hindrance = {};  ///< where the width is not the wanted one: what stood in the way
  /// Where it is asked for and anything reflects.
  std::shared_ptr<const GoalProof> proof = nullptr;
};

/// Encloses the mean of u over every piece.
/// Maths     J_k(u) = Int j_k u, j_k = 1/|S_k| on piece k. With v = E + rho q_0, y_k = j_k + q_k for any q,
///           t_0 = T(E + rho q_0) - q_0 and t_k = T(rho y_k) - q_k: |J_k(u) - J_k(v) - Int rho y_k t_0| <=
///           (Int rho t_0^2)^(1/2) (Int rho t_k^2)^(1/2) / (1 - s), s = sup rho. Proof: B = rho^(1/2) T
///           rho^(1/2) is self-adjoint in L2 with the norm s at most, by Schur's test, since T >= 0 is
///           symmetric and T 1 = 1; u - v = (I - rho T)^-1 rho t_0, so that J(u-v) = (rho^(1/2) j, (I-B)^-1
///           rho^(1/2) t_0), and (I-B)^-1 rho^(1/2) j = rho^(1/2) y + (I-B)^-1 rho^(1/2) t_k. Where y_k =
///           j_kh + q_k with j_kh near j_k, (Int rho (j_k - j_kh)^2)^(1/2) is added to the norm of t_k. The q
///           are polynomials on elements that shrink towards edges (trial_functions), as good as they happen
///           to be; t_0 and t_k are enclosed (residual_sums), also where parts hide each other (PanelSight,
///           Penumbra)
/// Source    dual weighted residuals: R. Becker, R. Rannacher, "An optimal control approach to a posteriori
///           error estimation", 2001; here without an unknown constant
/// Requires  0 < wanted < infinity; at least one panel; numbers whose sizes are within 1e-60 and 1e60, or 0
/// Result    proved. The mesh has as many layers, and the polynomials the degree, that the width asks for;
///           the same bits for any number of threads. Enclosures of coarser meshes are intersected with finer
///           ones. Further emissions have the same width; their t_i share the y_k, and every transport is
///           taken of all functions at once
/// Limits    a proof is of one emission; what is reached where the wanted width is not is given with its
///           reason. Where parts hide each other the width falls with the size of the cells: a tenth of it
///           asks for a hundred times as many
[[nodiscard]] GoalEnclosure enclose_means(const PolyhedronProblem& problem, double wanted,
                                          const SearchContext& context = {}, bool with_proof = false);

/// Encloses u at points.
/// Maths     u(P) = E(P) + rho(P) J(u), J(u) = T u(P), j = G(P,.)/pi, as above
/// Requires  as above; points inside panels of the problem, or on sides at which parts of one plane meet
/// Result    by point; all else as above
/// Limits    the nearer a point is to an edge, the more elements its kernel asks for; where parts hide each
///           other elements are cut along the borders of what the point sees, where its kernel jumps
[[nodiscard]] GoalEnclosure enclose_values(const PolyhedronProblem& problem,
                                           const std::vector<SolutionPoint>& points, double wanted,
                                           const SearchContext& context = {}, bool with_proof = false);

}  // namespace radcert
