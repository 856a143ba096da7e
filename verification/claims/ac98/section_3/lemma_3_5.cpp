// SPDX-License-Identifier: GPL-3.0-or-later

// On the paraboloid z = |q|^2, with h = q - p = r e, |e| = 1: (Q-P).n_P = r^2/w(p), (P-Q).n_Q = r^2/w(q),
// w(q) = (1 + 4 |q|^2)^(1/2), and |P-Q|^2 = r^2 (1 + k^2), k = (p + q).e, so that G = 1/[w(p) w(q) (1 +
// k^2)^2]: smooth in r and e down to r = 0, though not in q. With e = (cos a, sin a) the derivatives by q
// times r^2 are sums of r^2 G_rr, r G_ra, G_aa, r G_r and G_a, which are bounded. G contains n_Q, that is
// first derivatives of the surface: D_Q^2 G needs its third ones. On z = x^2 + y^2 + |x|^(5/2), which is
// convex and C^2 but not C^3, D_Q^2 G grows without bound as Q nears the plane x = 0, far from P.
//
// For charts in C^3 on which |P-Q| >= m |p - q|, m > 0, the product rule gives (77): with r = |p - q|, A =
// (Q-P).n_P and its derivatives of order 1 and 2 by q are O(r^2), O(r) and O(1), as A and DA vanish at q =
// p; so are those of B = (P-Q).n_Q, as DB = (P-Q).Dn_Q, and D^2 B needs the second derivative of n_Q, the
// third one of the chart; those of |P-Q|^-4 are O(r^-4), O(r^-5), O(r^-6). Each term of D^2 (A B |P-Q|^-4)
// is O(r^-2).
//
// G is made of sums and products of P, Q, n_P, n_Q and 1/|P-Q|: off P = Q it is as smooth as the normals
// are, in C^(m-1) for charts in C^m, and analytic for analytic ones.
//
// Checked      equation_77: |P-Q|^2 |D_Q^2 G| <= 100 for second derivatives along all directions, the
//              spectral norm, all p with |p| <= 1/2 and r <= 1, by enclosures over boxes: p = (|p|, 0)
//              without loss, as the norm does not change with the axes. G of the formula against G of (2),
//              at points. lemma_3_5: on the second surface x^(1/2) |P-Q|^2 D_xx G, for all 0 < x <= 4^-20
//              at once, is not what tends to 0: unbounded, for y = 1/7, P = (1,0). With |x|^(7/2) it does.
//              section_2_kernel_smooth: the same surface, for "smooth" in the sense that the section gives
//              to S, C^2; D_x G is continuous there, and not on a surface of C^1 alone, |x|^(3/2).
// Not checked  (77) for all surfaces of C^3, but in these words.

#include <algorithm>

#include "radcert/geometry/vector.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/scalar/dual.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Once = Dual<Ball>;
using Twice = Dual<Once>;

Twice constant(const Ball& x) { return {Once{x, Ball(0), Ball(0)}, Once{}, Once{}}; }
Twice first_variable(const Ball& x) {
  return {Once{x, Ball(1), Ball(0)}, Once{Ball(1), Ball(0), Ball(0)}, Once{}};
}
Twice second_variable(const Ball& x) {
  return {Once{x, Ball(0), Ball(1)}, Once{}, Once{Ball(1), Ball(0), Ball(0)}};
}

// G on the paraboloid for p = (distance, 0) and q = p + r (cos a, sin a).
template <class T>
T kernel(const T& distance, const T& r, const T& a) {
  const T c = cos(a);
  const T s = sin(a);
  const T q_1 = distance + r * c;
  const T q_2 = r * s;
  const T one = T(1);
  const T four = T(4);
  const T w_p = sqrt(one + four * (distance * distance));
  const T w_q = sqrt(one + four * (q_1 * q_1 + q_2 * q_2));
  const T k = (distance + q_1) * c + q_2 * s;
  const T chord = one + k * k;
  return reciprocal(w_p * w_q * (chord * chord));
}

struct Bounds {
  Ball by_ss;  ///< |P-Q|^2 D_ss G
  Ball by_st;
  Ball by_tt;
  Ball distance;  ///< |P-Q|
};

