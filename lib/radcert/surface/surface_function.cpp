// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/surface_function.h"

#include <utility>

#include "radcert/core/contract.h"

namespace radcert {

const PiecewiseExpression::Case& PiecewiseExpression::case_on(std::string_view piece) const {
  const Case* rest = nullptr;
  for (const Case& part : cases) {
    if (part.piece == piece) return part;
    if (part.piece == "*") rest = &part;
  }
  expects(rest != nullptr, "an expression for every piece", named("piece", piece));
  return *rest;
}

bool PiecewiseExpression::has_own() const {
  return std::any_of(cases.begin(), cases.end(), [](const Case& part) { return part.own != nullptr; });
}

PiecewiseExpression own_function(OwnFunction function) {
  expects(!function.words.empty() && function.values != nullptr, "words and values of a function");
  ExpressionNode minus_one;
  minus_one.literal = Rational(-1);
  ExpressionNode log;
  log.kind = ExpressionKind::log;
  log.left = 0;
  Expression nowhere({minus_one, log}, function.words, ExpressionVariables::space);
  return {.cases = {{"*", std::move(nowhere), std::make_shared<const OwnFunction>(std::move(function))}}};
}

}  // namespace radcert
