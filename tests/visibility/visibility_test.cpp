// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/visibility.h"

#include <gtest/gtest.h>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "tests/visibility/exact_sight.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

using sample::Exact;
using sample::ExactSight;
using sample::Numbers;

/// One triangle (0,0,0), (4,0,0), (0,4,0), that looks up.
Scene one_triangle() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  mesh.triangles = {{0, 1, 2}};
  return Scene(std::move(mesh));
}

bool free_points_see(const Scene& scene, const Vector<double>& p, const Vector<double>& q) {
  const bool there = visible(scene, {p, std::nullopt}, {q, std::nullopt});
  EXPECT_EQ(visible(scene, {q, std::nullopt}, {p, std::nullopt}), there);
  return there;
}

TEST(Visibility, IsHiddenFromBothSides) {
  const Scene scene = one_triangle();
  EXPECT_FALSE(free_points_see(scene, {1, 1, 1}, {1, 1, -1}));
  EXPECT_FALSE(free_points_see(scene, {-7, 1, 1}, {9, 1, -1}));
  EXPECT_TRUE(free_points_see(scene, {3, 3, 1}, {3, 3, -1}));
  EXPECT_TRUE(free_points_see(scene, {1, 1, 1}, {1, 1, 0.5}));
}

TEST(Visibility, IsNotHiddenByTheLinesOfSides) {
  // Past the obtuse corner (4,5) on the lines of the sides that meet there, within the triangle's box.
  const std::array<Vector<double>, 3> corners{Vector<double>{0, 0, 0}, {10, 10, 0}, {4, 5, 0}};
  for (std::size_t first = 0; first < 3; ++first) {
    TriangleMesh mesh;
    mesh.vertices = {corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]};
    mesh.triangles = {{0, 1, 2}};
    const Scene scene(std::move(mesh));
    EXPECT_TRUE(free_points_see(scene, {6, 7.5, 1}, {6, 7.5, -1}));
    EXPECT_TRUE(free_points_see(scene, {1, 2.5, 1}, {1, 2.5, -1}));
    EXPECT_FALSE(free_points_see(scene, {2, 2.5, 1}, {2, 2.5, -1}));
    EXPECT_FALSE(free_points_see(scene, {4, 4.5, 1}, {4, 4.5, -1}));
  }
}

TEST(Visibility, IsHiddenByGrazing) {
  const Scene scene = one_triangle();
  EXPECT_FALSE(free_points_see(scene, {2, 2, 1}, {2, 2, -1}));  // a side
  EXPECT_FALSE(free_points_see(scene, {0, 0, 1}, {0, 0, -1}));  // a vertex
  EXPECT_TRUE(free_points_see(scene, {2 + 0x1p-51, 2, 1}, {2 + 0x1p-51, 2, -1}));
  EXPECT_TRUE(free_points_see(scene, {-0x1p-1000, 0, 1}, {-0x1p-1000, 0, -1}));
}

TEST(Visibility, IsNotHiddenByTouching) {
  const Scene scene = one_triangle();
  EXPECT_TRUE(free_points_see(scene, {1, 1, 1}, {1, 1, 0}));
  EXPECT_TRUE(free_points_see(scene, {0, 0, 0}, {1, 1, -1}));
  EXPECT_TRUE(free_points_see(scene, {1, 1, 0}, {1, 1, 0}));
}

TEST(Visibility, IsHiddenWithinThePlane) {
  const Scene scene = one_triangle();
  EXPECT_FALSE(free_points_see(scene, {-1, 1, 0}, {5, 1, 0}));
  EXPECT_FALSE(free_points_see(scene, {1, 1, 0}, {2, 1, 0}));
  EXPECT_FALSE(free_points_see(scene, {-1, 0, 0}, {5, 0, 0}));   // along a side
  EXPECT_FALSE(free_points_see(scene, {-1, 1, 0}, {1, -1, 0}));  // through a vertex
  EXPECT_TRUE(free_points_see(scene, {-1, 1, 0}, {0, 0, 0}));    // to a vertex
  EXPECT_TRUE(free_points_see(scene, {-1, 1, 0}, {0, 1, 0}));    // to a side
  EXPECT_TRUE(free_points_see(scene, {-2, 1, 0}, {-1, 1, 0}));
  EXPECT_TRUE(free_points_see(scene, {3, 3, 0}, {5, 1, 0}));
}

