// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/events/event_edges.h"

#include <algorithm>
#include <map>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"

namespace radcert {
namespace {

std::vector<EventEdge> sides_of(const Scene& scene) {
  std::map<std::pair<std::size_t, std::size_t>, EventEdge> found;
  for (std::size_t t = 0; t < scene.triangle_count(); ++t) {
    const VertexTriple& v = scene.vertices(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [from, to] = std::minmax(v[i], v[(i + 1) % 3]);
      EventEdge& edge = found[{from, to}];
      edge.from = from;
      edge.to = to;
      edge.triangles.push_back(t);
      edge.opposite.push_back(v[(i + 2) % 3]);
    }
  }
  std::vector<EventEdge> edges;
  edges.reserve(found.size());
  for (auto& [vertices, edge] : found) {
    expects(edge.triangles.size() % 2 == 0, "a closed scene", named("from vertex", edge.from),
            named("to vertex", edge.to));
    edges.push_back(std::move(edge));
  }
  return edges;
}

void classify(EventEdge& edge, const Scene& scene, std::span<const std::optional<std::size_t>> source) {
  // Triangles look to the side from which their corners run counterclockwise.
  const auto [a, b, c] = scene.corners(edge.triangles[0]);
  const int side = orientation(a, b, c, scene.vertex(edge.opposite[1]));
  const bool manifold = edge.triangles.size() == 2;
  edge.flat = manifold && side == 0;
  edge.convex = !manifold || side < 0;
  const bool lit = std::any_of(edge.triangles.begin(), edge.triangles.end(),
                               [&](std::size_t t) { return source[t].has_value(); });
  const bool one_source = std::all_of(edge.triangles.begin(), edge.triangles.end(),
                                      [&](std::size_t t) { return source[t] == source[edge.triangles[0]]; });
  edge.source = lit && !(edge.flat && one_source);
}

}  // namespace

EventEdges::EventEdges(const Scene& scene, std::span<const std::optional<std::size_t>> source)
    : edges(sides_of(scene)), triangles_at(scene.mesh().vertices.size()) {
  for (std::size_t t = 0; t < scene.triangle_count(); ++t)
    for (const std::size_t v : scene.vertices(t)) triangles_at[v].push_back(t);
  std::vector<std::vector<std::size_t>> neighbours(triangles_at.size());
  for (EventEdge& edge : edges) {
    classify(edge, scene, source);
    if (!counts(edge)) continue;
    neighbours[edge.from].push_back(edge.to);
    neighbours[edge.to].push_back(edge.from);
  }
  for (std::size_t v = 0; v < neighbours.size(); ++v) {
    const std::vector<std::size_t>& ends = neighbours[v];
    const bool straight =
        ends.size() == 2 && collinear(scene.vertex(v), scene.vertex(ends[0]), scene.vertex(ends[1]));
    if (!ends.empty() && !straight) corners.push_back(v);
  }
}

}  // namespace radcert
