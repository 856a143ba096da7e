// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/problem.h"
#include "radcert/study/collocation/matrix_form.h"

#include <algorithm>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/json_pointer.h"
#include "radcert/core/text.h"
#include "radcert/quadrature/tolerance.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/own_surface.h"

namespace radcert {
namespace {

const SurfaceDescription& description_of(const Problem& problem) {
  const SurfaceDescription* found = find_surface(problem.surface.name);
  if (found != nullptr && found->unoccluded) return *found;
  std::string names;
  for (const SurfaceDescription& surface : surface_catalogue())
    if (surface.unoccluded) names += (names.empty() ? "" : ", ") + surface.name;
  refuse_input("/surface/name", problem.surface.name,
               found == nullptr ? "is not a known surface" : "has curved parts that hide each other", names);
}

/// Whether an expression is the one of some piece: a "*" beside an expression for every piece is not.
bool covers_a_piece(const PiecewiseExpression& function, const PiecewiseExpression::Case& part,
                    const Surface& surface) {
  const std::vector<std::string> names = surface.piece_names();
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return &function.on(name) == &part.expression; });
}

void check_reflectivity(const Problem& problem, const Surface& surface) {
  bool all_constant = true;
  Rational largest = 0;
  const std::vector<PiecewiseExpression::Case>& cases = problem.reflectivity.cases;
  for (const PiecewiseExpression::Case& part : cases) {
    if (!covers_a_piece(problem.reflectivity, part, surface)) continue;
    const std::string pointer =
        cases.size() == 1 && part.piece == "*" ? "/reflectivity" : pointer_below("/reflectivity", part.piece);
    const std::optional<Rational> value = part.expression.is_constant();
    if (!value) {
      all_constant = false;
      continue;
    }
    if (*value < Rational(0) || *value > Rational(1))
      refuse_input(pointer, part.expression.text(), "is not a reflectivity", "values in [0, 1]");
    largest = std::max(largest, *value);
  }
  if (surface.closed && all_constant && largest >= Rational(1))
    refuse_input("/reflectivity", largest.to_text(),
                 "makes the norm of K " + largest.to_text() + " on a closed surface",
                 "a norm of K below 1: on a closed surface the norm is the largest reflectivity");
}

void check_quadrature(const QuadratureChoice& quadrature) {
  const double tolerance = quadrature.tolerance.to_double();
  if (tolerance < Tolerance::finest || tolerance > Tolerance::coarsest)
    refuse_input("/quadrature/tolerance", quadrature.tolerance.to_text(), "is not allowed",
                 "a number from " + shortest(Tolerance::finest) + ", what double can hold, to " +
                     shortest(Tolerance::coarsest));
}

void check_solver(const SolverChoice& choice) {
  const LinearSolver* solver = find_linear_solver(choice.name);
  if (solver == nullptr)
    refuse_input("/solver/name", choice.name, "is not a known solver", listed(solver_names()));
  if (!choice.tolerance) return;
  const Rational& tolerance = *choice.tolerance;
  if (!solver->iterates())
    refuse_input(
        "/solver/tolerance", tolerance.to_text(), "is not for " + choice.name,
        listed(solver_names([](const LinearSolver& each) { return each.iterates(); })) + " with a tolerance");
  if (tolerance < Rational::exactly(least_tolerance) || tolerance >= Rational(1))
    refuse_input("/solver/tolerance", tolerance.to_text(), "is not allowed",
                 "a number from " + shortest(least_tolerance) + ", about what double can hold, to below 1");
}

void check_pieces(const PiecewiseExpression& function, const std::string& pointer, const Surface& surface) {
  const std::vector<std::string> names = surface.piece_names();
  for (const std::string& name : names) {
    const bool covered = std::any_of(function.cases.begin(), function.cases.end(), [&](const auto& part) {
      return part.piece == name || part.piece == "*";
    });
    if (!covered)
      refuse_input(pointer, name, "is a piece without an expression",
                   "one for every piece, or * for the rest");
  }
  for (const PiecewiseExpression::Case& part : function.cases)
    if (part.piece != "*" && std::find(names.begin(), names.end(), part.piece) == names.end())
      refuse_input(pointer_below(pointer, part.piece), part.piece, "is not a piece of the surface",
                   "its pieces, or * for the rest");
}

