// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <concepts>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// The number of points of the evenly spaced lattice of degree r on a triangle: (r + 1)(r + 2) / 2.
constexpr std::size_t interpolation_points(int degree) {
  return static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
}

/// A map of the unit triangle into space, polynomial of degree r, given on the evenly spaced lattice.
/// Maths     F(s,t) = F(0,0) + sum_{0 < i+j <= r} binom(r s, i) binom(r t, j) d_ij,  d_ij = Delta_s^i
///           Delta_t^j F at (0,0) with steps 1/r: Newton's form of the one polynomial of degree r with the
///           given F(a/r, b/r), a + b <= r
/// Source    [ac98, section 4.1], the m~_k there; Newton's form in two variables is classical
/// Requires  1 <= degree <= 6, interpolation_points(degree) values, else ContractViolation
/// Result    the polynomial whose differences are those of the given values as Number rounds them: with exact
///           numbers the values themselves on the lattice. Values are taken as differences to the corner
///           F(0,0), so that an element of size h far from the origin keeps its bends to a part u/h and not
///           u/h^2
/// Limits    above degree 6 evenly spaced points interpolate badly, and no statement needs them
template <Field R>
class LatticePolynomial {
public:
  static constexpr int smallest_degree = 1;
  static constexpr int largest_degree = 6;

  /// from_corner: F(a/r, b/r) - F(0,0), a ascending, then b; the first is zero.
  template <class Number>
  LatticePolynomial(int degree, const Vector<Number>& corner, const std::vector<Vector<Number>>& from_corner)
      : degree_(degree), corner_(in_arithmetic(corner)) {
    expects(smallest_degree <= degree && degree <= largest_degree, "1 <= degree <= 6",
            named("degree", degree));
    expects(from_corner.size() == interpolation_points(degree), "a value for each point of the lattice",
            named("values", from_corner.size()));
    std::vector<Vector<Number>> d = from_corner;
    for (int order = 1; order <= degree; ++order) {
      for (int a = degree; a >= order; --a)
        for (int b = 0; a + b <= degree; ++b) d[place(a, b)] = d[place(a, b)] - d[place(a - 1, b)];
      for (int b = degree; b >= order; --b)
        for (int a = 0; a + b <= degree; ++a) d[place(a, b)] = d[place(a, b)] - d[place(a, b - 1)];
    }
    for (const Vector<Number>& difference : d) differences_.push_back(in_arithmetic(difference));
  }

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const Binomials<T> in_s = binomials(s);
    const Binomials<T> in_t = binomials(t);
    Vector<T> f = term(0, 1, in_t[at(1)]);
    for (int b = 2; b <= degree_; ++b) f = f + term(0, b, in_t[at(b)]);
    for (int a = 1; a <= degree_; ++a) {
      f = f + term(a, 0, in_s[at(a)]);
      for (int b = 1; a + b <= degree_; ++b) f = f + term(a, b, in_s[at(a)] * in_t[at(b)]);
    }
    return {corner_.x + f.x, corner_.y + f.y, corner_.z + f.z};
  }

private:
  template <class T>
  using Binomials = std::array<T, static_cast<std::size_t>(largest_degree)>;

  static std::size_t at(int order) { return static_cast<std::size_t>(order - 1); }

  /// The place of the lattice point (a, b): before it lie a columns of degree + 1, degree, ... points.
  std::size_t place(int a, int b) const {
    return static_cast<std::size_t>(a * (2 * degree_ + 3 - a) / 2 + b);
  }

  template <Field T>
  Vector<T> term(int a, int b, const T& binomials) const {
    const Vector<R>& d = differences_[place(a, b)];
    return {d.x * binomials, d.y * binomials, d.z * binomials};
  }

  /// binom(r x, k), k = 1, ..., r.
  template <Field T>
  Binomials<T> binomials(const T& x) const {
    Binomials<T> binomial;
    binomial[0] = R(degree_) * x;
    for (int k = 2; k <= degree_; ++k)
      binomial[at(k)] = (R(1) / R(k)) * (binomial[at(k - 1)] * (R(1 - k) + binomial[0]));
    return binomial;
  }

  template <class Number>
  static Vector<R> in_arithmetic(const Vector<Number>& v) {
    return {entered(v.x), entered(v.y), entered(v.z)};
  }
  /// Rounded as R rounds; doubles are exact where R is.
  template <class Number>
  static R entered(const Number& x) {
    if constexpr (std::constructible_from<R, const Number&>) {
      return R(x);
    } else {
      return from_rational<R>(Rational::exactly(x));
    }
  }

  int degree_;
  Vector<R> corner_;
  std::vector<Vector<R>> differences_;  ///< d_ij at place(i, j); that at place(0, 0) is zero and not used
};

/// The interpolant of one element of a chart, a chart of its own.
/// Maths     m~(s,t) = sum over the lattice of m(a/r, b/r) l_ab(s,t) on 0 <= s, t, s + t <= 1, where
///           m(s,t) = F(v_1 + s (v_2 - v_1) + t (v_3 - v_1));  max |m - m~| = O(h^(r+1)), derivatives and
///           normals O(h^r)
/// Source    [ac98, section 4.1, (87)-(90)]
/// Requires  1 <= degree <= 6, else ContractViolation; vertices counter-clockwise, in the chart's domain
/// Result    domain unit_triangle, piece and orientation of the chart; analytic whatever the chart is; degree
///           1 is flat, and its plane is the exact one of its formula; the elements of a flat chart that is
///           not affine are flat where their rounded points lie in one plane, as those of a horizontal disk
///           do. Two elements with a common side have interpolants that agree on it up to rounding
/// Limits    across a common side the normals differ by O(h^r): the charts of a piece join continuously only
Chart interpolated_chart(const Chart& chart, const std::array<ParameterPoint<double>, 3>& vertices,
                         int degree, std::string name);

}  // namespace radcert
