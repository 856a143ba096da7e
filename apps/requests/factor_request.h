// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/factors/input/factor_scene.h"
#include "radcert/formats/result/factors_json.h"
#include "requests/work.h"

namespace radcert::app {

/// What is asked for of a scene's factors, in the words of users.
struct FactorWish {
  std::string by = "group";  ///< "triangle", "piece" or "group": what a row stands for
  std::optional<double> accuracy = std::nullopt;
  bool certified = false;
  bool rays = false;
  std::optional<std::string> unit = std::nullopt;  ///< of lengths, for reports
};

/// A matrix with the scene that it is of.
struct Factors {
  std::shared_ptr<const FactorScene> scene;
  FactorUnits units;
  FactorReport report;
  std::vector<std::string> failures;

  [[nodiscard]] std::size_t count() const { return units.names.size(); }
};

/// The wish as it can be fulfilled.
/// Result    returns, or throws InputError at the word that is not allowed
void check(const FactorWish& wish, bool two_sided);

/// The factors of a scene.
/// Requires  a checked wish; `command` and `name` stand in reports; a store as store_named has it
/// Result    as factor_matrix and ray_factors, with what is odd about them in words
[[nodiscard]] Factors factors_of(FactorScene scene, const std::string& command, const std::string& name,
                                 const FactorWish& wish, const std::string& store, Progress& progress);

/// Where light is, by its word.
/// Result    InputError at `front` for a word that is none of front_words
[[nodiscard]] FrontRule front_named(std::string_view word);

/// The unit of lengths, or nothing where the word is empty.
/// Result    InputError at `source` for a word that is none
[[nodiscard]] std::optional<std::string> unit_of_lengths(const std::string& word, const std::string& source);

}  // namespace radcert::app
