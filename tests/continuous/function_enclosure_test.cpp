// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/function_enclosure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/observer_cells.h"
#include "radcert/continuous/residual.h"
#include "radcert/continuous/transport/transport.h"
#include "radcert/continuous/trial.h"
#include "radcert/continuous/vertex_disks.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"
#include "tests/continuous/demands.h"
#include "tests/continuous/memory.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

PolyhedronProblem problem(const std::string& name, const Rational& rho, const Rational& emission) {
  PolyhedronProblem out{.panels = panels_of(name), .reflectivity = {}, .emission = {}};
  out.reflectivity.assign(out.panels.size(), rho);
  out.emission.assign(out.panels.size(), constant_polynomial(emission));
  return out;
}

/// u = 1 where some faces reflect: residuals on the others do not count, and are not looked at.
PolyhedronProblem furnace(const Rational& rho, std::size_t reflecting) {
  PolyhedronProblem out = problem("tetrahedron", 0, 1);
  for (std::size_t k = 0; k < reflecting; ++k) {
    out.reflectivity[k] = rho;
    out.emission[k] = constant_polynomial(Rational(1) - rho);
  }
  return out;
}

TEST(FunctionEnclosure, ContainsOneInAFurnace) {
  const FunctionEnclosure found = enclose_function(furnace(Rational(1, 4), 2), 2, 0.1);
  EXPECT_TRUE(found.hindrance.empty());
  EXPECT_LE(found.sup, 1);
  ASSERT_EQ(found.pieces.size(), 4U);
  for (const EnclosedPart& part : found.parts)
    for (const double value : part.values) EXPECT_LE(std::abs(value - 1), part.bound);
  // Coordinates are those of the surface: each part lies in the plane of a panel of its piece.
  const std::vector<Panel> panels = panels_of("tetrahedron");
  for (const EnclosedPart& part : found.parts)
    for (const Vector<double>& corner : part.corners) {
      double least = 1;
      for (const Panel& panel : panels) {
        if (panel.piece != part.piece) continue;
        const auto rounded = [](const Vector<Rational>& p) {
          return Vector<double>{p.x.to_double(), p.y.to_double(), p.z.to_double()};
        };
        least = std::min(least, std::abs(dot(rounded(panel.normal), corner - rounded(panel.corners[0]))));
      }
      EXPECT_LE(least, 1e-14);
    }
  for (const FunctionEnclosure::OnPiece& piece : found.pieces) {
    EXPECT_LE(piece.outside, found.sup);
    EXPECT_LE(piece.outside, piece.everywhere);
  }
}

TEST(FunctionEnclosure, IsTheEmissionWhereNothingReflects) {
  PolyhedronProblem dark = problem("tetrahedron", 0, 0);
  dark.emission[2] = constant_polynomial(Rational(5));
  const FunctionEnclosure found = enclose_function(dark, 1e-6, 0.01);
  EXPECT_LE(found.sup, 1e-12);
  EXPECT_EQ(found.outside, 0);
  for (const EnclosedPart& part : found.parts)
    for (const double value : part.values)
      EXPECT_NEAR(value, part.piece == dark.panels[2].piece ? 5 : 0, 1e-12);
}

TEST(FunctionEnclosure, ContainsOneInAFurnaceOfPolynomials) {
  PolyhedronProblem mixed = furnace(0, 0);
  PlanePolynomial<Rational> rho(2);
  rho(0, 0) = Rational(1, 10);
  rho(2, 0) = Rational(1, 5);
  rho(1, 1) = Rational(-1, 5);
  for (const std::size_t k : {0U, 2U}) {
    mixed.reflectivity[k] = reflectivity_of(mixed.panels[k], rho).value();
    mixed.emission[k] = sum(constant_polynomial(Rational(1)), Rational(-1), rho);
  }
  const FunctionEnclosure found = enclose_function(mixed, 2, 0.1);
  EXPECT_LE(found.sup, 1);
  double farthest = 0;
  for (const EnclosedPart& part : found.parts)
    for (const double value : part.values) {
      EXPECT_LE(std::abs(value - 1), part.bound);
      farthest = std::max(farthest, std::abs(value - 1));
    }
  EXPECT_GT(farthest, 0);
}

