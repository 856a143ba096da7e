// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "radcert/continuous/transport/smoothness.h"
#include "radcert/continuous/transport/transport.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::drawn_functions;
using test::panels_of;

/// Nodes of Chebyshev and the Lebesgue constant of interpolation at them.
std::vector<double> chebyshev(std::size_t n) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < n; ++i)
    nodes.push_back(
        std::cos((2.0 * static_cast<double>(i) + 1) * std::acos(-1.0) / (2.0 * static_cast<double>(n))));
  return nodes;
}
double lebesgue(std::size_t n) { return 1 + 2 / std::acos(-1.0) * std::log(static_cast<double>(n)); }

double interpolated(const std::vector<double>& nodes, const std::vector<double>& values, double x) {
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    double product = values[i];
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (j != i) product *= (x - nodes[j]) / (nodes[i] - nodes[j]);
    sum += product;
  }
  return sum;
}

/// The parameters along a line of a cell: (s,t) at x in [-1,1].
using Place = std::function<std::pair<double, double>(double)>;

struct Bound {
  double of_polynomials = 0;  ///< at the chosen number of nodes
  double of_rule = 0;
  std::size_t nodes = 0;
};

class SmoothnessOf : public ::testing::TestWithParam<const char*> {
protected:
  SmoothnessOf()
      : scene_(panels_of(GetParam())),
        elements_(graded_elements(scene_, 3)),
        w_(drawn_functions(elements_.size(), 2, 2, draw_)),
        q_(elements_.size(), 2, 2),
        closure_(scene_, elements_, w_),
        smoothness_(scene_, elements_, w_, q_, closure_),
        transport_(scene_, elements_, w_) {}

  /// T w_k at places of a line, with their radius.
  std::vector<double> values(std::size_t sector, const Place& place, const std::vector<double>& at,
                             std::size_t k, double& radius) const {
    ObserverGroup group{.panel = scene_.sectors()[sector].panel, .points = {}};
    for (const double x : at) {
      const auto [s, t] = place(x);
      group.points.push_back(scene_.sectors()[sector].point(s, t));
    }
    const Transport::Values found = transport_(group, 1e-11);
    radius = std::max(radius, found.radius);
    std::vector<double> out;
    for (std::size_t p = 0; p < at.size(); ++p) out.push_back(found.values[p * w_.count() + k]);
    return out;
  }

  /// Interpolation at n Chebyshev nodes is off by at most (1 + Lebesgue constant) times what polynomials of
  /// degree n - 1 are.
  void expect_interpolation(std::size_t sector, const Place& place, const RuleErrors& errors, int& tried,
                            double& closest) {
    for (const std::size_t n : {2U, 4U, 7U}) {
      const double bound = errors.interpolation[n - 1];
      if (!(bound < 1)) continue;
      ++tried;
      const std::vector<double> nodes = chebyshev(n);
      for (const std::size_t k : {0U, 1U}) {
        double radius = 0;
        const std::vector<double> at_nodes = values(sector, place, nodes, k, radius);
        const std::vector<double> between{-0.97, -0.6, -0.1, 0.35, 0.8, 0.99};
        const std::vector<double> truth = values(sector, place, between, k, radius);
        for (std::size_t i = 0; i < between.size(); ++i) {
          const double off = std::abs(interpolated(nodes, at_nodes, between[i]) - truth[i]);
          const double most = (1 + lebesgue(n)) * (bound + 2 * radius);
          EXPECT_LE(off, most) << "n " << n << " sector " << sector;
          closest = std::max(closest, off / most);
        }
      }
    }
  }

  Draw draw_{11};
  SectorScene scene_;
  std::vector<SectorElement> elements_;
  SectorFunctions w_;
  SectorFunctions q_;
  EdgeClosure closure_;
  Smoothness smoothness_;
  Transport transport_;
};

/// A part of an element whose depth and place in the element are drawn on a logarithmic scale.
SectorBox drawn_box(const SectorBox& whole, Draw& draw) {
  SectorBox box = whole;
  const double depth = whole.t1 - whole.t0;
  const double far = std::ldexp(depth, -static_cast<int>(draw.below(whole.t0 == 0 ? 16 : 3)));
  box.t1 = whole.t0 + far;
  box.t0 = whole.t0 == 0 ? far / 2 : whole.t0;
  const double width = whole.s1 - whole.s0;
  const double part = std::ldexp(width, -1 - static_cast<int>(draw.below(8)));
  const bool left = draw() < 0.5;
  box.s0 = left ? whole.s0 + part / 2 : whole.s1 - part;
  box.s1 = left ? whole.s0 + part : whole.s1 - part / 2;
  return box;
}

