// SPDX-License-Identifier: GPL-3.0-or-later

// The distance of sites, exactly: sites with rational points and normals.
//
// Checked      As printed, |p-> - q->| / max{0, p->.q->}: zero between different points of a plane. With the
//              points in the numerator: symmetric, positive at different points, never below |p - q|, and |p
//              - q| where the normals agree, at 2000 pairs. No metric: three sites on a line, normals turned
//              by the angle with the cosine 4/5 from one to the next: 5/4 and 5/4 against 50/7. Infinite
//              where the angle of the normals is 90 degrees or more and the points differ. "centroids with
//              the same orientation get more weight than centroids that are closer": always, or mostly? Not
//              where the cosine is at least the quotient of the distances, exactly. Figure 5 in a room of our own, a box: on the wall with the X both distances give the
//              colour 1/(1+d) of |p - q|; on the five other walls, floor and ceiling among them, the
//              normal-sensitive one gives 0 and the Euclidean one does not.
// Not checked  figure 5 itself. Where both points are one and the angle is 90 degrees or more (15) is 0/0.

#include <array>
#include <optional>

#include "radcert/meshless/radial_element.h"
#include "verification/claims/psg10/exact_sites.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr int pairs = 2000;

using ExactSite = Site<Rational>;

Rational squared_length(const Vector<Rational>& v) { return dot(v, v); }

/// A numerator and a denominator of the squared distance; infinite where the denominator alone is 0.
struct Fraction {
  Rational above;
  Rational below;
  [[nodiscard]] bool is_infinite() const { return below.sign() == 0 && above.sign() != 0; }
};

Fraction as_printed(const ExactSite& p, const ExactSite& q) {
  const Rational factor = normal_factor(p, q);
  return {squared_length(p.normal - q.normal), factor * factor};
}
Fraction with_points(const ExactSite& p, const ExactSite& q) {
  const Rational factor = normal_factor(p, q);
  return {squared_length(p.point - q.point), factor * factor};
}

/// Pairs of different points of the plane z = 0 that are at distance zero.
template <class Distance>
Rational apart_by_nothing(const Distance& distance) {
  ExactSites random(15);
  long total = 0;
  for (int k = 0; k < pairs; ++k) {
    const ExactSite p{{random.eighths(4), random.eighths(4), 0}, {0, 0, 1}};
    const ExactSite q{{random.eighths(4), random.eighths(4), 0}, {0, 0, 1}};
    if (!(p.point == q.point) && distance(p, q).above.sign() == 0) ++total;
  }
  return total;
}

/// Pairs for which `holds` is false, a third with normals that agree.
template <class Property>
Rational failing(const Property& holds) {
  ExactSites random(16);
  long total = 0;
  for (int k = 0; k < pairs; ++k) {
    const ExactSite p = random.in_space();
    ExactSite q = random.in_space();
    if (k % 3 == 0) q.normal = p.normal;
    if (!holds(p, q)) ++total;
  }
  return total;
}

/// Whether sqrt a + sqrt b < sqrt c.
bool sum_is_less(const Rational& a, const Rational& b, const Rational& c) {
  const Rational rest = c - a - b;
  return rest.sign() > 0 && Rational(4) * a * b < rest * rest;
}

/// Sites at 0, 1 and 2 of the x-axis, the normals turned by an angle from one to the next.
std::array<ExactSite, 3> turning(const Rational& cosine, const Rational& sine) {
  return {{{{0, 0, 0}, {0, 0, 1}},
           {{1, 0, 0}, {sine, 0, cosine}},
           {{2, 0, 0}, {Rational(2) * sine * cosine, 0, cosine * cosine - sine * sine}}}};
}

Rational breaks_the_inequality(const std::array<ExactSite, 3>& sites) {
  const auto& [p, q, r] = sites;
  return sum_is_less(squared_site_distance(p, q), squared_site_distance(q, r), squared_site_distance(p, r))
             ? 1
             : 0;
}

/// A point of a side of the box [0,4] x [0,3] x [0,2] with the inner normal; side 0 is the back wall, y = 3.
ExactSite of_box(ExactSites& random, int side) {
  const Rational x(random.below(33), 8);
  const Rational y(random.below(25), 8);
  const Rational z(random.below(17), 8);
  switch (side) {
    case 0: return {{x, 3, z}, {0, -1, 0}};
    case 1: return {{x, 0, z}, {0, 1, 0}};
    case 2: return {{0, y, z}, {1, 0, 0}};
    case 3: return {{4, y, z}, {-1, 0, 0}};
    case 4: return {{x, y, 0}, {0, 0, 1}};
    default: return {{x, y, 2}, {0, 0, -1}};
  }
}