Bounds second_derivatives(const Ball& distance, const Ball& r, const Ball& a) {
  const Twice g = kernel<Twice>(constant(distance), first_variable(r), second_variable(a));
  const Ball c = cos(a);
  const Ball s = sin(a);
  const Ball& r_a = g.by_s.by_t;
  const Ball& a_a = g.by_t.by_t;
  const Ball rr = r * r * g.by_s.by_s;
  const Ball mixed = Ball(2) * s * c * (r * r_a - g.by_t.value);
  const Ball turned = a_a + r * g.by_s.value;
  const Ball k = Ball(2) * distance * c + r;
  const Ball chord = Ball(1) + k * k;
  return {.by_ss = chord * (c * c * rr - mixed + s * s * turned),
          .by_st = chord * (s * c * (rr - turned) + (c * c - s * s) * (r * r_a - g.by_t.value)),
          .by_tt = chord * (s * s * rr + mixed + c * c * turned),
          .distance = r * sqrt(chord)};
}

// A box of |p| from 0 to 1/2, r from 0 to 1 and the angle, over pi, from 0 to 1: the other half turn is a
// mirror image.
struct BoundingBox {
  std::array<double, 3> low{0, 0, 0};
  std::array<double, 3> high{0.5, 1, 1};
};

// Whether the spectral norm of the matrix of all three, which is the largest second derivative along any
// direction, is at most c: |trace/2| plus the length of ((ss - tt)/2, st), compared by squares.
bool at_most(const Bounds& of, const Ball& c) {
  const Ball mean = abs(of.by_ss + of.by_tt) / Ball(2);
  const Ball half = (of.by_ss - of.by_tt) / Ball(2);
  const Ball rest = c - mean;
  return certainly_at_most(mean, c) && certainly_at_most(half * half + of.by_st * of.by_st, rest * rest);
}

bool below(const BoundingBox& box, const Ball& c) {
  const auto side = [&box](std::size_t i) { return hull(Ball(box.low.at(i)), Ball(box.high.at(i))); };
  return at_most(second_derivatives(side(0), side(1), Ball::pi() * side(2)), c);
}

// Boxes are halved, each side in turn, until the spectral norm is at most c, or the halving ends.
Rational boxes_not_below(const Ball& c) {
  constexpr int halvings = 24;
  constexpr long most = 1000;
  std::vector<std::pair<BoundingBox, int>> waiting{{BoundingBox{}, 0}};
  long count = 0;
  while (!waiting.empty() && count < most) {
    const auto [box, depth] = waiting.back();
    waiting.pop_back();
    if (below(box, c)) continue;
    if (depth == halvings) {
      ++count;
      continue;
    }
    const auto axis = static_cast<std::size_t>(depth % 3);
    const double middle = (box.low.at(axis) + box.high.at(axis)) / 2;
    BoundingBox first = box;
    BoundingBox second = box;
    first.high.at(axis) = middle;
    second.low.at(axis) = middle;
    waiting.emplace_back(first, depth + 1);
    waiting.emplace_back(second, depth + 1);
  }
  return {count};
}

Vector<Ball> on_the_paraboloid(const Ball& x, const Ball& y) { return {x, y, x * x + y * y}; }
Vector<Ball> inner_normal(const Ball& x, const Ball& y) {
  const Vector<Ball> n{-(Ball(2) * x), -(Ball(2) * y), Ball(1)};
  return reciprocal(norm(n)) * n;
}

// x^a and its first derivatives at a point, or a ball, x > 0.
struct Profile {
  Ball value;
  Ball first;
  Ball second;
  Ball third;
  Ball first_at_one;  ///< a
};

// x^(n/4), n >= 6.
Profile quarter_power(long n, const Ball& x) {
  const Ball root = sqrt(sqrt(x));
  const Rational a(n, 4);
  const auto part = [&](const Rational& factor, long fourths) {
    return Ball(factor) * power(root, static_cast<int>(n - fourths));
  };
  return {.value = part(1, 0),
          .first = part(a, 4),
          .second = part(a * (a - 1), 8),
          .third = part(a * (a - 1) * (a - 2), 12),
          .first_at_one = Ball(a)};
}

