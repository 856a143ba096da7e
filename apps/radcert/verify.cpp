// SPDX-License-Identifier: GPL-3.0-or-later

// radcert verify: the claims of the papers, or of a user's own folder, held against their record.
#include <CLI/CLI.hpp>
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
#include "verification/framework/run_verification.h"
#include "verification/report/report_text.h"

namespace radcert::app {

namespace {

struct VerifyOptions {
  std::vector<std::string> words;
  std::string budget = "quick";
  std::string out;
};

verification::Budget budget_of(const std::string& word) {
  const auto budget = verification::budget_named(word);
  if (!budget) throw InputError({.source = "--budget", .value = word, .allowed = "quick, standard, full"});
  return *budget;
}

verification::Report run(const Common& common, const VerifyOptions& options, verification::Budget budget,
                         ResultStore& store) {
  const OperatorRoute route = operator_route();
  verification::StoredLevels levels(store, verification::solve_with(route, common.memory_limit()));
  const verification::Bench bench{.budget = budget, .route = route, .levels = levels, .store = store};
  ProgressDisplay progress(common.quiet);
  return verification::run_verification(options.words, bench, [&](const verification::Progress& now) {
    const double fraction =
        now.total == 0 ? 0 : static_cast<double>(now.done) / static_cast<double>(now.total);
    progress.at(fraction, now.paper + "/" + now.label);
  });
}

ExitCode verify(const Common& common, const VerifyOptions& options) {
  const verification::Budget budget = budget_of(options.budget);
  Outputs outputs;
  if (!common.json.empty() && !common.json_to_stdout()) outputs.file("--json", common.json);
  if (!options.out.empty()) outputs.folder("--out", options.out);
  const auto threads = common.thread_limit();
  const std::optional<ThreadLimit> limit =
      threads ? std::optional<ThreadLimit>(std::in_place, *threads) : std::nullopt;

  ResultStore store;
  verification::Report report;
  try {
    report = run(common, options, budget, store);
  } catch (const Interrupted&) {
    const auto status = store.status();
    say("radcert: interrupted; what was finished is " +
        (status ? "kept in " + store.folder().string() + ": the same command goes on from there\n"
                : "not kept: " + status.reason() + "\n"));
    return ExitCode::interrupted;
  }
  if (!options.out.empty()) verification::write_report(report, options.out, common.command);
  print_result(common, verification::report_table(report),
               verification::report_json_text(report, common.command));
  return report.as_recorded() ? ExitCode::done : ExitCode::differs;
}

}  // namespace

void add_verify(CLI::App& program, Common& common, Action& action) {
  CLI::App& command =
      add_command(program, common, "verify", "Run the claims and hold each verdict against its record");
  auto options = std::make_shared<VerifyOptions>();
  command.add_option("WHAT", options->words,
                     "KEY, KEY/CLAIM, or a folder with claims.toml; all papers if none is named");
  command.add_option("--budget", options->budget, "quick (each paper in under 2 minutes), standard or full")
      ->capture_default_str();
  command.add_option("--out", options->out, "Write the report, report.json and report.md, to DIR")
      ->type_name("DIR");
  command.footer(
      "Finished work is kept in $RADCERT_STORE, else ~/.cache/radcert: an interrupted run goes on there.");
  command.callback(
      [&common, &action, options] { action = [&common, options] { return verify(common, *options); }; });
}

}  // namespace radcert::app
