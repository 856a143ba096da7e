// SPDX-License-Identifier: GPL-3.0-or-later

// The three bases.
//
// Checked      (16), for any number of sites at any distances r_i, by induction on their number, identities
//              of rational functions: the closed form without a division by zero is psi_i / sum_j psi_j, psi
//              = 1/r^2, rejected for 1/r^4; at r_j = 0 it is delta_ij; elements sum to 1. The library's form
//              is that one, for one to four sites. Near a site 1 - phi_j = u Q/(1 + u Q) <= u Q, u = r_j^2
//              and Q the sum of 1/r_i^2 over the others, however many, so that phi_j tends to 1 and the
//              others to 0 as u does; rejected for 1/(e + r^2). Two sites at one point, as on an edge, whose
//              normals have the cosine c: on the way to them along the first normal phi_1 is 1/(1 + c^2), at
//              any distance. (17): 1 at the centroid; the element of another site within 90 degrees and 4
//              alpha is positive there, so that it is not interpolated and the sum exceeds 1; rejected for
//              K, which is 0 beyond alpha. (18): as printed, with the normals in the place of the points,
//              all distances in a plane are 0 and all elements K(0); with the points they are the library's.
//              Figure 6: four sites on a line in a plane, at 0, 1, 2, 3, values 1, 3, 2, 4, radii 2: the
//              matrix phi_j(p_i) is regular for all three, by its determinant. With the values as
//              coefficients f interpolates for Shepard's basis alone; beside the sites not for Shepard's.
// Not checked  figure 6 itself, nor where its sites and radii are.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "radcert/meshless/radial_element.h"
#include "verification/claims/proved_number.h"
#include "verification/claims/psg10/element_lists.h"
#include "verification/claims/psg10/exact_sites.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using Sites = std::vector<Site<Rational>>;

using Function = RationalFunction;
using Row = std::vector<Function>;

constexpr std::size_t most_sites = 4;

Function symbol(const std::string& name) { return Function::variable(name); }
Row symbols(const std::string& name, std::size_t count) {
  Row row;
  for (std::size_t i = 0; i < count; ++i) row.push_back(symbol(name + std::to_string(i)));
  return row;
}

/// Terms in which the closed form that has no division by zero differs from psi_i / sum_j psi_j among any
/// number of sites, psi = S(r), or, to be rejected, S(r)^2.
Rational not_the_formula(bool squared) {
  const auto raw = [squared](const Function& r) {
    return squared ? inverse_square(r) * inverse_square(r) : inverse_square(r);
  };
  const Function next = symbol("r");
  const Rational otherwise = left_over_by_induction(
      OtherSites::none(), OtherSites::any(),
      [&](const OtherSites& before) { return before.with(next * next, raw(next)); },
      [](const OtherSites& others) {
        return differing_terms(others.without_one, others.product * others.inverses);
      });
  const Function own = symbol("r_i");
  const OtherSites others = OtherSites::any();
  return otherwise +
         differing_terms(shepard_element(own * own, others), raw(own) / (raw(own) + others.inverses));
}

/// Terms in which the library's form differs from that one, for one to four sites.
Rational not_of_library() {
  Rational terms(0);
  for (std::size_t count = 1; count <= most_sites; ++count) {
    const Row squares = symbols("u", count);
    const Row values = shepard_values<Function>(squares);
    for (std::size_t i = 0; i < count; ++i) {
      OtherSites others = OtherSites::none();
      for (std::size_t k = 0; k < count; ++k)
        if (k != i) others = others.with(squares[k], 1 / squares[k]);
      terms += differing_terms(values[i], shepard_element(squares[i], others));
    }
  }
  return terms;
}

/// Terms in which the closed form at a site is not delta_ij.
Rational not_delta() {
  const OtherSites with_own = OtherSites::any().with(0, symbol("psi_j"));
  return differing_terms(shepard_element(0, OtherSites::any()), 1) +
         differing_terms(shepard_element(symbol("u"), with_own), 0);
}

