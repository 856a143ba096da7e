// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/residual.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/core/parallel.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

/// A furnace: E = 1 - rho, u = 1, q = 1; and a second function that need not be good.
struct Furnace {
  SectorScene scene;
  std::vector<SectorElement> elements;
  PanelData data;
  SectorFunctions q;

  Furnace(const std::string& name, int layers, int degree)
      : scene(panels_of(name)), elements(graded_elements(scene, layers)), q(elements.size(), 2, degree) {
    data.reflectivity.assign(scene.panels().size(), 0.5);
    data.emissions.assign(2, std::vector<double>(scene.panels().size(), 0.5));
    for (std::size_t e = 0; e < elements.size(); ++e) {
      q.of(e, 0)[0] = 1;
      q.of(e, 1)[0] = 1;
    }
  }
  [[nodiscard]] ResidualSums sums(const CellDemand& demand) const {
    const SectorFunctions w = densities(scene, elements, data, q);
    const Smoothness smoothness(scene, elements, w, q);
    return residual_sums(scene, elements, data, w, q, smoothness,
                         observer_cells(scene, elements, smoothness, demand), demand);
  }
};

TEST(ResidualSums, VanishForTheExactSolution) {
  const Furnace furnace("cube", 2, 1);
  const ResidualSums sums = furnace.sums({.interpolation = 1e-3, .quadrature = 1e-5});
  EXPECT_LT(sums.norms[0], 0.2);
  for (const Approximation& product : sums.products) {
    EXPECT_TRUE(product.guaranteed);
    EXPECT_LE(std::abs(product.value), product.radius);
    EXPECT_LT(product.radius, 0.1);
  }
}

TEST(ResidualSums, SeeAConstantError) {
  // q_0 = 1 + d: w_0 = 1 + d/2, t_0 = -d/2; the norm is (Int rho t^2)^(1/2) = d/2 (3)^(1/2), Int w_1 t_0 = -3 d.
  for (const std::string name : {"cube", "tetrahedron"}) {
    Furnace furnace(name, 2, 1);
    constexpr double d = 0.25;
    for (std::size_t e = 0; e < furnace.elements.size(); ++e) furnace.q.of(e, 0)[0] = 1 + d;
    const ResidualSums sums = furnace.sums({.interpolation = 1e-3, .quadrature = 1e-5});
    const double area = furnace.scene.area();
    const double norm = 0.5 * d * std::sqrt(0.5 * area);
    EXPECT_GE(sums.norms[0], norm * (1 - 1e-12)) << name;
    EXPECT_LE(sums.norms[0], norm + 0.2) << name;
    EXPECT_NEAR(sums.products[1].value, -0.5 * d * area, sums.products[1].radius + 1e-12) << name;
  }
}

TEST(ResidualSums, AreBoundsAtAnyDemand) {
  // Products of coarse cells contain those of fine ones; norms from coarse cells are larger.
  Furnace furnace("octahedron", 1, 2);
  Draw draw(5);
  for (double& c : furnace.q.all()) c += 0.05 * (draw() - 0.5);
  const ResidualSums fine = furnace.sums({.interpolation = 1e-4, .quadrature = 1e-6});
  for (const double factor : {10.0, 100.0}) {
    const ResidualSums coarse = furnace.sums({.interpolation = 1e-4 * factor, .quadrature = 1e-6 * factor});
    EXPECT_LT(coarse.samples, fine.samples);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_GE(coarse.norms[k], 0.9 * fine.norms[k] - 1e-3);
      EXPECT_LE(std::abs(coarse.products[k].value - fine.products[k].value),
                coarse.products[k].radius + fine.products[k].radius);
    }
  }
}

TEST(ResidualSums, HaveTheSameBitsForAnyNumberOfThreads) {
  const Furnace furnace("tetrahedron", 2, 1);
  const CellDemand demand{.interpolation = 1e-3, .quadrature = 1e-5};
  const ResidualSums all = furnace.sums(demand);
  const ThreadLimit limit(1);
  const ResidualSums one = furnace.sums(demand);
  EXPECT_EQ(all.norms, one.norms);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(all.products[k].value, one.products[k].value);
    EXPECT_EQ(all.products[k].radius, one.products[k].radius);
  }
}

}  // namespace
}  // namespace radcert