const ExactSite& marked() {
  static const ExactSite x{{2, 3, 1}, {0, -1, 0}};
  return x;
}

/// Points of the other five sides that are not black, of 200 each.
template <class Distance>
Rational not_black(const Distance& distance) {
  ExactSites random(17);
  long total = 0;
  for (int side = 1; side < 6; ++side)
    for (int k = 0; k < 200; ++k) {
      const ExactSite p = of_box(random, side);
      if (!(p.point == marked().point) && !distance(p, marked()).is_infinite()) ++total;
    }
  return total;
}

/// Points of the back wall where the squared distance is not |p - q|^2, the wall's normals as they are or
/// turned.
Rational not_euclidean(const Vector<Rational>& normal) {
  ExactSites random(18);
  long total = 0;
  for (int k = 0; k < 200; ++k) {
    ExactSite p = of_box(random, 0);
    p.normal = normal;
    const Fraction d = with_points(p, marked());
    if (d.above != squared_length(p.point - marked().point) * d.below) ++total;
  }
  return total;
}

}  // namespace

Finding equation_15(const Bench&) {
  const auto of_one_coordinate = [](const ExactSite& p, const ExactSite& q) {
    const Rational step = p.point.x - q.point.x;
    return Fraction{step * step, 1};
  };
  Finding finding;
  finding.require("pairs of different points of a plane at distance zero, (15) as printed", IsExactly{0},
                  apart_by_nothing(as_printed));
  finding.instead("the same, (15) with the points in the numerator", IsExactly{0},
                  apart_by_nothing(with_points));
  finding.control("the same, one coordinate of the points in the numerator", IsExactly{0},
                  apart_by_nothing(of_one_coordinate));
  return finding;
}

Finding section_5_points(const Bench&) {
  Finding finding;
  finding.require("pairs of different points of a plane at distance zero", IsExactly{0},
                  apart_by_nothing(with_points));
  finding.control("pairs of different points of a plane at distance zero, (15) as printed", IsExactly{0},
                  apart_by_nothing(as_printed));
  finding.require("pairs whose distance is not symmetric", IsExactly{0},
                  failing([](const ExactSite& p, const ExactSite& q) {
                    const Fraction there = with_points(p, q);
                    const Fraction back = with_points(q, p);
                    return there.above == back.above && there.below == back.below;
                  }));
  finding.require("pairs nearer than |p - q|", IsExactly{0},
                  failing([](const ExactSite& p, const ExactSite& q) {
                    const Fraction d = with_points(p, q);
                    return d.above >= squared_length(p.point - q.point) * d.below;
                  }));
  finding.require("pairs with normals that agree and another distance than |p - q|", IsExactly{0},
                  failing([](const ExactSite& p, const ExactSite& q) {
                    return !(p.normal == q.normal) ||
                           squared_site_distance(p, q) == squared_length(p.point - q.point);
                  }));
  finding.control("pairs with another distance than |p - q|", IsExactly{0},
                  failing([](const ExactSite& p, const ExactSite& q) {
                    const Fraction d = with_points(p, q);
                    return d.above == squared_length(p.point - q.point) * d.below;
                  }));
  return finding;
}

Finding section_5_triangle(const Bench&) {
  Finding finding;
  const auto& [p, q, r] = turning(Rational(4, 5), Rational(3, 5));
  finding.require("|p,q|^2", IsExactly{Rational(25, 16)}, squared_site_distance(p, q));
  finding.require("|q,r|^2", IsExactly{Rational(25, 16)}, squared_site_distance(q, r));
  finding.require("|p,r|^2", IsExactly{Rational(2500, 49)}, squared_site_distance(p, r));
  finding.control("|p,r|^2 without the normals", IsExactly{Rational(2500, 49)},
                  squared_length(p.point - r.point));
  finding.require("whether |p,q| + |q,r| < |p,r|, normals turned by the angle of cosine 4/5", IsExactly{1},
                  breaks_the_inequality(turning(Rational(4, 5), Rational(3, 5))));
  finding.control("the same with equal normals", IsExactly{1}, breaks_the_inequality(turning(1, 0)));
  return finding;
}

