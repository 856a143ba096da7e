// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/residual.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "radcert/continuous/transport/transport.h"
#include "radcert/continuous/trial_functions.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"
#include "tests/continuous/rooms.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

/// A furnace: E = 1 - rho, u = 1, q = 1; and a second function that need not be good.
struct Furnace {
  SectorScene scene;
  std::vector<SectorElement> elements;
  std::vector<double> reflectivity;
  SectorFunctions q;

  Furnace(const std::string& name, int layers, int degree)
      : scene(panels_of(name)), elements(graded_elements(scene, layers)), q(elements.size(), 2, degree) {
    reflectivity.assign(scene.panels().size(), 0.5);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      q.of(e, 0)[0] = 1;
      q.of(e, 1)[0] = 1;
    }
  }
  [[nodiscard]] ResidualSums sums(const CellDemand& demand) const {
    const std::vector<std::vector<double>> emissions(2, std::vector<double>(scene.panels().size(), 0.5));
    const Trial trial(scene, reflectivity, elements, panel_functions(scene, elements, emissions, q.degree()),
                      q);
    return residual_sums(trial, observer_cells(trial, demand), demand);
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
  // q_0 = 1 + d: w_0 = 1 + d/2, t_0 = -d/2; the norm is d/2 times (area/2)^(1/2), Int w_1 t_0 = -area d/2.
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

TEST(ResidualSums, CountWhatBlackFacesEmit) {
  // w = 1 everywhere, by emission alone on a face that is black, and q_0 = 1 + d: t_0 = -d, Int w_1 t_0 = -d
  // area.
  Furnace furnace("cube", 2, 1);
  constexpr double d = 0.25;
  furnace.reflectivity[0] = 0;
  std::vector<std::vector<double>> emissions(2);
  for (const double rho : furnace.reflectivity) {
    emissions[0].push_back(1 - rho * (1 + d));
    emissions[1].push_back(1 - rho);
  }
  for (std::size_t e = 0; e < furnace.elements.size(); ++e) furnace.q.of(e, 0)[0] = 1 + d;
  const Trial trial(furnace.scene, furnace.reflectivity, furnace.elements,
                    panel_functions(furnace.scene, furnace.elements, emissions, 1), furnace.q);
  const CellDemand demand{.interpolation = 1e-3, .quadrature = 1e-5};
  const ResidualSums sums = residual_sums(trial, observer_cells(trial, demand), demand);
  EXPECT_LT(sums.products[1].radius, 0.1 * d);
  EXPECT_NEAR(sums.products[1].value, -d * furnace.scene.area(), sums.products[1].radius);
}

TEST(ResidualSums, SeeAConstantErrorWhereRhoIsAPolynomial) {
  // E_0 = 1 - rho (1 + d), q_0 = 1 + d: w_0 = 1 and t_0 = -d; the norm is at least d (Int rho)^(1/2), with
  // rho = (1 + s)/4 in the plane of each face; Int w_1 t_0 = -area d for w_1 = 1.
  const Furnace furnace("cube", 2, 1);
  constexpr double d = 0.25;
  const PlanePolynomial<Rational> rho = affine_polynomial<Rational>(Rational(1, 4), Rational(1, 4), 0);
  std::vector<PanelReflectivity> by_panel;
  for (const Panel& panel : furnace.scene.panels()) by_panel.push_back(reflectivity_of(panel, rho).value());
  const Reflectivity reflectivity(by_panel);
  const ElementReflectivity on_elements(reflectivity, furnace.scene, furnace.elements);
  SectorFunctions emissions(furnace.elements.size(), 2, 2);
  SectorFunctions q = furnace.q;
  for (std::size_t e = 0; e < furnace.elements.size(); ++e) {
    q.of(e, 0)[0] = -1 - d;
    for (std::size_t k = 0; k < 2; ++k) {
      q.of(e, 1)[0] = -1;
      on_elements.add_product(e, q.of(e, k), emissions.of(e, k));
      emissions.of(e, k)[0] += 1;
      for (double& c : q.of(e, k)) c = -c;
    }
  }
  const Trial trial(furnace.scene, reflectivity, furnace.elements, emissions, q);
  const CellDemand demand{.interpolation = 1e-3, .quadrature = 1e-5};
  const ResidualSums sums = residual_sums(trial, observer_cells(trial, demand), demand);
  const double area = furnace.scene.area();
  const double norm = d * std::sqrt(0.375 * area);
  EXPECT_GE(sums.norms[0], norm * (1 - 1e-12));
  EXPECT_LE(sums.norms[0], 1.2 * norm + 0.2);
  EXPECT_NEAR(sums.products[1].value, -d * area, sums.products[1].radius);
  EXPECT_LT(sums.products[1].radius, 0.1 * d);
}

TEST(ResidualSums, TakeProductsWithQExactly) {
  // E = 0, and q is 0 but on the sector at the first side of one face, where it is 2 t - 1. That face does
  // not see itself: Int w t = -Int rho q^2. In its plane rho = y^d/2, and y = t/2 on the sector.
  const SectorScene scene(panels_of("cube"));
  const std::vector<SectorElement> elements = graded_elements(scene, 1);
  for (const int d : {1, 2, 3}) {
    PlanePolynomial<Rational> rho(d);
    rho(0, d) = Rational(1, 2);
    std::vector<PanelReflectivity> by_panel(scene.panels().size(), PanelReflectivity(Rational(0)));
    by_panel[0] = reflectivity_of(scene.panels()[0], rho).value();
    const Reflectivity reflectivity(by_panel);
    SectorFunctions q(elements.size(), 1, 1);
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (elements[e].sector == scene.first_sector(0)) q.of(e, 0)[1] = 1;
    const Trial trial(scene, reflectivity, elements, SectorFunctions(elements.size(), 1, 1 + d), q);
    const CellDemand demand{.interpolation = 1e-4, .quadrature = 1e-7, .shade = 1};
    const ResidualSums sums = residual_sums(trial, observer_cells(trial, demand), demand);
    // The area element is (1 - t)/2.
    const double integral = -4.0 / (d + 4) + 8.0 / (d + 3) - 5.0 / (d + 2) + 1.0 / (d + 1);
    const double exact = -0.25 * std::ldexp(integral, -d);
    EXPECT_NEAR(sums.products[0].value, exact, sums.products[0].radius) << d;
    EXPECT_LT(sums.products[0].radius, 0.1 * std::abs(exact)) << d;
  }
}

TEST(ResidualSums, AreBoundsAtAnyDemand) {
  // Products of coarse cells contain those of fine ones; norms from coarse cells are larger.
  Furnace furnace("tetrahedron", 1, 2);
  Draw draw(5);
  for (double& c : furnace.q.all()) c += 0.05 * (draw() - 0.5);
  const ResidualSums fine = furnace.sums({.interpolation = 1e-3, .quadrature = 1e-5});
  for (const double factor : {10.0, 100.0}) {
    const ResidualSums coarse = furnace.sums({.interpolation = 1e-3 * factor, .quadrature = 1e-5 * factor});
    EXPECT_LT(coarse.samples, fine.samples);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_GE(coarse.norms[k], 0.9 * fine.norms[k] - 1e-3);
      EXPECT_LE(std::abs(coarse.products[k].value - fine.products[k].value),
                coarse.products[k].radius + fine.products[k].radius);
    }
  }
}

