// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      equation_33: as polynomials in alpha: the library's nodes are those printed, a permutation of
//              the coordinates permutes them; at alpha = 0 they are the vertices; for 0 < alpha < 1/3 all
//              coordinates are positive (their zeros, counted). equation_34: as polynomials in alpha,
//              l_i(q_j) = delta_ij and sum q_j l_j(x) = x at four points, three of which are not on a line,
//              for the printed l_i; the library's l_i are those. So L reproduces linear functions, takes the
//              values at the nodes, and L L = L: P_n of (35) and (36) is this on every element.
//              equation_36_jumps: for every alpha of 0 < alpha < 1/3 the interpolant of x^2 jumps at a
//              corner, by the zeros of a polynomial in alpha. For alpha = 0 each l_i is 0 on the side
//              opposite to its vertex, so that P_n g on a side is made of the values at its two ends, and
//              agrees with that of the element beyond, for every g, where both parametrise the side affinely
//              in each other. Beside that jumps of monomials along the common side of two triangles, exactly.
//              equation_38: one node, the centroid, l = 1: norm 1, constants reproduced, the rule of degree
//              1.
// Not checked  that P_n extends to L^infinity as a projection.

#include <array>

#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/lebesgue_constant.h"
#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/real_zeros.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/claims/ac98/surfaces/exact_plane.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// The printed nodes by (u, t, s).
std::array<std::array<RationalPolynomial, 3>, 3> printed_nodes() {
  const RationalPolynomial a = RationalPolynomial::variable();
  const auto from = [](const RationalPolynomial& s, const RationalPolynomial& t) {
    return std::array<RationalPolynomial, 3>{1 - s - t, t, s};
  };
  return {from(a, a), from(a, 1 - 2 * a), from(1 - 2 * a, a)};
}

// The numerators of the printed l_1, l_2, l_3, over 1 - 3 alpha, at (u, t, s).
template <class Coordinate>
std::array<RationalPolynomial, 3> printed_numerators(const std::array<Coordinate, 3>& at) {
  const RationalPolynomial a = RationalPolynomial::variable();
  return {RationalPolynomial(at[0]) - a, RationalPolynomial(at[1]) - a, RationalPolynomial(at[2]) - a};
}

// How many of l_i(q_j) are not delta_ij, with numerators divided by 1 - `pole` alpha.
Rational wrong_at_the_nodes(int pole) {
  const RationalPolynomial a = RationalPolynomial::variable();
  long count = 0;
  const auto nodes = printed_nodes();
  for (std::size_t j = 0; j < 3; ++j) {
    const auto l = printed_numerators(nodes.at(j));
    for (std::size_t i = 0; i < 3; ++i)
      count += l.at(i) == (i == j ? 1 - RationalPolynomial(pole) * a : RationalPolynomial()) ? 0 : 1;
  }
  return {count};
}

std::vector<Barycentric<Rational>> four_points() {
  return {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{Rational(1, 5), Rational(-2, 3), Rational(22, 15)}}};
}

// Monomials of a degree whose interpolants on the halves of a parallelogram differ somewhere on the common
// side.
Rational functions_that_jump(const Rational& alpha, int degree) {
  const PlanarTriangle below{PlanarPoint{0, 0}, PlanarPoint{2, 0}, PlanarPoint{3, 1}};
  const PlanarTriangle above{PlanarPoint{0, 0}, PlanarPoint{3, 1}, PlanarPoint{1, 1}};
  long count = 0;
  for (int b = 0; b <= degree; ++b) {
    const ExactPolynomial g = ExactPolynomial::monomial(degree - b, b);
    const ExactPolynomial jump = interpolant(below, alpha, g) - interpolant(above, alpha, g);
    if (jump(PlanarPoint{0, 0}) != 0 || jump(PlanarPoint{3, 1}) != 0) ++count;
  }
  return {count};
}

// The jump of P_n x^2 at the corner (0,0) of these two triangles, a polynomial in alpha: 1 - 3 alpha, in the
// denominators of l_i, divides it without a remainder, as for alpha = 1/3 all nodes are the centroid.
RationalPolynomial jump_of_the_square() {
  const RationalPolynomial a = RationalPolynomial::variable();
  const auto at_the_corner = [&](const std::array<Rational, 3>& x) {
    RationalPolynomial sum;
    for (std::size_t j = 0; j < 3; ++j) {
      RationalPolynomial place;
      for (std::size_t i = 0; i < 3; ++i) place += printed_nodes().at(j).at(i) * RationalPolynomial(x.at(i));
      sum += place * place * (RationalPolynomial(j == 0 ? 1 : 0) - a);
    }
    return sum;
  };
  const Division jump = divide(at_the_corner({0, 2, 3}) - at_the_corner({0, 3, 1}), 1 - 3 * a);
  return jump.remainder.is_zero() ? jump.quotient : RationalPolynomial();
}

