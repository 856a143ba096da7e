// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/study/result.h"

namespace radcert::app {

/// A result for people: a row a level, the fitted orders, and what guarantee the numbers have.
std::string solve_table(const Result& result);

}  // namespace radcert::app
