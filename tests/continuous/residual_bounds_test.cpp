// SPDX-License-Identifier: GPL-3.0-or-later
// What the bounds of residuals are put together from, each part by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "radcert/continuous/elements/local_values.h"
#include "radcert/continuous/observer_cells.h"
#include "radcert/continuous/residual.h"
#include "radcert/continuous/residual_samples.h"
#include "radcert/continuous/transport/cell_transport.h"
#include "tests/continuous/demands.h"
#include "tests/continuous/memory.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

constexpr double unit = unit_roundoff<double>();
/// Of samples, where nothing is demanded.
constexpr double loosest = 0.05;
constexpr CellDemand no_demand{.interpolation = 1e30, .quadrature = 1e30, .shade = 1e30};

/// A trial whose w are E + rho q for functions that the test chooses.
struct Chosen {
  using Functions = std::function<SectorFunctions(const SectorScene&, const std::vector<SectorElement>&)>;
  SectorScene scene;
  std::vector<SectorElement> elements;
  Trial trial;

  Chosen(const std::string& name, int layers, double rho, const Functions& emissions, const Functions& q)
      : scene(panels_of(name)),
        elements(graded_elements(scene, layers)),
        trial(scene, std::vector<double>(scene.panels().size(), rho), elements, emissions(scene, elements),
              q(scene, elements)) {}

  [[nodiscard]] double area(const ObserverCell& cell) const {
    return trial.sector(cell.element).jacobian * cell.box.weight();
  }
  [[nodiscard]] CellSamples samples(const ObserverCell& cell) const {
    return ResidualSamples(trial)(std::array{cell}, {loosest}).front();
  }
  /// At the nodes of a cell: the weight, the values of all w and of all q.
  template <class Visitor>
  void at_nodes(const ObserverCell& cell, const Visitor& visitor) const {
    const IntervalRule<double>& in_s = gauss_on_interval(cell.nodes_s);
    const IntervalRule<double>& in_t = gauss_on_interval(cell.nodes_t);
    LocalValues w_here(trial.elements[cell.element], trial.w, cell.element);
    LocalValues q_here(trial.elements[cell.element], trial.q, cell.element);
    std::vector<double> w(trial.w.count());
    std::vector<double> q(trial.q.count());
    std::size_t node = 0;
    for (std::size_t i = 0; i < in_s.nodes.size(); ++i)
      for (std::size_t j = 0; j < in_t.nodes.size(); ++j) {
        const double t = cell.box.middle_t() + 0.5 * (cell.box.t1 - cell.box.t0) * in_t.nodes[j];
        w_here.at(cell.box, in_s.nodes[i], in_t.nodes[j], w);
        q_here.at(cell.box, in_s.nodes[i], in_t.nodes[j], q);
        visitor(node++,
                0.25 * trial.sector(cell.element).jacobian * (cell.box.s1 - cell.box.s0) *
                    (cell.box.t1 - cell.box.t0) * (1 - t) * in_s.weights[i] * in_t.weights[j],
                w, q);
      }
  }
};

Chosen::Functions drawn(std::uint64_t seed, double size) {
  return [=](const SectorScene&, const std::vector<SectorElement>& elements) {
    Draw draw(seed);
    SectorFunctions f = test::drawn_functions(elements.size(), 2, 2, draw);
    for (double& c : f.all()) c *= size;
    return f;
  };
}
/// The same number on every element.
Chosen::Functions constant(double value, int degree = 0) {
  return [=](const SectorScene&, const std::vector<SectorElement>& elements) {
    SectorFunctions f(elements.size(), 1, degree);
    for (std::size_t e = 0; e < elements.size(); ++e) f.of(e, 0)[0] = value;
    return f;
  };
}

/// Two whole elements, not at an edge.
std::array<ObserverCell, 2> two_cells(const Chosen& chosen) {
  std::array<ObserverCell, 2> cells;
  std::size_t found = 0;
  for (std::size_t e = 0; e < chosen.elements.size() && found < 2; e += 5)
    if (chosen.elements[e].box.t0 > 0)
      cells[found++] = {.element = e, .box = chosen.elements[e].box, .nodes_s = 3, .nodes_t = 4};
  EXPECT_EQ(found, 2U);
  return cells;
}

