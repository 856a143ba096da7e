// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/experiment_table.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "output.h"
#include "radcert/formats/table/order_text.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::app {

namespace {

using Points = std::vector<CostPoint> (*)(const Result& result, const ErrorKind& kind);

const ErrorKind& kind_named(const std::string& name) {
  return *std::find_if(error_kinds().begin(), error_kinds().end(),
                       [&](const ErrorKind& kind) { return kind.name == name; });
}

using Question = std::vector<std::size_t>;

std::optional<EqualCost> compared(std::span<const Result> results, const Question& question,
                                  const std::string& kind, Points points) {
  std::vector<std::vector<CostPoint>> methods;
  for (const std::size_t i : question) methods.push_back(points(results[i], kind_named(kind)));
  return at_equal_cost(methods);
}

std::string error_text(const std::optional<double>& error) {
  return error ? nearest_text(*error, DecimalForm::scientific(4)) : "-";
}

std::string order_text(const std::vector<OrderFit>& orders) {
  for (const OrderFit& fit : orders)
    if (fit.quantity == "node_error" && fit.order) return fitted_order_text(fit, " +- ").value_or("-");
  return "-";
}

/// The place of each method in an order, from 1; "-" where it has no error there.
std::vector<std::string> ranks(const EqualCost& compared) {
  std::vector<std::string> out(compared.order.size(), "-");
  for (std::size_t place = 0; place < compared.order.size(); ++place)
    if (const std::size_t method = compared.order[place]; compared.errors[method])
      out[method] = std::to_string(place + 1);
  return out;
}

std::string left_out_text(const Experiment& experiment, std::span<const Result> results,
                          std::vector<int> OrderFit::*levels, const std::string& why) {
  std::string out;
  for (std::size_t i = 0; i < results.size(); ++i)
    for (const OrderFit& fit : results[i].orders) {
      if (fit.quantity != "node_error" || (fit.*levels).empty()) continue;
      out += "\n  " + experiment.combinations[i].name + ": level";
      for (const int level : fit.*levels) out += " " + std::to_string(level);
    }
  return out.empty() ? out : "Left out of the orders, " + why + ":" + out + "\n";
}

/// The combinations of one question, the best at equal unknowns first.
std::string ranking(const Experiment& experiment, std::span<const Result> results, const Question& question) {
  const auto by_unknowns = compared(results, question, "node_error", error_against_unknowns);
  const auto by_seconds = compared(results, question, "node_error", error_against_seconds);
  const auto on_sample = compared(results, question, "uniform_error", error_against_unknowns);
  if (!by_unknowns || !by_seconds)
    return "No level has an error that is not zero: there is nothing to rank.\n";
  const std::vector<std::string> places = ranks(*by_unknowns);
  const std::vector<std::string> fast_places = ranks(*by_seconds);
  const std::string at_unknowns =
      "at " + nearest_text(by_unknowns->cost, DecimalForm::general(6)) + " unknowns";
  const std::string at_seconds = "at " + nearest_text(by_seconds->cost, DecimalForm::general(2)) + " s";
  std::vector<std::vector<std::string>> rows = {{"combination", "rank", at_unknowns, "rank", at_seconds,
                                                 "sample, " + at_unknowns, "order in h", "in unknowns"}};
  for (const std::size_t method : by_unknowns->order) {
    const Result& result = results[question[method]];
    rows.push_back({experiment.combinations[question[method]].name, places[method],
                    error_text(by_unknowns->errors[method]), fast_places[method],
                    error_text(by_seconds->errors[method]),
                    error_text(on_sample ? on_sample->errors[method] : std::nullopt),
                    order_text(result.orders), order_text(orders_in_unknowns(result))});
  }
  return aligned(rows) + "\n";
}

}  // namespace

std::string experiment_table(const Experiment& experiment, std::span<const Result> results) {
  std::string out = experiment.name + ": max |u-u_n| over the nodes, the combinations at equal cost\n\n";
  for (const Question& question : questions(experiment)) out += ranking(experiment, results, question);
  return out +
         "Cost: the largest that all combinations of a table pay at some level; between two levels by a "
         "power "
         "law.\n- where every level costs more. Seconds: assembly and solution, when the level was "
         "solved.\nsample: max |u-u_n| over a sample of S. Orders with the spread of the slopes between "
         "levels; no "
         "guarantee.\n" +
         left_out_text(experiment, results, &OrderFit::left_out,
                       "because the radius exceeds 5 % of the error") +
         left_out_text(experiment, results, &OrderFit::pre_asymptotic,
                       "because no steady slope begins there");
}

}  // namespace radcert::app
