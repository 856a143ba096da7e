// SPDX-License-Identifier: GPL-3.0-or-later

// Lemma 3.2 with a constant, for all functions: let phi_0 be the mean of Phi, p_k the Taylor polynomials of f
// about the middle of the hypotenuse. As L'p_1 = 0 and Int L'p_2 = 0, L' = I - L,
//   Int Phi L'f = Int (Phi - phi_0) L'(f - p_1) + phi_0 Int L'(f - p_2).
// There |d_x| + |d_y| <= h, so that |f - p_k| <= h^(k+1)/(k+1)! |D^(k+1) f|; ||Phi - phi_0||_1 <= h Int |D
// Phi|; ||L'|| <= 1 + 7/3. So (60) holds with c = (10/3)(1/2) = 5/3, for every h. It does without the step of
// the printed proof that takes h ||D^3 f|| into the constant, which needs bounded h. On any triangle of
// diameter h, with Taylor polynomials about the centroid, |d_x| + |d_y| <= 2^(1/2) (2/3) h and ||Phi -
// phi_0||_1 <= 2^(1/2) h Int |D Phi|, so that c = (10/3) 2^(1/2) (4/9) < 21/10, and no shape enters. The
// inequalities are those of verification/claims/mean_value_bounds.h. Interpolation and nodes are carried from
// triangle to triangle by (56), so that what vanishes on one vanishes on all.
//
// Checked      lemma_3_2, corollary_3_4_a: each step, exactly, and the constants from them; that the error of
//              polynomials has no power of h below h^5, which is h^3 times the area, and that h^5 is there.
//              Both sides for products of monomials, down to an angle of 1e-8, which no step uses.
//              equation_61: (61) and (62) with c = 1/(k+1)!, reached by (d_x + d_y)^(k+1). equation_63: (63)
//              with c = 1. equation_64: the identity, B(Phi, f) = Int Phi L'f being bilinear, and that its
//              third term is 0 by (58).
// Not checked  that smooth functions are dense in W^(1,1). Legs that are not along the axes: c is then that
//              of corollary_3_4_a, as the largest derivative depends on the axes.

#include "radcert/scalar/real.h"
#include "verification/claims/ac98/collocation/interpolation_bounds.h"
#include "verification/claims/mean_value_bounds.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

const std::vector<PlanarPoint>& right_triangle() {
  static const std::vector<PlanarPoint> points{{0, 0}, {1, 0}, {0, 1}};
  return points;
}

PlanarTriangle triangle(const std::vector<PlanarPoint>& p) { return {p.at(0), p.at(1), p.at(2)}; }

std::vector<BoundedError> errors_on(const std::vector<PlanarPoint>& points) {
  return bounded_errors({triangle(points)}, points, 1);
}

const std::vector<Rational>& lengths() {
  static const std::vector<Rational> all{1000, 1, Rational(1, 8), Rational(1, 1000)};
  return all;
}

std::vector<PlanarPoint> between(const PlanarPoint& a, const PlanarPoint& b) {
  constexpr long parts = 24;
  std::vector<PlanarPoint> points;
  for (long i = 0; i <= parts; ++i) {
    const Rational c(i, parts);
    points.push_back({a.x + c * (b.x - a.x), a.y + c * (b.y - a.y)});
  }
  return points;
}

// Lattice points of the right triangle where |f - p_k| > c (|d_x| + |d_y|)^(k+1) |D^(k+1) f|, f over
// monomials.
Rational points_beyond_taylor(int k, const Rational& c, const std::vector<PlanarPoint>& corners,
                              const PlanarPoint& about) {
  constexpr long parts = 6;
  long count = 0;
  for (const ExactPolynomial& f : monomials(6)) {
    const ExactPolynomial difference = f - taylor(f, about, k);
    // Derivatives of monomials grow with x and y: their maxima lie on the hypotenuse.
    const Rational largest = largest_at(between(corners.at(1), corners.at(2)), derivatives(f, k + 1));
    for (long i = 0; i <= parts; ++i)
      for (long j = 0; i + j <= parts; ++j) {
        const Rational s(i, parts);
        const Rational t(j, parts);
        const PlanarPoint p{
            corners[0].x + s * (corners[1].x - corners[0].x) + t * (corners[2].x - corners[0].x),
            corners[0].y + s * (corners[1].y - corners[0].y) + t * (corners[2].y - corners[0].y)};
        const Rational d = abs(p.x - about.x) + abs(p.y - about.y);
        if (abs(difference(p)) > c * power(d, k + 1) * largest) ++count;
      }
  }
  return {count};
}