// Parts of two plans, or of two functions, are never added up.
TEST(ResidualBounds, AreNotTakenFromOtherCellsOrFunctions) {
  const Chosen chosen("tetrahedron", 2, 0.5, drawn(31, 1), drawn(32, 0.1));
  const Chosen other("tetrahedron", 2, 0.5, drawn(31, 1), drawn(33, 0.1));
  const std::array<ObserverCell, 2> cells = two_cells(chosen);
  std::vector<std::pair<const Trial*, std::array<ObserverCell, 2>>> tries{{&chosen.trial, cells},
                                                                          {&other.trial, cells}};
  const auto changed = [&](const auto& change) {
    std::array<ObserverCell, 2> others = cells;
    change(others[1]);
    tries.emplace_back(&chosen.trial, others);
  };
  changed([](ObserverCell& cell) { cell.box.s1 = std::nextafter(cell.box.s1, 0); });
  changed([](ObserverCell& cell) { cell.nodes_s = 2; });
  changed([](ObserverCell& cell) { cell.quadrature = 1; });
  test::Memory memory;
  const SearchContext context{.kept = &memory};
  for (const auto& [trial, of] : tries) {
    MeshWork work(context, {.layers = 2});
    const ResidualSums kept = residual_sums(*trial, of, no_demand, false, &work);
    const ResidualSums fresh = residual_sums(*trial, of, no_demand);
    EXPECT_EQ(kept.norms, fresh.norms);
    for (const std::size_t k : {0U, 1U}) EXPECT_EQ(kept.products[k].radius, fresh.products[k].radius);
  }
  EXPECT_EQ(memory.found, 0);
  MeshWork work(context, {.layers = 2});
  static_cast<void>(residual_sums(chosen.trial, cells, no_demand, false, &work));
  EXPECT_EQ(memory.found, 1);
  static_cast<void>(largest_residuals(chosen.trial, cells, test::EvenDemand(1e30), &work));
  static_cast<void>(largest_residuals(other.trial, cells, test::EvenDemand(1e30), &work));
  EXPECT_EQ(memory.found, 1);
}

TEST(ResidualBounds, CountWhatSamplesAreOffBy) {
  const Chosen chosen("tetrahedron", 2, 0.5, drawn(31, 1), drawn(32, 0.1));
  const std::array<ObserverCell, 2> cells = two_cells(chosen);
  const ResidualSums sums = residual_sums(chosen.trial, cells, no_demand);
  for (const std::size_t k : {0U, 1U}) {
    double squares = 0;
    double without = 0;
    double of_products = 0;
    for (const ObserverCell& cell : cells) {
      const CellSamples found = chosen.samples(cell);
      chosen.at_nodes(cell, [&](std::size_t node, double weight, const auto& w, const auto& q) {
        const double t = std::abs(found.values[2 * node + k] - q[k]);
        squares += weight * 0.5 * (t + found.radius) * (t + found.radius);
        without += weight * 0.5 * t * t;
        of_products += weight * std::abs(w[k]) * found.radius;
      });
    }
    EXPECT_GT(squares, (1 + 1e-6) * without);
    EXPECT_GE(sums.norms[k], std::sqrt(squares) * (1 - 1e-14));
    EXPECT_LE(sums.norms[k], std::sqrt(squares) * (1 + 1e-9));
    EXPECT_GT(of_products, 1e-9);
    EXPECT_GE(sums.products[k].radius, of_products * (1 - 1e-14));
    EXPECT_LE(sums.products[k].radius, of_products * (1 + 1e-3));
  }
}

