// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/sector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radcert/geometry/plane.h"
#include "radcert/scalar/ball.h"

namespace radcert {
namespace {

Vector<double> rounded(const Vector<Rational>& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

/// Int (1-t) over the square is 1/2: the jacobian is twice the area.
double length(const Vector<Rational>& v) { return sqrt(Ball(dot(v, v))).to_double(); }

/// The middle of the box about all corners.
Vector<Rational> middle(const std::vector<Panel>& panels) {
  Vector<Rational> least = panels.front().corners.front();
  Vector<Rational> largest = least;
  for (const Panel& panel : panels)
    for (const Vector<Rational>& corner : panel.corners) {
      least = {std::min(least.x, corner.x), std::min(least.y, corner.y), std::min(least.z, corner.z)};
      largest = {std::max(largest.x, corner.x), std::max(largest.y, corner.y), std::max(largest.z, corner.z)};
    }
  return Rational(1, 2) * (least + largest);
}

/// Whether a segment in the plane of a panel has a part of its length in it: what is left of it on the inner
/// side of all of the panel's sides.
bool lies_along(const Vector<Rational>& from, const Vector<Rational>& to, const Panel& panel) {
  Rational begin = 0;
  Rational end = 1;
  for (std::size_t l = 0; l < panel.corners.size(); ++l) {
    const Vector<Rational>& corner = panel.corners[l];
    const Vector<Rational> inwards =
        cross(panel.normal, panel.corners[(l + 1) % panel.corners.size()] - corner);
    const Rational at_from = dot(inwards, from - corner);
    const Rational at_to = dot(inwards, to - corner);
    if (std::max(at_from.sign(), at_to.sign()) <= 0 && std::min(at_from.sign(), at_to.sign()) < 0)
      return false;
    if (at_from.sign() * at_to.sign() >= 0) continue;
    const Rational crossing = at_from / (at_from - at_to);
    if (at_from.sign() < 0)
      begin = std::max(begin, crossing);
    else
      end = std::min(end, crossing);
  }
  return begin < end;
}

double largest_coordinate(const Vector<double>& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

}  // namespace

std::array<SectorBox, 2> halves(const Sector& sector, const SectorBox& box) {
  SectorBox lower = box;
  SectorBox upper = box;
  const double length = (1 - box.middle_t()) * (box.s1 - box.s0) * norm(sector.b - sector.a);
  const double depth = (box.t1 - box.t0) * norm(sector.c - sector.point(box.middle_s(), 0));
  if (length >= depth)
    lower.s1 = upper.s0 = box.middle_s();
  else
    lower.t1 = upper.t0 = box.middle_t();
  return {lower, upper};
}

SectorScene::SectorScene(std::vector<Panel> panels, const std::vector<Panel>& blockers)
    : panels_(std::move(panels)), origin_(middle(panels_)) {
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    const Panel& panel = panels_[k];
    first_sector_.push_back(sectors_.size());
    double area = 0;
    for (std::size_t i = 0; i < panel.corners.size(); ++i) {
      const Vector<Rational>& a = panel.corners[i];
      const Vector<Rational>& b = panel.corners[(i + 1) % panel.corners.size()];
      const double jacobian = length(cross(b - a, panel.centre - a));
      sectors_.push_back(
          {.panel = k, .a = place(a), .b = place(b), .c = place(panel.centre), .jacobian = jacobian});
      area += jacobian / 2;
      extent_ = std::max(extent_, largest_coordinate(sectors_.back().a));
    }
    areas_.push_back(area);
    area_ += area;
    const Vector<Rational>& n = panel.normal;
    const Ball size = sqrt(Ball(dot(n, n)));
    normals_.push_back(
        {(Ball(n.x) / size).to_double(), (Ball(n.y) / size).to_double(), (Ball(n.z) / size).to_double()});
  }
  first_sector_.push_back(sectors_.size());
  for (const Sector& sector : sectors_) {
    const Vector<double> outward = cross(sector.b - sector.a, normals_[sector.panel]);
    outward_.push_back(1 / norm(outward) * outward);
  }
  for (const Panel& panel : panels_)
    for (const Panel& other : panels_) {
      coplanar_.push_back(in_one_plane(panel, other) ? 1 : 0);
      before_.push_back(dot(panel.normal, other.normal).sign() < 0 ? 1 : 0);
    }
  const auto side = [&](std::size_t panel, std::size_t i) {
    const std::vector<Vector<Rational>>& corners = panels_[panel].corners;
    return std::pair<const Vector<Rational>&, const Vector<Rational>&>(corners[i],
                                                                       corners[(i + 1) % corners.size()]);
  };
  opposite_.resize(sectors_.size());
  for (std::size_t k = 0; k < panels_.size(); ++k)
    for (std::size_t i = 0; i < panels_[k].corners.size(); ++i) {
      const auto [from, to] = side(k, i);
      for (std::size_t j = 0; j < panels_.size(); ++j) {
        const Panel& other = panels_[j];
        const bool parallel = dot(to - from, other.normal).sign() == 0;
        parallel_.push_back(parallel ? 1 : 0);
        const bool is_in_plane =
            parallel && !coplanar(j, k) && dot(from - other.corners[0], other.normal).sign() == 0;
        touching_.push_back(is_in_plane && lies_along(from, to, other) ? 1 : 0);
        if (touching_.back() == 0 || dot(panels_[k].normal, other.centre - from).sign() <= 0) continue;
        for (std::size_t l = 0; l < other.corners.size(); ++l) {
          const auto [other_from, other_to] = side(j, l);
          if (other_from == to && other_to == from) opposite_[first_sector_[k] + i] = first_sector_[j] + l;
        }
      }
    }
  sight_.emplace(panels_, blockers, origin_, extent_);
}

Vector<double> SectorScene::origin() const { return rounded(origin_); }

Vector<double> SectorScene::place(const Vector<Rational>& point) const { return rounded(point - origin_); }

double SectorScene::beyond_side(std::size_t sector, const Vector<double>& point) const {
  const Sector& own = sectors_[sector];
  const Vector<double> way = point - own.a;
  const double turn = 4 * displacement * extent_ / norm(own.b - own.a);
  return dot(outward_[sector], way) - turn * norm(way);
}

bool SectorScene::aligned(std::size_t sector, std::size_t other) const {
  const auto side = [&](std::size_t k) {
    const std::size_t panel = sectors_[k].panel;
    const std::vector<Vector<Rational>>& corners = panels_[panel].corners;
    const std::size_t i = k - first_sector_[panel];
    return corners[(i + 1) % corners.size()] - corners[i];
  };
  return is_zero(cross(side(sector), side(other)));
}

double distance(const Vector<double>& point, const Vector<double>& from, const Vector<double>& to) {
  const Vector<double> way = to - from;
  const double squared = dot(way, way);
  const double along = squared > 0 ? std::clamp(dot(point - from, way) / squared, 0.0, 1.0) : 0.0;
  return norm(point - (from + along * way));
}

}  // namespace radcert
