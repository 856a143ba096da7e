// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/core/ranks/ranks.h"
#include "radcert/study/problem.h"

namespace radcert::app {

/// The ranks of this run: one, but under mpirun.
[[nodiscard]] const Ranks& ranks();

/// The ranks of a run from its begin to its end.
/// Requires  one object, in main
class RunRanks {
public:
  /// Takes `--petsc` and what follows it from the command line. Under mpirun begins MPI and PETSc; InputError
  /// where that is not for this command, EnvironmentError where it cannot be. Ranks but the first are silent.
  void begin(int& argc, char** argv);
  /// The exit code of the run, after this rank has ended with that; the first rank says what stopped others.
  [[nodiscard]] int end(int code);

private:
  std::unique_ptr<ThreadLimit> threads_;
};

/// The memory that all ranks may take together, each so much but for what others on its machine take.
[[nodiscard]] std::uint64_t memory_of_all_ranks(std::uint64_t here);

/// The problem with PETSc's solver in place of auto where options for it are given; InputError where it asks
/// for another one.
[[nodiscard]] Problem with_solver_of_run(Problem problem);

/// InputError where a rank has read another text than the first one, by that name.
void require_same_on_all_ranks(const std::string& name, const std::string& text);

}  // namespace radcert::app
