// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/problem.h"

#include <algorithm>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/quadrature/tolerance.h"
#include "radcert/solve/iteration.h"
#include "radcert/study/plan.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/interpolated_chart.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {
namespace {

[[noreturn]] void refuse(std::string pointer, std::string value, std::string problem, std::string allowed) {
  throw InputError({.pointer = std::move(pointer),
                    .value = std::move(value),
                    .problem = std::move(problem),
                    .allowed = std::move(allowed)});
}

const SurfaceDescription& description_of(const Problem& problem) {
  const SurfaceDescription* found = find_surface(problem.surface.name);
  if (found != nullptr && found->unoccluded) return *found;
  std::string names;
  for (const SurfaceDescription& surface : surface_catalogue())
    if (surface.unoccluded) names += (names.empty() ? "" : ", ") + surface.name;
  refuse("/surface/name", problem.surface.name,
         found == nullptr ? "is not a known surface" : "has curved parts that hide each other", names);
}

void check_levels(const Problem& problem, const Surface& surface, std::uint64_t memory_limit) {
  const std::vector<int>& levels = problem.triangulation.levels;
  if (levels.empty()) refuse("/triangulation/levels", "[]", "is empty", "at least one level");
  const std::size_t functions = function_count(problem.basis);
  const double area = problem.basis.meshless ? surface_area(surface) : 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::string pointer = "/triangulation/levels/" + std::to_string(i);
    const std::string value = std::to_string(levels[i]);
    if (levels[i] < 0) refuse(pointer, value, "is not allowed", "a whole number >= 0");
    if (i > 0 && levels[i] <= levels[i - 1])
      refuse(pointer, value, "does not exceed the level before it", "levels in ascending order, each once");
    const std::optional<std::uint64_t> elements = triangle_count(surface, levels[i]);
    if (!elements)
      refuse(pointer, value, "needs more than 2^64 bytes (more than 2^53 triangles)",
             "a plan within " + std::to_string(memory_limit) + " bytes (" + byte_text(memory_limit) + ")");
    const std::uint64_t unknowns =
        problem.basis.meshless ? planned_sites(problem.basis.meshless->sites, levels[i], area) : *elements;
    const std::uint64_t needed =
        problem.basis.meshless
            ? meshless_plan(unknowns, *problem.basis.meshless, problem.solver.name == SolverName::direct)
                  .total()
            : level_plan(*elements, functions, problem.solver.name, problem.geometry).total();
    if (needed > memory_limit) {
      const std::string bytes = needed == ~std::uint64_t{0} ? "more than 2^64" : std::to_string(needed);
      refuse(pointer, value,
             "needs " + bytes + " bytes (" + std::to_string(unknowns) +
                 (problem.basis.meshless ? " sites)" : " triangles)"),
             "a plan within " + std::to_string(memory_limit) + " bytes (" + byte_text(memory_limit) + ")");
    }
  }
}

void check_geometry(const Problem& problem, const Surface& surface) {
  if (!problem.geometry) return;
  if (!surface.unoccluded)
    refuse("/geometry/interpolated", std::to_string(problem.geometry->degree),
           "asks for an interpolant of a mesh whose parts hide each other", "\"exact\", which a mesh is");
  constexpr int smallest = LatticePolynomial<double>::smallest_degree;
  constexpr int largest = LatticePolynomial<double>::largest_degree;
  if (problem.geometry->degree < smallest || problem.geometry->degree > largest)
    refuse("/geometry/interpolated", std::to_string(problem.geometry->degree), "is not allowed",
           "a whole number from " + std::to_string(smallest) + " to " + std::to_string(largest));
}

