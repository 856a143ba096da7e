// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/exchange_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace radcert {

namespace {

using Point = Vector<double>;

/// Heights of lengths up to 1 say nothing below this: some roundings.
constexpr double least_height = 0x1p-46;

/// What of a screen lies in front of a plane; sides keep what is beyond them, the new one has nothing.
void cut_behind(Screen& screen, const Point& unit_normal, const Point& at) {
  const std::size_t n = screen.corners.size();
  std::vector<double> heights;
  bool below = false;
  for (const Point& p : screen.corners) {
    const double height = dot(unit_normal, p - at);
    heights.push_back(std::abs(height) <= least_height ? 0 : height);
    below = below || heights.back() < 0;
  }
  if (!below) return;
  FacetCorners corners;
  std::vector<std::optional<std::size_t>> beyond;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = k + 1 == n ? 0 : k + 1;
    const double here = heights[k];
    const double there = heights[next];
    if (here >= 0) {
      corners.push_back(screen.corners[k]);
      beyond.push_back(here == 0 && there < 0 ? std::nullopt : screen.beyond_side[k]);
    }
    if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
      corners.push_back(screen.corners[k] +
                        (here / (here - there)) * (screen.corners[next] - screen.corners[k]));
      beyond.push_back(here > 0 ? std::nullopt : screen.beyond_side[k]);
    }
  }
  screen.corners = std::move(corners);
  screen.beyond_side = std::move(beyond);
}

FacetCorners placed(const FacetCorners& corners, const Point& origin, double factor) {
  FacetCorners out;
  out.reserve(corners.size());
  for (const Point& p : corners) out.push_back(factor * (p - origin));
  return out;
}

/// The sides that occluders of one plane have in common; those of bodies are known.
void find_common_sides(std::vector<Screen>& screens) {
  for (std::size_t i = 0; i < screens.size(); ++i)
    for (std::size_t j = i + 1; j < screens.size(); ++j) {
      if (screens[i].is_of_body || screens[i].solid != screens[j].solid) continue;
      const FacetCorners& a = screens[i].corners;
      const FacetCorners& b = screens[j].corners;
      for (std::size_t k = 0; k < a.size(); ++k)
        for (std::size_t l = 0; l < b.size(); ++l) {
          const Point& from = b[l];
          const Point& to = b[(l + 1) % b.size()];
          const Point& start = a[k];
          const Point& end = a[(k + 1) % a.size()];
          if ((start == to && end == from) || (start == from && end == to)) {
            screens[i].beyond_side[k] = j;
            screens[j].beyond_side[l] = i;
          }
        }
    }
}

}  // namespace

ExchangeGeometry exchange_geometry(const FacetScene& scene, const OrientedPolygon& receiver,
                                   const OrientedPolygon& source, const std::vector<std::size_t>& occluders) {
  double largest = 0;
  for (const Point& p : receiver.corners)
    for (const Point& q : source.corners) largest = std::max(largest, norm(p - q));
  ExchangeGeometry out;
  out.unit = std::exp2(std::ceil(std::log2(largest)));
  out.origin = receiver.corners.front();
  const double factor = 1 / out.unit;
  out.receiver = placed(receiver.corners, out.origin, factor);
  out.source = placed(source.corners, out.origin, factor);
  out.receiver_normal = receiver.unit_normal;
  std::vector<Screen> all;
  for (const std::size_t k : occluders) {
    const ConvexOccluder& occluder = scene.occluders()[k];
    Screen screen{.corners = placed(occluder.corners, out.origin, factor),
                  .normal = scene.unit_normal(scene.triangle_of_occluder(k)),
                  .solid = occluder.solid,
                  .is_of_body = scene.solid_is_body(occluder.solid),
                  .beyond_side = {}};
    for (const std::optional<std::size_t>& beyond : occluder.beyond_side) {
      const auto at = beyond ? std::find(occluders.begin(), occluders.end(), *beyond) : occluders.end();
      screen.beyond_side.push_back(at == occluders.end()
                                       ? std::nullopt
                                       : std::optional(static_cast<std::size_t>(at - occluders.begin())));
    }
    all.push_back(std::move(screen));
  }
  find_common_sides(all);
  std::vector<std::optional<std::size_t>> number(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    cut_behind(all[k], receiver.unit_normal, out.receiver.front());
    cut_behind(all[k], source.unit_normal, out.source.front());
    if (all[k].corners.size() < 3) continue;
    number[k] = out.screens.size();
    out.screens.push_back(std::move(all[k]));
  }
  for (Screen& screen : out.screens)
    for (std::optional<std::size_t>& beyond : screen.beyond_side)
      if (beyond) beyond = number[*beyond];
  return out;
}

