// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/galerkin/galerkin.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/checked.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/expression/parse.h"
#include "radcert/galerkin/pair_integrals.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/ball.h"
#include "radcert/study/collocation/operator_norm.h"
#include "radcert/study/levels_within_memory.h"
#include "radcert/study/problem.h"
#include "radcert/surface/surface_function.h"

namespace radcert {
namespace {

void check_choices(const Problem& problem, const Galerkin& method, const Surface& surface) {
  if (method.degree < 0 || method.degree > largest_galerkin_degree)
    refuse_input("/basis/degree", std::to_string(method.degree), "is not allowed",
                 "a whole number from 0 to " + std::to_string(largest_galerkin_degree));
  if (problem.geometry)
    refuse_input("/geometry/interpolated", std::to_string(problem.geometry->degree),
                 "is not for Galerkin's method", "\"exact\"");
  if (problem.iterated)
    refuse_input("/iterated", "true", "is not for Galerkin's method",
                 "false, or collocation with a basis of functions on triangles");
  if (!surface.unoccluded)
    refuse_input("/basis/method", "galerkin",
                 "is not for the surface " + surface.name + ", whose parts hide each other",
                 "collocation there; Galerkin's method on surfaces whose parts do not hide each other");
  if (problem.solver.name != "auto")
    refuse_input("/solver/name", problem.solver.name, "is not for Galerkin's method",
                 "auto, which is conjugate gradients there");
  if (problem.matrix.name != "auto" && problem.matrix.name != "dense")
    refuse_input("/operator/name", problem.matrix.name, "is not for Galerkin's method", "auto or dense");
}

/// rho with words around each of its expressions.
PiecewiseExpression changed(const PiecewiseExpression& rho, const std::string& before,
                            const std::string& after) {
  PiecewiseExpression out;
  for (const PiecewiseExpression::Case& part : rho.cases)
    out.cases.push_back(
        {part.piece, parse_expression(before + "(" + part.expression.text() + ")" + after).value()});
  return out;
}

/// Refuses the reflectivity of the first chart that is not proved to be below 1 and, but for the constant 0,
/// above 0.
void check_range(const Problem& problem, const Surface& surface) {
  const PiecewiseExpression& rho = problem.reflectivity;
  const PiecewiseExpression one_less_rho = changed(rho, "1-", "");
  Surface part = surface;
  for (const Chart& chart : surface.charts) {
    part.charts = {chart};
    const Expression& expression = rho.on(chart.facts().piece);
    const auto refuse = [&](const std::string& why, const std::string& allowed) {
      refuse_input("/reflectivity", expression.text(), why + " on piece " + chart.facts().piece, allowed);
    };
    if (!reflectivity_below_one(part, rho))
      refuse("is not proved to stay below 1",
             "reflectivities below 1 on the whole surface: Galerkin's method solves by a lower bound of 1 - "
             "rho");
    const std::optional<Rational> constant = expression.is_constant();
    if (constant && constant->sign() == 0) continue;
    if (!reflectivity_below_one(part, one_less_rho))
      refuse("is not proved to be positive",
             "0 everywhere or more than 0 everywhere on a piece: Galerkin's method divides by it");
  }
}

}  // namespace

double reflectivity_bound(const Problem& problem, const Surface& surface) {
  std::optional<Rational> largest = Rational(0);
  for (const std::string& piece : surface.piece_names()) {
    const std::optional<Rational> value = problem.reflectivity.on(piece).is_constant();
    largest = value && largest ? std::optional(std::max(*largest, *value)) : std::nullopt;
  }
  if (largest) return Ball(*largest).upper_double();
  // From a sample towards 1 until it is proved.
  const SurfaceFunction rho(problem.reflectivity, surface);
  double seen = 0;
  constexpr int steps = 8;
  for (std::size_t k = 0; k < surface.charts.size(); ++k)
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        if (surface.charts[k].facts().domain == ChartDomain::unit_triangle && i + j > steps) continue;
        const ParameterPoint<double> at{static_cast<double>(i) / steps, static_cast<double>(j) / steps};
        seen = std::max(seen, rho(k, surface.charts[k].in<double>().frame(at).point));
      }
  for (const double part : {0x1p-6, 0x1p-4, 0x1p-2, 0x1p-1}) {
    const double bound = seen + part * (1 - seen);
    if (reflectivity_below_one(
            surface, changed(problem.reflectivity, "", "/(" + Rational::exactly(bound).to_text() + ")")))
      return bound;
  }
  throw InputError({.pointer = "/reflectivity",
                    .problem = "is not shown to stay away from 1",
                    .allowed = "reflectivities that balls tell from 1: Galerkin's method solves by a lower "
                               "bound of 1 - rho"});
}

void check(const Problem& problem, const Galerkin& method, const Surface& surface,
           std::uint64_t memory_limit) {
  check_choices(problem, method, surface);
  check_range(problem, surface);
  check_levels(problem, surface, memory_limit, [&](int, std::uint64_t triangles) {
    return LevelSize{.count = triangles, .counted = "triangles", .memory = galerkin_plan(method, triangles)};
  });
}

MemoryPlan galerkin_plan(const Galerkin& method, std::uint64_t elements) {
  const std::uint64_t functions = polynomial_dimension(method.degree);
  const std::uint64_t unknowns = saturated_product(elements, functions);
  constexpr std::uint64_t vectors = 2 * 64 + 32;  // a sum over the rows for each chunk of elements
  constexpr std::uint64_t bytes_per_node_record = 256;
  MemoryPlan plan;
  plan.add("Galerkin matrix", saturated_product(unknowns, unknowns), sizeof(double));
  plan.add("row sums and vectors", unknowns, vectors * sizeof(double));
  plan.add("points of rules", elements, kept_bytes_per_element(functions));
  plan.add("nodes", unknowns, bytes_per_node_record);
  plan.add("triangles", elements, 2 * bytes_per_node_record);
  return plan;
}

}  // namespace radcert
