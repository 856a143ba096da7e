// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/rates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/formats/problem/problem_json.h"
#include "verification/framework/embedded.h"

namespace radcert::verification::m06 {
namespace {

template <class Error>
Errors over_levels(const Problem& problem, const std::vector<int>& levels, const Bench& bench,
                   const Error& error) {
  Errors errors;
  for (const int level : levels) {
    const LevelOutcome outcome = bench.levels.level(problem, level);
    errors.mesh_sizes.push_back(outcome.result.mesh_size);
    errors.errors.push_back(error(outcome));
  }
  return errors;
}

}  // namespace

Problem problem_named(const std::string& name) {
  const std::string path = "m06/problems/" + name + ".json";
  const auto files = embedded_papers();
  const auto file =
      std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& f) { return f.path == path; });
  expects(file != files.end(), "a problem of papers/m06/problems", named("name", name));
  return parse_problem(file->content, path);
}

std::vector<int> levels_for(const Problem& problem, Budget budget, int fewer) {
  std::vector<int> levels = problem.triangulation.levels;
  const std::size_t left_out = static_cast<std::size_t>(fewer) + (budget == Budget::quick ? 1 : 0);
  expects(left_out + 2 <= levels.size(), "two levels at least", named("left_out", left_out));
  levels.resize(levels.size() - left_out);
  return levels;
}

Errors node_errors(const Problem& problem, const std::vector<int>& levels, const Bench& bench,
                   const NodeChoice& choice) {
  return over_levels(problem, levels, bench, [&](const LevelOutcome& level) {
    Approximation error = as_sampled(level.result.node_error.value());
    if (!choice) return error;
    error.value = 0;
    for (const NodeValue& node : level.nodes)
      if (choice(node)) error.value = std::max(error.value, std::abs(node.u.value() - node.u_n.value));
    return error;
  });
}

Errors uniform_errors(const Problem& problem, const std::vector<int>& levels, const Bench& bench) {
  return over_levels(problem, levels, bench, [](const LevelOutcome& level) {
    return as_sampled(level.result.uniform_error.value());
  });
}

Errors discretisation_errors(const Problem& problem, const std::vector<int>& levels, const Bench& bench) {
  return over_levels(problem, levels, bench, [](const LevelOutcome& level) {
    return as_sampled(level.result.discretisation_error.value());
  });
}

Approximation order_at(const Errors& errors, std::size_t k) {
  const Approximation& before = errors.errors.at(k - 1);
  const Approximation& after = errors.errors.at(k);
  const double steps = std::log(errors.mesh_sizes.at(k - 1) / errors.mesh_sizes.at(k));
  if (!(before.value > before.radius && after.value > after.radius))
    return {.value = 0, .radius = std::numeric_limits<double>::infinity()};
  const double spread = std::log((1 + before.radius / before.value) / (1 - after.radius / after.value));
  return {.value = std::log(before.value / after.value) / steps, .radius = spread / steps};
}

Approximation last_order(const Errors& errors) { return order_at(errors, errors.errors.size() - 1); }

Approximation noise(const Errors& errors) {
  const Approximation& last = errors.errors.back();
  return {.value = last.radius / last.value, .radius = 0};
}

}  // namespace radcert::verification::m06
