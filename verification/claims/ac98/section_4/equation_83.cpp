// SPDX-License-Identifier: GPL-3.0-or-later

// The kernel beside an edge is homogeneous: G(hP,hQ) h^2 = G(P,Q). So the integral over a square of the size
// h at the edge, seen from a point at distances of the order h, does not depend on h, (84), and for a
// quadratic u the error over it is h^2 times a number, (86).
//
// Checked      equation_83: the order of max |K(I - P_n)u| over the nodes is 2 and no more, on (20) and on a
//              box, alpha = 1/6, and what E_n/h^2 tends to: the rest of the integral is O(h^2) too.
//              equation_84: that identity, of polynomials in h, a, b, s and t, which the change of variables
//              (84) makes one of integrals; I_h(a,b) for several h, by enclosed double integrals, against
//              (22). equation_86: u - P_n u at (sh,th) over h^2, as an identity in s, t and h for every
//              quadratic u; e_h over h^2 by enclosed double integrals; and that it is not zero at the nodes,
//              which is what takes the superconvergence.
//              equation_86_remainder: that the rest of the integral neither exceeds h^2 nor takes e_h away,
//              for all h = 1/N. On a uniform mesh u - P_n u = h^2 q on every square alike. q is
//              orthogonal to the linear functions, by (71), so that the square (i,j) adds at most (1/2) Int
//              |q| max |D^2 g|, g = b eta/(delta^2 + eta^2 + b^2)^2, |D^2 g| <= 36 b/r^5, to K(I - P_n)u/h^2:
//              35 squares are enclosed and those beyond summed. From above K(I - P_n)u is at most (rho/2) max
//              |u - P_n u| in any case.
// Not checked  other u than quadratic ones; that the number is not zero, but at four points.

#include <array>
#include <string>
#include <vector>

#include "radcert/closed_form/two_squares.h"
#include "radcert/enclosure/square_integral.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/scalar/real.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/claims/ac98/surfaces/exact_plane.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

// Double integral over [0,1]^2.
Ball enclosed(const SquareFunction& f, double radius = 1e-13) {
  const std::array<SquareFunction, 1> one{f};
  return known(integral_over_squares(one, {.radius = radius}));
}

struct PlacePair {
  Rational a;
  Rational b;
};
// Two nodes of the first square of S_xz, and two other points.
std::vector<PlacePair> places() {
  const Rational sixth(1, 6);
  return {{2 * sixth, sixth},
          {5 * sixth, sixth},
          {Rational(1, 2), Rational(1, 3)},
          {Rational(1, 10), Rational(9, 10)}};
}

// I_h(a,b) over [0,h]^2 in the variables xi and eta.
Ball corner_integral(const Rational& h, const PlacePair& at) {
  return enclosed(square_function([h, at]<class R>(const R& s, const R& t) -> R {
    const R size = from_rational<R>(h);
    const R x = from_rational<R>(at.a * h);
    const R z = from_rational<R>(at.b * h);
    return size * size * two_squares_kernel<R>(x, z, size * s, size * t);
  }));
}

// The linear interpolant of x^power at the inset nodes of the triangle with the vertices (0,0), (h,0), (h,h),
// below the diagonal, or (0,0), (h,h), (0,h), above it: the plane through the three values, by exact
// elimination.
struct Plane3 {
  Rational constant;
  Rational by_x;
  Rational by_y;
};

// xi^i eta^j.
struct Power {
  int i;
  int j;
  template <class R>
  [[nodiscard]] R operator()(const R& xi, const R& eta) const {
    return power(xi, i) * power(eta, j);
  }
};

Plane3 interpolant_of(const Power& u, const Rational& h, bool below) {
  const Rational alpha(1, 6);
  using Point = std::array<Rational, 2>;
  const std::array<Point, 3> v =
      below ? std::array<Point, 3>{{{0, 0}, {h, 0}, {h, h}}} : std::array<Point, 3>{{{0, 0}, {h, h}, {0, h}}};
  std::array<Point, 3> q;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 2; ++c)
      q.at(i).at(c) = (1 - 3 * alpha) * v.at(i).at(c) + alpha * (v[0].at(c) + v[1].at(c) + v[2].at(c));
  const Rational x1 = q[1][0] - q[0][0];
  const Rational y1 = q[1][1] - q[0][1];
  const Rational x2 = q[2][0] - q[0][0];
  const Rational y2 = q[2][1] - q[0][1];
  const Rational f0 = u(q[0][0], q[0][1]);
  const Rational f1 = u(q[1][0], q[1][1]) - f0;
  const Rational f2 = u(q[2][0], q[2][1]) - f0;
  const Rational determinant = x1 * y2 - x2 * y1;
  const Rational by_x = (f1 * y2 - f2 * y1) / determinant;
  const Rational by_y = (x1 * f2 - x2 * f1) / determinant;
  return {.constant = f0 - by_x * q[0][0] - by_y * q[0][1], .by_x = by_x, .by_y = by_y};
}

