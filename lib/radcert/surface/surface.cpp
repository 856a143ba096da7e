// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/surface.h"

#include <algorithm>
#include <optional>

#include "radcert/core/contract.h"

namespace radcert {

std::vector<std::string> Surface::piece_names() const {
  std::vector<std::string> names;
  for (const Chart& chart : charts)
    if (std::find(names.begin(), names.end(), chart.facts().piece) == names.end())
      names.push_back(chart.facts().piece);
  return names;
}

std::size_t Surface::piece_of(std::size_t chart) const {
  expects(chart < charts.size(), "a chart of the surface", named("chart", chart));
  const std::vector<std::string> names = piece_names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), charts[chart].facts().piece) -
                                  names.begin());
}

bool in_one_plane(const Chart& a, const Chart& b) {
  const std::optional<Plane>& first = a.facts().flat_in();
  const std::optional<Plane>& second = b.facts().flat_in();
  return first && second && same_plane(*first, *second);
}

}  // namespace radcert
