// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// The accuracy demanded of the entries of a collocation matrix.
/// Maths     |entry - exact| <= entry() max|l_j| times the row's Int |G| dS, as far as rounding allows
/// Requires  0 < entry <= coarsest, and finest_of<R>() <= entry where it is used in the arithmetic R, else
///           ContractViolation
/// Result    the thresholds that follow from it. `converged` is the difference of two rules, relative to Int
///           |G l_j| over an element, at which an integral counts as converged: a fifth, since the error of a
///           row is the sum over its elements and the difference seldom less than the error.
///           `intended_truncation` is asked of the error model when an order is chosen: a hundredth, so that
///           the comparison of two rules seldom fails
/// Limits    at the finest of double a difference of 2e-14 is about 200 roundings
class Tolerance {
public:
  static constexpr double finest = 1e-13;  ///< of double
  static constexpr double coarsest = 1e-2;

  /// The finest tolerance that R can hold: about a thousand roundings.
  template <Real R>
  static double finest_of() {
    if constexpr (std::is_same_v<R, double>)
      return finest;
    else
      return 4096 * nearest_double(unit_roundoff<R>());
  }

  explicit Tolerance(double entry = finest) : entry_(entry) {
    expects(0 < entry && entry <= coarsest, "0 < tolerance <= 1e-2", named("tolerance", entry));
  }

  double entry() const { return entry_; }
  double converged() const { return entry_ / 5; }
  double intended_truncation() const { return entry_ / 100; }

private:
  double entry_;
};

}  // namespace radcert
