// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/expression/batch.h"
#include "radcert/geometry/vector.h"
#include "radcert/study/problem.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A piecewise expression ready for use on a surface.
/// Maths     u(Q) for Q on chart j: the expression of the chart's piece at the coordinates of Q
/// Source    the file format radcert/problem/1
/// Requires  an expression for every piece of the surface
/// Result    rounded as the expression's operations round; safe to share between threads
/// Limits    double
class SurfaceFunction {
public:
  SurfaceFunction(const PiecewiseExpression& function, const Surface& surface) {
    for (const Chart& chart : surface.charts) by_chart_.emplace_back(function.on(chart.facts().piece));
  }

  double operator()(std::size_t chart, const Vector<double>& q) const {
    double value = 0;
    by_chart_[chart].evaluate({&q.x, 1}, {&q.y, 1}, {&q.z, 1}, {&value, 1});
    return value;
  }

private:
  std::vector<CompiledExpression> by_chart_;
};

}  // namespace radcert
