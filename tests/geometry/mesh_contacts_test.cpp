// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/mesh_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "radcert/geometry/mesh_defects.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/polygon_triangulation.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

/// Adds a box as a group; its faces run counterclockwise as seen from outside, or from inside for a room.
void add_box(TriangleMesh& mesh, const std::string& name, const Vector<double>& from,
             const Vector<double>& to, bool is_room = false) {
  sample::Polyhedron box = sample::cube();
  const std::size_t first = mesh.vertices.size();
  for (const Vector<double>& v : box.vertices)
    mesh.vertices.push_back({v.x == 0 ? from.x : to.x, v.y == 0 ? from.y : to.y, v.z == 0 ? from.z : to.z});
  mesh.group_names.push_back(name);
  for (const std::vector<std::size_t>& face : box.faces)
    for (const auto& [b, c] : {std::pair(1, 2), std::pair(2, 3)}) {
      VertexTriple t{first + face[0], first + face[static_cast<std::size_t>(b)],
                     first + face[static_cast<std::size_t>(c)]};
      if (is_room) std::swap(t[1], t[2]);
      mesh.triangles.push_back(t);
      mesh.group.push_back(mesh.group_names.size() - 1);
      mesh.face.push_back(mesh.triangles.size() - 1);
    }
}

double area(const TriangleMesh& mesh, const std::string& group) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.group_names[mesh.group[t]] != group) continue;
    const auto c = mesh.corners(t);
    sum += norm(cross(c[1] - c[0], c[2] - c[0])) / 2;
  }
  return sum;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto c = mesh.corners(t);
    sum += dot(c[0], cross(c[1], c[2])) / 6;
  }
  return sum;
}

Outcome<UncoveredMesh> uncovered(const TriangleMesh& mesh) { return without_contacts(mesh, true); }

void expect_sound(const TriangleMesh& mesh) {
  EXPECT_TRUE(mesh_defects(mesh).crossing.empty());
  const MeshTopology topology = mesh_topology(mesh);
  EXPECT_TRUE(topology.open_edges.empty());
  EXPECT_TRUE(topology.crowded_edges.empty());
  EXPECT_TRUE(topology.disagreeing_edges.empty());
}

TEST(MeshContacts, TakeOutWhatACupboardCoversOfItsFloor) {
  TriangleMesh mesh;
  add_box(mesh, "room", {0, 0, 0}, {4, 3, 2.5}, true);
  add_box(mesh, "cupboard", {1, 1, 0}, {1.75, 1.5, 2});
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->contacts.size(), 1U);
  EXPECT_NEAR(found->contacts[0].area, 0.375, 1e-15);
  EXPECT_NEAR(area(found->mesh, "room"), area(mesh, "room") - 0.375, 1e-12);
  EXPECT_NEAR(area(found->mesh, "cupboard"), area(mesh, "cupboard") - 0.375, 1e-12);
  EXPECT_NEAR(volume(found->mesh), volume(mesh), 1e-12);
  expect_sound(found->mesh);
}

TEST(MeshContacts, TakeOutWhatStandsInCornersAndOnOneAnother) {
  TriangleMesh mesh;
  add_box(mesh, "room", {0, 0, 0}, {4, 3, 2.5}, true);
  add_box(mesh, "chest", {0, 0, 0}, {1, 1, 1});           // on the floor, against two walls
  add_box(mesh, "box", {0.25, 0.25, 1}, {0.75, 1, 1.5});  // on the chest, flush with its side
  add_box(mesh, "shelf", {1, 0, 0}, {1.5, 0.5, 2.5});     // beside the chest, from floor to ceiling
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  ASSERT_TRUE(found) << found.reason();
  double covered = 0;
  for (const MeshContact& contact : found->contacts) covered += contact.area;
  // chest: floor 1, walls 1 + 1, box 0.5 * 0.75, shelf 0.5 * 1; shelf: floor, ceiling 0.25, wall 0.5 * 2.5.
  EXPECT_NEAR(covered, 3 + 0.375 + 0.5 + 0.5 + 1.25, 1e-12);
  double before = 0;
  double after = 0;
  for (const char* name : {"room", "chest", "box", "shelf"}) {
    before += area(mesh, name);
    after += area(found->mesh, name);
  }
  EXPECT_NEAR(after, before - 2 * covered, 1e-12);
  EXPECT_NEAR(volume(found->mesh), volume(mesh), 1e-12);
  expect_sound(found->mesh);
}

