// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "radcert/galerkin/pair_integrals.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/solve/conjugate_gradients.h"
#include "radcert/surface/catalogue/box.h"
#include "tests/limits/limits.h"

namespace radcert::limits {
namespace {

/// The first entries of the blocks of degree 1 on a thin box, whose faces nearly touch; constants are in
/// closed form there.
Case pairs(const std::string& limit, double accuracy) {
  return {.limit = limit, .answer = [accuracy] {
            const Surface surface = box(1, 1, Rational(1, 3));
            const Triangulation triangulation = triangulate(surface, 0);
            const LocalFunctions functions(surface, triangulation, InsetBasis<double>(1, 1.0 / 6),
                                           [](std::size_t, const Vector<double>&) { return 1.0; });
            const PairIntegrals integrals(surface, triangulation, functions, accuracy);
            std::vector<Ball> all;
            for (std::size_t k = 0; k < functions.elements(); k += 3)
              for (std::size_t l = 0; l < functions.elements(); l += 2) {
                const PairBlock block = integrals.block(k, l);
                all.push_back(number(block.value(0, 0), block.radius(0, 0)));
              }
            return numbers(all);
          }};
}

Case directions() {
  return {.limit = "solve/conjugate_gradients: directions", .answer = [] {
            constexpr std::size_t n = 12;
            Matrix<double> k(n, n);
            for (std::size_t i = 0; i < n; ++i)
              for (std::size_t j = 0; j < n; ++j)
                k(i, j) = 0.05 * std::cos(static_cast<double>(i * j + i + j));
            const auto found =
                solve_by_conjugate_gradients(k, std::vector<double>(n, 1.0), 0.4, std::nullopt);
            if (!found) return refusal(found.reason());
            std::vector<Ball> all;
            for (const double value : found->values) all.push_back(number(value, found->error_bound));
            return numbers(all, std::to_string(found->iterations));
          }};
}

}  // namespace

std::vector<Case> galerkin_cases() {
  return {pairs("galerkin/pair_integrals: cuts of two near elements", 1e-6),
          pairs("galerkin/pair_integrals: rules that are tried after the first", 1e-8), directions()};
}

}  // namespace radcert::limits
