// SPDX-License-Identifier: GPL-3.0-or-later
// Ku on occluded meshes: the collocation matrix against the second route, and both against a plain sum of
// rays.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/smooth_components.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/surface/mesh_surface.h"
#include "radcert/visibility/surface_scene.h"
#include "radcert/visibility/visibility.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

Surface surface_of(const sample::Polyhedron& polyhedron) {
  const TriangleMesh mesh = sample::mesh_of(polyhedron);
  const SmoothComponents components = smooth_components(mesh, mesh_topology(mesh), 30);
  return mesh_surface(
      "mesh", mesh, components.of_piece, piece_names(mesh, components),
      {.orientation = Orientation::against_the_cross_product, .closed = true, .unoccluded = false});
}

double density(const Vector<double>& q) { return 1 + q.x - 2 * q.y + q.z * q.x; }

TEST(OccludedOperator, AgreesWithTheCollocationMatrixOnItsOwnSpace) {
  // u is quadratic, so P_n u = u at degree 2 and K P_n u = K u.
  for (const sample::Polyhedron& room : {sample::l_shaped_room(), sample::octahedron(-0.5),
                                         sample::cube_in_cube(0.5, {0.25, 0.125, 0.0625})}) {
    const Surface surface = surface_of(room);
    const Triangulation triangulation = triangulate(surface, 0);
    const InsetBasis<double> basis(2, 0.125);
    const auto nodes = collocation_nodes<double>(surface, triangulation, basis);
    const auto k =
        assemble<double>(surface, triangulation, basis, nodes, std::vector<double>(nodes.size(), 1.0));
    const reference::AppliedOperator applied(
        surface, [](const SurfacePoint<double>&, const Vector<double>& q) { return density(q); });
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < nodes.size(); ++j) sum += k.entries(i, j) * density(nodes[j].point);
      const Approximation second = applied(nodes[i].at);
      const double allowed = second.radius / pi<double>() + 5 * k.row_radius[i] + 1e-14;
      EXPECT_NEAR(sum, second.value / pi<double>(), allowed) << "row " << i;
      EXPECT_LT(allowed, 1e-9) << "row " << i;
    }
  }
}

TEST(OccludedOperator, AgreesWithRays) {
  // The midpoint rule over 300 x 300 cells a triangle, each ray decided alone: coarse, but of another kind.
  const Surface surface = surface_of(sample::cube_in_cube(0.5, {0.25, 0.125, 0.0625}));
  const SurfaceScene scene(surface);
  const reference::AppliedOperator applied(
      surface, [](const SurfacePoint<double>&, const Vector<double>& q) { return density(q); });
  constexpr int cells = 300;
  for (const std::size_t chart : {std::size_t{0}, std::size_t{5}, std::size_t{14}, std::size_t{21}}) {
    const CollocationPoint<double> p = collocation_point<double>(surface, {chart, {0.25, 0.5}});
    double sum = 0;
    for (std::size_t other = 0; other < surface.chart_count(); ++other) {
      if (in_one_plane(surface.charts[chart], surface.charts[other])) continue;
      for (int i = 0; i < cells; ++i)
        for (int j = 0; i + j < cells; ++j)
          for (const double third : {1.0 / 3, 2.0 / 3}) {
            if (third > 0.5 && i + j + 1 >= cells) continue;
            const CollocationPoint<double> q =
                collocation_point<double>(surface, {other, {(i + third) / cells, (j + third) / cells}});
            const double g = geometric_kernel(p.point, p.normal, q.point, q.normal);
            if (g <= 0 || !visible(scene.scene(), {p.point, chart}, {q.point, other})) continue;
            const double area =
                area_element(surface.charts[other].in<double>().frame(q.at.at)) / (2.0 * cells * cells);
            sum += g * area * density(q.point);
          }
    }
    EXPECT_NEAR(sum, applied(p.at).value, 2e-3) << chart;
  }
}

}  // namespace
}  // namespace radcert
