// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/sight_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "radcert/geometry/orientation.h"
#include "tests/visibility/exact_sight.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

using sample::Exact;
using sample::Numbers;
using Side = SightGeometry::Side;

/// Coordinates are tenths: of the decimals many determinants would be zero, of the doubles that stand for
/// them few are.
double tenths(Numbers& random, std::size_t count) { return static_cast<double>(random.below(count)) * 0.1; }

Scene triangles_of_tenths(Numbers& random) {
  TriangleMesh mesh;
  for (std::size_t k = 0; k < 12; ++k)
    mesh.vertices.push_back({tenths(random, 8), tenths(random, 8), 1 + tenths(random, 3)});
  // Any three that are not on one line.
  while (mesh.triangles.size() < 8) {
    const VertexTriple t{random.below(12), random.below(12), random.below(12)};
    const Exact a = sample::exact(mesh.vertices[t[0]]);
    const Exact normal =
        cross(sample::exact(mesh.vertices[t[1]]) - a, sample::exact(mesh.vertices[t[2]]) - a);
    if (!(normal == Exact{0, 0, 0})) mesh.triangles.push_back(t);
  }
  return Scene(std::move(mesh));
}

/// The vertices of the scene, each once.
std::vector<std::size_t> vertices_of(const Scene& scene) {
  std::set<std::size_t> all;
  for (std::size_t k = 0; k < scene.triangle_count(); ++k)
    for (const std::size_t v : scene.vertices(k)) all.insert(v);
  return {all.begin(), all.end()};
}

/// Sides and their normals into the side, by rational numbers.
class ExactSides {
public:
  ExactSides(const Scene& scene, const Vector<double>& eye) : scene_(scene), eye_(sample::exact(eye)) {}
  [[nodiscard]] Exact ray(std::size_t vertex) const { return sample::exact(scene_.vertex(vertex)) - eye_; }
  [[nodiscard]] Exact normal(std::size_t from, std::size_t to) const { return cross(ray(from), ray(to)); }

private:
  const Scene& scene_;
  Exact eye_;
};

bool is_zero(const Exact& v) { return v == Exact{0, 0, 0}; }

SizedVector<double> rounded_ray(const Vector<double>& to, const Vector<double>& from) {
  const Vector<double> value = to - from;
  return {value, sizes(value)};
}

/// Whether each coordinate is within k roundings of its size.
bool is_within(const SizedVector<double>& v, const Exact& exact, int k) {
  const auto near = [&](double value, double size, const Rational& truth) {
    return abs(truth - Rational::exactly(value)) <=
           Rational(k) * Rational::exactly(size) * Rational::exactly(unit_roundoff<double>());
  };
  return near(v.value.x, v.size.x, exact.x) && near(v.value.y, v.size.y, exact.y) &&
         near(v.value.z, v.size.z, exact.z);
}

TEST(SizedVector, BoundsWhatProductsAreOffBy) {
  // Coordinates a little above powers of two, where a rounding is all of a unit.
  Numbers random(70);
  const auto coordinate = [&] { return (random.below(2) == 0 ? 1 : -1) * (1 + 0x1p-20 * random.fraction()); };
  const auto point = [&] { return Vector<double>{coordinate(), coordinate(), coordinate()}; };
  double most_units = 0;
  for (int k = 0; k < 8000; ++k) {
    const Vector<double> eye = 0x1p-25 * point();
    std::array<SizedVector<double>, 5> rays;
    std::array<Exact, 5> exact_rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Vector<double> vertex = point();
      rays[i] = rounded_ray(vertex, eye);
      exact_rays[i] = sample::exact(vertex) - sample::exact(eye);
      ASSERT_TRUE(is_within(rays[i], exact_rays[i], 1));
    }
    const SizedVector<double> n = sized_cross(rays[0], rays[1]);
    const SizedVector<double> m = sized_cross(rays[2], rays[3]);
    const SizedVector<double> corner = sized_cross(n, m);
    const Exact exact_n = cross(exact_rays[0], exact_rays[1]);
    const Exact exact_corner = cross(exact_n, cross(exact_rays[2], exact_rays[3]));
    ASSERT_TRUE(is_within(n, exact_n, SightGeometry::rounding_of_normal));
    ASSERT_TRUE(is_within(corner, exact_corner, SightGeometry::rounding_of_direction));
    const auto off_by = [&](const SizedVector<double>& a, const SizedVector<double>& b,
                            const Rational& exact) {
      const Rational off = abs(Rational::exactly(dot(a.value, b.value)) - exact);
      EXPECT_LE(off, Rational::exactly(dot_rounding(a, b)));
      return off.to_double() / (unit_roundoff<double>() * dot(a.size, b.size));
    };
    most_units = std::max(most_units, off_by(rays[4], n, dot(exact_rays[4], exact_n)));
    const SizedVector<double> other = sized_cross(rays[4], rays[0]);
    off_by(corner, other, dot(exact_corner, cross(exact_rays[4], exact_rays[0])));
  }
  EXPECT_GT(most_units, 2.5);
}

