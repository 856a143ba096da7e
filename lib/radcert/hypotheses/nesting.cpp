// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/nesting.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "radcert/geometry/winding/ray_crossings.h"

namespace radcert {
namespace {

std::vector<std::vector<std::size_t>> triangles_of(const MeshTopology& topology) {
  std::vector<std::vector<std::size_t>> components(topology.component_count);
  for (std::size_t t = 0; t < topology.component.size(); ++t)
    if (topology.component[t] < components.size()) components[topology.component[t]].push_back(t);
  return components;
}

/// What a ray passes through that leaves one of these triangles, by the first that does not lie on others.
std::optional<std::vector<RayCrossing>> beside(const RayCrossings& rays,
                                               const std::vector<std::size_t>& triangles, int side) {
  for (const std::size_t t : triangles)
    if (auto crossings = rays.from_side(t, side)) return crossings;
  return std::nullopt;
}

const std::string undecided =
    "has a component that lies on another, so that it is not known which of them holds the other";

}  // namespace

Outcome<std::vector<std::size_t>> misoriented_components(const TriangleMesh& mesh,
                                                         const MeshTopology& topology,
                                                         Orientation orientation, LightOf light) {
  const int outwards = orientation == Orientation::against_the_cross_product ? 1 : -1;
  const RayCrossings rays(mesh);
  std::vector<std::size_t> faulty;
  for (const std::vector<std::size_t>& own : triangles_of(topology)) {
    const auto crossings = beside(rays, own, -outwards);
    if (!crossings) return because(undecided);
    if (outwards * winding_number(*crossings) != (light == LightOf::rooms ? 1 : 0))
      faulty.push_back(own.front());
  }
  std::sort(faulty.begin(), faulty.end());
  return faulty;
}

Outcome<std::size_t> outermost_components(const TriangleMesh& mesh, const MeshTopology& topology) {
  const RayCrossings rays(mesh);
  std::size_t count = 0;
  for (const std::vector<std::size_t>& own : triangles_of(topology)) {
    const auto crossings = beside(rays, own, 1);
    if (!crossings) return because(undecided);
    std::map<std::size_t, long> about;  // how often each other component winds about the point
    for (const auto& [triangle, side] : *crossings)
      if (const std::size_t other = topology.component[triangle]; other != topology.component[own.front()])
        about[other] += side;
    if (std::all_of(about.begin(), about.end(), [](const auto& other) { return other.second == 0; })) ++count;
  }
  return count;
}

}  // namespace radcert
