// SPDX-License-Identifier: GPL-3.0-or-later

// Lemma 1 (e) on the roof z = 2 - x^2 of two_piece(2), for all pairs of points and all directions of the
// derivative. P = (x,y), Q = (xi,eta) in parameters, Q - P = rho (c,n) with c^2 + n^2 = 1, and Q moves along
// rho tau (e,f), e^2 + f^2 = 1: the i-th derivative along (e,f) is i! rho^-i times the coefficient of tau^i.
// With A = c + e tau, B = x + xi + rho e tau,
//   G = [A^2/(1 + 2 (c e + n f) tau + tau^2 + A^2 B^2)]^2 (1 + 4x^2)^(-1/2)
//       (1 + 4 (xi + rho e tau)^2)^(-1/2),
//   |P-Q|^2 = rho^2 (1 + c^2 (x + xi)^2).
// rho has cancelled in the first factor, whose denominator begins with 1 + c^2 (x + xi)^2 >= 1. So |D_Q^i G|
// |P-Q|^i is at most i! times the size of a coefficient times (1 + c^2 (x + xi)^2)^(i/2): bounded on the
// compact set of x, xi, rho and the two directions. Mixed derivatives are no larger than the largest along a
// direction (a symmetric form of i vectors has its norm on the diagonal).
//
// Checked      that bound for i = 1, 2 and 3 in balls over boxes that cover the set, the angles of both
//              directions in arcs of a half circle: the other halves give the same, with the opposite sign of
//              n and f together, or of e and f. The series against the library's kernel. Rejected: a
//              pair of points on two squares that meet in an edge, where S is not smooth and G is of the
//              degree -2 in the distance. On the unit sphere G = 1/4 by lemma_1_d: all derivatives are 0.
// Not checked  other surfaces; i above 3.

#include <array>

#include "radcert/kernel/geometric_kernel.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// The first Taylor coefficients in tau.
constexpr std::size_t terms = 4;
using Series = std::array<Ball, terms>;

Series times(const Series& a, const Series& b) {
  Series c{};
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; i + j < terms; ++j) c[i + j] += a[i] * b[j];
  return c;
}

// a/b where b_0 is known to be positive.
Series quotient(const Series& a, const Series& b) {
  Series c{};
  for (std::size_t k = 0; k < terms; ++k) {
    Ball rest = a[k];
    for (std::size_t j = 1; j <= k; ++j) rest -= b[j] * c[k - j];
    c[k] = rest / b[0];
  }
  return c;
}

// a^(-1/2): y = a^p has k a_0 y_k = sum_j (p j - (k - j)) a_j y_(k-j).
Series inverse_root(const Series& a) {
  Series y{};
  y[0] = Ball(1) / sqrt(a[0]);
  for (std::size_t k = 1; k < terms; ++k) {
    Ball sum = 0;
    for (std::size_t j = 1; j <= k; ++j)
      sum += Ball(Rational(-static_cast<long>(j), 2) - Rational(static_cast<long>(k - j))) * a[j] * y[k - j];
    y[k] = sum / (Ball(static_cast<long>(k)) * a[0]);
  }
  return y;
}

// 1 + 4 a^2 for a = first + second tau, the constant term never below 1.
Series stretch(const Ball& first, const Ball& second) {
  return {Ball(1) + Ball(4) * (first * first), Ball(8) * first * second, Ball(4) * (second * second),
          Ball(0)};
}

struct PairOfPoints {
  Ball x;
  Ball xi;
  Ball rho;
  Ball c;
  Ball n;
};

struct Direction {
  Ball e;
  Ball f;
};

// c^2 (x + xi)^2.
Ball slope(const PairOfPoints& at) {
  const Ball product = at.c * (at.x + at.xi);
  return product * product;
}

// G along the direction.
Series kernel_along(const PairOfPoints& at, const Direction& along) {
  const Series a{at.c, along.e, 0, 0};
  const Series b{at.x + at.xi, at.rho * along.e, 0, 0};
  const Series square = times(a, a);
  const Series bent = times(a, b);
  Series denominator = times(bent, bent);
  denominator[0] = Ball(1) + slope(at);
  denominator[1] += Ball(2) * (at.c * along.e + at.n * along.f);
  denominator[2] += Ball(1);
  const Series ratio = quotient(square, denominator);
  Series kernel = times(times(ratio, ratio), inverse_root(stretch(at.xi, at.rho * along.e)));
  const Ball at_p = Ball(1) / sqrt(stretch(at.x, Ball(0))[0]);
  for (Ball& coefficient : kernel) coefficient = coefficient * at_p;
  return kernel;
}

constexpr std::array<long, terms> factorial{1, 1, 2, 6};

// [k/count, (k+1)/count] times a length.
Ball part(long k, long count, const Ball& length) {
  return hull(Ball(Rational(k, count)), Ball(Rational(k + 1, count))) * length;
}

