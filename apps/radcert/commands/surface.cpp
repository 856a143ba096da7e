// SPDX-License-Identifier: GPL-3.0-or-later

// radcert surface NAME or FILE: what a surface is made of, and what is decided about it.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "named_surface.h"
#include "output.h"
#include "radcert/core/text.h"
#include "radcert/factors/factor_mesh.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/result/surface_json.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/rational.h"
#include "requests/factor_request.h"

namespace radcert::app {

namespace {

using Rows = std::vector<std::vector<std::string>>;

struct SurfaceOptions {
  std::string name;
  std::string angle;
  std::vector<std::string> repair;
  std::string front = "auto";
  std::string unit;
  std::string write;
};

std::string point_text(const Vector<double>& p) {
  return "(" + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")";
}

/// A number that double found, with no word on its error.
std::string about(double value, int digits) { return nearest_text(value, DecimalForm::general(digits)); }

std::string exact_text(const Vector<Rational>& p) {
  return "(" + p.x.to_text() + ", " + p.y.to_text() + ", " + p.z.to_text() + ")";
}

std::string several(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// A row of the table where there is something to count.
template <class List>
void defect_row(Rows& rows, const List& list, const std::string& what, const std::string& first) {
  if (!list.empty()) rows.push_back({"", several(list.size(), what, what) + ", the first " + first});
}

void file_rows(Rows& rows, const MeshSurvey& survey) {
  rows.push_back({"file", fmt::format("{}, {}, {}; coordinates {}", survey.format,
                                      several(survey.file_vertices, "vertex", "vertices"),
                                      several(survey.file_faces, "face", "faces"), survey.precision.words)});
  if (survey.joined_corners > 0)
    rows.push_back({"", several(survey.joined_corners, "corner", "corners") +
                            " joined to others with the same coordinates"});
  if (survey.cut_faces > 0) {
    std::string line =
        several(survey.cut_faces, "face", "faces") + " of more than three corners cut into triangles";
    if (survey.bent_faces.empty())
      line += ", each in one plane exactly";
    else
      line += fmt::format(", {} of them not plane: the diagonals below decide what the surface is there",
                          survey.bent_faces.size());
    rows.push_back({"", line});
  }
  for (const std::string& line : survey.mended) rows.push_back({"mended", line});
  for (const std::string& line : survey.remarks) rows.push_back({"remark", line});
}

void piece_rows(Rows& rows, const MeshSurvey& survey) {
  if (!survey.components) return;
  const SmoothComponents& components = *survey.components;
  rows.push_back({"smooth components", fmt::format("{}, parted where normals make more than {} degrees",
                                                   components.count, about(survey.degrees, 6))});
  std::vector<std::size_t> triangles(survey.pieces.size(), 0);
  for (const std::size_t piece : components.of_piece) ++triangles[piece];
  constexpr std::size_t most_pieces = 20;
  std::string names;
  for (std::size_t i = 0; i < std::min(survey.pieces.size(), most_pieces); ++i)
    names += fmt::format("{}{} ({})", i == 0 ? "" : ", ", survey.pieces[i], triangles[i]);
  if (survey.pieces.size() > most_pieces) names += ", ...";
  rows.push_back({"pieces", fmt::format("{}: {} (charts)", survey.pieces.size(), names)});
  std::size_t closed = 0;
  for (const SharpLine& line : components.lines) closed += line.closed ? 1 : 0;
  rows.push_back({"edges", fmt::format("{}, {} of them closed", components.lines.size(), closed)});
  rows.push_back({"corners", std::to_string(components.corners.size())});
  rows.push_back({"planes", fmt::format("{} different ones of {} triangles", survey.planes->count(),
                                        survey.mesh.triangles.size())});
  if (survey.planes->count() > survey.pieces.size())
    rows.push_back({"", "a piece of several planes stays a polyhedron: its charts are flat"});
}

void orientation_rows(Rows& rows, const MeshSurvey& survey) {
  const MeshTopology& topology = survey.topology;
  if (!topology.disagreeing_edges.empty()) {
    const MeshEdge& first = topology.edges[topology.disagreeing_edges.front()];
    rows.push_back({"orientation", several(topology.disagreeing_edges.size(), "edge", "edges") +
                                       " between triangles that run against each other, the first " +
                                       point_text(survey.mesh.vertices[first.from]) + " to " +
                                       point_text(survey.mesh.vertices[first.to])});
    return;
  }
  if (survey.front.undecided) {
    rows.push_back({"orientation", "undecided: it " + *survey.front.undecided});
    return;
  }
  const bool right = survey.front.orientation == Orientation::along_the_cross_product;
  const std::string front = right ? "right-hand" : "left-hand";
  switch (survey.front.known_by) {
    case InnerSide::by_volume:
      rows.push_back({"orientation", "counterclockwise as seen from " +
                                         std::string(right ? "inside" : "outside") +
                                         ", by the sign of the volume: front " + front});
      return;
    case InnerSide::by_file:
      rows.push_back({"orientation", "front " + front + ", as the file has it"});
      if (survey.looks_away)
        rows.push_back(
            {"", "all of it looks away from the rest; with --front left-hand the light is inside"});
      return;
    case InnerSide::by_choice: rows.push_back({"orientation", "front " + front + ", as asked for"}); return;
  }
}

void topology_rows(Rows& rows, const MeshSurvey& survey) {
  const MeshTopology& topology = survey.topology;
  const auto at = [&](std::size_t vertex) { return point_text(survey.mesh.vertices[vertex]); };
  const auto edge_text = [&](std::size_t e) {
    return at(topology.edges[e].from) + " to " + at(topology.edges[e].to);
  };
  if (topology.open_edges.empty()) {
    rows.push_back(
        {"border", topology.closed() ? "closed" : "no open edge, but edges of more than two triangles"});
  } else {
    rows.push_back(
        {"border", fmt::format("open: {} in {}", several(topology.open_edges.size(), "edge", "edges"),
                               several(topology.open_loops.size(), "line", "lines"))});
    constexpr std::size_t most_edges = 3;
    for (std::size_t i = 0; i < std::min(topology.open_edges.size(), most_edges); ++i)
      rows.push_back({"", edge_text(topology.open_edges[i])});
  }
  rows.push_back({"connected", several(topology.component_count, "component", "components")});
  rows.push_back({"Euler", fmt::format("V - E + F = {}", topology.characteristic)});
  orientation_rows(rows, survey);

  Rows defects;
  const MeshDefects& found = survey.defects;
  if (!found.duplicate_vertices.empty())
    defect_row(defects, found.duplicate_vertices, "vertices with the coordinates of another",
               at(found.duplicate_vertices.front().first));
  if (!found.unreferenced_vertices.empty())
    defect_row(defects, found.unreferenced_vertices, "vertices that no triangle uses",
               at(found.unreferenced_vertices.front()));
  if (!found.degenerate_triangles.empty())
    defect_row(defects, found.degenerate_triangles, "degenerate triangles",
               "at " + at(survey.mesh.triangles[found.degenerate_triangles.front()][0]));
  if (!topology.crowded_edges.empty())
    defect_row(defects, topology.crowded_edges, "edges of more than two triangles",
               edge_text(topology.crowded_edges.front()));
  if (!topology.pinched_vertices.empty())
    defect_row(defects, topology.pinched_vertices, "vertices where several sheets meet",
               at(topology.pinched_vertices.front()));
  if (!found.crossing.empty()) {
    const auto [a, b] = found.crossing.front();
    defect_row(defects, found.crossing,
               found.crossing.size() == most_crossings.count()
                   ? "pairs or more of triangles that cross or overlap"
                   : "pairs of triangles that cross or overlap",
               "of faces " + std::to_string(survey.mesh.face[a] + 1) + " and " +
                   std::to_string(survey.mesh.face[b] + 1));
  }
  if (defects.empty()) defects.push_back({"", "none"});
  defects.front().front() = "defects";
  rows.insert(rows.end(), defects.begin(), defects.end());
}

std::string enclosed_text(const Vector<Ball>& p) {
  constexpr int digits = 10;
  return "(" + p.x.to_text(digits) + ", " + p.y.to_text(digits) + ", " + p.z.to_text(digits) + ")";
}

void chart_witness_rows(Rows& rows, const Surface& surface, const ConvexContainment& containment) {
  if (!containment.chart_witness) return;
  constexpr int digits = 10;
  const ChartWitness& witness = *containment.chart_witness;
  const auto place = [&](std::size_t chart, const ParameterPoint<Rational>& at) {
    return surface.charts.at(chart).facts().name + " at (" + at.s.to_text() + ", " + at.t.to_text() + ")";
  };
  rows.push_back(
      {"witness P", place(witness.chart_p, witness.at_p) + ", the point " + enclosed_text(witness.p)});
  rows.push_back(
      {"witness Q", place(witness.chart_q, witness.at_q) + ", the point " + enclosed_text(witness.q)});
  rows.push_back({"", "(Q-P).n = " + witness.product.to_text(digits) +
                          " < 0 with n = " + enclosed_text(witness.inner_normal)});
  rows.push_back({"depth", "about " + about(containment.relative_depth, 3) + " of the diagonal"});
}

void step_rows(Rows& rows, const ConvexContainment& containment) {
  // Charts of which the same was proved are counted, the first is named.
  std::string title = "proof";
  for (std::size_t i = 0; i < containment.steps.size();) {
    std::size_t next = i;
    while (next < containment.steps.size() && containment.steps[next].proof == containment.steps[i].proof)
      ++next;
    const std::string more = next - i == 1 ? "" : " and " + std::to_string(next - i - 1) + " more";
    rows.push_back({title, containment.steps[i].says + more + ": " + containment.steps[i].proof});
    title.clear();
    i = next;
  }
}

void containment_rows(Rows& rows, const ConvexContainment& containment) {
  rows.push_back({"convex", containment_word(containment.verdict) + ": " + containment.reason});
  if (!containment.witness) return;
  const ContainmentWitness& witness = *containment.witness;
  rows.push_back({"witness P", exact_text(witness.p)});
  rows.push_back({"witness Q", exact_text(witness.q)});
  rows.push_back(
      {"", "(Q-P).n = " + witness.product.to_text() + " < 0 with n = " + exact_text(witness.inner_normal)});
  rows.push_back(
      {"depth", fmt::format("about {} of the diagonal; {} of {} planes", about(containment.relative_depth, 3),
                            containment.violated_planes, containment.planes)});
  rows.push_back({"", containment.within_precision ? "below the file's precision: rounding may account for it"
                                                   : "above the file's precision: no matter of rounding"});
}

std::string rounded_point(const Vector<double>& p) {
  constexpr int digits = 6;
  // A sum with 0 makes -0 what it is.
  return "(" + about(p.x + 0.0, digits) + ", " + about(p.y + 0.0, digits) + ", " + about(p.z + 0.0, digits) +
         ")";
}

/// A line for each piece, of a file with very many of the first ones.
std::string measures_text(const std::vector<std::string>& names, std::span<const PieceMeasures> measures,
                          const std::optional<std::string>& unit) {
  constexpr std::size_t most_pieces = 100;
  constexpr int digits = 10;
  Rows rows{{"piece", "triangles", unit ? "area (" + *unit + "^2)" : "area", "+-", "normal to the front",
             "centroid", "box"}};
  for (std::size_t i = 0; i < std::min(measures.size(), most_pieces); ++i) {
    const PieceMeasures& m = measures[i];
    const EnclosingText area = enclosing_text(m.area.value, m.area.radius, DecimalForm::general(digits));
    rows.push_back({names[i], std::to_string(m.triangles), area.value, area.radius,
                    m.normal ? rounded_point(*m.normal) : "several planes", rounded_point(m.centroid),
                    point_text(m.box.low) + " to " + point_text(m.box.high)});
  }
  std::string out = "\n" + aligned_left(rows);
  if (measures.size() > most_pieces)
    out += fmt::format("... and {} more; --json has all\n", measures.size() - most_pieces);
  return out;
}

/// Of the pieces of a mesh, normals to its front.
std::vector<PieceMeasures> measures_of(const MeshSurvey& survey) {
  if (!survey.components) return {};
  std::vector<PieceMeasures> out =
      piece_measures(survey.mesh, survey.components->of_piece, survey.pieces.size());
  if (survey.front.orientation == Orientation::against_the_cross_product)
    for (PieceMeasures& piece : out)
      if (piece.normal) piece.normal = -*piece.normal;
  return out;
}

/// Of the pieces of a surface of plane charts.
std::vector<PieceMeasures> measures_of(const Surface& surface) {
  for (const Chart& chart : surface.charts)
    if (!chart.facts().plane) return {};
  FactorMesh mesh = factor_mesh(surface, 0);
  for (Vector<double>& vertex : mesh.mesh.vertices) vertex = mesh.unit.to_double() * vertex;
  return piece_measures(mesh.mesh, mesh.piece, mesh.piece_names.size());
}

std::string mesh_text(const std::string& file, const MeshSurvey& survey) {
  Rows rows{{"surface", file}};
  file_rows(rows, survey);
  piece_rows(rows, survey);
  topology_rows(rows, survey);
  containment_rows(rows, survey.containment);
  const std::optional<std::string> obstacle = survey.obstacle();
  rows.push_back({"unoccluded", survey.containment.verdict == Containment::certified ? "yes" : "not known"});
  rows.push_back({"solve", obstacle ? "refused: " + *obstacle : "accepts it"});
  const MeshQuality& quality = survey.quality;
  rows.push_back(
      {"triangles", fmt::format("angles {} to {} degrees, sides {} to {}, aspect up to {}, area {}",
                                about(quality.smallest_angle, 4), about(quality.largest_angle, 4),
                                about(quality.shortest_side, 4), about(quality.longest_side, 4),
                                about(quality.largest_aspect, 3), about(quality.area, 6))});
  return aligned_left(rows);
}

std::string catalogue_text(const Surface& surface, const ConvexContainment& containment) {
  Rows rows{{"surface", surface.name}};
  for (const SurfaceParameter& parameter : surface.parameters)
    rows.push_back({"", parameter.name + " = " + parameter.value.to_text()});
  rows.push_back({"charts", std::to_string(surface.chart_count())});
  const std::vector<std::string> pieces = surface.piece_names();
  rows.push_back({"pieces", std::to_string(pieces.size()) + ": " + listed(pieces)});
  rows.push_back({"border", surface.closed ? "closed" : "open"});
  rows.push_back(
      {"joins", surface.pieces_meet_at_angle ? "pieces meet at an angle" : "no pieces meet at an angle"});
  containment_rows(rows, containment);
  chart_witness_rows(rows, surface, containment);
  step_rows(rows, containment);
  const std::string unoccluded = containment.verdict == Containment::certified
                                     ? "yes, it follows"
                                     : (surface.unoccluded ? "stated, not proved" : "no");
  rows.push_back({"unoccluded", unoccluded});
  return aligned_left(rows);
}

double degrees_of(const std::string& text) {
  if (text.empty()) return default_sharp_degrees;
  const Outcome<Rational> angle = Rational::parse(text);
  if (!angle || angle->sign() < 0 || *angle > Rational(180))
    throw InputError({.source = "--angle", .value = text, .allowed = "an angle in degrees, from 0 to 180"});
  return angle->to_double();
}

/// The mesh as it was decided on: every double as its shortest exact text.
std::string off_text(const TriangleMesh& mesh) {
  std::string out = fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.triangles.size());
  for (const Vector<double>& v : mesh.vertices)
    out += shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z) + "\n";
  for (const VertexTriple& t : mesh.triangles) out += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return out;
}

/// The same with the names of groups, a group's triangles after one another.
std::string obj_text(const TriangleMesh& mesh) {
  std::string out;
  for (const Vector<double>& v : mesh.vertices)
    out += "v " + shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z) + "\n";
  for (std::size_t g = 0; g < mesh.group_names.size(); ++g) {
    if (std::find(mesh.group.begin(), mesh.group.end(), g) == mesh.group.end()) continue;
    if (!mesh.group_names[g].empty()) out += "g " + mesh.group_names[g] + "\n";
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (mesh.group[t] == g)
        out += fmt::format("f {} {} {}\n", mesh.triangles[t][0] + 1, mesh.triangles[t][1] + 1,
                           mesh.triangles[t][2] + 1);
  }
  return out;
}

