// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/result_json.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/formats/json/json_document.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/collocation/graded_levels.h"
#include "radcert/study/edge_grading.h"

namespace radcert {

namespace {

JsonValue iteration_json(const std::optional<IterationReport>& iteration) {
  if (!iteration) return {};
  return JsonValue::object({{"iterations", iteration->iterations},
                            {"contraction", iteration->contraction},
                            {"error_bound", iteration->error_bound}});
}

JsonValue verified_json(const std::optional<VerifiedReport>& verified,
                        const std::optional<double>& solution_radius) {
  if (!verified) return {};
  return JsonValue::object(
      {{"theta", verified->theta}, {"solution_radius", finite_or_null(solution_radius)}});
}

JsonValue events_json(const EventCut& events) {
  return JsonValue::object({{"source_triangles", events.source_triangles},
                            {"pencils", events.pencils},
                            {"segments", events.segments},
                            {"kinks", events.kinks},
                            {"charts", events.charts},
                            {"coarse_elements", events.coarse->size()}});
}

template <std::size_t N>
JsonValue names_json(const std::array<std::string, N>& names) {
  JsonValue out = JsonValue::array();
  for (const std::string& name : names) out.push(name);
  return out;
}

JsonValue edge_json(const GradedEdge& edge) {
  return JsonValue::object({{"pieces", names_json(edge.pieces)},
                            {"degrees", edge.degrees},
                            {"reflectivities", JsonValue::array({exact_json(edge.reflectivities[0]),
                                                                 exact_json(edge.reflectivities[1])})},
                            {"exponent", edge.exponent},
                            {"grading", exact_json(edge.grading)}});
}

JsonValue corner_json(const GradedCorner& corner) {
  return JsonValue::object({{"pieces", names_json(corner.pieces)},
                            {"exponent", approximation_json(corner.exponent)},
                            {"grading", exact_json(corner.grading)}});
}

JsonValue edge_grading_json(const EdgeGrading& asked) {
  return JsonValue::object({{"grading", exact_json(asked.grading)},
                            {"edges", json_array(asked.edges, edge_json)},
                            {"corners", json_array(asked.corners, corner_json)}});
}

/// What the iterated solution is; null where it is not asked for.
JsonValue iterated_json(const LevelResult& level) {
  if (!level.iterated) return {};
  const IteratedReport& iterated = *level.iterated;
  JsonValue means = JsonValue::object();
  for (const auto& [piece, mean] : iterated.piece_means) means.set(piece, mean);
  return JsonValue::object({{"check_points", iterated.check_points},
                            {"error", approximation_json(level.iterated_error)},
                            {"u_n_error", approximation_json(iterated.u_n_error)},
                            {"node_error", approximation_json(iterated.node_error)},
                            {"difference", approximation_json(iterated.difference)},
                            {"l2_error", finite_or_null(iterated.l2_error)},
                            {"mean_error", finite_or_null(iterated.mean_error)},
                            {"piece_means", std::move(means)},
                            {"ratio", finite_or_null(iterated.ratio)},
                            {"order", finite_or_null(iterated.order)},
                            {"u_n_ratio", finite_or_null(iterated.u_n_ratio)},
                            {"u_n_order", finite_or_null(iterated.u_n_order)}});
}

}  // namespace

JsonValue orders_json(std::span<const OrderFit> orders) {
  JsonValue out = JsonValue::object();
  for (const OrderFit& fit : orders) {
    out.set(fit.quantity, JsonValue::object({{"order", finite_or_null(fit.order)},
                                             {"halfwidth", finite_or_null(fit.halfwidth)},
                                             {"levels", json_array(fit.levels)},
                                             {"left_out", json_array(fit.left_out)},
                                             {"pre_asymptotic", json_array(fit.pre_asymptotic)},
                                             {"model", fit.model}}));
  }
  return out;
}

JsonValue enclosing_json(const Approximation& number) {
  const EnclosingText text = enclosing_text(number.value, number.radius, DecimalForm::general(17));
  return JsonValue::object({{"midpoint", text.value}, {"radius", text.radius}});
}

/// A distance; none is null.
JsonValue distance_json(double distance) {
  return distance > 0 ? JsonValue(nearest_text(distance, DecimalForm::general(15))) : JsonValue();
}

JsonValue function_json(const FunctionBound& bound) {
  JsonValue by_distance = JsonValue::array();
  for (const FunctionBound::AtDistance& at : bound.by_distance)
    by_distance.push(
        JsonValue::object({{"outside", distance_json(at.outside)}, {"sup", upper_text(at.sup)}}));
  JsonValue pieces = JsonValue::object();
  for (const FunctionBound::OnPiece& on : bound.pieces)
    pieces.set(on.piece, JsonValue::object({{"outside", upper_text(on.outside)},
                                            {"everywhere", upper_text(on.everywhere)}}));
  return JsonValue::object({{"sup", upper_text(bound.sup)},
                            {"outside", distance_json(bound.outside)},
                            {"faces_are_cut", bound.faces_are_cut},
                            {"by_distance", std::move(by_distance)},
                            {"pieces", std::move(pieces)}});
}

JsonValue means_json(const std::vector<std::pair<std::string, Approximation>>& pieces) {
  JsonValue out = JsonValue::object();
  for (const auto& [piece, mean] : pieces) out.set(piece, enclosing_json(mean));
  return out;
}

JsonValue values_json(const std::vector<EnclosedValue>& points) {
  JsonValue out = JsonValue::array();
  for (const EnclosedValue& point : points) {
    const EnclosingText text =
        enclosing_text(point.value.value, point.value.radius, DecimalForm::general(17));
    out.push(JsonValue::object({{"piece", point.piece},
                                {"at", point_json(point.at)},
                                {"midpoint", text.value},
                                {"radius", text.radius}}));
  }
  return out;
}

/// What was not asked for is null.
JsonValue enclosure_json(const SolutionEnclosure& enclosure) {
  const EnclosedQuantity of = enclosure.wanted.of;
  const bool of_means = of == EnclosedQuantity::means;
  const bool of_values = of == EnclosedQuantity::values;
  JsonValue pieces = of_means ? means_json(enclosure.pieces) : JsonValue();
  JsonValue points = of_values ? values_json(enclosure.points) : JsonValue();
  JsonValue emissions = enclosure.emissions.empty() ? JsonValue() : JsonValue::object();
  for (const SolutionEnclosure::OfEmission& further : enclosure.emissions)
    emissions.set(further.emission,
                  JsonValue::object({{"pieces", of_means ? means_json(further.pieces) : JsonValue()},
                                     {"points", of_values ? values_json(further.points) : JsonValue()}}));
  JsonValue function;
  if (enclosure.function) function = function_json(*enclosure.function);
  return JsonValue::object(
      {{"of", name_of(of)},
       {"wanted", enclosing_text(enclosure.wanted.width, 0, DecimalForm::general(17)).value},
       {"width", upper_text(enclosure.width)},
       {"pieces", std::move(pieces)},
       {"points", std::move(points)},
       {"function", std::move(function)},
       {"emissions", std::move(emissions)},
       {"hindrance", enclosure.hindrance.empty() ? JsonValue() : JsonValue(enclosure.hindrance)},
       {"guaranteed", true}});
}

JsonValue timing_json(const LevelTiming& timing) {
  return JsonValue::object({{"assembly_seconds", timing.assembly_seconds},
                            {"operator_seconds", timing.operator_seconds},
                            {"solve_seconds", timing.solve_seconds},
                            {"iterated_seconds", timing.iterated_seconds}});
}

JsonValue level_json(const LevelResult& level) {
  JsonValue out = JsonValue::object();
  out.set("level", level.level);
  out.set("elements", level.elements);
  out.set("unknowns", level.unknowns);
  out.set("mesh_size", level.mesh_size);
  out.set("discretisation_error", approximation_json(level.discretisation_error));
  out.set("node_error", approximation_json(level.node_error));
  out.set("uniform_error", approximation_json(level.uniform_error));
  out.set("l2_error", approximation_json(level.l2_error));
  out.set("mean_error", approximation_json(level.mean_error));
  out.set("discretisation_ratio", finite_or_null(level.discretisation_ratio));
  out.set("node_ratio", finite_or_null(level.node_ratio));
  out.set("discretisation_order", finite_or_null(level.discretisation_order));
  out.set("node_order", finite_or_null(level.node_order));
  JsonValue means = JsonValue::object();
  double means_radius = level.piece_means.empty() ? std::numeric_limits<double>::infinity() : 0;
  for (const auto& [piece, mean] : level.piece_means) {
    means.set(piece, mean.value);
    means_radius = mean.has_radius() ? std::max(means_radius, mean.radius) : mean.radius;
  }
  out.set("piece_means", std::move(means));
  out.set("norm_K", approximation_json(level.norm_K));
  out.set("planned_bytes", level.planned_bytes);
  out.set("operator", level.matrix_form);
  out.set("solver", level.solver);
  out.set("iteration", iteration_json(level.iteration));
  out.set("verified", verified_json(level.verified, level.solution_radius));
  out.set("solution_radius", finite_or_null(level.solution_radius));
  out.set("means_radius", finite_or_null(means_radius));
  out.set("iterated", iterated_json(level));
  return out;
}

JsonValue result_json(const Result& result, const std::string& command) {
  JsonValue out = document_head("solution", command);
  out.set("problem", problem_json(result.problem));
  out.set("levels", json_array(result.levels, level_json));
  if (result.problem.triangulation.grading != Rational(1)) {
    const Surface surface = surface_of(result.problem);
    if (const auto asked = known_edge_grading(result.problem, surface))
      out.set("edge_grading", edge_grading_json(*asked));
    if (!result.enclosure) out.set("rounded_levels", json_array(rounded_levels(result.problem, surface)));
  }
  if (const auto& events = result.problem.triangulation.events) out.set("events", events_json(*events));
  if (result.enclosure) out.set("enclosure", enclosure_json(*result.enclosure));
  out.set("orders", orders_json(result.orders));
  out.set("timing", JsonValue::object({{"levels", json_array(result.timing, timing_json)}}));
  return out;
}

std::string result_text(const Result& result, const std::string& command) {
  return result_json(result, command).pretty() + "\n";
}

}  // namespace radcert
