// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/goal_enclosure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <span>
#include <vector>

#include "radcert/continuous/elements/local_values.h"
#include "radcert/continuous/goals.h"
#include "radcert/continuous/observer_cells.h"
#include "radcert/continuous/residual.h"
#include "radcert/continuous/trial_functions.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/real.h"
#include "tests/continuous/memory.h"
#include "tests/continuous/rooms.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

PolyhedronProblem problem(const std::string& name, const Rational& rho, const Rational& emission) {
  PolyhedronProblem out{.panels = panels_of(name), .reflectivity = {}, .emission = {}};
  out.reflectivity.assign(out.panels.size(), rho);
  out.emission.assign(out.panels.size(), constant_polynomial(emission));
  return out;
}

/// As `problem`, but that only the first panel emits, and another reflects more.
PolyhedronProblem lit(const std::string& name) {
  PolyhedronProblem out = problem(name, Rational(1, 2), 0);
  out.emission[0] = constant_polynomial(Rational(1));
  out.reflectivity[1] = Rational(7, 10);
  return out;
}

/// E = 1 - rho, where u = 1; rho a polynomial of this degree, another on each panel.
PolyhedronProblem furnace_of_polynomials(const std::string& name, int degree) {
  PolyhedronProblem out = problem(name, 0, 0);
  Draw draw(static_cast<std::uint64_t>(degree));
  for (std::size_t k = 0; k < out.panels.size(); ++k) {
    PlanePolynomial<Rational> rho =
        test::drawn_polynomial(degree, Rational(1, 9 * (degree + 1) * (degree + 2)), draw);
    rho(0, 0) = Rational(1, 3);
    out.reflectivity[k] = reflectivity_of(out.panels[k], rho).value();
    out.emission[k] = sum(constant_polynomial(Rational(1)), Rational(-1), rho);
  }
  return out;
}

void expect_contains(const Approximation& enclosure, double value) {
  EXPECT_TRUE(enclosure.guaranteed);
  EXPECT_LE(std::abs(enclosure.value - value), enclosure.radius * (1 + 1e-9) + 1e-15);
}

/// Points on two faces of a surface, none in a middle.
std::vector<SolutionPoint> points_on(const PolyhedronProblem& asked) {
  std::vector<SolutionPoint> out;
  for (const std::size_t k : {std::size_t{0}, asked.panels.size() - 1}) {
    const Panel& panel = asked.panels[k];
    out.push_back({k, Rational(1, 4) * (Rational(3) * panel.centre + panel.corners[0])});
  }
  return out;
}

TEST(GoalEnclosure, ContainsOneInAFurnace) {
  const GoalEnclosure found = enclose_means(problem("octahedron", Rational(3, 10), Rational(7, 10)), 4e-1);
  EXPECT_LE(found.width, 4e-1);
  EXPECT_TRUE(found.hindrance.empty());
  for (const Approximation& mean : found.numbers) expect_contains(mean, 1);
}

/// rho between 1/10 and 6/10, by piece.
std::vector<Rational> reflectivities(std::size_t pieces) {
  std::vector<Rational> rho;
  for (std::size_t k = 0; k < pieces; ++k) rho.emplace_back(1 + static_cast<long>(k * 3 % 6), 10);
  return rho;
}

TEST(GoalEnclosure, ContainsOneAndKeepsTheBalanceOfEnergyInARoomWhosePartsHideEachOther) {
  const std::vector<Rational> rho = reflectivities(8);
  std::vector<Rational> emission(8, Rational(0));
  emission[4] = 1;
  PolyhedronProblem asked = test::occluded_problem(test::l_room(), rho, emission);
  // T 1 = 1: u = 1 where E = 1 - rho, whatever rho is on each piece.
  std::vector<Rational> of_furnace;
  for (const Rational& r : rho) of_furnace.push_back(Rational(1) - r);
  asked.further_emissions = {test::occluded_problem(test::l_room(), rho, of_furnace).emission};
  const SectorScene scene(asked.panels);
  const GoalEnclosure found = enclose_means(asked, 1.5);
  ASSERT_EQ(found.numbers.size(), 16U);
  for (std::size_t k = 8; k < 16; ++k) expect_contains(found.numbers[k], 1);
  EXPECT_LE(found.width, 1.5);
  double left = 0;
  double radius = 0;
  double right = 0;
  for (std::size_t j = 0; j < asked.panels.size(); ++j) {
    const Approximation& mean = found.numbers[asked.panels[j].piece];
    const double of_piece = asked.reflectivity[j].largest.to_double();
    const double weight = (1 / of_piece - 1) * scene.area(j);
    left += weight * mean.value;
    radius += weight * mean.radius;
    right += asked.emission[j](0, 0).to_double() / of_piece * scene.area(j);
  }
  EXPECT_NEAR(left, right, radius);
  const GoalEnclosure wide = enclose_means(asked, 6.0);
  for (std::size_t k = 0; k < found.numbers.size(); ++k)
    EXPECT_LE(std::abs(found.numbers[k].value - wide.numbers[k].value),
              found.numbers[k].radius + wide.numbers[k].radius);
}

