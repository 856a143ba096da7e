// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/convex_containment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "radcert/geometry/mesh_defects.h"
#include "radcert/geometry/orientation.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/hypotheses/random_polyhedron.h"

namespace radcert {
namespace {

constexpr Orientation inwards = Orientation::against_the_cross_product;

/// RADCERT_POLYHEDRA, or few.
int polyhedra() {
  int count = 500;
  if (const char* given = std::getenv("RADCERT_POLYHEDRA"))
    std::from_chars(given, given + std::string_view(given).size(), count);
  return count;
}

/// The witness, from the mesh and two numbers alone: P inside the triangle, Q a vertex, strictly behind P's
/// plane.
bool checks(const TriangleMesh& mesh, const ContainmentWitness& witness, Orientation orientation) {
  const auto corners = mesh.corners(witness.triangle);
  const Vector<Rational> a = exactly(corners[0]);
  const Vector<Rational> b = exactly(corners[1]);
  const Vector<Rational> c = exactly(corners[2]);
  const Vector<Rational> sum = a + b + c;
  const Rational sign = orientation == Orientation::along_the_cross_product ? 1 : -1;
  const Vector<Rational> normal = sign * cross(b - a, c - a);
  const bool p_is_inside = Rational(3) * witness.p == sum;
  const bool q_is_there = witness.q == exactly(mesh.vertices[witness.vertex]);
  const Rational product = dot(witness.q - witness.p, normal);
  return p_is_inside && q_is_there && normal == witness.inner_normal && product == witness.product &&
         product.sign() < 0;
}

/// Whether a vertex lies strictly inside the hull of the others, by exact orientations: it does exactly if
/// after its removal it is strictly inside every facet of their hull, which the caller gives.
bool strictly_inside(const TriangleMesh& hull, const Vector<double>& v) {
  for (std::size_t k = 0; k < hull.triangles.size(); ++k) {
    const auto [a, b, c] = hull.corners(k);
    if (orientation(a, b, c, v) >= 0) return false;
  }
  return true;
}

TEST(ConvexContainment, CertifiesRandomConvexPolyhedra) {
  std::mt19937_64 stream(1);
  for (int k = 0; k < polyhedra(); ++k) {
    const TriangleMesh mesh = random_polyhedron(stream);
    const ConvexContainment found = convex_containment(mesh, inwards, 0);
    ASSERT_EQ(found.verdict, Containment::certified) << "polyhedron " << k;
    // Seen from the other side every plane is violated.
    const ConvexContainment reversed = convex_containment(mesh, Orientation::along_the_cross_product, 0);
    ASSERT_EQ(reversed.verdict, Containment::refuted) << "polyhedron " << k;
    ASSERT_EQ(reversed.violated_planes, reversed.planes);
    ASSERT_TRUE(checks(mesh, *reversed.witness, Orientation::along_the_cross_product));
  }
}

TEST(ConvexContainment, RefutesRandomPolyhedraWithAVertexPushedInside) {
  std::mt19937_64 stream(2);
  int refuted = 0;
  for (int k = 0; refuted < polyhedra(); ++k) {
    const TriangleMesh convex = random_polyhedron(stream);
    // Towards the centroid of all vertices: inside the hull of the others unless that is flat.
    Vector<double> centre;
    for (const Vector<double>& v : convex.vertices)
      centre = centre + (1 / static_cast<double>(convex.vertices.size())) * v;
    TriangleMesh dented = convex;
    const std::size_t pushed = stream() % convex.vertices.size();
    const double how_far = stream() % 3 == 0 ? 1 : 0.75;
    dented.vertices[pushed] = convex.vertices[pushed] + how_far * (centre - convex.vertices[pushed]);
    // The centroid is strictly inside the hull of the others if they, without it, still surround it.
    std::vector<std::size_t> others;
    for (std::size_t v = 0; v < convex.vertices.size(); ++v)
      if (v != pushed) others.push_back(v);
    if (!strictly_inside(convex, dented.vertices[pushed])) continue;
    if (others.size() < 4) continue;
    bool surrounded =
        true;  // no plane through the pushed vertex and two others has all others on one closed side
    for (std::size_t i = 0; i < others.size() && surrounded; ++i)
      for (std::size_t j = i + 1; j < others.size() && surrounded; ++j) {
        bool before = false;
        bool behind = false;
        for (const std::size_t v : others) {
          const int side = orientation(dented.vertices[pushed], dented.vertices[others[i]],
                                       dented.vertices[others[j]], dented.vertices[v]);
          before = before || side > 0;
          behind = behind || side < 0;
        }
        surrounded = before && behind;
      }
    if (!surrounded) continue;
    ++refuted;
    const ConvexContainment found = convex_containment(dented, inwards, 0);
    ASSERT_EQ(found.verdict, Containment::refuted) << "polyhedron " << k << ", vertex " << pushed;
    ASSERT_TRUE(checks(dented, *found.witness, inwards)) << "polyhedron " << k;
    ASSERT_GT(found.relative_depth, 0);
    ASSERT_FALSE(found.within_precision);
  }
}

/// Every plane against every vertex.
std::size_t violated_by_brute_force(const TriangleMesh& mesh) {
  std::size_t violated = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    violated +=
        std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                    [&, p = a, q = b, r = c](const Vector<double>& v) { return orientation(p, q, r, v) > 0; })
            ? 1
            : 0;
  }
  return violated;
}

