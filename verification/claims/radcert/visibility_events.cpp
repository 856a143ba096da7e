// SPDX-License-Identifier: GPL-3.0-or-later

// What cutting elements along visibility events does to collocation.
//
// Checked      Rooms that are black but for one plane face, which reflects half: there u is E + K E exactly,
//              the light of a lamp past boxes, summed along the sides of what a point sees of the lamp.
//              Of |u - u_n| at points of all elements: on the wall behind the corner of an L-shaped room,
//              which is away from all edges that see it, the order is 1 with uniform meshes and r = 1, and
//              r + 1 for the degrees r = 1 and 2 with elements cut along events. On the floor beside a table
//              2 for r = 1, and at most a quarter of the error of the uniform mesh.
//              Rejected: elements cut along as many other lines; uniform meshes.
// Not checked  light that is reflected more than once, which has events of its own; degree 2 under the table,
//              where conics remain, along which second derivatives jump.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "radcert/expression/parse.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/study/events/event_triangulation.h"
#include "radcert/study/study.h"
#include "verification/claims/radcert/light_past_boxes.h"
#include "verification/claims/radcert/mesh_choice.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::radcert {
namespace {

/// A closed room whose faces are quadrilaterals, counterclockwise as seen from within.
class Room {
public:
  void quad(const std::string& piece, const std::array<Vector<double>, 4>& corners) {
    std::array<std::size_t, 4> v{};
    for (std::size_t i = 0; i < 4; ++i) v.at(i) = vertex(corners.at(i));
    const auto known = std::find(names_.begin(), names_.end(), piece);
    const auto number = static_cast<std::size_t>(known - names_.begin());
    if (known == names_.end()) names_.push_back(piece);
    for (const VertexTriple& triangle : {VertexTriple{v[0], v[1], v[2]}, VertexTriple{v[0], v[2], v[3]}}) {
      mesh_.triangles.push_back(triangle);
      pieces_.push_back(number);
    }
  }
  /// The ring between two rectangles of a plane z = constant, seen from above or from below; its part towards
  /// larger x is a piece of its own.
  void ring(const std::string& piece, double z, const AxisBox& outer, const AxisBox& inner, bool from_above) {
    const auto corner = [&](const AxisBox& box, int k) {
      return Vector<double>{k == 1 || k == 2 ? box.high.x : box.low.x, k >= 2 ? box.high.y : box.low.y, z};
    };
    for (int k = 0; k < 4; ++k) {
      const int next = (k + 1) % 4;
      std::array<Vector<double>, 4> corners{corner(outer, k), corner(outer, next), corner(inner, next),
                                            corner(inner, k)};
      if (!from_above) std::reverse(corners.begin(), corners.end());
      quad(k == 1 ? piece + "_east" : piece, corners);
    }
  }
  /// The four upright sides of a box, seen from outside or from inside.
  void sides(const std::string& piece, const AxisBox& box, bool from_outside) {
    const auto& [x, y, z] = box.low;
    const auto& [X, Y, Z] = box.high;
    for (std::array<Vector<double>, 4> corners :
         std::vector<std::array<Vector<double>, 4>>{{{{x, y, z}, {X, y, z}, {X, y, Z}, {x, y, Z}}},
                                                    {{{X, y, z}, {X, Y, z}, {X, Y, Z}, {X, y, Z}}},
                                                    {{{X, Y, z}, {x, Y, z}, {x, Y, Z}, {X, Y, Z}}},
                                                    {{{x, Y, z}, {x, y, z}, {x, y, Z}, {x, Y, Z}}}}) {
      if (!from_outside) std::reverse(corners.begin(), corners.end());
      quad(piece, corners);
    }
  }
  [[nodiscard]] SurfaceChoice surface(const std::string& name) const {
    return mesh_choice(
        name, mesh_, pieces_, names_,
        {.orientation = Orientation::along_the_cross_product, .closed = true, .unoccluded = false});
  }

private:
  std::size_t vertex(const Vector<double>& at) {
    const auto known = std::find(mesh_.vertices.begin(), mesh_.vertices.end(), at);
    if (known != mesh_.vertices.end()) return static_cast<std::size_t>(known - mesh_.vertices.begin());
    mesh_.vertices.push_back(at);
    return mesh_.vertices.size() - 1;
  }

