// SPDX-License-Identifier: GPL-3.0-or-later

// What section 5 reads off its tables: orders, by the figures of the tables without their errors of
// integration, and one level beyond the last row where that is needed to tell an order. Level 0, at which an
// element is half a piece, is left out.
//
// Checked      section_5_rates_smooth: E_n of Table 1 and the errors of Table 2 have the order 2 for alpha =
//              1/10 and 4 for alpha = 1/6, where 4 |log h| is an upper bound as well. Rejected: the other
//              alpha on two_piece(3).
// Not checked  the logarithm by itself; finer levels.

#include <string>

#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

const std::string inverse_distance = "1/sqrt(x^2 + y^2 + (z-1/2)^2)";
const std::string squares = "x^2 + y^2 + z^2";
const Rational sixth(1, 6);
const Rational tenth(1, 10);
constexpr OrderModel with_logarithm{.logarithm = true};

Problem two_piece_problem(int p, const std::string& solution, const Rational& alpha) {
  return known_problem("two_piece", {{"p", p}}, "1", solution, 1, alpha);
}

}  // namespace

Finding section_5_rates_smooth(const Bench& bench) {
  const Order two = Order::is(2);
  const Order four = Order::is(4);
  const Order at_least_four = Order::at_least(4);
  Finding finding;
  const auto of_table_1 = [&](const Rational& alpha) {
    return discretisation_errors(bench, two_piece_problem(2, inverse_distance, alpha), levels_from(1, 4));
  };
  const auto of_table_2 = [&](int p, const Rational& alpha, int last = 4) {
    return node_errors(bench, two_piece_problem(p, squares, alpha), levels_from(1, last));
  };
  const LevelErrors first = of_table_1(sixth);
  const LevelErrors second = of_table_2(2, sixth);
  finding.require("order of E_n, Table 1, alpha = 1/10", two, observed_order(of_table_1(tenth)));
  finding.require("order of max |u - u_n|, Table 2, alpha = 1/10", two, observed_order(of_table_2(2, tenth)));
  finding.require("order of E_n, Table 1, alpha = 1/6", four, observed_order(first));
  finding.require("order of max |u - u_n|, Table 2, alpha = 1/6", four, observed_order(second));
  finding.require("order of E_n beside |log h|, Table 1, alpha = 1/6", at_least_four,
                  observed_order(first, with_logarithm));
  finding.require("order of max |u - u_n| beside |log h|, Table 2, alpha = 1/6", at_least_four,
                  observed_order(second, with_logarithm));
  const LevelErrors slow = of_table_2(3, tenth, 3);
  finding.control("order of max |u - u_n|, two_piece(3), alpha = 1/6, against 2", two,
                  observed_order(of_table_2(3, sixth, 3)));
  finding.control("order of max |u - u_n|, two_piece(3), alpha = 1/10, against 4", four,
                  observed_order(slow));
  finding.control("the same beside |log h|", at_least_four, observed_order(slow, with_logarithm));
  finding.show(observed_order(first).exponent);
  return finding;
}

}  // namespace radcert::verification::ac98
