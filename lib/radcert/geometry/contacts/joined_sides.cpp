// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/joined_sides.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/contacts/place.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/polygon_triangulation.h"

namespace radcert {
namespace {

/// Whether a point lies on a segment, between its ends.
bool is_between(const Vector<double>& at, const Vector<double>& from, const Vector<double>& to) {
  return !apart(box_about(std::array{at}), box_about(std::array{from, to})) && at != from && at != to &&
         collinear(from, at, to);
}

}  // namespace

JoinedSides joined_sides(TriangleMesh mesh) {
  std::map<Place, std::size_t> corners;
  for (const VertexTriple& triangle : mesh.triangles)
    for (const std::size_t v : triangle) corners.emplace(place_of(mesh.vertices[v]), v);

  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> on_side;  // of triangle and side
  const BoxTree tree(triangle_boxes(mesh));
  for (const auto& [place, v] : corners) {
    const BoundingBox here = box_about(std::array{mesh.vertices[v]});
    tree.visit([&](const BoundingBox& box) { return !apart(box, here); },
               [&, vertex = v](std::size_t t) {
                 const auto c = mesh.corners(t);
                 for (std::size_t k = 0; k < 3; ++k)
                   if (is_between(mesh.vertices[vertex], c[k], c[(k + 1) % 3]))
                     on_side[{t, k}].push_back(vertex);
                 return true;
               });
  }

  JoinedSides out;
  for (auto side = on_side.begin(); side != on_side.end(); ++out.cut) {
    const std::size_t t = side->first.first;
    std::vector<std::size_t> loop;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = mesh.triangles[t][k];
      loop.push_back(from);
      if (side == on_side.end() || side->first != std::pair(t, k)) continue;
      std::sort(side->second.begin(), side->second.end(), [&](std::size_t a, std::size_t b) {
        return is_between(mesh.vertices[a], mesh.vertices[from], mesh.vertices[b]);
      });
      loop.insert(loop.end(), side->second.begin(), side->second.end());
      ++side;
    }
    std::vector<Vector<double>> points;
    for (const std::size_t v : loop) points.push_back(mesh.vertices[v]);
    const std::vector<VertexTriple> parts = polygon_triangles(points).value();
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const VertexTriple part{loop[parts[k][0]], loop[parts[k][1]], loop[parts[k][2]]};
      if (k == 0) {
        mesh.triangles[t] = part;
        continue;
      }
      mesh.triangles.push_back(part);
      mesh.group.push_back(mesh.group[t]);
      mesh.face.push_back(mesh.face[t]);
    }
  }
  out.mesh = std::move(mesh);
  return out;
}

}  // namespace radcert