TEST(MeshContacts, TakeOutWhatIsCoveredToItsBorder) {
  // A pedestal, and two boxes side by side that cover its top: nothing of it is left whose corners would tell
  // its sides where theirs meet.
  TriangleMesh mesh;
  add_box(mesh, "room", {0, 0, 0}, {4, 4, 3}, true);
  add_box(mesh, "pedestal", {1, 1, 0}, {3, 3, 1});
  add_box(mesh, "left", {1, 1, 1}, {2, 3, 2});
  add_box(mesh, "right", {2, 1, 1}, {3, 3, 2});
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  ASSERT_TRUE(found) << found.reason();
  double covered = 0;
  for (const MeshContact& contact : found->contacts) covered += contact.area;
  EXPECT_NEAR(covered, 4 + 4 + 2, 1e-12);
  EXPECT_NEAR(area(found->mesh, "pedestal"), 8, 1e-12);
  EXPECT_NEAR(volume(found->mesh), volume(mesh), 1e-12);
  expect_sound(found->mesh);
}

/// Adds a rectangle at a height that looks up or down.
void add_sheet(TriangleMesh& mesh, const std::string& name, double from, double to, double z, bool up) {
  const std::size_t first = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), {{from, from, z}, {to, from, z}, {to, to, z}, {from, to, z}});
  mesh.group_names.push_back(name);
  for (VertexTriple t :
       {VertexTriple{first, first + 1, first + 2}, VertexTriple{first, first + 2, first + 3}}) {
    if (!up) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
    mesh.group.push_back(mesh.group_names.size() - 1);
    mesh.face.push_back(mesh.triangles.size() - 1);
  }
}

TEST(MeshContacts, RefuseBodiesThatLightWouldPassThrough) {
  // A box between two sheets: without its ends it is a tube from the ground to the roof.
  TriangleMesh tube;
  add_sheet(tube, "ground", 1.9, 2.1, 0, true);
  add_sheet(tube, "roof", 1.9, 2.1, 3, false);
  add_sheet(tube, "low", 0, 4, 1, true);
  add_sheet(tube, "high", 0, 4, 2, false);
  TriangleMesh one = tube;
  add_box(tube, "box", {1, 1, 1}, {3, 3, 2});
  ASSERT_FALSE(uncovered(tube));
  EXPECT_NE(uncovered(tube).reason().find("two planes"), std::string::npos) << uncovered(tube).reason();
  // Two boxes, one on the other, are one tube as well.
  TriangleMesh stacked = one;
  add_box(stacked, "lower", {1, 1, 1}, {3, 3, 1.5});
  add_box(stacked, "upper", {1, 1, 1.5}, {3, 3, 2});
  EXPECT_FALSE(uncovered(stacked));
  // On one of the sheets alone, what comes in does not come out.
  TriangleMesh lower = one;
  add_box(lower, "box", {1, 1, 1}, {3, 3, 1.75});
  ASSERT_TRUE(uncovered(lower)) << uncovered(lower).reason();
  EXPECT_EQ(uncovered(lower)->contacts.size(), 1U);
  // But what is inside would come out.
  add_box(lower, "hidden", {1.5, 1.5, 1.25}, {2, 2, 1.5});
  EXPECT_FALSE(uncovered(lower));
  // With nothing beyond the sheets nothing can pass.
  TriangleMesh alone;
  add_sheet(alone, "low", 0, 4, 1, true);
  add_sheet(alone, "high", 0, 4, 2, false);
  add_box(alone, "box", {1, 1, 1}, {3, 3, 2});
  EXPECT_EQ(uncovered(alone)->contacts.size(), 2U);
}

