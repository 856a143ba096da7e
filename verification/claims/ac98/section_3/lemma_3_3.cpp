// SPDX-License-Identifier: GPL-3.0-or-later

// Lemma 3.3 with a constant, for all functions: phi_0 the mean of Phi, phi_1 - phi_0 = g.(distance from the
// centre), g the mean of grad Phi, p_k Taylor polynomials of f about the centre. As L'p_1 = 0, Int phi_1
// L'p_2 = 0 and Int phi_0 L'p_3 = 0, L' = I - L,
//   Int Phi L'f = Int (Phi - phi_1) L'(f - p_1) + Int (phi_1 - phi_0) L'(f - p_2) + phi_0 Int L'(f - p_3).
// |d_x| + |d_y| <= h on the square, so that |f - p_k| <= h^(k+1)/(k+1)! |D^(k+1) f|; ||Phi - phi_1||_1 <=
// h^2 Int |D^2 Phi| and ||phi_1 - phi_0||_1 <= (h/2) Int |D Phi|; ||L'|| <= 1 + 7/3. So (65) holds with c
// = (10/3) max (1/2!, (1/2)/3!, 1/4!) = 5/3, for every h. On any parallelogram of two triangles of
// diameter h the sides and half the diagonals are no longer than h, so that 2^(1/2) h stands for h in
// these bounds and c = (10/3) 2 = 20/3: no shape enters. The inequalities are those of
// verification/claims/mean_value_bounds.h. Interpolation and nodes are carried by affine maps, so that
// what vanishes on the unit square vanishes on all parallelograms.
//
// (71) stands, but not for the reason given. L'p_2 is one polynomial on tau_1 and another on tau_2, so that
// (phi_1 - phi_0) L'p_2 is no polynomial on R, and the degree of precision of (59), which is one of
// polynomials on R, says nothing of it. What carries: phi_i L p_2 is quadratic on each triangle, so that the
// rule of precision 2 there integrates it exactly, and has the same values as for phi_i p_2, which is cubic
// on R and integrated exactly by (59).
//
// Checked      lemma_3_3, corollary_3_4_b: each step, exactly, on both diagonals, and the constants from
//              them; that the error of polynomials has no power of h below h^6, which is h^4 times the area,
//              and that h^6 is there. Both sides for products of monomials, down to an angle of 1e-8, which
//              no step uses. equation_66, equation_68: (66) and (67) with c = 1/(k+1)! and 1/k!, (68) with c
//              = 1. equation_69: the identity, B(Phi, f) = Int Phi L'f being bilinear. equation_70: L needs
//              the values at the nodes alone, where L p has those of p, for every alpha. equation_71: on the
//              unit square, both diagonals. The counterexample to the reason for (71).
// Not checked  that smooth functions are dense in W^(1,1) and W^(2,1).

#include <algorithm>

#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/scalar/real.h"
#include "verification/claims/ac98/collocation/interpolation_bounds.h"
#include "verification/claims/mean_value_bounds.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

const Rational& sixth() {
  static const Rational value(1, 6);
  return value;
}

struct Halves {
  std::vector<PlanarPoint> region;
  std::vector<PlanarTriangle> triangles;
};

// A parallelogram, given by its corners in order, cut along the diagonal from the first corner or from the
// second.
Halves halves(const std::vector<PlanarPoint>& p, bool from_the_first) {
  if (from_the_first) return {p, {{p.at(0), p.at(1), p.at(2)}, {p.at(0), p.at(2), p.at(3)}}};
  return {p, {{p.at(0), p.at(1), p.at(3)}, {p.at(1), p.at(2), p.at(3)}}};
}