TEST(GoalEnclosure, ContainsOneInAFurnaceOfPolynomials) {
  const GoalEnclosure means = enclose_means(furnace_of_polynomials("tetrahedron", 4), 1.0);
  EXPECT_LE(means.width, 1.0);
  for (const Approximation& mean : means.numbers) expect_contains(mean, 1);
  const PolyhedronProblem furnace = furnace_of_polynomials("tetrahedron", 1);
  const GoalEnclosure values = enclose_values(
      furnace,
      {{1, Rational(1, 4) * (Rational(3) * furnace.panels[1].centre + furnace.panels[1].corners[0])}}, 1.5);
  EXPECT_LE(values.width, 1.5);
  expect_contains(values.numbers[0], 1);
}

TEST(GoalEnclosure, OfPolynomialReflectivitiesIsLinearInTheEmission) {
  // Lit by one half of the faces and by the other, a furnace is u = 1.
  const PolyhedronProblem furnace = furnace_of_polynomials("cube", 2);
  PolyhedronProblem lit_by_halves = furnace;
  lit_by_halves.further_emissions = {furnace.emission, furnace.emission};
  for (std::size_t k = 0; k < furnace.panels.size(); ++k)
    lit_by_halves.further_emissions[k % 2][k] = constant_polynomial(Rational(0));
  const GoalEnclosure means = enclose_means(lit_by_halves, 3e-1);
  EXPECT_LE(means.width, 3e-1);
  const std::size_t count = means.numbers.size() / 3;
  ASSERT_EQ(means.numbers.size(), 3 * count);
  for (std::size_t k = 0; k < count; ++k) {
    EXPECT_GT(means.numbers[count + k].value, 0.05);
    expect_contains(means.numbers[k], 1);
    expect_contains(means.numbers[count + k] + means.numbers[2 * count + k], 1);
  }
}

TEST(GoalEnclosure, OfFurtherEmissionsHasTheirResiduals) {
  // Beside an emission that is 0, and whose residual is none, nothing is lost of another's radius.
  const PolyhedronProblem by_itself = lit("tetrahedron");
  PolyhedronProblem beside = by_itself;
  beside.further_emissions = {beside.emission};
  beside.emission.assign(4, constant_polynomial(Rational(0)));
  const GoalEnclosure alone = enclose_means(by_itself, 1e-1);
  const GoalEnclosure second = enclose_means(beside, 1e-1);
  for (std::size_t k = 0; k < 4; ++k) {
    expect_contains(second.numbers[k], 0);
    EXPECT_GE(second.numbers[4 + k].radius, 0.99 * alone.numbers[k].radius);
    EXPECT_NEAR(second.numbers[4 + k].value, alone.numbers[k].value, 1e-6);
  }
}

TEST(GoalEnclosure, OfValuesForSeveralEmissionsMakesAFurnace) {
  PolyhedronProblem furnace = problem("tetrahedron", Rational(3, 10), Rational(7, 10));
  furnace.further_emissions = {furnace.emission, furnace.emission};
  for (std::size_t k = 0; k < furnace.panels.size(); ++k)
    furnace.further_emissions[k % 2][k] = constant_polynomial(Rational(0));
  const GoalEnclosure found = enclose_values(furnace, points_on(furnace), 1.0);
  EXPECT_LE(found.width, 1.0);
  ASSERT_EQ(found.numbers.size(), 6U);
  for (std::size_t k = 0; k < 2; ++k) {
    expect_contains(found.numbers[k], 1);
    expect_contains(found.numbers[2 + k] + found.numbers[4 + k], 1);
  }
}

/// A point of the parts of faces.
SolutionPoint point_on(const PolyhedronProblem& asked, const Vector<Rational>& at) {
  return {panel_about(asked.panels, at), at};
}

TEST(GoalEnclosure, OfValuesWherePartsHideEachOtherMakesAFurnace) {
  const std::vector<Rational> rho(8, Rational(1, 10));
  const std::vector<Rational> emission(8, Rational(9, 10));
  PolyhedronProblem furnace = test::occluded_problem(test::l_room(), rho, emission);
  furnace.further_emissions = {furnace.emission, furnace.emission};
  for (std::size_t k = 0; k < furnace.panels.size(); ++k)
    furnace.further_emissions[furnace.panels[k].piece == 4 ? 0 : 1][k] = constant_polynomial(Rational(0));
  // From there half of the room is not seen.
  const GoalEnclosure found =
      enclose_values(furnace, {point_on(furnace, {Rational(1, 4), Rational(7, 4), 0})}, 1.0);
  EXPECT_LE(found.width, 1.0);
  ASSERT_EQ(found.numbers.size(), 3U);
  expect_contains(found.numbers[0], 1);
  expect_contains(found.numbers[1] + found.numbers[2], 1);
  EXPECT_GT(found.numbers[1].value, 0.5);
}

TEST(GoalEnclosure, OfEmissionsByFaceIsReciprocal) {
  // B_ij the mean over face i where j emits 1: |S_i| B_ij / rho_i is symmetric, as (I - rho T)^-1 rho is.
  PolyhedronProblem asked = lit("tetrahedron");
  asked.further_emissions.assign(4, asked.emission);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      asked.further_emissions[i][j] = constant_polynomial(Rational(i == j ? 1 : 0));
  const SectorScene scene(asked.panels);
  const std::vector<Approximation> b = enclose_means(asked, 1e-1).numbers;
  ASSERT_EQ(b.size(), 20U);
  const auto weight = [&](std::size_t j) {
    return scene.area(j) / asked.reflectivity[j].largest.to_double();
  };
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Approximation& there = b[4 + 4 * i + asked.panels[j].piece];
      const Approximation& back = b[4 + 4 * j + asked.panels[i].piece];
      EXPECT_NEAR(weight(j) * there.value, weight(i) * back.value,
                  weight(j) * there.radius + weight(i) * back.radius);
    }
    // The first emission is that of the first face.
    EXPECT_NEAR(b[asked.panels[j].piece].value, b[4 + asked.panels[j].piece].value,
                b[asked.panels[j].piece].radius + b[4 + asked.panels[j].piece].radius);
  }
}