// The largest |D^i G| |P-Q|^i, i = 0 to 3, over all pairs and directions, from above.
Series largest_derivatives() {
  constexpr long arcs = 24;
  constexpr long sides = 4;
  const Ball diagonal = sqrt(Ball(2));
  const auto arc = [](long k) {
    const Ball angle = part(k, arcs, Ball::pi());
    return std::array<Ball, 2>{cos(angle), sin(angle)};
  };
  Series largest{};
  for (long i = 0; i < sides; ++i)
    for (long j = 0; j < sides; ++j)
      for (long k = 0; k < arcs; ++k) {
        const auto [c, n] = arc(k);
        const PairOfPoints at{part(i, sides, Ball(1)), part(j, sides, Ball(1)), hull(Ball(0), diagonal), c,
                              n};
        const Ball length = sqrt(Ball(1) + slope(at));
        for (long l = 0; l < arcs; ++l) {
          const auto [e, f] = arc(l);
          const Series kernel = kernel_along(at, {e, f});
          for (std::size_t m = 0; m < terms; ++m)
            largest[m] =
                max(largest[m], Ball(factorial[m]) * abs(kernel[m]) * power(length, static_cast<long>(m)));
        }
      }
  return largest;
}

// The series with so many terms less the library's G, Q moved by tau = 2^-24 along (e,f), |P-Q| from 1/2 to
// 2^-12.
Ball off_the_library(std::size_t count) {
  const Surface surface = two_piece(2);
  const ChartIn<Ball>& roof = surface.charts[1].in<Ball>();
  const Rational x(1, 3);
  const Rational y(1, 5);
  // Unit vectors.
  const Rational c(3, 5);
  const Rational n(4, 5);
  const Rational e(-5, 13);
  const Rational f(12, 13);
  const Rational tau = 1 / power(Rational(2), 24);
  Ball largest = 0;
  for (const int k : {1, 6, 12}) {
    const Rational rho = 1 / power(Rational(2), k);
    const Frame<Ball> p = roof.frame({Ball(x), Ball(y)});
    const Frame<Ball> q = roof.frame({Ball(x + rho * (c + e * tau)), Ball(y + rho * (n + f * tau))});
    Ball rest = -geometric_kernel(p.point, unit_normal(p), q.point, unit_normal(q));
    const Series series =
        kernel_along({Ball(x), Ball(x + rho * c), Ball(rho), Ball(c), Ball(n)}, {Ball(e), Ball(f)});
    for (std::size_t m = 0; m < count; ++m) rest += series[m] * Ball(power(tau, static_cast<long>(m)));
    largest = max(largest, abs(rest));
  }
  return largest;
}

// Two squares that meet in an edge, G = z eta/((x - xi)^2 + eta^2 + z^2)^2 at xi = x, z = distance and eta =
// distance (2 + tau): |D^i G| |P-Q|^i = i! 5^(i/2) distance^-2 times the coefficient of (2 + tau)/((2 +
// tau)^2 + 1)^2.
Series across_an_edge(const Rational& distance) {
  const Series a{2, 1, 0, 0};
  Series sum = times(a, a);
  sum[0] += Ball(1);
  Series kernel = quotient(a, times(sum, sum));
  for (std::size_t m = 0; m < terms; ++m)
    kernel[m] = Ball(factorial[m]) * abs(kernel[m]) * power(sqrt(Ball(5)), static_cast<long>(m)) /
                Ball(distance * distance);
  return kernel;
}

}  // namespace

Finding lemma_1_e(const Bench&) {
  const BallPrecision precision(64);
  const Series all = largest_derivatives();
  const Series edge = across_an_edge(1 / power(Rational(2), 20));
  Finding finding;
  for (std::size_t i = 1; i < terms; ++i) {
    // Only that there is a c_2 is stated: i! 32^i is one.
    const AtMost bounded{.value = static_cast<double>(factorial[i] << (5 * i)), .slack = 0, .why = ""};
    const std::string order = std::to_string(i);
    finding.require("largest |D^" + order + " G| |P-Q|^" + order + ", all pairs and directions on the roof",
                    bounded, proved(all[i].upper()));
    finding.control("|D^" + order + " G| |P-Q|^" + order + " across an edge of two squares, at 2^-20",
                    bounded, proved(edge[i]));
  }
  const BallPrecision more(192);
  // The next term is a number below 10^6 times tau^4 = 2^-96.
  const AgreesWith zero{.value = Ball(0), .within = 0x1p-76};
  finding.require("series of G along a direction less G of the library, tau = 2^-24", zero,
                  off_the_library(terms));
  for (std::size_t fewer = 1; fewer < terms; ++fewer)
    finding.control("the same with " + std::to_string(fewer) + " of four terms", zero,
                    off_the_library(fewer));
  finding.show(proved(all[1].upper()));
  return finding;
}

}  // namespace radcert::verification::m06