std::vector<PlanarPoint> square(const Rational& h, const PlanarPoint& by) {
  return placed({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, h, by);
}

PlanarPoint centre(const std::vector<PlanarPoint>& p) {
  return {(p.at(0).x + p.at(2).x) / 2, (p.at(0).y + p.at(2).y) / 2};
}

const std::vector<PlanarPoint>& corners() {
  static const std::vector<PlanarPoint> all{{0, 0}, {1, 2}};
  return all;
}

const std::vector<Rational>& lengths() {
  static const std::vector<Rational> all{1000, 1, Rational(1, 1000)};
  return all;
}

// phi_0 and phi_1 of the introduction.
std::array<ExactPolynomial, 2> means(const ExactPolynomial& phi, const std::vector<PlanarPoint>& region) {
  const Rational area = ExactPolynomial(1).integral_over(region);
  const PlanarPoint middle = centre(region);
  const ExactPolynomial phi_0 = phi.integral_over(region) / area;
  const ExactPolynomial along_x = phi.by_x().integral_over(region) / area;
  const ExactPolynomial along_y = phi.by_y().integral_over(region) / area;
  return {phi_0, phi_0 + along_x * (ExactPolynomial::monomial(1, 0) - middle.x) +
                     along_y * (ExactPolynomial::monomial(0, 1) - middle.y)};
}

// Int phi (I - L) f over a region of the example, cut in two.
Rational error(const ExactPolynomial& phi, const ExactPolynomial& f, const Halves& r) {
  return interpolation_error(phi, f, r.triangles, sixth());
}

Halves example() { return halves(square(Rational(3, 4), {Rational(1, 3), 1}), true); }

std::vector<BoundedError> errors_on(const Halves& r) { return bounded_errors(r.triangles, r.region, 2); }

// Products of phi_i and p with Int phi L'p != 0 over the unit square.
Rational not_integrated(int degree_of_phi, int degree_of_p, bool from_the_first, const Rational& alpha) {
  const Halves unit = halves(square(1, {0, 0}), from_the_first);
  long count = 0;
  for (const ExactPolynomial& phi : monomials(degree_of_phi))
    for (const ExactPolynomial& p : monomials(degree_of_p))
      if (interpolation_error(phi, p, unit.triangles, alpha) != 0) ++count;
  return {count};
}

// B(Phi, f) less the right side of the introduction.
BilinearSum rest_of_the_introduction() {
  BilinearSum sum;
  sum.add({{"Phi", 1}}, {{"f", 1}});
  sum.add({{"Phi", 1}, {"phi_1", -1}}, {{"f", 1}, {"p_1", -1}}, -1);
  sum.add({{"phi_1", 1}, {"phi_0", -1}}, {{"f", 1}, {"p_2", -1}}, -1);
  sum.add({{"phi_0", 1}}, {{"f", 1}, {"p_3", -1}}, -1);
  return sum;
}

// What both bounds rest on: what L' annihilates, alone and under an integral, and the identity.
void require_steps(Finding& finding) {
  const IsExactly zero{0};
  for (const bool first : {true, false}) {
    const std::string cut = first ? ", cut from (0,0)" : ", cut from (1,0)";
    finding.require("products with Int phi_1 L'p_2 != 0" + cut, zero, not_integrated(1, 2, first, sixth()));
    finding.require("monomials p_3 with Int L'p_3 != 0" + cut, zero, not_integrated(0, 3, first, sixth()));
    finding.control("products with Int phi_1 L'p_3 != 0" + cut, zero, not_integrated(1, 3, first, sixth()));
    finding.control("monomials p_3 with Int L'p_3 != 0, alpha = 1/10" + cut, zero,
                    not_integrated(0, 3, first, Rational(1, 10)));
  }
  long not_reproduced = 0;
  for (const ExactPolynomial& p : monomials(1))
    if ((p - interpolant(example().triangles[0], sixth(), p)).size() != 0) ++not_reproduced;
  finding.require("monomials p_1 with L'p_1 != 0", zero, Rational(not_reproduced));
  BilinearSum rest = rest_of_the_introduction();
  rest.vanish("p_1");
  rest.vanish("p_3", "phi_0");
  finding.control("terms of Int Phi L'f less those three, where Int phi_1 L'p_2 is kept", zero, rest.size());
  rest.vanish("p_2", "phi_1");
  rest.vanish("p_2", "phi_0");
  finding.require(
      "terms of Int Phi L'f less Int (Phi - phi_1) L'(f - p_1) + Int (phi_1 - phi_0) L'(f - p_2) + "
      "phi_0 Int L'(f - p_3)",
      zero, rest.size());
  require_mean_values(finding, 1);
}

// The constant of parallelograms where the Taylor polynomials are about a corner, at most twice as far away.
Ball constant_about_a_corner() {
  const Ball side = sqrt(Ball(2));
  return Ball(bound_of_the_remainder()) * interpolation_factors<Ball>(1, 2, side, 2 * side).at(0);
}

// B(Phi, f) less the right side of (69), where the term of phi_1 - phi_0 may be left out.
BilinearSum rest_of_69(bool with_the_last) {
  BilinearSum sum;
  sum.add({{"Phi", 1}}, {{"f", 1}});
  sum.add({{"Phi", 1}}, {{"f", 1}, {"p_3", -1}}, -1);
  sum.add({{"Phi", 1}, {"phi_0", -1}}, {{"p_3", 1}, {"p_2", -1}}, -1);
  sum.add({{"Phi", 1}, {"phi_1", -1}}, {{"p_2", 1}, {"p_1", -1}}, -1);
  if (with_the_last) sum.add({{"phi_1", 1}, {"phi_0", -1}}, {{"p_2", 1}}, -1);
  sum.vanish("p_1");
  sum.vanish("p_3", "phi_0");
  return sum;
}

// Pairs i, j for which the numerator of l_i at q_j is not (1 - shrinkage alpha) delta_ij, as polynomials of
// alpha: l_1 = (u - alpha)/(1 - 3 alpha) and so on, (s,t,u) = (alpha, alpha, 1 - 2 alpha) and so on.
Rational wrong_at_the_nodes(int shrinkage) {
  const RationalPolynomial alpha = RationalPolynomial::variable();
  long count = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const RationalPolynomial coordinate = i == j ? 1 - 2 * alpha : alpha;
      if (coordinate - alpha != (i == j ? 1 - shrinkage * alpha : RationalPolynomial())) ++count;
    }
  return {count};
}

}  // namespace

