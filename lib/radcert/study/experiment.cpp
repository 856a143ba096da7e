// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/experiment.h"

#include <algorithm>
#include <map>

namespace radcert {
namespace {

template <class Cost>
std::vector<CostPoint> error_against(const Result& result, const ErrorKind& kind, const Cost& cost) {
  std::vector<CostPoint> out;
  for (std::size_t k = 0; k < result.levels.size(); ++k) {
    const std::optional<Approximation>& error = result.levels[k].*kind.figure;
    if (error && error->value > 0 && cost(k) > 0) out.push_back({cost(k), error->value});
  }
  return out;
}

const ErrorKind& kind_named(const std::string& name) {
  return *std::find_if(error_kinds().begin(), error_kinds().end(),
                       [&](const ErrorKind& kind) { return kind.name == name; });
}

}  // namespace

std::vector<std::vector<std::size_t>> questions(const Experiment& experiment) {
  std::map<std::vector<std::size_t>, std::size_t> place;
  std::vector<std::vector<std::size_t>> out;
  for (std::size_t i = 0; i < experiment.combinations.size(); ++i) {
    const Combination& combination = experiment.combinations[i];
    std::vector<std::size_t> asked;
    for (const auto& [key, choice] : combination.choice)
      if (key == "surface" || key == "reflectivity" || key == "solution") asked.push_back(choice);
    // Each degree of the interpolant is another surface.
    const std::optional<InterpolatedGeometry>& geometry = combination.problem.geometry;
    const bool is_of_interpolant = geometry && geometry->data == DataPoints::interpolant;
    asked.push_back(is_of_interpolant ? static_cast<std::size_t>(geometry->degree) : 0);
    const auto [found, is_new] = place.emplace(asked, out.size());
    if (is_new) out.emplace_back();
    out[found->second].push_back(i);
  }
  return out;
}

const std::vector<ErrorKind>& error_kinds() {
  static const std::vector<ErrorKind> kinds = {{"discretisation_error", &LevelResult::discretisation_error},
                                               {"node_error", &LevelResult::node_error},
                                               {"uniform_error", &LevelResult::uniform_error},
                                               {"l2_error", &LevelResult::l2_error},
                                               {"mean_error", &LevelResult::mean_error}};
  return kinds;
}

bool is_for_plots(const ErrorKind& kind, std::span<const LevelResult> levels) {
  if (kind.name != "l2_error" && kind.name != "mean_error") return true;
  return std::any_of(levels.begin(), levels.end(), [&](const LevelResult& level) {
    const std::optional<Approximation>& error = level.*kind.figure;
    return error && error->has_radius();
  });
}

const ErrorKind& iterated_kind() {
  static const ErrorKind kind{"iterated_error", &LevelResult::iterated_error};
  return kind;
}

std::vector<CostPoint> error_against_unknowns(const Result& result, const ErrorKind& kind) {
  return error_against(result, kind,
                       [&](std::size_t k) { return static_cast<double>(result.levels[k].unknowns); });
}

std::vector<CostPoint> error_against_seconds(const Result& result, const ErrorKind& kind) {
  return error_against(result, kind, [&](std::size_t k) {
    return result.timing[k].assembly_seconds + result.timing[k].solve_seconds;
  });
}

std::vector<OrderFit> orders_in_unknowns(const Result& result) {
  std::vector<OrderFit> out;
  for (const OrderFit& in_h : result.orders) {
    OrderFit fit = in_h;
    fit.model = "unknowns^-p";
    fit.order = fit.halfwidth = std::nullopt;
    std::vector<CostPoint> points;
    for (const LevelResult& level : result.levels)
      if (std::find(fit.levels.begin(), fit.levels.end(), level.level) != fit.levels.end())
        points.push_back(
            {static_cast<double>(level.unknowns), (level.*kind_named(fit.quantity).figure)->value});
    if (const auto law = power_law(points)) {
      fit.order = -law->exponent;
      fit.halfwidth = law->halfwidth;
    }
    out.push_back(fit);
  }
  return out;
}

}  // namespace radcert