  TriangleMesh mesh_;
  std::vector<std::size_t> pieces_;
  std::vector<std::string> names_;
};

/// A room, its lamp, the boxes that stand before it, and the face on which u is looked at.
struct LitRoom {
  SurfaceChoice surface;
  AxisRectangle lamp;
  std::vector<AxisBox> boxes;
  std::string receiver;
  Vector<double> normal;
  std::function<bool(const Vector<double>& p)> looked_at;
};

/// x in [0,3] for y in [0,1], x in [0,1] for y in [1,27/10], z in [0,1]; the wall x = 3 is the lamp.
LitRoom room_around_a_corner() {
  Room room;
  constexpr double end = 2.7;
  const auto ground = [&](double x, double X, double y, double Y) {
    room.quad("floor", {{{x, y, 0}, {X, y, 0}, {X, Y, 0}, {x, Y, 0}}});
    room.quad("ceiling", {{{x, y, 1}, {x, Y, 1}, {X, Y, 1}, {X, y, 1}}});
  };
  const auto wall = [&](const std::string& name, double x, double y, double X, double Y) {
    room.quad(name, {{{x, y, 0}, {X, Y, 0}, {X, Y, 1}, {x, y, 1}}});
  };
  ground(0, 1, 0, 1);
  ground(0, 1, 1, end);
  ground(1, 3, 0, 1);
  wall("lamp", 3, 1, 3, 0);
  wall("west", 0, 0, 0, 1);
  wall("west", 0, 1, 0, end);
  wall("inner_east", 1, end, 1, 1);
  wall("inner_south", 1, 1, 3, 1);
  wall("north", 0, end, 1, end);
  wall("south", 1, 0, 0, 0);
  wall("south", 3, 0, 1, 0);
  return {.surface = room.surface("a room around a corner"),
          .lamp = {.axis = 0, .low = {3, 0, 0}, .high = {3, 1, 1}},
          .boxes = {{{1, 1, 0}, {3, end, 1}}},
          .receiver = "west",
          .normal = {1, 0, 0},
          .looked_at = [](const Vector<double>& p) { return p.y >= 1; }};
}

/// A room of 4 x 4 x 4 with a lamp in the ceiling over a table, whose foot stands in full shadow.
LitRoom room_with_a_table() {
  const AxisBox all{{0, 0, 0}, {4, 4, 4}};
  const AxisBox lamp{{2, 1.6, 4}, {3.2, 2.7, 4}};
  const AxisBox top{{1.1, 1.2, 0.9}, {2.9, 2.5, 1}};
  const AxisBox foot{{1.8, 1.7, 0}, {2.2, 2.1, 0.9}};
  Room room;
  room.ring("floor", 0, all, foot, true);
  room.ring("ceiling", 4, all, lamp, false);
  room.quad("lamp", {{{2, 1.6, 4}, {2, 2.7, 4}, {3.2, 2.7, 4}, {3.2, 1.6, 4}}});
  room.sides("walls", all, false);
  room.sides("foot", foot, true);
  room.sides("top", top, true);
  room.ring("top", 0.9, top, foot, false);
  room.quad("top", {{{1.1, 1.2, 1}, {2.9, 1.2, 1}, {2.9, 2.5, 1}, {1.1, 2.5, 1}}});
  return {.surface = room.surface("a room with a table"),
          .lamp = {.axis = 2, .low = lamp.low, .high = lamp.high},
          .boxes = {top},
          .receiver = "floor_east",
          .normal = {0, 0, 1},
          .looked_at = [](const Vector<double>&) { return true; }};
}

Problem problem_in(const LitRoom& room, int degree) {
  const auto only = [](const std::string& piece, const std::string& value) {
    return PiecewiseExpression{
        .cases = {{piece, parse_expression(value).value()}, {"*", parse_expression("0").value()}}};
  };
  Problem problem;
  problem.surface = room.surface;
  problem.triangulation.levels = {0};
  problem.method = Collocation{{.degree = degree, .alpha = Rational(1, 10)}};
  problem.reflectivity = only(room.receiver, "1/2");
  problem.emission = only("lamp", "1");
  problem.quadrature.tolerance = degree == 1 ? Rational(1, 10'000'000) : Rational(1, 1'000'000'000);
  return problem;
}

Problem with_events(Problem problem) {
  problem.triangulation.events = event_cut(problem, surface_of(problem));
  return problem;
}

/// The same elements, each chart turned so that its corners take each other's places: cut along as many
/// lines, which are no events.
Problem with_other_lines(Problem problem) {
  EventCut& cut = *problem.triangulation.events;
  std::vector<ParameterTriangle> coarse = *cut.coarse;
  for (ParameterTriangle& element : coarse) {
    for (ParameterPoint<double>& v : element.vertices) v = {v.t, 1 - v.s - v.t};
  }
  cut.coarse = std::make_shared<const std::vector<ParameterTriangle>>(std::move(coarse));
  problem.surface.mesh->digest += ", other lines";  // by which results are kept
  return problem;
}

/// The barycentric coordinates of the points of an element that are looked at: those whose value follows from
/// the values at its corners. Linear functions are known everywhere.
std::vector<std::array<double, 3>> looked_at(int degree) {
  const int parts = degree == 1 ? 4 : 1;
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j)
      points.push_back({static_cast<double>(i) / parts, static_cast<double>(j) / parts,
                        static_cast<double>(parts - i - j) / parts});
  return points;
}

/// The largest |u - u_n| over points of the receiver.
LevelErrors errors(const Bench& bench, const LitRoom& room, const Problem& problem, int first, int last) {
  const auto points = looked_at(find_triangle_basis(problem.method)->degree);
  const double radius =
      10 * problem.quadrature.tolerance.to_double();  // of entries, which sum to 1/2 at most
  return over_levels(levels_from(first, last), [&](int level) {
    Approximation error{.value = 0, .radius = radius};
    for (const ElementValue& element : bench.levels.level(problem, level).elements) {
      if (element.piece != room.receiver) continue;
      for (const auto& x : points) {
        Vector<double> p;
        double u_n = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          p = p + x.at(i) * element.corners.at(i);
          u_n += x.at(i) * element.corner_values.at(i);
        }
        if (!room.looked_at(p)) continue;
        const double u = 0.5 * light_past_boxes(p, room.normal, room.lamp, room.boxes);
        error.value = std::max(error.value, std::abs(u_n - u));
      }
    }
    return error;
  });
}

}  // namespace