Finding lemma_3_3(const Bench&) {
  Finding finding;
  for (const bool from_the_first : {true, false}) {
    const Halves unit = halves(square(1, {0, 0}), from_the_first);
    const std::string cut = from_the_first ? ", cut from (0,0)" : ", cut from (1,0)";
    finding.require("products phi f of degree up to 3 that are missed: terms of the error up to h^5" + cut,
                    IsExactly{0}, products_missed(3, unit.triangles, sixth()));
    finding.control("products phi f of degree up to 4 that are missed: h^6 stays" + cut, IsExactly{0},
                    products_missed(4, unit.triangles, sixth()));
    finding.control("products phi f of degree up to 3 that are missed by one of the triangles" + cut,
                    IsExactly{0}, products_missed(3, {unit.triangles[0]}, sixth()));
    finding.control("products phi f of degree up to 3 that are missed, alpha = 1/10" + cut, IsExactly{0},
                    products_missed(3, unit.triangles, Rational(1, 10)));
  }
  require_steps(finding);
  const std::vector<PlanarPoint> unit = square(1, {0, 0});
  finding.require("largest |d_x| + |d_y| about the centre, over h", IsExactly{1}, reach(unit, centre(unit)));
  finding.control("largest |d_x| + |d_y| about a corner, over h", IsExactly{1}, reach(unit, unit[0]));
  const Rational c(5, 3);
  finding.require("c = (1 + 7/3) max (1/2!, (1/2)/3!, 1/4!)", IsExactly{c}, constant_on_squares());
  // 10/3
  require_in_any_direction(finding, 2, {3, Rational(7, 2)});
  Rational largest = 0;
  for (const Rational& h : lengths())
    for (const PlanarPoint& by : corners()) {
      const std::vector<BoundedError> errors = errors_on(halves(square(h, by), true));
      finding.require("products beyond (65) with this c" + placed_at(h, by), IsExactly{0},
                      exceeding(errors, c * power(h, 4)));
      largest = std::max(largest, largest_ratio(errors) / power(h, 4));
    }
  const Rational tiny = power(Rational(10), -6);
  finding.control("products beyond (65) with h^5 for h^4" + placed_at(tiny, corners()[0]), IsExactly{0},
                  exceeding(errors_on(halves(square(tiny, corners()[0]), true)), c * power(tiny, 5)));
  finding.remark("largest error over h^4 and the bracket", proved(Ball(largest)));
  finding.show(proved(Ball(c)));
  return finding;
}

