// SPDX-License-Identifier: GPL-3.0-or-later
// What EdgeContinuation says, against the functions themselves: w~ is put together here once more, from the
// polynomials' values. Samples are no larger than the truth, distances no smaller.
#include "radcert/continuous/transport/edge_continuation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "radcert/continuous/elements/gauss_tables.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 2> parts_of_width{0.25, 0.0625};

SectorFunctions drawn(std::size_t elements, std::uint64_t seed) {
  Draw draw(seed);
  return test::drawn_functions(elements, 1, 2, draw);
}

struct Case {
  Case(const std::string& name, int layers, std::uint64_t seed)
      : Case(name, layers, [&](std::size_t count) { return drawn(count, seed); }) {}
  template <class Functions>
    requires std::invocable<Functions, std::size_t> Case(const std::string& name, int layers,
                                                         const Functions& functions)
        : scene(panels_of(name)),
          elements(graded_elements(scene, layers)),
          w(functions(elements.size())),
          continuation(scene, elements, w) {}

    SectorScene scene;
    std::vector<SectorElement> elements;
    SectorFunctions w;
    EdgeContinuation continuation;

    /// The polynomial of an element, anywhere.
    template <class R>
    [[nodiscard]] R value(std::size_t e, const R& s, const R& t) const {
      return test::element_value(w, e, 0, elements[e].box, s, t);
    }

    [[nodiscard]] std::size_t element_at(std::size_t sector, double s, double t) const {
      for (std::size_t e = 0; e < elements.size(); ++e) {
        const SectorBox& b = elements[e].box;
        if (elements[e].sector == sector && b.s0 <= s && s <= b.s1 && b.t0 <= t && t <= b.t1) return e;
      }
      ADD_FAILURE() << "no element";
      return 0;
    }
};

/// A part of an element that another one is continued into.
struct SharedPart {
  std::size_t own = 0;    ///< of the column
  std::size_t other = 0;  ///< that is continued into
  SectorBox box;
};

/// What is continued beyond the edge of an element.
class Beyond {
public:
  Beyond(const Case& on, std::size_t element, double part)
      : on_(on), sector_(*on.scene.opposite(on.elements[element].sector)) {
    const SectorBox& own = on.elements[element].box;
    s0_ = 1 - own.s1;
    s1_ = 1 - own.s0;
    for (;;) {
      const auto next = std::find_if(on.elements.begin(), on.elements.end(), [&](const SectorElement& e) {
        return e.sector == sector_ && e.box.s0 == s0_ && e.box.s1 == s1_ && e.box.t0 == top_;
      });
      if (next == on.elements.end()) break;
      top_ = next->box.t1;
      column_.push_back(static_cast<std::size_t>(next - on.elements.begin()));
    }
    double before = s0_ > 0 ? s1_ - s0_ : 0;
    double after = s1_ < 1 ? s1_ - s0_ : 0;
    for (const SectorElement& e : on.elements) {
      if (e.sector != sector_ || e.box.t0 >= top_) continue;
      if (e.box.s1 == s0_) before = std::min(before, e.box.s1 - e.box.s0);
      if (e.box.s0 == s1_) after = std::min(after, e.box.s1 - e.box.s0);
    }
    from_ = s0_ - part * before;
    to_ = s1_ + part * after;
  }

  [[nodiscard]] bool is_there() const { return !column_.empty(); }
  [[nodiscard]] std::size_t sector() const { return sector_; }
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }
  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] const std::vector<std::size_t>& column() const { return column_; }
  [[nodiscard]] bool is_within_column(double s) const { return s0_ <= s && s <= s1_; }

  [[nodiscard]] std::vector<SharedPart> parts() const {
    std::vector<SharedPart> out;
    for (const std::size_t c : column_)
      for (std::size_t other = 0; other < on_.elements.size(); ++other) {
        const SectorBox& a = on_.elements[c].box;
        const SectorBox& b = on_.elements[other].box;
        const SectorBox shared{.s0 = std::max(b.s0, from_),
                               .s1 = std::min(b.s1, to_),
                               .t0 = std::max(a.t0, b.t0),
                               .t1 = std::min(a.t1, b.t1)};
        if (other != c && on_.elements[other].sector == sector_ && shared.s0 < shared.s1 &&
            shared.t0 < shared.t1)
          out.push_back({c, other, shared});
      }
    return out;
  }

  /// w~ on the opposite sector.
  [[nodiscard]] double continued(double s, double t) const {
    if (from_ <= s && s <= to_)
      for (const std::size_t e : column_)
        if (t <= on_.elements[e].box.t1) return on_.value(e, s, t);
    return itself(s, t);
  }
  [[nodiscard]] double itself(double s, double t) const {
    const std::size_t e = on_.element_at(sector_, s, t);
    return on_.value(e, s, t);
  }