/// Negative coefficients of |p,p_j|^2 Q - (1 - phi_j), Q the sum of 1/|p,p_i|^2 over the others, whatever
/// their number; psi_j = 1/(shift + |p,p_j|^2).
Rational not_tending_to_one(const Function& shift) {
  const Function own = symbol("u");
  const Function others = symbol("Q");
  const Function raw = 1 / (shift + own);
  return negative_terms(own * others - (1 - raw / (raw + others)));
}

/// phi_1 at any distance from two sites at one point, with the normal of the first; c is the cosine of their
/// normals.
Function beside_two_at_one_point(const Function& cosine) {
  const Site<Function> p{{0, symbol("r"), 0}, {0, 0, 1}};
  const Site<Function> first{{0, 0, 0}, {0, 0, 1}};
  const Site<Function> second{{0, 0, 0}, {symbol("s"), 0, cosine}};
  return shepard_values<Function>(
             std::array{squared_site_distance(p, first), squared_site_distance(p, second)})
      .front();
}

/// The raw element (17) of a centroid at a distance along a flat line, uncut.
Ball gaussian_element(const Rational& distance) { return gaussian_bell(Ball(distance)); }

using Matrix4 = std::array<std::array<Rational, 4>, 4>;
using BallMatrix4 = std::array<std::array<Ball, 4>, 4>;

constexpr std::size_t four = 4;

Sites four_on_a_line() {
  Sites sites;
  for (long i = 0; i < 4; ++i) sites.push_back({{i, 0, 0}, {0, 0, 1}});
  return sites;
}

/// By expansion along the first row.
template <class R>
R determinant(const std::array<std::array<R, 4>, 4>& a) {
  const auto minor3 = [&](std::size_t c0, std::size_t c1, std::size_t c2) {
    return R(a[1][c0] * (a[2][c1] * a[3][c2] - a[2][c2] * a[3][c1]) -
             a[1][c1] * (a[2][c0] * a[3][c2] - a[2][c2] * a[3][c0]) +
             a[1][c2] * (a[2][c0] * a[3][c1] - a[2][c1] * a[3][c0]));
  };
  return a[0][0] * minor3(1, 2, 3) - a[0][1] * minor3(0, 2, 3) + a[0][2] * minor3(0, 1, 3) -
         a[0][3] * minor3(0, 1, 2);
}

/// phi_j at the sites, or at places beside them.
Matrix4 shepard_matrix(const Rational& beside = 0) {
  const Sites sites = four_on_a_line();
  Matrix4 a;
  for (std::size_t i = 0; i < four; ++i) {
    Site<Rational> p = sites[i];
    p.point.x += beside;
    const std::vector<Rational> row = shepard_elements(sites, p);
    for (std::size_t j = 0; j < four; ++j) a[i][j] = row[j];
  }
  return a;
}
Matrix4 lehtinen_matrix() {
  const Sites sites = four_on_a_line();
  Matrix4 a;
  for (std::size_t i = 0; i < four; ++i) {
    const std::vector<Rational> row = normalised(raw_lehtinen(sites, 2, sites[i]));
    for (std::size_t j = 0; j < four; ++j) a[i][j] = row[j];
  }
  return a;
}
BallMatrix4 gaussian_matrix() {
  BallMatrix4 a;
  for (std::size_t i = 0; i < four; ++i)
    for (std::size_t j = 0; j < four; ++j)
      a[i][j] = gaussian_element(Rational(static_cast<long>(i) - static_cast<long>(j), 2));
  return a;
}

template <class R>
BallMatrix4 in_balls(const std::array<std::array<R, 4>, 4>& a) {
  BallMatrix4 b;
  for (std::size_t i = 0; i < four; ++i)
    for (std::size_t j = 0; j < four; ++j) b[i][j] = Ball(a[i][j]);
  return b;
}

