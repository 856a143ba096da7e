// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/events/visibility_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane.h"
#include "radcert/visibility/point_view.h"
#include "tests/visibility/event_rooms.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

using sample::EventRoom;
using sample::Numbers;

Vector<Rational> place(const Scene& scene, std::size_t triangle, const ParameterPoint<Rational>& at) {
  const auto [a, b, c] = scene.corners(triangle);
  const Vector<Rational> origin = exactly(a);
  return origin + at.s * (exactly(b) - origin) + at.t * (exactly(c) - origin);
}

std::string words(const Vector<Rational>& p) {
  return "(" + p.x.to_text() + ", " + p.y.to_text() + ", " + p.z.to_text() + ")";
}

Rational doubled(const std::vector<ParameterPoint<Rational>>& polygon) {
  Rational sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    sum += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return sum;
}

/// What a point sees of the lamp's area, exactly: twice its parts in the triangles' parameters.
Rational seen_of_lamp(const EventRoom& room, const Viewpoint& from) {
  Rational sum = 0;
  for (std::size_t t = 0; t < room.names.size(); ++t)
    if (room.names[t] == "lamp")
      for (const VisiblePart& part : visible_region(room.scene, from, t).parts)
        sum += doubled(exact_corners(room.scene, from, t, part));
  return sum;
}

struct Segment {
  std::string face;
  Vector<Rational> from;
  Vector<Rational> to;
};

std::vector<Segment> in_space(const EventRoom& room, const VisibilityEvents& events) {
  std::vector<Segment> segments;
  for (const EventSegment& each : events.segments)
    segments.push_back({room.names[each.triangle], place(room.scene, each.triangle, each.from),
                        place(room.scene, each.triangle, each.to)});
  return segments;
}

/// The part of a line that segments make up, if they lie on it.
Rational covered(const Segment& line, const std::vector<Segment>& segments) {
  const Vector<Rational> along = line.to - line.from;
  const auto part = [&](const Vector<Rational>& p) { return dot(p - line.from, along) / dot(along, along); };
  Rational sum = 0;
  for (const Segment& each : segments)
    if (each.face == line.face && is_zero(cross(each.from - line.from, along)) &&
        is_zero(cross(each.to - line.from, along)))
      sum += abs(part(each.to) - part(each.from));
  return sum;
}

// The lamp's upright sides are seen past the upright edge of the corner along two planes, which meet the wall
// behind it at y = 1 + 1/8 and 1 + 3/8.
TEST(VisibilityEvents, LieWhereTheLampIsSeenPastACorner) {
  const EventRoom room = sample::room_around_a_corner(0, 1);
  const auto found = visibility_events(room.scene, room.question);
  ASSERT_TRUE(found) << found.reason();
  const std::vector<Segment> segments = in_space(room, *found);
  std::size_t on_lines = 0;
  for (const Rational& y : {Rational(9, 8), Rational(11, 8)})
    for (const Segment& line :
         {Segment{"floor", {1, 1, 0}, {0, y, 0}}, Segment{"ceiling", {1, 1, 1}, {0, y, 1}},
          Segment{"west", {0, y, 0}, {0, y, 1}}}) {
      EXPECT_EQ(covered(line, segments), Rational(1)) << line.face << " " << y.to_text();
      for (const Segment& each : segments)
        if (covered(line, {each}) > Rational(0)) ++on_lines;
    }
  EXPECT_EQ(on_lines, segments.size());
  for (const EventSegment& each : found->segments) EXPECT_EQ(each.derivative, 1);
}

// Of a lamp that does not reach the floor the upright sides are seen as before, from all heights.
TEST(VisibilityEvents, OfAWindowReachAsHighAsItIsSeen) {
  const EventRoom room = sample::room_around_a_corner(0.25, 0.5);
  const auto found = visibility_events(room.scene, room.question);
  ASSERT_TRUE(found) << found.reason();
  const std::vector<Segment> segments = in_space(room, *found);
  for (const Rational& y : {Rational(9, 8), Rational(11, 8)}) {
    EXPECT_EQ(covered({"floor", {1, 1, 0}, {0, y, 0}}, segments), Rational(1));
    EXPECT_EQ(covered({"west", {0, y, 0}, {0, y, 1}}, segments), Rational(1));
  }
}

