// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/meshless/meshless.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/core/checked.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/json_pointer.h"
#include "radcert/core/text.h"
#include "radcert/meshless/surface_cells.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/study/levels_within_memory.h"
#include "radcert/study/problem.h"

namespace radcert {
namespace {

// Numbers of sites beyond this are no numbers of a double.
constexpr std::uint64_t most_sites = std::uint64_t{1} << 53U;

double separation_at(const PoissonDiskLevels& sites, int level) {
  return (sites.separation / power(Rational(2), level)).to_double();
}

std::optional<std::uint64_t> count_at(const UniformLevels& sites, int level) {
  constexpr int most_doublings = 26;  // 4^26 = 2^52
  if (level > most_doublings) return std::nullopt;
  const auto count = checked_multiply(sites.count, std::uint64_t{1} << (2U * static_cast<unsigned>(level)));
  return count && *count <= most_sites ? count : std::nullopt;
}

/// What a meshless basis asks of the rest of a problem, and of itself before there are sites.
void check_choice(const Problem& problem, const Meshless& method) {
  if (problem.geometry)
    refuse_input("/geometry/interpolated", std::to_string(problem.geometry->degree),
                 "asks for interpolated elements, which a meshless basis has none of", "exact");
  if (problem.iterated)
    refuse_input("/iterated", "true", "is not for a meshless basis", "a basis of functions on triangles");
  const std::string& solver = problem.solver.name;
  if (solver != "auto" && solver != "direct" && solver != "neumann")
    refuse_input("/solver/name", solver, "is not for meshless bases", "auto, direct, neumann");
  if (const auto* apart = std::get_if<PoissonDiskLevels>(&method.sites);
      apart != nullptr && apart->separation <= Rational(0))
    refuse_input("/basis/sites/poisson_disk", apart->separation.to_text(), "is not allowed", "a number > 0");
  if (const auto* anywhere = std::get_if<UniformLevels>(&method.sites);
      anywhere != nullptr && anywhere->count == 0)
    refuse_input("/basis/sites/uniform", "0", "is not allowed", "a whole number >= 1");
  if (method.basis.radius.neighbour && *method.basis.radius.neighbour == 0)
    refuse_input("/basis/radius/neighbour", "0", "is not allowed", "a whole number >= 1");
  if (method.basis.normalise == Normalisation::none && method.basis.mother.kind == MotherKind::shepard)
    refuse_input("/basis/normalise", "none", "leaves the mother function shepard infinite at the sites",
                 "partition_of_unity");
  for (const PiecewiseExpression::Case& part : problem.reflectivity.cases)
    if (const std::optional<Rational> value = part.expression.is_constant(); value && *value >= Rational(1))
      refuse_input(problem.reflectivity.cases.size() == 1 && part.piece == "*"
                       ? "/reflectivity"
                       : pointer_below("/reflectivity", part.piece),
                   part.expression.text(), "is not below 1",
                   "reflectivities in [0, 1): a meshless basis scatters less than arrives");
}

}  // namespace

std::string_view name(MeshlessFamily family) {
  switch (family) {
    case MeshlessFamily::shepard: return "shepard";
    case MeshlessFamily::gaussian: return "gaussian";
    case MeshlessFamily::lehtinen: return "lehtinen";
    case MeshlessFamily::meshless: break;
  }
  return "meshless";
}

Meshless basis_of(MeshlessFamily family) {
  Meshless basis{.family = family};
  switch (family) {
    case MeshlessFamily::shepard: basis.basis = shepard_basis(); return basis;
    case MeshlessFamily::gaussian: basis.basis = gaussian_basis(); return basis;
    case MeshlessFamily::lehtinen: basis.basis = lehtinen_basis(); return basis;
    case MeshlessFamily::meshless: break;
  }
  expects(false, "one of shepard, gaussian, lehtinen", named("family", std::string(name(family))));
  return basis;
}

std::optional<SiteChoice> sites_at_level(const SiteLevels& sites, int level) {
  expects(level >= 0, "a level >= 0", named("level", level));
  if (const auto* apart = std::get_if<PoissonDiskLevels>(&sites))
    return PoissonDiskSites{.separation = separation_at(*apart, level), .seed = apart->seed};
  const auto& anywhere = *std::get_if<UniformLevels>(&sites);
  const std::optional<std::uint64_t> count = count_at(anywhere, level);
  if (!count) return std::nullopt;
  return UniformSites{.count = *count, .seed = anywhere.seed};
}

double site_spacing(const SiteLevels& sites, int level, double area) {
  expects(level >= 0 && area > 0, "a level >= 0 and an area > 0", named("level", level), named("area", area));
  if (const auto* apart = std::get_if<PoissonDiskLevels>(&sites)) return separation_at(*apart, level);
  const auto count = count_at(*std::get_if<UniformLevels>(&sites), level).value_or(most_sites);
  return std::sqrt(area / static_cast<double>(count));
}

double surface_area(const Surface& surface) {
  const TriangleRule<double> rule = conical_rule<double>(2, Grading::none);
  const auto cells =
      cells_below(surface, std::numeric_limits<double>::infinity(), std::numeric_limits<std::size_t>::max());
  double area = 0;
  for (const SurfaceCell& cell : *cells)
    for (std::size_t i = 0; i < rule.points.size(); ++i)
      // The rule's weights sum to 1/2.
      area += 2 * cell.parameter_area() * rule.weights[i] *
              area_element(surface.charts[cell.chart].in<double>().frame(
                  cell.at(surface, rule.points[i].x[1], rule.points[i].x[2])));
  return area;
}

MemoryPlan meshless_plan(std::uint64_t sites, const Meshless& basis, bool is_direct) {
  constexpr std::uint64_t bytes_per_site = 1024;  // arrays, tree, node records, triangles to look at
  const std::uint64_t squared = saturated_product(sites, sites);
  MemoryPlan plan;
  plan.add("transfer matrix", squared, sizeof(double));
  plan.add("powers of it", saturated_product(squared, 2), sizeof(double));
  if (is_direct) plan.add("factors of I - R", squared, sizeof(double));
  if (basis.coefficients == CoefficientRule::interpolated)
    plan.add("interpolation matrix and its factors", saturated_product(squared, 2), sizeof(double));
  plan.add("sites", sites, bytes_per_site);
  return plan;
}

std::uint64_t planned_sites(const SiteLevels& sites, int level, double area) {
  if (std::holds_alternative<UniformLevels>(sites))
    return count_at(*std::get_if<UniformLevels>(&sites), level)
        .value_or(std::numeric_limits<std::uint64_t>::max());
  const double separation = site_spacing(sites, level, area);
  const double most = std::ceil(2 / std::numbers::sqrt3 * area / (separation * separation));
  return most < static_cast<double>(most_sites) ? static_cast<std::uint64_t>(most) : most_sites;
}

void check(const Problem& problem, const Meshless& method, const Surface& surface,
           std::uint64_t memory_limit) {
  check_choice(problem, method);
  const double area = surface_area(surface);
  check_levels(problem, surface, memory_limit, [&](int level, std::uint64_t) {
    const std::uint64_t sites = planned_sites(method.sites, level, area);
    return LevelSize{.count = sites,
                     .counted = "sites",
                     .memory = meshless_plan(sites, method, problem.solver.name != "neumann")};
  });
}

}  // namespace radcert
