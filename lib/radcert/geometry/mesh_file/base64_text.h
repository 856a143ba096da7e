// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace radcert {

/// The bytes of a text in base64.
/// Source    RFC 4648, section 4
/// Result    three bytes for four letters, fewer where "=" fills up the last four; none for other characters
///           and for lengths that are no multiple of four
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace radcert
