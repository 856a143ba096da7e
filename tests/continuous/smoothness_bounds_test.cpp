// SPDX-License-Identifier: GPL-3.0-or-later
// What Smoothness says of cells, put together here once more: lines, distances and masses by sampling,
// functions at the real ends of the ellipses, the least over all ellipses. Nothing of it is larger than the
// truth.
#include "radcert/continuous/transport/smoothness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "radcert/continuous/elements/analytic_error.h"
#include "tests/continuous/rooms.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t floor_panel = 0;
constexpr std::size_t east_wall = 1;
constexpr std::size_t tile = 5;
constexpr std::size_t west_of_tile = 6;
/// Elements of two_layers on the floor.
constexpr std::size_t on_floor = 8;

/// A low hall, 4 by 1 by 1/4, whose ceiling has a small tile in the middle.
std::vector<Panel> hall() {
  std::vector<Panel> panels;
  const auto add = [&](test::Corners corners) {
    const Vector<Rational> within{Rational(2), Rational(1, 2), Rational(1, 8)};
    if (dot(cross(corners[1] - corners[0], corners[2] - corners[0]), within - corners[0]).sign() < 0)
      std::reverse(corners.begin(), corners.end());
    panels.push_back(test::panel_with(0, std::move(corners)));
  };
  const Rational top(1, 4);
  const auto flat = [&](const Rational& x0, const Rational& x1, const Rational& y0, const Rational& y1,
                        const Rational& z) {
    add({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
  };
  const auto wall = [&](long x0, long y0, long x1, long y1) {
    add({{x0, y0, 0}, {x1, y1, 0}, {x1, y1, top}, {x0, y0, top}});
  };
  flat(0, 4, 0, 1, 0);
  wall(4, 0, 4, 1);
  wall(0, 0, 4, 0);
  wall(0, 1, 4, 1);
  wall(0, 0, 0, 1);
  const Rational x0(63, 32);
  const Rational x1(65, 32);
  const Rational y0(15, 32);
  const Rational y1(17, 32);
  flat(x0, x1, y0, y1, top);
  flat(0, x0, 0, 1, top);
  flat(x1, 4, 0, 1, top);
  flat(x0, x1, 0, y0, top);
  flat(x0, x1, y1, 1, top);
  return panels;
}

/// Lines of a cell in one parameter: their middles and halves.
struct Line {
  Vector<double> c;
  Vector<double> e;
};

std::vector<Line> lines_of(const Sector& sector, const SectorBox& box, bool along_t) {
  std::vector<Line> out;
  for (int k = 0; k <= 8; ++k) {
    const double s = along_t ? box.s0 + (box.s1 - box.s0) * k / 8 : 0;
    const double t = box.t0 + (box.t1 - box.t0) * k / 8;
    const Vector<double> from = along_t ? sector.point(s, box.t0) : sector.point(box.s0, t);
    const Vector<double> to = along_t ? sector.point(s, box.t1) : sector.point(box.s1, t);
    out.push_back({0.5 * (from + to), 0.5 * (to - from)});
  }
  return out;
}

/// What is sampled of a panel from such lines.
ObserverLines sampled(const SectorScene& scene, std::size_t from, std::size_t panel,
                      const std::vector<Line>& lines) {
  ObserverLines out{.distance = infinity, .height = infinity, .mass = 0, .area = 0};
  const Vector<double>& n_p = scene.normal(from);
  const Vector<double>& n = scene.normal(panel);
  std::vector<double> masses(lines.size());
  for (std::size_t s = scene.first_sector(panel); s < scene.first_sector(panel + 1); ++s) {
    const Sector& sector = scene.sectors()[s];
    out.area += norm(cross(sector.b - sector.a, sector.c - sector.a)) / 2;
    constexpr int count = 24;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) {
        const double t = (j + 0.5) / count;
        const Vector<double> q = sector.point((i + 0.5) / count, t);
        const double weight = sector.jacobian * (1 - t) / (count * count);
        for (std::size_t k = 0; k < lines.size(); ++k) {
          const Vector<double> way = q - lines[k].c;
          const double squared = dot(way, way);
          out.distance = std::min(out.distance, std::sqrt(squared));
          masses[k] -= weight * std::numbers::inv_pi * dot(n_p, way) * dot(n, way) / (squared * squared);
        }
      }
  }
  for (const Line& line : lines) {
    const double height = dot(n, line.c - scene.sectors()[scene.first_sector(panel)].a);
    out.half = std::max(out.half, norm(line.e));
    out.height = std::min(out.height, height);
    out.highest = std::max(out.highest, height);
    out.turned = std::max(out.turned, std::abs(dot(n, line.e)));
  }
  out.mass = 0.98 * *std::max_element(masses.begin(), masses.end());
  out.rings = scene.before(from, panel) && !(out.distance > out.highest);
  return out;
}

/// sup |T_j w| / sup |w| in an ellipse about the lines of a cell, from what is sampled.
class Bound {
public:
  Bound(const SectorScene& scene, const std::vector<SectorElement>& elements, std::size_t panel,
        const std::vector<Line>& lines, bool along_t)
      : seen_(sampled(scene, floor_panel, panel, lines)),
        slides_(!along_t && std::abs(dot(scene.normal(panel), lines[0].e)) < 1e-9 * norm(lines[0].e)) {
    for (const SectorElement& element : elements)
      if (scene.sectors()[element.sector].panel == panel)
        approach(scene.sectors()[element.sector], element.box, lines);
  }

  double operator()(double axis) const {
    const double tube = tube_bound(seen_, axis);
    return slides_ ? std::min(tube, slide_bound(slide_part(seen_.half, reach_, axis))) : tube;
  }

private:
  /// The distance of the middles from the sides that the lines are not parallel to.
  void approach(const Sector& sector, const SectorBox& b, const std::vector<Line>& lines) {
    const std::array<Vector<double>, 4> corners{sector.point(b.s0, b.t0), sector.point(b.s1, b.t0),
                                                sector.point(b.s1, b.t1), sector.point(b.s0, b.t1)};
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector<double>& from = corners[i];
      const Vector<double>& to = corners[(i + 1) % 4];
      if (norm(cross(to - from, lines[0].e)) < 1e-9 * norm(to - from) * norm(lines[0].e)) continue;
      for (const Line& line : lines) reach_ = std::min(reach_, distance(line.c, from, to));
    }
  }

  ObserverLines seen_;
  bool slides_;
  double reach_ = infinity;
};

