// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/plane_polygon.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

#include "radcert/geometry/plane.h"

namespace radcert {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Points = std::vector<Kernel::Point_2>;

CGAL::Gmpq gmpq(const Rational& x) { return CGAL::Gmpq(static_cast<mpq_srcptr>(x.gmp())); }

Kernel::Point_2 point_of(const ParameterPoint<Rational>& at) { return {gmpq(at.s), gmpq(at.t)}; }

Points points_of(std::span<const ParameterPoint<Rational>> loop) {
  Points points;
  points.reserve(loop.size());
  for (const ParameterPoint<Rational>& at : loop) points.push_back(point_of(at));
  return points;
}

Kernel::Segment_2 edge(const Points& loop, std::size_t i) { return {loop[i], loop[(i + 1) % loop.size()]}; }

std::string place(std::size_t loop) { return "loop " + std::to_string(loop); }

std::string numbers(std::size_t a, std::size_t b) { return std::to_string(a) + " and " + std::to_string(b); }

/// The first two edges that meet elsewhere than neighbours do, in a loop that is not simple.
std::string crossing(const Points& loop) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool follows = j == i + 1;
      const bool precedes = i == 0 && j + 1 == n;
      if (!follows && !precedes) {
        if (CGAL::do_intersect(edge(loop, i), edge(loop, j))) return "edges " + numbers(i, j) + " meet";
        continue;
      }
      // Neighbours share a corner; more only if one runs back over the other.
      const Kernel::Point_2& far_of_i = follows ? loop[i] : loop[1];
      const Kernel::Point_2& far_of_j = follows ? loop[(j + 1) % n] : loop[j];
      if (edge(loop, j).has_on(far_of_i) || edge(loop, i).has_on(far_of_j))
        return "edges " + numbers(i, j) + " overlap";
    }
  return "it meets itself";
}

/// What is wrong with one loop by itself.
std::optional<std::string> fault(const PolygonLoop& loop) {
  if (loop.size() < 3) return std::to_string(loop.size()) + " vertices, three are needed";
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t next = (i + 1) % loop.size();
    if (loop[i] == loop[next]) return "vertices " + numbers(i, next) + " are the same point";
  }
  const Points points = points_of(loop);
  // Beside crossings this excludes the area 0, with which edges overlap.
  if (!CGAL::is_simple_2(points.begin(), points.end(), Kernel())) return crossing(points);
  return std::nullopt;
}

/// Whether boundaries have a point in common.
bool touch(const Points& a, const Points& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (CGAL::do_intersect(edge(a, i), edge(b, j))) return true;
  return false;
}

bool in_closed(const Points& polygon, const Kernel::Point_2& point) {
  return CGAL::bounded_side_2(polygon.begin(), polygon.end(), point, Kernel()) != CGAL::ON_UNBOUNDED_SIDE;
}

/// Whether `inner`, whose boundary does not touch that of `outer`, lies inside it.
bool inside(const Points& inner, const Points& outer) { return in_closed(outer, inner.front()); }

std::optional<std::string> fault(const std::vector<PolygonLoop>& loops) {
  if (loops.empty()) return "no loop";
  std::vector<Points> points;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (const std::optional<std::string> wrong = fault(loops[k])) return place(k) + ": " + *wrong;
    points.push_back(points_of(loops[k]));
  }
  for (std::size_t k = 1; k < loops.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l)
      if (touch(points[k], points[l])) return place(k) + " touches " + place(l);
    if (!inside(points[k], points[0])) return place(k) + " lies outside of loop 0";
    for (std::size_t l = 1; l < k; ++l)
      if (inside(points[k], points[l]) || inside(points[l], points[k]))
        return place(k) + " and " + place(l) + " lie one inside the other";
  }
  return std::nullopt;
}

}  // namespace

PolygonLoop convex_hull(std::span<const ParameterPoint<Rational>> points) {
  const Points all = points_of(points);
  Points hull;
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(hull));
  PolygonLoop loop;
  for (const Kernel::Point_2& at : hull)
    loop.push_back({Rational::from_gmp(at.x().mpq()), Rational::from_gmp(at.y().mpq())});
  return loop;
}

Rational doubled_area(std::span<const ParameterPoint<Rational>> loop) {
  Rational sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += cross(loop[i], loop[(i + 1) % loop.size()]);
  return sum;
}

ParameterPoint<Rational> coordinates(const Vector<Rational>& p, const Vector<Rational>& first,
                                     const Vector<Rational>& second) {
  const Vector<Rational> normal = cross(first, second);
  const Rational scale = dot(normal, normal);
  return {dot(cross(p, second), normal) / scale, dot(cross(first, p), normal) / scale};
}

bool contains(std::span<const ParameterPoint<Rational>> polygon, const ParameterPoint<Rational>& point) {
  return in_closed(points_of(polygon), point_of(point));
}

Rational PlanePolygon::parameter_area() const {
  Rational sum = 0;
  for (const PolygonLoop& loop : loops_) sum += doubled_area(loop);
  return sum / Rational(2);
}

Outcome<PlanePolygon> plane_polygon(const Vector<Rational>& origin, const Vector<Rational>& first,
                                    const Vector<Rational>& second, std::vector<PolygonLoop> loops) {
  if (is_zero(cross(first, second))) return because("the two directions are parallel and span no plane");
  if (const std::optional<std::string> wrong = fault(loops)) return because(*wrong);
  for (std::size_t k = 0; k < loops.size(); ++k)
    if ((doubled_area(loops[k]).sign() > 0) != (k == 0)) std::reverse(loops[k].begin(), loops[k].end());
  PlanePolygon polygon;
  polygon.origin_ = origin;
  polygon.first_ = first;
  polygon.second_ = second;
  polygon.loops_ = std::move(loops);
  return polygon;
}

Outcome<PlanePolygon> plane_polygon(const std::vector<Vector<Rational>>& corners) {
  if (corners.size() < 3) return because(std::to_string(corners.size()) + " corners, three are needed");
  const Vector<Rational> origin = corners[0];
  const Vector<Rational> first = corners[1] - origin;
  if (is_zero(first)) return because("corners 0 and 1 are the same point");
  std::size_t off_the_line = 2;
  while (off_the_line < corners.size() && is_zero(cross(first, corners[off_the_line] - origin)))
    ++off_the_line;
  if (off_the_line == corners.size()) return because("all corners lie on one line");
  Vector<Rational> second = corners[off_the_line] - origin;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (dot(cross(first, second), corners[i] - origin).sign() != 0)
      return because("corner " + std::to_string(i) + " does not lie in the plane of the corners 0, 1 and " +
                     std::to_string(off_the_line));
  PolygonLoop loop;
  for (const Vector<Rational>& corner : corners) loop.push_back(coordinates(corner - origin, first, second));
  // Counterclockwise as given: a clockwise loop means the other side of the plane.
  if (doubled_area(loop).sign() < 0) {
    second = -second;
    for (ParameterPoint<Rational>& at : loop) at.t = -at.t;
  }
  return plane_polygon(origin, first, second, {std::move(loop)});
}

}  // namespace radcert
