// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "radcert/visibility/events/visibility_events.h"
#include "radcert/visibility/scene.h"

namespace radcert::sample {

/// A closed room whose triangles face inwards, with one source and names of faces.
struct EventRoom {
  Scene scene;
  EventQuestion question;
  std::vector<std::string> names;  ///< of each triangle's face
};

/// Collects quadrilaterals whose corners run counterclockwise as seen from the light.
class RoomBuilder {
public:
  void quad(const std::string& name, const std::array<Vector<double>, 4>& corners) {
    const std::size_t first = mesh_.vertices.size();
    mesh_.vertices.insert(mesh_.vertices.end(), corners.begin(), corners.end());
    mesh_.triangles.push_back({first, first + 1, first + 2});
    mesh_.triangles.push_back({first, first + 2, first + 3});
    names_.insert(names_.end(), 2, name);
  }
  void triangle(const std::string& name, const std::array<Vector<double>, 3>& corners) {
    const std::size_t first = mesh_.vertices.size();
    mesh_.vertices.insert(mesh_.vertices.end(), corners.begin(), corners.end());
    mesh_.triangles.push_back({first, first + 1, first + 2});
    names_.push_back(name);
  }
  /// An axis-parallel box that looks outwards, or inwards, without one of its sides.
  void box(const std::string& name, const Vector<double>& low, const Vector<double>& high, bool inwards,
           const std::string& without = "") {
    const auto face = [&](const std::string& side, std::array<Vector<double>, 4> corners) {
      if (side == without) return;
      if (inwards) std::swap(corners[1], corners[3]);
      quad(name + side, corners);
    };
    const auto& [x, y, z] = low;
    const auto& [X, Y, Z] = high;
    face("bottom", {{{x, y, z}, {x, Y, z}, {X, Y, z}, {X, y, z}}});
    face("top", {{{x, y, Z}, {X, y, Z}, {X, Y, Z}, {x, Y, Z}}});
    face("south", {{{x, y, z}, {X, y, z}, {X, y, Z}, {x, y, Z}}});
    face("north", {{{x, Y, z}, {x, Y, Z}, {X, Y, Z}, {X, Y, z}}});
    face("west", {{{x, y, z}, {x, y, Z}, {x, Y, Z}, {x, Y, z}}});
    face("east", {{{X, y, z}, {X, Y, z}, {X, Y, Z}, {X, y, Z}}});
  }
  [[nodiscard]] EventRoom room(const std::string& source) const {
    EventRoom out{.scene = Scene(mesh_), .question = {}, .names = names_};
    for (const std::string& name : names_) {
      out.question.source.push_back(name == source ? std::optional<std::size_t>(0) : std::nullopt);
      out.question.receives.push_back(true);
    }
    return out;
  }

private:
  TriangleMesh mesh_;
  std::vector<std::string> names_;
};

/// A room of the size 4 x 4 x 3 with a lamp in the wall x = 0, a slab that hangs in it, and a post on that.
inline EventRoom room_with_a_post() {
  RoomBuilder walls;
  using Corners = std::array<Vector<double>, 4>;
  const auto ring = [&](const std::string& name, const Corners& outer, const Corners& inner) {
    for (std::size_t k = 0; k < 4; ++k)
      walls.quad(name, {outer.at(k), outer.at((k + 1) % 4), inner.at((k + 1) % 4), inner.at(k)});
  };
  const Corners lamp{{{0, 1.25, 0.5}, {0, 2.625, 0.5}, {0, 2.625, 1.75}, {0, 1.25, 1.75}}};
  walls.quad("lamp", lamp);
  ring("west", {{{0, 0, 0}, {0, 4, 0}, {0, 4, 3}, {0, 0, 3}}}, lamp);
  walls.quad("floor", {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}});
  walls.quad("ceiling", {{{0, 0, 3}, {0, 4, 3}, {4, 4, 3}, {4, 0, 3}}});
  walls.quad("south", {{{0, 0, 0}, {0, 0, 3}, {4, 0, 3}, {4, 0, 0}}});
  walls.quad("north", {{{0, 4, 0}, {4, 4, 0}, {4, 4, 3}, {0, 4, 3}}});
  walls.quad("east", {{{4, 0, 0}, {4, 0, 3}, {4, 4, 3}, {4, 4, 0}}});
  const Corners foot{{{2, 1.75, 1}, {2.25, 1.75, 1}, {2.25, 2.125, 1}, {2, 2.125, 1}}};
  ring("slab_top", {{{1.25, 1.125, 1}, {3, 1.125, 1}, {3, 3, 1}, {1.25, 3, 1}}}, foot);
  walls.box("slab_", {1.25, 1.125, 0.75}, {3, 3, 1}, false, "top");
  walls.box("post_", {2, 1.75, 1}, {2.25, 2.125, 1.5}, false, "bottom");
  return walls.room("lamp");
}