// A face that shines is seen from one side of its plane alone: light falls to nothing there, with a kink.
TEST(VisibilityEvents, LieInThePlaneOfASource) {
  const EventRoom room = sample::room_with_a_box("box_east");
  const auto found = visibility_events(room.scene, room.question);
  ASSERT_TRUE(found) << found.reason();
  const std::vector<Segment> segments = in_space(room, *found);
  const Rational x(5, 2);
  for (const Segment& line : {Segment{"floor", {x, 0, 0}, {x, 4, 0}}, Segment{"south", {x, 0, 0}, {x, 0, 3}},
                              Segment{"north", {x, 4, 0}, {x, 4, 3}}})
    EXPECT_EQ(covered(line, segments), Rational(1)) << line.face;
  // Nothing behind it is lit.
  for (const Segment& each : segments) EXPECT_GE(std::min(each.from.x, each.to.x), x) << each.face;
}

TEST(VisibilityEvents, AreNoneWithoutASourceOrWhereNobodyAsks) {
  EventRoom room = sample::room_with_a_box();
  EventQuestion dark = room.question;
  std::fill(dark.source.begin(), dark.source.end(), std::nullopt);
  EXPECT_TRUE(visibility_events(room.scene, dark)->segments.empty());
  for (std::size_t t = 0; t < room.names.size(); ++t) room.question.receives[t] = room.names[t] == "west";
  const auto found = visibility_events(room.scene, room.question);
  for (const EventSegment& each : found->segments) EXPECT_EQ(room.names[each.triangle], "west");
}

TEST(VisibilityEvents, AreRefusedAtTheirLimit) {
  const EventRoom room = sample::room_with_a_box();
  const std::size_t all = visibility_events(room.scene, room.question)->pencils;
  {
    const LoweredWorkLimit enough(most_event_pencils, static_cast<long>(all));
    EXPECT_TRUE(visibility_events(room.scene, room.question));
  }
  const LoweredWorkLimit one_less(most_event_pencils, static_cast<long>(all) - 1);
  EXPECT_FALSE(visibility_events(room.scene, room.question));
}

TEST(VisibilityEvents, AskForAClosedScene) {
  EventRoom room = sample::room_with_a_box();
  TriangleMesh mesh = room.scene.mesh();
  mesh.triangles.pop_back();
  room.question.source.pop_back();
  room.question.receives.pop_back();
  EXPECT_THROW((void)visibility_events(Scene(mesh), room.question), ContractViolation);
}

/// The area that is seen along a line on the floor of the room with a box, and where events cross the line.
class AreaAlong {
public:
  AreaAlong(const EventRoom& room, const std::vector<Segment>& segments, bool along_x, double at)
      : room_(room), along_x_(along_x), at_(at) {
    const Rational height = Rational::exactly(at);
    for (const Segment& each : segments) {
      if (each.face != "floor") continue;
      const Rational from = across(each.from) - height;
      const Rational to = across(each.to) - height;
      if (from.sign() * to.sign() > 0 || from == to) continue;
      const Rational part = from / (from - to);
      crossings.push_back((along(each.from) + part * (along(each.to) - along(each.from))).to_double());
    }
    std::sort(crossings.begin(), crossings.end());
  }

  /// The third difference of the area over the square of the step: where the first or the second derivative
  /// jumps it stays, elsewhere it falls with the step.
  double third_difference(double from, double step) {
    const auto area = [&](int k) {
      const double x = from + k * step;
      return seen_of_lamp(room_, {.point = along_x_ ? Vector<double>{x, at_, 0} : Vector<double>{at_, x, 0},
                                  .normal = {0, 0, 1},
                                  .triangle = std::nullopt});
    };
    const Rational difference = area(0) - Rational(3) * area(1) + Rational(3) * area(2) - area(3);
    return std::abs(difference.to_double()) / step / step;
  }

  /// Whether an event crosses [from,to].
  [[nodiscard]] bool crossed(double from, double to) const {
    return std::any_of(crossings.begin(), crossings.end(), [&](double x) { return x >= from && x <= to; });
  }

  std::vector<double> crossings;

private:
  [[nodiscard]] Rational along(const Vector<Rational>& p) const { return along_x_ ? p.x : p.y; }
  [[nodiscard]] Rational across(const Vector<Rational>& p) const { return along_x_ ? p.y : p.x; }

  const EventRoom& room_;
  bool along_x_;
  double at_;
};

