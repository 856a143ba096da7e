// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/core/files/result_store.h"

namespace radcert::app {

/// From now on this process neither writes nor speaks: of several ranks the first one does.
void be_silent();
[[nodiscard]] bool is_silent();

/// From now on stdout counts as no terminal, though it may look like one: a launcher gives its processes one.
void take_no_terminal();

/// What was last said by complain().
[[nodiscard]] const std::string& last_complaint();

/// The number of columns of the terminal that stdout is; none where it is no terminal.
std::optional<std::size_t> terminal_width();

/// Whether colour may be used on a stream, 1 stdout or 2 stderr: a terminal that is not dumb, and NO_COLOR is
/// not set.
bool colour_allowed(int stream);

/// The text in red where colour is allowed.
std::string alarming(std::string_view text, int stream);

/// The lines of a text broken at spaces so that none is longer than `width`; what follows a break stands
/// below the last column of the line.
std::string folded(std::string_view text, std::size_t width);

/// The same for the terminal that stdout is; as it is where it is none.
std::string fitted(std::string_view text);

/// Writes to stdout; EnvironmentError where that fails.
void print(std::string_view text);

/// Writes to stderr: what is not a result.
void say(std::string_view text);

/// Says on stderr why the program ends.
void complain(std::string_view text);

/// Says how many of the levels asked for were finished before the interruption, and where they are kept.
ExitCode interrupted(const std::string& finished, const ResultStore& store);
ExitCode interrupted(std::size_t finished, std::size_t asked, const ResultStore& store);

/// The files of one run: what it reads, and what it writes together once all of the contents are there.
class Outputs {
public:
  /// With the file of --json, if there is one.
  explicit Outputs(const Common& common);
  /// A file that is read; InputError where one that is to be written is the same file.
  void input(const std::filesystem::path& path);
  /// A file that the user named, if any; InputError at once if its folder does not exist, if no file can have
  /// its name, or if it is an input or another output.
  void file(const std::string& option, const std::filesystem::path& path);
  /// A folder that the user named, if any, made if need be; InputError at once if that is impossible by its
  /// name, or if one of these files in it is an input or another output.
  void folder(const std::string& option, const std::filesystem::path& path,
              const std::vector<std::string>& names = {});
  /// Writes these files, all of them or none, with one that has been put piece by piece; InputError where one
  /// is an input.
  void write(const std::vector<std::pair<std::filesystem::path, std::string>>& files,
             AtomicFile* with_them = nullptr) const;

private:
  struct Named {
    std::string option;
    std::filesystem::path path;
  };
  void named(const std::string& option, const std::filesystem::path& path);
  std::vector<std::filesystem::path> folders_;
  std::vector<std::filesystem::path> inputs_;
  std::vector<Named> named_;
};

/// Writes these files and the JSON where it goes into one, together, and prints text for people or JSON, as
/// the options want it.
void print_result(const Common& common, const Outputs& outputs, std::string_view text, std::string_view json,
                  std::vector<std::pair<std::filesystem::path, std::string>> files = {},
                  AtomicFile* with_them = nullptr);

/// The same without further files.
void print_result(const Common& common, std::string_view text, std::string_view json);

/// Says on stderr that finished work is not kept, where that is so, and why.
void say_where_nothing_is_kept(const ResultStore& store);

/// Rows of cells as lines, columns padded to their widest cell: the first column to the left, all others to
/// the right. On a terminal that is too narrow the columns go on below, each part with the first column; one
/// that stands in `with_the_left` is not parted from the column before it.
std::string aligned(const std::vector<std::vector<std::string>>& rows,
                    const std::set<std::size_t>& with_the_left = {});

/// The same with every column to the left.
std::string aligned_left(const std::vector<std::vector<std::string>>& rows);

}  // namespace radcert::app
