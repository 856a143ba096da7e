// SPDX-License-Identifier: GPL-3.0-or-later

// radcert: the command line. One file a subcommand beside this one.
#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "circumstances.h"
#include "command.h"
#include "output.h"
#include "progress.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "radcert/core/ranks/krylov_engine.h"
#include "radcert/core/ranks/ranks.h"
#include "radcert/core/version.h"
#include "run_ranks.h"

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

/// Holds the number of threads where the system gives fewer than processors, and those that draw progress.
void limit_to_what_there_is() {
  constexpr std::size_t drawers = 2;
  const std::size_t wanted = std::max(1U, std::thread::hardware_concurrency()) - 1 + drawers;
  const std::size_t given = threads_to_be_had(wanted);
  if (given == wanted) return;
  const std::size_t at_work = given <= drawers ? 1 : given - drawers + 1;
  say("radcert: warning: the system gives " + std::to_string(given) +
      " more threads: " + std::to_string(at_work) + (at_work == 1 ? " works\n" : " work\n"));
  // Never lifted: TBB would look for threads at once.
  static_cast<void>(std::make_unique<ThreadLimit>(at_work).release());
}

int run(int argc, char** argv) {
  if (argc <= 1) {
    welcome();
    return code(ExitCode::done);
  }
  Program program(argc, argv);
  add_solve(program);
  add_check(program);
  add_edge(program);
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
  if (is_silent()) set_last_words({});
  hold_memory(program.common().memory_limit());
  limit_to_what_there_is();
  const ProgressDisplay waiting(program.common().quiet, argv[1]);
  return code((*action)());
}

void defect(const std::string& what) { complain("a defect of radcert itself, please report it: " + what); }

/// The exit code of what is done; what stops it is said.
int code_of(const std::function<int()>& work) {
  try {
    return work();
  } catch (const EndedElsewhere& error) {
    const bool is_interruption = error.code() == code(ExitCode::interrupted);
    complain(is_interruption ? "interrupted; what was finished is kept" : error.what());
    return error.code();
  } catch (const InputError& error) {
    complain(error.what());
    return code(ExitCode::input);
  } catch (const KrylovFailure& error) {
    complain(std::string("--petsc: ") + error.what());
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
  } catch (const std::filesystem::filesystem_error& error) {
    complain(error.path1().string() + ": " + error.code().message());
    // A name that no file can have is the input's fault, everything else the world's.
    return code(error.code() == std::errc::filename_too_long ? ExitCode::input : ExitCode::environment);
  } catch (const std::system_error& error) {
    // No more threads, or a file system that fails where no one expects it: the world, not radcert.
    complain(std::string("the system: ") + error.what());
    return code(ExitCode::environment);
  } catch (const std::exception& error) {
    // What TBB throws where the system has given a thread and gives it no more.
    if (std::string_view(error.what()).find("pthread_create") == std::string_view::npos) {
      defect(error.what());
    } else {
      complain(std::string("threads: there are not enough: ") + error.what());
    }
  } catch (...) {
    defect("an exception of an unknown kind");
  }
  return code(ExitCode::environment);
}

}  // namespace

int main(int argc, char** argv) {
  // A file that may not grow so long is refused by write(2), which is looked at.
  std::signal(SIGXFSZ, SIG_IGN);
  leave_when_memory_ends();
  RunRanks ranks;
  return ranks.end(code_of([&] {
    ranks.begin(argc, argv);
    return run(argc, argv);
  }));
}
