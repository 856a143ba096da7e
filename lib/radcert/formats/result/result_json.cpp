// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/result_json.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/core/version.h"
#include "radcert/formats/problem/problem_json.h"

namespace radcert {

namespace {

/// An unknown radius is null.
JsonValue number_json(const Approximation& number) {
  JsonValue out = JsonValue::object();
  out.set("value", number.value);
  out.set("radius", number.has_radius() ? JsonValue(number.radius) : JsonValue());
  out.set("guaranteed", number.guaranteed);
  return out;
}

JsonValue figure_json(const std::optional<Approximation>& figure) {
  return figure ? number_json(*figure) : JsonValue();
}

JsonValue finite_or_null(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return {};
  return *value;
}

JsonValue orders_json(const std::vector<OrderFit>& orders) {
  JsonValue out = JsonValue::object();
  const auto number = [](int level) { return JsonValue(level); };
  for (const OrderFit& fit : orders) {
    JsonValue entry = JsonValue::object();
    entry.set("order", finite_or_null(fit.order));
    entry.set("halfwidth", finite_or_null(fit.halfwidth));
    entry.set("levels", json_array(fit.levels, number));
    entry.set("left_out", json_array(fit.left_out, number));
    entry.set("model", fit.model);
    out.set(fit.quantity, std::move(entry));
  }
  return out;
}

JsonValue timing_json(const std::vector<LevelTiming>& timing) {
  JsonValue out = JsonValue::object();
  out.set("levels", json_array(timing, [](const LevelTiming& level) {
            JsonValue entry = JsonValue::object();
            entry.set("assembly_seconds", level.assembly_seconds);
            entry.set("operator_seconds", level.operator_seconds);
            entry.set("solve_seconds", level.solve_seconds);
            return entry;
          }));
  return out;
}

JsonValue iteration_json(const std::optional<IterationReport>& iteration) {
  if (!iteration) return {};
  JsonValue out = JsonValue::object();
  out.set("iterations", iteration->iterations);
  out.set("contraction", iteration->contraction);
  out.set("error_bound", iteration->error_bound);
  return out;
}

JsonValue verified_json(const std::optional<VerifiedReport>& verified) {
  if (!verified) return {};
  JsonValue out = JsonValue::object();
  out.set("theta", verified->theta);
  out.set("solution_radius", verified->solution_radius);
  return out;
}

}  // namespace

JsonValue level_json(const LevelResult& level) {
  JsonValue out = JsonValue::object();
  out.set("level", level.level);
  out.set("elements", level.elements);
  out.set("unknowns", level.unknowns);
  out.set("mesh_size", level.mesh_size);
  out.set("discretisation_error", figure_json(level.discretisation_error));
  out.set("node_error", figure_json(level.node_error));
  out.set("uniform_error", figure_json(level.uniform_error));
  out.set("discretisation_ratio", finite_or_null(level.discretisation_ratio));
  out.set("node_ratio", finite_or_null(level.node_ratio));
  out.set("discretisation_order", finite_or_null(level.discretisation_order));
  out.set("node_order", finite_or_null(level.node_order));
  JsonValue means = JsonValue::object();
  for (const auto& [piece, mean] : level.piece_means) means.set(piece, mean);
  out.set("piece_means", std::move(means));
  out.set("norm_K", number_json(level.norm_K));
  out.set("planned_bytes", level.planned_bytes);
  out.set("iteration", iteration_json(level.iteration));
  out.set("verified", verified_json(level.verified));
  out.set("solution_radius", finite_or_null(level.solution_radius));
  out.set("means_radius", finite_or_null(level.means_radius));
  return out;
}

JsonValue result_json(const Result& result, const std::string& command) {
  JsonValue out = JsonValue::object();
  out.set("schema", "radcert/solution/1");
  out.set("radcert", version());
  out.set("command", command);
  out.set("problem", problem_json(result.problem));
  out.set("levels", json_array(result.levels, level_json));
  out.set("orders", orders_json(result.orders));
  out.set("timing", timing_json(result.timing));
  return out;
}

std::string result_text(const Result& result, const std::string& command) {
  return result_json(result, command).pretty() + "\n";
}

}  // namespace radcert
