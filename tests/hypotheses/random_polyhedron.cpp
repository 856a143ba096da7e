// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hypotheses/random_polyhedron.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cmath>
#include <vector>

namespace radcert {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

double unit(std::mt19937_64& stream) { return std::ldexp(static_cast<double>(stream() >> 11U), -53); }

Vector<double> random_point(std::mt19937_64& stream, unsigned kind) {
  if (kind == 0) {
    const auto lattice = [&] { return static_cast<double>(stream() % 4); };
    return {lattice(), lattice(), lattice()};
  }
  const Vector<double> p{2 * unit(stream) - 1, 2 * unit(stream) - 1, 2 * unit(stream) - 1};
  if (kind == 1) return p;
  if (kind == 2) return (1 / norm(p)) * p;
  return {p.x, p.y, 1e-9 * p.z + 1000};
}

}  // namespace

TriangleMesh random_polyhedron(std::mt19937_64& stream) {
  while (true) {
    const auto kind = static_cast<unsigned>(stream() % 4);
    const std::size_t count = 4 + stream() % 40;
    std::vector<Kernel::Point_3> points;
    for (std::size_t i = 0; i < count; ++i) {
      const Vector<double> p = random_point(stream, kind);
      points.emplace_back(p.x, p.y, p.z);
    }
    CGAL::Surface_mesh<Kernel::Point_3> hull;
    CGAL::convex_hull_3(points.begin(), points.end(), hull);
    if (hull.number_of_faces() < 4) continue;
    TriangleMesh mesh;
    mesh.group_names = {""};
    for (const auto v : hull.vertices())
      mesh.vertices.push_back({hull.point(v).x(), hull.point(v).y(), hull.point(v).z()});
    for (const auto f : hull.faces()) {
      VertexTriple t{};
      std::size_t i = 0;
      for (const auto v : hull.vertices_around_face(hull.halfedge(f))) t[i++] = v.idx();
      mesh.triangles.push_back(t);
      mesh.group.push_back(0);
      mesh.face.push_back(mesh.face.size());
    }
    return mesh;
  }
}

}  // namespace radcert