TEST(GoalEnclosure, IsTheEmissionWhereNothingReflects) {
  PolyhedronProblem dark = problem("cube", 0, 0);
  dark.emission[2] = constant_polynomial(Rational(5));
  const GoalEnclosure found = enclose_means(dark, 1e-6);
  for (std::size_t k = 0; k < found.numbers.size(); ++k) expect_contains(found.numbers[k], k == 2 ? 5 : 0);
  EXPECT_LE(found.width, 1e-6);
}

TEST(GoalEnclosure, KeepsTheBalanceOfEnergy) {
  // Int T u = Int u, since T 1 = 1 and T is symmetric; T u = (u - E)/rho: Int (1/rho - 1) u = Int E/rho.
  for (const std::string name : {"cube", "tetrahedron"}) {
    const PolyhedronProblem asked = lit(name);
    const SectorScene scene(asked.panels);
    const GoalEnclosure found = enclose_means(asked, 5e-1);
    double left = 0;
    double radius = 0;
    double right = 0;
    for (std::size_t j = 0; j < asked.panels.size(); ++j) {
      const Approximation& mean = found.numbers[asked.panels[j].piece];
      const double rho = asked.reflectivity[j].largest.to_double();
      const double weight = (1 / rho - 1) * scene.area(j);
      left += weight * mean.value;
      radius += weight * mean.radius;
      right += asked.emission[j](0, 0).to_double() / rho * scene.area(j);
    }
    EXPECT_NEAR(left, right, radius) << name;
    EXPECT_LE(found.width, 5e-1);
  }
}

TEST(GoalEnclosure, OfCoarseMeshesContainThoseOfFineOnes) {
  std::mutex mutex;
  std::vector<EnclosureProgress> told;
  const GoalEnclosure coarse =
      enclose_means(lit("tetrahedron"), 5e-1, {.progress = [&](const EnclosureProgress& now) {
                      const std::scoped_lock lock(mutex);
                      told.push_back(now);
                    }});
  // It is told that a mesh is begun, how many of its cells are done, and how wide the enclosure is then.
  ASSERT_GT(told.size(), 10U);
  EXPECT_FALSE(told.front().finished);
  EXPECT_EQ(told.front().cells, 0U);
  EXPECT_TRUE(told.back().finished);
  EXPECT_EQ(told.back().width, coarse.width);
  std::size_t most = 0;
  for (const EnclosureProgress& now : told) {
    EXPECT_LE(now.cells_done, now.cells);
    most = std::max(most, now.cells_done);
  }
  EXPECT_GT(most, told[told.size() - 2].cells * 9 / 10);
  const GoalEnclosure fine = enclose_means(lit("tetrahedron"), 3e-2);
  EXPECT_LT(fine.width, 0.1 * coarse.width);
  for (std::size_t k = 0; k < fine.numbers.size(); ++k)
    EXPECT_LE(std::abs(coarse.numbers[k].value - fine.numbers[k].value),
              coarse.numbers[k].radius + fine.numbers[k].radius);
}

TEST(GoalEnclosure, GoesOnFromWhatIsKept) {
  const PolyhedronProblem asked = lit("tetrahedron");
  const GoalEnclosure by_itself = enclose_means(asked, 4e-1, {}, true);
  const auto expect_same = [&](const GoalEnclosure& found) {
    ASSERT_EQ(found.numbers.size(), by_itself.numbers.size());
    for (std::size_t k = 0; k < found.numbers.size(); ++k) {
      EXPECT_EQ(found.numbers[k].value, by_itself.numbers[k].value);
      EXPECT_EQ(found.numbers[k].radius, by_itself.numbers[k].radius);
    }
    EXPECT_EQ(found.last.samples, by_itself.last.samples);
    for (std::size_t e = 0; e < found.proof->residuals.size(); ++e)
      EXPECT_EQ(found.proof->residuals[e].norms, by_itself.proof->residuals[e].norms);
  };
  test::Memory memory;
  expect_same(enclose_means(asked, 4e-1, {.kept = &memory}, true));
  ASSERT_GT(memory.numbers.size(), 3U);
  EXPECT_EQ(memory.found, 0);
  // Begun again where about half of the parts had been done.
  test::Memory half(memory.half());
  const auto done = static_cast<int>(half.numbers.size());
  expect_same(enclose_means(asked, 4e-1, {.kept = &half}, true));
  EXPECT_EQ(half.found, done);
  EXPECT_EQ(half.numbers, memory.numbers);
}

