// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/interpolation_bounds.h"

#include <algorithm>

namespace radcert::verification::ac98 {

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

std::string placed_at(const Rational& h, const PlanarPoint& by) {
  return ", h = " + h.to_text() + ", corner (" + by.x.to_text() + "," + by.y.to_text() + ")";
}

}  // namespace radcert::verification::ac98
