// SPDX-License-Identifier: GPL-3.0-or-later

// radcert solve PROBLEM.json: one problem over its levels.
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "command.h"
#include "enclosure_display.h"
#include "origin.h"
#include "output.h"
#include "plot_files.h"
#include "progress.h"
#include "radcert/core/digest.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/memory_plan.h"
#include "radcert/formats/field/element_errors.h"
#include "radcert/formats/field/ply.h"
#include "radcert/formats/field/vtu.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/plot/convergence_plot.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/formats/result/certificate_json.h"
#include "radcert/formats/result/result_json.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/formats/result/stored_numbers.h"
#include "radcert/formats/table/csv.h"
#include "radcert/formats/table/latex_table.h"
#include "radcert/formats/table/points_csv.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/certified_solution.h"
#include "radcert/study/expected_seconds.h"
#include "requests/solution_at.h"
#include "run_ranks.h"
#include "tables/enclosure_table.h"
#include "tables/points_table.h"
#include "tables/solve_table.h"

namespace radcert::app {

namespace {

struct SolveOptions {
  std::string problem;
  std::string nodes;
  std::string vtu;
  std::string ply;
  std::string out;
  std::string guarantee;
  std::vector<std::string> at;
  std::string sample;
  std::string within;
  std::string points;
  std::string of;
  std::string outside;
  std::string emission_by;
  std::string certificate;
};

/// What --out may write beside plots and tables, which are no input's.
const std::vector<std::string> names_of_out = {"solution.json", "provenance.json", "points.csv"};
constexpr std::size_t points_size_limit = std::size_t{256} << 20U;

Outputs checked_outputs(const Common& common, const SolveOptions& options) {
  Outputs outputs(common);
  outputs.input(options.problem);
  outputs.file("--nodes", options.nodes);
  outputs.file("--vtu", options.vtu);
  outputs.file("--ply", options.ply);
  outputs.file("--certificate", options.certificate);
  outputs.file("--points", options.points);
  outputs.folder("--out", options.out, names_of_out);
  return outputs;
}

/// Whether something is written that has the values at nodes or elements.
bool takes_fields(const SolveOptions& options) {
  return !options.nodes.empty() || !options.vtu.empty() || !options.ply.empty() || !options.out.empty();
}

/// The entries of the matrix at a level, in units of those at level 0: four times the unknowns from level to
/// level.
double work(int level) { return std::pow(16.0, level); }

/// ", on 4 ranks, ..." of a level that ranks have shared.
std::string shared_text(const std::optional<SharedWork>& shared) {
  if (!shared) return {};
  return ", on " + std::to_string(shared->ranks) + " ranks: at most " + byte_text(shared->operator_bytes) +
         " of the operator on one, and " + byte_text(shared->bytes_sent) + " sent for a product";
}

/// The levels of a problem, each from the store or computed; fewer than asked for where the user asked to
/// stop.
std::vector<LevelOutcome> solve_levels(const Problem& problem, StoredLevels& levels, bool quiet) {
  ProgressDisplay progress(quiet);
  double all = 0;
  for (const int level : problem.triangulation.levels) all += work(level);
  double done = 0;
  std::vector<LevelOutcome> finished;
  ExpectedSeconds expected;
  try {
    for (const int level : problem.triangulation.levels) {
      std::vector<double> rest;
      for (const int other : problem.triangulation.levels)
        if (other >= level) rest.push_back(work(other));
      progress.at(done / all, "level " + std::to_string(level), expected.of(rest));
      const std::size_t computed = levels.computed();
      finished.push_back(levels.level(problem, level));
      done += work(level);
      const LevelTiming& timing = finished.back().timing;
      expected.finished(work(level), timing.assembly_seconds + timing.operator_seconds +
                                         timing.solve_seconds + timing.iterated_seconds);
      const LevelResult& result = finished.back().result;
      progress.note("level " + std::to_string(level) + ": " + std::to_string(result.elements) +
                    " elements, " + std::to_string(result.unknowns) + " unknowns" +
                    (levels.computed() == computed ? ", found in the store" : "") +
                    shared_text(finished.back().shared));
    }
  } catch (const Interrupted&) {
    // What is finished is in the store already.
  }
  return finished;
}

/// What is asked for of u_n at points, before any level is solved.
struct PointsWish {
  std::vector<AskedPoint> at;
  std::optional<std::size_t> sample = std::nullopt;
  double tolerance = 0;
  std::vector<InputDigest> inputs = {};  ///< the files of points
  [[nodiscard]] bool is_empty() const { return at.empty() && !sample; }
};

/// What --out writes.
Files files_of(const Common& common, const SolveOptions& options, const Result& result,
               std::span<const LevelOutcome> levels, const std::string& json, const InputDigest& problem,
               const std::optional<std::vector<ValueAt>>& points, const PointsWish& wish) {
  const std::filesystem::path folder = options.out;
  const auto& elements = levels.back().elements;
  const auto errors = corner_errors(result.problem, elements);
  const auto iterated_errors = iterated_corner_errors(result.problem, elements);
  Files files = {{folder / "solution.json", json},
                 {folder / "errors.csv", errors_csv(result)},
                 {folder / "nodes.csv", nodes_csv(levels)},
                 {folder / "solution.vtu", vtu_text(elements, errors, iterated_errors)},
                 {folder / "solution.ply", ply_text(elements, errors, iterated_errors)},
                 {folder / "table.tex", levels_latex(result)}};
  if (points) files.emplace_back(folder / "points.csv", points_csv(*points));
  const std::string name =
      result.problem.label.empty()
          ? (options.problem == "-" ? std::string("the problem")
                                    : std::filesystem::path(options.problem).filename().string())
          : result.problem.label;
  const NamedPlot plot{
      "errors_against_h",
      convergence_plot("Errors of " + name, {.name = {}, .levels = result.levels, .orders = result.orders})};
  if (!plot.plot.curves.empty())
    for (auto& file : plot_files(folder, {&plot, 1})) files.push_back(std::move(file));
  std::vector<InputDigest> inputs = {problem};
  for (InputDigest& named : inputs_named_in({&result.problem, 1})) inputs.push_back(std::move(named));
  inputs.insert(inputs.end(), wish.inputs.begin(), wish.inputs.end());
  for (auto& file : origin_files(folder, common, references_of(result.problem), std::move(inputs),
                                 seed_of({&result.problem, 1})))
    files.push_back(std::move(file));
  return files;
}

/// "1/2,1/2,0" as JSON.
JsonValue coordinates_json(const std::string& text) {
  JsonValue out = JsonValue::array();
  std::istringstream words(text);
  for (std::string coordinate; std::getline(words, coordinate, ',');) out.push(coordinate);
  return out;
}

/// Whether the problem's own words or options ask for an enclosure of u itself; --at is of that then, and
/// else of u_n.
bool asks_for_guarantee(const SolveOptions& options, const Problem& problem) {
  return problem.guarantee || !options.guarantee.empty() || !options.of.empty() || !options.outside.empty() ||
         !options.emission_by.empty();
}

/// Whether a word of --at names a file, and not a point.
bool is_file_of_points(const std::string& word) { return word.find(',') == std::string::npos; }

/// The points of --at without a guarantee: "1/2,1/2,0", or those of a file.
std::vector<AskedPoint> asked_points(const SolveOptions& options, Outputs& outputs,
                                     std::vector<InputDigest>& inputs) {
  std::vector<AskedPoint> out;
  for (const std::string& word : options.at) {
    if (is_file_of_points(word)) {
      const InputFile file = read_input(word, points_size_limit);
      outputs.input(word);
      inputs.push_back(file.digest);
      const std::vector<AskedPoint> of_file =
          with_source(file.source, [&] { return read_points(file.text); });
      for (AskedPoint asked : of_file) {
        asked.where = file.source + ", " + asked.where;
        out.push_back(std::move(asked));
      }
      continue;
    }
    std::vector<double> coordinates;
    std::istringstream words(word);
    for (std::string coordinate; std::getline(words, coordinate, ',');) {
      const Outcome<Rational> number = Rational::parse(coordinate);
      if (!number) break;
      coordinates.push_back(number->to_double());
    }
    if (coordinates.size() != 3)
      throw InputError({.source = "--at",
                        .value = word,
                        .problem = "is no point",
                        .allowed = "X,Y,Z, numbers or fractions; or a CSV file"});
    out.push_back({.where = "--at " + word, .point = {coordinates[0], coordinates[1], coordinates[2]}});
  }
  return out;
}

/// A number of points of --sample.
std::size_t sample_size(const std::string& text) {
  constexpr std::uint64_t most = 1'000'000;
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc{} || end != text.data() + text.size() || count < 1 || count > most)
    throw InputError(
        {.source = "--sample", .value = text, .allowed = "a whole number from 1 to " + std::to_string(most)});
  return count;
}

double tolerance_of(const SolveOptions& options) {
  constexpr double near = 1e-9;
  if (options.within.empty()) return near;
  const std::optional<double> number = parse_double(options.within);
  if (!number || !(*number >= 0 && *number <= 1))
    throw InputError({.source = "--within", .value = options.within, .allowed = "a number from 0 to 1"});
  return *number;
}

PointsWish points_wish(const SolveOptions& options, Outputs& outputs, const Problem& problem) {
  PointsWish wish;
  wish.at = asked_points(options, outputs, wish.inputs);
  if (!options.sample.empty()) wish.sample = sample_size(options.sample);
  wish.tolerance = tolerance_of(options);
  const auto refuse = [](const std::string& option, const std::string& value, const std::string& why,
                         const std::string& allowed) {
    throw InputError({.source = option, .value = value, .problem = why, .allowed = allowed});
  };
  const std::string option = wish.sample ? "--sample" : "--at";
  const std::string value = wish.sample ? options.sample : options.at.empty() ? "" : options.at.front();
  if (!wish.at.empty() && wish.sample)
    refuse("--sample", options.sample, "stands beside --at", "one of them");
  if (wish.at.empty() && !options.within.empty())
    refuse("--within", options.within, "says how far points of --at may be from the surface",
           "--at beside it");
  if (wish.is_empty() && !options.points.empty())
    refuse("--points", options.points, "is of values at points, and none are asked for", "--at or --sample");
  if (wish.is_empty()) return wish;
  if (!std::holds_alternative<Collocation>(problem.method))
    refuse(option, value, "is not for a basis without functions on triangles", "a basis on triangles");
  if (problem.geometry)
    refuse(option, value, "is not for an interpolated geometry", "a problem whose geometry is exact");
  return wish;
}

/// u_n and E + K u_n where it is asked for, at the last level.
std::optional<std::vector<ValueAt>> values_at(const PointsWish& wish, const Problem& problem,
                                              const LevelOutcome& last, bool quiet) {
  if (wish.is_empty()) return std::nullopt;
  const ProgressDisplay display(quiet, "values at points");
  const SolutionLevel level(problem, last);
  if (wish.sample) return level.values_at(level.spread(*wish.sample), true, reference::applied_operator);
  Progress told;
  const AskedPlaces found = places_of(level, wish.at, wish.tolerance, told);
  std::vector<ValueAt> out = level.values_at(found.places, true, reference::applied_operator);
  for (std::size_t i = 0; i < out.size(); ++i) out[i].distance = found.distances[i];
  return out;
}

/// The points of --at for a guarantee, as a problem has them.
JsonValue guaranteed_points(const SolveOptions& options, Outputs& outputs) {
  JsonValue points = JsonValue::array();
  for (const std::string& word : options.at) {
    if (!is_file_of_points(word)) {
      points.push(coordinates_json(word));
      continue;
    }
    const InputFile file = read_input(word, points_size_limit);
    outputs.input(word);
    const std::vector<Vector<Rational>> of_file =
        with_source(file.source, [&] { return read_exact_points(file.text); });
    for (const Vector<Rational>& point : of_file) points.push(point_json(point));
  }
  return points;
}

/// The problem with what --guarantee, --of, --at, --outside and --emission-by say in place of its own words.
Problem problem_of(const SolveOptions& options, Outputs& outputs, const InputFile& input) {
  Problem problem = parse_problem(input.text, input.source);
  if (!asks_for_guarantee(options, problem)) return problem;
  JsonValue guarantee = JsonValue::object();
  if (!options.guarantee.empty())
    guarantee.set("width", options.guarantee);
  else if (problem.guarantee)
    guarantee.set("width", exact_json(problem.guarantee->width));
  if (!options.of.empty())
    guarantee.set("of", options.of);
  else if (!options.at.empty())
    guarantee.set("of", name_of(EnclosedQuantity::values));
  else if (problem.guarantee)
    guarantee.set("of", name_of(problem.guarantee->of));
  if (!options.outside.empty())
    guarantee.set("outside", options.outside);
  else if (problem.guarantee && problem.guarantee->outside)
    guarantee.set("outside", exact_json(*problem.guarantee->outside));
  JsonValue points = guaranteed_points(options, outputs);
  if (options.at.empty() && problem.guarantee)
    for (const Vector<Rational>& point : problem.guarantee->points) points.push(point_json(point));
  if (!points.elements()->empty()) guarantee.set("points", std::move(points));
  if (!options.emission_by.empty()) {
    guarantee.set("emissions", "by " + options.emission_by);
    if (problem.guarantee && !problem.guarantee->emissions.empty())
      throw InputError({.source = "--emission-by",
                        .value = options.emission_by,
                        .problem = "stands beside /guarantee/emissions of " + input.source,
                        .allowed = "one of them"});
  }
  std::vector<NamedEmission> emissions;
  if (options.emission_by.empty() && problem.guarantee) emissions = problem.guarantee->emissions;
  std::string given;
  for (const auto& [name, is_given] :
       {std::pair("--guarantee", !options.guarantee.empty()), std::pair("--of", !options.of.empty()),
        std::pair("--at", !options.at.empty()), std::pair("--outside", !options.outside.empty()),
        std::pair("--emission-by", !options.emission_by.empty())})
    if (is_given) given += (given.empty() ? "" : ", ") + std::string(name);
  problem.guarantee =
      with_source(given, [&] { return read_guarantee(JsonReader(guarantee), pieces_of(problem.surface)); });
  if (!emissions.empty()) problem.guarantee->emissions = std::move(emissions);
  return problem;
}

/// The levels of a result are of u_n; a solution that is enclosed has none, and its means have no places.
void refuse_fields(const SolveOptions& options, const Guarantee& guarantee) {
  const bool has_places = guarantee.of != EnclosedQuantity::means;
  for (const auto& [name, path, is_of_u] :
       {std::tuple("--nodes", &options.nodes, has_places), std::tuple("--vtu", &options.vtu, has_places),
        std::tuple("--ply", &options.ply, false), std::tuple("--out", &options.out, false)})
    if (!path->empty() && !is_of_u)
      throw InputError({.source = name,
                        .value = *path,
                        .problem = "is of the levels of u_n, and a guarantee is of u itself",
                        .allowed = has_places ? "--json, --vtu and --nodes beside this guarantee"
                                              : "--json beside a guarantee of means"});
}

/// What was found, with what there is to tell of the mesh on which it was.
void print_solved(const Common& common, const Outputs& outputs, const Problem& problem,
                  const std::string& table, const std::string& json, Files files) {
  const std::string notes = notes_on_meshes({&problem, 1});
  if (common.json_to_stdout()) say(notes);
  print_result(common, outputs, table + (notes.empty() ? "" : "\n" + notes), json, std::move(files));
}

ExitCode enclose(const Common& common, const SolveOptions& options, const Outputs& outputs,
                 const Problem& problem, const std::string& source) {
  refuse_fields(options, *problem.guarantee);
  for (const auto& [name, text] :
       {std::pair("--sample", &options.sample), {"--within", &options.within}, {"--points", &options.points}})
    if (!text->empty())
      throw InputError({.source = name,
                        .value = *text,
                        .problem = "is of u_n, and a guarantee is of u itself",
                        .allowed = "--at X,Y,Z beside a guarantee"});
  const auto limit = common.limit_threads();
  const bool certified = !options.certificate.empty();
  with_source(source, [&] {
    check_guarantee(problem, *problem.guarantee);
    if (certified) check_certified(problem, *problem.guarantee);
  });
  EnclosureDisplay display(common.quiet);
  ResultStore store = common.store();
  StoredNumbers kept(store, guarantee_key(problem, certified));
  const GuaranteeContext context{.progress = [&](const GuaranteeProgress& now) { display.mesh_done(now); },
                                 .meshes = [&](const MeshProgress& now) { display.at(now); },
                                 .kept = &kept};
  Files files;
  LevelResult level;
  SolutionEnclosure enclosure;
  try {
    with_source(source, [&] {
      if (!certified) {
        std::tie(level, enclosure) = solve_within(problem, *problem.guarantee, context);
        return;
      }
      CertifiedSolution found = certified_solution(problem, *problem.guarantee, context);
      files.emplace_back(options.certificate, certificate_text(found.certificate, common.command));
      level = std::move(found.level);
      enclosure = std::move(found.enclosure);
    });
  } catch (const Interrupted&) {
    return interrupted("finished cells", store);
  }
  say_where_nothing_is_kept(store);
  const std::string hindrance = enclosure.hindrance;
  const Result result{.problem = problem,
                      .levels = {std::move(level)},
                      .orders = {},
                      .timing = {{}},
                      .enclosure = std::move(enclosure)};
  const std::string json = result_text(result, common.command);
  if (!options.vtu.empty()) files.emplace_back(options.vtu, vtu_text(*result.enclosure));
  if (!options.nodes.empty()) files.emplace_back(options.nodes, enclosure_csv(*result.enclosure));
  print_solved(common, outputs, problem, enclosure_table(*result.enclosure), json, std::move(files));
  if (hindrance.empty()) return ExitCode::done;
  const double width = result.enclosure->width;
  const Rational& wanted = result.enclosure->wanted.width;
  // What is wanted is reached where it is the certificate that is wider.
  complain("the width " + upper_text(width) +
           (Rational::exactly(width) <= wanted ? " is reached, but "
                                               : " and not " + upper_text(wanted) + " is reached: ") +
           hindrance);
  return ExitCode::differs;
}

ExitCode solve(const Common& common, const SolveOptions& options) {
  Outputs outputs = checked_outputs(common, options);
  const InputFile input = read_input(options.problem, json_size_limit);
  const Problem problem = with_solver_of_run(problem_of(options, outputs, input));
  for (const InputDigest& named : inputs_named_in({&problem, 1})) outputs.input(named.name);
  require_same_named_files({&problem, 1});
  if (problem.guarantee) {
    if (ranks().count() > 1)
      throw InputError({.source = "mpirun",
                        .value = std::to_string(ranks().count()) + " ranks",
                        .problem = "do not share the work of a guarantee",
                        .allowed = "one process"});
    return enclose(common, options, outputs, problem, input.source);
  }
  if (!options.certificate.empty())
    throw InputError({.source = "--certificate",
                      .value = options.certificate,
                      .problem = "is of an enclosure of u itself, and none is asked for",
                      .allowed = "--guarantee beside it, or guarantee in the problem"});
  const auto limit = common.limit_threads();
  const std::uint64_t memory = memory_of_all_ranks(common.memory_limit());
  with_source(input.source, [&] { check(problem, memory); });
  const PointsWish wish = points_wish(options, outputs, problem);

  ResultStore store = common.store();
  const LevelSharing sharing{.ranks = ranks(), .fields = takes_fields(options) || !wish.is_empty()};
  StoredLevels levels(store, solve_with(reference::applied_operator, memory, sharing, &store), sharing);
  const std::vector<LevelOutcome> finished =
      with_source(input.source, [&] { return solve_levels(problem, levels, common.quiet); });
  const std::size_t asked = problem.triangulation.levels.size();
  if (finished.size() < asked) return interrupted(finished.size(), asked, store);

  if (!ranks().is_first()) return ExitCode::done;

  std::vector<LevelResult> results;
  std::vector<LevelTiming> timing;
  for (const LevelOutcome& level : finished) {
    results.push_back(level.result);
    timing.push_back(level.timing);
  }
  const Result result = collect(problem, std::move(results), std::move(timing));

  std::optional<std::vector<ValueAt>> points;
  try {
    points =
        with_source(input.source, [&] { return values_at(wish, problem, finished.back(), common.quiet); });
  } catch (const Interrupted&) {
    return interrupted(finished.size(), asked, store);
  }
  JsonValue document = result_json(result, common.command);
  if (points) document.set("points", points_json(*points));
  const std::string json = document.pretty() + "\n";
  Files files;
  if (!options.out.empty())
    files = files_of(common, options, result, finished, json, input.digest, points, wish);
  if (!options.points.empty()) files.emplace_back(options.points, points_csv(*points));
  if (!options.nodes.empty()) files.emplace_back(options.nodes, nodes_csv(finished));
  const auto& elements = finished.back().elements;
  if (!options.vtu.empty())
    files.emplace_back(options.vtu, vtu_text(elements, corner_errors(problem, elements),
                                             iterated_corner_errors(problem, elements)));
  if (!options.ply.empty())
    files.emplace_back(options.ply, ply_text(elements, corner_errors(problem, elements),
                                             iterated_corner_errors(problem, elements)));
  say_where_nothing_is_kept(store);
  const std::string of_points =
      points ? "\n" + points_table(*points, problem.triangulation.levels.back()) : "";
  print_solved(common, outputs, problem, solve_table(result) + of_points, json, std::move(files));
  return ExitCode::done;
}

}  // namespace

