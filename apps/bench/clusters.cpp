// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix as couplings of clusters and near entries, and with all its entries: making it, and products
// with it; degree 1, inset 1/6. The argument `digits` is the tolerance of couplings, 10^-digits.
#include <benchmark/benchmark.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "radcert/clusters/cluster_operator.h"
#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/solve/system_matrix.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"

namespace radcert::bench {
namespace {

/// A level of a surface, with the reflectivity 1/2.
struct Level {
  Level(const Surface& of, int number)
      : surface(of),
        triangulation(triangulate(surface, number)),
        nodes(collocation_nodes<double>(surface, triangulation, basis)) {}
  const Surface& surface;
  Triangulation triangulation;
  TriangleBasis<double> basis = InsetBasis<double>(1, 1.0 / 6);
  std::vector<CollocationPoint<double>> nodes;
  std::vector<double> rho = std::vector<double>(nodes.size(), 0.5);
};

void make_and_multiply(benchmark::State& state, const Surface& surface) {
  const int number = static_cast<int>(state.range(0));
  const Level level(surface, number);
  const double tolerance = std::pow(10.0, -static_cast<double>(state.range(1)));
  const ClusterTree tree =
      ClusterTree::make(level.triangulation, number, leaf_refinements(level.basis.size())).value();
  const ClusterPart part(tree);
  std::optional<ClusterOperator> k;
  const auto make = [&] {
    k.emplace(ClusterOperator::Setting{.surface = surface,
                                       .tree = tree,
                                       .part = part,
                                       .basis = level.basis,
                                       .nodes = level.nodes,
                                       .reflectivity = level.rho,
                                       .far = ClusterTolerance(tolerance)});
  };
  // Either is measured: making it where the third argument is 0, a product where it is 1.
  const bool product = state.range(2) != 0;
  std::vector<double> x(level.nodes.size(), 1.0);
  std::vector<double> y(level.nodes.size());
  if (product) make();
  for (auto step : state) {
    if (product)
      k->multiply(x, y);
    else
      make();
  }
  const auto n = static_cast<double>(level.nodes.size());
  state.counters["unknowns"] = n;
  state.counters["bytes_an_unknown"] = static_cast<double>(k->memory().total()) / n;
  state.counters["near_entries_an_unknown"] = static_cast<double>(k->near_entries().size()) / n;
  state.counters["evaluations_an_unknown"] = static_cast<double>(k->couplings().evaluations()) / n;
}

void assemble_and_multiply(benchmark::State& state, const Surface& surface) {
  const Level level(surface, static_cast<int>(state.range(0)));
  CollocationMatrix<double> k;
  const auto make = [&] {
    k = {};
    k = assemble<double>(surface, level.triangulation, level.basis, level.nodes, level.rho, Tolerance(1e-13));
  };
  const bool is_product = state.range(1) != 0;
  std::vector<double> x(level.nodes.size(), 1.0);
  std::vector<double> y(level.nodes.size());
  if (is_product) make();
  for (auto step : state) {
    if (is_product)
      SystemMatrix(k.entries).multiply(x, y);
    else
      make();
  }
  state.counters["unknowns"] = static_cast<double>(level.nodes.size());
  state.counters["bytes_an_unknown"] = static_cast<double>(sizeof(double) * level.nodes.size());
}

void of(const std::string& name, const Surface& surface, const std::vector<std::int64_t>& levels) {
  benchmark::internal::Benchmark* const one =
      benchmark::RegisterBenchmark(("clusters/" + name).c_str(),
                                   [surface](benchmark::State& state) { make_and_multiply(state, surface); });
  one->ArgNames({"level", "digits", "product"})->UseRealTime()->Unit(benchmark::kSecond);
  for (const std::int64_t level : levels)
    for (const std::int64_t digits : {6, 12})
      for (const std::int64_t product : {0, 1}) one->Args({level, digits, product});
  benchmark::RegisterBenchmark(("dense/" + name).c_str(),
                               [surface](benchmark::State& state) { assemble_and_multiply(state, surface); })
      ->ArgNames({"level", "product"})
      ->UseRealTime()
      ->Unit(benchmark::kSecond)
      ->ArgsProduct({{levels.front(), levels.front() + 1}, {0, 1}});
}

const bool registered = [] {
  of("ellipsoid 1 3/2 2", ellipsoid(1, Rational(3, 2), 2), {4, 5, 6});
  of("cube", cube(), {4, 5, 6});
  return true;
}();

}  // namespace
}  // namespace radcert::bench
