// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/galerkin/galerkin_matrix.h"

#include <utility>

#include "radcert/core/parallel.h"
#include "radcert/scalar/real.h"

namespace radcert {

GalerkinMatrix galerkin_matrix(const PairIntegrals& pairs, std::size_t functions,
                               const std::vector<bool>& serves) {
  const std::size_t elements = serves.size();
  const std::size_t p = functions;
  GalerkinMatrix matrix{Matrix<double>(elements * p, elements * p), {}};
  constexpr std::size_t most_chunks = 64;  // each holds its own sums over the rows
  const std::size_t grain = elements / most_chunks + 1;
  const auto assemble_chunk = [&](std::size_t begin, std::size_t end) {
    std::vector<double> radii(elements * p);
    for (std::size_t k = begin; k < end; ++k)
      for (std::size_t n = 0; n <= elements / 2; ++n) {
        // Every pair once, and as many for each k.
        const std::size_t l = (k + n) % elements;
        if (2 * n == elements && l < k) continue;
        if (!(serves[k] || serves[l]) || pairs.vanishes(k, l)) continue;
        const PairBlock block = pairs.block(k, l);
        for (std::size_t a = 0; a < p; ++a)
          for (std::size_t b = 0; b < p; ++b) {
            const std::size_t i = k * p + a;
            const std::size_t j = l * p + b;
            matrix.entries(i, j) = block.value(a, b);
            radii[i] += block.radius(a, b);
            if (k == l) continue;
            matrix.entries(j, i) = block.value(a, b);
            radii[j] += block.radius(a, b);
          }
      }
    return radii;
  };
  const auto add_radii = [](std::vector<double> sum, const std::vector<double>& radii) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += radii[i];
    return sum;
  };
  matrix.row_radius =
      parallel_reduce_ordered(elements, grain, std::vector<double>(elements * p), assemble_chunk, add_radii);
  return matrix;
}

double definiteness_as_stored(double absorptivity, double radius, double defect) {
  constexpr double unit = unit_roundoff<double>();
  const double bound = absorptivity - (1 - absorptivity) * defect - radius;
  return bound - 4 * unit * (absorptivity + defect + radius);
}

}  // namespace radcert
