// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/expression/batch.h"
#include "radcert/geometry/vector.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A function on a surface given by one expression a piece; the piece "*" stands for all others.
struct PiecewiseExpression {
  struct Case {
    std::string piece;
    Expression expression;
  };
  std::vector<Case> cases;  ///< in the order of the file

  /// The expression on a piece. Requires a case for it, else ContractViolation.
  const Expression& on(std::string_view piece) const;
};

/// A piecewise expression ready for use on a surface.
/// Maths     u(Q) for Q on chart j: the expression of the chart's piece at the coordinates of Q
/// Source    the file format radcert/problem/1
/// Requires  an expression for every piece of the surface
/// Result    rounded as the expression's operations round; safe to share between threads
/// Limits    double
class SurfaceFunction {
public:
  SurfaceFunction(const PiecewiseExpression& function, const Surface& surface) {
    for (const Chart& chart : surface.charts) formulas_.push_back(function.on(chart.facts().piece));
    for (const Expression& formula : formulas_) by_chart_.emplace_back(formula);
  }

  /// The expression of each chart.
  std::span<const Expression> formulas() const { return formulas_; }

  double operator()(std::size_t chart, const Vector<double>& q) const {
    return by_chart_[chart].at(q.x, q.y, q.z);
  }

  /// The values at many points of one chart, the same bits; InputError at /solution where one is not finite.
  void evaluate(std::size_t chart, std::span<const double> x, std::span<const double> y,
                std::span<const double> z, std::span<double> values) const {
    by_chart_[chart].evaluate(x, y, z, values);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        throw InputError({.pointer = "/solution",
                          .value = std::nullopt,
                          .problem = "is not finite at (" + shortest(x[i]) + ", " + shortest(y[i]) + ", " +
                                     shortest(z[i]) + "), a point of the surface",
                          .allowed = "an expression that is finite on the whole surface"});
  }

private:
  std::vector<Expression> formulas_;
  std::vector<CompiledExpression> by_chart_;
};

}  // namespace radcert