std::string text_for(const std::string& file, const TriangleMesh& mesh) {
  if (file.ends_with(".off")) return off_text(mesh);
  if (file.ends_with(".obj")) return obj_text(mesh);
  throw InputError({.source = "--write", .value = file, .allowed = "a name in .off, or .obj with groups"});
}

ExitCode show_mesh(const Common& common, const SurfaceOptions& options) {
  Outputs outputs(common);
  outputs.file("--write", options.write);
  outputs.input(options.name);
  const std::optional<std::string> unit = unit_of_lengths(options.unit, "--unit");
  const MeshSurvey survey = survey_mesh(options.name, degrees_of(options.angle), repair_of(options.repair),
                                        front_of(options.front));
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  if (!options.write.empty()) files.emplace_back(options.write, text_for(options.write, survey.mesh));
  const std::vector<PieceMeasures> measures = measures_of(survey);
  print_result(common, outputs,
               mesh_text(options.name, survey) +
                   (measures.empty() ? "" : measures_text(survey.pieces, measures, unit)),
               surface_report(options.name, survey, measures, unit, common.command).pretty() + "\n",
               std::move(files));
  return ExitCode::done;
}

ExitCode show_catalogue(const Common& common, const SurfaceOptions& options) {
  const SurfaceDescription& description = surface_named(options.name);
  const std::optional<std::string> unit = unit_of_lengths(options.unit, "--unit");
  for (const auto& [option, given] :
       {std::pair("--angle", !options.angle.empty()), std::pair("--repair", !options.repair.empty()),
        std::pair("--front", options.front != "auto"), std::pair("--write", !options.write.empty())})
    if (given)
      throw InputError(
          {.source = option, .problem = "is for meshes", .allowed = "a file in " + mesh_file_endings()});
  const Surface surface = default_surface(description);
  const ConvexContainment containment = convex_containment(surface);
  const std::vector<PieceMeasures> measures = measures_of(surface);
  print_result(common,
               catalogue_text(surface, containment) +
                   (measures.empty() ? "" : measures_text(surface.piece_names(), measures, unit)),
               surface_report(surface, containment, measures, unit, common.command).pretty() + "\n");
  return ExitCode::done;
}

