// SPDX-License-Identifier: GPL-3.0-or-later

// The triangulations of section 2: (11), (12), T1 to T3, (32)-(33), and the partition in the proof of Theorem
// 7.
//
// Checked      on the coarse triangulations of two_piece, sphere and ellipsoid and two refinements, in exact
//              arithmetic (the vertices are dyadic): h is halved by each refinement; m_k takes (0,0), (0,1),
//              (1,0) to v_1, v_2, v_3; T1, T2 and T3, each by itself and by hypotheses/conforming; the number
//              of shapes of triangles is that of the coarse ones, so that (33) holds; all but at most 2^L
//              triangles of each coarse one, L the level, are the halves of parallelograms. (12) is said to
//              be "an affine mapping": F_j after an affine mapping is affine only where F_j is. (33) has
//              curved triangles for the plane ones of (32), and the "radius of the circle" makes r(tau) = 2
//              sqrt 3 for the equilateral triangle. T3 is about two different triangles.
// Not checked  how charts meet across their seams, which is for the tests of the surfaces.

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "radcert/hypotheses/conforming.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using Corner = std::array<Rational, 2>;
using Triangle = std::array<Corner, 3>;
using Side = std::array<Corner, 2>;

struct Domain {
  std::string name;
  std::vector<Corner> corners;  ///< counterclockwise
  std::vector<Triangle> triangles;
};

std::vector<Triangle> triangles_of(const Surface& surface, int level, std::size_t chart) {
  std::vector<Triangle> triangles;
  for (const ParameterTriangle& each : triangulate(surface, level).triangles) {
    if (each.chart != chart) continue;
    Triangle exact;
    for (std::size_t i = 0; i < 3; ++i)
      exact[i] = {Rational::exactly(each.vertices[i].s), Rational::exactly(each.vertices[i].t)};
    triangles.push_back(exact);
  }
  return triangles;
}

constexpr int levels = 3;

// The first chart of each surface: the others have the same parameter triangles.
std::vector<Domain> domains(int level) {
  return {{"two_piece", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, triangles_of(two_piece(2), level, 0)},
          {"sphere", {{0, 0}, {1, 0}, {0, 1}}, triangles_of(sphere(), level, 0)},
          {"ellipsoid", {{0, 0}, {1, 0}, {0, 1}}, triangles_of(ellipsoid(1, 2, 5), level, 0)}};
}

std::string named(const Domain& domain, int level) {
  return ", " + domain.name + ", level " + std::to_string(level);
}

std::array<Side, 3> sides(const Triangle& t) {
  return {Side{t[0], t[1]}, Side{t[1], t[2]}, Side{t[2], t[0]}};
}

Rational twice_area(const Corner& a, const Corner& b, const Corner& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

Rational squared(const Side& side) {
  const Rational dx = side[1][0] - side[0][0];
  const Rational dy = side[1][1] - side[0][1];
  return dx * dx + dy * dy;
}

Rational squared_mesh_size(const Domain& domain) {
  Rational largest = 0;
  for (const Triangle& t : domain.triangles)
    for (const Side& side : sides(t)) largest = std::max(largest, squared(side));
  return largest;
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

template <class Count>
Finding on_all(const std::string& what, const std::string& of_control, const Domain& control,
               const Count& count) {
  Finding finding;
  for (int level = 0; level < levels; ++level)
    for (const Domain& domain : domains(level)) {
      finding.require(what + named(domain, level), IsExactly{0}, count(domain));
      finding.require("whether hypotheses/conforming refuses" + named(domain, level), IsExactly{0},
                      refused(domain));
    }
  finding.control(what + ", " + of_control, IsExactly{0}, count(control));
  finding.control("whether hypotheses/conforming refuses, " + of_control, IsExactly{0}, refused(control));
  return finding;
}

// The sides of a triangle divided by its shortest, squared and sorted: its shape.
std::array<Rational, 3> shape(const Triangle& t) {
  std::array<Rational, 3> lengths;
  for (std::size_t i = 0; i < 3; ++i) lengths[i] = squared(sides(t)[i]);
  std::sort(lengths.begin(), lengths.end());
  const Rational shortest = lengths[0];
  for (Rational& length : lengths) length /= shortest;
  return lengths;
}

// h(tau)/h*(tau): the longest side times half the perimeter over the area.
Ball ratio(const Triangle& t) {
  Ball longest = 0;
  Ball perimeter = 0;
  for (const Side& side : sides(t)) {
    const Ball length = sqrt(Ball(squared(side)));
    longest = max(longest, length);
    perimeter += length;
  }
  return longest * perimeter / Ball(abs(twice_area(t[0], t[1], t[2])));
}

Ball largest_ratio(const Domain& domain) {
  Ball largest = 0;
  for (const Triangle& t : domain.triangles) largest = max(largest, ratio(t));
  return largest;
}

// Of the triangles inside a coarse one, those that are left when pairs with a common side of one direction
// are taken out.
Rational unpaired(const std::vector<Triangle>& inside, const Side& parallel) {
  std::map<Side, long> common;
  for (const Triangle& t : inside)
    for (Side side : sides(t)) {
      const Rational turn = (side[1][0] - side[0][0]) * (parallel[1][1] - parallel[0][1]) -
                            (side[1][1] - side[0][1]) * (parallel[1][0] - parallel[0][0]);
      if (turn != 0) continue;
      std::sort(side.begin(), side.end());
      ++common[side];
    }
  return {static_cast<long>(
      std::count_if(common.begin(), common.end(), [](const auto& each) { return each.second == 1; }))};
}

}  // namespace

Finding equation_11(const Bench&) {
  Finding finding;
  const AgreesWith rounding{.value = Ball(0), .within = 0x1p-50};
  for (std::size_t d = 0; d < 2; ++d) {
    const Surface surface = d == 0 ? two_piece(2) : sphere();
    for (int level = 0; level < levels; ++level) {
      const Domain domain = domains(level).at(d);
      const Rational halves = power(Rational(4), level);
      finding.require("h^2" + named(domain, level), IsExactly{2 / halves}, squared_mesh_size(domain));
      finding.control("h^2" + named(domain, level) + ", against that of the next level",
                      IsExactly{1 / (2 * halves)}, squared_mesh_size(domain));
      finding.require("mesh_size - h" + named(domain, level), rounding,
                      Ball(mesh_size(triangulate(surface, level))) - sqrt(Ball(squared_mesh_size(domain))));
    }
  }
  return finding;
}

Finding equation_12(const Bench&) {
  Finding finding;
  const Surface surface = sphere();
  const ChartIn<Ball>& chart = surface.charts[0].in<Ball>();
  const auto at = [&](const Triangle& t, const Rational& s, const Rational& third) {
    const Rational u = 1 - s - third;
    const auto coordinate = [&](std::size_t c) { return Ball(u * t[0][c] + third * t[1][c] + s * t[2][c]); };
    return chart.frame({coordinate(0), coordinate(1)}).point;
  };
  const AgreesWith zero{.value = Ball(0), .within = 1e-25};
  const std::vector<Triangle> triangles = triangles_of(surface, 1, 0);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const Triangle& t = triangles[k];
    const std::string of = ", triangle " + std::to_string(k + 1) + " of the sphere";
    const auto vertex = [&](std::size_t i) { return chart.frame({Ball(t[i][0]), Ball(t[i][1])}).point; };
    const auto distance = [](const Vector<Ball>& a, const Vector<Ball>& b) {
      return abs(a.x - b.x) + abs(a.y - b.y) + abs(a.z - b.z);
    };
    finding.require("m_k(0,0) - F(v_1)" + of, zero, distance(at(t, 0, 0), vertex(0)));
    finding.require("m_k(0,1) - F(v_2)" + of, zero, distance(at(t, 0, 1), vertex(1)));
    finding.require("m_k(1,0) - F(v_3)" + of, zero, distance(at(t, 1, 0), vertex(2)));
    finding.control("m_k(1,0) - F(v_1)" + of, zero, distance(at(t, 1, 0), vertex(0)));
    const Rational half(1, 2);
    finding.control("m_k(1/2,1/2) less the mean of m_k(1,0) and m_k(0,1): not affine" + of, zero,
                    distance(at(t, half, half), Ball(half) * (at(t, 1, 0) + at(t, 0, 1))));
  }
  return finding;
}

