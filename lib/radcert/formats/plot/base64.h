// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace radcert {

/// Bytes as text.
/// Source    RFC 4648, section 4
/// Result    four letters for three bytes, filled up with "="
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace radcert
