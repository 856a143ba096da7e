// SPDX-License-Identifier: GPL-3.0-or-later

// radcert: the command line. One file a subcommand beside this one.
#include <CLI/CLI.hpp>
#include <array>
#include <exception>
#include <new>
#include <string>

#include "command.h"
#include "output.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/version.h"
#include "radcert/formats/json/json_reader.h"

namespace {

using namespace radcert;
using namespace radcert::app;

constexpr const char* exit_codes =
    "Results go to stdout, everything else to stderr.\n"
    "Exit codes: 0 done, every verdict as recorded; 1 a verdict differs from the record, or a demanded "
    "accuracy was\n"
    "not reached; 2 the input is wrong; 3 the environment failed, or radcert itself has a defect; 130 "
    "interrupted.";

void welcome() {
  print("radcert " + std::string(version()) +
        ": verified numerics for the radiosity integral equation\n\n"
        "Worth trying, seconds each:\n"
        "  radcert list surfaces\n"
        "  radcert example problem > problem.json\n"
        "  radcert solve problem.json\n\n"
        "The main job is radcert verify. All commands: radcert --help\n");
}

/// A word in the place of a subcommand that is none.
void require_command(const CLI::App& program, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == word) return;
    names.push_back(command->get_name());
  }
  const auto near = nearest_word(word, names);
  throw InputError({.value = word,
                    .problem = "is no command" + (near ? "; did you mean " + *near + "?" : std::string()),
                    .allowed = listed(names)});
}

int code(ExitCode exit) { return static_cast<int>(exit); }

int run(int argc, char** argv) {
  if (argc <= 1) {
    welcome();
    return code(ExitCode::done);
  }
  CLI::App program("Verified numerics for the radiosity integral equation", "radcert");
  program.set_help_flag("-h,--help", "Print this help");
  program.set_version_flag("--version", "radcert " + std::string(version()), "Print the version");
  program.footer(exit_codes);
  program.require_subcommand(1);

  Common common{.command = command_line(argc, argv)};
  Action action;
  add_solve(program, common, action);
  add_verify(program, common, action);
  add_reference(program, common, action);
  add_surface(program, common, action);
  add_factors(program, common, action);
  add_experiment(program, common, action);
  add_basis(program, common, action);
  add_picture(program, common, action);
  add_list(program, common, action);
  add_schema(program, common, action);
  add_example(program, common, action);
  add_completion(program, action);
  add_man(program, action);

  if (argv[1][0] != '-') require_command(program, argv[1]);
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = program.get_subcommands();
    print(fitted(chosen.empty() ? program.help() : chosen.front()->help("radcert")));
    return code(ExitCode::done);
  } catch (const CLI::CallForVersion& version_text) {
    print(std::string(version_text.what()) + "\n");
    return code(ExitCode::done);
  } catch (const CLI::ParseError& error) {
    const auto chosen = program.get_subcommands();
    const std::string name = chosen.empty() ? std::string() : chosen.front()->get_name();
    const std::string help = chosen.empty() ? "radcert --help" : "radcert " + name + " --help";
    throw InputError({.source = name, .problem = error.what(), .allowed = "see " + help});
  }
  install_interrupt_handler();
  return code(action());
}

void defect(const std::string& what) { complain("a defect of radcert itself, please report it: " + what); }

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const InputError& error) {
    complain(error.what());
    return code(ExitCode::input);
  } catch (const EnvironmentError& error) {
    complain(error.what());
    return code(ExitCode::environment);
  } catch (const AccuracyNotReached& error) {
    complain(error.what());
    return code(ExitCode::differs);
  } catch (const Interrupted&) {
    complain("interrupted; what was finished is kept");
    return code(ExitCode::interrupted);
  } catch (const std::bad_alloc&) {
    complain("memory: there is not enough");
    return code(ExitCode::environment);
  } catch (const std::exception& error) {
    defect(error.what());
  } catch (...) {
    defect("an exception of an unknown kind");
  }
  return code(ExitCode::environment);
}
