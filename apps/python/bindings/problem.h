// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/study/problem.h"

namespace radcert::python {

/// A problem that Python has stated, and the name by which messages know it.
struct PythonProblem {
  Problem problem;
  std::string source;
};

}  // namespace radcert::python
