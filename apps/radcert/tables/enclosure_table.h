// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/scalar/approximation.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/guarantee.h"

namespace radcert::app {

/// As many digits of an enclosed number as its radius leaves, and one more.
DecimalForm form_of(const Approximation& number);

/// The enclosures of a solution for people: a row a piece or a point, and what they are worth.
std::string enclosure_table(const SolutionEnclosure& enclosure);

}  // namespace radcert::app
