// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/surface_json.h"
#include "radcert/formats/json/json_document.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace radcert {

namespace {

JsonValue point_json(const Vector<double>& p) {
  return JsonValue::array({JsonValue(p.x), JsonValue(p.y), JsonValue(p.z)});
}

/// Coordinates in exact or ball arithmetic.
template <class R>
JsonValue point_text_json(const Vector<R>& p) {
  return JsonValue::array({JsonValue(p.x.to_text()), JsonValue(p.y.to_text()), JsonValue(p.z.to_text())});
}

/// {"count": n, "first": [...]}.
template <class List, class Make>
JsonValue counted_json(const List& list, const Make& make) {
  JsonValue first = JsonValue::array();
  for (std::size_t i = 0; i < std::min(list.size(), surface_json_places); ++i) first.push(make(list[i]));
  return JsonValue::object({{"count", list.size()}, {"first", std::move(first)}});
}

JsonValue exact_parameters_json(const ParameterPoint<Rational>& at) {
  return JsonValue::array({JsonValue(at.s.to_text()), JsonValue(at.t.to_text())});
}

JsonValue chart_witness_json(const Surface& surface, const ChartWitness& witness) {
  return JsonValue::object({{"chart_p", surface.charts.at(witness.chart_p).facts().name},
                            {"parameters_p", exact_parameters_json(witness.at_p)},
                            {"chart_q", surface.charts.at(witness.chart_q).facts().name},
                            {"parameters_q", exact_parameters_json(witness.at_q)},
                            {"p", point_text_json(witness.p)},
                            {"q", point_text_json(witness.q)},
                            {"inner_normal", point_text_json(witness.inner_normal)},
                            {"product", witness.product.to_text()}});
}

/// surface: null for a mesh.
JsonValue containment_json(const ConvexContainment& containment, const Surface* surface) {
  JsonValue out = JsonValue::object();
  out.set("verdict", containment_word(containment.verdict));
  out.set("reason", containment.reason);
  out.set("planes", containment.planes == 0 ? JsonValue() : JsonValue(containment.planes));
  out.set("violated_planes", containment.planes == 0 ? JsonValue() : JsonValue(containment.violated_planes));
  const bool refuted = containment.verdict == Containment::refuted;
  out.set("relative_depth", refuted ? JsonValue(containment.relative_depth) : JsonValue());
  out.set("within_precision",
          refuted && surface == nullptr ? JsonValue(containment.within_precision) : JsonValue());
  JsonValue witness;
  if (surface != nullptr && containment.chart_witness)
    witness = chart_witness_json(*surface, *containment.chart_witness);
  if (containment.witness) {
    witness = JsonValue::object();
    witness.set("p", point_text_json(containment.witness->p));
    witness.set("q", point_text_json(containment.witness->q));
    witness.set("inner_normal", point_text_json(containment.witness->inner_normal));
    witness.set("product", containment.witness->product.to_text());
    witness.set("triangle", containment.witness->triangle);
    witness.set("vertex", containment.witness->vertex);
  }
  out.set("witness", std::move(witness));
  out.set("steps", json_array(containment.steps, [](const ContainmentStep& step) {
            return JsonValue::object({{"of", step.says}, {"proof", step.proof}});
          }));
  out.set("open", json_array(containment.open, [surface](const OpenPair& pair) {
            return JsonValue::object({{"chart_p", surface->charts.at(pair.chart_p).facts().name},
                                      {"chart_q", surface->charts.at(pair.chart_q).facts().name},
                                      {"boxes", pair.boxes}});
          }));
  return out;
}

JsonValue file_json(const MeshSurvey& survey) {
  return JsonValue::object({{"format", survey.format},
                            {"digest", survey.digest},
                            {"vertices", survey.file_vertices},
                            {"faces", survey.file_faces},
                            {"joined_corners", survey.joined_corners},
                            {"cut_faces", survey.cut_faces},
                            {"bent_faces", survey.bent_faces.size()},
                            {"precision", survey.precision.words},
                            {"precision_unit", survey.precision.unit},
                            {"mended", json_array(survey.mended)},
                            {"remarks", json_array(survey.remarks)}});
}

/// Where an edge begins and ends.
JsonValue edge_json(const MeshSurvey& survey, std::size_t e) {
  const MeshEdge& edge = survey.topology.edges[e];
  return JsonValue::array(
      {point_json(survey.mesh.vertices[edge.from]), point_json(survey.mesh.vertices[edge.to])});
}

JsonValue defects_json(const MeshSurvey& survey) {
  const auto at = [&](std::size_t vertex) { return point_json(survey.mesh.vertices[vertex]); };
  const auto edge_at = [&](std::size_t e) { return edge_json(survey, e); };
  const auto number = [](std::size_t n) { return JsonValue(n); };
  const auto pair = [](const std::pair<std::size_t, std::size_t>& p) {
    return JsonValue::array({JsonValue(p.first), JsonValue(p.second)});
  };
  return JsonValue::object(
      {{"duplicate_vertices", counted_json(survey.defects.duplicate_vertices, pair)},
       {"unreferenced_vertices", counted_json(survey.defects.unreferenced_vertices, at)},
       {"degenerate_triangles", counted_json(survey.defects.degenerate_triangles, number)},
       {"crossing_triangles", counted_json(survey.defects.crossing, pair)},
       {"disagreeing_edges", counted_json(survey.topology.disagreeing_edges, edge_at)},
       {"crowded_edges", counted_json(survey.topology.crowded_edges, edge_at)},
       {"pinched_vertices", counted_json(survey.topology.pinched_vertices, at)},
       {"misoriented_components", counted_json(survey.front.misoriented, number)}});
}

JsonValue quality_json(const MeshQuality& quality) {
  return JsonValue::object({{"area", quality.area},
                            {"shortest_side", quality.shortest_side},
                            {"longest_side", quality.longest_side},
                            {"smallest_angle", quality.smallest_angle},
                            {"largest_angle", quality.largest_angle},
                            {"largest_aspect", quality.largest_aspect},
                            {"worst_triangle", quality.worst_triangle}});
}

std::string inner_side_word(InnerSide side) {
  switch (side) {
    case InnerSide::by_volume: return "volume";
    case InnerSide::by_file: return "file";
    case InnerSide::by_choice: return "choice";
  }
  return {};
}

JsonValue piece_json(const std::string& name, std::size_t charts, std::size_t component,
                     const PieceMeasures* measures) {
  JsonValue out = JsonValue::object({{"name", name}, {"charts", charts}, {"smooth_component", component}});
  const JsonValue unknown;
  out.set("area", measures == nullptr ? unknown : JsonValue(measures->area.value));
  out.set("area_radius", measures == nullptr ? unknown : JsonValue(measures->area.radius));
  out.set("normal", measures == nullptr || !measures->normal ? unknown : point_json(*measures->normal));
  out.set("centroid", measures == nullptr ? unknown : point_json(measures->centroid));
  out.set("box", measures == nullptr
                     ? unknown
                     : JsonValue::array({point_json(measures->box.low), point_json(measures->box.high)}));
  return out;
}

const PieceMeasures* measures_of(std::span<const PieceMeasures> measures, std::size_t piece) {
  return piece < measures.size() ? &measures[piece] : nullptr;
}

JsonValue pieces_json(const MeshSurvey& survey, std::span<const PieceMeasures> measures) {
  if (!survey.components) return {};
  std::vector<std::size_t> triangles(survey.pieces.size(), 0);
  std::vector<std::size_t> component(survey.pieces.size(), 0);
  for (std::size_t k = 0; k < survey.mesh.triangles.size(); ++k) {
    ++triangles[survey.components->of_piece[k]];
    component[survey.components->of_piece[k]] = survey.components->of_triangle[k];
  }
  JsonValue out = JsonValue::array();
  for (std::size_t i = 0; i < survey.pieces.size(); ++i)
    out.push(piece_json(survey.pieces[i], triangles[i], component[i], measures_of(measures, i)));
  return out;
}

}  // namespace