private:
  const Case& on_;
  std::size_t sector_;
  std::vector<std::size_t> column_;
  double s0_ = 0;
  double s1_ = 1;
  double top_ = 0;
  double from_ = 0;
  double to_ = 1;
};

std::vector<Vector<double>> corners(const Sector& sector, const SectorBox& box) {
  const std::array<Vector<double>, 4> at = corners_of(sector, box);
  return {at.begin(), at.end()};
}

class EdgeContinuationOf : public ::testing::TestWithParam<const char*> {};

TEST_P(EdgeContinuationOf, IsOfTheElementsOppositeWithTheSameEnds) {
  const Case on(GetParam(), 3, 5);
  std::size_t there = 0;
  for (std::size_t e = 0; e < on.elements.size(); ++e) {
    if (!on.scene.opposite(on.elements[e].sector)) continue;
    const Beyond beyond(on, e, 0.25);
    EXPECT_EQ(on.continuation.beyond(e).size(), beyond.is_there() ? parts_of_width.size() : 0) << e;
    there += beyond.is_there() ? 1 : 0;
  }
  EXPECT_GT(there, on.elements.size() / 2);
}

TEST_P(EdgeContinuationOf, IsOnePolynomialAlongTheEdgeBetweenItsSides) {
  const Case on(GetParam(), 3, 6);
  Draw draw(7);
  int crossing = 0;
  for (int k = 0; k < 3000; ++k) {
    const std::size_t e = draw.below(on.elements.size());
    if (on.continuation.beyond(e).empty()) continue;
    const std::size_t which = draw.below(parts_of_width.size());
    const Beyond beyond(on, e, parts_of_width[which]);
    const EdgeContinuation::Continued& found = on.continuation.beyond(e)[which];
    const Sector& sector = on.scene.sectors()[beyond.sector()];
    const double width = beyond.to() - beyond.from();
    const double s = beyond.from() + width * (0.02 + 0.96 * draw());
    // Above the column too.
    const double t =
        std::min(0.99, beyond.top() * std::ldexp(2 * draw() + 0.01, -static_cast<int>(draw.below(8))));
    const Vector<double> p = sector.point(s, t);
    const double reach = 0.98 * least_distance(p, found.sides);
    // In the parameter along the edge, on the line t = const.
    const double half = reach / ((1 - t) * norm(sector.b - sector.a));
    std::array<double, 4> at{};
    for (std::size_t i = 0; i < 4; ++i)
      at[i] = beyond.continued(s + half * (static_cast<double>(i) / 1.5 - 1), t);
    EXPECT_NEAR(at[3] - 3 * at[2] + 3 * at[1] - at[0], 0, 1e-11) << e << " at " << s << " " << t;
    if (!beyond.is_within_column(s - half) || !beyond.is_within_column(s + half)) ++crossing;
  }
  EXPECT_GT(crossing, 20);
}

