// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace radcert {

/// Whether a text is one decimal number.
/// Maths     [+-] digits [. digits] [(e|E) [+-] digits], a digit before or after the point
/// Result    the whole text is the number; an exponent has at most 18 digits
/// Limits    no spaces, no locale, no "inf" or "nan"
[[nodiscard]] bool is_decimal(std::string_view text);

}  // namespace radcert