/// A room with the plan of a plus, two units high.
TriangleMesh plus_shaped_room() {
  const std::vector<std::pair<double, double>> plan{{1, 0}, {3, 0}, {3, 1}, {4, 1}, {4, 3}, {3, 3},
                                                    {3, 4}, {1, 4}, {1, 3}, {0, 3}, {0, 1}, {1, 1}};
  const sample::Polyhedron room = sample::column(plan, 2);
  TriangleMesh mesh;
  mesh.vertices = room.vertices;
  mesh.group_names = {"room"};
  for (const std::vector<std::size_t>& face : room.faces) {
    std::vector<ParameterPoint<double>> flat;
    for (const std::size_t v : face) {
      const Vector<double>& at = room.vertices[v];
      if (face.size() > 4)
        flat.push_back({at.x, at.y});
      else
        flat.push_back({at.x + at.y, at.z});
    }
    // As they run, seen from inside: turned round.
    const std::vector<VertexTriple> triangles = polygon_triangles(flat).value();
    for (const VertexTriple& t : triangles) {
      mesh.triangles.push_back({face[t[0]], face[t[2]], face[t[1]]});
      mesh.group.push_back(0);
      mesh.face.push_back(mesh.triangles.size() - 1);
    }
  }
  return mesh;
}

TEST(MeshContacts, TakeWhatStandsBetweenWallsOfARoomThatGoesOnBehindThem) {
  // A chest across one of the arms of a plus: the others lie beyond both of the walls that it touches. All is
  // inside of the room, and what is covered lies within what is solid.
  TriangleMesh mesh = plus_shaped_room();
  add_box(mesh, "chest", {1, 0.25, 0}, {3, 0.75, 1});
  add_box(mesh, "other", {0.25, 1.25, 0.5}, {0.5, 1.5, 1});
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  ASSERT_TRUE(found) << found.reason();
  double covered = 0;
  for (const MeshContact& contact : found->contacts) covered += contact.area;
  EXPECT_NEAR(covered, 2 * 0.5 + 2 * 0.5 * 1, 1e-12);
  EXPECT_NEAR(volume(found->mesh), volume(mesh), 1e-12);
  expect_sound(found->mesh);
  // With something outside the room light could pass there, and with a plate that goes on behind a wall.
  TriangleMesh outside = mesh;
  add_box(outside, "outside", {5, 5, 0}, {6, 6, 1});
  EXPECT_FALSE(uncovered(outside));
  TriangleMesh plate = mesh;
  const std::size_t first = plate.vertices.size();
  plate.vertices.insert(plate.vertices.end(),
                        {{1, 0.8125, 0.5}, {1, 0.875, 0.5}, {1.5, 0.8125, 0.5}, {0.5, 0.8125, 0.5}});
  plate.group_names.emplace_back("plate");
  for (const VertexTriple& t :
       {VertexTriple{first, first + 2, first + 1}, VertexTriple{first, first + 1, first + 3}}) {
    plate.triangles.push_back(t);
    plate.group.push_back(plate.group_names.size() - 1);
    plate.face.push_back(plate.triangles.size() - 1);
  }
  EXPECT_FALSE(uncovered(plate));
}

/// Adds a triangle with its corners in this order as a group.
void add_triangle(TriangleMesh& mesh, const std::string& name, const std::array<Vector<double>, 3>& corners) {
  const std::size_t first = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.group_names.push_back(name);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.group.push_back(mesh.group_names.size() - 1);
  mesh.face.push_back(mesh.triangles.size() - 1);
}

