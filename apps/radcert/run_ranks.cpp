// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_ranks.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string_view>
#include <thread>

#include "apps/ranks/ranks_module.h"
#include "command.h"
#include "output.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "watched_process.h"

namespace radcert::app {
namespace {

/// The module's object, or null.
RankedRun*& run() {
  static RankedRun* run = nullptr;
  return run;
}

/// Whether a launcher of MPI has begun this process, by what the common ones leave in the environment.
bool is_launched() {
  constexpr std::array names{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
  return std::any_of(names.begin(), names.end(),
                     [](const char* name) { return std::getenv(name) != nullptr; });
}

/// The number of ranks as the launcher says it, before MPI has begun; 0 where it does not.
std::size_t launched_ranks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* text = std::getenv(name)) return std::strtoul(text, nullptr, 10);
  return 0;
}

/// The number of this rank, before MPI has begun.
std::string launched_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"})
    if (const char* text = std::getenv(name)) return text;
  return "0";
}

/// The options of PETSc, which are taken from the command line.
std::vector<std::string> options_of_petsc(int& argc, char** argv) {
  std::vector<std::string> options;
  const auto words = std::span(argv, static_cast<std::size_t>(argc));
  const auto found = std::find_if(words.begin(), words.end(),
                                  [](const char* word) { return std::string_view(word) == "--petsc"; });
  if (found == words.end()) return options;
  options.assign(found + 1, words.end());
  argc = static_cast<int>(found - words.begin());
  if (options.empty())
    throw InputError({.source = "--petsc",
                      .problem = "is followed by nothing",
                      .allowed = "options of PETSc, as the last words"});
  return options;
}

BeginRanks function_of_module() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path module =
      program.parent_path().parent_path() / "lib" / "radcert" / "radcert_petsc.so";
  if (!std::filesystem::exists(module, error))
    throw EnvironmentError("mpirun",
                           "radcert was built without PETSc; with Debian's petsc-dev, libopenmpi-dev and "
                           "openmpi-bin installed it is built with it");
  void* library = dlopen(module.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) throw EnvironmentError(module.string(), dlerror());
  // POSIX makes a function of what dlsym gives.
  BeginRanks begin = nullptr;
  void* symbol = dlsym(library, begin_ranks_name);
  static_assert(sizeof(begin) == sizeof(symbol));
  std::memcpy(&begin, &symbol, sizeof(begin));
  if (begin == nullptr) throw EnvironmentError(module.string(), "is no module of this radcert");
  return begin;
}

}  // namespace

const Ranks& ranks() { return run() ? *run() : one_rank(); }

void RunRanks::begin(int& argc, char** argv) {
  if (is_launched()) {
    go_on_watched("rank " + launched_rank());
    take_no_terminal();
    if (launched_rank() != "0") be_silent();
  }
  const std::vector<std::string> options = options_of_petsc(argc, argv);
  if (!is_launched()) {
    if (options.empty()) return;
    throw InputError({.source = "--petsc",
                      .value = options.front(),
                      .problem = "is for ranks, and there is no launcher of MPI",
                      .allowed = "mpirun -n RANKS radcert ..."});
  }
  const std::string command = argc > 1 ? argv[1] : "";
  if (launched_ranks() != 1 && command != "solve" && command != "experiment" && command != "factors")
    throw InputError({.source = "mpirun",
                      .value = command,
                      .problem = "is not shared by ranks",
                      .allowed = "solve, experiment or factors; or one process"});
  std::string failure;
  run() = function_of_module()(options, failure);
  if (run() == nullptr) throw EnvironmentError("mpirun", failure);
  const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
  threads_ = std::make_unique<ThreadLimit>(std::max<std::size_t>(1, processors / run()->ranks_of_machine()));
  if (const std::vector<std::string> left = run()->options_not_taken(); !left.empty())
    throw InputError(
        {.source = "--petsc", .value = left.front(), .problem = "is no option of PETSc that is taken here"});
}

Problem with_solver_of_run(Problem problem) {
  if (run() == nullptr || run()->options_of_solver().empty()) return problem;
  if (problem.solver.name == "auto") problem.solver.name = "petsc";
  if (problem.solver.name != "petsc")
    throw InputError({.source = "--petsc",
                      .value = run()->options_of_solver().front(),
                      .problem = "is for PETSc's solvers, and the problem asks for " + problem.solver.name,
                      .allowed = "a problem with the solver petsc, or auto"});
  return problem;
}

int RunRanks::end(int code) {
  if (run() == nullptr) return code;
  threads_.reset();
  // Once this rank has said why it ends, it says no more: a launcher that sees one rank end stops the others.
  if (code != 0) set_last_words({});
  const Ending ending = run()->end({code, code == 0 ? std::string() : last_complaint()});
  run() = nullptr;
  if (code == 0 && ending.code != 0 && !ending.text.empty()) complain(ending.text);
  return ending.code;
}

std::uint64_t memory_of_all_ranks(std::uint64_t here) {
  if (run() == nullptr) return here;
  constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();
  const auto share = static_cast<double>(here) / static_cast<double>(run()->ranks_of_machine());
  double sum = 0;
  for (const double each : run()->gather_numbers({&share, 1})) sum += each;
  return sum < static_cast<double>(unlimited) ? static_cast<std::uint64_t>(sum) : unlimited;
}

void require_same_on_all_ranks(const std::string& name, const std::string& text) {
  if (ranks().from_first(text) == text) return;
  throw InputError(
      {.source = name,
       .problem = "is another file on rank " + std::to_string(ranks().here()) + " than on rank 0",
       .allowed = "the same file on all ranks"});
}

}  // namespace radcert::app
