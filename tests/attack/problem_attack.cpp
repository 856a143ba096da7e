// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated solutions of random problems, against constants, which every closed surface reproduces, and against proofs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/expression/parse.h"
#include "radcert/polynomial/symmetric_nodes.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"
#include "tests/attack/attack.h"
#include "tests/attack/random_problem.h"

namespace radcert::attack {
namespace {

struct Instance {
  RandomSurface surface;
  std::string reflectivity;
  std::string solution;      ///< u, where `by_emission` is false
  bool by_emission = false;  ///< `solution` stands for E then
  int level = 0;
  int degree = 1;
  Rational alpha = Rational(1, 6);
  bool symmetric = false;
  int interpolated = 0;  ///< the degree, or 0: exact
  SolverName solver = SolverName::direct;
  Rational tolerance = Rational(1, 10000000);
};

PiecewiseExpression everywhere(const std::string& text) { return {{{"*", parse_expression(text).value()}}}; }

Problem problem_of(const Instance& x) {
  Problem problem{.surface = {.name = x.surface.description->name, .parameters = {}},
                  .triangulation = {.levels = {x.level}, .pattern = {}, .grading = 1},
                  .basis = {.degree = x.degree, .alpha = x.alpha},
                  .reflectivity = everywhere(x.reflectivity),
                  .solution = std::nullopt,
                  .emission = std::nullopt,
                  .solver = {.name = x.solver, .tolerance = std::nullopt}};
  for (std::size_t i = 0; i < x.surface.values.size(); ++i)
    problem.surface.parameters.push_back({x.surface.description->parameters[i].name, x.surface.values[i]});
  (x.by_emission ? problem.emission : problem.solution) = everywhere(x.solution);
  problem.quadrature.tolerance = x.tolerance;
  if (x.interpolated > 0)
    problem.geometry = InterpolatedGeometry{.degree = x.interpolated, .data = DataPoints::surface};
  return problem;
}

std::string text(const Instance& x) {
  return x.surface.text() + ", level " + std::to_string(x.level) + ", degree " + std::to_string(x.degree) +
         ", alpha " + x.alpha.to_text() + ", rho = " + x.reflectivity + ", " +
         (x.by_emission ? "E = " : "u = ") + x.solution + ", " + solver_name(x.solver) + ", tolerance " +
         x.tolerance.to_text() +
         (x.interpolated > 0 ? ", interpolated by degree " + std::to_string(x.interpolated) : "");
}

/// The second route of the program.
AppliedOperator route(const Surface& surface, const SurfaceFunction& u) {
  const reference::Density density = [&u](const reference::PointBlock& q, std::span<double> values) {
    u.evaluate(q.chart, q.x, q.y, q.z, values);
  };
  return
      [applied = reference::AppliedOperator(surface, density, u.formulas())](const SurfacePoint<double>& p) {
        const reference::Estimate integral = applied(p);
        return OperatorValue{.value = integral.value, .radius = integral.radius};
      };
}

/// The level, or nothing where it is refused with a name.
std::optional<LevelOutcome> solved(const Problem& problem) {
  try {
    check(problem, std::uint64_t{1} << 32U);
    return solve_level(problem, problem.triangulation.levels.front(), route);
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const AccuracyNotReached&) {
    return std::nullopt;
  }
}

Instance make_instance(Draw& draw, bool closed, bool plane) {
  Instance x;
  x.surface = random_surface(draw, closed, plane);
  x.degree = static_cast<int>(draw.below(4));
  const std::vector<Rational> alphas{Rational(1, 6), Rational(1, 10), Rational(3, 10), Rational(1, 100),
                                     Rational(1, 100000)};
  x.alpha = x.degree == 0 ? Rational(0) : alphas[draw.below(alphas.size())];
  const std::vector<std::string> reflectivities{"1/2", "0.999", "0", "1/1000", "9/10"};
  x.reflectivity = reflectivities[draw.below(reflectivities.size())];
  x.solver = std::vector{SolverName::direct, SolverName::gmres, SolverName::neumann}[draw.below(3)];
  x.tolerance = draw.below(3) == 0 ? Rational(1, 1000000) : Rational(1, 10000000000000);
  x.level = draw.below(8) == 0 ? 1 : 0;
  return x;
}

std::string off_text(const std::string& what, double off, double radius) {
  return what + " is off by " + shortest(off) + ", radius " + shortest(radius);
}

/// Of a constant u every figure is known: errors 0, means and values u.
Judgement judge_constant(const Instance& x) {
  Problem problem = problem_of(x);
  const double u = parse_expression(x.solution).value().is_constant()->to_double();
  if (x.by_emission) problem.emission = everywhere("(" + x.solution + ")*(1 - (" + x.reflectivity + "))");
  const std::optional<LevelOutcome> level = solved(problem);
  if (!level) return Judgement::refused();
  const LevelResult& result = level->result;
  const double rounding = 0x1p-53 * std::abs(u);
  if (!result.solution_radius || !result.means_radius) return Judgement::violated("no radius");
  for (const NodeValue& node : level->nodes)
    if (!(std::abs(node.u_n - u) <= *result.solution_radius + rounding))
      return Judgement::violated(off_text("u_n", node.u_n - u, *result.solution_radius));
  for (const auto& [piece, mean] : result.piece_means)
    if (!(std::abs(mean - u) <= *result.means_radius + rounding))
      return Judgement::violated(off_text("mean over " + piece, mean - u, *result.means_radius));
  for (const auto& [name, figure] :
       {std::pair{"discretisation_error", result.discretisation_error}, {"node_error", result.node_error}})
    if (figure && !(figure->value <= *figure->radius + rounding))
      return Judgement::violated(off_text(name, figure->value, *figure->radius));
  return Judgement::held();
}

std::vector<Instance> smaller(const Instance& x) {
  std::vector<Instance> found;
  const auto with = [&](const auto& change) {
    found.push_back(x);
    change(found.back());
  };
  if (x.level > 0) with([](Instance& y) { y.level = 0; });
  if (x.degree > 0)
    with([](Instance& y) {
      y.degree = 0;
      y.alpha = 0;
    });
  if (x.degree > 1) with([](Instance& y) { y.degree = 1; });
  if (x.solver != SolverName::direct) with([](Instance& y) { y.solver = SolverName::direct; });
  if (x.reflectivity != "1/2") with([](Instance& y) { y.reflectivity = "1/2"; });
  for (std::size_t i = 0; i < x.surface.values.size(); ++i)
    if (x.surface.values[i] != Rational(1) && x.surface.description->parameters[i].admits(Rational(1)))
      with([i](Instance& y) { y.surface.values[i] = 1; });
  return found;
}

TEST(ProblemAttack, ReproducesConstantsWithinTheRadii) {
  hold(Attack<Instance>{.name = "estimated problems, constant solutions",
                        .usual_instances = 4,
                        .make =
                            [](Draw& draw) {
                              Instance x = make_instance(draw, true, false);
                              x.by_emission = draw.below(2) == 0;
                              const std::vector<std::string> constants{"1", "-3", "1/1000", "1e10"};
                              x.solution = constants[draw.below(constants.size())];
                              return x;
                            },
                        .judge = judge_constant,
                        .text = text,
                        .smaller = smaller});
}

/// Two figures with radii must overlap.
bool overlap(const Figure& a, const Figure& b) {
  return std::abs(a.value - b.value) <= (*a.radius + *b.radius) * (1 + 0x1p-40);
}

Judgement judge_by_proof(const Instance& x) {
  const Problem problem = problem_of(x);
  Problem proved = problem;
  proved.solver = {.name = SolverName::verified, .tolerance = std::nullopt};
  proved.quadrature.tolerance = Rational(1, 1000000000);
  const std::optional<LevelOutcome> level = solved(problem);
  if (!level || !level->result.solution_radius) return Judgement::refused();
  const std::optional<LevelOutcome> truth = solved(proved);
  if (!truth) return Judgement::refused();
  for (std::size_t i = 0; i < level->nodes.size(); ++i) {
    const double off = std::abs(level->nodes[i].u_n - truth->nodes[i].u_n);
    if (!(off <= *level->result.solution_radius + *truth->nodes[i].radius))
      return Judgement::violated(
          off_text("u_n at node " + std::to_string(i), off, *level->result.solution_radius) +
          ", proved radius " + shortest(*truth->nodes[i].radius));
  }
  for (const auto& [name, figure, exact] :
       {std::tuple{"discretisation_error", level->result.discretisation_error,
                   truth->result.discretisation_error},
        {"node_error", level->result.node_error, truth->result.node_error}})
    if (figure && figure->radius && !overlap(*figure, *exact))
      return Judgement::violated(std::string(name) + " is " + shortest(figure->value) + " +- " +
                                 shortest(*figure->radius) + ", proved " + shortest(exact->value) + " +- " +
                                 shortest(*exact->radius));
  return Judgement::held();
}

std::string random_solution(Draw& draw) {
  const std::vector<std::string> coordinates{"x", "y", "z"};
  const auto coordinate = [&] { return coordinates[draw.below(3)]; };
  const std::string number = std::to_string(1 + draw.below(9));
  switch (draw.below(8)) {
    case 0: return coordinate();
    case 1: return number + " + " + coordinate() + "*" + coordinate() + "/10 - " + coordinate() + "^2/5";
    case 2: return coordinate() + "^" + std::to_string(1 + draw.below(6)) + " - " + number;
    case 3: return "exp(" + coordinate() + " - " + coordinate() + ")";
    case 4: return "1/sqrt(x^2 + y^2 + (z + " + number + "/4)^2 + 1/10)";
    case 5: return "sin(" + number + "*" + coordinate() + ") + 1e8*" + coordinate();
    case 6: return "1/(" + coordinate() + " + 1.0000" + number + ")";
    default: return "1e-8*" + coordinate() + " + cos(" + number + "*" + coordinate() + ")/3";
  }
}

Instance with_random_data(Draw& draw, bool plane) {
  Instance x = make_instance(draw, draw.below(2) == 0, plane);
  x.solution = random_solution(draw);
  x.by_emission = draw.below(3) == 0;
  const std::vector<std::string> reflectivities{"1/2", "0.3", "1/2 + sin(x + 2*y)/5", "9/10"};
  x.reflectivity = reflectivities[draw.below(reflectivities.size())];
  return x;
}

TEST(ProblemAttack, AgreesWithProofsOnPlaneSurfaces) {
  hold(Attack<Instance>{.name = "estimated problems, plane surfaces",
                        .usual_instances = 3,
                        .make =
                            [](Draw& draw) {
                              Instance x = with_random_data(draw, true);
                              x.level = 0;
                              return x;
                            },
                        .judge = judge_by_proof,
                        .text = text,
                        .smaller = smaller});
}

TEST(ProblemAttack, AgreesWithProofsOnCurvedSurfaces) {
  hold(Attack<Instance>{.name = "estimated problems, curved surfaces",
                        .usual_instances = 1,
                        .make =
                            [](Draw& draw) {
                              Instance x = with_random_data(draw, false);
                              x.level = 0;
                              x.degree = std::min(x.degree, 1);
                              if (x.degree == 0) x.alpha = 0;
                              if (draw.below(4) == 0) x.interpolated = static_cast<int>(1 + draw.below(2));
                              return x;
                            },
                        .judge = judge_by_proof,
                        .text = text,
                        .smaller = smaller});
}

}  // namespace
}  // namespace radcert::attack
