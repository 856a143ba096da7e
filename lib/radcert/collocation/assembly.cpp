// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/assembly.h"

#include <algorithm>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/quadrature/element_integrator.h"

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

}  // namespace

template <Real R>
CollocationMatrix<R> assemble(const Surface& surface, const Triangulation& triangulation,
                              const InsetBasis<R>& basis, std::span<const Observer<R>> nodes,
                              std::span<const R> reflectivity) {
  const std::size_t elements = triangulation.triangles.size();
  const std::size_t functions = basis.size();
  const std::size_t unknowns = elements * functions;
  expects(nodes.size() == unknowns, "one node a basis function and element", named("nodes", nodes.size()));
  expects(reflectivity.size() == unknowns, "one reflectivity a node", named("values", reflectivity.size()));

  CollocationMatrix<R> matrix{Matrix<R>(unknowns, unknowns), {}, {}};
  const std::size_t grain = (elements + most_chunks - 1) / most_chunks;
  const auto integrate_chunk = [&](std::size_t begin, std::size_t end) {
    RowSums<R> rows{std::vector<R>(unknowns), std::vector<R>(unknowns)};
    for (std::size_t k = begin; k < end; ++k) {
      ElementIntegrator<R> element(surface, triangulation.triangles[k], basis);
      for (std::size_t i = 0; i < unknowns; ++i) {
        const ElementIntegral<R> integral = element.integrate(nodes[i]);
        const R factor = reflectivity[i] / pi<R>();
        rows.kernel_integral[i] += integral.absolute;
        for (std::size_t j = 0; j < functions; ++j) {
          matrix.entries(i, k * functions + j) = factor * integral.value[j];
          rows.radius[i] += factor * integral.radius[j];
        }
      }
    }
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
                                                    const InsetBasis<double>&,
                                                    std::span<const Observer<double>>,
                                                    std::span<const double>);

}  // namespace radcert
