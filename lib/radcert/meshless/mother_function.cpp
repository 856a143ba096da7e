// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/mother_function.h"

#include <utility>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

void expects_positive(const std::optional<Rational>& support) {
  expects(!support || *support > Rational(0), "a support > 0 or none", named("support", *support));
}

}  // namespace

std::string MotherFunction::to_text() const {
  switch (kind) {
    case MotherKind::gaussian: return "gaussian";
    case MotherKind::spline: return "spline";
    case MotherKind::shepard: return "shepard";
    case MotherKind::own: return own.name;
    case MotherKind::expression: break;
  }
  return expression.text();
}

MotherFunction gaussian_mother(std::optional<Rational> support) {
  expects_positive(support);
  return {.kind = MotherKind::gaussian, .support = std::move(support)};
}

MotherFunction spline_mother() { return {.kind = MotherKind::spline, .support = 1}; }

MotherFunction shepard_mother() { return {.kind = MotherKind::shepard, .support = std::nullopt}; }

MotherFunction expression_mother(Expression in_r, std::optional<Rational> support) {
  expects(in_r.variables() == ExpressionVariables::radius, "an expression in r", named("text", in_r.text()));
  expects_positive(support);
  return {.kind = MotherKind::expression, .expression = std::move(in_r), .support = std::move(support)};
}

}  // namespace radcert
