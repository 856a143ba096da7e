// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/guarantee.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::by_piece;
using testing::everywhere;
using testing::fault_of;
using ::testing::HasSubstr;
using testing::sample_problem;
using testing::with_emission;
using testing::with_solution;

Problem lit_cube() {
  Problem problem = with_emission(sample_problem("cube"), "1");
  problem.emission = by_piece({{"floor", "1"}, {"*", "0"}});
  return problem;
}

InputFault refused(const Problem& problem, const Rational& width = Rational(1, 100)) {
  return fault_of([&] { check_guarantee(problem, {width}); });
}

TEST(Guarantee, IsGivenForConstantDataOnConvexPolyhedra) {
  for (const char* name : {"cube", "tetrahedron", "octahedron"})
    EXPECT_NO_THROW(check_guarantee(with_emission(sample_problem(name), "1/3"), {Rational(1, 100)})) << name;
  // Constant on each face, though not as a formula.
  Problem problem = lit_cube();
  problem.reflectivity = by_piece({{"floor", "1/2 + z"}, {"*", "1/2"}});
  EXPECT_NO_THROW(check_guarantee(problem, {Rational(1, 100)}));
}

TEST(Guarantee, IsRefusedByNameElsewhere) {
  const std::string name = "two_piece";
  const InputFault fault = refused(with_emission(sample_problem(name, {{"p", 2}}), "1"));
  EXPECT_EQ(fault.pointer, "/surface/name");
  EXPECT_EQ(fault.value, name);
  EXPECT_THAT(fault.allowed, HasSubstr("convex polyhedron with exact planes"));
  EXPECT_EQ(refused(with_solution(sample_problem("cube"), "1")).pointer, "/solution");
  Problem interpolated = lit_cube();
  interpolated.geometry = InterpolatedGeometry{};
  EXPECT_EQ(refused(interpolated).pointer, "/geometry");
}

TEST(Guarantee, RefusesDataThatItDoesNotKnow) {
  Problem problem = lit_cube();
  for (const char* rho :
       {"1", "3/2", "-1/10", "1/2 + x/2", "x - 1/1000", "exp(x)/4", "x^9/2", "(x - 1/3)^2/4"}) {
    problem.reflectivity = everywhere(rho);
    EXPECT_EQ(refused(problem).pointer, "/reflectivity") << rho;
  }
  for (const char* rho : {"1/2 + x/10", "x/2", "(x*y*z)^2*y*z/3 + 1/3", "1/2 - x*(1 - x)"}) {
    problem.reflectivity = everywhere(rho);
    EXPECT_NO_THROW(check_guarantee(problem, {Rational(1, 100)})) << rho;
  }
  problem = lit_cube();
  for (const char* emission : {"abs(x - 1/2)", "1/x", "sqrt(x + y)", "1/(x + 1/1000)"}) {
    problem.emission = everywhere(emission);
    EXPECT_EQ(refused(problem).pointer, "/emission") << emission;
  }
  for (const char* emission : {"exp(2*x)", "x^9", "1/(2 + x)"}) {
    problem.emission = everywhere(emission);
    EXPECT_NO_THROW(check_guarantee(problem, {Rational(1, 1000)})) << emission;
    EXPECT_EQ(refused(problem, Rational::parse("2e-9").value()).pointer, "/emission") << emission;
  }
  problem.emission = everywhere("exp(x)*cos(y)");
  EXPECT_NO_THROW(check_guarantee(problem, {Rational::parse("1e-6").value()}));
  problem.emission = everywhere("x^3*y^2 - z/3");
  EXPECT_NO_THROW(check_guarantee(problem, {Rational(1, 100)}));
  problem.emission = everywhere("1e-70*x");
  EXPECT_EQ(refused(problem).pointer, "/emission");
}

