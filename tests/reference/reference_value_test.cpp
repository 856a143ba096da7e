// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/reference_value.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "radcert/core/contract.h"

namespace radcert::reference {
namespace {

/// Digits found elsewhere: by other programs, or from formulas that are not ours. The last digit shown may be
/// off by one.
struct KnownDigits {
  const char* name;
  const char* digits;
};
const std::vector<KnownDigits> known = {
    {"cube_opposite_faces", "0.19982489569838738304"},
    {"cube_adjacent_faces", "0.20004377607540315424"},
    {"parallel_squares_h_1/2", "0.41525328357714673537"},
    {"parallel_squares_h_2", "0.06858958881855244779"},
    {"squares_common_edge_60_degrees", "0.3709053211500514359"},
    {"squares_common_edge_90_degrees", "0.20004377607540315424"},
    {"squares_common_edge_120_degrees", "0.08661500111827605883"},
    {"regular_tetrahedron_adjacent", "0.33333333333333333333"},
    {"corner_tetrahedron_leg_to_leg", "0.21132486540518711775"},
    {"coaxial_disks_1_1_1", "0.38196601125010515180"},
    {"sphere_to_coaxial_disk_1_1/2", "0.27639320225002103036"},
    {"point_cube_centre_to_opposite", "0.239456470460773538825"},
    {"point_cube_centre_to_adjacent", "0.19013588238480661529"},
    {"point_triangle_constant", "0.096225044864937627418"},
    {"point_triangle_constant_tilted", "0.08878201174185088557"},
    {"point_triangle_x", "0.028774955135062372582"},
    {"point_triangle_x_tilted", "0.02821038361001400224186293"},
    {"two_squares_1", "1.19901694200745466734732784136"},
    {"two_squares_xi_minus_x", "0.03587048430574663062415412568602655130141"},
    {"two_squares_eta", "0.29708137306324786544485847876"},
    {"edge_exponent_90_rho_1/2", "0.76336207521951358985"},
    {"concentric_spheres_inner_radiosity", "1.1111111111111111111"},
    {"concentric_spheres_outer_radiosity", "0.2222222222222222222"},
    {"cube_floor_radiosity", "1.09090909810769547"},
    {"cube_ceiling_radiosity", "0.181745826107788481"},
    {"cube_wall_radiosity", "0.181836268946129011"},
    {"sphere_exp_z_excess", "1.1752011936438014569"},
    {"superconvergent_inset_3", "0.07793654034364663527"},
};

EnclosedValue enclosed(const NamedValue& value, int digits) {
  return enclose(*find_family(value.family), value.arguments, digits).value();
}

TEST(ReferenceValues, HaveTheDigitsThatAreKnown) {
  for (const KnownDigits& expected : known) {
    const NamedValue* value = find_value(expected.name);
    ASSERT_NE(value, nullptr) << expected.name;
    const std::string text = expected.digits;
    const long places = static_cast<long>(text.size() - text.find('.') - 1);
    const BallPrecision precision(256);
    const Ball around = widened(Ball(Rational::parse(text).value()), power(Ball(10), -places));
    const EnclosedValue found = enclosed(*value, 30);
    for (const RouteValue& route : {found.first, found.second})
      EXPECT_TRUE(overlaps(around, route.value))
          << expected.name << ", " << route.how << ": " << route.value.to_text(40) << ", not " << text;
    EXPECT_LE(found.first.value.radius(), 1e-30) << expected.name;
  }
}

TEST(ReferenceValues, AgreeBetweenTheirRoutes) {
  // enclose() throws where they do not.
  for (const NamedValue& value : named_values()) {
    const EnclosedValue found = enclosed(value, 12);
    EXPECT_LE(found.first.value.radius(), 1e-12) << value.name;
    EXPECT_LE(found.second.value.radius(), 1e-12) << value.name;
    EXPECT_NE(found.first.how, found.second.how) << value.name;
  }
}

TEST(ReferenceValues, CoverManyFamiliesUnderLegalNames) {
  std::set<std::string> names;
  std::set<std::string> families;
  const auto is_legal = [](const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
      return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '_' || c == '/';
    });
  };
  for (const ValueFamily& family : value_families()) {
    EXPECT_TRUE(is_legal(family.name)) << family.name;
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_FALSE(family.summary.empty() || family.formula.empty() || family.source.empty()) << family.name;
    const Arguments defaults = default_arguments(family);
    for (std::size_t i = 0; i < defaults.size(); ++i)
      EXPECT_TRUE(family.parameters[i].allows(defaults[i]))
          << family.name << " " << family.parameters[i].name;
  }
  for (const NamedValue& value : named_values()) {
    EXPECT_TRUE(is_legal(value.name)) << value.name;
    EXPECT_TRUE(names.insert(value.name).second) << value.name;
    const ValueFamily* family = find_family(value.family);
    ASSERT_NE(family, nullptr) << value.name;
    ASSERT_EQ(value.arguments.size(), family->parameters.size()) << value.name;
    families.insert(value.family);
  }
  EXPECT_GE(named_values().size(), 60U);
  EXPECT_GE(families.size(), 15U);
}

TEST(ReferenceValues, TakeTheirDefaultsInEveryFamily) {
  for (const ValueFamily& family : value_families()) {
    const Outcome<EnclosedValue> value = enclose(family, default_arguments(family), 8);
    EXPECT_TRUE(value) << family.name << ": " << (value ? "" : value.reason());
  }
}

TEST(ReferenceValues, RefuseArgumentsThatTheyDoNotAllow) {
  const ValueFamily& family = *find_family("opposed_rectangles");
  EXPECT_THROW((void)enclose(family, {1, 1, 0}, 10), ContractViolation);
  EXPECT_THROW((void)enclose(family, {1, 1}, 10), ContractViolation);
  EXPECT_THROW((void)enclose(family, {1, 1, 1}, 0), ContractViolation);
  EXPECT_THROW((void)enclose(family, {1, 1, 1}, 1002), ContractViolation);
  EXPECT_EQ(find_family("opposed_rectangle"), nullptr);
  EXPECT_EQ(find_value("cube"), nullptr);
}

TEST(ReferenceValues, SayWhichRadiusWasReached) {
  ValueFamily family = *find_family("opposed_rectangles");
  family.route = by_formula("a formula of few digits", [](const Arguments&) {
    const BallPrecision few(20);
    return Ball(1) / Ball(3);
  });
  const Outcome<EnclosedValue> value = enclose(family, {1, 1, 1}, 20);
  ASSERT_FALSE(value);
  EXPECT_NE(value.reason().find("a formula of few digits"), std::string::npos) << value.reason();
  EXPECT_NE(value.reason().find("0.3333"), std::string::npos) << value.reason();
}

TEST(ReferenceValues, AreNotGivenWhereTheRoutesContradictEachOther) {
  ValueFamily family = *find_family("opposed_rectangles");
  family.route = by_formula("wrong by 1e-10", [](const Arguments&) {
    return Ball(Rational::parse("0.19982489579838738304").value());
  });
  EXPECT_THROW((void)enclose(family, {1, 1, 1}, 15), std::logic_error);
}

}  // namespace
}  // namespace radcert::reference
