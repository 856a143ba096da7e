// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/transport/smoothness.h"
#include "radcert/continuous/transport/transport.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::drawn_functions;
using test::panels_of;

/// cos(pi k/n), k = 0, ..., n.
std::vector<double> extrema(std::size_t n) {
  std::vector<double> places;
  for (std::size_t k = 0; k <= n; ++k)
    places.push_back(std::cos(static_cast<double>(k) * std::acos(-1.0) / static_cast<double>(n)));
  return places;
}

/// Polynomials of degree n - 1 are off by this much at least at one of n + 1 places (de la Vallee-Poussin).
double least_deviation(const std::vector<double>& places, const std::function<double(std::size_t)>& value) {
  double sum = 0;
  double size = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double product = 1;
    for (std::size_t j = 0; j < places.size(); ++j)
      if (j != i) product *= places[i] - places[j];
    sum += value(i) / product;
    size += 1 / std::abs(product);
  }
  return std::abs(sum) / size;
}

/// The parameters along a line of a cell: (s,t) at x in [-1,1].
using Place = std::function<std::pair<double, double>(double)>;

/// The functions of f and, last, 1.
SectorFunctions with_one(const SectorFunctions& f, std::size_t elements) {
  SectorFunctions out(elements, f.count() + 1, f.degree());
  for (std::size_t e = 0; e < elements; ++e) {
    for (std::size_t k = 0; k < f.count(); ++k)
      std::copy(f.of(e, k).begin(), f.of(e, k).end(), out.of(e, k).begin());
    out.of(e, f.count())[0] = 1;
  }
  return out;
}

/// How near values come to bounds.
struct Closest {
  int tried = 0;
  double quotient = 0;
  void meet(double value, double radius, double bound, const std::string& what) {
    if (!(bound < 1)) return;
    ++tried;
    EXPECT_LE(value, bound + radius) << what;
    if (value > 10 * radius) quotient = std::max(quotient, (value - radius) / bound);
  }
};

/// Functions on the elements of a scene, and what is sent to points of it.
class Sent {
public:
  Sent(SectorScene scene, std::vector<SectorElement> elements, const SectorFunctions& functions)
      : scene_(std::move(scene)),
        elements_(std::move(elements)),
        w_(functions),
        q_(elements_.size(), w_.count(), w_.degree()),
        closure_(scene_, elements_, w_),
        smoothness_(scene_, elements_, w_, q_, closure_),
        with_one_(with_one(w_, elements_.size())),
        transport_(scene_, elements_, w_),
        transport_with_one_(scene_, elements_, with_one_) {}

  Sent(const Sent&) = delete;
  Sent& operator=(const Sent&) = delete;

  /// w_k on an element.
  [[nodiscard]] double density(std::size_t e, std::size_t k, double s, double t) const {
    return test::element_value(w_, e, k, elements_[e].box, s, t);
  }

  /// T w, or F of EdgeClosure, at places of an element, by place, function.
  [[nodiscard]] std::vector<double> operator()(std::size_t e, const Place& place, std::span<const double> at,
                                               bool closed, double& radius) const {
    const Sector& sector = scene_.sectors()[elements_[e].sector];
    ObserverGroup group{.panel = sector.panel, .points = {}};
    for (const double x : at) {
      const auto [s, t] = place(x);
      group.points.push_back(sector.point(s, t));
    }
    if (!closed) {
      const Transport::Values found = transport_(group, 1e-11);
      radius = found.radius;
      return found.values;
    }
    const std::size_t mirror = *closure_.mirror(e);
    const Transport::Values found =
        transport_with_one_(group, 1e-11, scene_.sectors()[elements_[mirror].sector].panel);
    radius = 4 * found.radius;
    std::vector<double> values;
    for (std::size_t p = 0; p < at.size(); ++p)
      for (std::size_t k = 0; k < w_.count(); ++k) {
        const double* const sent = &found.values[p * (w_.count() + 1)];
        values.push_back(sent[k] + density(mirror, k, 1 - place(at[p]).first, 0) * (1 - sent[w_.count()]));
      }
    return values;
  }

