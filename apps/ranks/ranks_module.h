// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/core/ranks/ranks.h"

namespace radcert::app {

/// How a rank comes to its end.
struct Ending {
  int code = 0;
  std::string text;  ///< what it has to say, where the code is not 0
};

/// The ranks of a run under mpirun.
class RankedRun : public Ranks {
public:
  /// The ranks on this machine, at least this one.
  [[nodiscard]] virtual std::size_t ranks_of_machine() const = 0;
  /// Of the options of PETSc those that are for solvers, and of these those that no solver knows.
  [[nodiscard]] virtual std::vector<std::string> options_of_solver() const = 0;
  [[nodiscard]] virtual std::vector<std::string> options_not_taken() const = 0;
  /// Tells the others how this rank has ended, hears how they have, and leaves MPI.
  /// Requires  called once by every rank, at last
  /// Result    the same on all ranks: the ending of the lowest rank whose code is not 0, or of the first;
  ///           where EndedElsewhere was thrown, what that said
  virtual Ending end(const Ending& own) = 0;
};

/// The one function that the module radcert_petsc has for the program: begins MPI and PETSc, with options of
/// PETSc as on a command line.
/// Result    null where that fails, and the reason
using BeginRanks = RankedRun* (*)(const std::vector<std::string>& options, std::string& failure);
inline constexpr const char* begin_ranks_name = "radcert_begin_ranks";

}  // namespace radcert::app
