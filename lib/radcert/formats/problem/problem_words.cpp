// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/problem/problem_words.h"

#include <optional>

#include "radcert/core/contract.h"
#include "radcert/formats/problem/problem_parts.h"

namespace radcert {

namespace {

using Words = std::vector<std::string>;

/// A string without its quotes, anything else as JSON.
std::string plain(const JsonValue& value) {
  return value.string() != nullptr ? *value.string() : value.compact();
}

Words surface_words(const SurfaceChoice& surface) {
  Words words{surface.name};
  for (const SurfaceParameter& parameter : surface.parameters)
    words.push_back(parameter.name + " " + parameter.value.to_text());
  return words;
}

Words triangulation_words(const TriangulationChoice& triangulation) {
  std::string levels = "levels";
  for (const int level : triangulation.levels) levels += " " + std::to_string(level);
  const JsonValue json = triangulation_json(triangulation);
  return {levels, "pattern " + plain(*json.find("pattern")), "grading " + triangulation.grading.to_text()};
}

Words geometry_words(const std::optional<InterpolatedGeometry>& geometry) {
  if (!geometry) return {"exact geometry"};
  Words words{"interpolated of degree " + std::to_string(geometry->degree)};
  if (geometry->data == DataPoints::interpolant) words.emplace_back("data on the interpolant");
  return words;
}

Words solver_words(const SolverChoice& solver) {
  Words words{solver.name};
  if (solver.tolerance) words.push_back("tolerance " + solver.tolerance->to_text());
  return words;
}

Words operator_words(const OperatorChoice& matrix) {
  Words words{"operator " + matrix.name};
  if (matrix.name != "dense") words.push_back("couplings within " + matrix.tolerance.to_text());
  return words;
}

Words function_words(const std::string& symbol, const std::optional<PiecewiseExpression>& function) {
  if (!function) return {};
  return {symbol + " = " + plain(piecewise_json(*function))};
}

}  // namespace

std::vector<std::string> part_words(const Problem& problem, std::string_view key) {
  if (key == "surface") return surface_words(problem.surface);
  if (key == "triangulation") return triangulation_words(problem.triangulation);
  if (key == "geometry") return geometry_words(problem.geometry);
  if (key == "basis") return method_words(problem.method);
  if (key == "reflectivity") return function_words("rho", problem.reflectivity);
  if (key == "solution") return function_words("u", problem.solution);
  if (key == "emission") return function_words("E", problem.emission);
  if (key == "quadrature") return {"quadrature " + problem.quadrature.tolerance.to_text()};
  if (key == "operator") return operator_words(problem.matrix);
  expects(key == "solver", "a key of a problem", named("key", std::string(key)));
  return solver_words(problem.solver);
}

}  // namespace radcert