/// Looks at lines on the floor of a room: third differences of the area that is seen fall with the step where
/// no event is crossed, and only there. Returns how many events were crossed.
std::size_t smooth_but_at_events(const EventRoom& room, unsigned seed, int lines) {
  const auto found = visibility_events(room.scene, room.question);
  EXPECT_TRUE(found) << found.reason();
  const std::vector<Segment> segments = in_space(room, *found);
  Numbers random(seed);
  constexpr double coarse = 0x1p-7;
  constexpr double fine = 0x1p-15;
  std::size_t crossed = 0;
  for (int run = 0; run < lines; ++run) {
    const double at = 0.25 + std::floor(random.fraction() * 3.5 / coarse) * coarse + coarse / 2;
    AreaAlong area(room, segments, run % 2 == 0, at);
    for (double from = coarse; from + 4 * coarse < 4; from += 3 * coarse) {
      if (area.crossed(from, from + 3 * coarse)) continue;
      const double all = area.third_difference(from, coarse);
      double parts = 0;
      for (int k = 0; k < 8; ++k)
        parts = std::max(parts, area.third_difference(from + k * 3 * coarse / 8, coarse / 8));
      EXPECT_LE(parts, 0.5 * all + 1e-9) << "run " << run << " at " << at << " from " << from;
    }
    for (const double x : area.crossings) {
      const double near = std::floor(x / fine) * fine;
      const double clear = 16 * fine;
      const auto others = std::count_if(area.crossings.begin(), area.crossings.end(),
                                        [&](double other) { return std::abs(other - x) < clear; });
      if (others > 1 || near < clear || near > 4 - clear) continue;
      ++crossed;
      const double across =
          std::max(area.third_difference(near - fine, fine), area.third_difference(near - 2 * fine, fine));
      const double beside = std::max(area.third_difference(near - 8 * fine, fine),
                                     area.third_difference(near + 8 * fine, fine));
      EXPECT_GT(across, 10 * beside) << "run " << run << " at " << at << " x " << x;
    }
  }
  return crossed;
}

// A convex body: no line touches two edges of it and one of the lamp but in the planes of events.
TEST(VisibilityEvents, AreWhereTheAreaThatIsSeenIsNotSmooth) {
  EXPECT_GT(smooth_but_at_events(sample::room_with_a_box(), 29, 12), 50U);
}

TEST(VisibilityEvents, OfASlantedBodyAreWhereTheAreaThatIsSeenIsNotSmooth) {
  Numbers random(8);
  for (int run = 0; run < 4; ++run) {
    const auto near = [&](double x, double y, double z) {
      const auto moved = [&](double c) { return c + std::floor(random.between(-96, 96)) / 256; };
      return Vector<double>{moved(x), moved(y), moved(z)};
    };
    const std::array<Vector<double>, 4> corners{near(1, 1.25, 1), near(2.75, 1.5, 1.25),
                                                near(1.75, 2.75, 1.5), near(2, 1.75, 2.25)};
    SCOPED_TRACE(run);
    EXPECT_GT(
        smooth_but_at_events(sample::room_with_a_tetrahedron(corners), 40 + static_cast<unsigned>(run), 3),
        5U);
  }
}

// Two bodies: some lines touch three edges, so that conics remain. Across them the second derivative jumps:
// third differences over the square of the step neither fall with the step, nor grow as at kinks, by 8.
TEST(VisibilityEvents, LeaveOutConicsAcrossWhichSecondDerivativesJump) {
  const std::array<Vector<double>, 4> body{
      {{1.125, 1.25, 1.25}, {2.75, 1.5, 1.5}, {1.75, 2.75, 1.375}, {2, 1.75, 2.25}}};
  const EventRoom room = sample::room_with_a_tetrahedron(body, true);
  const VisibilityEvents found = visibility_events(room.scene, room.question).value();
  const std::vector<Segment> segments = in_space(room, found);
  constexpr double coarse = 0x1p-7;
  Numbers random(3);
  std::size_t conics = 0;
  for (int run = 0; run < 12; ++run) {
    const double at = 0.25 + std::floor(random.fraction() * 3.5 / coarse) * coarse + coarse / 2;
    AreaAlong area(room, segments, run % 2 == 0, at);
    // Over all windows of one step that lie about three coarse ones.
    const auto largest = [&](double from, int parts) {
      double most = 0;
      for (int k = -parts; k <= 4 * parts - 3; ++k)
        most = std::max(most, area.third_difference(from + k * coarse / parts, coarse / parts));
      return most;
    };
    for (double from = 2 * coarse; from + 5 * coarse < 4; from += 3 * coarse) {
      if (area.crossed(from - coarse, from + 4 * coarse)) continue;
      const double all = area.third_difference(from, coarse);
      if (all < 0.1) continue;  // what is smooth is below that at this step, and most conics are above
      const double in_eight = largest(from, 8);
      if (in_eight <= 0.5 * all) continue;
      ++conics;
      EXPECT_LT(largest(from, 64), 4 * in_eight) << "run " << run << " at " << at << " from " << from;
    }
  }
  EXPECT_GT(conics, 2U);
}

