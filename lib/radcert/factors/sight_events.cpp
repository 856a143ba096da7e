// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/sight_events.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace radcert {

namespace {

using Point = Vector<double>;

/// Products of three lengths say nothing below this part of their sizes' product: some roundings.
constexpr double roundings = 0x1p-46;
/// Corners of cells are rounded to some of these; lengths are at most about 1.
constexpr double cell_rounding = 0x1p-48;

double determinant(const Point& a, const Point& b, const Point& c) { return dot(cross(a, b), c); }

/// Bounds the solid angle of the triangle of three directions of unit length.
double solid_angle(const std::array<Point, 3>& d) {
  const double across = std::abs(determinant(d[0], d[1], d[2]));
  const double along = 1 + dot(d[0], d[1]) + dot(d[1], d[2]) + dot(d[2], d[0]);
  return 2 * std::atan2(across, along);
}

}  // namespace

SightEvents::Sign SightEvents::sign(const Side& side, const Corner& corner) const {
  const Corner& from = corners_[side.from];
  const Corner& to = corners_[side.to];
  if (corner.at == from.at || corner.at == to.at) return none;
  unsigned found = none;
  const double moved = cell_rounding * norm(cross(from.at - corner.at, to.at - corner.at));
  for (std::size_t k = 0; k < 3; ++k) {
    const double height = dot(side.normal[k], corner.ray[k]);
    if (std::abs(height) > roundings * from.distance[k] * to.distance[k] * corner.distance[k] + moved)
      found |= height > 0 ? positive : negative;
  }
  return static_cast<Sign>(found);
}

SightEvents::Sign SightEvents::sign(std::size_t side, std::size_t corner) {
  constexpr unsigned char unknown = 255;
  if (signs_.size() != sides_.size() * corners_.size())
    signs_.assign(sides_.size() * corners_.size(), unknown);
  unsigned char& kept = signs_[side * corners_.size() + corner];
  if (kept == unknown) kept = static_cast<unsigned char>(sign(sides_[side], corners_[corner]));
  return static_cast<Sign>(kept);
}

bool SightEvents::keeps_facing(std::size_t solid) const {
  return std::find(turning_.begin(), turning_.end(), solid) == turning_.end();
}

std::size_t SightEvents::corner_at(const Point& at, std::size_t solid) {
  for (std::size_t k = 0; k < corners_.size(); ++k)
    if (corners_[k].solid == solid && corners_[k].at == at) return k;
  Corner corner{.at = at, .ray = {}, .solid = solid};
  for (std::size_t k = 0; k < 4; ++k) {
    corner.ray[k] = at - cell_[k];
    corner.distance[k] = norm(corner.ray[k]);
  }
  corners_.push_back(std::move(corner));
  return corners_.size() - 1;
}

void SightEvents::add_side(std::size_t from, std::size_t to, std::size_t solid) {
  Side side{.from = from, .to = to, .solid = solid};
  for (std::size_t k = 0; k < 4; ++k) side.normal[k] = cross(corners_[from].ray[k], corners_[to].ray[k]);
  sides_.push_back(side);
}

void SightEvents::add_corners_of_source() {
  corners_.clear();
  sides_.clear();
  for (const Point& q : geometry_.source) corner_at(q, of_source);
  const std::size_t count = corners_.size();
  for (std::size_t k = 0; k < count; ++k) add_side(k, (k + 1) % count, of_source);
}

