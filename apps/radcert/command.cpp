// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "radcert/core/checked.h"
#include "radcert/core/memory_plan.h"

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
  const std::size_t power = std::string_view("kMG").find(suffix);
  if (suffix.size() != 1 || power == std::string_view::npos) return std::nullopt;
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

}  // namespace

std::optional<std::size_t> Common::thread_limit() const {
  if (threads.empty()) return std::nullopt;
  constexpr std::uint64_t most = 4096;
  std::string_view rest;
  const auto number = positive(threads, rest);
  if (!number || !rest.empty() || *number > most)
    throw InputError({.source = "--threads", .value = threads, .allowed = "a whole number from 1 to 4096"});
  return static_cast<std::size_t>(*number);
}

std::uint64_t Common::memory_limit() const {
  const std::uint64_t available = available_memory();
  if (max_memory.empty()) return available;
  const auto limit = bytes(max_memory);
  if (!limit)
    throw InputError({.source = "--max-memory",
                      .value = max_memory,
                      .allowed = "a positive whole number of bytes; k, M or G behind it count in 1024s"});
  return std::min(available, *limit);
}

CLI::App& add_command(CLI::App& program, Common& common, const std::string& name,
                      const std::string& summary) {
  CLI::App& command = *program.add_subcommand(name, summary);
  command.set_help_flag("-h,--help", "Print this help");
  command.add_option("--json", common.json, "Write the result as JSON to FILE, - for stdout")
      ->type_name("FILE");
  command.add_option("--threads", common.threads, "Use at most N threads; the numbers do not depend on it")
      ->type_name("N");
  command
      .add_option("--max-memory", common.max_memory, "Refuse what would need more; default: what is there")
      ->type_name("BYTES");
  command.add_flag("--quiet", common.quiet, "Say nothing about progress");
  return command;
}

std::string command_line(int count, const char* const* words) {
  std::string out = "radcert";
  for (int i = 1; i < count; ++i) out += " " + shell_word(words[i]);
  return out;
}

}  // namespace radcert::app
