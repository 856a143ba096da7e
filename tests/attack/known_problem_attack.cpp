// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated solutions of random problems whose discrete solution u_n is known exactly, since the basis
// reproduces it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "radcert/collocation/certified/certified_chart_entries.h"
#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/core/text.h"
#include "radcert/expression/parse.h"
#include "radcert/scalar/ball_precision.h"
#include "tests/attack/problem_instance.h"

namespace radcert::attack {
namespace {

/// A problem and its u_n.
struct Known {
  ProblemInstance problem;
  ByPiece u;
};

/// By how much a double is off the truth, rounded up.
double distance(double value, const Ball& truth) { return abs(Ball(value) - truth).upper_double(); }

/// The value of u at a point of a chart, by its parameters. A constant needs no exact chart.
Ball value_at(const Expression& u, const std::optional<PlaneChart>& plane,
              const ParameterPoint<Rational>& at) {
  if (const auto constant = u.is_constant()) return Ball(*constant);
  const Vector<Rational> p = plane.value().point(at);
  return u.evaluate<Ball>({Ball(p.x), Ball(p.y), Ball(p.z)});
}

ParameterPoint<Rational> middle(const ParameterPoint<Rational>& a, const ParameterPoint<Rational>& b) {
  return {(a.s + b.s) / Rational(2), (a.t + b.t) / Rational(2)};
}

/// The area of a plane element, and the integral of a polynomial of degree at most 3 over it, by the rule
/// with corners, midpoints and centroid.
std::pair<Ball, Ball> area_and_integral(const Expression& u, const PlaneChart& plane,
                                        const ParameterTriangle& triangle) {
  std::array<ParameterPoint<Rational>, 3> v;
  for (std::size_t c = 0; c < 3; ++c)
    v[c] = {Rational::exactly(triangle.vertices[c].s), Rational::exactly(triangle.vertices[c].t)};
  const auto value = [&](const ParameterPoint<Rational>& p) { return value_at(u, plane, p); };
  Ball sum;
  for (std::size_t c = 0; c < 3; ++c)
    sum += Ball(Rational(1, 20)) * value(v[c]) + Ball(Rational(2, 15)) * value(middle(v[c], v[(c + 1) % 3]));
  const Rational third(1, 3);
  sum +=
      Ball(Rational(9, 20)) * value({third * (v[0].s + v[1].s + v[2].s), third * (v[0].t + v[1].t + v[2].t)});
  const Vector<Rational> n = plane.over(v).normal();
  const Ball area = sqrt(Ball(dot(n, n))) * Ball(Rational(1, 2));
  return {area, area * sum};
}

/// The mean of u over each piece on which it is a constant or which is plane.
std::map<std::string, Ball> true_means(const Surface& surface, const Triangulation& triangulation,
                                       const PiecewiseExpression& u) {
  std::map<std::string, std::pair<Ball, Ball>> sums;
  std::map<std::string, Ball> means;
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    const std::string& piece = surface.charts[triangle.chart].facts().piece;
    const Expression& f = u.on(piece);
    if (const auto constant = f.is_constant()) {
      means[piece] = Ball(*constant);
      continue;
    }
    const auto [area, integral] =
        area_and_integral(f, plane_chart(surface, triangle.chart).value(), triangle);
    sums[piece].first += area;
    sums[piece].second += integral;
  }
  for (const auto& [piece, sum] : sums) means[piece] = sum.second / sum.first;
  return means;
}

PiecewiseExpression expression_of(const ByPiece& cases) {
  PiecewiseExpression function;
  for (const auto& [piece, expression] : cases)
    function.cases.push_back({piece, parse_expression(expression).value()});
  return function;
}

/// Every figure is known: u_n = u at the nodes, no errors, the means of u.
Judgement judge(const Known& x) {
  constexpr long bits = 256;
  const BallPrecision precision(bits);
  std::optional<Problem> made;
  try {
    made = problem_of(x.problem);
  } catch (const InputError&) {
    return Judgement::refused();
  }
  const Problem& problem = *made;
  const std::optional<LevelOutcome> level = solved(problem);
  if (!level || !level->result.solution_radius) return Judgement::refused();
  const LevelResult& result = level->result;
  const PiecewiseExpression u = expression_of(x.u);
  const Surface surface = surface_of(problem);
  const Triangulation triangulation = triangulation_of(problem, surface);
  const std::vector<SurfacePoint<Rational>> nodes =
      exact_collocation_nodes(triangulation, functions_of(problem));
  if (nodes.size() != level->nodes.size()) return Judgement::violated("other nodes");
  std::size_t values = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::string& piece = surface.charts[nodes[i].chart].facts().piece;
    if (piece != level->nodes[i].piece) return Judgement::violated("other pieces");
    const Ball truth = value_at(u.on(piece), plane_chart(surface, nodes[i].chart), nodes[i].at);
    const double off = distance(level->nodes[i].u_n.value, truth);
    if (!(off <= *result.solution_radius))
      return Judgement::violated(
          off_text("u_n at node " + std::to_string(i) + " on " + piece, off, *result.solution_radius));
    ++values;
  }
  const std::map<std::string, Ball> means = true_means(surface, triangulation, u);
  for (const auto& [piece, mean] : result.piece_means) {
    const double off = distance(mean.value, means.at(piece));
    if (!mean.has_radius()) return Judgement::violated("no radius of the mean over " + piece);
    if (!(off <= mean.radius)) return Judgement::violated(off_text("mean over " + piece, off, mean.radius));
    ++values;
  }
  for (const auto& [name, figure] :
       {std::pair{"discretisation_error", result.discretisation_error}, {"node_error", result.node_error}}) {
    if (!figure) continue;
    if (!(figure->value <= figure->radius))
      return Judgement::violated(off_text(name, figure->value, figure->radius));
    ++values;
  }
  return Judgement::held(values);
}

