// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "radcert/formats/json/json_value.h"

namespace radcert {

/// A file that a run read.
struct InputDigest {
  std::string name;    ///< as the command line has it
  std::string digest;  ///< digest_of its bytes
};

/// A library and its version as text.
struct LibraryVersion {
  std::string name;
  std::string version;
};

/// The inputs, programs and machine from which files were made, so that they can be made again.
/// Result    plain data
struct Provenance {
  std::string command;
  std::vector<InputDigest> inputs;
  std::vector<LibraryVersion> libraries;
  std::string compiler;      ///< name and version
  std::string architecture;  ///< that code was generated for
  std::string system;        ///< the operating system it ran on
  std::vector<std::string> cpu_features;
  std::uint64_t threads = 1;
  std::optional<std::uint64_t> seed;  ///< where random numbers were drawn
};

/// A provenance as JSON, ending with a newline.
/// Source    the file format radcert/provenance/1
/// Requires  nothing
/// Result    with version and source digest of this radcert
/// Limits    no time and no name of a machine: the same run gives the same bytes
[[nodiscard]] std::string provenance_text(const Provenance& provenance);

}  // namespace radcert
