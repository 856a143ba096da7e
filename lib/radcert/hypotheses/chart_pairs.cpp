// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/chart_pairs.h"

#include <algorithm>
#include <deque>

namespace radcert {
namespace {

struct BoxPair {
  ParameterBox of_p;
  ParameterBox of_q;
};

/// [-w/2, w/2].
Ball around_centre(double width) { return widened(Ball(0), Ball(width / 2)); }

Ball product_at_centres(const ChartPatch& p, const ChartPatch& q) {
  return dot(q.centre.point - p.centre.point, p.centre.area_normal);
}

/// The parts of the mean value form that vary, each with the side of a box that it grows with.
struct Variation {
  Ball p_by_s;
  Ball p_by_t;
  Ball q_by_s;
  Ball q_by_t;

  Ball sum() const { return p_by_s + p_by_t + q_by_s + q_by_t; }
};

Variation variation(const ChartPatch& p, const ParameterBox& box_p, const ChartPatch& q,
                    const ParameterBox& box_q) {
  const Vector<Ball> difference = q.over.point - p.over.point;
  return {.p_by_s = dot(difference, p.normal_by_s) * around_centre(box_p.s_width()),
          .p_by_t = dot(difference, p.normal_by_t) * around_centre(box_p.t_width()),
          .q_by_s = dot(q.over.tangent_s, p.over.area_normal) * around_centre(box_q.s_width()),
          .q_by_t = dot(q.over.tangent_t, p.over.area_normal) * around_centre(box_q.t_width())};
}

/// N . D^2 F / 2 positive definite.
bool bends_inwards(const ChartPatch& patch) {
  if (!patch.curved) return false;
  const Ball ss = dot(patch.over.area_normal, patch.half_ss);
  const Ball st = dot(patch.over.area_normal, patch.half_st);
  const Ball tt = dot(patch.over.area_normal, patch.half_tt);
  return certainly_positive(ss) && certainly_positive(ss * tt - st * st);
}

/// Two boxes are near when the box about both is at most twice as wide as the wider of them.
bool are_near(const ParameterBox& a, const ParameterBox& b) {
  const ParameterBox both = hull(a, b);
  return both.s_width() <= 2 * std::max(a.s_width(), b.s_width()) &&
         both.t_width() <= 2 * std::max(a.t_width(), b.t_width());
}

/// About the square of the longer side of a box as its chart maps it.
double extent(const ChartPatch& patch, const ParameterBox& box) {
  const Ball s = dot(patch.centre.tangent_s, patch.centre.tangent_s);
  const Ball t = dot(patch.centre.tangent_t, patch.centre.tangent_t);
  const double by_s = box.s_width() * box.s_width() * (s.is_finite() ? s.to_double() : 1);
  const double by_t = box.t_width() * box.t_width() * (t.is_finite() ? t.to_double() : 1);
  return std::max(by_s, by_t);
}

/// Which side of which box is halved.
struct Cut {
  bool of_p;
  bool across_s;
};

Cut by_extent(const ChartPatch& p, const ParameterBox& box_p, const ChartPatch& q,
              const ParameterBox& box_q) {
  const bool of_p = extent(p, box_p) >= extent(q, box_q);
  return {.of_p = of_p, .across_s = of_p ? is_longer_in_s(p.over, box_p) : is_longer_in_s(q.over, box_q)};
}

/// The side that the mean value form owes most of its width to.
Cut by_variation(const Variation& varied) {
  const double p = std::max(varied.p_by_s.radius(), varied.p_by_t.radius());
  const double q = std::max(varied.q_by_s.radius(), varied.q_by_t.radius());
  if (p >= q) return {.of_p = true, .across_s = varied.p_by_s.radius() >= varied.p_by_t.radius()};
  return {.of_p = false, .across_s = varied.q_by_s.radius() >= varied.q_by_t.radius()};
}

}  // namespace

PairSearch search_pairs(PatchTable& of_p, PatchTable& of_q, std::size_t limit, std::size_t& boxes) {
  const bool one_chart = &of_p == &of_q;
  const ChartDomain domain_p = of_p.chart().facts().domain;
  const ChartDomain domain_q = of_q.chart().facts().domain;
  std::deque<BoxPair> waiting{{}};
  for (std::size_t looked_at = 0; !waiting.empty() && looked_at < limit; ++looked_at) {
    const BoxPair pair = waiting.front();
    waiting.pop_front();
    if (!meets(pair.of_p, domain_p) || !meets(pair.of_q, domain_q)) continue;
    ++boxes;
    const ChartPatch& p = of_p(pair.of_p);
    const ChartPatch& q = of_q(pair.of_q);
    const Ball at_centres = product_at_centres(p, q);
    const ParameterPoint<double> centre_p = pair.of_p.centre();
    const ParameterPoint<double> centre_q = pair.of_q.centre();
    if (certainly_negative(at_centres) && is_in_domain(centre_p, domain_p) &&
        is_in_domain(centre_q, domain_q))
      return {.boxes_left = waiting.size(), .witness = std::pair(centre_p, centre_q)};
    if (certainly_positive(dot(q.over.point - p.over.point, p.over.area_normal))) continue;
    const Variation varied = variation(p, pair.of_p, q, pair.of_q);
    if (p.curved && certainly_positive(at_centres + varied.sum())) continue;
    const bool near = one_chart && are_near(pair.of_p, pair.of_q);
    if (near && bends_inwards(of_p(hull(pair.of_p, pair.of_q)))) continue;
    if (one_chart && pair.of_p == pair.of_q) {
      const auto [low, high] = pair.of_p.halves(is_longer_in_s(p.over, pair.of_p));
      for (const ParameterBox& x : {low, high})
        for (const ParameterBox& y : {low, high}) waiting.push_back({x, y});
      continue;
    }
    const Cut cut = !near && p.curved ? by_variation(varied) : by_extent(p, pair.of_p, q, pair.of_q);
    if (cut.of_p) {
      const auto [low, high] = pair.of_p.halves(cut.across_s);
      waiting.push_back({low, pair.of_q});
      waiting.push_back({high, pair.of_q});
    } else {
      const auto [low, high] = pair.of_q.halves(cut.across_s);
      waiting.push_back({pair.of_p, low});
      waiting.push_back({pair.of_p, high});
    }
  }
  return {.boxes_left = waiting.size()};
}

}  // namespace radcert
