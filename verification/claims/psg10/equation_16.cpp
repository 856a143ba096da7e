// SPDX-License-Identifier: GPL-3.0-or-later

// The three bases.
//
// Checked      (16), exactly, sites in space with rational points and normals, no two at one point: near a
//              site 1 - phi_j <= |p,p_j|^2 sum_i 1/|p,p_i|^2, so that phi_j tends to 1 and the others to 0
//              there; the closed form without a division by zero is the formula elsewhere, rejected for 1/r, and is
//              delta_ij at sites; elements sum to 1. Two sites at one point with normals of cosine 4/5, as on an edge: on
//              the way to it along one normal phi is 25/41, 1/(1 + c^2), at any distance. (17): 1 at the
//              centroid; on a line the sum of the elements there exceeds 1 by more than 1/2, that of
//              Lehtinen's does not. (18), exactly, on a line: as printed, with the normals in the place of
//              the points, all elements of a plane are one constant; with the points they are different, and
//              those of the library. Figure 6: four sites on a line in a plane, at 0,
//              1, 2, 3, values 1, 3, 2, 4, radii 2: the matrix phi_j(p_i) is regular for all three, by its
//              determinant. With the values as coefficients f interpolates for Shepard's basis alone,
//              and for Lehtinen's where no support reaches the next site; beside the sites not for Shepard's.
// Not checked  figure 6 itself, nor where its sites and radii are.

#include <algorithm>
#include <array>
#include <utility>

#include "radcert/meshless/radial_element.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/claims/psg10/exact_sites.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using Sites = std::vector<Site<Rational>>;

/// Sites where an element is not delta_ij, by the closed form that has no division by zero.
Rational not_delta() {
  ExactSites random(161);
  long total = 0;
  for (int k = 0; k < 20; ++k) {
    const Sites sites = random.several_in_space(6);
    for (std::size_t j = 0; j < sites.size(); ++j) {
      std::vector<Rational> squares;
      std::size_t own = 0;
      for (std::size_t i = 0; i < sites.size(); ++i) {
        if (normal_factor(sites[j], sites[i]).sign() == 0) continue;
        if (i == j) own = squares.size();
        squares.push_back(squared_site_distance(sites[j], sites[i]));
      }
      const std::vector<Rational> values = shepard_values<Rational>(squares);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] != Rational(i == own ? 1 : 0)) ++total;
    }
  }
  return total;
}

/// Elements at points in space that are not psi_i / sum_j psi_j, psi = d^-2, or, to be rejected, d^-4.
Rational not_the_formula(int exponent) {
  ExactSites random(164);
  long total = 0;
  for (int k = 0; k < 40; ++k) {
    const Sites sites = random.several_in_space(6);
    Site<Rational> p = random.in_space();
    p.point.x += Rational(1, 16);  // at no site
    std::vector<Rational> raw;
    for (const Site<Rational>& site : sites)
      raw.push_back(normal_factor(p, site).sign() == 0 ? Rational(0)
                                                       : power(squared_site_distance(p, site), -exponent));
    const std::vector<Rational> stated = normalised(std::move(raw));
    const std::vector<Rational> values = shepard_elements(sites, p);
    if (stated.size() != values.size()) ++total;
    for (std::size_t i = 0; i < std::min(stated.size(), values.size()); ++i)
      if (values[i] != stated[i]) ++total;
  }
  return total;
}

