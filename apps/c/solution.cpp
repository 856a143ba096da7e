// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests/solve_request.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "c/call.h"
#include "radcert/core/errors.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/result/result_json.h"

namespace radcert::c {

namespace {

/// The nodes of a level as arrays. They point into the level, which outlives them.
struct NodeArrays {
  explicit NodeArrays(const LevelOutcome& level) {
    bool has_u = true;
    for (const NodeValue& node : level.nodes) {
      points.insert(points.end(), {node.point.x, node.point.y, node.point.z});
      normals.insert(normals.end(), {node.normal.x, node.normal.y, node.normal.z});
      value.push_back(node.u_n.value);
      radius.push_back(node.u_n.radius);
      guaranteed.push_back(node.u_n.guaranteed ? 1 : 0);
      emission.push_back(node.emission);
      has_u = has_u && node.u.has_value();
      solution.push_back(node.u.value_or(0));
      pieces.push_back(node.piece.c_str());
      elements.push_back(static_cast<std::int64_t>(node.element));
    }
    shown = {.level = level.result.level,
             .count = level.nodes.size(),
             .points = points.data(),
             .normals = normals.data(),
             .value = value.data(),
             .radius = radius.data(),
             .guaranteed = guaranteed.data(),
             .emission = emission.data(),
             .solution = has_u ? solution.data() : nullptr,
             .pieces = pieces.data(),
             .elements = elements.data()};
  }
  NodeArrays(const NodeArrays&) = delete;
  NodeArrays& operator=(const NodeArrays&) = delete;

  std::vector<double> points, normals, value, radius, emission, solution;
  std::vector<std::uint8_t> guaranteed;
  std::vector<const char*> pieces;
  std::vector<std::int64_t> elements;
  radcert_nodes shown{};
};

}  // namespace

}  // namespace radcert::c

/// A solution with what is read from it.
struct radcert_solution {
  explicit radcert_solution(radcert::app::Solution found)
      : solution(std::move(found)), json(radcert::result_text(solution.result, "radcert_solve")) {
    for (const radcert::LevelOutcome& level : solution.levels) nodes.emplace_back(level);
  }
  radcert_solution(const radcert_solution&) = delete;
  radcert_solution& operator=(const radcert_solution&) = delete;

  radcert::app::Solution solution;
  std::string json;
  std::deque<radcert::c::NodeArrays> nodes;
};

extern "C" {

radcert_status radcert_solve(const char* problem, const char* name, const radcert_run* run,
                             radcert_solution** solution) {
  using namespace radcert;
  return c::guarded([&] {
    c::given(solution, "solution");
    const std::string text = c::text_at(problem, "problem");
    const std::string source = c::text_or(name, "problem");
    const c::Run how(run);
    std::unique_ptr<radcert_solution> made;
    c::compute(how, [&](app::Progress& told) {
      made = std::make_unique<radcert_solution>(
          app::solved(parse_problem(text, source), source, how.store, told));
    });
    *solution = made.release();
  });
}

radcert_status radcert_solution_json(const radcert_solution* solution, const char** text) {
  using namespace radcert;
  return c::guarded([&] { c::given(text, "text") = c::given(solution, "solution").json.c_str(); });
}

radcert_status radcert_solution_level_count(const radcert_solution* solution, size_t* count) {
  using namespace radcert;
  return c::guarded([&] { c::given(count, "count") = c::given(solution, "solution").nodes.size(); });
}

radcert_status radcert_solution_nodes(const radcert_solution* solution, size_t place,
                                      const radcert_nodes** nodes) {
  using namespace radcert;
  return c::guarded([&] {
    c::given(nodes, "nodes");
    const auto& levels = c::given(solution, "solution").nodes;
    if (place >= levels.size())
      throw InputError({.pointer = "place",
                        .value = std::to_string(place),
                        .problem = "is outside the range",
                        .allowed = "a whole number from 0 to " + std::to_string(levels.size() - 1)});
    *nodes = &levels[place].shown;
  });
}

void radcert_solution_free(radcert_solution* solution) { delete solution; }
}