TEST(GoalEnclosure, CountsTheProductOfBothNormsOverTheGap) {
  // rho is 7/10 at most.
  const GoalEnclosure found = enclose_means(lit("tetrahedron"), 30, {}, true);
  const GoalProof& proof = *found.proof;
  ASSERT_EQ(proof.norms.size(), 1 + proof.radii.size());
  for (std::size_t k = 0; k < proof.radii.size(); ++k) {
    const double of_norms = proof.norms[0] * proof.norms[1 + k] / 0.3;
    EXPECT_GE(proof.radii[k], of_norms * (1 - 1e-12)) << k;
    EXPECT_LE(proof.radii[k], 2.5 * of_norms) << k;
  }
}

TEST(GoalEnclosure, CountsWhatPolynomialsLeaveOfAKernel) {
  // Little is reflected: what polynomials leave of the kernel is of the size rho^(1/2), the residual of
  // its dual of rho^(3/2).
  PolyhedronProblem asked = problem("tetrahedron", Rational(1, 1000), 0);
  asked.emission[0] = constant_polynomial(Rational(1));
  const GoalEnclosure found = enclose_values(asked, {points_on(asked).back()}, 3e-5, {}, true);
  const GoalProof& proof = *found.proof;
  const double of_norms = proof.norms[0] * proof.norms[1] / 0.999;
  EXPECT_GE(proof.radii[0], of_norms * (1 - 1e-12));
  EXPECT_LE(proof.radii[0], 2 * of_norms);
}

TEST(GoalEnclosure, CountsTheRoundingOfAPointsEmission) {
  PolyhedronProblem dark = problem("tetrahedron", 0, 0);
  dark.emission[1] = constant_polynomial(Rational(1, 3));
  const Approximation found = enclose_values(dark, {{1, dark.panels[1].centre}}, 1).numbers[0];
  const Rational off = abs(Rational(1, 3) - Rational::exactly(found.value));
  EXPECT_LE(off, Rational::exactly(found.radius));
  EXPECT_LE(found.radius, 1e-15);
}

TEST(GoalEnclosure, HasPolynomialEmissions) {
  // u is linear in E.
  const auto with = [](const Rational& a, const Rational& b, int power) {
    PolyhedronProblem out = problem("tetrahedron", Rational(2, 5), 0);
    PlanePolynomial<Rational> f(2);
    f(0, 0) = a;
    f(power, 0) = b;
    out.emission[1] = f;
    return out;
  };
  // The sum in a search of its own.
  PolyhedronProblem apart = with(1, 0, 1);
  apart.further_emissions = {with(0, 1, 2).emission};
  const GoalEnclosure parts = enclose_means(apart, 6e-1);
  const GoalEnclosure both = enclose_means(with(3, -2, 2), 6e-1);
  ASSERT_EQ(parts.numbers.size(), 8U);
  for (std::size_t k = 0; k < both.numbers.size(); ++k)
    EXPECT_NEAR(both.numbers[k].value, 3 * parts.numbers[k].value - 2 * parts.numbers[4 + k].value,
                both.numbers[k].radius + 3 * parts.numbers[k].radius + 2 * parts.numbers[4 + k].radius);
}

TEST(GoalEnclosure, IsThatOfAPolynomialEmissionWhereNothingReflects) {
  PolyhedronProblem dark = problem("cube", 0, 0);
  const Panel& panel = dark.panels[3];
  dark.emission[3] = PlanePolynomial<Rational>(1);
  dark.emission[3](1, 0) = 4;
  const GoalEnclosure found = enclose_values(dark, {{3, panel.centre}}, 1e-6);
  // The mean of a linear function is its value at the centre.
  const double at_centre = 4 * plane_coordinates(panel, panel.centre).s.to_double();
  expect_contains(found.numbers[0], at_centre);
  // In the plane of a square t runs along the second side: the mean of 3 t^2 is 1.
  dark.emission[4] = PlanePolynomial<Rational>(2);
  dark.emission[4](0, 2) = 3;
  const GoalEnclosure means = enclose_means(dark, 1e-6);
  for (std::size_t k = 0; k < 6; ++k) expect_contains(means.numbers[k], k == 3 ? at_centre : k == 4 ? 1 : 0);
}

TEST(GoalEnclosure, OfAnyWidthContainsTheSolution) {
  // Widths at which products of bounds leave double's range say little, and nothing false.
  const PolyhedronProblem furnace = problem("tetrahedron", Rational(1, 2), Rational(1, 2));
  for (const double wanted : {1e60, 1e300})
    for (const Approximation& mean : enclose_means(furnace, wanted).numbers) expect_contains(mean, 1);
}

std::vector<std::unique_ptr<Goals>> goals_of(std::unique_ptr<Goals> a, std::unique_ptr<Goals> b) {
  std::vector<std::unique_ptr<Goals>> out;
  out.push_back(std::move(a));
  out.push_back(std::move(b));
  return out;
}

