// SPDX-License-Identifier: GPL-3.0-or-later

// radcert: the command line. One file a subcommand beside this one.
#include <exception>
#include <new>
#include <optional>
#include <string>

#include "command.h"
#include "output.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/version.h"

namespace {

using namespace radcert;
using namespace radcert::app;

void welcome() {
  print("radcert " + std::string(version()) +
        ": verified numerics for the radiosity integral equation\n\n"
        "Worth trying, seconds each:\n"
        "  radcert list surfaces\n"
        "  radcert example problem > problem.json\n"
        "  radcert solve problem.json\n\n"
        "The main job is radcert verify. All commands: radcert --help\n");
}

int code(ExitCode exit) { return static_cast<int>(exit); }

int run(int argc, char** argv) {
  if (argc <= 1) {
    welcome();
    return code(ExitCode::done);
  }
  Program program(argc, argv);
  add_solve(program);
  add_check(program);
  add_verify(program);
  add_reference(program);
  add_surface(program);
  add_factors(program);
  add_experiment(program);
  add_basis(program);
  add_picture(program);
  add_list(program);
  add_schema(program);
  add_example(program);
  add_completion(program);
  add_man(program);
  const std::optional<Action> action = program.parse(argc, argv);
  if (!action) return code(ExitCode::done);
  install_interrupt_handler();
  return code((*action)());
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
