// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel against the machine's own multiply-add peak, measured in the same run.
#include <benchmark/benchmark.h>

#include <random>

#include "radcert/quadrature/far_field.h"

namespace radcert::bench {
namespace {

/// Multiplications and additions a second that packs reach when nothing but fma is asked of them.
void multiply_add_peak(benchmark::State& state) {
  constexpr int steps = 1000;
  const Pack factor(0.999);
  const Pack term(1e-3);
  // Five chains: enough to hide the latency, few enough to stay in registers.
  Pack a(1);
  Pack b(2);
  Pack c(3);
  Pack d(4);
  Pack e(5);
  for (auto step : state) {
    for (int k = 0; k < steps; ++k) {
      a = fma(a, factor, term);
      b = fma(b, factor, term);
      c = fma(c, factor, term);
      d = fma(d, factor, term);
      e = fma(e, factor, term);
    }
    benchmark::ClobberMemory();
  }
  benchmark::DoNotOptimize((a + b + c + d + e).sum());
  const double operations = 2.0 * 5 * Pack::lanes * steps;
  state.counters["flops"] = benchmark::Counter(operations, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(multiply_add_peak);

CollocationPointBlock<double> some_observers(std::mt19937_64& stream) {
  const auto number = [&stream] { return static_cast<double>(stream() >> 11U) * 0x1p-53; };
  CollocationPointBlock<double> block;
  block.count = Pack::lanes;
  for (std::size_t i = 0; i < Pack::lanes; ++i) {
    block.point.x.set_lane(i, 3 + number());
    block.point.y.set_lane(i, number());
    block.point.z.set_lane(i, number());
    block.normal.x.set_lane(i, -1 + 0.1 * number());
    block.normal.y.set_lane(i, number());
    block.normal.z.set_lane(i, number());
  }
  return block;
}

Samples<double> some_samples(std::mt19937_64& stream, std::size_t count, std::size_t functions) {
  Samples<double> samples;
  samples.count = count;
  samples.functions = functions;
  for (std::vector<double>* array : {&samples.x, &samples.y, &samples.z, &samples.normal_x, &samples.normal_y,
                                     &samples.normal_z, &samples.basis}) {
    array->resize(padded<double>(count) * (array == &samples.basis ? functions : 1));
    for (double& value : *array) value = static_cast<double>(stream() >> 11U) * 0x1p-53;
  }
  return samples;
}

/// Evaluations of G a second in the loop of the far field, with their products with the basis.
void kernel(benchmark::State& state) {
  const auto functions = static_cast<std::size_t>(state.range(0));
  constexpr std::size_t points = 49;
  std::mt19937_64 stream(1);
  const CollocationPointBlock<double> observers = some_observers(stream);
  const Samples<double> samples = some_samples(stream, points, functions);
  std::vector<Pack> g;
  FarSums<double> sums;
  for (auto step : state) {
    far_sums(observers, samples, g, sums);
    benchmark::DoNotOptimize(sums);
  }
  const double evaluations = static_cast<double>(points) * Pack::lanes;
  // Three differences, three scalar products of five, two products, a division, a magnitude and its sum.
  const double flops = 3 + 15 + 2 + 1 + 2 + 2.0 * static_cast<double>(functions);
  using benchmark::Counter;
  state.counters["evaluations"] = Counter(evaluations, Counter::kIsIterationInvariantRate);
  state.counters["flops"] = Counter(flops * evaluations, Counter::kIsIterationInvariantRate);
}
BENCHMARK(kernel)->ArgName("functions")->Arg(1)->Arg(3)->Arg(6)->Arg(10)->Arg(45);

}  // namespace
}  // namespace radcert::bench