/// Which screens may hide something; whether one hides all. The sides of a polygon counterclockwise as seen
/// from P have what is inside on their negative side.
bool SightEvents::list_screens(const std::vector<std::size_t>& screens, CellSight& out) {
  const std::size_t source_sides = sides_.size();
  facing_.clear();
  turning_.clear();
  for (const std::size_t number : screens) {
    const Screen& screen = geometry_.screens[number];
    unsigned facing = none;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point d = cell_[k] - screen.corners[0];
      const double height = dot(screen.normal, d);
      if (std::abs(height) > roundings * norm(d) + cell_rounding) facing |= height > 0 ? positive : negative;
    }
    if (facing == none || (screen.is_of_body && (facing & positive) == 0)) continue;
    // Corners and sides of this screen alone, behind those of the source.
    const std::size_t first = corners_.size();
    for (const Point& q : screen.corners) {
      Corner corner{.at = q, .ray = {}, .solid = screen.solid};
      for (std::size_t k = 0; k < 4; ++k) {
        corner.ray[k] = q - cell_[k];
        corner.distance[k] = norm(corner.ray[k]);
      }
      corners_.push_back(std::move(corner));
    }
    const std::size_t count = screen.corners.size();
    for (std::size_t k = 0; k < count; ++k) add_side(first + k, first + (k + 1) % count, screen.solid);
    bool parted = false;
    for (std::size_t g = 0; g < source_sides && !parted; ++g) {
      parted = true;
      for (std::size_t k = first; k < corners_.size() && parted; ++k)
        parted = (sign(sides_[g], corners_[k]) & negative) == 0;
    }
    bool hides = facing != both;
    const unsigned inside = (facing & positive) != 0 ? negative : positive;
    const unsigned outside = inside == negative ? positive : negative;
    for (std::size_t e = source_sides; e < sides_.size() && !parted && facing != both; ++e) {
      unsigned found = none;
      for (std::size_t k = 0; k < source_sides; ++k) found |= sign(sides_[e], corners_[k]);
      parted = (found & inside) == 0;
      hides = hides && (found & outside) == 0;
    }
    corners_.resize(first);
    sides_.resize(source_sides);
    if (parted) continue;
    if (hides) return true;
    out.screens.push_back(number);
    facing_.push_back(static_cast<Sign>(facing));
    if (facing == both) turning_.push_back(screen.solid);
  }
  return false;
}

/// All sides of listed screens but those between two of which both are seen.
void SightEvents::find_sides(const CellSight& listed) {
  const auto place = [&](std::size_t screen) -> std::optional<std::size_t> {
    const auto at = std::find(listed.screens.begin(), listed.screens.end(), screen);
    return at == listed.screens.end() ? std::nullopt
                                      : std::optional(static_cast<std::size_t>(at - listed.screens.begin()));
  };
  for (std::size_t i = 0; i < listed.screens.size(); ++i) {
    const Screen& screen = geometry_.screens[listed.screens[i]];
    const std::size_t count = screen.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
      if (screen.beyond_side[k]) {
        if (const auto other = place(*screen.beyond_side[k])) {
          const bool both_seen =
              !screen.is_of_body || (facing_[i] == positive && facing_[*other] == positive);
          // A side of two listed faces counts once.
          if (both_seen || *other < i) continue;
        }
      }
      const std::size_t from = corner_at(screen.corners[k], screen.solid);
      const std::size_t to = corner_at(screen.corners[(k + 1) % count], screen.solid);
      if (from == to) continue;
      if (facing_[i] == negative)
        add_side(to, from, screen.solid);
      else
        add_side(from, to, screen.solid);
    }
  }
}

/// Whether the source lies within all sides of a convex body whose faces keep their facing on the cell: then
/// these bound its picture.
bool SightEvents::body_hides() const {
  const std::size_t source_sides = geometry_.source.size();
  for (std::size_t begin = source_sides; begin < sides_.size();) {
    std::size_t end = begin;
    while (end < sides_.size() && sides_[end].solid == sides_[begin].solid) ++end;
    bool hides = keeps_facing(sides_[begin].solid);
    for (std::size_t e = begin; e < end && hides; ++e)
      for (std::size_t k = 0; k < source_sides && hides; ++k)
        hides = (sign(sides_[e], corners_[k]) & positive) == 0;
    if (hides) return true;
    begin = end;
  }
  return false;
}

/// What lies inside all sides of a solid's picture, from all points of the cell, is not seen. A side is
/// hidden if both its ends lie inside one picture.
void SightEvents::mark_hidden() {
  const std::size_t source_sides = geometry_.source.size();
  signs_.clear();
  std::vector<std::vector<std::size_t>> hidden_by(corners_.size());
  for (std::size_t begin = source_sides; begin < sides_.size();) {
    const std::size_t solid = sides_[begin].solid;
    std::size_t end = begin;
    while (end < sides_.size() && sides_[end].solid == solid) ++end;
    for (std::size_t c = 0; c < corners_.size() && keeps_facing(solid); ++c) {
      if (corners_[c].solid == solid) continue;
      bool inside = true;
      for (std::size_t e = begin; e < end && inside; ++e) inside = sign(e, c) == negative;
      if (inside) hidden_by[c].push_back(solid);
    }
    begin = end;
  }
  for (std::size_t c = 0; c < corners_.size(); ++c) corners_[c].apart = !hidden_by[c].empty();
  for (Side& side : sides_)
    for (const std::size_t solid : hidden_by[side.from])
      side.hidden = side.hidden || std::find(hidden_by[side.to].begin(), hidden_by[side.to].end(), solid) !=
                                       hidden_by[side.to].end();
}

