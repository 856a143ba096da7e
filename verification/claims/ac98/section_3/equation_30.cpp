// SPDX-License-Identifier: GPL-3.0-or-later

// (76) is (30) element by element. What the paper says of the parts that its factors play is another matter:
// the method interpolates u and leaves G and the area element alone, so that its error is the integral of G
// |D_s m x D_t m| (I - L) u(m). That is Lemmas 3.2 and
// 3.3 with f = u(m) and Phi = G |D_s m x D_t m|, and not with f = u |D_s m x D_t m| and Phi = G: for u = 1
// the method has no error. The hypotheses on F_j in Theorems 3.6 and 3.7, made for the printed parts, are one
// derivative more than f = u(m) needs.
//
// Checked      equation_30: on all plane triangles, for all f of degree 2 at most, as a polynomial identity
//              in the corners' coordinates, the left side by Green's formula. On five triangles of the sphere
//              the right side, an enclosed integral over sigma through the library's charts, is the left side
//              in closed form: the area, and the integrals of x, y, z as half the sum of the sides' angles
//              times their normals. equation_76: the sum over the elements, pulled back to sigma by product
//              rules but beside v_i, against the operator over the whole surface. equation_76_parts: K(I -
//              P_n)u in balls on the sphere, u = 1 and u = z^4, against both readings, each integrated.
// Not checked  other surfaces for (30).

#include <algorithm>
#include <cmath>

#include "radcert/enclosure/polygon_integral.h"
#include "radcert/expression/parse.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/ac98/collocation/sphere_collocation.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/exact_plane.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// What is integrated: 1, x, y or z.
enum class Factor { one, x, y, z };

// The integrand of (30) over sigma: the chart of the first octant is F(s,t) = e/|e|, e = (1-s-t, s, t), so
// that corners of the plane x + y + z = 1 have the parameters (y, z).
struct PulledBack {
  const Surface* surface;
  std::array<ParameterPoint<Rational>, 3> v;  // v_1, v_2, v_3
  Factor factor;
  bool with_area_element;

  template <class R>
  R operator()(const ParameterPoint<R>& at) const {
    const auto in = [](const ParameterPoint<Rational>& p) {
      return ParameterPoint<R>{from_rational<R>(p.s), from_rational<R>(p.t)};
    };
    const ParameterPoint<R> along_s = in(v[0] - v[2]);
    const ParameterPoint<R> along_t = in(v[1] - v[2]);
    const Frame<R> frame =
        surface->charts.front().template in<R>().frame(in(v[2]) + at.s * along_s + at.t * along_t);
    const Vector<R> by_s = along_s.s * frame.tangent_s + along_s.t * frame.tangent_t;
    const Vector<R> by_t = along_t.s * frame.tangent_s + along_t.t * frame.tangent_t;
    const R area = with_area_element ? norm(cross(by_s, by_t)) : R(1);
    if (factor == Factor::x) return area * frame.point.x;
    if (factor == Factor::y) return area * frame.point.y;
    if (factor == Factor::z) return area * frame.point.z;
    return area;
  }
};

Ball over_sigma(const Surface& sphere, const OctantTriangle& triangle, Factor factor, bool with_area_element,
                double radius) {
  std::array<ParameterPoint<Rational>, 3> v;
  for (std::size_t i = 0; i < 3; ++i) v.at(i) = {triangle.corners.at(i).y, triangle.corners.at(i).z};
  const PulledBack f{&sphere, v, factor, with_area_element};
  return known(integral_over_polygon(f, {{0, 0}, {1, 0}, {0, 1}}, {.radius = radius}));
}

// Int (x, y, z) dS over a triangle of great circles: half the sum of the sides' angles times the inner
// normals of their planes.
Vector<Ball> first_moment(const OctantTriangle& triangle) {
  std::array<Vector<Ball>, 3> v;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<Rational>& c = triangle.corners.at(i);
    v.at(i) = {Ball(c.x), Ball(c.y), Ball(c.z)};
  }
  const bool turned = certainly_negative(dot(v[0], cross(v[1], v[2])));
  Vector<Ball> sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<Ball>& a = v.at(i);
    const Vector<Ball>& b = v.at((i + 1) % 3);
    const Vector<Ball> normal = cross(a, b);
    const Ball sine = norm(normal);
    sum = sum + (atan(sine / dot(a, b)) / (Ball(2) * sine)) * normal;
  }
  return turned ? -sum : sum;
}

