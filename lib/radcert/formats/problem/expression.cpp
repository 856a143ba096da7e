// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/expression/parse.h"
#include "radcert/formats/problem/problem_parts.h"

namespace radcert {

namespace {

constexpr const char* expression_allowed =
    "a number, or an expression in a string: x, y, z, pi, + - * / ^, parentheses, "
    "sqrt, exp, log, sin, cos, tan, atan, abs, min, max";

Expression read_expression(const JsonReader& place) {
  if (const auto number = place.value().number())
    return Expression::constant(place.rational(expression_allowed));
  auto parsed = parse_expression(place.string(expression_allowed));
  if (!parsed)
    place.refuse("is no expression: " + without_quotes(parsed.reason().to_text()), expression_allowed);
  return std::move(parsed).value();
}

/// An expression that came from a JSON number other than a small whole one goes back as that number: its text
/// as an exact fraction may have hundreds of digits.
JsonValue expression_json(const Expression& expression) {
  const auto& nodes = expression.nodes();
  if (nodes.size() == 1 && nodes.front().kind == ExpressionKind::literal) {
    const Rational& value = nodes.front().literal;
    const double nearest = value.to_double();
    const bool small_whole = value.is_integer() && std::abs(nearest) <= 9007199254740992.0;
    if (!small_whole && expression.text() == value.to_text() && std::isfinite(nearest) &&
        Rational::exactly(nearest) == value)
      return nearest;
  }
  return expression.text();
}

}  // namespace

void require_pieces(const JsonReader& by_piece, std::span<const std::string> pieces) {
  std::vector<std::string> allowed(pieces.begin(), pieces.end());
  allowed.emplace_back("*");
  by_piece.require_object(allowed);
  if (by_piece.find("*")) return;
  const auto left_out =
      std::find_if(pieces.begin(), pieces.end(), [&](const std::string& p) { return !by_piece.find(p); });
  if (left_out != pieces.end())
    by_piece.refuse("leaves out the piece " + *left_out, "each piece, or * for the rest: " + listed(pieces));
}

PiecewiseExpression read_piecewise(const JsonReader& expression, std::span<const std::string> pieces) {
  PiecewiseExpression out;
  if (expression.value().members() == nullptr) {
    out.cases.push_back({"*", read_expression(expression)});
    return out;
  }
  require_pieces(expression, pieces);
  for (const auto& [piece, place] : expression.members("an object"))
    out.cases.push_back({piece, read_expression(place)});
  return out;
}

JsonValue piecewise_json(const PiecewiseExpression& expression) {
  if (expression.cases.size() == 1 && expression.cases.front().piece == "*")
    return expression_json(expression.cases.front().expression);
  JsonValue out = JsonValue::object();
  for (const PiecewiseExpression::Case& part : expression.cases)
    out.set(part.piece, expression_json(part.expression));
  return out;
}

}  // namespace radcert
