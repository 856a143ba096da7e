// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/parallel.h"

namespace CLI {
class App;
}

namespace radcert::app {

/// The options that every subcommand takes.
struct Common {
  std::string command;       ///< the command line, as a shell takes it
  std::string json{};        ///< --json: a file, "-" for stdout, empty: not asked for
  std::string threads{};     ///< --threads, as written
  std::string max_memory{};  ///< --max-memory, as written
  bool quiet = false;        ///< --quiet
  bool fresh = false;        ///< --fresh, of the commands that keep finished work

  [[nodiscard]] bool json_to_stdout() const { return json == "-"; }
  [[nodiscard]] bool json_to_file() const { return !json.empty() && !json_to_stdout(); }
  /// Holds --threads, if there is one, while it lives; InputError where it is no positive whole number.
  [[nodiscard]] std::optional<ThreadLimit> limit_threads() const;
  /// Bytes that may be used: what is there, or --max-memory where that is less.
  [[nodiscard]] std::uint64_t memory_limit() const;
  /// Where finished work is kept; with --fresh that of this run alone is taken from there.
  [[nodiscard]] ResultStore store() const;
};

/// What to do once the whole command line has been understood.
using Action = std::function<ExitCode()>;

/// A subcommand while it is being described. `type` is what help shows for a value: "FILE.json".
class Subcommand {
public:
  Subcommand(CLI::App& app, Action& action) : app_(&app), action_(&action) {}

  /// A word without dashes that must be there.
  void word(const std::string& name, std::string& value, const std::string& help,
            const std::string& type = {});
  void optional_word(const std::string& name, std::string& value, const std::string& help);
  /// Any number of such words.
  void words(const std::string& name, std::vector<std::string>& values, const std::string& help);

  void option(const std::string& name, std::string& value, const std::string& help, const std::string& type);
  /// Help shows the value that it has now.
  void option_with_default(const std::string& name, std::string& value, const std::string& help);
  /// One that may be given several times.
  void repeated(const std::string& name, std::vector<std::string>& values, const std::string& help,
                const std::string& type);
  /// One whose value is a list, parted by commas.
  void list(const std::string& name, std::vector<std::string>& values, const std::string& help,
            const std::string& type);
  void flag(const std::string& name, bool& value, const std::string& help);
  /// --fresh, of a command that takes its store from `common`.
  void fresh_flag(Common& common);

  /// What help says below the options.
  void footer(const std::string& text);
  /// What is done where this subcommand is chosen.
  void runs(Action action);

private:
  CLI::App* app_;
  Action* action_;
};

/// The command line of radcert. CLI11, which takes long to compile, stands behind it in command.cpp and
/// shell_help.cpp.
class Program {
public:
  Program(int count, const char* const* words);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// A new subcommand with the options that all have.
  Subcommand add(const std::string& name, const std::string& summary);
  /// One with --help alone.
  Subcommand add_plain(const std::string& name, const std::string& summary);
  [[nodiscard]] Common& common() { return common_; }
  [[nodiscard]] const CLI::App& tree() const { return *tree_; }

  /// What the command line asks for; nothing where it asked for help or the version, which are printed.
  /// InputError where it is not understood.
  [[nodiscard]] std::optional<Action> parse(int argc, char** argv);

private:
  std::unique_ptr<CLI::App> tree_;
  Common common_;
  Action action_;
};

/// Each adds its subcommand.
void add_solve(Program& program);
void add_verify(Program& program);
void add_reference(Program& program);
void add_check(Program& program);
void add_edge(Program& program);
void add_surface(Program& program);
void add_factors(Program& program);
void add_experiment(Program& program);
void add_basis(Program& program);
void add_picture(Program& program);
void add_list(Program& program);
void add_schema(Program& program);
void add_example(Program& program);
void add_completion(Program& program);
void add_man(Program& program);

/// What WHAT may be in `radcert list WHAT`.
std::vector<std::string> list_names();

/// The names of `radcert list WHAT`.
std::vector<std::string> listed_names(const std::string& what);

/// The words of a command line as a shell would take them: quotes where they are needed.
std::string command_line(int count, const char* const* words);

}  // namespace radcert::app
