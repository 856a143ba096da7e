// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/scalar/functions/taylor_model.h"
#include "radcert/surface/chart.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// How a chart, its unit normal and its area element grow on complex neighbourhoods of a cluster.
/// Maths     c the middle of the box about the parameters, r_s and r_t half its sides; where the barycentric
///           coordinates have the sum 1 and sum |lambda_i| <= g, w = sum lambda_i v_i - c has |w_s| <= g r_s
///           and |w_t| <= g r_t.  L(F(c + w) - F(c) - DF(c) w) <= bend, L(n(c + w) - n(c)) <= turn, |J(c +
///           w)| <= area, L Lie's norm, see ClusterRegion
/// Source    Theorem. Let f = sum c_ij u^i v^j + rest where |u|, |v| < 1 in (R r_s u, R r_t v), |rest| <= d,
///           and q = g/R < 1. Without the terms of orders below m of its power series about c, f(c + w) is at
///           most sum_(i+j >= m) |c_ij| q^(i+j) + d min(m + 1, q^m/(1 - q)) in size. Proof. f(c + zw) is a
///           power series in z for |z| < 1/q; of that of the rest the term of order k is at most d q^k at z =
///           1 by Cauchy's formula, and the rest itself at most d. The same holds of vectors in L, which is a
///           norm with L(zw) = |z| L(w), and L(rest) <= sqrt(2) |rest|. Thus bend with m = 2, turn with m = 1
///           and area with m = 0, from TaylorModel for many R, of which the best counts.  On a plane the
///           normal does not turn
/// Requires  a chart that is known in balls
/// Result    rounded up; infinite from g = limit() on, which is 0 where the chart is not analytic about c
class ChartGrowth {
public:
  ChartGrowth(const Chart& chart, const ParameterTriangle& triangle);

  struct Bounds {
    double bend = 0;
    double turn = 0;
    double area = 0;
  };
  [[nodiscard]] Bounds at(double g) const;
  [[nodiscard]] double limit() const;
  [[nodiscard]] const ParameterPoint<double>& middle() const { return middle_; }

private:
  /// The sizes of a function's terms by their order, and of its rest.
  struct Sizes {
    std::array<double, TaylorModel::highest_degree + 1> of_order{};
    double rest = 0;
    /// Of the terms from order m on, at a part q of the polydisk.
    [[nodiscard]] double from(int m, double q) const;
  };
  static Sizes sizes_of(const TaylorModel& model);
  static Sizes sizes_of(const Vector<TaylorModel>& model);

  /// w runs through R r_s and R r_t.
  struct Polydisk {
    double reach = 1;
    Sizes point;
    Sizes normal;
    Sizes area;
  };

  ParameterPoint<double> middle_;
  std::vector<Polydisk> polydisks_;
};

}  // namespace radcert