TEST(Goals, AreCorrectedByTheirDualsFromAnyTrialFunction) {
  // A furnace, u = 1, and q_0 = 0: what is reflected is left to Int w_k t_0.
  for (const int of_rho : {0, 2}) {
    const PolyhedronProblem furnace = of_rho == 0 ? problem("tetrahedron", Rational(1, 2), Rational(1, 2))
                                                  : furnace_of_polynomials("tetrahedron", of_rho);
    const SectorScene scene(furnace.panels);
    const Reflectivity reflectivity(furnace.reflectivity);
    const Vector<Rational> centre = scene.panels()[1].centre;
    const ParameterPoint<Rational> at = plane_coordinates(scene.panels()[1], centre);
    const double rho = furnace.reflectivity[1].polynomial.value(at.s, at.t).to_double();
    const std::vector<ValueGoal> points{
        {.point = {1, centre}, .emissions = {Approximation::proved(1 - rho, 1e-16)}, .reflectivity = rho}};
    constexpr int degree = 5;
    const auto both = goals_of(point_values(scene, reflectivity, points), piece_means(scene, reflectivity));
    for (const std::unique_ptr<Goals>& goals : both) {
      const std::vector<SectorElement> elements = goals->refined(graded_elements(scene, 2), degree, 3e-3);
      SectorFunctions given =
          emission_functions(furnace, scene, elements, 1 + goals->count(), degree + of_rho, 0);
      const DualErrors duals = goals->put_duals(elements, given);
      SectorFunctions q = trial_functions(scene, elements, reflectivity, given, 1e-4);
      for (std::size_t e = 0; e < elements.size(); ++e)
        for (double& c : q.of(e, 0)) c = 0;
      const Trial trial(scene, reflectivity, elements, given, std::move(q), duals.rounding);
      const CellDemand demand{.interpolation = 3e-3, .quadrature = 3e-5};
      const ResidualSums sums = residual_sums(trial, observer_cells(trial, demand), demand);
      const std::vector<Approximation> of_density = goals->of_density(trial, 1e-9);
      for (std::size_t k = 0; k < goals->count(); ++k) {
        const Approximation rest =
            Approximation::proved(0, sums.norms[0] * (sums.norms[1 + k] + duals.left[k]) / 0.5);
        const Approximation number = goals->number(k, of_density[k] + sums.products[1 + k] + rest);
        expect_contains(number, 1);
        // Far nearer than the norms promise.
        EXPECT_NEAR(number.value, 1, 2e-3);
      }
    }
  }
}

TEST(PieceMeans, HaveTheReflectivityForTheirDuals) {
  // rho on the piece's panels, 0 on others: as functions of the planes.
  const PolyhedronProblem furnace = furnace_of_polynomials("cube", 3);
  const SectorScene scene(furnace.panels);
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  const std::unique_ptr<Goals> goals = piece_means(scene, Reflectivity(furnace.reflectivity));
  SectorFunctions given(elements.size(), 1 + goals->count(), 5);
  goals->put_duals(elements, given);
  for (std::size_t k = 0; k < goals->count(); ++k) {
    std::vector<PlanePolynomial<Rational>> own;
    for (std::size_t j = 0; j < furnace.panels.size(); ++j)
      own.push_back(furnace.panels[j].piece == k ? furnace.reflectivity[j].polynomial
                                                 : constant_polynomial(Rational(0)));
    const SectorFunctions expected = plane_functions(own, scene, elements, 1, 5, 0);
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(given.of(e, 1 + k)[i], expected.of(e, 0)[i]) << k << " " << e;
  }
}

/// Twice the area of each piece.
std::vector<Ball> doubled_areas(const std::vector<Panel>& panels, std::size_t pieces) {
  std::vector<Ball> out(pieces, Ball(0));
  for (const Panel& panel : panels)
    for (std::size_t i = 0; i < panel.corners.size(); ++i) {
      const Vector<Rational> n = cross(panel.corners[(i + 1) % panel.corners.size()] - panel.corners[i],
                                       panel.centre - panel.corners[i]);
      out[panel.piece] += sqrt(Ball(dot(n, n)));
    }
  return out;
}

/// J_k(w) by exact sums, for jacobians that are.
Rational exact_functional(const Trial& trial, std::size_t piece) {
  const auto powers = static_cast<std::size_t>(trial.w.degree() + 1);
  Rational sum;
  for (std::size_t e = 0; e < trial.elements.size(); ++e) {
    if (trial.scene.panels()[trial.sector(e).panel].piece != piece) continue;
    const auto [s0, s1, t0, t1] = trial.elements[e].box;
    const Rational t_length = Rational::exactly(t1) - Rational::exactly(t0);
    const Rational mean = 1 - (Rational::exactly(t0) + Rational::exactly(t1)) / 2;
    const std::span<const double> c = trial.w.of(e, 0);
    const Rational value =
        Rational::exactly(c[0]) * mean - (powers > 1 ? Rational::exactly(c[1]) * t_length / 6 : Rational(0));
    sum += Rational::exactly(trial.sector(e).jacobian) * (Rational::exactly(s1) - Rational::exactly(s0)) *
           t_length * value;
  }
  return sum;
}

TEST(PieceMeans, CountTheRoundingsOfTheirSums) {
  // Over the first element of each piece w has the integral 1, a little more, and over every other one so
  // small a one that it is lost beside that: more than w and each term are rounded by.
  const SectorScene scene(panels_of("cube"));
  const std::vector<double> black(scene.panels().size(), 0.0);
  const std::vector<SectorElement> elements = graded_elements(scene, 7);
  const std::unique_ptr<Goals> goals = piece_means(scene, black);
  constexpr double unit = unit_roundoff<double>();
  SectorFunctions staircase(elements.size(), 1, 0);
  std::vector<int> others(goals->count(), -1);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Sector& sector = scene.sectors()[elements[e].sector];
    int& before = others[scene.panels()[sector.panel].piece];
    staircase.of(e, 0)[0] =
        (before < 0 ? 1 + 0x1p-45 : 0.99 * unit) / (sector.jacobian * elements[e].box.weight());
    ++before;
  }
  const Trial trial(scene, black, elements, staircase, SectorFunctions(elements.size(), 1, 0));
  const std::vector<Approximation> found = goals->of_density(trial, 1e-9);
  const std::vector<Ball> areas = doubled_areas(scene.panels(), goals->count());
  for (std::size_t k = 0; k < goals->count(); ++k) {
    const Rational off = abs(exact_functional(trial, k) - Rational::exactly(found[k].value));
    EXPECT_LE(off, Rational::exactly(found[k].radius));
    EXPECT_GE(off, Rational::exactly(0.98 * others[k] * unit));
    EXPECT_GE(0.98 * others[k] * unit, 16 * unit + 0.5 * trial.rounding * areas[k].to_double());
  }
}

