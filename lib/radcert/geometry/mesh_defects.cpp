// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_defects.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "radcert/geometry/orientation.h"

namespace radcert {

const WorkLimit most_crossings("geometry/mesh_defects: pairs that cross", 1000, 1,
                               "a fault all the same: that there may be more is said");

MeshDefects mesh_defects(const TriangleMesh& mesh) {
  MeshDefects defects;
  std::vector<char> used(mesh.vertices.size(), 0);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    for (const std::size_t v : mesh.triangles[k]) used[v] = 1;
    const auto [a, b, c] = mesh.corners(k);
    if (collinear(a, b, c)) defects.degenerate_triangles.push_back(k);
  }
  for (std::size_t v = 0; v < used.size(); ++v)
    if (!used[v]) defects.unreferenced_vertices.push_back(v);

  std::vector<std::size_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) {
    const Vector<double>& v = mesh.vertices[i];
    return std::tie(v.x, v.y, v.z);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto first = key(a);
    const auto second = key(b);
    return first != second ? first < second : a < b;
  });
  // Triangles that share a place, not a number, do not cross there.
  TriangleMesh joined = mesh;
  std::vector<std::size_t> first(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool repeated = k > 0 && key(order[k]) == key(order[k - 1]);
    first[order[k]] = repeated ? first[order[k - 1]] : order[k];
    if (repeated) defects.duplicate_vertices.emplace_back(order[k], first[order[k]]);
  }
  std::sort(defects.duplicate_vertices.begin(), defects.duplicate_vertices.end());
  for (VertexTriple& triangle : joined.triangles)
    for (std::size_t& v : triangle) v = first[v];
  defects.crossing = crossing_triangles(joined, most_crossings.count());
  return defects;
}

}  // namespace radcert
