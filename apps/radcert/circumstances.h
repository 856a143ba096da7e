// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/formats/result/provenance.h"

namespace radcert::app {

/// The libraries that numbers pass through, with the versions that are loaded, or built in where they are
/// headers.
std::vector<LibraryVersion> library_versions();

/// Name and version of the compiler that made this program.
std::string compiler_version();

/// The operating system with its release, and the kind of processor.
std::string system_name();

/// Those features of this processor that change how numbers are computed, of a fixed list.
std::vector<std::string> cpu_features();

}  // namespace radcert::app
