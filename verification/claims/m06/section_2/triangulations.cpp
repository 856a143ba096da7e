// SPDX-License-Identifier: GPL-3.0-or-later

// T1 to T3 for the symmetric refinements of a triangulation that meets them, by induction over the levels.
// Let T_n be conforming. Two triangles meet in nothing, in a vertex or in a side, and so do their children
// across these: a child meets a side AB of its parent, a face, in the hull of those of its vertices that lie
// on it. If these are always some of {A}, {M}, {B}, {A,M}, {M,B}, M the middle, then children of different
// parents meet in a hull that belongs to both, as M depends on A and B alone and not on the parent. Children
// of one parent are an affine image of those of the unit triangle. The vertices of the parent are vertices of
// children (T1), and each side is the union of two sides of children (T2).
//
// Checked      exactly. The step: children of one parent, in pairs; their vertices on each side; the parent's
//              vertices; that the middle of A and B is that of B and A, for all points; that the library's
//              levels 1 to 4 are the children of those before, triangle by triangle. The beginning: the unit
//              triangle, and the unit square with either diagonal, which all of the catalogue's charts are
//              cut into; and levels 1 and 2 of them once more, by T1, T2 and T3 themselves and by
//              hypotheses/conforming. T3 is about two different triangles. Rejected: sides that are divided
//              at a third, a hanging node, a domain that is not covered.
// Not checked  here how charts meet: conformity_across_seams. T1 and T2 speak of vertices and edges of S: a
//              closed smooth surface has none, and of a piece with corners they are those of the domain.

#include <algorithm>
#include <set>
#include <vector>

#include "radcert/hypotheses/conforming.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "verification/claims/m06/section_2/symmetric_refinement.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using Side = std::array<Corner, 2>;

constexpr int levels = 3;

std::array<Side, 3> sides(const Triangle& t) {
  return {Side{t[0], t[1]}, Side{t[1], t[2]}, Side{t[2], t[0]}};
}

Rational squared(const Side& side) {
  const Rational dx = side[1][0] - side[0][0];
  const Rational dy = side[1][1] - side[0][1];
  return dx * dx + dy * dy;
}

// T1: corners of the domain that are no vertices.
Rational missing_corners(const Domain& domain) {
  std::set<Corner> vertices;
  for (const Triangle& t : domain.triangles) vertices.insert(t.begin(), t.end());
  return {static_cast<long>(std::count_if(domain.corners.begin(), domain.corners.end(),
                                          [&](const Corner& c) { return !vertices.contains(c); }))};
}

// T2: the length, as a part of the whole, of the domain's sides that no triangle's side lies on. Both are
// parallel: lengths along a side by its parameter.
Rational uncovered_part(const Domain& domain) {
  Rational uncovered = 0;
  for (std::size_t i = 0; i < domain.corners.size(); ++i) {
    const Corner& a = domain.corners[i];
    const Corner& b = domain.corners[(i + 1) % domain.corners.size()];
    const Rational length = squared({a, b});
    uncovered += 1;
    for (const Triangle& t : domain.triangles)
      for (const Side& side : sides(t)) {
        if (twice_area(a, b, side[0]) != 0 || twice_area(a, b, side[1]) != 0) continue;
        const auto along = [&](const Corner& c) {
          return ((c[0] - a[0]) * (b[0] - a[0]) + (c[1] - a[1]) * (b[1] - a[1])) / length;
        };
        uncovered -= abs(along(side[1]) - along(side[0]));
      }
  }
  return uncovered;
}

// Whether a point lies in a closed triangle that runs counterclockwise.
bool contains(const Triangle& t, const Corner& c) {
  return twice_area(t[0], t[1], c) >= 0 && twice_area(t[1], t[2], c) >= 0 && twice_area(t[2], t[0], c) >= 0;
}

// Whether a line through a side of `a` has all of b on its other side, or on it.
bool apart(const Triangle& a, const Triangle& b) {
  for (const Side& side : sides(a))
    if (std::all_of(b.begin(), b.end(),
                    [&](const Corner& c) { return twice_area(side[0], side[1], c) <= 0; }))
      return true;
  return false;
}

// T3: pairs of different triangles that meet in anything but a common vertex or a common side.
Rational pairs_that_meet_wrongly(const Domain& domain) {
  long count = 0;
  const std::vector<Triangle>& all = domain.triangles;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      // Vertices of one in the other that are not common; none, and interiors apart: only common faces are
      // left.
      const auto stray = [](const Triangle& a, const Triangle& b) {
        return std::any_of(a.begin(), a.end(), [&](const Corner& c) {
          return contains(b, c) && std::find(b.begin(), b.end(), c) == b.end();
        });
      };
      if (stray(all[i], all[j]) || stray(all[j], all[i]) || !(apart(all[i], all[j]) || apart(all[j], all[i])))
        ++count;
    }
  return {count};
}

Rational refused(const Domain& domain) {
  PolygonLoop loop;
  for (const Corner& c : domain.corners) loop.push_back({c[0], c[1]});
  std::vector<DomainTriangle> triangles;
  for (const Triangle& t : domain.triangles)
    triangles.push_back({ParameterPoint<Rational>{t[0][0], t[0][1]}, {t[1][0], t[1][1]}, {t[2][0], t[2][1]}});
  return {conforming(std::vector<PolygonLoop>{loop}, triangles) ? 0 : 1};
}

