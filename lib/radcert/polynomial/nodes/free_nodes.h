// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/polynomial/barycentric.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"

namespace radcert {

/// A node without symmetry, with its weight.
/// Maths     s = x_3, t = x_2
struct FreeNode {
  Rational s{};
  Rational t{};
  Rational weight{};     ///< of integrals: all of them sum to 1/2
  bool holds_s = false;  ///< s is a number that was chosen, and so t
  bool holds_t = false;
};

/// Nodes that no symmetry exchanges, and what is said of a rule beside them.
/// Maths     the rule is exact for all polynomials of degree `triangle`, and on the parallelogram up to the
///           even degree `parallelogram`, and so up to the next odd one: polynomials that are odd about its
///           centre cost nothing
/// Result    points(): the nodes in their order, with the exact sum 1
struct FreeNodes {
  int degree = 0;  ///< of the functions
  int triangle = 0;
  int parallelogram = 0;
  std::vector<FreeNode> nodes;
  [[nodiscard]] std::vector<Barycentric<Rational>> points() const;
};

/// How many equations that are: (d + 1)(d + 2)/2 for d = triangle, and k + 1 for each even k beyond, up to
/// `parallelogram`.
/// Requires  0 <= triangle
[[nodiscard]] int free_equations(int triangle, int parallelogram);

/// Newton's method in balls from these numbers, with those that are held; nothing where it does not converge
/// or where there are not as many equations as unknowns.
/// Result    60 digits and two more; proves nothing
[[nodiscard]] std::optional<FreeNodes> sharpened(const FreeNodes& nodes);

/// Proves that nodes without symmetry lie at a rule of high precision.
/// Maths     F_k = sum w f_k(q) - Int f_k for the products of powers of s - 1/3, t - 1/3 up to the degree
///           `triangle`, and of s - 1/2, t - 1/2 of each even degree beyond up to `parallelogram`: even about
///           the centre of the parallelogram, on which the rule and its image under the half turn miss twice
///           what it misses on the triangle. Krawczyk's test as in `certify` of symmetric nodes
/// Source    as `certify` of symmetric nodes
/// Requires  degree <= triangle; parallelogram even; radius > 0, else ContractViolation
/// Result    the certificate; or why there is none
/// Limits    works at 512 bits; a refusal does not prove that there is no such rule
[[nodiscard]] Outcome<SymmetricCertificate> certify(const FreeNodes& nodes, const Rational& radius);

}  // namespace radcert