// (d_x + d_y)^(k+1) at the right angle over h^(k+1) times its derivative of order k + 1, which is constant.
Rational reached_by_taylor(int k) {
  const PlanarPoint middle{Rational(1, 2), Rational(1, 2)};
  ExactPolynomial f(1);
  for (int i = 0; i <= k; ++i)
    f = f * (ExactPolynomial::monomial(1, 0) + ExactPolynomial::monomial(0, 1) - Rational(1));
  return abs((f - taylor(f, middle, k))(PlanarPoint{0, 0})) / largest_at({middle}, derivatives(f, k + 1));
}

// Monomials with area Int (phi - phi_0)^2 > (c h Int |D phi|)^2; the left side is at least ||phi -
// phi_0||_1^2.
Rational monomials_beyond_their_mean(const Rational& c, int power_of_h) {
  long count = 0;
  for (const Rational& h : lengths())
    for (const PlanarPoint& by : {PlanarPoint{0, 0}, PlanarPoint{1, 2}}) {
      const std::vector<PlanarPoint> points = placed(right_triangle(), h, by);
      const Rational area = ExactPolynomial(1).integral_over(points);
      for (const ExactPolynomial& phi : monomials(6)) {
        const ExactPolynomial rest = phi - phi.integral_over(points) / area;
        const Rational slope = std::max(phi.by_x().integral_over(points), phi.by_y().integral_over(points));
        const Rational bound = c * power(h, power_of_h) * slope;
        if (area * (rest * rest).integral_over(points) > bound * bound) ++count;
      }
    }
  return {count};
}

// Polynomials of a degree with Int L'p != 0, and linear ones with L'p != 0.
Rational not_integrated(int degree, const Rational& alpha) {
  long count = 0;
  for (const ExactPolynomial& p : monomials(degree))
    if (interpolation_error(1, p, {triangle(right_triangle())}, alpha) != 0) ++count;
  return {count};
}

Rational not_reproduced(int degree) {
  long count = 0;
  for (const ExactPolynomial& p : monomials(degree))
    if ((p - interpolant(triangle(right_triangle()), Rational(1, 6), p)).size() != 0) ++count;
  return {count};
}

// B(Phi, f) less the right side of the introduction, or of (64).
BilinearSum rest_of_the_introduction() {
  BilinearSum sum;
  sum.add({{"Phi", 1}}, {{"f", 1}});
  sum.add({{"Phi", 1}, {"phi_0", -1}}, {{"f", 1}, {"p_1", -1}}, -1);
  sum.add({{"phi_0", 1}}, {{"f", 1}, {"p_2", -1}}, -1);
  return sum;
}

BilinearSum rest_of_64() {
  BilinearSum sum;
  sum.add({{"Phi", 1}}, {{"f", 1}});
  sum.add({{"Phi", 1}}, {{"f", 1}, {"p_2", -1}}, -1);
  sum.add({{"Phi", 1}, {"phi_0", -1}}, {{"p_2", 1}}, -1);
  sum.add({{"phi_0", 1}}, {{"p_2", 1}}, -1);
  return sum;
}

// The same constant where the Taylor polynomials are about a vertex: |d|_1 <= 2^(1/2) h.
Ball constant_on_triangles_about_a_vertex() {
  const Ball side = sqrt(Ball(2));
  return Ball(bound_of_the_remainder()) * interpolation_factors<Ball>(1, 1, side, side).at(0);
}

