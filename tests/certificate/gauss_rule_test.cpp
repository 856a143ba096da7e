// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/gauss_rule.h"

#include <gtest/gtest.h>

#include <cmath>

namespace radcert::certificate {
namespace {

TEST(CheckedGaussRule, IntegratesPowersUpToItsDegree) {
  for (int n = 1; n <= most_nodes; ++n) {
    const GaussRule& rule = gauss_rule(n);
    ASSERT_EQ(rule.nodes.size(), static_cast<std::size_t>(n));
    for (int k = 0; k < 2 * n; ++k) {
      Ball sum;
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * power(rule.nodes[i], k);
      const Rational exact = k % 2 == 0 ? Rational(2, k + 1) : Rational(0);
      EXPECT_TRUE(sum.contains(exact)) << n << " " << k;
      EXPECT_LE(sum.radius(), 1e-30);
    }
    // And no further.
    Ball sum;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * power(rule.nodes[i], 2 * n);
    EXPECT_FALSE(sum.contains(Rational(2, 2 * n + 1)));
  }
}

TEST(CheckedGaussRule, IsNearInDouble) {
  for (int n = 1; n <= most_nodes; ++n) {
    const GaussRule& rule = gauss_rule(n);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      EXPECT_TRUE(widened(Ball(rule.near_nodes[i]), Ball(0x1p-53)).contains(rule.nodes[i]));
      EXPECT_TRUE(widened(Ball(rule.near_weights[i]), Ball(0x1p-53) * Ball(rule.near_weights[i]))
                      .contains(rule.weights[i]));
    }
  }
}

}  // namespace
}  // namespace radcert::certificate