TEST(SightGeometry, KnowsTheSignsThatRationalNumbersHave) {
  Numbers random(71);
  int close = 0;
  int backwards = 0;
  for (int round = 0; round < 40; ++round) {
    const Scene scene = triangles_of_tenths(random);
    const std::vector<std::size_t> vertices = vertices_of(scene);
    const auto any = [&] { return vertices[random.below(vertices.size())]; };
    const Viewpoint from{
        {tenths(random, 8), tenths(random, 8), tenths(random, 14)}, {0.1, 0.3, 0.7}, std::nullopt};
    SightGeometry geometry(scene, from);
    const ExactSides exact(scene, from.point);
    for (int k = 0; k < 100; ++k) {
      std::array<Side, 3> sides;
      std::array<Exact, 3> normals;
      const std::size_t shared = any();
      for (std::size_t i = 0; i < 3; ++i) {
        // Half the time the first two share a vertex.
        const std::size_t a = i < 2 && k % 2 == 0 ? shared : any();
        const std::size_t b = any();
        const bool turned = random.below(2) == 1;
        sides[i] = turned ? geometry.side(b, a) : geometry.side(a, b);
        normals[i] = turned ? exact.normal(b, a) : exact.normal(a, b);
      }
      const std::size_t v = any();
      EXPECT_EQ(geometry.sign_at(sides[2], v), dot(normals[2], exact.ray(v)).sign());
      EXPECT_EQ(geometry.sign_at(geometry.horizon(), v),
                dot(sample::exact(from.normal), exact.ray(v)).sign());
      const Exact meet = cross(normals[1], normals[0]);
      if (is_zero(meet)) continue;
      const SightGeometry::Corner corner = geometry.corner(sides[0], sides[1]);
      const Exact direction = to_rational(geometry.whole_direction(corner));
      EXPECT_TRUE(is_zero(cross(direction, meet)));
      EXPECT_GT(dot(direction, meet), Rational(0));
      const Rational determinant = dot(meet, normals[2]);
      EXPECT_EQ(geometry.sign_at(sides[2], corner), determinant.sign());
      close += determinant.sign() != 0 && abs(determinant) < Rational::exactly(1e-15) ? 1 : 0;
      backwards += corner.vertex != SightGeometry::none && corner.sign < 0 ? 1 : 0;
    }
  }
  EXPECT_GT(close, 50);
  EXPECT_GT(backwards, 50);
}

