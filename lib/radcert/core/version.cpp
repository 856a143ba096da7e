// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/version.h"

#if __has_include("radcert_source_digest.h")
#include "radcert_source_digest.h"
#endif

#ifndef RADCERT_VERSION
#define RADCERT_VERSION "unknown"
#endif
#ifndef RADCERT_SOURCE_DIGEST
#define RADCERT_SOURCE_DIGEST "unknown"
#endif

namespace radcert {

std::string_view version() { return RADCERT_VERSION; }

std::string_view source_digest() { return RADCERT_SOURCE_DIGEST; }

}  // namespace radcert