/// What a meshless basis asks of the rest of a problem, and of itself before there are sites.
void check_meshless(const Problem& problem, const MeshlessBasis& basis) {
  if (problem.geometry)
    refuse("/geometry/interpolated", std::to_string(problem.geometry->degree),
           "asks for interpolated elements, which a meshless basis has none of", "exact");
  if (problem.solver.name != SolverName::direct && problem.solver.name != SolverName::neumann)
    refuse("/solver/name", solver_name(problem.solver.name), "is not for meshless bases", "direct, neumann");
  if (const auto* apart = std::get_if<PoissonDiskLevels>(&basis.sites);
      apart != nullptr && apart->separation <= Rational(0))
    refuse("/basis/sites/poisson_disk", apart->separation.to_text(), "is not allowed", "a number > 0");
  if (const auto* anywhere = std::get_if<UniformLevels>(&basis.sites);
      anywhere != nullptr && anywhere->count == 0)
    refuse("/basis/sites/uniform", "0", "is not allowed", "a whole number >= 1");
  if (basis.basis.radius.neighbour && *basis.basis.radius.neighbour == 0)
    refuse("/basis/radius/neighbour", "0", "is not allowed", "a whole number >= 1");
  if (basis.basis.normalise == Normalisation::none && basis.basis.mother.kind == MotherKind::shepard)
    refuse("/basis/normalise", "none", "leaves the mother function shepard infinite at the sites",
           "partition_of_unity");
  for (const PiecewiseExpression::Case& part : problem.reflectivity.cases)
    if (const std::optional<Rational> value = part.expression.is_constant(); value && *value >= Rational(1))
      refuse(problem.reflectivity.cases.size() == 1 && part.piece == "*" ? "/reflectivity"
                                                                         : "/reflectivity/" + part.piece,
             part.expression.text(), "is not below 1",
             "reflectivities in [0, 1): a meshless basis scatters less than arrives");
}

/// The least barycentric coordinate of a node.
Rational least_coordinate(const LagrangeFunctions& functions) {
  Rational least = 1;
  for (const Barycentric<Rational>& node : functions.nodes())
    for (const Rational& x : node.x) least = std::min(least, x);
  return least;
}

void check_basis(const Problem& problem, const Surface& surface) {
  const BasisChoice& basis = problem.basis;
  if (basis.meshless) return check_meshless(problem, *basis.meshless);
  constexpr int largest = InsetBasis<double>::largest_degree;
  if (basis.degree < 0 || basis.degree > largest)
    refuse("/basis/degree", std::to_string(basis.degree), "is not allowed",
           "a whole number from 0 to " + std::to_string(largest));
  if (basis.degree == 0) return;
  if (!basis.functions && !basis.alpha) refuse("/basis/alpha", "", "is missing", "a number in [0, 1/3)");
  const Rational alpha = basis.functions ? least_coordinate(*basis.functions) : *basis.alpha;
  if (alpha < Rational(0) || alpha >= Rational(1, 3))
    refuse("/basis/alpha", alpha.to_text(), "is not allowed", "a number in [0, 1/3)");
  // Below this the nodes of the finest level keep less than half of a double's digits of their distance from
  // an edge.
  const int finest = problem.triangulation.levels.back();
  const Rational least = Rational(1) / power(Rational(2), 26 - std::min(finest, 26));
  const bool interpolants_meet =
      problem.geometry && std::any_of(surface.charts.begin(), surface.charts.end(),
                                      [](const Chart& chart) { return !chart.facts().plane; });
  if ((surface.pieces_meet_at_angle || interpolants_meet) && alpha < least) {
    const std::string where = surface.pieces_meet_at_angle
                                  ? "edges where pieces of the surface meet at an angle"
                                  : "sides where interpolated elements meet at an angle";
    if (basis.functions)
      refuse("/basis", alpha.to_text(), "puts nodes on or too close to " + where,
             "least barycentric coordinates of at least " + least.to_text() +
                 " on this surface at these levels");
    refuse("/basis/alpha", alpha.to_text(),
           alpha == Rational(0) ? "puts nodes on " + where + ", and there the kernel has no value"
                                : "puts nodes too close to " + where,
           "a number in [" + least.to_text() + ", 1/3) on this surface at these levels");
  }
  if (!basis.functions && alpha > Rational(333333, 1000000))
    refuse("/basis/alpha", alpha.to_text(),
           "is too close to 1/3: the nodes of an element coincide in double precision",
           "a number in [0, 0.333333]");
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
        cases.size() == 1 && part.piece == "*" ? "/reflectivity" : "/reflectivity/" + part.piece;
    const std::optional<Rational> value = part.expression.is_constant();
    if (!value) {
      all_constant = false;
      continue;
    }
    if (*value < Rational(0) || *value > Rational(1))
      refuse(pointer, part.expression.text(), "is not a reflectivity", "values in [0, 1]");
    largest = std::max(largest, *value);
  }
  if (surface.closed && all_constant && largest >= Rational(1))
    refuse("/reflectivity", largest.to_text(),
           "makes the norm of K " + largest.to_text() + " on a closed surface",
           "a norm of K below 1: on a closed surface the norm is the largest reflectivity");
}