TEST(Visibility, IsNotHiddenByThePlanesOfItsEnds) {
  const Scene room = sample::cube_room();
  // Rounded points of the floor, above and below it.
  for (const double z : {-1e-17, 0.0, 1e-17})
    for (std::size_t own = 0; own < room.triangle_count(); ++own) {
      const auto [a, b, c] = room.corners(own);
      if (a.z != 0 || b.z != 0 || c.z != 0) continue;
      for (std::size_t k = 0; k < room.triangle_count(); ++k) {
        const Vector<double> q = sample::point_of(room, k, 0.25, 0.5);
        EXPECT_TRUE(visible(room, {{0.25, 0.375, z}, own}, {q, k})) << z << " " << k;
      }
      EXPECT_TRUE(visible(room, {{0.25, 0.375, 1e-17}, own}, {{0.5, 0.625, -1e-17}, own}));
    }
}

TEST(Visibility, IsHiddenBehindATrianglesBack) {
  const Scene scene = one_triangle();
  EXPECT_TRUE(visible(scene, {{1, 1, 0}, 0}, {{1, 1, 1}, std::nullopt}));
  EXPECT_FALSE(visible(scene, {{1, 1, 0}, 0}, {{1, 1, -1}, std::nullopt}));
  EXPECT_FALSE(visible(scene, {{1, 1, -1}, std::nullopt}, {{1, 1, 0}, 0}));
  EXPECT_EQ(blocker(scene, {{1, 1, -1}, std::nullopt}, {{1, 1, 0}, 0}), 0U);
  EXPECT_TRUE(visible(scene, {{1, 1, 0}, 0}, {{7, 1, 0}, std::nullopt}));
}

void expect_as_every_triangle_says(const Scene& scene, Numbers& random, int count, bool on_grid,
                                   double size = 1) {
  const ExactSight sight(scene);
  int hidden = 0;
  for (int k = 0; k < count; ++k) {
    const auto place = [&] { return size * (on_grid ? random.on_grid(32) : random.fraction()); };
    const Vector<double> p{place(), place(), place()};
    const std::size_t of = random.below(scene.triangle_count());
    const auto at = sample::random_parameters(random, 16);
    const Vector<double> q = sample::point_of(scene, of, at.s, at.t);
    bool blocked = sight.height(of, sample::exact(p)) < 0;
    bool touches = false;
    for (std::size_t t = 0; t < scene.triangle_count(); ++t) {
      if (sight.in_plane(t, of)) continue;
      const auto passes = sight.passes(t, sample::exact(p), sample::exact(q));
      blocked = blocked || passes == 1;
      touches = touches || !passes;
    }
    if (touches && !blocked) continue;
    hidden += blocked ? 1 : 0;
    EXPECT_EQ(visible(scene, {p, std::nullopt}, {q, of}), !blocked)
        << p.x << " " << p.y << " " << p.z << ", triangle " << of;
    EXPECT_EQ(visible(scene, {q, of}, {p, std::nullopt}), !blocked);
  }
  EXPECT_GT(hidden, count / 8);
  EXPECT_LT(hidden, count);
}

TEST(Visibility, IsWhatEveryTriangleSays) {
  Numbers random(31);
  expect_as_every_triangle_says(sample::boxes_in_box(1, true, 6), random, 250, true);
  expect_as_every_triangle_says(sample::boxes_in_box(2, false, 6), random, 250, false);
  expect_as_every_triangle_says(sample::l_room(), random, 250, true, 2);
}

/// Whether the open segment meets the closed triangle, by its two ends on a line or by the three sides' half
/// planes, in rational numbers: nothing is left undecided.
bool meets_exactly(const std::array<Vector<Rational>, 3>& t, const Vector<Rational>& p,
                   const Vector<Rational>& q) {
  const Vector<Rational> normal = cross(t[1] - t[0], t[2] - t[0]);
  const Vector<Rational> along = q - p;
  // The parameters in (0,1) at which p + r along is in the plane and to the left of each side.
  Rational low = 0;
  Rational high = 1;
  bool low_is_open = true;
  bool high_is_open = true;
  const auto keep_at_least_zero = [&](const Rational& at_p, const Rational& slope) {
    if (slope.sign() == 0) return at_p.sign() >= 0;
    const Rational root = -at_p / slope;
    if (slope.sign() > 0 && root > low) {
      low = root;
      low_is_open = false;
    }
    if (slope.sign() < 0 && root < high) {
      high = root;
      high_is_open = false;
    }
    return true;
  };
  const Rational height = dot(normal, p - t[0]);
  const Rational rise = dot(normal, along);
  if (!keep_at_least_zero(height, rise) || !keep_at_least_zero(-height, -rise)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<Rational> inwards = cross(normal, t[(k + 1) % 3] - t[k]);
    if (!keep_at_least_zero(dot(inwards, p - t[k]), dot(inwards, along))) return false;
  }
  return low < high || (low == high && !low_is_open && !high_is_open);
}

