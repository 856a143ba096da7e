// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::by_piece;
using testing::everywhere;
using testing::fault_of;
using ::testing::HasSubstr;
using testing::sample_problem;
using testing::with_basis;

constexpr std::uint64_t plenty = std::uint64_t{1} << 40U;

/// Expects a refusal at `pointer` that shows `value`, and returns it.
InputFault expect_refused(const Problem& problem, const std::string& pointer, const std::string& value,
                          std::uint64_t memory = plenty) {
  const InputFault fault = fault_of([&] { check(problem, memory); });
  EXPECT_EQ(fault.pointer, pointer) << fault.problem;
  EXPECT_EQ(fault.value.value_or(""), value) << pointer;
  EXPECT_FALSE(fault.problem.empty()) << pointer;
  EXPECT_FALSE(fault.allowed.empty()) << pointer;
  return fault;
}

Problem with_levels(Problem problem, std::vector<int> levels) {
  problem.triangulation.levels = std::move(levels);
  return problem;
}

Problem with_reflectivity(Problem problem, PiecewiseExpression reflectivity) {
  problem.reflectivity = std::move(reflectivity);
  return problem;
}

TEST(Check, AdmitsEveryUnoccludedSurfaceOfTheCatalogue) {
  for (const SurfaceDescription& entry : surface_catalogue()) {
    std::vector<SurfaceParameter> parameters;
    for (const ParameterDescription& parameter : entry.parameters)
      parameters.push_back({parameter.name, *Rational::parse(parameter.default_text)});
    const Problem problem = sample_problem(entry.name, parameters);
    if (entry.unoccluded) {
      EXPECT_NO_THROW(check(problem, plenty)) << entry.name;
    } else {
      EXPECT_THAT(expect_refused(problem, "/surface/name", entry.name).problem, HasSubstr("hide each other"));
    }
  }
}

TEST(Check, RefusesUnknownSurfacesAndNamesTheKnownOnes) {
  const InputFault fault = expect_refused(sample_problem("moebius"), "/surface/name", "moebius");
  for (const SurfaceDescription& entry : surface_catalogue())
    EXPECT_EQ(fault.allowed.find(entry.name) != std::string::npos, entry.unoccluded) << entry.name;
}

TEST(Check, RefusesMissingAndInadmissibleParameters) {
  expect_refused(sample_problem("two_piece"), "/surface/p", "");
  expect_refused(sample_problem("two_piece", {{"p", Rational(1, 2)}}), "/surface/p", "1/2");
  expect_refused(sample_problem("box", {{"a", 1}, {"b", 2}}), "/surface/c", "");
  expect_refused(sample_problem("ellipsoid", {{"a", 1}, {"b", 0}, {"c", 1}}), "/surface/b", "0");
}

TEST(Check, RefusesDegreesOutOfRange) {
  for (const int degree : {-1, 11, 1000, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()})
    expect_refused(with_basis(sample_problem("sphere"), degree, Rational(1, 6)), "/basis/degree",
                   std::to_string(degree));
  EXPECT_NO_THROW(check(with_basis(sample_problem("sphere"), 10, Rational(1, 6)), plenty));
}

TEST(Check, RefusesInsetsOutOfRange) {
  for (const Rational& alpha : {Rational(1, 3), Rational(2, 5), Rational(-1, 10)})
    expect_refused(with_basis(sample_problem("sphere"), 1, alpha), "/basis/alpha", alpha.to_text());
  expect_refused(with_basis(sample_problem("sphere"), 1, Rational(333334, 1000000)), "/basis/alpha",
                 Rational(333334, 1000000).to_text());
  expect_refused(with_basis(sample_problem("sphere"), 2, std::nullopt), "/basis/alpha", "");
  EXPECT_NO_THROW(check(with_basis(sample_problem("sphere"), 1, Rational(333333, 1000000)), plenty));
  EXPECT_NO_THROW(check(with_basis(sample_problem("sphere"), 1, Rational(0)), plenty));
}

TEST(Check, IgnoresTheInsetOfDegreeZero) {
  EXPECT_NO_THROW(check(with_basis(sample_problem("cube"), 0, std::nullopt), plenty));
  EXPECT_NO_THROW(check(with_basis(sample_problem("cube"), 0, Rational(0)), plenty));
  EXPECT_NO_THROW(check(with_basis(sample_problem("cube"), 0, Rational(5)), plenty));
}

