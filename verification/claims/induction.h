// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/rational.h"

namespace radcert::verification {

/// What a statement on lists of any length leaves over, by induction on the length.
/// Maths     a state is what a list has come to, sums and products over its members. `none` is that of the
///           empty list; `any` one of any length, in symbols that stand for all states as the statement has
///           them; `join` adds a member, in symbols of its own; leftover(state) counts in what the statement
///           fails. The sum of leftover(none), leftover(any) and leftover(join(any))
/// Source    ours
/// Result    exact: 0 proves the statement for lists of every length
/// Limits    that `any` stands for all states of which the statement is true is for the caller to see to: one
///           symbol for each part of the state that the statement leaves free
template <class State, class Join, class Leftover>
[[nodiscard]] Rational left_over_by_induction(const State& none, const State& any, const Join& join,
                                              const Leftover& leftover) {
  return leftover(none) + leftover(any) + leftover(join(any));
}

}  // namespace radcert::verification
