// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/polynomial/nodes/inset_family.h"

namespace radcert::verification::ac98 {

/// How far two rational functions of alpha are from being the same, as a number that is zero if they are.
/// Maths     the number of coefficients of N_1 (1 - 3 alpha)^q - N_2 (1 - 3 alpha)^p that are not zero, for
///           the functions N_1/(1 - 3 alpha)^p and N_2/(1 - 3 alpha)^q
/// Result    exact; 0 if and only if the functions are equal
[[nodiscard]] Rational differing_coefficients(const InsetFunction& a, const InsetFunction& b);

}  // namespace radcert::verification::ac98