TEST(ConvexContainment, CountsThePlanesThatBruteForceCounts) {
  for (const sample::Polyhedron& solid : {sample::cube(), sample::octahedron(-0.25), sample::l_shaped_room(),
                                          sample::glued_grid(9, 8, false)}) {
    TriangleMesh mesh = sample::mesh_of(solid);
    const ConvexContainment found = convex_containment(mesh, inwards, 0);
    if (found.planes == mesh.triangles.size()) {
      EXPECT_EQ(found.violated_planes, violated_by_brute_force(mesh));
    }
    EXPECT_EQ(found.verdict == Containment::certified, violated_by_brute_force(mesh) == 0);
  }
  std::mt19937_64 stream(3);
  for (int k = 0; k < 60; ++k) {
    TriangleMesh mesh = random_polyhedron(stream);
    Vector<double>& v = mesh.vertices[stream() % mesh.vertices.size()];
    // By the last bit, or by much: outwards, inwards or along a facet.
    (stream() % 2 == 0 ? v.x : v.z) *= stream() % 2 == 0 ? 1 - 0x1p-53 : 1.001;
    if (!mesh_defects(mesh).degenerate_triangles.empty()) continue;
    EXPECT_EQ(convex_containment(mesh, inwards, 0).verdict == Containment::certified,
              violated_by_brute_force(mesh) == 0)
        << k;
  }
}

TEST(ConvexContainment, KnowsTheDepthOfADent) {
  // The upper triangle at (1, 0, 0) and (0, 1, 0) has the normal (-1, -1, 4)/4, and (-1, 0, 0) lies 1/2 / |n|
  // beyond it.
  const ConvexContainment found =
      convex_containment(sample::mesh_of(sample::octahedron(-0.25)), inwards, 1e-9);
  ASSERT_EQ(found.verdict, Containment::refuted);
  EXPECT_FALSE(found.within_precision);
  EXPECT_EQ(found.violated_planes, 4U);
  EXPECT_NEAR(found.relative_depth, 0.5 / std::sqrt(18.0 / 16) / 3, 1e-15);
}

