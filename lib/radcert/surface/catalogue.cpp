// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue.h"

#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/cone.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/octahedron.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/spherical_cap.h"
#include "radcert/surface/catalogue/tetrahedron.h"
#include "radcert/surface/catalogue/torus.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"

namespace radcert {
namespace {

ParameterDescription positive_length(std::string name, std::string default_text, std::string meaning = {}) {
  // Fourth powers of distances must neither overflow nor lose digits to underflow.
  const Rational largest = power(Rational(10), 60);
  return {.name = std::move(name),
          .requirement = "a number in [1e-60, 1e60]",
          .default_text = std::move(default_text),
          .admits = [largest](const Rational& length) { return length * largest >= 1 && length <= largest; },
          .meaning = std::move(meaning)};
}

/// Nearer to its ends a chart has its next singularity within a thousandth of its domain.
ParameterDescription inner_part(std::string name, std::string default_text, std::string meaning) {
  return {
      .name = std::move(name),
      .requirement = "a number in [1/1000, 999/1000]",
      .default_text = std::move(default_text),
      .admits = [](const Rational& part) { return part >= Rational(1, 1000) && part <= Rational(999, 1000); },
      .meaning = std::move(meaning)};
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
      {.name = "spherical_cap",
       .summary = "the cap of the unit sphere with a given part of its area, open at its rim, four charts",
       .parameters = {inner_part("fraction", "1/4", "of the sphere's area")},
       .pieces = {"cap"},
       .make = [](Values v) { return spherical_cap(v[0]); }},
      {.name = "cylinder",
       .summary = "the boundary of a circular cylinder, four charts a piece",
       .parameters = {positive_length("radius", "1"), positive_length("height", "2")},
       .pieces = {"floor", "ceiling", "mantle"},
       .make = [](Values v) { return cylinder(v[0], v[1]); }},
      {.name = "cone",
       .summary = "the boundary of a truncated cone, four charts a piece",
       .parameters = {positive_length("radius", "1"),
                      positive_length("top", "1/2", "the radius of the upper end"),
                      positive_length("height", "1")},
       .pieces = {"floor", "ceiling", "mantle"},
       .make = [](Values v) { return cone(v[0], v[1], v[2]); }},
      {.name = "paraboloid_cap",
       .summary = "the boundary of 0 <= z <= 1 - x^2 - y^2, four charts a piece",
       .parameters = {},
       .pieces = {"floor", "cap"},
       .make = [](Values) { return paraboloid_cap(); }},
      {.name = "tetrahedron",
       .summary = "the boundary of the regular tetrahedron with corners in four of those of [-1,1]^3",
       .parameters = {},
       .pieces = {"face_mmm", "face_mpp", "face_pmp", "face_ppm"},
       .make = [](Values) { return tetrahedron(); }},
      {.name = "octahedron",
       .summary = "the boundary of |x| + |y| + |z| <= 1",
       .parameters = {},
       .pieces = {"face_ppp", "face_mpp", "face_pmp", "face_mmp", "face_ppm", "face_mpm", "face_pmm",
                  "face_mmm"},
       .make = [](Values) { return octahedron(); }},
      {.name = "torus",
       .summary = "the torus of that radius, its tube ratio times as wide; parts hide others: not for solve",
       .parameters = {positive_length("radius", "1"),
                      inner_part("ratio", "1/2", "of the tube's radius to the other")},
       .pieces = {"torus"},
       .make = [](Values v) { return torus(v[0], v[1]); },
       .unoccluded = false},
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