/// Numbers of nodes.
constexpr std::array<int, 4> tried_nodes{1, 2, 4, 8};

/// Bounds of errors, by tried_nodes.
struct LeastErrors {
  std::array<double, tried_nodes.size()> interpolation{};
  std::array<double, tried_nodes.size()> quadrature{};

  /// Adds the least over all ellipses of bound(A), and of a mean that of bound(A) growth(A). Both grow with
  /// A, and the factors fall.
  template <class OfEllipse, class Growth>
  void add(const OfEllipse& bound, const Growth& growth) {
    std::array<double, tried_nodes.size()> polynomials;
    std::array<double, tried_nodes.size()> rules;
    polynomials.fill(infinity);
    rules.fill(infinity);
    double below = 1;
    for (double beyond = 0.01; beyond < 1e6; beyond *= 1.04) {
      const double most = bound(below);
      if (!(most < infinity)) break;
      const double with_density = most * growth(below);
      below = 1 + beyond;
      const double rho = below + std::sqrt(below * below - 1);
      for (std::size_t i = 0; i < tried_nodes.size(); ++i) {
        polynomials[i] = std::min(polynomials[i], most * polynomial_error_factor(tried_nodes[i], rho));
        rules[i] = std::min(rules[i], with_density * gauss_mean_error_factor(tried_nodes[i], rho));
      }
    }
    for (std::size_t i = 0; i < tried_nodes.size(); ++i) {
      interpolation[i] += polynomials[i];
      quadrature[i] += rules[i];
    }
  }
};

/// What is found against the least, and the largest quotients of both.
struct Comparison {
  int tried = 0;
  double interpolation = 0;
  double quadrature = 0;

  void meet(const LeastErrors& least, const RuleErrors& found, int number) {
    for (std::size_t i = 0; i < tried_nodes.size(); ++i) {
      const auto n = static_cast<std::size_t>(tried_nodes[i]) - 1;
      if (!(found.interpolation[n] < infinity)) continue;
      ++tried;
      EXPECT_GE(found.interpolation[n], least.interpolation[i]) << n + 1 << " nodes, cell " << number;
      EXPECT_GE(found.quadrature[n], least.quadrature[i]) << n + 1 << " nodes, cell " << number;
      interpolation = std::max(interpolation, least.interpolation[i] / found.interpolation[n]);
      if (found.quadrature[n] > 0)
        quadrature = std::max(quadrature, least.quadrature[i] / found.quadrature[n]);
    }
  }
};

