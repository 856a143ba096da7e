// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/mean_enclosure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::panels_of;

PolyhedronProblem problem(const std::string& name, const Rational& rho, const Rational& emission) {
  PolyhedronProblem out{.panels = panels_of(name), .reflectivity = {}, .emission = {}};
  out.reflectivity.assign(out.panels.size(), rho);
  out.emission.assign(out.panels.size(), emission);
  return out;
}

/// As `problem`, but that only the first panel emits, and another reflects more.
PolyhedronProblem lit(const std::string& name) {
  PolyhedronProblem out = problem(name, Rational(1, 2), 0);
  out.emission[0] = 1;
  out.reflectivity[1] = Rational(7, 10);
  return out;
}

void expect_contains(const Approximation& enclosure, double value) {
  EXPECT_TRUE(enclosure.guaranteed);
  EXPECT_LE(std::abs(enclosure.value - value), enclosure.radius * (1 + 1e-9) + 1e-15);
}

TEST(MeanEnclosure, ContainsOneInAFurnace) {
  for (const std::string name : {"cube", "octahedron"}) {
    const MeanEnclosure found = enclose_means(problem(name, Rational(3, 10), Rational(7, 10)), 3e-2);
    EXPECT_LE(found.width, 3e-2) << name;
    EXPECT_TRUE(found.hindrance.empty());
    for (const Approximation& mean : found.means) expect_contains(mean, 1);
  }
}

TEST(MeanEnclosure, IsTheEmissionWhereNothingReflects) {
  PolyhedronProblem dark = problem("cube", 0, 0);
  dark.emission[2] = 5;
  const MeanEnclosure found = enclose_means(dark, 1e-6);
  for (std::size_t k = 0; k < found.means.size(); ++k) expect_contains(found.means[k], k == 2 ? 5 : 0);
  EXPECT_LE(found.width, 1e-6);
}

TEST(MeanEnclosure, KeepsTheBalanceOfEnergy) {
  // Int T u = Int u, since T 1 = 1 and T is symmetric; T u = (u - E)/rho: Int (1/rho - 1) u = Int E/rho.
  for (const std::string name : {"cube", "tetrahedron"}) {
    const PolyhedronProblem asked = lit(name);
    const SectorScene scene(asked.panels);
    const MeanEnclosure found = enclose_means(asked, 5e-2);
    double left = 0;
    double radius = 0;
    double right = 0;
    for (std::size_t j = 0; j < asked.panels.size(); ++j) {
      const Approximation& mean = found.means[asked.panels[j].piece];
      const double rho = asked.reflectivity[j].to_double();
      const double weight = (1 / rho - 1) * scene.area(j);
      left += weight * mean.value;
      radius += weight * mean.radius;
      right += asked.emission[j].to_double() / rho * scene.area(j);
    }
    EXPECT_NEAR(left, right, radius) << name;
    EXPECT_LE(found.width, 5e-2);
  }
}

TEST(MeanEnclosure, OfCoarseMeshesContainThoseOfFineOnes) {
  const MeanEnclosure coarse = enclose_means(lit("cube"), 5e-2);
  const MeanEnclosure fine = enclose_means(lit("cube"), 5e-4);
  EXPECT_LT(fine.width, 0.1 * coarse.width);
  for (std::size_t k = 0; k < fine.means.size(); ++k)
    EXPECT_LE(std::abs(coarse.means[k].value - fine.means[k].value),
              coarse.means[k].radius + fine.means[k].radius);
}

}  // namespace
}  // namespace radcert