/// An L: x in [0,3] for y in [0,1], x in [0,1] for y in [1,3], z in [0,1]; the lamp is the part of the wall
/// x = 3 with y in [1/4,3/4] and z in [low,high]. All faces are cut along one grid.
inline EventRoom room_around_a_corner(double low, double high) {
  RoomBuilder walls;
  const std::vector<double> ys{0, 0.25, 0.75, 1, 3};
  std::vector<double> zs{0};
  if (low > 0) zs.push_back(low);
  if (high < 1) zs.push_back(high);
  zs.push_back(1);
  const auto ground = [&](double x, double X, double y, double Y) {
    walls.quad("floor", {{{x, y, 0}, {X, y, 0}, {X, Y, 0}, {x, Y, 0}}});
    walls.quad("ceiling", {{{x, y, 1}, {x, Y, 1}, {X, Y, 1}, {X, y, 1}}});
  };
  const auto wall = [&](const std::string& name, double x, double y, double X, double Y) {
    for (std::size_t k = 0; k + 1 < zs.size(); ++k) {
      const bool shines = name == "lamp" && zs[k] >= low && zs[k + 1] <= high;
      walls.quad(name == "lamp" && !shines ? "east" : name,
                 {{{x, y, zs[k]}, {X, Y, zs[k]}, {X, Y, zs[k + 1]}, {x, y, zs[k + 1]}}});
    }
  };
  for (std::size_t k = 0; k + 1 < ys.size(); ++k) {
    ground(0, 1, ys[k], ys[k + 1]);
    if (ys[k] < 1) ground(1, 3, ys[k], ys[k + 1]);
    if (ys[k] < 1) wall(k == 1 ? "lamp" : "east", 3, ys[k + 1], 3, ys[k]);
    wall("west", 0, ys[k], 0, ys[k + 1]);
  }
  wall("inner_east", 1, 3, 1, 1);
  wall("inner_south", 1, 1, 3, 1);
  wall("north", 0, 3, 1, 3);
  wall("south", 1, 0, 0, 0);
  wall("south", 3, 0, 1, 0);
  return walls.room("lamp");
}

/// A room of the size 4 x 4 x 3 with a triangular lamp in the ceiling, no side of which follows an axis.
inline RoomBuilder room_with_a_slanted_lamp() {
  RoomBuilder walls;
  const Vector<double> a{0, 0, 3}, b{4, 0, 3}, c{4, 4, 3}, d{0, 4, 3};
  const Vector<double> p{1.5, 1.375, 3}, q{2.5, 1.75, 3}, r{1.875, 2.5, 3};
  // From below counterclockwise.
  walls.triangle("lamp", {p, r, q});
  for (const auto& [u, v, w] : std::vector<std::array<Vector<double>, 3>>{
           {a, q, b}, {a, p, q}, {b, q, c}, {c, q, r}, {c, r, d}, {d, r, p}, {d, p, a}})
    walls.triangle("ceiling", {u, v, w});
  walls.quad("floor", {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}});
  walls.quad("south", {{{0, 0, 0}, {0, 0, 3}, {4, 0, 3}, {4, 0, 0}}});
  walls.quad("north", {{{0, 4, 0}, {4, 4, 0}, {4, 4, 3}, {0, 4, 3}}});
  walls.quad("west", {{{0, 0, 0}, {0, 4, 0}, {0, 4, 3}, {0, 0, 3}}});
  walls.quad("east", {{{4, 0, 0}, {4, 0, 3}, {4, 4, 3}, {4, 4, 0}}});
  return walls;
}

/// The same with a box that hangs below the lamp.
inline EventRoom room_with_a_box(const std::string& source = "lamp") {
  RoomBuilder walls = room_with_a_slanted_lamp();
  walls.box("box_", {1.25, 1.5, 1}, {2.5, 2.25, 1.5}, false);
  return walls.room(source);
}

/// The same with a tetrahedron, whose last corner is above the others, which run counterclockwise from above;
/// below it a box, or not.
inline EventRoom room_with_a_tetrahedron(const std::array<Vector<double>, 4>& v, bool over_a_box = false) {
  RoomBuilder walls = room_with_a_slanted_lamp();
  walls.triangle("body", {v[0], v[2], v[1]});
  walls.triangle("body", {v[0], v[1], v[3]});
  walls.triangle("body", {v[1], v[2], v[3]});
  walls.triangle("body", {v[2], v[0], v[3]});
  if (over_a_box) walls.box("box_", {1.25, 1.5, 0.5}, {2.5, 2.25, 0.75}, false);
  return walls.room("lamp");
}

}  // namespace radcert::sample
