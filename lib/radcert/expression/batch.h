// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/expression/expression.h"

#include <cstddef>
#include <span>
#include <vector>

namespace radcert {

/// An expression made ready for many points in double precision.
/// Maths     out[i] = expression at (x[i], y[i], z[i]), or at r[i]
/// Requires  evaluate(): spans of the same length and the variables of the expression, else
///           ContractViolation; out overlaps no other span
/// Result    the same bits as Expression::evaluate<double> at each point
/// Limits    only an expression of unusual depth allocates: evaluate() once a call, at() where its stack is
///           higher than 96
class CompiledExpression {
public:
  explicit CompiledExpression(const Expression& expression);
  void evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                std::span<double> out) const;
  void evaluate_radial(std::span<const double> r, std::span<double> out) const;

  /// The value at one point, the same bits as evaluate(), without allocation.
  [[nodiscard]] double at(double x, double y, double z) const;

private:
  struct Step {
    ExpressionKind kind;
    int variable;
    long whole_exponent;
    bool whole;
    double literal;
  };
  struct Level;
  void run(std::span<const std::span<const double>> arguments, std::span<double> out) const;
  void run(std::span<const std::span<const double>> arguments, std::span<double> out, Level* stack) const;

  ExpressionVariables variables_;
  std::vector<Step> steps_;
  std::size_t stack_size_ = 0;
};

}  // namespace radcert
