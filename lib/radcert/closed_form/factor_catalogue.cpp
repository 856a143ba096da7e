// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/factor_catalogue.h"

#include <string_view>

#include "radcert/core/contract.h"
#include "radcert/scalar/functions/dilogarithm.h"

namespace radcert {
namespace {

Ball ball(const Rational& value) { return Ball(value); }

void positive(std::string_view name, const Rational& value) {
  expects(value.sign() > 0, "a length > 0", named(name, value));
}

// asin x where 1 - x^2 > 0 is known exactly.
Ball arc_sine(const Rational& x) { return atan(ball(x) / sqrt(ball(1 - x * x))); }

// g(x) = (1-x^2) log(1+x^2) + x^2 log x^2 + 4 x atan(1/x), from x^2.
Ball edges_at_distance(const Ball& squared) {
  const Ball x = sqrt(squared);
  return (1 - squared) * log(1 + squared) + squared * log(squared) + 4 * x * atan(1 / x);
}

struct Angle {
  Ball cosine;
  Ball sine;
};

// Lambda without the sign of d, see polygon_to_polygon.cpp; d > 0, h = 1.
Ball triangle_integral(const Ball& d, const Ball& rho, const Ball& tau) {
  const Ball theta = atan(tau / d);
  const Ball root = 1 / (rho + d);
  const Ball turned = 2 * theta + Ball::pi();
  return -theta * log(root) +
         (dilogarithm_imaginary(1, turned) - dilogarithm_imaginary(root * root, turned)) / 2;
}

// T_1(p,q) - T_0(p,q); `squared_third` is C^2, the square of the side between the ends of p and q.
Ball side_difference(const Ball& p, const Ball& q, const Angle& angle, const Ball& squared_third) {
  const Ball d = p * angle.sine;
  const Ball rho = sqrt(d * d + 1);
  const Ball start = -p * angle.cosine;
  const Ball end = q + start;
  const auto at = [&](const Ball& tau, const Ball& squared) {
    const Ball logarithm = tau * (log(squared + 1) - log(squared));
    return d / 2 * (logarithm + 2 * rho * atan(tau / rho) - 2 * d * atan(tau / d)) +
           triangle_integral(d, rho, tau);
  };
  return at(end, squared_third) - at(start, p * p);
}

Ball inclined(const Rational& edge, const Rational& from_width, const Rational& to_width,
              const Angle& angle) {
  positive("edge", edge);
  positive("from_width", from_width);
  positive("to_width", to_width);
  const Ball a = ball(from_width / edge);
  const Ball b = ball(to_width / edge);
  const Ball squared_third = a * a + b * b - 2 * a * b * angle.cosine;
  const Ball sides =
      side_difference(a, b, angle, squared_third) + side_difference(b, a, angle, squared_third);
  return (edges_at_distance(a * a) + edges_at_distance(b * b) - edges_at_distance(squared_third) +
          2 * angle.cosine / angle.sine * sides) /
         (4 * Ball::pi() * a);
}

struct Annulus {
  Annulus(const Rational& inner, const Rational& outer, const Rational& length)
      : ratio(quotient(inner, outer)), height(length / inner) {
    positive("length", length);
  }
  static Rational quotient(const Rational& inner, const Rational& outer) {
    positive("inner", inner);
    expects(inner < outer, "inner < outer", named("inner", inner), named("outer", outer));
    return outer / inner;
  }