TEST_P(EdgeContinuationOf, LeavesNoMoreThanTheRest) {
  const Case on(GetParam(), 3, 8);
  Draw draw(9);
  double closest = 0;
  double nearest = 0;
  int tried = 0;
  for (int k = 0; k < 400; ++k) {
    const std::size_t e = draw.below(on.elements.size());
    if (on.continuation.beyond(e).empty()) continue;
    const std::size_t which = draw.below(parts_of_width.size());
    const Beyond beyond(on, e, parts_of_width[which]);
    const EdgeContinuation::Continued& found = on.continuation.beyond(e)[which];
    const SectorElement& own = on.elements[e];
    const Sector& here = on.scene.sectors()[own.sector];
    SectorBox box = own.box;
    box.t1 = box.t0 + (box.t1 - box.t0) * std::ldexp(1.0, -static_cast<int>(draw.below(10)));
    const double width = std::ldexp(box.s1 - box.s0, -static_cast<int>(draw.below(4)));
    (draw() < 0.5 ? box.s1 : box.s0) = draw() < 0.5 ? box.s0 + width : box.s1 - width;
    if (!(box.s0 < box.s1)) continue;
    const std::vector<Vector<double>> hull = corners(here, box);
    const double rest = on.continuation.rest(found, e, hull);
    const Sector& sector = on.scene.sectors()[beyond.sector()];
    const Vector<double>& n = on.scene.normal(sector.panel);
    const Vector<double>& n_p = on.scene.normal(here.panel);
    double height = 0;
    for (const Vector<double>& p : hull) height = std::max(height, dot(n, p - sector.a));
    const double rings = (dot(n, n_p) < -1e-9 ? 2 : 1) * height;
    // What is sent to a point of the cell, and the parts' sizes and distances.
    const Vector<double> p = here.point(box.s0 + (box.s1 - box.s0) * draw(),
                                        std::max(box.t0, 1e-6) + (box.t1 - std::max(box.t0, 1e-6)) * draw());
    double sent = 0;
    double by_parts = 0;
    for (const SharedPart& part : beyond.parts()) {
      double difference = 0;
      double q = infinity;
      constexpr int steps = 12;
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
          const double s = part.box.s0 + (part.box.s1 - part.box.s0) * i / steps;
          const double t = part.box.t0 + (part.box.t1 - part.box.t0) * j / steps;
          difference = std::max(difference, std::abs(on.value(part.own, s, t) - on.value(part.other, s, t)));
          for (const Vector<double>& corner : hull) q = std::min(q, norm(sector.point(s, t) - corner));
        }
      by_parts += difference * (q > rings ? rings / q : 1);
      const IntervalRule<double>& rule = gauss_on_interval(10);
      for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
          const double s = part.box.middle_s() + 0.5 * (part.box.s1 - part.box.s0) * rule.nodes[i];
          const double t = part.box.middle_t() + 0.5 * (part.box.t1 - part.box.t0) * rule.nodes[j];
          const Vector<double> way = sector.point(s, t) - p;
          const double squared = dot(way, way);
          const double kernel = -dot(n_p, way) * dot(n, way) / (squared * squared) * std::numbers::inv_pi;
          sent += 0.25 * (part.box.s1 - part.box.s0) * (part.box.t1 - part.box.t0) * sector.jacobian *
                  (1 - t) * rule.weights[i] * rule.weights[j] * kernel *
                  std::abs(on.value(part.own, s, t) - on.value(part.other, s, t));
        }
    }
    ++tried;
    EXPECT_LE(sent, rest * (1 + 1e-9)) << e;
    if (rest > 0) closest = std::max(closest, sent / rest);
    if (rest > 0) nearest = std::max(nearest, by_parts / rest);
  }
  EXPECT_GT(tried, 100);
  EXPECT_GT(closest, 0.02);
  EXPECT_GT(nearest, 0.3);
}