// Functions l_i that are not zero on the side opposite to their vertex, for this alpha, at four points of it.
Rational functions_on_the_opposite_side(const Rational& alpha) {
  long count = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (const Rational& part : {Rational(0), Rational(1, 3), Rational(1), Rational(5, 2)}) {
      std::array<Rational, 3> x;
      x.at(i) = 0;
      x.at((i + 1) % 3) = part;
      x.at((i + 2) % 3) = 1 - part;
      if (printed_numerators(x).at(i)(alpha) != 0) ++count;
    }
  return {count};
}

}  // namespace

Finding equation_33(const Bench&) {
  Finding finding;
  const InsetFamily family(1);
  const auto nodes = printed_nodes();
  long differing = 0;
  long not_positive = 0;
  long not_permuted = 0;
  long not_vertices = 0;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalPolynomial& x = nodes.at(j).at(i);
      if (family.node(j).at(i) != x) ++differing;
      if (zeros_between(x, 0, Rational(1, 3)) != 0 || x(Rational(1, 6)).sign() <= 0) ++not_positive;
      if (x != nodes.at(0).at(i == j ? 0 : 1)) ++not_permuted;
      if (x(0) != Rational(i == j ? 1 : 0)) ++not_vertices;
    }
  finding.require("coordinates of the library's nodes that are not the printed ones", IsExactly{0},
                  Rational(differing));
  finding.require("coordinates that are not positive for all 0 < alpha <= 1/3", IsExactly{0},
                  Rational(not_positive));
  finding.require("coordinates that are not those of q_1 with two of them exchanged", IsExactly{0},
                  Rational(not_permuted));
  finding.require("coordinates that are not those of the vertices at alpha = 0", IsExactly{0},
                  Rational(not_vertices));
  finding.control("zeros of the coordinate 1 - 2 alpha in 0 < alpha <= 1", IsExactly{0},
                  Rational(zeros_between(nodes[0][0], 0, 1)));
  return finding;
}

Finding equation_34(const Bench&) {
  Finding finding;
  const RationalPolynomial a = RationalPolynomial::variable();
  const InsetFamily family(1);
  const auto nodes = printed_nodes();
  finding.require("pairs i, j with l_i(q_j) != delta_ij", IsExactly{0}, wrong_at_the_nodes(3));
  finding.control("the same with the denominator 1 - 2 alpha", IsExactly{0}, wrong_at_the_nodes(2));
  long not_reproduced = 0;
  long differing = 0;
  for (const Barycentric<Rational>& x : four_points()) {
    const auto l = printed_numerators(x.x);
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalPolynomial sum = nodes[0].at(i) * l[0] + nodes[1].at(i) * l[1] + nodes[2].at(i) * l[2];
      if (sum != (1 - 3 * a) * RationalPolynomial(x.x.at(i))) ++not_reproduced;
      if (differing_coefficients(family.value(i, x), {l.at(i), 1}) != 0) ++differing;
    }
  }
  finding.require("coordinates of four points that L does not reproduce", IsExactly{0},
                  Rational(not_reproduced));
  finding.require("values where the library's l_i are not the printed ones", IsExactly{0},
                  Rational(differing));
  const PlanarTriangle tau{PlanarPoint{0, 0}, PlanarPoint{2, 1}, PlanarPoint{Rational(1, 3), 3}};
  const auto not_projected = [&](const Rational& second) {
    long count = 0;
    for (const ExactPolynomial& g : monomials(4)) {
      const ExactPolynomial once = interpolant(tau, Rational(1, 6), g);
      if ((interpolant(tau, second, once * once) - interpolant(tau, Rational(1, 6), once * once)).size() !=
              0 ||
          (interpolant(tau, second, once) - once).size() != 0)
        ++count;
    }
    return Rational(count);
  };
  finding.require("monomials with L L g != L g", IsExactly{0}, not_projected(Rational(1, 6)));
  finding.control("monomials whose (L g)^2 has another interpolant at the nodes of alpha = 1/10",
                  IsExactly{0}, not_projected(Rational(1, 10)));
  return finding;
}

