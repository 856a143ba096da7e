// SPDX-License-Identifier: GPL-3.0-or-later

// The entry that libFuzzer calls, for the reader that RADCERT_FUZZ_READER names; see fuzz.py.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/fuzz/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const radcert::fuzz::Reader* const reader = [] {
    const char* name = std::getenv("RADCERT_FUZZ_READER");
    const radcert::fuzz::Reader* found = name == nullptr ? nullptr : radcert::fuzz::find_reader(name);
    if (found == nullptr) {
      std::fputs("RADCERT_FUZZ_READER names no reader\n", stderr);
      std::exit(2);
    }
    return found;
  }();
  // What leaves it ends the process, which libFuzzer reports with the input.
  radcert::fuzz::read_any(*reader, {reinterpret_cast<const char*>(data), size});
  return 0;
}
