// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace radcert {

/// The largest degree of a basis of collocation, and how many functions it has on an element then.
/// Limits    of arrays on the stack alone: no formula of bases, rules or clusters asks for less. Closed forms
///           and certified rules, and so the solver `verified`, stop at degree 8
inline constexpr int largest_basis_degree = 10;
inline constexpr std::size_t most_basis_functions = 66;
static_assert(most_basis_functions == (largest_basis_degree + 1) * (largest_basis_degree + 2) / 2);

}  // namespace radcert
