// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/nodal_integral.h"

#include <algorithm>
#include <cmath>

#include "radcert/collocation/element_sweep.h"
#include "radcert/core/parallel.h"

namespace radcert {
namespace {

/// At most so many chunks of elements, each with a number a point: points beyond take another sweep.
constexpr std::size_t most_chunks = 64;
constexpr std::size_t points_of_a_sweep = 4096;

/// Adds what one element gives to the points of a block.
void add(const CollocationPointBlock<double>& block, const BlockIntegral<double>& integral,
         std::span<const double> values, std::vector<NodalIntegral>& sums) {
  for (std::size_t lane = 0; lane < block.count; ++lane) {
    NodalIntegral& sum = sums[block.first + lane];
    for (std::size_t j = 0; j < values.size(); ++j) {
      const double g = Block<double>::lane(integral.value[j], lane);
      const double radius = Block<double>::lane(integral.radius[j], lane);
      sum.value += g * values[j];
      sum.left_out += radius * std::abs(values[j]);
      sum.size += std::abs(g * values[j]);
      sum.weight += std::abs(g) + radius;
    }
  }
}

}  // namespace

std::vector<NodalIntegral> nodal_integrals(const Surface& surface, const Triangulation& triangulation,
                                           const TriangleBasis<double>& basis, std::span<const double> values,
                                           std::span<const CollocationPoint<double>> points,
                                           const Tolerance& tolerance) {
  const std::size_t elements = triangulation.triangles.size();
  const std::size_t functions = basis.size();
  expects(values.size() == elements * functions, "a value a basis function and element",
          named("values", values.size()));
  const std::size_t grain = (elements + most_chunks - 1) / most_chunks;
  std::vector<NodalIntegral> out;
  out.reserve(points.size());
  for (std::size_t first = 0; first < points.size(); first += points_of_a_sweep) {
    const auto now = points.subspan(first, std::min(points_of_a_sweep, points.size() - first));
    const ElementSweep<double> sweep(surface, triangulation, basis, now, tolerance);
    const std::vector<NodalIntegral> sums = parallel_reduce_ordered(
        elements, grain, std::vector<NodalIntegral>(now.size()),
        [&](std::size_t begin, std::size_t end) {
          std::vector<NodalIntegral> of_chunk(now.size());
          sweep.over(begin, end, [&](const auto& block, std::size_t k, const auto& integral) {
            add(block, integral, values.subspan(k * functions, functions), of_chunk);
          });
          return of_chunk;
        },
        [](std::vector<NodalIntegral> sum, const std::vector<NodalIntegral>& of_chunk) {
          for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i].value += of_chunk[i].value;
            sum[i].left_out += of_chunk[i].left_out;
            sum[i].size += of_chunk[i].size;
            sum[i].weight += of_chunk[i].weight;
          }
          return sum;
        });
    out.insert(out.end(), sums.begin(), sums.end());
  }
  return out;
}

}  // namespace radcert
