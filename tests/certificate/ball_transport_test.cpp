// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/ball_transport.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "radcert/certificate/gauss_rule.h"
#include "tests/certificate/bench.h"
#include "tests/certificate/closed_form_transport.h"
#include "tests/certificate/samples.h"

namespace radcert::certificate {
namespace {

using radcert::test::bare_certificate;
using radcert::test::Draw;
using test::Bench;
using test::point_of;
using test::sent;

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
