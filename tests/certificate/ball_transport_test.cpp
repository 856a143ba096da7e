// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/ball_transport.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "radcert/certificate/gauss_rule.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "tests/certificate/bench.h"
#include "tests/certificate/samples.h"

namespace radcert::certificate {
namespace {

using radcert::test::bare_certificate;
using radcert::test::Draw;
using test::Bench;

Vector<Rational> point_of(const PolyhedronCertificate& c, std::size_t face, std::size_t side,
                          const Rational& s, const Rational& t) {
  const std::vector<Vector<Rational>>& p = c.faces[face].corners;
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : p) sum = sum + corner;
  const Vector<Rational> centre = Rational(1, static_cast<long>(p.size())) * sum;
  const Vector<Rational>& a = p[side];
  const Vector<Rational>& b = p[(side + 1) % p.size()];
  return a + (s * (Rational(1) - t)) * (b - a) + t * (centre - a);
}

Vector<Rational> normal_of(const Face& face) {
  return cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]);
}

/// T w_k by closed forms, w_k constant on elements.
Ball sent(const PolyhedronCertificate& c, std::size_t k, std::size_t face, const Vector<Rational>& at) {
  Ball sum;
  for (std::size_t e = 0; e < c.elements.size(); ++e) {
    const Element& x = c.elements[e];
    if (x.face == face) continue;
    const auto corner = [&](double s, double t) {
      return point_of(c, x.face, x.side, Rational::exactly(s), Rational::exactly(t));
    };
    std::vector<Vector<Rational>> corners{corner(x.s0, x.t0), corner(x.s1, x.t0), corner(x.s1, x.t1)};
    if (x.t1 < 1) corners.push_back(corner(x.s0, x.t1));
    const Face& source = c.faces[x.face];
    Rational w = source.reflectivity * Rational::exactly(c.coefficient(k, e, 0, 0));
    if (k == 0) w += source.emission[0][0];
    if (k > 0 && source.piece == k - 1) w += source.reflectivity;
    const Ball factor = point_to_polygon(at, normal_of(c.faces[face]), plane_polygon(corners).value(),
                                         constant_polynomial(Rational(1)));
    sum += Ball(w) * factor / Ball::pi();
  }
  return sum;
}

TEST(BallTransport, AgreesWithClosedForms) {
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const Bench bench(bare_certificate(name, 2, 0, 5));
    Draw draw(6);
    double narrowest = 1;
    for (int n = 0; n < 20; ++n) {
      const std::size_t face = draw.below(bench.c.faces.size());
      const std::size_t side = draw.below(bench.c.faces[face].corners.size());
      const double s = draw();
      // Some of them next to the edge.
      const double t = std::ldexp(0.05 + 0.9 * draw(), -static_cast<int>(draw.below(20)));
      const Observers one{.triangle = bench.scene.triangle(face, side),
                          .s = {BoundedDouble::exactly(s)},
                          .t = {BoundedDouble::exactly(t)}};
      const BallTransport::Values found = bench.transport(one, 1e-9, std::nullopt);
      ASSERT_TRUE(std::isfinite(found.radii[0])) << name << " " << s << " " << t;
      narrowest = std::min(narrowest, found.radii[0]);
      const Vector<Rational> at = point_of(bench.c, face, side, Rational::exactly(s), Rational::exactly(t));
      for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        Ball exact = sent(bench.c, k, face, at);
        if (k == 0) exact *= power(Ball(2), -bench.densities.exponent());
        const Ball enclosed = widened(Ball(found.values[k]), Ball(found.radii[0]));
        EXPECT_TRUE(overlaps(exact, enclosed)) << name << " " << s << " " << t << " " << exact.to_text();
      }
      // T 1 = 1.
      EXPECT_LE(std::abs(found.values[bench.densities.constant()] - 1), found.radii[0]);
    }
    EXPECT_LE(narrowest, 1e-8);
  }
}

TEST(BallTransport, IsOneForOneInGroupsOfPoints) {
  const Bench bench(bare_certificate("box", 3, 2, 7));
  Draw draw(8);
  for (int n = 0; n < 12; ++n) {
    const std::size_t face = draw.below(bench.c.faces.size());
    Observers group{.triangle = bench.scene.triangle(face, draw.below(4)), .s = {}, .t = {}};
    const double depth = std::ldexp(1.0, -static_cast<int>(draw.below(30)));
    for (int p = 0; p < 30; ++p) {
      group.s.push_back(BoundedDouble::exactly(draw()));
      group.t.push_back(BoundedDouble::exactly(depth * (0.1 + 0.9 * draw())));
    }
    const BallTransport::Values found = bench.transport(group, 1e-7, std::nullopt);
    for (std::size_t p = 0; p < group.s.size(); ++p) {
      const double off =
          std::abs(found.values[p * bench.densities.stride() + bench.densities.constant()] - 1);
      EXPECT_LE(off, found.radii[p]) << depth;
    }
  }
}

TEST(BallTransport, DependsOnTheTolerance) {
  const Bench bench(bare_certificate("cube", 3, 2, 9));
  const Observers one{.triangle = 2, .s = {BoundedDouble::exactly(0.3)}, .t = {BoundedDouble::exactly(0.4)}};
  double last = 1;
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    const BallTransport::Values found = bench.transport(one, tolerance, std::nullopt);
    const BallTransport::Values finer = bench.transport(one, 1e-12, std::nullopt);
    for (std::size_t k = 0; k <= bench.densities.constant(); ++k)
      EXPECT_LE(std::abs(found.values[k] - finer.values[k]), found.radii[0] + finer.radii[0]);
    EXPECT_LT(found.radii[0], last);
    last = found.radii[0];
  }
}

}  // namespace
}  // namespace radcert::certificate