TEST(FunctionEnclosure, KnowsThatCoefficientsAreRoundedWhereNothingReflects) {
  // v is a double, and u is a third.
  for (const Rational& rho : {Rational(0), Rational(1, 1000000000)}) {
    PolyhedronProblem dark = problem("tetrahedron", 0, 0);
    dark.emission[1] = constant_polynomial(Rational(1, 3));
    for (std::size_t j = 0; j < dark.panels.size(); ++j)
      if (j != 1) dark.reflectivity[j] = rho;
    const FunctionEnclosure found = enclose_function(dark, 0.1, 0.1);
    const double off = abs(Ball(Rational(1, 3)) - Ball(1.0 / 3)).upper_double();
    ASSERT_GT(off, 1e-17);
    EXPECT_GE(found.sup, off);
    EXPECT_GE(found.pieces[dark.panels[1].piece].everywhere, off);
    for (const EnclosedPart& part : found.parts)
      if (part.piece == dark.panels[1].piece) {
        EXPECT_GE(part.bound, off);
      }
  }
}

/// A prism of the height 1 over a convex polygon, black, with the emission 1; `low` is the height of the last
/// corner's upper vertex, whose neighbours have a triangle with it on top.
PolyhedronProblem black_prism(const std::vector<std::pair<Rational, Rational>>& base, const Rational& low) {
  using Point = Vector<Rational>;
  const std::size_t n = base.size();
  const auto at = [&](std::size_t k, const Rational& z) { return Point{base[k].first, base[k].second, z}; };
  std::vector<std::vector<Point>> faces(2);
  for (std::size_t k = 0; k < n; ++k) faces[0].push_back(at(k, 0));
  for (std::size_t k = 0; k + 1 < n; ++k) faces[1].push_back(at(k, 1));
  if (low == Rational(1))
    faces[1].push_back(at(n - 1, 1));
  else
    faces.push_back({at(n - 2, 1), at(n - 1, low), at(0, 1)});
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    faces.push_back({at(k, 0), at(next, 0), at(next, next + 1 == n ? low : 1), at(k, k + 1 == n ? low : 1)});
  }
  const Point within{2, 2, Rational(1, 2)};
  PolyhedronProblem out;
  for (std::vector<Point>& corners : faces) {
    Point normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (dot(normal, within - corners[0]).sign() < 0) {
      std::reverse(corners.begin(), corners.end());
      normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    }
    Point sum = corners[0];
    for (std::size_t i = 1; i < corners.size(); ++i) sum = sum + corners[i];
    out.panels.push_back({.piece = out.panels.size(),
                          .corners = corners,
                          .centre = Rational(1, static_cast<int>(corners.size())) * sum,
                          .normal = normal});
    out.reflectivity.emplace_back(0);
    out.emission.push_back(constant_polynomial(Rational(1)));
  }
  return out;
}

TEST(FunctionEnclosure, IsFoundWhereAVertexIsAsNearToAnotherFaceAsDoubleCanTell) {
  const Rational low = Rational(1) - Rational(1, 1000000000000000);
  const PolyhedronProblem sharp = black_prism({{4, 0}, {4, 4}, {2, Rational(9, 2)}, {0, 4}, {0, 0}}, low);
  const FunctionEnclosure found = enclose_function(sharp, 1, 0.1);
  EXPECT_TRUE(found.hindrance.empty()) << found.hindrance;
  EXPECT_LE(found.sup, 1e-12);
}

TEST(FunctionEnclosure, IsRefusedWhereTwoVerticesAreAsNearAsDoubleCanTell) {
  const Rational little(1, 1'000'000'000'000'000'000);
  const PolyhedronProblem sharp =
      black_prism({{4, 0}, {4, 4}, {Rational(4) - little, Rational(4) + little / 2}, {0, 4}, {0, 0}}, 1);
  const FunctionEnclosure found = enclose_function(sharp, 1, 0.1);
  EXPECT_FALSE(std::isfinite(found.sup));
  EXPECT_FALSE(found.hindrance.empty());
}

