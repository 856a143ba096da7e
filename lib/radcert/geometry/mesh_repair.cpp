// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_repair.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/geometry/mesh_defects.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/orientation.h"

namespace radcert {
namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

template <class Keep>
std::size_t keep_triangles(TriangleMesh& mesh, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    if (!keep(k)) continue;
    mesh.triangles[kept] = mesh.triangles[k];
    mesh.group[kept] = mesh.group[k];
    mesh.face[kept] = mesh.face[k];
    ++kept;
  }
  const std::size_t dropped = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
  mesh.group.resize(kept);
  mesh.face.resize(kept);
  return dropped;
}

void mend_vertices(TriangleMesh& mesh, std::vector<std::string>& done) {
  std::vector<std::size_t> stands_for(mesh.vertices.size());
  std::iota(stands_for.begin(), stands_for.end(), std::size_t{0});
  const MeshDefects defects = mesh_defects(mesh);
  for (const auto& [later, earlier] : defects.duplicate_vertices) stands_for[later] = earlier;
  std::vector<char> used(mesh.vertices.size(), 0);
  for (VertexTriple& triangle : mesh.triangles)
    for (std::size_t& v : triangle) used[v = stands_for[v]] = 1;
  std::vector<std::size_t> renumbered(mesh.vertices.size());
  std::vector<Vector<double>> kept;
  for (std::size_t v = 0; v < used.size(); ++v) {
    renumbered[v] = kept.size();
    if (used[v]) kept.push_back(mesh.vertices[v]);
  }
  for (VertexTriple& triangle : mesh.triangles)
    for (std::size_t& v : triangle) v = renumbered[v];
  mesh.vertices = std::move(kept);
  if (!defects.duplicate_vertices.empty())
    done.push_back(counted(defects.duplicate_vertices.size(), "vertex", "vertices") +
                   " joined to another with the same coordinates");
  if (!defects.unreferenced_vertices.empty())
    done.push_back(counted(defects.unreferenced_vertices.size(), "vertex", "vertices") +
                   " that no triangle used left out");
}

void mend_faces(TriangleMesh& mesh, std::vector<std::string>& done) {
  const std::size_t degenerate = keep_triangles(mesh, [&](std::size_t k) {
    const auto [a, b, c] = mesh.corners(k);
    return !collinear(a, b, c);
  });
  std::set<VertexTriple> seen;
  const std::size_t repeated = keep_triangles(mesh, [&](std::size_t k) {
    VertexTriple sorted = mesh.triangles[k];
    std::sort(sorted.begin(), sorted.end());
    return seen.insert(sorted).second;
  });
  if (degenerate > 0)
    done.push_back(counted(degenerate, "degenerate triangle", "degenerate triangles") + " left out");
  if (repeated > 0)
    done.push_back(counted(repeated, "triangle", "triangles") + " that repeated another left out");
}

void mend_orientation(TriangleMesh& mesh, std::vector<std::string>& done) {
  const MeshTopology topology = mesh_topology(mesh);
  if (!topology.orientable() || topology.turned.empty()) return;
  for (const std::size_t t : topology.turned) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  done.push_back(counted(topology.turned.size(), "triangle", "triangles") + " turned over");
}

/// Each fan of triangles about a vertex gets a vertex of its own.
void mend_manifold(TriangleMesh& mesh, std::vector<std::string>& done) {
  const MeshTopology topology = mesh_topology(mesh);
  const std::set<std::size_t> pinched(topology.pinched_vertices.begin(), topology.pinched_vertices.end());
  std::map<std::size_t, std::vector<std::size_t>> around;  // vertex, triangles
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    for (const std::size_t v : mesh.triangles[k])
      if (pinched.contains(v)) around[v].push_back(k);
  std::size_t added = 0;
  std::vector<VertexTriple> triangles = mesh.triangles;
  for (const auto& [vertex, members] : around) {
    std::set<std::size_t> left(members.begin(), members.end());
    for (bool first = true; !left.empty(); first = false) {
      std::vector<std::size_t> fan{*left.begin()};
      left.erase(left.begin());
      for (std::size_t next = 0; next < fan.size(); ++next)
        for (const std::size_t e : topology.edge_of_side[fan[next]]) {
          if (e == MeshTopology::no_edge) continue;
          const MeshEdge& edge = topology.edges[e];
          if (edge.side_count() != 2 || (edge.from != vertex && edge.to != vertex)) continue;
          for (std::size_t s = edge.begin; s < edge.end; ++s)
            if (left.erase(topology.sides[s].triangle) > 0) fan.push_back(topology.sides[s].triangle);
        }
      if (first) continue;
      ++added;
      for (const std::size_t k : fan)
        for (std::size_t i = 0; i < 3; ++i)
          if (mesh.triangles[k][i] == vertex) triangles[k][i] = mesh.vertices.size();
      mesh.vertices.push_back(mesh.vertices[vertex]);
    }
  }
  mesh.triangles = std::move(triangles);
  if (added > 0)
    done.push_back("parted at " + counted(pinched.size(), "vertex", "vertices") + ", " +
                   counted(added, "vertex", "vertices") + " added");
}

