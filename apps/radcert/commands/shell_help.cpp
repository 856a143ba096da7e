// SPDX-License-Identifier: GPL-3.0-or-later

// radcert completion and radcert man: the tree of commands and options as a script for bash and as a manual
// page.
#include <CLI/CLI.hpp>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "command.h"
#include "examples.h"
#include "output.h"
#include "radcert/core/errors.h"
#include "radcert/core/version.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/formats/schema/schemas.h"
#include "radcert/geometry/mesh_repair.h"
#include "verification/claims/psg10/figures/figure.h"
#include "verification/framework/reading/paper.h"
#include "verification/framework/run_verification.h"

namespace radcert::app {

namespace {

std::vector<const CLI::App*> commands(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

/// The options of a command that have a name with dashes, or the words that stand for themselves.
std::vector<const CLI::Option*> options(const CLI::App& command, bool positional) {
  return command.get_options(
      [positional](const CLI::Option* option) { return option->get_positional() == positional; });
}

std::vector<std::string> dashed_names(const CLI::Option& option) {
  std::vector<std::string> out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
  return out;
}

/// What the word of a command may be, where it is one of a list.
std::vector<std::string> words_of(const std::string& command) {
  if (command == "schema") return schema_names();
  std::vector<std::string> out;
  if (command == "example") {
    for (const Example& example : examples()) out.emplace_back(example.name);
    for (const Example& example : experiment_examples()) out.emplace_back(example.name);
  }
  if (command == "list") out = list_names();
  if (command == "picture")
    for (const verification::psg10::FigureKind& kind : verification::psg10::figure_kinds())
      out.emplace_back(kind.name);
  if (command == "completion") out = {"bash"};
  if (command == "verify") {
    // Tables have a name beside those of their cells.
    const std::vector<std::string> claims = listed_names("claims");
    std::set<std::string> words(claims.begin(), claims.end());
    for (const verification::Paper& paper : verification::embedded_paper_list()) {
      words.insert(paper.key);
      for (const std::string& label : verification::statement_labels(paper))
        words.insert(paper.key + "/" + label);
    }
    out.assign(words.begin(), words.end());
  }
  if (command == "reference") out = listed_names("references");
  if (command == "surface" || command == "factors") out = listed_names("surfaces");
  if (command == "basis") out = {"inset", "symmetric", "search"};
  if (command == "experiment") out = {"scoreboard"};
  return out;
}

/// Whether it may be the name of a file or a folder as well.
bool takes_files(const std::string& command) {
  return command == "verify" || command == "surface" || command == "factors" || command == "basis" ||
         command == "experiment";
}

/// What bash is to offer after an option: folders, files, the words of a choice, or nothing.
std::string completion_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  if (type.find("DIR") != std::string::npos)
    return "compopt -o filenames; COMPREPLY=($(compgen -d -- \"$word\"))";
  if (type.find("FILE") != std::string::npos)
    return "compopt -o filenames; COMPREPLY=($(compgen -f -- \"$word\"))";
  for (const std::string& name : option.get_lnames()) {
    if (name == "budget") return "COMPREPLY=($(compgen -W 'quick standard full' -- \"$word\"))";
    if (name == "direct") return "COMPREPLY=($(compgen -W 'basis exact' -- \"$word\"))";
    if (name == "by") return "COMPREPLY=($(compgen -W 'triangle piece group' -- \"$word\"))";
    if (name == "front") return "COMPREPLY=($(compgen -W 'auto right-hand left-hand' -- \"$word\"))";
    if (name == "of")
      return "COMPREPLY=($(compgen -W '" + joined(guaranteed_quantities(), " ") + "' -- \"$word\"))";
    if (name == "repair")
      return "COMPREPLY=($(compgen -W '" +
             joined(std::vector<std::string>(repair_words.begin(), repair_words.end()), " ") +
             "' -- \"$word\"))";
    if (name == "unit") return "COMPREPLY=($(compgen -W 'mm cm m in' -- \"$word\"))";
  }
  return "COMPREPLY=()";
}

/// The claims of a folder of one's own, after its name and a slash.
constexpr std::string_view claims_of_folder =
    "_radcert_claims() {\n"
    "  local folder=${1%/*} label\n"
    "  [[ $1 == */* && -f $folder/claims.toml ]] || return\n"
    "  while read -r label; do\n"
    "    [[ $folder/$label == \"$1\"* ]] && COMPREPLY+=(\"$folder/$label\")\n"
    "  done < <(sed -n 's/^\\[\\([A-Za-z0-9_]*\\)\\].*/\\1/p' \"$folder/claims.toml\")\n"
    "}\n";

std::string bash_script(const CLI::App& program) {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* command : commands(program)) {
    names.push_back(command->get_name());
    std::vector<std::string> dashed;
    std::string values;
    for (const CLI::Option* option : options(*command, false)) {
      const std::vector<std::string> own = dashed_names(*option);
      dashed.insert(dashed.end(), own.begin(), own.end());
      if (takes_value(*option))
        values += "        " + joined(own, "|") + ") " + completion_of(*option) + "; return ;;\n";
    }
    const std::vector<std::string> words = words_of(command->get_name());
    cases +=
        "    " + command->get_name() + ")\n      case $previous in\n" + values +
        "      esac\n      if [[ $word == -* ]]; then\n        COMPREPLY=($(compgen -W '" +
        joined(dashed, " ") + "' -- \"$word\"))\n      else\n        " +
        (words.empty() ? std::string("compopt -o filenames; COMPREPLY=($(compgen -f -- \"$word\"))")
                       : "COMPREPLY=($(compgen -W '" + joined(words, " ") + "' -- \"$word\")" +
                             (takes_files(command->get_name()) ? " $(compgen -f -- \"$word\")" : "") + ")") +
        (command->get_name() == "verify" ? "; _radcert_claims \"$word\"" : "") + "\n      fi ;;\n";
  }
  return "# radcert " + std::string(version()) + " in bash: source <(radcert completion bash)\n" +
         std::string(claims_of_folder) +
         "_radcert() {\n  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  COMPREPLY=()\n"
         "  if ((COMP_CWORD == 1)); then\n    COMPREPLY=($(compgen -W '" +
         joined(names, " ") +
         " --help --version' -- \"$word\"))\n    return\n  fi\n  case ${COMP_WORDS[1]} in\n" + cases +
         "  esac\n}\ncomplete -F _radcert radcert\n";
}

/// Text for troff: no line is taken for a request, hyphens and backslashes stay what they are.
std::string troff(std::string_view text) {
  std::string out;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    begins = c == '\n';
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string manual_entry(const CLI::Option& option) {
  std::string out = ".TP\n";
  if (option.get_positional())
    out += ".I " + troff(option.get_name(true)) + "\n";
  else
    out += ".B " + troff(joined(dashed_names(option), ", ")) +
           (takes_value(option) ? " \\fI" + troff(option.get_type_name()) + "\\fR" : "") + "\n";
  return out + troff(option.get_description()) + ".\n";
}

std::string synopsis(const CLI::App& command) {
  std::string out = ".B radcert " + troff(command.get_name()) + "\n";
  for (const CLI::Option* option : options(command, true))
    out += option->get_required() ? "\\fI" + troff(option->get_name(true)) + "\\fR\n"
                                  : "[\\fI" + troff(option->get_name(true)) + "\\fR]\n";
  return out + "[\\fIoptions\\fR]\n.br\n";
}

std::string manual_page(const CLI::App& program) {
  std::string out = ".TH RADCERT 1 \"\" \"radcert " + std::string(version()) +
                    "\" \"User commands\"\n.SH NAME\nradcert \\- verified numerics for the radiosity "
                    "integral equation\n.SH SYNOPSIS\n";
  for (const CLI::App* command : commands(program)) out += synopsis(*command);
  out += ".SH COMMANDS\n";
  for (const CLI::App* command : commands(program)) {
    out += ".SS " + troff(command->get_name()) + "\n" + troff(command->get_description()) + ".\n";
    for (const bool positional : {true, false})
      for (const CLI::Option* option : options(*command, positional)) out += manual_entry(*option);
    if (const std::string footer = command->get_footer(); !footer.empty())
      out += ".PP\n" + troff(footer) + "\n";
  }
  return out +
         ".SH EXIT STATUS\n.TP\n.B 0\nDone, every verdict as recorded.\n.TP\n.B 1\nA verdict differs from "
         "the "
         "record, or a demanded accuracy was not reached.\n.TP\n.B 2\nThe input is wrong.\n.TP\n.B 3\nThe "
         "environment failed, or radcert itself has a defect.\n.TP\n.B 130\nInterrupted.\n"
         ".SH ENVIRONMENT\n.TP\n.B RADCERT_STORE\nThe folder in which finished work is kept; without it "
         "~/.cache/radcert.\n.TP\n.B NO_COLOR\nIf it is set and not empty, nothing is coloured.\n"
         ".TP\n.B COLUMNS\nThe width of a terminal that does not tell its own.\n";
}

}  // namespace

void add_completion(Program& program) {
  Subcommand command =
      program.add_plain("completion", "Print a script that completes radcert's words in a shell");
  auto shell = std::make_shared<std::string>();
  command.word("SHELL", *shell, "bash", "bash");
  command.footer("In ~/.bashrc: source <(radcert completion bash)");
  command.runs([&program, shell] {
    if (*shell != "bash") throw InputError({.source = "completion", .value = *shell, .allowed = "bash"});
    print(bash_script(program.tree()));
    return ExitCode::done;
  });
}

void add_man(Program& program) {
  Subcommand command = program.add_plain("man", "Print the manual page");
  command.footer("To read it: radcert man | man -l -");
  command.runs([&program] {
    print(manual_page(program.tree()));
    return ExitCode::done;
  });
}

}  // namespace radcert::app
