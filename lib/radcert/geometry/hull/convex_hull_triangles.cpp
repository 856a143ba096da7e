// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/hull/convex_hull_triangles.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cstddef>

namespace radcert {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Point = Kernel::Point_3;

CGAL::Gmpq gmpq(const Rational& x) { return CGAL::Gmpq(static_cast<mpq_srcptr>(x.gmp())); }

Vector<Rational> vector_of(const Point& p) {
  return {Rational::from_gmp(p.x().mpq()), Rational::from_gmp(p.y().mpq()), Rational::from_gmp(p.z().mpq())};
}

}  // namespace

std::vector<std::array<Vector<Rational>, 3>> convex_hull_triangles(std::span<const Vector<Rational>> points) {
  std::vector<Point> all;
  all.reserve(points.size());
  for (const Vector<Rational>& p : points) all.emplace_back(gmpq(p.x), gmpq(p.y), gmpq(p.z));
  CGAL::Surface_mesh<Point> hull;
  CGAL::convex_hull_3(all.begin(), all.end(), hull);
  std::vector<std::array<Vector<Rational>, 3>> triangles;
  if (hull.number_of_faces() < 4) return triangles;
  for (const auto face : hull.faces()) {
    std::array<Vector<Rational>, 3> corners;
    // CGAL's run counterclockwise as seen from outside.
    std::size_t k = corners.size();
    for (const auto vertex : hull.vertices_around_face(hull.halfedge(face)))
      corners[--k] = vector_of(hull.point(vertex));
    triangles.push_back(std::move(corners));
  }
  return triangles;
}

}  // namespace radcert