/// Sums over cells that the test chooses, of drawn functions with q = 0: norms are of T w, products Int w_k T
/// w_0.
struct Drawn {
  SectorScene scene;
  std::vector<double> reflectivity;
  std::vector<SectorElement> elements;
  SectorFunctions w;
  Trial trial;

  Drawn(const std::string& name, Draw draw)
      : Drawn(name, [&](std::size_t count) { return test::drawn_functions(count, 2, 2, draw); }) {}
  /// Of functions for a number of elements.
  Drawn(const std::string& name, const std::function<SectorFunctions(std::size_t)>& functions)
      : scene(panels_of(name)),
        reflectivity(scene.panels().size(), 0.5),
        elements(graded_elements(scene, 2)),
        w(functions(elements.size())),
        trial(scene, reflectivity, elements, w, SectorFunctions(elements.size(), 2, 2)) {}
  [[nodiscard]] ResidualSums over(const std::vector<ObserverCell>& cells) const {
    return residual_sums(trial, cells, {.interpolation = 1e-7, .quadrature = 1e-9});
  }
  /// Int over a box of w_k T w_0, and of (T w_k)^2/2, by an 8 x 8 rule.
  [[nodiscard]] std::pair<double, double> by_a_rule(std::size_t e, const SectorBox& box,
                                                    std::size_t k) const {
    const Sector& sector = scene.sectors()[elements[e].sector];
    const SectorBox& whole = elements[e].box;
    const IntervalRule<double>& rule = gauss_on_interval(8);
    const Transport transport(scene, elements, w);
    double product = 0;
    double square = 0;
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 8; ++j) {
        const double s = box.middle_s() + 0.5 * (box.s1 - box.s0) * rule.nodes[i];
        const double t = box.middle_t() + 0.5 * (box.t1 - box.t0) * rule.nodes[j];
        const std::vector<double> sent =
            transport({.panel = sector.panel, .points = {sector.point(s, t)}}, 1e-9).values;
        std::array<double, 3> p_s{};
        std::array<double, 3> p_t{};
        legendre_values<double>((2 * s - whole.s0 - whole.s1) / (whole.s1 - whole.s0), p_s);
        legendre_values<double>((2 * t - whole.t0 - whole.t1) / (whole.t1 - whole.t0), p_t);
        double w_k = 0;
        for (std::size_t a = 0; a < 3; ++a)
          for (std::size_t b = 0; b < 3; ++b) w_k += w.of(e, k)[a * 3 + b] * p_s[a] * p_t[b];
        const double weight = 0.25 * (box.s1 - box.s0) * (box.t1 - box.t0) * rule.weights[i] *
                              rule.weights[j] * sector.jacobian * (1 - t);
        product += weight * w_k * sent[0];
        square += weight * 0.5 * sent[k] * sent[k];
      }
    return {product, square};
  }
};