// What both bounds rest on: L' annihilates linear functions, its integral quadratic ones, and the identity.
void require_steps(Finding& finding) {
  const IsExactly zero{0};
  finding.require("monomials p_1 with L'p_1 != 0", zero, not_reproduced(1));
  finding.require("monomials p_2 with Int L'p_2 != 0", zero, not_integrated(2, Rational(1, 6)));
  finding.control("monomials p_2 with Int L'p_2 != 0, alpha = 1/10", zero,
                  not_integrated(2, Rational(1, 10)));
  BilinearSum rest = rest_of_the_introduction();
  rest.vanish("p_1");
  finding.control("terms of Int Phi L'f less those two, where Int L'p_2 is kept", zero, rest.size());
  rest.vanish("p_2", "phi_0");
  finding.require("terms of Int Phi L'f less Int (Phi - phi_0) L'(f - p_1) + phi_0 Int L'(f - p_2)", zero,
                  rest.size());
  require_mean_values(finding, 0);
}

}  // namespace

Finding lemma_3_2(const Bench&) {
  Finding finding;
  require_steps(finding);
  const std::vector<PlanarPoint>& points = right_triangle();
  const std::vector<PlanarTriangle> tau{triangle(points)};
  finding.require("largest |d_x| + |d_y| about the middle of the hypotenuse, over h", IsExactly{1},
                  reach(points, {Rational(1, 2), Rational(1, 2)}));
  finding.control("largest |d_x| + |d_y| about an end of the hypotenuse, over h", IsExactly{1},
                  reach(points, points[1]));
  const Rational c(5, 3);
  finding.require("c = (1 + 7/3) max (1/2!, 1/3!)", IsExactly{c}, constant_with_legs());
  // (5/3) 2^(1/2)
  require_in_any_direction(finding, 1, {2, Rational(12, 5)});
  const std::string missed = "products phi f of degree ";
  finding.require(missed + "up to 2 that are missed: terms of the error up to h^4", IsExactly{0},
                  products_missed(2, tau, Rational(1, 6)));
  finding.control(missed + "up to 3 that are missed: h^5 stays", IsExactly{0},
                  products_missed(3, tau, Rational(1, 6)));
  finding.control(missed + "up to 2 that are missed, alpha = 1/10", IsExactly{0},
                  products_missed(2, tau, Rational(1, 10)));
  Rational largest = 0;
  for (const Rational& h : {Rational(1000), Rational(1, 1000)})
    for (const PlanarPoint& by : {PlanarPoint{0, 0}, PlanarPoint{1, 2}}) {
      const std::string at = placed_at(h, by);
      const std::vector<BoundedError> errors = errors_on(placed(points, h, by));
      finding.require("products beyond (60) with this c" + at, IsExactly{0},
                      exceeding(errors, c * power(h, 3)));
      if (h < 1 && by.x == 0)
        finding.control("products beyond (60) with h^4 for h^3" + at, IsExactly{0},
                        exceeding(errors, c * power(h, 4)));
      largest = std::max(largest, largest_ratio(errors) / power(h, 3));
    }
  finding.remark("largest error over h^3 and the bracket", proved(Ball(largest)));
  finding.show(proved(Ball(c)));
  return finding;
}

