// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/mesh_bodies.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/orientation.h"

namespace radcert {
namespace {

/// A triangle as one sees it who looks along an edge.
struct Leaf {
  std::size_t triangle;
  Vector<double> apex;  ///< the corner that is not on the edge
  int quarter;          ///< of the angle a from the first leaf: a = 0, 0 < a < pi, a = pi, pi < a: 0, 1, 2, 3
  bool begins_solid;    ///< its back is on the side of larger angles
};

/// Pairs of triangles that bound one solid at an edge.
std::vector<std::pair<std::size_t, std::size_t>> solid_pairs(const TriangleMesh& mesh,
                                                             const MeshTopology& topology,
                                                             const MeshEdge& edge, bool right_hand) {
  const Vector<double>& from = mesh.vertices[edge.from];
  const Vector<double>& to = mesh.vertices[edge.to];
  const auto apex = [&](const TriangleSide& side) {
    return mesh.vertices[mesh.triangles[side.triangle][(side.side + 2) % 3]];
  };
  const Vector<double> first = apex(topology.sides[edge.begin]);
  const auto plane_normal = [&](const Vector<double>& at) {
    return cross(exactly(to) - exactly(from), exactly(at) - exactly(from));
  };
  std::vector<Leaf> leaves;
  for (std::size_t k = edge.begin; k < edge.end; ++k) {
    const TriangleSide& side = topology.sides[k];
    const Vector<double> at = apex(side);
    const int turn = orientation(from, to, first, at);
    const bool ahead = turn == 0 && dot(plane_normal(first), plane_normal(at)).sign() > 0;
    // The normal by the right-hand rule of a triangle that runs along the edge points to larger angles.
    leaves.push_back({.triangle = side.triangle,
                      .apex = at,
                      .quarter = ahead       ? 0
                                 : turn > 0  ? 1
                                 : turn == 0 ? 2
                                             : 3,
                      .begins_solid = side.forward != right_hand});
  }
  // Where one ends and one begins at the same angle, the solid before ends there.
  std::stable_sort(leaves.begin(), leaves.end(), [&](const Leaf& a, const Leaf& b) {
    if (a.quarter != b.quarter) return a.quarter < b.quarter;
    const int turn = a.quarter % 2 == 0 ? 0 : orientation(from, to, a.apex, b.apex);
    return turn != 0 ? turn > 0 : a.begins_solid < b.begins_solid;
  });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const Leaf& next = leaves[(k + 1) % leaves.size()];
    if (leaves[k].begins_solid && !next.begins_solid) pairs.emplace_back(leaves[k].triangle, next.triangle);
  }
  return pairs;
}

}  // namespace

MeshBodies mesh_bodies(const TriangleMesh& mesh, bool right_hand) {
  const MeshTopology topology = mesh_topology(mesh);
  const std::size_t count = mesh.triangles.size();
  std::vector<std::size_t> parent(count);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::vector<std::size_t> joined(count, 0);  // sides of each triangle that fit to another's
  for (const MeshEdge& edge : topology.edges) {
    if (edge.side_count() == 1) continue;
    if (edge.side_count() > 2) {
      for (const auto& [s, t] : solid_pairs(mesh, topology, edge, right_hand)) {
        parent[root(s)] = root(t);
        ++joined[s];
        ++joined[t];
      }
      continue;
    }
    const TriangleSide& one = topology.sides[edge.begin];
    const TriangleSide& other = topology.sides[edge.begin + 1];
    parent[root(one.triangle)] = root(other.triangle);
    if (one.forward == other.forward) continue;
    ++joined[one.triangle];
    ++joined[other.triangle];
  }

  MeshBodies out;
  std::vector<std::size_t> number(count, count);
  std::vector<TriangleMesh> parts;
  std::vector<bool> closed;
  for (std::size_t t = 0; t < count; ++t) {
    std::size_t& component = number[root(t)];
    if (component == count) {
      component = parts.size();
      parts.emplace_back();
      closed.push_back(true);
    }
    out.component.push_back(component);
    TriangleMesh& part = parts[component];
    const std::size_t first_corner = part.vertices.size();
    for (const Vector<double>& corner : mesh.corners(t)) part.vertices.push_back(corner);
    part.triangles.push_back({first_corner, first_corner + 1, first_corner + 2});
    if (joined[t] != 3) closed[component] = false;
  }
  const int outwards = right_hand ? 1 : -1;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    const int sign = closed[c] ? volume_sign(parts[c]) : 0;
    out.is_body.push_back(sign == outwards);
    out.is_room.push_back(sign == -outwards);
  }
  return out;
}

}  // namespace radcert
