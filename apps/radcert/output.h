// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command.h"
#include "radcert/core/result_store.h"

namespace radcert::app {

/// Writes to stdout; EnvironmentError where that fails.
void print(std::string_view text);

/// Writes to stderr: what is not a result.
void say(std::string_view text);

/// Says how many of the levels asked for were finished before the interruption, and where they are kept.
ExitCode interrupted(std::size_t finished, std::size_t asked, const ResultStore& store);

/// Files that are written together, once all of their contents are there.
class Outputs {
public:
  /// A file that the user named; InputError at once if its folder does not exist.
  void file(const std::string& option, const std::filesystem::path& path);
  /// A folder that the user named, made if need be; InputError at once if that is impossible by its name.
  void folder(const std::string& option, const std::filesystem::path& path);
  /// Writes one file after the other, each as a whole or not at all.
  void write(const std::vector<std::pair<std::filesystem::path, std::string>>& files) const;

private:
  std::vector<std::filesystem::path> folders_;
};

/// Text for people and JSON, each where the options want it: stdout has the one or the other.
void print_result(const Common& common, std::string_view text, std::string_view json);

/// Rows of cells as lines, columns padded to their widest cell: the first column to the left, all others to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

/// The same with every column to the left.
std::string aligned_left(const std::vector<std::vector<std::string>>& rows);

}  // namespace radcert::app
