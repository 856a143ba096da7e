// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/plane_element.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/closed_form/polygon_to_polygon.h"
#include "radcert/factors/certified_exchange.h"
#include "radcert/factors/contour_exchange.h"
#include "radcert/factors/exchange_area.h"
#include "radcert/factors/shadow_exchange.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_polygon.h"
#include "tests/factors/sample_rooms.h"
#include "tests/limits/limits.h"
#include "tests/visibility/event_rooms.h"

namespace radcert::limits {
namespace {

const Rational half(1, 2);

/// Between unit squares of which a quarter of a third hides a part: 3/4 of the factor of the cube's opposite
/// faces.
const Ball& obstruction() {
  static const Ball value = *Ball::parse("0.14986867177379053728 +/- 1e-20");
  return value;
}

/// The factor between the first two squares of a scene.
Case certified(const TriangleMesh& mesh, bool obstructed, const std::string& about) {
  return {
      .limit = "factors/certified_exchange: evaluations of a shadow",
      .answer =
          [mesh] {
            const FacetScene scene(mesh);
            Ball sum = 0;
            for (const std::size_t i : {0U, 1U})
              for (const std::size_t j : {2U, 3U})
                sum += certified_exchange_area(scene, i, j, scene.pair(i, j), {.radius = 1e-4});
            return numbers({sum});
          },
      .truth = [obstructed] { return obstructed ? std::vector<Ball>{obstruction()} : std::vector<Ball>(); },
      .about = about};
}

Case shadow() {
  return {
      .limit = "factors/shadow_exchange: evaluations",
      .answer =
          [] {
            const ExactCorners receiver{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
            const ExactCorners source{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
            const ExactCorners between{{0, 0, half}, {half, 0, half}, {half, half, half}, {0, half, half}};
            const auto found =
                shadow_exchange_area(receiver, source, between, OccludingSide::both, {.radius = 1e-6});
            return found ? numbers({*found}) : refusal("nothing was bounded");
          },
      // A quarter of the factor is kept back.
      .truth = [] { return std::vector<Ball>{obstruction() / 3}; }};
}

Case seen_contours() {
  return {
      .limit = "factors/contour_exchange: pieces of edges",
      .answer =
          [] {
            const ExactCorners receiver{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
            const ExactCorners source{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
            const ExactCorners between{{0, 0, half}, {half, 0, half}, {half, half, half}, {0, half, half}};
            const auto found = contour_exchange_area(receiver, source, {between},
                                                     obstruction() * Ball(4) / Ball(3), {.radius = 1e-6});
            return found ? numbers({*found}) : refusal("sides in the receiver's plane");
          },
      .truth = [] { return std::vector<Ball>{obstruction()}; }};
}

/// Of two polygons with nothing between them, by contours and by rules.
Case exchange(const std::string& limit, const FacetCorners& first, const FacetCorners& second, bool far,
              const std::string& about) {
  const auto polygon = [](const FacetCorners& corners) {
    std::vector<Vector<Rational>> exact;
    for (const Vector<double>& p : corners) exact.push_back(exactly(p));
    return plane_polygon(exact).value();
  };
  return {.limit = limit,
          .answer =
              [=] {
                const Approximation found =
                    far ? exchange_area_by_rules(first, second) : exchange_area_by_contours(first, second);
                return numbers({number(found.value, found.radius)});
              },
          .truth =
              [=] {
                const Vector<double> area = vector_area(first);
                return std::vector<Ball>{polygon_to_polygon(polygon(first), polygon(second)) *
                                         sqrt(Ball(dot(exactly(area), exactly(area))))};
              },
          .about = about};
}

PlanePolygon unit_square(const Rational& height) {
  return plane_polygon({{0, 0, height}, {1, 0, height}, {1, 1, height}, {0, 1, height}}).value();
}
PlanePolygon square_from_above(const Rational& height) {
  return plane_polygon({{0, 0, height}, {0, 1, height}, {1, 1, height}, {1, 0, height}}).value();
}

PlanePolynomial<Rational> one() {
  PlanePolynomial<Rational> q(0);
  q(0, 0) = 1;
  return q;
}

Case far_squares() {
  return {.limit = "scalar/raised_precision: bits", .answer = [] {
            const Outcome<Ball> found = polygon_to_polygon_within(unit_square(0), square_from_above(100000),
                                                                  1 / power(Rational(10), 40));
            return found ? numbers({*found}) : refusal(found.reason());
          }};
}

Case far_point() {
  return {.limit = "closed_form/point_to_polygon: bits", .answer = [] {
            const Outcome<Ball> found = point_to_polygon_within(
                1 / power(Rational(10), 40), {half, half, 1000}, {0, 0, -1}, unit_square(0), one());
            return found ? numbers({*found}) : refusal(found.reason());
          }};
}

/// s^degree over the unit square from a point above it. Int |G| is at most pi, and max |s^n| = 1.
Case element(const std::string& limit, int degree, const Vector<double>& p, double normal_length,
             const std::string& about) {
  const auto density = [degree] {
    PlanePolynomial<Rational> q(degree);
    q(degree, 0) = 1;
    return q;
  };
  return {.limit = limit,
          .answer =
              [=] {
                const PlaneElement prepared(unit_square(0), {density()});
                std::vector<double> values(1);
                const PlaneElement::Route route = prepared.integrals(p, {0, 0, -normal_length}, values);
                return numbers({number(values[0], 4e-14)}, std::to_string(static_cast<int>(route)));
              },
          .truth =
              [=] {
                const BallPrecision precision(2000);
                return std::vector<Ball>{
                    point_to_polygon({Rational::exactly(p.x), Rational::exactly(p.y), Rational::exactly(p.z)},
                                     {0, 0, -1}, unit_square(0), density())};
              },
          .about = about};
}

/// The events in a room by their ends.
Case events() {
  return {.limit = "visibility/visibility_events: pencils of lines", .answer = [] {
            const sample::EventRoom room = sample::room_around_a_corner(0, 1);
            const auto found = visibility_events(room.scene, room.question);
            if (!found) return refusal(found.reason());
            std::vector<Ball> all;
            for (const EventSegment& each : found->segments)
              for (const Rational& x : {each.from.s, each.from.t, each.to.s, each.to.t}) all.emplace_back(x);
            return numbers(std::move(all));
          }};
}

}  // namespace

std::vector<Case> polygon_cases() {
  const FacetCorners floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const FacetCorners wall{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
  const FacetCorners leaning{{-1e-7, 0, 1e-9}, {-1e-7, 1, 1e-9}, {-0.5, 1, 0.75}, {-0.5, 0, 0.75}};
  const FacetCorners away{{0, 0, 5}, {0, 1, 5}, {1, 1, 5}, {1, 0, 5}};
  return {
      certified(sample::obstructed_squares(), true, "a quarter hidden"),
      shadow(),
      seen_contours(),
      exchange("factors/exchange_area: halvings of an edge", floor, wall, false, "a common edge"),
      exchange("factors/exchange_area: halvings of an edge", floor, leaning, false, "nearly a common edge"),
      exchange("factors/exchange_area: halvings of an edge in all", floor, wall, false, "a common edge"),
      exchange("factors/exchange_area: halvings of an edge in all", floor, leaning, false,
               "nearly a common edge"),
      exchange("factors/exchange_area: points of a rule for far polygons", floor, away, true, "far squares"),
      events(),
      far_squares(),
      far_point(),
      element("closed_form/plane_element: bits of a ball", 3, {0.3, 0.4, 0.5}, 1e-70, "a short normal"),
      element("closed_form/plane_element: pieces of a rule", 6, {0.3, 0.4, 0.3}, 1, "above"),
      element("closed_form/plane_element: pieces of a rule", 4, {-0.2, 0.4, 0.3}, 1, "beside")};
}

}  // namespace radcert::limits
