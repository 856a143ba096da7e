// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/convex_containment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/geometry/mesh_quality.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_classes.h"
#include "radcert/hypotheses/vertex_tree.h"

namespace radcert {
namespace {

/// The corners of a triangle in the order that makes them run counterclockwise as seen from outside.
std::array<std::size_t, 3> seen_from_outside(const TriangleMesh& mesh, std::size_t triangle,
                                             Orientation orientation) {
  VertexTriple t = mesh.triangles[triangle];
  if (orientation == Orientation::along_the_cross_product) std::swap(t[1], t[2]);
  return t;
}

struct Violation {
  std::size_t triangle = 0;
  std::size_t vertex = 0;
  double depth = 0;
};

ContainmentWitness witness_of(const TriangleMesh& mesh, const Violation& violation, Orientation orientation) {
  const VertexTriple t = seen_from_outside(mesh, violation.triangle, orientation);
  const Vector<Rational> a = exactly(mesh.vertices[t[0]]);
  const Vector<Rational> b = exactly(mesh.vertices[t[1]]);
  const Vector<Rational> c = exactly(mesh.vertices[t[2]]);
  ContainmentWitness witness{.triangle = violation.triangle,
                             .vertex = violation.vertex,
                             .p = Rational(1, 3) * (a + b + c),
                             .q = exactly(mesh.vertices[violation.vertex]),
                             .inner_normal = -cross(b - a, c - a),
                             .product = {}};
  witness.product = dot(witness.q - witness.p, witness.inner_normal);
  return witness;
}

/// The distance of a vertex from a triangle's plane, from exact products.
double depth_of(const TriangleMesh& mesh, std::size_t triangle, std::size_t vertex) {
  const auto [a, b, c] = mesh.corners(triangle);
  const Vector<Rational> origin = exactly(a);
  const Vector<Rational> normal = cross(exactly(b) - origin, exactly(c) - origin);
  const Rational product = dot(normal, exactly(mesh.vertices[vertex]) - origin);
  return std::sqrt((product * product / dot(normal, normal)).to_double());
}

/// How far each coordinate must move at least, to first order, for the four points to lie in one plane.
/// The determinant of the four points over the sum of the sizes of its derivatives in the twelve coordinates.
double movement_to_flat(const TriangleMesh& mesh, std::size_t triangle, std::size_t vertex, double depth) {
  const auto [a, b, c] = mesh.corners(triangle);
  const Vector<double>& v = mesh.vertices[vertex];
  const auto sum = [](const Vector<double>& g) { return std::abs(g.x) + std::abs(g.y) + std::abs(g.z); };
  const Vector<double> by_v = cross(b - a, c - a);
  const Vector<double> by_a = cross(c - b, v - b);
  const Vector<double> by_b = cross(c - a, v - a);
  const Vector<double> by_c = cross(b - a, v - a);
  return depth * norm(by_v) / (sum(by_v) + sum(by_a) + sum(by_b) + sum(by_c));
}

}  // namespace

ConvexContainment convex_containment(const TriangleMesh& mesh, Orientation orientation, double unit) {
  expects(!mesh.triangles.empty(), "at least one triangle");
  expects(unit >= 0, "unit >= 0", named("unit", unit));
  std::vector<std::size_t> used;
  for (const VertexTriple& t : mesh.triangles) used.insert(used.end(), t.begin(), t.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const VertexTree tree(mesh.vertices, std::move(used));
  const PlaneClasses planes = plane_classes(mesh);

  std::vector<std::optional<Violation>> found(planes.count());
  parallel_for(planes.count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t triangle = planes.first_triangle[k];
      const VertexTriple t = seen_from_outside(mesh, triangle, orientation);
      if (const auto v = tree.farthest_beyond(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]))
        found[k] = Violation{.triangle = triangle, .vertex = *v, .depth = depth_of(mesh, triangle, *v)};
    }
  });

  ConvexContainment result;
  result.planes = planes.count();
  const Violation* deepest = nullptr;
  result.within_precision = true;
  for (const std::optional<Violation>& violation : found) {
    if (!violation) continue;
    ++result.violated_planes;
    if (deepest == nullptr || violation->depth > deepest->depth) deepest = &*violation;
    if (movement_to_flat(mesh, violation->triangle, violation->vertex, violation->depth) > unit)
      result.within_precision = false;
  }
  if (deepest == nullptr) {
    result.verdict = Containment::certified;
    result.within_precision = false;
    result.reason = "no vertex lies behind any plane of the mesh, exactly";
    return result;
  }
  result.verdict = Containment::refuted;
  result.witness = witness_of(mesh, *deepest, orientation);
  result.relative_depth = deepest->depth / mesh_quality(mesh).diagonal;
  result.reason = "a vertex lies behind the plane of a triangle, exactly";
  return result;
}

}  // namespace radcert