TEST(ResidualSums, AreThoseOfARuleOnOneCell) {
  for (const std::string name : {"cube", "tetrahedron"}) {
    const Drawn drawn(name, Draw(23));
    for (const std::size_t e : {0U, 5U, 11U}) {
      SectorBox box = drawn.elements[e].box;
      box.t0 = box.t0 + 0.25 * (box.t1 - box.t0);
      box.t1 = box.t0 + 0.25 * (box.t1 - box.t0);
      const double middle = box.middle_s();
      box.s1 = middle + 0.125 * (box.s1 - middle);
      box.s0 = middle;
      const ResidualSums sums = drawn.over({{.element = e, .box = box, .nodes_s = 8, .nodes_t = 8}});
      for (const std::size_t k : {0U, 1U}) {
        const auto [product, square] = drawn.by_a_rule(e, box, k);
        EXPECT_NEAR(sums.products[k].value, product, sums.products[k].radius + 1e-9) << name << " " << e;
        EXPECT_NEAR(sums.norms[k], std::sqrt(square), 1e-5) << name << " " << e;
        EXPECT_LT(sums.products[k].radius, 1e-3 * std::abs(product) + 1e-9);
      }
    }
  }
}

TEST(ResidualSums, OfAClosedCellDifferByWhatItsBoundSays) {
  // At an edge T w is F and a little; the little is bounded by `nearby`.
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const Drawn drawn(name, Draw(29));
    for (std::size_t e = 0; e < drawn.elements.size(); e += 7) {
      const SectorBox& whole = drawn.elements[e].box;
      if (whole.t0 != 0) continue;
      SectorBox box = whole;
      box.t1 = std::ldexp(whole.t1, -10);
      const double width = whole.s1 - whole.s0;
      box.s0 = whole.s0 + 0.375 * width;
      box.s1 = whole.s0 + 0.4375 * width;
      const double bound = drawn.trial.closure.nearby(e, box).bound;
      ASSERT_LT(bound, 0.1);
      const ResidualSums closed =
          drawn.over({{.element = e, .box = box, .nodes_s = 8, .nodes_t = 8, .closed = true}});
      const double area = drawn.scene.sectors()[drawn.elements[e].sector].jacobian * box.weight();
      for (const std::size_t k : {0U, 1U}) {
        const auto [product, square] = drawn.by_a_rule(e, box, k);
        EXPECT_NEAR(closed.products[k].value, product,
                    area * drawn.trial.smoothness.density_size(e) * bound + closed.products[k].radius)
            << name << " " << e;
        EXPECT_NEAR(closed.norms[k], std::sqrt(square), std::sqrt(area) * bound + 1e-6) << name << " " << e;
      }
    }
  }
}