Finding corollary_3_4_b(const Bench&) {
  Finding finding;
  require_steps(finding);
  require_lengths(finding);
  const Rational c(20, 3);
  const Ball constant = constant_on_parallelograms();
  finding.require("c for every parallelogram", AgreesWith{Ball(c), 1e-15}, constant);
  finding.control("c by Taylor polynomials about a corner", AgreesWith{Ball(c), 1e-15},
                  constant_about_a_corner());
  for (const long thinness : {1L, 100L, 100000000L})
    for (const Rational& h : {Rational(1), Rational(1, 1000)}) {
      // Each half has the sides 1, at most 3/5 and at most 5/6: the diameter is h.
      const PlanarPoint tip{Rational(1, 3), Rational(1, 2 * thinness)};
      const std::vector<PlanarPoint> shape{{0, 0}, {1, 0}, {tip.x + 1, tip.y}, tip};
      for (const PlanarPoint& by : corners()) {
        const std::string at = ", height " + tip.y.to_text() + " of the diameter" + placed_at(h, by);
        const std::vector<BoundedError> errors = errors_on(halves(placed(shape, h, by), false));
        finding.require("products beyond (75) with c = 20/3" + at, IsExactly{0},
                        exceeding(errors, c * power(h, 4)));
      }
    }
  const Rational tiny = power(Rational(10), -6);
  finding.control("products beyond (75) with h^5 for h^4, squares" + placed_at(tiny, corners()[0]),
                  IsExactly{0},
                  exceeding(errors_on(halves(square(tiny, corners()[0]), true)), c * power(tiny, 5)));
  finding.show(proved(constant));
  return finding;
}

Finding equation_66(const Bench&) {
  constexpr long parts = 5;
  Finding finding;
  const auto points_beyond = [&](int k, const Rational& factor, const Rational& h, const PlanarPoint& by,
                                 bool difference_of_two) {
    const std::vector<PlanarPoint> region = square(h, by);
    const PlanarPoint middle = centre(region);
    Rational factorial = 1;
    for (int m = 2; m <= k; ++m) factorial *= m;
    long count = 0;
    for (const ExactPolynomial& f : monomials(6)) {
      const Rational of_k = largest_at(region, derivatives(f, k));
      const Rational next = largest_at(region, derivatives(f, k + 1));
      const ExactPolynomial difference =
          difference_of_two ? taylor(f, middle, k) - taylor(f, middle, k - 1) : f - taylor(f, middle, k);
      const Rational bound =
          difference_of_two ? factor * power(h, k) * (of_k / factorial + h * next / (factorial * (k + 1)))
                            : factor * power(h, k + 1) * next / (factorial * (k + 1));
      for (long i = 0; i <= parts; ++i)
        for (long j = 0; j <= parts; ++j) {
          const PlanarPoint p{by.x + h * Rational(i, parts), by.y + h * Rational(j, parts)};
          if (abs(difference(p)) > bound) ++count;
        }
    }
    return Rational(count);
  };
  const std::vector<PlanarPoint> unit = square(1, {0, 0});
  finding.require("largest |d_x| + |d_y| about the centre, over h", IsExactly{1}, reach(unit, centre(unit)));
  finding.control("largest |d_x| + |d_y| about a corner, over h", IsExactly{1}, reach(unit, unit[0]));
  const std::vector<Rational> constants{Rational(1, 2), Rational(1, 6), Rational(1, 24)};
  for (const int k : {1, 2, 3})
    finding.require("c in (66), and over h ||D^(k+1) f|| in (67), k = " + std::to_string(k),
                    IsExactly{constants.at(static_cast<std::size_t>(k - 1))}, taylor_factor(k));
  // p_k - p_(k-1) = (f - p_(k-1)) - (f - p_k): c = 1/k! by (66) for k - 1 and k.
  for (const int k : {2, 3})
    finding.require("c over ||D^k f|| in (67), k = " + std::to_string(k),
                    IsExactly{constants.at(static_cast<std::size_t>(k - 2))}, taylor_factor(k - 1));
  for (const Rational& h : {Rational(1), Rational(1, 1000)})
    for (const PlanarPoint& by : corners()) {
      for (const int k : {1, 2, 3}) {
        const std::string of = std::to_string(k);
        const std::string next = std::to_string(k + 1);
        finding.require("points with |f - p_" + of + "| > h^" + next + "/" + next + "! ||D^" + next + " f||" +
                            placed_at(h, by),
                        IsExactly{0}, points_beyond(k, 1, h, by, false));
        if (k == 1) continue;
        finding.require("points with |p_" + of + " - p_" + std::to_string(k - 1) + "| > h^" + of + "/" + of +
                            "! (||D^" + of + " f|| + h/" + next + " ||D^" + next + " f||)" + placed_at(h, by),
                        IsExactly{0}, points_beyond(k, 1, h, by, true));
      }
      if (h == 1) {
        finding.control("points with |f - p_1| > h^2/20 ||D^2 f||" + placed_at(h, by), IsExactly{0},
                        points_beyond(1, Rational(1, 10), h, by, false));
        finding.control("points with |p_2 - p_1| > a tenth of its bound" + placed_at(h, by), IsExactly{0},
                        points_beyond(2, Rational(1, 10), h, by, true));
      }
    }
  return finding;
}

