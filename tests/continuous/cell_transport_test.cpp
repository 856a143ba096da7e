// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/cell_transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/lagrange_table.h"
#include "radcert/continuous/transport/far_bound.h"
#include "radcert/core/contract.h"
#include "tests/continuous/rooms.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

/// Cells that shrink towards the edge of an element, in the order in which it is cut.
std::vector<CellNodes> graded_cells(const SectorBox& box, int layers, int nodes, double tolerance) {
  std::vector<CellNodes> cells;
  SectorBox rest = box;
  std::vector<SectorBox> rows;
  for (int layer = 0; layer < layers; ++layer) {
    SectorBox upper = rest;
    upper.t0 = rest.t1 = rest.t0 + (rest.t1 - rest.t0) / 4;
    rows.push_back(upper);
  }
  std::reverse(rows.begin(), rows.end());
  for (const SectorBox& row : rows) {
    constexpr int parts = 8;
    for (int k = 0; k < parts; ++k) {
      SectorBox cell = row;
      cell.s0 = row.s0 + (row.s1 - row.s0) * k / parts;
      cell.s1 = row.s0 + (row.s1 - row.s0) * (k + 1) / parts;
      cells.push_back({cell, nodes, nodes + 1, tolerance});
    }
  }
  return cells;
}

TEST(CellTransport, AgreesWithTransportToEachCellWithinItsRadius) {
  Draw draw(11);
  double closest = 0;
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const SectorScene scene(panels_of(name));
    const std::vector<SectorElement> elements = graded_elements(scene, 2);
    const SectorFunctions f = test::drawn_functions(elements.size(), 3, 2, draw);
    const Transport transport(scene, elements, f);
    for (int trial = 0; trial < 8; ++trial) {
      const std::size_t element = draw.below(elements.size());
      const double tolerance = std::pow(10.0, -1.0 - static_cast<double>(draw.below(10)));
      const std::vector<CellNodes> cells =
          graded_cells(elements[element].box, 1 + static_cast<int>(draw.below(4)),
                       2 + static_cast<int>(draw.below(7)), tolerance);
      const std::vector<Transport::Values> found = transport_to_cells(transport, element, cells);
      ASSERT_EQ(found.size(), cells.size());
      const Sector& sector = scene.sectors()[elements[element].sector];
      for (std::size_t c = 0; c < cells.size(); ++c) {
        const ObserverGroup group{
            .panel = sector.panel,
            .points = ElementInterpolation(cells[c].nodes_s, cells[c].nodes_t).points(sector, cells[c].box)};
        const Transport::Values alone = transport(group, 1e-13);
        ASSERT_EQ(found[c].values.size(), alone.values.size());
        EXPECT_LE(found[c].radius, 8 * tolerance * transport.size() + 4 * alone.radius) << name;
        for (std::size_t i = 0; i < alone.values.size(); ++i) {
          const double off = std::abs(found[c].values[i] - alone.values[i]);
          EXPECT_LE(off, found[c].radius + alone.radius) << name << " tolerance " << tolerance;
          closest = std::max(closest, (off - alone.radius) / found[c].radius);
        }
      }
    }
  }
  // The kernel is bounded far into the complex plane: values are much better than their radii.
  EXPECT_GT(closest, 1e-5);
}

// Whatever way values have come, their radii have at least the roundings that Transport counts of each sum.
TEST(CellTransport, HasTheRadiusOfWhatIsSummedAloneAndOfWhatIsInterpolated) {
  const SectorScene scene(panels_of("cube"));
  const std::vector<SectorElement> elements = graded_elements(scene, 1);
  SectorFunctions one(elements.size(), 1, 0);
  for (double& c : one.all()) c = 1;
  const Transport transport(scene, elements, one);
  const double roundings = 128 * unit_roundoff<double>() * transport.size();
  // Near the middle of a face, so small that all other faces are far.
  constexpr double small = 0x1p-10;
  const SectorBox box{.s0 = 0.25, .s1 = 0.25 + small, .t0 = 0.75, .t1 = 0.75 + small};
  for (const int nodes : {1, 9}) {  // one point is never interpolated
    const std::vector<CellNodes> cells{{box, nodes, nodes, 1e-7}};
    const std::vector<Transport::Values> found = transport_to_cells(transport, 0, cells);
    EXPECT_GE(found[0].radius, roundings) << nodes;
    for (const double value : found[0].values) EXPECT_LE(std::abs(value - 1), found[0].radius);
  }
}

