// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/core/outcome.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/ball.h"

namespace radcert {

/// Of an enclosure, where the demand says nothing else.
extern const WorkLimit most_evaluations;

/// The accuracy demanded of an enclosure, and the work allowed.
/// Maths     a ball of at most this radius around the number, with at most so many evaluations of the
///           function
/// Requires  radius > 0 and work_limit >= 1, else ContractViolation where it is used
/// Limits    rounding is not in it: BallPrecision::current() must leave the digits, some 30 bits beyond the
///           radius
struct Demand {
  double radius;
  long work_limit = most_evaluations.value();
};

/// A number enclosed as demanded.
struct Enclosed {
  Ball value;
  long evaluations = 0;
};

/// The demand was not met.
/// Maths     reached contains the number if the number exists, and is the whole line where nothing was
///           bounded
/// Result    why names the limit that was hit, and what stood in the way
/// Limits    says nothing about whether the number exists
struct Undecided {
  std::string why;
  Ball reached;
  long evaluations = 0;

  [[nodiscard]] std::string to_text() const { return why + "; reached " + reached.to_text(); }
};

/// A number as demanded, or why it was not found.
using Enclosure = Outcome<Enclosed, Undecided>;

}  // namespace radcert
