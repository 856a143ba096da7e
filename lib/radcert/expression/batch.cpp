// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/expression/batch.h"

#include <algorithm>
#include <array>

#include "radcert/scalar/pack.h"

namespace radcert {

namespace {

/// Points treated together: a stack of a few such blocks stays in the first-level cache.
constexpr std::size_t block = 64;
constexpr std::size_t lanes = Pack::lanes;

using Numbers = std::array<double, block>;

/// The operands of a step and where its result goes, which may be where an operand lies.
struct Operands {
  const double* a;
  const double* b;
  double* out;
};

/// One operation on the first numbers of a block, in packs.
template <class Operation>
void apply_packs(const Operands& operands, std::size_t count, const Operation& operation) {
  for (std::size_t i = 0; i < count; i += lanes)
    operation(Pack::load(operands.a + i), Pack::load(operands.b + i)).store(operands.out + i);
}

template <ExpressionKind kind>
void apply_packs(const Operands& operands, std::size_t count) {
  apply_packs(operands, count, [](const Pack& a, const Pack& b) { return detail::apply<Pack>(kind, a, b); });
}

void apply_packs(ExpressionKind kind, const Operands& operands, std::size_t count) {
  using enum ExpressionKind;
  switch (kind) {
    case negate: return apply_packs<negate>(operands, count);
    case add: return apply_packs<add>(operands, count);
    case subtract: return apply_packs<subtract>(operands, count);
    case multiply: return apply_packs<multiply>(operands, count);
    case divide: return apply_packs<divide>(operands, count);
    case power: return apply_packs<power>(operands, count);
    case sqrt: return apply_packs<sqrt>(operands, count);
    case exp: return apply_packs<exp>(operands, count);
    case log: return apply_packs<log>(operands, count);
    case sin: return apply_packs<sin>(operands, count);
    case cos: return apply_packs<cos>(operands, count);
    case tan: return apply_packs<tan>(operands, count);
    case atan: return apply_packs<atan>(operands, count);
    case abs: return apply_packs<abs>(operands, count);
    case min: return apply_packs<min>(operands, count);
    case max: return apply_packs<max>(operands, count);
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

constexpr std::size_t low_stack = 16;

}  // namespace

/// A place of the stack: numbers of its own, or a variable's where they are.
struct CompiledExpression::Level {
  Numbers numbers;
  const double* at;
};

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
  if (stack_size_ <= low_stack) {
    std::array<Level, low_stack>
        stack;  // NOLINT(cppcoreguidelines-pro-type-member-init): each level is written first
    run(arguments, out, stack.data());
  } else {
    std::vector<Level> stack(stack_size_);
    run(arguments, out, stack.data());
  }
}

void CompiledExpression::run(std::span<const std::span<const double>> arguments, std::span<double> out,
                             Level* stack) const {
  std::array<Numbers, 3> ends;  // of arguments whose last pack is not full
  std::array<const double*, 3> from{};
  for (std::size_t start = 0; start < out.size(); start += block) {
    const std::size_t count = std::min(block, out.size() - start);
    const std::size_t full = padded<double>(count);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      from[i] = arguments[i].data() + start;
      if (full == count) continue;
      std::copy_n(from[i], count, ends[i].begin());
      std::fill_n(ends[i].begin() + static_cast<std::ptrdiff_t>(count), full - count, from[i][count - 1]);
      from[i] = ends[i].data();
    }
    std::size_t height = 0;
    for (const Step& step : steps_) {
      if (step.kind == ExpressionKind::literal) {
        Level& top = stack[height++];
        top.numbers.fill(step.literal);
        top.at = top.numbers.data();
        continue;
      }
      if (step.kind == ExpressionKind::variable) {
        stack[height++].at = from[static_cast<std::size_t>(step.variable)];
        continue;
      }
      const bool binary = has_two_operands(step.kind) && !step.whole;
      if (binary) --height;
      Level& top = stack[height - 1];
      const Operands operands{top.at, binary ? stack[height].at : top.at, top.numbers.data()};
      if (step.whole) {
        apply_packs(operands, full,
                    [n = step.whole_exponent](const Pack& a, const Pack&) { return power(a, n); });
      } else {
        apply_packs(step.kind, operands, full);
      }
      top.at = top.numbers.data();
    }
    std::copy_n(stack[0].at, count, out.begin() + static_cast<std::ptrdiff_t>(start));
  }
}

}  // namespace radcert
