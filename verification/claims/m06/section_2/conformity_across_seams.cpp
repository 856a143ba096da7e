// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulations of the R_j, mapped by the F_j, are a triangulation of S where charts that have a side in
// common map it alike, point by point, and cut it alike. (10) asks for neither.
//
// Checked      in exact arithmetic, by the formulas that the library's charts are made of: each side of a
//              chart, as a function of tau along it, is that of exactly one side of another chart, run
//              through in the same or in the opposite sense. Symmetric refinement divides both at the same
//              tau, so that vertices and sides of triangles agree along them at every level. Sphere, torus of
//              radius 1 and tube radius 1/2, cylinder of radius 1 and height 2. An ellipsoid is the sphere
//              with its coordinates stretched, and so are its seams: (1,2,5) is looked at besides. The pieces
//              of two_piece do not meet. Rejected: a chart that runs through its sides with another speed; a
//              surface with a chart left out.
// Not checked  whether charts meet elsewhere than in whole sides; other surfaces.

#include <array>
#include <functional>
#include <vector>

#include "radcert/surface/catalogue/cone.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/torus.h"
#include "radcert/surface/exact_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using Image = Vector<ExactFunction>;
using Map = std::function<Image(const ExactFunction& s, const ExactFunction& t)>;

struct Patch {
  ChartDomain domain;
  Map map;
};

struct Patches {
  std::string name;
  std::vector<Patch> all;
};

template <template <class> class Formula, class... Parameters>
Patch patch(ChartDomain domain, const Parameters&... parameters) {
  return {domain, [formula = Formula<ExactFunction>(parameters...)](
                      const ExactFunction& s, const ExactFunction& t) { return formula(s, t); }};
}

Patches ellipsoid_patches(const std::string& name, const Rational& a, const Rational& b, const Rational& c) {
  Patches patches{name, {}};
  for (const int z : {1, -1})
    for (const int y : {1, -1})
      for (const int x : {1, -1})
        patches.all.push_back(patch<EllipsoidOctant>(ChartDomain::unit_triangle, a, b, c, Octant{x, y, z}));
  return patches;
}

Patches torus_patches() {
  Patches patches{"torus", {}};
  for (const Quadrant& around : quadrants())
    for (const Quadrant& of_tube : quadrants())
      patches.all.push_back(
          patch<TorusPatch>(ChartDomain::unit_square, Rational(1), Rational(1, 2), around, of_tube));
  return patches;
}

Patches cylinder_patches() {
  const Rational radius = 1;
  const Rational height = 2;
  Patches patches{"cylinder", {}};
  for (const Quadrant& quadrant : quadrants()) {
    patches.all.push_back(patch<DiskQuadrant>(ChartDomain::unit_triangle, radius, Rational(0), quadrant));
    patches.all.push_back(patch<DiskQuadrant>(ChartDomain::unit_triangle, radius, height, quadrant));
    patches.all.push_back(patch<ConeMantle>(ChartDomain::unit_square, radius, radius, height, quadrant));
  }
  return patches;
}

// The images of the sides, tau from 0 to 1 and back. The variable of ExactFunction is s, for tau.
struct SideImage {
  Image forwards;
  Image backwards;
};

std::vector<SideImage> sides(const Patch& patch) {
  std::vector<std::array<long, 2>> corners{{0, 0}, {1, 0}, {0, 1}};
  if (patch.domain == ChartDomain::unit_square) corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto along = [&patch](const std::array<long, 2>& from, const std::array<long, 2>& to) {
    const auto coordinate = [&](std::size_t c) {
      return ExactFunction(from[c]) + ExactFunction(to[c] - from[c]) * ExactFunction::s();
    };
    return patch.map(coordinate(0), coordinate(1));
  };
  std::vector<SideImage> images;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& from = corners[i];
    const auto& to = corners[(i + 1) % corners.size()];
    images.push_back({along(from, to), along(to, from)});
  }
  return images;
}

bool same(const Image& a, const Image& b) {
  return (a.x - b.x).is_zero() && (a.y - b.y).is_zero() && (a.z - b.z).is_zero();
}

// Sides of charts that are not the side of exactly one other chart.
Rational sides_without_one_partner(const Patches& patches) {
  std::vector<std::vector<SideImage>> images;
  for (const Patch& each : patches.all) images.push_back(sides(each));
  long count = 0;
  for (std::size_t i = 0; i < images.size(); ++i)
    for (const SideImage& side : images[i]) {
      long partners = 0;
      for (std::size_t j = 0; j < images.size(); ++j) {
        if (i == j) continue;
        for (const SideImage& other : images[j])
          if (same(side.forwards, other.forwards) || same(side.forwards, other.backwards)) ++partners;
      }
      if (partners != 1) ++count;
    }
  return {count};
}

// The first chart after (s,t) -> (s^2, t).
Patches with_another_speed(Patches patches) {
  patches.name += ", one chart after (s,t) -> (s^2,t)";
  patches.all.front().map = [map = patches.all.front().map](const ExactFunction& s, const ExactFunction& t) {
    return map(s * s, t);
  };
  return patches;
}

Patches without_the_first(Patches patches) {
  patches.name += ", one chart left out";
  patches.all.erase(patches.all.begin());
  return patches;
}

}  // namespace

Finding conformity_across_seams(const Bench&) {
  const IsExactly none{0};
  const std::string what = "sides of charts that are not the side of exactly one other, point by point, ";
  Finding finding;
  const Patches torus = torus_patches();
  for (const Patches& patches : {ellipsoid_patches("sphere", 1, 1, 1),
                                 ellipsoid_patches("ellipsoid (1,2,5)", 1, 2, 5), torus, cylinder_patches()})
    finding.require(what + patches.name, none, sides_without_one_partner(patches));
  for (const Patches& patches : {with_another_speed(torus), without_the_first(torus)})
    finding.control(what + patches.name, none, sides_without_one_partner(patches));
  return finding;
}

}  // namespace radcert::verification::m06
