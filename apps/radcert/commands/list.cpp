// SPDX-License-Identifier: GPL-3.0-or-later

// radcert list surfaces, bases, solvers, claims, references: what there is, a line each.
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "output.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/reference/continuous_means.h"
#include "radcert/reference/reference_value.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/surface/catalogue.h"
#include "verification/claims/psg10/figures/sphere_over_disk_records.h"
#include "verification/framework/reading/paper.h"
#include "verification/framework/run_verification.h"

namespace radcert::app {

namespace {

/// A parameter of something that is listed.
struct EntryParameter {
  std::string name;
  std::string allowed;
  std::string default_text;  ///< empty: it must be given
  std::string meaning{};     ///< empty: the name says it
};

/// One line of a list.
struct Entry {
  std::string name;
  std::string summary;
  std::vector<EntryParameter> parameters{};
};

std::vector<Entry> surfaces() {
  std::vector<Entry> out;
  for (const SurfaceDescription& surface : surface_catalogue()) {
    Entry line{.name = surface.name, .summary = surface.summary + "; pieces " + listed(surface.pieces)};
    for (const ParameterDescription& parameter : surface.parameters)
      line.parameters.push_back(
          {parameter.name, parameter.requirement, parameter.default_text, parameter.meaning});
    out.push_back(line);
  }
  return out;
}

/// What all meshless bases take; defaults as JSON has them.
std::vector<EntryParameter> meshless_parameters() {
  return {
      {"sites",
       R"({"poisson_disk": s, "seed": n}, s / 2^k apart at level k, or {"uniform": count, "seed": n}, count 4^k)",
       R"({"uniform": 400, "seed": 1})"},
      {"weights", "integrated, plane, neighbours, mean_density", "integrated"},
      {"coefficients", "as_values, interpolated", "as_values"}};
}

std::vector<EntryParameter> with_radius(std::vector<EntryParameter> parameters) {
  parameters.insert(parameters.begin(), {"radius", R"({"neighbour": m, "too_few": "refuse" or "farthest"})",
                                         R"({"neighbour": 10, "too_few": "refuse"})"});
  return parameters;
}

std::vector<EntryParameter> own_meshless_parameters() {
  std::vector<EntryParameter> parameters = with_radius(meshless_parameters());
  parameters.front().allowed += ", or absolute";
  parameters.insert(
      parameters.begin(),
      {{"mother", "gaussian, spline, shepard, or an expression in r", ""},
       {"support", "of gaussian or an expression: a number > 0, or none", "4, or none"},
       {"distance", "normal_sensitive, euclidean_with_normal_factor, euclidean", "normal_sensitive"},
       {"normalise", "none, partition_of_unity", "partition_of_unity"}});
  return parameters;
}

std::vector<Entry> bases() {
  return {
      {.name = "inset",
       .summary = "polynomials with the nodes of m06 (13) pulled in from the corners",
       .parameters = {{"degree", "a whole number from 0 to 10", ""},
                      {"alpha", "a number in [0, 1/3), superconvergent at degrees 1 and 3; none at degree 0",
                       ""}}},
      {.name = "symmetric",
       .summary = "polynomials with symmetric nodes whose rule has a high degree of precision",
       .parameters = {{"degree", "a whole number from 1 to 6", ""}}},
      {.name = "galerkin",
       .summary = "a method, and no family: {\"method\": \"galerkin\", \"degree\": r}, piecewise polynomials "
                  "without continuity",
       .parameters = {{"degree", "a whole number from 0 to 4", ""}}},
      {.name = "shepard",
       .summary = "meshless: inverse squares of normal-sensitive distances, normalised, psg10 (16)",
       .parameters = meshless_parameters()},
      {.name = "gaussian",
       .summary = "meshless: Gaussian bells of normal-sensitive distances, psg10 (17)",
       .parameters = with_radius(meshless_parameters())},
      {.name = "lehtinen",
       .summary =
           "meshless: spline bells of Euclidean distances with a normal factor, normalised, psg10 (18)",
       .parameters = with_radius(meshless_parameters())},
      {.name = "meshless",
       .summary = "meshless: a mother function of one's own, psg10 sections V and VI",
       .parameters = own_meshless_parameters()}};
}

std::vector<Entry> solvers() {
  std::vector<Entry> out;
  for (const LinearSolver& solver : linear_solvers()) {
    Entry line{.name = solver.name, .summary = solver.summary};
    if (solver.iterates())
      line.parameters.push_back({"tolerance", "from 2^-51 to below 1, or rounding", "rounding",
                                 "what may be left of the system's error, relative to max |u_n|"});
    out.push_back(line);
  }
  return out;
}

std::vector<Entry> claims() {
  std::vector<Entry> out;
  for (const verification::Paper& paper : verification::embedded_paper_list()) {
    const std::vector<std::string> labels = verification::statement_labels(paper);
    for (const verification::Claim& claim : paper.claims) {
      std::size_t cells = 0;
      for (const std::string& label : labels) cells += label.starts_with(claim.label + ".") ? 1 : 0;
      out.push_back(
          {.name = paper.key + "/" + claim.label,
           .summary = (claim.table ? std::to_string(cells) + " cells: " : std::string()) + claim.says});
    }
  }
  return out;
}

/// Values with a name of their own first, then the families that --set reaches into.
std::vector<Entry> references() {
  std::vector<Entry> out;
  for (const reference::NamedValue& value : reference::named_values()) {
    const reference::ValueFamily& family = *reference::find_family(value.family);
    std::string arguments;
    for (std::size_t i = 0; i < value.arguments.size(); ++i)
      arguments += (i == 0 ? "(" : ", ") + family.parameters[i].name + " = " + value.arguments[i].to_text();
    out.push_back({.name = value.name, .summary = family.name + (arguments.empty() ? "" : arguments + ")")});
  }
  for (const reference::ContinuousMean& mean : reference::continuous_means())
    out.push_back({.name = mean.name, .summary = mean.summary});
  for (const reference::ValueFamily& family : reference::value_families()) {
    Entry line{.name = family.name, .summary = family.summary};
    for (const reference::ValueParameter& parameter : family.parameters)
      line.parameters.push_back({parameter.name, parameter.allowed, parameter.default_text});
    out.push_back(line);
  }
  Entry scene{
      .name = std::string(verification::psg10::sphere_over_disk_name),
      .summary = "radiance of a sphere above a disk lit from above, psg10 (20)-(21); at points by --at"};
  for (const reference::ValueParameter& parameter : verification::psg10::sphere_over_disk_parameters())
    scene.parameters.push_back({parameter.name, parameter.allowed, parameter.default_text});
  out.push_back(scene);
  return out;
}

const std::vector<std::pair<std::string, std::function<std::vector<Entry>()>>> lists = {
    {"surfaces", surfaces},
    {"bases", bases},
    {"solvers", solvers},
    {"claims", claims},
    {"references", references}};

std::string parameter_text(const EntryParameter& parameter) {
  const std::string value = parameter.default_text.empty() ? "" : " = " + parameter.default_text;
  return parameter.name + value + " (" + parameter.meaning + (parameter.meaning.empty() ? "" : ", ") +
         parameter.allowed + ")";
}

std::string text(const std::string& what, const std::vector<Entry>& lines) {
  if (lines.empty()) return "There are no " + what + " in this version.\n";
  std::vector<std::vector<std::string>> rows;
  for (const Entry& line : lines) {
    std::string parameters;
    for (const EntryParameter& p : line.parameters)
      parameters += (parameters.empty() ? "; " : ", ") + parameter_text(p);
    rows.push_back({line.name, line.summary + parameters});
  }
  return aligned_left(rows);
}

std::string json(const Common& common, const std::string& what, const std::vector<Entry>& lines) {
  JsonValue out = document_head("list", common.command);
  out.set("list", what);
  out.set("entries", json_array(lines, [](const Entry& line) {
            return JsonValue::object(
                {{"name", line.name},
                 {"summary", line.summary},
                 {"parameters", json_array(line.parameters, [](const EntryParameter& parameter) {
                    return JsonValue::object(
                        {{"name", parameter.name},
                         {"meaning", parameter.meaning.empty() ? JsonValue() : JsonValue(parameter.meaning)},
                         {"allowed", parameter.allowed},
                         {"default",
                          parameter.default_text.empty() ? JsonValue() : JsonValue(parameter.default_text)}});
                  })}});
          }));
  return out.pretty() + "\n";
}

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const auto& [name, make] : lists) out.push_back(name);
  return out;
}

ExitCode print_list(const Common& common, const std::string& what) {
  for (const auto& [name, make] : lists) {
    if (name != what) continue;
    const std::vector<Entry> lines = make();
    print_result(common, text(what, lines), json(common, what, lines));
    return ExitCode::done;
  }
  throw InputError({.source = "list",
                    .value = what,
                    .problem = with_nearest_word("is unknown", what, names()),
                    .allowed = listed(names())});
}

}  // namespace

std::vector<std::string> list_names() { return names(); }

std::vector<std::string> listed_names(const std::string& what) {
  std::vector<std::string> out;
  for (const auto& [name, make] : lists)
    if (name == what)
      for (const Entry& entry : make()) out.push_back(entry.name);
  return out;
}

void add_list(Program& program) {
  Subcommand command = program.add("list", "What there is, a line each, with parameters and defaults");
  auto what = std::make_shared<std::string>();
  command.word("WHAT", *what, listed(names()));
  command.runs([&common = program.common(), what] { return print_list(common, *what); });
}

}  // namespace radcert::app