JsonValue surface_report(const std::string& file, const MeshSurvey& survey,
                         std::span<const PieceMeasures> measures, const std::optional<std::string>& unit,
                         const std::string& command) {
  const auto at = [&](std::size_t vertex) { return point_json(survey.mesh.vertices[vertex]); };
  const auto& components = survey.components;
  JsonValue out = document_head("surface", command);
  out.set("name", file);
  out.set("kind", "mesh");
  out.set("unit", unit);
  out.set("file", file_json(survey));
  out.set("vertices", survey.topology.used_vertices);
  out.set("triangles", survey.mesh.triangles.size());
  out.set("angle", survey.degrees);
  out.set("smooth_components", components ? JsonValue(components->count) : JsonValue());
  out.set("pieces", pieces_json(survey, measures));
  out.set("edges", components ? JsonValue(components->lines.size()) : JsonValue());
  out.set("corners", components ? counted_json(components->corners, at) : JsonValue());
  out.set("planes", survey.planes ? JsonValue(survey.planes->count()) : JsonValue());
  out.set("closed", survey.topology.closed());
  out.set("open_edges",
          counted_json(survey.topology.open_edges, [&](std::size_t e) { return edge_json(survey, e); }));
  out.set("open_lines", survey.topology.open_loops.size());
  out.set("connected_components", survey.topology.component_count);
  out.set("euler_characteristic", survey.topology.characteristic);
  out.set("orientation",
          JsonValue::object(
              {{"consistent", survey.topology.disagreeing_edges.empty()},
               {"counterclockwise_from",
                survey.front.orientation == Orientation::against_the_cross_product ? "outside" : "inside"},
               {"known_by", inner_side_word(survey.front.known_by)},
               {"front", survey.front.orientation == Orientation::along_the_cross_product ? "right-hand"
                                                                                          : "left-hand"},
               {"encloses", survey.front.encloses},
               {"undecided", survey.front.undecided}}));
  out.set("defects", defects_json(survey));
  out.set("containment", containment_json(survey.containment, nullptr));
  out.set("unoccluded", survey.containment.verdict == Containment::certified ? JsonValue(true) : JsonValue());
  const std::optional<std::string> obstacle = survey.obstacle();
  out.set("obstacle", obstacle);
  out.set("quality", quality_json(survey.quality));
  return out;
}