TEST(PieceMeans, AreThoseOfFunctionsThatVary) {
  const SectorScene scene(panels_of("cube"));
  const std::vector<double> black(scene.panels().size(), 0.0);
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  const std::unique_ptr<Goals> goals = piece_means(scene, black);
  Draw draw(53);
  const Trial trial(scene, black, elements, test::drawn_functions(elements.size(), 1, 2, draw),
                    SectorFunctions(elements.size(), 1, 2));
  const std::vector<Approximation> found = goals->of_density(trial, 1e-9);
  for (std::size_t k = 0; k < goals->count(); ++k) {
    EXPECT_LE(abs(exact_functional(trial, k) - Rational::exactly(found[k].value)),
              Rational::exactly(found[k].radius));
    EXPECT_LE(found[k].radius, 1e-12);
  }
}

TEST(PieceMeans, CountWhatFunctionsAreOffBy) {
  const SectorScene scene(panels_of("cube"));
  const std::vector<double> black(scene.panels().size(), 0.0);
  const std::vector<SectorElement> elements = graded_elements(scene, 1);
  SectorFunctions one(elements.size(), 1, 0);
  for (std::size_t e = 0; e < elements.size(); ++e) one.of(e, 0)[0] = 1;
  const Trial trial(scene, black, elements, one, SectorFunctions(elements.size(), 1, 0), 0.25);
  const std::unique_ptr<Goals> goals = piece_means(scene, black);
  const std::vector<Ball> areas = doubled_areas(scene.panels(), goals->count());
  for (std::size_t k = 0; k < goals->count(); ++k) {
    const double area = 0.5 * areas[k].to_double();
    const Approximation functional = goals->of_density(trial, 1e-9)[k];
    EXPECT_GE(functional.radius, 0.25 * area);
    EXPECT_LE(functional.radius, 0.25 * area * (1 + 1e-9));
  }
}

/// The panels, so many times as large.
std::vector<Panel> scaled(std::vector<Panel> panels, const Rational& by) {
  for (Panel& panel : panels) {
    for (Vector<Rational>& corner : panel.corners) corner = by * corner;
    panel.centre = by * panel.centre;
  }
  return panels;
}

TEST(PieceMeans, AreIntegralsOverAreas) {
  // All that an integral may be, over the exact area.
  int rounded = 0;
  for (const std::string name : {"cube", "tetrahedron"})
    for (const Rational& size : {Rational(7), Rational(1, 3), Rational(1, 1000)}) {
      const SectorScene scene(scaled(panels_of(name), size));
      const std::unique_ptr<Goals> goals =
          piece_means(scene, std::vector<double>(scene.panels().size(), 0.5));
      const std::vector<Ball> areas = doubled_areas(scene.panels(), goals->count());
      for (std::size_t k = 0; k < goals->count(); ++k)
        for (const double radius : {0.0, 1e-12, 0.125}) {
          const Approximation mean = goals->number(k, Approximation::proved(1, radius));
          EXPECT_TRUE(mean.guaranteed);
          for (const int end : {-1, 1}) {
            const Ball exact = Ball(2) * (Ball(1) + Ball(end) * Ball(radius)) / areas[k];
            const double off = abs(exact - Ball(mean.value)).upper_double();
            EXPECT_LE(off, mean.radius);
            EXPECT_LE(mean.radius, off * (1 + 1e-9) + 1e-13 * mean.value);
            rounded += radius == 0 && off > 0 ? 1 : 0;
          }
        }
    }
  EXPECT_GT(rounded, 0);
}

TEST(PointValues, EndCuttingAtAnEdge) {
  // A point nearer to an edge than roundings of points are: no element is small enough for its kernel.
  const SectorScene scene(panels_of("cube"));
  const std::vector<double> reflectivity(6, 0.5);
  const Panel& panel = scene.panels()[0];
  const Vector<Rational> middle = Rational(1, 2) * (panel.corners[0] + panel.corners[1]);
  const Rational hair = Rational(1) / power(Rational(10), 16);
  const std::vector<ValueGoal> points{{.point = {0, middle + hair * (panel.centre - middle)},
                                       .emissions = {Approximation::exact(1)},
                                       .reflectivity = 0.5}};
  const std::unique_ptr<Goals> goals = point_values(scene, reflectivity, points);
  const std::vector<SectorElement> elements = goals->refined(graded_elements(scene, 2), 5, 1e-2);
  EXPECT_LT(elements.size(), 30000U);
  SectorFunctions emissions(elements.size(), 2, 5);
  EXPECT_FALSE(std::isfinite(goals->put_duals(elements, emissions).left[0]));
}

