// SPDX-License-Identifier: GPL-3.0-or-later

// Radiosities that are known exactly, and the exponents with which they behave along an edge.
#include "radcert/closed_form/factor_catalogue.h"
#include "radcert/closed_form/polygon_to_polygon.h"
#include "radcert/core/work_limit.h"
#include "radcert/reference/values/families.h"
#include "radcert/reference/values/line.h"
#include "radcert/scalar/functions/beta_function.h"

namespace radcert::reference::values {
namespace {

constexpr int digits_of_a_line = 300;
constexpr int digits_of_a_search = 100;
const WorkLimit quarterings("reference/values/exact_solutions: quarterings towards the symbol's pole", 8, 1,
                            "refused: no upper end was found");

/// What E = exp(z) adds to itself on the unit sphere: rho/(1 - rho) times its mean.
Enclosure sphere_by_integral(const Arguments& a, const Demand& demand) {
  return times_integral(
      Ball(a[0] / (Rational(2) * (Rational(1) - a[0]))), []<class R>(const R& z) { return exp(z); }, Ball(-1),
      Ball(1), demand);
}

/// Two concentric spheres of radii 1 and `outer`, E = 1 on the inner and 0 on the outer, one reflectivity:
/// with the factor F from the outer to the inner, u_outer = rho (F u_inner + (1 - F) u_outer), u_inner = 1 +
/// rho u_outer.
Ball outer_radiosity(const Ball& rho, const Ball& factor) {
  return rho * factor / (Ball(1) - rho * (Ball(1) - factor) - rho * rho * factor);
}
Enclosure spheres_by_integral(const Arguments& a, const Demand& demand, bool inner) {
  const Rational& outer = a[0];
  const auto f = [outer]<class R>(const R& c) {
    const R d = in<R>(outer);
    const R square = d * d + R(1) - R(2) * d * c;
    return (d - c) * (d * c - R(1)) / (square * square);
  };
  // d u / dF <= 4 rho / (1 - rho)^2 in absolute value: the factor takes as many digits more.
  const Ball rho(a[1]);
  const Ball loss = Ball(8) / ((Ball(1) - rho) * (Ball(1) - rho));
  const Enclosure factor =
      times_integral(Ball(2), f, Ball(Rational(1) / outer), Ball(1),
                     {.radius = demand.radius / loss.upper_double(), .work_limit = demand.work_limit});
  if (!factor) return factor;
  const Ball u = outer_radiosity(rho, factor->value);
  return Enclosed{.value = inner ? Ball(1) + rho * u : u, .evaluations = factor->evaluations};
}

/// One constant on each face of the unit cube, the floor emits 1; by the factors f to the opposite and g to
/// an adjacent face.
enum class CubeFace { floor, ceiling, wall };
Ball cube_radiosity(const Ball& rho, const Ball& f, const Ball& g, CubeFace face) {
  // u_floor - u_ceiling = 1 - rho f (u_floor - u_ceiling);  with the sum s of both and a wall w:
  // s = 1 + rho (f s + 8 g w),  w = rho (g s + (f + 2 g) w).
  const Ball difference = Ball(1) / (Ball(1) + rho * f);
  const Ball to_wall = rho * g / (Ball(1) - rho * (f + Ball(2) * g));
  const Ball sum = Ball(1) / (Ball(1) - rho * (f + Ball(8) * g * to_wall));
  switch (face) {
    case CubeFace::floor: return (sum + difference) / Ball(2);
    case CubeFace::ceiling: return (sum - difference) / Ball(2);
    case CubeFace::wall: break;
  }
  return to_wall * sum;
}

/// The same by elimination in all six unknowns, with factors from contour integrals.
Ball cube_by_elimination(const Ball& rho, CubeFace face) {
  const auto square = [](const std::vector<Vector<Rational>>& corners) {
    return plane_polygon(corners).value();
  };
  const PlanePolygon floor = square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const Ball f = polygon_to_polygon(floor, square({{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}));
  const Ball g = polygon_to_polygon(floor, square({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}));
  // Faces 0, 1 opposite, 2, 3 and 4, 5 likewise; the floor is 0, the ceiling 1.
  constexpr std::size_t n = 6;
  std::array<std::array<Ball, n + 1>, n> rows;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = i == j ? Ball(1) : -(rho * (i / 2 == j / 2 ? f : g));
    rows[i][n] = Ball(i == 0 ? 1 : 0);
  }
  // Diagonally dominant, as rho < 1: no pivoting.
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Ball multiple = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= multiple * rows[k][j];
    }
  const std::size_t at = face == CubeFace::floor ? 0 : face == CubeFace::ceiling ? 1 : 2;
  return rows[at][n] / rows[at][at];
}

ValueFamily cube_family(const std::string& face_name, CubeFace face) {
  return {.name = "cube_radiosity_of_" + face_name,
          .summary =
              "lumped radiosity of the " + face_name +
              " of the unit cube whose floor emits 1, one constant a face coupled by area-to-area factors; "
              "the mean of the continuous solution is continuous_mean_cube_" +
              face_name + "_rho_1/2",
          .formula = "u_i = E_i + rho sum_j F_ij u_j",
          .source = "Howell C-11 for the factors",
          .parameters = {from_to_below("rho", "1/2", 0, 1)},
          .route = by_formula("symmetry reduces the six unknowns; Howell C-11 and closure",
                              [face](const Arguments& a) {
                                const Ball f = opposed_rectangles(1, 1, 1);
                                return cube_radiosity(Ball(a[0]), f, (Ball(1) - f) / Ball(4), face);
                              }),
          .second_route =
              by_formula("elimination in six unknowns, factors by contour integrals",
                         [face](const Arguments& a) { return cube_by_elimination(Ball(a[0]), face); })};
}

/// The zero of an increasing function on an interval, by bisection; `sign` is of a ball, 0 where it straddles
/// 0.
template <class Function>
Outcome<Ball> zero_of_increasing(const Function& f, Rational lower, Rational upper, const Rational& radius) {
  while (upper - lower > radius) {
    const Rational middle = (lower + upper) / Rational(2);
    const Outcome<Ball> value = f(middle);
    if (!value) return value;
    if (certainly_positive(*value)) {
      upper = middle;
    } else if (certainly_negative(*value)) {
      lower = middle;
    } else {
      return because("the sign at " + middle.to_text() + " was not decided: " + value->to_text());
    }
  }
  return hull(Ball(lower), Ball(upper));
}

/// Mellin symbol of the operator between two half planes at a right angle, (rho/4) B((b+2)/2, (1-b)/2), less
/// 1: it increases in 0 < b < 1 from rho/2 - 1 to infinity.
Outcome<Ball> exponent_by_beta(const Arguments& a, const Rational& radius) {
  const BallPrecision precision(2 * bits_for(radius) + 64);
  return zero_of_increasing(
      [&a](const Rational& b) -> Outcome<Ball> {
        return Ball(a[0] / Rational(4)) *
                   beta_function(Ball(b / Rational(2) + Rational(1)), Ball((Rational(1) - b) / Rational(2))) -
               Ball(1);
      },
      0, 1, radius);
}

/// Int v^k e^(-c v) (1 + e^(-2v))^(-3/2) dv over v > 0 for c > 0 and k = 0 or 1. Beyond V the integrand is at
/// most v^k e^(-c v), and v <= V e^((v-V)/V): the tail is at most V^k e^(-c V) / (c - k/V).
Enclosure half_line_integral(const Ball& c, int k, const Demand& demand) {
  const auto f = [&c, k]<class R>(const R& v) {
    const R sum = R(1) + exp(R(-2) * v);
    const R value = exp(-(R(c) * v)) / (sum * sqrt(sum));
    return k == 0 ? value : v * value;
  };
  const Ball end(std::ceil((8 - std::log(demand.radius)) / std::min(1.0, c.lower_double())));
  const Ball tail = power(end, k) * exp(-(c * end)) / (c - Ball(k) / end);
  const Enclosure integral = integral_on_interval(line_function(f), Ball(0), end, demand);
  if (!integral) return integral;
  return Enclosed{.value = widened(integral->value, tail), .evaluations = integral->evaluations};
}

/// Int t^(b+1) (1 + t^2)^(-3/2) (log t)^k dt over t > 0 for k = 0 or 1, with t = e^v for t > 1 and t = e^(-v)
/// for t < 1.
Enclosure symbol_integral(const Ball& b, int k, const Demand& demand) {
  return sum_of([&](const Demand& half) { return half_line_integral(Ball(1) - b, k, half); },
                [&](const Demand& half) -> Enclosure {
                  const Enclosure below = half_line_integral(Ball(2) + b, k, half);
                  if (!below || k == 0) return below;
                  return Enclosed{.value = -below->value, .evaluations = below->evaluations};
                },
                demand);
}

/// The zero of (rho/2) Int t^(b+1) (1 + t^2)^(-3/2) dt - 1, the same symbol, from both sides: it increases
/// with b and is convex, as log t and log^2 t beside positive factors say of its derivatives. So a tangent at
/// the upper end vanishes above the zero, a chord below it.
Outcome<Ball> exponent_by_integral(const Arguments& a, const Rational& radius) {
  const BallPrecision precision(bits_for(radius) + 96);
  const Ball half_rho(a[0] / Rational(2));
  const auto symbol = [&half_rho](const Ball& b, int k, double accuracy) -> Outcome<Ball> {
    const Enclosure integral = symbol_integral(b, k, {.radius = accuracy});
    if (!integral) return because(integral.reason().to_text());
    return half_rho * integral->value - Ball(k == 0 ? 1 : 0);
  };
  Ball lower(0);  // where the symbol is rho/2 - 1 < 0
  Ball upper;
  Ball gap(1);
  long quartered = 0;
  for (bool above = false; !above;) {
    if (quartered++ == quarterings.value()) return because("no upper end was found below " + upper.to_text());
    gap = gap / 4;
    upper = Ball(1) - gap;
    const Outcome<Ball> value = symbol(upper, 0, 1e-3);
    if (!value) return value;
    above = certainly_positive(*value);
  }
  while (!certainly_at_most(hull(lower, upper).radius_ball(), Ball(radius))) {
    const double width = (upper - lower).upper_double();
    // As accurate as the next width, about the square of this one.
    const double accuracy = std::max(radius.to_double(), width * width) / 64;
    const Outcome<Ball> below = symbol(lower, 0, accuracy);
    if (!below) return below;
    const Outcome<Ball> above = symbol(upper, 0, accuracy);
    if (!above) return above;
    const Outcome<Ball> slope = symbol(upper, 1, std::max(radius.to_double(), width) / 64);
    if (!slope) return slope;
    const Ball tangent = upper - *above / *slope;
    const Ball chord = lower - *below * (upper - lower) / (*above - *below);
    if (certainly_less(tangent, upper)) upper = tangent.upper();
    if (certainly_less(lower, chord)) lower = chord.lower();
    if (!((upper - lower).upper_double() < 0.99 * width))
      return because("tangent and chord stood still at " + hull(lower, upper).to_text());
  }
  return hull(lower, upper);
}

}  // namespace

