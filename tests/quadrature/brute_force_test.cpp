// SPDX-License-Identifier: GPL-3.0-or-later
// The truth that the law of the radius is measured by, itself measured.
#include "brute_force.h"

#include <gtest/gtest.h>

#include "radcert/core/parallel.h"
#include "random_entries.h"

namespace radcert {
namespace {

constexpr Effort greater{.points = 26, .ratio = 3, .stretch = 0.17L, .gathered_points = 40};

/// What the law needs: a twentieth of the smallest radius, 60 u = 6.7e-15 of Int |G l_j|.
constexpr Long accuracy = 3e-16L;

/// The largest difference of two integrals, relative to Int |G l_j|.
Long difference(const BruteForce::Integral& a, const BruteForce::Integral& b) {
  Long largest = 0;
  for (std::size_t j = 0; j < a.value.size(); ++j)
    largest = std::max(largest, std::abs(a.value[j] - b.value[j]) / b.size[j]);
  return largest;
}

void expect_settled(Place place, std::size_t cases, std::uint64_t seed) {
  Stream stream(seed);
  for (const Surface& surface :
       {cube(), sphere(), ellipsoid(1, 2, 5), two_piece(3), two_piece(Rational(3, 2))}) {
    const BruteForce truth(surface);
    std::vector<Case> drawn;
    for (int attempt = 0; attempt < 1000 && drawn.size() < cases; ++attempt) {
      const TouchingElements elements(surface, static_cast<int>(stream.index(3)));
      const double inset = surface.pieces_meet_at_angle ? 1e-3 : stream.pick<double>({0, 1e-3, 0.1});
      const auto c = elements.draw(place, static_cast<int>(stream.index(4)), inset, stream);
      if (c) drawn.push_back(*c);
    }
    std::vector<Long> differences(drawn.size());
    parallel_for(drawn.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Case& c = drawn[i];
        const InsetBasis<Long> basis(c.degree, c.inset);
        differences[i] = difference(truth.integrate(c.observer, c.element, basis),
                                    truth.integrate(c.observer, c.element, basis, greater));
      }
    });
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      EXPECT_LE(differences[i], accuracy) << drawn[i].text();
    }
  }
}

TEST(BruteForce, IsSettledOnTheObserversOwnElement) { expect_settled(Place::own, 3, 1); }
TEST(BruteForce, IsSettledBesideAnEdge) { expect_settled(Place::edge, 6, 2); }
TEST(BruteForce, IsSettledBesideAVertex) { expect_settled(Place::vertex, 6, 3); }
TEST(BruteForce, IsSettledApart) { expect_settled(Place::apart, 10, 4); }

TEST(BruteForce, AgreesWithItselfInPolarAndInCutCoordinates) {
  Stream stream(5);
  for (const Surface& surface : {sphere(), ellipsoid(1, 2, 5), two_piece(3), two_piece(Rational(3, 2))}) {
    const BruteForce truth(surface);
    for (int k = 0; k < 2; ++k) {
      const TouchingElements elements(surface, 1);
      auto c = elements.draw(Place::own, 2, 0.1, stream);
      while (!c) c = elements.draw(Place::own, 2, 0.1, stream);
      const InsetBasis<Long> basis(c->degree, c->inset);
      EXPECT_LE(difference(truth.around(c->observer, c->element, basis),
                           truth.away(c->observer, c->element, basis)),
                accuracy)
          << c->text();
    }
  }
}

TEST(BruteForce, IsAQuarterOfTheAreaOnTheSphere) {
  // G = 1/4 and the octant's area is pi/2; its four children together make the octant.
  const Surface surface = sphere();
  const BruteForce truth(surface);
  const InsetBasis<Long> constant(0, 0);
  for (const SurfacePoint<double>& p :
       {SurfacePoint<double>{0, {0.25, 0.5}}, {0, {1.0 / 3, 1e-3}}, {1, {0.25, 0.5}}, {7, {0.1, 0.2}}}) {
    Long sum = 0;
    for (const ParameterTriangle& triangle : triangulate(surface, 1).triangles)
      if (triangle.chart == 0) sum += truth.integrate(p, triangle, constant).value[0];
    EXPECT_LE(std::abs(sum - pi<Long>() / 8), 1e-18L) << p.chart;
  }
}

TEST(BruteForce, IsLambertsIntegralOnATriangleAtARightAngle) {
  // [Lambert 1760]: Int G = 1/2 sum over the sides of their angle at P times n_P . unit(a x b).
  const Surface surface = two_squares();
  const BruteForce truth(surface);
  const InsetBasis<Long> constant(0, 0);
  const ParameterTriangle triangle{1, {{{0.25, 0}, {0.75, 0}, {0.5, 0.5}}}};
  for (const double height : {0.5, 0x1p-6, 0x1p-12}) {
    const SurfacePoint<double> p{0, {0.4375, height}};
    const Vector<Long> point{0.4375L, 0, static_cast<Long>(height)};
    const std::array<Vector<Long>, 3> corners{{{0.25L, 0, 0}, {0.75L, 0, 0}, {0.5L, 0.5L, 0}}};
    Long exact = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<Long> a = corners[i] - point;
      const Vector<Long> b = corners[(i + 1) % 3] - point;
      const Vector<Long> normal = cross(b, a);
      exact += std::atan2(norm(normal), dot(a, b)) * normal.y / norm(normal) / 2;
    }
    EXPECT_LE(std::abs(truth.integrate(p, triangle, constant).value[0] - std::abs(exact)), accuracy)
        << height;
  }
}

}  // namespace
}  // namespace radcert
