// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "progress.h"
#include "radcert/core/errors.h"

namespace radcert::app {

namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Characters, not bytes, and none of the sequences that change the colour.
std::size_t length(std::string_view text) {
  std::size_t count = 0;
  bool in_sequence = false;
  for (const char c : text) {
    if (c == '\x1b') in_sequence = true;
    if (!in_sequence && (static_cast<unsigned char>(c) & 0xC0U) != 0x80U) ++count;
    if (c == 'm') in_sequence = false;
  }
  return count;
}

std::string pad(const std::string& cell, std::size_t width, bool left) {
  const std::string blanks(width - std::min(width, length(cell)), ' ');
  return left ? cell + blanks : blanks + cell;
}

constexpr std::size_t between_columns = 2;

/// The columns in parts that are no wider than `most`, each but for the first column, which all parts have;
/// groups that are to stay together are parted where they are too wide by themselves.
std::vector<std::vector<std::size_t>> parts(const std::vector<std::size_t>& widths, std::size_t most,
                                            const std::set<std::size_t>& with_the_left) {
  std::vector<std::vector<std::size_t>> out(1);
  std::size_t used = 0;
  for (std::size_t column = 0; column < widths.size(); ++column) {
    const std::size_t more = widths[column] + (column == 0 ? 0 : between_columns);
    std::size_t group = more;
    for (std::size_t next = column + 1; !with_the_left.contains(column) && with_the_left.contains(next);
         ++next)
      group += widths[next] + between_columns;
    const bool too_wide = used + more > most || (used + group > most && widths[0] + group <= most);
    if (out.back().size() > 1 && too_wide) {
      out.push_back({0});
      used = widths[0];
    }
    out.back().push_back(column);
    used += more;
  }
  return out;
}

std::string lines(const Rows& rows, bool all_left, const std::set<std::size_t>& with_the_left) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max(widths[column], length(row[column]));
  }
  // Columns of words are better folded than torn apart.
  const std::size_t most = all_left ? std::string::npos : terminal_width().value_or(std::string::npos);
  std::string out;
  for (const auto& columns : parts(widths, most, with_the_left)) {
    if (!out.empty()) out += "\n";
    for (const auto& row : rows) {
      std::string line;
      for (const std::size_t column : columns)
        if (column < row.size())
          line += (column == 0 ? "" : std::string(between_columns, ' ')) +
                  pad(row[column], widths[column], all_left || column == 0);
      out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
  }
  return out;
}

/// Whether two names are of one file, there or not; devices and pipes are nobody's content.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  if (std::filesystem::exists(a, error) || std::filesystem::exists(b, error))
    return std::filesystem::is_regular_file(a, error) && std::filesystem::equivalent(a, b, error);
  const auto first = std::filesystem::weakly_canonical(std::filesystem::absolute(a, error), error);
  if (error) return false;
  const auto second = std::filesystem::weakly_canonical(std::filesystem::absolute(b, error), error);
  return !error && first == second;
}

void refuse_standard_output(const std::string& option, const std::filesystem::path& path) {
  if (path != "-") return;
  throw InputError({.source = option,
                    .value = path.string(),
                    .problem = "is the standard output, which takes the JSON of --json alone",
                    .allowed = "the name of a file or folder; ./- where it is called so"});
}

[[noreturn]] void refuse_input_as_output(const std::string& option, const std::filesystem::path& path,
                                         const std::filesystem::path& input) {
  throw InputError({.source = option,
                    .value = path.string(),
                    .problem = "would be written over the input " + input.string(),
                    .allowed = "another file"});
}

/// What the system says of a name that nothing can have.
void refuse_name(const std::string& option, const std::filesystem::path& path, const std::error_code& error) {
  if (error == std::errc::filename_too_long || error == std::errc::too_many_symbolic_link_levels)
    throw InputError({.source = option,
                      .value = path.string(),
                      .problem = "is no possible name: " + error.message(),
                      .allowed = "names of at most 255 bytes, paths of at most 4095"});
}

struct Speech {
  bool silent = false;
  bool takes_terminal = true;
  std::string complaint;
};

Speech& speech() {
  static Speech speech;
  return speech;
}

