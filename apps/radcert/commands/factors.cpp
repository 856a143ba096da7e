// SPDX-License-Identifier: GPL-3.0-or-later

// radcert factors NAME or FILE: configuration factors between the surfaces of a scene.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "factors_table.h"
#include "named_surface.h"
#include "output.h"
#include "progress.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/result_store.h"
#include "radcert/core/text.h"
#include "radcert/core/version.h"
#include "radcert/factors/factor_mesh.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/result/factors_json.h"
#include "radcert/formats/table/factors_csv.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/surface/catalogue.h"

namespace radcert::app {

namespace {

struct FactorsOptions {
  std::string name;
  std::string by = "triangle";
  std::string level;
  std::string accuracy;
  std::string out;
  std::string compare;
  std::vector<std::string> repair;
  bool certified = false;
  bool space = false;
};

std::string point_text(const Vector<double>& p) {
  return "(" + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")";
}

FactorUnit unit_of(const std::string& word) {
  if (word == "triangle") return FactorUnit::triangle;
  if (word == "piece") return FactorUnit::piece;
  if (word == "group") return FactorUnit::group;
  throw InputError({.source = "--by", .value = word, .allowed = "triangle, piece, group"});
}

int level_of(const std::string& text) {
  if (text.empty()) return 0;
  constexpr int most = 8;
  int level = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), level);
  if (error != std::errc() || end != text.data() + text.size() || level < 0 || level > most)
    throw InputError({.source = "--level", .value = text, .allowed = "a whole number from 0 to 8"});
  return level;
}

double accuracy_of(const std::string& text, bool certified) {
  constexpr double usual_of_certified = 1e-9;
  if (text.empty()) return certified ? usual_of_certified : FactorDemand{}.accuracy;
  const std::optional<double> accuracy = parse_double(text);
  constexpr double least = 1e-12;
  constexpr double most = 0.1;
  if (!accuracy || *accuracy < least || *accuracy > most)
    throw InputError({.source = "--accuracy", .value = text, .allowed = "a number from 1e-12 to 0.1"});
  return *accuracy;
}

/// A mesh, a text that says which, and what was mended in it.
struct NamedMesh {
  FactorMesh mesh;
  std::string identity;
  std::vector<std::string> mended;
};

NamedMesh mesh_of_file(const FactorsOptions& options) {
  if (!options.level.empty())
    throw InputError(
        {.source = "--level", .problem = "is for surfaces of the catalogue", .allowed = "no mesh file"});
  const MeshSurvey survey = survey_mesh(options.name, default_sharp_degrees, repair_of(options.repair));
  if (!survey.defects.degenerate_triangles.empty()) {
    const auto corners = survey.mesh.corners(survey.defects.degenerate_triangles.front());
    throw InputError({.source = options.name,
                      .problem = "has a triangle with its corners on one line: " + point_text(corners[0]) +
                                 ", " + point_text(corners[1]) + ", " + point_text(corners[2]),
                      .allowed = "triangles with an area"});
  }
  if (!survey.misoriented.empty())
    throw InputError({.source = options.name,
                      .problem = "has reversed normals: the triangles connected with the one at " +
                                 point_text(survey.mesh.corners(survey.misoriented.front())[0]) +
                                 " look away from where the light of the others is",
                      .allowed = "bodies within a room run the other way round than the room"});
  return {factor_mesh(survey), survey.digest + " repair " + listed(options.repair), survey.mended};
}

NamedMesh mesh_of_catalogue(const FactorsOptions& options) {
  if (!options.repair.empty())
    throw InputError(
        {.source = "--repair", .problem = "is for meshes", .allowed = "a file in .off, .obj, .ply, .stl"});
  const Surface surface = default_surface(surface_named(options.name));
  for (const Chart& chart : surface.charts)
    if (!chart.facts().plane)
      throw InputError(
          {.source = "surface",
           .value = options.name,
           .problem = "is curved",
           .allowed = "surfaces of plane pieces, or a mesh file: then the factors are those of its facets"});
  return {factor_mesh(surface, level_of(options.level)),
          options.name + " " + std::to_string(level_of(options.level)),
          {}};
}

/// What makes the numbers meaningless is the input's fault, with coordinates.
void require_scene(const std::string& name, const TriangleMesh& mesh) {
  const std::vector<SceneFault> faults = scene_faults(mesh);
  if (faults.empty()) {
    if (const auto words = beyond_doubles(mesh))
      throw InputError({.source = name, .problem = *words, .allowed = "a scene that doubles carry"});
    return;
  }
  const std::string more = faults.size() == 1 ? "" : fmt::format("; and {} more faults", faults.size() - 1);
  throw InputError({.source = name,
                    .problem = faults.front().words + more,
                    .allowed = "triangles that have a vertex or a side in common, or nothing"});
}

std::string edge_text(const FacetScene& scene, std::size_t edge) {
  const MeshEdge& e = scene.topology().edges[edge];
  return point_text(scene.scene().vertex(e.from)) + " to " + point_text(scene.scene().vertex(e.to));
}

