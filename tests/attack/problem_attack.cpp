// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated solutions of random problems, against proofs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "tests/attack/problem_instance.h"

namespace radcert::attack {
namespace {

/// Two figures with radii must overlap.
bool overlap(const Approximation& a, const Approximation& b) {
  return std::abs(a.value - b.value) <= (a.radius + b.radius) * (1 + 0x1p-40);
}

Judgement judge_by_proof(const ProblemInstance& x) {
  std::optional<Problem> made;
  try {
    made = problem_of(x);
  } catch (const InputError&) {
    return Judgement::refused();
  }
  Problem proved = *made;
  proved.solver = {.name = "verified", .tolerance = std::nullopt};
  proved.quadrature.tolerance = Rational(1, 1000000000);
  const std::optional<LevelOutcome> level = solved(*made);
  if (!level || !level->result.solution_radius) return Judgement::refused();
  const std::optional<LevelOutcome> truth = solved(proved);
  if (!truth) return Judgement::refused();
  std::size_t values = 0;
  for (std::size_t i = 0; i < level->nodes.size(); ++i) {
    const double off = std::abs(level->nodes[i].u_n.value - truth->nodes[i].u_n.value);
    if (!(off <= *level->result.solution_radius + truth->nodes[i].u_n.radius))
      return Judgement::violated(
          off_text("u_n at node " + std::to_string(i), off, *level->result.solution_radius) +
          ", proved radius " + shortest(truth->nodes[i].u_n.radius));
    ++values;
  }
  for (const auto& [name, figure, exact] :
       {std::tuple{"discretisation_error", level->result.discretisation_error,
                   truth->result.discretisation_error},
        {"node_error", level->result.node_error, truth->result.node_error}}) {
    if (!figure || !figure->radius) continue;
    if (!overlap(*figure, *exact))
      return Judgement::violated(std::string(name) + " is " + shortest(figure->value) + " +- " +
                                 shortest(figure->radius) + ", proved " + shortest(exact->value) + " +- " +
                                 shortest(exact->radius));
    ++values;
  }
  return Judgement::held(values);
}

/// A polynomial, or anything. Of polynomials the operator is known in closed form on plane surfaces; of
/// others a proof takes minutes.
std::string random_solution(Draw& draw, bool polynomial) {
  const std::vector<std::string> coordinates{"x", "y", "z"};
  const auto coordinate = [&] { return coordinates[draw.below(3)]; };
  const std::string number = std::to_string(1 + draw.below(9));
  switch (draw.below(polynomial ? 3 : 8)) {
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

ProblemInstance with_random_data(Draw& draw, bool plane) {
  ProblemInstance x;
  x.surface = random_surface(draw, draw.below(2) == 0, plane, Extremes::seldom);
  draw_method(draw, x);
  // Proofs for other bases, and for finer levels, take minutes.
  x.level = 0;
  x.symmetric = false;
  x.nodes = {};
  x.degree = std::min(x.degree, 1);
  x.alpha = x.degree == 0 ? Rational(0) : std::vector{Rational(1, 6), Rational(1, 100)}[draw.below(2)];
  (draw.below(3) == 0 ? x.emission : x.solution) = everywhere(random_solution(draw, plane));
  // Those of random_reflectivity are proved to lie below 1 in minutes, where they are.
  const std::vector<std::string> reflectivities{"1/2", "0.3", "1/2 + sin(x + 2*y)/5", "9/10"};
  x.reflectivity = everywhere(reflectivities[draw.below(reflectivities.size())]);
  if (draw.below(2) == 0) {
    const std::vector<std::string>& pieces = x.surface.description->pieces;
    x.reflectivity.emplace_back(pieces[draw.below(pieces.size())], "1/5");
  }
  return x;
}

TEST(ProblemAttack, AgreesWithProofsOnPlaneSurfaces) {
  hold(Attack<ProblemInstance>{.name = "estimated problems, plane surfaces",
                               .usual_instances = 2,
                               .make = [](Draw& draw) { return with_random_data(draw, true); },
                               .judge = judge_by_proof,
                               .text = text,
                               .smaller = smaller});
}

TEST(ProblemAttack, AgreesWithProofsOnConvexMeshes) {
  hold(Attack<ProblemInstance>{.name = "estimated problems, convex meshes",
                               .usual_instances = 1,
                               .make =
                                   [](Draw& draw) {
                                     ProblemInstance x = with_random_data(draw, true);
                                     x.degree = std::min(x.degree, 1);
                                     if (x.degree == 0) x.alpha = 0;
                                     x.mesh = random_mesh(draw, false, draw.below(2) == 0);
                                     x.reflectivity = everywhere(x.reflectivity.front().second);
                                     return x;
                                   },
                               .judge = judge_by_proof,
                               .text = text,
                               .smaller = smaller});
}

TEST(ProblemAttack, AgreesWithProofsOnCurvedSurfaces) {
  hold(Attack<ProblemInstance>{.name = "estimated problems, curved surfaces",
                               .usual_instances = 1,
                               .make =
                                   [](Draw& draw) {
                                     ProblemInstance x = with_random_data(draw, false);
                                     if (draw.below(4) == 0)
                                       x.interpolated = static_cast<int>(1 + draw.below(2));
                                     return x;
                                   },
                               .judge = judge_by_proof,
                               .text = text,
                               .smaller = smaller});
}

}  // namespace
}  // namespace radcert::attack