TEST(PointValues, OfADensityAreWhatIsSeenOfALampPastAnEdge) {
  // From (6/5, 1/2) the edge at (1, 1) leaves x <= 3/5 of the wall y = 2 in sight, all of whose light comes
  // straight: of what is h away and as high, in a plane across its own, a strip of the width w from the foot
  // sends (atan(w/h) - h/r atan(w/r))/(2 pi), r^2 = h^2 + 1.
  const Rational half(1, 2);
  std::vector<Rational> emission(8, 0);
  emission[5] = 1;
  const PolyhedronProblem lamp =
      test::occluded_problem(test::l_room(), std::vector<Rational>(8, half), emission);
  const SectorScene scene(lamp.panels, lamp.blockers);
  const std::vector<double> reflectivity(scene.panels().size(), 0.5);
  const Vector<Rational> at{Rational(6, 5), half, 0};
  const std::unique_ptr<Goals> goals = point_values(
      scene, reflectivity,
      {{.point = point_on(lamp, at), .emissions = {Approximation::exact(0)}, .reflectivity = 0.5}});
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  const SectorFunctions given = emission_functions(lamp, scene, elements, 2, 1, 0);
  const Trial trial(scene, reflectivity, elements, given, SectorFunctions(elements.size(), 2, 1));
  const auto sent_by = [](double width) {
    const double h = 1.5;
    const double r = std::sqrt(h * h + 1);
    return (std::atan(width / h) - h / r * std::atan(width / r)) / (2 * std::numbers::pi);
  };
  for (const double allowed : {1e-2, 1e-4, 1e-6}) {
    const Approximation functional = goals->of_density(trial, allowed)[0];
    EXPECT_LE(functional.radius, allowed * 1.01);
    const Approximation number = goals->number(0, functional);
    EXPECT_TRUE(number.guaranteed);
    EXPECT_LE(std::abs(number.value - 0.5 * (sent_by(1.2) - sent_by(0.6))), number.radius);
  }
}

/// Whether a straight way leaves the L-shaped room, through the quarter x > 1, y > 1.
bool is_hidden_in_l_room(const Vector<double>& p, const Vector<double>& q) {
  double from = 0;
  double to = 1;
  for (const auto& [a, b] : {std::array{p.x, q.x}, {p.y, q.y}}) {
    if (a <= 1 && b <= 1) return false;
    const double at = (1 - a) / (b - a);
    if (a <= 1) from = std::max(from, at);
    if (b <= 1) to = std::min(to, at);
  }
  return from < to;
}

TEST(PointValues, LeaveHalfOfAKernelWhereItIsSeenInPart) {
  const SectorScene scene(test::cut(test::l_room()), test::l_room());
  const std::vector<double> reflectivity(scene.panels().size(), 0.25);
  const Vector<Rational> at{Rational(6, 5), Rational(1, 2), 0};
  const std::size_t panel = panel_about(scene.panels(), at);
  const std::unique_ptr<Goals> goals =
      point_values(scene, reflectivity,
                   {{.point = {panel, at}, .emissions = {Approximation::exact(0)}, .reflectivity = 0.25}});
  constexpr int degree = 5;
  const std::vector<SectorElement> elements = goals->refined(graded_elements(scene, 2), degree, 0.03);
  SectorFunctions emissions(elements.size(), 2, degree);
  const DualErrors duals = goals->put_duals(elements, emissions);
  EXPECT_LE(duals.left[0], 0.06);
  const Vector<double> from = scene.place(at);
  const Vector<double>& up = scene.normal(panel);
  double closest = 0;
  int seen_in_part = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Sector& sector = scene.sectors()[elements[e].sector];
    const SectorBox& box = elements[e].box;
    constexpr int steps = 24;
    double squares = 0;
    int hidden = 0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const double x = (2 * i + 1.0) / steps - 1;
        const double y = (2 * j + 1.0) / steps - 1;
        const double t = box.middle_t() + 0.5 * (box.t1 - box.t0) * y;
        const Vector<double> q = sector.point(box.middle_s() + 0.5 * (box.s1 - box.s0) * x, t);
        const Vector<double> way = q - from;
        const double cosines =
            std::max(0.0, dot(up, way)) * std::max(0.0, -dot(scene.normal(sector.panel), way));
        const bool is_hidden = is_hidden_in_l_room(from + scene.origin(), q + scene.origin());
        hidden += static_cast<int>(is_hidden);
        const double kernel =
            is_hidden ? 0
                      : std::ldexp(cosines / (dot(way, way) * dot(way, way)), -goals->exponent(0)) /
                            std::numbers::pi;
        double h = 0;
        LocalValues(elements[e], *duals.polynomials, e).at(box, x, y, {&h, 1});
        squares += 0.25 * (kernel - h) * (kernel - h) * sector.jacobian * (1 - t) * (box.s1 - box.s0) *
                   (box.t1 - box.t0) / (steps * steps);
      }
    const double left = duals.left_on_elements[e];
    EXPECT_LE(std::sqrt(squares), left * 1.01 + 1e-12) << "element " << e;
    if (hidden == 0 || hidden == steps * steps) continue;
    ++seen_in_part;
    closest = std::max(closest, std::sqrt(squares) / left);
  }
  EXPECT_GT(seen_in_part, 10);
  EXPECT_GT(closest, 0.65);
}

