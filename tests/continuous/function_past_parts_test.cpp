// SPDX-License-Identifier: GPL-3.0-or-later
// Functions on polyhedra whose parts hide each other.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/function_enclosure.h"
#include "radcert/continuous/observer_cells.h"
#include "radcert/continuous/residual.h"
#include "radcert/continuous/residual_samples.h"
#include "radcert/continuous/trial.h"
#include "tests/continuous/demands.h"
#include "tests/continuous/rooms.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;

/// T w by rays: what they meet first sends w.
class Rays {
public:
  Rays(const SectorScene& scene, const std::vector<SectorElement>& elements, const SectorFunctions& w)
      : scene_(scene), elements_(elements), w_(w) {}

  /// Maths     directions whose projections on the plane of the panel fill the unit disk evenly, by middle
  ///           points in its angle and its squared radius
  [[nodiscard]] double transported(std::size_t panel, const Vector<double>& p, int steps) const {
    const Vector<double>& n = scene_.normal(panel);
    const Vector<double> off = std::abs(n.x) < 0.5 ? Vector<double>{1, 0, 0} : Vector<double>{0, 1, 0};
    Vector<double> u = off - dot(off, n) * n;
    u = (1 / norm(u)) * u;
    const Vector<double> v = cross(n, u);
    double sum = 0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const double squared = (i + 0.5) / steps;
        const double angle = 2 * std::numbers::pi * (j + 0.5 + 0.37 * i) / steps;
        const double radius = std::sqrt(squared);
        sum +=
            sent(p, radius * std::cos(angle) * u + radius * std::sin(angle) * v + std::sqrt(1 - squared) * n);
      }
    return sum / (steps * steps);
  }

private:
  /// w where the ray from p ends.
  [[nodiscard]] double sent(const Vector<double>& p, const Vector<double>& way) const {
    double nearest = std::numeric_limits<double>::infinity();
    double value = 0;
    for (std::size_t k = 0; k < scene_.sectors().size(); ++k) {
      const Sector& sector = scene_.sectors()[k];
      const Vector<double>& n = scene_.normal(sector.panel);
      const double towards = dot(n, way);
      const double length = towards == 0 ? -1 : dot(n, sector.a - p) / towards;
      if (!(length > 1e-9 && length < nearest)) continue;
      const Vector<double> q = p + length * way;
      // The parts of the triangle a, b, c that lie across from its corners.
      const double whole = dot(n, cross(sector.b - sector.a, sector.c - sector.a));
      const double of_a = dot(n, cross(sector.b - q, sector.c - q)) / whole;
      const double of_b = dot(n, cross(sector.c - q, sector.a - q)) / whole;
      const double of_c = 1 - of_a - of_b;
      if (!(of_a >= 0 && of_b >= 0 && of_c >= 0)) continue;
      nearest = length;
      value = at(k, of_a + of_b > 0 ? of_b / (of_a + of_b) : 0, of_c);
    }
    return value;
  }
  [[nodiscard]] double at(std::size_t sector, double s, double t) const {
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const SectorBox& box = elements_[e].box;
      if (elements_[e].sector == sector && box.s0 <= s && s <= box.s1 && box.t0 <= t && t <= box.t1)
        return test::element_value<double>(w_, e, 0, box, s, t);
    }
    return 0;
  }

  const SectorScene& scene_;
  const std::vector<SectorElement>& elements_;
  const SectorFunctions& w_;
};

TEST(LargestResiduals, BoundWhatOtherPartsLeaveToBeSeen) {
  double closest = 0;
  double most_shade = 0;
  for (const std::vector<Panel>& room : {test::l_room(), test::cube_in_a_cube()}) {
    const SectorScene scene(test::cut(room), room);
    const std::vector<SectorElement> elements = graded_elements(scene, 1);
    Draw draw(31);
    SectorFunctions emissions = test::drawn_functions(elements.size(), 1, 1, draw);
    // One panel shines: what is hidden of it shows.
    for (std::size_t e = 0; e < elements.size(); ++e)
      emissions.of(e, 0)[0] = scene.sectors()[elements[e].sector].panel == 1 ? 3 : 0.1;
    const Trial trial(scene, std::vector<double>(scene.panels().size(), 0.5), elements, emissions,
                      SectorFunctions(elements.size(), 1, 1));
    const test::EvenDemand demand(1, 1e-3);
    const std::vector<ObserverCell> all = observer_cells(trial, demand);
    std::vector<ObserverCell> cells;
    for (const ObserverCell& cell : all)
      if (!cell.is_strip() && draw.below(all.size()) < 40) cells.push_back(cell);
    const std::vector<double> largest = largest_residuals(trial, cells, demand);
    // With one node nothing else is in the bound but the value there, and what is seen in part.
    std::vector<ObserverCell> middles = cells;
    for (ObserverCell& cell : middles) cell.nodes_s = cell.nodes_t = 1;
    for (ObserverCell& cell : middles) cell.of_interpolant = cell.beside = 0;
    const std::vector<double> at_middles = largest_residuals(trial, middles, test::EvenDemand(1e-3));
    const std::vector<CellSamples> samples =
        ResidualSamples(trial)(middles, CellTolerances(cells.size(), 1e-4));
    const Rays rays(scene, elements, trial.w);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const Sector& sector = trial.sector(cells[c].element);
      const SectorBox& box = cells[c].box;
      EXPECT_GE(largest[c], cells[c].of_interpolant + cells[c].beside);
      const double shade = samples[c].largest_shade();
      EXPECT_GE(at_middles[c] + samples[c].radius, std::abs(samples[c].values[0]) + shade);  // q is 0
      EXPECT_LE(shade, 0.5);
      most_shade = std::max(most_shade, shade);
      const Vector<double> p =
          sector.point(box.s0 + (box.s1 - box.s0) * draw(), box.t0 + (box.t1 - box.t0) * draw());
      const double residual = rays.transported(sector.panel, p, 100);
      // Rays are even within a hundredth.
      EXPECT_LE(residual, largest[c] + 0.03) << c;
      closest = std::max(closest, residual / largest[c]);
    }
  }
  EXPECT_GT(closest, 0.5);
  EXPECT_GT(most_shade, 0.1);
}

