// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/run_verification.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/core/files/result_store.h"
#include "radcert/formats/problem/problem_json.h"
#include "verification/framework/check.h"
#include "verification/framework/enclosure_check.h"
#include "verification/framework/level_errors.h"
#include "verification/framework/pending_findings.h"
#include "verification/framework/stored_finding.h"
#include "verification/framework/table_check.h"

namespace radcert::verification {
namespace {

const PaperChecks* checks_of(std::span<const PaperChecks> checks, const std::string& key) {
  for (const PaperChecks& each : checks)
    if (each.key == key) return &each;
  return nullptr;
}

LevelErrors errors_of(const Problem& problem, const OrderClaim& claim, const Bench& bench) {
  const std::vector<int>& levels = problem.triangulation.levels;
  return claim.quantity == "node_error" ? node_errors(bench, problem, levels)
                                        : discretisation_errors(bench, problem, levels);
}

Finding check_order(const Paper& paper, const OrderClaim& claim, const Bench& bench) {
  const OrderModel model{.logarithm = claim.logarithm};
  const auto observed = [&](const std::string& file) {
    const Problem problem = parse_problem(paper.file(file), paper.source(file));
    return observed_order(errors_of(problem, claim, bench), model);
  };
  Finding finding = Finding::of_data();
  const Order order = Order::at_least(claim.order);
  const ObservedOrder found = observed(claim.problem);
  finding.require("order of " + claim.quantity + ", " + claim.problem, order, found);
  finding.control("order of " + claim.quantity + ", " + claim.control, order, observed(claim.control));
  finding.show(found.exponent);
  return finding;
}

// An order takes three levels, each of which halves the one before; with |log h| three with h < 1.
void check_levels(const Paper& paper, const OrderClaim& claim, const std::string& file) {
  const Problem problem = parse_problem(paper.file(file), paper.source(file));
  const std::vector<int>& levels = problem.triangulation.levels;
  bool consecutive = true;
  for (std::size_t k = 1; k < levels.size(); ++k) consecutive = consecutive && levels[k] == levels[k - 1] + 1;
  const std::size_t coarse = claim.logarithm && !levels.empty() && levels.front() == 0 ? 1 : 0;
  if (consecutive && levels.size() >= 3 + coarse) return;
  throw InputError({.source = paper.source(file),
                    .pointer = "/triangulation/levels",
                    .problem = "are too few, or leave one out, for an order",
                    .allowed = claim.logarithm ? "three consecutive levels at least, beside level 0"
                                               : "three consecutive levels at least"});
}

// What is wrong with any of a paper's files is said before any work.
void check_files(const Selected& selected) {
  const Paper& paper = selected.paper;
  for (const Claim& claim : paper.claims) {
    if (!selected.wants_part_of(claim.label)) continue;
    check_erratum(paper, claim);
    if (claim.order)
      for (const std::string& file : {claim.order->problem, claim.order->control})
        check_levels(paper, *claim.order, file);
    if (claim.enclosure) check_names(paper, claim);
  }
}

ClaimReport check_claim(const Paper& paper, const Claim& claim, const Bench& bench, RecordedLevels& levels,
                        const PaperChecks* checks) {
  ClaimReport report{.paper = paper.key,
                     .label = claim.label,
                     .says = claim.says,
                     .covers = claim.covers,
                     .page = claim.page,
                     .needs = claim.needs,
                     .recorded = claim.verdict.value().at(bench.budget),
                     .ours = std::nullopt,
                     .printed = std::nullopt,
                     .note = claim.note,
                     .evidence = {},
                     .remarks = {},
                     .failure = std::nullopt};
  if (claim.check == CheckKind::none) {
    report.found = report.recorded;
    return report;
  }
  const auto start = std::chrono::steady_clock::now();
  std::optional<double> seconds;
  try {
    Finding finding;
    if (claim.check == CheckKind::order) {
      finding = check_order(paper, claim.order.value(), bench);
    } else if (claim.check == CheckKind::enclosure) {
      finding = check_enclosure(paper, claim, bench);
    } else {
      const Check* check = checks == nullptr ? nullptr : checks->find(claim.label);
      if (check == nullptr)
        throw InputError({.source = paper.source("claims.toml") + ", line " + std::to_string(claim.line),
                          .pointer = "/" + claim.label,
                          .problem = "has no check of that name in the program",
                          .allowed = "check = \"table\", \"order\" or \"enclosure\", or the label of a check "
                                     "that is compiled in"});
      TimedFinding found = stored_finding(*check, paper.key + "/" + claim.label, bench, levels);
      finding = std::move(found.finding);
      seconds = found.seconds;
    }
    report.found = finding.verdict();
    report.evidence = finding.evidence();
    report.remarks = finding.remarks();
    report.ours = finding.figure();
    report.failure = finding.fault();
  } catch (const InputError&) {
    throw;
  } catch (const EnvironmentError&) {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    report.found = Verdict::failed;
    report.failure = error.what();
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  report.seconds = seconds.value_or(passed.count());
  return report;
}

// The checks in code that a run of a store that keeps something has to make.
std::vector<PendingFinding> pending_of(std::span<const Selected> selected, const Bench& bench,
                                       std::span<const PaperChecks> checks) {
  std::vector<PendingFinding> pending;
  if (!bench.store.status()) return pending;
  for (const Selected& each : selected) {
    const PaperChecks* of_paper = checks_of(checks, each.paper.key);
    for (const Claim& claim : each.paper.claims) {
      if (claim.check != CheckKind::function || of_paper == nullptr || !each.wants(claim.label)) continue;
      const Check* const check = of_paper->find(claim.label);
      const std::string statement = each.paper.key + "/" + claim.label;
      if (check != nullptr && !is_stored(statement, bench)) pending.push_back({statement, check});
    }
  }
  return pending;
}

Account account_of(const Claim& claim) {
  return {.formula = claim.formula,
          .met = claim.met,
          .scope = claim.scope,
          .tried = claim.tried,
          .unchecked = claim.unchecked,
          .erratum = claim.erratum};
}

std::vector<std::string> labels_of(const Paper& paper, const Claim& claim) {
  return claim.table ? cell_labels(paper, claim) : std::vector<std::string>{claim.label};
}

}  // namespace

std::vector<std::string> statement_labels(const Paper& paper) {
  std::vector<std::string> labels;
  for (const Claim& claim : paper.claims)
    for (std::string& label : labels_of(paper, claim)) labels.push_back(std::move(label));
  return labels;
}

Report run_verification(std::span<const Selected> selected, const Bench& given,
                        std::span<const PaperChecks> checks,
                        const std::function<void(const Progress&)>& progress) {
  RecordedLevels levels(given.levels);
  const Bench bench{.budget = given.budget, .route = given.route, .levels = levels, .store = given.store};
  Progress now;
  for (const Selected& each : selected) check_files(each);
  for (const Selected& each : selected)
    for (const std::string& label : statement_labels(each.paper)) now.total += each.wants(label) ? 1 : 0;
  Report report{.budget = bench.budget, .claims = {}, .problems = {}, .papers = {}};
  for (const Selected& each : selected)
    report.papers.push_back({.key = each.paper.key,
                             .folder = each.paper.folder,
                             .readme = file_if_there(each.paper, "README.md"),
                             .errata = file_if_there(each.paper, "errata.md")});
  const auto add = [&](ClaimReport claim, const Claim& of) {
    claim.account = account_of(of);
    claim.problems = levels.used();
    report.claims.push_back(std::move(claim));
  };
  const auto tell = [&](const std::string& statement) {
    now.statement = statement;
    if (progress) progress(now);
    ++now.done;
  };
  const std::vector<PendingFinding> pending = pending_of(selected, given, checks);
  std::set<std::string> told;
  find_pending(pending, given, [&](const PendingFinding& one) {
    tell(one.statement);
    told.insert(one.statement);
  });
  for (const Selected& each : selected) {
    const PaperChecks* of_paper = checks_of(checks, each.paper.key);
    const auto starting = [&](const std::string& label) {
      const std::string statement = each.paper.key + "/" + label;
      if (!told.contains(statement)) tell(statement);
    };
    for (const Claim& claim : each.paper.claims) {
      if (!each.wants_part_of(claim.label)) continue;
      levels.begin();
      if (claim.table) {
        std::vector<ClaimReport> cells = check_table(
            each.paper, claim, bench, of_paper == nullptr ? SecondRoute{} : of_paper->second_route,
            [&](const std::string& label) { return each.wants(label); }, starting);
        for (ClaimReport& cell : cells) add(std::move(cell), claim);
      } else if (each.wants(claim.label)) {
        starting(claim.label);
        add(check_claim(each.paper, claim, bench, levels, of_paper), claim);
      }
    }
  }
  report.problems = levels.problems();
  return report;
}

Report run_verification(std::span<const std::string> words, const Bench& bench,
                        const std::function<void(const Progress&)>& progress) {
  const std::vector<Selected> selected = select(words);
  const std::vector<PaperChecks> checks = all_checks();
  return run_verification(selected, bench, checks, progress);
}

}  // namespace radcert::verification
