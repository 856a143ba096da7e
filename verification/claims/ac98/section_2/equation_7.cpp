// SPDX-License-Identifier: GPL-3.0-or-later

// Omega has to be bounded, which the divergence theorem is asked to imply: with the boundary of a quarter
// space in place of S, P in one of its faces at the distance 1 from the edge, the other face is all there is
// and the integral is pi/2; with a half space it is 0.
//
// Checked      Int_S G = pi on all ellipsoids for all P, and on all bounded convex polyhedra for all P off
//              the edges: G dS_Q is n_P.w dw for the direction w, and each w with n_P.w > 0 meets S once, as
//              in lemma_2_1. Besides G >= 0 for all pairs of points of cube, tetrahedron and octahedron,
//              exactly, and Int_S G there at random rational points, some within a millionth of an edge, to
//              50 digits, by the closed form of a polygon; on the sphere, the ellipsoid (1,2,5) and the
//              closed body under two_piece(2), a square, a curved roof, two walls with curved tops and two
//              plane ones, to 20 digits by enclosed double integrals over the charts, P on one of them. The
//              hypotheses: a point of an edge, an open box, a quarter space.
// Not checked  other bodies, and other points of the body under two_piece(2): the proof is that of the paper,
//              its steps are (8) to (12).

#include <algorithm>
#include <random>

#include "radcert/enclosure/kernel_integral.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "verification/claims/ac98/convex_bodies/convex_polyhedra.h"
#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/claims/ac98/surfaces/solid_angle.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// F(s,t) = (s, y, t (2 - s^p)).
template <Field R>
class CurvedWall {
public:
  CurvedWall(const Rational& p, const Rational& y) : p_(p), y_(from_rational<R>(y)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    return {s, y_ + R(0) * s, t * (R(2) - power(s, p_))};
  }

private:
  Exponent<R> p_;
  R y_;
};

