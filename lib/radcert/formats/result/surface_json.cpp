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
  JsonValue out = JsonValue::object();
  out.set("count", list.size());
  out.set("first", std::move(first));
  return out;
}

JsonValue exact_parameters_json(const ParameterPoint<Rational>& at) {
  return JsonValue::array({JsonValue(at.s.to_text()), JsonValue(at.t.to_text())});
}

JsonValue chart_witness_json(const Surface& surface, const ChartWitness& witness) {
  JsonValue out = JsonValue::object();
  out.set("chart_p", surface.charts.at(witness.chart_p).facts().name);
  out.set("parameters_p", exact_parameters_json(witness.at_p));
  out.set("chart_q", surface.charts.at(witness.chart_q).facts().name);
  out.set("parameters_q", exact_parameters_json(witness.at_q));
  out.set("p", point_text_json(witness.p));
  out.set("q", point_text_json(witness.q));
  out.set("inner_normal", point_text_json(witness.inner_normal));
  out.set("product", witness.product.to_text());
  return out;
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
            JsonValue each = JsonValue::object();
            each.set("of", step.says);
            each.set("proof", step.proof);
            return each;
          }));
  out.set("open", json_array(containment.open, [surface](const OpenPair& pair) {
            JsonValue each = JsonValue::object();
            each.set("chart_p", surface->charts.at(pair.chart_p).facts().name);
            each.set("chart_q", surface->charts.at(pair.chart_q).facts().name);
            each.set("boxes", pair.boxes);
            return each;
          }));
  return out;
}

JsonValue file_json(const MeshSurvey& survey) {
  JsonValue out = JsonValue::object();
  out.set("format", survey.format);
  out.set("digest", survey.digest);
  out.set("vertices", survey.file_vertices);
  out.set("faces", survey.file_faces);
  out.set("joined_corners", survey.joined_corners);
  out.set("cut_faces", survey.cut_faces);
  out.set("bent_faces", survey.bent_faces.size());
  out.set("precision", survey.precision.words);
  out.set("precision_unit", survey.precision.unit);
  out.set("mended", json_array(survey.mended));
  return out;
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
  JsonValue out = JsonValue::object();
  out.set("duplicate_vertices", counted_json(survey.defects.duplicate_vertices, pair));
  out.set("unreferenced_vertices", counted_json(survey.defects.unreferenced_vertices, at));
  out.set("degenerate_triangles", counted_json(survey.defects.degenerate_triangles, number));
  out.set("crossing_triangles", counted_json(survey.defects.crossing, pair));
  out.set("disagreeing_edges", counted_json(survey.topology.disagreeing_edges, edge_at));
  out.set("crowded_edges", counted_json(survey.topology.crowded_edges, edge_at));
  out.set("pinched_vertices", counted_json(survey.topology.pinched_vertices, at));
  out.set("misoriented_components", counted_json(survey.misoriented, number));
  return out;
}

JsonValue quality_json(const MeshQuality& quality) {
  JsonValue out = JsonValue::object();
  out.set("area", quality.area);
  out.set("shortest_side", quality.shortest_side);
  out.set("longest_side", quality.longest_side);
  out.set("smallest_angle", quality.smallest_angle);
  out.set("largest_angle", quality.largest_angle);
  out.set("largest_aspect", quality.largest_aspect);
  out.set("worst_triangle", quality.worst_triangle);
  return out;
}

std::string inner_side_word(InnerSide side) {
  switch (side) {
    case InnerSide::by_volume: return "volume";
    case InnerSide::by_certificate: return "certificate";
    case InnerSide::by_convention: return "convention";
  }
  return {};
}

JsonValue piece_json(const std::string& name, std::size_t charts, std::size_t component) {
  JsonValue out = JsonValue::object();
  out.set("name", name);
  out.set("charts", charts);
  out.set("smooth_component", component);
  return out;
}

JsonValue pieces_json(const MeshSurvey& survey) {
  if (!survey.components) return {};
  std::vector<std::size_t> triangles(survey.pieces.size(), 0);
  std::vector<std::size_t> component(survey.pieces.size(), 0);
  for (std::size_t k = 0; k < survey.mesh.triangles.size(); ++k) {
    ++triangles[survey.components->of_piece[k]];
    component[survey.components->of_piece[k]] = survey.components->of_triangle[k];
  }
  JsonValue out = JsonValue::array();
  for (std::size_t i = 0; i < survey.pieces.size(); ++i)
    out.push(piece_json(survey.pieces[i], triangles[i], component[i]));
  return out;
}

}  // namespace

JsonValue surface_report(const std::string& file, const MeshSurvey& survey, const std::string& command) {
  const auto at = [&](std::size_t vertex) { return point_json(survey.mesh.vertices[vertex]); };
  const auto& components = survey.components;
  JsonValue out = document_head("surface", command);
  out.set("name", file);
  out.set("kind", "mesh");
  out.set("file", file_json(survey));
  out.set("vertices", survey.topology.used_vertices);
  out.set("triangles", survey.mesh.triangles.size());
  out.set("angle", survey.degrees);
  out.set("smooth_components", components ? JsonValue(components->count) : JsonValue());
  out.set("pieces", pieces_json(survey));
  out.set("edges", components ? JsonValue(components->lines.size()) : JsonValue());
  out.set("corners", components ? counted_json(components->corners, at) : JsonValue());
  out.set("planes", survey.planes ? JsonValue(survey.planes->count()) : JsonValue());
  out.set("closed", survey.topology.closed());
  out.set("open_edges",
          counted_json(survey.topology.open_edges, [&](std::size_t e) { return edge_json(survey, e); }));
  out.set("open_lines", survey.topology.open_loops.size());
  out.set("connected_components", survey.topology.component_count);
  out.set("euler_characteristic", survey.topology.characteristic);
  JsonValue orientation = JsonValue::object();
  orientation.set("consistent", survey.topology.disagreeing_edges.empty());
  orientation.set("counterclockwise_from",
                  survey.orientation == Orientation::against_the_cross_product ? "outside" : "inside");
  orientation.set("known_by", inner_side_word(survey.inner_side));
  out.set("orientation", std::move(orientation));
  out.set("defects", defects_json(survey));
  out.set("containment", containment_json(survey.containment, nullptr));
  out.set("unoccluded", survey.containment.verdict == Containment::certified ? JsonValue(true) : JsonValue());
  const std::optional<std::string> obstacle = survey.obstacle();
  out.set("obstacle", obstacle);
  out.set("quality", quality_json(survey.quality));
  return out;
}

JsonValue surface_report(const Surface& surface, const ConvexContainment& containment,
                         const std::string& command) {
  const JsonValue unknown;
  JsonValue out = document_head("surface", command);
  out.set("name", surface.name);
  out.set("kind", "catalogue");
  for (const char* key : {"file", "vertices", "triangles", "angle"}) out.set(key, unknown);
  const std::vector<std::string> names = surface.piece_names();
  out.set("smooth_components", names.size());
  JsonValue pieces = JsonValue::array();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto charts = std::count_if(surface.charts.begin(), surface.charts.end(),
                                      [&](const Chart& chart) { return chart.facts().piece == names[i]; });
    pieces.push(piece_json(names[i], static_cast<std::size_t>(charts), i));
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
