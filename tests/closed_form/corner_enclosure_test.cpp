// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/edge/corner_enclosure.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

#include "radcert/closed_form/edge/corner_exponent.h"
#include "radcert/core/errors.h"

namespace radcert {
namespace {

std::array<double, 3> rounded(const std::array<Rational, 3>& rho) {
  return {rho[0].to_double(), rho[1].to_double(), rho[2].to_double()};
}

// By Nystrom's method on the kernel itself, which shares no function with the closed forms in cos(a).
TEST(OctantSpectralBounds, EncloseWhatNystromsMethodEstimates) {
  const std::array<std::array<Rational, 3>, 4> cases{{{Rational(1, 2), Rational(1, 2), Rational(1, 2)},
                                                      {Rational(9, 10), Rational(9, 10), Rational(9, 10)},
                                                      {Rational(9, 10), Rational(1, 5), Rational(1, 2)},
                                                      {Rational(1, 3), Rational(3, 4), Rational(3, 4)}}};
  for (const auto& rho : cases)
    for (const Rational& g : {Rational(1, 20), Rational(1, 3), Rational(3, 4), Rational(19, 20)}) {
      const Approximation estimate = octant_spectral_radius(rounded(rho), g.to_double());
      const BallBounds bounds = octant_spectral_bounds(rho, g, 64);
      EXPECT_LE(bounds.lower.upper_double(), estimate.value + estimate.radius) << g.to_text();
      EXPECT_GE(bounds.upper.lower_double(), estimate.value - estimate.radius) << g.to_text();
      EXPECT_LT(bounds.upper.to_double(), 2 * bounds.lower.to_double()) << g.to_text();
    }
}

TEST(OctantSpectralBounds, ComeNearerWithMoreCells) {
  const std::array<Rational, 3> rho{Rational(1, 2), Rational(1, 2), Rational(1, 2)};
  const double estimate = octant_spectral_radius(rounded(rho), 0.7).value;
  double before = 2;
  for (const int cells : {8, 32, 128}) {
    const BallBounds bounds = octant_spectral_bounds(rho, Rational(7, 10), cells);
    const double width = (bounds.upper - bounds.lower).to_double();
    EXPECT_LT(width, before / 2) << cells;
    EXPECT_LT(bounds.lower.to_double(), estimate);
    EXPECT_GT(bounds.upper.to_double(), estimate);
    before = width;
  }
}

// Scaled by the reflectivity: all three by the same factor.
TEST(OctantSpectralBounds, AreLinearInTheReflectivity) {
  const BallBounds half =
      octant_spectral_bounds({Rational(1, 2), Rational(1, 2), Rational(1, 2)}, Rational(2, 5), 32);
  const BallBounds quarter =
      octant_spectral_bounds({Rational(1, 4), Rational(1, 4), Rational(1, 4)}, Rational(2, 5), 32);
  EXPECT_NEAR(half.upper.to_double(), 2 * quarter.upper.to_double(), 1e-12);
  EXPECT_NEAR(half.lower.to_double(), 2 * quarter.lower.to_double(), 1e-12);
}

TEST(EnclosedOctantExponent, ContainsTheEstimate) {
  for (const Rational& r : {Rational(1, 2), Rational(4, 5)}) {
    const Outcome<Ball> exponent = enclosed_octant_exponent({r, r, r}, Rational(1, 100));
    ASSERT_TRUE(exponent) << exponent.reason();
    EXPECT_TRUE(exponent->contains(octant_exponent(rounded({r, r, r})).value));
    EXPECT_LE(exponent->radius(), 0.0100001);
  }
}

TEST(OctantSpectralBounds, AreTheWholeLineWhereBallsDoNotTell) {
  const Rational half(1, 2);
  const Rational almost_one = Rational(1) - Rational(1) / power(Rational(10), 60);
  const BallBounds bounds = octant_spectral_bounds({half, half, half}, almost_one, 8);
  EXPECT_EQ(bounds.upper.upper_double(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(bounds.lower.lower_double(), -std::numeric_limits<double>::infinity());
}

TEST(EnclosedOctantExponent, TakesReflectivitiesThatRoundToOne) {
  const Rational almost_one = Rational(1) - Rational(1) / power(Rational(10), 30);
  EXPECT_TRUE(enclosed_octant_exponent({almost_one, almost_one, almost_one}, Rational(1, 50)));
}

TEST(EnclosedOctantExponent, RefusesWhatItCannot) {
  const Rational little(1, 100);
  const Outcome<Ball> near_one = enclosed_octant_exponent({little, little, little}, Rational(1, 20));
  ASSERT_FALSE(near_one);
  EXPECT_NE(near_one.reason().find("nearer to 0 or 1"), std::string::npos) << near_one.reason();
  EXPECT_THROW(static_cast<void>(enclosed_octant_exponent({little, little, Rational(0)}, Rational(1, 20))),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(octant_spectral_bounds({little, little, little}, Rational(1), 8)),
               ContractViolation);
  EXPECT_FALSE(enclosed_octant_exponent({Rational(1, 2), Rational(1, 2), Rational(1, 2)},
                                        Rational(1) / power(Rational(10), 9)));
  EXPECT_THROW(static_cast<void>(octant_spectral_bounds({little, little, little}, Rational(1, 2), 9)),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
