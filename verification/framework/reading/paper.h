// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "verification/framework/reading/claim.h"

namespace radcert::verification {

/// A folder of claims: one of papers/ or a user's own.
/// Requires  the folder holds claims.toml
/// Result    key: the folder's name; file(path): the content of a file by its path from the folder,
///           InputError where it is missing; source(path): how messages name that file; folder: as the user
///           named it, empty for an embedded paper
/// Limits    files outside the folder are not reached from an embedded paper
struct Paper {
  std::string key;
  std::vector<Claim> claims;
  std::function<std::string(const std::string& path)> file;
  std::function<std::string(const std::string& path)> source;
  std::string folder = {};
};

/// The content of a file of a paper's folder, empty where there is none.
[[nodiscard]] std::string file_if_there(const Paper& paper, const std::string& path);

/// Refuses a claim that names an erratum which is not there.
/// Result    returns where the claim names none, or where errata.md has a row of a table whose first cell is
///           that place; InputError with the claim's place otherwise
void check_erratum(const Paper& paper, const Claim& claim);

/// The papers that travel inside the program: every folder of papers/ with a claims.toml, by key.
[[nodiscard]] std::vector<Paper> embedded_paper_list();

/// A folder on disk. InputError where it has no claims.toml.
[[nodiscard]] Paper read_paper(const std::filesystem::path& folder);

/// A paper and those of its statements that were asked for.
/// Result    labels: empty stands for all; "table_1.alpha_1_6" for every label that begins with it up to a
///           point
struct Selected {
  Paper paper;
  std::vector<std::string> labels;
  /// Whether a label was asked for.
  [[nodiscard]] bool wants(std::string_view label) const;
  /// Whether something below a label was asked for, or the label itself.
  [[nodiscard]] bool wants_part_of(std::string_view label) const;
};

/// What words of a command line select: KEY or a folder of the user's own, with /CLAIM or /TABLE.CELL behind
/// it a statement or a part of a table; none: every paper.
/// Source    apps/radcert/README.md
/// Requires  nothing
/// Result    papers in the order in which they were first named; InputError for a word that is none of these,
///           with what there is
/// Limits    a word that is the key of an embedded paper is never a folder: write ./ac98
[[nodiscard]] std::vector<Selected> select(std::span<const std::string> words);

}  // namespace radcert::verification
