// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace radcert {

/// Which radcert this is.
/// Source    the build: RADCERT_VERSION, and RADCERT_SOURCE_DIGEST in the generated radcert_source_digest.h
/// Requires  nothing
/// Result    version(): "0.1.0"; source_digest(): a digest of the sources, the same for the same sources
/// Limits    "unknown" where the build gave none
[[nodiscard]] std::string_view version();
[[nodiscard]] std::string_view source_digest();

}  // namespace radcert