double coordinate(const Vector<double>& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// The third differences of the area that is seen, across a segment and beside it, over the squared step.
struct Differences {
  double across = 0;
  double beside = 0;
};

Differences differences_at(const EventRoom& room, const EventSegment& segment, double step = 0x1p-17) {
  const Rational part(37, 100);
  const Vector<Rational> p =
      place(room.scene, segment.triangle, segment.from + part * (segment.to - segment.from));
  const Vector<Rational> along =
      place(room.scene, segment.triangle, segment.to) - place(room.scene, segment.triangle, segment.from);
  const Vector<double> normal = sample::normal_of(room.scene, segment.triangle);
  // An axis of the face, and of the two that which runs across the segment rather than along it.
  const Vector<double> a{std::abs(along.x.to_double()), std::abs(along.y.to_double()),
                         std::abs(along.z.to_double())};
  std::size_t axis = 3;
  for (std::size_t k = 0; k < 3; ++k)
    if (coordinate(normal, k) == 0 && (axis == 3 || coordinate(a, k) < coordinate(a, axis))) axis = k;
  const auto on_grid = [step](const Rational& x) { return std::floor(x.to_double() / step) * step; };
  const Vector<double> base{on_grid(p.x), on_grid(p.y), on_grid(p.z)};
  const auto area = [&](int k) {
    Vector<double> at = base;
    (axis == 0 ? at.x : axis == 1 ? at.y : at.z) += k * step;
    return seen_of_lamp(room, {.point = at, .normal = normal, .triangle = segment.triangle});
  };
  const auto difference = [&](int k) {
    const Rational d = area(k) - Rational(3) * area(k + 1) + Rational(3) * area(k + 2) - area(k + 3);
    return std::abs(d.to_double()) / step / step;
  };
  // The point was moved onto the grid along the segment too: by a step, which the slope makes two at most.
  Differences found;
  for (int k = -5; k <= 2; ++k) found.across = std::max(found.across, difference(k));
  for (const int k : {-12, 9}) found.beside = std::max(found.beside, difference(k));
  return found;
}

// Every segment, on whatever face, is one across which the area that is seen is not smooth.
TEST(VisibilityEvents, AreNowhereElse) {
  for (const EventRoom& room :
       {sample::room_around_a_corner(0.25, 0.5), sample::room_with_a_box(), sample::room_with_a_post()}) {
    const auto found = visibility_events(room.scene, room.question);
    ASSERT_TRUE(found) << found.reason();
    EXPECT_GT(found->segments.size(), 8U);
    for (const EventSegment& each : found->segments) {
      const Differences at = differences_at(room, each);
      EXPECT_GT(at.across, 10 * at.beside)
          << room.names[each.triangle] << " " << words(place(room.scene, each.triangle, each.from)) << " to "
          << words(place(room.scene, each.triangle, each.to)) << " derivative " << each.derivative;
    }
  }
}

// Where the second derivative jumps, third differences over the square of the step stay as the step falls;
// where the first one does, they grow like 1/step: from 2^-16 to 2^-19 by 8. Where in its cell of the grid
// the event lies makes a factor of less than 2, either way.
TEST(VisibilityEvents, AreOfTheDerivativeThatTheySay) {
  const auto growth = [](const EventRoom& room, const EventSegment& segment) {
    return differences_at(room, segment, 0x1p-19).across / differences_at(room, segment, 0x1p-16).across;
  };
  const EventRoom corner = sample::room_around_a_corner(0, 1);
  const VisibilityEvents kinks = visibility_events(corner.scene, corner.question).value();
  for (const EventSegment& each : kinks.segments)
    EXPECT_NEAR(std::log2(growth(corner, each)), 3, 1)
        << words(place(corner.scene, each.triangle, each.from));
  std::size_t second = 0;
  for (const EventRoom& room : {sample::room_with_a_box(), sample::room_with_a_post()}) {
    const VisibilityEvents found = visibility_events(room.scene, room.question).value();
    for (const EventSegment& each : found.segments) {
      if (each.derivative == 1) continue;
      ++second;
      EXPECT_NEAR(std::log2(growth(room, each)), 0, 1)
          << room.names[each.triangle] << " " << words(place(room.scene, each.triangle, each.from)) << " to "
          << words(place(room.scene, each.triangle, each.to));
    }
  }
  EXPECT_GT(second, 20U);
}

}  // namespace
}  // namespace radcert
