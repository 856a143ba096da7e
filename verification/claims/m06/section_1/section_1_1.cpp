// SPDX-License-Identifier: GPL-3.0-or-later

// Three statements in words of section 1.1.
//
// The reflectivity: a surface whose reflection distribution function is a constant f gives back f Int cos
// theta d omega = pi f of the light that arrives, over the half sphere of directions. (1) gives back rho, as
// (rho/pi) Int G dS = rho. So f = rho/pi; with f = rho a surface with rho = 1/2 would give back more than it
// receives.
//
// V: to the letter the segment between two points of a plane piece lies in S, and so does that between two
// points of a ruling of the roof z = 2 - x^2: V = 0 there. But there G = 0, so that G V = G, which is what
// (1) needs. On the sphere no three points are on a line.
//
// "G has a singularity at P = Q": on the roof of two_piece(2) G tends to 1/(1 + 4x^2)^3 along x and to 0
// along y, so that it has no continuous value. On the unit sphere, G = 1/4, and on a plane, G = 0, there is
// nothing of the kind. Elsewhere G is smooth, a quotient with the denominator |P-Q|^4.
//
// Checked      the integral of the cosine, enclosed; pairs of a grid of points of the square, of the roof and
//              of the sphere, exactly, by the middle of their segment; the two limits on the roof, by the
//              library's chords along rays; pairs on the sphere and on a plane face. Rejected: a reflection
//              without the cosine; pairs of the sphere of which one is moved inside; two ways to a point Q
//              other than P.
// Not checked  other surfaces and points.

#include "radcert/enclosure/interval_integral.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "verification/claims/ac98/surfaces/sample_points.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// The share of the light that arrives which a constant distribution function gives back: 2 pi f Int_0^(pi/2)
// cos theta sin theta d theta, or without the cosine.
Ball given_back(const Ball& f, bool with_cosine) {
  const auto formula = line_function([with_cosine]<class R>(const R& theta) -> R {
    return with_cosine ? cos(theta) * sin(theta) : sin(theta);
  });
  const Ball right_angle = Ball::pi() / Ball(2);
  return Ball(2) * Ball::pi() * f *
         known(integral_on_interval(formula, Ball(0), right_angle, {.radius = 1e-25}));
}

// By a name: a point, its inner normal up to a positive factor.
struct SurfacePair {
  Vector<Rational> point;
  Vector<Rational> normal;
};

std::vector<SurfacePair> points_of_square() {
  std::vector<SurfacePair> points;
  for (long i = 1; i < 5; ++i)
    for (long j = 1; j < 5; ++j) points.push_back({{Rational(i, 5), Rational(j, 5), 0}, {0, 0, 1}});
  return points;
}

std::vector<SurfacePair> points_of_roof() {
  std::vector<SurfacePair> points = points_of_square();
  for (auto& [point, normal] : points) {
    normal = {-2 * point.x, 0, -1};
    point.z = 2 - point.x * point.x;
  }
  return points;
}

std::vector<SurfacePair> points_of_sphere() {
  std::vector<SurfacePair> points;
  for (long i = -2; i <= 2; ++i)
    for (long j = -2; j <= 2; ++j) {
      const Vector<Rational> p = ac98::sphere_point(Rational(i, 2), Rational(j, 3));
      points.push_back({p, -p});
    }
  return points;
}

// Pairs whose segment has its middle on the surface, and those of them with G != 0.
struct Hidden {
  Rational pairs = 0;
  Rational with_kernel = 0;
};
template <class OnSurface>
Hidden hidden(const std::vector<SurfacePair>& points, const OnSurface& on_surface) {
  Hidden count;
  for (const SurfacePair& p : points)
    for (const SurfacePair& q : points) {
      if (p.point == q.point || !on_surface(Rational(1, 2) * (p.point + q.point))) continue;
      count.pairs += 1;
      if (geometric_kernel(p.point, p.normal, q.point, q.normal) != 0) count.with_kernel += 1;
    }
  return count;
}

bool on_square(const Vector<Rational>& p) { return p.z == 0; }
bool on_roof(const Vector<Rational>& p) { return p.z == 2 - p.x * p.x; }
bool on_sphere(const Vector<Rational>& p) { return dot(p, p) == 1; }