Finding equation_36_jumps(const Bench&) {
  Finding finding;
  const RationalPolynomial jump = jump_of_the_square();
  const Rational third(1, 3);
  finding.require("1 where P_n x^2 does not jump at a corner for an alpha of 0 < alpha <= 1/3", IsExactly{0},
                  Rational(!jump.is_zero() && zeros_between(jump, 0, third) == 0 ? 0 : 1));
  finding.control("1 where it does not for an alpha of -1 < alpha <= 1/3", IsExactly{0},
                  Rational(zeros_between(jump, -1, third) == 0 ? 0 : 1));
  finding.require("values of l_i on the side opposite to their vertex that are not 0, alpha = 0",
                  IsExactly{0}, functions_on_the_opposite_side(0));
  finding.control("the same, alpha = 1/6", IsExactly{0}, functions_on_the_opposite_side(Rational(1, 6)));
  for (const int degree : {0, 1})
    finding.require("monomials of degree " + std::to_string(degree) + " whose interpolant jumps, alpha = 1/6",
                    IsExactly{0}, functions_that_jump(Rational(1, 6), degree));
  for (const int degree : {2, 3, 4}) {
    const std::string of =
        "monomials of degree " + std::to_string(degree) + " whose interpolant jumps, alpha = ";
    finding.require(of + "0", IsExactly{0}, functions_that_jump(0, degree));
    for (const Rational& alpha : {Rational(1, 6), Rational(1, 10)})
      finding.require(of + alpha.to_text() + ", of " + std::to_string(degree + 1), IsExactly{degree + 1},
                      functions_that_jump(alpha, degree));
  }
  finding.control("monomials of degree 2 whose interpolant jumps, alpha = 0, of 3", IsExactly{3},
                  functions_that_jump(0, 2));
  finding.control("monomials of degree 2 whose interpolant jumps, alpha = 1/6, of 0", IsExactly{0},
                  functions_that_jump(Rational(1, 6), 2));
  return finding;
}

Finding equation_38(const Bench&) {
  Finding finding;
  const Rational third(1, 3);
  for (const Rational& alpha : {Rational(0), Rational(1, 6)}) {
    const InsetBasis<Rational> basis(0, alpha);
    const std::string at = ", alpha = " + alpha.to_text();
    const bool centroid = basis.nodes() == std::vector<Barycentric<Rational>>{{{third, third, third}}};
    finding.require("1 where the only node is not the centroid" + at, IsExactly{0},
                    Rational(centroid ? 0 : 1));
    for (const Barycentric<Rational>& x : four_points()) {
      std::array<Rational, 1> value;
      basis.values(x, std::span<Rational>(value));
      finding.require(
          "l at (" + x.x[0].to_text() + "," + x.x[1].to_text() + "," + x.x[2].to_text() + ")" + at,
          IsExactly{1}, value[0]);
    }
    const LagrangeFunctions functions = lagrange_functions(basis.nodes()).value();
    const LebesgueConstant norm = lebesgue_constant(functions, Rational(1, 1000));
    const AgreesWith unit{.value = Ball(1), .within = 1e-30};
    finding.require("norm of P_n, from below" + at, unit, Ball(norm.lower));
    finding.require("norm of P_n, from above" + at, unit, Ball(norm.upper));
    finding.require("degree of precision of its rule" + at, IsExactly{1},
                    Rational(degree_of_precision(interpolatory_rule(functions), Region::triangle).degree));
  }
  const LagrangeFunctions linear =
      lagrange_functions(InsetBasis<Rational>(1, Rational(1, 6)).nodes()).value();
  const Rational fifth(1, 5);
  std::array<Rational, 3> of_degree_1;
  InsetBasis<Rational>(1, fifth).values({{fifth, fifth, 1 - 2 * fifth}}, std::span<Rational>(of_degree_1));
  finding.control("l_1 of degree 1 at one of its nodes", IsExactly{1}, of_degree_1[0]);
  finding.control("norm of interpolation of degree 1, alpha = 1/6",
                  AgreesWith{.value = Ball(1), .within = 1e-30},
                  Ball(lebesgue_constant(linear, Rational(1, 1000)).lower));
  return finding;
}

}  // namespace radcert::verification::ac98
