// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue.h"

#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"

namespace radcert {
namespace {

ParameterDescription positive_length(std::string name, std::string default_text) {
  // Fourth powers of distances must neither overflow nor lose digits to underflow.
  const Rational largest = power(Rational(10), 60);
  return {.name = std::move(name),
          .requirement = "a number in [1e-60, 1e60]",
          .default_text = std::move(default_text),
          .admits = [largest](const Rational& length) { return length * largest >= 1 && length <= largest; }};
}

std::vector<ParameterDescription> half_axes_or_sides() {
  return {positive_length("a", "1"), positive_length("b", "2"), positive_length("c", "5")};
}

// Beyond it the roof falls within a layer at x = 1 that no rule of the coarse triangulation would see.
constexpr long largest_power = 1000;

std::vector<SurfaceDescription> all_surfaces() {
  using Values = std::span<const Rational>;
  return {
      {.name = "two_squares",
       .summary = "two unit squares at a right angle along an edge [ac98, (20)]",
       .parameters = {},
       .pieces = {"xz", "xy"},
       .make = [](Values) { return two_squares(); }},
      {.name = "two_piece",
       .summary = "the unit square below the roof z = 2 - x^p [ac98, (94)]",
       .parameters = {{.name = "p",
                       .requirement = "a number in [1, 1000]",
                       .default_text = "2",
                       .admits = [](const Rational& p) { return p >= 1 && p <= largest_power; }}},
       .pieces = {"lower", "upper"},
       .make = [](Values v) { return two_piece(v[0]); }},
      {.name = "cube",
       .summary = "the boundary of the unit cube [ac98, section 5]",
       .parameters = {},
       .pieces = {"west", "east", "south", "north", "floor", "ceiling"},
       .make = [](Values) { return cube(); }},
      {.name = "box",
       .summary = "the boundary of [0,a] x [0,b] x [0,c] [ac98, section 2.2]",
       .parameters = half_axes_or_sides(),
       .pieces = {"west", "east", "south", "north", "floor", "ceiling"},
       .make = [](Values v) { return box(v[0], v[1], v[2]); }},
      {.name = "sphere",
       .summary = "the unit sphere, eight charts",
       .parameters = {},
       .pieces = {"sphere"},
       .make = [](Values) { return sphere(); }},
      {.name = "ellipsoid",
       .summary = "the ellipsoid with half axes a, b, c, eight charts [ac98, section 3]",
       .parameters = half_axes_or_sides(),
       .pieces = {"ellipsoid"},
       .make = [](Values v) { return ellipsoid(v[0], v[1], v[2]); }},
  };
}

}  // namespace

const std::vector<SurfaceDescription>& surface_catalogue() {
  static const std::vector<SurfaceDescription> surfaces = all_surfaces();
  return surfaces;
}

const SurfaceDescription* find_surface(std::string_view name) {
  for (const SurfaceDescription& surface : surface_catalogue())
    if (surface.name == name) return &surface;
  return nullptr;
}

}  // namespace radcert