std::string known_text(const Known& x) { return text(x.problem); }

std::string random_number(Draw& draw) {
  const std::vector<std::string> numbers{"1",   "-3",    "1/1000", "1e10",     "-7/3",
                                         "0.1", "1e-12", "0",      "123456789"};
  return numbers[draw.below(numbers.size())];
}

/// A polynomial of at most that degree, as text.
std::string random_polynomial(Draw& draw, int degree) {
  std::string out = random_number(draw);
  for (std::size_t terms = degree == 0 ? 0 : draw.below(4); terms > 0; --terms) {
    out += " + (" + random_number(draw) + ")";
    for (std::size_t k = draw.below(static_cast<std::size_t>(degree) + 1); k > 0; --k)
      out += std::string("*") + std::vector{"x", "y", "z"}[draw.below(3)];
  }
  return out;
}

/// A function that the basis reproduces: a polynomial on a piece of affine charts, a number on others.
ByPiece reproduced(Draw& draw, const Surface& surface, int degree) {
  constexpr int most = 3;
  ByPiece cases;
  for (const std::string& piece : surface.piece_names()) {
    bool affine = true;
    for (std::size_t j = 0; j < surface.chart_count(); ++j)
      if (surface.charts[j].facts().piece == piece) affine = affine && plane_chart(surface, j).has_value();
    cases.emplace_back(piece,
                       affine ? random_polynomial(draw, std::clamp(degree, 0, most)) : random_number(draw));
  }
  if (draw.below(2) == 0 && std::all_of(cases.begin(), cases.end(), [&](const auto& c) {
        return c.second.find_first_of("xyz") != std::string::npos;
      }))
    return everywhere(cases.front().second);
  return cases;
}

