// SPDX-License-Identifier: GPL-3.0-or-later

// radcert experiment EXPERIMENT.json: many problems, compared.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "command.h"
#include "commands/scoreboard.h"
#include "origin.h"
#include "output.h"
#include "plot_files.h"
#include "progress.h"
#include "radcert/core/files/result_store.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/plot/experiment_plots.h"
#include "radcert/formats/problem/experiment_file.h"
#include "radcert/formats/result/experiment_json.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/formats/table/latex_table.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/expected_seconds.h"
#include "radcert/study/study.h"
#include "run_ranks.h"
#include "tables/experiment_table.h"
#include "verification/report/report_page.h"

namespace radcert::app {

namespace {

struct ExperimentOptions {
  std::string experiment;
  std::string out;
  std::string finest;
};

constexpr int most_finest = 6;

/// Of the scoreboard; none where it is not given.
std::optional<int> finest_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  int level = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), level);
  if (error != std::errc() || end != text.data() + text.size() || level < 1 || level > most_finest)
    throw InputError({.source = "--finest",
                      .value = text,
                      .allowed = "a whole number from 1 to " + std::to_string(most_finest)});
  return level;
}

/// What is finished of an experiment.
struct Finished {
  std::vector<Result> results;
  std::size_t levels = 0;
};

/// The entries of the matrix at a level, in units of those of one basis function an element at level 0.
double work(const Problem& problem, int level) {
  const TriangleBasisChoice* basis = find_triangle_basis(problem.method);
  const double functions = basis != nullptr ? static_cast<double>(function_count(*basis)) : 1;
  return functions * functions * std::pow(16.0, level);
}

/// The works of all levels, in the order in which they are solved.
std::vector<double> works(const Experiment& experiment) {
  std::vector<double> out;
  for (const Combination& combination : experiment.combinations)
    for (const int level : combination.problem.triangulation.levels)
      out.push_back(work(combination.problem, level));
  return out;
}

std::size_t level_count(const Experiment& experiment) {
  std::size_t count = 0;
  for (const Combination& combination : experiment.combinations)
    count += combination.problem.triangulation.levels.size();
  return count;
}

/// The results of the combinations, level by level from the store or computed; fewer where the user asked to
/// stop.
Finished solve_all(const Experiment& experiment, const std::string& source, StoredLevels& levels,
                   bool quiet) {
  ProgressDisplay progress(quiet);
  const std::vector<double> all_works = works(experiment);
  const double all = std::accumulate(all_works.begin(), all_works.end(), 0.0);
  double done = 0;
  ExpectedSeconds expected;
  Finished finished;
  try {
    for (const Combination& combination : experiment.combinations) {
      const Problem& problem = combination.problem;
      const std::size_t computed = levels.computed();
      std::vector<LevelResult> results;
      std::vector<LevelTiming> timing;
      for (const int level : problem.triangulation.levels) {
        progress.at(done / all, combination.name + "; level " + std::to_string(level),
                    expected.of(std::span(all_works).subspan(finished.levels)));
        with_combination(combination, source, [&] {
          const LevelOutcome outcome = levels.level(problem, level);
          results.push_back(outcome.result);
          timing.push_back(outcome.timing);
          expected.finished(work(problem, level), outcome.timing.assembly_seconds +
                                                      outcome.timing.operator_seconds +
                                                      outcome.timing.solve_seconds);
        });
        done += work(problem, level);
        ++finished.levels;
      }
      finished.results.push_back(collect(problem, std::move(results), std::move(timing)));
      const std::size_t count = problem.triangulation.levels.size();
      progress.note(combination.name + ": " + std::to_string(count) + (count == 1 ? " level" : " levels") +
                    (levels.computed() == computed ? ", found in the store" : ""));
    }
  } catch (const Interrupted&) {
    // What is finished is in the store already.
  }
  return finished;
}

/// For a paper: table, plots, and where they come from.
Files paper_files(const Common& common, const ExperimentOptions& options, const Experiment& experiment,
                  std::span<const Result> results, const InputDigest& input) {
  const std::filesystem::path folder = options.out;
  Files files = {{folder / "table.tex", combinations_latex(experiment, results)}};
  for (auto& file : plot_files(folder, experiment_plots(experiment, results)))
    files.push_back(std::move(file));
  std::vector<Problem> problems;
  std::vector<std::string> references;
  for (const Combination& combination : experiment.combinations) {
    problems.push_back(combination.problem);
    for (std::string& key : references_of(combination.problem))
      if (std::find(references.begin(), references.end(), key) == references.end())
        references.push_back(std::move(key));
  }
  std::vector<InputDigest> inputs = {input};
  for (InputDigest& named : inputs_named_in(problems)) inputs.push_back(std::move(named));
  for (auto& file : origin_files(folder, common, references, std::move(inputs), seed_of(problems)))
    files.push_back(std::move(file));
  return files;
}