double legendre(int degree, double x) { return degree == 0 ? 1 : degree == 1 ? x : 1.5 * x * x - 0.5; }

/// Elements of two layers, one beside the edge and one at the centre.
std::vector<SectorElement> two_layers(const SectorScene& scene) {
  std::vector<SectorElement> elements;
  for (std::size_t sector = 0; sector < scene.sectors().size(); ++sector) {
    elements.push_back({sector, {.t1 = 0.5}});
    elements.push_back({sector, {.t0 = 0.5}});
  }
  return elements;
}

/// A part of an element that keeps off its border.
SectorBox drawn_part(const SectorBox& whole, Draw& draw) {
  const auto part = [&](double from, double to, double& begin, double& end) {
    const double width = (to - from) * std::ldexp(0.875, -static_cast<int>(draw.below(4)));
    begin = from + (to - from) / 16 + (0.875 * (to - from) - width) * (draw.below(2) == 0 ? 0.5 : draw());
    end = begin + width;
  };
  SectorBox box;
  part(whole.s0, whole.s1, box.s0, box.s1);
  part(whole.t0, whole.t1, box.t0, box.t1);
  return box;
}

/// |w| times the area element at the real ends of an ellipse, over that in the middle; w of a degree in the
/// variable of the lines.
class Growth {
public:
  Growth(const SectorBox& box, const SectorBox& whole, int degree, bool along_t)
      : part_(along_t ? part_in_t(box, whole) : part_in_s(box, whole)),
        degree_(degree),
        element_(along_t ? 0.5 * (box.t1 - box.t0) / (1 - box.middle_t()) : 0) {}

  double operator()(double axis) const {
    return std::max(std::abs(legendre(degree_, part_.place(axis)) * (1 - element_ * axis)),
                    std::abs(legendre(degree_, part_.place(-axis)) * (1 + element_ * axis)));
  }

private:
  PartOfInterval part_;
  int degree_;
  double element_;
};

/// w of the degree 2: where a polynomial of one variable stands.
std::size_t place_of(int degree, bool along_t) {
  return static_cast<std::size_t>(along_t ? degree : 3 * degree);
}

RuleErrors errors_of(const Smoothness& smoothness, std::size_t e, const SectorBox& box, bool along_t,
                     bool closed) {
  return along_t ? smoothness.along_t(e, box, closed) : smoothness.along_s(e, box, closed);
}

TEST(SmoothnessBounds, CountWhatAPanelSendsAsTheirMathsSays) {
  const SectorScene scene(hall());
  const std::vector<SectorElement> elements = two_layers(scene);
  Draw draw(31);
  for (const bool along_t : {false, true})
    for (const std::size_t panel : {tile, west_of_tile, east_wall})
      for (const int degree : {0, 1, 2}) {
        SectorFunctions w(elements.size(), 1, 2);
        for (std::size_t e = 0; e < elements.size(); ++e) {
          const std::size_t of = scene.sectors()[elements[e].sector].panel;
          if (of == floor_panel) w.of(e, 0)[place_of(degree, along_t)] = 1;
          if (of == panel) w.of(e, 0)[0] = 1;
        }
        const SectorFunctions q(elements.size(), 1, 2);
        const EdgeClosure closure(scene, elements, w);
        const Smoothness smoothness(scene, elements, w, q, closure);
        Comparison comparison;
        for (int k = 0; k < 60; ++k) {
          const std::size_t e = draw.below(on_floor);
          const std::size_t sector = elements[e].sector;
          // Along t the panel beyond the edge turns.
          if (along_t && scene.sectors()[*scene.opposite(sector)].panel == panel) continue;
          const SectorBox& whole = elements[e].box;
          const SectorBox box = drawn_part(whole, draw);
          const std::vector<Line> lines = lines_of(scene.sectors()[sector], box, along_t);
          LeastErrors least;
          least.add(Bound(scene, elements, panel, lines, along_t), Growth(box, whole, degree, along_t));
          comparison.meet(least, errors_of(smoothness, e, box, along_t, false), k);
        }
        EXPECT_GT(comparison.tried, 60);
        // A wall at the end is so oblique along t that its mass counts little of it.
        const double quotient = along_t && panel == east_wall ? 0.05 : 0.4;
        EXPECT_GT(comparison.interpolation, quotient);
        EXPECT_GT(comparison.quadrature, 0.3 * quotient);
      }
}