TEST(FunctionEnclosure, ContainsOneInAFurnaceWhosePartsHideEachOther) {
  // The floor reflects: residuals on the others do not count.
  std::vector<Rational> rho(8, 0);
  std::vector<Rational> emission(8, 1);
  rho[0] = Rational(1, 10);
  emission[0] = Rational(9, 10);
  const PolyhedronProblem furnace = test::occluded_problem(test::l_room(), rho, emission);
  const FunctionEnclosure found = enclose_function(furnace, 2, 0.2);
  EXPECT_TRUE(found.hindrance.empty());
  EXPECT_LE(found.sup, 1);
  ASSERT_EQ(found.pieces.size(), 8U);
  ASSERT_FALSE(found.parts.empty());
  for (const EnclosedPart& part : found.parts)
    for (const double value : part.values) EXPECT_LE(std::abs(value - 1), part.bound);
}

TEST(ObserverCells, AreNotCutTowardsALineThatNothingTouches) {
  // Parts of one face meet in the plane of a wall that ends further off.
  const std::vector<Panel> room = test::l_room();
  const SectorScene scene(test::cut(room), room);
  std::size_t apart = 0;
  for (std::size_t i = 0; i < scene.sectors().size(); ++i)
    for (std::size_t j = 0; j < scene.panels().size(); ++j) {
      const Sector& sector = scene.sectors()[i];
      if (j == sector.panel || scene.coplanar(j, sector.panel)) continue;
      // A side touches a panel where its middle is in it.
      const Vector<double> middle = 0.5 * (sector.a + sector.b);
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = scene.first_sector(j); k < scene.first_sector(j + 1); ++k) {
        const Sector& of_panel = scene.sectors()[k];
        least = std::min(least, distance(middle, of_panel.a, of_panel.b));
      }
      const bool in_plane =
          std::abs(dot(scene.normal(j), middle - scene.sectors()[scene.first_sector(j)].a)) < 1e-12;
      EXPECT_EQ(scene.touching(i, j), in_plane && least < 1e-12) << i << " " << j;
      if (in_plane && scene.parallel(i, j) && least > 0.4) ++apart;
    }
  EXPECT_GT(apart, 0U);
}

/// A cube whose floor is two faces, so that edges of walls have not their ends; u = 1, and one wall reflects.
PolyhedronProblem cube_on_two_floors() {
  PolyhedronProblem out{.panels = test::panels_of("cube"), .reflectivity = {}, .emission = {}};
  std::vector<Panel> panels;
  for (const Panel& panel : out.panels) {
    bool is_floor = true;
    for (const Vector<Rational>& corner : panel.corners) is_floor = is_floor && corner.z == Rational(0);
    if (!is_floor) {
      panels.push_back(panel);
      continue;
    }
    for (const Rational& from : {Rational(0), Rational(1, 2)}) {
      Panel half = panel;
      half.piece = from == Rational(0) ? panel.piece : out.panels.size();
      for (Vector<Rational>& corner : half.corners) corner.x = from + Rational(1, 2) * corner.x;
      half.centre.x = from + Rational(1, 2) * panel.centre.x;
      panels.push_back(half);
    }
  }
  out.panels = std::move(panels);
  out.reflectivity.assign(out.panels.size(), Rational(0));
  out.emission.assign(out.panels.size(), constant_polynomial(Rational(1)));
  for (std::size_t k = 0; k < out.panels.size(); ++k) {
    if (out.panels[k].normal.y.sign() <= 0) continue;
    out.reflectivity[k] = Rational(1, 8);
    out.emission[k] = constant_polynomial(Rational(7, 8));
  }
  return out;
}

TEST(FunctionEnclosure, SaysWhatStandsInTheWayWhereEdgesHaveOtherEndsOnTheOtherSide) {
  const PolyhedronProblem asked = cube_on_two_floors();
  ASSERT_EQ(asked.panels.size(), 7U);
  const FunctionEnclosure found = enclose_function(asked, 0.5, 0.1);
  EXPECT_NE(found.hindrance.find("have not the same ends"), std::string::npos) << found.hindrance;
  EXPECT_GT(found.sup, 0.25);
  for (const EnclosedPart& part : found.parts)
    for (const double value : part.values) EXPECT_LE(std::abs(value - 1), part.bound);
}

}  // namespace
}  // namespace radcert