  /// What polynomials miss at least, and what rules miss, against their bounds.
  void expect(std::size_t e, const SectorBox& box, double across, bool along_t, bool closed,
              Closest& polynomials, Closest& rules) const {
    const RuleErrors errors =
        along_t ? smoothness_.along_t(e, box, closed) : smoothness_.along_s(e, box, closed);
    const double s = box.s0 + (box.s1 - box.s0) * across;
    const double t = box.t0 + (box.t1 - box.t0) * across;
    const auto place = [&](double x) {
      return along_t ? std::pair(s, box.middle_t() + 0.5 * (box.t1 - box.t0) * x)
                     : std::pair(box.middle_s() + 0.5 * (box.s1 - box.s0) * x, t);
    };
    const std::string what = std::string(closed ? "closed, " : "") + (along_t ? "t" : "s") + " of " +
                             std::to_string(box.s0) + " " + std::to_string(box.s1) + " " +
                             std::to_string(box.t0) + " " + std::to_string(box.t1) + ", nodes ";
    double radius = 0;
    for (const std::size_t n : {1U, 2U, 4U, 7U}) {
      const std::vector<double> places = extrema(n);
      // The ends may lie on an edge.
      std::vector<double> inner = places;
      for (double& x : inner) x *= 0.999;
      if (!(errors.interpolation[n - 1] < 1)) continue;
      const std::vector<double> values = (*this)(e, place, inner, closed, radius);
      for (std::size_t k = 0; k < w_.count(); ++k)
        polynomials.meet(least_deviation(inner, [&](std::size_t p) { return values[p * w_.count() + k]; }),
                         radius, errors.interpolation[n - 1], what + std::to_string(n));
    }
    // The mean of w_k T w_l with the area element relative to its own mean.
    const auto means = [&](int n, double& off) {
      const IntervalRule<double>& rule = gauss_on_interval(n);
      const std::vector<double> values = (*this)(e, place, rule.nodes, closed, radius);
      std::vector<double> sums(w_.count() * w_.count());
      off = 0;
      for (std::size_t p = 0; p < rule.nodes.size(); ++p) {
        const auto [s_p, t_p] = place(rule.nodes[p]);
        const double weight = 0.5 * rule.weights[p] * (along_t ? (1 - t_p) / (1 - box.middle_t()) : 1);
        for (std::size_t k = 0; k < w_.count(); ++k) {
          const double w = weight * density(e, k, s_p, t_p);
          off += 2 * radius * std::abs(w);
          for (std::size_t l = 0; l < w_.count(); ++l)
            sums[k * w_.count() + l] += w * values[p * w_.count() + l];
        }
      }
      return sums;
    };
    if (!(errors.quadrature[6] < 1e-3)) return;
    double off_truth = 0;
    const std::vector<double> truth = means(most_gauss_nodes, off_truth);
    for (const int n : {1, 2, 3, 5}) {
      const double bound = errors.quadrature[static_cast<std::size_t>(n) - 1];
      double off = 0;
      const std::vector<double> found = means(n, off);
      for (std::size_t k = 0; k < truth.size(); ++k)
        rules.meet(std::abs(found[k] - truth[k]), off + off_truth, bound, what + std::to_string(n));
    }
  }

  [[nodiscard]] const SectorScene& scene() const { return scene_; }
  [[nodiscard]] const std::vector<SectorElement>& elements() const { return elements_; }
  [[nodiscard]] const EdgeClosure& closure() const { return closure_; }
  [[nodiscard]] const SectorFunctions& w() const { return w_; }

private:
  SectorScene scene_;
  std::vector<SectorElement> elements_;
  SectorFunctions w_;
  SectorFunctions q_;
  EdgeClosure closure_;
  Smoothness smoothness_;
  SectorFunctions with_one_;
  Transport transport_;
  Transport transport_with_one_;
};