TEST(Guarantee, SaysTheSmallestWidth) {
  const InputFault fault = refused(lit_cube(), Rational::parse("1e-12").value());
  EXPECT_EQ(fault.pointer, "/guarantee/width");
  EXPECT_THAT(fault.allowed, HasSubstr("e-10 or more"));
  EXPECT_EQ(refused(lit_cube(), 0).pointer, "/guarantee/width");
  // A width beyond what double holds is no leave to say anything.
  EXPECT_EQ(refused(lit_cube(), Rational::parse("1e309").value()).pointer, "/guarantee/width");
  EXPECT_EQ(refused(with_emission(sample_problem("cube"), "0"), Rational::parse("1e-400").value()).pointer,
            "/guarantee/width");
}

TEST(Guarantee, TakesPointsInsideFacesAlone) {
  const auto fault = [](const Vector<Rational>& point, EnclosedQuantity of) {
    return fault_of([&] { check_guarantee(lit_cube(), {Rational(1, 100), of, {point}}); });
  };
  const Rational half(1, 2);
  EXPECT_NO_THROW(
      check_guarantee(lit_cube(), {Rational(1, 100), EnclosedQuantity::values, {{half, half, 0}}}));
  for (const Vector<Rational>& point :
       {Vector<Rational>{half, half, half}, {half, 0, 0}, {0, 0, 0}, {half, half, 2}}) {
    EXPECT_EQ(fault(point, EnclosedQuantity::values).pointer, "/guarantee/points/0");
    EXPECT_THAT(fault(point, EnclosedQuantity::values).allowed, HasSubstr("none of its edges"));
  }
  const Rational hair = Rational::parse("1e-16").value();
  EXPECT_THAT(fault({half, hair, 0}, EnclosedQuantity::values).problem, HasSubstr("too near to an edge"));
  EXPECT_EQ(fault({half, half, 0}, EnclosedQuantity::means).pointer, "/guarantee/points");
}

TEST(Guarantee, TakesADistanceForFunctionsOnPolyhedraAlone) {
  const auto fault = [](const Problem& problem, EnclosedQuantity of, const Rational& outside) {
    return fault_of([&] { check_guarantee(problem, {Rational(1, 100), of, {}, outside}); });
  };
  EXPECT_NO_THROW(
      check_guarantee(lit_cube(), {Rational(1, 100), EnclosedQuantity::function, {}, Rational(1, 20)}));
  EXPECT_EQ(fault(lit_cube(), EnclosedQuantity::means, 1).pointer, "/guarantee/outside");
  EXPECT_EQ(fault(lit_cube(), EnclosedQuantity::function, -1).pointer, "/guarantee/outside");
  EXPECT_THAT(fault(lit_cube(), EnclosedQuantity::function, Rational(3, 2)).allowed,
              HasSubstr("less than 1.41421"));
  EXPECT_EQ(fault(with_emission(sample_problem("sphere"), "1"), EnclosedQuantity::function, 1).pointer,
            "/guarantee/outside");
}

TEST(Guarantee, GivesAFunctionOnAPolyhedron) {
  Problem problem = with_emission(sample_problem("tetrahedron"), "7/8");
  problem.reflectivity = everywhere("1/8");
  const auto [level, enclosure] = solve_within(problem, {4, EnclosedQuantity::function, {}, Rational(1, 10)});
  EXPECT_TRUE(enclosure.hindrance.empty());
  ASSERT_TRUE(enclosure.function.has_value());
  EXPECT_LE(2 * enclosure.function->sup, 4);
  EXPECT_EQ(enclosure.function->pieces.size(), 4U);
  EXPECT_EQ(enclosure.patches.size(), 16 * level.elements);
  for (const EnclosedPatch& patch : enclosure.patches)
    for (const double value : patch.values) EXPECT_LE(std::abs(value - 1), patch.bound) << patch.piece;
}

