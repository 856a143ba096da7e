// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/certified_entries.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "radcert/closed_form/plane_element.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"

namespace radcert {

void expects_collocation_data(const LagrangeFunctions& functions, std::size_t nodes,
                              std::span<const double> reflectivity) {
  expects(functions.degree() <= PlaneElement::largest_degree, "functions of degree at most 8",
          named("degree", functions.degree()));
  expects(reflectivity.size() == nodes && std::all_of(reflectivity.begin(), reflectivity.end(),
                                                      [](double rho) { return std::isfinite(rho); }),
          "a finite reflectivity for every node", named("nodes", nodes), named("size", reflectivity.size()));
}

Outcome<CertifiedEntries> certified_entries(std::span<const ExactTriangle> elements,
                                            const LagrangeFunctions& functions,
                                            std::span<const double> reflectivity) {
  const std::size_t p = functions.size();
  const std::size_t n = elements.size() * p;
  expects_collocation_data(functions, n, reflectivity);
  const Outcome<IntegralErrors> errors = IntegralErrors::of(functions);
  if (!errors) return because(errors.reason());
  const Outcome<ExactNodes> exact = exact_nodes(elements, functions);
  if (!exact) return because(exact.reason());
  const std::vector<ExactNode>& nodes = exact->nodes;
  const std::vector<PlanePolynomial<Rational>> polynomials = by_monomials(functions);

  CertifiedEntries result{.entries = Matrix<double>::uninitialised(n, n),
                          .radius = Matrix<double>::uninitialised(n, n)};
  parallel_for(elements.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<double> values(p);
    for (std::size_t k = begin; k < end; ++k) {
      const PlaneElement element = plane_element(elements[k], exact->scale, polynomials);
      for (std::size_t i = 0; i < n; ++i) {
        element.integrals(nodes[i].point, nodes[i].normal, values);
        const double error = errors->bound(values);
        for (std::size_t j = 0; j < p; ++j) {
          const Approximation entry = certified_entry(reflectivity[i], values[j], error);
          result.entries(i, k * p + j) = entry.value;
          result.radius(i, k * p + j) = entry.radius;
        }
      }
    }
  });
  return result;
}

}  // namespace radcert
