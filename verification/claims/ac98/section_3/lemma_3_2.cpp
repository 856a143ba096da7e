// SPDX-License-Identifier: GPL-3.0-or-later

// Lemma 3.2 with a constant: let phi_0 be the mean of phi, p_k Taylor polynomials about the middle of the
// hypotenuse, d_x and d_y the distances from there. |d_x| + |d_y| <= h on the triangle, so that |f - p_k| <=
// h^(k+1)/(k+1)! |D^(k+1) f|; ||I - L|| <= 1 + 7/3, and ||phi - phi_0||_1 <= (diameter/2) Int |grad phi| <= h
// Int |D phi| on convex sets (Acosta and Duran 2004). With Int phi L'f = Int (phi - phi_0) L'(f - p_1) +
// phi_0 Int L'(f - p_2) this is (60) with c = (10/3)(1/2) = 5/3, for every h. It does without the step of the
// printed proof that takes h ||D^3 f|| into the constant, which needs bounded h. On any triangle, with Taylor
// polynomials about the centroid, |d_x| + |d_y| <= 2^(1/2) (2/3) h for the diameter h; then c = max (40/(27
// 2^(1/2)), (5/9)(16 2^(1/2)/27)) < 21/20, and no shape enters.
//
// Checked      lemma_3_2: for all polynomials at once, the error has no power of h below h^5, which is h^3
//              times the area. (60) with c = 5/3 for products of monomials, four h, two places.
//              corollary_3_4_a: (74) with c = 21/20 for triangles down to an angle of 1e-8. equation_61: (61)
//              and (62) with c = 1/(k+1)! on lattices of points, reached by (d_x + d_y)^(k+1). equation_63:
//              (63) with c = 1 by the inequality of Cauchy and Schwarz. equation_64: the identity, and that
//              its third term is 0.
// Not checked  functions that are no polynomials; the inequality of Acosta and Duran itself.

#include "radcert/scalar/real.h"
#include "verification/claims/ac98/collocation/interpolation_bounds.h"
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

struct Counts {
  Rational identity;
  Rational third_term;
};

// Products of monomials for which (64) fails, and for which its last term is not 0.
Counts failing_decompositions(const Rational& alpha) {
  const std::vector<PlanarPoint> points = placed(right_triangle(), Rational(3, 4), {Rational(1, 3), 1});
  const PlanarPoint middle{(points[1].x + points[2].x) / 2, (points[1].y + points[2].y) / 2};
  const std::vector<PlanarTriangle> tau{triangle(points)};
  const Rational area = ExactPolynomial(1).integral_over(points);
  long identity = 0;
  long third = 0;
  for (const ExactPolynomial& f : monomials(4)) {
    const ExactPolynomial p_2 = taylor(f, middle, 2);
    for (const ExactPolynomial& phi : monomials(2)) {
      const ExactPolynomial phi_0 = phi.integral_over(points) / area;
      const Rational last = interpolation_error(phi_0, p_2, tau, alpha);
      const Rational sum = interpolation_error(phi, f - p_2, tau, alpha) +
                           interpolation_error(phi - phi_0, p_2, tau, alpha) + last;
      if (sum != interpolation_error(phi, f, tau, alpha)) ++identity;
      if (last != 0) ++third;
    }
  }
  return {{identity}, {third}};
}

}  // namespace

Finding lemma_3_2(const Bench&) {
  Finding finding;
  const std::vector<PlanarTriangle> tau{triangle(right_triangle())};
  const std::string missed = "products phi f of degree ";
  finding.require(missed + "up to 2 that are missed: terms of the error up to h^4", IsExactly{0},
                  products_missed(2, tau, Rational(1, 6)));
  finding.control(missed + "up to 3 that are missed: h^5 stays", IsExactly{0},
                  products_missed(3, tau, Rational(1, 6)));
  finding.control(missed + "up to 2 that are missed, alpha = 1/10", IsExactly{0},
                  products_missed(2, tau, Rational(1, 10)));
  const Rational c(5, 3);
  Rational largest = 0;
  for (const Rational& h : lengths())
    for (const PlanarPoint& by : {PlanarPoint{0, 0}, PlanarPoint{1, 2}}) {
      const std::string at = placed_at(h, by);
      const std::vector<BoundedError> errors = errors_on(placed(right_triangle(), h, by));
      finding.require("products beyond (60) with c = 5/3" + at, IsExactly{0},
                      exceeding(errors, c * power(h, 3)));
      if (h == Rational(1, 1000) && by.x == 0)
        finding.control("products beyond (60) with h^4 for h^3 and c = 5/3" + at, IsExactly{0},
                        exceeding(errors, c * power(h, 4)));
      largest = std::max(largest, largest_ratio(errors) / power(h, 3));
    }
  finding.remark("largest error over h^3 and the bracket", {.value = largest.to_double(), .radius = 0});
  return finding;
}