TEST(Check, RefusesNodesOnOrNextToEdgesWherePiecesMeetAtAnAngle) {
  for (const char* surface : {"cube", "two_squares"}) {
    const Problem problem = sample_problem(surface);
    const InputFault on_edge = expect_refused(with_basis(problem, 1, Rational(0)), "/basis/alpha", "0");
    EXPECT_THAT(on_edge.problem, HasSubstr("on edges"));
    const Rational tiny = Rational(1) / power(Rational(10), 9);
    EXPECT_THAT(expect_refused(with_basis(problem, 1, tiny), "/basis/alpha", tiny.to_text()).problem,
                HasSubstr("too close to edges"));
  }
  // The bound is 2^(level - 26) of the finest level: nodes keep half of a double's digits of their distance.
  const Rational bound = Rational(1) / power(Rational(2), 24);
  const Problem finest = with_levels(sample_problem("cube"), {0, 2});
  EXPECT_NO_THROW(check(with_basis(finest, 1, bound), plenty));
  expect_refused(with_basis(finest, 1, bound * Rational(999, 1000)), "/basis/alpha",
                 (bound * Rational(999, 1000)).to_text());
}

TEST(Check, AdmitsNodesOnSeamsThatAreSmoothOrFree) {
  EXPECT_NO_THROW(check(with_basis(sample_problem("sphere"), 1, Rational(0)), plenty));
  EXPECT_NO_THROW(check(with_basis(sample_problem("two_piece", {{"p", 2}}), 2, Rational(0)), plenty));
}

TEST(Check, RefusesLevelsThatAreNotAscendingWholeNumbers) {
  expect_refused(with_levels(sample_problem("cube"), {}), "/triangulation/levels", "[]");
  expect_refused(with_levels(sample_problem("cube"), {-1}), "/triangulation/levels/0", "-1");
  expect_refused(with_levels(sample_problem("cube"), {0, 2, 1}), "/triangulation/levels/2", "1");
  expect_refused(with_levels(sample_problem("cube"), {1, 1}), "/triangulation/levels/1", "1");
  EXPECT_NO_THROW(check(with_levels(sample_problem("cube"), {1, 3}), plenty));
}

TEST(Check, RefusesAbsurdLevelsNamingTheBytes) {
  Problem problem = sample_problem("cube");
  problem.matrix.name = "dense";
  for (const int level : {13, 20, 40, std::numeric_limits<int>::max()}) {
    const InputFault fault =
        expect_refused(with_levels(problem, {0, level}), "/triangulation/levels/1", std::to_string(level),
                       std::numeric_limits<std::uint64_t>::max() - 1);
    EXPECT_THAT(fault.problem, HasSubstr("bytes")) << level;
    EXPECT_THAT(fault.problem, HasSubstr("triangles")) << level;
  }
}

TEST(Check, RefusesALevelExactlyIfItsPlanExceedsTheMemory) {
  const Problem problem = with_levels(sample_problem("cube"), {0, 1});
  const std::uint64_t needed = level_plan(problem, 48).total();
  EXPECT_NO_THROW(check(problem, needed));
  const InputFault fault = expect_refused(problem, "/triangulation/levels/1", "1", needed - 1);
  EXPECT_THAT(fault.problem, HasSubstr(std::to_string(needed) + " bytes"));
  EXPECT_THAT(fault.problem, HasSubstr("48 triangles"));
  EXPECT_THAT(fault.allowed, HasSubstr(std::to_string(needed - 1)));
  expect_refused(problem, "/triangulation/levels/0", "0", 0);
}

TEST(Check, RefusesALevelByWhatItsSolverNeeds) {
  Problem problem = with_levels(sample_problem("cube"), {0, 3});
  Problem by_direct = problem;
  by_direct.solver.name = "direct";
  problem.solver.name = "gmres";
  const std::uint64_t between = level_plan(problem, 768).total();
  expect_refused(by_direct, "/triangulation/levels/1", "3", between);
  EXPECT_NO_THROW(check(problem, between));
  expect_refused(problem, "/triangulation/levels/1", "3", between - 1);
  problem.solver.name = "neumann";
  EXPECT_NO_THROW(check(problem, between - 1));
}

TEST(Check, RefusesTolerancesThatDoubleCannotHoldOrThatDirectHasNot) {
  Problem problem = sample_problem("cube");
  for (const char* name : {"gmres", "neumann"}) {
    problem.solver = {.name = name, .tolerance = Rational(1, 1000)};
    EXPECT_NO_THROW(check(problem, plenty));
    problem.solver.tolerance = Rational::exactly(0x1p-51);
    EXPECT_NO_THROW(check(problem, plenty));
    for (const Rational& tolerance : {Rational(0), Rational(-1), Rational(1), Rational::exactly(0x1.fffp-52),
                                      Rational::exactly(1e-300)}) {
      problem.solver.tolerance = tolerance;
      expect_refused(problem, "/solver/tolerance", tolerance.to_text());
    }
  }
  problem.solver = {.name = "direct", .tolerance = Rational(1, 1000)};
  expect_refused(problem, "/solver/tolerance", "1/1000");
}

