// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "radcert/core/errors.h"

namespace CLI {
class App;
}

namespace radcert::app {

/// What every subcommand is told.
struct Common {
  std::string command;       ///< the command line, as a shell takes it
  std::string json{};        ///< --json: a file, "-" for stdout, empty: not asked for
  std::string threads{};     ///< --threads, as written
  std::string max_memory{};  ///< --max-memory, as written
  bool quiet = false;        ///< --quiet

  [[nodiscard]] bool json_to_stdout() const { return json == "-"; }
  /// The number of --threads, if there is one; InputError where it is no positive whole number.
  [[nodiscard]] std::optional<std::size_t> thread_limit() const;
  /// Bytes that may be used: what is there, or --max-memory where that is less.
  [[nodiscard]] std::uint64_t memory_limit() const;
};

/// What to do once the whole command line has been understood.
using Action = std::function<ExitCode()>;

/// Each adds its subcommand; choosing it on the command line sets the action.
void add_solve(CLI::App& program, Common& common, Action& action);
void add_verify(CLI::App& program, Common& common, Action& action);
void add_reference(CLI::App& program, Common& common, Action& action);
void add_surface(CLI::App& program, Common& common, Action& action);
void add_factors(CLI::App& program, Common& common, Action& action);
void add_experiment(CLI::App& program, Common& common, Action& action);
void add_basis(CLI::App& program, Common& common, Action& action);
void add_picture(CLI::App& program, Common& common, Action& action);
void add_list(CLI::App& program, Common& common, Action& action);
void add_schema(CLI::App& program, Common& common, Action& action);
void add_example(CLI::App& program, Common& common, Action& action);
void add_completion(CLI::App& program, Action& action);
void add_man(CLI::App& program, Action& action);

/// A new subcommand with the options that all have.
CLI::App& add_command(CLI::App& program, Common& common, const std::string& name, const std::string& summary);

/// The words of a command line as a shell would take them: quotes where they are needed.
std::string command_line(int count, const char* const* words);

}  // namespace radcert::app