Site<Ball> in_balls(const Site<Rational>& site) {
  const auto of = [](const Vector<Rational>& v) { return Vector<Ball>{Ball(v.x), Ball(v.y), Ball(v.z)}; };
  return {of(site.point), of(site.normal)};
}

/// |f - value| at the sites, largest, with the values as coefficients.
Ball largest_miss(const BallMatrix4& a) {
  const std::array<long, four> values{1, 3, 2, 4};
  Ball largest(0);
  for (std::size_t i = 0; i < four; ++i) {
    Ball miss = -Ball(values[i]);
    for (std::size_t j = 0; j < four; ++j) miss += a[i][j] * Ball(values[j]);
    largest = max(largest, abs(miss));
  }
  return largest;
}

}  // namespace

Finding equation_16(const Bench&) {
  Finding finding;
  finding.require("terms in which the elements at a site are not delta_ij, any number of sites", IsExactly{0},
                  not_delta());
  finding.control("the same for the element at a place that is no site", IsExactly{0},
                  differing_terms(shepard_element(symbol("u"), OtherSites::any()), 0));
  finding.require("terms in which the elements are not psi_i over the sum of psi_j, any number of sites",
                  IsExactly{0}, not_the_formula(false));
  finding.control("the same, psi the fourth power of the inverse distance", IsExactly{0},
                  not_the_formula(true));
  finding.require("terms in which the library's elements are others, one to four sites", IsExactly{0},
                  not_of_library());
  finding.require("negative coefficients of |p,p_j|^2 Q - (1 - phi_j)", IsExactly{0}, not_tending_to_one(0));
  finding.control("the same with 1/(e + r^2) for 1/r^2", IsExactly{0}, not_tending_to_one(symbol("e")));
  finding.require("terms in which any number of elements do not sum to 1", IsExactly{0},
                  not_divided(DividedElements::total()));
  finding.control("terms in which any number of raw elements do not sum to 1", IsExactly{0}, not_divided(1));
  return finding;
}

Finding equation_16_always(const Bench&) {
  const Function c = symbol("c");
  Finding finding;
  finding.require("terms in which phi_1 beside two sites at one point, cosine c, differs from 1",
                  IsExactly{0}, differing_terms(beside_two_at_one_point(c), 1));
  finding.instead("terms in which it differs from 1/(1 + c^2)", IsExactly{0},
                  differing_terms(beside_two_at_one_point(c), 1 / (1 + c * c)));
  finding.control("terms in which it differs from 1/(1 + c^2), both normals equal", IsExactly{0},
                  differing_terms(beside_two_at_one_point(1), 1 / (1 + c * c)));
  return finding;
}

Finding equation_17(const Bench&) {
  const BallPrecision precision(128);
  const AgreesWith one{.value = Ball(1), .within = 1e-30};
  // Cells of [0, 4] on which the element of another site at such a distance is not certainly positive.
  const auto without_another = [](const MotherFunction& mother) {
    constexpr long cells_a_unit = 16;
    long count = 0;
    for (long k = 0; k < 4 * cells_a_unit; ++k) {
      const Ball r = hull(Ball(Rational(k, cells_a_unit)), Ball(Rational(k + 1, cells_a_unit)));
      if (!certainly_positive(mother.value(r))) ++count;
    }
    return Rational(count);
  };
  Finding finding;
  finding.require("phi_i(p_i)", one, gaussian_element(0));
  finding.control("phi_i at the distance alpha/2", one, gaussian_element(Rational(1, 2)));
  finding.require("cells of distances up to 4 alpha on which an element is not positive", IsExactly{0},
                  without_another(gaussian_mother(std::nullopt)));
  finding.control("the same for the spline", IsExactly{0}, without_another(spline_mother()));
  return finding;
}

