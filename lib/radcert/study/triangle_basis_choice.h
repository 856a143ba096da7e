// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// Where the nodes of a basis on triangles come from.
enum class NodeFamily { inset, symmetric, file };

/// A basis on the reference triangle, as a problem chooses it.
struct TriangleBasisChoice {
  int degree = 1;
  std::optional<Rational> alpha = {};  ///< absent exactly where degree 0 left it out
  /// alpha stands for the irrational alpha_0 of m06 and lies within 10^-100 of it.
  bool alpha_is_near = false;
  NodeFamily family = NodeFamily::inset;
  std::string file = {};    ///< of nodes, as the problem names it
  std::string digest = {};  ///< of that file's bytes
  /// Of symmetric nodes and of files; inset bases have none.
  std::shared_ptr<const LagrangeFunctions> functions = {};
};

/// How many functions the basis has on an element.
[[nodiscard]] std::size_t function_count(const TriangleBasisChoice& basis);

/// The basis in the arithmetic of the pipeline. Requires functions, or degree and alpha that an InsetBasis
/// takes.
[[nodiscard]] TriangleBasis<double> triangle_basis(const TriangleBasisChoice& basis);

/// The basis exactly. Requires as triangle_basis.
[[nodiscard]] LagrangeFunctions exact_functions(const TriangleBasisChoice& basis);

}  // namespace radcert
