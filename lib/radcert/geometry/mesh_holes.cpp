// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <iterator>

#include "radcert/geometry/mesh_repair.h"

namespace radcert {

std::vector<VertexTriple> hole_triangles(const std::vector<Vector<double>>& line) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  for (const Vector<double>& v : line) points.emplace_back(v.x, v.y, v.z);
  std::vector<CGAL::Triple<int, int, int>> found;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(found));
  std::vector<VertexTriple> triangles;
  for (const auto& t : found)
    triangles.push_back({static_cast<std::size_t>(t.first), static_cast<std::size_t>(t.second),
                         static_cast<std::size_t>(t.third)});
  return triangles;
}

}  // namespace radcert
