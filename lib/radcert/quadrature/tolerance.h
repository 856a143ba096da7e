// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/contract.h"

namespace radcert {

/// What is asked of the entries of a collocation matrix.
/// Maths     |entry - exact| <= entry() max|l_j| times the row's Int |G| dS, as far as rounding allows
/// Source    -
/// Requires  finest <= entry <= coarsest, else ContractViolation
/// Result    the thresholds that follow from it. `converged` is the difference of two rules, relative to Int |G l_j| over an
///           element, at which an integral counts as converged: a fifth, since the error of a row is the sum over its
///           elements and the difference seldom less than the error. `intended_truncation` is asked of the error model when
///           an order is chosen: a hundredth, so that the comparison of two rules seldom fails
/// Limits    double: at the finest a difference of 2e-14 is about 200 roundings
class Tolerance {
public:
  static constexpr double finest = 1e-13;
  static constexpr double coarsest = 1e-2;

  explicit Tolerance(double entry = finest) : entry_(entry) {
    expects(finest <= entry && entry <= coarsest, "1e-13 <= tolerance <= 1e-2", named("tolerance", entry));
  }

  double entry() const { return entry_; }
  double converged() const { return entry_ / 5; }
  double intended_truncation() const { return entry_ / 100; }

private:
  double entry_;
};

}  // namespace radcert
