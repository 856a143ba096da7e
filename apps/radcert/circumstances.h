// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
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

/// From now on the program ends with exit code 3 and a word where GMP, MPFR or FLINT find no memory, in place
/// of an abort; no temporary of a file stays.
void leave_when_memory_ends();

/// From now on the process gets no more than so many bytes beside what it holds, and room for stacks and for
/// what no plan counts: an allocation fails where the system would kill the process.
/// Source    getrlimit(2), RLIMIT_DATA
void hold_memory(std::uint64_t bytes);

/// How many threads beside this one the system gives at this moment, at most so many.
std::size_t threads_to_be_had(std::size_t most);

/// Those features of this processor that change how numbers are computed, of a fixed list.
std::vector<std::string> cpu_features();

}  // namespace radcert::app