TEST(Visibility, IsItsDefinitionForDegenerateQueries) {
  // Triangles and points on a coarse grid: segments through corners and sides, within planes, that end on
  // other triangles.
  Numbers random(33);
  constexpr std::size_t steps = 4;
  const auto coordinate = [&] { return static_cast<double>(random.below(steps + 1)); };
  const auto grid_point = [&] { return Vector<double>{coordinate(), coordinate(), coordinate()}; };
  int hidden = 0;
  int count = 0;
  for (int trial = 0; trial < 12; ++trial) {
    TriangleMesh mesh;
    while (mesh.triangles.size() < 8) {
      const Vector<double> a = grid_point();
      const Vector<double> b = grid_point();
      const Vector<double> c = grid_point();
      if (cross(b - a, c - a) == Vector<double>{}) continue;
      const std::size_t first = mesh.vertices.size();
      mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    mesh.group.assign(mesh.triangles.size(), 0);
    mesh.group_names = {""};
    mesh.face.assign(mesh.triangles.size(), 0);
    const Scene scene(std::move(mesh));
    const ExactSight sight(scene);
    const auto end = [&]() -> ScenePoint {
      if (random.below(2) == 0) return {grid_point(), std::nullopt};
      const std::size_t of = random.below(scene.triangle_count());
      const std::size_t i = random.below(3);
      return {sample::point_of(scene, of, 0.5 * static_cast<double>(i),
                               0.5 * static_cast<double>(random.below(3 - i))),
              of};
    };
    for (int k = 0; k < 200; ++k) {
      const ScenePoint p = end();
      const ScenePoint q = end();
      const bool one_plane = p.triangle && q.triangle && sight.in_plane(*p.triangle, *q.triangle);
      const Vector<Rational> at_p = sample::exact(p.at);
      const Vector<Rational> at_q = sample::exact(q.at);
      bool sees = one_plane || p.at == q.at ||
                  ((!p.triangle || sight.height(*p.triangle, at_q) >= 0) &&
                   (!q.triangle || sight.height(*q.triangle, at_p) >= 0));
      for (std::size_t t = 0; t < scene.triangle_count() && !(p.at == q.at); ++t) {
        if ((p.triangle && sight.in_plane(t, *p.triangle)) || (q.triangle && sight.in_plane(t, *q.triangle)))
          continue;
        sees = sees && !meets_exactly(sight.corners(t), at_p, at_q);
      }
      ++count;
      hidden += sees ? 0 : 1;
      EXPECT_EQ(visible(scene, p, q), sees) << "trial " << trial << ": " << p.at.x << " " << p.at.y << " "
                                            << p.at.z << " to " << q.at.x << " " << q.at.y << " " << q.at.z;
      EXPECT_EQ(visible(scene, q, p), sees) << "trial " << trial << ", turned";
    }
  }
  EXPECT_GT(hidden, count / 4);
  EXPECT_LT(hidden, 3 * count / 4);
}

TEST(Visibility, SeesPastNarrowGaps) {
  for (const double gap : {1e-1, 1e-6, 1e-12}) {
    const Scene scene = sample::cube_in_cube(gap);
    // Along the gap, and from within it into the inner cube.
    EXPECT_TRUE(free_points_see(scene, {0, 0.5, gap / 2}, {1, 0.5, gap / 2}));
    EXPECT_FALSE(free_points_see(scene, {0, 0.5, gap / 2}, {1, 0.5, 2 * gap}));
    EXPECT_FALSE(free_points_see(scene, {0.5, 0.5, gap / 2}, {0.5, 0.5, 1}));
  }
}

TEST(Visibility, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = sample::boxes_in_box(3, false, 10);
  Numbers random(32);
  std::vector<std::pair<Vector<double>, Vector<double>>> pairs(2000);
  for (auto& [p, q] : pairs) {
    p = {random.fraction(), random.fraction(), random.fraction()};
    q = {random.fraction(), random.fraction(), random.fraction()};
  }
  const auto answers = [&] {
    std::vector<std::optional<std::size_t>> result(pairs.size());
    parallel_for(pairs.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        result[k] = blocker(scene, {pairs[k].first, std::nullopt}, {pairs[k].second, std::nullopt});
    });
    return result;
  };
  const auto parallel = answers();
  const ThreadLimit limit(1);
  EXPECT_EQ(answers(), parallel);
}

TEST(Visibility, RefusesWhatItCannotUse) {
  const Scene scene = one_triangle();
  EXPECT_THROW(static_cast<void>(visible(scene, {{1e31, 0, 0}, std::nullopt}, {{0, 0, 0}, std::nullopt})),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(visible(scene, {{1, 0, 0}, 1}, {{0, 0, 0}, std::nullopt})),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
