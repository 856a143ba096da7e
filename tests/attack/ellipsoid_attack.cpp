// SPDX-License-Identifier: GPL-3.0-or-later
// T on ellipsoids against its integral as it is in space, by brute force in long double; solutions that are
// known: constants in furnaces whose walls reflect unequally, and the closed form on spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/continuous/ellipsoid/ellipsoid_enclosure.h"
#include "radcert/core/text.h"
#include "radcert/expression/parse.h"
#include "tests/attack/attack.h"
#include "tests/continuous/ellipsoid_judge.h"

namespace radcert::attack {
namespace {

/// c x^i y^j z^k, c in hundredths.
struct Monomial {
  long hundredths = 0;
  std::array<int, 3> powers{};
};
using Terms = std::vector<Monomial>;

std::string text_of(const Terms& terms) {
  std::string out = "0";
  for (const Monomial& term : terms) {
    out += " + (" + std::to_string(term.hundredths) + "/100)";
    for (std::size_t k = 0; k < 3; ++k)
      if (term.powers[k] > 0) out += std::string("*") + "xyz"[k] + "^" + std::to_string(term.powers[k]);
  }
  return out;
}

long double value_of(const Terms& terms, const judge::Triple& at) {
  long double sum = 0;
  for (const Monomial& term : terms) {
    long double product = static_cast<long double>(term.hundredths) / 100;
    for (std::size_t k = 0; k < 3; ++k)
      for (int i = 0; i < term.powers[k]; ++i) product *= at[k];
    sum += product;
  }
  return sum;
}

Terms drawn_terms(Draw& draw, std::size_t most, int degree, long largest) {
  Terms out;
  const std::size_t count = draw.below(most) + 1;
  for (std::size_t t = 0; t < count; ++t) {
    Monomial term;
    term.hundredths = static_cast<long>(draw.below(static_cast<std::size_t>(2 * largest + 1))) - largest;
    for (int left = static_cast<int>(draw.below(static_cast<std::size_t>(degree + 1))); left > 0; --left)
      ++term.powers[draw.below(3)];
    out.push_back(term);
  }
  return out;
}

/// In hundredths: equal, almost equal, and up to about 1:3.
std::array<long, 3> drawn_axes(Draw& draw) {
  std::array<long, 3> out{100, 100, 100};
  if (draw.below(6) == 0) return out;
  for (long& axis : out) {
    const std::size_t kind = draw.below(4);
    if (kind == 1) axis += 1;
    if (kind > 1) axis += static_cast<long>(draw.below(180));
  }
  return out;
}

std::array<double, 3> drawn_point(Draw& draw) {
  if (draw.below(4) == 0) {
    std::array<double, 3> out{};
    out[draw.below(3)] = draw.below(2) == 0 ? 1 : -1;
    return out;
  }
  const double z = 2 * draw.unit() - 1;
  const double angle = 7 * draw.unit();
  const double sine = std::sqrt(1 - z * z);
  return {sine * std::cos(angle), sine * std::sin(angle), z};
}

Vector<Rational> exact(const std::array<long, 3>& axes) {
  return {Rational(axes[0], 100), Rational(axes[1], 100), Rational(axes[2], 100)};
}
judge::Triple in_long(const std::array<long, 3>& axes) {
  judge::Triple out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = static_cast<long double>(axes[k]) / 100;
  return out;
}

std::string off_text(const std::string& what, long double off, double radius) {
  return what + " is off by " + shortest(static_cast<double>(off)) + ", the radius is " + shortest(radius);
}

struct Instance {
  std::array<long, 3> axes{};
  Terms emission, reflectivity, reflected;
  std::array<double, 3> point{};
  double tolerance = 0;
};

std::string text(const Instance& x) {
  std::string out = "half axes";
  for (const long axis : x.axes) out += " " + std::to_string(axis) + "/100";
  out += ", E = " + text_of(x.emission) + ", rho = " + text_of(x.reflectivity) +
         ", q = " + text_of(x.reflected) + ", at";
  for (const double p : x.point) out += " " + shortest(p);
  return out + ", tolerance " + shortest(x.tolerance);
}

std::vector<Instance> smaller(const Instance& x) {
  std::vector<Instance> out;
  for (Terms Instance::*const terms : {&Instance::emission, &Instance::reflectivity, &Instance::reflected})
    for (std::size_t t = 0; t < (x.*terms).size(); ++t) {
      Instance less = x;
      (less.*terms).erase((less.*terms).begin() + static_cast<std::ptrdiff_t>(t));
      out.push_back(less);
    }
  for (std::size_t k = 0; k < 3; ++k)
    if (x.axes[k] != 100) {
      out.push_back(x);
      out.back().axes[k] = 100;
    }
  return out;
}

SpherePolynomial along(const Terms& terms, const std::array<long, 3>& axes) {
  return SpherePolynomial::along(parse_expression(text_of(terms)).value(), exact(axes)).value();
}

Judgement judge_transport(const Instance& x) {
  const EllipsoidShape shape(exact(x.axes));
  const EllipsoidDensity w{.emission = along(x.emission, x.axes),
                           .reflectivity = along(x.reflectivity, x.axes),
                           .reflected = along(x.reflected, x.axes)};
  const Approximation value = EllipsoidTransport(shape, w, x.tolerance)({x.point[0], x.point[1], x.point[2]});
  if (!value.has_radius()) return Judgement::refused();
  const judge::Triple p = judge::direction(x.point[0], x.point[1], x.point[2]);
  const auto density = [&](const judge::Triple& q) {
    return value_of(x.emission, q) + value_of(x.reflectivity, q) * value_of(x.reflected, q);
  };
  const long double truth = judge::transported(in_long(x.axes), p, density, 10, 160);
  const long double other = judge::transported(in_long(x.axes), p, density, 8, 130);
  const long double off = std::abs(truth - static_cast<long double>(value.value));
  // What the judge itself may be off, from two of its rules.
  if (!(off <= value.radius + 10 * std::abs(truth - other)))
    return Judgement::violated(off_text("T w", off, value.radius));
  return Judgement::held(1);
}

TEST(EllipsoidAttack, TransportIsWithinItsRadius) {
  hold(Attack<Instance>{.name = "T w on ellipsoids",
                        .usual_instances = 200,
                        .make =
                            [](Draw& draw) {
                              Instance x;
                              x.axes = drawn_axes(draw);
                              x.emission = drawn_terms(draw, 4, 6, 300);
                              x.reflectivity = drawn_terms(draw, 2, 2, 50);
                              x.reflected = drawn_terms(draw, 4, 6, 300);
                              x.point = drawn_point(draw);
                              x.tolerance = std::pow(10.0, -12 * draw.unit());
                              return x;
                            },
                        .judge = judge_transport,
                        .text = text,
                        .smaller = smaller});
}

/// On a sphere u = E + rho mean(E) / (1 - rho) where rho is constant; otherwise E = (1 - rho) c and u = c, c
/// the number in `reflected`.
Judgement judge_solution(const Instance& x) {
  const bool is_furnace = x.emission.empty();
  const std::string rho = text_of(x.reflectivity);
  const std::string e =
      is_furnace ? "(1 - (" + rho + "))*(" + text_of(x.reflected) + ")" : text_of(x.emission);
  const Outcome<EllipsoidEnclosure> found =
      enclose_on_ellipsoid({.half_axes = exact(x.axes),
                            .reflectivity = parse_expression(rho).value(),
                            .emission = parse_expression(e).value()},
                           x.tolerance);
  if (!found || !std::isfinite(found->bound)) return Judgement::refused();
  const judge::Triple a = in_long(x.axes);
  const long double constant = value_of(x.reflectivity, {});
  const long double mean =
      is_furnace ? value_of(x.reflected, {})
                 : judge::mean_over(
                       a, [&](const judge::Triple& q) { return value_of(x.emission, q); }, 2, 30) /
                       (1 - constant);
  const auto u = [&](const judge::Triple& p) {
    if (is_furnace) return mean;
    return value_of(x.emission, {a[0] * p[0], a[1] * p[1], a[2] * p[2]}) + constant * mean;
  };
  const long double judge_error = 1e-16L * (1 + std::abs(mean));
  const long double off_mean = std::abs(mean - static_cast<long double>(found->mean.value));
  if (!(off_mean <= found->mean.radius + judge_error))
    return Judgement::violated(off_text("the mean", off_mean, found->mean.radius));
  Draw draw(7);
  constexpr std::size_t points = 20;
  for (std::size_t k = 0; k < points; ++k) {
    const std::array<double, 3> at = k == 0 ? x.point : drawn_point(draw);
    const Approximation value = found->at({at[0], at[1], at[2]});
    const long double off =
        std::abs(u(judge::direction(at[0], at[1], at[2])) - static_cast<long double>(value.value));
    if (!(off <= value.radius + judge_error)) return Judgement::violated(off_text("u", off, value.radius));
  }
  return Judgement::held(points + 1);
}

TEST(EllipsoidAttack, KnownSolutionsAreWithinTheirBounds) {
  hold(Attack<Instance>{.name = "solutions on ellipsoids",
                        .usual_instances = 100,
                        .make =
                            [](Draw& draw) {
                              Instance x;
                              x.point = drawn_point(draw);
                              x.tolerance = std::pow(10.0, 1 - 8 * draw.unit());
                              if (draw.below(3) == 0) {
                                x.axes.fill(20 + static_cast<long>(draw.below(200)));
                                x.emission = drawn_terms(draw, 4, 6, 300);
                                x.reflectivity = {{static_cast<long>(draw.below(100)), {}}};
                                return x;
                              }
                              x.axes = drawn_axes(draw);
                              for (long& axis : x.axes) axis = std::min(axis, 190L);
                              x.reflectivity = drawn_terms(draw, 2, 2, 4);
                              x.reflectivity.push_back({40, {}});
                              x.reflected = {{static_cast<long>(draw.below(1000)) - 500, {}}};
                              return x;
                            },
                        .judge = judge_solution,
                        .text = text,
                        .smaller = smaller});
}

}  // namespace
}  // namespace radcert::attack