TEST(SightGeometry, KnowsOnWhichSideThePlaneOfNearlyAllPasses) {
  // Triangles whose planes pass P within the rounding of their last corner.
  Numbers random(76);
  const auto number = [&] { return 2 * (random.fraction() + 0x1p-20 * random.fraction()) - 1; };
  const Vector<double> eye{0.3, -0.7, 0.9};
  TriangleMesh mesh;
  constexpr std::size_t count = 20000;
  for (std::size_t k = 0; k < count; ++k) {
    const Vector<double> a{number(), number(), number()};
    const Vector<double> b{number(), number(), number()};
    const double along = number();
    const double across = number();
    mesh.vertices.insert(mesh.vertices.end(), {a, b, eye + along * (a - eye) + across * (b - eye)});
    mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  const Scene scene(std::move(mesh));
  SightGeometry geometry(scene, {eye, {0, 0, 1}, std::nullopt});
  std::size_t turned = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [a, b, c] = scene.vertices(k);
    const auto corners = scene.corners(k);
    const int exact = -orientation(corners[0], corners[1], corners[2], eye);
    geometry.clear();
    const Side side = geometry.side(a, b);
    EXPECT_EQ(geometry.sign_at(side, c), exact) << k;
    const double rounded = dot(cross(corners[0] - eye, corners[1] - eye), corners[2] - eye);
    turned += rounded * exact < 0 ? 1U : 0U;
  }
  EXPECT_GT(turned, count / 20);
}

TEST(SightGeometry, KnowsSignsBelowTheSmallestDouble) {
  // n . v of n = 2^-700 (1, -1, 1) and v = 2^-1074 2^700 (3/5, 2/5, -2/5) is negative, but the first product
  // alone is not rounded to zero.
  const double length = std::ldexp(1, -350);
  const double small = std::ldexp(1, -374);
  TriangleMesh mesh;
  mesh.vertices = {{length, length, 0}, {0, length, length}, {0.6 * small, 0.4 * small, -0.4 * small}};
  mesh.triangles = {{0, 1, 2}};
  const Scene scene(std::move(mesh));
  const ExactSides exact(scene, {0, 0, 0});
  SightGeometry geometry(scene, {{0, 0, 0}, {0, 0, 1}, std::nullopt});
  const auto [a, b, v] = scene.vertices(0);
  EXPECT_EQ(dot(exact.normal(a, b), exact.ray(v)).sign(), -1);
  EXPECT_EQ(geometry.sign_at(geometry.side(a, b), v), -1);
  EXPECT_EQ(geometry.sign_at(geometry.side(b, a), v), 1);
}

TEST(SightGeometry, RoundsParametersAsItSays) {
  Numbers random(72);
  int inside = 0;
  Rational worst = 0;
  for (int round = 0; round < 150; ++round) {
    const Scene scene = triangles_of_tenths(random);
    const std::vector<std::size_t> vertices = vertices_of(scene);
    const auto any = [&] { return vertices[random.below(vertices.size())]; };
    const Viewpoint from{{tenths(random, 8), tenths(random, 8), tenths(random, 8)}, {0, 0, 1}, std::nullopt};
    for (std::size_t t = 0; t < scene.triangle_count(); ++t) {
      SightGeometry geometry(scene, from);
      const ExactSides exact(scene, from.point);
      const VertexTriple& v = scene.vertices(t);
      std::array<Side, 3> own;
      for (std::size_t k = 0; k < 3; ++k) own[k] = geometry.side(v[k], v[(k + 1) % 3]);
      const int turn = geometry.sign_at(own[0], v[2]);
      if (turn == 0) continue;
      for (Side& side : own) side.sign *= turn;
      for (int k = 0; k < 10; ++k) {
        const std::array<std::size_t, 4> of{any(), any(), any(), any()};
        if (is_zero(cross(exact.normal(of[0], of[1]), exact.normal(of[2], of[3])))) continue;
        const SightGeometry::Corner corner =
            geometry.corner(geometry.side(of[0], of[1]), geometry.side(of[2], of[3]));
        // In the triangle's cone, and not on a plane through P and one of its sides only by rounding.
        bool in_cone = true;
        for (const Side& side : own) in_cone = in_cone && geometry.sign_at(side, corner) >= 0;
        if (!in_cone) continue;
        const ParameterPoint<double> rounded = geometry.parameters(corner, own, v);
        const ParameterPoint<Rational> there = geometry.exact_parameters(corner, own);
        ++inside;
        worst = std::max({worst, abs(Rational::exactly(rounded.s) - there.s),
                          abs(Rational::exactly(rounded.t) - there.t)});
      }
    }
  }
  EXPECT_LE(worst, Rational::exactly(0x1p-51));
  EXPECT_GT(inside, 500);
}

