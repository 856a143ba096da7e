// SPDX-License-Identifier: GPL-3.0-or-later
// Enclosures of the solution itself: the width that is proved, the points at which residuals were taken, and
// seconds. Half of the light is reflected, one face emits.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "radcert/continuous/goal_enclosure.h"
#include "radcert/surface/catalogue.h"

namespace radcert::bench {
namespace {

void means(benchmark::State& state, const std::string& name, const std::vector<Rational>& parameters) {
  const SurfaceDescription& surface = *find_surface(name);
  PolyhedronProblem problem{
      .panels =
          convex_panels(parameters.empty() ? default_surface(surface) : surface.make(parameters)).value(),
      .reflectivity = {},
      .emission = {}};
  problem.reflectivity.assign(problem.panels.size(), Rational(1, 2));
  problem.emission.assign(problem.panels.size(), constant_polynomial(Rational(0)));
  problem.emission[0] = constant_polynomial(Rational(1));
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

const bool registered = [] {
  of("cube", {}, {4, 6, 7});
  of("box", {1, 2, 3}, {5});
  of("tetrahedron", {}, {5});
  of("octahedron", {}, {5});
  return true;
}();

}  // namespace
}  // namespace radcert::bench
