// SPDX-License-Identifier: GPL-3.0-or-later

// The roof z = 2 - x^p over right triangles with legs h along the axes: x and y are linear on the element and
// z depends on x = x_0 + h L alone, 0 <= L <= 1 a barycentric coordinate or 1 less one. Interpolation of
// degree r at the lattice takes a function of one barycentric coordinate to its interpolant at i/r, i = 0,
// ..., r. With e_j = L^j - I_r L^j, which is 0 for j <= r,
//   m_k - m~_k = h^(r+1) sum over j > r of C(p,j) x_0^(p-j) h^(j-r-1) e_j(L),
// which for 0 <= x_0 <= 1 and h <= 1 is at most h^(r+1) sum C(p,j) max |e_j|, whatever
// x_0, h and the element are: (87). The derivative by L, which D_s and D_t are up to the sign or 0, is at
// most h^(r+1) sum C(p,j) max |e_j'|: (88) over sigma; by lengths in the parameter plane it is 1/h of that.
// The normal is that of a line of the slope dz/dx, also on the interpolant; the angle of the line, its
// arctangent, changes by no more than the slope, and the normal by no more than the angle: (90) with the same
// constant and h^r.
//
// Checked      equation_87_uniform: each step exactly, p = 1 to 8 and r = 1 to 6, maxima by Bernstein
//              coefficients; and the bounds at points of elements, computed from the chart itself.
// Not checked  other surfaces.

#include <algorithm>
#include <string>
#include <vector>

#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/scalar/real.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

constexpr int largest_power = 8;
constexpr int largest_degree = 6;

Rational binomial(int n, int k) {
  Rational result = 1;
  for (int i = 1; i <= k; ++i) result = result * Rational(n - k + i) / Rational(i);
  return result;
}

RationalPolynomial monomial(int exponent) {
  RationalPolynomial result = 1;
  for (int k = 0; k < exponent; ++k) result *= RationalPolynomial::variable();
  return result;
}

// I_r f for values of f at i/r, i = 0, ..., r.
RationalPolynomial interpolated(const std::vector<Rational>& values) {
  const int r = static_cast<int>(values.size()) - 1;
  RationalPolynomial sum;
  for (int i = 0; i <= r; ++i) {
    RationalPolynomial l = values.at(static_cast<std::size_t>(i));
    for (int k = 0; k <= r; ++k)
      if (k != i) l *= (Rational(r) * RationalPolynomial::variable() - k) * Rational(1, i - k);
    sum += l;
  }
  return sum;
}

// e_j for I_r.
RationalPolynomial left_over(int j, int r) {
  std::vector<Rational> values;
  for (int i = 0; i <= r; ++i) values.push_back(power(Rational(i, r), j));
  return monomial(j) - interpolated(values);
}

// The largest of the sizes of the Bernstein coefficients on [0,1], which is at least the maximum there.
Rational bound_on_the_interval(const RationalPolynomial& p) {
  Rational largest = 0;
  for (int k = 0; k <= p.degree(); ++k) {
    Rational b = 0;
    for (int i = 0; i <= k; ++i)
      b += binomial(k, i) / binomial(p.degree(), i) * p.coefficient(static_cast<std::size_t>(i));
    largest = std::max(largest, abs(b));
  }
  return largest;
}

struct Constants {
  Rational point;       ///< of (87)
  Rational derivative;  ///< of (88) over sigma, and of (90)
};

Constants constants(int p, int r) {
  Constants sum;
  for (int j = r + 1; j <= p; ++j) {
    const RationalPolynomial e = left_over(j, r);
    sum.point += binomial(p, j) * bound_on_the_interval(e);
    sum.derivative += binomial(p, j) * bound_on_the_interval(e.derivative());
  }
  return sum;
}

// Coefficients of e_j for j <= degree and I_r.
Rational not_reproduced(int degree, int r) {
  long count = 0;
  for (int j = 0; j <= degree; ++j) {
    const RationalPolynomial e = left_over(j, r);
    for (int k = 0; k <= e.degree(); ++k)
      if (e.coefficient(static_cast<std::size_t>(k)).sign() != 0) ++count;
  }
  return {count};
}

