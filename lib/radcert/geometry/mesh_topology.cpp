// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "radcert/geometry/orientation.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

bool is_left_out(const VertexTriple& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

struct RawSide {
  std::size_t from;
  std::size_t to;
  TriangleSide side;
};

void find_edges(const TriangleMesh& mesh, MeshTopology& topology) {
  std::vector<RawSide> raw;
  raw.reserve(3 * mesh.triangles.size());
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const VertexTriple& t = mesh.triangles[k];
    if (is_left_out(t)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = t[i];
      const std::size_t b = t[(i + 1) % 3];
      raw.push_back({std::min(a, b), std::max(a, b), {k, i, a < b}});
    }
  }
  std::sort(raw.begin(), raw.end(), [](const RawSide& a, const RawSide& b) {
    return std::tie(a.from, a.to, a.side.triangle, a.side.side) <
           std::tie(b.from, b.to, b.side.triangle, b.side.side);
  });
  constexpr std::size_t none = MeshTopology::no_edge;
  topology.edge_of_side.assign(mesh.triangles.size(), {none, none, none});
  for (const RawSide& side : raw) {
    std::vector<MeshEdge>& edges = topology.edges;
    if (edges.empty() || edges.back().from != side.from || edges.back().to != side.to)
      edges.push_back({side.from, side.to, topology.sides.size(), topology.sides.size()});
    topology.sides.push_back(side.side);
    edges.back().end = topology.sides.size();
    topology.edge_of_side[side.side.triangle][side.side.side] = edges.size() - 1;
  }
}

/// Gives each component a sense of rotation, and finds who disagrees with it.
void orient(const TriangleMesh& mesh, MeshTopology& topology) {
  const std::size_t count = mesh.triangles.size();
  constexpr std::size_t none = MeshTopology::no_edge;
  topology.component.assign(count, none);
  std::vector<char> turned(count, 0);
  std::vector<std::size_t> members;
  for (std::size_t start = 0; start < count; ++start) {
    if (topology.component[start] != none || is_left_out(mesh.triangles[start])) continue;
    members.assign(1, start);
    topology.component[start] = topology.component_count;
    for (std::size_t next = 0; next < members.size(); ++next) {
      const std::size_t here = members[next];
      for (const std::size_t e : topology.edge_of_side[here]) {
        const MeshEdge& edge = topology.edges[e];
        if (edge.side_count() != 2) continue;
        const TriangleSide& first = topology.sides[edge.begin];
        const TriangleSide& second = topology.sides[edge.begin + 1];
        const std::size_t there = first.triangle == here ? second.triangle : first.triangle;
        const char wanted = static_cast<char>(turned[here] ^ (first.forward == second.forward ? 1 : 0));
        if (topology.component[there] == none) {
          topology.component[there] = topology.component_count;
          turned[there] = wanted;
          members.push_back(there);
        } else if (turned[there] != wanted && !topology.crooked_edge) {
          topology.crooked_edge = e;
        }
      }
    }
    ++topology.component_count;
    const auto against = static_cast<std::size_t>(
        std::count_if(members.begin(), members.end(), [&](std::size_t t) { return turned[t] != 0; }));
    const char minority = 2 * against > members.size() ? 0 : 1;
    for (const std::size_t t : members)
      if (turned[t] == minority) topology.turned.push_back(t);
  }
  std::sort(topology.turned.begin(), topology.turned.end());
}

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Vertices around which the corners fall into several fans.
void find_pinched(const TriangleMesh& mesh, MeshTopology& topology) {
  std::vector<std::size_t> parent(3 * mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto corner_at = [&](std::size_t triangle, std::size_t vertex) {
    const VertexTriple& t = mesh.triangles[triangle];
    return 3 * triangle + (t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2);
  };
  for (const MeshEdge& edge : topology.edges) {
    if (edge.side_count() != 2) continue;
    for (const std::size_t vertex : {edge.from, edge.to}) {
      const std::size_t a = root_of(parent, corner_at(topology.sides[edge.begin].triangle, vertex));
      const std::size_t b = root_of(parent, corner_at(topology.sides[edge.begin + 1].triangle, vertex));
      parent[a] = b;
    }
  }
  std::vector<std::size_t> fans(mesh.vertices.size(), 0);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    if (is_left_out(mesh.triangles[k])) continue;
    for (std::size_t i = 0; i < 3; ++i)
      if (root_of(parent, 3 * k + i) == 3 * k + i) ++fans[mesh.triangles[k][i]];
  }
  for (std::size_t v = 0; v < fans.size(); ++v) {
    if (fans[v] > 0) ++topology.used_vertices;
    if (fans[v] > 1) topology.pinched_vertices.push_back(v);
  }
}

