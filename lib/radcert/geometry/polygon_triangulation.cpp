// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/polygon_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace radcert {
namespace {

/// Counterclockwise triangles; the points are numbered through all loops.
template <class Kernel>
std::vector<VertexTriple> delaunay_triangles(
    const std::vector<std::vector<typename Kernel::Point_2>>& loops) {
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using PlainFace = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::optional<bool>, Kernel, PlainFace>;
  using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
  using Delaunay =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;
  using Face = typename Delaunay::Face_handle;

  Delaunay delaunay;
  std::size_t number = 0;
  for (const auto& loop : loops) {
    std::vector<typename Delaunay::Vertex_handle> handles;
    Face near;
    for (const auto& point : loop) {
      handles.push_back(delaunay.insert(point, near));
      handles.back()->info() = number++;
      near = handles.back()->face();
    }
    for (std::size_t i = 0; i < handles.size(); ++i)
      delaunay.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
  }
  // Outside is what is reached from infinity; each side of a loop changes that.
  std::queue<Face> reached;
  delaunay.infinite_face()->info() = false;
  reached.push(delaunay.infinite_face());
  while (!reached.empty()) {
    const Face face = reached.front();
    reached.pop();
    for (int i = 0; i < 3; ++i) {
      const Face next = face->neighbor(i);
      if (next->info()) continue;
      next->info() = *face->info() != face->is_constrained(i);
      reached.push(next);
    }
  }
  std::vector<VertexTriple> triangles;
  for (const Face face : delaunay.finite_face_handles())
    if (*face->info())
      triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

/// The corners on a coordinate plane, without the coordinate `left_out`; the order keeps the sense of
/// rotation.
std::vector<ParameterPoint<double>> projection(std::span<const Vector<double>> corners,
                                               std::size_t left_out) {
  std::vector<ParameterPoint<double>> points;
  for (const Vector<double>& p : corners) {
    const std::array<double, 3> x{p.x, p.y, p.z};
    points.push_back({x[(left_out + 1) % 3], x[(left_out + 2) % 3]});
  }
  return points;
}

}  // namespace

PlaneTriangulation triangulate(const PlanePolygon& polygon) {
  using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
  const auto gmpq = [](const Rational& x) { return CGAL::Gmpq(static_cast<mpq_srcptr>(x.gmp())); };
  PlaneTriangulation result;
  std::vector<std::vector<Kernel::Point_2>> loops;
  for (const PolygonLoop& loop : polygon.loops()) {
    loops.emplace_back();
    for (const ParameterPoint<Rational>& at : loop) loops.back().emplace_back(gmpq(at.s), gmpq(at.t));
    result.vertices.insert(result.vertices.end(), loop.begin(), loop.end());
  }
  result.triangles = delaunay_triangles<Kernel>(loops);
  return result;
}

std::optional<std::vector<VertexTriple>> polygon_triangles(std::span<const ParameterPoint<double>> corners) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<std::vector<Kernel::Point_2>> loops(1);
  std::vector<Kernel::Point_2>& points = loops.front();
  for (const ParameterPoint<double>& at : corners) points.emplace_back(at.s, at.t);
  if (!CGAL::is_simple_2(points.begin(), points.end(), Kernel())) return std::nullopt;
  std::vector<VertexTriple> triangles = delaunay_triangles<Kernel>(loops);
  if (CGAL::orientation_2(points.begin(), points.end(), Kernel()) == CGAL::CLOCKWISE)
    for (VertexTriple& triangle : triangles) std::swap(triangle[1], triangle[2]);
  return triangles;
}

std::optional<std::vector<VertexTriple>> polygon_triangles(std::span<const Vector<double>> corners) {
  double largest = 0;
  for (const Vector<double>& p : corners)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  const auto scaled = [&](const Vector<double>& p) {
    return Vector<double>{std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent), std::ldexp(p.z, -exponent)};
  };
  Vector<double> sum;  // Newell's normal: the sum of the cross products along the boundary
  const Vector<double> first = scaled(corners[0]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum = sum + cross(scaled(corners[i]) - first, scaled(corners[i + 1]) - first);
  const std::array<double, 3> normal{sum.x, sum.y, sum.z};
  std::array<std::size_t, 3> order{2, 0, 1};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return std::abs(normal[a]) > std::abs(normal[b]); });
  for (const std::size_t axis : order)
    if (auto triangles =
            polygon_triangles(std::span<const ParameterPoint<double>>(projection(corners, axis))))
      return triangles;
  return std::nullopt;
}

}  // namespace radcert