ExitCode run_experiment(const Common& common, const ExperimentOptions& options) {
  if (std::error_code error;
      options.experiment == "scoreboard" && !std::filesystem::exists("scoreboard", error))
    return ranks().is_first() ? run_scoreboard(common, options.out, finest_of(options.finest))
                              : ExitCode::done;
  if (!options.finest.empty())
    throw InputError({.source = "--finest",
                      .value = options.finest,
                      .problem = "has no meaning for an experiment file",
                      .allowed = "the word scoreboard; a file names its levels"});
  Outputs outputs(common);
  outputs.input(options.experiment);
  outputs.folder("--out", options.out, {"experiment.json", "provenance.json"});
  const auto limit = common.limit_threads();
  const std::uint64_t memory = memory_of_all_ranks(common.memory_limit());
  const InputFile input = read_input(options.experiment, json_size_limit);
  Experiment experiment = parse_experiment(input.text, options.experiment);
  for (Combination& combination : experiment.combinations)
    combination.problem = with_solver_of_run(std::move(combination.problem));
  for (const Combination& combination : experiment.combinations)
    with_combination(combination, options.experiment, [&] { check(combination.problem, memory); });

  std::vector<Problem> problems;
  for (const Combination& combination : experiment.combinations) problems.push_back(combination.problem);
  for (const InputDigest& named : inputs_named_in(problems)) outputs.input(named.name);
  require_same_named_files(problems);
  say(notes_on_meshes(problems));
  ResultStore store = common.store();
  const LevelSharing sharing{.ranks = ranks(), .fields = false};
  StoredLevels levels(store, solve_with(reference::applied_operator, memory, sharing, &store), sharing);
  const Finished finished = solve_all(experiment, options.experiment, levels, common.quiet);
  const std::size_t asked = level_count(experiment);
  if (finished.levels < asked) return interrupted(finished.levels, asked, store);

  if (!ranks().is_first()) return ExitCode::done;

  const std::vector<Result>& results = finished.results;
  const JsonValue document = experiment_json(experiment, results, common.command);
  const std::string json = document.pretty() + "\n";
  Files files;
  if (!options.out.empty()) files = paper_files(common, options, experiment, results, input.digest);
  if (!options.out.empty()) {
    const std::filesystem::path folder = options.out;
    files.emplace_back(folder / "experiment.json", json);
    files.emplace_back(folder / "experiment.html",
                       verification::experiment_page(document, experiment, results));
    files.emplace_back(folder / "errors.csv", experiment_errors_csv(experiment, results));
    files.emplace_back(folder / "timing.csv", experiment_timing_csv(experiment, results));
  }
  say_where_nothing_is_kept(store);
  print_result(common, outputs, experiment_table(experiment, results), json, std::move(files));
  return ExitCode::done;
}

}  // namespace

void add_experiment(Program& program) {
  Subcommand command =
      program.add("experiment", "Solve problems that differ in a few parts and compare them at equal cost");
  auto options = std::make_shared<ExperimentOptions>();
  command.word("EXPERIMENT", options->experiment,
               "An experiment file, see radcert example experiment; or scoreboard, see below", "FILE.json");
  command.option(
      "--out", options->out,
      "Write to DIR: experiment.json, experiment.html, errors.csv, timing.csv, table.tex, each plot as .svg "
      "and .tex, plot.tex with all of them, cite.bib, provenance.json",
      "DIR");
  command.option("--finest", options->finest,
                 "Of scoreboard: the last level for linear functions; default 2. Others end beside it",
                 "LEVEL");
  command.fresh_flag(program.common());
  command.footer(
      "Every combination of the lists of `vary` with `base` is a problem, as radcert solve takes it.\n"
      "Finished levels are kept in $RADCERT_STORE, else ~/.cache/radcert: an interrupted experiment goes "
      "on.\n"
      "scoreboard: all methods and bases on five problems with known or enclosed solutions, with the "
      "frontier of "
      "those that nothing\nbeats; --out then writes scoreboard.json, .csv and .html, timing.csv and plots.\n"
      "Under mpirun ranks share the work; --petsc, and options of PETSc after it, may be the last words.");
  command.runs([&common = program.common(), options] { return run_experiment(common, *options); });
}

}  // namespace radcert::app