Finding corollary_3_4_a(const Bench&) {
  Finding finding;
  require_steps(finding);
  require_lengths(finding);
  const Rational c(21, 10);
  const Ball constant = constant_on_triangles();
  finding.require("c for every triangle", LiesIn{2, c}, constant);
  finding.control("c by Taylor polynomials about a vertex, which are at most the diameter away", LiesIn{2, c},
                  constant_on_triangles_about_a_vertex());
  for (const long thinness : {1L, 100L, 100000000L})
    for (const Rational& h : {Rational(1), Rational(1, 1000)}) {
      // Sides of the first triangle: at most 1. The diameter is h.
      const std::vector<PlanarPoint> shape{{0, 0}, {1, 0}, {Rational(1, 3), Rational(1, 2 * thinness)}};
      for (const PlanarPoint& by : {PlanarPoint{0, 0}, PlanarPoint{1, 2}}) {
        const std::string at = ", height " + shape[2].y.to_text() + " of the diameter" + placed_at(h, by);
        const std::vector<BoundedError> errors = errors_on(placed(shape, h, by));
        finding.require("products beyond (74) with c = 21/10" + at, IsExactly{0},
                        exceeding(errors, c * power(h, 3)));
      }
    }
  const Rational tiny = power(Rational(10), -6);
  finding.control("products beyond (74) with h^4 for h^3, legs of " + tiny.to_text(), IsExactly{0},
                  exceeding(errors_on(placed(right_triangle(), tiny, {0, 0})), c * power(tiny, 4)));
  finding.show(proved(constant));
  return finding;
}

Finding equation_61(const Bench&) {
  Finding finding;
  const std::vector<PlanarPoint>& points = right_triangle();
  const PlanarPoint middle{Rational(1, 2), Rational(1, 2)};
  const IsExactly one{1};
  finding.require("largest |d_x| + |d_y| about the middle of the hypotenuse, over h", one,
                  reach(points, middle));
  finding.control("largest |d_x| + |d_y| about an end of the hypotenuse, over h", one,
                  reach(points, points[1]));
  const std::vector<Rational> constants{Rational(1, 2), Rational(1, 6)};
  for (const int k : {1, 2}) {
    const std::string of = std::to_string(k);
    const std::string next = std::to_string(k + 1);
    const Rational& c = constants.at(static_cast<std::size_t>(k - 1));
    finding.require("Int_0^1 (1 - t)^" + of + "/" + of + "! dt: |f - p_" + of + "| over (|d_x| + |d_y|)^" +
                        next + " ||D^" + next + " f||",
                    IsExactly{c}, taylor_factor(k));
    const std::string what = "||f - p_" + of + "||/(h^" + next + " ||D^" + next + " f||)";
    finding.require(what + ", f = (d_x + d_y)^" + next + ": the constant is reached", IsExactly{c},
                    reached_by_taylor(k));
    finding.control(what + ", the same with p_3 and D^4", IsExactly{c}, reached_by_taylor(3));
    finding.require("points where a monomial less p_" + of + " is beyond its bound", IsExactly{0},
                    points_beyond_taylor(k, c, points, middle));
    finding.control("points where a monomial less p_" + of + " is beyond half of it", IsExactly{0},
                    points_beyond_taylor(k, c / 2, points, middle));
  }
  return finding;
}

Finding equation_63(const Bench&) {
  Finding finding;
  require_mean_values(finding, 0);
  finding.require("monomials, h = 1000, 1, 1/8, 1/1000, with ||phi - phi_0||_1 > h ||D phi||_1", IsExactly{0},
                  monomials_beyond_their_mean(1, 1));
  finding.control("the same with h^2 for h", IsExactly{0}, monomials_beyond_their_mean(1, 2));
  return finding;
}

Finding equation_64(const Bench&) {
  Finding finding;
  const IsExactly zero{0};
  finding.require("terms of Int Phi L'f less those of (64)", zero, rest_of_64().size());
  BilinearSum without = rest_of_64();
  without.add({{"phi_0", 1}}, {{"p_2", 1}});
  finding.control("the same without the third term", zero, without.size());
  finding.require("monomials p_2 with Int L'p_2 != 0", zero, not_integrated(2, Rational(1, 6)));
  finding.control("monomials p_3 with Int L'p_3 != 0", zero, not_integrated(3, Rational(1, 6)));
  finding.control("monomials p_2 with Int L'p_2 != 0, alpha = 1/10", zero,
                  not_integrated(2, Rational(1, 10)));
  return finding;
}

}  // namespace radcert::verification::ac98