  Rational ratio;   ///< R
  Rational height;  ///< H
};

}  // namespace

Ball opposed_rectangles(const Rational& width, const Rational& depth, const Rational& distance) {
  positive("width", width);
  positive("depth", depth);
  positive("distance", distance);
  const Rational x = width / distance;
  const Rational y = depth / distance;
  const Rational xx = 1 + x * x;
  const Rational yy = 1 + y * y;
  const Ball root_x = sqrt(ball(xx));
  const Ball root_y = sqrt(ball(yy));
  const Ball sum = log(ball(xx * yy / (xx + y * y))) / 2 - ball(x) * atan(ball(x)) - ball(y) * atan(ball(y)) +
                   ball(x) * root_y * atan(ball(x) / root_y) + ball(y) * root_x * atan(ball(y) / root_x);
  return 2 * sum / (Ball::pi() * ball(x * y));
}

Ball perpendicular_rectangles(const Rational& edge, const Rational& from_width, const Rational& to_width) {
  positive("edge", edge);
  positive("from_width", from_width);
  positive("to_width", to_width);
  const Rational w = from_width / edge;
  const Rational h = to_width / edge;
  const Rational ww = w * w;
  const Rational hh = h * h;
  const Rational cc = ww + hh;
  const Ball c = sqrt(ball(cc));
  const Ball angles = ball(w) * atan(ball(1 / w)) + ball(h) * atan(ball(1 / h)) - c * atan(1 / c);
  const Ball logarithms = log(ball((1 + ww) * (1 + hh) / (1 + cc))) +
                          ball(ww) * log(ball(ww * (1 + cc) / ((1 + ww) * cc))) +
                          ball(hh) * log(ball(hh * (1 + cc) / ((1 + hh) * cc)));
  return (angles + logarithms / 4) / (Ball::pi() * ball(w));
}

Ball inclined_rectangles(const Rational& edge, const Rational& from_width, const Rational& to_width,
                         const Rational& cosine) {
  expects(-1 < cosine && cosine < 1, "-1 < cosine < 1", named("cosine", cosine));
  return inclined(edge, from_width, to_width, {ball(cosine), sqrt(ball(1 - cosine * cosine))});
}

Ball inclined_rectangles_at_angle(const Rational& edge, const Rational& from_width, const Rational& to_width,
                                  const Rational& half_turns) {
  expects(0 < half_turns && half_turns < 1, "0 < half_turns < 1", named("half_turns", half_turns));
  const Ball angle = Ball::pi() * ball(half_turns);
  return inclined(edge, from_width, to_width, {cos(angle), sin(angle)});
}

Ball regular_tetrahedron() { return ball(Rational(1, 3)); }
Ball corner_tetrahedron() { return (3 - sqrt(Ball(3))) / 6; }

Ball coaxial_disks(const Rational& from_radius, const Rational& to_radius, const Rational& distance) {
  positive("from_radius", from_radius);
  positive("to_radius", to_radius);
  positive("distance", distance);
  const Rational from = from_radius * from_radius;
  const Rational to = to_radius * to_radius;
  const Rational x = from + to + distance * distance;
  return 2 * ball(to) / (ball(x) + sqrt(ball(x * x - 4 * from * to)));
}

Ball cylinder_to_itself(const Rational& radius, const Rational& length) {
  positive("radius", radius);
  positive("length", length);
  const Rational h = length / (2 * radius);
  return 2 * ball(h) / (1 + ball(h) + sqrt(ball(1 + h * h)));
}

Ball outer_cylinder_to_inner(const Rational& inner, const Rational& outer, const Rational& length) {
  const Annulus annulus(inner, outer, length);
  const Rational& r = annulus.ratio;
  const Rational& h = annulus.height;
  const Rational a = h * h + r * r - 1;
  const Rational b = h * h - r * r + 1;
  const Ball s = sqrt(ball(r * r - 1));
  const Ball bracket =
      2 * sqrt(ball((a + 2) * (a + 2) - 4 * r * r)) * atan(sqrt(ball((r * a - b) / (r * a + b)))) +
      ball(b) * atan(1 / s) - Ball::pi() * ball(a / 2);
  return (1 - (2 * atan(s / ball(h)) - bracket / ball(2 * h)) / Ball::pi()) / ball(r);
}

Ball outer_cylinder_to_itself(const Rational& inner, const Rational& outer, const Rational& length) {
  const Annulus annulus(inner, outer, length);
  const Rational& r = annulus.ratio;
  const Rational& h = annulus.height;
  const Rational rr = r * r;
  const Rational hh = h * h;
  const Ball s = sqrt(ball(rr - 1));
  const Ball q = sqrt(ball(4 * rr + hh)) / ball(h);
  const Rational y = (4 * (rr - 1) + (rr - 2) * hh / rr) / (hh + 4 * (rr - 1));
  const Ball bracket = q * arc_sine(y) - arc_sine((rr - 2) / rr) + (q - 1) * Ball::pi() / 2;
  return 1 - ball(1 / r) + (2 * atan(2 * s / ball(h)) - ball(h / 2) * bracket) / (Ball::pi() * ball(r));
}

Ball sphere_to_coaxial_disk(const Rational& disk_radius, const Rational& distance) {
  positive("disk_radius", disk_radius);
  positive("distance", distance);
  const Rational r = disk_radius / distance;
  const Ball root = sqrt(ball(1 + r * r));
  return ball(r * r) / (2 * root * (root + 1));
}

Ball outer_sphere_to_inner(const Rational& inner, const Rational& outer) {
  positive("inner", inner);
  expects(inner < outer, "inner < outer", named("inner", inner), named("outer", outer));
  return ball(inner * inner / (outer * outer));
}

Ball opposed_strips(const Rational& width, const Rational& distance) {
  positive("width", width);
  positive("distance", distance);
  const Rational h = distance / width;
  return 1 / (sqrt(ball(1 + h * h)) + ball(h));
}

Ball inclined_strips(const Rational& from_width, const Rational& to_width, const Rational& cosine) {
  positive("from_width", from_width);
  positive("to_width", to_width);
  expects(-1 < cosine && cosine < 1, "-1 < cosine < 1", named("cosine", cosine));
  const Rational& a = from_width;
  const Rational& b = to_width;
  // (a + b)^2 - c^2 = 2 a b (1 + cos Phi).
  return ball(b * (1 + cosine)) / (ball(a + b) + sqrt(ball(a * a + b * b - 2 * a * b * cosine)));
}

Ball element_to_parallel_disk(const Rational& radius, const Rational& distance) {
  positive("radius", radius);
  positive("distance", distance);
  return ball(radius * radius / (radius * radius + distance * distance));
}

Ball element_to_sphere(const Rational& radius, const Rational& distance) {
  positive("radius", radius);
  expects(radius <= distance, "radius <= distance", named("radius", radius), named("distance", distance));
  return ball(radius * radius / (distance * distance));
}

}  // namespace radcert