TEST(ResidualBounds, TakeProductsOfEachFunctionWithEachResidual) {
  const Chosen chosen("tetrahedron", 2, 0, drawn(41, 1), drawn(42, 3));
  const std::array<ObserverCell, 2> cells = two_cells(chosen);
  std::array<double, 4> with_t{};
  double size = 0;
  for (std::size_t e = 0; e < chosen.elements.size(); ++e)
    chosen.at_nodes({.element = e, .box = chosen.elements[e].box, .nodes_s = 3, .nodes_t = 3},
                    [&](std::size_t, double weight, const auto& w, const auto& q) {
                      for (std::size_t i = 0; i < 2; ++i)
                        for (std::size_t k = 0; k < 2; ++k) {
                          with_t[2 * i + k] -= weight * w[k] * q[i];
                          size += weight * std::abs(w[k] * q[i]);
                        }
                    });
  for (const ObserverCell& cell : cells) {
    const CellSamples found = chosen.samples(cell);
    chosen.at_nodes(cell, [&](std::size_t node, double weight, const auto& w, const auto&) {
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 2; ++k) with_t[2 * i + k] += weight * w[k] * found.values[2 * node + i];
    });
  }
  const ResidualSums sums = residual_sums(chosen.trial, cells, no_demand, false, nullptr, 2);
  ASSERT_EQ(sums.products.size(), 4U);
  for (std::size_t place = 0; place < 4; ++place)
    EXPECT_NEAR(sums.products[place].value, with_t[place], 1e-12 * size) << place;
  EXPECT_GT(std::abs(with_t[1] - with_t[2]), 1e-3 * size);
}

TEST(ResidualBounds, CountWhatRulesMiss) {
  // t = T 2 - 1 = 1 has the same size everywhere: what rules miss may add to it.
  const Chosen chosen("tetrahedron", 2, 0.5, constant(1.5), constant(1));
  std::array<ObserverCell, 2> cells = two_cells(chosen);
  const double area = chosen.area(cells[0]) + chosen.area(cells[1]);
  const double norm = residual_sums(chosen.trial, cells, no_demand).norms[0];
  for (const double missed : {1.0, 1e6}) {
    double of_product = 0;
    for (ObserverCell& cell : cells) {
      cell.interpolation = missed;
      cell.quadrature = &cell == cells.data() ? missed : 2 * missed;
      of_product += cell.quadrature * chosen.area(cell);
    }
    const ResidualSums sums = residual_sums(chosen.trial, cells, no_demand);
    const double least = norm + 2 * missed * std::sqrt(0.5 * area);
    EXPECT_GE(sums.norms[0], least * (1 - 1e-14));
    EXPECT_LE(sums.norms[0], least * (1 + 1e-9));
    EXPECT_GE(sums.products[0].radius, of_product * (1 - 1e-14));
    EXPECT_LE(sums.products[0].radius, of_product + 1);
  }
}

TEST(ResidualBounds, CountStrips) {
  const Chosen chosen("tetrahedron", 2, 0.5, drawn(33, 1), drawn(34, 3));
  std::array<ObserverCell, 2> strips = two_cells(chosen);
  double squares = 0;
  double product = 0;
  for (ObserverCell& strip : strips) {
    strip.nodes_s = strip.nodes_t = 0;
    const double area = chosen.area(strip);
    const double residual = chosen.trial.smoothness.residual_size(strip.element);
    squares += 0.5 * area * residual * residual;
    product += area * residual * chosen.trial.smoothness.density_size(strip.element);
  }
  const ResidualSums sums = residual_sums(chosen.trial, strips, no_demand);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_GE(sums.norms[k], std::sqrt(squares) * (1 - 1e-14));
    EXPECT_LE(sums.norms[k], std::sqrt(squares) * (1 + 1e-9));
    EXPECT_GE(sums.products[k].radius, product * (1 - 1e-14));
    EXPECT_LE(sums.products[k].radius, product * (1 + 1e-9));
  }
}

TEST(ResidualBounds, CountTheRoundingsOfTheSumOfElements) {
  // w q is 1 on the first element, and on every other one so small that its integral is lost beside that
  // of the first.
  double first = 0;
  const auto staircase = [&](const SectorScene& scene, const std::vector<SectorElement>& elements) {
    SectorFunctions w(elements.size(), 1, 0);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const double area = scene.sectors()[elements[e].sector].jacobian * elements[e].box.weight();
      if (e == 0) first = area;
      w.of(e, 0)[0] = e == 0 ? 1 : std::ldexp(0.99, std::ilogb(first) - 53) / area;
    }
    return w;
  };
  const Chosen chosen("cube", 2, 0, staircase, constant(1));
  Rational exact;
  for (std::size_t e = 0; e < chosen.elements.size(); ++e) {
    const double area = chosen.trial.sector(e).jacobian * chosen.elements[e].box.weight();
    exact += Rational::exactly(chosen.trial.w.of(e, 0)[0]) * Rational::exactly(area);
  }
  const Approximation product = residual_sums(chosen.trial, {}, no_demand).products[0];
  const Rational off = abs(exact + Rational::exactly(product.value));
  EXPECT_LE(off, Rational::exactly(product.radius));
  EXPECT_GE(off, Rational::exactly(50 * unit * first));
}

