// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"

namespace radcert {

/// Euler's beta function, enclosed.
/// Maths     B(x, y) = Gamma(x) Gamma(y) / Gamma(x + y) = Int_0^1 t^(x-1) (1-t)^(y-1) dt
/// Source    Arb's arb_gamma
/// Result    contains the value for all points of the operands; a failure where one of them may be a pole of
///           Gamma
[[nodiscard]] Ball beta_function(const Ball& x, const Ball& y);

}  // namespace radcert
