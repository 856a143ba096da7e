// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rational_polynomial.h"

#include <gtest/gtest.h>

#include <random>

#include "radcert/core/contract.h"
#include "radcert/polynomial/real_zeros.h"

namespace radcert {
namespace {

using Polynomial = RationalPolynomial;

const Polynomial x = Polynomial::variable();

Polynomial random_polynomial(std::mt19937_64& random) {
  std::vector<Rational> coefficients;
  for (std::size_t k = random() % 7; k-- > 0;)
    coefficients.emplace_back(static_cast<long>(random() % 9) - 4, 1 + static_cast<long>(random() % 3));
  return Polynomial(coefficients);
}

TEST(RationalPolynomial, IsEvaluatedAsARing) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Polynomial p = random_polynomial(random);
    const Polynomial q = random_polynomial(random);
    for (const Rational& at : {Rational(0), Rational(1), Rational(-3, 7)}) {
      EXPECT_EQ((p + q)(at), p(at) + q(at));
      EXPECT_EQ((p - q)(at), p(at) - q(at));
      EXPECT_EQ((p * q)(at), p(at) * q(at));
      EXPECT_EQ((-p)(at), -p(at));
    }
    EXPECT_EQ((p * q).derivative(), p.derivative() * q + p * q.derivative());
    EXPECT_TRUE((p - p).is_zero());
    Polynomial copy = p;
    copy *= copy;
    EXPECT_EQ(copy, p * p);
  }
}

TEST(RationalPolynomial, DividesWithASmallRemainder) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Polynomial p = random_polynomial(random);
    const Polynomial q = random_polynomial(random);
    if (q.is_zero()) {
      EXPECT_THROW(static_cast<void>(divide(p, q)), ContractViolation);
      continue;
    }
    const Division division = divide(p, q);
    EXPECT_EQ(division.quotient * q + division.remainder, p);
    EXPECT_LT(division.remainder.degree(), q.degree());
  }
}

TEST(RationalPolynomial, HasAGreatestCommonDivisor) {
  const Polynomial common = (x - Rational(1, 6)) * (x * x + 1);
  EXPECT_EQ(greatest_common_divisor(3 * common * (x - 2), -7 * common * (x + 5)), common);
  EXPECT_EQ(greatest_common_divisor(x - 1, x - 2), Polynomial(1));
  EXPECT_EQ(greatest_common_divisor({}, 2 * x), x);
  EXPECT_EQ(greatest_common_divisor(2 * x, {}), x);
  EXPECT_TRUE(greatest_common_divisor({}, {}).is_zero());
}

TEST(RationalPolynomial, KeepsNoLeadingZeros) {
  EXPECT_EQ(Polynomial(std::vector<Rational>{1, 2, 0, 0}).degree(), 1);
  EXPECT_EQ((x * x - x * x).degree(), -1);
  EXPECT_EQ(Polynomial(0).degree(), -1);
  EXPECT_EQ((x * 3 + 1).coefficient(1), 3);
  EXPECT_EQ((x * 3 + 1).coefficient(2), 0);
  EXPECT_EQ((x * 3 + 1).leading(), 3);
}

TEST(RationalPolynomial, IsWrittenFromTheHighestPower) {
  EXPECT_EQ((3 * x * x - Rational(1, 2) * x + 1).to_text(), "3 x^2 - 1/2 x + 1");
  EXPECT_EQ((-x * x * x - 1).to_text("alpha"), "-alpha^3 - 1");
  EXPECT_EQ(Polynomial().to_text(), "0");
}

TEST(RealZeros, AreCountedOnceOnAHalfOpenInterval) {
  const Polynomial p = (x - 1) * (x - 1) * (x - 2) * (x * x + 1);
  EXPECT_EQ(zeros_between(p, 0, 3), 2);
  EXPECT_EQ(zeros_between(p, 1, 2), 1);
  EXPECT_EQ(zeros_between(p, 0, 1), 1);
  EXPECT_EQ(zeros_between(p, 2, 9), 0);
  EXPECT_EQ(zeros_between(Polynomial(5), -1, 1), 0);
}

TEST(RealZeros, AreFoundExactlyWhereTheyAreSmallFractions) {
  Polynomial p = 1;
  std::vector<Rational> zeros;
  for (int k = -5; k <= 5; ++k) {
    zeros.emplace_back(2L * k + 1, 13L);
    p *= x - zeros.back();
  }
  p *= p;
  const std::vector<RealZero> found = real_zeros(p, -1, 1, Rational(1, 1000));
  ASSERT_EQ(found.size(), zeros.size());
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    EXPECT_TRUE(found[i].is_exact());
    EXPECT_EQ(found[i].lower, zeros[i]);
  }
}

TEST(RealZeros, EncloseSquareRoots) {
  const Rational width(1, 1L << 40);
  const std::vector<RealZero> found = real_zeros(x * x - 2, -2, 2, width);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_FALSE(found[1].is_exact());
  EXPECT_LT(found[1].lower * found[1].lower, 2);
  EXPECT_GT(found[1].upper * found[1].upper, 2);
  EXPECT_LE(found[1].upper - found[1].lower, width);
  EXPECT_LT(found[0].upper, 0);
}

TEST(RealZeros, AtTheEndsOfTheIntervalBelongToIt) {
  const std::vector<RealZero> found = real_zeros(x * (x - 1) * (x - 2), 0, 1, Rational(1, 8));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].lower, 0);
  EXPECT_EQ(found[1].upper, 1);
  EXPECT_TRUE(found[0].is_exact() && found[1].is_exact());
  EXPECT_EQ(real_zeros(x, 0, 0, 1).size(), 1U);
  EXPECT_TRUE(real_zeros(x * x + 1, -9, 9, 1).empty());
}

TEST(RealZeros, NextToAZeroAreNotTakenForIt) {
  const std::vector<RealZero> found = real_zeros(x * (x * x - Rational(2, 1000000)), 0, 1, Rational(1, 100));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].is_exact());
  EXPECT_FALSE(found[1].is_exact());
  EXPECT_GT(found[1].upper * found[1].upper, Rational(2, 1000000));
}

TEST(RealZeros, RefuseWhatHasNoAnswer) {
  EXPECT_THROW(static_cast<void>(zeros_between({}, 0, 1)), ContractViolation);
  EXPECT_THROW(static_cast<void>(zeros_between(x, 1, 0)), ContractViolation);
  EXPECT_THROW(static_cast<void>(real_zeros(x, 0, 1, 0)), ContractViolation);
}

}  // namespace
}  // namespace radcert
