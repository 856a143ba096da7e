// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of points and polygons: PlaneElement against its accuracy, point_to_polygon and
// polygon_to_polygon as balls. The judges are Lambert's formula in space, a polar integral by Chebyshev
// rules, and the sum 1 of the factors of a closed body; they share no function with the library above
// rationals and balls.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "radcert/closed_form/plane_element.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/closed_form/polygon_to_polygon.h"
#include "tests/attack/attack.h"
#include "tests/attack/nasty_geometry.h"

namespace radcert::attack {
namespace {

using Polynomial = PlanePolynomial<Rational>;

/// Polygons in the parameters of a triangle's frame.
std::vector<PolygonLoop> shape(std::size_t kind) {
  const auto at = [](long s, long t) { return ParameterPoint<Rational>{Rational(s, 16), Rational(t, 16)}; };
  switch (kind) {
    case 1: return {{at(0, 0), at(16, 0), at(16, 16), at(8, 10), at(0, 16)}, {at(4, 4), at(4, 8), at(8, 4)}};
    case 2:  // a comb
      return {{at(0, 0), at(16, 0), at(16, 12), at(14, 12), at(14, 1), at(10, 1), at(10, 16), at(9, 16),
               at(9, 1), at(2, 1), at(2, 9), at(0, 9)}};
    case 3: return {{at(0, 0), at(16, 0), at(16, 16), at(0, 16)}};
    case 4:  // a frame as thin as a sixteenth
      return {{at(0, 0), at(16, 0), at(16, 16), at(0, 16)}, {at(1, 1), at(1, 15), at(15, 15), at(15, 1)}};
    default: return {{at(0, 0), at(16, 0), at(0, 16)}};
  }
}

judge::Polygon judged(const PlanePolygon& polygon) {
  const auto three = [](const Vector<Rational>& a) { return judge::Triple{a.x, a.y, a.z}; };
  judge::Polygon result{three(polygon.origin()), three(polygon.first()), three(polygon.second()), {}};
  for (const PolygonLoop& loop : polygon.loops()) {
    judge::Loop copy;
    for (const auto& at : loop) copy.push_back({at.s, at.t});
    result.loops.push_back(copy);
  }
  return result;
}

struct Instance {
  Sight sight;
  std::size_t shape = 0;
  double accuracy = 1e-14;
  int degree = 0;
  /// Powers (i, j) of monomials; a constant is added to odd ones, which then have no sign.
  std::vector<std::array<int, 2>> powers{};
  bool shifted = false;

