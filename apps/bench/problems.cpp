// SPDX-License-Identifier: GPL-3.0-or-later
// Whole problems: assembly beside the plain program, and studies from the triangulation to the errors.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "plain.h"
#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/parallel.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/quadrature/element_integrator.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert::bench {
namespace {

Surface surface_called(const std::string& name) {
  if (name == "cube") return cube();
  if (name == "sphere") return sphere();
  return two_piece(2);
}

const InsetBasis<double>& linear_basis() {
  static const InsetBasis<double> basis(1, 1.0 / 6);
  return basis;
}

/// How often an assembly evaluates G from afar: blocks of observers at least 2.5 radii from an element. The
/// near ones come on top, so that the rate that follows is a lower bound.
double far_evaluations(const Surface& surface, const Triangulation& triangulation,
                       std::span<const CollocationPoint<double>> nodes, const Tolerance& tolerance) {
  const IntegrationScheme<double> scheme(surface, linear_basis(), tolerance);
  const std::vector<CollocationPointBlock<double>> blocks = observer_blocks(nodes);
  double evaluations = 0;
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    const Chart& chart = surface.charts[triangle.chart];
    const Vector<double> centre = chart.in<double>().frame(triangle.at({1.0 / 3, 1.0 / 3, 1.0 / 3})).point;
    double radius = 0;
    for (const ParameterPoint<double>& v : triangle.vertices)
      radius = std::max(radius, norm(chart.in<double>().frame(v).point - centre));
    for (const CollocationPointBlock<double>& block : blocks) {
      const double eta = (norm(block.centre - centre) - block.radius) / radius;
      if (scheme.in_plane(block.chart, triangle.chart) || eta < 2.5) continue;
      const FarRule rule = scheme.far_rule(chart.facts(), eta, 0);
      const int compared = rule.compared_with.value_or(0);
      evaluations += static_cast<double>(Pack::lanes) * (rule.order * rule.order + compared * compared);
    }
  }
  return evaluations;
}

void assembly(benchmark::State& state, const std::string& name, int level, double tolerance) {
  const ThreadLimit limit(static_cast<std::size_t>(state.range(0)));
  const Surface surface = surface_called(name);
  const Triangulation triangulation = triangulate(surface, level);
  const std::vector<CollocationPoint<double>> nodes =
      collocation_nodes(surface, triangulation, linear_basis());
  const std::vector<double> reflectivity(nodes.size(), 1.0);
  for (auto step : state) {
    const CollocationMatrix<double> matrix =
        assemble<double>(surface, triangulation, linear_basis(), nodes, reflectivity, Tolerance(tolerance));
    benchmark::DoNotOptimize(matrix.entries.column(0).data());
  }
  const auto unknowns = static_cast<double>(nodes.size());
  using benchmark::Counter;
  state.counters["unknowns"] = unknowns;
  state.counters["entries"] = Counter(unknowns * unknowns, Counter::kIsIterationInvariantRate);
  state.counters["evaluations"] =
      Counter(far_evaluations(surface, triangulation, nodes, Tolerance(tolerance)),
              Counter::kIsIterationInvariantRate);
}

void plain_assembly(benchmark::State& state, const std::string& name, int level) {
  const Surface surface = surface_called(name);
  const Triangulation triangulation = triangulate(surface, level);
  for (auto step : state) {
    const Matrix<double> matrix = plain_collocation_matrix(surface, triangulation, linear_basis());
    benchmark::DoNotOptimize(matrix.column(0).data());
  }
  const auto unknowns =
      static_cast<double>(triangulation.triangles.size()) * static_cast<double>(linear_basis().size());
  state.counters["unknowns"] = unknowns;
  state.counters["entries"] = benchmark::Counter(unknowns * unknowns, benchmark::Counter::kIsRate);
}

/// E, the discretisation error, the solution and its error, over all levels: what `radcert solve` does.
void study(benchmark::State& state, const std::string& file, const std::string& solver) {
  const ThreadLimit limit(static_cast<std::size_t>(state.range(0)));
  Problem problem = read_problem(std::string(RADCERT_SOURCE_DIR) + "/papers/ac98/problems/" + file);
  problem.solver.name = solver;
  const OperatorRoute route = reference::applied_operator;
  double assembly_seconds = 0;
  double operator_seconds = 0;
  double solve_seconds = 0;
  double bytes_per_unknown = 0;
  for (auto step : state)
    for (const int level : problem.triangulation.levels) {
      const LevelOutcome outcome = solve_level(problem, level, route);
      assembly_seconds += outcome.timing.assembly_seconds;
      operator_seconds += outcome.timing.operator_seconds;
      solve_seconds += outcome.timing.solve_seconds;
      bytes_per_unknown =
          static_cast<double>(outcome.result.planned_bytes) / static_cast<double>(outcome.result.unknowns);
    }
  using benchmark::Counter;
  state.counters["assembly"] = Counter(assembly_seconds, Counter::kAvgIterations);
  state.counters["operator"] = Counter(operator_seconds, Counter::kAvgIterations);
  state.counters["solve"] = Counter(solve_seconds, Counter::kAvgIterations);
  state.counters["bytes_per_unknown"] = bytes_per_unknown;
}

void timed_by_the_clock(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->UseRealTime()->ArgName("threads");
}
void on_one_and_two_threads(benchmark::internal::Benchmark* b) {
  timed_by_the_clock(b);
  b->Arg(1)->Arg(2);
}
void once(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
}

BENCHMARK_CAPTURE(assembly, cube_768, "cube", 3, 1e-13)->Apply(on_one_and_two_threads);
BENCHMARK_CAPTURE(assembly, two_piece_256, "two_piece", 3, 1e-13)->Apply(on_one_and_two_threads);
BENCHMARK_CAPTURE(assembly, two_piece_1024, "two_piece", 4, 1e-13)->Apply(on_one_and_two_threads);
BENCHMARK_CAPTURE(assembly, sphere_512, "sphere", 3, 1e-13)->Apply(on_one_and_two_threads);
BENCHMARK_CAPTURE(assembly, cube_3072_to_1e_12, "cube", 4, 1e-12)->Apply(on_one_and_two_threads);
BENCHMARK_CAPTURE(assembly, cube_768_to_1e_6, "cube", 3, 1e-6)->Apply(on_one_and_two_threads);
BENCHMARK_CAPTURE(plain_assembly, cube_192, "cube", 2)->Apply(once);
BENCHMARK_CAPTURE(plain_assembly, cube_768, "cube", 3)->Apply(once);
BENCHMARK_CAPTURE(plain_assembly, two_piece_256, "two_piece", 3)->Apply(once);
BENCHMARK_CAPTURE(study, two_piece_to_1024_gmres, "table_1_alpha_1_6.json", "gmres")
    ->Apply(on_one_and_two_threads);
BENCHMARK_CAPTURE(study, two_piece_to_1024_direct, "table_1_alpha_1_6.json", "direct")
    ->Apply(on_one_and_two_threads);
BENCHMARK_CAPTURE(study, cube_to_768_gmres, "table_4.json", "gmres")->Apply(on_one_and_two_threads);
BENCHMARK_CAPTURE(study, cube_to_768_direct, "table_4.json", "direct")->Apply(on_one_and_two_threads);

}  // namespace
}  // namespace radcert::bench
