// SPDX-License-Identifier: GPL-3.0-or-later
// Entries a second and points an entry, by the distance of the observer and by degree.
#include <benchmark/benchmark.h>

#include <cmath>

#include "radcert/quadrature/element_integrator.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert::bench {
namespace {

/// Eight observers in a small square at a distance of `radii` radii of the element, above it.
std::vector<CollocationPoint<double>> observers_above(const Surface& surface,
                                                      const ParameterTriangle& element, double radii,
                                                      std::size_t chart_of_observers) {
  const ChartIn<double>& chart = surface.charts[element.chart].in<double>();
  const Frame<double> centre = chart.frame(element.at({1.0 / 3, 1.0 / 3, 1.0 / 3}));
  double radius = 0;
  for (const ParameterPoint<double>& v : element.vertices)
    radius = std::max(radius, norm(chart.frame(v).point - centre.point));
  const Vector<double> up = unit_normal(centre);
  const Vector<double> across = (1 / norm(centre.tangent_s)) * centre.tangent_s;
  std::vector<CollocationPoint<double>> observers;
  for (int i = 0; i < 8; ++i) {
    const Vector<double> aside = (0.02 * radius * i) * across;
    const Vector<double> d = radii * radius * (0.8 * up + 0.6 * across) + aside;
    observers.push_back({{chart_of_observers, {0, 0}}, centre.point + d, (-1 / norm(d)) * d});
  }
  return observers;
}

void entries(benchmark::State& state, const Surface& surface, const ParameterTriangle& element,
             std::size_t chart_of_observers) {
  const double radii = static_cast<double>(state.range(0)) / 10;
  const InsetBasis<double> basis(static_cast<int>(state.range(1)), 1.0 / 6);
  const Tolerance tolerance(std::pow(10.0, -static_cast<double>(state.range(2))));
  const auto scheme = std::make_shared<const IntegrationScheme<double>>(surface, basis, tolerance);
  ElementIntegrator<double> integrator(scheme, element);
  const std::vector<CollocationPoint<double>> observers =
      observers_above(surface, element, radii, chart_of_observers);
  const CollocationPointBlock<double> block = observer_blocks<double>(observers).front();
  BlockIntegral<double> integral;
  for (auto step : state) {
    integrator.integrate(block, observers, integral);
    benchmark::DoNotOptimize(integral);
  }
  const FarRule rule = scheme->far_rule(surface.charts[element.chart].facts(), radii, 0);
  const int points =
      rule.order * rule.order + (rule.compared_with ? *rule.compared_with * *rule.compared_with : 0);
  const auto functions = static_cast<double>(basis.size());
  using benchmark::Counter;
  state.counters["entries"] = Counter(functions * Pack::lanes, Counter::kIsIterationInvariantRate);
  if (radii >= 3) state.counters["points_per_entry"] = points / functions;
}

void plane_entries(benchmark::State& state) {
  const Surface surface = cube();
  entries(state, surface, {5, {{{0.25, 0.25}, {0.5, 0.25}, {0.5, 0.5}}}}, 0);
}

void curved_entries(benchmark::State& state) {
  const Surface surface = two_piece(2);
  entries(state, surface, {1, {{{0.25, 0.25}, {0.5, 0.25}, {0.5, 0.5}}}}, 0);
}

/// Distances in tenths of a radius, degrees, and minus the decimal logarithm of the tolerance.
void classes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"tenths_of_radius", "degree", "digits"});
  for (const int radii : {2, 10, 20, 40, 80, 160, 320})
    for (const int degree : {0, 1, 2, 4}) b->Args({radii, degree, 13});
  for (const int radii : {40, 80, 160, 320})
    for (const int digits : {6, 10}) b->Args({radii, 1, digits});
}
BENCHMARK(plane_entries)->Apply(classes);
BENCHMARK(curved_entries)->Apply(classes);

/// The observer on the element's own curved chart: inside it, and in a neighbour.
void own_entries(benchmark::State& state) {
  const Surface surface = two_piece(2);
  const ParameterTriangle element{1, {{{0.25, 0.25}, {0.5, 0.25}, {0.5, 0.5}}}};
  const InsetBasis<double> basis(static_cast<int>(state.range(1)), 1.0 / 6);
  ElementIntegrator<double> integrator(surface, element, basis);
  const ParameterPoint<double> at =
      state.range(0) == 0 ? element.at({0.6, 0.2, 0.2}) : ParameterPoint<double>{0.55, 0.4};
  const CollocationPoint<double> p = collocation_point<double>(surface, {1, at});
  for (auto step : state) {
    ElementIntegral<double> integral = integrator.integrate(p);
    benchmark::DoNotOptimize(integral);
  }
  state.counters["entries"] =
      benchmark::Counter(static_cast<double>(basis.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(own_entries)->ArgNames({"neighbour", "degree"})->ArgsProduct({{0, 1}, {0, 1, 2, 4}});

}  // namespace
}  // namespace radcert::bench
