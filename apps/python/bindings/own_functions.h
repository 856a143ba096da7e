// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "python.h"
#include "radcert/study/problem.h"

namespace radcert::python {

/// A function of Python's in place of one of a problem's parts: "solution" or "emission", which it is of all
/// pieces, or "mother", the mother function of a meshless basis, whose support stays.
/// Maths     solution, emission: f(P), P an array (n, 3) of doubles, gives an array (n,); mother: Phi(r), a
///           float of a float
/// Requires  the interpreter's lock
/// Result    called from any thread of the library, each time with the interpreter's lock. What it raises
///           leaves the computation; InputError at its place for another shape or type, and for a mother
///           function that is not finite
/// Limits    as slow as Python: a call an element for u, a call a node for E, a call a number for Phi
void set_function(Problem& problem, const std::string& part, const py::object& function);

}  // namespace radcert::python