void check_quadrature(const QuadratureChoice& quadrature) {
  const double tolerance = quadrature.tolerance.to_double();
  if (tolerance < Tolerance::finest || tolerance > Tolerance::coarsest)
    refuse("/quadrature/tolerance", quadrature.tolerance.to_text(), "is not allowed",
           "a number from " + shortest(Tolerance::finest) + ", what double can hold, to " +
               shortest(Tolerance::coarsest));
}

void check_solver(const SolverChoice& solver) {
  if (!solver.tolerance) return;
  const Rational& tolerance = *solver.tolerance;
  if (solver.name == SolverName::direct || solver.name == SolverName::verified)
    refuse("/solver/tolerance", tolerance.to_text(), "is not for " + solver_name(solver.name),
           "gmres and neumann with a tolerance");
  if (tolerance < Rational::exactly(least_tolerance) || tolerance >= Rational(1))
    refuse("/solver/tolerance", tolerance.to_text(), "is not allowed",
           "a number from " + shortest(least_tolerance) + ", about what double can hold, to below 1");
}

void check_pieces(const PiecewiseExpression& function, const std::string& pointer, const Surface& surface) {
  const std::vector<std::string> names = surface.piece_names();
  for (const std::string& name : names) {
    const bool covered = std::any_of(function.cases.begin(), function.cases.end(), [&](const auto& part) {
      return part.piece == name || part.piece == "*";
    });
    if (!covered)
      refuse(pointer, name, "is a piece without an expression", "one for every piece, or * for the rest");
  }
  for (const PiecewiseExpression::Case& part : function.cases)
    if (part.piece != "*" && std::find(names.begin(), names.end(), part.piece) == names.end())
      refuse(pointer + "/" + part.piece, part.piece, "is not a piece of the surface",
             "its pieces, or * for the rest");
}

}  // namespace

std::size_t function_count(const BasisChoice& basis) {
  if (basis.meshless) return 1;
  return basis.functions ? basis.functions->size() : polynomial_dimension(basis.degree);
}

TriangleBasis<double> triangle_basis(const BasisChoice& basis) {
  if (basis.functions) return make_triangle_basis<double>(*basis.functions);
  return InsetBasis<double>(basis.degree, basis.alpha.value_or(Rational(0)).to_double());
}

std::string solver_name(SolverName name) {
  switch (name) {
    case SolverName::direct: return "direct";
    case SolverName::gmres: return "gmres";
    case SolverName::neumann: return "neumann";
    case SolverName::verified: return "verified";
  }
  expects(false, "a solver of the list", named("solver", static_cast<int>(name)));
  return {};
}

Surface surface_of(const Problem& problem) {
  if (problem.surface.mesh) return *problem.surface.mesh->surface;
  const SurfaceDescription& description = description_of(problem);
  std::vector<Rational> values;
  for (const ParameterDescription& parameter : description.parameters) {
    const auto given = std::find_if(problem.surface.parameters.begin(), problem.surface.parameters.end(),
                                    [&](const SurfaceParameter& p) { return p.name == parameter.name; });
    if (given == problem.surface.parameters.end())
      refuse("/surface/" + parameter.name, "", "is missing", parameter.requirement);
    if (!parameter.admits(given->value))
      refuse("/surface/" + parameter.name, given->value.to_text(), "is not allowed", parameter.requirement);
    values.push_back(given->value);
  }
  return description.make(values);
}

void check(const Problem& problem, std::uint64_t memory_limit) {
  const Surface surface = surface_of(problem);
  if (problem.triangulation.grading < Rational(1))
    refuse("/triangulation/grading", problem.triangulation.grading.to_text(), "is not allowed",
           "a number >= 1");
  if (problem.solution.has_value() == problem.emission.has_value())
    refuse("", "",
           problem.solution ? "states both solution and emission" : "states neither solution nor emission",
           "exactly one of the two");
  check_pieces(problem.reflectivity, "/reflectivity", surface);
  if (problem.solution) check_pieces(*problem.solution, "/solution", surface);
  if (problem.emission) check_pieces(*problem.emission, "/emission", surface);
  check_reflectivity(problem, surface);
  check_geometry(problem, surface);
  check_quadrature(problem.quadrature);
  check_solver(problem.solver);
  // A plan is made for a basis that there is.
  if (problem.basis.meshless || problem.basis.degree < 0 ||
      problem.basis.degree > InsetBasis<double>::largest_degree)
    check_basis(problem, surface);
  check_levels(problem, surface, memory_limit);
  check_basis(problem, surface);
}

}  // namespace radcert
