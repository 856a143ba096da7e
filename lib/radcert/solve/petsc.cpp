// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/ranks/krylov_engine.h"
#include "radcert/solve/iteration.h"
#include "radcert/solve/linear_solver.h"

namespace radcert {
namespace {

/// The vectors that PETSc's GMRES holds unless its options say otherwise.
constexpr std::size_t usual_vectors = 64;

/// Corrections by the Krylov method that comes with the ranks, refined until the error bound is small enough:
/// as solve_by_gmres, whose error bound does not ask how a correction was found.
Outcome<IterativeSolution, NotReached> solve_by_engine(const SystemProducts& k,
                                                       const Contraction& contraction,
                                                       std::span<const double> e,
                                                       std::optional<double> tolerance, KeptNumbers* kept) {
  const VectorParts parts = k.parts();
  const KrylovEngine* engine = parts.ranks().krylov_engine();
  expects(engine != nullptr, "ranks with Krylov methods");
  const KrylovEngine::Product product = [&k](std::span<const double> x, std::span<double> y) {
    k.multiply(x, y);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = x[i] - y[i];
  };
  const KrylovEngine::Dot dot = [&parts](std::span<const double> x, std::span<const double> y) {
    return parts.dot(x, y);
  };
  const double least_weight = contraction.least_weight();
  const auto correct = [&](std::span<double> r, double goal) {
    constexpr double enough = 0x1p-36;
    const double size = parts.size_of(r);
    if (size == 0) return std::size_t{0};
    // Of size 1, so that no square overflows.
    for (double& each : r) each /= size;
    const double length = std::sqrt(parts.dot(r, r));
    const std::size_t iterations =
        engine->solve(product, dot, std::max(enough, goal * least_weight / 2 / size / length), r);
    for (double& each : r) each *= size;
    return iterations;
  };
  return iterate(k, contraction, e, tolerance, {.apply = correct, .reflections = usual_vectors}, kept);
}

}  // namespace

LinearSolver petsc_entry() {
  return {
      .name = "petsc",
      .summary =
          "PETSc's Krylov methods, on ranks alone; a proved bound of the linear system's error stops it",
      .iterate = solve_by_engine,
      .plan = [](MemoryPlan& plan,
                 std::uint64_t n) { plan.add("Krylov vectors", n, (usual_vectors + 3) * sizeof(double)); },
      .on_ranks = true};
}

}  // namespace radcert