TEST(FunctionEnclosure, AddsTheResidualAndWhatIsReflectedOfIt) {
  // u - v = R + K R + K K R + ... with R the residual: where that of every element is r or more, |u - v|
  // may be R + r rho/(1 - rho).
  const PolyhedronProblem asked = problem("tetrahedron", Rational(1, 4), Rational(3, 4));
  const FunctionEnclosure found = enclose_function(asked, 10000, 0.1, {}, true);
  const SectorScene scene(asked.panels);
  const std::vector<SectorElement> elements = graded_elements(scene, found.last.layers);
  const FunctionProof& proof = *found.proof;
  ASSERT_EQ(found.parts.size(), 16 * elements.size());
  const auto in_units = [&](double x) { return std::ldexp(x, proof.exponent); };
  const double least = in_units(*std::min_element(proof.residuals.begin(), proof.residuals.end()));
  const double most = in_units(*std::max_element(proof.residuals.begin(), proof.residuals.end()));
  const double reflected = least / 3;
  ASSERT_GT(reflected, 1e-6 * most);
  std::size_t tried = 0;
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (std::size_t k = 0; k < proof.elements.size(); ++k) {
      if (proof.elements[k].sector != elements[e].sector || proof.elements[k].box != elements[e].box)
        continue;
      ++tried;
      double bound = 0;
      for (std::size_t part = 16 * e; part < 16 * (e + 1); ++part)
        bound = std::max(bound, found.parts[part].bound);
      EXPECT_GE(bound, in_units(proof.residuals[k]) + reflected) << e;
    }
  EXPECT_GT(tried, elements.size() / 2);
  EXPECT_GE(found.by_distance.back().sup, most + reflected);
  const VertexDisks disks(scene);
  for (const FunctionEnclosure::AtDistance& at : found.by_distance) {
    double outside = 0;
    for (std::size_t k = 0; k < proof.elements.size(); ++k)
      if (disks.distance_at_least(scene.sectors()[proof.elements[k].sector], proof.elements[k].box) >=
          at.outside)
        outside = std::max(outside, in_units(proof.residuals[k]));
    EXPECT_GE(at.sup, outside + reflected) << at.outside;
  }
}

TEST(FunctionEnclosure, CountsWhatItsValuesAreRoundedBy) {
  // Nothing reflects, and v = E is a Chebyshev polynomial across a face: the P_i that its values are
  // summed from are off by 8 (i+1)^2 units.
  PolyhedronProblem dark = problem("tetrahedron", 0, 0);
  const PlanePolynomial<Rational> x = affine_polynomial<Rational>(Rational(-1), Rational(2), 0);
  PlanePolynomial<Rational> before = constant_polynomial(Rational(1));
  dark.emission[2] = x;
  for (int n = 1; n < 8; ++n) {
    const PlanePolynomial<Rational> next =
        sum(product(product(constant_polynomial(Rational(2)), x), dark.emission[2]), Rational(-1), before);
    before = std::exchange(dark.emission[2], next);
  }
  const FunctionEnclosure found = enclose_function(dark, 1, 0.1);
  const SectorScene scene(dark.panels);
  const std::vector<SectorElement> elements = graded_elements(scene, found.last.layers);
  ASSERT_EQ(found.parts.size(), 16 * elements.size());
  const SectorFunctions v = emission_functions(dark, scene, elements, 1, 8, 0);
  double largest = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    double off = 0;
    for (std::size_t i = 0; i <= 8; ++i)
      for (std::size_t j = 0; j <= 8; ++j) {
        const std::size_t in_both = (i > 1 ? (i + 1) * (i + 1) : 0) + (j > 1 ? (j + 1) * (j + 1) : 0);
        off += 8 * static_cast<double>(in_both) * unit_roundoff<double>() * std::abs(v.of(e, 0)[9 * i + j]);
      }
    largest = std::max(largest, off);
    for (std::size_t part = 16 * e; part < 16 * (e + 1); ++part) EXPECT_GE(found.parts[part].bound, off) << e;
  }
  EXPECT_GT(largest, 100 * unit_roundoff<double>());
}

/// Functions on three layers that have jumps, small as those of an approximation.
struct Jumping {
  SectorScene scene;
  std::vector<double> reflectivity;
  std::vector<SectorElement> elements;
  Trial trial;