/// Makes a folder and those above it; `made` gets what was not there.
void make_folders(const std::filesystem::path& folder, std::vector<std::filesystem::path>& made) {
  std::error_code error;
  std::vector<std::filesystem::path> missing;
  for (std::filesystem::path part = folder; !part.empty() && !std::filesystem::exists(part, error);
       part = part.parent_path())
    missing.push_back(part);
  for (auto part = missing.rbegin(); part != missing.rend(); ++part) {
    if (std::filesystem::create_directory(*part, error)) made.push_back(*part);
    if (error) throw EnvironmentError(part->string(), "cannot be made: " + error.message());
  }
}

}  // namespace

void be_silent() { speech().silent = true; }

bool is_silent() { return speech().silent; }

void take_no_terminal() { speech().takes_terminal = false; }

const std::string& last_complaint() { return speech().complaint; }

std::optional<std::size_t> terminal_width() {
  if (!speech().takes_terminal || isatty(STDOUT_FILENO) == 0) return std::nullopt;
  constexpr std::size_t least = 20;  // a terminal that says less is not believed
  constexpr std::size_t usual = 80;
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= least) return size.ws_col;
  const char* columns = std::getenv("COLUMNS");
  std::size_t number = 0;
  if (columns != nullptr) std::from_chars(columns, columns + std::strlen(columns), number);
  return number >= least ? number : usual;
}

bool colour_allowed(int stream) {
  const char* refused = std::getenv("NO_COLOR");
  if (refused != nullptr && *refused != '\0') return false;
  const char* terminal = std::getenv("TERM");
  return speech().takes_terminal && isatty(stream) != 0 && terminal != nullptr &&
         std::string_view(terminal) != "dumb";
}

std::string alarming(std::string_view text, int stream) {
  return colour_allowed(stream) ? "\x1b[1;31m" + std::string(text) + "\x1b[0m" : std::string(text);
}

std::string folded(std::string_view text, std::size_t width) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    const bool ends = end < text.size();
    text.remove_prefix(end + (ends ? 1 : 0));
    // Below the last column, where that leaves at least half of the width; else below the first word.
    const std::size_t gap = line.rfind("  ", width / 2);
    const std::size_t below = gap == std::string::npos ? 0 : line.find_first_not_of(' ', gap);
    const std::string indent(below == std::string::npos || below > width / 2 ? 0 : below, ' ');
    while (length(line) > width) {
      // Bytes of a character count once: the place is at most so many bytes further.
      std::size_t place = 0;
      for (std::size_t seen = 0; place < line.size(); ++place)
        if ((static_cast<unsigned char>(line[place]) & 0xC0U) != 0x80U && seen++ == width) break;
      const std::size_t space = line.rfind(' ', place);
      const std::size_t first = line.find_first_not_of(' ');
      if (space == std::string::npos || space <= std::max(first, indent.size())) break;
      out += line.substr(0, line.find_last_not_of(' ', space) + 1) + "\n";
      line = indent + line.substr(space + 1);
    }
    out += line + (ends ? "\n" : "");
  }
  return out;
}

std::string fitted(std::string_view text) {
  const auto width = terminal_width();
  return width ? folded(text, *width) : std::string(text);
}

void print(std::string_view text) {
  if (is_silent()) return;
  ProgressDisplay::put_away();
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw EnvironmentError("stdout", std::strerror(errno));
}

