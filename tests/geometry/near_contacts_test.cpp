// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/near_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

/// A room of the side 4 and a box in it, from `low` on, whose sides are `width`.
TriangleMesh room_with_box(const Vector<double>& low, double width) {
  TriangleMesh mesh;
  for (const bool is_room : {true, false}) {
    const sample::Polyhedron box = sample::cube();
    const std::size_t first = mesh.vertices.size();
    for (const Vector<double>& v : box.vertices) mesh.vertices.push_back(is_room ? 4 * v : low + width * v);
    mesh.group_names.emplace_back(is_room ? "room" : "box");
    for (const std::vector<std::size_t>& face : box.faces)
      for (const std::size_t k : {1U, 2U}) {
        VertexTriple t{first + face[0], first + face[k], first + face[k + 1]};
        if (is_room) std::swap(t[1], t[2]);
        mesh.triangles.push_back(t);
        mesh.group.push_back(mesh.group_names.size() - 1);
        mesh.face.push_back(mesh.triangles.size() - 1);
      }
  }
  return mesh;
}

TEST(NearContacts, AreFacesThatLookAtEachOtherAcrossNextToNothing) {
  const auto found = near_contacts(room_with_box({1, 1, 0x1p-52}, 1), true, 0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].one, "room");
  EXPECT_EQ(found[0].other, "box");
  EXPECT_DOUBLE_EQ(found[0].gap, 0x1p-52);
  EXPECT_EQ(found[0].at.z, 0);
  for (const double x : {found[0].at.x, found[0].at.y}) EXPECT_TRUE(1 < x && x < 2) << x;
  EXPECT_GE(found[0].pairs, 2U);
}

TEST(NearContacts, AreToldAtTheNarrowestAndCounted) {
  // A pillar between floor and ceiling, with a wider gap below.
  TriangleMesh mesh = room_with_box({1, 1, 0x1p-32}, 1);
  for (Vector<double>& v : mesh.vertices)
    if (v.z == 1 + 0x1p-32) v.z = 4 - 0x1p-40;
  const auto found = near_contacts(mesh, true, 0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].gap, 0x1p-40);
  EXPECT_NEAR(found[0].at.z, 4, 1e-9);
  for (const double x : {found[0].at.x, found[0].at.y}) EXPECT_TRUE(1 < x && x < 2) << x;
  EXPECT_GE(found[0].pairs, 4U);
}

TEST(NearContacts, AreLookedForAsFarAsTheDigitsOfAFileLeaveOpen) {
  for (const double gap : {1e-6, 1e-4}) {
    const TriangleMesh mesh = room_with_box({1, 1, gap}, 1);
    EXPECT_EQ(near_contacts(mesh, true, gap / 4).size(), 1U);
    EXPECT_TRUE(near_contacts(mesh, true, gap / 16).empty());
  }
  // A large floor that rounding tilts under a small box: its plane lies in front of the box's bottom there.
  TriangleMesh mesh = room_with_box({1, 1, 1e-4}, 0.01);
  for (Vector<double>& v : mesh.vertices)
    if (v.x == 1.01 && v.z == 1e-4) v.z = 0.5e-4;
  const auto found = near_contacts(mesh, true, 1e-4);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].gap, 1e-4);
  // The same where the small box is tilted, so that its plane leaves the floor on either side.
  for (Vector<double>& v : mesh.vertices)
    if (v.x == 1 && v.y == 1 && v.z > 0 && v.z < 1e-3) v.z = 0.9e-4;
  EXPECT_EQ(near_contacts(mesh, true, 1e-4).size(), 1U);
}

TEST(NearContacts, AreNoneWhereAGapIsSeenOrThereIsNone) {
  for (const double height : {0.0, 1e-6, 0.5})
    EXPECT_TRUE(near_contacts(room_with_box({1, 1, height}, 1), true, 0).empty()) << height;
}

// A thin plate: its fronts look away from each other, and its sides are next to nothing wide.
TEST(NearContacts, AreNoneBetweenTheSidesOfAThinPlate) {
  TriangleMesh mesh = room_with_box({1, 1, 1}, 1);
  for (Vector<double>& v : mesh.vertices)
    if (v.z == 2) v.z = 1 + 0x1p-50;
  EXPECT_TRUE(near_contacts(mesh, true, 0).empty());
}

// A tilted box on a tilted floor: what is equal before rounding is off by a rounding here and there.
TEST(NearContacts, AreFoundWhereBothAreTilted) {
  TriangleMesh mesh = room_with_box({1, 1, 1e-12}, 1);
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  for (Vector<double>& v : mesh.vertices) v = {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
  const auto found = near_contacts(mesh, true, 0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].gap, 1e-12, 1e-15);
}

TEST(NearContacts, AreNoneBetweenTheSidesOfAPlateWithoutThickness) {
  TriangleMesh mesh = room_with_box({1, 1, 1}, 1);
  const std::size_t count = mesh.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    const VertexTriple front = mesh.triangles[t];
    mesh.triangles.push_back({front[0], front[2], front[1]});
    mesh.group.push_back(mesh.group[t]);
    mesh.face.push_back(mesh.face[t]);
  }
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  for (Vector<double>& v : mesh.vertices) v = {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
  EXPECT_TRUE(near_contacts(mesh, true, 0).empty());
}

TEST(NearContacts, AreNoneBetweenFacesBesideEachOther) {
  TriangleMesh mesh;
  for (const bool lower : {true, false}) {
    const double x = lower ? 0 : 1;
    const double z = lower ? 0 : 1e-12;
    const std::size_t first = mesh.vertices.size();
    for (const auto& [s, t] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
      mesh.vertices.push_back({x + s, 1.0 * t, z});
    for (const std::size_t k : {1U, 2U})
      mesh.triangles.push_back({first, first + (lower ? k : k + 1), first + (lower ? k + 1 : k)});
    mesh.group.insert(mesh.group.end(), 2, lower ? 0 : 1);
    mesh.face.insert(mesh.face.end(), 2, 0);
  }
  mesh.group_names = {"lower", "upper"};
  EXPECT_TRUE(near_contacts(mesh, true, 0).empty());
  for (std::size_t v = 4; v < 8; ++v) mesh.vertices[v].x -= 0.25;
  EXPECT_EQ(near_contacts(mesh, true, 0).size(), 1U);
}

TEST(NearContacts, AreFoundFromTheOtherSideWithTheOtherHand) {
  TriangleMesh mesh = room_with_box({1, 0x1p-50, 1}, 1);
  for (VertexTriple& t : mesh.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(near_contacts(mesh, false, 0).size(), 1U);
  EXPECT_TRUE(near_contacts(mesh, true, 0).empty());
}

}  // namespace
}  // namespace radcert
