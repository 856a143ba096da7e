// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/point_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "tests/visibility/exact_sight.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

using sample::area;
using sample::Exact;
using sample::ExactPolygon;
using sample::ExactSight;
using sample::Numbers;
using sample::place;

std::vector<ExactPolygon> exact_parts(const Scene& scene, const Viewpoint& from, std::size_t triangle,
                                      const VisibleRegion& region) {
  std::vector<ExactPolygon> parts;
  for (const VisiblePart& part : region.parts) parts.push_back(exact_corners(scene, from, triangle, part));
  return parts;
}

Rational seen_area(const Scene& scene, const Viewpoint& from, std::size_t triangle) {
  Rational sum = 0;
  for (const ExactPolygon& part : exact_parts(scene, from, triangle, visible_region(scene, from, triangle)))
    sum += area(part);
  return sum;
}

std::string words(const Viewpoint& from, std::size_t triangle) {
  return "P (" + shortest(from.point.x) + ", " + shortest(from.point.y) + ", " + shortest(from.point.z) +
         "), normal (" + shortest(from.normal.x) + ", " + shortest(from.normal.y) + ", " +
         shortest(from.normal.z) + "), triangle " + std::to_string(triangle);
}

Viewpoint on(const Scene& scene, std::size_t triangle, const ParameterPoint<double>& at) {
  return {sample::point_of(scene, triangle, at.s, at.t), sample::normal_of(scene, triangle), triangle};
}

/// Points of the triangle are seen exactly where they lie in a part, and in one part only.
void expect_as_every_triangle_says(const Scene& scene, const ExactSight& sight, const Viewpoint& from,
                                   std::size_t triangle, Numbers& random, int count) {
  SCOPED_TRACE(words(from, triangle));
  const VisibleRegion region = visible_region(scene, from, triangle);
  const std::vector<ExactPolygon> parts = exact_parts(scene, from, triangle, region);
  EXPECT_EQ(parts.empty(), region.sight == Sight::nothing);
  Rational total = 0;
  for (const ExactPolygon& part : parts) {
    EXPECT_GT(area(part), Rational(0));
    total += area(part);
    for (std::size_t k = 0; k < part.size(); ++k) {
      const auto first = part[(k + 1) % part.size()] - part[k];
      const auto second = part[(k + 2) % part.size()] - part[(k + 1) % part.size()];
      EXPECT_GT(cross(first, second), Rational(0)) << "a corner that does not turn left";
      EXPECT_GE(part[k].s, Rational(0));
      EXPECT_GE(part[k].t, Rational(0));
      EXPECT_LE(part[k].s + part[k].t, Rational(1));
    }
  }
  EXPECT_LE(total, Rational(1, 2));
  EXPECT_EQ(total == Rational(1, 2), region.sight == Sight::whole);
  const Exact p = sample::exact(from.point);
  const Exact normal = sample::exact(from.normal);
  const auto& [a, b, c] = sight.corners(triangle);
  const bool faces =
      sample::sign_of_volume(a, b, c, p) > 0 && !(from.triangle && sight.in_plane(triangle, *from.triangle));
  for (int k = 0; k < count; ++k) {
    constexpr std::size_t steps = 61;  // a prime: few points fall on borders
    const auto at = sample::random_parameters(random, steps);
    const ParameterPoint<Rational> exact_at{Rational(std::lround(at.s * steps), steps),
                                            Rational(std::lround(at.t * steps), steps)};
    const Exact q = sight.point(triangle, exact_at.s, exact_at.t);
    const int above = dot(normal, q - p).sign();
    const std::optional<bool> open = sight.sees(p, from.triangle, q, triangle);
    if (above == 0 || !open) continue;
    const bool seen = faces && above > 0 && *open;
    int inside = 0;
    bool on_border = false;
    for (const ExactPolygon& part : parts) {
      inside += place(part, exact_at) > 0 ? 1 : 0;
      on_border = on_border || place(part, exact_at) == 0;
    }
    if (on_border) {
      EXPECT_TRUE(seen) << exact_at.s.to_text() << " " << exact_at.t.to_text();
    } else {
      EXPECT_EQ(inside, seen ? 1 : 0) << exact_at.s.to_text() << " " << exact_at.t.to_text();
    }
  }
}

TEST(PointView, SeesAllOfAConvexRoom) {
  const Scene room = sample::cube_room();
  for (std::size_t own = 0; own < room.triangle_count(); ++own)
    for (std::size_t k = 0; k < room.triangle_count(); ++k)
      EXPECT_EQ(visible_region(room, on(room, own, {0.25, 0.5}), k).sight,
                room.plane(own) == room.plane(k) ? Sight::nothing : Sight::whole);
}

