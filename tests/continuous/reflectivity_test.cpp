// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/reflectivity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "radcert/continuous/polyhedron_problem.h"
#include "radcert/continuous/trial.h"
#include "radcert/core/work_limit.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::drawn_polynomial;
using test::panels_of;

using Polynomial = PlanePolynomial<Rational>;

Polynomial affine(const Rational& c, const Rational& s, const Rational& t) {
  return affine_polynomial<Rational>(c, s, t);
}

/// A point of a panel from weights of its corners.
ParameterPoint<Rational> drawn_point(const Panel& panel, Draw& draw) {
  Vector<Rational> sum;
  Rational all = 0;
  for (const Vector<Rational>& corner : panel.corners) {
    const Rational weight(static_cast<long>(draw.below(1000)) + (draw() < 0.5 ? 0 : 1));
    sum = sum + weight * corner;
    all += weight;
  }
  if (all.sign() == 0) return plane_coordinates(panel, panel.centre);
  return plane_coordinates(panel, Rational(1) / all * sum);
}

TEST(ReflectivityOf, IsExactForAffineFunctions) {
  // On a square whose corners are (0,0), (1,0), (0,1) and (-1,1).
  const Panel square = panels_of("cube")[0];
  const Outcome<PanelReflectivity> rho =
      reflectivity_of(square, affine(Rational(3, 8), Rational(1, 4), Rational(1, 8)));
  ASSERT_TRUE(rho);
  Rational largest = 0;
  for (const Vector<Rational>& corner : square.corners) {
    const ParameterPoint<Rational> at = plane_coordinates(square, corner);
    largest = std::max(largest, rho->polynomial.value(at.s, at.t));
  }
  EXPECT_EQ(rho->largest, largest);
  EXPECT_EQ(rho->seen, largest);
}

TEST(ReflectivityOf, BoundsDrawnPolynomials) {
  Draw draw(41);
  int taken = 0;
  for (const std::string name : {"cube", "tetrahedron", "octahedron"})
    for (int k = 0; k < 12; ++k) {
      const Panel panel = panels_of(name)[draw.below(4)];
      Polynomial f = drawn_polynomial(1 + static_cast<int>(draw.below(8)), Rational(1, 40), draw);
      f(0, 0) = Rational(1, 2);
      const Outcome<PanelReflectivity> rho = reflectivity_of(panel, f);
      if (!rho) continue;
      ++taken;
      EXPECT_LT(rho->largest, Rational(1));
      EXPECT_LE(rho->seen, rho->largest);
      EXPECT_LE((rho->largest - rho->seen) * Rational(1000), Rational(1) - rho->seen);
      for (int n = 0; n < 200; ++n) {
        const ParameterPoint<Rational> at = drawn_point(panel, draw);
        const Rational value = f.value(at.s, at.t);
        EXPECT_GE(value.sign(), 0);
        EXPECT_LE(value, rho->largest);
      }
    }
  EXPECT_GT(taken, 15);
}

TEST(ReflectivityOf, RefusesWhatLeavesTheInterval) {
  const Panel square = panels_of("cube")[0];
  const auto refused = [&](const Polynomial& f) { return !reflectivity_of(square, f).has_value(); };
  EXPECT_TRUE(refused(affine(0, 0, 1)));                      // 1 at a side
  EXPECT_TRUE(refused(affine(Rational(-1, 1000000), 0, 0)));  // negative
  EXPECT_TRUE(refused(affine(Rational(1, 2), Rational(-501, 1000), 0)));
  EXPECT_FALSE(refused(affine(0, 0, Rational(999, 1000))));  // 0 at a side
  // 1 - (s - 1/3)^2 - (t - 1/5)^2 reaches 1 at one point inside, which no corner of a triangle is.
  const Polynomial s = affine(Rational(-1, 3), 1, 0);
  const Polynomial t = affine(Rational(-1, 5), 0, 1);
  const Polynomial hill = sum(product(s, s), Rational(1), product(t, t));
  EXPECT_TRUE(refused(sum(constant_polynomial(Rational(1)), Rational(-1, 4), hill)));
  const Polynomial top = sum(constant_polynomial(Rational(999, 1000)), Rational(-1, 4), hill);
  ASSERT_FALSE(refused(top));
  EXPECT_GE(reflectivity_of(square, top)->largest, Rational(999, 1000));
  // And it is negative by a hair in a hollow there.
  EXPECT_TRUE(refused(sum(constant_polynomial(Rational(-1, 100000)), Rational(1, 4), hill)));
  EXPECT_FALSE(refused(sum(constant_polynomial(Rational(1, 1000)), Rational(1, 4), hill)));
}