ExitCode show(const Common& common, const SurfaceOptions& options) {
  const auto limit = common.limit_threads();
  return is_mesh_file_name(options.name) ? show_mesh(common, options) : show_catalogue(common, options);
}

}  // namespace

void add_surface(Program& program) {
  Subcommand command = program.add(
      "surface",
      "Pieces with areas and normals, border, orientation, convex-containment certificate, mesh quality");
  auto options = std::make_shared<SurfaceOptions>();
  command.word("SURFACE", options->name,
               "A surface of radcert list surfaces, or a mesh in " + mesh_file_endings(), "NAME or FILE");
  command.option("--angle", options->angle,
                 "Edges whose triangles' normals make a larger angle part two pieces; default 30", "DEGREES");
  command.list("--repair", options->repair,
               "Mend the mesh in memory: align, triangulate, vertices, faces, orientation, manifold, "
               "crossings, holes; "
               "without it nothing is mended",
               "WHAT,...");
  command.option("--front", options->front, front_help, "WHICH");
  command.option("--unit", options->unit, unit_help, "UNIT");
  command.option("--write", options->write, "Write the triangles, mended if asked: .off, or .obj with groups",
                 "FILE.off");
  command.footer(
      "Triangles that cross are left out by --repair crossings; with holes too, what that opens is closed.\n"
      "Faces of more than three corners must be exactly plane; --repair triangulate cuts those that are not, "
      "and says how.");
  command.runs([&common = program.common(), options] { return show(common, *options); });
}

}  // namespace radcert::app
