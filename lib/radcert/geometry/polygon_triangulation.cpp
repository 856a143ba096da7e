// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/polygon_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <optional>
#include <queue>

namespace radcert {

PlaneTriangulation triangulate(const PlanePolygon& polygon) {
  using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using PlainFace = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::optional<bool>, Kernel, PlainFace>;
  using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
  using Delaunay =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

  PlaneTriangulation result;
  Delaunay delaunay;
  const auto gmpq = [](const Rational& x) { return CGAL::Gmpq(static_cast<mpq_srcptr>(x.gmp())); };
  for (const PolygonLoop& loop : polygon.loops()) {
    std::vector<Delaunay::Vertex_handle> handles;
    for (const ParameterPoint<Rational>& at : loop) {
      handles.push_back(delaunay.insert(Kernel::Point_2(gmpq(at.s), gmpq(at.t))));
      handles.back()->info() = result.vertices.size();
      result.vertices.push_back(at);
    }
    for (std::size_t i = 0; i < handles.size(); ++i)
      delaunay.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
  }
  // Outside is what is reached from infinity; each side of a loop changes that.
  std::queue<Delaunay::Face_handle> reached;
  delaunay.infinite_face()->info() = false;
  reached.push(delaunay.infinite_face());
  while (!reached.empty()) {
    const Delaunay::Face_handle face = reached.front();
    reached.pop();
    for (int i = 0; i < 3; ++i) {
      const Delaunay::Face_handle next = face->neighbor(i);
      if (next->info()) continue;
      next->info() = *face->info() != face->is_constrained(i);
      reached.push(next);
    }
  }
  for (const Delaunay::Face_handle face : delaunay.finite_face_handles())
    if (*face->info())
      result.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return result;
}

}  // namespace radcert