Finding equation_18(const Bench&) {
  // The square of K's argument times alpha^2, as printed or with the points, for two sites of a plane: one
  // normal.
  const auto not_between_points = [](const Vector<Function>& step_of_print) {
    const Vector<Function> step{symbol("x"), symbol("y"), 0};
    return differing_terms(dot(step_of_print, step_of_print), dot(step, step));
  };
  const Vector<Function> normal{symbol("nx"), symbol("ny"), symbol("nz")};
  const Vector<Function> turned{symbol("nx"), symbol("ny"), symbol("nz") + symbol("t")};
  Finding finding;
  finding.require("terms in which the square of the printed distance of points of a plane is not |p - q|^2",
                  IsExactly{0}, not_between_points(normal - normal));
  finding.instead("the same with the points", IsExactly{0},
                  not_between_points({symbol("x"), symbol("y"), 0}));
  finding.control("the same as printed, a normal turned", IsExactly{0}, not_between_points(turned - normal));
  // Of four sites 1 apart, radius 2, at the first: the library's elements against K(0) of the print, and with
  // the points.
  constexpr long alpha = 2;
  const Sites sites = four_on_a_line();
  const auto differing = [&](const std::vector<Rational>& elements) {
    long total = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (!overlaps(raw_element(lehtinen_basis(), in_balls(sites.front()), in_balls(sites[i]), Ball(alpha)),
                    Ball(elements[i])))
        ++total;
    return Rational(total);
  };
  finding.instead("elements of four sites of a plane that (18) with the points has otherwise", IsExactly{0},
                  differing(raw_lehtinen(sites, alpha, sites.front())));
  finding.control("elements of four sites of a plane that are not K(0)", IsExactly{0},
                  differing(std::vector<Rational>(four, spline_bell(Rational(0)))));
  return finding;
}

Finding figure_6(const Bench&) {
  const BallPrecision precision(128);
  const AtMost regular{.value = -1e-12, .slack = 0, .why = "not 0: far beyond the radii"};
  const auto minus_size = [](const BallMatrix4& a) { return proved(-abs(determinant(a))); };
  const BallMatrix4 shepard = in_balls(shepard_matrix());
  const BallMatrix4 lehtinen = in_balls(lehtinen_matrix());
  const BallMatrix4 gaussian = gaussian_matrix();
  Finding finding;
  finding.require("minus |det phi_j(p_i)|, Shepard", regular, minus_size(shepard));
  finding.require("minus |det phi_j(p_i)|, Gauss", regular, minus_size(gaussian));
  finding.require("minus |det phi_j(p_i)|, Lehtinen", regular, minus_size(lehtinen));
  BallMatrix4 twice = lehtinen;
  twice[1] = twice[0];
  finding.control("the same with a site taken twice", regular, minus_size(twice));
  return finding;
}

Finding figure_6_values(const Bench&) {
  const BallPrecision precision(128);
  const AtMost seen{.value = 0.05, .slack = 0, .why = "a twentieth of a unit of the figure"};
  // The values are coefficients, or what is interpolated: then the matrix, which is regular, gives f the
  // values.
  const auto by_both_readings = [](const Ball& as_coefficients) {
    return proved(hull(Ball(0), as_coefficients));
  };
  const Ball shepard = largest_miss(in_balls(shepard_matrix()));
  const Ball lehtinen = largest_miss(in_balls(lehtinen_matrix()));
  const Ball gaussian = largest_miss(gaussian_matrix());
  Finding finding;
  finding.require("largest miss at a site, Shepard, by either reading", seen, by_both_readings(shepard));
  finding.require("largest miss at a site, Lehtinen, by either reading", seen, by_both_readings(lehtinen));
  finding.require("largest miss at a site, Gauss, by either reading", seen, by_both_readings(gaussian));
  finding.remark("largest miss at a site, Lehtinen, the values as coefficients", proved(lehtinen));
  finding.remark("largest miss at a site, Gauss, the values as coefficients", proved(gaussian));
  finding.control("largest miss beside the sites by 1/4, Shepard", seen,
                  proved(largest_miss(in_balls(shepard_matrix(Rational(1, 4))))));
  return finding;
}

}  // namespace radcert::verification::psg10