/// The open edges, one after the other.
void find_open_loops(MeshTopology& topology) {
  std::vector<std::pair<std::size_t, std::size_t>> ends;  // vertex, place among the open edges
  for (std::size_t i = 0; i < topology.open_edges.size(); ++i) {
    const MeshEdge& edge = topology.edges[topology.open_edges[i]];
    ends.emplace_back(edge.from, i);
    ends.emplace_back(edge.to, i);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<char> walked(topology.open_edges.size(), 0);
  for (std::size_t start = 0; start < walked.size(); ++start) {
    if (walked[start]) continue;
    walked[start] = 1;
    const MeshEdge& first = topology.edges[topology.open_edges[start]];
    const bool forward = topology.sides[first.begin].forward;
    std::vector<std::size_t> line{forward ? first.from : first.to, forward ? first.to : first.from};
    for (bool further = true; further && line.back() != line.front();) {
      further = false;
      for (auto at = std::lower_bound(ends.begin(), ends.end(), std::pair(line.back(), std::size_t{0}));
           at != ends.end() && at->first == line.back(); ++at) {
        if (walked[at->second]) continue;
        walked[at->second] = 1;
        const MeshEdge& edge = topology.edges[topology.open_edges[at->second]];
        line.push_back(edge.from == line.back() ? edge.to : edge.from);
        further = true;
        break;
      }
    }
    if (line.back() == line.front()) line.pop_back();
    topology.open_loops.push_back(std::move(line));
  }
}

}  // namespace

MeshTopology mesh_topology(const TriangleMesh& mesh) {
  MeshTopology topology;
  find_edges(mesh, topology);
  std::size_t triangles = 0;
  for (const VertexTriple& t : mesh.triangles) triangles += is_left_out(t) ? 0 : 1;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    if (edge.side_count() == 1) topology.open_edges.push_back(e);
    if (edge.side_count() > 2) topology.crowded_edges.push_back(e);
    if (edge.side_count() == 2 &&
        topology.sides[edge.begin].forward == topology.sides[edge.begin + 1].forward)
      topology.disagreeing_edges.push_back(e);
  }
  orient(mesh, topology);
  find_pinched(mesh, topology);
  find_open_loops(topology);
  topology.characteristic = static_cast<std::ptrdiff_t>(topology.used_vertices) -
                            static_cast<std::ptrdiff_t>(topology.edges.size()) +
                            static_cast<std::ptrdiff_t>(triangles);
  return topology;
}

int volume_sign(const TriangleMesh& mesh) {
  double sum = 0;
  double size = 0;
  const auto magnitude = [](const Vector<double>& v) {
    return Vector<double>{std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  };
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    sum += dot(a, cross(b, c));
    const Vector<double> s = magnitude(a);
    const Vector<double> t = magnitude(b);
    const Vector<double> w = magnitude(c);
    size += s.x * (t.y * w.z + t.z * w.y) + s.y * (t.z * w.x + t.x * w.z) + s.z * (t.x * w.y + t.y * w.x);
  }
  // Each term passes fewer than 8 roundings, and the sum one a term.
  const double error = unit_roundoff<double>() * (static_cast<double>(mesh.triangles.size()) + 16) * size;
  constexpr double underflow = 1e-250;  // far above what products of coordinates below 1e61 lose to it
  if (sum > 2 * error + underflow) return 1;
  if (sum < -2 * error - underflow) return -1;
  Rational exact = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    exact += dot(exactly(a), cross(exactly(b), exactly(c)));
  }
  return exact.sign();
}

}  // namespace radcert