Sent drawn(const std::string& name, Draw& draw) {
  SectorScene scene(panels_of(name));
  std::vector<SectorElement> elements = graded_elements(scene, 3);
  const SectorFunctions w = drawn_functions(elements.size(), 2, 2, draw);
  return {std::move(scene), std::move(elements), w};
}

class SmoothnessOf : public ::testing::TestWithParam<const char*> {
protected:
  Draw draw_{11};
  Sent sent_{drawn(GetParam(), draw_)};
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

/// A part at a quarter of an element, of the same relative size in both parameters.
SectorBox drawn_small_box(const SectorBox& whole, Draw& draw) {
  const double part = std::ldexp(1.0, -3 - static_cast<int>(draw.below(11)));
  const double s = whole.s0 + (whole.s1 - whole.s0) * 0.25;
  const double t = whole.t0 + (whole.t1 - whole.t0) * 0.25;
  return {.s0 = s, .s1 = s + part * (whole.s1 - whole.s0), .t0 = t, .t1 = t + part * (whole.t1 - whole.t0)};
}

TEST_P(SmoothnessOf, BoundsPolynomialsAndRulesAlongBothParameters) {
  std::array<Closest, 2> polynomials;
  std::array<Closest, 2> rules;
  for (int k = 0; k < 200; ++k) {
    const std::size_t e = draw_.below(sent_.elements().size());
    const SectorBox& whole = sent_.elements()[e].box;
    const SectorBox box = k % 2 == 0 ? drawn_box(whole, draw_) : drawn_small_box(whole, draw_);
    for (const bool along_t : {false, true})
      sent_.expect(e, box, draw_(), along_t, false, polynomials[along_t], rules[along_t]);
  }
  for (const std::size_t t : {0U, 1U}) {
    EXPECT_GT(polynomials[t].tried, 600);
    EXPECT_GT(rules[t].tried, 1500);
    // A bound that nothing comes near would hold whatever was wrong with it.
    EXPECT_GT(polynomials[t].quotient, 2e-3);
    EXPECT_GT(rules[t].quotient, 1e-4);
  }
}

/// One polynomial a sector, and little more on each element.
SectorFunctions nearly_smooth(const std::vector<SectorElement>& elements, Draw& draw) {
  constexpr std::size_t powers = 3;
  SectorFunctions f = drawn_functions(elements.size(), 2, 2, draw);
  for (double& c : f.all()) c *= 1e-4;
  const ElementInterpolation interpolation(powers);
  const std::vector<double>& nodes = gauss_on_interval(powers).nodes;
  for (std::size_t k = 0; k < 2; ++k) {
    std::size_t sector = elements.size();
    std::array<double, powers * powers> a{};
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (elements[e].sector != sector)
        for (double& of_sector : a) of_sector = draw() - 0.25;
      sector = elements[e].sector;
      const SectorBox& box = elements[e].box;
      std::vector<double> values;
      for (const double x : nodes)
        for (const double y : nodes) {
          const double s = box.middle_s() + 0.5 * (box.s1 - box.s0) * x;
          const double t = box.middle_t() + 0.5 * (box.t1 - box.t0) * y;
          values.push_back(a[0] + s * (a[1] + s * a[2]) + t * (a[3] + t * a[4]) +
                           s * t * (a[5] + a[6] * s * t));
        }
      std::vector<double> smooth(powers * powers);
      interpolation.coefficients(values, 1, smooth);
      for (std::size_t i = 0; i < smooth.size(); ++i) f.of(e, k)[i] += smooth[i];
    }
  }
  return f;
}

