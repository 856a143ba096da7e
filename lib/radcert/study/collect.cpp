// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>

#include "radcert/core/contract.h"
#include "radcert/study/efficiency.h"
#include "radcert/study/errors/error_order.h"
#include "radcert/study/study.h"

namespace radcert {
namespace {

/// What a fit is of: a member of a level, or a function of one.
using Figure = std::function<std::optional<Approximation>(const LevelResult& level)>;

std::optional<Approximation> u_n_error(const LevelResult& level) {
  return level.iterated ? level.iterated->u_n_error : std::nullopt;
}

/// The power law through the levels whose figures are trustworthy, from `fit_from` on, else from where the
/// slopes are steady. Two levels meet every power law: no spread.
OrderFit fit(const std::string& quantity, const Figure& figure, const std::vector<LevelResult>& levels,
             std::optional<int> fit_from) {
  OrderFit result{.quantity = quantity, .order = {}, .halfwidth = {}, .levels = {}, .left_out = {}};
  std::vector<CostPoint> points;
  for (const LevelResult& level : levels) {
    const std::optional<Approximation> e = figure(level);
    if (!e) continue;
    if (!stands_above_radius(*e)) {
      result.left_out.push_back(level.level);
    } else if (fit_from && level.level < *fit_from) {
      result.pre_asymptotic.push_back(level.level);
    } else {
      result.levels.push_back(level.level);
      points.push_back({.cost = level.mesh_size, .error = e->value});
    }
  }
  const AsymptoticLaw found =
      fit_from ? AsymptoticLaw{.from = 0, .law = power_law(points)} : asymptotic_law(points);
  const auto first = result.levels.begin() + static_cast<std::ptrdiff_t>(found.from);
  result.pre_asymptotic.insert(result.pre_asymptotic.end(), result.levels.begin(), first);
  result.levels.erase(result.levels.begin(), first);
  if (found.law) {
    result.order = found.law->exponent;
    result.halfwidth = found.law->halfwidth;
  }
  return result;
}

}  // namespace

Result collect(const Problem& problem, std::vector<LevelResult> levels, std::vector<LevelTiming> timing) {
  for (std::size_t k = 0; k < levels.size(); ++k) {
    LevelResult& now = levels[k];
    if (now.iterated)
      now.iterated->ratio = now.iterated->u_n_ratio = now.iterated->order = now.iterated->u_n_order =
          std::nullopt;
    now.discretisation_ratio = now.node_ratio = now.discretisation_order = now.node_order = std::nullopt;
    if (k == 0) continue;
    const LevelResult& before = levels[k - 1];
    expects(before.level < now.level, "levels in ascending order", named("level", now.level));
    const auto order = [&](const std::optional<Approximation>& coarser,
                           const std::optional<Approximation>& finer) {
      return error_order(coarser, before.mesh_size, finer, now.mesh_size);
    };
    now.discretisation_ratio = error_ratio(before.discretisation_error, now.discretisation_error);
    now.node_ratio = error_ratio(before.node_error, now.node_error);
    now.discretisation_order = order(before.discretisation_error, now.discretisation_error);
    now.node_order = order(before.node_error, now.node_error);
    if (!now.iterated) continue;
    IteratedReport& of_iterated = *now.iterated;
    of_iterated.ratio = error_ratio(before.iterated_error, now.iterated_error);
    of_iterated.u_n_ratio = error_ratio(u_n_error(before), of_iterated.u_n_error);
    of_iterated.order = order(before.iterated_error, now.iterated_error);
    of_iterated.u_n_order = order(u_n_error(before), of_iterated.u_n_error);
  }
  Result result{.problem = problem, .levels = std::move(levels), .orders = {}, .timing = std::move(timing)};
  if (problem.solution) {
    const std::optional<int>& from = problem.fit_from;
    result.orders.push_back(
        fit("discretisation_error", &LevelResult::discretisation_error, result.levels, from));
    result.orders.push_back(fit("node_error", &LevelResult::node_error, result.levels, from));
    if (std::holds_alternative<Galerkin>(problem.method)) {
      result.orders.push_back(fit("l2_error", &LevelResult::l2_error, result.levels, from));
      result.orders.push_back(fit("mean_error", &LevelResult::mean_error, result.levels, from));
    }
    if (problem.iterated) {
      result.orders.push_back(fit("iterated_error", &LevelResult::iterated_error, result.levels, from));
      result.orders.push_back(fit("u_n_error", u_n_error, result.levels, from));
    }
  }
  return result;
}

}  // namespace radcert
