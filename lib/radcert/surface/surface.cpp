// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/surface.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "radcert/core/contract.h"
#include "radcert/surface/chart_pieces.h"

namespace radcert {

std::vector<std::string> Surface::piece_names() const {
  std::vector<std::string> names;
  std::unordered_set<std::string_view> known;
  for (const Chart& chart : charts)
    if (known.insert(chart.facts().piece).second) names.push_back(chart.facts().piece);
  return names;
}

std::size_t Surface::piece_of(std::size_t chart) const {
  expects(chart < charts.size(), "a chart of the surface", named("chart", chart));
  const std::vector<std::string> names = piece_names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), charts[chart].facts().piece) -
                                  names.begin());
}

std::vector<std::size_t> chart_pieces(const Surface& surface) {
  std::unordered_map<std::string_view, std::size_t> places;
  std::vector<std::size_t> out;
  for (const Chart& chart : surface.charts)
    out.push_back(places.try_emplace(chart.facts().piece, places.size()).first->second);
  return out;
}

bool in_one_plane(const Chart& a, const Chart& b) {
  const std::optional<Plane>& first = a.facts().flat_in();
  const std::optional<Plane>& second = b.facts().flat_in();
  return first && second && same_plane(*first, *second);
}

}  // namespace radcert
