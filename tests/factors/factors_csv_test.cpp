// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/factors_csv.h"

#include <gtest/gtest.h>

#include "radcert/core/errors.h"

namespace radcert {
namespace {

const std::vector<std::string> names{"a", "b \"x\", y"};

Rational decimal(const char* text) { return Rational::parse(text).value(); }

FactorMatrix sample_matrix() {
  FactorMatrix matrix;
  matrix.rows = {{.area = {2, 0}, .sum = {0.25, 1e-9}, .to_space = std::nullopt},
                 {.area = {1, 0}, .sum = {0.5, 2e-9}, .to_space = Approximation{0.5, 2e-9}}};
  matrix.entries = {{0, 1, {0.25, 1e-9}}, {1, 0, {0.5, 2e-9}}};
  return matrix;
}

TEST(FactorsCsv, ReadsWhatItWrites) {
  const std::string text = factors_csv(sample_matrix(), names);
  const ClaimedFactors claims = parse_factors(text, "a test", names);
  ASSERT_EQ(claims.size(), 2U);
  EXPECT_EQ(claims.at({"a", "b \"x\", y"}).value, Rational(1, 4));
  EXPECT_EQ(claims.at({"a", "b \"x\", y"}).halfwidth, decimal("1e-9"));
  EXPECT_NE(factor_surfaces_csv(sample_matrix(), names, {}).find("a,2,0.25,1e-09,,\r\n"), std::string::npos);
  EXPECT_NE(factor_surfaces_csv(sample_matrix(), names, "mm").find("a,2,0.25,1e-09,,mm^2\r\n"),
            std::string::npos);
}

TEST(FactorsCsv, TakesHalfAUnitOfTheLastDigitWhereThereIsNoRadius) {
  const ClaimedFactors claims = parse_factors("factor,from,to\n0.250,a,a\n2.5e-1,a,b\n", "a test", names);
  EXPECT_EQ(claims.at({"a", "a"}).halfwidth, decimal("0.0005"));
  EXPECT_EQ(claims.at({"a", "b"}).halfwidth, decimal("0.005"));
}

TEST(FactorsCsv, KeepsAllDigits) {
  const char* digits = "0.2953244536941345496642803";
  const ClaimedFactors claims = parse_factors(
      std::string("from,to,factor,radius\na,a,") + digits + ",\na,b," + digits + ",1e-20\n", "a test", names);
  const Rational exact = decimal(digits);
  const Rational off = abs(exact - Rational::exactly(exact.to_double()));
  ASSERT_GT(off, decimal("1e-18"));
  EXPECT_EQ(claims.at({"a", "a"}).value, exact);
  EXPECT_EQ(claims.at({"a", "a"}).halfwidth, decimal("5e-26"));
  // A number that is written with a radius may mean the nearest double.
  EXPECT_EQ(claims.at({"a", "b"}).value, exact);
  EXPECT_EQ(claims.at({"a", "b"}).halfwidth, off + decimal("1e-20"));
}

TEST(ClaimedFactor, IsWithinItsRadiusInDoubles) {
  for (const char* digits : {"0.2953244536941345496642803", "0.3", "0.25"})
    for (const char* halfwidth : {"0", "5e-26", "0.0005", "5e-7"}) {
      const ClaimedFactor claim{decimal(digits), decimal(halfwidth)};
      const Approximation rounded = claim.in_double();
      const Rational needed = abs(Rational::exactly(rounded.value) - claim.value) + claim.halfwidth;
      EXPECT_LE(needed, Rational::exactly(rounded.radius)) << digits << " " << halfwidth;
      EXPECT_LE(Rational::exactly(rounded.radius) - needed, needed * decimal("1e-15"))
          << digits << " " << halfwidth;
    }
  EXPECT_EQ(ClaimedFactor{}.in_double().radius, 0);
}

TEST(FactorsCsv, ReadsTheOutputOfView3D) {
  const ClaimedFactors claims = parse_factors(
      "View3D 3.5 0 1 0 2\n 2.0 1.0\n0.000000 0.250000\n0.500000 0.000000\n1 1\n", "a test", names);
  EXPECT_EQ(claims.size(), 4U);
  EXPECT_EQ(claims.at({names[1], "a"}).value, Rational(1, 2));
  EXPECT_EQ(claims.at({names[1], "a"}).halfwidth, decimal("5e-7"));
}

TEST(FactorsCsv, RefusesWithThePlace) {
  for (const char* text :
       {"from,to\na,a\n", "from,to,factor\na,a\n", "from,to,factor\na,a,x\n",
        "from,to,factor\na,a,1\na,a,1\n", "from,to,factor\n\"a,a,1\n", "", "View3D 3.5 0 1 0 3\n",
        "View3D 3.5 1 1 0 2\n", "View3D 3.5 0 1 0 2\n1 1\n0 0\n0\n"})
    EXPECT_THROW(static_cast<void>(parse_factors(text, "a test", names)), InputError) << text;
}

TEST(FactorsCsv, ReadsAMatrixWithNamesAboutIt) {
  const ClaimedFactors claims =
      parse_factors("from,a,\"b \"\"x\"\", y\"\na,0,0.25\n\"b \"\"x\"\", y\",0.5,\n", "a test", names);
  EXPECT_EQ(claims.size(), 4U);
  EXPECT_EQ(claims.at({"a", names[1]}).value, Rational(1, 4));
  EXPECT_EQ(claims.at({"a", names[1]}).halfwidth, decimal("0.005"));
  EXPECT_EQ(claims.at({names[1], "a"}).value, Rational(1, 2));
  EXPECT_EQ(claims.at({names[1], names[1]}).value, Rational(0));
  for (const char* text : {"from,a,c\na,0,0\n", "from,a,a\na,0,0\n", "from,a\na,0,0\n", "from,a\na,x\n"})
    EXPECT_THROW(static_cast<void>(parse_factors(text, "a test", names)), InputError) << text;
}

}  // namespace
}  // namespace radcert