TEST(MeshContacts, RefuseBodiesThatLightWouldReachFromOutsideOfARoom) {
  // Chests against two walls of a plus, one with its other end at an open face: from behind that, through
  // both walls and what is outside, light would come into the other.
  TriangleMesh mesh = plus_shaped_room();
  add_box(mesh, "chest", {1, 0.25, 0}, {1.25, 0.75, 1});
  add_box(mesh, "other", {0.25, 1, 0}, {0.75, 1.25, 1});
  EXPECT_TRUE(uncovered(mesh));
  add_triangle(mesh, "leaf", {{{1.25, 0.25, 0.25}, {1.25, 0.375, 0.75}, {1.25, 0.75, 0.25}}});
  EXPECT_FALSE(uncovered(mesh));
}

void expect_refused_for_contents(const TriangleMesh& mesh) {
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  ASSERT_FALSE(found);
  EXPECT_NE(found.reason().find(" inside, which would be seen"), std::string::npos) << found.reason();
}

TEST(MeshContacts, RefuseContentsOfEachBodyOfAChain) {
  TriangleMesh floor;
  add_sheet(floor, "floor", -2, 2, 0, true);
  add_sheet(floor, "lamp", 0.25, 0.75, -1, true);
  add_box(floor, "lower", {0, 0, 0}, {1, 1, 1});
  TriangleMesh above = floor;
  add_box(above, "upper", {0.25, 0.25, 1}, {0.75, 0.75, 1.5});
  EXPECT_TRUE(uncovered(above));
  add_box(above, "hidden", {0.375, 0.375, 1.125}, {0.625, 0.625, 1.25});
  expect_refused_for_contents(above);
  TriangleMesh beside = floor;
  add_box(beside, "other", {1, 0, 0}, {2, 1, 1});
  EXPECT_TRUE(uncovered(beside));
  add_box(beside, "hidden", {1.25, 0.25, 0.25}, {1.5, 0.5, 0.5});
  expect_refused_for_contents(beside);
}

TEST(MeshContacts, RefuseContentsOfBodiesThatTouchEachOther) {
  // In the open nothing else is opened, and what is in the one would see what is in the other.
  TriangleMesh mesh;
  add_box(mesh, "one", {0, 0, 0}, {1, 1, 1});
  add_box(mesh, "other", {1, 0, 0}, {2, 1, 1});
  EXPECT_TRUE(uncovered(mesh));
  add_box(mesh, "in one", {0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
  expect_refused_for_contents(mesh);
  add_box(mesh, "in other", {1.25, 0.25, 0.25}, {1.5, 0.5, 0.5});
  expect_refused_for_contents(mesh);
  // In chests against two walls of a room, from one through what is outside into the other.
  TriangleMesh room = plus_shaped_room();
  add_box(room, "chest", {1, 0.25, 0}, {1.5, 0.75, 1});
  add_box(room, "other", {0.25, 1, 0}, {0.75, 1.5, 1});
  EXPECT_TRUE(uncovered(room));
  add_box(room, "in chest", {1.125, 0.375, 0.25}, {1.25, 0.5, 0.5});
  add_box(room, "in other", {0.375, 1.125, 0.25}, {0.5, 1.25, 0.5});
  expect_refused_for_contents(room);
}

TEST(MeshContacts, RefuseContentsThatAreInsideInPart) {
  // A triangle through the part of a floor that a box covers: its middle is below, and with the faces taken
  // out it would cross nothing.
  TriangleMesh mesh;
  add_sheet(mesh, "floor", -2, 2, 0, true);
  add_box(mesh, "box", {-1, -1, 0}, {1, 1, 1});
  TriangleMesh below = mesh;
  add_triangle(below, "leaf", {{{-0.25, 0.125, -2}, {0.25, 0.125, -2}, {0, 0.125, -1}}});
  EXPECT_TRUE(uncovered(below));
  add_triangle(mesh, "leaf", {{{-0.25, 0.125, -2}, {0.25, 0.125, -2}, {0, 0.125, 0.25}}});
  expect_refused_for_contents(mesh);
}

TEST(MeshContacts, FindContentsFromWhichRaysMeetVertices) {
  // Three walls of the box have a vertex where fixed directions from the middle of the content meet them.
  TriangleMesh mesh;
  add_sheet(mesh, "floor", -2, 2, 0, true);
  add_sheet(mesh, "lamp", 0.25, 0.75, -1, true);
  const sample::Polyhedron box = sample::cube();
  const std::size_t first = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), box.vertices.begin(), box.vertices.end());
  mesh.group_names.emplace_back("box");
  const std::map<std::size_t, Vector<double>> apex{{1, {0.5 - 11.0 / 1024, 0.5 + 13.0 / 512, 1}},
                                                   {2, {0.5 + 7.0 / 512, 0, 0.5 + 9.0 / 1024}},
                                                   {3, {1, 0.5 + 3.0 / 256, 0.5 + 5.0 / 512}}};
  for (std::size_t f = 0; f < box.faces.size(); ++f) {
    const std::vector<std::size_t>& face = box.faces[f];
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      mesh.triangles.push_back({a, b, c});
      mesh.group.push_back(mesh.group_names.size() - 1);
      mesh.face.push_back(f);
    };
    if (apex.contains(f)) {
      mesh.vertices.push_back(apex.at(f));
      for (std::size_t k = 0; k < 4; ++k)
        add(first + face[k], first + face[(k + 1) % 4], mesh.vertices.size() - 1);
    } else {
      add(first + face[0], first + face[1], first + face[2]);
      add(first + face[0], first + face[2], first + face[3]);
    }
  }
  EXPECT_TRUE(uncovered(mesh));
  add_triangle(mesh, "content", {{{0.375, 0.375, 0.5}, {0.375, 0.625, 0.5}, {0.75, 0.5, 0.5}}});
  expect_refused_for_contents(mesh);
}

