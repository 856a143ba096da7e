// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/convex_hull.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace radcert {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

CGAL::Gmpq gmpq(const Rational& x) { return CGAL::Gmpq(static_cast<mpq_srcptr>(x.gmp())); }

Rational rational(const CGAL::Gmpq& x) { return Rational::from_gmp(x.mpq()); }

}  // namespace

PolygonLoop convex_hull(std::span<const ParameterPoint<Rational>> points) {
  std::vector<Kernel::Point_2> all;
  all.reserve(points.size());
  for (const ParameterPoint<Rational>& at : points) all.emplace_back(gmpq(at.s), gmpq(at.t));
  std::vector<Kernel::Point_2> hull;
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(hull));
  PolygonLoop loop;
  for (const Kernel::Point_2& at : hull) loop.push_back({rational(at.x()), rational(at.y())});
  return loop;
}

Rational signed_area(std::span<const ParameterPoint<Rational>> loop) {
  Rational sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += cross(loop[i], loop[(i + 1) % loop.size()]);
  return sum / Rational(2);
}

}  // namespace radcert