double polygon_flux(const FacetCorners& polygon, const Vector<double>& at,
                    const Vector<double>& unit_normal) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point a = polygon[k] - at;
    const Point b = polygon[k + 1 == polygon.size() ? 0 : k + 1] - at;
    const Point across = cross(a, b);
    const double size = norm(across);
    if (size > 0) sum += std::atan2(size, dot(a, b)) * dot(unit_normal, across) / size;
  }
  // Counterclockwise as seen from P: the cross products point out of the pyramid.
  return -sum / 2;
}

double SourceViewer::flux(const Vector<double>& at, const std::vector<std::size_t>& screens) {
  count_ = 0;
  Piece& whole = next_place();
  for (const Point& q : geometry_.source) whole.push_back(q - at);
  for (const std::size_t k : screens) {
    if (count_ == 0) break;
    subtract(geometry_.screens[k], at);
  }
  double sum = 0;
  for (std::size_t i = 0; i < count_; ++i) sum += polygon_flux(pieces_[i], {}, geometry_.receiver_normal);
  return sum;
}

SourceViewer::Piece& SourceViewer::next_place() {
  if (count_ == pieces_.size()) pieces_.emplace_back();
  pieces_[count_].clear();
  return pieces_[count_++];
}

void SourceViewer::subtract(const Screen& screen, const Vector<double>& at) {
  const FacetCorners& corners = screen.corners;
  const double height = dot(screen.normal, at - corners[0]);
  if (height == 0 || (screen.is_of_body && height < 0)) return;
  const double side = height > 0 ? 1 : -1;
  const std::size_t sides = corners.size();
  rays_.resize(sides);
  for (std::size_t k = 0; k < sides; ++k) rays_[k] = corners[k] - at;
  normals_.resize(sides);
  for (std::size_t k = 0; k < sides; ++k)
    normals_[k] = -side * cross(rays_[k], rays_[k + 1 == sides ? 0 : k + 1]);
  const std::size_t count = count_;
  std::swap(pieces_, before_);
  count_ = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (lies_beside(before_[i])) {
      std::swap(next_place(), before_[i]);
      continue;
    }
    rest_ = before_[i];
    const std::size_t kept = count_;
    for (std::size_t k = 0; k < sides && !rest_.empty(); ++k) cut_off(normals_[k]);
    // Of a piece that is seen whole the parts are not needed.
    if (rest_.empty() && count_ != kept + 1) {
      count_ = kept;
      std::swap(next_place(), before_[i]);
    }
  }
}

/// Whether one of the planes through P has all of a piece outside.
bool SourceViewer::lies_beside(const Piece& piece) const {
  return std::any_of(normals_.begin(), normals_.end(), [&](const Vector<double>& normal) {
    return std::all_of(piece.begin(), piece.end(),
                       [&](const Vector<double>& corner) { return dot(normal, corner) <= 0; });
  });
}

/// What of the rest lies outside is seen.
void SourceViewer::cut_off(const Vector<double>& normal) {
  const std::size_t n = rest_.size();
  heights_.resize(n);
  bool above = false;
  bool below = false;
  for (std::size_t k = 0; k < n; ++k) {
    heights_[k] = dot(normal, rest_[k]);
    above = above || heights_[k] > 0;
    below = below || heights_[k] < 0;
  }
  if (!below) return;
  if (!above) {
    next_place() = rest_;
    rest_.clear();
    return;
  }
  inside_.clear();
  outside_.clear();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = k + 1 == n ? 0 : k + 1;
    const double here = heights_[k];
    const double there = heights_[next];
    if (here >= 0) inside_.push_back(rest_[k]);
    if (here <= 0) outside_.push_back(rest_[k]);
    if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
      const Point at = rest_[k] + (here / (here - there)) * (rest_[next] - rest_[k]);
      inside_.push_back(at);
      outside_.push_back(at);
    }
  }
  if (outside_.size() >= 3) next_place() = outside_;
  std::swap(rest_, inside_);
  if (rest_.size() < 3) rest_.clear();
}

}  // namespace radcert
