// SPDX-License-Identifier: GPL-3.0-or-later

// radcert verify: the claims of the papers, or of a user's own folder, held against their record.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "origin.h"
#include "output.h"
#include "progress.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/text.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/reference/operator_integral.h"
#include "verification/framework/reading/embedded.h"
#include "verification/framework/run_verification.h"
#include "verification/report/report_junit.h"
#include "verification/report/report_text.h"
#include "verify_files.h"

namespace radcert::app {

namespace {

struct VerifyOptions {
  std::vector<std::string> words;
  std::string budget = "quick";
  std::string out;
  std::string junit;
};

verification::Budget budget_of(const std::string& word) {
  const auto budget = verification::budget_named(word);
  if (!budget) throw InputError({.source = "--budget", .value = word, .allowed = "quick, standard, full"});
  return *budget;
}

verification::Report run(const Common& common, const VerifyOptions& options, verification::Budget budget,
                         ResultStore& store) {
  const OperatorRoute route = reference::applied_operator;
  StoredLevels levels(store, solve_with(route, common.memory_limit()));
  const verification::Bench bench{.budget = budget, .route = route, .levels = levels, .store = store};
  ProgressDisplay progress(common.quiet);
  return verification::run_verification(options.words, bench, [&](const verification::Progress& now) {
    progress.counted(now.done, now.total, now.statement);
  });
}

/// The claims files of a user's own that were read.
std::vector<InputDigest> inputs_of(const std::vector<std::string>& words) {
  std::vector<InputDigest> out;
  for (const std::string& word : words) {
    const auto& papers = verification::embedded_papers();
    const bool embedded = std::any_of(papers.begin(), papers.end(), [&](const EmbeddedFile& each) {
      return each.path.starts_with(word + "/");
    });
    if (embedded) continue;
    const std::filesystem::path path = word;
    for (const std::filesystem::path& folder : {path, path.parent_path()}) {
      const auto file = folder / "claims.toml";
      if (!std::filesystem::is_regular_file(file)) continue;
      if (std::none_of(out.begin(), out.end(),
                       [&](const InputDigest& each) { return each.name == file.string(); }))
        out.push_back(read_input(file, json_size_limit).digest);
      break;
    }
  }
  return out;
}

/// The papers whose statements were checked.
std::vector<std::string> papers_of(const verification::Report& report) {
  std::vector<std::string> out;
  for (const verification::ClaimReport& claim : report.claims)
    if (std::find(out.begin(), out.end(), claim.paper) == out.end()) out.push_back(claim.paper);
  return out;
}

/// The lines of what differs from its record stand out.
std::string with_alarms(const std::string& table) {
  std::string out;
  for (std::size_t begin = 0; begin < table.size();) {
    const std::size_t end = std::min(table.find('\n', begin), table.size());
    const std::string line = table.substr(begin, end - begin);
    out += (line.starts_with("! ") ? alarming(line, STDOUT_FILENO) : line) + "\n";
    begin = end + 1;
  }
  return out;
}

ExitCode verify(const Common& common, const VerifyOptions& options) {
  const verification::Budget budget = budget_of(options.budget);
  Outputs outputs(common);
  outputs.folder("--out", options.out, {"provenance.json", "report.json"});
  outputs.file("--junit", options.junit);
  const std::vector<InputDigest> inputs = inputs_of(options.words);
  for (const InputDigest& input : inputs) outputs.input(input.name);
  const auto limit = common.limit_threads();

  ResultStore store = common.store();
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
  say_where_nothing_is_kept(store);
  const std::vector<InputDigest> now = inputs_of(options.words);
  if (!std::equal(now.begin(), now.end(), inputs.begin(), inputs.end(),
                  [](const InputDigest& a, const InputDigest& b) { return a.digest == b.digest; }))
    throw EnvironmentError(listed(options.words), "claims.toml has changed while it was verified");
  Files files;
  if (!options.out.empty()) {
    files = verification::report_files(report, options.out, common.command);
    for (auto& file : verify_files(report, options.out)) files.push_back(std::move(file));
    for (auto& file : origin_files(options.out, common, papers_of(report), inputs))
      files.push_back(std::move(file));
  }
  if (!options.junit.empty()) files.emplace_back(options.junit, verification::report_junit(report));
  const std::size_t columns = terminal_width().value_or(std::string::npos);
  print_result(common, outputs, with_alarms(verification::report_table(report, columns)),
               verification::report_json_text(report, common.command), std::move(files));
  return report.as_recorded() ? ExitCode::done : ExitCode::differs;
}

}  // namespace

void add_verify(Program& program) {
  Subcommand command = program.add("verify", "Run the claims and hold each verdict against its record");
  auto options = std::make_shared<VerifyOptions>();
  command.words("WHAT", options->words,
                "KEY, a folder with claims.toml, or one of these with /CLAIM; all papers if none is named");
  command.option_with_default("--budget", options->budget,
                              "quick (each paper in under 2 minutes), standard or full");
  command.option(
      "--out", options->out,
      "Write to DIR: report.html, report.json, report.md; errors.csv, table.tex, plot.tex, plots (SVG), "
      "cite.bib, provenance.json",
      "DIR");
  command.option(
      "--junit", options->junit,
      "Write the verdicts as test results in JUnit's XML: a case fails where its verdict is not the "
      "recorded one",
      "FILE.xml");
  command.fresh_flag(program.common());
  command.footer(
      "Finished work is kept in $RADCERT_STORE, else ~/.cache/radcert: an interrupted run goes on there.");
  command.runs([&common = program.common(), options] { return verify(common, *options); });
}

}  // namespace radcert::app