TEST(SmoothnessBounds, CountTheValueAtAnEdgeAsTheirMathsSays) {
  // w on the floor and beyond one of its edges alone, so that F = xi (1 - sum of T_i 1), i not beyond.
  const SectorScene scene(hall());
  const std::vector<SectorElement> elements = two_layers(scene);
  Draw draw(32);
  for (const bool along_t : {false, true})
    for (const int degree : {0, 1, 2}) {
      Comparison comparison;
      for (std::size_t e = 0; e < on_floor; e += 2) {
        const std::size_t sector = elements[e].sector;
        const std::size_t mirror = 2 * *scene.opposite(sector);
        SectorFunctions w(elements.size(), 1, 2);
        w.of(e, 0)[place_of(degree, along_t)] = 1;
        w.of(mirror, 0)[along_t ? 0 : place_of(degree, false)] = 1;
        const SectorFunctions q(elements.size(), 1, 2);
        const EdgeClosure closure(scene, elements, w);
        ASSERT_EQ(closure.mirror(e), mirror);
        const Smoothness smoothness(scene, elements, w, q, closure);
        for (int k = 0; k < 12; ++k) {
          const SectorBox& whole = elements[e].box;
          const SectorBox box = drawn_part(whole, draw);
          const std::vector<Line> lines = lines_of(scene.sectors()[sector], box, along_t);
          const Growth density(box, whole, degree, along_t);
          const Growth xi(box, whole, along_t ? 0 : degree, false);
          LeastErrors least;
          for (std::size_t panel = 1; panel < scene.panels().size(); ++panel) {
            if (panel == scene.sectors()[elements[mirror].sector].panel) continue;
            const Bound sent(scene, elements, panel, lines, along_t);
            least.add([&](double axis) { return sent(axis) * xi(axis); }, density);
          }
          LeastErrors of_xi;
          of_xi.add(xi, density);
          for (std::size_t i = 0; i < tried_nodes.size(); ++i) least.quadrature[i] += of_xi.quadrature[i];
          comparison.meet(least, errors_of(smoothness, e, box, along_t, true), k);
        }
      }
      EXPECT_GT(comparison.tried, 60);
      EXPECT_GT(comparison.interpolation, 0.25);
      EXPECT_GT(comparison.quadrature, 0.08);
    }
}

TEST(SmoothnessBounds, CountHowFarQIsFromPolynomials) {
  // Nothing is sent, so that q is all of it: P_d on an element, whose leading coefficient says how far it is
  // from polynomials of degree d - 1 on a part.
  const SectorScene scene(hall());
  const std::vector<SectorElement> elements = two_layers(scene);
  const SectorFunctions w(elements.size(), 1, 2);
  const EdgeClosure closure(scene, elements, w);
  Draw draw(33);
  for (const bool along_t : {false, true})
    for (const int degree : {1, 2}) {
      SectorFunctions q(elements.size(), 1, 2);
      for (std::size_t e = 0; e < on_floor; ++e) q.of(e, 0)[place_of(degree, along_t)] = 1;
      const Smoothness smoothness(scene, elements, w, q, closure);
      int tried = 0;
      for (int k = 0; k < 60; ++k) {
        const std::size_t e = draw.below(on_floor);
        const SectorBox box = drawn_part(elements[e].box, draw);
        const double half =
            along_t ? part_in_t(box, elements[e].box).half : part_in_s(box, elements[e].box).half;
        const RuleErrors found = errors_of(smoothness, e, box, along_t, false);
        const double away = degree == 1 ? half : 0.75 * half * half;
        const double bound = found.interpolation[static_cast<std::size_t>(degree - 1)];
        if (!(bound < infinity)) continue;
        ++tried;
        EXPECT_GE(bound, away);
        EXPECT_LE(bound, 8 * away);
        EXPECT_EQ(found.interpolation[2], 0);
      }
      EXPECT_GT(tried, 10);
    }
}

}  // namespace
}  // namespace radcert
