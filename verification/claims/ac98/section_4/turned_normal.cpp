// SPDX-License-Identifier: GPL-3.0-or-later

// On a closed convex surface each direction w of the half-sphere about the inner normal n at P leads to one
// Q, and cos(theta_Q) dS/|P-Q|^2 is the element of directions: Int G u = Int (w.n) u(Q(w)) dw. With a normal
// n' = cos(delta) n + sin(delta) e in the place of n, e at a right angle to n, the factor is w.n',
// negative on a rim as narrow as delta, where G is taken as it stands.
//   u = 1: the mean of w is along n, so that Int G' = pi cos(delta) on every such surface: what is missing
//   is pi delta^2/2, O(h^(2r)) for delta = O(h^r). The change of the first order in delta cancels.
//   u = x on the unit sphere, with the axes along e and n, P = -n: Q = P + 2 (w.n) w, so that Int G' u =
//   2 sin(delta) Int (w.n) (w.e)^2 dw = (pi/2) sin(delta), of the first order. For u = y, the third axis, it
//   is 0.
//
// Checked      section_4_1_no_cancellation: these integrals, exactly, by the moments of the half-sphere, Int
//              (w.e)^i (w.f)^j (w.n)^k dw; and G itself with the turned normal over the sphere by a product
//              rule.
// Not checked  other surfaces, but by the argument above for u = 1.

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "radcert/geometry/vector.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/polynomial/rules/gauss.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// Int (w.e)^i (w.f)^j (w.n)^k dw over the half-sphere w.n >= 0, over pi: with c = w.n the integral of c^k (1
// - c^2)^((i+j)/2) dc times that of cos^i sin^j over a turn, which is 0 unless i and j are even, and else 2
// pi (i-1)!! (j-1)!!/(i+j)!!.
Rational moment(int i, int j, int k) {
  if (i % 2 != 0 || j % 2 != 0) return 0;
  const RationalPolynomial c = RationalPolynomial::variable();
  RationalPolynomial f = 1;
  for (int m = 0; m < k; ++m) f *= c;
  for (int m = 0; m < (i + j) / 2; ++m) f *= 1 - c * c;
  Rational integral = 0;
  for (int m = 0; m <= f.degree(); ++m)
    integral += f.coefficient(static_cast<std::size_t>(m)) / Rational(m + 1);
  const auto double_factorial = [](int n) {
    Rational product = 1;
    for (int m = n; m > 1; m -= 2) product *= m;
    return product;
  };
  return 2 * integral * double_factorial(i - 1) * double_factorial(j - 1) / double_factorial(i + j);
}

enum class Density { one, along_the_turn, across_it };

/// Int G' u = pi (cosine cos(delta) + sine sin(delta)) on the unit sphere.
struct Turned {
  Rational cosine;
  Rational sine;
};
Turned turned(Density u) {
  switch (u) {
    case Density::one: return {moment(0, 0, 1), moment(1, 0, 0)};
    case Density::along_the_turn: return {2 * moment(1, 0, 2), 2 * moment(2, 0, 1)};
    case Density::across_it: break;
  }
  return {2 * moment(0, 1, 2), 2 * moment(1, 1, 1)};
}

// The same integral over the unit sphere, from P = (0,0,-1), n = (0,0,1), by a product rule in the
// directions' angles.
double by_rule(Density u, double delta, int order) {
  const Vector<double> p{0, 0, -1};
  const Vector<double> normal{std::sin(delta), 0, std::cos(delta)};
  const IntervalRule<double> gauss = gauss_rule<double>(order, IntervalWeight::one);
  double sum = 0;
  for (std::size_t i = 0; i < gauss.nodes.size(); ++i)
    for (int j = 0; j < order; ++j) {
      // Q at the polar angle a from P: dS = sin(a) da db.
      const double a = std::numbers::pi * gauss.nodes[i];
      const double b = 2 * std::numbers::pi * j / order;
      const Vector<double> q{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), -std::cos(a)};
      const double weight = gauss.weights[i] * std::numbers::pi * std::sin(a) * 2 * std::numbers::pi / order;
      const double value = u == Density::one ? 1 : u == Density::along_the_turn ? q.x : q.y;
      sum += weight * value * geometric_kernel(p, normal, q, -q);
    }
  return sum;
}

}  // namespace

Finding section_4_1_no_cancellation(const Bench&) {
  Finding finding;
  const LiesIn not_zero{Rational(1, 100), 1};
  const Turned one = turned(Density::one);
  const Turned along = turned(Density::along_the_turn);
  const Turned across = turned(Density::across_it);

  finding.require("change of Int G over pi and the angle, to first order, closed convex surfaces, u = 1",
                  not_zero, Ball(one.sine));
  finding.instead("the same, unit sphere, u = x along the turn", not_zero, Ball(along.sine));
  finding.control("the same, unit sphere, u = y across the turn", not_zero, Ball(across.sine));
  finding.require("Int G over pi for the normal itself, u = 1", IsExactly{1}, one.cosine);
  finding.control("the same with the cosine twice in the kernel", IsExactly{1}, moment(0, 0, 2));
  constexpr int order = 40;
  constexpr double delta = 0.1;
  for (const auto& [name, u, expected] :
       {std::tuple<std::string, Density, Turned>{"u = 1", Density::one, one},
        {"u = x", Density::along_the_turn, along},
        {"u = y", Density::across_it, across}})
    finding.remark("Int G by a rule over the sphere, normal turned by 1/10, less pi (A cos + B sin), " + name,
                   {.value = by_rule(u, delta, order) -
                             std::numbers::pi * (expected.cosine.to_double() * std::cos(delta) +
                                                 expected.sine.to_double() * std::sin(delta)),
                    .radius = 1e-13});
  return finding;
}

}  // namespace radcert::verification::ac98