Finding section_5_infinite(const Bench&) {
  const auto infinite_where = [](const Rational& largest_cosine) {
    return failing([&](const ExactSite& p, const ExactSite& q) {
      return p.point == q.point || dot(p.normal, q.normal) > largest_cosine ||
             with_points(p, q).is_infinite();
    });
  };
  Finding finding;
  finding.require("pairs with normals at 90 degrees or more at a finite distance", IsExactly{0},
                  infinite_where(0));
  finding.control("pairs with normals whose cosine is 1/4 or less at a finite distance", IsExactly{0},
                  infinite_where(Rational(1, 4)));
  return finding;
}

Finding section_5_orientation(const Bench&) {
  // p at 0, q with the normal of p at 2, r nearer with another normal: how often r is not farther than q by
  // the distance, over 1000 places and normals of r.
  const auto preferred = [](const auto& distance) {
    ExactSites random(19);
    const ExactSite p{{0, 0, 0}, {0, 0, 1}};
    const ExactSite q{{2, 0, 0}, {0, 0, 1}};
    long total = 0;
    for (int k = 0; k < 1000; ++k) {
      const ExactSite r{{Rational(1 + random.below(15), 8), 0, 0}, random.normal(3)};
      if (r.normal == p.normal) continue;
      const Fraction to_q = distance(p, q);
      const Fraction to_r = distance(p, r);
      if (to_r.above * to_q.below <= to_q.above * to_r.below) ++total;
    }
    return Rational(total);
  };
  // The same sites: how often r, at a with the cosine c, is not farther than q, or is, other than by 2 c >= a.
  const auto decided_otherwise = [] {
    ExactSites random(19);
    const ExactSite p{{0, 0, 0}, {0, 0, 1}};
    const ExactSite q{{2, 0, 0}, {0, 0, 1}};
    long total = 0;
    for (int k = 0; k < 1000; ++k) {
      const ExactSite r{{Rational(1 + random.below(15), 8), 0, 0}, random.normal(3)};
      const Fraction to_q = with_points(p, q);
      const Fraction to_r = with_points(p, r);
      const bool as_near = to_r.above * to_q.below <= to_q.above * to_r.below;
      if (as_near != (r.point.x <= Rational(2) * normal_factor(p, r))) ++total;
    }
    return Rational(total);
  };
  Finding finding;
  finding.instead("the same sites that get as much weight or more other than where a/2 <= c, (15)",
                  IsExactly{0}, decided_otherwise());
  // The sentence fails if a single nearer site gets as much weight, or, for a tendency, if half of them do.
  const auto fails = [](const Rational& as_near) {
    const double always = as_near.sign() > 0 ? 1 : 0;
    const double mostly = Rational(2) * as_near >= Rational(1000) ? 1 : 0;
    return Approximation::proved((always + mostly) / 2, (always - mostly) / 2);
  };
  const Equals no{.value = 0, .slack = 0, .why = "from always to mostly"};
  const auto euclidean = [](const ExactSite& a, const ExactSite& b) {
    return Fraction{squared_length(a.point - b.point), 1};
  };
  finding.require("whether nearer sites of another orientation get as much weight or more, (15)", no,
                  fails(preferred(with_points)));
  finding.remark("nearer sites of another orientation that get as much weight or more, (15), of 1000",
                 Approximation::exact(preferred(with_points).to_double()));
  finding.control("the same by the Euclidean distance", no, fails(preferred(euclidean)));
  return finding;
}

Finding figure_5(const Bench&) {
  const auto euclidean = [](const ExactSite& p, const ExactSite& q) {
    return Fraction{squared_length(p.point - q.point), 1};
  };
  Finding finding;
  finding.require("points of the other sides of a box that are not black", IsExactly{0},
                  not_black(with_points));
  finding.control("the same by the Euclidean distance", IsExactly{0}, not_black(euclidean));
  finding.require("points of the marked wall where the two distances differ", IsExactly{0},
                  not_euclidean({0, -1, 0}));
  finding.control("the same with the normals turned by the angle of cosine 4/5", IsExactly{0},
                  not_euclidean({Rational(3, 5), Rational(-4, 5), 0}));
  return finding;
}

}  // namespace radcert::verification::psg10
