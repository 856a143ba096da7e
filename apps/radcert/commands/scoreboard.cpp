// SPDX-License-Identifier: GPL-3.0-or-later

// radcert experiment scoreboard: all methods on a few problems.
#include "commands/scoreboard.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "origin.h"
#include "output.h"
#include "plot_files.h"
#include "progress.h"
#include "radcert/core/files/result_store.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/plot/scoreboard_plots.h"
#include "radcert/formats/result/certificate_json.h"
#include "radcert/formats/result/scoreboard_json.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/reference/continuous_means.h"
#include "radcert/reference/operator_integral.h"
#include "scoreboard/entries.h"
#include "scoreboard/page.h"
#include "tables/scoreboard_table.h"

namespace radcert::app {

namespace {

/// The means of a scene that are enclosed; none where u is given.
KnownMeans known_means(const BoardScene& scene) {
  KnownMeans out;
  if (scene.enclosed.empty()) return out;
  constexpr std::size_t elements_looked_at = 2;
  const auto means = reference::enclose(*reference::find_continuous_scene(scene.enclosed), intact_certificate,
                                        elements_looked_at);
  if (!means) throw AccuracyNotReached(scene.enclosed, "a certificate does not hold: " + means.reason());
  for (const auto& [piece, name] : scene.means)
    for (const reference::EnclosedMean& found : *means)
      if (found.mean->name == name) out.emplace_back(piece, enclosing(found.first.value));
  return out;
}

std::optional<double> largest_radius(const KnownMeans& known) {
  std::optional<double> out;
  for (const auto& [piece, mean] : known) out = std::max(out.value_or(0), mean.radius);
  return out;
}

/// Why a method does not serve a scene, on one line.
std::string reason_of(const InputError& error) {
  const InputFault& fault = error.fault();
  return (fault.pointer.empty() ? "" : fault.pointer + " ") + (fault.value ? *fault.value + " " : "") +
         fault.problem;
}

/// The cells of one method on one scene: its own, and that of its iterated solution.
std::vector<BoardCell> cells_of(const BoardScene& scene, const BoardMethod& method, const KnownMeans& known,
                                std::uint64_t memory, StoredLevels& levels) {
  std::vector<BoardCell> cells = {{.method = method.name}};
  if (method.iterated) cells.push_back({.method = *method.iterated});
  try {
    const Problem problem = board_problem(scene, method);
    check(problem, memory);
    for (const int level : problem.triangulation.levels) {
      const LevelOutcome outcome = levels.level(problem, level);
      cells[0].points.push_back(board_point(outcome.result, outcome.timing, known));
      if (method.iterated)
        cells[1].points.push_back(iterated_board_point(outcome.result, outcome.timing, known));
    }
  } catch (const InputError& error) {
    for (BoardCell& cell : cells) cell = {.method = cell.method, .refusal = reason_of(error)};
  } catch (const AccuracyNotReached& error) {
    for (BoardCell& cell : cells) cell = {.method = cell.method, .refusal = error.what()};
  }
  return cells;
}

}  // namespace

ExitCode run_scoreboard(const Common& common, const std::string& out, std::optional<int> finest) {
  Outputs outputs(common);
  outputs.folder("--out", out, {"scoreboard.json", "provenance.json"});
  const auto limit = common.limit_threads();
  const std::uint64_t memory = common.memory_limit();
  ResultStore store = common.store();
  StoredLevels levels(store, solve_with(reference::applied_operator, memory));
  std::vector<BoardScene> scenes = board_scenes();
  for (BoardScene& scene : scenes) scene.finest = finest.value_or(scene.finest);
  const auto parts = static_cast<double>(scenes.size() * board_methods().size());
  std::vector<BoardProblem> problems;
  try {
    ProgressDisplay progress(common.quiet);
    double done = 0;
    for (const BoardScene& scene : scenes) {
      progress.at(done / parts, scene.name);
      const KnownMeans known = known_means(scene);
      BoardProblem problem{.name = scene.name,
                           .words = scene.words,
                           .truth = scene.truth,
                           .truth_radius = largest_radius(known)};
      for (const BoardMethod& method : board_methods()) {
        progress.at(done / parts, scene.name + ", " + method.name);
        for (BoardCell& cell : cells_of(scene, method, known, memory, levels))
          problem.cells.push_back(std::move(cell));
        done += 1;
      }
      mark_frontiers(problem);
      problems.push_back(std::move(problem));
    }
  } catch (const Interrupted&) {
    return interrupted("finished levels", store);
  }

  const std::string json = scoreboard_json(problems, common.command).pretty() + "\n";
  Files files;
  if (!out.empty()) {
    const std::filesystem::path folder = out;
    files = plot_files(folder, scoreboard_plots(problems));
    files.emplace_back(folder / "scoreboard.json", json);
    files.emplace_back(folder / "scoreboard.csv", scoreboard_csv(problems));
    files.emplace_back(folder / "timing.csv", scoreboard_timing_csv(problems));
    files.emplace_back(folder / "scoreboard.html", scoreboard_page(problems, common.command));
    for (auto& file : origin_files(folder, common, {}, {}, std::nullopt)) files.push_back(std::move(file));
  }
  say_where_nothing_is_kept(store);
  print_result(common, outputs, scoreboard_table(problems), json, std::move(files));
  return ExitCode::done;
}

}  // namespace radcert::app
