// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/fine_orders.h"

#include <string>
#include <utility>
#include <vector>

#include "radcert/expression/parse.h"
#include "verification/claims/m06/named_problems.h"
#include "verification/framework/fine_levels.h"

namespace radcert::verification::m06 {
namespace {

/// A study, the order that is claimed of it, and from how much less K(I - P_n)u and u - u_n are to tell it:
/// the whole interval of the exponent lies above half of that below the order.
struct FineOrder {
  std::string name;
  FineStudy study;
  int claimed = 0;
  double less_at_source = 0.04;
  double less_at_nodes = 0.1;  ///< as the radius holds that of the solution as well
};

FineOrder of(const std::string& name, int first, int last, const Rational& tolerance, int claimed) {
  return {name,
          {.problem = problem_named(name),
           .first = first,
           .last = last,
           .tolerance = tolerance,
           .order = claimed},
          claimed};
}

// Where u = exp(x/2 + y/3 - z/4) leaves an error near the radius of the levels, one that varies more.
FineOrder with_solution(FineOrder order, const std::string& u) {
  order.name += ", u = " + u;
  order.study.problem.solution = PiecewiseExpression{.cases = {{"*", parse_expression(u).value()}}};
  return order;
}

std::string levels_of(const FineStudy& study) {
  return ", levels " + std::to_string(study.first) + " to " + std::to_string(study.last);
}

Order told(int claimed, double less) { return Order::at_least(claimed, claimed - less); }

void require(Finding& finding, const Bench& bench, const FineOrder& order) {
  const std::vector<LevelErrors> errors =
      fine_levels(bench, order.study, {node_error_figure(), discretisation_error_figure()});
  const std::string over_nodes = " over the nodes, " + order.name + levels_of(order.study);
  finding.require("order of max |u - u_n|" + over_nodes, told(order.claimed, order.less_at_nodes),
                  observed_order(errors[0]));
  finding.require("order of max |K(I - P_n)u|" + over_nodes, told(order.claimed, order.less_at_source),
                  observed_order(errors[1]));
  finding.remark("the last max |u - u_n|" + over_nodes, errors[0].errors.back());
}

void control(Finding& finding, const Bench& bench, const FineOrder& order) {
  const std::vector<LevelErrors> errors = fine_levels(bench, order.study, {node_error_figure()});
  finding.control("order of max |u - u_n| over the nodes, " + order.name + levels_of(order.study),
                  told(order.claimed, order.less_at_nodes), observed_order(errors.front()));
}

Rational ten_to_minus(int digits) { return Rational(1) / power(Rational(10), digits); }

}  // namespace

void require_fine_orders_of_theorem_7(Finding& finding, const Bench& bench) {
  require(finding, bench, of("ellipsoid_r1", 4, 6, ten_to_minus(11), 4));
  require(finding, bench, with_solution(of("two_piece_r1", 5, 7, ten_to_minus(13), 4), "exp(4*x + 2*y - z)"));
  control(finding, bench, of("two_piece_r1_other", 5, 7, ten_to_minus(10), 4));
}

void require_fine_orders_of_theorem_9(Finding& finding, const Bench& bench) {
  require(finding, bench, of("two_piece_r0", 5, 7, ten_to_minus(9), 2));
  require(finding, bench, of("ellipsoid_r0", 4, 6, ten_to_minus(8), 2));
  // At level 6 the radius is a hundredth of the error.
  FineOrder quadratic = with_solution(of("two_piece_r2", 4, 6, ten_to_minus(13), 4), "exp(2*x + y - z)");
  quadratic.less_at_source = 0.2;
  quadratic.less_at_nodes = 0.2;
  require(finding, bench, quadratic);
  require(finding, bench, of("ellipsoid_r2", 3, 5, ten_to_minus(11), 4));
  control(finding, bench, of("two_piece_r1_other", 5, 7, ten_to_minus(10), 3));
}

}  // namespace radcert::verification::m06