// |D_s m x D_t m| (I - L) u(m) over sigma, u = z^exponent, m = e/|e|, e the point of the triangle: the parts
// as they are in the method, with G = 1/4 left out. The values of an even u at the nodes are rational.
struct InterpolationError {
  std::array<Vector<Rational>, 3> corners;
  int exponent;
  Rational alpha;

  template <class R>
  R operator()(const ParameterPoint<R>& at) const {
    const std::array<R, 3> x{at.s, at.t, R(1) - at.s - at.t};
    Vector<R> e{R(0), R(0), R(0)};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<Rational>& corner = corners.at(i);
      e = e + x.at(i) * Vector<R>{from_rational<R>(corner.x), from_rational<R>(corner.y),
                                  from_rational<R>(corner.z)};
    }
    const R square = dot(e, e);
    R error = exponent == 0 ? R(1) : power(e.z * e.z / square, exponent / 2);
    for (std::size_t j = 0; j < 3; ++j) {
      Vector<Rational> node{0, 0, 0};
      for (std::size_t i = 0; i < 3; ++i) node = node + (i == j ? 1 - 2 * alpha : alpha) * corners.at(i);
      const Rational value = power(node.z * node.z / dot(node, node), exponent / 2);
      const R weight = (x.at(j) - from_rational<R>(alpha)) * from_rational<R>(1 / (1 - 3 * alpha));
      error = error - from_rational<R>(value) * weight;
    }
    const Rational area = abs(dot(corners[0], cross(corners[1], corners[2])));
    return from_rational<R>(area) * error / (square * norm(e));
  }
};

// K(I - P_n)u on the unit sphere for rho = 1, by the parts of the method.
Ball by_the_true_parts(const std::vector<OctantTriangle>& triangles, int exponent, const Rational& alpha) {
  constexpr int octants = 8;
  Ball sum(0);
  for (const OctantTriangle& triangle : triangles) {
    const InterpolationError f{triangle.corners, exponent, alpha};
    sum += known(integral_over_polygon(f, {{0, 0}, {1, 0}, {0, 1}}, {.radius = 1e-12}));
  }
  return Ball(octants) * sum / (Ball(4) * Ball::pi());
}

// The integrand of (76) over sigma for one element, as printed: G u |D_s m x D_t m|, by a product rule, with
// the area element of m or with that of the element's centroid throughout.
double pulled_back(const Surface& surface, const Frame<double>& p, const ParameterTriangle& element,
                   const reference::Density& u, int order, bool constant_area) {
  const ChartIn<double>& chart = surface.charts.at(element.chart).in<double>();
  const auto& v = element.vertices;
  const ParameterPoint<double> along_s = v[0] - v[2];
  const ParameterPoint<double> along_t = v[1] - v[2];
  const auto area_of = [&](const Frame<double>& frame) {
    return norm(cross(along_s.s * frame.tangent_s + along_s.t * frame.tangent_t,
                      along_t.s * frame.tangent_s + along_t.t * frame.tangent_t));
  };
  const double middle_area = area_of(chart.frame((1.0 / 3) * (v[0] + v[1] + v[2])));
  const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
  double sum = 0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const auto& x = rule.points[i].x;
    const ParameterPoint<double> at = v[2] + x[1] * along_s + x[2] * along_t;
    const Frame<double> q = chart.frame(at);
    sum += rule.weights[i] * (constant_area ? middle_area : area_of(q)) * u({element.chart, at}, q.point) *
           geometric_kernel(p.point, unit_normal(p), q.point, unit_normal(q));
  }
  return sum;
}

