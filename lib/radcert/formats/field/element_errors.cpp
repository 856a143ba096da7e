// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/field/element_errors.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "radcert/expression/batch.h"

namespace radcert {

namespace {

/// |u - v| at the corners, v as `values` has it of an element.
template <class Values>
std::optional<CornerErrors> errors_of(const Problem& problem, std::span<const ElementValue> elements,
                                      const Values& values) {
  if (!problem.solution) return std::nullopt;
  std::map<std::string, CompiledExpression> by_piece;
  CornerErrors out;
  for (const ElementValue& element : elements) {
    const auto [u, is_new] =
        by_piece.try_emplace(element.piece, CompiledExpression(problem.solution->on(element.piece)));
    std::array<double, 3> errors{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<double>& at = element.corners[i];
      errors[i] = std::abs(u->second.at(at.x, at.y, at.z) - values(element)[i]);
      if (!std::isfinite(errors[i])) return std::nullopt;
    }
    out.push_back(errors);
  }
  return out;
}

}  // namespace

std::optional<CornerErrors> corner_errors(const Problem& problem, std::span<const ElementValue> elements) {
  return errors_of(
      problem, elements, [](const ElementValue& element) -> auto& { return element.corner_values; });
}

std::optional<CornerErrors> iterated_corner_errors(const Problem& problem,
                                                   std::span<const ElementValue> elements) {
  if (std::any_of(elements.begin(), elements.end(),
                  [](const ElementValue& element) { return !element.iterated; }))
    return std::nullopt;
  return errors_of(
      problem, elements, [](const ElementValue& element) -> auto& { return *element.iterated; });
}

std::vector<std::string> pieces_of(std::span<const ElementValue> elements) {
  std::vector<std::string> names;
  for (const ElementValue& element : elements)
    if (std::find(names.begin(), names.end(), element.piece) == names.end()) names.push_back(element.piece);
  return names;
}

}  // namespace radcert