TEST(PointView, SeesWhatEveryTriangleSaysAmongBoxesOnAGrid) {
  Numbers random(11);
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Scene scene = sample::boxes_in_box(seed, true, 4);
    const ExactSight sight(scene);
    for (int k = 0; k < 40; ++k) {
      const std::size_t own = random.below(scene.triangle_count());
      const Viewpoint from = on(scene, own, sample::random_parameters(random, 16));
      expect_as_every_triangle_says(scene, sight, from, random.below(scene.triangle_count()), random, 6);
    }
  }
}

TEST(PointView, SeesWhatEveryTriangleSaysAmongBoxesAnywhere) {
  Numbers random(12);
  const Scene scene = sample::boxes_in_box(4, false, 5);
  const ExactSight sight(scene);
  for (int k = 0; k < 80; ++k) {
    const std::size_t own = random.below(scene.triangle_count());
    const Viewpoint from = on(scene, own, {random.fraction() / 2, random.fraction() / 2});
    expect_as_every_triangle_says(scene, sight, from, random.below(scene.triangle_count()), random, 6);
  }
}

/// Triangles that look anywhere, one in each of some cells of a grid.
Scene loose_triangles(Numbers& random, std::size_t cells) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < cells; ++i)
    for (std::size_t j = 0; j < cells; ++j)
      for (std::size_t k = 0; k < cells; ++k) {
        const std::size_t begin = mesh.vertices.size();
        const auto place_in = [&](std::size_t cell) {
          return static_cast<double>(cell) + random.between(0.01, 0.99);
        };
        for (int corner = 0; corner < 3; ++corner)
          mesh.vertices.push_back({place_in(i), place_in(j), place_in(k)});
        mesh.triangles.push_back({begin, begin + 1, begin + 2});
      }
  return Scene(std::move(mesh));
}

TEST(PointView, SeesWhatEveryTriangleSaysAmongLooseTriangles) {
  Numbers random(13);
  for (int round = 0; round < 4; ++round) {
    const Scene scene = loose_triangles(random, 3);
    const ExactSight sight(scene);
    for (int k = 0; k < 60; ++k) {
      // Free points, with a horizon anywhere; now and then a coordinate of a vertex, so that planes pass
      // through P.
      Viewpoint from{{random.between(0, 3), random.between(0, 3), random.between(0, 3)},
                     {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)},
                     std::nullopt};
      if (k % 4 == 0) from.point.x = scene.vertex(random.below(scene.mesh().vertices.size())).x;
      expect_as_every_triangle_says(scene, sight, from, random.below(scene.triangle_count()), random, 8);
    }
  }
}

TEST(PointView, DoesNotDependOnTheOrderOfTheTriangles) {
  Numbers random(14);
  const Scene scene = sample::boxes_in_box(5, true, 6);
  TriangleMesh mesh = scene.mesh();
  const std::size_t count = scene.triangle_count();
  std::vector<std::size_t> place_of(count);
  for (std::size_t k = 0; k < count; ++k) place_of[k] = k;
  for (std::size_t k = count; k > 1; --k) std::swap(place_of[k - 1], place_of[random.below(k)]);
  for (std::size_t k = 0; k < count; ++k) mesh.triangles[place_of[k]] = scene.mesh().triangles[k];
  const Scene shuffled(std::move(mesh));
  for (int k = 0; k < 60; ++k) {
    const std::size_t own = random.below(count);
    Viewpoint from = on(scene, own, sample::random_parameters(random, 16));
    const std::size_t triangle = random.below(count);
    SCOPED_TRACE(words(from, triangle));
    const Rational before = seen_area(scene, from, triangle);
    from.triangle = place_of[own];
    EXPECT_EQ(seen_area(shuffled, from, place_of[triangle]), before);
  }
}

TEST(PointView, SeesPastASquareWhatItsShadowLeaves) {
  // From (x, y, 0) the square [0,1/2]^2 at 1/2 throws the shadow [-x, 1-x] [-y, 1-y] at 1.
  const Scene scene = sample::occluded_squares();
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j) {
      const Viewpoint from{{i / 8.0, j / 8.0, 0}, {0, 0, 1}, 0};
      const Rational seen = seen_area(scene, from, 2) + seen_area(scene, from, 3);
      EXPECT_EQ(seen, Rational(1) - Rational(8 - i, 8) * Rational(8 - j, 8)) << i << " " << j;
      if (i == 8 || j == 8) {
        EXPECT_EQ(visible_region(scene, from, 2).sight, Sight::whole);
      }
      if (i == 0 && j == 0) {
        EXPECT_EQ(visible_region(scene, from, 2).sight, Sight::nothing);
      }
    }
}

