// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/scalar/ball.h"

/// Each limit of work at its smallest value: a small computation that reaches it still tells nothing false.
namespace radcert::limits {

/// What a computation told.
struct Answer {
  std::vector<Ball> numbers{};  ///< each with its radius; none: refused
  std::string verdict{};        ///< empty: undecided, or none asked for
  std::string note{};           ///< how it went; what is neither true nor false

  [[nodiscard]] bool tells_nothing() const { return numbers.empty() && verdict.empty(); }
};

/// A computation that reaches a limit.
struct Case {
  std::string limit;  ///< its name
  std::function<Answer()> answer;
  /// The truth by other means; without it the answer at the usual value stands for it.
  std::function<std::vector<Ball>()> truth = [] { return std::vector<Ball>(); };
  std::string about{};   ///< where a limit has several
  bool is_long = false;  ///< at the smallest value alone
};

/// A number with its radius; infinite: the whole line.
inline Ball number(double value, double radius) {
  if (!std::isfinite(value) || !std::isfinite(radius)) return Ball::failed("a radius without bound");
  return widened(Ball(value), Ball(radius));
}

inline Answer numbers(std::vector<Ball> balls, std::string note = {}) {
  return {.numbers = std::move(balls), .verdict = {}, .note = std::move(note)};
}
inline Answer verdict(std::string words, std::string note = {}) {
  return {.numbers = {}, .verdict = std::move(words), .note = std::move(note)};
}
inline Answer refusal(std::string why) { return {.numbers = {}, .verdict = {}, .note = std::move(why)}; }

std::vector<Case> formula_cases();  ///< scalar, polynomial, geometry, surface
std::vector<Case> certificate_cases();
std::vector<Case> continuous_cases();
std::vector<Case> enclosure_cases();  ///< enclosure, hypotheses
std::vector<Case> galerkin_cases();
std::vector<Case> meshless_cases();
std::vector<Case> polygon_cases();  ///< closed_form, factors
std::vector<Case> reference_cases();
std::vector<Case> system_cases();  ///< quadrature, collocation, solve, study

}  // namespace radcert::limits