// On z = x^2 + y^2 + x^a for P = (1, 0) and Q = (x, 1/7): D_xx G is of the first degree in the third
// derivative of x^a, and all else is without it.
struct AtRoughPair {
  Ball first;   ///< D_x G
  Ball second;  ///< |P-Q|^2 D_xx G
};
AtRoughPair rough_pair(const Ball& x, const Profile& of) {
  const Twice s = first_variable(x);
  const Twice t = second_variable(Ball(Rational(1, 7)));
  const Twice zero = constant(Ball(0));
  const Twice one = constant(Ball(1));
  const Twice two = constant(Ball(2));
  const Twice added{Once{of.value, of.first, Ball(0)}, Once{of.first, of.second, Ball(0)}, Once{}};
  const Twice slope{Once{of.first, of.second, Ball(0)}, Once{of.second, of.third, Ball(0)}, Once{}};
  const Vector<Twice> q{s, t, s * s + t * t + added};
  const Vector<Twice> area_normal{-(two * s + slope), -(two * t), one};
  const Twice length = sqrt(dot(area_normal, area_normal));
  const Vector<Twice> n_q = reciprocal(length) * area_normal;
  const Vector<Twice> p{one, zero, two};
  const Twice bend = two + constant(of.first_at_one);  // the slope at x = 1
  const Vector<Twice> n_p = reciprocal(sqrt(one + bend * bend)) * Vector<Twice>{-bend, zero, one};
  const Vector<Twice> h = q - p;
  const Twice square = dot(h, h);
  const Twice g = dot(h, n_p) * dot(-h, n_q) / (square * square);
  return {.first = g.by_s.value, .second = square.value.value * g.by_s.by_s};
}

AtRoughPair pair_at_depth(long n, int depth) {
  const Ball x = power(Ball(2), -2 * depth);
  return rough_pair(x, quarter_power(n, x));
}
Ball at_depth(long n, int depth) { return pair_at_depth(n, depth).second; }

// x^(1/2) |P-Q|^2 D_xx G for all 0 < x <= 4^-depth at once, a = n/4 = 5/2 or 7/2: with root = x^(1/2) in [0,
// 2^-depth], x^(1/2) (G_0 + G_1 d) where d is the third derivative of x^a, G_0 the value for d = 0 and G_0 +
// G_1 that for d = 1, and d = c root^(n/2 - 6).
// D_x G is without the third derivative.
AtRoughPair near_the_plane(long n, int depth) {
  const Ball root = hull(Ball(0), power(Ball(2), -depth));
  const Ball x = root * root;
  const Rational a(n, 4);
  const int half = static_cast<int>(n / 2);
  Profile of{.value = power(root, half),
             .first = Ball(a) * power(root, half - 2),
             .second = Ball(a * (a - 1)) * power(root, half - 4),
             .third = Ball(0),
             .first_at_one = Ball(a)};
  const AtRoughPair without = rough_pair(x, of);
  of.third = Ball(1);
  const Ball slope = rough_pair(x, of).second - without.second;
  // x^(1/2) d.
  const Ball third = Ball(a * (a - 1) * (a - 2)) * power(root, half - 5);
  return {.first = without.first, .second = root * without.second + slope * third};
}
Ball scaled_near_the_plane(long n, int depth) { return near_the_plane(n, depth).second; }

// |x|^(n/4): 5/2, in C^2 and not in C^3; 7/2, in C^3; 9/4, less smooth than either; 3/2, not in C^2.
constexpr long five_halves = 10;
constexpr long seven_halves = 14;
constexpr long nine_quarters = 9;
constexpr long three_halves = 6;
constexpr int depth = 20;
constexpr int deep = 40;

// That x^(1/2) |P-Q|^2 D_xx G tends to 0 with x, as it does where D_xx G is bounded.
void require_bounded_second_derivatives(Finding& finding) {
  // Any bound c of |P-Q|^2 |D_Q^2 G| leaves x^(1/2) c, and c < 1000 less than this for x <= 4^-20.
  const AgreesWith vanishes{.value = Ball(0), .within = 1e-3};
  const std::string scaled = "x^(1/2) |P-Q|^2 D_xx G, ";
  finding.require(scaled + "all 0 < x <= 4^-20, z = x^2 + y^2 + |x|^(5/2), P = (1,0), Q = (x,1/7)", vanishes,
                  scaled_near_the_plane(five_halves, depth));
  finding.instead(scaled + "all 0 < x <= 4^-20, the same with |x|^(7/2)", vanishes,
                  scaled_near_the_plane(seven_halves, depth));
  finding.control(scaled + "x = 4^-40, the same with |x|^(9/4)", vanishes,
                  power(Ball(2), -deep) * at_depth(nine_quarters, deep));
}

}  // namespace

