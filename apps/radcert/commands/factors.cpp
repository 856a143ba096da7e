// SPDX-License-Identifier: GPL-3.0-or-later

// radcert factors NAME or FILE: configuration factors between the surfaces of a scene.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "named_surface.h"
#include "origin.h"
#include "output.h"
#include "progress.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/text.h"
#include "radcert/core/version.h"
#include "radcert/factors/factor_mesh.h"
#include "radcert/factors/input/factor_scene.h"
#include "radcert/factors/ray_factors.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/result/factor_remarks.h"
#include "radcert/formats/result/factors_json.h"
#include "radcert/formats/table/factor_comparison.h"
#include "radcert/formats/table/factors_csv.h"
#include "radcert/formats/table/unoccluded_factor.h"
#include "radcert/geometry/mesh_file/mesh_file.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/surface/catalogue.h"
#include "requests/factor_request.h"
#include "run_ranks.h"
#include "tables/factors_table.h"

namespace radcert::app {

namespace {

struct FactorsOptions {
  std::string name;
  std::string by = "triangle";
  std::string level;
  std::string accuracy;
  std::string out;
  std::string compare;
  std::string tolerance;
  std::string differences;
  std::vector<std::string> repair;
  std::string front = "auto";
  std::vector<std::string> two_sided;
  std::string unit;
  bool certified = false;
  bool rays = false;
  bool space = false;
};

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

double accuracy_of(const FactorsOptions& options) {
  constexpr double usual_of_certified = 1e-9;
  const std::string& text = options.accuracy;
  if (text.empty())
    return options.rays ? RayDemand{}.accuracy
                        : (options.certified ? usual_of_certified : FactorDemand{}.accuracy);
  const std::optional<double> accuracy = parse_double(text);
  const double least = options.rays ? 1e-6 : 1e-12;
  constexpr double most = 0.1;
  if (!accuracy || *accuracy < least || *accuracy > most)
    throw InputError(
        {.source = "--accuracy",
         .value = text,
         .allowed = options.rays ? "with --rays a number from 1e-6 to 0.1" : "a number from 1e-12 to 0.1"});
  return *accuracy;
}

/// The scene of a mesh file or of a surface of the catalogue, with the options that belong to it.
FactorScene scene_of(const FactorsOptions& options) {
  if (is_mesh_file_name(options.name)) {
    if (!options.level.empty())
      throw InputError(
          {.source = "--level", .problem = "is for surfaces of the catalogue", .allowed = "no mesh file"});
    static_cast<void>(repair_of(options.repair));
    return factor_scene(options.name, read_mesh_file(options.name),
                        {.repair = options.repair,
                         .front = front_of(options.front),
                         .two_sided = options.two_sided,
                         .space = options.space},
                        OptionStyle::command_line);
  }
  const std::string files = "a file in " + mesh_file_endings();
  if (!options.repair.empty())
    throw InputError({.source = "--repair", .problem = "is for meshes", .allowed = files});
  if (!options.two_sided.empty())
    throw InputError({.source = "--two-sided", .problem = "is for groups of a mesh", .allowed = files});
  if (options.front != "auto")
    throw InputError({.source = "--front", .problem = "is for meshes", .allowed = files});
  return factor_scene(options.name, default_surface(surface_named(options.name)), level_of(options.level),
                      options.space, OptionStyle::command_line);
}

/// FILE of FILE.csv.
std::string stem_of(const std::string& out) {
  const std::string ending = ".csv";
  return out.ends_with(ending) ? out.substr(0, out.size() - ending.size()) : out;
}

/// "1e-4", "1%", or both, parted by a comma.
FactorTolerance tolerance_of(const std::string& text) {
  FactorTolerance out;
  if (text.empty()) return out;
  std::string_view rest = text;
  while (!rest.empty()) {
    std::string_view part = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    const bool relative = part.ends_with('%');
    if (relative) part.remove_suffix(1);
    const std::optional<double> number = parse_double(part);
    double& place = relative ? out.relative : out.absolute;
    constexpr double percent = 0.01;
    if (!number || *number <= 0 || *number > (relative ? 100 : 1) || place != 0)
      throw InputError({.source = "--tolerance",
                        .value = text,
                        .allowed = "a positive number, a percentage such as 1%, or both, parted by a comma"});
    place = relative ? percent * *number : *number;
  }
  return out;
}

void say_plan(const Common& common, const FactorPlan& plan, const std::string& what) {
  if (!common.quiet)
    say(fmt::format("{} {}: about {} and {} seconds, row sums to about {}\n", plan.pairs, what,
                    byte_text(plan.memory.total()), nearest_text(plan.seconds, DecimalForm::general(2)),
                    upper_text(plan.radius, DecimalForm::general(2))));
}

/// What the factors are written to.
struct FactorSinks {
  FactorsKept kept = FactorsKept::all;
  /// Takes rows where they are not kept.
  std::function<void(std::span<const ConfigurationFactor>)> row{};
  MemoryPlan memory{};  ///< what is made of kept factors
};

FactorMatrix computed(const Common& common, const FacetScene& scene, const FactorUnits& units,
                      const FactorDemand& demand, bool by_rays, const std::string& identity,
                      const FactorSinks& sinks, ResultStore& store) {
  const RayDemand rays{.accuracy = demand.accuracy, .open_to_space = demand.open_to_space};
  FactorPlan plan = by_rays ? ray_plan(scene, units, rays) : factor_plan(scene, units, demand, sinks.kept);
  for (const MemoryPlan::Item& item : sinks.memory.items()) plan.memory.add(item.name, 1, item.bytes);
  say_plan(common, plan, by_rays ? "rays" : "pairs of triangles");
  plan.memory.require(common.memory_limit());
  ProgressDisplay progress(common.quiet);
  progress.at(0, "factors", plan.seconds);
  const FactorProgress report{.at = [&](double fraction) { progress.at(fraction, "factors"); },
                              .key = "factors\n" + std::string(source_digest()) + "\n" + identity,
                              .store = &store,
                              .row = sinks.row,
                              .ranks = &ranks()};
  return by_rays ? ray_factors(scene, units, rays, report) : factor_matrix(scene, units, demand, report);
}

ExitCode factors(const Common& common, const FactorsOptions& options) {
  const auto limit = common.limit_threads();
  Outputs outputs(common);
  outputs.file("--out", options.out);
  outputs.file("--differences", options.differences);
  if (!options.out.empty()) outputs.file("--out", stem_of(options.out) + ".surfaces.csv");
  if (!options.differences.empty()) outputs.file("--differences", stem_of(options.differences) + ".svg");
  outputs.input(options.name);
  outputs.input(options.compare);
  for (const auto& [option, given] : {std::pair("--tolerance", !options.tolerance.empty()),
                                      std::pair("--differences", !options.differences.empty())})
    if (given && options.compare.empty())
      throw InputError({.source = option, .problem = "is for a comparison", .allowed = "with --compare"});
  const FactorTolerance tolerance = tolerance_of(options.tolerance);
  const FactorUnit by = unit_of(options.by);
  const std::optional<std::string> unit = unit_of_lengths(options.unit, "--unit");
  FactorDemand demand{.certified = options.certified, .accuracy = accuracy_of(options)};
  if (!options.two_sided.empty() && options.certified)
    throw InputError(
        {.source = "--two-sided", .problem = "is not served with --certified", .allowed = "estimated radii"});
  if (options.rays && options.certified)
    throw InputError({.source = "--rays", .problem = "proves nothing", .allowed = "without --certified"});

  const FactorScene named = scene_of(options);
  if (options.certified) require_exact_corners(options.name, named, OptionStyle::command_line);
  require_same_on_all_ranks(options.name, named.identity);
  // Rays go by whole rows of units, and the first rank sends them.
  if (options.rays && !ranks().is_first()) return ExitCode::done;
  const FacetScene& scene = named.scene;
  demand.open_to_space = named.open;
  const FactorUnits units = factor_units(named.mesh, by);
  std::optional<ClaimedFactors> claimed;
  if (!options.compare.empty()) claimed = read_factors(options.compare, units.names);

  FactorReport report{.command = common.command,
                      .name = options.name,
                      .by = options.by,
                      .triangles = scene.facet_count(),
                      .open = demand.open_to_space,
                      .unit = unit,
                      .front = named.front.empty() ? std::nullopt : std::optional(named.front),
                      .facets_only = named.mesh.pieces_bend,
                      .names = units.names,
                      .matrix = {},
                      .warnings = {},
                      .comparison = std::nullopt};
  ResultStore store = common.store();
  AtomicFile out(options.out);
  FactorsCsv csv(units.names);
  FactorSinks sinks;
  const bool asked_for_json = common.json_to_stdout() || common.json_to_file();
  if (asked_for_json || claimed) {
    const std::uint64_t entries = std::uint64_t{units.names.size()} * units.names.size();
    constexpr std::uint64_t bytes_of_json = 1024;
    constexpr std::uint64_t bytes_of_comparison = 512;
    if (asked_for_json) sinks.memory.add("JSON", entries, bytes_of_json);
    if (claimed) sinks.memory.add("comparison", entries, bytes_of_comparison);
  } else {
    sinks.kept = FactorsKept::none;
    sinks.row = [&](std::span<const ConfigurationFactor> row) {
      if (!options.out.empty()) out.put(csv.rows(row));
    };
  }
  try {
    report.matrix = computed(common, scene, units, demand, options.rays, named.identity, sinks, store);
  } catch (const Interrupted&) {
    return interrupted("finished rows", store);
  }
  if (!ranks().is_first()) return ExitCode::done;
  say_where_nothing_is_kept(store);
  Files files;
  report.warnings = factor_warnings(report, OptionStyle::command_line);
  for (const std::string& done : named.mended) report.warnings.push_back("mended: " + done);
  report.warnings.insert(report.warnings.end(), named.remarks.begin(), named.remarks.end());
  // The table ends with them: on a terminal they are not said twice.
  if (common.json_to_stdout() || !terminal_width())
    for (const std::string& warning : report.warnings) say("radcert: warning: " + warning + "\n");
  if (claimed) {
    report.comparison = with_source(
        options.compare, [&] { return compared(report.matrix, report.names, *claimed, tolerance); });
    explain(*report.comparison, report.matrix, report.names, *claimed, unoccluded_factor(scene, units));
    if (!options.differences.empty()) {
      files.emplace_back(options.differences, comparison_csv(*report.comparison));
      if (report.names.size() <= comparison_picture_rows)
        files.emplace_back(stem_of(options.differences) + ".svg",
                           comparison_svg(*report.comparison, report.names));
    }
  }
  if (!options.out.empty()) {
    // Where rows were kept, all of them; else the header line of a matrix without any.
    out.put(csv.rows(report.matrix.entries));
    files.emplace_back(stem_of(options.out) + ".surfaces.csv",
                       factor_surfaces_csv(report.matrix, report.names, report.unit));
  }
  print_result(common, outputs,
               factors_table(report) + (report.comparison ? comparison_table(*report.comparison) : ""),
               asked_for_json ? factors_report(report).pretty() + "\n" : "", std::move(files),
               options.out.empty() ? nullptr : &out);
  const bool differs = report.comparison && std::any_of(report.comparison->begin(), report.comparison->end(),
                                                        [](const FactorComparison& pair) {
                                                          return pair.agreement == Agreement::differs;
                                                        });
  const std::vector<std::string> failed =
      factor_failures(report, options.accuracy.empty() ? std::nullopt : std::optional(demand.accuracy),
                      OptionStyle::command_line);
  for (const std::string& failure : failed) say("radcert: " + failure + "\n");
  return differs || !failed.empty() ? ExitCode::differs : ExitCode::done;
}

}  // namespace

void add_factors(Program& program) {
  Subcommand command = program.add(
      "factors", "Area-to-area configuration factors (view factors, form factors), closure, reciprocity");
  auto options = std::make_shared<FactorsOptions>();
  command.word("SURFACE", options->name,
               "A surface of plane pieces (cube, box, tetrahedron, octahedron, ...), or a mesh in " +
                   mesh_file_endings(),
               "NAME or FILE");
  command.option("--by", options->by, "What a row stands for: triangle, piece or group; default triangle",
                 "WHAT");
  command.flag("--certified", options->certified, "Prove each radius");
  command.flag(
      "--rays", options->rays,
      "Integrate whole rows by rays, for scenes of thousands of triangles by group or piece: radii are "
      "estimates, default accuracy 1e-4");
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
  command.list(
      "--repair", options->repair,
      "Mend the mesh in memory: align, triangulate, vertices, faces, orientation, manifold, crossings, "
      "holes; without it nothing is mended",
      "WHAT,...");
  command.list(
      "--two-sided", options->two_sided,
      "Groups of a mesh that are plates without thickness: light leaves their backs too, as rows of \"NAME "
      "back\"",
      "GROUP,...");
  command.option("--unit", options->unit, unit_help, "UNIT");
  command.option("--front", options->front, front_help, "WHICH");
  command.option(
      "--compare", options->compare,
      "Hold the factors against those of a file: columns from,to,factor, a matrix with names about "
      "it, or View3D's output",
      "OTHER.csv");
  command.option(
      "--tolerance", options->tolerance,
      "How far these may be off beside their last digit: 1e-4, 1%, or both, parted by a comma; the "
      "larger counts",
      "X,Y%");
  command.option("--differences", options->differences,
                 "Write all pairs, the largest difference first, with verdict and a guess at the cause, and "
                 "FILE.svg, the matrix with what differs marked",
                 "FILE.csv");
  command.fresh_flag(program.common());
  command.footer(
      "A factor is what part of the light that leaves `from`, everywhere alike, arrives at `to`. Exact zeros "
      "are left out.\n"
      "--certified holds whatever stands between, shadows that fall on one another too. A pair that its "
      "limit "
      "of work does not settle widens the radius: look at it.\n"
      "Rows that are finished are kept in $RADCERT_STORE, else ~/.cache/radcert: an interrupted run goes on "
      "there.\nUnder mpirun ranks share them.\n"
      "The exit code is 1 where rows of a closed scene do not sum to 1 within their radius, where a row's "
      "radius is above "
      "an --accuracy that was given, and with --compare where a pair differs.");
  command.runs([&common = program.common(), options] { return factors(common, *options); });
}

}  // namespace radcert::app