/// What its surface needs for a solution that is known; nothing where surface or basis is refused.
std::optional<Problem> with_any_data(ProblemInstance x) {
  x.reflectivity = everywhere("0");
  x.solution = everywhere("0");
  try {
    return problem_of(x);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

ProblemInstance refused_instance() {
  ProblemInstance x;
  x.surface.description = find_surface("cube");
  x.reflectivity = everywhere("1");
  x.solution = everywhere("0");
  return x;
}

Known with_reproduced_solution(Draw& draw, ProblemInstance x) {
  const std::optional<Problem> problem = with_any_data(x);
  if (!problem) return {.problem = refused_instance(), .u = everywhere("0")};
  const Surface surface = surface_of(*problem);
  x.reflectivity = random_reflectivity(draw, surface.piece_names());
  x.solution = reproduced(draw, surface, functions_of(*problem).reproduced_degree());
  return {.problem = x, .u = x.solution};
}

std::vector<Known> smaller_with_solution(const Known& x) {
  std::vector<Known> found;
  for (ProblemInstance& y : smaller(x.problem)) {
    const auto keeps_u = [&] {
      // A basis of a lower degree reproduces constants only.
      const std::optional<Problem> before = with_any_data(x.problem);
      const std::optional<Problem> after = with_any_data(y);
      return before && after &&
             functions_of(*after).reproduced_degree() >= functions_of(*before).reproduced_degree();
    };
    // The emission of a bright piece is that of its surface.
    const bool other_factors = x.problem.solution.empty() && x.u.size() > 1 && !x.problem.mesh &&
                               y.surface.values != x.problem.surface.values;
    if (keeps_u() && !other_factors) found.push_back({.problem = y, .u = x.u});
  }
  if (!x.problem.solution.empty()) {
    Known y = x;
    y.u = y.problem.solution = everywhere("1");
    if (text(y.problem) != text(x.problem)) found.push_back(y);
  }
  return found;
}

Attack<Known> attack_of(std::string_view name, std::size_t usual, std::function<Known(Draw&)> make) {
  return {.name = name,
          .usual_instances = usual,
          .make = std::move(make),
          .judge = judge,
          .text = known_text,
          .smaller = smaller_with_solution};
}

TEST(KnownProblemAttack, FindsReproducedSolutionsOnTheCatalogue) {
  hold(attack_of("estimated problems, reproduced solutions", 12, [](Draw& draw) {
    ProblemInstance x;
    x.surface = random_surface(draw, draw.below(3) == 0, draw.below(3) == 0, Extremes::seldom);
    draw_method(draw, x);
    if (draw.below(8) == 0) x.grading = std::vector{Rational(2), Rational(3, 2), Rational(5)}[draw.below(3)];
    if (draw.below(6) == 0) {
      x.interpolated = static_cast<int>(1 + draw.below(2));
      x.on_interpolant = true;
    }
    return with_reproduced_solution(draw, x);
  }));
}

TEST(KnownProblemAttack, FindsReproducedSolutionsOnMeshes) {
  hold(attack_of("estimated problems, reproduced solutions on meshes", 6, [](Draw& draw) {
    ProblemInstance x;
    const bool closed = draw.below(2) == 0;
    x.mesh = random_mesh(draw, draw.below(2) == 0, closed);
    draw_method(draw, x);
    return with_reproduced_solution(draw, x);
  }));
}

/// A closed surface's E = (1 - rho) c, on each piece.
ByPiece emission_of_constant(const ByPiece& reflectivity, const std::string& c) {
  ByPiece emission;
  for (const auto& [piece, rho] : reflectivity)
    emission.emplace_back(piece, "(" + c + ")*(1 - (" + rho + "))");
  return emission;
}

TEST(KnownProblemAttack, FindsConstantsFromTheEmissionOfClosedSurfaces) {
  hold(attack_of("estimated problems, constants from the emission", 3, [](Draw& draw) {
    ProblemInstance x;
    draw_method(draw, x);
    switch (draw.below(4)) {
      case 0: x.mesh = random_mesh(draw, true, true); break;
      case 1: x.mesh = random_mesh(draw, false, true); break;
      default:
        x.surface = random_surface(draw, true, false, Extremes::seldom);
        if (draw.below(6) == 0) {
          x.interpolated = static_cast<int>(1 + draw.below(2));
          x.on_interpolant = true;
        }
    }
    const std::optional<Problem> problem = with_any_data(x);
    if (!problem) return Known{.problem = refused_instance(), .u = everywhere("0")};
    x.reflectivity = random_reflectivity(draw, surface_of(*problem).piece_names());
    const std::string c = random_number(draw);
    x.emission = emission_of_constant(x.reflectivity, c);
    return Known{.problem = x, .u = everywhere(c)};
  }));
}

// --- an emission that makes a plane piece differ by a constant from the rest
// -------------------------------------------------

std::string in_parentheses(const Rational& q) { return "(" + q.to_text() + ")"; }

/// c_0 + c_1 x + c_2 y + c_3 z
std::string linear_text(const Rational& c, const Vector<Rational>& by) {
  std::string out = in_parentheses(c);
  for (const auto& [factor, name] : {std::pair{by.x, "*x"}, {by.y, "*y"}, {by.z, "*z"}})
    if (factor != Rational(0)) out += "+" + in_parentheses(factor) + name;
  return "(" + out + ")";
}

/// Lambert's formula for the configuration factor from P = (x, y, z) with the inner normal n to a polygon
/// whose corners run counterclockwise as seen from P: -1/(2 pi) sum_i angle(v_i - P, v_i+1 - P)
/// n.(r_i)/|r_i|, r_i = (v_i - P) x (v_i+1 - v_i).
std::string factor_text(const std::vector<Vector<Rational>>& v, const Vector<Rational>& n) {
  std::string sum;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vector<Rational>& a = v[i];
    const Vector<Rational>& b = v[(i + 1) % v.size()];
    const Vector<Rational> e = b - a;
    const Vector<Rational> c = cross(a, e);
    // r = c - P x e
    const std::string rx = linear_text(c.x, {Rational(0), -e.z, e.y});
    const std::string ry = linear_text(c.y, {e.z, Rational(0), -e.x});
    const std::string rz = linear_text(c.z, {-e.y, e.x, Rational(0)});
    const std::string size = "sqrt(" + rx + "^2+" + ry + "^2+" + rz + "^2)";
    // n.r = n.c - (e x n).P
    const Vector<Rational> turned = cross(e, n);
    const std::string along = linear_text(dot(n, c), Rational(-1) * turned);
    const auto difference = [](const Rational& q, const char* name) {
      return "(" + in_parentheses(q) + "-" + name + ")";
    };
    const std::string product = "(" + difference(a.x, "x") + "*" + difference(b.x, "x") + "+" +
                                difference(a.y, "y") + "*" + difference(b.y, "y") + "+" +
                                difference(a.z, "z") + "*" + difference(b.z, "z") + ")";
    sum +=
        (i > 0 ? "+" : "") + std::string("(pi/2-atan(") + product + "/" + size + "))*" + along + "/" + size;
  }
  return "(-(" + sum + ")/(2*pi*sqrt(" + dot(n, n).to_text() + ")))";
}

/// The corners of a plane chart, counterclockwise about its inner normal.
std::vector<Vector<Rational>> corners(const PlaneChart& plane, ChartDomain domain) {
  std::vector<Vector<Rational>> v{plane.origin, plane.origin + plane.first};
  if (domain == ChartDomain::unit_square) v.push_back(plane.origin + plane.first + plane.second);
  v.push_back(plane.origin + plane.second);
  if (plane.orientation == Orientation::against_the_cross_product) std::reverse(v.begin(), v.end());
  return v;
}

TEST(KnownProblemAttack, FindsPiecewiseConstantsFromTheEmissionOfPlaneSurfaces) {
  hold(attack_of("estimated problems, piecewise constants from the emission", 10, [](Draw& draw) {
    ProblemInstance x;
    draw_method(draw, x);
    x.surface = random_surface(draw, false, true, Extremes::seldom);
    const Known refused{.problem = refused_instance(), .u = everywhere("0")};
    const std::optional<Problem> problem = with_any_data(x);
    if (!problem) return refused;
    const Surface surface = surface_of(*problem);
    const std::vector<std::string> pieces = surface.piece_names();
    if (pieces.size() != surface.chart_count()) return refused;
    x.reflectivity = random_reflectivity(draw, pieces);
    const PiecewiseExpression rho = expression_of(x.reflectivity);
    const std::size_t bright = draw.below(pieces.size());
    const std::string b = random_number(draw);
    const std::string a = surface.closed ? random_number(draw) : "0";
    const auto corners_of_bright =
        corners(plane_chart(surface, bright).value(), surface.charts[bright].facts().domain);
    Known known;
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      const std::string r = rho.on(pieces[j]).text();
      std::string e = a == "0" ? "0" : "(" + a + ")*(1-(" + r + "))";
      if (j == bright)
        e += "+(" + b + ")";
      else
        e += "-(" + b + ")*(" + r + ")*" + factor_text(corners_of_bright, plane_chart(surface, j)->normal());
      if (!parse_expression(e)) return refused;  // too long
      x.emission.emplace_back(pieces[j], e);
      const Rational value =
          Rational::parse(a).value() + (j == bright ? Rational::parse(b).value() : Rational(0));
      known.u.emplace_back(pieces[j], value.to_text());
    }
    known.problem = x;
    return known;
  }));
}

}  // namespace
}  // namespace radcert::attack
