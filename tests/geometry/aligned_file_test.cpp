// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/aligned_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "radcert/scalar/rational.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

/// A box of other lengths in a room, each vertex `place` of where it would be.
template <class Moved>
MeshFile furnished_room(const Moved& place) {
  MeshFile file;
  for (const bool is_room : {true, false}) {
    const sample::Polyhedron box = sample::cube();
    const std::size_t first = file.vertices.size();
    for (const Vector<double>& v : box.vertices)
      file.vertices.push_back(place(is_room ? Vector<double>{4 * v.x, 3 * v.y, 2.5 * v.z}
                                            : Vector<double>{0.6 * v.x, 0.2 + 1.2 * v.y, 2 * v.z}));
    for (const std::vector<std::size_t>& face : box.faces) {
      for (const std::size_t corner : face) file.corner.push_back(first + corner);
      file.face_begin.push_back(file.corner.size());
      file.face_place.push_back(file.face_begin.size());
      file.group.push_back(is_room ? 0 : 1);
    }
  }
  file.group_names = {"room", "box"};
  file.unit_of_place = "line";
  return file;
}

Vector<double> rounded(const Vector<double>& v, double unit) {
  return {std::round(v.x / unit) * unit, std::round(v.y / unit) * unit, std::round(v.z / unit) * unit};
}

/// A rotation, by a quaternion.
struct Turn {
  double w, x, y, z;
  explicit Turn(std::mt19937& random) {
    std::normal_distribution<double> draw;
    w = draw(random), x = draw(random), y = draw(random), z = draw(random);
    const double size = std::sqrt(w * w + x * x + y * y + z * z);
    w /= size, x /= size, y /= size, z /= size;
  }
  Vector<double> operator()(const Vector<double>& v) const {
    const Vector<double> axis{x, y, z};
    const Vector<double> t = 2 * cross(axis, v);
    return v + w * t + cross(axis, t);
  }
};

std::size_t values(const MeshFile& file, double Vector<double>::*coordinate) {
  std::set<double> found;
  for (const Vector<double>& v : file.vertices) found.insert(v.*coordinate);
  return found.size();
}

double distance_of(const MeshFile& file, std::size_t i, std::size_t j) {
  return norm(file.vertices[i] - file.vertices[j]);
}

TEST(AlignedFile, HasOneValueForEachPlane) {
  std::mt19937 random(7);
  for (const double unit : {1e-6, 1e-4, 1e-12})
    for (int k = 0; k < 100; ++k) {
      const Turn turn(random);
      MeshFile given = furnished_room([&](const Vector<double>& v) { return rounded(turn(v), unit); });
      given.precision = {0.5 * unit, "printed with some digits"};
      const Outcome<AlignedFile> found = aligned(given);
      ASSERT_TRUE(found) << found.reason();
      // The room's walls and the box's far sides: three values, four where the box touches none of two walls.
      std::multiset<std::size_t> counts{values(found->file, &Vector<double>::x),
                                        values(found->file, &Vector<double>::y),
                                        values(found->file, &Vector<double>::z)};
      EXPECT_EQ(counts, (std::multiset<std::size_t>{3, 3, 4}));
      EXPECT_LE(found->moved, 8 * given.precision.unit + 1e-14);
      EXPECT_GE(found->degrees, 0);
      EXPECT_LE(found->degrees, 63);  // a rotation of the cube is within 62.8 degrees of any
      // The same room: distances are those that they were before.
      const MeshFile before = furnished_room([](const Vector<double>& v) { return v; });
      ASSERT_EQ(found->file.vertices.size(), before.vertices.size());
      for (std::size_t i = 0; i < before.vertices.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_NEAR(distance_of(found->file, i, j), distance_of(before, i, j), 64 * unit + 1e-13);
      // No mirror image.
      const auto volume = [](const MeshFile& f) {
        const auto side = [&](std::size_t v) { return f.vertices[v] - f.vertices[0]; };
        return dot(side(1), cross(side(2), side(4)));
      };
      EXPECT_GT(volume(found->file) * volume(before), 0);
    }
}

TEST(AlignedFile, LeavesWhatLiesAlongTheAxes) {
  const MeshFile given = furnished_room([](const Vector<double>& v) { return v; });
  const Outcome<AlignedFile> found = aligned(given);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->degrees, 0);
  EXPECT_EQ(found->moved, 0);
  EXPECT_EQ(found->file.corner, given.corner);
  for (std::size_t i = 0; i < given.vertices.size(); ++i)
    EXPECT_EQ(norm(found->file.vertices[i] - given.vertices[i]), 0);
}