TEST(Guarantee, GivesTheValuesAtCentres) {
  Problem problem = with_emission(sample_problem("tetrahedron"), "3/5");
  problem.reflectivity = everywhere("2/5");
  const auto [level, enclosure] = solve_within(problem, {1, EnclosedQuantity::values, {}});
  EXPECT_TRUE(enclosure.pieces.empty());
  EXPECT_TRUE(level.piece_means.empty());
  ASSERT_EQ(enclosure.points.size(), 4U);
  for (const EnclosedValue& point : enclosure.points) {
    EXPECT_TRUE(point.value.guaranteed);
    EXPECT_LE(std::abs(point.value.value - 1), point.value.radius) << point.piece;
  }
}

TEST(Guarantee, IsGivenOnTheSphereEverywhere) {
  // K u = rho times the mean of u on the unit sphere: u = E + rho/(1 - rho) mean E, mean z^2 = 1/3.
  Problem problem = with_emission(sample_problem("sphere"), "z^2");
  problem.reflectivity = everywhere("3/4");
  const Rational width(1, 1000000);
  const SolutionEnclosure means = solve_within(problem, {width}).second;
  ASSERT_EQ(means.pieces.size(), 1U);
  EXPECT_NEAR(means.pieces[0].second.value, 4.0 / 3, means.pieces[0].second.radius);
  const Rational fifth(1, 5);
  const Guarantee at{width, EnclosedQuantity::values, {{0, Rational(3) * fifth, Rational(4) * fifth}}};
  const SolutionEnclosure values = solve_within(problem, at).second;
  ASSERT_EQ(values.points.size(), 1U);
  EXPECT_NEAR(values.points[0].value.value, 1.64, values.points[0].value.radius);
  EXPECT_TRUE(values.points[0].value.guaranteed);
  const SolutionEnclosure everywhere_on =
      solve_within(problem, {width, EnclosedQuantity::function, {}}).second;
  ASSERT_TRUE(everywhere_on.function);
  EXPECT_LE(everywhere_on.function->sup, 0.5e-6);
  EXPECT_LE(everywhere_on.width, 1e-6);
  EXPECT_TRUE(everywhere_on.hindrance.empty());
}

TEST(Guarantee, TakesOpenSurfacesAsClosedByBlackFaces) {
  // What is lit between two squares: from the factor F of one to the other, u on the dark one lies between
  // rho F E, once reflected, and that with all that comes back and forth.
  Problem problem = with_emission(sample_problem("two_squares"), "1");
  problem.emission = by_piece({{"xz", "1"}, {"xy", "0"}});
  const auto [level, enclosure] = solve_within(problem, {Rational(1, 100)});
  ASSERT_EQ(enclosure.pieces.size(), 2U);
  EXPECT_TRUE(enclosure.hindrance.empty());
  EXPECT_LE(enclosure.width, 0.01);
  const double factor = 0.2000437760754;  // known to be this for squares that share an edge
  const double rho = 0.5;
  const Approximation dark = enclosure.pieces[1].second;
  EXPECT_GT(dark.value + dark.radius, rho * factor);
  EXPECT_LT(dark.value - dark.radius, rho * factor / (1 - rho * rho * 0.25));
  EXPECT_TRUE(level.norm_K.guaranteed);
  EXPECT_GE(level.norm_K.value + level.norm_K.radius, rho);
  const SolutionEnclosure values =
      solve_within(problem, {Rational(1, 5), EnclosedQuantity::values, {}}).second;
  EXPECT_EQ(values.points.size(), 2U);
  const SolutionEnclosure function =
      solve_within(problem, {1, EnclosedQuantity::function, {}, Rational(1, 10)}).second;
  EXPECT_EQ(function.function->pieces.size(), 2U);
  for (const EnclosedPatch& patch : function.patches) EXPECT_TRUE(patch.piece == "xz" || patch.piece == "xy");
}