TEST(ResidualBounds, CountWhatPolynomialsAreRoundedBy) {
  // w = P_12 along the side of each element, and q = 1: P_12 is off by up to 8 13^2 units where it is
  // computed, and so is w q.
  constexpr int degree = 12;
  const auto legendre = [](const SectorScene&, const std::vector<SectorElement>& elements) {
    SectorFunctions w(elements.size(), 1, degree);
    for (std::size_t e = 0; e < elements.size(); ++e) w.of(e, 0)[degree * (degree + 1)] = 1;
    return w;
  };
  const Chosen chosen("tetrahedron", 1, 0, legendre, constant(1, degree));
  std::vector<ObserverCell> cells;
  double of_samples = 0;
  for (std::size_t e = 0; e < chosen.elements.size(); ++e) {
    cells.push_back({.element = e, .box = chosen.elements[e].box, .nodes_s = 1, .nodes_t = 1});
    const CellSamples found = chosen.samples(cells.back());
    chosen.at_nodes(cells.back(), [&](std::size_t, double weight, const auto& w, const auto&) {
      of_samples += weight * std::abs(w[0]) * found.radius;
    });
  }
  const Approximation product = residual_sums(chosen.trial, cells, no_demand).products[0];
  EXPECT_GE(product.radius, of_samples + 8 * 13 * 13 * unit * chosen.scene.area());
}

TEST(ResidualSamples, CountTheRoundingsOfQ) {
  // Black faces, so that w = 1 beside q = 2^40, from which it is subtracted.
  const Chosen chosen("tetrahedron", 2, 0, constant(1), constant(0x1p40));
  const ObserverCell cell = two_cells(chosen)[0];
  EXPECT_GE(ResidualSamples(chosen.trial)(std::array{cell}, {1e-9}).front().radius, 0x1p40 * unit);
}

TEST(ResidualSamples, CountTheOtherSideOfAnEdge) {
  // F = what the other panels send + xi (1 - what they send of 1), xi = 16 on one panel: both sums are off.
  std::size_t beyond = 0;
  const auto bright = [&](const SectorScene& scene, const std::vector<SectorElement>& elements) {
    SectorFunctions w(elements.size(), 1, 0);
    for (std::size_t e = 0; e < elements.size(); ++e)
      w.of(e, 0)[0] = scene.sectors()[elements[e].sector].panel == beyond ? 16 : 1;
    return w;
  };
  const Chosen chosen("tetrahedron", 2, 0, bright, constant(0));
  int tried = 0;
  for (std::size_t e = 0; e < chosen.elements.size() && tried < 2; ++e) {
    SectorBox box = chosen.elements[e].box;
    const std::optional<std::size_t> mirror = chosen.trial.closure.mirror(e);
    if (box.t0 != 0 || !mirror || chosen.trial.sector(*mirror).panel != beyond) continue;
    ++tried;
    box.t1 /= 1024;
    SectorFunctions with_one(chosen.elements.size(), 2, 0);
    for (std::size_t other = 0; other < chosen.elements.size(); ++other) {
      with_one.of(other, 0)[0] = chosen.trial.w.of(other, 0)[0];
      with_one.of(other, 1)[0] = 1;
    }
    const Transport transport(chosen.scene, chosen.elements, with_one);
    const CellNodes nodes{.box = box, .nodes_s = 4, .nodes_t = 3, .tolerance = 0.5 * loosest};
    const double off = transport_to_cells(transport, e, std::array{nodes}, beyond).front().radius;
    ASSERT_GT(off, 1e-9);
    const double radius =
        chosen.samples({.element = e, .box = box, .nodes_s = 4, .nodes_t = 3, .closed = true}).radius;
    EXPECT_GE(radius, 17 * off);
    EXPECT_LE(radius, 17.01 * off);
  }
  EXPECT_EQ(tried, 2);
}

