// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/study/guarantee.h"

namespace radcert::app {

/// The enclosures of a solution for people: a row a piece or a point, and what they are worth.
std::string enclosure_table(const SolutionEnclosure& enclosure);

}  // namespace radcert::app