void require_orientation(const std::string& name, const FacetScene& scene) {
  const MeshTopology& topology = scene.topology();
  if (topology.disagreeing_edges.empty()) return;
  throw InputError(
      {.source = name,
       .problem = fmt::format(
           "has reversed normals: triangles run against each other along {} edges, the first {}",
           topology.disagreeing_edges.size(), edge_text(scene, topology.disagreeing_edges.front())),
       .allowed = "neighbours that look to the same side"});
}

/// Whether light can leave; then --space must have been given.
bool is_open(const FactorsOptions& options, const FacetScene& scene) {
  const std::vector<std::size_t>& open = scene.topology().open_edges;
  if (open.empty()) {
    if (options.space)
      throw InputError(
          {.source = "--space", .problem = "is for open scenes: " + options.name + " is closed"});
    return false;
  }
  if (options.space) return true;
  constexpr std::size_t most_edges = 3;
  std::string edges;
  for (std::size_t k = 0; k < std::min(open.size(), most_edges); ++k)
    edges += (k == 0 ? "" : ", ") + edge_text(scene, open[k]);
  throw InputError({.source = options.name,
                    .problem = fmt::format("is open: {} edges with one triangle: {}{}", open.size(), edges,
                                           open.size() > most_edges ? ", ..." : ""),
                    .allowed = "a closed scene, or --space for what leaves it"});
}

std::vector<std::string> warnings(const FactorReport& report) {
  std::vector<std::string> out;
  const FactorMatrix& matrix = report.matrix;
  for (std::size_t i = 0; i < matrix.rows.size(); ++i)
    if (matrix.rows[i].sum.value == 0 && matrix.rows[i].sum.radius == 0)
      out.push_back(report.names[i] + " sees nothing: its normals are probably reversed");
  return out;
}

/// The rows, worst first, of which something is to be said: their number, and the names of the first.
std::string worst_rows(const FactorReport& report, std::vector<std::pair<double, std::size_t>> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  constexpr std::size_t most_names = 3;
  std::string out = fmt::format("{} of {} rows", rows.size(), report.names.size());
  for (std::size_t k = 0; k < std::min(rows.size(), most_names); ++k)
    out += (k == 0 ? ": " : ", ") + report.names[rows[k].second];
  return out + (rows.size() > most_names ? ", ..." : "");
}

/// Why the numbers must not be relied on: rows of a closed scene that do not sum to 1 within their radius, or
/// an accuracy that was demanded and not reached.
std::vector<std::string> failures(const FactorReport& report, const std::optional<double>& demanded) {
  std::vector<std::string> out;
  const FactorMatrix& matrix = report.matrix;
  std::vector<std::pair<double, std::size_t>> unclosed;
  std::vector<std::pair<double, std::size_t>> wide;
  for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
    const double off = matrix.closure_defect(i) - matrix.rows[i].sum.radius;
    if (!report.open && off > 0) unclosed.emplace_back(off, i);
    if (demanded && matrix.rows[i].sum.radius > *demanded) wide.emplace_back(matrix.rows[i].sum.radius, i);
  }
  if (!unclosed.empty())
    out.push_back("rows of a closed scene that do not sum to 1 within their radius: " +
                  worst_rows(report, std::move(unclosed)));
  if (!wide.empty())
    out.push_back("incomplete: the row sums' radius is above the accuracy asked for, " + shortest(*demanded) +
                  ", in " + worst_rows(report, std::move(wide)));
  return out;
}

/// The name of FILE.surfaces.csv beside FILE.csv.
std::string surfaces_file(const std::string& out) {
  const std::string ending = ".csv";
  const std::string stem = out.ends_with(ending) ? out.substr(0, out.size() - ending.size()) : out;
  return stem + ".surfaces.csv";
}

void say_plan(const Common& common, const FactorPlan& plan) {
  if (!common.quiet)
    say(fmt::format("{} pairs of triangles: about {} and {} seconds\n", plan.pairs,
                    byte_text(plan.memory.total()), nearest_text(plan.seconds, DecimalForm::general(2))));
}

FactorMatrix computed(const Common& common, const FacetScene& scene, const FactorUnits& units,
                      const FactorDemand& demand, const std::string& identity, ResultStore& store) {
  const FactorPlan plan = factor_plan(scene, units, demand);
  say_plan(common, plan);
  plan.memory.require(common.memory_limit());
  ProgressDisplay progress(common.quiet);
  progress.at(0, "factors", plan.seconds);
  return factor_matrix(scene, units, demand,
                       {.at = [&](double fraction) { progress.at(fraction, "factors"); },
                        .key = "factors\n" + std::string(source_digest()) + "\n" + identity,
                        .store = &store});
}