TEST_P(EdgeContinuationOf, CountsTheMassOfWhatLiesAcrossABorder) {
  // Differences that grow away from an element, so that their coefficients have one sign: the sum of those is
  // the difference at a corner.
  const Case on(GetParam(), 3, [](std::size_t count) {
    SectorFunctions w(count, 1, 2);
    for (std::size_t e = 0; e < count; e += 2)
      for (std::size_t i = 0; i < 9; ++i) w.of(e, 0)[i] = 1 / static_cast<double>(1 + i);
    return w;
  });
  double nearest = 0;
  double far = 0;
  for (std::size_t e = 0; e < on.elements.size(); ++e)
    for (std::size_t which = 0; which < on.continuation.beyond(e).size(); ++which) {
      const Beyond beyond(on, e, parts_of_width[which]);
      const Sector& here = on.scene.sectors()[on.elements[e].sector];
      const Sector& sector = on.scene.sectors()[beyond.sector()];
      const SectorBox& whole = on.elements[e].box;
      for (const double place : {0.01, 0.5, 0.99})
        for (const double depth : {0x1p-16, 0x1p-10, 0x1p-6}) {
          const double s = whole.s0 + (whole.s1 - whole.s0) * place;
          const double t = whole.t0 + (whole.t1 - whole.t0) * depth;
          const Vector<double> p = here.point(s, t);
          const double rest = on.continuation.rest(on.continuation.beyond(e)[which], e, std::array{p});
          const double rings =
              (dot(on.scene.normal(sector.panel), on.scene.normal(here.panel)) < -1e-9 ? 2 : 1) *
              dot(on.scene.normal(sector.panel), p - sector.a);
          double by_parts = 0;
          for (const SharedPart& part : beyond.parts()) {
            double difference = 0;
            double q = infinity;
            for (int i = 0; i <= 20; ++i)
              for (int j = 0; j <= 20; ++j) {
                const double s_q = part.box.s0 + (part.box.s1 - part.box.s0) * i / 20;
                const double t_q = part.box.t0 + (part.box.t1 - part.box.t0) * j / 20;
                difference = std::max(
                    difference, std::abs(on.value(part.own, s_q, t_q) - on.value(part.other, s_q, t_q)));
                q = std::min(q, norm(sector.point(s_q, t_q) - p));
              }
            by_parts += difference * (q > rings ? rings / q : 1);
            if (q > rings) far = std::max(far, difference);
          }
          EXPECT_GE(rest, 0.999 * by_parts) << e << " at " << s << " " << t;
          nearest = std::max(nearest, by_parts / rest);
        }
    }
  EXPECT_GT(nearest, 0.9);
  EXPECT_GT(far, 0);
}

TEST(SlidSizes, GrowAsTheFunctionsDo) {
  constexpr int degree = 8;
  SectorFunctions f(2, 1, degree);
  f.of(0, 0)[degree * (degree + 1)] = 1;
  f.of(1, 0)[degree] = 2;
  SlidSizes one;
  one.include(f, 0);
  SlidSizes both = one;
  SlidSizes other;
  other.include(f, 1);
  both.include(other);
  for (int k = 0; k <= 100; ++k) {
    const double part = k / 100.0;
    const double growth = std::pow(part + std::sqrt(1 + part * part), degree);
    EXPECT_GE(one.at(part), growth) << part;
    EXPECT_GE(both.at(part), 2 * growth) << part;
    if (part == 0.25 || part == 0.5 || part == 1) {
      EXPECT_LE(one.at(part), growth * (1 + 1e-9)) << part;
    }
  }
}

TEST_P(EdgeContinuationOf, HasSizesWhereItsPointsSlide) {
  const Case on(GetParam(), 3, 10);
  double closest = 0;
  for (std::size_t e = 0; e < on.elements.size(); ++e)
    for (std::size_t which = 0; which < on.continuation.beyond(e).size(); ++which) {
      const Beyond beyond(on, e, parts_of_width[which]);
      const EdgeContinuation::Continued& found = on.continuation.beyond(e)[which];
      for (const double part : {0.1, 0.25, 0.4, 0.99}) {
        double largest = 0;
        for (const std::size_t c : beyond.column()) {
          const SectorBox& box = on.elements[c].box;
          for (int i = 0; i <= 10; ++i)
            for (int j = 0; j <= 4; ++j) {
              const double x = -1 + i / 5.0;
              const double y = -1 + j / 2.0;
              const std::complex<double> slid(x, part * (1 - std::abs(x)));
              const std::complex<double> s =
                  0.5 * (beyond.from() + beyond.to()) + 0.5 * (beyond.to() - beyond.from()) * slid;
              const std::complex<double> t(0.5 * (box.t0 + box.t1) + 0.5 * (box.t1 - box.t0) * y);
              largest = std::max(largest, std::abs(on.value(c, s, t)));
            }
        }
        EXPECT_LE(largest, found.sizes.at(part)) << e << " " << part;
        closest = std::max(closest, largest / found.sizes.at(part));
      }
    }
  EXPECT_GT(closest, 0.7);
}

INSTANTIATE_TEST_SUITE_P(Polyhedra, EdgeContinuationOf,
                         ::testing::Values("cube", "tetrahedron", "octahedron", "box"));

}  // namespace
}  // namespace radcert
