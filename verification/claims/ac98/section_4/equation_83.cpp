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
// Not checked  other u than quadratic ones; that the number is not zero, but at four points.

#include <array>
#include <string>
#include <vector>

#include "radcert/closed_form/two_squares.h"
#include "radcert/enclosure/square_integral.h"
#include "radcert/polynomial/rational_polynomial.h"
#include "verification/claims/ac98/collocation/level_orders.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// Double integral over [0,1]^2, to within 1e-13.
Ball enclosed(const SquareFunction& f) {
  const std::array<SquareFunction, 1> one{f};
  return known(integral_over_squares(one, {.radius = 1e-13}));
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

// e_h(ah,0,bh) over [0,h]^2: the triangle below the diagonal in (xi, eta) = (h p, h p w), the one above in (h
// p w, h p).
Ball corner_error(const Power& u, const Rational& h, const PlacePair& at) {
  const auto part = [&](bool below) {
    const Plane3 plane = interpolant_of(u, h, below);
    return square_function([u, h, at, plane, below]<class R>(const R& p, const R& w) -> R {
      const R size = from_rational<R>(h);
      const R far = size * p;
      const R near = far * w;
      const R xi = below ? far : near;
      const R eta = below ? near : far;
      const R error = u(xi, eta) - from_rational<R>(plane.constant) - from_rational<R>(plane.by_x) * xi -
                      from_rational<R>(plane.by_y) * eta;
      return size * far * error *
             two_squares_kernel<R>(from_rational<R>(at.a * h), from_rational<R>(at.b * h), xi, eta);
    });
  };
  return enclosed(part(true)) + enclosed(part(false));
}

}  // namespace

Finding equation_83(const Bench& bench) {
  const Bound two{.order = 2, .slack = 0.2, .why = "one halving: the next power of h is left"};
  const AtMost no_more{.value = 2.5, .slack = 0, .why = "halfway to the order 3 of (78)"};
  const int level = bench.budget == Budget::quick ? 2 : 3;
  constexpr int finest_of_squares = 4;
  Finding finding;
  const auto order_of = [&](const Problem& problem, int finest) {
    return observed_order(bench.levels, problem, &LevelResult::discretisation_error, finest);
  };
  const Problem squares = linear_problem_with_solution("two_squares", {}, "1/2", "x^2");
  const Problem box =
      linear_problem_with_solution("box", {{"a", 1}, {"b", 2}, {"c", 5}}, "1/2", "x^2 + y^2 + z^2");
  const Approximation on_squares = order_of(squares, finest_of_squares);
  const Approximation on_box = order_of(box, level);
  finding.require("order of |K(I - P_n)u|, (20), u = x^2", two, on_squares);
  finding.require("order of |K(I - P_n)u|, (20), u = x^2", no_more, on_squares);
  finding.require("order of |K(I - P_n)u|, box (1,2,5), u = x^2 + y^2 + z^2", two, on_box);
  finding.require("order of |K(I - P_n)u|, box (1,2,5), u = x^2 + y^2 + z^2", no_more, on_box);
  Problem constant = squares;
  constant.method = Collocation{{.degree = 0, .alpha = Rational(0)}};
  finding.control("order of |K(I - P_n)u|, (20), centroid rule", two, order_of(constant, 3));
  const SurfaceParameter square{"p", 2};
  finding.control(
      "order of |K(I - P_n)u|, two_piece(2), a smooth surface", no_more,
      order_of(linear_problem_with_solution("two_piece", {square}, "1", "1/sqrt(x^2 + y^2 + (z-1/2)^2)"), 3));
  for (int at = 2; at <= finest_of_squares; ++at) {
    const Approximation error = bench.levels.level(squares, at).result.discretisation_error.value();
    const double per_square = std::ldexp(1.0, 2 * at);  // 1/h^2
    finding.remark("E_n/h^2, (20), u = x^2, h = 2^-" + std::to_string(at),
                   {.value = error.value * per_square, .radius = as_sampled(error).radius * per_square});
  }
  finding.show(on_squares);
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

}  // namespace radcert::verification::ac98
