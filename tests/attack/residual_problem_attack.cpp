// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated solutions u_n of random problems with an emission, against the residual of their system by the
// reference layer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/collocation/assembly.h"
#include "radcert/collocation/certified/certified_chart_entries.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/polynomial/triangle_basis.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/solve/direct.h"
#include "radcert/triangulation/interpolated_surface.h"
#include "tests/attack/problem_instance.h"

namespace radcert::attack {
namespace {

/// A number and how far it may be off.
struct Known {
  double value = 0;
  double radius = 0;
};

/// The value of an expression at a node of exact parameters.
Ball value_at(const Expression& f, const Surface& surface, const SurfacePoint<Rational>& node) {
  const Vector<Ball> p =
      surface.charts[node.chart].in<Ball>().frame({Ball(node.at.s), Ball(node.at.t)}).point;
  return f.evaluate<Ball>({p.x, p.y, p.z});
}

/// Int_S G u_n dS at a node, element by element.
Known integral_of_u_n(const Surface& surface, const Triangulation& triangulation,
                      const TriangleBasis<double>& basis, std::span<const double> u_n,
                      const SurfacePoint<double>& node) {
  Known sum;
  const std::size_t functions = basis.size();
  for (std::size_t k = 0; k < triangulation.triangles.size(); ++k) {
    const ParameterTriangle& t = triangulation.triangles[k];
    const std::span<const double> values = u_n.subspan(k * functions, functions);
    const ParameterPoint<double> e = t.vertices[1] - t.vertices[0];
    const ParameterPoint<double> f = t.vertices[2] - t.vertices[0];
    const double whole = cross(e, f);
    const auto density = [&](const SurfacePoint<double>& q, const Vector<double>&) {
      const ParameterPoint<double> d = q.at - t.vertices[0];
      const double x2 = cross(d, f) / whole;
      const double x3 = cross(e, d) / whole;
      std::array<double, 45> at{};
      basis.values({{1 - x2 - x3, x2, x3}}, at);
      double value = 0;
      for (std::size_t j = 0; j < functions; ++j) value += at[j] * values[j];
      return value;
    };
    const Approximation part =
        reference::operator_integral(surface, node, t.chart, t.vertices, reference::Density(density));
    sum.value += part.value;
    sum.radius += part.radius + 1e-15 * std::abs(part.value);
  }
  return sum;
}

/// The defect r = E - (I - K_n) u_n at the nodes gives the error: (I - K_n)^-1 r, for which K_n need only be
/// known roughly.
Judgement judge_level(const ProblemInstance& x, const Problem& problem, const LevelOutcome& level) {
  const BallPrecision precision(128);
  const double radius = *level.result.solution_radius;
  const Surface surface = surface_of(problem);
  const Triangulation triangulation = triangulation_of(problem, surface);
  const TriangleBasis<double> basis = triangle_basis(triangle_basis_of(problem.method));
  const std::vector<SurfacePoint<Rational>> nodes =
      exact_collocation_nodes(triangulation, functions_of(problem));
  std::vector<double> u_n;
  for (const NodeValue& node : level.nodes) u_n.push_back(node.u_n.value);

  InterpolatedSurface integrals{.surface = surface, .triangulation = triangulation};
  if (x.interpolated > 0) integrals = interpolate(surface, triangulation, x.interpolated);
  const auto observers = collocation_nodes<double>(integrals.surface, integrals.triangulation, basis);
  std::vector<double> rho;
  std::vector<double> defects;
  double judge_radius = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::string& piece = surface.charts[nodes[i].chart].facts().piece;
    const Ball e = value_at(problem.emission->on(piece), surface, nodes[i]);
    const Ball r = value_at(problem.reflectivity.on(piece), surface, nodes[i]);
    rho.push_back(r.to_double());
    Known integral;
    if (rho.back() > 0)
      integral = integral_of_u_n(integrals.surface, integrals.triangulation, basis, u_n, observers[i].at);
    const Ball k_u_n = r / Ball::pi() * Ball(integral.value);
    const Ball defect = e - Ball(u_n[i]) + k_u_n;
    defects.push_back(defect.to_double());
    judge_radius =
        std::max(judge_radius, defect.radius() + rho.back() * integral.radius + 1e-18 * std::abs(u_n[i]));
  }
  const CollocationMatrix<double> matrix =
      assemble<double>(integrals.surface, integrals.triangulation, basis, observers, rho, Tolerance(1e-6));
  const DirectSolver rough(matrix.entries);
  const double inverse = rough.inverse_norm();
  const std::vector<double> errors = rough.solve(defects);
  const double from_judge = 1.01 * inverse * judge_radius;
  // A judge that knows less than what it judges says nothing.
  if (!(from_judge <= radius)) return Judgement::refused();
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (!(std::abs(errors[i]) * (1 - 1e-3) <= radius + from_judge))
      return Judgement::violated(off_text("u_n at node " + std::to_string(i), errors[i], radius) +
                                 ", known within " + shortest(from_judge));
  return Judgement::held(errors.size());
}

Judgement judge(const ProblemInstance& x) {
  try {
    const Problem problem = problem_of(x);
    const std::optional<LevelOutcome> level = solved(problem);
    if (!level || !level->result.solution_radius) return Judgement::refused();
    return judge_level(x, problem, *level);
  } catch (const InputError&) {
    return Judgement::refused();
  } catch (const AccuracyNotReached&) {
    return Judgement::refused();  // of the reference layer, beside interpolants that are thin
  }
}

std::string random_emission(Draw& draw) {
  const auto coordinate = [&draw] { return std::string(std::vector{"x", "y", "z"}[draw.below(3)]); };
  const std::string number = std::to_string(1 + draw.below(9));
  switch (draw.below(6)) {
    case 0: return coordinate();
    case 1: return number + " + " + coordinate() + "*" + coordinate();
    case 2: return "exp(-" + coordinate() + "^2)";
    case 3: return "abs(" + coordinate() + " - 1/3)";
    case 4: return "1e8*" + coordinate() + " - 1/" + number;
    default: return "sin(" + number + "*" + coordinate() + ")/" + number;
  }
}

TEST(ResidualProblemAttack, LeavesNoDefectBeyondItsRadius) {
  hold(Attack<ProblemInstance>{.name = "estimated problems, residuals",
                               .usual_instances = 1,
                               .make =
                                   [](Draw& draw) {
                                     ProblemInstance x;
                                     x.surface =
                                         random_surface(draw, draw.below(2) == 0, false, Extremes::seldom);
                                     draw_method(draw, x);
                                     x.level = 0;
                                     if (x.degree > 2) x.degree = 2;
                                     if (draw.below(5) == 0)
                                       x.interpolated = static_cast<int>(1 + draw.below(3));
                                     x.reflectivity =
                                         random_reflectivity(draw, x.surface.description->pieces);
                                     x.emission = everywhere(random_emission(draw));
                                     return x;
                                   },
                               .judge = judge,
                               .text = text,
                               .smaller = smaller});
}

}  // namespace
}  // namespace radcert::attack
