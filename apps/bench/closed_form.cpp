// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms over plane polygons: entries a second of PlaneElement by distance and degree, and what a ball
// costs. An entry is all functions, the monomials up to the degree, from one point to one triangle.
#include <benchmark/benchmark.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

#include "radcert/closed_form/plane_element.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/scalar/functions/dilogarithm.h"

namespace radcert::bench {
namespace {

using Exact = Vector<Rational>;

PlanePolygon triangle() { return plane_polygon({Exact{0, 0, 0}, {1, 0, 0}, {Rational(1, 4), 1, 0}}).value(); }

std::vector<PlanePolynomial<Rational>> monomials(int degree) {
  std::vector<PlanePolynomial<Rational>> all;
  for (int n = 0; n <= degree; ++n) {
    for (int j = 0; j <= n; ++j) {
      PlanePolynomial<Rational> q(n);
      q(n - j, j) = 1;
      all.push_back(q);
    }
  }
  return all;
}

struct Observer {
  Vector<double> point;
  Vector<double> normal;
};

/// Points in front of the triangle, at a distance from its centre, which they face.
std::vector<Observer> observers(double distance) {
  constexpr std::size_t count = 256;
  std::mt19937_64 stream(1);
  const auto number = [&stream] { return static_cast<double>(stream() >> 11U) * 0x1p-53; };
  std::vector<Observer> all(count);
  for (Observer& one : all) {
    const double x = distance * (number() - 0.5);
    const double y = distance * (number() - 0.5);
    one = {{0.4 + x, 0.35 + y, distance}, {-0.1 * x, -0.1 * y, -1}};
  }
  return all;
}

/// Distance in hundredths of the triangle's longest edge; `balls`: the part of the points that needed them.
void plane_element(benchmark::State& state) {
  const PlaneElement element(triangle(), monomials(static_cast<int>(state.range(0))));
  const std::vector<Observer> all = observers(static_cast<double>(state.range(1)) / 100);
  std::vector<double> values(element.function_count());
  std::size_t balls = 0;
  std::size_t rules = 0;
  for (const Observer& one : all) {
    const PlaneElement::Route route = element.integrals(one.point, one.normal, values);
    balls += route == PlaneElement::Route::ball ? 1 : 0;
    rules += route == PlaneElement::Route::rule ? 1 : 0;
  }
  std::size_t k = 0;
  for (auto step : state) {
    benchmark::DoNotOptimize(element.integrals(all[k].point, all[k].normal, values));
    k = (k + 1) % all.size();
  }
  using benchmark::Counter;
  state.counters["entries"] = Counter(1, Counter::kIsIterationInvariantRate);
  state.counters["balls"] = static_cast<double>(balls) / static_cast<double>(all.size());
  state.counters["rules"] = static_cast<double>(rules) / static_cast<double>(all.size());
}
BENCHMARK(plane_element)
    ->ArgNames({"degree", "distance"})
    ->ArgsProduct({{0, 1, 2}, {3, 10, 30, 100, 300, 1000, 100000}});

void point_to_polygon_ball(benchmark::State& state) {
  const PlanePolygon polygon = triangle();
  const auto degree = static_cast<int>(state.range(0));
  PlanePolynomial<Rational> q(degree);
  q(degree, 0) = 1;
  const Exact p{Rational(1, 3), Rational(1, 5), Rational(1, 2)};
  const BallPrecision precision(state.range(1));
  for (auto step : state) benchmark::DoNotOptimize(point_to_polygon(p, {1, 2, -3}, polygon, q));
}
BENCHMARK(point_to_polygon_ball)->ArgNames({"degree", "bits"})->ArgsProduct({{0, 1, 2, 8}, {64, 128}});

void dilogarithm(benchmark::State& state) {
  std::mt19937_64 stream(1);
  std::vector<double> numbers(1024);
  for (double& x : numbers) x = static_cast<double>(stream() >> 11U) * 0x1p-53;
  std::size_t k = 0;
  for (auto step : state) {
    benchmark::DoNotOptimize(dilogarithm_imaginary(numbers[k], 3 * numbers[k + 1]));
    k = (k + 2) % numbers.size();
  }
}
BENCHMARK(dilogarithm);

}  // namespace
}  // namespace radcert::bench
