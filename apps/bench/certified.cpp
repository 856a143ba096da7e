// SPDX-License-Identifier: GPL-3.0-or-later
// Entries with a proved radius a second, plane and curved. Functions of degree 1 and 2 with inset 1/6.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "radcert/collocation/certified/certified_chart_entries.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert::bench {
namespace {

LagrangeFunctions functions_of(const benchmark::State& state) {
  return lagrange_functions(inset_nodes(static_cast<int>(state.range(0)), Rational(1, 6))).value();
}

void count(benchmark::State& state, std::size_t nodes) {
  const auto n = static_cast<double>(nodes);
  state.counters["entries"] = benchmark::Counter(n * n, benchmark::Counter::kIsIterationInvariantRate);
}

void certified_plane_entries(benchmark::State& state) {
  const Surface surface = cube();
  const Triangulation triangulation = triangulate(surface, static_cast<int>(state.range(1)));
  std::vector<ExactTriangle> elements;
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    const ChartIn<double>& chart = surface.charts[triangle.chart].in<double>();
    ExactTriangle corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<double> at = chart.frame(triangle.vertices[i]).point;  // dyadic, so exact
      corners[i] = {Rational::exactly(at.x), Rational::exactly(at.y), Rational::exactly(at.z)};
    }
    elements.push_back(corners);
  }
  const LagrangeFunctions functions = functions_of(state);
  const std::vector<double> reflectivity(elements.size() * functions.size(), 1.0);
  const ThreadLimit one(1);
  for (auto step : state)
    benchmark::DoNotOptimize(certified_entries(elements, functions, reflectivity).has_value());
  count(state, reflectivity.size());
}
BENCHMARK(certified_plane_entries)->ArgNames({"degree", "level"})->ArgsProduct({{1, 2}, {2}});

void curved(benchmark::State& state, const Surface& surface) {
  const Triangulation triangulation = triangulate(surface, static_cast<int>(state.range(1)));
  const LagrangeFunctions functions = functions_of(state);
  const std::vector<double> reflectivity(triangulation.triangles.size() * functions.size(), 1.0);
  const double demand = std::pow(10.0, -static_cast<double>(state.range(2)));
  const ThreadLimit one(1);
  for (auto step : state) {
    const bool found =
        certified_chart_entries(surface, triangulation, functions, reflectivity, demand).has_value();
    if (!found) state.SkipWithError("refused");
  }
  count(state, reflectivity.size());
}

void certified_roof_entries(benchmark::State& state) { curved(state, two_piece(2)); }
BENCHMARK(certified_roof_entries)
    ->ArgNames({"degree", "level", "digits"})
    ->ArgsProduct({{1}, {1, 2}, {8, 11}})
    ->Unit(benchmark::kMillisecond);

void certified_sphere_entries(benchmark::State& state) { curved(state, sphere()); }
BENCHMARK(certified_sphere_entries)
    ->ArgNames({"degree", "level", "digits"})
    ->ArgsProduct({{1}, {0}, {8, 11}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace radcert::bench
