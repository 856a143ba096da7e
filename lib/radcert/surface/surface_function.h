// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
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

/// A function of a program's own, known by its values in double alone.
/// Maths     values[i] = f(x[i], y[i], z[i])
/// Requires  a function that threads may call at the same time, and `words` for whoever reads of it
/// Result    plain data
struct OwnFunction {
  std::string words;
  std::function<void(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                     std::span<double> values)>
      values;
};

/// A function on a surface given by one expression a piece; the piece "*" stands for all others.
struct PiecewiseExpression {
  struct Case {
    std::string piece;
    Expression expression;
    /// In place of the expression, which then has no value in any arithmetic: see own_function
    std::shared_ptr<const OwnFunction> own = nullptr;
  };
  std::vector<Case> cases;  ///< in the order of the file

  /// The case or the expression of a piece. Requires a case for it, else ContractViolation.
  const Case& case_on(std::string_view piece) const;
  const Expression& on(std::string_view piece) const { return case_on(piece).expression; }
  /// Whether a case is a function of a program's own.
  [[nodiscard]] bool has_own() const;
};

/// A function of a program's own on all pieces.
/// Maths     the expression of the case is log(-1): no real number, in double NaN, a failure of balls
/// Requires  words and values, else ContractViolation
/// Result    SurfaceFunction takes its values. Whoever asks the expression itself, to prove something or to
///           find a polynomial, finds that it has no value and refuses. Nothing of it is kept in a store: its
///           words do not tell it from another
/// Limits    rounding of the function is not known, so that what follows from it has no radius
[[nodiscard]] PiecewiseExpression own_function(OwnFunction function);

/// A piecewise expression ready for use on a surface.
/// Maths     u(Q) for Q on chart j: the expression of the chart's piece at the coordinates of Q
/// Source    the file format radcert/problem/1
/// Requires  an expression for every piece of the surface
/// Result    rounded as the expression's operations round; safe to share between threads
/// Limits    double
class SurfaceFunction {
public:
  SurfaceFunction(const PiecewiseExpression& function, const Surface& surface) {
    for (const Chart& chart : surface.charts) {
      const PiecewiseExpression::Case& part = function.case_on(chart.facts().piece);
      formulas_.push_back(part.expression);
      own_.push_back(part.own);
    }
    for (const Expression& formula : formulas_) by_chart_.emplace_back(formula);
  }

  /// Whether each chart has a formula, and none a function of a program's own.
  [[nodiscard]] bool is_by_formulas() const {
    return std::all_of(own_.begin(), own_.end(), [](const auto& own) { return own == nullptr; });
  }
  /// The expression of each chart.
  std::span<const Expression> formulas() const { return formulas_; }

  double operator()(std::size_t chart, const Vector<double>& q) const {
    if (own_[chart] == nullptr) return by_chart_[chart].at(q.x, q.y, q.z);
    double value = 0;
    own_[chart]->values({&q.x, 1}, {&q.y, 1}, {&q.z, 1}, {&value, 1});
    return value;
  }

  /// The values at many points of one chart, the same bits; InputError at /solution where one is not finite.
  void evaluate(std::size_t chart, std::span<const double> x, std::span<const double> y,
                std::span<const double> z, std::span<double> values) const {
    if (own_[chart] == nullptr)
      by_chart_[chart].evaluate(x, y, z, values);
    else
      own_[chart]->values(x, y, z, values);
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
  std::vector<std::shared_ptr<const OwnFunction>> own_;  ///< null where a chart has a formula
};

}  // namespace radcert
