// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "radcert/core/atomic_file.h"
#include "radcert/core/errors.h"

namespace radcert::app {

namespace {

std::string pad(const std::string& cell, std::size_t width, bool left) {
  const std::string blanks(width - std::min(width, cell.size()), ' ');
  return left ? cell + blanks : blanks + cell;
}

std::string lines(const std::vector<std::vector<std::string>>& rows, bool all_left) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max(widths[column], row[column].size());
  }
  std::string out;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column)
      line += (column == 0 ? "" : "  ") + pad(row[column], widths[column], all_left || column == 0);
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return out;
}

}  // namespace

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw EnvironmentError("stdout", std::strerror(errno));
}

void say(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

ExitCode interrupted(std::size_t finished, std::size_t asked, const ResultStore& store) {
  const auto status = store.status();
  say("radcert: interrupted; " + std::to_string(finished) + " of " + std::to_string(asked) +
      " levels are finished" +
      (status ? " and kept in " + store.folder().string() + ": the same command goes on from there\n"
              : ", but not kept: " + status.reason() + "\n"));
  return ExitCode::interrupted;
}

void Outputs::file(const std::string& option, const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path folder =
      path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, error))
    throw InputError({.source = option, .value = path.string(), .allowed = "a file in a folder that exists"});
  if (std::filesystem::is_directory(path, error))
    throw InputError(
        {.source = option, .value = path.string(), .problem = "is a folder", .allowed = "a file"});
}

void Outputs::folder(const std::string& option, const std::filesystem::path& path) {
  std::error_code error;
  for (std::filesystem::path part = path; !part.empty(); part = part.parent_path()) {
    const auto status = std::filesystem::status(part, error);
    if (std::filesystem::is_directory(status)) break;
    if (std::filesystem::exists(status))
      throw InputError(
          {.source = option, .value = path.string(), .problem = "is no folder", .allowed = "a folder"});
    if (part == part.parent_path()) break;
  }
  folders_.push_back(path);
}

void Outputs::write(const std::vector<std::pair<std::filesystem::path, std::string>>& files) const {
  for (const std::filesystem::path& folder : folders_) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw EnvironmentError(folder.string(), error.message());
  }
  for (const auto& [path, content] : files) write_atomically(path, content);
}

void print_result(const Common& common, std::string_view text, std::string_view json) {
  if (!common.json.empty() && !common.json_to_stdout()) {
    Outputs outputs;
    outputs.file("--json", common.json);
    outputs.write({{common.json, std::string(json)}});
  }
  print(common.json_to_stdout() ? json : text);
}

std::string aligned(const std::vector<std::vector<std::string>>& rows) { return lines(rows, false); }

std::string aligned_left(const std::vector<std::vector<std::string>>& rows) { return lines(rows, true); }

}  // namespace radcert::app