Theme exact_solutions() {
  const ValueParameter reflectivity = from_to_below("rho", "1/2", 0, 1);
  const ValueParameter outer{.name = "outer",
                             .default_text = "2",
                             .allowed = "a number > 1, the outer radius in units of the inner",
                             .allows = [](const Rational& x) { return x > Rational(1); }};
  const auto spheres = [&](const std::string& which, bool inner) {
    return ValueFamily{
        .name = "concentric_spheres_radiosity_of_" + which,
        .summary = "radiosity of the " + which + " of two concentric spheres of which the inner emits 1",
        .formula = "u_i = E_i + rho sum_j F_ij u_j",
        .source = "F = 1/outer^2, closure and reciprocity",
        .parameters = {outer, reflectivity},
        .route = by_formula("closed form",
                            [inner](const Arguments& a) {
                              const Rational& rho = a[1];
                              const Rational f = Rational(1) / (a[0] * a[0]);
                              const Rational u =
                                  rho * f / (Rational(1) - rho + rho * f * (Rational(1) - rho));
                              return Ball(inner ? Rational(1) + rho * u : u);
                            }),
        .second_route = by_integral("factor by an integral over the visible cap", digits_of_a_line,
                                    [inner](const Arguments& a, const Demand& demand) {
                                      return spheres_by_integral(a, demand, inner);
                                    })};
  };
  Theme theme;
  theme.families = {
      {.name = "sphere_radiosity_excess",
       .summary = "u - E on the unit sphere for E = exp(z) and a constant reflectivity",
       .formula = "rho/(1 - rho) sinh(1)",
       .source = "G = 1/4 on the unit sphere: m06 Lemma 1 (d)",
       .parameters = {reflectivity},
       .route = by_formula("closed form",
                           [](const Arguments& a) {
                             const Ball e = exp(Ball(1));
                             return Ball(a[0] / (Rational(1) - a[0])) * (e - Ball(1) / e) / Ball(2);
                           }),
       .second_route = by_integral("mean of E by an integral", digits_of_a_line, sphere_by_integral)},
      spheres("inner", true),
      spheres("outer", false),
      cube_family("floor", CubeFace::floor),
      cube_family("ceiling", CubeFace::ceiling),
      cube_family("wall", CubeFace::wall),
      {.name = "edge_exponent_90",
       .summary = "the exponent b in (0, 1) with which radiosity behaves like r^b beside an edge at which "
                  "two half planes meet at a "
                  "right angle",
       .formula = "(rho/4) B((b+2)/2, (1-b)/2) = 1",
       .source = "Mellin symbol of the operator between two half planes",
       .parameters = {strictly_between("rho", "1/2", 0, Rational(2))},
       .route = {.how = "bisection of the symbol by the gamma function", .enclose = exponent_by_beta},
       .second_route = {.how = "tangents and chords of the symbol as an enclosed integral",
                        .enclose = exponent_by_integral,
                        .most_digits = digits_of_a_search}},
  };
  theme.named = {
      {"sphere_exp_z_excess", "sphere_radiosity_excess", {Rational(1, 2)}},
      {"concentric_spheres_inner_radiosity", "concentric_spheres_radiosity_of_inner", {2, Rational(1, 2)}},
      {"concentric_spheres_outer_radiosity", "concentric_spheres_radiosity_of_outer", {2, Rational(1, 2)}},
      {"cube_floor_radiosity", "cube_radiosity_of_floor", {Rational(1, 2)}},
      {"cube_ceiling_radiosity", "cube_radiosity_of_ceiling", {Rational(1, 2)}},
      {"cube_wall_radiosity", "cube_radiosity_of_wall", {Rational(1, 2)}},
      {"edge_exponent_90_rho_1/2", "edge_exponent_90", {Rational(1, 2)}},
      {"edge_exponent_90_rho_9/10", "edge_exponent_90", {Rational(9, 10)}},
      {"edge_exponent_90_rho_1", "edge_exponent_90", {1}},
  };
  return theme;
}

}  // namespace radcert::reference::values