Rational error_at(const Power& u, const Rational& h, bool below, const Rational& x, const Rational& y) {
  const Plane3 plane = interpolant_of(u, h, below);
  return u(x, y) - plane.constant - plane.by_x * x - plane.by_y * y;
}

// Points of a grid where u - P_n u at (sh,th) is not h^2 times the same for h = 1. By Cramer's rule both
// sides are polynomials over h^2 of degree 4 in h, and of degree 2 in s and t, for a quadratic u: five values
// of h and three of s and t prove an identity.
Rational points_out_of_scale(const Power& u) {
  long count = 0;
  for (const bool below : {true, false})
    for (const Rational& h : {Rational(1, 2), Rational(1, 7), Rational(3, 1000), Rational(2), Rational(5, 3)})
      for (long i = 0; i <= 4; ++i)
        for (long j = 0; j <= 4; ++j) {
          const Rational s(i, 4);
          const Rational t(j, 4);
          if (error_at(u, h, below, s * h, t * h) != h * h * error_at(u, 1, below, s, t)) ++count;
        }
  return {count};
}

// Points of a grid in a, b, s and t where G(hP,hQ) h^exponent is not G(P,Q), both over the common
// denominator, as polynomials in h. These have degree 6 at most in each of a, b, s and t, so that seven
// values of each prove an identity: with exponent 2, and in all five.
Rational points_not_homogeneous(int exponent) {
  constexpr long values = 7;
  const RationalPolynomial h = RationalPolynomial::variable();
  const auto to_the = [&](int n) {
    RationalPolynomial result = 1;
    for (int k = 0; k < n; ++k) result *= h;
    return result;
  };
  // z eta and the square of the distance, x, z, xi and eta being a, b, s and t times a length.
  struct Parts {
    RationalPolynomial numerator;
    RationalPolynomial square;
  };
  const auto parts = [](const RationalPolynomial& length, const std::array<Rational, 4>& at) {
    const auto& [a, b, s, t] = at;
    const RationalPolynomial offset = (a - s) * length;
    const RationalPolynomial z = b * length;
    const RationalPolynomial eta = t * length;
    return Parts{z * eta, offset * offset + eta * eta + z * z};
  };
  long count = 0;
  for (long i = 0; i < values; ++i)
    for (long j = 1; j <= values; ++j)
      for (long k = 0; k < values; ++k)
        for (long l = 1; l <= values; ++l) {
          const std::array<Rational, 4> at{Rational(i, 3), Rational(j, 5), Rational(k, 7), Rational(l, 2)};
          const Parts scaled = parts(h, at);
          const Parts whole = parts(1, at);
          if (scaled.numerator * to_the(exponent) * whole.square * whole.square !=
              whole.numerator * scaled.square * scaled.square)
            ++count;
        }
  return {count};
}

// The same over the square [ih, (i+1)h] x [jh, (j+1)h], from (ah,0,bh): the triangle below the diagonal in
// (xi, eta) = (h p, h p w), the one above in (h p w, h p). u less its interpolant is that of the square at
// the edge, which holds for a quadratic u.
Ball square_error(const Power& u, const Rational& h, const PlacePair& at, long i, long j, double radius) {
  const auto part = [&](bool below) {
    const Plane3 plane = interpolant_of(u, h, below);
    return square_function([u, h, at, plane, below, i, j]<class R>(const R& p, const R& w) -> R {
      const R size = from_rational<R>(h);
      const R far = size * p;
      const R near = far * w;
      const R xi = below ? far : near;
      const R eta = below ? near : far;
      const R error = u(xi, eta) - from_rational<R>(plane.constant) - from_rational<R>(plane.by_x) * xi -
                      from_rational<R>(plane.by_y) * eta;
      return size * far * error *
             two_squares_kernel<R>(from_rational<R>(at.a * h), from_rational<R>(at.b * h),
                                   xi + from_rational<R>(h * Rational(i)),
                                   eta + from_rational<R>(h * Rational(j)));
    });
  };
  return enclosed(part(true), radius) + enclosed(part(false), radius);
}