ExitCode factors(const Common& common, const FactorsOptions& options) {
  const auto limit = common.limit_threads();
  Outputs outputs(common);
  outputs.file("--out", options.out);
  const FactorUnit unit = unit_of(options.by);
  FactorDemand demand{.certified = options.certified,
                      .accuracy = accuracy_of(options.accuracy, options.certified)};

  const NamedMesh named =
      is_mesh_file_name(options.name) ? mesh_of_file(options) : mesh_of_catalogue(options);
  require_scene(options.name, named.mesh.mesh);
  const FacetScene scene(named.mesh.mesh);
  require_orientation(options.name, scene);
  demand.open_to_space = is_open(options, scene);
  const FactorUnits units = factor_units(named.mesh, unit);
  std::optional<ClaimedFactors> claimed;
  if (!options.compare.empty()) claimed = read_factors(options.compare, units.names);

  FactorReport report{.command = common.command,
                      .name = options.name,
                      .by = options.by,
                      .triangles = scene.facet_count(),
                      .open = demand.open_to_space,
                      .facets_only = named.mesh.pieces_bend,
                      .names = units.names,
                      .matrix = {},
                      .warnings = {},
                      .comparison = std::nullopt};
  ResultStore store = common.store();
  try {
    report.matrix = computed(common, scene, units, demand, named.identity, store);
  } catch (const Interrupted&) {
    const auto status = store.status();
    say("radcert: interrupted; finished rows are " +
        (status ? "kept in " + store.folder().string() + ": the same command goes on from there\n"
                : "not kept: " + status.reason() + "\n"));
    return ExitCode::interrupted;
  }
  report.warnings = warnings(report);
  for (const std::string& done : named.mended) report.warnings.push_back("mended: " + done);
  for (const std::string& warning : report.warnings) say("radcert: warning: " + warning + "\n");
  if (claimed)
    report.comparison =
        with_source(options.compare, [&] { return compared(report.matrix, report.names, *claimed); });
  if (!options.out.empty())
    outputs.write({{options.out, factors_csv(report.matrix, report.names)},
                   {surfaces_file(options.out), factor_surfaces_csv(report.matrix, report.names)}});
  print_result(common,
               factors_table(report) + (report.comparison ? comparison_table(*report.comparison) : ""),
               factors_report(report).pretty() + "\n");
  const bool differs = report.comparison && std::any_of(report.comparison->begin(), report.comparison->end(),
                                                        [](const FactorComparison& pair) {
                                                          return pair.agreement == Agreement::differs;
                                                        });
  const std::vector<std::string> failed =
      failures(report, options.accuracy.empty() ? std::nullopt : std::optional(demand.accuracy));
  for (const std::string& failure : failed) say("radcert: " + failure + "\n");
  return differs || !failed.empty() ? ExitCode::differs : ExitCode::done;
}

}  // namespace

void add_factors(Program& program) {
  Subcommand command = program.add("factors", "Area-to-area configuration factors, closure, reciprocity");
  auto options = std::make_shared<FactorsOptions>();
  command.word("SURFACE", options->name,
               "A surface of plane pieces (cube, box, tetrahedron, octahedron, ...), or a mesh in .off, "
               ".obj, .ply, .stl",
               "NAME or FILE");
  command.option("--by", options->by, "What a row stands for: triangle, piece or group; default triangle",
                 "WHAT");
  command.flag("--certified", options->certified, "Prove each radius");
  command.option("--out", options->out,
                 "Write from,to,factor,radius,guaranteed, and FILE.surfaces.csv beside it", "FILE.csv");
  command.flag("--space", options->space,
               "The scene is open: give what reaches no front of a surface as to_space");
  command.option("--accuracy", options->accuracy,
                 "Wanted of each row's sum, where occlusion makes integration adaptive; default 1e-5, with "
                 "--certified 1e-9",
                 "X");
  command.option("--level", options->level,
                 "Cut each triangle of a surface of the catalogue into 4^N; default 0", "N");
  command.list("--repair", options->repair,
               "Mend the mesh in memory: triangulate, vertices, faces, orientation, manifold, crossings, "
               "holes; without it nothing is mended",
               "WHAT,...");
  command.option("--compare", options->compare,
                 "Hold the factors against those of a file: columns from,to,factor, or View3D's output",
                 "OTHER.csv");
  command.fresh_flag(program.common());
  command.footer(
      "A factor is what part of the light that leaves `from`, everywhere alike, arrives at `to`. Exact zeros "
      "are left out.\n"
      "--certified holds whatever stands between. A shadow that its limit of work does not settle, and "
      "shadows of "
      "several bodies that fall on one another, widen the radius: look at it.\n"
      "Rows that are finished are kept in $RADCERT_STORE, else ~/.cache/radcert: an interrupted run goes on "
      "there.\n"
      "The exit code is 1 where rows of a closed scene do not sum to 1 within their radius, where a row's "
      "radius is above "
      "an --accuracy that was given, and with --compare where a pair differs.");
  command.runs([&common = program.common(), options] { return factors(common, *options); });
}

}  // namespace radcert::app