/// l_a(x) at the Gauss nodes of a rule.
std::vector<double> lagrange(const IntervalRule<double>& rule, double x) {
  std::vector<double> l(rule.nodes.size(), 1);
  for (std::size_t a = 0; a < l.size(); ++a)
    for (std::size_t b = 0; b < l.size(); ++b)
      if (b != a) l[a] *= (x - rule.nodes[b]) / (rule.nodes[a] - rule.nodes[b]);
  return l;
}

TEST(LargestResiduals, CountWhatSamplesAreOffBy) {
  // A value off by r at each node moves the interpolant at a corner by r times both sums of |l_a|.
  const Chosen chosen("tetrahedron", 2, 0.5, drawn(35, 1), drawn(36, 0.1));
  for (const ObserverCell& cell : two_cells(chosen)) {
    const CellSamples found = chosen.samples(cell);
    const IntervalRule<double>& in_s = gauss_on_interval(cell.nodes_s);
    const IntervalRule<double>& in_t = gauss_on_interval(cell.nodes_t);
    std::vector<double> residual;
    chosen.at_nodes(cell, [&](std::size_t node, double, const auto&, const auto& q) {
      residual.push_back(found.values[2 * node] - q[0]);
    });
    double least = 0;
    double amplified = 0;
    for (int i = -16; i <= 16; ++i)
      for (int j = -16; j <= 16; ++j) {
        const std::vector<double> l_s = lagrange(in_s, i / 16.0);
        const std::vector<double> l_t = lagrange(in_t, j / 16.0);
        double value = 0;
        double sizes = 0;
        for (std::size_t a = 0; a < l_s.size(); ++a)
          for (std::size_t b = 0; b < l_t.size(); ++b) {
            value += l_s[a] * l_t[b] * residual[a * l_t.size() + b];
            sizes += std::abs(l_s[a] * l_t[b]);
          }
        least = std::max(least, std::abs(value));
        amplified = std::max(amplified, sizes);
      }
    const double largest = largest_residuals(chosen.trial, std::array{cell}, test::EvenDemand(1e30))[0];
    ASSERT_GT(amplified * found.radius, 1e-3 * least);
    EXPECT_GE(largest, (least + amplified * found.radius) * (1 - 1e-12));
    EXPECT_LE(largest, 1.2 * (least + amplified * found.radius));
    // And what is left beside samples, each with its factor.
    ObserverCell wide = cell;
    wide.of_interpolant = 1e6;
    wide.beside = 1e5;
    EXPECT_GE(largest_residuals(chosen.trial, std::array{wide}, test::EvenDemand(1e30))[0], 1e6 + 1e5);
  }
}

TEST(InterpolationError, IsThatOfBothVariables) {
  // Chebyshev's polynomial of degree n, which polynomials of degree n - 1 miss by 1.
  const auto chebyshev = [](int n, double x) { return std::cos(n * std::acos(std::clamp(x, -1.0, 1.0))); };
  for (const int nodes_s : {1, 2, 3, 5, 8})
    for (const int nodes_t : {1, 2, 4, 7})
      for (const double of_t : {0.0, 0.01, 1.0, 100.0}) {
        const auto f = [&](double x, double y) {
          return chebyshev(nodes_s, x) + of_t * chebyshev(nodes_t, y);
        };
        const std::vector<double>& at_s = gauss_on_interval(nodes_s).nodes;
        const std::vector<double>& at_t = gauss_on_interval(nodes_t).nodes;
        const auto lagrange = [](const std::vector<double>& nodes, std::size_t k, double x) {
          double product = 1;
          for (std::size_t j = 0; j < nodes.size(); ++j)
            if (j != k) product *= (x - nodes[j]) / (nodes[k] - nodes[j]);
          return product;
        };
        double missed = 0;
        for (int i = 0; i <= 40; ++i)
          for (int j = 0; j <= 40; ++j) {
            const double x = -1 + i / 20.0;
            const double y = -1 + j / 20.0;
            double sum = 0;
            for (std::size_t a = 0; a < at_s.size(); ++a)
              for (std::size_t b = 0; b < at_t.size(); ++b)
                sum += f(at_s[a], at_t[b]) * lagrange(at_s, a, x) * lagrange(at_t, b, y);
            missed = std::max(missed, std::abs(f(x, y) - sum));
          }
        const double bound = interpolation_error(1, nodes_s, of_t, nodes_t);
        EXPECT_LE(missed, bound * (1 + 1e-12)) << nodes_s << " " << nodes_t << " " << of_t;
        EXPECT_GE(missed, bound / (4 * nodes_s * nodes_t)) << nodes_s << " " << nodes_t << " " << of_t;
      }
  // One variable alone, and both.
  const double of_8 = lebesgue_constant(8);
  const double of_2 = lebesgue_constant(2);
  for (const double bound : {interpolation_error(1, 8, 0, 2), interpolation_error(0, 2, 1, 8)})
    EXPECT_NEAR(bound, 1 + of_8, 1e-9);
  EXPECT_NEAR(interpolation_error(1, 8, 1e-3, 2), 1 + of_8 + of_8 * (1 + of_2) * 1e-3, 0.2 * of_8);
  EXPECT_GE(interpolation_error(3, 8, 5, 2),
            std::min(3 * (1 + of_8) + 5 * of_8 * (1 + of_2), 5 * (1 + of_2) + 3 * of_2 * (1 + of_8)));
}

