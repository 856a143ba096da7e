// SPDX-License-Identifier: GPL-3.0-or-later

// Theorem 7 asks for u in C^(r+2), Lemma 5, on which it rests, for C^(r+3). On the unit square, cut into
// cells with sides h = 2^-L, let u = sum_k 2^-kp k^-2 cos(2 pi 2^k x), k = 1, 2, ..., p = r + 2: its
// derivatives up to the order p converge uniformly. The terms with k < L leave nothing: over all cells the
// cosines at a node sum to zero. Those with k = L + i take the same values in every cell, and so E_L = Int (I
// - L) u = sum_i 2^-(L+i)p (L+i)^-2 m_i, m_i = -2 sum_j w_j cos(2 pi 2^i s_j). Where |m_0| exceeds the sum of
// 2^-ip |m_i|, i >= 1, |E_L| is at least some c h^p/L^2 for all L, c > 0, while (36) would have h^(r+3) L. As
// seen from a node of another piece G varies over the square; h^(r+3) is what that adds.
//
// Checked      r = 1 and 3 at alpha_0, in balls. |m_0| less the sum is positive: p = r + 2. E_L by the rule,
//              cell by cell, against the formula, L = 1 to 6, series cut after 24 terms; rejected with the
//              nodes of one cell moved. The order of E_L beside |log h|, from three levels from L = 12, 18,
//              24 on, against r + 3: violated by p = r + 2, met by p = r + 3; rejected: p = r + 1.
// Not checked  the error at a node itself, in balls: what G adds is in the words above.

#include <cmath>

#include "radcert/polynomial/nodes/superconvergent_inset.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

constexpr int terms = 24;

/// The nodes and weights of a cell, both halves, in units of h.
struct CellRule {
  std::vector<Ball> places;
  std::vector<Ball> weights;

  CellRule(int r, const Rational& alpha) {
    const InsetFamily family(r);
    for (std::size_t j = 0; j < family.size(); ++j) {
      const Rational s = family.node(j)[2](alpha);
      for (const Rational& place : {s, Rational(1 - s)}) {
        places.emplace_back(place);
        weights.emplace_back(family.weight(j)(alpha));
      }
    }
  }

  /// -m: the rule for cos(2 pi 2^i s).
  [[nodiscard]] Ball of_cosine(int i) const {
    const Ball frequency = Ball(2) * Ball::pi() * power(Ball(2), i);
    Ball sum = 0;
    for (std::size_t j = 0; j < places.size(); ++j) sum += weights[j] * cos(frequency * places[j]);
    return sum;
  }
  /// The sum of the sizes of the weights: |m_i| is at most that.
  [[nodiscard]] Ball size() const {
    Ball sum = 0;
    for (const Ball& weight : weights) sum += abs(weight);
    return sum;
  }
};

Ball amplitude(int p, int k) { return Ball(1) / (power(Ball(2), k * p) * Ball(k) * Ball(k)); }

/// E_L, enclosed: what is left of the series after `terms` of it is at most a geometric one.
Ball left_over(const CellRule& rule, int p, int level) {
  Ball sum = 0;
  for (int i = 0; i < terms; ++i) sum -= amplitude(p, level + i) * rule.of_cosine(i);
  return widened(sum, Ball(2) * amplitude(p, level + terms) * rule.size());
}

/// |m_0| less the sum of 2^-ip |m_i|, from below.
Ball margin(const CellRule& rule, int p) {
  Ball rest = abs(rule.of_cosine(0));
  for (int i = 1; i < terms; ++i) rest -= abs(rule.of_cosine(i)) / power(Ball(2), i * p);
  return rest - Ball(2) * rule.size() / power(Ball(2), terms * p);
}

/// The rule over all cells, for the terms k <= level + terms - 1 of u, of which the integral is zero; the
/// nodes of the first cell moved by a part of h.
Ball by_cells(const CellRule& rule, int p, int level, const Ball& moved) {
  const long cells = 1L << level;
  Ball sum = 0;
  for (long cell = 0; cell < cells; ++cell)
    for (std::size_t j = 0; j < rule.places.size(); ++j) {
      const Ball x = (Ball(cell) + rule.places[j] + (cell == 0 ? moved : Ball(0))) / Ball(cells);
      for (int k = 1; k < level + terms; ++k)
        sum -= rule.weights[j] * amplitude(p, k) * cos(Ball(2) * Ball::pi() * power(Ball(2), k) * x);
    }
  return sum / Ball(cells);
}

// The exponent of E_L beside |log h| from three levels.
ObservedOrder order(const CellRule& rule, int p, int level) {
  LevelErrors errors;
  for (int l = level; l < level + 3; ++l) {
    errors.mesh_sizes.push_back(std::ldexp(1.0, -l));
    errors.errors.push_back(proved(abs(left_over(rule, p, l))));
  }
  return observed_order(errors, {.logarithm = true});
}

}  // namespace

Finding theorem_7_smoothness(const Bench&) {
  const BallPrecision precision(512);
  Finding finding;
  for (const int r : {1, 3}) {
    const Rational alpha = superconvergent_inset(r, 1 / power(Rational(10), 60)).value().value;
    const CellRule rule(r, alpha);
    const std::string of = ", r = " + std::to_string(r);
    finding.require("2^-ip |m_i|, i >= 1, summed, less |m_0|, p = r + 2" + of,
                    AtMost{.value = 0, .slack = 0, .why = "|E_L| is at least c h^p/L^2 for all L"},
                    proved(-margin(rule, r + 2)));
    finding.control("2^-ip |m_i|, i >= 1, summed, less |m_0|, p = 0" + of,
                    AtMost{.value = 0, .slack = 0, .why = ""}, proved(-margin(rule, 0)));
    for (int level = 1; level <= 6; ++level) {
      const std::string at = of + ", h = 2^-" + std::to_string(level);
      const AgreesWith formula{.value = left_over(rule, r + 2, level), .within = 1e-20};
      finding.require("Int (I - L) u by the cells, p = r + 2" + at, formula,
                      by_cells(rule, r + 2, level, Ball(0)));
      finding.control("the same, the nodes of one cell moved by h/3" + at, formula,
                      by_cells(rule, r + 2, level, Ball(Rational(1, 3))));
    }
    for (int level = 12; level <= 24; level += 6) {
      const Order printed = Order::at_least(r + 3);
      const std::string at = of + ", L = " + std::to_string(level);
      finding.require("order of Int (I - L) u, p = r + 2" + at, printed, order(rule, r + 2, level));
      finding.instead("order of Int (I - L) u, p = r + 3" + at, printed, order(rule, r + 3, level));
      finding.control("order of Int (I - L) u, p = r + 1" + at, printed, order(rule, r + 1, level));
    }
  }
  return finding;
}

}  // namespace radcert::verification::m06