TEST(MeshContacts, DoNotDependOnHowVerticesAreShared) {
  TriangleMesh mesh;
  add_box(mesh, "room", {0, 0, 0}, {4, 3, 2.5}, true);
  add_box(mesh, "chest", {0, 0, 0}, {1, 1, 1});
  TriangleMesh apart = mesh;
  apart.vertices.clear();
  for (VertexTriple& t : apart.triangles)
    for (std::size_t& v : t) {
      apart.vertices.push_back(mesh.vertices[v]);
      v = apart.vertices.size() - 1;
    }
  const Outcome<UncoveredMesh> one = uncovered(mesh);
  const Outcome<UncoveredMesh> other = uncovered(apart);
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->contacts.size(), 3U);
  EXPECT_EQ(other->contacts.size(), 3U);
  EXPECT_EQ(one->mesh.triangles.size(), other->mesh.triangles.size());
  expect_sound(other->mesh);
}

TEST(MeshContacts, AreExactForRandomBoxesOnATilesOfAFloor) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 60; ++trial) {
    TriangleMesh mesh;
    add_box(mesh, "room", {0, 0, 0}, {8, 8, 4}, true);
    // Boxes of a grid, on the floor, some of them neighbours; each a part of its cell or all of it.
    double covered = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        if (random() % 2 == 0) continue;
        const double x = 1 + 2 * i;
        const double y = 1 + 2 * j;
        const double width = random() % 2 == 0 ? 2 : 0.3 + 0.1 * static_cast<double>(random() % 16);
        const double height = 1 + static_cast<double>(random() % 3);
        add_box(mesh, "b" + std::to_string(3 * i + j), {x, y, 0}, {x + width, y + width, height});
        covered += (x + width - x) * (y + width - y);
      }
    const Outcome<UncoveredMesh> found = uncovered(mesh);
    ASSERT_TRUE(found) << trial << found.reason();
    double on_floor = 0;
    for (const MeshContact& contact : found->contacts)
      if (contact.one == "room" || contact.other == "room") on_floor += contact.area;
    EXPECT_NEAR(on_floor, covered, 1e-11) << trial;
    EXPECT_NEAR(volume(found->mesh), volume(mesh), 1e-11) << trial;
    EXPECT_TRUE(mesh_defects(found->mesh).crossing.empty()) << trial;
  }
}

