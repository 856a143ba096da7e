// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/cut/segment_arrangement.h"

#include <algorithm>
#include <map>
#include <set>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

using Point = ParameterPoint<Rational>;

struct Before {
  bool operator()(const Point& a, const Point& b) const { return a.s != b.s ? a.s < b.s : a.t < b.t; }
};
using Points = std::set<Point, Before>;

/// Whether a point of the segment's line lies between its ends, ends included.
bool between_ends(const Point& p, const PlaneSegment& segment) {
  const Before before;
  const auto [low, high] = before(segment.to, segment.from) ? std::pair(segment.to, segment.from)
                                                            : std::pair(segment.from, segment.to);
  return !before(p, low) && !before(high, p);
}

/// The points in which two segments meet, on both: where they cross or touch, or the ends of what they share.
void meet(const PlaneSegment& a, Points& on_a, const PlaneSegment& b, Points& on_b) {
  const Point along_a = a.to - a.from;
  const Point along_b = b.to - b.from;
  const Rational turn = cross(along_a, along_b);
  const Rational height = cross(along_a, b.from - a.from);
  if (turn.sign() == 0) {
    if (height.sign() != 0) return;
    for (const Point& end : {b.from, b.to})
      if (between_ends(end, a)) on_a.insert(end);
    for (const Point& end : {a.from, a.to})
      if (between_ends(end, b)) on_b.insert(end);
    return;
  }
  const Rational part_a = cross(b.from - a.from, along_b) / turn;
  const Rational part_b = -height / turn;
  const auto within = [](const Rational& part) { return part.sign() >= 0 && part <= Rational(1); };
  if (!within(part_a) || !within(part_b)) return;
  const Point at = a.from + part_a * along_a;
  on_a.insert(at);
  on_b.insert(at);
}

}  // namespace

SegmentArrangement segment_arrangement(std::span<const PlaneSegment> segments) {
  std::vector<Points> on(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    expects(!(segments[i].from == segments[i].to), "segments of a length", named("segment", i));
    on[i].insert(segments[i].from);
    on[i].insert(segments[i].to);
  }
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = i + 1; j < segments.size(); ++j) meet(segments[i], on[i], segments[j], on[j]);
  std::map<Point, std::size_t, Before> place;
  for (const Points& points : on)
    for (const Point& point : points) place.try_emplace(point, 0);
  SegmentArrangement result;
  for (auto& [point, number] : place) {
    number = result.points.size();
    result.points.push_back(point);
  }
  std::set<std::pair<std::size_t, std::size_t>> parts;
  for (const Points& points : on)
    for (auto at = points.begin(), next = std::next(at); next != points.end(); ++at, ++next)
      parts.emplace(place.at(*at), place.at(*next));
  result.segments.assign(parts.begin(), parts.end());
  return result;
}

}  // namespace radcert
