// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/galerkin/touching_rule.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

/// Int x_1^a x_2^b x_3^c over the reference triangle, of area one half: a! b! c! / (a + b + c + 2)!.
double moment(int a, int b, int c) {
  return std::tgamma(a + 1) * std::tgamma(b + 1) * std::tgamma(c + 1) / std::tgamma(a + b + c + 3);
}

double power(const Barycentric<double>& x, int a, int b, int c) {
  return std::pow(x.x[0], a) * std::pow(x.x[1], b) * std::pow(x.x[2], c);
}

TEST(TouchingRule, IntegratesPolynomialsOfBothPoints) {
  for (const std::size_t common : {1, 2, 3}) {
    const std::vector<PointPair> rule = touching_rule(common, 7);
    for (int a = 0; a <= 2; ++a)
      for (int b = 0; b <= 2; ++b)
        for (int c = 0; c <= 2; ++c)
          for (int d = 0; d <= 2; ++d) {
            double sum = 0;
            for (const PointPair& pair : rule)
              sum += pair.weight * power(pair.first, a, b, 1) * power(pair.second, 0, c, d);
            EXPECT_NEAR(sum, moment(a, b, 1) * moment(0, c, d), 1e-15) << common << ": " << a << b << c << d;
          }
    for (const PointPair& pair : rule) {
      EXPECT_GT(pair.weight, 0);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GT(pair.first.x[i], 0);
        EXPECT_GT(pair.second.x[i], 0);
      }
    }
  }
}

TEST(TouchingRule, ConvergesForKernelsThatAreSingularInTheCommonPart) {
  // The first triangle in the plane z = 0, the second in y = 0, both with the vertex 0 at the origin and,
  // with a common side, the vertex 1 at (1,0,0): 1/|P-Q|^2.
  for (const std::size_t common : {1, 2}) {
    const auto integral = [&](int order) {
      double sum = 0;
      for (const PointPair& pair : touching_rule(common, order)) {
        const double x = pair.first.x[1] + pair.first.x[2];
        const double y = pair.first.x[2];
        const double direction = common == 2 ? 1 : -1;
        const double u = direction * (pair.second.x[1] + pair.second.x[2]);
        const double w = pair.second.x[2];
        sum += pair.weight / ((x - u) * (x - u) + y * y + w * w);
      }
      return sum;
    };
    const double fine = integral(16);
    EXPECT_NEAR(integral(12), fine, 1e-8 * fine);
    EXPECT_NEAR(integral(6), fine, 1e-4 * fine);
  }
}

TEST(TouchingRule, ConvergesForKernelsThatJumpWithTheDirection) {
  // Homogeneous of degree 0 in x - y, as G is on one smooth chart: d_1^2 / |d|^2. Its mean is that of d_2^2 /
  // |d|^2 with the two parameters exchanged, and both add up to the whole.
  const auto integral = [](int order, bool exchanged) {
    double sum = 0;
    for (const PointPair& pair : touching_rule(3, order)) {
      const double d_1 = pair.first.x[1] - pair.second.x[1];
      const double d_2 = pair.first.x[2] - pair.second.x[2];
      const double d = exchanged ? d_2 : d_1;
      sum += pair.weight * d * d / (d_1 * d_1 + d_2 * d_2);
    }
    return sum;
  };
  EXPECT_NEAR(integral(12, false), 1.0 / 8, 1e-8);
  EXPECT_NEAR(integral(12, true), 1.0 / 8, 1e-8);
}

TEST(TouchingRule, RefusesTrianglesThatDoNotTouch) {
  EXPECT_THROW((void)touching_rule(0, 4), ContractViolation);
  EXPECT_THROW((void)touching_rule(4, 4), ContractViolation);
}

}  // namespace
}  // namespace radcert