TEST(CellTransport, LeavesAPanelOut) {
  const SectorScene scene(panels_of("cube"));
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  SectorFunctions one(elements.size(), 1, 0);
  for (double& c : one.all()) c = 1;
  const Transport transport(scene, elements, one);
  const std::vector<CellNodes> cells = graded_cells(elements[0].box, 3, 6, 1e-9);
  for (std::size_t panel = 1; panel < scene.panels().size(); ++panel) {
    const std::vector<Transport::Values> found = transport_to_cells(transport, 0, cells, panel);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const Sector& sector = scene.sectors()[elements[0].sector];
      const ObserverGroup group{.panel = sector.panel,
                                .points = ElementInterpolation(6, 7).points(sector, cells[c].box)};
      const Transport::Values alone = transport(group, 1e-12, panel);
      for (std::size_t i = 0; i < alone.values.size(); ++i)
        EXPECT_LE(std::abs(found[c].values[i] - alone.values[i]), found[c].radius + alone.radius);
    }
  }
}

TEST(CellTransport, IsNotForPanelsThatHideEachOther) {
  const SectorScene room(test::cut(test::l_room()), test::l_room());
  const std::vector<SectorElement> elements = graded_elements(room, 1);
  const Transport transport(room, elements, SectorFunctions(elements.size(), 1, 0));
  EXPECT_THROW(static_cast<void>(transport_to_cells(transport, 0, {})), ContractViolation);
}

TEST(CellTransport, OfNothingIsNothing) {
  const SectorScene scene(panels_of("cube"));
  const std::vector<SectorElement> elements = graded_elements(scene, 1);
  const Transport transport(scene, elements, SectorFunctions(elements.size(), 1, 0));
  EXPECT_TRUE(transport_to_cells(transport, 0, {}).empty());
  // Nothing is sent.
  const std::vector<CellNodes> cells = graded_cells(elements[0].box, 1, 3, 0.01);
  for (const Transport::Values& values : transport_to_cells(transport, 0, cells)) {
    EXPECT_EQ(values.radius, 0);
    for (const double value : values.values) EXPECT_EQ(value, 0);
  }
}

// From what the header states: A = 3/4 D/h, Bernstein's theorem, |G| <= min(D,H)/(D-a)^3.
TEST(FarBound, IsThatOfItsEllipse) {
  Draw draw(3);
  for (int trial = 0; trial < 200; ++trial) {
    const double half = 0.01 + draw();
    const double distance = half * (8.0 / 3 + 20 * draw() * draw());
    const double height = 2 * distance * draw();
    const double mass = 0.1 + draw();
    const FarBound bound(distance, half, height, mass);
    const double a = 0.75 * distance;
    if (!(a > 2.0001 * half)) continue;
    const double rho = a / half + std::sqrt(a * a / (half * half) - 1);
    const double most = mass * std::min(distance, height) / std::pow(distance - a, 3);
    for (int n = 1; n <= most_gauss_nodes; ++n) {
      const double expected = 2 * most * std::pow(rho, 1 - n) / (rho - 1);
      EXPECT_GE(bound.of_polynomials(n), expected * (1 - 1e-14));
      EXPECT_LE(bound.of_polynomials(n), expected * (1 + 1e-9));
    }
    const double slope = mass * std::min(distance, height) / std::pow(distance - 2 * half, 3);
    EXPECT_GE(bound.of_slope(), slope * (1 - 1e-14));
    EXPECT_LE(bound.of_slope(), slope * (1 + 1e-9));
  }
  EXPECT_TRUE(std::isinf(FarBound(2.66, 1, 1, 1).of_polynomials(16)));
  EXPECT_TRUE(std::isinf(FarBound(2.66, 1, 1, 1).of_slope()));
  EXPECT_TRUE(std::isinf(FarBound(-1, 1, 1, 1).of_polynomials(16)));
  EXPECT_EQ(FarBound(10, 1, 1, 0).of_polynomials(1), 0);
}

