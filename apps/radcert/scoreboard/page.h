// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/study/errors/scoreboard.h"

namespace radcert::app {

/// A scoreboard as a page that asks for nothing else: of each problem a plot against the unknowns and a table
/// of all levels with the frontiers marked; the seconds stand apart, at the end.
std::string scoreboard_page(const std::vector<BoardProblem>& problems, const std::string& command);

}  // namespace radcert::app