// e_h(ah,0,bh), over [0,h]^2.
Ball corner_error(const Power& u, const Rational& h, const PlacePair& at) {
  return square_error(u, h, at, 0, 0, 1e-13);
}

// The halves of the unit square, cut from (0,0) to (1,1).
std::vector<PlanarTriangle> halves_of_the_square() {
  return {{PlanarPoint{0, 0}, PlanarPoint{1, 0}, PlanarPoint{1, 1}},
          {PlanarPoint{0, 0}, PlanarPoint{1, 1}, PlanarPoint{0, 1}}};
}

// Linear functions that are not orthogonal to q, u = xi^2.
Rational not_orthogonal(const Rational& alpha) {
  long count = 0;
  for (const ExactPolynomial& phi : monomials(1))
    if (interpolation_error(phi, ExactPolynomial::monomial(2, 0), halves_of_the_square(), alpha) != 0)
      ++count;
  return {count};
}

// Int q^2, whose root is at least Int |q|.
Rational square_of_q() {
  Rational sum = 0;
  for (const PlanarTriangle& tau : halves_of_the_square()) {
    const ExactPolynomial u = ExactPolynomial::monomial(2, 0);
    const ExactPolynomial q = u - interpolant(tau, Rational(1, 6), u);
    sum += (q * q).integral_over({tau.begin(), tau.end()});
  }
  return sum;
}

constexpr long near_squares = 6;

// A bound for all squares with max(i,j) >= 6: 2k + 1 of them have the maximum k, and lie at least k - 1/2
// away from a point with 0 < a, b < 1/2; the sum over k of (2k + 1)/(k - 1/2)^5 <= sum of 2 (k - 1/2)^-4 + 2
// (k - 1/2)^-5 is at most the first term and Int from 6 - 1/2 on.
Ball beyond_the_near(const PlacePair& at) {
  const Rational first = Rational(near_squares) - Rational(1, 2);
  const auto inverse = [&](int n) { return 1 / power(first, n); };
  const Rational sum = 2 * (inverse(4) + inverse(3) / 3) + 2 * (inverse(5) + inverse(4) / 4);
  return Ball(Rational(36, 2) * at.b * sum) * sqrt(Ball(square_of_q()));
}

// What |K(I - P_n)u| pi/(rho h^2) cannot fall below at (ah,0,bh), h = 1/N: N^2 squares, by their absolute
// values.
Ball lower_bound(const Power& u, const PlacePair& at, const Ball& beyond) {
  constexpr double radius = 1e-7;
  Ball rest(0);
  for (long i = 0; i < near_squares; ++i)
    for (long j = 0; j < near_squares; ++j)
      if (i + j > 0) rest += abs(square_error(u, 1, at, i, j, radius));
  return abs(square_error(u, 1, at, 0, 0, radius)) - rest - beyond;
}

}  // namespace

Finding equation_83(const Bench& bench) {
  const Order two = Order::is(2);
  const int level = bench.budget == Budget::quick ? 2 : 3;
  constexpr int finest_of_squares = 4;
  Finding finding;
  const auto order_of = [&](const Problem& problem, int first, int last) {
    return observed_order(discretisation_errors(bench, problem, levels_from(first, last)));
  };
  const Problem squares = linear_problem_with_solution("two_squares", {}, "1/2", "x^2");
  const Problem box =
      linear_problem_with_solution("box", {{"a", 1}, {"b", 2}, {"c", 5}}, "1/2", "x^2 + y^2 + z^2");
  const ObservedOrder on_squares = order_of(squares, 1, finest_of_squares);
  finding.require("order of |K(I - P_n)u|, (20), u = x^2", two, on_squares);
  finding.require("order of |K(I - P_n)u|, box (1,2,5), u = x^2 + y^2 + z^2", two, order_of(box, 0, level));
  finding.control("order of |K(I - P_n)u|, (20), centroid rule", two, order_of(by_centroids(squares), 1, 3));
  const SurfaceParameter square{"p", 2};
  finding.control(
      "order of |K(I - P_n)u|, two_piece(2), a smooth surface", two,
      order_of(linear_problem_with_solution("two_piece", {square}, "1", "1/sqrt(x^2 + y^2 + (z-1/2)^2)"), 1,
               3));
  for (int at = 2; at <= finest_of_squares; ++at) {
    const Approximation error = bench.levels.level(squares, at).result.discretisation_error.value();
    const double per_square = std::ldexp(1.0, 2 * at);  // 1/h^2
    finding.remark("E_n/h^2, (20), u = x^2, h = 2^-" + std::to_string(at),
                   {.value = error.value * per_square, .radius = as_sampled(error).radius * per_square});
  }
  finding.show(on_squares.exponent);
  return finding;
}

