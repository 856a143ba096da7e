// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/winding/ray_crossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "radcert/geometry/orientation.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

/// Adds a box of triangles that run counterclockwise as seen from outside, or from inside.
void add_box(TriangleMesh& mesh, const Vector<double>& low, const Vector<double>& high, bool turned = false) {
  const sample::Polyhedron box = sample::cube();
  const std::size_t first = mesh.vertices.size();
  for (const Vector<double>& v : box.vertices)
    mesh.vertices.push_back(
        {v.x == 0 ? low.x : high.x, v.y == 0 ? low.y : high.y, v.z == 0 ? low.z : high.z});
  for (const std::vector<std::size_t>& face : box.faces)
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      VertexTriple t{first + face[0], first + face[k], first + face[k + 1]};
      if (turned) std::swap(t[1], t[2]);
      mesh.triangles.push_back(t);
    }
}

/// Adds a tetrahedron whose triangles run counterclockwise as seen from outside.
void add_tetrahedron(TriangleMesh& mesh, std::array<Vector<double>, 4> v) {
  if (orientation(v[0], v[1], v[2], v[3]) < 0) std::swap(v[0], v[1]);
  const std::size_t first = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), v.begin(), v.end());
  for (const VertexTriple& t : {VertexTriple{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

std::optional<long> winding(const RayCrossings& rays, const Vector<Rational>& point) {
  const auto crossings = rays.from(point);
  return crossings ? std::optional(winding_number(*crossings)) : std::nullopt;
}

TEST(RayCrossings, TellPointsInsideFromThoseOnTheSurface) {
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {4, 4, 4});
  add_box(mesh, {1, 1, 1}, {2, 2, 2});
  add_box(mesh, {2, 2, 2}, {3, 3, 3}, true);  // touches that one in a vertex
  const RayCrossings rays(mesh);
  const auto place = [](long at, long low,
                        long high) {  // of a point of a box: inside, on its border, outside
    return low < at && at < high ? 2 : at < low || at > high ? 0 : 1;
  };
  for (long x = -1; x <= 9; ++x)
    for (long y = -1; y <= 9; ++y)
      for (long z = -1; z <= 9; ++z) {
        long expected = 0;
        bool on = false;
        for (const auto& [low, high, weight] : {std::array<long, 3>{0, 8, 1}, {2, 4, 1}, {4, 6, -1}}) {
          const long least = std::min({place(x, low, high), place(y, low, high), place(z, low, high)});
          on = on || least == 1;
          if (least == 2) expected += weight;
        }
        const Vector<Rational> point{Rational(x, 2), Rational(y, 2), Rational(z, 2)};
        EXPECT_EQ(winding(rays, point), on ? std::nullopt : std::optional(expected)) << x << y << z;
      }
}

TEST(RayCrossings, TakeAnotherRayWhereOneMeetsASideOrAVertex) {
  // From the origin the first directions are (1, s, s^2), s = 11/32, 19/32, ...: of tetrahedra in the way,
  // some have a vertex there, some the middle of a side.
  TriangleMesh mesh;
  add_box(mesh, {-8, -8, -8}, {8, 8, 8});
  for (int k = 0; k < 6; ++k) {
    const double s = (11 + 8 * k) / 32.0;
    const Vector<double> at{1, s, s * s};
    const Vector<double> aside{0, 0.015625, -0.03125};
    const Vector<double> tip{1.25, 1.25 * s + 0.03125, 1.25 * s * s};
    if (k % 2 == 0)
      add_tetrahedron(mesh, {at, tip, tip + Vector<double>{0, -0.0625, 0.03125},
                             tip + Vector<double>{0, -0.0625, -0.03125}});
    else
      add_tetrahedron(mesh, {at + aside, at - aside, tip, tip + Vector<double>{0.125, -0.0625, 0.03125}});
  }
  EXPECT_EQ(winding(RayCrossings(mesh), {0, 0, 0}), 1);
}

TEST(RayCrossings, AreExactNextToASide) {
  // Points on a side, rounded: the judge has exact signs of its own.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::array<int, 2> seen{};
  for (int trial = 0; trial < 300; ++trial) {
    std::array<Vector<double>, 4> v;
    for (Vector<double>& corner : v) corner = {uniform(random), uniform(random), uniform(random)};
    TriangleMesh mesh;
    add_tetrahedron(mesh, v);
    const RayCrossings rays(mesh);
    for (int k = 0; k < 20; ++k) {
      const Vector<double> point = v[0] + uniform(random) * (v[1] - v[0]);
      bool inside = true;
      bool on = false;
      for (std::size_t t = 0; t < 4; ++t) {
        const auto c = mesh.corners(t);
        const int side = orientation(c[0], c[1], c[2], point);
        inside = inside && side < 0;
        on = on || side == 0;
      }
      if (on) continue;
      ++seen[inside ? 1 : 0];
      ASSERT_EQ(winding(rays, exactly(point)), inside ? 1 : 0) << trial << " " << k;
    }
  }
  EXPECT_GT(seen[0], 100);
  EXPECT_GT(seen[1], 100);
}

TEST(RayCrossings, LeaveATriangleToTheSideThatIsAskedFor) {
  TriangleMesh mesh;
  add_box(mesh, {0, 0, 0}, {4, 4, 4});
  add_box(mesh, {1, 1, 1}, {2, 2, 2}, true);
  const std::size_t plate = mesh.triangles.size();
  mesh.vertices.insert(mesh.vertices.end(), {{3, 3, 3}, {3.5, 3, 3}, {3, 3.5, 3}});
  const std::size_t corner = mesh.vertices.size() - 3;
  mesh.triangles.push_back({corner, corner + 1, corner + 2});
  mesh.triangles.push_back({corner, corner + 2, corner + 1});
  const RayCrossings rays(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const int side : {-1, 1}) {
      const auto crossings = rays.from_side(t, side);
      ASSERT_TRUE(crossings);
      // Between the boxes 1, on both sides of the plate too; outside of the large one and in the small one 0.
      EXPECT_EQ(winding_number(*crossings), t >= plate || side < 0 ? 1 : 0) << t << side;
    }
  // A triangle that another goes through where the ray begins.
  const auto c = mesh.corners(plate);
  const Vector<double> middle{3.125, 3.125, 3};
  mesh.vertices.insert(mesh.vertices.end(),
                       {middle + Vector<double>{0, 0, 1}, middle + Vector<double>{0, 1, -1},
                        middle + Vector<double>{0, -1, -1}});
  mesh.triangles.push_back({corner + 3, corner + 4, corner + 5});
  EXPECT_EQ(point_inside(c), exactly(middle));
  EXPECT_FALSE(RayCrossings(mesh).from_side(plate, 1));
}

}  // namespace
}  // namespace radcert
