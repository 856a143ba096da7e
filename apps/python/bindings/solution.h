// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/study/study.h"

namespace radcert::python {

/// What is computed of a problem: its levels, and what they say together.
struct Solution {
  Result result;
  std::vector<LevelOutcome> levels;
};

}  // namespace radcert::python
