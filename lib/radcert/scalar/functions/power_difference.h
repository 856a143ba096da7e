// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"

namespace radcert {

/// First and second divided differences of a power, enclosed.
/// Maths     phi(x) = x^e, b = a + d:  first = phi[a,b] = (phi(b) - phi(a)) / d,
///           bend = phi[a,a,b] = (phi[a,b] - phi'(a)) / d = Int_0^1 (1-l) phi''(a + l d) dl
/// Source    mean value theorem: phi[a,b] = phi'(xi), phi[a,a,b] = phi''(xi) / 2, xi between a and b;
///           binomial series in d/a
/// Requires  a, b >= 0; b contains a + d for the a and d that are meant
/// Result    balls that contain the value for all such a, b, d, also where d contains 0; narrow both for
///           small and for large d: the common part of what the mean value theorem, the series, the
///           definition and, for first, phi'(a) + d bend give. A failure where none of them gives a bound:
///           then bend is not bounded, as for e < 2 and a = b = 0
/// Limits    e is a ball around a constant
[[nodiscard]] Ball bend_of_power(const Ball& a, const Ball& b, const Ball& d, const Ball& e);
/// `bend` may be a failure.
[[nodiscard]] Ball first_of_power(const Ball& a, const Ball& b, const Ball& d, const Ball& e,
                                  const Ball& bend);

}  // namespace radcert
