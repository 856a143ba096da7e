// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/expression/expression.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace radcert {

/// Why a text is not an expression.
/// Requires  nothing
/// Result    column: counted in bytes from 1, one past the end where the text stops too early; message: what
///           was expected or is wrong there
/// Limits    the first fault only
struct ExpressionFault {
  std::size_t column = 0;
  std::string message{};
  /// "column 3: expected ..."
  [[nodiscard]] std::string to_text() const;
};

/// A text as an expression.
/// Maths     sum     := product (('+' | '-') product)*                   left-associative
///           product := signed (('*' | '/') signed)*                     left-associative
///           signed  := '-' signed | power                               -2^2 = -4
///           power   := primary ['^' signed]                             2^3^2 = 2^(3^2), 2^-1
///           primary := number | name | function '(' sum [',' sum] ')' | '(' sum ')'
///           number  := digits ['.' [digits]] [e] | '.' digits [e],  e := ('e' | 'E') ['+' | '-'] digits
///           name    := pi, and x | y | z, or r, or x1 | x2 | x3
///           function := sqrt exp log sin cos tan atan abs (one argument), min max (two)
/// Source    lib/radcert/formats/README.md
/// Requires  nothing
/// Result    the tree as written, numbers exact; or the place and the reason
/// Limits    at most 4096 characters of ASCII, 64 levels of parentheses, calls, signs and exponents together,
///           decimal exponents up to 400; blanks and tabs separate, nothing else. There is no sign '+' and no
///           multiplication without '*'
[[nodiscard]] Outcome<Expression, ExpressionFault> parse_expression(
    std::string_view text, ExpressionVariables variables = ExpressionVariables::space);

}  // namespace radcert
