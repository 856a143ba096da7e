// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace radcert {

/// The shortest decimal text that reads back as the same double.
/// Maths     parse_double(shortest(x)) = x for every finite x
/// Source    std::to_chars
/// Requires  nothing
/// Result    exact in the sense above, independent of the locale; "inf", "-inf", "nan" for what is not finite
/// Limits    not JSON where the value is not finite
[[nodiscard]] std::string shortest(double value);

/// A decimal text as the nearest double.
/// Maths     round to nearest, ties to even
/// Source    std::from_chars
/// Requires  nothing
/// Result    the whole text is one decimal number (sign, digits, point, exponent), independent of the locale;
///           otherwise no value
/// Limits    a leading '+', spaces, "inf", "nan", hexadecimal and numbers that overflow or underflow to zero
///           give no value
[[nodiscard]] std::optional<double> parse_double(std::string_view text);

/// Text of unknown origin, made safe to print inside a message.
/// Source    UTF-8 as in RFC 3629
/// Requires  nothing
/// Result    in double quotes on one line; quotes, backslashes, control characters and bytes that are not
///           UTF-8 are escaped; after `limit` bytes it is cut between characters and followed by `... (N
///           bytes)`
/// Limits    for people: not guaranteed to be a JSON string
[[nodiscard]] std::string quotation(std::string_view text, std::size_t limit = 80);

/// Words for a message: "a, b, c".
/// Requires  nothing
/// Result    the words in their order
[[nodiscard]] std::string listed(std::span<const std::string> words);

/// Whether a text is UTF-8.
/// Source    RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF
/// Requires  nothing
/// Result    exact
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace radcert
