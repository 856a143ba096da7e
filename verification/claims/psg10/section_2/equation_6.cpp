// SPDX-License-Identifier: GPL-3.0-or-later

// Neumann's formula, the iteration, and the paths of light.
//
// Checked      For every linear operator R and every k, by induction on k in the free algebra: (I - R)(I + R
//              + ... + R^k) = I - R^(k+1), from both sides, and k + 1 steps lambda <- epsilon + R lambda
//              from 0 give (I + R + ... + R^k) epsilon, (19). "favourable circumstances": ||R|| <= q < 1 in
//              some norm. Then ||R^(k+1)|| <= q^(k+1), which tends to 0, and what the sum leaves is at most
//              q^(k+1)/(1 - q) = 1/(1 - q) - (1 + ... + q^k), the same identity at q. Rejected: a sum that
//              leaves a power out; any sum and power; lambda <- R (epsilon + lambda). That an albedo of 9/10
//              is such a circumstance is seen on 8 matrices with row sums 9/10: rows of R^21 sum to at most
//              (9/10)^21; rejected: row sums 11/10. "R^k accounts for light that met the scene k times":
//              each entry of R^k, of order 2 and 3 with symbols for the entries, k = 1, ..., 4, is the sum
//              over all paths of k steps of the products of their entries; a path of k + 1 steps is one of k
//              and a last one, R^(k+1) = R^k R. Rejected: paths of k - 1 steps.
// Not checked  that the transfer matrix of a scene has a norm below 1: point lights in corners may give
//              larger row sums.

#include <array>
#include <string>
#include <vector>

#include "verification/claims/operator_identities.h"
#include "verification/claims/psg10/exact_sites.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr std::size_t order = 5;
constexpr int matrices = 8;
constexpr int steps = 20;

template <class R, std::size_t n>
using Square = std::array<std::array<R, n>, n>;

template <class R, std::size_t n>
Square<R, n> product(const Square<R, n>& a, const Square<R, n>& b) {
  Square<R, n> c;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      c[i][j] = R(0);
      for (std::size_t k = 0; k < n; ++k) c[i][j] = c[i][j] + a[i][k] * b[k][j];
    }
  return c;
}

/// Entries that are not negative, some of them 0, and row sums `sum`.
Square<Rational, order> random_matrix(ExactSites& random, const Rational& sum) {
  Square<Rational, order> r;
  for (std::size_t i = 0; i < order; ++i) {
    Rational total(0);
    for (Rational& entry : r[i]) {
      entry = Rational(random.below(4));
      total += entry;
    }
    r[i][i] += 1;
    total += 1;
    for (Rational& entry : r[i]) entry = entry * sum / total;
  }
  return r;
}

/// Rows of R^(steps + 1) whose sum exceeds (9/10)^(steps + 1).
Rational not_falling(const Rational& row_sum) {
  ExactSites random(7);
  long total = 0;
  const Rational bound = power(Rational(9, 10), steps + 1);
  for (int m = 0; m < matrices; ++m) {
    const Square<Rational, order> r = random_matrix(random, row_sum);
    Square<Rational, order> next = r;
    for (int k = 0; k < steps; ++k) next = product(next, r);
    for (const auto& row : next) {
      Rational sum(0);
      for (const Rational& entry : row) sum += entry;
      if (sum > bound) ++total;
    }
  }
  return total;
}

/// The sum over all paths of so many steps from j to i of the products of their entries.
template <std::size_t n>
RationalFunction over_paths(const Square<RationalFunction, n>& r, std::size_t to, std::size_t from,
                            int length) {
  if (length == 0) return to == from ? 1 : 0;
  RationalFunction sum(0);
  for (std::size_t last = 0; last < n; ++last) sum += r[to][last] * over_paths(r, last, from, length - 1);
  return sum;
}

/// Terms in which the entries of R^k differ from the sums over paths of k steps, or of fewer.
template <std::size_t n>
Rational not_over_paths(int fewer) {
  Square<RationalFunction, n> r;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      r[i][j] = RationalFunction::variable("r" + std::to_string(i) + std::to_string(j));
  Square<RationalFunction, n> powered = r;
  Rational total(0);
  for (int k = 1; k <= 4; ++k) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        total += differing_terms(powered[i][j], over_paths(r, i, j, k - fewer));
    powered = product(powered, r);
  }
  return total;
}

}  // namespace

Finding equation_6(const Bench&) {
  Finding finding;
  require_neumann_series(finding);
  finding.require("rows of R^21 with a sum above (9/10)^21, row sums of R 9/10", IsExactly{0},
                  not_falling(Rational(9, 10)));
  finding.control("the same, row sums of R 11/10", IsExactly{0}, not_falling(Rational(11, 10)));
  return finding;
}

Finding equation_19(const Bench&) {
  Finding finding;
  require_neumann_series(finding);
  require_steps_of_neumann_series(finding);
  return finding;
}

Finding section_2_paths(const Bench&) {
  Finding finding;
  finding.require("terms in which R^k differs from the sum over paths of k steps, order 2", IsExactly{0},
                  not_over_paths<2>(0));
  finding.require("terms in which R^k differs from the sum over paths of k steps, order 3", IsExactly{0},
                  not_over_paths<3>(0));
  finding.control("the same for paths of k - 1 steps, order 2", IsExactly{0}, not_over_paths<2>(1));
  return finding;
}

}  // namespace radcert::verification::psg10