TEST_P(SmoothnessOf, BoundsInterpolationAlongBothParameters) {
  int tried_s = 0;
  int tried_t = 0;
  double closest_s = 0;
  double closest_t = 0;
  for (int k = 0; k < 250; ++k) {
    const std::size_t e = draw_.below(elements_.size());
    const SectorBox box = drawn_box(elements_[e].box, draw_);
    const std::size_t sector = elements_[e].sector;
    const double t = box.t0 + (box.t1 - box.t0) * draw_();
    const double s = box.s0 + (box.s1 - box.s0) * draw_();
    expect_interpolation(
        sector, [&](double x) { return std::pair(box.middle_s() + 0.5 * (box.s1 - box.s0) * x, t); },
        smoothness_.along_s(e, box, false), tried_s, closest_s);
    expect_interpolation(
        sector, [&](double x) { return std::pair(s, box.middle_t() + 0.5 * (box.t1 - box.t0) * x); },
        smoothness_.along_t(e, box, false), tried_t, closest_t);
  }
  EXPECT_GT(tried_s, 200);
  EXPECT_GT(tried_t, 100);
  // A bound that no function comes near of would hold whatever was wrong with it.
  EXPECT_GT(closest_s, 1e-5);
  EXPECT_GT(closest_t, 1e-5);
}

TEST_P(SmoothnessOf, BoundsWhatTheOtherSideOfAnEdgeSends) {
  // T w - F, F of the closure, at points near an edge: the other side's T_j (w - xi) alone.
  int tried = 0;
  for (int k = 0; k < 300; ++k) {
    const std::size_t e = draw_.below(elements_.size());
    const SectorBox& whole = elements_[e].box;
    if (whole.t0 != 0 || !closure_.mirror(e)) continue;
    SectorBox box = drawn_box(whole, draw_);
    box.t0 = 0;
    const EdgeClosure::Nearby nearby = closure_.nearby(e, box);
    if (!(nearby.bound < 1)) continue;
    ++tried;
    const std::size_t mirror = *closure_.mirror(e);
    const std::size_t sector = elements_[e].sector;
    const double s = box.s0 + (box.s1 - box.s0) * draw_();
    const double t = box.t1 * (0.1 + 0.9 * draw_());
    // xi: the function on the other side at the edge, taken off the whole panel beyond.
    const SectorBox& across = elements_[mirror].box;
    const double x = (2 * (1 - s) - across.s0 - across.s1) / (across.s1 - across.s0);
    for (const std::size_t f : {0U, 1U}) {
      std::array<double, 3> p{};
      legendre_values<double>(x, p);
      double xi = 0;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) xi += w_.of(mirror, f)[i * 3 + j] * p[i] * (j % 2 == 0 ? 1 : -1);
      SectorFunctions rest(elements_.size(), 1, 2);
      const std::size_t beyond = scene_.sectors()[elements_[mirror].sector].panel;
      for (std::size_t other = 0; other < elements_.size(); ++other) {
        if (scene_.sectors()[elements_[other].sector].panel != beyond) continue;
        const std::span<const double> from = w_.of(other, f);
        std::copy(from.begin(), from.end(), rest.of(other, 0).begin());
        rest.of(other, 0)[0] -= xi;
      }
      const Transport sent(scene_, elements_, rest);
      const ObserverGroup group{.panel = scene_.sectors()[sector].panel,
                                .points = {scene_.sectors()[sector].point(s, t)}};
      const Transport::Values found = sent(group, 1e-9);
      EXPECT_LE(std::abs(found.values[0]) - found.radius, nearby.bound);
    }
  }
  EXPECT_GT(tried, 20);
}

INSTANTIATE_TEST_SUITE_P(Polyhedra, SmoothnessOf,
                         ::testing::Values("cube", "tetrahedron", "octahedron", "box"));

}  // namespace
}  // namespace radcert