/// As occluded_squares, and another square whose cone from (0,0,0) is the same, coplanar ones stacked on it,
/// one of which shares its corners with it and with none of them.
TEST(PointView, HidesOnceWhatSeveralHide) {
  TriangleMesh mesh = sample::occluded_squares().mesh();
  const auto add = [&](double x0, double x1, double y0, double y1, double z) {
    const std::size_t begin = mesh.vertices.size();
    for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
      mesh.vertices.push_back({x, y, z});
    mesh.triangles.push_back({begin, begin + 1, begin + 2});
    mesh.triangles.push_back({begin, begin + 2, begin + 3});
  };
  add(0, 0.25, 0, 0.25, 0.25);     // the same cone from (0,0,0)
  add(0, 0.5, 0, 0.5, 0.5);        // again
  add(0.25, 0.5, 0.25, 0.5, 0.5);  // a part of it
  add(0, 0.75, 0, 0.75, 0.75);
  const Scene scene(std::move(mesh));
  const Viewpoint from{{0, 0, 0}, {0, 0, 1}, 0};
  EXPECT_EQ(visible_region(scene, from, 2).sight, Sight::nothing);
  EXPECT_EQ(visible_region(scene, from, 3).sight, Sight::nothing);
  // From (1/2, 1/2, 0) the shadows are [0,1/2]^2 of a height of 1/2, and [-1,1/2]^2 and [1/3,5/6]... of the
  // others.
  const Viewpoint middle{{0.5, 0.5, 0}, {0, 0, 1}, 0};
  const auto shadow = [](const Rational& z, const Rational& x) {
    return Rational(1, 2) + (x - Rational(1, 2)) / z;
  };
  Rational reach = 0;
  for (const auto& [z, x] : {std::pair{Rational(1, 4), Rational(1, 4)},
                             {Rational(1, 2), Rational(1, 2)},
                             {Rational(3, 4), Rational(3, 4)}})
    reach = std::max(reach, shadow(z, x));
  EXPECT_EQ(seen_area(scene, middle, 2) + seen_area(scene, middle, 3), Rational(1) - reach * reach);
}

/// Two triangles, the second behind the first as seen from (0,0,0).
Scene one_behind_the_other(const std::array<Vector<double>, 3>& near,
                           const std::array<Vector<double>, 3>& far) {
  TriangleMesh mesh;
  mesh.vertices = {near[0], near[1], near[2], far[0], far[1], far[2]};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  return Scene(std::move(mesh));
}

