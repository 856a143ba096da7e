// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/problem/problem_json.h"

#include <algorithm>
#include <string>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/study/edge_grading.h"
#include "radcert/study/events/event_triangulation.h"
#include "radcert/surface/catalogue.h"

namespace radcert {

namespace {

constexpr const char* schema = "radcert/problem/1";

/// Where a Galerkin problem says nothing of quadrature: integrals over pairs of elements cost more than those
/// over one.
const Rational usual_galerkin_tolerance = Rational(1) / power(Rational(10), 9);

Problem read(const JsonValue& document, const std::filesystem::path& folder,
             const std::optional<SurfaceChoice>& surface = std::nullopt,
             const std::optional<Method>& method = std::nullopt) {
  const JsonReader root(document);
  root.require_schema(schema, "an object: a problem");
  root.require_object({"schema", "surface", "triangulation", "geometry", "basis", "reflectivity", "solution",
                       "emission", "quadrature", "operator", "solver", "iterated", "guarantee", "label",
                       "fit_from"});
  Problem problem;
  if (const auto stated = root.find("surface"); surface && stated)
    stated->refuse("stands beside another surface", "one of them");
  problem.surface =
      surface ? *surface
              : read_surface(
                    root.at("surface", "an object with a name, see radcert list surfaces, or with a file"),
                    folder);
  const std::vector<std::string> pieces = pieces_of(problem.surface);
  problem.triangulation = read_triangulation(root.at("triangulation", "an object with levels"), pieces);
  if (const auto geometry = root.find("geometry")) problem.geometry = read_geometry(*geometry);
  if (const auto stated = root.find("basis"); method && stated)
    stated->refuse("stands beside another basis", "one of them");
  problem.method =
      method
          ? *method
          : read_method(root.at("basis", "an object with a family, see radcert list bases, or with a file"),
                        folder);
  problem.reflectivity = read_piecewise(root.at("reflectivity", "an expression, or one a piece"), pieces);

  const auto solution = root.find("solution");
  const auto emission = root.find("emission");
  if (solution && emission)
    emission->refuse("stands beside a solution", "exactly one of solution and emission");
  if (!solution && !emission)
    throw InputError({.pointer = "/solution",
                      .problem = "is missing, and so is emission",
                      .allowed = "exactly one of solution and emission"});
  if (solution) problem.solution = read_piecewise(*solution, pieces);
  if (emission) problem.emission = read_piecewise(*emission, pieces);
  if (const auto quadrature = root.find("quadrature"))
    problem.quadrature = read_quadrature(*quadrature);
  else if (std::holds_alternative<Galerkin>(problem.method))
    problem.quadrature.tolerance = usual_galerkin_tolerance;
  if (const auto matrix = root.find("operator")) problem.matrix = read_operator(*matrix);
  if (const auto solver = root.find("solver")) problem.solver = read_solver(*solver);
  if (const auto iterated = root.find("iterated")) problem.iterated = iterated->boolean("true or false");
  if (const auto guarantee = root.find("guarantee")) problem.guarantee = read_guarantee(*guarantee, pieces);
  if (const auto label = root.find("label")) problem.label = read_label(*label);
  if (const auto fit_from = root.find("fit_from")) problem.fit_from = read_fit_from(*fit_from);
  const JsonReader triangulation = root.at("triangulation", "an object with levels");
  const auto grading = triangulation.find("grading");
  if (grading && is_edge_grading(*grading))
    problem.triangulation.grading = edge_grading(problem, surface_of(problem)).grading;
  if (const auto events = triangulation.find("events"))
    if (const auto wanted = read_events(*events))
      problem.triangulation.events = event_cut(problem, surface_of(problem), wanted->secondary);
  return problem;
}

}  // namespace

std::vector<std::string> pieces_of(const SurfaceChoice& surface) {
  return surface.mesh ? surface.mesh->surface->piece_names() : find_surface(surface.name)->pieces;
}

std::string read_label(const JsonReader& label) {
  constexpr std::size_t longest = 60;
  const std::string allowed = "a text of 1 to 60 characters without commas, quotation marks and line breaks";
  const std::string& text = label.string(allowed);
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) >= ' ' && c != ',' && c != '"' && c != '\x7f';
  });
  if (text.empty() || text.size() > longest || !plain) label.refuse("is no label", allowed);
  return text;
}

int read_fit_from(const JsonReader& level) {
  constexpr int most = 30;
  return static_cast<int>(level.whole(0, most, "a level from 0 to 30"));
}

Problem read_problem(const std::filesystem::path& path) {
  const JsonValue document = read_json(path);
  return with_source(path.string(), [&] { return read(document, path.parent_path()); });
}

Problem parse_problem(std::string_view text, const std::string& source) {
  const JsonValue document = parse_json(text, source);
  return with_source(source, [&] { return read(document, std::filesystem::path(source).parent_path()); });
}

Problem problem_of(const JsonValue& document, const std::string& source,
                   const std::optional<SurfaceChoice>& surface, const std::optional<Method>& method) {
  return with_source(
      source, [&] { return read(document, std::filesystem::path(source).parent_path(), surface, method); });
}

JsonValue problem_json(const Problem& problem) {
  JsonValue out = JsonValue::object();
  out.set("schema", schema);
  out.set("surface", surface_json(problem.surface));
  out.set("triangulation", triangulation_json(problem.triangulation));
  out.set("geometry", geometry_json(problem.geometry));
  out.set("basis", method_json(problem.method));
  out.set("reflectivity", piecewise_json(problem.reflectivity));
  if (problem.solution) out.set("solution", piecewise_json(*problem.solution));
  if (problem.emission) out.set("emission", piecewise_json(*problem.emission));
  out.set("quadrature", quadrature_json(problem.quadrature));
  // As it was before there were others, so that what has been stored is still found.
  if (problem.matrix != OperatorChoice{}) out.set("operator", operator_json(problem.matrix));
  out.set("solver", solver_json(problem.solver));
  if (problem.iterated) out.set("iterated", true);
  if (problem.guarantee) out.set("guarantee", guarantee_json(*problem.guarantee));
  if (!problem.label.empty()) out.set("label", problem.label);
  if (problem.fit_from) out.set("fit_from", *problem.fit_from);
  return out;
}

std::string problem_text(const Problem& problem) { return problem_json(problem).pretty() + "\n"; }

}  // namespace radcert
