// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace radcert::app {

/// The entry for radcert itself in BibTeX, as CITATION.cff has it; the definition is generated.
std::string_view own_citation();

}  // namespace radcert::app
