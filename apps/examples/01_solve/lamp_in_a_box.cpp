// SPDX-License-Identifier: GPL-3.0-or-later

// A program of one's own: how much light reaches the floor of a room whose ceiling shines, and what the paint
// of the walls does to it. The problem is the one of 2_lamp_in_a_box.json, its walls repainted by the
// program.
#include <exception>
#include <iostream>
#include <span>
#include <string>

#include "radcert/formats/problem/problem_json.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"

namespace {

using namespace radcert;

constexpr int level = 1;

Problem room(const std::string& walls) {
  return parse_problem(R"({
      "schema": "radcert/problem/1",
      "surface": {"name": "box", "a": 4, "b": 3, "c": "5/2"},
      "triangulation": {"levels": [1]},
      "basis": {"family": "inset", "degree": 0},
      "reflectivity": {"floor": "0.3", "ceiling": "0.8", "*": ")" +
                           walls + R"("},
      "emission": {"ceiling": "1", "*": "0"}})",
                       "room");
}

double mean_on(const LevelResult& result, const std::string& name) {
  for (const auto& [piece, mean] : result.piece_means)
    if (piece == name) return mean.value;
  return 0;
}

}  // namespace

int main() try {
  for (const std::string walls : {"1/10", "1/2", "9/10"}) {
    const Problem problem = room(walls);
    check(problem, std::uint64_t{1} << 30);
    const LevelOutcome outcome = solve_level(problem, level, reference::applied_operator);
    std::cout << "walls of reflectivity " << walls << ": mean radiosity of the floor "
              << mean_on(outcome.result, "floor") << '\n';
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
