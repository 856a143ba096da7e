// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>

#include "radcert/study/collocation/collocation.h"
#include "radcert/study/galerkin/galerkin.h"
#include "radcert/study/meshless/meshless.h"

namespace radcert {

/// How the equation of a problem is made finite: the list of all methods. Each is a type of its own folder
/// that brings, as functions beside it, what the others of this layer ask of a method:
///   check(problem, method, surface, memory_limit)   what is to be refused before any work
///   solve(problem, method, level, route)            one level
/// and, in formats/problem, how it is read, written and said in words.
using Method = std::variant<Collocation, Meshless, Galerkin>;

/// The basis on triangles of a method that has one, or null.
[[nodiscard]] const TriangleBasisChoice* find_triangle_basis(const Method& method);

/// The same where the method is known to have one, else ContractViolation.
[[nodiscard]] const TriangleBasisChoice& triangle_basis_of(const Method& method);
[[nodiscard]] TriangleBasisChoice& triangle_basis_of(Method& method);

/// The degree of the polynomials on triangles of a method that has such, or nothing.
[[nodiscard]] std::optional<int> find_degree(const Method& method);

}  // namespace radcert