  explicit Jumping(const std::string& name, double size, std::uint64_t seed)
      : scene(panels_of(name)),
        reflectivity(scene.panels().size(), 0.5),
        elements(graded_elements(scene, 3)),
        trial(scene, reflectivity, elements, functions(size, seed), ones()) {}

private:
  /// q = 1 and E about 1/2, so that w is about 1, and T w - q small: its bound is what rules miss, above all.
  [[nodiscard]] SectorFunctions ones() const {
    SectorFunctions q(elements.size(), 1, 2);
    for (std::size_t e = 0; e < elements.size(); ++e) q.of(e, 0)[0] = 1;
    return q;
  }
  [[nodiscard]] SectorFunctions functions(double size, std::uint64_t seed) const {
    Draw draw(seed);
    SectorFunctions w = test::drawn_functions(elements.size(), 1, 2, draw);
    for (double& c : w.all()) c *= size;
    for (std::size_t e = 0; e < elements.size(); ++e) w.of(e, 0)[0] += 0.5;
    return w;
  }
};

TEST(LargestResiduals, SeeWhatVariesAboutAMeanOfZero) {
  // E = 1 - q/2 with q = 1 + x: w = 1, T w = 1, and t = -x, the place along the side.
  const SectorScene scene(panels_of("cube"));
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  SectorFunctions q(elements.size(), 1, 1);
  SectorFunctions emissions = q;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    q.of(e, 0)[0] = 1;
    q.of(e, 0)[2] = 1;
    emissions.of(e, 0)[0] = 0.5;
    emissions.of(e, 0)[2] = -0.5;
  }
  const Trial trial(scene, std::vector<double>(6, 0.5), elements, emissions, q);
  const test::EvenDemand demand(0.02, 1e-5);
  std::size_t tried = 0;
  for (std::size_t e = 0; e < elements.size() && tried < 3; ++e) {
    if (elements[e].box.t0 == 0) continue;
    ++tried;
    const std::vector<ObserverCell> cell{{.element = e, .box = elements[e].box, .nodes_s = 4, .nodes_t = 4}};
    const double largest = largest_residuals(trial, cell, demand)[0];
    EXPECT_GE(largest, 1);
    EXPECT_LE(largest, 1.1);
  }
  EXPECT_EQ(tried, 3U);
}

TEST(LargestResiduals, BoundTheResidualEverywhere) {
  for (const std::string name : {"cube", "tetrahedron"}) {
    const Jumping jumping(name, 0.02, 11);
    const Trial& trial = jumping.trial;
    const test::EvenDemand demand(0.02, 1e-5);
    // One cell in three, from all elements.
    const std::vector<ObserverCell> all = observer_cells(trial, demand);
    std::vector<ObserverCell> cells;
    for (std::size_t c = 0; c < all.size(); c += 3) cells.push_back(all[c]);
    const std::vector<double> largest = largest_residuals(trial, cells, demand);
    // What rules miss and what a closure leaves is in every bound: a sample of the surface cannot see that.
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].is_strip()) continue;
      EXPECT_GT(cells[c].of_interpolant, 0);
      EXPECT_GE(largest[c], cells[c].of_interpolant + cells[c].beside);
      EXPECT_EQ(cells[c].beside > 0, cells[c].closed);
    }
    const Transport transport(jumping.scene, trial.elements, trial.w);
    Draw draw(12);
    double closest = 0;
    int closed = 0;
    for (int k = 0; k < 500; ++k) {
      const std::size_t c = draw.below(cells.size());
      const ObserverCell& cell = cells[c];
      if (cell.is_strip()) continue;
      if (cell.closed) ++closed;
      const Sector& sector = trial.sector(cell.element);
      const Vector<double> p =
          sector.point(cell.box.s0 + (cell.box.s1 - cell.box.s0) * draw(),
                       cell.box.t0 + (cell.box.t1 - cell.box.t0) * (0.01 + 0.99 * draw()));
      const Transport::Values sent = transport({.panel = sector.panel, .points = {p}}, 1e-8);
      const double residual = std::abs(sent.values[0] - 1);
      EXPECT_LE(residual, largest[c] + sent.radius);
      closest = std::max(closest, residual / largest[c]);
    }
    EXPECT_GT(closest, 0.4) << name;
    EXPECT_GT(closed, 0) << name;
  }
}

