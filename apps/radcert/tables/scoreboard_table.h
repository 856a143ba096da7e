// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/study/errors/scoreboard.h"

namespace radcert::app {

/// A scoreboard for people: of each problem a row a method, its finest level, and which levels of all are on
/// the frontier.
std::string scoreboard_table(std::span<const BoardProblem> problems);

}  // namespace radcert::app