TEST(EmissionFunctions, AreThePolynomialOnEveryElement) {
  // The emission at points of elements by plane_coordinates, against its coefficients there.
  Draw draw(3);
  for (const std::string name : {"cube", "tetrahedron", "box"}) {
    PolyhedronProblem asked = problem(name, 0, 0);
    for (PlanePolynomial<Rational>& f : asked.emission) {
      f = PlanePolynomial<Rational>(3);
      for (int i = 0; i <= 3; ++i)
        for (int j = 0; i + j <= 3; ++j) f(i, j) = Rational(static_cast<long>(draw.below(19)) - 9, 7);
    }
    const SectorScene scene(asked.panels);
    const std::vector<SectorElement> elements = graded_elements(scene, 2);
    const SectorFunctions f = emission_functions(asked, scene, elements, 2, 4, -1);
    for (std::size_t e = 0; e < elements.size(); e += 5) {
      const SectorBox& box = elements[e].box;
      const std::size_t panel = scene.sectors()[elements[e].sector].panel;
      const std::size_t corner = elements[e].sector - scene.first_sector(panel);
      const std::vector<Vector<Rational>>& corners = asked.panels[panel].corners;
      const double x = 2 * draw() - 1;
      const double y = 2 * draw() - 1;
      const Rational s = Rational::exactly(box.middle_s() + 0.5 * (box.s1 - box.s0) * x);
      const Rational t = Rational::exactly(box.middle_t() + 0.5 * (box.t1 - box.t0) * y);
      const Vector<Rational> base =
          (Rational(1) - s) * corners[corner] + s * corners[(corner + 1) % corners.size()];
      const Vector<Rational> point = (Rational(1) - t) * base + t * asked.panels[panel].centre;
      const ParameterPoint<Rational> at = plane_coordinates(asked.panels[panel], point);
      std::array<double, 5> p_x{};
      std::array<double, 5> p_y{};
      legendre_values<double>(x, p_x);
      legendre_values<double>(y, p_y);
      double value = 0;
      for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = 0; j < 5; ++j) value += f.of(e, 0)[i * 5 + j] * p_x[i] * p_y[j];
      EXPECT_NEAR(value, 2 * asked.emission[panel].value(at.s, at.t).to_double(), 1e-11) << name << " " << e;
      EXPECT_EQ(f.of(e, 1)[0], 0);
    }
  }
}

TEST(PanelAbout, IsAPartOfAFaceButNotOfItsEdges) {
  const std::vector<Panel> parts = test::cut(test::l_room());
  // In a part, on the line between two, and on no edge; on edges, in a corner, at the corner that looks
  // inwards, beside the room and off its planes.
  const Rational half(1, 2);
  for (const Vector<Rational>& p :
       {Vector<Rational>{half, half, 0}, {1, half, 0}, {half, 1, 1}, {0, 1, half}}) {
    const std::size_t k = panel_about(parts, p);
    ASSERT_LT(k, parts.size());
    EXPECT_EQ(dot(parts[k].normal, p - parts[k].corners[0]).sign(), 0);
  }
  for (const Vector<Rational>& p : {Vector<Rational>{half, 0, 0},
                                    {0, 0, 0},
                                    {1, 1, 0},
                                    {1, 0, 0},
                                    {1, 1, half},
                                    {Rational(3, 2), 1, 0},
                                    {Rational(3, 2), Rational(3, 2), 0},
                                    {half, half, half}})
    EXPECT_EQ(panel_about(parts, p), parts.size());
  // Four triangles about a point, and three of them.
  const Vector<Rational> middle{0, 0, 0};
  std::vector<Panel> star;
  const std::array<Vector<Rational>, 4> ends{Vector<Rational>{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (std::size_t i = 0; i < 4; ++i)
    star.push_back(test::panel_with(0, {middle, ends[i], ends[(i + 1) % 4]}));
  EXPECT_EQ(panel_about(star, middle), 0U);
  // A corner of another plane touches them there, or stands inside one of them.
  for (const Vector<Rational>& at : {middle, Vector<Rational>{Rational(1, 4), Rational(1, 4), 0}}) {
    std::vector<Panel> touched = star;
    touched.push_back(
        test::panel_with(0, {at, at + Vector<Rational>{1, 0, 1}, at + Vector<Rational>{0, 1, 1}}));
    EXPECT_LT(panel_about(star, at), star.size());
    EXPECT_EQ(panel_about(touched, at), touched.size());
  }
  EXPECT_EQ(panel_about({star[0], star[1], star[2]}, middle), 3U);
  star[3].piece = 1;
  EXPECT_EQ(panel_about(star, middle), 4U);
}

TEST(PanelInside, DecidesExactly) {
  const std::vector<Panel> panels = panels_of("cube");
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const Panel& panel = panels[k];
    EXPECT_EQ(panel_inside(panels, panel.centre), k);
    // On an edge, at a corner, and a hair off the plane.
    EXPECT_EQ(panel_inside(panels, Rational(1, 2) * (panel.corners[0] + panel.corners[1])), panels.size());
    EXPECT_EQ(panel_inside(panels, panel.corners[2]), panels.size());
    const Rational hair = Rational(1) / power(Rational(10), 40);
    EXPECT_EQ(panel_inside(panels, panel.centre + hair * panel.normal), panels.size());
  }
}

}  // namespace
}  // namespace radcert