TEST_P(SmoothnessOf, BoundsPolynomialsAndRulesBesideBordersThatAreContinuedAcross) {
  SectorScene scene(panels_of(GetParam()));
  std::vector<SectorElement> elements = graded_elements(scene, 3);
  const SectorFunctions w = nearly_smooth(elements, draw_);
  const Sent sent(std::move(scene), std::move(elements), w);
  Closest polynomials;
  Closest rules;
  int wide = 0;
  for (int k = 0; k < 600; ++k) {
    const std::size_t e = draw_.below(sent.elements().size());
    const SectorBox& whole = sent.elements()[e].box;
    if (whole.t0 != 0 || whole.s0 == 0 || whole.s1 == 1 || !sent.closure().mirror(e)) continue;
    // From a border on, and much wider than far from the edge.
    SectorBox box = whole;
    box.t1 = whole.t1 * std::ldexp(1.0, -3 - static_cast<int>(draw_.below(10)));
    box.t0 = box.t1 / 2;
    const double width = std::ldexp(whole.s1 - whole.s0, -4 - static_cast<int>(draw_.below(3)));
    if (draw_() < 0.5)
      box.s1 = whole.s0 + width;
    else
      box.s0 = whole.s1 - width;
    const int before = polynomials.tried;
    sent.expect(e, box, draw_(), false, false, polynomials, rules);
    if (polynomials.tried > before && box.s1 - box.s0 > 4 * box.t1) ++wide;
  }
  EXPECT_GT(wide, 20);
  EXPECT_GT(polynomials.tried, 300);
  EXPECT_GT(polynomials.quotient, 2e-3);
  EXPECT_GT(rules.quotient, 1e-4);
}

TEST_P(SmoothnessOf, CountsWhatLiesAcrossBordersThatAreContinuedAcross) {
  // Something on one element and 0 on all others beyond: what is continued across its border is all that
  // varies.
  SectorScene scene(panels_of(GetParam()));
  const std::vector<SectorElement> elements = graded_elements(scene, 3);
  Closest polynomials;
  Closest rules;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const SectorBox& whole = elements[e].box;
    const std::optional<std::size_t> opposite = scene.opposite(elements[e].sector);
    if (!opposite || whole.t0 != 0 || whole.s0 != 0.125) continue;
    SectorFunctions w(elements.size(), 1, 2);
    w.of(e, 0)[0] = 0.01;
    for (std::size_t other = 0; other < elements.size(); ++other)
      if (elements[other].sector == *opposite && elements[other].box.s0 == 1 - whole.s0)
        w.of(other, 0)[0] = 0.01;
    const Sent sent(SectorScene(panels_of(GetParam())), elements, w);
    for (const double depth : {0x1p-7, 0x1p-8, 0x1p-10}) {
      const SectorBox box{.s0 = whole.s0, .s1 = whole.s0 + 0x1p-7, .t0 = depth / 2, .t1 = depth};
      sent.expect(e, box, 0.5, false, false, polynomials, rules);
    }
  }
  EXPECT_GT(polynomials.tried, 50);
  EXPECT_GT(polynomials.quotient, 0.03);
  EXPECT_GT(rules.quotient, 0.005);
}

TEST_P(SmoothnessOf, BoundsPolynomialsAndRulesOfClosedCells) {
  std::array<Closest, 2> polynomials;
  std::array<Closest, 2> rules;
  for (int k = 0; k < 400; ++k) {
    const std::size_t e = draw_.below(sent_.elements().size());
    const SectorBox& whole = sent_.elements()[e].box;
    if (whole.t0 != 0 || !sent_.closure().mirror(e)) continue;
    SectorBox box = drawn_box(whole, draw_);
    box.t0 = 0;
    for (const bool along_t : {false, true})
      sent_.expect(e, box, draw_(), along_t, true, polynomials[along_t], rules[along_t]);
  }
  for (const std::size_t t : {0U, 1U}) {
    EXPECT_GT(polynomials[t].tried, 800);
    EXPECT_GT(rules[t].tried, 2000);
    EXPECT_GT(polynomials[t].quotient, 2e-3);
    EXPECT_GT(rules[t].quotient, 1e-4);
  }
}