TEST(ResidualSums, OfAClosedCellSeeTheOtherSideAtTheSamePointOfTheEdge) {
  // x and x - 1/2 P_2(x) of the place x along the side are not symmetric on the cell: their products differ
  // where the other side is taken at a mirrored point.
  const auto leaning = [](std::size_t elements) {
    SectorFunctions w(elements, 2, 2);
    for (std::size_t e = 0; e < elements; ++e)
      for (const std::size_t k : {0U, 1U}) {
        w.of(e, k)[3] = 1;
        w.of(e, k)[6] = k == 0 ? 0 : -0.5;
      }
    return w;
  };
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const Drawn drawn(name, leaning);
    int tried = 0;
    for (std::size_t e = 0; e < drawn.elements.size(); e += 5) {
      const SectorBox& whole = drawn.elements[e].box;
      if (whole.t0 != 0) continue;
      ++tried;
      const double width = whole.s1 - whole.s0;
      const SectorBox box{.s0 = whole.s0 + 0.25 * width,
                          .s1 = whole.s0 + 0.625 * width,
                          .t0 = 0,
                          .t1 = std::ldexp(whole.t1, -20)};
      const double area = drawn.scene.sectors()[drawn.elements[e].sector].jacobian * box.weight();
      const double most =
          area * drawn.trial.smoothness.density_size(e) * drawn.trial.closure.nearby(e, box).bound;
      ASSERT_LT(most, 5e-3 * area);
      const ResidualSums closed =
          drawn.over({{.element = e, .box = box, .nodes_s = 8, .nodes_t = 8, .closed = true}});
      for (const std::size_t k : {0U, 1U})
        EXPECT_NEAR(closed.products[k].value, drawn.by_a_rule(e, box, k).first, most + 1e-6 * area)
            << name << " " << e;
    }
    EXPECT_GT(tried, 3);
  }
}

TEST(ResidualSums, HaveTheSameBitsForAnyNumberOfThreads) {
  const Furnace furnace("tetrahedron", 2, 1);
  const CellDemand demand{.interpolation = 1e-2, .quadrature = 1e-4};
  const ResidualSums all = furnace.sums(demand);
  const ThreadLimit limit(1);
  const ResidualSums one = furnace.sums(demand);
  EXPECT_EQ(all.norms, one.norms);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(all.products[k].value, one.products[k].value);
    EXPECT_EQ(all.products[k].radius, one.products[k].radius);
  }
}

TEST(ResidualSums, CountWhatIsShaded) {
  // The means of one wall around a corner: on cells that are whole elements the residual of a good function
  // is small beside what is not known of shaded parts.
  const std::vector<Panel> room = test::l_room();
  const SectorScene scene(test::cut(room), room);
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  const std::vector<double> rho(scene.panels().size(), 0.5);
  std::vector<std::vector<double>> emissions(2, std::vector<double>(scene.panels().size()));
  for (std::size_t j = 0; j < scene.panels().size(); ++j) {
    emissions[0][j] = scene.panels()[j].piece == 4 ? 1 : 0;
    emissions[1][j] = scene.panels()[j].piece == 0 ? 0.5 : 0;
  }
  const SectorFunctions given = panel_functions(scene, elements, emissions, 1);
  const Trial trial(scene, rho, elements, given, trial_functions(scene, elements, rho, given, 1e-4));
  std::vector<ObserverCell> cells;
  std::array<double, 2> products{};
  double squares = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Sector& sector = trial.sector(e);
    const SectorBox& box = elements[e].box;
    if (box.t0 == 0) continue;
    const auto hull = corners_of(sector, box);
    const std::vector<ShadedPart> shaded =
        trial.penumbra.shaded(sector.panel, hull, trial.penumbra.may_be_shaded(sector.panel), 0);
    if (shaded.empty()) continue;
    cells.push_back({.element = e, .box = box, .nodes_s = 3, .nodes_t = 3});
    const Penumbra::Rest rest = trial.penumbra.rest(shaded);
    const double area = sector.jacobian * box.weight();
    squares += rho[sector.panel] * area * rest.bounds[1] * rest.bounds[1];
    for (const std::size_t k : {0U, 1U}) products[k] += area * trial.penumbra.size(e, k) * rest.bounds[0];
  }
  const ResidualSums sums = residual_sums(trial, cells, {.interpolation = 1e-4, .quadrature = 1e-4});
  EXPECT_GE(sums.norms[1], 0.999 * std::sqrt(squares));
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_GE(sums.products[k].radius, 0.999 * products[k]);
    EXPECT_LE(sums.products[k].radius, 1.5 * products[k]);
  }
  EXPECT_GT(squares, 1e-5);
}

}  // namespace
}  // namespace radcert
