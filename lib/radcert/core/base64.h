// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace radcert {

/// Bytes as text.
/// Source    RFC 4648, section 4
/// Result    four letters for three bytes, filled up with "="
[[nodiscard]] std::string base64(std::string_view bytes);

/// The bytes of such a text.
/// Result    three bytes for four letters, fewer where "=" fills up the last four; none for other characters
///           and for lengths that are no multiple of four
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace radcert
