// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/interpolation_bounds.h"

#include <algorithm>
#include <array>

#include "radcert/polynomial/lebesgue_constant.h"
#include "radcert/scalar/real.h"
#include "verification/claims/mean_value_bounds.h"

namespace radcert::verification::ac98 {
namespace {

Ball largest_of(const std::vector<Ball>& numbers) {
  Ball largest = numbers.at(0);
  for (const Ball& number : numbers) largest = max(largest, number);
  return largest;
}

}  // namespace

std::vector<BoundedError> bounded_errors(const std::vector<PlanarTriangle>& triangles,
                                         const std::vector<PlanarPoint>& polygon, int derivatives_of_phi) {
  constexpr int degree_of_phi = 3;
  constexpr int degree_of_f = 5;
  const std::vector<ExactPolynomial> phis = monomials(degree_of_phi);
  std::vector<Rational> integrals;
  for (const ExactPolynomial& phi : phis) {
    Rational sum = 0;
    for (int i = 0; i <= derivatives_of_phi; ++i) {
      Rational largest = 0;
      for (const ExactPolynomial& d : derivatives(phi, i))
        largest = std::max(largest, d.integral_over(polygon));
      sum += largest;
    }
    integrals.push_back(sum);
  }
  std::vector<BoundedError> result;
  for (const ExactPolynomial& f : monomials(degree_of_f)) {
    Rational largest = 0;
    for (int i = 2; i <= derivatives_of_phi + 2; ++i)
      largest = std::max(largest, largest_at(polygon, derivatives(f, i)));
    std::vector<ExactPolynomial> differences;
    for (const PlanarTriangle& triangle : triangles)
      differences.push_back(f - interpolant(triangle, Rational(1, 6), f));
    for (std::size_t k = 0; k < phis.size(); ++k) {
      Rational error = 0;
      for (std::size_t i = 0; i < triangles.size(); ++i)
        error += (phis[k] * differences[i]).integral_over({triangles[i].begin(), triangles[i].end()});
      result.push_back({abs(error), integrals[k] * largest});
    }
  }
  return result;
}

Rational exceeding(const std::vector<BoundedError>& errors, const Rational& factor) {
  return {std::count_if(errors.begin(), errors.end(),
                        [&](const BoundedError& each) { return each.error > factor * each.bound; })};
}

Rational largest_ratio(const std::vector<BoundedError>& errors) {
  Rational largest = 0;
  for (const BoundedError& each : errors)
    if (each.bound.sign() > 0) largest = std::max(largest, each.error / each.bound);
  return largest;
}

std::vector<PlanarPoint> placed(const std::vector<PlanarPoint>& points, const Rational& h,
                                const PlanarPoint& by) {
  std::vector<PlanarPoint> result;
  for (const PlanarPoint& p : points) result.push_back({by.x + h * p.x, by.y + h * p.y});
  return result;
}

Rational reach(const std::vector<PlanarPoint>& points, const PlanarPoint& about) {
  Rational largest = 0;
  for (const PlanarPoint& p : points) largest = std::max(largest, abs(p.x - about.x) + abs(p.y - about.y));
  return largest;
}

Rational bound_of_the_remainder() { return 1 + linear_lebesgue_constant()(Rational(1, 6)); }

Rational constant_with_legs() {
  const std::vector<Rational> factors = interpolation_factors<Rational>(1, 1, 1, 1);
  return bound_of_the_remainder() * *std::max_element(factors.begin(), factors.end());
}

Rational constant_on_squares() {
  const std::vector<Rational> factors = interpolation_factors<Rational>(1, 2, 1, 1);
  return bound_of_the_remainder() * *std::max_element(factors.begin(), factors.end());
}

Ball constant_on_triangles() {
  const Ball side = sqrt(Ball(2));
  return Ball(bound_of_the_remainder()) *
         largest_of(interpolation_factors<Ball>(1, 1, side, side * Ball(Rational(2, 3))));
}

Ball constant_on_parallelograms() {
  const Ball side = sqrt(Ball(2));
  return Ball(bound_of_the_remainder()) * largest_of(interpolation_factors<Ball>(1, 2, side, side));
}

void require_lengths(Finding& finding) {
  const ExactPolynomial x = ExactPolynomial::monomial(1, 0);
  const ExactPolynomial y = ExactPolynomial::monomial(0, 1);
  const auto left = [&](int factor) {
    const ExactPolynomial rest =
        ExactPolynomial(factor) * (x * x + y * y) - (x + y) * (x + y) - (x - y) * (x - y);
    return Rational(static_cast<long>(rest.size()));
  };
  finding.require("|d|_1 <= 2^(1/2) |d|: coefficients of 2 (x^2 + y^2) - (x + y)^2 - (x - y)^2", IsExactly{0},
                  left(2));
  finding.control("the same with 1 for 2", IsExactly{0}, left(1));
  // In the coordinates of v_1, v_2 and v_3: v_1 less their mean, less a part of (v_1 - v_2) + (v_1 - v_3).
  using Weights = std::array<Rational, 3>;
  const std::array<Weights, 3> v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto differing = [&](const Rational& part) {
    long count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational way = v[0].at(i) - (v[0].at(i) + v[1].at(i) + v[2].at(i)) / 3;
      const Rational sides = (v[0].at(i) - v[1].at(i)) + (v[0].at(i) - v[2].at(i));
      if (way != part * sides) ++count;
    }
    return Rational(count);
  };
  finding.require("from the centroid to v_1: coefficients other than those of ((v_1 - v_2) + (v_1 - v_3))/3",
                  IsExactly{0}, differing(Rational(1, 3)));
  finding.control("from the centroid to v_1: coefficients other than those of ((v_1 - v_2) + (v_1 - v_3))/4",
                  IsExactly{0}, differing(Rational(1, 4)));
}

void require_in_any_direction(Finding& finding, int gained, const LiesIn& range) {
  require_lengths(finding);
  const auto constant = [&](int reach) {
    return Ball(bound_of_the_remainder()) *
           interpolation_factors<Ball>(1, gained, sqrt(Ball(2)), Ball(reach)).at(0);
  };
  finding.require("c for sides in any direction", range, constant(1));
  finding.control("the same by Taylor polynomials about a corner", range, constant(2));
}

void BilinearSum::add(const Combination& phi, const Combination& f, int factor) {
  for (const auto& [left, a] : phi)
    for (const auto& [right, b] : f) {
      int& sum = terms_[{left, right}];
      sum += factor * a * b;
      if (sum == 0) terms_.erase({left, right});
    }
}

void BilinearSum::vanish(const std::string& f, const std::string& phi) {
  std::erase_if(terms_, [&](const auto& term) {
    return term.first.second == f && (phi.empty() || term.first.first == phi);
  });
}

std::string placed_at(const Rational& h, const PlanarPoint& by) {
  return ", h = " + h.to_text() + ", corner (" + by.x.to_text() + "," + by.y.to_text() + ")";
}

}  // namespace radcert::verification::ac98