Finding equation_68(const Bench&) {
  Finding finding;
  // area Int (phi - phi_i)^2 is at least ||phi - phi_i||_1^2.
  const auto beyond = [](std::size_t i, const Rational& c, int power_of_h) {
    long count = 0;
    for (const Rational& h : lengths())
      for (const PlanarPoint& by : corners()) {
        const std::vector<PlanarPoint> region = square(h, by);
        for (const ExactPolynomial& phi : monomials(5)) {
          const ExactPolynomial rest = phi - means(phi, region).at(i);
          Rational largest = 0;
          for (const ExactPolynomial& d : derivatives(phi, static_cast<int>(i) + 1))
            largest = std::max(largest, d.integral_over(region));
          const Rational bound = c * power(h, power_of_h) * largest;
          if (h * h * (rest * rest).integral_over(region) > bound * bound) ++count;
        }
      }
    return Rational(count);
  };
  require_mean_values(finding, 1);
  finding.require("monomials, h = 1000, 1, 1/1000, with ||phi - phi_0||_1 > h ||D phi||_1", IsExactly{0},
                  beyond(0, 1, 1));
  finding.control("the same with h^2 for h", IsExactly{0}, beyond(0, 1, 2));
  finding.require("monomials with ||phi - phi_1||_1 > h^2 ||D^2 phi||_1", IsExactly{0}, beyond(1, 1, 2));
  finding.control("the same with h^3 for h^2", IsExactly{0}, beyond(1, 1, 3));
  return finding;
}

Finding equation_69(const Bench&) {
  Finding finding;
  const IsExactly zero{0};
  finding.require("terms of Int Phi L'f less those of (69), where L'p_1 = 0 = Int phi_0 L'p_3", zero,
                  rest_of_69(true).size());
  finding.control("the same without the fourth term", zero, rest_of_69(false).size());
  long not_reproduced = 0;
  for (const ExactPolynomial& p : monomials(1))
    for (const PlanarTriangle& tau : example().triangles)
      if ((p - interpolant(tau, sixth(), p)).size() != 0) ++not_reproduced;
  finding.require("monomials p_1 and triangles with L'p_1 != 0", zero, Rational(not_reproduced));
  for (const bool first : {true, false}) {
    const std::string cut = first ? ", cut from (0,0)" : ", cut from (1,0)";
    finding.require("monomials p_3 with Int L'p_3 != 0" + cut, zero, not_integrated(0, 3, first, sixth()));
    finding.control("monomials p_3 with Int L'p_3 != 0, alpha = 1/10" + cut, zero,
                    not_integrated(0, 3, first, Rational(1, 10)));
  }
  return finding;
}

