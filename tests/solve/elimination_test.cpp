// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/elimination.h"

#include <gtest/gtest.h>

#include <random>

#include "radcert/core/contract.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/solve/direct.h"

namespace radcert {
namespace {

/// A K whose I - K needs its pivots looked for: zeros on the diagonal.
template <class R>
Matrix<R> with_zero_pivots() {
  Matrix<R> k(3, 3);
  for (std::size_t i = 0; i < 3; ++i) k(i, i) = R(1);
  k(0, 1) = k(1, 2) = k(2, 0) = R(-2);
  return k;
}

TEST(Elimination, LooksForItsPivots) {
  // I - K = 2 times a permutation: u_1 = e_0/2, u_2 = e_1/2, u_0 = e_2/2.
  const std::vector<double> u = solve_by_elimination<double>(with_zero_pivots<double>(), {2, 4, 6});
  EXPECT_EQ(u, (std::vector<double>{3, 1, 2}));
}

TEST(Elimination, LeavesAResidualOfFiftyDigits) {
  std::mt19937_64 stream(3);
  constexpr std::size_t n = 20;
  Matrix<Mpfr<50>> k(n, n);
  Matrix<double> k_in_double(n, n);
  std::vector<Mpfr<50>> e;
  std::vector<double> e_in_double;
  const auto number = [&stream] { return static_cast<double>(stream() >> 11U) * 0x1p-53; };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      k_in_double(i, j) = number() / n;
      k(i, j) = Mpfr<50>(k_in_double(i, j));
    }
    e_in_double.push_back(number());
    e.emplace_back(e_in_double.back());
  }
  const std::vector<Mpfr<50>> u = solve_by_elimination(k, e);
  const std::vector<double> v = DirectSolver(k_in_double).solve(e_in_double);
  for (std::size_t i = 0; i < n; ++i) {
    Mpfr<50> residual = e[i] - u[i];
    for (std::size_t j = 0; j < n; ++j) residual += k(i, j) * u[j];
    EXPECT_LT(std::abs(residual.to_double()), 1e-47);
    EXPECT_NEAR(u[i].to_double(), v[i], 1e-13);
  }
}

TEST(Elimination, RefusesASingularMatrixAndOtherSizes) {
  Matrix<double> k(2, 2);
  k(0, 0) = k(1, 1) = 1;
  EXPECT_THROW((void)solve_by_elimination<double>(k, {1, 1}), ContractViolation);
  EXPECT_THROW((void)solve_by_elimination<double>(k, {1}), ContractViolation);
}

}  // namespace
}  // namespace radcert
