// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/unoccluded_factor.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "radcert/factors/exchange_area.h"

namespace radcert {

UnoccludedFactor unoccluded_factor(const FacetScene& scene, const FactorUnits& units) {
  auto members = std::make_shared<std::vector<std::vector<std::size_t>>>(units.names.size());
  for (std::size_t t = 0; t < units.of_triangle.size(); ++t) (*members)[units.of_triangle[t]].push_back(t);
  constexpr std::size_t most_pairs = 200'000;  // of triangles, in all
  auto left = std::make_shared<std::size_t>(most_pairs);
  return [&scene, members, left](std::size_t from, std::size_t to) -> std::optional<double> {
    const auto& mine = (*members)[from];
    const auto& others = (*members)[to];
    if (mine.size() * others.size() > *left) return std::nullopt;
    *left -= mine.size() * others.size();
    double sum = 0;
    double area = 0;
    for (const std::size_t i : mine) {
      area += scene.area(i);
      for (const std::size_t j : others) {
        const FacetPair pair = scene.pair(i, j);
        if (pair.sight != PairSight::nothing) sum += exchange_area(pair.first, pair.second).value;
      }
    }
    return sum / area;
  };
}

}  // namespace radcert