// One triangle cut into two at the middle of its first side, and its neighbours left alone.
Domain with_a_hanging_node(Domain domain) {
  const Triangle t = domain.triangles.front();
  // Of the sides the one that another triangle has too.
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner& a = t[i];
    const Corner& b = t[(i + 1) % 3];
    const Corner& c = t[(i + 2) % 3];
    const bool common =
        std::any_of(domain.triangles.begin() + 1, domain.triangles.end(), [&](const Triangle& other) {
          return std::find(other.begin(), other.end(), a) != other.end() &&
                 std::find(other.begin(), other.end(), b) != other.end();
        });
    if (!common) continue;
    const Corner middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    domain.triangles.front() = {a, middle, c};
    domain.triangles.push_back({middle, b, c});
    break;
  }
  return domain;
}

Domain without_its_first(Domain domain) {
  domain.triangles.erase(domain.triangles.begin());
  return domain;
}

// A triangle of half the size, far from the corners it had.
Domain shrunk() {
  const Rational half(1, 2);
  return {"a domain with one small triangle", {{0, 0}, {1, 0}, {0, 1}}, {{{{0, 0}, {half, 0}, {0, half}}}}};
}

const Rational third(1, 3);

Domain children_of_one(const Rational& part) {
  Domain domain{"children of one triangle", {{0, 0}, {1, 0}, {0, 1}}, {}};
  for (const Triangle& child : children<Rational>({{{0, 0}, {1, 0}, {0, 1}}}, part))
    domain.triangles.push_back(child);
  return domain;
}

// Of the children of a triangle: those with other vertices on a side than an end, the middle or a half of it,
// and the halves of sides that are not the side of one child.
Rational wrong_parts_of_sides(const Rational& part) {
  const Domain all = children_of_one(part);
  long count = 0;
  for (const Side& side : sides({{all.corners[0], all.corners[1], all.corners[2]}})) {
    const Corner middle{(side[0][0] + side[1][0]) / 2, (side[0][1] + side[1][1]) / 2};
    std::array<long, 2> halves{0, 0};
    for (const Triangle& child : all.triangles) {
      std::set<Corner> on_side;
      for (const Corner& c : child)
        if (twice_area(side[0], side[1], c) == 0) on_side.insert(c);
      const bool is_first = on_side == std::set<Corner>{side[0], middle};
      const bool is_second = on_side == std::set<Corner>{middle, side[1]};
      if (is_first) ++halves[0];
      if (is_second) ++halves[1];
      const bool is_point = on_side.size() == 1 && (on_side.contains(side[0]) || on_side.contains(side[1]) ||
                                                    on_side.contains(middle));
      if (!is_first && !is_second && !is_point && !on_side.empty()) ++count;
    }
    for (const long times : halves)
      if (times != 1) ++count;
  }
  return {count};
}

// A + part (B - A) less B + part (A - B), for any two points.
Rational terms_of_turned_division(const Rational& part) {
  const Polynomial a = Polynomial::variable("a");
  const Polynomial b = Polynomial::variable("b");
  return differing_terms(a + Polynomial(part) * (b - a), b + Polynomial(part) * (a - b));
}

// What all three have in common: the step of the induction, and the library.
template <class Count>
Finding by_induction(const std::string& what, const std::string& of_control, const Domain& control,
                     const Count& count) {
  const IsExactly none{0};
  Finding finding;
  finding.require("children with a part of a side other than a half, an end or the middle", none,
                  wrong_parts_of_sides(Rational(1, 2)));
  finding.control("the same, sides divided at a third", none, wrong_parts_of_sides(third));
  finding.require("terms of the middle of A and B less that of B and A", none,
                  terms_of_turned_division(Rational(1, 2)));
  finding.control("terms of the point at a third from A less that from B", none,
                  terms_of_turned_division(third));
  finding.require(what + ", the children of one triangle", none, count(children_of_one(Rational(1, 2))));
  for (const Surface& surface : {two_piece(2), sphere(), cylinder(1, 2)})
    finding.require("triangles of levels 1 to 4 that are not such children, " + surface.name, none,
                    differing_children(surface, 4));
  for (int level = 0; level < levels; ++level)
    for (const Domain& domain : domains(level)) {
      finding.require(what + named(domain, level), none, count(domain));
      finding.require("whether hypotheses/conforming refuses" + named(domain, level), none, refused(domain));
    }
  finding.control(what + ", " + of_control, none, count(control));
  finding.control("whether hypotheses/conforming refuses, " + of_control, none, refused(control));
  return finding;
}

}  // namespace

Finding assumption_t1(const Bench&) {
  return by_induction("corners of the domain that are no vertices", "one small triangle", shrunk(),
                      missing_corners);
}

Finding assumption_t2(const Bench&) {
  return by_induction("sides of the domain that no side of a triangle covers", "one triangle left out",
                      without_its_first(domains(1).at(2)), uncovered_part);
}

Finding assumption_t3(const Bench&) {
  return by_induction("pairs of triangles that meet in more or less than a common vertex or side",
                      "one triangle cut in two", with_a_hanging_node(domains(2).at(2)),
                      pairs_that_meet_wrongly);
}

}  // namespace radcert::verification::m06
