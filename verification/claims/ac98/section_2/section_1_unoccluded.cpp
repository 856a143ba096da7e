// SPDX-License-Identifier: GPL-3.0-or-later

// "V(P,Q) = 1 if the straight line segment from P to Q does not intersect S at any other point, and 0
// otherwise; unoccluded is V = 1 on S; the interior surface of a convex solid is unoccluded." Between two
// points of one face of a cube the segment lies in S: V = 0 to the letter. There G = 0, so that G V = G all
// the same, which is what (1) needs. A convex solid without a segment in its surface, such as a ball, is
// unoccluded to the letter.
//
// Checked      section_1_unoccluded: on the unit cube and the unit sphere, for rational points in pairs, in
//              exact arithmetic, whether the points at 1/4, 1/2 and 3/4 of the segment are inside, and G
//              where they are not. section_1_unoccluded_kernel: for all P and Q off the edges of all convex
//              polyhedra, V = 1 between different faces and G = 0 within one, convex_polyhedra.h. That cube,
//              box, tetrahedron and octahedron are such: no corner is behind a face, and no two faces are in
//              one plane. On all ellipsoids the segment is inside, solid_angle.h.
// Not checked  other solids.

#include <string>
#include <vector>

#include "radcert/kernel/geometric_kernel.h"
#include "verification/claims/ac98/convex_bodies/convex_polyhedra.h"
#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/claims/ac98/surfaces/sample_points.h"
#include "verification/claims/ac98/surfaces/solid_angle.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

struct SolidPoint {
  Vector<Rational> point;
  Vector<Rational> normal;
};

std::vector<SolidPoint> cube_points() {
  std::vector<SolidPoint> points;
  const Rational third(1, 3);
  const Rational fifth(1, 5);
  for (const Rational& s : {fifth, third, 1 - fifth})
    for (const Rational& t : {third, 1 - third}) {
      points.push_back({{s, t, 0}, {0, 0, 1}});
      points.push_back({{s, t, 1}, {0, 0, -1}});
      points.push_back({{0, s, t}, {1, 0, 0}});
      points.push_back({{1, s, t}, {-1, 0, 0}});
      points.push_back({{s, 0, t}, {0, 1, 0}});
      points.push_back({{s, 1, t}, {0, -1, 0}});
    }
  return points;
}

std::vector<SolidPoint> sphere_points() {
  std::vector<SolidPoint> points;
  for (long i = -2; i <= 2; ++i)
    for (long j = -2; j <= 2; ++j) {
      const Vector<Rational> p = sphere_point(Rational(i, 2), Rational(j, 3));
      points.push_back({p, -p});
    }
  return points;
}

bool inside_cube(const Vector<Rational>& p) {
  return 0 < p.x && p.x < 1 && 0 < p.y && p.y < 1 && 0 < p.z && p.z < 1;
}
bool inside_sphere(const Vector<Rational>& p) { return dot(p, p) < 1; }

// Pairs whose segment has a point that is not inside, and those among them where G is not 0.
struct Obstructed {
  Rational pairs = 0;
  Rational with_kernel = 0;
  Rational without_kernel = 0;
};
template <class Inside>
Obstructed obstructed(const std::vector<SolidPoint>& points, const Inside& inside) {
  Obstructed count;
  for (const SolidPoint& p : points)
    for (const SolidPoint& q : points) {
      if (p.point == q.point) continue;
      const bool open = inside(Rational(1, 4) * (3 * p.point + q.point)) &&
                        inside(Rational(1, 2) * (p.point + q.point)) &&
                        inside(Rational(1, 4) * (p.point + 3 * q.point));
      if (open) continue;
      count.pairs += 1;
      if (geometric_kernel(p.point, p.normal, q.point, q.normal) == 0)
        count.without_kernel += 1;
      else
        count.with_kernel += 1;
    }
  return count;
}

// Faces all of whose corners are in the plane of another face.
Rational faces_in_one_plane(const Polyhedron& body) {
  long count = 0;
  for (std::size_t i = 0; i < body.faces.size(); ++i)
    for (std::size_t k = 0; k < body.faces.size(); ++k) {
      if (i == k) continue;
      const PlanePolygon& plane = body.faces[k];
      bool in_front = false;
      for (const ParameterPoint<Rational>& at : body.faces[i].loops().front())
        if (dot(body.faces[i].point(at) - plane.origin(), plane.normal()).sign() > 0) in_front = true;
      if (!in_front) ++count;
    }
  return {count};
}

}  // namespace

Finding section_1_unoccluded(const Bench&) {
  Finding finding;
  const Obstructed cube = obstructed(cube_points(), inside_cube);
  const Obstructed ball = obstructed(sphere_points(), inside_sphere);
  const IsExactly none{0};
  finding.require("pairs of points of the unit cube with V = 0 to the letter", none, cube.pairs);
  finding.require("those among them with G != 0", none, cube.with_kernel);
  finding.require("pairs of points of the unit sphere with V = 0 to the letter", none, ball.pairs);
  finding.control("pairs of points of the sphere that a smaller ball at its centre obstructs", none,
                  obstructed(sphere_points(), [](const Vector<Rational>& p) {
                    return inside_sphere(p) && !inside_sphere(Rational(4) * p);
                  }).pairs);
  return finding;
}

Finding section_1_unoccluded_kernel(const Bench&) {
  Finding finding;
  for (const Polyhedron& body : {cube_polyhedron(), box_polyhedron(1, 2, 5), tetrahedron(), octahedron()}) {
    finding.require("corners behind a face, " + body.name, IsExactly{0}, corners_behind_faces(body));
    finding.require("faces in the plane of another one, " + body.name, IsExactly{0},
                    faces_in_one_plane(body));
  }
  Polyhedron with_shelf = cube_polyhedron();
  const Rational quarter(1, 4);
  const Rational half(1, 2);
  const Rational three(3, 4);
  with_shelf.faces.push_back(
      plane_polygon(
          {{quarter, quarter, half}, {quarter, three, half}, {three, three, half}, {three, quarter, half}})
          .value());
  finding.control("corners behind a face, the cube with a shelf inside", IsExactly{0},
                  corners_behind_faces(with_shelf));
  Polyhedron cut = cube_polyhedron();
  cut.faces.push_back(plane_polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}).value());
  finding.control("faces in the plane of another one, the cube with half of its floor once more",
                  IsExactly{0}, faces_in_one_plane(cut));
  require_segments_in_polyhedra(finding);
  require_convex_ellipsoids(finding);
  return finding;
}

}  // namespace radcert::verification::ac98
