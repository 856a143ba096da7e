// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "radcert/formats/result/provenance.h"
#include "radcert/study/problem.h"

namespace radcert::app {

/// Files to be written, with their contents.
using Files = std::vector<std::pair<std::filesystem::path, std::string>>;

/// A file that the user named, read once: what it says, and the digest of these very bytes.
struct InputFile {
  std::string source;  ///< as messages name it
  std::string text;
  InputDigest digest;
};
/// "-": the standard input. InputError as read_file, with the file as its source. Of several ranks the first
/// one reads, and another only to see that it has no other file of that name.
InputFile read_input(const std::filesystem::path& file, std::uint64_t limit_bytes);

/// The files that problems name, a mesh or nodes, each once.
std::vector<InputDigest> inputs_named_in(std::span<const Problem> problems);

/// InputError where a rank has another file of one of these names than the first one.
void require_same_named_files(std::span<const Problem> problems);

/// What was mended in the meshes of problems, and what looks like a slip in them or their triangulations, a
/// line each: "Mended: room.off: face 7 (line 31), bent ...". Empty where there is nothing to tell.
std::string notes_on_meshes(std::span<const Problem> problems);

/// The keys of the works that the method of a problem is taken from.
std::vector<std::string> references_of(const Problem& problem);

/// The seed of the sites of meshless bases, where all problems that have one share it.
std::optional<std::uint64_t> seed_of(std::span<const Problem> problems);

/// Where the files of a folder come from: cite.bib with these entries of papers/references.bib and radcert's
/// own, and provenance.json.
Files origin_files(const std::filesystem::path& folder, const Common& common,
                   const std::vector<std::string>& references, std::vector<InputDigest> inputs,
                   std::optional<std::uint64_t> seed = std::nullopt);

}  // namespace radcert::app