TEST(Guarantee, KnowsTheNormOfKForFormulasOfTheReflectivity) {
  // 1 - rho times 2: u = 2. sup of 1/2 + z/5 on the sphere is 7/10.
  Problem problem = with_emission(sample_problem("sphere"), "1 - 2*z/5");
  problem.reflectivity = everywhere("1/2 + z/5");
  const auto [level, enclosure] = solve_within(problem, {Rational(1, 1000)});
  EXPECT_NEAR(enclosure.pieces[0].second.value, 2, enclosure.pieces[0].second.radius);
  EXPECT_TRUE(level.norm_K.guaranteed);
  EXPECT_NEAR(level.norm_K.value, 0.7, level.norm_K.radius);
  EXPECT_LT(level.norm_K.radius, 0.3);
  problem = lit_cube();
  problem.reflectivity = by_piece({{"floor", "1/2 + z"}, {"*", "1/4"}});
  const LevelResult on_cube = solve_within(problem, {1}).first;
  EXPECT_EQ(on_cube.norm_K.value, 0.5);
}

TEST(Guarantee, OfAFunctionOnAnEllipsoidCountsHowItsValuesAreRounded) {
  // u = E, of which no polynomial misses anything.
  Problem problem = with_emission(sample_problem("sphere"), "1/3 + z^2 + x*y^3");
  problem.reflectivity = everywhere("0");
  const SolutionEnclosure enclosure =
      solve_within(problem, {Rational(1, 1'000'000'000), EnclosedQuantity::function, {}}).second;
  ASSERT_FALSE(enclosure.patches.empty());
  for (const EnclosedPatch& patch : enclosure.patches)
    for (std::size_t k = 0; k < patch.corners.size(); ++k) {
      const Vector<double>& p = patch.corners[k];
      EXPECT_GE(patch.bound, unit_roundoff<double>() * std::abs(patch.values[k]));
      EXPECT_NEAR(patch.values[k], 1.0 / 3 + p.z * p.z + p.x * p.y * p.y * p.y, 1e-14);
    }
}

TEST(Guarantee, RefusesOnEllipsoidsWhatIsNoPolynomial) {
  const auto fault = [](const char* emission, const char* rho, const Guarantee& guarantee) {
    const std::vector<SurfaceParameter> axes{{"a", 1}, {"b", Rational(13, 10)}, {"c", Rational(17, 10)}};
    Problem problem = with_emission(sample_problem("ellipsoid", axes), emission);
    problem.reflectivity = everywhere(rho);
    return fault_of([&] { check_guarantee(problem, guarantee); }).pointer;
  };
  const Rational width(1, 1000);
  EXPECT_EQ(fault("exp(x)", "1/2", {width}), "/emission");
  EXPECT_EQ(fault("x", "1/2 + x", {width}), "/reflectivity");
  EXPECT_EQ(fault("x", "1", {width}), "/reflectivity");
  EXPECT_EQ(fault("x", "1/2", {Rational::parse("1e-15").value()}), "/guarantee/width");
  EXPECT_EQ(fault("x", "1/2", {width, EnclosedQuantity::values, {{1, 1, 1}}}), "/guarantee/points/0");
}

TEST(Guarantee, IsOfSeveralEmissionsAtOnce) {
  Problem problem = lit_cube();
  Guarantee guarantee{Rational(1, 4)};
  guarantee.emissions = emissions_by_piece({"west", "east", "south", "north", "floor", "ceiling"});
  guarantee.emissions.push_back({"all", everywhere("1/2")});
  const auto [level, enclosure] = solve_within(problem, guarantee);
  ASSERT_EQ(enclosure.emissions.size(), 7U);
  EXPECT_LE(enclosure.width, 0.25);
  const auto mean = [](const auto& pieces, const std::string& piece) {
    for (const auto& [name, value] : pieces)
      if (name == piece) return value;
    return Approximation::proved(0, -1);
  };
  for (const auto& [piece, own] : enclosure.pieces) {
    // The floor emits, in the problem as in the fifth of these.
    EXPECT_EQ(enclosure.emissions[4].emission, "floor");
    const Approximation of_floor = mean(enclosure.emissions[4].pieces, piece);
    EXPECT_NEAR(of_floor.value, own.value, of_floor.radius + own.radius);
    // A furnace.
    const Approximation of_all = mean(enclosure.emissions[6].pieces, piece);
    EXPECT_NEAR(of_all.value, 1, of_all.radius);
    EXPECT_GE(of_all.radius, 0);
  }
  guarantee.of = EnclosedQuantity::function;
  const auto refusal = [&](const Problem& asked) {
    return fault_of([&] { check_guarantee(asked, guarantee); }).pointer;
  };
  EXPECT_EQ(refusal(problem), "/guarantee/emissions");
  guarantee.of = EnclosedQuantity::means;
  EXPECT_EQ(refusal(with_emission(sample_problem("sphere"), "1")), "/guarantee/emissions");
  guarantee.emissions[0].emission = everywhere("1/x");
  EXPECT_EQ(refusal(problem), "/guarantee/emissions/west");
}

TEST(Guarantee, IsForSolveAlone) {
  Problem problem = lit_cube();
  problem.guarantee = Guarantee{Rational(1, 100)};
  EXPECT_EQ(fault_of([&] { check(problem, 1U << 30U); }).pointer, "/guarantee");
}

TEST(Guarantee, CountsWhatThePolynomialNearAnEmissionLeaves) {
  // Nothing reflects: u = E, with the mean log 5 of 1/(1/4 + x) on the floor. Rounding alone would leave
  // 1e-14.
  Problem problem = lit_cube();
  problem.reflectivity = everywhere("0");
  problem.emission = by_piece({{"floor", "1/(1/4 + x)"}, {"*", "0"}});
  const SolutionEnclosure enclosure = solve_within(problem, {1}).second;
  for (const auto& [piece, mean] : enclosure.pieces) {
    const double truth = piece == "floor" ? std::log(5.0) : 0;
    EXPECT_LE(std::abs(mean.value - truth), mean.radius) << piece;
    EXPECT_LE(mean.radius, 0.25) << piece;
    EXPECT_TRUE(mean.guaranteed);
  }
  const Guarantee at{1, EnclosedQuantity::values, {{Rational(1, 100), Rational(1, 2), 0}}};
  const SolutionEnclosure values = solve_within(problem, at).second;
  ASSERT_EQ(values.points.size(), 1U);
  EXPECT_LE(std::abs(values.points[0].value.value - 1 / 0.26), values.points[0].value.radius);
  EXPECT_GT(values.points[0].value.radius, 1e-9);
}

TEST(Guarantee, KeepsTheBalanceOfAnEmissionThatIsNoPolynomial) {
  // Int u = Int E/(1 - rho) on a closed surface: 16 (e^(1/4) - 1) + 1 + e^(1/4) over 3/4 for exp(x/4) on the
  // cube.
  Problem problem = with_emission(sample_problem("cube"), "exp(x/4)");
  problem.reflectivity = everywhere("1/4");
  const SolutionEnclosure enclosure = solve_within(problem, {1}).second;
  double sum = 0;
  double radius = 0;
  for (const auto& [piece, mean] : enclosure.pieces) {
    sum += mean.value;
    radius += mean.radius;
  }
  EXPECT_NEAR(sum, (17 * std::exp(0.25) - 15) / 0.75, radius);
  EXPECT_LE(enclosure.width, 1);
}

TEST(Guarantee, GivesTheMeshAndTheMeans) {
  Problem problem = lit_cube();
  const auto [level, enclosure] = solve_within(problem, {Rational(1, 10)});
  EXPECT_EQ(level.level, 2);
  EXPECT_EQ(level.elements, 144U);
  EXPECT_EQ(level.unknowns, 576U);
  EXPECT_TRUE(level.norm_K.guaranteed);
  EXPECT_LE(enclosure.width, 0.1);
  ASSERT_EQ(enclosure.pieces.size(), 6U);
  double sum = 0;
  for (const auto& [piece, mean] : enclosure.pieces) {
    EXPECT_TRUE(mean.guaranteed);
    sum += mean.value;
  }
  EXPECT_NEAR(sum, 2, 0.3);  // Int u = Int E / (1 - rho)
}

}  // namespace
}  // namespace radcert
