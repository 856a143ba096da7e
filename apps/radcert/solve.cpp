// SPDX-License-Identifier: GPL-3.0-or-later

// radcert solve PROBLEM.json: one problem over its levels.
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "operator_route.h"
#include "output.h"
#include "progress.h"
#include "radcert/core/parallel.h"
#include "radcert/core/result_store.h"
#include "radcert/formats/csv.h"
#include "radcert/formats/problem_json.h"
#include "radcert/formats/result_json.h"
#include "radcert/formats/vtu.h"
#include "solve_table.h"
#include "verification/framework/levels.h"

namespace radcert::app {

namespace {

struct SolveOptions {
  std::string problem;
  std::string nodes;
  std::string vtu;
  std::string out;
};

Outputs checked_outputs(const Common& common, const SolveOptions& options) {
  Outputs outputs;
  if (!common.json.empty() && !common.json_to_stdout()) outputs.file("--json", common.json);
  if (!options.nodes.empty()) outputs.file("--nodes", options.nodes);
  if (!options.vtu.empty()) outputs.file("--vtu", options.vtu);
  if (!options.out.empty()) outputs.folder("--out", options.out);
  return outputs;
}

/// The entries of the matrix at a level, in units of those at level 0: four times the unknowns from level to level.
double work(int level) { return std::pow(16.0, level); }

/// The levels of a problem, each from the store or computed; fewer than asked for where somebody asked to stop.
std::vector<LevelOutcome> solve_levels(const Problem& problem, verification::StoredLevels& levels,
                                       bool quiet) {
  ProgressDisplay progress(quiet);
  double all = 0;
  for (const int level : problem.triangulation.levels) all += work(level);
  double done = 0;
  std::vector<LevelOutcome> finished;
  try {
    for (const int level : problem.triangulation.levels) {
      const LevelTiming last = finished.empty() ? LevelTiming{} : finished.back().timing;
      const double last_seconds = last.assembly_seconds + last.operator_seconds + last.solve_seconds;
      const double expected =
          finished.empty() ? 0 : last_seconds * (all - done) / work(finished.back().result.level);
      progress.at(done / all, "level " + std::to_string(level), expected);
      const std::size_t computed = levels.computed();
      finished.push_back(levels.level(problem, level));
      done += work(level);
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

ExitCode solve(const Common& common, const SolveOptions& options) {
  const Outputs outputs = checked_outputs(common, options);
  const auto threads = common.thread_limit();
  const std::uint64_t memory = common.memory_limit();
  const Problem problem = read_problem(options.problem);
  with_source(options.problem, [&] { check(problem, memory); });

  const std::optional<ThreadLimit> limit =
      threads ? std::optional<ThreadLimit>(std::in_place, *threads) : std::nullopt;
  ResultStore store;
  verification::StoredLevels levels(store, verification::solve_with(operator_route(), memory));
  const std::vector<LevelOutcome> finished =
      with_source(options.problem, [&] { return solve_levels(problem, levels, common.quiet); });
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
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  if (!common.json.empty() && !common.json_to_stdout()) files.emplace_back(common.json, json);
  if (!options.nodes.empty()) files.emplace_back(options.nodes, nodes_csv(finished));
  if (!options.vtu.empty()) files.emplace_back(options.vtu, vtu_text(finished.back().elements));
  if (!options.out.empty()) {
    const std::filesystem::path folder = options.out;
    files.emplace_back(folder / "solution.json", json);
    files.emplace_back(folder / "errors.csv", errors_csv(result));
    files.emplace_back(folder / "nodes.csv", nodes_csv(finished));
    files.emplace_back(folder / "solution.vtu", vtu_text(finished.back().elements));
  }
  outputs.write(files);
  print(common.json_to_stdout() ? json : solve_table(result));
  return ExitCode::done;
}

}  // namespace

void add_solve(CLI::App& program, Common& common, Action& action) {
  CLI::App& command = add_command(
      program, common, "solve", "Solve one problem over its levels: errors, ratios, orders, seconds, memory");
  auto options = std::make_shared<SolveOptions>();
  command.add_option("PROBLEM", options->problem, "A problem file; see radcert example problem")
      ->required()
      ->type_name("FILE.json");
  command.add_option("--nodes", options->nodes, "Write the values at the nodes of every level as CSV")
      ->type_name("FILE.csv");
  command.add_option("--vtu", options->vtu, "Write u_n of the last level for ParaView")
      ->type_name("FILE.vtu");
  command
      .add_option("--out", options->out, "Write solution.json, errors.csv, nodes.csv and solution.vtu to DIR")
      ->type_name("DIR");
  command.footer(
      "In a problem, `emission` is E, the power emitted per area, not the material constant 1 - rho; with "
      "`solution`\n"
      "u given instead, E = u - Ku. `solver` is direct, gmres or neumann.\n"
      "Finished levels are kept in $RADCERT_STORE, else ~/.cache/radcert.");
  command.callback(
      [&common, &action, options] { action = [&common, options] { return solve(common, *options); }; });
}

}  // namespace radcert::app
