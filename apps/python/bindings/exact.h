// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "python.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert::python {

/// A number of Python's, exactly.
/// Result    of an int, a Fraction, a Decimal or a text ("1/3", "0.1") what it says; of a float, NumPy's too,
///           the double that it is. InputError with `place` for everything else, NaN and infinities too
[[nodiscard]] Rational rational_of(const py::handle& number, const std::string& place,
                                   const std::string& allowed);

/// The same as the text that files of the library have: "1/3".
[[nodiscard]] std::string exact_text_of(const py::handle& number, const std::string& place,
                                        const std::string& allowed);

/// fractions.Fraction.
[[nodiscard]] py::object fraction_of(const Rational& number);

/// What an object is, for messages: "a list", "None".
[[nodiscard]] std::string kind_of(const py::handle& object);

}  // namespace radcert::python
