// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/cut/cut_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/geometry/cut/segment_arrangement.h"

namespace radcert {
namespace {

using Point = ParameterPoint<Rational>;
using Corners = std::array<ParameterPoint<double>, 3>;

class Points {
public:
  explicit Points(unsigned seed) : stream_(seed) {}
  Rational part() { return {static_cast<long>(stream_() % 1001), 1000}; }
  Point inside() {
    const Rational s = part();
    return {s, part() * (Rational(1) - s)};
  }
  /// On side k of the unit triangle.
  Point on_side(int k) {
    const Rational x = part();
    if (k == 0) return {x, 0};
    return k == 1 ? Point{Rational(1) - x, x} : Point{0, x};
  }

private:
  std::mt19937_64 stream_;
};

std::vector<PlaneSegment> chords(Points& random, int count) {
  std::vector<PlaneSegment> out;
  while (static_cast<int>(out.size()) < count) {
    const PlaneSegment chord{random.on_side(static_cast<int>(out.size()) % 3),
                             random.on_side(static_cast<int>(out.size() + 1) % 3)};
    if (!(chord.from == chord.to)) out.push_back(chord);
  }
  return out;
}

Point exact(const ParameterPoint<double>& p) { return {Rational::exactly(p.s), Rational::exactly(p.t)}; }

Rational doubled_area(const Corners& v) {
  return cross(exact(v[1]) - exact(v[0]), exact(v[2]) - exact(v[0]));
}

TEST(SegmentArrangement, CutsAtAllCommonPointsAndNowhereElse) {
  // A cross, one that touches it, and one that overlaps an arm.
  const std::vector<PlaneSegment> segments{
      {{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}, {{1, 1}, {1, 5}}, {{1, 4}, {1, 7}}};
  const SegmentArrangement found = segment_arrangement(segments);
  EXPECT_EQ(found.points.size(), 8U);
  EXPECT_EQ(found.segments.size(), 7U);
}

TEST(SegmentArrangement, CutsWhereAnEndLiesOnASegment) {
  const std::vector<PlaneSegment> segments{{{0, 0}, {2, 0}}, {{1, 0}, {1, 1}}};
  const SegmentArrangement found = segment_arrangement(segments);
  EXPECT_EQ(found.points.size(), 4U);
  EXPECT_EQ(found.segments.size(), 3U);
}

TEST(SegmentArrangement, CutsOverlappingSegmentsAtTheEndsOfBoth) {
  const std::vector<PlaneSegment> segments{
      {{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}, {{4, 0}, {9, 0}}, {{5, 0}, {6, 0}}};
  const SegmentArrangement found = segment_arrangement(segments);
  EXPECT_EQ(found.points.size(), 8U);
  // From point to point: points are in order along the line.
  const std::vector<std::pair<std::size_t, std::size_t>> expected{{0, 1}, {1, 2}, {2, 3},
                                                                  {4, 5}, {5, 6}, {6, 7}};
  EXPECT_EQ(found.segments, expected);
}

TEST(SegmentArrangement, LeavesPartsThatMeetInEndsAlone) {
  Points random(3);
  for (int run = 0; run < 20; ++run) {
    std::vector<PlaneSegment> segments;
    while (segments.size() < 8) {
      const PlaneSegment each{random.inside(), random.inside()};
      if (!(each.from == each.to)) segments.push_back(each);
    }
    const SegmentArrangement found = segment_arrangement(segments);
    const auto sign = [&](std::size_t a, std::size_t b, std::size_t c) {
      return cross(found.points[b] - found.points[a], found.points[c] - found.points[a]).sign();
    };
    for (const auto& [a, b] : found.segments)
      for (const auto& [c, d] : found.segments) {
        if (a == c || a == d || b == c || b == d) continue;
        if (sign(a, b, c) == 0 && sign(a, b, d) == 0) continue;  // parts of one line: see the sums below
        EXPECT_FALSE(sign(a, b, c) * sign(a, b, d) <= 0 && sign(c, d, a) * sign(c, d, b) <= 0)
            << "run " << run;
      }
    // No length is lost: the parts that lie on a segment add up to it.
    for (const PlaneSegment& whole : segments) {
      Rational sum = 0;
      const Point along = whole.to - whole.from;
      const Rational square = along.s * along.s + along.t * along.t;
      for (const auto& [a, b] : found.segments) {
        const Point p = found.points[a] - whole.from;
        const Point q = found.points[b] - whole.from;
        if (cross(along, p).sign() != 0 || cross(along, q).sign() != 0) continue;
        const Rational at_p = (along.s * p.s + along.t * p.t) / square;
        const Rational at_q = (along.s * q.s + along.t * q.t) / square;
        if (std::min(at_p, at_q).sign() >= 0 && std::max(at_p, at_q) <= Rational(1)) sum += abs(at_q - at_p);
      }
      EXPECT_EQ(sum, Rational(1)) << "run " << run;
    }
  }
}

TEST(CutTriangle, IsTheTriangleWhereNothingCuts) {
  const auto parts = cut_triangle({});
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->size(), 1U);
  EXPECT_EQ(doubled_area(parts->front()), Rational(1));
}

TEST(CutTriangle, TilesTheTriangleAlongTheSegments) {
  Points random(5);
  int cut = 0;
  for (int run = 0; run < 40; ++run) {
    const std::vector<PlaneSegment> segments = chords(random, 1 + run % 5);
    const auto parts = cut_triangle(segments);
    if (!parts) continue;  // a part that is too thin
    ++cut;
    Rational sum = 0;
    for (const Corners& part : *parts) {
      EXPECT_GT(doubled_area(part), Rational(0));
      sum += doubled_area(part);
      for (const auto& corner : part)
        EXPECT_EQ(std::ldexp(corner.s, digits_of_a_cut), std::floor(std::ldexp(corner.s, digits_of_a_cut)));
      // No segment runs through the interior of a part, up to the move of its points.
      for (const PlaneSegment& segment : segments) {
        const Point along = segment.to - segment.from;
        double least = 1;
        double most = -1;
        for (const auto& corner : part) {
          const double height = cross(along, exact(corner) - segment.from).to_double();
          least = std::min(least, height);
          most = std::max(most, height);
        }
        EXPECT_FALSE(least < -0x1p-28 && most > 0x1p-28) << "run " << run;
      }
    }
    EXPECT_EQ(sum, Rational(1)) << "run " << run;
  }
  EXPECT_GT(cut, 30);
}

// The same point of a side, from either end: of two triangles that share the side each measures from its own.
TEST(CutTriangle, CutsASideAtTheSamePointFromBothEnds) {
  Points random(11);
  for (int run = 0; run < 200; ++run) {
    // Every second one half way between two numbers of the grid.
    const Rational x = run % 2 == 0 ? random.part() * Rational(1, 3)
                                    : Rational(2 * static_cast<long>(run) + 1, 1L << (digits_of_a_cut + 1));
    if (x.sign() == 0) continue;
    const std::vector<PlaneSegment> from_start{{{x, 0}, {Rational(1, 4), Rational(1, 2)}}};
    const std::vector<PlaneSegment> from_end{{{Rational(1) - x, 0}, {Rational(1, 4), Rational(1, 2)}}};
    const auto on_side = [](const std::vector<Corners>& parts) {
      std::vector<double> at;
      for (const Corners& part : parts)
        for (const auto& corner : part)
          if (corner.t == 0 && corner.s > 0 && corner.s < 1) at.push_back(corner.s);
      return at;
    };
    const auto start = cut_triangle(from_start);
    const auto end = cut_triangle(from_end);
    if (!start || !end) continue;
    EXPECT_EQ(on_side(*start).front(), 1 - on_side(*end).front()) << x.to_text();
  }
}

TEST(CutTriangle, JoinsLinesThatRoundingParts) {
  const Rational nearly = Rational(1, 3) + Rational(1, 1L << 50);
  const std::vector<PlaneSegment> segments{{{Rational(1, 3), 0}, {0, Rational(1, 3)}},
                                           {{nearly, 0}, {0, nearly}}};
  const auto parts = cut_triangle(segments);
  ASSERT_TRUE(parts) << parts.reason();
  EXPECT_EQ(parts->size(), 3U);
}

TEST(CutTriangle, RefusesThinParts) {
  const Rational near = Rational(1, 3) + Rational(1, 1L << 22);
  const std::vector<PlaneSegment> segments{{{Rational(1, 3), 0}, {0, Rational(1, 3)}},
                                           {{near, 0}, {0, near}}};
  EXPECT_FALSE(cut_triangle(segments));
}

TEST(CutTriangle, RefusesAtItsLimitAndOutsideTheTriangle) {
  Points random(2);
  const std::vector<PlaneSegment> segments = chords(random, 3);
  const LoweredWorkLimit two(most_segments_of_a_cut, 2);
  EXPECT_FALSE(cut_triangle(segments));
  const std::vector<PlaneSegment> outside{{{0, 0}, {1, 1}}};
  EXPECT_THROW((void)cut_triangle(outside), ContractViolation);
}

}  // namespace
}  // namespace radcert