/// Points near sites, at 2^-1 to 2^-40 from them, where 1 - phi_j exceeds |p,p_j|^2 sum_i 1/|p,p_i|^2; psi_j
/// = 1/(shift + |p,p_j|^2).
Rational not_tending_to_one(const Rational& shift) {
  ExactSites random(162);
  long total = 0;
  for (int k = 0; k < 20; ++k) {
    const Sites sites = random.several_in_space(6);
    for (int power_of_half = 1; power_of_half <= 40; power_of_half += 3) {
      Site<Rational> p = sites.front();
      p.point.x += power(Rational(1, 2), power_of_half);
      const Rational own = squared_site_distance(p, sites.front());
      Rational others(0);
      Rational sum = Rational(1) / (shift + own);
      bool at_a_site = false;
      for (std::size_t i = 1; i < sites.size(); ++i) {
        if (normal_factor(p, sites[i]).sign() == 0) continue;
        const Rational square = squared_site_distance(p, sites[i]);
        at_a_site = at_a_site || square.sign() == 0;
        if (at_a_site) break;
        others += Rational(1) / square;
        sum += Rational(1) / (shift + square);
      }
      if (!at_a_site && Rational(1) - Rational(1) / (shift + own) / sum > own * others) ++total;
    }
  }
  return total;
}

/// Points in space where Shepard's elements do not sum to 1, or, not normalised, the raw ones do not.
Rational not_one(bool normalise) {
  ExactSites random(163);
  long total = 0;
  for (int k = 0; k < 200; ++k) {
    const Sites sites = random.several_in_space(6);
    Site<Rational> p = random.in_space();
    p.point.x += Rational(1, 16);  // at no site
    Rational sum(0);
    if (normalise) {
      const std::vector<Rational> values = shepard_elements(sites, p);
      if (values.empty()) continue;
      for (const Rational& value : values) sum += value;
    } else {
      for (const Site<Rational>& site : sites)
        if (normal_factor(p, site).sign() > 0) sum += Rational(1) / squared_site_distance(p, site);
    }
    if (sum != Rational(1)) ++total;
  }
  return total;
}