TEST(AlignedFile, GivesTheValueThatMostHaveWhereNothingTurns) {
  MeshFile given = furnished_room([](const Vector<double>& v) { return v; });
  given.precision = {1e-6, "printed with 7 digits"};
  given.vertices.back() = given.vertices.back() + Vector<double>{1e-6, -1e-6, 2e-6};
  const Outcome<AlignedFile> found = aligned(given);
  ASSERT_TRUE(found);
  const MeshFile before = furnished_room([](const Vector<double>& v) { return v; });
  EXPECT_EQ(norm(found->file.vertices.back() - before.vertices.back()), 0);
  EXPECT_NEAR(found->moved, std::sqrt(6.0) * 1e-6, 1e-12);
}

TEST(AlignedFile, BoundsHowFarCornersWereMoved) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> draw(-1e-6, 1e-6);
  for (int k = 0; k < 100; ++k) {
    MeshFile given = furnished_room([](const Vector<double>& v) { return v; });
    given.precision = {1e-6, "printed with 7 digits"};
    given.vertices.back() = given.vertices.back() + Vector<double>{draw(random), draw(random), draw(random)};
    const Outcome<AlignedFile> found = aligned(given);
    ASSERT_TRUE(found) << found.reason();
    Rational largest = 0;
    for (std::size_t i = 0; i < given.vertices.size(); ++i) {
      const auto square = [](double a, double b) {
        const Rational apart = Rational::exactly(a) - Rational::exactly(b);
        return apart * apart;
      };
      const Vector<double>& a = given.vertices[i];
      const Vector<double>& b = found->file.vertices[i];
      largest = std::max(largest, square(a.x, b.x) + square(a.y, b.y) + square(a.z, b.z));
    }
    const Rational bound = Rational::exactly(found->moved);
    EXPECT_LE(largest, bound * bound);
    EXPECT_LE(bound * bound, largest * (1 + Rational(1, 1000000000000)));
  }
}

TEST(AlignedFile, DoesNotDependOnTheUnit) {
  for (const double unit : {1e-80, 1e55}) {
    const MeshFile given = furnished_room([&](const Vector<double>& v) { return unit * v; });
    const Outcome<AlignedFile> found = aligned(given);
    ASSERT_TRUE(found) << found.reason();
    for (std::size_t i = 0; i < given.vertices.size(); ++i)
      EXPECT_EQ(norm((1 / unit) * (found->file.vertices[i] - given.vertices[i])), 0) << unit;
  }
}

TEST(AlignedFile, TakesFewDigitsForTheAuthorsOwn) {
  // Whole numbers are no roundings of others.
  MeshFile given = furnished_room([](const Vector<double>& v) { return rounded(10 * v, 1); });
  given.precision = {0.5, "printed with 2 digits"};
  const Outcome<AlignedFile> found = aligned(given);
  ASSERT_TRUE(found) << found.reason();
  EXPECT_EQ(found->moved, 0);
}

TEST(AlignedFile, RefusesWhatHasNoAxesOrIsTooFine) {
  MeshFile tetrahedron;
  const sample::Polyhedron solid = sample::tetrahedron();
  tetrahedron.vertices = solid.vertices;
  for (Vector<double>& v : tetrahedron.vertices) v = {v.x, v.y + v.x / 3, v.z + v.y / 5 + v.x / 7};
  for (const std::vector<std::size_t>& face : solid.faces) {
    tetrahedron.corner.insert(tetrahedron.corner.end(), face.begin(), face.end());
    tetrahedron.face_begin.push_back(tetrahedron.corner.size());
  }
  const Outcome<AlignedFile> skew = aligned(tetrahedron);
  ASSERT_FALSE(skew);
  EXPECT_NE(skew.reason().find("right angles"), std::string::npos);
  MeshFile coarse = furnished_room([](const Vector<double>& v) { return v; });
  for (std::size_t v = 8; v < 16; ++v)
    if (coarse.vertices[v].x > 0) coarse.vertices[v].x = 0.001;
  coarse.precision = {7e-4, "printed with 4 digits"};
  const Outcome<AlignedFile> flat = aligned(coarse);
  ASSERT_FALSE(flat);
  EXPECT_NE(flat.reason().find("no larger than the precision"), std::string::npos) << flat.reason();
  coarse.precision.unit = 3e-4;
  for (std::size_t v = 8; v < 10; ++v) coarse.vertices[v].z = v == 8 ? 2.4993 : 2.4986;
  const Outcome<AlignedFile> close = aligned(coarse);
  ASSERT_FALSE(close);
  EXPECT_NE(close.reason().find("more closely"), std::string::npos) << close.reason();
}

}  // namespace
}  // namespace radcert
