// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/named_problems.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/polynomial/inset_basis.h"
#include "verification/framework/level_errors.h"
#include "verification/framework/reading/embedded.h"

namespace radcert::verification::m06 {

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

std::vector<int> levels_of_an_order(const Problem& problem, Budget budget) {
  return levels_from(1, budget == Budget::quick ? 3 : problem.triangulation.levels.back());
}

TriangleBasis<double> chosen_nodes(int r) {
  if (r == 0) return {InsetBasis<double>(0, 0)};
  if (r == 1) return {InsetBasis<double>(1, 1.0 / 6)};
  if (r == 3) return {InsetBasis<double>(3, (7 - std::sqrt(34.0)) / 15)};
  return nodes_at_a_tenth(r);
}

TriangleBasis<double> nodes_at_a_tenth(int r) { return {InsetBasis<double>(r, 0.1)}; }

}  // namespace radcert::verification::m06