/// A function that is known by its values in double alone proves nothing, and rho has to be known exactly.
void check_own_functions(const Problem& problem) {
  if (problem.reflectivity.has_own())
    refuse_input("/reflectivity", problem.reflectivity.cases.front().expression.text(),
                 "is a function without a formula", "an expression: its bound decides whether u exists");
  const auto is_own = [](const std::optional<PiecewiseExpression>& data) { return data && data->has_own(); };
  if ((is_own(problem.solution) || is_own(problem.emission)) &&
      find_linear_solver(problem.solver.name)->proves())
    refuse_input("/solver/name", problem.solver.name,
                 std::string("proves nothing where the ") + (problem.solution ? "solution" : "emission") +
                     " is a function without a formula",
                 "a solver that estimates, or an expression");
}

/// What is refused on a surface that is known in double alone, as own_surface makes it.
void check_own_surface(const Problem& problem, const Surface& surface) {
  if (is_known_in_balls(surface)) return;
  if (find_linear_solver(problem.solver.name)->proves())
    refuse_input("/solver/name", problem.solver.name,
                 "proves nothing where the charts of the surface are known by their values alone",
                 "a solver that estimates, or a surface of the catalogue or of a mesh");
  if (!std::holds_alternative<Collocation>(problem.method))
    refuse_input("/basis", surface.name, "has charts that are known by their values alone",
                 "collocation with a basis on triangles, or a surface of the catalogue or of a mesh");
  if (problem.geometry)
    refuse_input("/geometry/interpolated", std::to_string(problem.geometry->degree),
                 "is not for a surface whose charts are interpolants already", "\"exact\"");
}

}  // namespace

Surface surface_of(const Problem& problem) {
  if (problem.surface.mesh) return *problem.surface.mesh->surface;
  const SurfaceDescription& description = description_of(problem);
  std::vector<Rational> values;
  for (const ParameterDescription& parameter : description.parameters) {
    const auto given = std::find_if(problem.surface.parameters.begin(), problem.surface.parameters.end(),
                                    [&](const SurfaceParameter& p) { return p.name == parameter.name; });
    if (given == problem.surface.parameters.end())
      refuse_input("/surface/" + parameter.name, "", "is missing", parameter.requirement);
    if (!parameter.admits(given->value))
      refuse_input("/surface/" + parameter.name, given->value.to_text(), "is not allowed",
                   parameter.requirement);
    values.push_back(given->value);
  }
  return description.make(values);
}

void check(const Problem& problem, std::uint64_t memory_limit) {
  if (problem.guarantee)
    refuse_input("/guarantee", problem.guarantee->width.to_text(), "is not for a study over levels",
                 "a guarantee in radcert solve alone");
  const Surface surface = surface_of(problem);
  if (problem.triangulation.grading < Rational(1))
    refuse_input("/triangulation/grading", problem.triangulation.grading.to_text(), "is not allowed",
                 "a number >= 1");
  if (problem.solution.has_value() == problem.emission.has_value())
    refuse_input(
        "", "",
        problem.solution ? "states both solution and emission" : "states neither solution nor emission",
        "exactly one of the two");
  check_pieces(problem.reflectivity, "/reflectivity", surface);
  if (problem.solution) check_pieces(*problem.solution, "/solution", surface);
  if (problem.emission) check_pieces(*problem.emission, "/emission", surface);
  check_reflectivity(problem, surface);
  check_quadrature(problem.quadrature);
  check_solver(problem.solver);
  check_own_functions(problem);
  check_own_surface(problem, surface);
  check_operator(problem, surface);
  std::visit([&](const auto& method) { check(problem, method, surface, memory_limit); }, problem.method);
}

}  // namespace radcert