/// phi_1 at a distance from two sites at one point whose normals have a cosine, with the normal of the first.
Rational beside_two_at_one_point(const Rational& cosine, const Rational& sine, const Rational& distance) {
  const Sites sites{{{0, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {sine, 0, cosine}}};
  return shepard_elements(sites, {{0, distance, 0}, {0, 0, 1}}).front();
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
Matrix4 lehtinen_matrix(const Rational& alpha = 2) {
  const Sites sites = four_on_a_line();
  Matrix4 a;
  for (std::size_t i = 0; i < four; ++i) {
    const std::vector<Rational> row = normalised(raw_lehtinen(sites, alpha, sites[i]));
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
  finding.require("elements that are not delta_ij at a site", IsExactly{0}, not_delta());
  finding.require("elements in space that are not psi_i over the sum of psi_j", IsExactly{0},
                  not_the_formula(1));
  finding.control("the same, psi the fourth power of the inverse distance", IsExactly{0}, not_the_formula(2));
  finding.require("points near a site where 1 - phi_j exceeds its bound", IsExactly{0},
                  not_tending_to_one(0));
  finding.control("the same with 1/(1/100 + r^2) for 1/r^2", IsExactly{0},
                  not_tending_to_one(Rational(1, 100)));
  finding.require("points where the elements do not sum to 1", IsExactly{0}, not_one(true));
  finding.control("points where the raw elements do not sum to 1", IsExactly{0}, not_one(false));
  return finding;
}

Finding equation_16_always(const Bench&) {
  Finding finding;
  for (const int k : {1, 20, 40})
    finding.require("phi_1 at 2^-" + std::to_string(k) + " from two sites at one point", IsExactly{1},
                    beside_two_at_one_point(Rational(4, 5), Rational(3, 5), power(Rational(1, 2), k)));
  for (const auto& [cosine, sine] :
       {std::pair(Rational(4, 5), Rational(3, 5)), {Rational(5, 13), Rational(12, 13)}, {0, 1}})
    finding.instead(
        "1 + c^2 times phi_1 at 2^-40, c = " + cosine.to_text(), IsExactly{1},
        (Rational(1) + cosine * cosine) * beside_two_at_one_point(cosine, sine, power(Rational(1, 2), 40)));
  finding.control("the same, both normals equal", IsExactly{1},
                  beside_two_at_one_point(1, 0, Rational(1, 2)));
  finding.remark(
      "phi_1 at 2^-40, normals at 90 degrees",
      {.value = beside_two_at_one_point(0, 1, power(Rational(1, 2), 40)).to_double(), .radius = 0});
  return finding;
}

Finding equation_17(const Bench&) {
  const BallPrecision precision(128);
  const AgreesWith one{.value = Ball(1), .within = 1e-30};
  const AtMost half_less{.value = -0.5, .slack = 0, .why = "the elements sum to more than 1 + 1/2"};
  // Neighbours at the distance alpha on both sides.
  const Ball sum = gaussian_element(0) + Ball(2) * gaussian_element(1);
  Finding finding;
  finding.require("phi_i(p_i)", one, gaussian_element(0));
  finding.control("phi_i at the distance alpha/2", one, gaussian_element(Rational(1, 2)));
  finding.require("1 less the sum of the elements at a site, neighbours at the distance alpha", half_less,
                  ac98::proved(Ball(1) - sum));
  const Sites three{{{-1, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 0, 1}}};
  Rational of_lehtinen(0);
  for (const Rational& value : normalised(raw_lehtinen(three, 2, three[1]))) of_lehtinen += value;
  finding.control("the same, Lehtinen's elements of twice that radius", half_less,
                  ac98::proved(Ball(1) - Ball(of_lehtinen)));
  return finding;
}

Finding equation_18(const Bench&) {
  // At p = p_1, radius 2: those of the library against (18) as printed, K(|p-> - p_i->| / alpha) max{0,
  // p->.p_i->}, |p-> - p_i->| given, and against (18) with the points.
  constexpr long alpha = 2;
  const Sites sites = four_on_a_line();
  const auto of_library = [&](std::size_t i) {
    return raw_element(lehtinen_basis(), in_balls(sites.front()), in_balls(sites[i]), Ball(alpha));
  };
  const auto differing = [&](const std::vector<Rational>& elements) {
    long total = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (!overlaps(of_library(i), Ball(elements[i]))) ++total;
    return Rational(total);
  };
  const auto printed = [&](const Rational& between_normals, const Rational& cosine) {
    std::vector<Rational> elements(1, spline_bell(Rational(0)));
    while (elements.size() < sites.size())
      elements.push_back(spline_bell(Rational(between_normals / Rational(alpha))) * cosine);
    return elements;
  };
  Finding finding;
  finding.require("elements of four sites of a plane that the print, with normals for points, has otherwise",
                  IsExactly{0}, differing(printed(0, 1)));
  finding.instead("elements of four sites of a plane that (18) with the points has otherwise", IsExactly{0},
                  differing(raw_lehtinen(sites, alpha, sites.front())));
  // Half of the angle has the sine 3/5.
  finding.control("elements of the plane that the print has otherwise, the other normals turned",
                  IsExactly{0}, differing(printed(Rational(6, 5), Rational(7, 25))));
  return finding;
}

Finding figure_6(const Bench&) {
  const BallPrecision precision(128);
  const AtMost regular{.value = -1e-12, .slack = 0, .why = "not 0: far beyond the radii"};
  const auto minus_size = [](const BallMatrix4& a) { return ac98::proved(-abs(determinant(a))); };
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
  Finding finding;
  finding.require("largest miss at a site, Shepard", seen,
                  ac98::proved(largest_miss(in_balls(shepard_matrix()))));
  finding.require("largest miss at a site, Lehtinen", seen,
                  ac98::proved(largest_miss(in_balls(lehtinen_matrix()))));
  finding.require("largest miss at a site, Gauss", seen, ac98::proved(largest_miss(gaussian_matrix())));
  finding.instead("largest miss at a site, Lehtinen, radii 1/2", seen,
                  ac98::proved(largest_miss(in_balls(lehtinen_matrix(Rational(1, 2))))));
  finding.control("largest miss beside the sites by 1/4, Shepard", seen,
                  ac98::proved(largest_miss(in_balls(shepard_matrix(Rational(1, 4))))));
  return finding;
}

}  // namespace radcert::verification::psg10