// G at the distance `step` along x less that along y, from the point (1/3, 1/5) of the chart; at step 0 the
// limits.
Ball difference_along(const Surface& surface, std::size_t chart, const Ball& step) {
  const ChartIn<Ball>& formula = surface.charts[chart].in<Ball>();
  const ParameterPoint<Ball> at{Ball(Rational(1, 3)), Ball(Rational(1, 5))};
  const Vector<Ball> normal = unit_normal(formula.frame(at));
  const auto along = [&](const ParameterPoint<Ball>& direction) {
    const Vector<Ball> other = unit_normal(formula.frame(at + step * direction));
    return chord_kernel(formula.chord_along(at, direction, step), normal, other);
  };
  return along({Ball(1), Ball(0)}) - along({Ball(0), Ball(1)});
}

// G from P = (1/3, 1/5) to points near Q = (2/3, 3/5), 2^-40 along x and along y: their difference.
Ball difference_apart(const Surface& surface, std::size_t chart) {
  const ChartIn<Ball>& formula = surface.charts[chart].in<Ball>();
  const Rational step = 1 / power(Rational(2), 40);
  const Frame<Ball> p = formula.frame({Ball(Rational(1, 3)), Ball(Rational(1, 5))});
  const auto kernel = [&](const Rational& s, const Rational& t) {
    const Frame<Ball> q = formula.frame({Ball(s), Ball(t)});
    return geometric_kernel(p.point, unit_normal(p), q.point, unit_normal(q));
  };
  return kernel(Rational(2, 3) + step, Rational(3, 5)) - kernel(Rational(2, 3), Rational(3, 5) + step);
}

}  // namespace

Finding section_1_1_reflectivity(const Bench&) {
  const BallPrecision precision(128);
  const AgreesWith zero{.value = Ball(0), .within = 1e-20};
  const Ball rho(Rational(1, 2));
  Finding finding;
  finding.require("share given back less rho, the distribution function being rho = 1/2", zero,
                  given_back(rho, true) - rho);
  finding.instead("share given back less rho, the distribution function being rho/pi", zero,
                  given_back(rho / Ball::pi(), true) - rho);
  finding.control("the same without the cosine", zero, given_back(rho / Ball::pi(), false) - rho);
  finding.show(proved(given_back(rho, true)));
  return finding;
}

Finding section_1_1_visibility(const Bench&) {
  const IsExactly none{0};
  const Hidden square = hidden(points_of_square(), on_square);
  const Hidden roof = hidden(points_of_roof(), on_roof);
  const Hidden sphere = hidden(points_of_sphere(), on_sphere);
  std::vector<SurfacePair> moved = points_of_sphere();
  for (SurfacePair& each : moved) each.point = Rational(1, 2) * each.point;
  Finding finding;
  finding.require("pairs of points of the square of two_piece with V = 0 to the letter", none, square.pairs);
  finding.require("pairs of points of the roof of two_piece(2) with V = 0 to the letter", none, roof.pairs);
  finding.instead("those of the square with G != 0", none, square.with_kernel);
  finding.instead("those of the roof with G != 0", none, roof.with_kernel);
  finding.instead("pairs of points of the sphere with V = 0 to the letter", none, sphere.pairs);
  finding.control("pairs of points of the sphere that a cube of side 1/2 at its centre obstructs", none,
                  hidden(points_of_sphere(), [](const Vector<Rational>& p) {
                    const Rational quarter(1, 4);
                    return abs(p.x) <= quarter && abs(p.y) <= quarter && abs(p.z) <= quarter;
                  }).with_kernel);
  return finding;
}

Finding section_1_1_singularity(const Bench&) {
  const BallPrecision precision(192);
  const AtMost jumps{.value = -0x1p-20, .slack = 0, .why = ""};
  const Surface pieces = two_piece(2);
  const Surface ball = sphere();
  Finding finding;
  const Ball roof = difference_along(pieces, 1, Ball(0));
  finding.require("limit of G along y less that along x at a point of the roof", jumps, proved(-roof));
  finding.require("the same at a point of the unit sphere", jumps,
                  proved(-difference_along(ball, 0, Ball(0))));
  finding.instead("limit along x at (1/3, 1/5) of the roof less 1/(1 + 4x^2)^3",
                  AgreesWith{.value = power(Ball(Rational(9, 13)), 3), .within = 1e-30}, roof);
  finding.control("G along y less G along x at the distance 1/4 of a point of the roof",
                  AgreesWith{.value = power(Ball(Rational(9, 13)), 3), .within = 1e-30},
                  difference_along(pieces, 1, Ball(Rational(1, 4))));
  finding.control("G to points near Q, other than P, along y less along x, on the roof", jumps,
                  proved(-difference_apart(pieces, 1)));
  finding.show(proved(roof));
  return finding;
}

}  // namespace radcert::verification::m06
