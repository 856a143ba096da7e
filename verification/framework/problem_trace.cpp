// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/problem_trace.h"

#include <algorithm>
#include <utility>

#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/formats/problem/problem_words.h"

namespace radcert::verification {
namespace {

std::string parameters_text(const SurfaceChoice& surface) {
  std::string out;
  for (const SurfaceParameter& parameter : surface.parameters)
    out += (out.empty() ? "" : "; ") + parameter.name + " = " + parameter.value.to_text();
  return out.empty() ? "" : " (" + out + ")";
}

std::string method_text(const Method& method) {
  const TriangleBasisChoice* triangles = find_triangle_basis(method);
  if (triangles == nullptr) {
    std::string out;
    for (const std::string& word : method_words(method)) out += (out.empty() ? "" : "; ") + word;
    return out;
  }
  const TriangleBasisChoice& basis = *triangles;
  switch (basis.family) {
    case NodeFamily::file: return "nodes of " + basis.file;
    case NodeFamily::symmetric: return "symmetric nodes of degree " + std::to_string(basis.degree);
    case NodeFamily::inset: break;
  }
  std::string out = "degree " + std::to_string(basis.degree);
  if (basis.alpha && basis.degree > 0)
    out += "; alpha " + (basis.alpha_is_near ? "= alpha_0" : "= " + basis.alpha->to_text());
  return out;
}

}  // namespace

std::string problem_title(const Problem& problem) {
  std::string out =
      problem.surface.name + parameters_text(problem.surface) + "; " + method_text(problem.method);
  if (problem.geometry) out += "; interpolated of degree " + std::to_string(problem.geometry->degree);
  if (problem.triangulation.grading != Rational(1))
    out += "; grading " + problem.triangulation.grading.to_text();
  const auto& data = problem.solution ? problem.solution : problem.emission;
  if (data && data->cases.size() == 1)
    out += (problem.solution ? "; u = " : "; E = ") + data->cases.front().expression.text();
  if (problem.reflectivity.cases.size() == 1)
    out += "; rho = " + problem.reflectivity.cases.front().expression.text();
  return out;
}

LevelOutcome RecordedLevels::level(const Problem& problem, int level) {
  LevelOutcome outcome = source_->level(problem, level);
  asked_.push_back({.problem = problem, .level = level});
  const std::size_t index = index_of(problem);
  if (std::find(used_.begin(), used_.end(), index) == used_.end()) used_.push_back(index);
  ProblemTrace& trace = problems_[index];
  const auto place = std::lower_bound(trace.levels.begin(), trace.levels.end(), level,
                                      [](const LevelResult& a, int b) { return a.level < b; });
  if (place == trace.levels.end()) trace.problem.solver = problem.solver;
  if (place != trace.levels.end() && place->level == level) {
    if (outcome.result.verified && !place->verified) *place = outcome.result;
    return outcome;
  }
  trace.levels.insert(place, outcome.result);
  draw(trace, outcome);
  return outcome;
}

std::vector<ProblemTrace> RecordedLevels::problems() const {
  std::vector<ProblemTrace> finished = problems_;
  for (ProblemTrace& trace : finished) {
    trace.problem.triangulation.levels.clear();
    for (const LevelResult& level : trace.levels) trace.problem.triangulation.levels.push_back(level.level);
    trace.text = problem_text(trace.problem);
    trace.orders = collect(trace.problem, trace.levels, std::vector<LevelTiming>(trace.levels.size())).orders;
  }
  return finished;
}

// A problem is the same whichever of its levels are asked for, and by whichever solver.
std::size_t RecordedLevels::index_of(const Problem& problem) {
  Problem same = problem;
  same.triangulation.levels = {0};
  same.solver = {};
  same.label.clear();
  same.fit_from.reset();
  std::string text = problem_text(same);
  const auto known = std::find_if(problems_.begin(), problems_.end(),
                                  [&](const ProblemTrace& trace) { return trace.text == text; });
  if (known != problems_.end()) return static_cast<std::size_t>(known - problems_.begin());
  problems_.push_back({.problem = problem,
                       .name = problem_title(problem),
                       .text = std::move(text),
                       .levels = {},
                       .orders = {},
                       .elements = {},
                       .nodes = {}});
  return problems_.size() - 1;
}

void RecordedLevels::draw(ProblemTrace& trace, const LevelOutcome& outcome) {
  const std::size_t held = trace.elements.size();
  const std::size_t offered = outcome.elements.size();
  const bool first = held == 0;
  const bool finer = offered > held && offered <= most_drawn;
  const bool coarser = offered < held && held > most_drawn;
  if (offered == 0 || !(first || finer || coarser)) return;
  trace.drawn_level = outcome.result.level;
  trace.elements = outcome.elements;
  trace.nodes = outcome.nodes;
}

}  // namespace radcert::verification
