// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/occlusion/panel_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/continuous/upward.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What rounding makes of d and g, over the extent X.
/// Maths     points within 33 u X (displacement), others rounded once; unit vectors off by 6 u a coordinate;
///           sums of three products of at most 4 X: less than 128 u X
constexpr double rounding_of_distance = 256 * unit_roundoff<double>();

Vector<double> rounded(const Vector<Rational>& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

Vector<double> direction(const Vector<Rational>& v) {
  const Ball size = sqrt(Ball(dot(v, v)));
  return {(Ball(v.x) / size).to_double(), (Ball(v.y) / size).to_double(), (Ball(v.z) / size).to_double()};
}

/// The outward direction of a side in the plane of a panel.
Vector<Rational> outward(const Panel& panel, std::size_t side) {
  const std::vector<Vector<Rational>>& c = panel.corners;
  return cross(c[(side + 1) % c.size()] - c[side], panel.normal);
}

}  // namespace

PanelSight::PanelSight(const std::vector<Panel>& panels, const std::vector<Panel>& blockers,
                       const Vector<Rational>& origin, double extent)
    : panels_(panels.size()), slack_(rounding_of_distance * extent) {
  for (const Panel& panel : blockers) {
    Blocker blocker{.at = rounded(panel.corners[0] - origin), .normal = direction(panel.normal), .sides = {}};
    for (std::size_t e = 0; e < panel.corners.size(); ++e)
      blocker.sides.push_back({rounded(panel.corners[e] - origin), direction(outward(panel, e))});
    blockers_.push_back(std::move(blocker));
  }
  if (is_open()) return;
  const auto signs_at = [](const Panel& panel, const Vector<Rational>& normal, const Vector<Rational>& at) {
    Signs signs{.least = 1, .largest = -1};
    for (const Vector<Rational>& corner : panel.corners) {
      const auto sign = static_cast<signed char>(dot(normal, corner - at).sign());
      signs.least = std::min(signs.least, sign);
      signs.largest = std::max(signs.largest, sign);
    }
    return signs;
  };
  for (const Panel& panel : panels)
    for (const Panel& blocker : blockers) {
      const Signs plane = signs_at(panel, blocker.normal, blocker.corners[0]);
      expects(plane.least >= 0 || plane.largest <= 0, "panels on one side of the planes of all blockers");
      planes_.push_back(plane);
      std::vector<Signs>& of_sides = of_sides_.emplace_back();
      for (std::size_t e = 0; e < blocker.corners.size(); ++e)
        of_sides.push_back(signs_at(panel, outward(blocker, e), blocker.corners[e]));
    }
  std::vector<std::vector<Vector<double>>> corners;
  for (const Panel& panel : panels) {
    corners.emplace_back();
    for (const Vector<Rational>& corner : panel.corners) corners.back().push_back(rounded(corner - origin));
  }
  pairs_.resize(panels_ * panels_);
  for (std::size_t i = 0; i < panels_; ++i)
    for (std::size_t j = 0; j < panels_; ++j) {
      Pair& pair = pairs_[i * panels_ + j];
      const auto faces = [&](std::size_t from, std::size_t to) {
        return signs_at(panels[to], panels[from].normal, panels[from].corners[0]).largest > 0;
      };
      if (!faces(i, j) || !faces(j, i)) {
        pair.view = PanelView::none;
        continue;
      }
      std::vector<std::size_t> hiding;
      for (std::size_t b = 0; b < blockers_.size(); ++b) {
        const Signs x = of_plane(i, b);
        const Signs y = of_plane(j, b);
        if (!((x.least < 0 && y.largest > 0) || (x.largest > 0 && y.least < 0))) continue;
        pair.blockers = {b};
        const PanelView found = Lookout(*this, i, corners[i], j).view(corners[j]);
        if (found == PanelView::none) {
          pair.view = PanelView::none;
          break;
        }
        if (found == PanelView::partly) hiding.push_back(b);
      }
      pair.blockers = pair.view == PanelView::none ? std::vector<std::size_t>{} : std::move(hiding);
      if (!pair.blockers.empty()) pair.view = PanelView::partly;
    }
}