Finding equation_77(const Bench&) {
  const BallPrecision precision(64);
  constexpr int c = 100;
  Finding finding;
  const AtMost bound{.value = c, .slack = 0, .why = ""};
  const std::string boxes = "boxes where |P-Q|^2 |D_Q^2 G| was not shown to be at most ";
  finding.require(boxes + std::to_string(c), IsExactly{0}, boxes_not_below(Ball(c)));
  finding.control(boxes + "1", IsExactly{0}, boxes_not_below(Ball(1)));
  const Ball half(Rational(1, 2));
  for (const int exponent : {4, 8, 12}) {
    const Ball r(power(Rational(10), -exponent));
    const Ball a(1);
    const Bounds here = second_derivatives(half, r, a);
    const std::string at = ", |p| = 1/2, r = 1e-" + std::to_string(exponent);
    finding.require("|P-Q|^2 |D_ss G|" + at, bound, proved(abs(here.by_ss)));
    finding.control("|P-Q| |D_ss G|" + at, bound, proved(abs(here.by_ss) / here.distance));
  }
  for (const auto& [x, y] : {std::pair<Rational, Rational>{{1, 3}, {2, 5}}, {{-1, 2}, {1, 9}}}) {
    const Ball px = half;
    const Ball qx(x);
    const Ball qy(y);
    const Ball dx = qx - px;
    const Ball r = sqrt(dx * dx + qy * qy);
    const Ball angle = Ball(2) * atan(qy / (r + dx));
    const Ball direct = geometric_kernel<Ball>(on_the_paraboloid(px, Ball(0)), inner_normal(px, Ball(0)),
                                               on_the_paraboloid(qx, qy), inner_normal(qx, qy));
    finding.require("G by the formula, against (2), q = (" + x.to_text() + "," + y.to_text() + ")",
                    AgreesWith{.value = direct, .within = 1e-12}, kernel<Ball>(px, r, angle));
  }
  finding.show({.value = c, .radius = 0, .guaranteed = true});
  return finding;
}

Finding lemma_3_5(const Bench&) {
  const BallPrecision precision(512);
  Finding finding;
  const std::string of = ", z = x^2 + y^2 + |x|^(5/2), P = (1,0), Q = (x,1/7)";
  const std::string smooth = ", the same with |x|^(7/2)";
  const std::string rough = ", the same with |x|^(9/4)";
  const std::string scaled = "x^(1/2) |P-Q|^2 D_xx G, ";
  const Ball limit = scaled_near_the_plane(five_halves, depth);
  require_bounded_second_derivatives(finding);
  const AgreesWith none{.value = Ball(1), .within = 1e-3};
  const auto growth = [](long n) { return at_depth(n, deep + 1) / at_depth(n, deep); };
  const Ball found = growth(five_halves);
  finding.require("growth of D_xx G as x = 4^-40 is divided by 4, against none" + of, none, found);
  finding.instead("growth of D_xx G as x = 4^-40 is divided by 4" + smooth, none, growth(seven_halves));
  finding.control("growth of D_xx G as x = 4^-40 is divided by 4" + rough, none, growth(nine_quarters));
  // The limit is attained: one value from inside the range lies in its enclosure.
  const Ball inside = power(Ball(2), -deep) * at_depth(five_halves, deep);
  finding.require(scaled + "x = 4^-40, against the enclosure of all" + of,
                  AgreesWith{.value = limit, .within = 1e-4}, inside);
  for (const int k : {5, 10, 20, 40})
    finding.remark("|P-Q|^2 |D_xx G|, x = 4^-" + std::to_string(k), proved(abs(at_depth(five_halves, k))));
  finding.show(proved(found));
  return finding;
}

Finding section_2_kernel_smooth(const Bench&) {
  Finding finding;
  {
    const BallPrecision precision(512);
    require_bounded_second_derivatives(finding);
    const auto value_at = [](long n, int at) {
      return AgreesWith{.value = pair_at_depth(n, at).first, .within = 1e-4};
    };
    finding.instead("D_x G, all 0 < x <= 4^-20, against x = 4^-40, |x|^(5/2)", value_at(five_halves, deep),
                    near_the_plane(five_halves, depth).first);
    finding.control("D_x G, x = 4^-20, against x = 4^-40, |x|^(3/2)", value_at(three_halves, deep),
                    pair_at_depth(three_halves, depth).first);
  }
  const BallPrecision precision(64);
  constexpr int c = 100;
  finding.instead("boxes where |P-Q|^2 |D_Q^2 G| was not shown to be at most 100, paraboloid", IsExactly{0},
                  boxes_not_below(Ball(c)));
  finding.control("the same, at most 1", IsExactly{0}, boxes_not_below(Ball(1)));
  return finding;
}

}  // namespace radcert::verification::ac98
