// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/catalogue_json.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/geometry/mesh_repair.h"
#include "radcert/study/collocation/matrix_form.h"
#include "radcert/study/experiment.h"
#include "radcert/surface/catalogue.h"

namespace radcert {

namespace {

using Words = std::vector<std::string>;

Words repairs() { return {repair_words.begin(), repair_words.end()}; }

Words errors() {
  Words names;
  for (const ErrorKind& kind : error_kinds()) names.emplace_back(kind.name);
  names.emplace_back(iterated_kind().name);
  names.emplace_back("u_n_error");
  return names;
}

constexpr const char* surface_parameters = "parameters of surfaces";
constexpr std::array<std::pair<std::string_view, Words (*)()>, 16> lists{
    {{"surfaces", surface_names},
     {"repairs", repairs},
     {"patterns", pattern_names},
     {"diagonals", diagonal_names},
     {"data points", data_point_names},
     {"named meshless bases", named_meshless_families},
     {"site distances", site_distance_names},
     {"normalisations", normalisation_names},
     {"rules for too few neighbours", too_few_neighbours_names},
     {"weights", weight_rule_names},
     {"coefficients", coefficient_rule_names},
     {"operators", [] { return operator_names(); }},
     {"solvers", [] { return solver_names(); }},
     {"solvers without tolerance", solvers_without_tolerance},
     {"guaranteed quantities", guaranteed_quantities},
     {"errors", errors}}};

JsonValue object_of(const char* key, JsonValue value) { return JsonValue::object({{key, std::move(value)}}); }

/// The keys of a surface in a problem file: its name, and its parameters.
JsonValue surface_keys(const SurfaceDescription& surface) {
  JsonValue keys = object_of("name", true);
  for (const ParameterDescription& parameter : surface.parameters) {
    const std::string meaning = parameter.meaning.empty() ? "" : parameter.meaning + ", ";
    JsonValue key = object_of("description", meaning + parameter.requirement);
    key.set("default", parameter.default_text);
    key.set("$ref", "#/$defs/exact");
    keys.set(parameter.name, std::move(key));
  }
  return keys;
}

/// For all surfaces that have the same keys, what follows of their names.
JsonValue surface_conditions() {
  std::vector<std::pair<JsonValue, Words>> groups;
  for (const std::string& name : surface_names()) {
    JsonValue keys = surface_keys(*find_surface(name));
    const std::string text = keys.compact();
    const auto same =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first.compact() == text; });
    if (same != groups.end())
      same->second.push_back(name);
    else
      groups.push_back({std::move(keys), {name}});
  }
  return json_array(groups, [](const auto& group) {
    const auto& [keys, names] = group;
    JsonValue applies = object_of("required", json_array(Words{"name"}));
    applies.set("properties", object_of("name", names.size() == 1 ? object_of("const", names.front())
                                                                  : object_of("enum", json_array(names))));
    JsonValue holds = object_of("properties", keys);
    holds.set("additionalProperties", false);
    JsonValue out = object_of("if", std::move(applies));
    out.set("then", std::move(holds));
    return out;
  });
}

}  // namespace

JsonValue catalogue_json(std::string_view name) {
  if (name == surface_parameters) return surface_conditions();
  const auto list = std::find_if(lists.begin(), lists.end(), [&](const auto& l) { return l.first == name; });
  expects(list != lists.end(), "the name of a list", named("name", std::string(name)));
  return json_array(list->second());
}

}  // namespace radcert
