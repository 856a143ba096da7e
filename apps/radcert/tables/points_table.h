// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/study/collocation/solution_level.h"

namespace radcert::app {

/// u_n and the iterated solution at points of a level for people: the first twenty of them, and the largest
/// errors and distances.
std::string points_table(std::span<const ValueAt> values, int level);

}  // namespace radcert::app
