// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "verification/claims/ac98/surfaces/unit_square_integrals.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

/// A printed formula for one of the integrals of section 2.2, and what it is held against.
struct PrintedIntegral {
  using Formula = std::function<Ball(const Ball& x, const Ball& z)>;
  std::string name;
  Ball UnitSquareIntegrals::*integral;
  Formula printed;
  Formula library;      ///< the same number from closed_form
  Formula wrong;        ///< a formula that must be rejected
  std::string mistake;  ///< what is wrong with it
};

/// Evidence that a formula has the value of its integral, by enclosures of both.
/// Maths     at points to within 1e-30; on boxes that cover 1/8 <= x <= 7/8, 1/4 <= z <= 3/4 the enclosures
///           of formula and integral overlap, which those of `wrong` on the same boxes do not
/// Result    requirements for `printed` and `library`, controls for `wrong`
/// Limits    beside a proof of the identity: boxes alone would not see a deviation that is less than their
///           width
void require_values(Finding& finding, const Bench& bench, const PrintedIntegral& formula);

}  // namespace radcert::verification::ac98
