// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/surface/chart.h"
#include "radcert/surface/exact_function.h"

namespace radcert {

/// A rectangle of the parameter plane, its ends exact.
/// Maths     [s_low, s_high] x [t_low, t_high]
/// Requires  ends that are whole multiples of a power of two, so that halves are exact
struct ParameterBox {
  double s_low = 0;
  double s_high = 1;
  double t_low = 0;
  double t_high = 1;

  double s_width() const { return s_high - s_low; }
  double t_width() const { return t_high - t_low; }
  ParameterPoint<double> centre() const { return {(s_low + s_high) / 2, (t_low + t_high) / 2}; }
  std::pair<ParameterBox, ParameterBox> halves(bool across_s) const;
  friend auto operator<=>(const ParameterBox& a, const ParameterBox& b) = default;
};
/// The smallest box about two.
[[nodiscard]] ParameterBox hull(const ParameterBox& a, const ParameterBox& b);
/// Whether a box has more than a point in common with a chart's domain; the whole of which is the box
/// [0,1]^2.
[[nodiscard]] bool meets(const ParameterBox& box, ChartDomain domain);
/// Whether a point is one of the domain.
[[nodiscard]] bool is_in_domain(const ParameterPoint<double>& at, ChartDomain domain);
/// The box as two balls.
[[nodiscard]] ParameterPoint<Ball> ball_of(const ParameterBox& box);

/// A chart over a box, enclosed.
/// Maths     F, D_s F, D_t F and the inner area normal N over the box; the same at its centre; half the
///           second derivatives, and the derivatives of N = +-D_s F x D_t F that follow from them
/// Source    Chart::frame, and chord_along with the step 0, which is D^2 F (d,d) / 2
/// Result    enclosed; balls have failed where the formula does not bound them
/// Limits    curved: whether second derivatives are finite
struct ChartPatch {
  Frame<Ball> over;
  Frame<Ball> centre;
  Vector<Ball> half_ss;
  Vector<Ball> half_st;  ///< D_s D_t F / 2
  Vector<Ball> half_tt;
  Vector<Ball> normal_by_s;
  Vector<Ball> normal_by_t;
  bool curved = false;
};
[[nodiscard]] ChartPatch chart_patch(const Chart& chart, const ParameterBox& box);

/// The patches of one chart, made when they are asked for.
class PatchTable {
public:
  explicit PatchTable(const Chart& chart) : chart_(&chart) {}
  const ChartPatch& operator()(const ParameterBox& box);
  const Chart& chart() const { return *chart_; }

private:
  const Chart* chart_;
  std::map<ParameterBox, ChartPatch> patches_;
};

/// The longer side of a box as its chart maps it: whether to cut s.
[[nodiscard]] bool is_longer_in_s(const Frame<Ball>& frame, const ParameterBox& box);

/// Whether the chart has a formula in balls.
[[nodiscard]] bool has_balls(const Chart& chart);

/// The region of a chart's parameters.
[[nodiscard]] ParameterRegion region_of(const Chart& chart);

}  // namespace radcert