void mend_crossings(TriangleMesh& mesh, std::vector<std::string>& done) {
  std::size_t dropped = 0;
  while (true) {
    std::set<std::size_t> crossing;
    for (const auto& [first, second] : crossing_triangles(mesh, most_crossings.count()))
      crossing.insert({first, second});
    if (crossing.empty()) break;
    dropped += keep_triangles(mesh, [&](std::size_t k) { return !crossing.contains(k); });
  }
  if (dropped > 0)
    done.push_back(counted(dropped, "triangle", "triangles") + " that crossed or overlapped others left out");
}

void mend_holes(TriangleMesh& mesh, std::vector<std::string>& done) {
  const MeshTopology topology = mesh_topology(mesh);
  std::size_t added = 0;
  std::size_t closed = 0;
  for (std::vector<std::size_t> loop : topology.open_loops) {
    if (loop.size() < 3) continue;
    // The triangle there runs from loop[0] to loop[1]; those that close the hole run the other way.
    std::reverse(loop.begin(), loop.end());
    std::vector<Vector<double>> line;
    for (const std::size_t v : loop) line.push_back(mesh.vertices[v]);
    std::vector<VertexTriple> triangles = hole_triangles(line);
    if (triangles.empty()) continue;
    const bool along = std::any_of(triangles.begin(), triangles.end(), [](const VertexTriple& t) {
      return (t[0] == 0 && t[1] == 1) || (t[1] == 0 && t[2] == 1) || (t[2] == 0 && t[0] == 1);
    });
    ++closed;
    for (VertexTriple t : triangles) {
      if (!along) std::swap(t[1], t[2]);
      mesh.triangles.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
      mesh.face.push_back(mesh.face.empty() ? 0 : mesh.face.back() + 1);
      mesh.group.push_back(mesh.group_names.size());
      ++added;
    }
  }
  if (added == 0) return;
  mesh.group_names.emplace_back("closed_hole");
  done.push_back(counted(closed, "hole", "holes") + " closed with " +
                 counted(added, "triangle", "triangles"));
}

}  // namespace

MeshRepair repair_named(std::span<const std::string> words) {
  MeshRepair repair;
  const std::array<bool*, repair_words.size()> choice{
      &repair.align,       &repair.triangulate, &repair.vertices,  &repair.faces,
      &repair.orientation, &repair.manifold,    &repair.crossings, &repair.holes};
  for (const std::string& word : words) {
    const auto found = std::find(repair_words.begin(), repair_words.end(), word);
    expects(found != repair_words.end(), "a word of repair_words", named("word", word));
    *choice[static_cast<std::size_t>(found - repair_words.begin())] = true;
  }
  return repair;
}

MendedMesh mend(TriangleMesh mesh, const MeshRepair& repair) {
  MendedMesh mended{.mesh = std::move(mesh), .done = {}};
  if (repair.vertices) mend_vertices(mended.mesh, mended.done);
  if (repair.faces) mend_faces(mended.mesh, mended.done);
  if (repair.orientation) mend_orientation(mended.mesh, mended.done);
  if (repair.manifold) mend_manifold(mended.mesh, mended.done);
  if (repair.crossings) mend_crossings(mended.mesh, mended.done);
  if (repair.holes) mend_holes(mended.mesh, mended.done);
  return mended;
}

}  // namespace radcert