// The body between the two pieces of two_piece(p), with its walls.
Surface closed_two_piece(const Rational& p) {
  Surface surface = two_piece(p);
  surface.name = "the body under two_piece(" + p.to_text() + ")";
  for (const int y : {0, 1}) {
    ChartFacts facts{.name = "wall_y" + std::to_string(y),
                     .piece = "wall_y" + std::to_string(y),
                     .orientation = y == 0 ? Orientation::against_the_cross_product
                                           : Orientation::along_the_cross_product};
    facts.plane_of_disk = Plane({0, y, 0}, {1, 0, 0}, {0, 0, 1});
    surface.charts.push_back(make_chart<CurvedWall>(std::move(facts), p, Rational(y)));
  }
  surface.charts.push_back(
      make_rectangle({.name = "wall_x0", .piece = "wall_x0"}, {0, 0, 0}, {0, 1, 0}, {0, 0, 2}));
  surface.charts.push_back(make_rectangle(
      {.name = "wall_x1", .piece = "wall_x1", .orientation = Orientation::against_the_cross_product},
      {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

// Rational points inside the domain of a chart.
std::vector<ParameterPoint<Rational>> random_parameters(ChartDomain domain, std::size_t count,
                                                        std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  const auto part = [&] { return Rational(static_cast<long>(bits() % 97) + 2, 100); };
  std::vector<ParameterPoint<Rational>> points;
  while (points.size() < count) {
    const ParameterPoint<Rational> at{part(), part()};
    if (domain == ChartDomain::unit_square || at.s + at.t < Rational(99, 100)) points.push_back(at);
  }
  return points;
}

Ball total(const Surface& surface, std::size_t chart, const ParameterPoint<Rational>& at, double radius) {
  return known(kernel_integral(ExactObserver::on_surface({{.chart = chart, .at = at}}), surface,
                               unit_density(), {.radius = radius}));
}

struct CurvedCase {
  Surface surface;
  std::vector<std::size_t> charts;  ///< where P is taken
};

// From (1,0,0) to the square 0 <= z <= L, |y| <= L of the plane x = 0. Beyond it G = z/|Q-P|^4 <= r^-3, whose
// integral is at most 2/L.
Ball over_a_quarter_space(const Rational& side) {
  const PlanePolygon wall =
      plane_polygon({{0, -side, 0}, {0, side, 0}, {0, side, side}, {0, -side, side}}).value();
  PlanePolynomial<Rational> one(0);
  one(0, 0) = 1;
  const Ball part = point_to_polygon({1, 0, 0}, {0, 0, 1}, wall, one);
  return hull(part, part + Ball(2 / side));
}

void require_on_polyhedra(Finding& finding, std::size_t per_face) {
  const BallPrecision precision(256);
  const AgreesWith pi{.value = Ball::pi(), .within = 1e-50};
  const Rational radius = Rational(1) / power(Rational(10), 52);
  for (const Polyhedron& body : {cube_polyhedron(), tetrahedron(), octahedron()}) {
    finding.require("corners behind a face, " + body.name, IsExactly{0}, corners_behind_faces(body));
    Polyhedron turned = body;
    std::vector<Vector<Rational>> corners;
    const PlanePolygon& first = body.faces.front();
    for (const ParameterPoint<Rational>& at : first.loops().front()) corners.push_back(first.point(at));
    std::reverse(corners.begin(), corners.end());
    turned.faces.front() = plane_polygon(corners).value();
    finding.control("corners behind a face, one face turned over, " + body.name, IsExactly{0},
                    corners_behind_faces(turned));
    Ball all = Ball::pi();
    for (std::size_t face = 0; face < body.faces.size(); ++face)
      for (const Vector<Rational>& p : random_face_points(body.faces[face], per_face, 700 + face))
        all = hull(all, total_factor(body, face, p, radius));
    finding.require(
        "integral of G, the hull over " + std::to_string(per_face) + " points of each face, " + body.name, pi,
        all);
  }
  const Polyhedron cube = cube_polyhedron();
  Polyhedron open = cube;
  open.faces.pop_back();
  const Rational third(1, 3);
  finding.control("integral of G, the cube without one wall", pi,
                  total_factor(open, floor_face, {third, third, 0}, radius));
  // Without its last face, x = 0, which contains P as well.
  finding.control("integral of G from the edge x = z = 0 of the cube with the normal of z = 0", pi,
                  total_factor(open, floor_face, {0, third, 0}, radius));
}

}  // namespace

Finding equation_7(const Bench& bench) {
  const bool quick = bench.budget == Budget::quick;
  const double radius = bench.budget == Budget::full ? 1e-25 : 1e-20;
  const std::size_t per_chart = quick ? 1 : 2;
  Finding finding;
  require_kernel_by_directions(finding);
  require_convex_ellipsoids(finding);
  require_rays_leave_polyhedra_once(finding);
  require_on_polyhedra(finding, quick ? 6 : 60);
  const BallPrecision precision(192);
  const AgreesWith pi{.value = Ball::pi(), .within = 2 * radius};
  for (const CurvedCase& each : {CurvedCase{.surface = sphere(), .charts = {0}},
                                 CurvedCase{.surface = ellipsoid(1, 2, 5), .charts = {0}},
                                 CurvedCase{.surface = closed_two_piece(2), .charts = {0, 1, 2}}})
    for (const std::size_t chart : each.charts) {
      const ChartFacts& facts = each.surface.charts[chart].facts();
      for (const ParameterPoint<Rational>& at : random_parameters(facts.domain, per_chart, 70 + chart))
        finding.require("integral of G, " + each.surface.name + ", " + facts.name + " at (" + at.s.to_text() +
                            ", " + at.t.to_text() + ")",
                        pi, total(each.surface, chart, at, radius));
    }
  Surface without_a_wall = closed_two_piece(2);
  without_a_wall.charts.pop_back();
  finding.control("integral of G, the body under two_piece(2) without the wall x = 1", pi,
                  total(without_a_wall, 0, {Rational(1, 2), Rational(1, 2)}, radius));
  const Ball quarter = over_a_quarter_space(1000000);
  finding.control("integral of G, a quarter space", pi, quarter);
  finding.remark("integral of G, a quarter space", proved(quarter));
  return finding;
}

}  // namespace radcert::verification::ac98
