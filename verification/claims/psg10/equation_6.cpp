// SPDX-License-Identifier: GPL-3.0-or-later

// Neumann's formula and the iteration, exactly: matrices of order 5 with rational entries that are not
// negative.
//
// Checked      "favourable circumstances": row sums of at most beta = 9/10, as every transfer matrix of a
//              scene of albedo beta has them. Then (I - R)(I + R + ... + R^k) = I - R^(k+1), entry by entry,
//              and the row sums of R^(k+1) are at most beta^(k+1), k = 20: the formula converges, to the
//              inverse. Rejected: the series without R^3, and row sums of 11/10, whose powers grow. (19): k + 1 steps lambda <- epsilon +
//              R lambda from 0 give the sum of the first k + 1 terms applied to epsilon, exactly; rejected
//              for the transposed matrix. R^k alone as light scattered k times: the same sums.
// Not checked  operators; point lights in corners, which may give a matrix with larger row sums.

#include <array>

#include "verification/claims/psg10/exact_sites.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr std::size_t order = 5;
constexpr int terms = 20;
constexpr int matrices = 8;

using Row = std::array<Rational, order>;
using Square = std::array<Row, order>;

/// Entries that are not negative, some of them 0, and row sums `sum`.
Square random_matrix(ExactSites& random, const Rational& sum) {
  Square r;
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

Square identity() {
  Square one;
  for (std::size_t i = 0; i < order; ++i) one[i][i] = 1;
  return one;
}

Square product(const Square& a, const Square& b) {
  Square c;
  for (std::size_t i = 0; i < order; ++i)
    for (std::size_t j = 0; j < order; ++j)
      for (std::size_t k = 0; k < order; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

Row applied(const Square& a, const Row& x) {
  Row y;
  for (std::size_t i = 0; i < order; ++i)
    for (std::size_t k = 0; k < order; ++k) y[i] += a[i][k] * x[k];
  return y;
}

struct Powers {
  Square sum;   ///< I + R + ... + R^terms
  Square next;  ///< R^(terms + 1)
};

Square transposed(const Square& a) {
  Square b;
  for (std::size_t i = 0; i < order; ++i)
    for (std::size_t j = 0; j < order; ++j) b[i][j] = a[j][i];
  return b;
}

/// R^left_out is not added; 0: none is left out.
Powers powers(const Square& r, int left_out = 0) {
  Powers result{.sum = identity(), .next = r};
  for (int k = 1; k <= terms; ++k) {
    if (k != left_out)
      for (std::size_t i = 0; i < order; ++i)
        for (std::size_t j = 0; j < order; ++j) result.sum[i][j] += result.next[i][j];
    result.next = product(result.next, r);
  }
  return result;
}

/// Entries in which (I - R)(I + ... + R^k) is not I - R^(k+1), one power left out or none.
Rational not_telescoping(int left_out) {
  ExactSites random(6);
  long total = 0;
  for (int m = 0; m < matrices; ++m) {
    const Square r = random_matrix(random, Rational(9, 10));
    const Powers found = powers(r, left_out);
    const Square shifted = product(r, found.sum);
    const Square one = identity();
    for (std::size_t i = 0; i < order; ++i)
      for (std::size_t j = 0; j < order; ++j)
        if (found.sum[i][j] - shifted[i][j] != one[i][j] - found.next[i][j]) ++total;
  }
  return total;
}

/// Rows of R^(k+1) whose sum exceeds (9/10)^(k+1).
Rational not_falling(const Rational& row_sum) {
  ExactSites random(7);
  long total = 0;
  const Rational bound = power(Rational(9, 10), terms + 1);
  for (int m = 0; m < matrices; ++m)
    for (const Row& row : powers(random_matrix(random, row_sum)).next) {
      Rational sum(0);
      for (const Rational& entry : row) sum += entry;
      if (sum > bound) ++total;
    }
  return total;
}

/// Values in which terms + 1 steps of the iteration differ from the sum of the first terms + 1 terms.
Rational not_the_sum(bool with_transposed) {
  ExactSites random(8);
  long total = 0;
  for (int m = 0; m < matrices; ++m) {
    const Square r = random_matrix(random, Rational(9, 10));
    Row emission;
    for (Rational& value : emission) value = random.eighths(1);
    Row lambda;
    const Square iterated = with_transposed ? transposed(r) : r;
    for (int k = 0; k <= terms; ++k) {
      Row next = applied(iterated, lambda);
      for (std::size_t i = 0; i < order; ++i) next[i] += emission[i];
      lambda = next;
    }
    const Row sum = applied(powers(r).sum, emission);
    for (std::size_t i = 0; i < order; ++i)
      if (lambda[i] != sum[i]) ++total;
  }
  return total;
}

}  // namespace

Finding equation_6(const Bench&) {
  Finding finding;
  finding.require("entries in which (I - R)(I + ... + R^20) is not I - R^21", IsExactly{0},
                  not_telescoping(0));
  finding.control("the same, R^3 left out of the sum", IsExactly{0}, not_telescoping(3));
  finding.require("rows of R^21 with a sum above (9/10)^21, row sums of R 9/10", IsExactly{0},
                  not_falling(Rational(9, 10)));
  finding.control("the same, row sums of R 11/10", IsExactly{0}, not_falling(Rational(11, 10)));
  return finding;
}

Finding equation_19(const Bench&) {
  Finding finding;
  finding.require("values in which 21 iterations differ from the first 21 terms of (6)", IsExactly{0},
                  not_the_sum(false));
  finding.control("the same for 21 iterations with the transposed matrix", IsExactly{0}, not_the_sum(true));
  return finding;
}

}  // namespace radcert::verification::psg10
