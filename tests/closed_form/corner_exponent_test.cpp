// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/edge/corner_exponent.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/closed_form/edge/edge_exponents.h"
#include "radcert/core/contract.h"

namespace radcert {
namespace {

// Constants: a quarter of the directions above a face miss the two others.
TEST(OctantSpectralRadius, IsThreeQuartersForConstants) {
  const Approximation found = octant_spectral_radius({0.8, 0.8, 0.8}, 1e-4);
  EXPECT_NEAR(found.value, 0.6, 1e-3);
  EXPECT_NEAR(octant_spectral_radius({0.8, 0.8, 0.8}, 2e-4).value - found.value, found.value - 0.6, 1e-5);
}

// Two faces of an octant are a part of the faces of a wedge: they send no more to each other than these do.
TEST(OctantSpectralRadius, OfTwoFacesIsAtMostThatOfTheirEdge) {
  for (const double g : {0.3, 0.6, 0.9}) {
    const double wedge = 0.7 * EdgeSymbol(Ball::pi() / Ball(2))(ComplexBall(Ball(g))).real().to_double();
    EXPECT_LT(octant_spectral_radius({0.7, 0.7, 0}, g).value, wedge);
    // The third face adds to it, but for large g, where the wedge draws on what is far along the edge.
    EXPECT_EQ(octant_spectral_radius({0.7, 0.7, 0.7}, g).value > wedge, g < 0.8) << g;
  }
}

TEST(OctantExponent, MakesTheSpectralRadiusOneAndFallsWithTheReflectivity) {
  double before = 1;
  for (const double rho : {0.1, 0.5, 0.9, 0.99}) {
    const Approximation found = octant_exponent({rho, rho, rho});
    EXPECT_LT(found.radius, 1e-3) << rho;
    EXPECT_NEAR(octant_spectral_radius({rho, rho, rho}, found.value).value, 1, 1e-6) << rho;
    EXPECT_LT(found.value, before) << rho;
    before = found.value;
  }
  // It may be that of the corner or of the edge which is smaller.
  const auto edge = [](const Rational& rho) {
    return smallest_edge_exponent(edge_of_degrees(90, rho, rho), Rational(1, 1000000))->to_double();
  };
  EXPECT_LT(octant_exponent({0.9, 0.9, 0.9}).value, edge(Rational(9, 10)) - 0.1);
  EXPECT_GT(octant_exponent({0.1, 0.1, 0.1}).value, edge(Rational(1, 10)));
}

TEST(OctantExponent, DoesNotDependOnTheOrderOfTheFaces) {
  const double one = octant_exponent({0.9, 0.5, 0.2}).value;
  EXPECT_NEAR(octant_exponent({0.5, 0.2, 0.9}).value, one, 1e-9);
  EXPECT_NEAR(octant_exponent({0.5, 0.9, 0.2}).value, one, 1e-9);
  EXPECT_EQ(octant_exponent({0.9, 0, 0}).value, 1);
  EXPECT_THROW(static_cast<void>(octant_exponent({0.9, 0.5, 1})), ContractViolation);
}

}  // namespace
}  // namespace radcert