Finding events_around_a_corner(const Bench& bench) {
  Finding finding;
  const LitRoom room = room_around_a_corner();
  for (const int degree : {1, 2}) {
    const std::string with = ", degree " + std::to_string(degree);
    const Problem uniform = problem_in(room, degree);
    const Problem cut = with_events(uniform);
    const Order smooth = Order::at_least(degree + 1, 1);
    const ObservedOrder seen = observed_order(errors(bench, room, cut, 0, 2));
    finding.require("order behind the corner, cut along events" + with, smooth, seen);
    // The largest error of a uniform mesh depends on where the kink crosses an element: one level more.
    if (degree == 1) {
      finding.require("order behind the corner, uniform" + with, Order::is(1, 0, 2),
                      observed_order(errors(bench, room, uniform, 1, 3)));
      finding.show(seen.exponent);
    }
    finding.control("order behind the corner, cut along other lines" + with, smooth,
                    observed_order(errors(bench, room, with_other_lines(cut), 0, 2)));
  }
  return finding;
}

Finding events_under_a_table(const Bench& bench) {
  Finding finding;
  const LitRoom room = room_with_a_table();
  const Problem uniform = problem_in(room, 1);
  const Problem cut = with_events(uniform);
  const Order smooth = Order::at_least(2, 1);
  const LevelErrors of_uniform = errors(bench, room, uniform, 0, 2);
  const LevelErrors of_cut = errors(bench, room, cut, 0, 2);
  const LevelErrors of_others = errors(bench, room, with_other_lines(cut), 2, 2);
  const ObservedOrder seen = observed_order(of_cut);
  finding.require("order on the floor, cut along events", smooth, seen);
  finding.control("order on the floor, uniform", smooth, observed_order(of_uniform));
  // Where kinks cross elements decides about the error of a level, so that three levels tell no order.
  const AtMost quarter{.value = of_uniform.errors.back().value / 4,
                       .slack = 0,
                       .why = "a quarter of the error of the uniform mesh of the same level"};
  finding.require("error on the floor at level 2, cut along events", quarter, of_cut.errors.back());
  finding.control("error on the floor at level 2, cut along as many other lines", quarter,
                  of_others.errors.back());
  finding.show(seen.exponent);
  return finding;
}

}  // namespace radcert::verification::radcert
