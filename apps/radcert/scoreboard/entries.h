// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/formats/json/json_value.h"
#include "radcert/study/errors/scoreboard.h"
#include "radcert/study/problem.h"

namespace radcert::app {

/// A method of the scoreboard: what it adds to a problem.
struct BoardMethod {
  std::string name;
  std::string keys = {};      ///< of a problem, as JSON: its basis, and what else makes it
  std::string basis = {};     ///< of a meshless method in their place: its basis without sites, as JSON
  std::string grading = "1";  ///< of the triangulation
  /// The levels are those of the problem for linear functions, from `first` on and with `more` at the end
  int first = 0;
  int more = 0;
  bool meshless = false;  ///< its sites are as far apart as the scene says
  /// Its iterated solution, under this name, is a method of its own
  std::optional<std::string> iterated = std::nullopt;
};

/// A problem of the scoreboard, without a method.
struct BoardScene {
  std::string name;
  std::string words;
  std::string truth;
  std::string keys;  ///< of a problem, as JSON: surface, unless a mesh is given, and data
  std::optional<SurfaceChoice> mesh = std::nullopt;
  int finest = 2;                ///< level for linear functions
  std::string separation = "1";  ///< of meshless sites at level 0, halved from level to level
  /// The scene of reference::continuous_scenes() whose means are the truth, and the pieces that these means
  /// are of, by their names
  std::string enclosed = {};
  std::vector<std::pair<std::string, std::string>> means = {};
};

/// All methods: a further one is one further line.
[[nodiscard]] std::span<const BoardMethod> board_methods();
/// All problems.
[[nodiscard]] std::vector<BoardScene> board_scenes();

/// The problem of a scene for a method.
/// Result    InputError, as problem_of and check say, where the method cannot serve the scene
[[nodiscard]] Problem board_problem(const BoardScene& scene, const BoardMethod& method);

}  // namespace radcert::app