Finding equation_70(const Bench&) {
  Finding finding;
  const Halves r = example();
  const auto differing = [&](int degree_of_phi, const Rational& other) {
    long count = 0;
    for (const ExactPolynomial& phi : monomials(degree_of_phi))
      for (const ExactPolynomial& p_2 : monomials(2))
        for (const PlanarTriangle& tau : r.triangles) {
          const ExactPolynomial inner = interpolant(tau, other, p_2);
          if ((interpolant(tau, sixth(), phi * inner) - interpolant(tau, sixth(), phi * p_2)).size() != 0)
            ++count;
        }
    return Rational(count);
  };
  // Both sides are L of functions with the same values at the nodes.
  finding.require("pairs i, j with l_i(q_j) != delta_ij, as identities in alpha", IsExactly{0},
                  wrong_at_the_nodes(3));
  finding.control("the same with the denominator 1 - 2 alpha", IsExactly{0}, wrong_at_the_nodes(2));
  finding.require("products and triangles with L(phi_i L p_2) != L(phi_i p_2)", IsExactly{0},
                  differing(1, sixth()));
  finding.control("the same with other nodes, alpha = 1/10, for the inner L", IsExactly{0},
                  differing(1, Rational(1, 10)));
  return finding;
}

Finding equation_71(const Bench&) {
  Finding finding;
  for (const bool from_the_first : {true, false}) {
    const Halves r = halves(square(Rational(3, 4), {Rational(1, 3), 1}), from_the_first);
    const std::string cut = from_the_first ? ", first diagonal" : ", second diagonal";
    const auto left = [&](int degree_of_p) {
      long count = 0;
      for (const ExactPolynomial& phi : monomials(1))
        for (const ExactPolynomial& p : monomials(degree_of_p))
          if (error(phi, p, r) != 0) ++count;
      return Rational(count);
    };
    long right = 0;
    for (const ExactPolynomial& phi : monomials(1))
      for (const ExactPolynomial& p_2 : monomials(2))
        if (error(1, phi * p_2, r) != 0) ++right;
    finding.require("products of phi_i and p_2 with Int phi_i L'p_2 != 0" + cut, IsExactly{0}, left(2));
    finding.require("products with Int L'(phi_i p_2) != 0" + cut, IsExactly{0}, Rational(right));
    finding.control("products with Int phi_i L'p_3 != 0" + cut, IsExactly{0}, left(3));
    long alone = 0;
    for (const ExactPolynomial& phi : monomials(1))
      for (const ExactPolynomial& p_2 : monomials(2))
        if (interpolation_error(phi, p_2, r.triangles, Rational(1, 10)) != 0) ++alone;
    finding.control("products of phi_i and p_2 with Int phi_i L'p_2 != 0, alpha = 1/10" + cut, IsExactly{0},
                    Rational(alone));
  }
  return finding;
}

Finding equation_71_reason(const Bench&) {
  Finding finding;
  const Halves r = example();
  const auto two_pieces = [&](int degree) {
    long count = 0;
    for (const ExactPolynomial& p : monomials(degree))
      if ((interpolant(r.triangles[0], sixth(), p) - interpolant(r.triangles[1], sixth(), p)).size() != 0)
        ++count;
    return Rational(count);
  };
  finding.require("p_2 whose L'p_2 is not one polynomial on R", IsExactly{0}, two_pieces(2));
  // x^2 y on tau_1 and 0 on tau_2, for (59).
  const std::vector<PlanarPoint> first{r.triangles[0].begin(), r.triangles[0].end()};
  const Rational gap = missed(printed_rule(r.triangles[0], sixth()), first, 2, 1);
  finding.require("(59) less the integral, for x^2 y on tau_1 and 0 on tau_2", IsExactly{0}, gap);
  finding.control("p_3 whose L'p_3 is not one polynomial on R", IsExactly{0}, two_pieces(3));
  // What carries instead: each triangle's rule is exact for phi_i L p_2, a quadratic there.
  long inexact = 0;
  for (const ExactPolynomial& phi : monomials(1))
    for (const ExactPolynomial& p_2 : monomials(2))
      for (const PlanarTriangle& tau : r.triangles)
        if (interpolation_error(1, phi * interpolant(tau, sixth(), p_2), {tau}, sixth()) != 0) ++inexact;
  finding.require("products and triangles with Int phi_i L p_2 != Q(phi_i L p_2)", IsExactly{0},
                  Rational(inexact));
  finding.show(proved(Ball(gap)));
  return finding;
}

}  // namespace radcert::verification::ac98