/// The value of a function of SectorFunctions, exactly, at a place in [-1,1]^2.
Rational exact_value(std::span<const double> c, const Rational& x, const Rational& y) {
  const auto powers = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(c.size()))));
  const auto legendre = [&](const Rational& at) {
    std::vector<Rational> p{1, at};
    for (std::size_t i = 1; i + 1 < powers; ++i) {
      const auto k = static_cast<long>(i);
      p.push_back((Rational(2 * k + 1) * at * p[i] - Rational(k) * p[i - 1]) / Rational(k + 1));
    }
    return p;
  };
  const std::vector<Rational> p = legendre(x);
  const std::vector<Rational> q = legendre(y);
  Rational sum = 0;
  for (std::size_t i = 0; i < powers; ++i)
    for (std::size_t j = 0; j < powers; ++j) sum += Rational::exactly(c[i * powers + j]) * p[i] * q[j];
  return sum;
}

TEST(ElementReflectivity, MultipliesWithinItsRounding) {
  // w = E + rho q at rational points, E and q as they are given, rho exactly.
  Draw draw(42);
  double closest = 0;
  for (const std::string name : {"cube", "tetrahedron"})
    for (const int degree : {1, 3, 8}) {
      const std::vector<Panel> panels = panels_of(name);
      std::vector<PanelReflectivity> by_panel;
      for (std::size_t k = 0; k < panels.size(); ++k) {
        Polynomial f = drawn_polynomial(degree, Rational(1, 40), draw);
        f(0, 0) = Rational(1, 2);
        by_panel.emplace_back(f, Rational(100), Rational(0));
      }
      const SectorScene scene(panels);
      const std::vector<SectorElement> elements = graded_elements(scene, 2);
      SectorFunctions emissions = test::drawn_functions(elements.size(), 2, degree + 3, draw);
      for (double& c : emissions.all()) c *= 0x1p-20;
      const SectorFunctions q = test::drawn_functions(elements.size(), 2, 3, draw);
      const Trial trial(scene, Reflectivity(by_panel), elements, emissions, q);
      EXPECT_EQ(trial.w.degree(), degree + 3);
      for (std::size_t e = 0; e < elements.size(); e += 3) {
        const SectorBox& box = elements[e].box;
        const std::size_t panel = trial.sector(e).panel;
        const std::size_t side = elements[e].sector - scene.first_sector(panel);
        const std::vector<Vector<Rational>>& corners = panels[panel].corners;
        const Rational x = Rational::exactly(2 * draw() - 1);
        const Rational y = Rational::exactly(2 * draw() - 1);
        const auto place = [](double from, double to, const Rational& at) {
          return Rational::exactly(from) + Rational::exactly(to - from) * (at + Rational(1)) / Rational(2);
        };
        const Rational s = place(box.s0, box.s1, x);
        const Rational t = place(box.t0, box.t1, y);
        const Vector<Rational> base =
            (Rational(1) - s) * corners[side] + s * corners[(side + 1) % corners.size()];
        const ParameterPoint<Rational> at =
            plane_coordinates(panels[panel], (Rational(1) - t) * base + t * panels[panel].centre);
        const Rational rho = by_panel[panel].polynomial.value(at.s, at.t);
        EXPECT_LE(rho, Rational::exactly(trial.rho(e)));
        for (const std::size_t k : {0U, 1U}) {
          const Rational exact = exact_value(emissions.of(e, k), x, y) + rho * exact_value(q.of(e, k), x, y);
          const double off = abs(exact_value(trial.w.of(e, k), x, y) - exact).to_double();
          EXPECT_LE(off, trial.rounding) << name << " " << e;
          closest = std::max(closest, off / trial.rounding);
        }
      }
    }
  EXPECT_GT(closest, 1e-3);
}

}  // namespace
}  // namespace radcert
