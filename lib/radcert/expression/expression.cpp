// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/expression/expression.h"

#include <utility>

namespace radcert {

namespace {

int operand_count(ExpressionKind kind) {
  switch (kind) {
    case ExpressionKind::literal:
    case ExpressionKind::variable:
    case ExpressionKind::pi: return 0;
    case ExpressionKind::add:
    case ExpressionKind::subtract:
    case ExpressionKind::multiply:
    case ExpressionKind::divide:
    case ExpressionKind::power:
    case ExpressionKind::min:
    case ExpressionKind::max: return 2;
    case ExpressionKind::negate:
    case ExpressionKind::sqrt:
    case ExpressionKind::exp:
    case ExpressionKind::log:
    case ExpressionKind::sin:
    case ExpressionKind::cos:
    case ExpressionKind::tan:
    case ExpressionKind::atan:
    case ExpressionKind::abs: return 1;
  }
  return 0;
}

/// Postorder: a stack machine that reads the nodes finds each operand on top of its stack.
void expect_postorder(const std::vector<ExpressionNode>& nodes, ExpressionVariables variables) {
  expects(!nodes.empty(), "an expression has at least one node");
  std::vector<int> stack;
  for (std::size_t place = 0; place < nodes.size(); ++place) {
    const ExpressionNode& node = nodes[place];
    const int count = operand_count(node.kind);
    const auto takes = [&](int operand) {
      const bool is_there = !stack.empty() && stack.back() == operand;
      if (is_there) stack.pop_back();
      return is_there;
    };
    const bool right = count == 2 ? takes(node.right) : node.right == -1;
    const bool left = count >= 1 ? takes(node.left) : node.left == -1;
    expects(right && left, "operands come right before their operator", named("place", place));
    if (node.kind == ExpressionKind::variable) {
      expects(node.variable >= 0 && static_cast<std::size_t>(node.variable) < names(variables).size(),
              "a variable of the expression", named("variable", node.variable), named("place", place));
    }
    stack.push_back(static_cast<int>(place));
  }
  expects(stack.size() == 1, "every node but the root is an operand", named("roots", stack.size()));
}

/// Whole exponents from here on are left to pow.
constexpr long whole_exponent_bound = 1000000;

/// A literal, or the negation of one.
std::optional<Rational> signed_literal(const std::vector<ExpressionNode>& nodes, int place) {
  const ExpressionNode& node = nodes[static_cast<std::size_t>(place)];
  if (node.kind == ExpressionKind::literal) return node.literal;
  if (node.kind != ExpressionKind::negate) return std::nullopt;
  const ExpressionNode& operand = nodes[static_cast<std::size_t>(node.left)];
  if (operand.kind != ExpressionKind::literal) return std::nullopt;
  return -operand.literal;
}

/// The exponent of a power that is written as a whole number below the bound.
std::optional<long> whole_exponent(const std::vector<ExpressionNode>& nodes, const ExpressionNode& node) {
  if (node.kind != ExpressionKind::power) return std::nullopt;
  const std::optional<Rational> exponent = signed_literal(nodes, node.right);
  const std::optional<long> whole = exponent ? exponent->to_long() : std::nullopt;
  if (!whole || *whole >= whole_exponent_bound || *whole <= -whole_exponent_bound) return std::nullopt;
  return whole;
}

}  // namespace

std::span<const std::string_view> names(ExpressionVariables variables) {
  static constexpr std::array<std::string_view, 3> space{"x", "y", "z"};
  static constexpr std::array<std::string_view, 1> radius{"r"};
  static constexpr std::array<std::string_view, 3> barycentric{"x1", "x2", "x3"};
  switch (variables) {
    case ExpressionVariables::space: return space;
    case ExpressionVariables::radius: return radius;
    case ExpressionVariables::barycentric: return barycentric;
  }
  return {};
}

struct Expression::Tree {
  std::vector<ExpressionNode> nodes;
  std::string text;
  ExpressionVariables variables;
};

Expression::Expression() : Expression(constant(Rational(0))) {}

Expression Expression::constant(const Rational& q, std::string text) {
  ExpressionNode node;
  node.literal = q;
  return {{node}, text.empty() ? q.to_text() : std::move(text), ExpressionVariables::space};
}

Expression::Expression(std::vector<ExpressionNode> nodes, std::string text, ExpressionVariables variables) {
  expect_postorder(nodes, variables);
  for (ExpressionNode& node : nodes) node.whole_exponent = whole_exponent(nodes, node);
  tree_ = std::make_shared<const Tree>(Tree{std::move(nodes), std::move(text), variables});
}

const std::string& Expression::text() const { return tree_->text; }

const std::vector<ExpressionNode>& Expression::nodes() const { return tree_->nodes; }

ExpressionVariables Expression::variables() const { return tree_->variables; }

std::optional<Rational> Expression::is_constant() const {
  const std::vector<ExpressionNode>& all = nodes();
  const int root = static_cast<int>(all.size()) - 1;
  if (all.back().kind != ExpressionKind::divide) return signed_literal(all, root);
  const auto above = signed_literal(all, all.back().left);
  const auto below = signed_literal(all, all.back().right);
  if (!above || !below || below->sign() == 0) return std::nullopt;
  return *above / *below;
}

bool Expression::depends_on(int variable) const {
  for (const ExpressionNode& node : nodes()) {
    if (node.kind == ExpressionKind::variable && node.variable == variable) return true;
  }
  return false;
}

}  // namespace radcert