void say(std::string_view text) {
  if (is_silent()) return;
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void complain(std::string_view text) {
  speech().complaint = text;
  ProgressDisplay::put_away();
  say(alarming("radcert:", STDERR_FILENO) + " " + std::string(text) + "\n");
}

ExitCode interrupted(const std::string& finished, const ResultStore& store) {
  const auto status = store.status();
  say("radcert: interrupted; " + finished + " are " +
      (status ? "kept in " + store.folder().string() + ": the same command goes on from there\n"
              : "not kept: " + status.reason() + "\n"));
  return ExitCode::interrupted;
}

ExitCode interrupted(std::size_t finished, std::size_t asked, const ResultStore& store) {
  const auto status = store.status();
  say("radcert: interrupted; " + std::to_string(finished) + " of " + std::to_string(asked) +
      " levels are finished" +
      (status ? " and kept in " + store.folder().string() + ": the same command goes on from there\n"
              : ", but not kept: " + status.reason() + "\n"));
  return ExitCode::interrupted;
}

Outputs::Outputs(const Common& common) {
  if (common.json_to_file()) file("--json", common.json);
}

void Outputs::input(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return;  // whoever reads it says so
  for (const Named& output : named_)
    if (is_same_file(path, output.path)) refuse_input_as_output(output.option, output.path, path);
  inputs_.push_back(path);
}

void Outputs::named(const std::string& option, const std::filesystem::path& path) {
  for (const std::filesystem::path& input : inputs_)
    if (is_same_file(path, input)) refuse_input_as_output(option, path, input);
  for (const Named& other : named_)
    if (is_same_file(path, other.path))
      throw InputError({.source = option,
                        .value = path.string(),
                        .problem = "is the file of " + other.option + " too",
                        .allowed = "a file of its own"});
  named_.push_back({option, path});
}

void Outputs::file(const std::string& option, const std::filesystem::path& path) {
  if (path.empty() || is_silent()) return;
  refuse_standard_output(option, path);
  std::error_code error;
  const std::filesystem::path folder =
      path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, error))
    throw InputError({.source = option, .value = path.string(), .allowed = "a file in a folder that exists"});
  if (std::filesystem::is_directory(path, error))
    throw InputError(
        {.source = option, .value = path.string(), .problem = "is a folder", .allowed = "a file"});
  refuse_name(option, path, error);
  named(option, path);
}

void Outputs::folder(const std::string& option, const std::filesystem::path& path,
                     const std::vector<std::string>& names) {
  if (path.empty() || is_silent()) return;
  refuse_standard_output(option, path);
  std::error_code error;
  for (std::filesystem::path part = path; !part.empty(); part = part.parent_path()) {
    const auto status = std::filesystem::status(part, error);
    refuse_name(option, part, error);
    if (std::filesystem::is_directory(status)) break;
    if (std::filesystem::exists(status))
      throw InputError(
          {.source = option, .value = path.string(), .problem = "is no folder", .allowed = "a folder"});
    if (part == part.parent_path()) break;
  }
  folders_.push_back(path);
  for (const std::string& name : names) named(option, path / name);
}

void Outputs::write(const std::vector<std::pair<std::filesystem::path, std::string>>& files,
                    AtomicFile* with_them) const {
  if (is_silent()) return;
  for (const auto& [path, content] : files)
    for (const std::filesystem::path& input : inputs_)
      if (is_same_file(path, input)) refuse_input_as_output("output", path, input);
  std::vector<std::filesystem::path> made;
  try {
    for (const std::filesystem::path& folder : folders_) make_folders(folder, made);
    write_together(files, with_them);
  } catch (...) {
    // Those that are not empty stay: others have put something there meanwhile.
    std::error_code left;
    for (auto folder = made.rbegin(); folder != made.rend(); ++folder) std::filesystem::remove(*folder, left);
    throw;
  }
}

void print_result(const Common& common, const Outputs& outputs, std::string_view text, std::string_view json,
                  std::vector<std::pair<std::filesystem::path, std::string>> files, AtomicFile* with_them) {
  if (common.json_to_file()) files.emplace_back(common.json, json);
  if (!files.empty() || with_them != nullptr) outputs.write(files, with_them);
  // A text that is the JSON itself stays JSON.
  print(common.json_to_stdout() || text == json ? std::string(json) : fitted(text));
}

void print_result(const Common& common, std::string_view text, std::string_view json) {
  print_result(common, Outputs(common), text, json);
}

void say_where_nothing_is_kept(const ResultStore& store) {
  if (const auto status = store.status(); !status)
    say("radcert: warning: finished work is not kept: " + status.reason() + "\n");
}

std::string aligned(const std::vector<std::vector<std::string>>& rows,
                    const std::set<std::size_t>& with_the_left) {
  return lines(rows, false, with_the_left);
}

std::string aligned_left(const std::vector<std::vector<std::string>>& rows) { return lines(rows, true, {}); }

}  // namespace radcert::app