Finding assumption_t1(const Bench&) {
  return on_all("corners of the domain that are no vertices", "one small triangle", shrunk(),
                missing_corners);
}

Finding assumption_t2(const Bench&) {
  return on_all("sides of the domain that no side of a triangle covers", "one triangle left out",
                without_its_first(domains(1).at(1)), uncovered_part);
}

Finding assumption_t3(const Bench&) {
  return on_all("pairs of triangles that meet in more or less than a common vertex or side",
                "one triangle cut in two", with_a_hanging_node(domains(2).at(1)), pairs_that_meet_wrongly);
}

Finding equation_33(const Bench&) {
  const BallPrecision precision(128);
  Finding finding;
  const AgreesWith coarse{.value = Ball(2) * sqrt(Ball(2)) * (Ball(1) + sqrt(Ball(2)) / Ball(2)),
                          .within = 1e-30};
  for (int level = 0; level < levels; ++level)
    for (const Domain& domain : domains(level)) {
      std::set<std::array<Rational, 3>> shapes;
      for (const Triangle& t : domain.triangles) shapes.insert(shape(t));
      finding.require("shapes of triangles" + named(domain, level), IsExactly{1},
                      Rational(static_cast<long>(shapes.size())));
      finding.require("largest r(tau)" + named(domain, level), coarse, largest_ratio(domain));
    }
  for (const int k : {1, 10, 20}) {
    const Rational thin = 1 / power(Rational(2), k);
    const Triangle flat{{{0, 0}, {1, 0}, {0, thin}}};
    finding.control("r(tau), a triangle with an angle near 2^-" + std::to_string(k), coarse, ratio(flat));
    // The longest side is at most half the perimeter, the area at most half the longest side times the
    // height.
    finding.require("1/angle - r(tau) there, with tan(angle) for the angle", AtMost{},
                    ac98::proved(Ball(1 / thin) - ratio(flat)));
  }
  return finding;
}

Finding theorem_7_partition(const Bench&) {
  Finding finding;
  for (int level = 0; level < levels + 2; ++level) {
    const Domain domain = domains(level).at(1);
    const Rational rest = power(Rational(2), level);
    for (std::size_t i = 0; i < 3; ++i) {
      const Side parallel{domain.corners[i], domain.corners[(i + 1) % 3]};
      const std::string of = ", sides parallel to side " + std::to_string(i + 1) + named(domain, level);
      finding.require("triangles in no parallelogram" + of, IsExactly{rest},
                      unpaired(domain.triangles, parallel));
    }
    if (level > 0)
      finding.control("triangles in no parallelogram, one triangle left out" + named(domain, level),
                      IsExactly{rest},
                      unpaired(without_its_first(domain).triangles, {domain.corners[0], domain.corners[1]}));
  }
  return finding;
}

}  // namespace radcert::verification::m06
