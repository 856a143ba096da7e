// SPDX-License-Identifier: GPL-3.0-or-later
// What polynomials and rules miss of an analytic function, against Chebyshev's polynomials, which miss most;
// and how Legendre's polynomials grow around the interval.
#include "radcert/continuous/elements/analytic_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/transport/transport_bounds.h"

namespace radcert {
namespace {

/// T_n, and (rho^n + rho^-n)/2, which bounds it in the ellipse.
double chebyshev(int n, double x) { return std::cos(n * std::acos(x)); }
double largest_in_ellipse(int n, double rho) { return 0.5 * (std::pow(rho, n) + std::pow(rho, -n)); }

TEST(PolynomialErrorFactor, IsThatOfChebyshevsPolynomialInLargeEllipses) {
  // T_n takes the values 1 and -1 in turn n + 1 times: nothing of a lower degree is nearer than 0.
  for (int n = 1; n <= most_gauss_nodes; ++n) {
    for (const double rho : {1.05, 1.5, 2.0, 5.0, 50.0, 1000.0})
      EXPECT_GE(polynomial_error_factor(n, rho) * largest_in_ellipse(n, rho), 1) << n << " " << rho;
    EXPECT_LE(polynomial_error_factor(n, 1000) * largest_in_ellipse(n, 1000), 1.002) << n;
  }
}

TEST(GaussMeanErrorFactor, IsNearThatOfChebyshevsPolynomial) {
  for (int n = 1; n <= most_gauss_nodes; ++n) {
    const IntervalRule<double>& rule = gauss_on_interval(n);
    double mean = -1.0 / (4.0 * n * n - 1);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      mean -= 0.5 * rule.weights[i] * chebyshev(2 * n, rule.nodes[i]);
    const double missed = std::abs(mean);
    for (const double rho : {1.05, 1.5, 2.0, 5.0, 50.0})
      EXPECT_GE(gauss_mean_error_factor(n, rho) * largest_in_ellipse(2 * n, rho), missed) << n << " " << rho;
    EXPECT_LE(gauss_mean_error_factor(n, 50) * largest_in_ellipse(2 * n, 50), (n == 1 ? 2.01 : 1.51) * missed)
        << n;
  }
}

TEST(GaussMeanErrors, AreTheFactorsOneAfterTheOther) {
  for (const double rho : {1.02, 1.5, 2.0, 5.0, 50.0, 1e6}) {
    GaussMeanErrors errors(rho);
    for (int n = 1; n <= most_gauss_nodes; ++n) {
      const double factor = gauss_mean_error_factor(n, rho);
      EXPECT_NEAR(errors.next(), factor, 1e-13 * factor) << n << " " << rho;
    }
  }
}

/// The largest |P_n| of points, as the n-th power of a number.
double growth(int n, const std::vector<std::complex<double>>& points) {
  double largest = 0;
  std::vector<std::complex<double>> values(static_cast<std::size_t>(n) + 1);
  for (const std::complex<double>& z : points) {
    legendre_values<std::complex<double>>(z, values);
    largest = std::max(largest, std::abs(values.back()));
  }
  return std::pow(largest, 1.0 / n);
}

TEST(LegendreGrowth, IsBoundedWhereSourcesMove) {
  std::vector<std::complex<double>> along;   // within 1/2 of [-1,1]
  std::vector<std::complex<double>> across;  // within 1 of -1
  for (int k = 0; k < 720; ++k) {
    const std::complex<double> way = std::polar(1.0, k * std::numbers::pi / 360);
    along.push_back((way.real() < 0 ? -1.0 : 1.0) + 0.5 * way);
    across.push_back(-1.0 + way);
  }
  for (int n = 1; n <= 60; ++n) {
    EXPECT_LE(growth(n, along), turned_along) << n;
    EXPECT_LE(growth(n, across), turned_across) << n;
  }
  EXPECT_GT(growth(60, along), 0.95 * turned_along);
  EXPECT_GT(growth(60, across), 0.95 * turned_across);
}

TEST(LegendreGrowth, IsBoundedWhereSourcesSlide) {
  for (const double part : {0.1, 0.25, 0.5, 0.9, 1.0}) {
    // Q slides by i part times its distance from the nearer end of a segment of a line, of which the
    // parameter is a quotient of affine functions that takes the segment to a part of [-1,1].
    std::vector<std::complex<double>> slid;
    for (const double pole : {1e9, 3.0, -1.5, 1.01})
      for (const double from : {-1.0, -0.5, 0.75})
        for (const double to : {-0.25, 0.9, 1.0}) {
          if (!(from < to)) continue;
          const auto place = [&](std::complex<double> x) { return (x * pole - 1.0) / (pole - x); };
          const double low = place(-1).real();
          const double high = place(1).real();
          for (int k = 0; k <= 80; ++k) {
            const double x = -1 + k / 40.0;
            const std::complex<double> moved(x, part * (1 - std::abs(x)));
            const std::complex<double> within = (place(moved) - low) / (high - low);
            slid.push_back(from + (to - from) * within);
          }
        }
    for (int n = 1; n <= 60; ++n) EXPECT_LE(growth(n, slid), slid_growth(part)) << n << " " << part;
    EXPECT_GT(growth(60, slid), 0.95 * slid_growth(part)) << part;
  }
}

}  // namespace
}  // namespace radcert
