// SPDX-License-Identifier: GPL-3.0-or-later

// radcert solve PROBLEM.json: one problem over its levels.
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
#include "radcert/reference/operator_integral.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/certified_solution.h"
#include "radcert/study/expected_seconds.h"
#include "tables/enclosure_table.h"
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
  std::string of;
  std::string outside;
  std::string emission_by;
  std::string certificate;
};

/// What --out may write beside plots and tables, which are no input's.
const std::vector<std::string> names_of_out = {"solution.json", "provenance.json"};

Outputs checked_outputs(const Common& common, const SolveOptions& options) {
  Outputs outputs(common);
  outputs.input(options.problem);
  outputs.file("--nodes", options.nodes);
  outputs.file("--vtu", options.vtu);
  outputs.file("--ply", options.ply);
  outputs.file("--certificate", options.certificate);
  outputs.folder("--out", options.out, names_of_out);
  return outputs;
}

/// The entries of the matrix at a level, in units of those at level 0: four times the unknowns from level to
/// level.
double work(int level) { return std::pow(16.0, level); }

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
      expected.finished(work(level),
                        timing.assembly_seconds + timing.operator_seconds + timing.solve_seconds);
      const LevelResult& result = finished.back().result;
      progress.note("level " + std::to_string(level) + ": " + std::to_string(result.elements) +
                    " elements, " + std::to_string(result.unknowns) + " unknowns" +
                    (levels.computed() == computed ? ", found in the store" : ""));
    }
  } catch (const Interrupted&) {
    // What is finished is in the store already.
  }
  return finished;
}

/// What --out writes.
Files files_of(const Common& common, const SolveOptions& options, const Result& result,
               std::span<const LevelOutcome> levels, const std::string& json, const InputDigest& problem) {
  const std::filesystem::path folder = options.out;
  const auto& elements = levels.back().elements;
  const auto errors = corner_errors(result.problem, elements);
  Files files = {{folder / "solution.json", json},
                 {folder / "errors.csv", errors_csv(result)},
                 {folder / "nodes.csv", nodes_csv(levels)},
                 {folder / "solution.vtu", vtu_text(elements, errors)},
                 {folder / "solution.ply", ply_text(elements, errors)},
                 {folder / "table.tex", levels_latex(result)}};
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

/// The problem with what --guarantee, --of, --at, --outside and --emission-by say in place of its own words.
Problem problem_of(const SolveOptions& options, const InputFile& input) {
  Problem problem = parse_problem(input.text, input.source);
  if (options.guarantee.empty() && options.of.empty() && options.at.empty() && options.outside.empty() &&
      options.emission_by.empty())
    return problem;
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
  JsonValue points = JsonValue::array();
  for (const std::string& point : options.at) points.push(coordinates_json(point));
  if (options.at.empty() && problem.guarantee)
    for (const Vector<Rational>& point : problem.guarantee->points) points.push(point_json(point));
  if (!points.elements()->empty()) guarantee.set("points", std::move(points));
  if (!options.emission_by.empty()) guarantee.set("emissions", "by " + options.emission_by);
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
  complain("the width " + upper_text(result.enclosure->width) + " and not " +
           upper_text(result.enclosure->wanted.width) + " is reached: " + hindrance);
  return ExitCode::differs;
}

ExitCode solve(const Common& common, const SolveOptions& options) {
  Outputs outputs = checked_outputs(common, options);
  const InputFile input = read_input(options.problem, json_size_limit);
  const Problem problem = problem_of(options, input);
  for (const InputDigest& named : inputs_named_in({&problem, 1})) outputs.input(named.name);
  if (problem.guarantee) return enclose(common, options, outputs, problem, input.source);
  if (!options.certificate.empty())
    throw InputError({.source = "--certificate",
                      .value = options.certificate,
                      .problem = "is of an enclosure of u itself, and none is asked for",
                      .allowed = "--guarantee beside it, or guarantee in the problem"});
  const auto limit = common.limit_threads();
  const std::uint64_t memory = common.memory_limit();
  with_source(input.source, [&] { check(problem, memory); });

  ResultStore store = common.store();
  StoredLevels levels(store, solve_with(reference::applied_operator, memory));
  const std::vector<LevelOutcome> finished =
      with_source(input.source, [&] { return solve_levels(problem, levels, common.quiet); });
  const std::size_t asked = problem.triangulation.levels.size();
  if (finished.size() < asked) return interrupted(finished.size(), asked, store);

  std::vector<LevelResult> results;
  std::vector<LevelTiming> timing;
  for (const LevelOutcome& level : finished) {
    results.push_back(level.result);
    timing.push_back(level.timing);
  }
  const Result result = collect(problem, std::move(results), std::move(timing));

  const std::string json = result_text(result, common.command);
  Files files;
  if (!options.out.empty()) files = files_of(common, options, result, finished, json, input.digest);
  if (!options.nodes.empty()) files.emplace_back(options.nodes, nodes_csv(finished));
  const auto& elements = finished.back().elements;
  if (!options.vtu.empty())
    files.emplace_back(options.vtu, vtu_text(elements, corner_errors(problem, elements)));
  if (!options.ply.empty())
    files.emplace_back(options.ply, ply_text(elements, corner_errors(problem, elements)));
  say_where_nothing_is_kept(store);
  print_solved(common, outputs, problem, solve_table(result), json, std::move(files));
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
  command.option(
      "--vtu", options->vtu,
      "Write u_n and its error at the last level for ParaView; with a guarantee of values or a function, "
      "what is proved of u",
      "FILE.vtu");
  command.option("--ply", options->ply, "Write the same as PLY: triangles with radiosity and error",
                 "FILE.ply");
  command.option(
      "--out", options->out,
      "Write to DIR: solution.json, .vtu and .ply, errors.csv, nodes.csv; table.tex, plot.tex, the plot of "
      "the errors as .svg and .tex, cite.bib, provenance.json",
      "DIR");
  command.option(
      "--guarantee", options->guarantee,
      "Enclose the solution of the equation itself, within this width; the mesh and the degree are "
      "chosen by radcert",
      "WIDTH");
  command.option("--certificate", options->certificate,
                 "Write what encloses the means or values on a convex polyhedron, or anything on an "
                 "ellipsoid, as a file "
                 "that radcert check verifies",
                 "FILE.json");
  command.option("--of", options->of, "What the guarantee is of: " + listed(guaranteed_quantities()), "WORD");
  command.option("--outside", options->outside,
                 "Of a function on a polyhedron: how far from the vertices the width is wanted. Default: a "
                 "hundredth of the shortest edge",
                 "DISTANCE");
  command.option(
      "--emission-by", options->emission_by,
      "piece: on a polyhedron, the same is enclosed for each emission that is 1 on one piece and 0 "
      "elsewhere, together",
      "WORD");
  command.repeated("--at", options->at,
                   "Where values are asked for, inside a face or on the ellipsoid; may be repeated. Default: "
                   "the centres of the faces, the ends of the axes",
                   "X,Y,Z");
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
      "Finished levels are kept in $RADCERT_STORE, else ~/.cache/radcert.");
  command.runs([&common = program.common(), options] { return solve(common, *options); });
}

}  // namespace radcert::app