TEST(ObserverCells, HaveWhatRulesMissInBothVariablesAndWhatAClosureLeaves) {
  const auto nearly_one = [](const SectorScene&, const std::vector<SectorElement>& elements) {
    Draw draw(37);
    SectorFunctions f = test::drawn_functions(elements.size(), 1, 2, draw);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      for (double& c : f.of(e, 0)) c *= 1e-3;
      f.of(e, 0)[0] = 1;
    }
    return f;
  };
  const Chosen chosen("cube", 3, 0, nearly_one, constant(1, 2));
  const Smoothness& smoothness = chosen.trial.smoothness;
  const EdgeClosure& closure = chosen.trial.closure;
  const std::array<std::vector<ObserverCell>, 2> found{
      observer_cells(chosen.trial, CellDemand{.interpolation = 3e-3, .quadrature = 1e-3, .shade = 1}),
      observer_cells(chosen.trial, test::EvenDemand(0.1, 1e-5))};
  for (const std::vector<ObserverCell>& cells : found) {
    double in_both = 1;
    double beside_rules = 0;
    for (const ObserverCell& cell : cells) {
      if (cell.is_strip()) continue;
      const auto s = static_cast<std::size_t>(cell.nodes_s - 1);
      const auto t = static_cast<std::size_t>(cell.nodes_t - 1);
      const RuleErrors in_s = smoothness.along_s(cell.element, cell.box, cell.closed);
      const RuleErrors in_t = smoothness.along_t(cell.element, cell.box, cell.closed);
      double beside = 0;
      if (cell.closed)
        beside = std::min(closure.nearby(cell.element, cell.box).bound,
                          closure.nearby_across_borders(cell.element, cell.box).bound);
      EXPECT_GE(cell.beside, beside);
      EXPECT_EQ(cell.beside > 0, cell.closed);
      const double of_rules = in_s.interpolation[s] + in_t.interpolation[t];
      EXPECT_GE(cell.of_interpolant, interpolation_error(in_s.interpolation[s], cell.nodes_s,
                                                         in_t.interpolation[t], cell.nodes_t) *
                                         (1 - 4 * unit));
      EXPECT_GE(cell.interpolation, (of_rules + 0.5 * cell.beside) * (1 - 4 * unit));
      const double of_mean =
          in_s.quadrature[s] + in_t.quadrature[t] + cell.beside * smoothness.density_size(cell.element);
      EXPECT_GE(cell.quadrature, of_mean * (1 - 4 * unit));
      EXPECT_LE(cell.quadrature, of_mean * (1 + 4 * unit));
      in_both = std::min(in_both, in_s.interpolation[s] / of_rules);
      if (cell.closed) beside_rules = std::max(beside_rules, cell.beside / of_rules);
    }
    // Each part is seen.
    EXPECT_LT(in_both, 0.5);
    EXPECT_GT(beside_rules, 0.1);
  }
}

}  // namespace
}  // namespace radcert
