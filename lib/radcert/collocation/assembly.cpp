// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/assembly.h"

#include <algorithm>

#include "radcert/collocation/element_sweep.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"

namespace radcert {
namespace {

/// At most so many chunks of elements: each holds its own sums over the rows.
constexpr std::size_t most_chunks = 64;

/// What one chunk of elements adds to every row.
template <Real R>
struct RowSums {
  std::vector<R> kernel_integral;
  std::vector<R> radius;
};

/// Writes the entries of a full block of rows and element k, and adds to the rows' sums.
template <Real R>
void put_block(std::size_t first, std::size_t k, const BlockIntegral<R>& integral, std::size_t functions,
               const std::vector<R>& factors, Matrix<R>& entries, RowSums<R>& rows) {
  using B = typename Block<R>::Type;
  const B factor = Block<R>::load(&factors[first]);
  B radius = B(R(0));
  for (std::size_t j = 0; j < functions; ++j) {
    Block<R>::store(factor * integral.value[j], &entries(first, k * functions + j));
    radius = radius + integral.radius[j];
  }
  const auto add = [first](const B& term, std::vector<R>& sums) {
    Block<R>::store(Block<R>::load(&sums[first]) + term, &sums[first]);
  };
  add(integral.absolute, rows.kernel_integral);
  add(factor * radius, rows.radius);
}

/// The same, lane by lane, for a block that is not full.
template <Real R>
void put_lanes(const CollocationPointBlock<R>& block, std::size_t k, const BlockIntegral<R>& integral,
               std::size_t functions, const std::vector<R>& factors, Matrix<R>& entries, RowSums<R>& rows) {
  for (std::size_t lane = 0; lane < block.count; ++lane) {
    const std::size_t i = block.first + lane;
    R radius = R(0);
    for (std::size_t j = 0; j < functions; ++j) {
      entries(i, k * functions + j) = factors[i] * Block<R>::lane(integral.value[j], lane);
      radius += Block<R>::lane(integral.radius[j], lane);
    }
    rows.kernel_integral[i] += Block<R>::lane(integral.absolute, lane);
    rows.radius[i] += factors[i] * radius;
  }
}

}  // namespace

template <Real R>
CollocationMatrix<R> assemble(const Surface& surface, const Triangulation& triangulation,
                              const TriangleBasis<R>& basis, std::span<const CollocationPoint<R>> nodes,
                              std::span<const R> reflectivity, const Tolerance& tolerance) {
  const std::size_t elements = triangulation.triangles.size();
  const std::size_t functions = basis.size();
  const std::size_t unknowns = elements * functions;
  expects(nodes.size() == unknowns, "one node a basis function and element", named("nodes", nodes.size()));
  expects(reflectivity.size() == unknowns, "one reflectivity a node", named("values", reflectivity.size()));

  CollocationMatrix<R> matrix{Matrix<R>::uninitialised(unknowns, unknowns), {}, {}};
  const std::size_t grain = (elements + most_chunks - 1) / most_chunks;
  std::vector<R> factors;
  for (const R& rho : reflectivity) factors.push_back(rho / pi<R>());
  const ElementSweep<R> sweep(surface, triangulation, basis, nodes, tolerance);
  const auto integrate_chunk = [&](std::size_t begin, std::size_t end) {
    RowSums<R> rows{std::vector<R>(unknowns), std::vector<R>(unknowns)};
    sweep.over(begin, end, [&](const auto& block, std::size_t k, const auto& integral) {
      if (block.count == Block<R>::lanes)
        put_block(block.first, k, integral, functions, factors, matrix.entries, rows);
      else
        put_lanes(block, k, integral, functions, factors, matrix.entries, rows);
    });
    return rows;
  };
  const auto add_rows = [](RowSums<R> sum, const RowSums<R>& rows) {
    for (std::size_t i = 0; i < sum.radius.size(); ++i) {
      sum.kernel_integral[i] += rows.kernel_integral[i];
      sum.radius[i] += rows.radius[i];
    }
    return sum;
  };
  RowSums<R> sums =
      parallel_reduce_ordered(elements, grain, RowSums<R>{std::vector<R>(unknowns), std::vector<R>(unknowns)},
                              integrate_chunk, add_rows);
  matrix.kernel_integral = std::move(sums.kernel_integral);
  matrix.row_radius = std::move(sums.radius);
  return matrix;
}

template CollocationMatrix<double> assemble<double>(const Surface&, const Triangulation&,
                                                    const TriangleBasis<double>&,
                                                    std::span<const CollocationPoint<double>>,
                                                    std::span<const double>, const Tolerance&);
template CollocationMatrix<Mpfr<50>> assemble<Mpfr<50>>(const Surface&, const Triangulation&,
                                                        const TriangleBasis<Mpfr<50>>&,
                                                        std::span<const CollocationPoint<Mpfr<50>>>,
                                                        std::span<const Mpfr<50>>, const Tolerance&);

}  // namespace radcert