// The right side of (76) less the left: elements whose centroid is nearer to v_i than their size and a half
// by the library's cubature, which the kernel's direction asks for there.
Approximation sum_less_the_whole(const Surface& surface, const std::vector<ParameterTriangle>& triangles,
                                 const SurfacePoint<double>& node, const reference::Density& u,
                                 bool constant_area) {
  constexpr int order = 30;
  constexpr int lower_order = 24;
  const Frame<double> p = surface.charts.at(node.chart).in<double>().frame(node.at);
  const Approximation whole = reference::operator_integral(surface, node, u);
  Approximation difference{.value = -whole.value, .radius = whole.radius};
  for (const ParameterTriangle& each : triangles) {
    const ChartIn<double>& chart = surface.charts.at(each.chart).in<double>();
    const auto& v = each.vertices;
    const Vector<double> middle = chart.frame((1.0 / 3) * (v[0] + v[1] + v[2])).point;
    const double size = norm(chart.frame(v[0]).point - chart.frame(v[1]).point);
    if (norm(middle - p.point) < 1.5 * size) {
      const Approximation near = reference::operator_integral(surface, node, each.chart, each.vertices, u);
      difference.value += near.value;
      difference.radius += near.radius;
      continue;
    }
    const double value = pulled_back(surface, p, each, u, order, constant_area);
    difference.value += value;
    difference.radius += std::abs(value - pulled_back(surface, p, each, u, lower_order, constant_area));
  }
  return difference;
}

std::vector<OctantTriangle> five_triangles() {
  std::vector<OctantTriangle> all = symmetric_octant(1);
  all.push_back(symmetric_octant(3).at(25));
  return all;
}

// Plane triangles and monomials f of degree 2 at most where the two sides of (30) differ, the left one by
// Green's formula and the right one over sigma by the rule at the midpoints of its sides, which is exact for
// degree 2: with the triangle's area element, or with that of a triangle whose first corner is (1,0). The
// first corner is the origin, as the polynomials of degree 2 are the same seen from any point. But for the
// sign of the area, which both sides have, they are polynomials of the other corners' coordinates of degree 3
// at most in each.
Rational differing_plane_elements(bool own_area) {
  using Four = std::array<Rational, 4>;
  constexpr long values = 4;
  Rational count = 0;
  for (const ExactPolynomial& f : monomials(2))
    count += differing_on_grid<4>(
        values,
        [&](const Four& x) {
          return f.integral_over({{0, 0}, {x[0], x[1]}, {x[2], x[3]}});
        },
        [&](const Four& x) {
          const PlanarPoint first{own_area ? 0 : 1, 0};
          const Rational area_element = abs((x[0] - first.x) * x[3] - x[1] * (x[2] - first.x));
          return area_element / 6 *
                 (f({x[0] / 2, x[1] / 2}) + f({x[2] / 2, x[3] / 2}) +
                  f({(x[0] + x[2]) / 2, (x[1] + x[3]) / 2}));
        });
  return count;
}

}  // namespace

Finding equation_30(const Bench& bench) {
  const BallPrecision precision(192);
  const double radius = bench.budget == Budget::quick ? 1e-15 : 1e-25;
  const Surface surface = sphere();
  Finding finding;
  finding.require("plane triangles and monomials of degree 2 at most where the sides of (30) differ",
                  IsExactly{0}, differing_plane_elements(true));
  finding.control("the same with another area element", IsExactly{0}, differing_plane_elements(false));
  int number = 0;
  for (const OctantTriangle& triangle : five_triangles()) {
    const std::string at = ", triangle " + std::to_string(++number);
    const std::array<Ball, 3> parts = coordinate_integrals(triangle);
    const Vector<Ball> moment = first_moment(triangle);
    const AgreesWith area{.value = parts[0] + parts[1] + parts[2], .within = 4 * radius};
    finding.require("area" + at, area, over_sigma(surface, triangle, Factor::one, true, radius));
    finding.require("Int x" + at, AgreesWith{.value = moment.x, .within = 4 * radius},
                    over_sigma(surface, triangle, Factor::x, true, radius));
    finding.require("Int y" + at, AgreesWith{.value = moment.y, .within = 4 * radius},
                    over_sigma(surface, triangle, Factor::y, true, radius));
    finding.require("Int z" + at, AgreesWith{.value = moment.z, .within = 4 * radius},
                    over_sigma(surface, triangle, Factor::z, true, radius));
    finding.control("area, without |D_s m x D_t m|" + at, area,
                    over_sigma(surface, triangle, Factor::one, false, radius));
  }
  return finding;
}

