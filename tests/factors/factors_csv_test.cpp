// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/factors_csv.h"

#include <gtest/gtest.h>

#include "radcert/core/errors.h"

namespace radcert {
namespace {

const std::vector<std::string> names{"a", "b \"x\", y"};

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
  EXPECT_EQ(claims.at({"a", "b \"x\", y"}).value, 0.25);
  EXPECT_EQ(claims.at({"a", "b \"x\", y"}).halfwidth, 1e-9);
  EXPECT_NE(factor_surfaces_csv(sample_matrix(), names, {}).find("a,2,0.25,1e-09,,\r\n"), std::string::npos);
  EXPECT_NE(factor_surfaces_csv(sample_matrix(), names, "mm").find("a,2,0.25,1e-09,,mm^2\r\n"),
            std::string::npos);
}

TEST(FactorsCsv, TakesHalfAUnitOfTheLastDigitWhereThereIsNoRadius) {
  const ClaimedFactors claims = parse_factors("factor,from,to\n0.250,a,a\n2.5e-1,a,b\n", "a test", names);
  EXPECT_DOUBLE_EQ(claims.at({"a", "a"}).halfwidth, 0.0005);
  EXPECT_DOUBLE_EQ(claims.at({"a", "b"}).halfwidth, 0.005);
}

TEST(FactorsCsv, ReadsTheOutputOfView3D) {
  const ClaimedFactors claims = parse_factors(
      "View3D 3.5 0 1 0 2\n 2.0 1.0\n0.000000 0.250000\n0.500000 0.000000\n1 1\n", "a test", names);
  EXPECT_EQ(claims.size(), 4U);
  EXPECT_EQ(claims.at({names[1], "a"}).value, 0.5);
  EXPECT_DOUBLE_EQ(claims.at({names[1], "a"}).halfwidth, 5e-7);
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
  EXPECT_EQ(claims.at({"a", names[1]}).value, 0.25);
  EXPECT_DOUBLE_EQ(claims.at({"a", names[1]}).halfwidth, 0.005);
  EXPECT_EQ(claims.at({names[1], "a"}).value, 0.5);
  EXPECT_EQ(claims.at({names[1], names[1]}).value, 0);
  for (const char* text : {"from,a,c\na,0,0\n", "from,a,a\na,0,0\n", "from,a\na,0,0\n", "from,a\na,x\n"})
    EXPECT_THROW(static_cast<void>(parse_factors(text, "a test", names)), InputError) << text;
}

}  // namespace
}  // namespace radcert
