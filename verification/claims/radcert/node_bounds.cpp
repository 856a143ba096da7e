// SPDX-License-Identifier: GPL-3.0-or-later

// What no nodes of small degrees reach, by exact algebra.
//
// c_i = x_i - 1/3, p = c_1^2 + c_2^2 + c_3^2, q = c_1 c_2 c_3. The means of p^i q^j with 2i + 3j <= d decide
// whether a symmetric rule is exact up to the degree d. At the centroid p = q = 0, on an orbit of three c =
// (-2t, t, t), p = 6 t^2, q = -2 t^3, so that 54 q^2 = p^3; p = 0 nowhere but at the centroid.
//
// r = 1 has one orbit of three, which carries the whole weight: degree 3 asks for p = M(p), q = M(q), and 54
// M(q)^2 = M(p)^3 is false.
//
// r = 3 has the centroid, an orbit A of three and an orbit B of six. With a = alpha p_A, b = beta p_B, t =
// q/p the means of p, p^2, p^3, q, pq, q^2 are those of 1, p, p^2, t, pt, p t^2 with the weights a at A and b
// at B. If a = 0, b = 0 or p_A = p_B, then M(p) M(p^3) = M(p^2)^2, which is false. Else t = lambda + kappa p
// at both, lambda and kappa by M(q) and M(pq); if kappa is not 0, M(q^2) gives the mean of p^3 with these
// weights, and four means of powers the polynomial f = p^2 - sigma p + pi with the zeros p_A, p_B. At A 54
// t^2 = p, so that f and 54 (lambda + kappa p)^2 - p have a common zero: their resultant, which is not 0,
// would vanish.
//
// Any three nodes: the rule on the parallelogram has three pairs of nodes opposite to each other about its
// centre. The even polynomials of degree 2, of which there are four, have at three pairs a Gram matrix of
// rank 3 at most, and that of the integral is regular: no such rule is exact for their products, which are of
// degree 4.
//
// Checked      all of it, in rational arithmetic. Rejected: the means of rules that there are.
// Not checked  other degrees. That there are no other numbers of orbits is orbit_structure's proof.

#include <array>
#include <cstddef>
#include <string>

#include "radcert/polynomial/nodes/orbit_structure.h"
#include "radcert/polynomial/nodes/symmetric_system.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"
#include "verification/framework/check.h"

namespace radcert::verification::radcert {
namespace {

using Polynomial = PlanePolynomial<Rational>;

/// The means of p^i q^j: of p, p^2, p^3, q, pq, q^2.
struct Means {
  Rational p, pp, ppp, q, pq, qq;
};

constexpr std::array<std::array<int, 2>, 6> powers{{{1, 0}, {2, 0}, {3, 0}, {0, 1}, {1, 1}, {0, 2}}};

Means means_from(const std::array<Rational, 6>& m) { return {m[0], m[1], m[2], m[3], m[4], m[5]}; }

/// Those over the triangle.
Means means_over_the_triangle() {
  const Polynomial c_3 = affine_polynomial<Rational>(Rational(-1, 3), 1, 0);
  const Polynomial c_2 = affine_polynomial<Rational>(Rational(-1, 3), 0, 1);
  const Polynomial c_1 = affine_polynomial<Rational>(Rational(2, 3), -1, -1);
  const Polynomial q = product(product(c_1, c_2), c_3);
  Polynomial p = product(c_1, c_1);
  for (const Polynomial& c : {c_2, c_3}) p = sum(p, Rational(1), product(c, c));
  std::array<Rational, 6> out;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    Polynomial f = constant_polynomial<Rational>(1);
    for (int i = 0; i < powers[k][0]; ++i) f = product(f, p);
    for (int i = 0; i < powers[k][1]; ++i) f = product(f, q);
    for (int i = 0; i <= f.degree(); ++i)
      for (int j = 0; i + j <= f.degree(); ++j)
        out[k] += 2 * f(i, j) * factorial(i) * factorial(j) / factorial(i + j + 2);
  }
  return means_from(out);
}

/// Those of a rule with the weight 2/5 at an orbit of three with c = (-2t, t, t) and 1/2 at one of six with p
/// and q, the rest at the centroid.
Means means_of_a_rule(const Rational& t, const Rational& p, const Rational& q) {
  std::array<Rational, 6> out;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    const auto [i, j] = powers[k];
    out[k] = Rational(2, 5) * power(6 * t * t, i) * power(-2 * t * t * t, j) +
             Rational(1, 2) * power(p, i) * power(q, j);
  }
  return means_from(out);
}

