// SPDX-License-Identifier: GPL-3.0-or-later

// Lemma 1 (a) on every ellipsoid, (c) at every point of the unit sphere and Theorem 3 (a) for all data on it,
// beside what [ac98] has of them on other surfaces.
//
// (a): x.Ax = 1, A = diag(a^-2, b^-2, c^-2), a <= b <= c. With Q = P + h and n_P = -AP/|AP|
//   4 |AP| |AQ| [(Q-P).n_P] [(P-Q).n_Q] = (h.Ah)^2 - (Q.AQ - P.AP)^2,
// where the last term is 0 on the ellipsoid; h.Ah <= |h|^2/a^2 and |AP|^2 >= P.AP/c^2 = 1/c^2, as the
// differences are sums of squares with factors a^-2 - b^-2 >= 0 and the like. So 0 <= G <= c^2/(4 a^4), for
// all pairs of points.
//
// (c): G = 1/4 on the unit sphere, lemma_1_d: the integral is a quarter of the area from wherever it is
// looked at.
//
// Theorem 3 (a): hence K f = rho M(f) there, M the mean. With p = M(rho), m the norm of rho, both below 1: u
// = E + rho M(E)/(1 - p) solves (1); if K w = w then M(w) (1 - p) = 0 and w = rho M(w) = 0, so that it is the
// only one. As |M(E)| <= norm of E, norm of u is at most (1 + m/(1 - p)) norm of E, and 1/(1 - m) - 1 - m/(1
// - p) = m (m - p)/((1 - m)(1 - p)) >= 0: p is a mean of numbers of at most m.
//
// Checked      these identities, as polynomials in all variables; the area of the library's sphere, enclosed.
//              Rejected: normals of another ellipsoid, a sphere of radius 2, the solution with 1 + p for 1 -
//              p and the inequality with the signs of m and p exchanged.
// Not checked  other surfaces: what ac98 has of them is in the same findings.

#include "radcert/enclosure/polygon_integral.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "verification/claims/m06/rank_one_inverse.h"
#include "verification/claims/proved_number.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
Finding equation_6(const Bench& bench);
Finding equation_7(const Bench& bench);
Finding theorem_2_4_a(const Bench& bench);
}  // namespace radcert::verification::ac98

namespace radcert::verification::m06 {
namespace {

using Variables = std::array<Polynomial, 3>;

Variables variables(const std::string& name) {
  return {Polynomial::variable(name + "1"), Polynomial::variable(name + "2"),
          Polynomial::variable(name + "3")};
}

Polynomial product(const Variables& a, const Variables& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A v for A = diag(inverse).
Variables times(const Variables& inverse, const Variables& v) {
  return {inverse[0] * v[0], inverse[1] * v[1], inverse[2] * v[2]};
}

// 4 (-h.AP) (h.BQ) less (h.Ah)^2 - (Q.AQ - P.AP)^2; B = A, or not.
Rational terms_of_kernel(bool same_ellipsoid) {
  const Variables a = variables("a");
  const Variables p = variables("p");
  const Variables h = variables("h");
  const Variables other = same_ellipsoid ? a : Variables{a[1], a[0], a[2]};
  const Variables q{p[0] + h[0], p[1] + h[1], p[2] + h[2]};
  const Polynomial from_p = -product(h, times(a, p));
  const Polynomial from_q = product(h, times(other, q));
  const Polynomial bend = product(h, times(a, h));
  const Polynomial off = product(q, times(a, q)) - product(p, times(a, p));
  return differing_terms(4 * from_p * from_q - (bend * bend - off * off), 0);
}

// A_1 |h|^2 - h.Ah - (A_1 - A_2) h_2^2 - (A_1 - A_3) h_3^2, and the like for |AP|^2 - A_3 P.AP.
Rational terms_of_sums_of_squares() {
  const Variables a = variables("a");
  const Variables h = variables("h");
  const Polynomial largest = a[0] * product(h, h) - product(h, times(a, h)) - (a[0] - a[1]) * h[1] * h[1] -
                             (a[0] - a[2]) * h[2] * h[2];
  const Polynomial smallest = product(times(a, h), times(a, h)) - a[2] * product(h, times(a, h)) -
                              (a[0] - a[2]) * a[0] * h[0] * h[0] - (a[1] - a[2]) * a[1] * h[1] * h[1];
  return differing_terms(largest, 0) + differing_terms(smallest, 0);
}

struct AreaElement {
  const Chart* chart;

  template <class R>
  R operator()(const ParameterPoint<R>& at) const {
    return area_element(chart->in<R>().frame(at));
  }
};

// The area of the library's sphere, by its charts.
Ball area_of_sphere(int radius) {
  const Surface surface = ellipsoid(radius, radius, radius);
  Ball area = 0;
  for (const Chart& chart : surface.charts)
    area += known(integral_over_polygon(AreaElement{&chart}, {{0, 0}, {1, 0}, {0, 1}}, {.radius = 1e-20}));
  return area;
}

// (1 - m)(1 - p) [1/(1 - m) - 1 - m/(1 - p)] - m (m - p), or with m (p - m).
Rational terms_of_inequality(int sign) {
  const Polynomial m = Polynomial::variable("m");
  const Polynomial p = Polynomial::variable("p");
  return differing_terms((1 - p) - (1 - m) * (1 - p) - m * (1 - m) - sign * m * (m - p), 0);
}

}  // namespace

Finding lemma_1_a(const Bench& bench) {
  const IsExactly none{0};
  Finding finding = ac98::equation_6(bench);
  finding.require("terms of 4 |AP| |AQ| |P-Q|^4 G - (h.Ah)^2 + (Q.AQ - P.AP)^2, any ellipsoid", none,
                  terms_of_kernel(true));
  finding.control("the same with the normal at Q of an ellipsoid with two axes exchanged", none,
                  terms_of_kernel(false));
  finding.require("terms of |h|^2/a^2 - h.Ah and |AP|^2 - P.AP/c^2 less sums of squares", none,
                  terms_of_sums_of_squares());
  return finding;
}

Finding lemma_1_c(const Bench& bench) {
  Finding finding = ac98::equation_7(bench);
  const BallPrecision precision(128);
  const AgreesWith pi{.value = Ball::pi(), .within = 1e-18};
  finding.require("a quarter of the area of the unit sphere: the integral of G from each of its points", pi,
                  area_of_sphere(1) / Ball(4));
  finding.control("a quarter of the area of the sphere of radius 2, where G = 1/16", pi,
                  area_of_sphere(2) / Ball(4));
  return finding;
}

Finding theorem_3_a(const Bench& bench) {
  const IsExactly none{0};
  Finding finding = ac98::theorem_2_4_a(bench);
  finding.require("terms of u - K u - E on the unit sphere, any E and rho", none, terms_of_right_inverse(-1));
  finding.control("the same for E + rho M(E)/(1 + M(rho))", none, terms_of_right_inverse(1));
  finding.require("terms of E + rho M(E)/(1 - M(rho)) - u for E = u - K u, any u", none,
                  terms_of_left_inverse(-1));
  finding.control("the same with 1 + M(rho)", none, terms_of_left_inverse(1));
  finding.require("terms of 1/(1 - m) - 1 - m/(1 - p) less m (m - p)/((1 - m)(1 - p))", none,
                  terms_of_inequality(1));
  finding.control("the same less m (p - m)/((1 - m)(1 - p))", none, terms_of_inequality(-1));
  return finding;
}

}  // namespace radcert::verification::m06