void add_solve(Program& program) {
  Subcommand command =
      program.add("solve", "Solve one problem over its levels: errors, ratios, orders, seconds, memory");
  auto options = std::make_shared<SolveOptions>();
  command.word("PROBLEM", options->problem,
               "A problem file, or - for the standard input; see radcert example problem", "FILE.json");
  command.option(
      "--nodes", options->nodes,
      "Write the values at the nodes of every level as CSV; with a guarantee of values or a function, "
      "the proved ones",
      "FILE.csv");
  command.option("--vtu", options->vtu,
                 "Write u_n, its error and with \"iterated\" E + K u_n at the last level for ParaView; with "
                 "a guarantee of values or a function, "
                 "what is proved of u",
                 "FILE.vtu");
  command.option("--ply", options->ply, "Write the same as PLY: triangles with radiosity and error",
                 "FILE.ply");
  command.option("--out", options->out,
                 "Write to DIR: solution.json, .vtu and .ply, errors.csv, nodes.csv, points.csv; table.tex, "
                 "plot.tex, the plot of "
                 "the errors as .svg and .tex, cite.bib, provenance.json",
                 "DIR");
  command.option(
      "--guarantee", options->guarantee,
      "Enclose the solution of the equation itself, within this width; the mesh and the degree are "
      "chosen by radcert",
      "WIDTH");
  command.option("--certificate", options->certificate,
                 "Write what proves the enclosure as a file that radcert check verifies", "FILE.json");
  command.option("--of", options->of, "What the guarantee is of: " + listed(guaranteed_quantities()), "WORD");
  command.option("--outside", options->outside,
                 "Of a function on a polyhedron: how far from the corners of faces the width is wanted. "
                 "Default: a hundredth of the shortest edge",
                 "DISTANCE");
  command.option(
      "--emission-by", options->emission_by,
      "piece: on a polyhedron, the same is enclosed for each emission that is 1 on one piece and 0 "
      "elsewhere, together",
      "WORD");
  command.repeated(
      "--at", options->at,
      "Where u_n and the iterated solution E + K u_n are asked for, at the last level: points on the "
      "surface, or a CSV file of them with the columns x, y, z, or piece, s, t, or chart, s, t; may "
      "be repeated. With a guarantee where values are, inside a face or on the ellipsoid; default "
      "then: the centres of the faces, the ends of the axes",
      "X,Y,Z or FILE.csv");
  command.option("--sample", options->sample,
                 "The same at N points spread over the surface by area, the same on every run", "N");
  command.option("--within", options->within,
                 "How far a point of --at may be from the surface, as a part of its extent; a farther one is "
                 "refused with its distance. Default: 1e-9",
                 "PART");
  command.option("--points", options->points,
                 "Write what --at or --sample asks for as CSV; --out writes it as points.csv", "FILE.csv");
  command.fresh_flag(program.common());
  command.footer(
      std::string("In a problem, `emission` is E, the power emitted per area, not the material constant 1 - "
                  "rho; with "
                  "`solution`\n"
                  "u given instead, E = u - Ku. `solver` is one of ") +
      listed(solver_names()) +
      ";\n"
      "verified proves its radii, or ends with exit code 1 and the reason why it cannot.\n"
      "With a meshless basis `elements` are its functions, one a site; at level k the sites of "
      "{\"poisson_disk\": s} are\n"
      "s/2^k apart, those of {\"uniform\": n} 4^k n. Reflections that would grow without end are refused "
      "with "
      "exit code 1.\n"
      "Under mpirun ranks share the work; --petsc, and options of PETSc after it, may be the last words.\n"
      "Finished levels are kept in $RADCERT_STORE, else ~/.cache/radcert.");
  command.runs([&common = program.common(), options] { return solve(common, *options); });
}

}  // namespace radcert::app
