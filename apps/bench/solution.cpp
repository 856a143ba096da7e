// SPDX-License-Identifier: GPL-3.0-or-later
// Enclosures of the solution itself: the width that is proved, the points at which residuals were taken, and
// seconds. Half of the light is reflected; of a polyhedron one face emits.
#include <benchmark/benchmark.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "radcert/continuous/ellipsoid/ellipsoid_enclosure.h"
#include "radcert/continuous/function_enclosure.h"
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/expression/parse.h"
#include "radcert/surface/catalogue.h"

namespace radcert::bench {
namespace {

PolyhedronProblem lit(const std::string& name, const std::vector<Rational>& parameters) {
  const SurfaceDescription& surface = *find_surface(name);
  PolyhedronProblem problem{
      .panels =
          convex_panels(parameters.empty() ? default_surface(surface) : surface.make(parameters)).value(),
      .reflectivity = {},
      .emission = {}};
  problem.reflectivity.assign(problem.panels.size(), Rational(1, 2));
  problem.emission.assign(problem.panels.size(), constant_polynomial(Rational(0)));
  problem.emission[0] = constant_polynomial(Rational(1));
  return problem;
}

void means(benchmark::State& state, const std::string& name, const std::vector<Rational>& parameters) {
  const PolyhedronProblem problem = lit(name, parameters);
  GoalEnclosure found;
  for (auto step : state)
    found = enclose_means(problem, std::pow(10.0, -static_cast<double>(state.range(0))));
  state.counters["width"] = found.width;
  state.counters["samples"] = static_cast<double>(found.last.samples);
  state.counters["unknowns"] = static_cast<double>(found.last.unknowns);
}

void of(const std::string& name, const std::vector<Rational>& parameters,
        const std::vector<std::int64_t>& digits) {
  benchmark::internal::Benchmark* const one = benchmark::RegisterBenchmark(
      ("means_of_the_solution/" + name).c_str(),
      [name, parameters](benchmark::State& state) { means(state, name, parameters); });
  one->ArgName("digits")->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
  for (const std::int64_t count : digits) one->Arg(count);
}

/// Further than a hundredth from the vertices of the cube, within a width of 1/state.
void away_from_vertices(benchmark::State& state) {
  const PolyhedronProblem problem = lit("cube", {});
  FunctionEnclosure found;
  for (auto step : state) found = enclose_function(problem, 1 / static_cast<double>(state.range(0)), 0.01);
  state.counters["width"] = 2 * found.sup;
  state.counters["samples"] = static_cast<double>(found.last.samples);
  state.counters["unknowns"] = static_cast<double>(found.last.unknowns);
}

/// Half of the light is reflected; the emission is a cubic.
void everywhere(benchmark::State& state, const Vector<Rational>& half_axes) {
  const EllipsoidProblem problem{.half_axes = half_axes,
                                 .reflectivity = parse_expression("1/2").value(),
                                 .emission = parse_expression("1 + x/2 + y*z/3 - x^2*z/5").value()};
  std::optional<EllipsoidEnclosure> found;
  for (auto step : state)
    found = enclose_on_ellipsoid(problem, 2 * std::pow(10.0, -static_cast<double>(state.range(0)))).value();
  state.counters["bound"] = found->bound;
  state.counters["width_of_mean"] = 2 * found->mean.radius;
  state.counters["degree"] = found->last.degree;
  state.counters["samples"] = static_cast<double>(found->last.samples);
  state.counters["nodes"] = static_cast<double>(found->last.nodes);
}

void on_ellipsoid(const std::string& name, const Vector<Rational>& half_axes,
                  const std::vector<std::int64_t>& digits) {
  benchmark::internal::Benchmark* const one =
      benchmark::RegisterBenchmark(("solution_everywhere/ellipsoid " + name).c_str(),
                                   [half_axes](benchmark::State& state) { everywhere(state, half_axes); });
  one->ArgName("digits")->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
  for (const std::int64_t count : digits) one->Arg(count);
}

const bool registered = [] {
  benchmark::RegisterBenchmark("solution_away_from_vertices/cube", away_from_vertices)
      ->ArgName("parts")
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kSecond)
      ->Arg(5)
      ->Arg(20)
      ->Arg(100);
  on_ellipsoid("1, 1.3, 1.7", {1, Rational(13, 10), Rational(17, 10)}, {6, 9, 12});
  on_ellipsoid("1, 1, 3", {1, 1, 3}, {6, 9});
  of("cube", {}, {4, 6, 7});
  of("box", {1, 2, 3}, {5});
  of("tetrahedron", {}, {5});
  of("octahedron", {}, {5});
  return true;
}();

}  // namespace
}  // namespace radcert::bench