  [[nodiscard]] PlanePolygon polygon() const {
    const Vector<Rational> a = exactly(sight.corners[0]);
    return plane_polygon(a, exactly(sight.corners[1]) - a, exactly(sight.corners[2]) - a,
                         attack::shape(shape))
        .value();
  }
  [[nodiscard]] std::vector<Polynomial> functions() const {
    std::vector<Polynomial> all;
    for (const auto& [i, j] : powers) {
      Polynomial q(i + j);
      q(i, j) = 1;
      if (shifted && i + j > 0) q(0, 0) = Rational(-1, 4);
      all.push_back(q);
    }
    return all;
  }
};

std::string text_of(const Instance& x) {
  std::string text = attack::text(x.sight) + "\nshape " + std::to_string(x.shape) + ", accuracy " +
                     shortest(x.accuracy) + (x.shifted ? ", shifted" : "") + ", powers";
  for (const auto& [i, j] : x.powers) text += " (" + std::to_string(i) + ", " + std::to_string(j) + ")";
  return text;
}

std::vector<Instance> simpler_instances(const Instance& x) {
  std::vector<Instance> all;
  Instance y = x;
  if (x.powers.size() > 1) {
    for (const auto& power : x.powers) {
      y.powers = {power};
      all.push_back(y);
    }
    y = x;
  }
  if (x.shape != 0) {
    y.shape = 0;
    all.push_back(y);
    y = x;
  }
  for (const Sight& sight : simpler(x.sight)) {
    y.sight = sight;
    all.push_back(y);
  }
  return all;
}

Instance drawn(Draw& draw, int lowest, int highest, bool polygons) {
  NastyGeometry nasty(draw);
  Instance x;
  x.sight = nasty.sight();
  x.shape = polygons && draw.below(4) == 0 ? 1 + draw.below(4) : 0;
  constexpr std::array accuracies{1e-14, 1e-14, 1e-14, 1e-13, 1e-10, 1e-5, 1e-3};
  x.accuracy = accuracies[draw.below(accuracies.size())];
  x.degree = lowest + static_cast<int>(draw.below(static_cast<std::size_t>(highest - lowest + 1)));
  if (x.degree <= 2) {
    for (int n = 0; n <= x.degree; ++n)
      for (int j = 0; j <= n; ++j) x.powers.push_back({n - j, j});
  } else {
    const int j = static_cast<int>(draw.below(static_cast<std::size_t>(x.degree + 1)));
    x.powers.push_back({x.degree - j, j});
  }
  x.shifted = draw.below(4) == 0;
  return x;
}

/// An upper bound of max |q| over the polygon: a monomial has its largest value on the boundary, and at 0 its
/// smallest.
double largest_value(const PlanePolygon& polygon, const Polynomial& q) {
  double largest = 0;
  double change = 0;
  for (const PolygonLoop& loop : polygon.loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto edge = loop[(k + 1) % loop.size()] - loop[k];
      constexpr int steps = 64;
      double before = abs(q.value(loop[k].s, loop[k].t)).to_double();
      for (int i = 1; i <= steps; ++i) {
        const auto at = loop[k] + Rational(i, steps) * edge;
        const double value = abs(q.value(at.s, at.t)).to_double();
        change = std::max(change, std::abs(value - before));
        largest = std::max(largest, value);
        before = value;
      }
    }
  }
  return largest + change;
}

/// The moments of the judge, narrow against `part` of Int G dS; none where it cannot say.
struct Truth {
  Ball whole;
  std::vector<Ball> moments{};  ///< in the order of Instance::powers
  bool known = false;
};

Truth truth(const PlanePolygon& polygon, const Instance& x, double part,
            judge::Behind behind = judge::Behind::left_out) {
  const judge::Polygon judged_polygon = judged(polygon);
  const judge::Triple p = triple(x.sight.p);
  const judge::Triple normal = triple(x.sight.normal);
  Truth result;
  constexpr std::array<std::array<int, 2>, 4> efforts{{{44, 128}, {96, 256}, {192, 640}, {192, 1600}}};
  for (const auto& [points, bits] : efforts) {
    const BallPrecision precision(bits);
    result.whole = judge::lambert_integral(judged_polygon, p, normal, behind);
    if (!result.whole.is_finite()) continue;
    const double size = abs(result.whole).lower_double();
    if (certainly_zero(result.whole)) {
      result.moments.assign(x.powers.size(), Ball(0));
      result.known = true;
      return result;
    }
    bool narrow = result.whole.radius() <= part * size;
    if (!narrow) continue;
    result.moments.clear();
    if (x.degree == 0) {
      result.moments.push_back(result.whole);
    } else {
      const judge::PolarIntegral integral(judged_polygon, p, normal, x.degree, points, behind);
      if (!overlaps(integral.moment(0, 0), result.whole)) throw std::logic_error("the judges disagree");
      for (const auto& [i, j] : x.powers) {
        Ball value = integral.moment(i, j);
        if (x.shifted && i + j > 0) value -= result.whole / 4;
        narrow = narrow && value.is_finite() && value.radius() <= part * size;
        result.moments.push_back(value);
      }
    }
    if (narrow) {
      result.known = true;
      return result;
    }
  }
  return result;
}

template <class Sizes>
Judgement held_within(const Instance& x, const Truth& exact, const std::vector<double>& values,
                      const Sizes& sizes, const std::string& how) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    const BallPrecision precision(256);
    const Ball error = abs(Ball(values[k]) - exact.moments[k]);
    const Ball allowed = Ball(x.accuracy) * abs(exact.whole) * Ball(sizes(k)) + Ball(0x1p-1074);
    if (certainly_at_most(error.lower(), allowed.upper())) continue;
    return Judgement::violated(how + ", function " + std::to_string(k) + ": " + shortest(values[k]) +
                               ", exactly " + exact.moments[k].to_text(25) + ", off by " +
                               (error / allowed).to_text(4) + " of what is allowed");
  }
  return Judgement::held();
}

Judgement judge_plane_element(const Instance& x) {
  const PlanePolygon polygon = x.polygon();
  const std::vector<Polynomial> functions = x.functions();
  const PlaneElement element(polygon, functions, x.accuracy);
  std::vector<double> values(functions.size());
  const PlaneElement::Route route = element.integrals(x.sight.p, x.sight.normal, values);
  const Truth exact = truth(polygon, x, 1e-4 * x.accuracy);
  if (!exact.known) return Judgement::refused();
  return held_within(
      x, exact, values, [&](std::size_t k) { return largest_value(polygon, functions[k]); },
      "route " + std::to_string(static_cast<int>(route)));
}