Finding corollary_3_4_a(const Bench&) {
  Finding finding;
  const Rational c(21, 20);
  for (const long thinness : {1L, 100L, 100000000L})
    for (const Rational& h : {Rational(1), Rational(1, 1000)}) {
      // Sides of the first triangle: at most 1. The diameter is h.
      const std::vector<PlanarPoint> shape{{0, 0}, {1, 0}, {Rational(1, 3), Rational(1, 2 * thinness)}};
      for (const PlanarPoint& by : {PlanarPoint{0, 0}, PlanarPoint{1, 2}}) {
        const std::string at = ", height " + shape[2].y.to_text() + " of the diameter h = " + h.to_text() +
                               ", corner (" + by.x.to_text() + "," + by.y.to_text() + ")";
        const std::vector<BoundedError> errors = errors_on(placed(shape, h, by));
        finding.require("products beyond (74) with c = 21/20" + at, IsExactly{0},
                        exceeding(errors, c * power(h, 3)));
        if (h == Rational(1, 1000) && thinness == 1 && by.x == 0)
          finding.control("products beyond (74) with h^4 for h^3" + at, IsExactly{0},
                          exceeding(errors, c * power(h, 4)));
      }
    }
  return finding;
}

Finding equation_61(const Bench&) {
  Finding finding;
  const std::vector<Rational> constants{Rational(1, 2), Rational(1, 6)};
  for (const int k : {1, 2}) {
    const Rational& c = constants.at(static_cast<std::size_t>(k - 1));
    const std::string what = "||f - p_" + std::to_string(k) + "||/(h^" + std::to_string(k + 1) + " ||D^" +
                             std::to_string(k + 1) + " f||)";
    finding.require(what + ", f = (d_x + d_y)^" + std::to_string(k + 1), IsExactly{c}, reached_by_taylor(k));
    finding.control(what + ", the same with p_3 and D^4", IsExactly{c}, reached_by_taylor(3));
    for (const PlanarPoint& by : {PlanarPoint{0, 0}, PlanarPoint{1, 2}})
      for (const Rational& h : lengths()) {
        const std::vector<PlanarPoint> points = placed(right_triangle(), h, by);
        const PlanarPoint middle{by.x + h / 2, by.y + h / 2};
        const std::string at = placed_at(h, by);
        finding.require(
            "points where f - p_" + std::to_string(k) + " is beyond its bound, c = " + c.to_text() + at,
            IsExactly{0}, points_beyond_taylor(k, c, points, middle));
        if (h == 1)
          finding.control("points where f - p_" + std::to_string(k) + " is beyond half of it" + at,
                          IsExactly{0}, points_beyond_taylor(k, c / 2, points, middle));
      }
  }
  return finding;
}

Finding equation_63(const Bench&) {
  Finding finding;
  finding.require("monomials, h = 1000, 1, 1/8, 1/1000, with ||phi - phi_0||_1 > h ||D phi||_1", IsExactly{0},
                  monomials_beyond_their_mean(1, 1));
  finding.control("the same with h^2 for h", IsExactly{0}, monomials_beyond_their_mean(1, 2));
  return finding;
}

Finding equation_64(const Bench&) {
  Finding finding;
  const Counts at_a_sixth = failing_decompositions(Rational(1, 6));
  const Counts at_a_tenth = failing_decompositions(Rational(1, 10));
  finding.require("products for which (64) fails, alpha = 1/6", IsExactly{0}, at_a_sixth.identity);
  finding.require("products whose third term is not 0, alpha = 1/6", IsExactly{0}, at_a_sixth.third_term);
  finding.control("products whose third term is not 0, alpha = 1/10", IsExactly{0}, at_a_tenth.third_term);
  return finding;
}

}  // namespace radcert::verification::ac98