TEST(MeshContacts, LeavePlatesAndMeshesWithoutContactsAsTheyAre) {
  TriangleMesh apart;
  add_box(apart, "room", {0, 0, 0}, {4, 3, 2.5}, true);
  add_box(apart, "box", {1, 1, 1}, {2, 2, 2});
  EXPECT_TRUE(uncovered(apart)->contacts.empty());
  EXPECT_EQ(uncovered(apart)->mesh.triangles, apart.triangles);
  // A plate given by both of its sides: no body.
  TriangleMesh plate;
  add_box(plate, "room", {0, 0, 0}, {4, 3, 2.5}, true);
  const std::size_t first = plate.vertices.size();
  plate.vertices.insert(plate.vertices.end(), {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}});
  plate.group_names.emplace_back("plate");
  for (const VertexTriple& t :
       {VertexTriple{first, first + 1, first + 2}, VertexTriple{first, first + 2, first + 1}}) {
    plate.triangles.push_back(t);
    plate.group.push_back(1);
    plate.face.push_back(plate.triangles.size() - 1);
  }
  EXPECT_TRUE(uncovered(plate)->contacts.empty());
  EXPECT_EQ(uncovered(plate)->mesh.triangles, plate.triangles);
  // A sheet that lies on the floor, front down: neither it nor the room, whose front is inside, is a body.
  TriangleMesh sheet;
  add_box(sheet, "room", {0, 0, 0}, {4, 3, 2.5}, true);
  const std::size_t begin = sheet.vertices.size();
  sheet.vertices.insert(sheet.vertices.end(), {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}});
  sheet.group_names.emplace_back("sheet");
  sheet.triangles.push_back({begin, begin + 2, begin + 1});
  sheet.group.push_back(1);
  sheet.face.push_back(sheet.triangles.size() - 1);
  EXPECT_TRUE(uncovered(sheet)->contacts.empty());
  EXPECT_EQ(uncovered(sheet)->mesh.triangles, sheet.triangles);
  // A cupboard in place of it is one.
  TriangleMesh mesh;
  add_box(mesh, "room", {0, 0, 0}, {4, 3, 2.5}, true);
  add_box(mesh, "cupboard", {1, 1, 0}, {1.75, 1.5, 2});
  EXPECT_FALSE(uncovered(mesh)->contacts.empty());
}

TEST(MeshContacts, CutFacesAlongTheSidesThatStandOnThem) {
  // A gable across the floor's diagonal, by one side; and a tip, which is no side.
  TriangleMesh mesh;
  add_box(mesh, "room", {0, 0, 0}, {4, 4, 3}, true);
  add_triangle(mesh, "gable", {{{1, 0.5, 0}, {2.5, 3, 0}, {2, 2, 2}}});
  TriangleMesh tip = mesh;
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  ASSERT_TRUE(found) << found.reason();
  EXPECT_TRUE(found->contacts.empty());
  EXPECT_EQ(found->cut, 2U);
  EXPECT_FALSE(found->is_as_it_was());
  EXPECT_NEAR(area(found->mesh, "room"), area(mesh, "room"), 1e-12);
  EXPECT_TRUE(mesh_defects(found->mesh).crossing.empty());
  // Three triangles meet along the gable's side, the floor's being cut along it, and no diagonal is kept.
  const MeshTopology topology = mesh_topology(found->mesh);
  EXPECT_EQ(topology.crowded_edges.size(), 1U);
  EXPECT_EQ(topology.open_edges.size(), 2U);
  EXPECT_EQ(found->mesh.triangles.size(), 10U + 1 + 6);
  // A side that lies on the floor's diagonal, as joined_sides would make it: no face is cut along it.
  TriangleMesh along = tip;
  along.vertices[along.vertices.size() - 3] = {1, 1, 0};
  along.vertices[along.vertices.size() - 2] = {2, 2, 0};
  EXPECT_TRUE(uncovered(along)->is_as_it_was());
  tip.vertices[tip.vertices.size() - 1] = {2, 2, 0.5};
  tip.vertices[tip.vertices.size() - 3] = {1, 0.5, 2};
  EXPECT_TRUE(uncovered(tip)->is_as_it_was());
}