Attack<Instance> attack_on(const char* name, std::size_t usual, int lowest, int highest, bool polygons,
                           Judgement (*judgement)(const Instance&)) {
  return {.name = name,
          .usual_instances = usual,
          .make = [=](Draw& draw) { return drawn(draw, lowest, highest, polygons); },
          .judge = judgement,
          .text = text_of,
          .smaller = simpler_instances};
}

TEST(ClosedFormAttack, PlaneElementsOfConstants) {
  hold(attack_on("plane elements, constants", 250, 0, 0, true, judge_plane_element));
}

TEST(ClosedFormAttack, PlaneElementsOfPolynomials) {
  hold(attack_on("plane elements, degrees 1 to 8", 4, 1, 8, true, judge_plane_element));
}

Judgement judge_ball(const Instance& x) {
  const PlanePolygon polygon = x.polygon();
  const bool counted = x.accuracy > 1e-14;  // a third of them
  const Truth exact = truth(polygon, x, 1e-15, counted ? judge::Behind::counted : judge::Behind::left_out);
  if (!exact.known) return Judgement::refused();
  const std::vector<Polynomial> functions = x.functions();
  for (const long bits : {64L, 200L}) {
    const BallPrecision precision(bits);
    for (std::size_t k = 0; k < functions.size(); ++k) {
      const Ball value =
          point_to_polygon(exactly(x.sight.p), exactly(x.sight.normal), polygon, functions[k],
                           counted ? BehindTangentPlane::counted : BehindTangentPlane::left_out);
      if (!value.is_finite() || overlaps(value, exact.moments[k])) continue;
      return Judgement::violated("at " + std::to_string(bits) + " bits " + value.to_text(30) +
                                 ", the judge has " + exact.moments[k].to_text(30));
    }
  }
  return Judgement::held();
}

TEST(ClosedFormAttack, PointToPolygonOfConstants) {
  hold(attack_on("point_to_polygon, constants", 500, 0, 0, true, judge_ball));
}

TEST(ClosedFormAttack, PointToPolygonOfPolynomials) {
  hold(attack_on("point_to_polygon, degrees 1 to 8", 6, 1, 8, true, judge_ball));
}

struct Body {
  std::array<Point, 4> corners;
};

/// The factors from a side of a tetrahedron to the others have the sum 1.
Judgement judge_tetrahedron(const Body& body) {
  const auto& c = body.corners;
  const judge::Triple ab = judge::minus(triple(c[1]), triple(c[0]));
  const judge::Triple ac = judge::minus(triple(c[2]), triple(c[0]));
  const judge::Triple ad = judge::minus(triple(c[3]), triple(c[0]));
  const int turn = judge::dot(judge::cross(ab, ac), ad).sign();
  if (turn == 0) return Judgement::refused();
  // Counterclockwise as seen from within.
  std::array<std::array<std::size_t, 3>, 4> sides{{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  std::vector<PlanePolygon> polygons;
  for (auto side : sides) {
    if (turn < 0) std::swap(side[1], side[2]);
    polygons.push_back(
        plane_polygon({exactly(c[side[0]]), exactly(c[side[1]]), exactly(c[side[2]])}).value());
  }
  for (const long bits : {64L, 256L}) {
    const BallPrecision precision(bits);
    for (std::size_t i = 0; i < 4; ++i) {
      Ball sum;
      for (std::size_t j = 0; j < 4; ++j)
        if (j != i) sum += polygon_to_polygon(polygons[i], polygons[j]);
      if (sum.is_finite() && !sum.contains(1.0))
        return Judgement::violated("at " + std::to_string(bits) + " bits the factors of side " +
                                   std::to_string(i) + " have the sum " + sum.to_text(30));
    }
  }
  return Judgement::held();
}

TEST(ClosedFormAttack, PolygonToPolygon) {
  hold(Attack<Body>{
      .name = "polygon_to_polygon, closed bodies",
      .usual_instances = 2,
      .make =
          [](Draw& draw) {
            NastyGeometry nasty(draw);
            Body body;
            if (draw.below(2) == 0) {
              const auto [first, second] = nasty.nearly_coplanar_pair(draw.below(2) == 0 ? 8 : 27);
              body.corners = {first[0], first[1], first[2], second[2]};
            } else {
              const Sight sight = nasty.sight();
              body.corners = {sight.corners[0], sight.corners[1], sight.corners[2], sight.p};
            }
            return body;
          },
      .judge = judge_tetrahedron,
      .text =
          [](const Body& body) {
            std::string all;
            for (const Point& c : body.corners) all += attack::text(c) + " ";
            return all;
          },
  });
}

}  // namespace
}  // namespace radcert::attack