// G of P on a complex line and a real Q, by its definition: what the ellipse's bound is of.
TEST(FarBound, HoldsOnTheEllipse) {
  using Complex = std::complex<double>;
  Draw draw(5);
  double closest = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    // Observers in z = 0, in whose plane the line runs; Q above it with any normal.
    const double angle = 2 * std::numbers::pi * draw();
    const double half = 0.05 + 0.4 * draw();
    const Vector<double> q{2 * draw() - 1, 2 * draw() - 1, 0.01 + draw()};
    const Vector<double> m{2 * draw() - 1, 2 * draw() - 1, 2 * draw() - 1};
    const double distance = norm(q);
    const FarBound bound(distance, half, q.z, 1);
    const double axis = draw() < 0.5 ? 0.75 * distance / half : 2;
    if (!(0.75 * distance > 2 * half)) continue;
    const double minor = std::sqrt(axis * axis - 1);
    const double phase = 2 * std::numbers::pi * draw();
    const Complex x{axis * std::cos(phase), minor * std::sin(phase)};
    const Complex w[3] = {half * x * std::cos(angle) - q.x, half * x * std::sin(angle) - q.y, Complex(-q.z)};
    const Complex square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
    const Complex along = (w[0] * m.x + w[1] * m.y + w[2] * m.z) / norm(m);
    const double size = std::abs(q.z * along / (square * square));
    // 2 rho^(1-n)/(rho-1) M for n = 1, rho the sum of the half axes; M in the smaller ellipse bounds the
    // slope.
    const double rho = 0.75 * distance / half + std::sqrt(std::pow(0.75 * distance / half, 2) - 1);
    const double most = axis == 2 ? bound.of_slope() : bound.of_polynomials(1) * (rho - 1) / 2;
    EXPECT_LE(size, most * (1 + 1e-9));
    closest = std::max(closest, size / most);
  }
  EXPECT_GT(closest, 0.5);
}

TEST(FarBound, SaysHowManyNodesAreNeeded) {
  for (const double allowed : {1e-2, 1e-5, 1e-9}) {
    const FarBound bound(7, 1, 0.5, 0.1);
    const int nodes = bound.needed(allowed);
    ASSERT_LE(nodes, most_gauss_nodes);
    const double l = lagrange_moduli_at_the_ends(nodes);
    EXPECT_LE(bound.of_polynomials(nodes) * (1 + l) * l, 2 * allowed);
    EXPECT_GT(bound.of_polynomials(std::max(1, nodes - 2)) * 20, allowed);
  }
  EXPECT_GT(FarBound(7, 1, 0.5, 0.1).needed(1e-30), most_gauss_nodes);
  EXPECT_GT(FarBound(1, 1, 0.5, 0.1).needed(1), most_gauss_nodes);
  EXPECT_EQ(FarBound(7, 1, 0.5, 0).needed(1e-30), 1);
  // What is sent is next to nothing.
  EXPECT_EQ(FarBound(7, 1, 0.5, 0x1p-1070).needed(1), 1);
}

/// Lagrange's polynomials of n nodes at the end of the interval.
LagrangeTable at_the_end(int nodes) { return {nodes, {.middle = 1, .half = 0}, 1}; }

// With one node in the middle, f = a (2x^2-1) + b (2y^2-1) is a and b away from constants in either variable,
// and its interpolant off by 2a + 2b in the corners.
TEST(FarError, IsAttained) {
  const FarError error{.in_s = 0.25, .in_t = 0.125, .slope = 0};
  const LagrangeTable one = at_the_end(1);
  EXPECT_GE(error.of_interpolant(one, one, 0, 0), 0.75);
  EXPECT_LE(error.of_interpolant(one, one, 0, 0), 0.75 * (1 + 1e-9));
}