TEST(MeshContacts, CutAFaceThatABodyCoversAndAWallStandsOnOnce) {
  TriangleMesh mesh;
  add_box(mesh, "room", {0, 0, 0}, {4, 4, 3}, true);
  add_box(mesh, "box", {0.5, 0.5, 0}, {1.5, 1.5, 1});
  add_triangle(mesh, "wall", {{{1.5, 1, 0}, {3, 1, 0}, {1.5, 1, 0.5}}});  // from the box on
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  ASSERT_TRUE(found) << found.reason();
  ASSERT_EQ(found->contacts.size(), 1U);
  EXPECT_NEAR(found->contacts[0].area, 1, 1e-12);
  EXPECT_NEAR(area(found->mesh, "room"), area(mesh, "room") - 1, 1e-12);
  EXPECT_NEAR(area(found->mesh, "box"), 5, 1e-12);
  EXPECT_TRUE(mesh_defects(found->mesh).crossing.empty());
}

TEST(MeshContacts, LeaveFacesThatOverlapAndLookTheSameWay) {
  // A sheet under a box in the open, both front down, and a flag that hangs from where they meet: one of the
  // two would be gone there.
  TriangleMesh mesh;
  add_sheet(mesh, "sheet", 0, 4, 1, false);
  add_box(mesh, "box", {1, 1, 1}, {2, 2, 2});
  add_triangle(mesh, "flag", {{{1.25, 1.5, 1}, {1.75, 1.25, 1}, {1.5, 1.5, 0}}});
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  ASSERT_TRUE(found) << found.reason();
  EXPECT_NEAR(area(found->mesh, "sheet"), 16, 1e-12);
  EXPECT_NEAR(area(found->mesh, "box"), 6, 1e-12);
}

TEST(MeshContacts, LeaveFacesWhereSidesThatStandOnThemCrossAtNoDoubles) {
  // They cross where x = 17/14: nothing is cut, and the mesh is left to be refused for what touches.
  TriangleMesh mesh;
  add_box(mesh, "room", {0, 0, 0}, {4, 4, 3}, true);
  add_triangle(mesh, "one", {{{1, 1.5, 0}, {2, 2.5, 0}, {1, 1, 1}}});
  add_triangle(mesh, "other", {{{1, 2.25, 0}, {1.5, 1, 0}, {1, 2, 1}}});
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  ASSERT_TRUE(found) << found.reason();
  EXPECT_TRUE(found->is_as_it_was());
  EXPECT_EQ(found->mesh.triangles, mesh.triangles);
}

TEST(MeshContacts, RefuseCornersThatNoDoublesHold) {
  TriangleMesh mesh;
  add_box(mesh, "table", {0, 0, 0}, {3, 3, 1});
  // A prism on the table that stands over its edge, so that its slanted side crosses it at y = 1/3.
  const sample::Polyhedron prism = sample::column({{2, 0.25}, {4, 0.5}, {2, 2}}, 1);
  const std::size_t first = mesh.vertices.size();
  for (const Vector<double>& v : prism.vertices) mesh.vertices.push_back({v.x, v.y + 1 / 3.0, v.z + 1});
  mesh.group_names.emplace_back("prism");
  for (const std::vector<std::size_t>& face : prism.faces)
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      mesh.triangles.push_back({first + face[0], first + face[k], first + face[k + 1]});
      mesh.group.push_back(1);
      mesh.face.push_back(mesh.triangles.size() - 1);
    }
  const Outcome<UncoveredMesh> found = uncovered(mesh);
  EXPECT_FALSE(found);
  EXPECT_NE(found.reason().find("no doubles hold exactly"), std::string::npos);
  EXPECT_NE(found.reason().find(
                "(prism, table), and what they cover of each other has a corner near (3, 1.58333, 1)"),
            std::string::npos)
      << found.reason();
}

}  // namespace
}  // namespace radcert
