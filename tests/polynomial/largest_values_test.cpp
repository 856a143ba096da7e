// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/largest_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "radcert/polynomial/inset_basis.h"
#include "radcert/scalar/mpfr_real.h"

namespace radcert {
namespace {

/// max |l_j| over a fine lattice.
std::vector<double> sampled(const TriangleBasis<double>& basis, int steps) {
  std::vector<double> largest(basis.size());
  std::vector<double> values(basis.size());
  for (int i = 0; i <= steps; ++i)
    for (int k = 0; i + k <= steps; ++k) {
      basis.values({{i / double(steps), k / double(steps), (steps - i - k) / double(steps)}}, values);
      for (std::size_t j = 0; j < values.size(); ++j) largest[j] = std::max(largest[j], std::abs(values[j]));
    }
  return largest;
}

TEST(LargestValues, BoundTheFunctionsAndAreClose) {
  for (int degree = 0; degree <= 10; ++degree)
    for (const double inset : {0.0, 1.0 / 6, 0.01, 0.3}) {
      const TriangleBasis<double> basis(InsetBasis<double>(degree, inset));
      const std::vector<double> bound = largest_values(basis);
      // A prime number of steps: no point of the lattice that the bound is made of.
      const std::vector<double> seen = sampled(basis, 211);
      ASSERT_EQ(bound.size(), seen.size());
      for (std::size_t j = 0; j < bound.size(); ++j) {
        EXPECT_GE(bound[j], seen[j]) << "degree " << degree << ", inset " << inset << ", function " << j;
        EXPECT_LE(bound[j], (1.0001 + 0.3 * degree * degree / 64) * seen[j])
            << "degree " << degree << ", inset " << inset << ", function " << j;
      }
    }
}

TEST(LargestValues, AreTheCornersOfLinearFunctions) {
  // l_1 of (33) in ac98 is (x_1 - a)/(1 - 3a), largest at its own corner.
  const TriangleBasis<double> basis(InsetBasis<double>(1, 1.0 / 6));
  for (const double bound : largest_values(basis)) EXPECT_NEAR(bound, (1 - 1.0 / 6) / 0.5, 1e-5);
}

TEST(LargestValues, AreTheSameInManyDigits) {
  const std::vector<double> in_doubles = largest_values(TriangleBasis<double>(InsetBasis<double>(5, 0.1)));
  const std::vector<Mpfr<50>> in_digits =
      largest_values(TriangleBasis<Mpfr<50>>(InsetBasis<Mpfr<50>>(5, Mpfr<50>(0.1))));
  for (std::size_t j = 0; j < in_doubles.size(); ++j)
    EXPECT_NEAR(in_doubles[j], in_digits[j].to_double(), 1e-9 * in_doubles[j]);
}

}  // namespace
}  // namespace radcert