TEST(SightGeometry, RoundsParametersWherePlanesAlmostCoincide) {
  Numbers random(73);
  int inside = 0;
  Rational worst = 0;
  for (int round = 0; round < 600; ++round) {
    const Vector<double> eye{tenths(random, 8), tenths(random, 8), tenths(random, 8)};
    const auto at_height = [&](double z) {
      return Vector<double>{eye.x + random.between(-1, 1), eye.y + random.between(-1, 1), eye.z + z};
    };
    TriangleMesh mesh;
    mesh.vertices = {eye + Vector<double>{-9, -9, 2}, eye + Vector<double>{9, -9, 2},
                     eye + Vector<double>{0, 9, 2}};
    const Vector<double> a = at_height(1);
    const Vector<double> b = at_height(1.1);
    // Two more points of the plane through P, a, b, but for rounding or a little more.
    const Vector<double> off{0, 0, std::ldexp(random.between(-1, 1), -static_cast<int>(random.below(60)))};
    mesh.vertices.insert(mesh.vertices.end(), {a, b, eye + 0.7 * (a - eye) + 0.2 * (b - eye) + off,
                                               eye + 0.3 * (a - eye) + 0.4 * (b - eye)});
    mesh.triangles = {{0, 2, 1}, {3, 4, 0}, {5, 6, 0}};
    const Scene scene(std::move(mesh));
    SightGeometry geometry(scene, {eye, {0, 0, 1}, std::nullopt});
    const ExactSides exact(scene, eye);
    if (is_zero(cross(exact.normal(3, 4), exact.normal(5, 6)))) continue;
    const VertexTriple& v = scene.vertices(0);
    std::array<Side, 3> own;
    for (std::size_t k = 0; k < 3; ++k) {
      own[k] = geometry.side(v[k], v[(k + 1) % 3]);
      own[k].sign = -own[k].sign;
    }
    for (const bool turned : {false, true}) {
      const Side first = geometry.side(3, 4);
      const Side second = turned ? geometry.side(6, 5) : geometry.side(5, 6);
      const SightGeometry::Corner corner = geometry.corner(first, second);
      bool in_cone = true;
      for (const Side& side : own) in_cone = in_cone && geometry.sign_at(side, corner) >= 0;
      if (!in_cone) continue;
      const ParameterPoint<double> rounded = geometry.parameters(corner, own, v);
      const ParameterPoint<Rational> there = geometry.exact_parameters(corner, own);
      ++inside;
      worst = std::max(
          {worst, abs(Rational::exactly(rounded.s) - there.s), abs(Rational::exactly(rounded.t) - there.t)});
    }
  }
  EXPECT_LE(worst, Rational::exactly(0x1p-51));
  EXPECT_GT(inside, 50);
}

TEST(SightGeometry, HasExactParametersOfThePointThatItMeets) {
  const Scene scene = sample::occluded_squares();
  const Viewpoint from{{0.25, 0.125, 0}, {0, 0, 1}, std::nullopt};
  SightGeometry geometry(scene, from);
  const VertexTriple& v = scene.vertices(2);
  std::array<Side, 3> own;
  for (std::size_t k = 0; k < 3; ++k) {
    own[k] = geometry.side(v[k], v[(k + 1) % 3]);
    own[k].sign = -own[k].sign;
  }
  // The vertex (1/2, 1/2, 1/2) of the square between, seen at (3/4, 7/8, 1).
  const VertexTriple& o = scene.vertices(4);
  const SightGeometry::Corner corner = geometry.corner(geometry.side(o[1], o[2]), geometry.side(o[2], o[0]));
  const ParameterPoint<Rational> at = geometry.exact_parameters(corner, own);
  const auto corners = scene.corners(2);
  const Exact a = sample::exact(corners[0]);
  const Exact q = a + at.s * (sample::exact(corners[1]) - a) + at.t * (sample::exact(corners[2]) - a);
  EXPECT_EQ(q, (Exact{Rational(3, 4), Rational(7, 8), 1}));
}

}  // namespace
}  // namespace radcert