Finding equation_76(const Bench&) {
  const Equals zero{
      .value = 0, .slack = 1e-9, .why = "cubature to 1e-12 on each element, and up to 128 elements"};
  Finding finding;
  const std::vector<std::pair<std::string, std::vector<Rational>>> cases{
      {"ellipsoid", {1, 2, 5}}, {"two_piece", {2}}, {"spherical_cap", {Rational(1, 4)}}};
  for (const auto& [name, parameters] : cases) {
    const Surface surface = find_surface(name)->make(parameters);
    const std::vector<ParameterTriangle> triangles = triangulate(surface, 2).triangles;
    const reference::Density u = [](const SurfacePoint<double>&, const Vector<double>& q) {
      return std::exp(q.x + q.y / 2 - q.z / 3);
    };
    // A node v_i of the first element, alpha = 1/6.
    const auto& v = triangles.front().vertices;
    const SurfacePoint<double> node{triangles.front().chart,
                                    (2.0 / 3) * v[0] + (1.0 / 6) * v[1] + (1.0 / 6) * v[2]};
    finding.require("sum over the elements less the whole, " + name, zero,
                    sum_less_the_whole(surface, triangles, node, u, false));
    finding.control("the same with |D_s m x D_t m| of the centroid for each element, " + name, zero,
                    sum_less_the_whole(surface, triangles, node, u, true));
  }
  return finding;
}

Finding equation_76_parts(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  using Function = SphereCollocation::Function;
  const Function one = [](const Vector<Ball>&) { return Ball(1); };
  const Function fourth_power = [](const Vector<Ball>& q) { return power(q.z, 4); };
  constexpr int octants = 8;
  for (const int level : {0, 1, 2}) {
    const std::vector<OctantTriangle> triangles = symmetric_octant(level);
    const SphereCollocation method(triangles, Rational(1, 6));
    // The rule (54) for u |D_s m x D_t m|, |D_s m x D_t m| = |e|^-3/4^level: what interpolation of the
    // product gives.
    const auto by_the_printed_parts = [&](const Function& u) {
      Ball sum(0);
      for (const OctantTriangle& t : triangles)
        for (std::size_t j = 0; j < 3; ++j) {
          Vector<Rational> e{0, 0, 0};
          for (std::size_t i = 0; i < 3; ++i)
            e = e + (i == j ? Rational(2, 3) : Rational(1, 6)) * t.corners.at(i);
          const Vector<Ball> at{Ball(e.x), Ball(e.y), Ball(e.z)};
          const Ball length = norm(at);
          sum += u(reciprocal(length) * at) * power(length, -3);
        }
      return Ball(octants) * sum / (Ball(6) * power(Ball(4), level) * Ball(4) * Ball::pi());
    };
    const std::string at = ", level " + std::to_string(level);
    // K(I - P_n)u on the unit sphere is the mean of u less M_n u, rho = 1.
    for (const auto& [name, u, mean, exponent] :
         {std::tuple<std::string, Function, Rational, int>{"u = 1", one, 1, 0},
          {"u = z^4", fourth_power, Rational(1, 5), 4}}) {
      const AgreesWith error{.value = Ball(mean) - method.mean(u), .within = 1e-9};
      finding.require("Int G (I - L)(u |D_s m x D_t m|), against K(I - P_n)u, " + name + at, error,
                      Ball(mean) - by_the_printed_parts(u));
      finding.instead("Int G |D_s m x D_t m| (I - L)u, against K(I - P_n)u, " + name + at, error,
                      by_the_true_parts(triangles, exponent, Rational(1, 6)));
      if (exponent != 0)
        finding.control("the same with the nodes of alpha = 1/10, " + name + at, error,
                        by_the_true_parts(triangles, exponent, Rational(1, 10)));
    }
  }
  finding.show(proved(Ball(1) - Ball(2) * sqrt(Ball(2)) / Ball::pi()));
  return finding;
}

}  // namespace radcert::verification::ac98