TEST(Check, RefusesAQuadratureTolerance) {
  Problem problem = sample_problem("cube");
  problem.quadrature.tolerance = Rational(1, 1000000);
  EXPECT_NO_THROW(check(problem, plenty));
  for (const Rational& tolerance :
       {Rational(0), Rational(-1), Rational(1) / power(Rational(10), 14), Rational(1, 10)}) {
    problem.quadrature.tolerance = tolerance;
    expect_refused(problem, "/quadrature/tolerance", tolerance.to_text());
  }
}

TEST(Check, RefusesAGradingBelowOne) {
  Problem problem = sample_problem("cube");
  problem.triangulation.grading = Rational(99, 100);
  expect_refused(problem, "/triangulation/grading", "99/100");
  problem.triangulation.grading = 3;
  EXPECT_NO_THROW(check(problem, plenty));
}

TEST(Check, RefusesReflectivitiesOutsideTheUnitInterval) {
  const Problem open = sample_problem("two_piece", {{"p", 2}});
  expect_refused(with_reflectivity(open, everywhere("1.5")), "/reflectivity", "1.5");
  expect_refused(with_reflectivity(open, everywhere("-1/10")), "/reflectivity", "-1/10");
  expect_refused(with_reflectivity(open, by_piece({{"lower", "1"}, {"*", "3/2"}})), "/reflectivity/*", "3/2");
  expect_refused(with_reflectivity(open, by_piece({{"lower", "2"}, {"upper", "0"}})), "/reflectivity/lower",
                 "2");
  EXPECT_NO_THROW(check(with_reflectivity(open, everywhere("1")), plenty));
  EXPECT_NO_THROW(check(with_reflectivity(open, everywhere("0")), plenty));
}

TEST(Check, RefusesANormOfOneOnClosedSurfaces) {
  for (const char* surface : {"cube", "sphere"}) {
    expect_refused(with_reflectivity(sample_problem(surface), everywhere("1")), "/reflectivity", "1");
    EXPECT_NO_THROW(check(with_reflectivity(sample_problem(surface), everywhere("0.999")), plenty));
  }
  expect_refused(with_reflectivity(sample_problem("cube"), by_piece({{"floor", "1"}, {"*", "0"}})),
                 "/reflectivity", "1");
}

TEST(Check, RefusesPiecesThatAreMissingOrUnknown) {
  Problem problem = sample_problem("two_piece", {{"p", 2}});
  expect_refused(with_reflectivity(problem, by_piece({{"lower", "1/2"}})), "/reflectivity", "upper");
  expect_refused(with_reflectivity(problem, by_piece({{"*", "1/2"}, {"roof", "0"}})), "/reflectivity/roof",
                 "roof");
  problem.solution = by_piece({{"upper", "1"}});
  expect_refused(problem, "/solution", "lower");
  problem.solution = std::nullopt;
  problem.emission = by_piece({{"upper", "1"}});
  expect_refused(problem, "/emission", "lower");
}

TEST(Check, LeavesOutAReflectivityThatNoPieceHas) {
  Problem problem = sample_problem("sphere");
  problem.reflectivity = by_piece({{"sphere", "1/2"}, {"*", "1"}});
  EXPECT_NO_THROW(check(problem, plenty));
  problem.reflectivity = by_piece({{"sphere", "1"}, {"*", "1/2"}});
  EXPECT_THROW(check(problem, plenty), InputError);
}

TEST(Check, WantsExactlyOneOfSolutionAndEmission) {
  Problem problem = sample_problem("cube");
  problem.emission = everywhere("1");
  EXPECT_THAT(expect_refused(problem, "", "").problem, HasSubstr("both"));
  problem.solution = std::nullopt;
  EXPECT_NO_THROW(check(problem, plenty));
  problem.emission = std::nullopt;
  EXPECT_THAT(expect_refused(problem, "", "").problem, HasSubstr("neither"));
}

TEST(PiecewiseExpression, TakesTheNamedCaseBeforeTheRest) {
  const PiecewiseExpression function = by_piece({{"*", "1"}, {"floor", "2"}, {"ceiling", "3"}});
  EXPECT_EQ(function.on("floor").text(), "2");
  EXPECT_EQ(function.on("ceiling").text(), "3");
  EXPECT_EQ(function.on("west").text(), "1");
  EXPECT_THROW(static_cast<void>(by_piece({{"floor", "2"}}).on("west")), ContractViolation);
  EXPECT_THROW(static_cast<void>(PiecewiseExpression{}.on("west")), ContractViolation);
}

TEST(SurfaceOf, TakesParametersByNameInAnyOrder) {
  const Surface surface = surface_of(sample_problem("box", {{"c", 5}, {"a", 1}, {"b", 2}}));
  ASSERT_EQ(surface.parameters.size(), 3U);
  EXPECT_EQ(surface.parameters[0].value, Rational(1));
  EXPECT_EQ(surface.parameters[1].value, Rational(2));
  EXPECT_EQ(surface.parameters[2].value, Rational(5));
  EXPECT_EQ(surface.name, "box");
}

}  // namespace
}  // namespace radcert
