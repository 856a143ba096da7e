// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/expression/batch.h"

#include <algorithm>
#include <array>

namespace radcert {

namespace {

/// Points treated together: a stack of a few such blocks stays in the first-level cache.
constexpr std::size_t block = 64;

using Block = std::array<double, block>;

/// One operation on the first `count` lanes: a := f(a, b). The lanes beyond hold earlier values and are never
/// read.
template <ExpressionKind kind>
void apply_lanes(Block& a, const Block& b, std::size_t count) {
  for (std::size_t lane = 0; lane < count; ++lane) a[lane] = detail::apply<double>(kind, a[lane], b[lane]);
}

void apply_lanes(ExpressionKind kind, Block& a, const Block& b, std::size_t count) {
  using enum ExpressionKind;
  switch (kind) {
    case negate: return apply_lanes<negate>(a, b, count);
    case add: return apply_lanes<add>(a, b, count);
    case subtract: return apply_lanes<subtract>(a, b, count);
    case multiply: return apply_lanes<multiply>(a, b, count);
    case divide: return apply_lanes<divide>(a, b, count);
    case power: return apply_lanes<power>(a, b, count);
    case sqrt: return apply_lanes<sqrt>(a, b, count);
    case exp: return apply_lanes<exp>(a, b, count);
    case log: return apply_lanes<log>(a, b, count);
    case sin: return apply_lanes<sin>(a, b, count);
    case cos: return apply_lanes<cos>(a, b, count);
    case tan: return apply_lanes<tan>(a, b, count);
    case atan: return apply_lanes<atan>(a, b, count);
    case abs: return apply_lanes<abs>(a, b, count);
    case min: return apply_lanes<min>(a, b, count);
    case max: return apply_lanes<max>(a, b, count);
    case literal:
    case variable:
    case pi: break;
  }
}

bool has_two_operands(ExpressionKind kind) {
  using enum ExpressionKind;
  return kind == add || kind == subtract || kind == multiply || kind == divide || kind == power ||
         kind == min || kind == max;
}

bool is_leaf(ExpressionKind kind) {
  using enum ExpressionKind;
  return kind == literal || kind == variable || kind == pi;
}

}  // namespace

CompiledExpression::CompiledExpression(const Expression& expression) : variables_(expression.variables()) {
  const std::vector<ExpressionNode>& nodes = expression.nodes();
  // The exponent of a whole power, a literal or a negated one, is in the power's step; its nodes need none.
  std::vector<bool> left_out(nodes.size(), false);
  for (std::size_t place = nodes.size(); place-- > 0;) {
    const ExpressionNode& node = nodes[place];
    if (left_out[place] && node.left >= 0) left_out[static_cast<std::size_t>(node.left)] = true;
    if (node.whole_exponent) left_out[static_cast<std::size_t>(node.right)] = true;
  }
  std::size_t height = 0;
  for (std::size_t place = 0; place < nodes.size(); ++place) {
    if (left_out[place]) continue;
    const ExpressionNode& node = nodes[place];
    Step step{node.kind, node.variable, node.whole_exponent.value_or(0), node.whole_exponent.has_value(),
              0.0};
    if (node.kind == ExpressionKind::literal) step.literal = from_rational<double>(node.literal);
    if (node.kind == ExpressionKind::pi) {
      step.kind = ExpressionKind::literal;
      step.literal = pi<double>();
    }
    steps_.push_back(step);
    if (is_leaf(node.kind)) ++height;
    if (has_two_operands(node.kind) && !step.whole) --height;
    stack_size_ = std::max(stack_size_, height);
  }
}

void CompiledExpression::evaluate(std::span<const double> x, std::span<const double> y,
                                  std::span<const double> z, std::span<double> out) const {
  expects(variables_ == ExpressionVariables::space, "an expression in x, y, z");
  const std::array<std::span<const double>, 3> arguments{x, y, z};
  run(arguments, out);
}

void CompiledExpression::evaluate_radial(std::span<const double> r, std::span<double> out) const {
  expects(variables_ == ExpressionVariables::radius, "an expression in r");
  const std::array<std::span<const double>, 1> arguments{r};
  run(arguments, out);
}

double CompiledExpression::at(double x, double y, double z) const {
  expects(variables_ == ExpressionVariables::space, "an expression in x, y, z");
  constexpr std::size_t usual_height = 96;
  if (stack_size_ > usual_height) {
    double out = 0;
    evaluate({&x, 1}, {&y, 1}, {&z, 1}, {&out, 1});
    return out;
  }
  const std::array<double, 3> arguments{x, y, z};
  std::array<double, usual_height> stack;
  std::size_t height = 0;
  for (const Step& step : steps_) {
    if (step.kind == ExpressionKind::literal) {
      stack[height++] = step.literal;
    } else if (step.kind == ExpressionKind::variable) {
      stack[height++] = arguments[static_cast<std::size_t>(step.variable)];
    } else if (step.whole) {
      stack[height - 1] = power(stack[height - 1], step.whole_exponent);
    } else {
      if (has_two_operands(step.kind)) --height;
      const double second = has_two_operands(step.kind) ? stack[height] : stack[height - 1];
      stack[height - 1] = detail::apply<double>(step.kind, stack[height - 1], second);
    }
  }
  return stack[0];
}

void CompiledExpression::run(std::span<const std::span<const double>> arguments,
                             std::span<double> out) const {
  for (const std::span<const double>& argument : arguments) {
    expects(argument.size() == out.size(), "as many arguments as results",
            named("arguments", argument.size()), named("results", out.size()));
  }
  std::vector<Block> stack(stack_size_, Block{});
  for (std::size_t start = 0; start < out.size(); start += block) {
    const std::size_t count = std::min(block, out.size() - start);
    std::size_t height = 0;
    for (const Step& step : steps_) {
      if (step.kind == ExpressionKind::literal) {
        stack[height++].fill(step.literal);
      } else if (step.kind == ExpressionKind::variable) {
        const auto from = arguments[static_cast<std::size_t>(step.variable)].subspan(start, count);
        std::copy(from.begin(), from.end(), stack[height++].begin());
      } else if (step.whole) {
        Block& base = stack[height - 1];
        for (std::size_t lane = 0; lane < count; ++lane) base[lane] = power(base[lane], step.whole_exponent);
      } else if (has_two_operands(step.kind)) {
        --height;
        apply_lanes(step.kind, stack[height - 1], stack[height], count);
      } else {
        apply_lanes(step.kind, stack[height - 1], stack[height - 1], count);
      }
    }
    std::copy_n(stack[0].begin(), count, out.begin() + static_cast<std::ptrdiff_t>(start));
  }
}

}  // namespace radcert