/// What vanishes if there are an orbit of three and one of six with these means: see above.
struct Obstruction {
  Rational one_orbit;  ///< M(p) M(p^3) - M(p^2)^2
  Rational kappa;
  Rational resultant;
};
Obstruction obstruction(const Means& m) {
  Obstruction out;
  out.one_orbit = m.p * m.ppp - m.pp * m.pp;
  const Rational lambda = (m.q * m.ppp - m.pq * m.pp) / out.one_orbit;
  out.kappa = (m.p * m.pq - m.pp * m.q) / out.one_orbit;
  const Rational& kappa = out.kappa;
  const Rational p_4 = (m.qq - lambda * lambda * m.pp - 2 * lambda * kappa * m.ppp) / (kappa * kappa);
  const Rational sigma = (m.p * p_4 - m.pp * m.ppp) / out.one_orbit;
  const Rational pi = (m.pp * p_4 - m.ppp * m.ppp) / out.one_orbit;
  // (lambda + kappa p)^2 - p/54 = u p + v at the zeros of p^2 - sigma p + pi.
  const Rational u = kappa * kappa * sigma + 2 * lambda * kappa - Rational(1, 54);
  const Rational v = lambda * lambda - kappa * kappa * pi;
  out.resultant = u * u * pi + u * v * sigma + v * v;
  return out;
}

/// The determinant of the Gram matrix of 1, x^2, xy, y^2, by the means of products.
template <class Mean>
Rational gram_determinant(const Mean& mean) {
  constexpr std::array<std::array<int, 2>, 4> even{{{0, 0}, {2, 0}, {1, 1}, {0, 2}}};
  Matrix<Rational> a(4, 4);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) a(i, j) = mean(even[i][0] + even[j][0], even[i][1] + even[j][1]);
  Rational determinant = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    // Leading minors of a positive semidefinite matrix: where one vanishes, so do all that follow.
    if (a(k, k).sign() == 0) return 0;
    determinant *= a(k, k);
    for (std::size_t i = k + 1; i < 4; ++i) {
      const Rational factor = a(i, k) / a(k, k);
      for (std::size_t j = k; j < 4; ++j) a(i, j) -= factor * a(k, j);
    }
  }
  return determinant;
}

}  // namespace

Finding symmetric_nodes_of_degrees_1_and_3(const Bench&) {
  Finding finding;
  const Means m = means_over_the_triangle();
  finding.require("orbits of three, r = 1", IsExactly{1}, Rational(orbit_structure(1).threes));
  finding.require("orbits in all, r = 1", IsExactly{1}, Rational(orbit_structure(1).orbits()));
  finding.require("orbits of three, r = 3", IsExactly{1}, Rational(orbit_structure(3).threes));
  finding.require("orbits of six, r = 3", IsExactly{1}, Rational(orbit_structure(3).sixes));
  finding.require("orbits in all, r = 3", IsExactly{3}, Rational(orbit_structure(3).orbits()));
  finding.control("orbits in all, r = 4", IsExactly{3}, Rational(orbit_structure(4).orbits()));

  const auto on_the_curve = [](const Means& at) { return Ball(54 * at.q * at.q - at.p * at.p * at.p); };
  const LiesIn below_zero{.least = Rational(-1, 100), .largest = Rational(-1, 10'000'000)};
  finding.require("r = 1: 54 M(q)^2 - M(p)^3, 0 for an orbit of three", below_zero, on_the_curve(m));
  const Rational t(-1, 6);
  finding.control("the same for the means of the rule at alpha = 1/6", below_zero,
                  on_the_curve({.p = 6 * t * t, .pp = 0, .ppp = 0, .q = -2 * t * t * t, .pq = 0, .qq = 0}));

  const Obstruction found = obstruction(m);
  const LiesIn above_zero{.least = Rational(1, 10'000), .largest = 1};
  finding.require("r = 3: M(p) M(p^3) - M(p^2)^2, 0 for one orbit off the centroid", above_zero,
                  Ball(found.one_orbit));
  finding.require("r = 3: kappa, by which is divided", above_zero, Ball(found.kappa));
  finding.require("r = 3: the resultant, 0 for orbits of three and six", below_zero, Ball(found.resultant));
  const Rational of_three = 6 * t * t;
  finding.control("M(p) M(p^3) - M(p^2)^2 of an orbit of three alone", above_zero,
                  Ball(of_three * power(of_three, 3) - power(of_three, 2) * power(of_three, 2)));
  finding.control(
      "the resultant for the means of a rule at orbits of three and six", below_zero,
      Ball(obstruction(means_of_a_rule(Rational(1, 5), Rational(1, 4), Rational(1, 90))).resultant));
  return finding;
}

Finding three_nodes_of_degree_1(const Bench&) {
  Finding finding;
  // The centre of the square [-1, 1]^2 is that of the parallelogram; an affine map keeps degrees.
  const auto over_the_square = [](int i, int j) {
    return i % 2 == 0 && j % 2 == 0 ? Rational(1, (i + 1) * (j + 1)) : Rational(0);
  };
  const LiesIn above_zero{.least = Rational(1, 10'000), .largest = 1};
  finding.require("the Gram determinant of 1, x^2, xy, y^2 over the square", above_zero,
                  Ball(gram_determinant(over_the_square)));
  const auto at_three_pairs = [](int i, int j) {
    constexpr std::array<std::array<int, 2>, 3> thirds{{{1, 1}, {2, -1}, {0, 2}}};
    Rational mean = 0;
    for (const auto& [x, y] : thirds)
      mean += Rational(1, 3) * power(Rational(x, 3), i) * power(Rational(y, 3), j);
    return mean;
  };
  finding.control("the same at three pairs of points", above_zero, Ball(gram_determinant(at_three_pairs)));
  return finding;
}

}  // namespace radcert::verification::radcert
