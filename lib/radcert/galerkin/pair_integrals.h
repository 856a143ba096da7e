// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/core/work_limit.h"
#include "radcert/galerkin/local_functions.h"

namespace radcert {

extern const WorkLimit deepest_pair;
extern const WorkLimit most_stages;

/// What two elements exchange, in their orthonormal functions.
/// Maths     value(a, b) = 1/pi Int_first Int_second psi_a(P) G(P,Q) psi_b(Q) dS_Q dS_P; radius(a, b) bounds
///           its error as far as the estimate goes
struct PairBlock {
  Matrix<double> value;
  Matrix<double> radius;
};

/// The integrals of the kernel over pairs of elements.
/// Maths     two plane elements with constants: the closed form of exchange_area along their edges. Other
///           pairs that touch: touching_rule, by chords where both are of one chart. Others: products of
///           conical Gauss rules, of orders by the distance of each element from the other's centre in terms
///           of its radius: where f continues to an ellipse of semi-axes eta and sqrt(eta^2 - 1), n points
///           leave out about rho^(d - 2n), rho = eta + sqrt(eta^2 - 1). The larger of two elements that are
///           near is cut into four until they are far. Finer and finer rules until two in a row differ by no
///           more than the accuracy times Int Int |G| and the largest constant functions: the finer counts,
///           and the radius is what they differ by, at least half of the largest in the block and, up to 64
///           times that, an eighth of what the rules before differed by, for two rules may agree by chance.
///           Rounding is added: of the points by rounded_kernel, of the sums by their length
/// Source    touching_rule; the rates: Trefethen, Approximation Theory and Approximation Practice, Theorem
///           19.3
/// Requires  functions of this triangulation, an unoccluded surface, 0 < accuracy < 1, else
///           ContractViolation; all outlive this
/// Result    block(a, b) and block(b, a) take other points and are transposed within their radii; exactly 0
///           for two elements in one plane. May be asked from several threads
/// Limits    estimates. That two elements touch is seen from their rounded vertices: it chooses a rule, and
///           no fact rests on it. What is near at deepest_pair, and what has not converged after most_stages
///           rules, counts with eight times what the last two differ by, or with what those before differed
///           by. Rules may agree on what is false where elements are thin: of plane ones what they miss of
///           Int Int G, by its closed form, is added; of curved ones nothing is known
class PairIntegrals {
public:
  PairIntegrals(const Surface& surface, const Triangulation& triangulation, const LocalFunctions& functions,
                double accuracy);
  ~PairIntegrals();
  PairIntegrals(const PairIntegrals&) = delete;
  PairIntegrals& operator=(const PairIntegrals&) = delete;

  /// Whether the integral is 0, since both elements lie in one plane: decided on exact coefficients.
  [[nodiscard]] bool vanishes(std::size_t first, std::size_t second) const;
  [[nodiscard]] PairBlock block(std::size_t first, std::size_t second) const;

private:
  class Implementation;
  std::unique_ptr<const Implementation> implementation_;
};

/// The bytes that a PairIntegrals keeps for an element with so many functions.
[[nodiscard]] std::size_t kept_bytes_per_element(std::size_t functions);

}  // namespace radcert
