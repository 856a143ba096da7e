// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/contract.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace radcert {

/// The names that an expression may use for its arguments.
/// Maths     space: a function of the point (x, y, z);  radius: a function of the distance r;  barycentric: a
///           function of the point (x1, x2, x3) of a triangle
/// Source    lib/radcert/formats/README.md
/// Requires  nothing
/// Result    the order of the values given to evaluate()
enum class ExpressionVariables : std::uint8_t { space, radius, barycentric };

/// "x", "y", "z" or "r" or "x1", "x2", "x3".
[[nodiscard]] std::span<const std::string_view> names(ExpressionVariables variables);

/// A point at which an expression in x, y, z is evaluated.
template <class R>
struct Variables {
  R x, y, z;
};

/// The operation of a node of an expression's tree.
enum class ExpressionKind : std::uint8_t {
  literal,
  variable,
  pi,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,
  sqrt,
  exp,
  log,
  sin,
  cos,
  tan,
  atan,
  abs,
  min,
  max
};

/// A node of an expression's tree.
/// Maths     literal: the number; variable: the index into names(); one operand: left; two: left and right
/// Requires  left and right are the places of earlier nodes, -1 where there is no such operand
/// Result    whole_exponent is filled in by Expression: n, where a power's exponent is written as a whole
///           number n, |n| < 10^6; the power is then evaluated by multiplication
struct ExpressionNode {
  ExpressionKind kind = ExpressionKind::literal;
  int left = -1;
  int right = -1;
  int variable = -1;
  std::optional<long> whole_exponent{};
  Rational literal{};
};

namespace detail {

/// The smaller and the larger of two numbers; one that is not a number stays visible.
template <class R>
R smaller(const R& a, const R& b) {
  if constexpr (std::floating_point<R>) {
    if (a != a) return a;
    if (b != b) return b;
    return b < a ? b : a;
  } else if constexpr (std::same_as<R, Pack>) {
    return by_lane(smaller<double>, a, b);
  } else {
    return min(a, b);
  }
}

template <class R>
R larger(const R& a, const R& b) {
  if constexpr (std::floating_point<R>) {
    if (a != a) return a;
    if (b != b) return b;
    return a < b ? b : a;
  } else if constexpr (std::same_as<R, Pack>) {
    return by_lane(larger<double>, a, b);
  } else {
    return max(a, b);
  }
}

/// One node that is neither a literal nor a variable, in the arithmetic R.
template <class R>
R apply(ExpressionKind kind, const R& a, const R& b) {
  using std::abs, std::atan, std::cos, std::exp, std::log, std::pow, std::sin, std::sqrt, std::tan;
  switch (kind) {
    case ExpressionKind::negate: return -a;
    case ExpressionKind::add: return a + b;
    case ExpressionKind::subtract: return a - b;
    case ExpressionKind::multiply: return a * b;
    case ExpressionKind::divide: return a / b;
    case ExpressionKind::power: return pow(a, b);
    case ExpressionKind::sqrt: return sqrt(a);
    case ExpressionKind::exp: return exp(a);
    case ExpressionKind::log: return log(a);
    case ExpressionKind::sin: return sin(a);
    case ExpressionKind::cos: return cos(a);
    case ExpressionKind::tan: return tan(a);
    case ExpressionKind::atan: return atan(a);
    case ExpressionKind::abs: return abs(a);
    case ExpressionKind::min: return smaller<R>(a, b);
    case ExpressionKind::max: return larger<R>(a, b);
    case ExpressionKind::literal:
    case ExpressionKind::variable:
    case ExpressionKind::pi: break;
  }
  expects(false, "a node with operands", named("kind", kind));
  return a;
}

}  // namespace detail

/// A function of (x, y, z), or of r, given as text.
/// Maths     the expression as written: no simplification, x/x stays; literals are exact rationals until a
///           Real is asked for
/// Source    the grammar in expression/parse.h
/// Requires  evaluate(): R has sqrt exp log sin cos tan atan pow abs min max (found by argument-dependent
///           lookup or in std), from_rational<R>, pi<R>
/// Result    each node in the arithmetic R: Ball encloses, double rounds once a node; a whole power is
///           repeated multiplication. Copies share the tree
/// Limits    outside its domain (1/0, sqrt(-1)) the result is what R makes of it, for double inf or nan: the
///           caller looks. abs, min, max are not differentiable where they switch
class Expression {
public:
  /// The constant 0.
  Expression();
  /// A constant; its text is q.to_text() unless another is given.
  [[nodiscard]] static Expression constant(const Rational& q, std::string text = {});
  /// From a tree, operands before operators, the root last; ContractViolation where it is not one.
  Expression(std::vector<ExpressionNode> nodes, std::string text, ExpressionVariables variables);

  /// The text as written.
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] std::string to_text() const { return text(); }
  /// The tree: operands before operators, the root last, every node but the root the operand of exactly one
  /// other.
  [[nodiscard]] const std::vector<ExpressionNode>& nodes() const;
  [[nodiscard]] ExpressionVariables variables() const;
  /// The value, where the expression is written as one number, a negated number, or a fraction of two such.
  [[nodiscard]] std::optional<Rational> is_constant() const;
  /// Whether the name of this index occurs in the expression.
  [[nodiscard]] bool depends_on(int variable) const;

  template <class R>
  [[nodiscard]] R evaluate(const Variables<R>& at) const {
    expects(variables() == ExpressionVariables::space, "an expression in x, y, z", named("text", text()));
    const std::array<const R*, 3> arguments{&at.x, &at.y, &at.z};
    return evaluate_nodes<R>(arguments);
  }
  template <class R>
  [[nodiscard]] R evaluate_radial(const R& r) const {
    expects(variables() == ExpressionVariables::radius, "an expression in r", named("text", text()));
    const std::array<const R*, 1> arguments{&r};
    return evaluate_nodes<R>(arguments);
  }

private:
  template <class R>
  [[nodiscard]] R evaluate_nodes(std::span<const R* const> arguments) const {
    std::vector<R> values;
    values.reserve(nodes().size());
    for (const ExpressionNode& node : nodes()) {
      const auto operand = [&](int place) -> const R& { return values[static_cast<std::size_t>(place)]; };
      switch (node.kind) {
        case ExpressionKind::literal: values.push_back(from_rational<R>(node.literal)); break;
        case ExpressionKind::variable:
          values.push_back(*arguments[static_cast<std::size_t>(node.variable)]);
          break;
        case ExpressionKind::pi: values.push_back(pi<R>()); break;
        case ExpressionKind::power:
          if (node.whole_exponent) {
            values.push_back(power(operand(node.left), *node.whole_exponent));
            break;
          }
          [[fallthrough]];
        default:
          values.push_back(detail::apply<R>(node.kind, operand(node.left),
                                            operand(node.right < 0 ? node.left : node.right)));
      }
    }
    return values.back();
  }

  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace radcert