TEST(EdgeClosure, BoundsWhatIsSentAcrossBorders) {
  double closest = 0;
  int tried = 0;
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const Jumping jumping(name, 0.1, 21);
    const Trial& trial = jumping.trial;
    const EdgeClosure& closure = trial.closure;
    Draw draw(22);
    for (int k = 0; k < 150; ++k) {
      const std::size_t e = draw.below(trial.elements.size());
      const SectorBox& whole = trial.elements[e].box;
      if (whole.t0 != 0 || !closure.mirror(e)) continue;
      // From a border, where the element beyond ends.
      const double width = (whole.s1 - whole.s0) * std::exp2(-2 - 8 * draw());
      const SectorBox box{
          .s0 = whole.s0, .s1 = whole.s0 + width, .t0 = 0, .t1 = whole.t1 * std::exp2(-6 - 8 * draw())};
      const EdgeClosure::Nearby nearby = closure.nearby_across_borders(e, box);
      if (!std::isfinite(nearby.bound)) continue;
      ++tried;
      EXPECT_LE(nearby.jumps, nearby.bound);
      const std::size_t mirror = *closure.mirror(e);
      const Sector& sector = trial.sector(e);
      const double s = box.s0 + width * draw();
      const double t = box.t1 * (0.1 + 0.9 * draw());
      const SectorBox& across = trial.elements[mirror].box;
      std::array<double, 3> p{};
      legendre_values<double>((2 * (1 - s) - across.s0 - across.s1) / (across.s1 - across.s0), p);
      double xi = 0;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          xi += trial.w.of(mirror, 0)[i * 3 + j] * p[i] * (j % 2 == 0 ? 1 : -1);
      SectorFunctions rest(trial.elements.size(), 1, 2);
      for (std::size_t other = 0; other < trial.elements.size(); ++other) {
        if (trial.sector(other).panel != trial.sector(mirror).panel) continue;
        const std::span<const double> from = trial.w.of(other, 0);
        std::copy(from.begin(), from.end(), rest.of(other, 0).begin());
        rest.of(other, 0)[0] -= xi;
      }
      const Transport sent(jumping.scene, trial.elements, rest);
      const Transport::Values found = sent({.panel = sector.panel, .points = {sector.point(s, t)}}, 1e-9);
      EXPECT_LE(std::abs(found.values[0]) - found.radius, nearby.bound) << name << " " << e;
      closest = std::max(closest, std::abs(found.values[0]) / nearby.bound);
    }
  }
  EXPECT_GT(tried, 40);
  EXPECT_GT(closest, 0.05);
}

TEST(FunctionEnclosure, HasTheSameBitsForAnyNumberOfThreads) {
  const PolyhedronProblem asked = furnace(Rational(1, 8), 1);
  const FunctionEnclosure many = enclose_function(asked, 4, 0.1);
  const ThreadLimit limit(1);
  const FunctionEnclosure one = enclose_function(asked, 4, 0.1);
  EXPECT_EQ(many.sup, one.sup);
  ASSERT_EQ(many.parts.size(), one.parts.size());
  for (std::size_t k = 0; k < one.parts.size(); ++k) EXPECT_EQ(many.parts[k].bound, one.parts[k].bound);
}

TEST(FunctionEnclosure, GoesOnFromWhatIsKept) {
  const PolyhedronProblem asked = furnace(Rational(1, 8), 1);
  const FunctionEnclosure by_itself = enclose_function(asked, 4, 0.1);
  test::Memory memory;
  EXPECT_EQ(enclose_function(asked, 4, 0.1, {.kept = &memory}).sup, by_itself.sup);
  ASSERT_GT(memory.numbers.size(), 2U);
  test::Memory half(memory.half());
  const FunctionEnclosure again = enclose_function(asked, 4, 0.1, {.kept = &half});
  EXPECT_GT(half.found, 0);
  EXPECT_EQ(half.numbers, memory.numbers);
  EXPECT_EQ(again.sup, by_itself.sup);
  for (std::size_t k = 0; k < again.parts.size(); ++k)
    EXPECT_EQ(again.parts[k].bound, by_itself.parts[k].bound);
}

}  // namespace
}  // namespace radcert
