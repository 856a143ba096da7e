// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "output.h"
#include "radcert/core/checked.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/version.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"

namespace radcert::app {

namespace {

/// A positive whole number; what follows it is left in `rest`.
std::optional<std::uint64_t> positive(std::string_view text, std::string_view& rest) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number == 0) return std::nullopt;
  rest = text.substr(static_cast<std::size_t>(end - text.data()));
  return number;
}

std::optional<std::uint64_t> bytes(std::string_view text) {
  std::string_view suffix;
  const auto number = positive(text, suffix);
  if (!number) return std::nullopt;
  if (suffix.empty()) return number;
  // 4G, 4GB and 4GiB all mean 4 times 1024^3: a limit that is meant in thousands is a little less strict.
  const std::size_t power = std::string_view("kMGT").find(suffix.front());
  const std::string_view rest = suffix.substr(1);
  if (power == std::string_view::npos || !(rest.empty() || rest == "B" || rest == "iB")) return std::nullopt;
  return checked_multiply(*number, std::uint64_t{1} << (10 * (power + 1)));
}

bool plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-./=,:+@%").find(c) != std::string_view::npos;
}

std::string shell_word(std::string_view word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return std::string(word);
  std::string out = "'";
  for (const char c : word) {
    if (c == '\'')
      out += "'\\''";
    else
      out += c;
  }
  return out + "'";
}

constexpr const char* exit_codes =
    "Results go to stdout, everything else to stderr.\n"
    "Exit codes: 0 done, every verdict as recorded; 1 a verdict differs from the record, or a demanded "
    "accuracy was\n"
    "not reached; 2 the input is wrong; 3 the environment failed, or radcert itself has a defect; 130 "
    "interrupted.";

/// A word in the place of a subcommand that is none.
void require_command(const CLI::App& program, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == word) return;
    names.push_back(command->get_name());
  }
  throw InputError(
      {.value = word, .problem = with_nearest_word("is no command", word, names), .allowed = listed(names)});
}

}  // namespace

std::optional<ThreadLimit> Common::limit_threads() const {
  if (threads.empty()) return std::nullopt;
  constexpr std::uint64_t most = 4096;
  std::string_view rest;
  const auto number = positive(threads, rest);
  if (!number || !rest.empty() || *number > most)
    throw InputError({.source = "--threads", .value = threads, .allowed = "a whole number from 1 to 4096"});
  return std::optional<ThreadLimit>(std::in_place, static_cast<std::size_t>(*number));
}

std::uint64_t Common::memory_limit() const {
  const std::uint64_t available = available_memory();
  if (max_memory.empty()) return available;
  const auto limit = bytes(max_memory);
  if (!limit)
    throw InputError({.source = "--max-memory",
                      .value = max_memory,
                      .allowed = "a positive whole number of bytes, or of k, M, G or T as in 4G, 4GB or "
                                 "4GiB, which count in 1024s"});
  return std::min(available, *limit);
}

ResultStore Common::store() const {
  ResultStore store;
  if (fresh) store.ignore_earlier();
  return store;
}

void Subcommand::word(const std::string& name, std::string& value, const std::string& help,
                      const std::string& type) {
  CLI::Option* option = app_->add_option(name, value, help)->required();
  if (!type.empty()) option->type_name(type);
}
void Subcommand::optional_word(const std::string& name, std::string& value, const std::string& help) {
  app_->add_option(name, value, help);
}
void Subcommand::words(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  app_->add_option(name, values, help);
}
void Subcommand::option(const std::string& name, std::string& value, const std::string& help,
                        const std::string& type) {
  app_->add_option(name, value, help)->type_name(type);
}
void Subcommand::option_with_default(const std::string& name, std::string& value, const std::string& help) {
  app_->add_option(name, value, help)->capture_default_str();
}
void Subcommand::repeated(const std::string& name, std::vector<std::string>& values, const std::string& help,
                          const std::string& type) {
  app_->add_option(name, values, help)->type_name(type)->take_all();
}
void Subcommand::list(const std::string& name, std::vector<std::string>& values, const std::string& help,
                      const std::string& type) {
  app_->add_option(name, values, help)->delimiter(',')->type_name(type);
}
void Subcommand::flag(const std::string& name, bool& value, const std::string& help) {
  app_->add_flag(name, value, help);
}

void Subcommand::fresh_flag(Common& common) {
  flag("--fresh", common.fresh, "Compute anew what earlier runs have kept");
}

void Subcommand::footer(const std::string& text) { app_->footer(text); }
void Subcommand::runs(Action action) {
  app_->callback([chosen = action_, action = std::move(action)] { *chosen = action; });
}

Program::Program(int count, const char* const* words)
    : tree_(std::make_unique<CLI::App>("Verified numerics for the radiosity integral equation", "radcert")),
      common_{.command = as_utf8(command_line(count, words))} {
  tree_->set_help_flag("-h,--help", "Print this help");
  tree_->set_version_flag("--version", "radcert " + std::string(version()), "Print the version");
  tree_->footer(exit_codes);
  tree_->require_subcommand(1);
}
Program::~Program() = default;

Subcommand Program::add_plain(const std::string& name, const std::string& summary) {
  CLI::App& command = *tree_->add_subcommand(name, summary);
  command.set_help_flag("-h,--help", "Print this help");
  return {command, action_};
}

Subcommand Program::add(const std::string& name, const std::string& summary) {
  Subcommand command = add_plain(name, summary);
  command.option("--json", common_.json, "Write the result as JSON to FILE, - for stdout", "FILE");
  command.option("--threads", common_.threads, "Use at most N threads; the numbers do not depend on it", "N");
  command.option("--max-memory", common_.max_memory,
                 "Refuse what would need more, as 4GB; default: what is there", "BYTES");
  command.flag("--quiet", common_.quiet, "Say nothing about progress");
  return command;
}

/// A word that a script has left empty is not one that was left out.
void refuse_empty_words(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_min() == 0) continue;
    const std::string name = option->get_name();
    option->check([name](const std::string& word) -> std::string {
      if (!word.empty()) return {};
      throw InputError({.source = name,
                        .value = "",
                        .problem = "is empty",
                        .allowed = "a word, or no " + name + " at all"});
    });
  }
  for (CLI::App* command : app.get_subcommands(nullptr)) refuse_empty_words(*command);
}

std::optional<Action> Program::parse(int argc, char** argv) {
  if (argv[1][0] != '-') require_command(*tree_, argv[1]);
  refuse_empty_words(*tree_);
  try {
    tree_->parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = tree_->get_subcommands();
    print(fitted(chosen.empty() ? tree_->help() : chosen.front()->help("radcert")));
    return std::nullopt;
  } catch (const CLI::CallForVersion& version_text) {
    print(std::string(version_text.what()) + "\n");
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    const auto chosen = tree_->get_subcommands();
    const std::string name = chosen.empty() ? std::string() : chosen.front()->get_name();
    const std::string help = chosen.empty() ? "radcert --help" : "radcert " + name + " --help";
    throw InputError({.source = name, .problem = error.what(), .allowed = "see " + help});
  }
  return action_;
}

std::string command_line(int count, const char* const* words) {
  std::string out = "radcert";
  for (int i = 1; i < count; ++i) out += " " + shell_word(words[i]);
  return out;
}

}  // namespace radcert::app