// Each term alone, at the end of the interval, where I makes the largest values of what it is given.
TEST(FarError, CountsWhatInterpolationMagnifies) {
  const LagrangeTable in_s = at_the_end(5);
  const LagrangeTable in_t = at_the_end(9);
  const double l_s = in_s.largest();
  const double l_t = in_t.largest();
  EXPECT_GT(l_s, 2);
  EXPECT_GT(l_t, l_s);
  EXPECT_GE((FarError{.in_s = 1, .in_t = 0, .slope = 0}.of_interpolant(in_s, in_t, 0, 0)), 1 + l_s);
  EXPECT_GE((FarError{.in_s = 0, .in_t = 1, .slope = 0}.of_interpolant(in_s, in_t, 0, 0)), l_s * (1 + l_t));
  constexpr double u = unit_roundoff<double>();
  EXPECT_GE((FarError{.in_s = 0, .in_t = 0, .slope = 1}.of_interpolant(in_s, in_t, 0, 0)), 16 * u);
  // Values that are off with the signs of Lagrange's polynomials.
  EXPECT_GE(FarError{}.of_interpolant(in_s, in_t, 1, 0), l_s * l_t);
  // Products of 4, differences among them, and sums of 5 and 9.
  EXPECT_GE(FarError{}.of_interpolant(in_s, in_t, 0, 1), l_s * l_t * (4 * 5 + 4 * 9 + 5 + 9) * u);
}

// Each of 2^40 terms may be lost to half a unit of the sum.
TEST(FarError, CountsTheRoundingsOfItsSums) {
  const FarError error{.in_s = 1, .in_t = 0, .slope = 0, .parts = std::size_t{1} << 40U};
  const LagrangeTable one = at_the_end(1);
  EXPECT_GE(error.of_interpolant(one, one, 0, 0), 2 * (1 + 0x1p-13));
}

TEST(FarError, AddsUp) {
  const FarBound one(7, 1, 0.5, 0.1);
  const FarBound other(9, 0.5, 0.75, 0.2);
  FarError error;
  error.add(one, other, 3, 5);
  error.add(other, one, 3, 5);
  EXPECT_EQ(error.in_s, one.of_polynomials(3) + other.of_polynomials(3));
  EXPECT_EQ(error.in_t, other.of_polynomials(5) + one.of_polynomials(5));
  EXPECT_GE(error.slope, 2 * one.of_slope() + 2 * other.of_slope());
  EXPECT_EQ(error.parts, 2U);
}

TEST(LagrangeTable, ReproducesPolynomialsAndKnowsItsModuli) {
  Draw draw(2);
  for (int n = 1; n <= most_gauss_nodes; ++n)
    for (int trial = 0; trial < 10; ++trial) {
      const double half = draw();
      const PartOfInterval part{.middle = (1 - half) * (2 * draw() - 1), .half = half};
      const int at = 1 + static_cast<int>(draw.below(most_gauss_nodes));
      const LagrangeTable table(n, part, at);
      const std::vector<double>& x = gauss_on_interval(n).nodes;
      double largest = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(at); ++i) {
        const double place = part.place(gauss_on_interval(at).nodes[i]);
        double sum = 0;
        double power = 0;
        double moduli = 0;
        for (std::size_t a = 0; a < x.size(); ++a) {
          sum += table(i, a);
          power += table(i, a) * std::pow(x[a], n - 1);
          moduli += std::abs(table(i, a));
        }
        EXPECT_NEAR(sum, 1, 1e-13);
        EXPECT_NEAR(power, std::pow(place, n - 1), 1e-13);
        largest = std::max(largest, moduli);
      }
      EXPECT_GE(table.largest(), largest);
      EXPECT_LE(table.largest(), lagrange_moduli_at_the_ends(n) * (1 + 1e-12));
    }
  // Two nodes, +- 1/sqrt(3): (1 + sqrt 3)/2 + (sqrt 3 - 1)/2.
  EXPECT_NEAR(lagrange_moduli_at_the_ends(2), std::numbers::sqrt3, 1e-11);
}

}  // namespace
}  // namespace radcert