TEST_P(SmoothnessOf, BoundsWhatTheOtherSideOfAnEdgeSends) {
  // T w - F, F of the closure, at points near an edge: the other side's T_j (w - xi) alone.
  const SectorScene& scene_ = sent_.scene();
  const std::vector<SectorElement>& elements_ = sent_.elements();
  const EdgeClosure& closure_ = sent_.closure();
  const SectorFunctions& w_ = sent_.w();
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

/// A thin tetrahedron: two triangles that meet at a small angle, and what closes them in narrow pieces.
std::vector<Panel> wedge() {
  using Point = Vector<Rational>;
  const Point a{Rational(-1), Rational(0), Rational(0)};
  const Point b{Rational(1), Rational(0), Rational(0)};
  const Point c{Rational(0), Rational(1), Rational(1, 32)};
  const Point d{Rational(0), Rational(1), Rational(-1, 32)};
  std::vector<Panel> panels;
  const auto add = [&](std::vector<Point> corners) {
    const Point within = Rational(1, 4) * (a + b + c + d);
    if (dot(cross(corners[1] - corners[0], corners[2] - corners[0]), within - corners[0]).sign() < 0)
      std::reverse(corners.begin(), corners.end());
    Point sum = corners[0];
    for (std::size_t i = 1; i < corners.size(); ++i) sum = sum + corners[i];
    const Point normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    panels.push_back({.piece = 0,
                      .corners = corners,
                      .centre = Rational(1, static_cast<int>(corners.size())) * sum,
                      .normal = normal});
  };
  add({a, b, c});
  add({a, b, d});
  constexpr int parts = 6;
  for (const Point& end : {a, b})
    for (int k = 0; k < parts; ++k) {
      const auto on = [&](const Point& to, int i) { return end + Rational(i, parts) * (to - end); };
      if (k == 0)
        add({end, on(c, 1), on(d, 1)});
      else
        add({on(c, k), on(c, k + 1), on(d, k + 1), on(d, k)});
    }
  return panels;
}

TEST(Smoothness, CountsWhatVariesOnTheOtherSideOfAnEdge) {
  // F is about xi where the other panels send next to nothing.
  SectorScene scene(wedge());
  const std::vector<Sector>& sectors = scene.sectors();
  const auto long_side = std::find_if(sectors.begin(), sectors.end(),
                                      [](const Sector& sector) { return norm(sector.b - sector.a) > 1.9; });
  const auto own = static_cast<std::size_t>(long_side - sectors.begin());
  const std::size_t other = scene.opposite(own).value();
  const double from = 0.5;
  const double to = 0.5 + 0x1p-6;
  std::vector<SectorElement> elements;
  std::size_t e = 0;
  std::size_t mirror = 0;
  for (std::size_t sector = 0; sector < sectors.size(); ++sector) {
    if (sector == own) e = elements.size() + 1;
    if (sector == other) mirror = elements.size() + 1;
    const std::array<double, 4> cuts =
        sector == other ? std::array{0.0, 1 - to, 1 - from, 1.0} : std::array{0.0, from, to, 1.0};
    for (std::size_t i = 0; i < 3; ++i) elements.push_back({sector, {.s0 = cuts[i], .s1 = cuts[i + 1]}});
  }
  for (const bool bent : {false, true}) {
    SectorFunctions w(elements.size(), 1, 2);
    w.of(mirror, 0)[bent ? 6 : 3] = 1;
    w.of(e, 0)[0] = 1;
    const Sent sent(scene, elements, w);
    ASSERT_EQ(sent.closure().mirror(e), mirror);
    Closest polynomials;
    Closest rules;
    const SectorBox box{.s0 = from + 0x1p-8, .s1 = from + 0x1p-7, .t0 = 0, .t1 = 0x1p-9};
    sent.expect(e, box, 0.5, false, true, polynomials, rules);
    EXPECT_GT(polynomials.quotient, 0.3);
    if (bent) {
      EXPECT_GT(rules.quotient, 0.1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Polyhedra, SmoothnessOf,
                         ::testing::Values("cube", "tetrahedron", "octahedron", "box"));

}  // namespace
}  // namespace radcert