void SightEvents::drop_sides_apart() {
  const std::size_t source_sides = geometry_.source.size();
  std::size_t kept = source_sides;
  for (std::size_t e = source_sides; e < sides_.size(); ++e) {
    const Side& side = sides_[e];
    unsigned found = none;
    for (std::size_t k = 0; k < source_sides; ++k) found |= sign(side, corners_[k]);
    bool apart = found != both;
    for (std::size_t g = 0; g < source_sides && !apart; ++g)
      apart = ((sign(sides_[g], corners_[side.from]) | sign(sides_[g], corners_[side.to])) & negative) == 0;
    if (side.hidden) continue;
    if (apart) {
      // Then its ends are not over the source either.
      corners_[side.from].apart = true;
      corners_[side.to].apart = true;
    } else {
      sides_[kept++] = side;
    }
  }
  sides_.resize(kept);
  for (std::size_t e = 0; e < sides_.size(); ++e) {
    corners_[sides_[e].from].sides.push_back(e);
    corners_[sides_[e].to].sides.push_back(e);
  }
}

/// Whether the corner is in line with a point of the side, from a point of the cell where it is in line with
/// the side's line. There V - P = a (A - P) + b (B - P), and the signs of a and b change only where P passes
/// lines of the plane through all of them.
bool SightEvents::passes_within(const Corner& corner, const Side& side) const {
  const Point& a = corners_[side.from].at;
  const Point& b = corners_[side.to].at;
  std::array<double, 3> height{};
  for (std::size_t k = 0; k < 3; ++k) height[k] = dot(side.normal[k], corner.ray[k]);
  bool low[2] = {true, true};
  std::optional<Point> first_normal;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if ((height[k] > 0) == (height[next] > 0)) continue;
    const Point p = cell_[k] + (height[k] / (height[k] - height[next])) * (cell_[next] - cell_[k]);
    const Point normal = cross(a - p, b - p);
    if (first_normal && dot(*first_normal, normal) <= 0) return true;
    first_normal = normal;
    const double least = -roundings * dot(normal, normal);
    low[0] = low[0] && dot(cross(corner.at - p, b - p), normal) < least;
    low[1] = low[1] && dot(cross(a - p, corner.at - p), normal) < least;
  }
  return !(low[0] || low[1]);
}

double SightEvents::change(const Side& one, const Side& two, const Side& three, double most) const {
  Point centre;
  for (const Point& q : geometry_.source)
    centre = centre + (1.0 / static_cast<double>(geometry_.source.size())) * q;
  double largest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<Point, 3> direction{cross(one.normal[k], two.normal[k]), cross(two.normal[k], three.normal[k]),
                                   cross(three.normal[k], one.normal[k])};
    const std::array<double, 3> size{norm(one.normal[k]), norm(two.normal[k]), norm(three.normal[k])};
    double cosine = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double length = norm(direction[i]);
      if (length <= roundings * size[i] * size[(i + 1) % 3]) return most;
      direction[i] = ((dot(direction[i], centre - cell_[k]) < 0 ? -1 : 1) / length) * direction[i];
      cosine = std::max(cosine, std::abs(dot(direction[i], geometry_.receiver_normal)));
    }
    largest = std::max(largest, solid_angle(direction) * cosine);
  }
  return std::min(largest, most);
}

