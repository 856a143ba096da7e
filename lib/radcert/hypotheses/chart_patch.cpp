// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/chart_patch.h"

#include <algorithm>

namespace radcert {
namespace {

bool is_finite(const Vector<Ball>& v) { return v.x.is_finite() && v.y.is_finite() && v.z.is_finite(); }

Ball interval(double low, double high) { return hull(Ball(low), Ball(high)); }

/// Of the midpoint; 1 where nothing is known.
double squared_length(const Vector<Ball>& v) {
  const Ball squared = dot(v, v);
  return squared.is_finite() ? squared.to_double() : 1;
}

/// Half the second derivative along a direction, or nothing where the chart has no chords along rays.
std::optional<Vector<Ball>> half_second(const ChartIn<Ball>& chart, const ParameterPoint<Ball>& at, int s,
                                        int t) {
  try {
    return chart.chord_along(at, {Ball(s), Ball(t)}, Ball(0)).bend_p;
  } catch (const ContractViolation&) {  // such charts say so by this alone
    return std::nullopt;
  }
}

}  // namespace

std::pair<ParameterBox, ParameterBox> ParameterBox::halves(bool across_s) const {
  ParameterBox low = *this;
  ParameterBox high = *this;
  if (across_s) {
    low.s_high = high.s_low = centre().s;
  } else {
    low.t_high = high.t_low = centre().t;
  }
  return {low, high};
}

ParameterBox hull(const ParameterBox& a, const ParameterBox& b) {
  return {.s_low = std::min(a.s_low, b.s_low),
          .s_high = std::max(a.s_high, b.s_high),
          .t_low = std::min(a.t_low, b.t_low),
          .t_high = std::max(a.t_high, b.t_high)};
}

bool meets(const ParameterBox& box, ChartDomain domain) {
  return domain == ChartDomain::unit_square || box.s_low + box.t_low < 1;
}

bool is_in_domain(const ParameterPoint<double>& at, ChartDomain domain) {
  const bool in_square = at.s >= 0 && at.s <= 1 && at.t >= 0 && at.t <= 1;
  return in_square && (domain == ChartDomain::unit_square || at.s + at.t <= 1);
}

ParameterPoint<Ball> ball_of(const ParameterBox& box) {
  return {interval(box.s_low, box.s_high), interval(box.t_low, box.t_high)};
}

ChartPatch chart_patch(const Chart& chart, const ParameterBox& box) {
  const ChartIn<Ball>& formula = chart.in<Ball>();
  const ParameterPoint<Ball> all = ball_of(box);
  ChartPatch patch;
  patch.over = formula.frame(all);
  patch.centre = formula.frame({Ball(box.centre().s), Ball(box.centre().t)});
  const auto ss = half_second(formula, all, 1, 0);
  const auto tt = half_second(formula, all, 0, 1);
  const auto sum = half_second(formula, all, 1, 1);
  const auto difference = half_second(formula, all, 1, -1);
  if (!ss || !tt || !sum || !difference) return patch;
  patch.half_ss = *ss;
  patch.half_tt = *tt;
  // D^2 F (d,d)/2 for d = (1,1) and (1,-1) differ by 2 D_s D_t F.
  patch.half_st = (Ball(1) / Ball(4)) * (*sum - *difference);
  if (!is_finite(*ss) || !is_finite(*tt) || !is_finite(patch.half_st)) return patch;
  const Ball sign = chart.facts().orientation == Orientation::along_the_cross_product ? 2 : -2;
  const Frame<Ball>& f = patch.over;
  patch.normal_by_s = sign * (cross(patch.half_ss, f.tangent_t) + cross(f.tangent_s, patch.half_st));
  patch.normal_by_t = sign * (cross(patch.half_st, f.tangent_t) + cross(f.tangent_s, patch.half_tt));
  patch.curved = is_finite(patch.normal_by_s) && is_finite(patch.normal_by_t);
  return patch;
}

const ChartPatch& PatchTable::operator()(const ParameterBox& box) {
  const auto known = patches_.find(box);
  if (known != patches_.end()) return known->second;
  return patches_.emplace(box, chart_patch(*chart_, box)).first->second;
}

bool is_longer_in_s(const Frame<Ball>& frame, const ParameterBox& box) {
  return squared_length(frame.tangent_s) * box.s_width() * box.s_width() >=
         squared_length(frame.tangent_t) * box.t_width() * box.t_width();
}

bool has_balls(const Chart& chart) {
  try {
    static_cast<void>(chart.in<Ball>());
    return true;
  } catch (const ContractViolation&) {
    return false;
  }
}

ParameterRegion region_of(const Chart& chart) {
  return chart.facts().domain == ChartDomain::unit_square ? ParameterRegion::square
                                                          : ParameterRegion::triangle;
}

}  // namespace radcert
