// SPDX-License-Identifier: GPL-3.0-or-later

// Lemma 1 (b) and (e). The lemma asks of S no more than smoothness and the divergence theorem.
//
// Checked      (b): G = -1/4 between the points (3/2,0,0) and (-1/2,0,0) of the torus of radius 1 and tube
//              radius 1/2, a smooth closed surface that bounds a body, exactly; G >= 0 for the pairs of a
//              grid of the unit sphere, which lies in the boundary of a convex body as the paper's unoccluded
//              surfaces do. The torus has V = 0 there: it is convexity, and not smoothness, that makes G >=
//              0. (e): on the parabolic cylinder z = 2 - x^2, where G is ((xi-x)^2/[(xi-x)^2 (1+(x+xi)^2) +
//              d^2])^2 times smooth factors of x and xi alone: its derivatives of the orders 1 to 3 along
//              eight directions times |P-Q|^i, exactly, at distances from 1/2 to 2^-30; they stay bounded,
//              and those times |P-Q|^(i-1) do not.
// Not checked  (e) for other surfaces and pairs.

#include <algorithm>

#include "radcert/kernel/geometric_kernel.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

constexpr AtMost never_negative{};

// -G as a proved number.
Approximation minus_kernel(const Vector<Rational>& p, const Vector<Rational>& normal_p,
                           const Vector<Rational>& q, const Vector<Rational>& normal_q) {
  // Exact: G is a dyadic fraction for the points that are used.
  return {
      .value = 0 - geometric_kernel(p, normal_p, q, normal_q).to_double(), .radius = 0, .guaranteed = true};
}

Vector<Rational> on_the_sphere(long a, long b) {
  const Rational squares = Rational(a * a + b * b);
  return {Rational(2 * a) / (squares + 1), Rational(2 * b) / (squares + 1), (squares - 1) / (squares + 1)};
}

Rational negative_pairs_on_the_sphere() {
  constexpr long range = 4;
  long count = 0;
  for (long a = -range; a <= range; ++a)
    for (long b = -range; b <= range; ++b)
      for (long c = -range; c <= range; ++c) {
        const Vector<Rational> p = on_the_sphere(a, b);
        const Vector<Rational> q = on_the_sphere(c, 7);
        if (geometric_kernel(p, -p, q, -q) < 0) ++count;
      }
  return {count};
}

constexpr std::size_t terms = 4;
using Series = std::array<Rational, terms>;

Series times(const Series& a, const Series& b) {
  Series c{};
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; i + j < terms; ++j) c[i + j] += a[i] * b[j];
  return c;
}

Series quotient(const Series& a, const Series& b) {
  Series c{};
  for (std::size_t k = 0; k < terms; ++k) {
    Rational rest = a[k];
    for (std::size_t j = 1; j <= k; ++j) rest -= b[j] * c[k - j];
    c[k] = rest / b[0];
  }
  return c;
}

// The Taylor coefficients of G without its smooth factors at Q = P + (w, d), along (e, f).
Series along(const Rational& x, const Rational& w, const Rational& d, const Rational& e, const Rational& f) {
  const Series first{w, e, 0, 0};
  const Series second{d, f, 0, 0};
  const Series bend{2 * x + w, e, 0, 0};
  Series slope = times(bend, bend);
  slope[0] += 1;
  const Series square = times(first, first);
  Series denominator = times(square, slope);
  const Series square_d = times(second, second);
  for (std::size_t k = 0; k < terms; ++k) denominator[k] += square_d[k];
  const Series ratio = quotient(square, denominator);
  return times(ratio, ratio);
}

// The largest |D^i G| distance^power over directions of Q - P and of the derivative; distances as the larger
// of |w| and |d|.
Approximation largest(std::size_t i, int power_of_distance, int k) {
  const Rational distance = 1 / power(Rational(2), k);
  const std::vector<std::array<Rational, 2>> directions{{1, 0},
                                                        {0, 1},
                                                        {1, 1},
                                                        {1, -1},
                                                        {Rational(1, 3), 1},
                                                        {1, Rational(1, 7)},
                                                        {-1, Rational(1, 2)},
                                                        {Rational(-1, 5), -1}};
  const std::array<long, terms> factorial{1, 1, 2, 6};
  Rational result = 0;
  for (const Rational& x : {Rational(1, 10), Rational(1, 2), Rational(1)})
    for (const auto& [w, d] : directions)
      for (const auto& [e, f] : directions)
        result = std::max(result, abs(along(x, distance * w, distance * d, e, f)[i]));
  return {.value = (result * Rational(factorial[i]) * power(distance, power_of_distance)).to_double(),
          .radius = 0};
}

}  // namespace

Finding lemma_1_b(const Bench&) {
  Finding finding;
  const Rational half(1, 2);
  const Rational three_halves(3, 2);
  finding.require("-G between two points of the torus of radius 1 and tube radius 1/2", never_negative,
                  minus_kernel({three_halves, 0, 0}, {-1, 0, 0}, {-half, 0, 0}, {-1, 0, 0}));
  finding.require("pairs of a grid of the unit sphere with G < 0", IsExactly{0},
                  negative_pairs_on_the_sphere());
  finding.instead("-G between floor and ceiling of the unit cube, a convex body", never_negative,
                  minus_kernel({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}));
  finding.control("-G between floor and ceiling of the unit cube, one of the normals outwards",
                  never_negative, minus_kernel({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}));
  return finding;
}

Finding lemma_1_e(const Bench&) {
  const AtMost bounded{.value = 1000, .slack = 0, .why = ""};
  Finding finding;
  for (const int i : {1, 2, 3}) {
    const std::string order = std::to_string(i);
    for (const int k : {1, 10, 20, 30})
      finding.require("|D^" + order + " G| |P-Q|^" + order + ", |P-Q| near 2^-" + std::to_string(k), bounded,
                      largest(static_cast<std::size_t>(i), i, k));
    finding.control("|D^" + order + " G| |P-Q|^" + std::to_string(i - 1) + ", |P-Q| near 2^-30", bounded,
                    largest(static_cast<std::size_t>(i), i - 1, 30));
  }
  return finding;
}

}  // namespace radcert::verification::m06