// Points of a triangle at which interpolation of x_1^j at the lattice of degree r is not I_r of it at x_1, or
// at x_1 + x_2, where both coordinates are those of the function.
Rational unlike_one_variable(int r, bool of_one_coordinate) {
  const InsetFamily family(r);
  long count = 0;
  for (int j = 0; j <= largest_power; ++j) {
    const RationalPolynomial one_variable = monomial(j) - left_over(j, r);
    // Both sides are polynomials of degree r: their values at a lattice of degree r decide.
    for (int a = 0; a <= r; ++a)
      for (int b = 0; a + b <= r; ++b) {
        const Barycentric<Rational> x{
            {Rational(a + 1, r + 3), Rational(b + 1, r + 3), Rational(r + 1 - a - b, r + 3)}};
        Rational sum = 0;
        for (std::size_t node = 0; node < family.size(); ++node) {
          const auto q = family.node(node);
          const Rational at = of_one_coordinate ? q[0](0) : q[0](0) * q[1](0);
          sum += power(at, j) * family.value(node, x)(0);
        }
        if (sum != one_variable(of_one_coordinate ? x.x[0] : x.x[0] * x.x[1])) ++count;
      }
  }
  return {count};
}

// Points L of elements where x^p less its interpolant, or the derivative of it by L, is beyond its constant
// times h^(r+1+further).
Rational points_beyond(int p, int r, const Constants& c, int further) {
  constexpr long parts = 7;
  long count = 0;
  for (const Rational& h : {Rational(1), Rational(1, 3), Rational(1, 64)})
    for (const Rational& x_0 : {Rational(0), (1 - h) / 2, 1 - h}) {
      const RationalPolynomial x = RationalPolynomial(x_0) + h * RationalPolynomial::variable();
      RationalPolynomial z = 1;
      for (int k = 0; k < p; ++k) z *= x;
      std::vector<Rational> values;
      for (int i = 0; i <= r; ++i) values.push_back(power(x_0 + h * Rational(i, r), p));
      const RationalPolynomial error = z - interpolated(values);
      const Rational scale = power(h, r + 1 + further);
      for (long i = 0; i <= parts; ++i) {
        const Rational at(i, parts);
        if (abs(error(at)) > c.point * scale || abs(error.derivative()(at)) > c.derivative * scale) ++count;
      }
    }
  return {count};
}

}  // namespace

Finding equation_87_uniform(const Bench&) {
  const IsExactly zero{0};
  Finding finding;
  for (int r = 1; r <= largest_degree; ++r) {
    const std::string of = ", r = " + std::to_string(r);
    finding.require("coefficients of L^j - I_r L^j, j <= r" + of, zero, not_reproduced(r, r));
    finding.control("the same, j <= r + 1" + of, zero, not_reproduced(r + 1, r));
    finding.require("points where the interpolant of x_1^j on a triangle is not I_r of it" + of, zero,
                    unlike_one_variable(r, true));
    finding.control("the same for (x_1 x_2)^j" + of, zero, unlike_one_variable(r, false));
    Rational beyond = 0;
    Rational beyond_one_more = 0;
    for (int p = 1; p <= largest_power; ++p) {
      const Constants c = constants(p, r);
      beyond += points_beyond(p, r, c, 0);
      beyond_one_more += points_beyond(p, r, c, 1);
    }
    finding.require("points beyond the constants times h^(r+1), p = 1 to 8" + of, zero, beyond);
    finding.control("the same with h^(r+2)" + of, zero, beyond_one_more);
    const Constants largest = constants(largest_power, r);
    finding.remark("constant of (87), p = 8" + of, {.value = largest.point.to_double(), .radius = 0});
    finding.remark("constant of (88) over sigma and of (90), p = 8" + of,
                   {.value = largest.derivative.to_double(), .radius = 0});
  }
  return finding;
}

}  // namespace radcert::verification::ac98