Finding equation_84(const Bench&) {
  const BallPrecision precision(96);
  Finding finding;
  finding.require("points of a grid in a, b, s, t where G(hP,hQ) h^2 is not G(P,Q) for all h", IsExactly{0},
                  points_not_homogeneous(2));
  finding.control("the same with h for h^2", IsExactly{0}, points_not_homogeneous(1));
  for (const PlacePair& at : places()) {
    const AgreesWith printed{.value = TwoSquares<Ball>(Ball(at.a), Ball(at.b)).one(), .within = 1e-12};
    const std::string where = ", a = " + at.a.to_text() + ", b = " + at.b.to_text();
    for (const Rational& h : {Rational(1, 2), Rational(1, 1000)})
      finding.require("I_h(a,b) against (22) at (a,b), h = " + h.to_text() + where, printed,
                      corner_integral(h, at));
    finding.control("I_h with b halved" + where, printed, corner_integral(Rational(1, 2), {at.a, at.b / 2}));
  }
  return finding;
}

Finding equation_86(const Bench&) {
  const BallPrecision precision(96);
  Finding finding;
  for (const auto& [name, u] :
       {std::pair<std::string, Power>{"xi^2", {2, 0}}, {"xi eta", {1, 1}}, {"eta^2", {0, 2}}})
    finding.require("points where u - P_n u at (sh,th) is not h^2 q_i(s,t), u = " + name, IsExactly{0},
                    points_out_of_scale(u));
  finding.control("the same for u = xi^3, no quadratic one", IsExactly{0}, points_out_of_scale({3, 0}));
  finding.require("points of a grid in a, b, s, t where G(hP,hQ) h^2 is not G(P,Q) for all h", IsExactly{0},
                  points_not_homogeneous(2));
  const Power square{2, 0};
  const AtMost not_zero{
      .value = -1e-6, .slack = 0, .why = "a number c != 0, far beyond the enclosure, makes h^2 the order"};
  for (const PlacePair& at : places()) {
    const Ball one = corner_error(square, 1, at);
    const std::string where = ", a = " + at.a.to_text() + ", b = " + at.b.to_text();
    const AgreesWith number{.value = one, .within = 1e-11};
    for (const Rational& h : {Rational(1, 2), Rational(1, 16)}) {
      finding.require("e_h(ah,0,bh)/h^2 against its value for h = 1, h = " + h.to_text() + where, number,
                      corner_error(square, h, at) / Ball(h * h));
      finding.control("the same for u = xi^3 against it, h = " + h.to_text() + where, number,
                      corner_error({3, 0}, h, at) / Ball(h * h));
    }
    finding.require("-|e_h(ah,0,bh)|/h^2" + where, not_zero, proved(-abs(one)));
    finding.remark("e_h(ah,0,bh)/h^2" + where, proved(one));
  }
  // xi is linear, and interpolated exactly.
  finding.control("-|e_h(ah,0,bh)| for u = xi, h = 1, a = 1/3, b = 1/6", not_zero,
                  proved(-abs(corner_error({1, 0}, 1, places().front()))));
  finding.show(proved(corner_error(square, 1, places().front())));
  return finding;
}

Finding equation_86_remainder(const Bench&) {
  const BallPrecision precision(96);
  Finding finding;
  const PlacePair node = places().front();
  finding.require("linear functions that are not orthogonal to q", IsExactly{0},
                  not_orthogonal(Rational(1, 6)));
  finding.control("the same for alpha = 1/10", IsExactly{0}, not_orthogonal(Rational(1, 10)));
  const LiesIn above_zero{Rational(1, 1000), 1};
  const Ball beyond = beyond_the_near(node);
  const Ball bound = lower_bound({2, 0}, node, beyond);
  finding.remark("bound of what the squares beyond 6 h add", proved(beyond));
  finding.require("least |K(I - P_n)u| pi/(rho h^2) at the node a = 1/3, b = 1/6, u = xi^2, every h = 1/N",
                  above_zero, bound);
  finding.control("the same for u = xi, whose q is 0", above_zero, lower_bound({1, 0}, node, Ball(0)));
  finding.show(proved(bound));
  return finding;
}

}  // namespace radcert::verification::ac98
