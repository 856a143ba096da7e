// SPDX-License-Identifier: GPL-3.0-or-later
// Certified entries of scenes whose triangles hide each other. The judge cuts the pyramids over the other
// triangles out of the one that is looked at, in rational numbers, and takes Lambert's formula of what is
// left.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "radcert/collocation/certified/certified_visible_entries.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "tests/attack/attack.h"
#include "tests/attack/nasty_geometry.h"

namespace radcert::attack {
namespace {

/// Triangles that look to the side from which their corners run counterclockwise.
using Triangles = std::vector<Corners>;

TriangleMesh mesh_of(const Triangles& triangles) {
  TriangleMesh mesh;
  for (const Corners& c : triangles) {
    const std::size_t first = mesh.vertices.size();
    mesh.vertices.insert(mesh.vertices.end(), c.begin(), c.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

/// Corners on a small lattice: corners in line with sides, sides in one plane with the node, common corners;
/// now and then moved by a few units in the last place, or far away, or flat.
Triangles drawn(Draw& draw) {
  NastyGeometry nasty(draw);
  constexpr std::size_t most_tries = 200;
  const std::size_t count = 3 + draw.below(3);
  const bool moves = draw.below(3) == 0;
  const double flat = std::array{1.0, 1.0, 0x1p-30, 0x1p-10}[draw.below(4)];
  const double offset = std::array{0.0, 0.0, 0x1p30, 3.0}[draw.below(4)];
  Triangles triangles;
  for (std::size_t tries = 0; triangles.size() < count && tries < most_tries; ++tries) {
    Corners c;
    for (Point& a : c) {
      a = nasty.whole_point(3);
      // The first two face each other above and below the others.
      if (triangles.empty()) a.z = -9;
      if (triangles.size() == 1) a.z = 9 + std::floor(a.z / 4);
      a.z *= flat;
      a.x += offset;
      if (moves) a = nasty.nudged(a);
    }
    if (!triangles.empty() && draw.below(4) == 0)
      c[0] = triangles[draw.below(triangles.size())][draw.below(3)];
    if (is_degenerate(c)) continue;
    triangles.push_back(c);
    if (!scene_faults(mesh_of(triangles)).empty()) triangles.pop_back();
  }
  return triangles;
}

judge::Triple normal_of(const Corners& c) {
  return judge::cross(judge::minus(triple(c[1]), triple(c[0])), judge::minus(triple(c[2]), triple(c[0])));
}

judge::Triple centroid(const Corners& c) {
  judge::Triple sum = triple(c[0]);
  for (const std::size_t k : {1U, 2U})
    for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + triple(c[k])[i];
  for (Rational& x : sum) x = x / 3;
  return sum;
}

/// normal . (X - at) >= 0.
struct HalfSpace {
  judge::Triple normal;
  judge::Triple at;
};

/// The parts of a convex loop within the half space and without.
std::pair<judge::Loop, judge::Loop> parted(const judge::Polygon& plane, const judge::Loop& loop,
                                           const HalfSpace& half) {
  std::pair<judge::Loop, judge::Loop> parts;
  const auto height = [&](const judge::Pair& q) {
    return judge::dot(half.normal, judge::minus(plane.point(q), half.at));
  };
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const judge::Pair& a = loop[k];
    const judge::Pair& b = loop[(k + 1) % loop.size()];
    const Rational here = height(a);
    const Rational there = height(b);
    if (here.sign() >= 0) parts.first.push_back(a);
    if (here.sign() <= 0) parts.second.push_back(a);
    if (here.sign() * there.sign() >= 0) continue;
    const Rational share = here / (here - there);
    const judge::Pair cut{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
    parts.first.push_back(cut);
    parts.second.push_back(cut);
  }
  return parts;
}

/// What P does not see of the plane for a triangle between: the pyramid over it, beyond its plane. None where
/// P lies in its plane.
std::vector<HalfSpace> shadow(const Corners& c, const judge::Triple& p) {
  const judge::Triple normal = normal_of(c);
  const int side = judge::dot(normal, judge::minus(p, triple(c[0]))).sign();
  if (side == 0) return {};
  const auto turned = [](judge::Triple n, int sign) {
    for (Rational& x : n) x = Rational(sign) * x;
    return n;
  };
  std::vector<HalfSpace> halves{{turned(normal, -side), triple(c[0])}};
  for (std::size_t k = 0; k < 3; ++k) {
    const judge::Triple n =
        judge::cross(judge::minus(triple(c[k]), p), judge::minus(triple(c[(k + 1) % 3]), p));
    halves.push_back({turned(n, judge::dot(n, judge::minus(triple(c[(k + 2) % 3]), p)).sign()), p});
  }
  return halves;
}

/// Int G V dS over a triangle, from the centroid of another.
Ball seen_from(const Triangles& triangles, std::size_t observer, std::size_t target) {
  const judge::Triple p = centroid(triangles[observer]);
  const Corners& c = triangles[target];
  if (judge::dot(normal_of(c), judge::minus(p, triple(c[0]))).sign() <= 0) return 0;
  judge::Polygon polygon = judged(c);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    if (k == observer || k == target) continue;
    const std::vector<HalfSpace> halves = shadow(triangles[k], p);
    if (halves.empty()) continue;
    std::vector<judge::Loop> seen;
    for (judge::Loop rest : polygon.loops)
      for (const HalfSpace& half : halves) {
        if (rest.size() < 3) break;
        auto [inside, outside] = parted(polygon, rest, half);
        if (outside.size() > 2) seen.push_back(std::move(outside));
        rest = std::move(inside);
      }
    polygon.loops = std::move(seen);
  }
  return judge::lambert_integral(polygon, p, normal_of(triangles[observer]));
}

Judgement judge_entries(const Triangles& triangles) {
  if (triangles.size() < 2) return Judgement::refused();
  const Scene scene(mesh_of(triangles));
  const LagrangeFunctions functions = lagrange_functions(inset_nodes(0, Rational(0))).value();
  std::vector<SceneElement> elements;
  for (std::size_t k = 0; k < triangles.size(); ++k) elements.push_back({.triangle = k});
  const std::vector<double> rho(triangles.size(), 0.75);
  const Outcome<CertifiedEntries> found = certified_visible_entries(scene, elements, functions, rho);
  if (!found) return Judgement::refused();
  const BallPrecision precision(256);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < triangles.size(); ++j) {
      const Ball truth = i == j ? Ball(0) : Ball(0.75) / Ball::pi() * seen_from(triangles, i, j);
      if (!certainly_less(Ball(found->radius(i, j)), abs(truth - Ball(found->entries(i, j))))) continue;
      return Judgement::violated("entry " + std::to_string(i) + ", " + std::to_string(j) + ": " +
                                 shortest(found->entries(i, j)) + " +- " + shortest(found->radius(i, j)) +
                                 ", truth " + shortest(truth.to_double()));
    }
  return Judgement::held();
}

TEST(VisibleEntryAttack, OfTrianglesOnALattice) {
  hold(Attack<Triangles>{
      .name = "certified entries past occluders",
      .usual_instances = 40,
      .make = drawn,
      .judge = judge_entries,
      .text =
          [](const Triangles& triangles) {
            std::string all;
            for (const Corners& c : triangles) all += text(c) + "\n";
            return all;
          },
      .smaller =
          [](const Triangles& triangles) {
            std::vector<Triangles> all;
            for (std::size_t k = 0; k < triangles.size(); ++k) {
              all.push_back(triangles);
              all.back().erase(all.back().begin() + static_cast<std::ptrdiff_t>(k));
            }
            return all;
          },
  });
}

}  // namespace
}  // namespace radcert::attack
