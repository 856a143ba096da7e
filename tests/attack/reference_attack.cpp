// SPDX-License-Identifier: GPL-3.0-or-later

// The families of reference values with parameters at the ends of their ranges. The judge has a formula of
// its own for each family that has one (sums over corners, Lambert's formula, quadratics, elimination), at
// 1500 bits, and shares nothing with the routes but balls. Families without one are held against the laws
// that they obey; that the two routes agree, the library itself insists on.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "radcert/reference/reference_value.h"
#include "radcert/scalar/real.h"
#include "tests/attack/attack.h"

namespace radcert::attack {
namespace {

using reference::Arguments;
using reference::ValueFamily;

Ball square(const Ball& x) { return x * x; }
// For x >= 0 that is zero or certainly not.
Ball root(const Ball& x) { return sqrt(abs(x)); }
Ball arc_sine(const Ball& x) { return Ball(2) * atan(x / (Ball(1) + root(Ball(1) - square(x)))); }
Ball arc_cosine(const Ball& x) { return Ball::pi() / Ball(2) - arc_sine(x); }

using Point = std::array<Ball, 3>;
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Ball product(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point crossed(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Lambert's formula for a polygon wholly above the horizon of P.
Ball lambert(const Point& p, const Point& normal, const std::vector<Point>& polygon) {
  Ball sum(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = minus(polygon[i], p);
    const Point b = minus(polygon[(i + 1) % polygon.size()], p);
    const Point n = crossed(a, b);
    const Ball size = product(n, n);
    if (size.contains_zero()) continue;  // P on the line of the side: no angle, as P is off the side
    const Ball length = sqrt(size);
    const Ball angle = Ball(2) * atan(length / (sqrt(product(a, a)) * sqrt(product(b, b)) + product(a, b)));
    sum += angle * product(normal, n) / length;
  }
  return abs(sum) / (Ball(2) * Ball::pi() * sqrt(product(normal, normal)));
}

Ball signed_sum(const std::function<Ball(const std::array<Ball, 4>&)>& f,
                const std::array<std::array<Ball, 2>, 4>& ends) {
  Ball sum(0);
  for (unsigned corner = 0; corner < 16; ++corner) {
    std::array<Ball, 4> at;
    unsigned odd = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      at[k] = ends[k][corner >> k & 1U];
      odd ^= corner >> k & 1U;
    }
    sum += odd ? -f(at) : f(at);
  }
  return sum;
}

// Rectangles in parallel planes, by their corners: [Howell, C-13].
Ball opposed(const Ball& w, const Ball& d, const Ball& z) {
  const auto corner = [&](const std::array<Ball, 4>& at) {
    const Ball u = at[0] - at[1];
    const Ball v = at[2] - at[3];
    const Ball p = sqrt(square(u) + square(z));
    const Ball q = sqrt(square(v) + square(z));
    return v * p * atan(v / p) + u * q * atan(u / q) -
           square(z) / Ball(2) * log(square(u) + square(v) + square(z));
  };
  const std::array<Ball, 2> x{Ball(0), w};
  const std::array<Ball, 2> y{Ball(0), d};
  return signed_sum(corner, {x, x, y, y}) / (Ball(2) * Ball::pi() * w * d);
}

// Rectangles in planes at a right angle, by their corners: [Howell, C-15].
Ball perpendicular(const Ball& edge, const Ball& from, const Ball& to) {
  const auto corner = [&](const std::array<Ball, 4>& at) {
    const Ball c = square(at[0]) + square(at[1]);
    const Ball v = at[2] - at[3];
    const Ball r = c + square(v);
    if (r.contains_zero())
      return Ball(0);  // the corner on the common edge: 0 but for the rounding of the edge
    const Ball first = certainly_zero(c) ? Ball(0) : v * sqrt(c) * atan(v / sqrt(c));
    return first - (c - square(v)) / Ball(4) * log(r);
  };
  const std::array<Ball, 2> y{Ball(0), edge};
  return abs(signed_sum(corner, {std::array{Ball(0), from}, std::array{Ball(0), to}, y, y})) /
         (Ball(2) * Ball::pi() * edge * from);
}

std::vector<Point> rectangle(const Ball& width, const Ball& depth) {
  const Ball o(0);
  return {{o, o, o}, {width, o, o}, {width, depth, o}, {o, depth, o}};
}

Ball cube_factor() { return opposed(Ball(1), Ball(1), Ball(1)); }

// Sum and difference of floor and ceiling, and the walls.
Ball cube(const Ball& rho, int face) {
  const Ball f = cube_factor();
  const Ball g = (Ball(1) - f) / Ball(4);
  const Ball walls = Ball(1) - rho * (f + Ball(2) * g);
  const Ball sum = Ball(1) / (Ball(1) - rho * f - Ball(8) * square(rho * g) / walls);
  const Ball difference = Ball(1) / (Ball(1) + rho * f);
  if (face == 2) return rho * g * sum / walls;
  return (sum + (face == 0 ? difference : -difference)) / Ball(2);
}

Ball inner_sphere(const Ball& outer, const Ball& rho) {
  const Ball f = Ball(1) / square(outer);
  return Ball(1) / (Ball(1) - square(rho) * f / (Ball(1) - rho * (Ball(1) - f)));
}

Ball to_inner_cylinder(const Ball& R, const Ball& H) {
  const Ball a = square(H) + square(R) - Ball(1);
  const Ball b = square(H) - square(R) + Ball(1);
  return (Ball(1) -
          (arc_cosine(b / a) - (root(square(a + Ball(2)) - square(Ball(2) * R)) * arc_cosine(b / (R * a)) +
                                b * arc_sine(Ball(1) / R) - Ball::pi() * a / Ball(2)) /
                                   (Ball(2) * H)) /
              Ball::pi()) /
         R;
}

Ball to_outer_cylinder(const Ball& R, const Ball& H) {
  const Ball two(2), four(4), pi = Ball::pi();
  const Ball q = sqrt(four * square(R) + square(H)) / H;
  const Ball s = square(R) - Ball(1);
  const Ball y = (four * s + (square(R) - two) * square(H) / square(R)) / (square(H) + four * s);
  return Ball(1) - Ball(1) / R + two / (pi * R) * atan(two * sqrt(s) / H) -
         H / (two * pi * R) *
             (q * arc_sine(y) - arc_sine((square(R) - two) / square(R)) + (q - Ball(1)) * pi / two);
}

using Formula = std::function<std::optional<Ball>(const std::vector<Ball>&)>;

const std::map<std::string, Formula>& formulas() {
  static const Ball one(1), two(2);
  const auto pi_total = [](const std::vector<Ball>&) { return Ball::pi(); };
  static const std::map<std::string, Formula> all{
      {"opposed_rectangles", [](const auto& a) { return opposed(a[0], a[1], a[2]); }},
      {"perpendicular_rectangles", [](const auto& a) { return perpendicular(a[0], a[1], a[2]); }},
      {"regular_tetrahedron_faces", [](const auto&) { return Ball(Rational(1, 3)); }},
      {"corner_tetrahedron_legs", [](const auto&) { return (Ball(3) - sqrt(Ball(3))) / Ball(6); }},
      {"coaxial_disks",
       [](const auto& a) {
         const Ball x = square(a[0]) + square(a[1]) + square(a[2]);
         return (x - root(square(x) - square(Ball(2) * a[0] * a[1]))) / (Ball(2) * square(a[0]));
       }},
      {"sphere_to_coaxial_disk",
       [](const auto& a) { return (one - a[1] / sqrt(square(a[0]) + square(a[1]))) / two; }},
      {"cylinder_to_itself",
       [](const auto& a) {
         const Ball h = a[1] / (two * a[0]);
         return one + h - sqrt(one + square(h));
       }},
      {"opposed_strips", [](const auto& a) { return sqrt(one + square(a[1] / a[0])) - a[1] / a[0]; }},
      {"inclined_strips",
       [](const auto& a) {
         const Ball c = sqrt(square(a[0]) + square(a[1]) - two * a[0] * a[1] * a[2]);
         return (a[0] + a[1] - c) / (two * a[0]);
       }},
      {"element_to_parallel_disk", [](const auto& a) { return one - one / (one + square(a[0] / a[1])); }},
      {"outer_cylinder_to_inner", [](const auto& a) { return to_inner_cylinder(a[0], a[1]); }},
      {"outer_cylinder_to_itself", [](const auto& a) { return to_outer_cylinder(a[0], a[1]); }},
      {"outer_sphere_to_inner", [](const auto& a) { return power(a[0], -2); }},
      {"element_to_sphere", [](const auto& a) { return power(a[0], -2); }},
      {"sphere_radiosity_excess",
       [](const auto& a) { return (exp(one) - exp(-one)) / two * (one / (one - a[0]) - one); }},
      {"concentric_spheres_radiosity_of_inner", [](const auto& a) { return inner_sphere(a[0], a[1]); }},
      {"concentric_spheres_radiosity_of_outer",
       [](const auto& a) -> std::optional<Ball> {
         if (certainly_zero(a[1])) return Ball(0);
         return (inner_sphere(a[0], a[1]) - one) / a[1];
       }},
      {"cube_radiosity_of_floor", [](const auto& a) { return cube(a[0], 0); }},
      {"cube_radiosity_of_ceiling", [](const auto& a) { return cube(a[0], 1); }},
      {"cube_radiosity_of_wall", [](const auto& a) { return cube(a[0], 2); }},
      {"linear_interpolation_norm", [](const auto& a) { return (one + a[0]) / (one - Ball(3) * a[0]); }},
      {"point_above_rectangle",
       [](const auto& a) {
         return lambert({a[0], a[1], a[2]}, {Ball(0), Ball(0), -one}, rectangle(a[3], a[4]));
       }},
      {"point_beside_rectangle",
       [](const auto& a) {
         return lambert({a[0], -a[1], a[2]}, {Ball(0), one, Ball(0)}, rectangle(a[3], a[4]));
       }},
      {"point_to_corner_triangle",
       [](const auto& a) -> std::optional<Ball> {
         if (!certainly_zero(a[3]) || !certainly_zero(a[4])) return std::nullopt;
         const Ball o(0);
         return a[2] * lambert({o, o, o}, {a[0], a[1], one}, {{o, o, one}, {one, o, one}, {o, one, one}});
       }},
      {"two_squares_one",
       [](const auto& a) {
         return Ball::pi() * lambert({a[0], Ball(0), a[1]}, {Ball(0), one, Ball(0)}, rectangle(one, one));
       }},
      {"box_total", pi_total},
      {"ellipsoid_total", pi_total},
      {"cylinder_total", pi_total},
      {"cone_total", pi_total},
      {"paraboloid_cap_total", pi_total},
      {"tetrahedron_total", pi_total},
      {"octahedron_total", pi_total},
      {"spherical_cap_total", [](const auto& a) { return Ball::pi() * a[0]; }},
      {"sphere_power", [](const auto& a) { return Ball::pi() / (a[0] + one); }},
  };
  return all;
}

struct Value {
  std::size_t family = 0;
  Arguments arguments;
  int digits = 10;
};

// Whether the second route takes integrals over charts: seconds each.
bool is_slow(const std::string& name) {
  for (const char* part :
       {"ellipsoid", "cylinder_total", "cone", "paraboloid", "tetrahedron_total", "octahedron",
        "spherical_cap", "sphere_power", "two_piece", "edge_exponent", "point_", "two_squares"})
    if (name.find(part) != std::string::npos) return true;
  return false;
}

// Closed forms are asked everywhere; integrals take long at the ends of the ranges, and are asked nearer to
// their middle.
enum class Routes { closed_form, both, surfaces };

Rational extreme(Draw& draw, Routes routes) {
  const bool far = routes == Routes::closed_form;
  const auto tiny = [&](std::size_t most) {
    return 1 / power(Rational(10), 1 + static_cast<int>(draw.below(far ? most : 2)));
  };
  switch (draw.below(9)) {
    case 0: return tiny(12);
    case 1: return 1 / tiny(9);
    case 2: return 1 - tiny(12);
    case 3: return 1 + tiny(12);
    case 4: return Rational(1, 3) - tiny(9);
    case 5: return Rational(1 + static_cast<long>(draw.below(20)));
    case 6: return Rational(static_cast<long>(draw.below(3)));
    case 7: return Rational::exactly(draw.unit());
    default: return Rational(1 + static_cast<long>(draw.below(99)), 100);
  }
}

Value value(Draw& draw, Routes routes) {
  const auto families = reference::value_families();
  while (true) {
    const int most_digits = routes == Routes::closed_form ? 100 : routes == Routes::both ? 25 : 8;
    Value out{.family = draw.below(families.size()),
              .arguments = {},
              .digits = 1 + static_cast<int>(draw.below(static_cast<std::size_t>(most_digits)))};
    const ValueFamily& family = families[out.family];
    if (routes != Routes::closed_form && is_slow(family.name) != (routes == Routes::surfaces)) continue;
    if (routes == Routes::closed_form && !formulas().contains(family.name)) continue;
    if (family.parameters.empty() && draw.below(10) != 0) continue;
    out.arguments = reference::default_arguments(family);
    for (std::size_t k = 0; k < family.parameters.size(); ++k)
      for (int tries = 0; tries < 20; ++tries) {
        const Rational x = draw.below(4) == 0 ? -extreme(draw, routes) : extreme(draw, routes);
        if (!family.parameters[k].allows(x)) continue;
        out.arguments[k] = x;
        break;
      }
    return out;
  }
}

std::string text(const Value& v) {
  const ValueFamily& family = reference::value_families()[v.family];
  std::string out = family.name + ", " + std::to_string(v.digits) + " digits";
  for (std::size_t k = 0; k < v.arguments.size(); ++k)
    out += ", " + family.parameters[k].name + " = " + v.arguments[k].to_text();
  return out;
}

// Of a ball that was given for the value.
Judgement judge(const Value& v, const Ball& found) {
  constexpr long bits = 1500;
  const BallPrecision scope(bits);
  const ValueFamily& family = reference::value_families()[v.family];
  const auto formula = formulas().find(family.name);
  if (formula == formulas().end()) return Judgement::held();
  std::vector<Ball> arguments;
  for (const Rational& x : v.arguments) arguments.emplace_back(x);
  const std::optional<Ball> truth = formula->second(arguments);
  if (!truth) return Judgement::held();
  if (!truth->is_finite())
    return Judgement::violated("the judge has no value: " + std::string(truth->failure()));
  if (certainly_less(Ball(1 / power(Rational(10), v.digits + 50)), truth->radius_ball()))
    return Judgement::violated("the judge lost its digits: " + truth->to_text());
  if (!overlaps(found, *truth))
    return Judgement::violated(found.to_text(60) + ", but the truth is " + truth->to_text(60));
  return Judgement::held();
}

Judgement judge_closed_form(const Value& v) {
  const ValueFamily& family = reference::value_families()[v.family];
  const Rational radius = 1 / power(Rational(10), v.digits);
  const Outcome<Ball> found = family.route.enclose(v.arguments, radius);
  if (!found) return Judgement::refused();
  if (!certainly_at_most(found->radius_ball(), Ball(radius)))
    return Judgement::violated("the radius of " + found->to_text() + " is larger than asked for");
  return judge(v, *found);
}

Judgement judge_both(const Value& v) {
  const ValueFamily& family = reference::value_families()[v.family];
  const Outcome<reference::EnclosedValue> found = reference::enclose(family, v.arguments, v.digits);
  if (!found) return Judgement::refused();
  if (!overlaps(found->first.value, found->second.value))
    return Judgement::violated("the routes contradict each other");
  const Judgement first = judge(v, found->first.value);
  return first.kind == Judgement::Kind::held ? judge(v, found->second.value) : first;
}

std::vector<Value> smaller(const Value& v) {
  std::vector<Value> out;
  const ValueFamily& family = reference::value_families()[v.family];
  const Arguments usual = reference::default_arguments(family);
  for (std::size_t k = 0; k < usual.size(); ++k) {
    if (v.arguments[k] == usual[k]) continue;
    Value other = v;
    other.arguments[k] = usual[k];
    out.push_back(std::move(other));
  }
  if (v.digits > 1) {
    Value other = v;
    other.digits = v.digits / 2;
    out.push_back(std::move(other));
  }
  return out;
}

Attack<Value> attack_on(std::string_view name, std::size_t usual, Routes routes) {
  return {.name = name,
          .usual_instances = usual,
          .make = [routes](Draw& draw) { return value(draw, routes); },
          .judge =
              [routes](const Value& v) {
                return routes == Routes::closed_form ? judge_closed_form(v) : judge_both(v);
              },
          .text = [](const Value& v) { return text(v); },
          .smaller = smaller};
}

TEST(ReferenceAttack, OfClosedForms) {
  EXPECT_EQ(hold(attack_on("closed forms of reference families", 1000, Routes::closed_form)).violated, 0U);
}

TEST(ReferenceAttack, OfBothRoutes) {
  EXPECT_EQ(hold(attack_on("reference families by both routes", 60, Routes::both)).violated, 0U);
}

TEST(ReferenceAttack, OfIntegralsOverSurfaces) {
  EXPECT_EQ(hold(attack_on("reference families over surfaces", 3, Routes::surfaces)).violated, 0U);
}

// A factor from one rectangle to another, and back: a F = b F'.
TEST(ReferenceAttack, OfReciprocity) {
  const Attack<Value> attack{
      .name = "reciprocity of reference factors",
      .usual_instances = 150,
      .make =
          [](Draw& draw) {
            Value v = value(draw, Routes::closed_form);
            const auto families = reference::value_families();
            for (v.family = 0; families[v.family].name != "inclined_rectangles"; ++v.family) {
            }
            const auto length = [&] { return abs(extreme(draw, Routes::closed_form)) + Rational(1, 1000); };
            v.arguments = {length(), length(), length(), Rational(1 + static_cast<long>(draw.below(98)), 99)};
            return v;
          },
      .judge = [](const Value& v) -> Judgement {
        const ValueFamily& family = reference::value_families()[v.family];
        const Rational radius = 1 / power(Rational(10), v.digits);
        const auto there = family.route.enclose(v.arguments, radius);
        const auto back =
            family.route.enclose({v.arguments[0], v.arguments[2], v.arguments[1], v.arguments[3]}, radius);
        if (!there || !back) return Judgement::refused();
        if (!overlaps(Ball(v.arguments[1]) * *there, Ball(v.arguments[2]) * *back))
          return Judgement::violated("a F " + there->to_text() + ", b F' " + back->to_text());
        return Judgement::held();
      },
      .text = [](const Value& v) { return text(v); }};
  EXPECT_EQ(hold(attack).violated, 0U);
}

}  // namespace
}  // namespace radcert::attack