void PanelSight::Lookout::Distances::put(const PanelSight& sight, std::size_t panel, std::size_t blocker,
                                         std::span<const Vector<double>> points) {
  const Blocker& past = sight.blockers_[blocker];
  const std::size_t number = panel * sight.blockers_.size() + blocker;
  const std::vector<Signs>& of_sides = sight.of_sides_[number];
  const double sign = sight.planes_[number].least < 0 ? -1 : 1;
  const double slack = sight.slack_;
  from_plane.resize(points.size());
  beyond.resize(points.size() * of_sides.size());
  Between* at = beyond.data();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector<double>& p = points[i];
    const double d = sign * dot(past.normal, p - past.at);
    from_plane[i] = {std::max(0.0, d - slack), std::max(0.0, d + slack)};
    for (std::size_t e = 0; e < of_sides.size(); ++e) {
      const double g = dot(past.sides[e].outward, p - past.sides[e].at);
      *at++ = {of_sides[e].least >= 0 ? std::max(0.0, g - slack) : g - slack,
               of_sides[e].largest <= 0 ? std::min(0.0, g + slack) : g + slack};
    }
  }
}

/// The largest -g_e/|d| over the points, from above: the least number where every alpha has them in front,
/// infinite where none has.
double PanelSight::Lookout::Distances::largest_alpha(std::size_t side) const {
  const std::size_t sides = beyond.size() / from_plane.size();
  double largest = std::numeric_limits<double>::lowest();
  for (std::size_t p = 0; p < from_plane.size(); ++p) {
    const double g = beyond[p * sides + side].least;
    const double d = g >= 0 ? from_plane[p].largest : from_plane[p].least;
    if (d > 0)
      largest = std::max(largest, -(g >= 0 ? g / d / upward : g / d * upward));
    else if (g < 0)
      return infinity;
  }
  return largest;
}

/// Whether g_e >= alpha |d| at all points.
bool PanelSight::Lookout::Distances::are_in_front(std::size_t side, double alpha) const {
  const std::size_t sides = beyond.size() / from_plane.size();
  for (std::size_t p = 0; p < from_plane.size(); ++p) {
    const Between& d = from_plane[p];
    const double least = alpha > 0 ? alpha * d.largest * upward : alpha * d.least / upward;
    if (!(beyond[p * sides + side].least >= least)) return false;
  }
  return true;
}

PanelSight::Lookout::Lookout(const PanelSight& sight, std::size_t panel, std::span<const Vector<double>> hull,
                             std::size_t other)
    : sight_(sight), other_(other), without_blockers_(sight.view(panel, other)) {
  if (sight.is_open()) return;
  for (const std::size_t b : sight.pairs_[panel * sight.panels_ + other].blockers) {
    Past past{.blocker = b, .hull = {}, .alphas = {}};
    past.hull.put(sight, panel, b, hull);
    for (std::size_t e = 0; e < sight.blockers_[b].sides.size(); ++e)
      past.alphas.push_back(past.hull.largest_alpha(e));
    past_.push_back(std::move(past));
  }
}

PanelView PanelSight::Lookout::view(std::span<const Vector<double>> points, MayHide& may_hide) {
  if (past_.empty()) return without_blockers_;
  constexpr std::size_t bits = 64;
  PanelView found = PanelView::whole;
  for (std::size_t i = 0; i < past_.size(); ++i) {
    const MayHide own = i < bits ? MayHide{1} << i : 0;
    if (own != 0 && (may_hide & own) == 0) continue;
    const Past& past = past_[i];
    points_.put(sight_, other_, past.blocker, points);
    const PanelView here = view(past);
    if (here == PanelView::none) return PanelView::none;
    if (here == PanelView::partly)
      found = PanelView::partly;
    else
      may_hide &= ~own;
  }
  return found;
}

PanelView PanelSight::Lookout::view(const Past& past) const {
  const std::size_t sides = past.alphas.size();
  for (std::size_t e = 0; e < sides; ++e)
    if (past.alphas[e] < infinity && points_.are_in_front(e, past.alphas[e])) return PanelView::whole;
  const auto is_inside = [&](std::size_t p, std::size_t q, std::size_t e) {
    const double of_p = past.hull.beyond[p * sides + e].largest;
    const double of_q = points_.beyond[q * sides + e].largest;
    const Between& d = past.hull.from_plane[p];
    const Between& other_d = points_.from_plane[q];
    const double first = of_p * (of_p > 0 ? other_d.largest : other_d.least);
    const double second = of_q * (of_q > 0 ? d.largest : d.least);
    return first + second <= -4 * unit_roundoff<double>() * (std::abs(first) + std::abs(second));
  };
  for (std::size_t p = 0; p < past.hull.from_plane.size(); ++p)
    for (std::size_t q = 0; q < points_.from_plane.size(); ++q)
      for (std::size_t e = 0; e < sides; ++e)
        if (!is_inside(p, q, e)) return PanelView::partly;
  return PanelView::none;
}

}  // namespace radcert
