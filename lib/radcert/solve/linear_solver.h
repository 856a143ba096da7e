// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/core/memory_plan.h"
#include "radcert/core/outcome.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/iteration.h"
#include "radcert/solve/system_matrix.h"

namespace radcert {

/// A linear system (I - K) u = e whose matrix and right-hand side are known within radii.
struct LinearSystem {
  SystemMatrix k;
  std::span<const double> row_radius;  ///< for each row, of the sum of its entries' errors
  std::span<const double> e;
  std::span<const double> e_radius;
  const Contraction* contraction;  ///< of all matrices within the radii; null where none was found
};

/// How an iterative solver came to its solution.
struct IterationReport {
  std::uint64_t iterations = 0;  ///< reflections of `neumann`, Krylov vectors of `gmres`
  double contraction = 0;        ///< theta < 1 of the weighted norm in which K contracts
  double error_bound = 0;        ///< of max |u - values|, u the solution of the system as stored, proved
};

/// A vector near the solutions of all systems within the radii.
struct LinearSolution {
  std::vector<double> values;
  double radius = 0;  ///< bounds max |u - values| over all of these systems
  std::optional<IterationReport> iteration = std::nullopt;
};

/// How the linear system of a level may be solved.
struct LinearSolver {
  std::string name;
  std::string summary;  ///< one line
  /// Of a solver that iterates: stops at a tolerance, by an error bound, as `iterate` does, and asks for a
  /// contraction and for products alone.
  std::function<Outcome<IterativeSolution, NotReached>(
      const SystemProducts& k, const Contraction& contraction, std::span<const double> e,
      std::optional<double> tolerance, KeptNumbers* kept)>
      iterate = {};
  /// Of a solver that reads the entries of the matrix: a reason in words where the system has no solution
  /// within bounds. A solver that has neither this nor `iterate` chooses another, or proves, and needs a
  /// matrix whose entries are enclosed (verified_system).
  std::function<Outcome<LinearSolution>(const LinearSystem& system)> eliminate = {};
  /// Of a solver that leaves the choice open: the name of the one that it takes, from whether a contraction
  /// was found: one that iterates where there is one, and another elsewhere, whose memory is planned then.
  std::function<std::string_view(bool contracts)> choose = {};
  /// Adds its memory beside the matrix.
  std::function<void(MemoryPlan& plan, std::uint64_t unknowns)> plan = {};
  /// Of a solver that needs the Krylov methods of ranks: gmres serves where a level is not shared.
  bool on_ranks = false;
  [[nodiscard]] bool iterates() const { return iterate != nullptr; }
  [[nodiscard]] bool proves() const { return !iterate && !eliminate && !choose; }
  /// Whether it may take a system that is known by its products alone.
  [[nodiscard]] bool takes_products() const { return iterate || choose; }
};

/// The solvers that radcert knows by name.
/// Source    the list `linear_solvers` in lib/CMakeLists.txt: <name>.cpp defines <name>_entry()
/// Result    in a fixed order
[[nodiscard]] const std::vector<LinearSolver>& linear_solvers();

/// The solver of that name, or null.
[[nodiscard]] const LinearSolver* find_linear_solver(std::string_view name);

/// The solver that is taken where `solver` was asked for: itself, or the one that it chooses.
[[nodiscard]] const LinearSolver& chosen(const LinearSolver& solver, bool contracts);

/// The names of the solvers that a condition holds for, in the order of the list.
[[nodiscard]] std::vector<std::string> solver_names(
    const std::function<bool(const LinearSolver&)>& condition = [](const LinearSolver&) { return true; });

/// Bounds of |(I - K)(u - v)|, entry by entry, over all systems within the radii.
/// Maths     |e - (I - K) v| + |K's errors| |v| + |e's errors|, v's residual bounded by `residual_sizes`
[[nodiscard]] std::vector<double> defects(const LinearSystem& system, std::span<const double> v,
                                          std::vector<double> residual_sizes);

/// Solves a system of finite numbers by a solver that iterates or eliminates.
/// Requires  for one that iterates a contraction; `tolerance`, and where it keeps its state, are for such a
///           solver alone
/// Result    the solution with the radius over all systems within the radii; else a reason in words, of an
///           iteration how far it came
[[nodiscard]] Outcome<LinearSolution> solution_of(const LinearSystem& system, const LinearSolver& solver,
                                                  std::optional<double> tolerance,
                                                  KeptNumbers* kept = nullptr);

}  // namespace radcert