void SightEvents::find_lines(CellSight& out) {
  for (std::size_t i = 0; i < out.screens.size(); ++i) {
    const Screen& screen = geometry_.screens[out.screens[i]];
    if (facing_[i] != both) continue;
    unsigned found = none;
    for (const Point& q : geometry_.source) {
      const double height = dot(screen.normal, q - screen.corners[0]);
      if (std::abs(height) > roundings) found |= height > 0 ? positive : negative;
    }
    if (found != both) continue;
    // What changes is at most what this screen hides.
    double largest = 0;
    for (const Point& p : cell_)
      largest = std::max(largest, std::abs(polygon_flux(screen.corners, p, geometry_.receiver_normal)));
    largest = std::min(largest, out.unoccluded);
    out.lines.push_back({screen.normal, screen.corners[0], largest});
    out.change += largest;
  }
  const std::size_t source_sides = geometry_.source.size();
  constexpr std::size_t enough = 8;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const Corner& corner = corners_[c];
    if (corner.apart || corner.sides.empty()) continue;
    if (out.lines.size() >= enough && out.change >= out.unoccluded) return;
    if (corner.solid != of_source) {
      bool outside = false;
      for (std::size_t g = 0; g < source_sides && !outside; ++g) outside = sign(g, c) == positive;
      if (outside) continue;
    }
    for (std::size_t e = 0; e < sides_.size(); ++e) {
      const Side& side = sides_[e];
      if (side.hidden || side.solid == corner.solid || sign(e, c) != both || !passes_within(corner, side))
        continue;
      double largest = corner.sides.size() < 2 ? out.unoccluded : 0;
      for (std::size_t i = 0; i < corner.sides.size(); ++i)
        for (std::size_t j = i + 1; j < corner.sides.size(); ++j)
          largest = std::max(largest,
                             change(sides_[corner.sides[i]], sides_[corner.sides[j]], side, out.unoccluded));
      out.lines.push_back(
          {cross(corners_[side.from].at - corner.at, corners_[side.to].at - corner.at), corner.at, largest});
      out.change += largest;
    }
  }
}

bool SightEvents::may_cross(std::size_t one, std::size_t other) {
  const auto part = [&](std::size_t side, std::size_t ends) {
    return (sign(side, sides_[ends].from) | sign(side, sides_[ends].to)) != both;
  };
  return !part(one, other) && !part(other, one);
}

/// Whether det(m_1, m_2, m_3) may be 0 inside the cell, by its Bernstein coefficients.
bool SightEvents::may_meet(const Side& one, const Side& two, const Side& three) const {
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k)
    size = std::max(size, norm(one.normal[k]) * norm(two.normal[k]) * norm(three.normal[k]));
  unsigned found = none;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a; b < 3; ++b)
      for (std::size_t c = b; c < 3; ++c) {
        const auto term = [&](std::size_t i, std::size_t j, std::size_t k) {
          return determinant(one.normal[i], two.normal[j], three.normal[k]);
        };
        const double coefficient =
            term(a, b, c) + term(a, c, b) + term(b, a, c) + term(b, c, a) + term(c, a, b) + term(c, b, a);
        if (std::abs(coefficient) > roundings * size) found |= coefficient > 0 ? positive : negative;
      }
  return found == both;
}

void SightEvents::find_curves(CellSight& out) {
  const std::size_t count = sides_.size();
  std::vector<std::vector<std::size_t>> crossing(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (!sides_[i].hidden && !sides_[j].hidden && sides_[i].solid != sides_[j].solid && may_cross(i, j))
        crossing[i].push_back(j);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t a = 0; a < crossing[i].size(); ++a)
      for (std::size_t b = a + 1; b < crossing[i].size(); ++b) {
        const std::size_t j = crossing[i][a];
        const std::size_t k = crossing[i][b];
        if (!std::binary_search(crossing[j].begin(), crossing[j].end(), k)) continue;
        if (!may_meet(sides_[i], sides_[j], sides_[k])) continue;
        out.change += change(sides_[i], sides_[j], sides_[k], out.unoccluded);
        if (out.change >= out.unoccluded) return;
      }
}

CellSight SightEvents::of(const ReceiverCell& cell, const std::vector<std::size_t>& screens) {
  CellSight out;
  cell_ = {cell[0], cell[1], cell[2], (1.0 / 3) * (cell[0] + cell[1] + cell[2])};
  for (const Point& p : cell_)
    out.unoccluded = std::max(out.unoccluded, polygon_flux(geometry_.source, p, geometry_.receiver_normal));
  add_corners_of_source();
  if (list_screens(screens, out)) {
    out.hidden = true;
    return out;
  }
  if (out.screens.empty()) return out;
  // Sides of one solid stand together.
  find_sides(out);
  std::stable_sort(sides_.begin() + static_cast<std::ptrdiff_t>(geometry_.source.size()), sides_.end(),
                   [](const Side& a, const Side& b) { return a.solid < b.solid; });
  if (body_hides()) {
    out.hidden = true;
    return out;
  }
  mark_hidden();
  drop_sides_apart();
  signs_.clear();
  find_lines(out);
  if (out.change < out.unoccluded) find_curves(out);
  return out;
}

}  // namespace radcert