JsonValue surface_report(const Surface& surface, const ConvexContainment& containment,
                         std::span<const PieceMeasures> measures, const std::optional<std::string>& unit,
                         const std::string& command) {
  const JsonValue unknown;
  JsonValue out = document_head("surface", command);
  out.set("name", surface.name);
  out.set("kind", "catalogue");
  out.set("unit", unit);
  for (const char* key : {"file", "vertices", "triangles", "angle"}) out.set(key, unknown);
  const std::vector<std::string> names = surface.piece_names();
  out.set("smooth_components", names.size());
  JsonValue pieces = JsonValue::array();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto charts = std::count_if(surface.charts.begin(), surface.charts.end(),
                                      [&](const Chart& chart) { return chart.facts().piece == names[i]; });
    pieces.push(piece_json(names[i], static_cast<std::size_t>(charts), i, measures_of(measures, i)));
  }
  out.set("pieces", std::move(pieces));
  for (const char* key : {"edges", "corners", "planes"}) out.set(key, unknown);
  out.set("closed", surface.closed);
  for (const char* key :
       {"open_edges", "open_lines", "connected_components", "euler_characteristic", "orientation", "defects"})
    out.set(key, unknown);
  out.set("containment", containment_json(containment, &surface));
  // What is stated follows from a certificate; a surface that is said to hide parts of itself has none.
  const bool decided = containment.verdict == Containment::certified || !surface.unoccluded;
  out.set("unoccluded", decided ? JsonValue(surface.unoccluded) : JsonValue());
  for (const char* key : {"obstacle", "quality"}) out.set(key, unknown);
  return out;
}

}  // namespace radcert