TEST(PointView, TellsNearFromFarThoughBoxesOverlap) {
  const Scene scene = one_behind_the_other({Vector<double>{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                           {Vector<double>{1.01, 0, 0}, {0, 0, 1.01}, {0, 1.01, 0}});
  const Viewpoint from{{0, 0, 0}, {1, 1, 1}, std::nullopt};
  EXPECT_EQ(visible_region(scene, from, 0).sight, Sight::whole);
  EXPECT_EQ(visible_region(scene, from, 1).sight, Sight::nothing);
}

TEST(PointView, TellsNearFromFarThoughEachCutsTheOthersPlane) {
  // Long triangles at heights 1 and 2 that cross at right angles, each tilted about its length; then all is
  // slanted by z + x/2, so that their boxes overlap.
  std::array<Vector<double>, 3> near{Vector<double>{3, -0.1, 0.91}, {-3, -0.1, 0.91}, {0, 0.2, 1.18}};
  std::array<Vector<double>, 3> far{Vector<double>{-0.1, -3, 1.91}, {-0.1, 3, 1.91}, {0.2, 0, 2.18}};
  for (std::size_t k = 0; k < 3; ++k) {
    near[k].z += near[k].x / 2;
    far[k].z += far[k].x / 2;
  }
  const Scene scene = one_behind_the_other(near, far);
  const ExactSight sight(scene);
  Numbers random(16);
  for (const double x : {0.0, 0.01, -0.02}) {
    const Viewpoint from{{x, 0, 0}, {-0.5, 0, 1}, std::nullopt};
    EXPECT_EQ(visible_region(scene, from, 0).sight, Sight::whole);
    EXPECT_EQ(visible_region(scene, from, 1).sight, Sight::part);
    expect_as_every_triangle_says(scene, sight, from, 0, random, 50);
    expect_as_every_triangle_says(scene, sight, from, 1, random, 50);
  }
}

TEST(PointView, SeesPastWhatItSeesEdgeOn) {
  // P in the plane of the square between: nothing is hidden below or above.
  const Scene scene = sample::occluded_squares();
  const Viewpoint from{{0.75, 0.25, 0.5}, {0, 0, 1}, std::nullopt};
  EXPECT_EQ(visible_region(scene, from, 2).sight, Sight::whole);
  EXPECT_EQ(visible_region(scene, from, 3).sight, Sight::whole);
  EXPECT_EQ(visible_region(scene, from, 4).sight, Sight::nothing);
  EXPECT_EQ(visible_region(scene, from, 0).sight, Sight::nothing);  // below the horizon
}

TEST(PointView, CutsByTheHorizon) {
  const Scene room = sample::cube_room();
  // From the middle, looking to +x: the half x > 1/2 of the floor.
  const Viewpoint from{{0.5, 0.5, 0.5}, {1, 0, 0}, std::nullopt};
  Rational seen = 0;
  for (std::size_t k = 0; k < room.triangle_count(); ++k) seen += seen_area(room, from, k);
  EXPECT_EQ(seen, Rational(3));  // one face and four halves, a face having the area 1 in its parameters
}

TEST(PointView, IsHiddenByWhatReachesInByAHair) {
  // Triangles that stand before the source's side x = 0 from the left, and reach across it by `hair`; others
  // far to the right, so that those are in boxes of their own.
  for (const double hair : {0x1p-52, 0x1p-50, -0x1p-52, 0.0}) {
    TriangleMesh mesh;
    const auto add = [&mesh](const Vector<double>& a, const Vector<double>& b, const Vector<double>& c) {
      const std::size_t first = mesh.vertices.size();
      mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
      mesh.triangles.push_back({first, first + 1, first + 2});
    };
    add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (int k = 0; k < 32; ++k) {
      const double z = 0.3 + 0.01 * k;
      add({-1, 0, z}, {hair, 0.25, z}, {-1, 0.5, z});
      add({5.0 + k, 0, 0}, {5.5 + k, 0, 0}, {5.0 + k, 1, 0});
    }
    const Scene scene(std::move(mesh));
    const Viewpoint from{{0, 0.25, 1}, {0, 0, -1}, std::nullopt};
    EXPECT_EQ(visible_region(scene, from, 0).sight, hair > 0 ? Sight::part : Sight::whole) << hair;
  }
}

TEST(PointView, IsHiddenByWhatReachesInByLessThanRounding) {
  // The tip of a triangle lies on the plane through P and the source's side, but for its rounding. The rest
  // of the triangle lies further out in each coordinate, so that its box reaches as far in as the tip.
  Numbers random(17);
  int seen_in_part = 0;
  constexpr int count = 500;
  for (int k = 0; k < count; ++k) {
    const auto vector = [&](double z) {
      return Vector<double>{random.between(-1, 1), random.between(-1, 1), z + random.fraction()};
    };
    const Vector<double> eye = vector(-1);
    const Vector<double> a = vector(2);
    const Vector<double> b = vector(2);
    Vector<double> c = vector(2);
    if (dot(cross(b - a, c - a), eye - a) < 0) c = a + (a - c);
    const Vector<double> inwards = cross(b - eye, a - eye);
    const Vector<double> out{-std::copysign(0.2, inwards.x), -std::copysign(0.2, inwards.y),
                             -std::copysign(0.2, inwards.z)};
    const double s = random.between(0.1, 0.3);
    const double t = random.between(0.1, 0.3);
    const Vector<double> tip = eye + s * (a - eye) + t * (b - eye);
    TriangleMesh mesh;
    mesh.vertices = {a, b, c, tip, tip + out, tip + Vector<double>{0.5 * out.x, out.y, 0.75 * out.z}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const Exact from = sample::exact(eye);
    const Exact normal = cross(sample::exact(b) - from, sample::exact(a) - from);
    const bool reaches_in = dot(normal, sample::exact(tip) - from).sign() > 0;
    const Scene scene(std::move(mesh));
    EXPECT_EQ(visible_region(scene, {eye, {0, 0, 1}, std::nullopt}, 0).sight,
              reaches_in ? Sight::part : Sight::whole)
        << k;
    seen_in_part += reaches_in ? 1 : 0;
  }
  EXPECT_GT(seen_in_part, count / 4);
}

TEST(PointView, IsHiddenByWhatStandsAtTheEndsOfItsHull) {
  // P at the origin, the source across one axis, and between them a triangle within a hundredth of P or of
  // the source: at either end of the box about both, in each coordinate.
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (const double away : {0.004, 0.996}) {
        const auto across = [&](double x, double y, double scale) {
          std::array<double, 3> v{};
          v[axis] = side * scale;
          v[(axis + 1) % 3] = scale * x;
          v[(axis + 2) % 3] = side * scale * y;
          return Vector<double>{v[0], v[1], v[2]};
        };
        TriangleMesh mesh;
        mesh.vertices = {across(-1, -1, 1),        across(0, 1, 1),      across(1, -1, 1),
                         across(-0.5, -0.5, away), across(0, 0.5, away), across(0.5, -0.5, away)};
        mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
        EXPECT_EQ(visible_region(Scene(std::move(mesh)), {{0, 0, 0}, across(0, 0, 1), std::nullopt}, 0).sight,
                  Sight::part)
            << axis << " " << side << " " << away;
      }
}

TEST(PointView, IsNotCutByTheHorizonOfItsOwnPlane) {
  // Rounding puts P above or below the floor: the walls stay whole either way.
  const Scene room = sample::cube_room();
  for (const double z : {-1e-17, 0.0, 1e-17})
    for (std::size_t own = 0; own < room.triangle_count(); ++own) {
      const auto [a, b, c] = room.corners(own);
      if (a.z != 0 || b.z != 0 || c.z != 0) continue;
      for (std::size_t k = 0; k < room.triangle_count(); ++k)
        EXPECT_EQ(visible_region(room, {{0.3, 0.4, z}, {0, 0, 1}, own}, k).sight,
                  room.plane(own) == room.plane(k) ? Sight::nothing : Sight::whole);
    }
}

TEST(PointView, RoundsCornersAsItSays) {
  Numbers random(15);
  const Scene scene = sample::boxes_in_box(6, false, 6);
  Rational worst = 0;
  for (int k = 0; k < 200; ++k) {
    const std::size_t own = random.below(scene.triangle_count());
    const Viewpoint from = on(scene, own, {random.fraction() / 2, random.fraction() / 2});
    const std::size_t triangle = random.below(scene.triangle_count());
    for (const VisiblePart& part : visible_region(scene, from, triangle).parts) {
      const ExactPolygon exact = exact_corners(scene, from, triangle, part);
      ASSERT_EQ(exact.size(), part.corners.size());
      for (std::size_t i = 0; i < exact.size(); ++i) {
        worst = std::max(worst, abs(exact[i].s - Rational::exactly(part.corners[i].s)));
        worst = std::max(worst, abs(exact[i].t - Rational::exactly(part.corners[i].t)));
      }
    }
  }
  EXPECT_LE(worst, Rational::exactly(0x1p-51));
  EXPECT_GT(worst, Rational(0));
}

TEST(PointView, DecidesBeyondTheDigitsOfDoubles) {
  // A square slid by one part in 2^52 leaves a slit of that width.
  for (const double slit : {0.0, 0x1p-52}) {
    TriangleMesh mesh = sample::occluded_squares().mesh();
    for (std::size_t v = 8; v < 12; ++v) mesh.vertices[v].x += slit;
    const Scene scene(std::move(mesh));
    const Viewpoint from{{0, 0, 0}, {0, 0, 1}, 0};
    const Rational seen = seen_area(scene, from, 2) + seen_area(scene, from, 3);
    EXPECT_EQ(seen, Rational::exactly(2 * slit));
  }
}

TEST(PointView, RefusesWhatItCannotUse) {
  const Scene room = sample::cube_room();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(PointView(room, {{0.5, 0.5, infinity}, {0, 0, 1}, std::nullopt}), ContractViolation);
  EXPECT_THROW(PointView(room, {{0.5, 0.5, 0.5}, {0, 0, 0}, std::nullopt}), ContractViolation);
  EXPECT_THROW(PointView(room, {{0.5, 0.5, 0.5}, {0, 0, 1}, 12}), ContractViolation);
  PointView view(room, {{0.5, 0.5, 0.5}, {0, 0, 1}, std::nullopt});
  EXPECT_THROW(static_cast<void>(view.region(12)), ContractViolation);
}

}  // namespace
}  // namespace radcert