TEST(ConvexContainment, NamesTheDeepestOfAllDents) {
  // Against every plane and every vertex. Seen from the wrong side every plane is violated, each by another
  // depth.
  std::mt19937_64 stream(4);
  constexpr Orientation outwards = Orientation::along_the_cross_product;
  int first = 0;
  int last = 0;
  for (int k = 0; k < 15; ++k) {
    const TriangleMesh mesh = random_polyhedron(stream);
    Vector<double> low = mesh.vertices[mesh.triangles[0][0]];
    Vector<double> high = low;
    std::vector<double> depths;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto corners = mesh.corners(t);
      const Vector<Rational> a = exactly(corners[0]);
      const Vector<Rational> normal = cross(exactly(corners[1]) - a, exactly(corners[2]) - a);
      Rational most;
      for (const VertexTriple& other : mesh.triangles)
        for (const std::size_t v : other) {
          const Vector<double>& p = mesh.vertices[v];
          low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
          high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
          most = std::max(most, abs(dot(normal, exactly(p) - a)));
        }
      depths.push_back(std::sqrt((most * most / dot(normal, normal)).to_double()));
    }
    const double deepest = *std::max_element(depths.begin(), depths.end());
    const ConvexContainment found = convex_containment(mesh, outwards, 0);
    ASSERT_EQ(found.verdict, Containment::refuted);
    EXPECT_NEAR(found.relative_depth, deepest / norm(high - low), 1e-12 * deepest / norm(high - low)) << k;
    const ContainmentWitness& witness = *found.witness;
    EXPECT_NEAR(std::abs(witness.product.to_double()) /
                    std::sqrt(dot(witness.inner_normal, witness.inner_normal).to_double()),
                deepest, 1e-12 * deepest)
        << k;
    first += depths.front() < deepest ? 1 : 0;
    last += depths.back() < deepest ? 1 : 0;
  }
  EXPECT_GE(first, 8);
  EXPECT_GE(last, 8);
}

TEST(ConvexContainment, TellsRoundingFromDents) {
  // A cube turned by an angle whose sine is no double: its corners are rounded, its squares no longer plane.
  sample::Polyhedron cube = sample::cube();
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  for (Vector<double>& v : cube.vertices) {
    v = {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
    v = {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
  }
  decltype(cube.faces) halves;
  for (const auto& face : cube.faces) {
    halves.push_back({face[0], face[1], face[2]});
    halves.push_back({face[0], face[2], face[3]});
  }
  cube.faces = halves;
  const TriangleMesh mesh = sample::mesh_of(cube);
  const ConvexContainment found = convex_containment(mesh, inwards, 0x1p-53);
  ASSERT_EQ(found.verdict, Containment::refuted);
  EXPECT_LT(found.relative_depth, 1e-15);
  EXPECT_TRUE(found.within_precision);
  EXPECT_TRUE(checks(mesh, *found.witness, inwards));
  EXPECT_FALSE(convex_containment(mesh, inwards, 0).within_precision) << found.relative_depth;
}

TEST(ConvexContainment, MeasuresMovementByTheTwelveCoordinates) {
  // A square with one corner lifted by 1/1024: the four corners each weigh as much in the determinant.
  const double lifted = 0x1p-10;
  const TriangleMesh mesh =
      sample::mesh_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, lifted}}, {{0, 1, 2}, {0, 2, 3}}});
  ASSERT_EQ(convex_containment(mesh, inwards, 0).verdict, Containment::refuted);
  EXPECT_TRUE(convex_containment(mesh, inwards, 0.251 * lifted).within_precision);
  EXPECT_FALSE(convex_containment(mesh, inwards, 0.249 * lifted).within_precision);
}

TEST(ConvexContainment, NeedsNeitherAClosedNorAConnectedSurface) {
  sample::Polyhedron room = sample::cube();
  room.faces = {room.faces[0], room.faces[1]};  // floor and ceiling
  EXPECT_EQ(convex_containment(sample::mesh_of(room), inwards, 0).verdict, Containment::certified);
  sample::Polyhedron sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}}, {{0, 1, 2}, {1, 3, 2}}};
  for (const Orientation side : {inwards, Orientation::along_the_cross_product})
    EXPECT_EQ(convex_containment(sample::mesh_of(sheet), side, 0).verdict, Containment::certified);
  // A vertex that no triangle uses is no part of S.
  room.vertices.push_back({0, 0, 9});
  EXPECT_EQ(convex_containment(sample::mesh_of(room), inwards, 0).verdict, Containment::certified);
}

TEST(ConvexContainment, DecidesAtEveryScale) {
  for (const double scale : {1e60, 1.0, 1e-60, 1e-150}) {
    for (const double top : {1.0, -0.5}) {
      sample::Polyhedron solid = sample::octahedron(top);
      for (Vector<double>& v : solid.vertices) v = scale * v;
      TriangleMesh mesh = sample::mesh_of(solid);
      EXPECT_EQ(convex_containment(mesh, inwards, 0).verdict,
                top > 0 ? Containment::certified : Containment::refuted)
          << scale;
    }
  }
}

}  // namespace
}  // namespace radcert
