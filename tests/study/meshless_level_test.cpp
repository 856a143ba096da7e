// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "radcert/core/parallel.h"
#include "radcert/meshless/light_solution.h"
#include "radcert/study/study.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::everywhere;
using testing::fault_of;
using ::testing::HasSubstr;
using testing::no_route;
using testing::sample_problem;
using testing::with_emission;

constexpr std::uint64_t plenty = std::uint64_t{1} << 32U;

/// Int G u of the unit sphere, G = 1/4: a constant for a u whose mean is known.
OperatorRoute sphere_route(double mean) {
  return [mean](const Surface&, const SurfaceFunction&) {
    return [mean](const SurfacePoint<double>&) { return Approximation{std::numbers::pi * mean, 1e-15}; };
  };
}

Problem meshless(const Meshless& basis, const std::string& surface = "sphere") {
  Problem problem = sample_problem(surface);
  problem.method = basis;
  return problem;
}

Meshless with_sites(MeshlessFamily family, SiteLevels sites) {
  Meshless basis = basis_of(family);
  basis.sites = sites;
  return basis;
}

Meshless own(const std::string& mother, std::optional<Rational> support) {
  Meshless basis;
  basis.basis = {.mother = expression_mother(parse_expression(mother, ExpressionVariables::radius).value(),
                                             std::move(support)),
                 .normalise = Normalisation::partition_of_unity};
  basis.sites = PoissonDiskLevels{.separation = Rational(1, 2)};
  return basis;
}

TEST(MeshlessLevel, IsTheClosedFormOfEqualLightsInASphere) {
  // Lights of weight 4 pi/n on the unit sphere send (rho/n) u_j to every site but their own:
  // u_i (1 + rho/n) = E_i + rho S/n, S = sum u_j = sum E_i / (1 + rho/n - rho).
  Meshless basis = with_sites(MeshlessFamily::shepard, UniformLevels{.count = 60, .seed = 3});
  basis.weights = WeightRule::mean_density;
  for (const char* solver : {"auto", "direct", "neumann"}) {
    Problem problem = with_emission(meshless(basis), "2 + z");
    problem.solver.name = solver;
    const LevelOutcome outcome = solve_level(problem, 0, no_route);
    ASSERT_EQ(outcome.nodes.size(), 60U);
    const double rho = 0.5;
    const double share = rho / 60;
    double emitted = 0;
    for (const NodeValue& node : outcome.nodes) emitted += 2 + node.point.z;
    const double sum = emitted / (1 + share - rho);
    for (const NodeValue& node : outcome.nodes) {
      EXPECT_DOUBLE_EQ(node.emission, 2 + node.point.z);
      EXPECT_NEAR(node.u_n.value, (2 + node.point.z + share * sum) / (1 + share), 3e-7);  // the area
    }
    EXPECT_FALSE(outcome.result.node_error);
    EXPECT_EQ(outcome.result.iteration.has_value(), std::string(solver) == "neumann");
  }
}

TEST(MeshlessLevel, AgreesWithTheTransferMatrixOfAScene) {
  // The same R by LightTransfer, with the same demand of the weights.
  for (const CoefficientRule coefficients : {CoefficientRule::as_values, CoefficientRule::interpolated}) {
    Meshless basis =
        with_sites(MeshlessFamily::lehtinen, PoissonDiskLevels{.separation = Rational(2, 5), .seed = 5});
    // With ten neighbours the interpolation amplifies what point lights leave, and the iteration diverges.
    basis.basis.radius.neighbour = 3;
    basis.coefficients = coefficients;
    basis.weights = WeightRule::neighbours;
    const Problem problem = with_emission(meshless(basis), "exp(x)");
    const LevelOutcome outcome = solve_level(problem, 1, no_route);
    const LightScene scene = LightScene::make(surface_of(problem), {0.5}).value();
    const LightTransfer transfer =
        LightTransfer::make(scene, {.meshless = {.basis = basis.basis,
                                                 .sites = PoissonDiskSites{.separation = 0.2, .seed = 5}},
                                    .weights = basis.weights,
                                    .coefficients = coefficients})
            .value();
    const LightSolution solution =
        transfer
            .solve(SurfaceEmission{[](const LitPoint& p) { return std::exp(p.site.point.x); }}, std::nullopt)
            .value();
    ASSERT_EQ(outcome.nodes.size(), transfer.basis().size());
    for (const NodeValue& node : outcome.nodes)
      EXPECT_NEAR(node.u_n.value, transfer.basis().at({node.point, node.normal}, solution.total).value(),
                  1e-10);
  }
}

TEST(MeshlessLevel, TakesTheReflectivityOfEachSite) {
  // With rho = 0 on one half nothing comes back there.
  Meshless basis = with_sites(MeshlessFamily::shepard, UniformLevels{.count = 80});
  Problem problem = with_emission(meshless(basis), "1");
  problem.reflectivity = everywhere("max(0, z)/2");
  const LevelOutcome outcome = solve_level(problem, 0, no_route);
  for (const NodeValue& node : outcome.nodes) {
    EXPECT_EQ(node.u_n.value > 1, node.point.z > 0);
    EXPECT_GE(node.u_n.value, 1);
  }
}

TEST(MeshlessLevel, FindsTheManufacturedSolutionAndHalvesItsSpacing) {
  for (const MeshlessFamily family : {MeshlessFamily::shepard, MeshlessFamily::lehtinen}) {
    Problem problem = meshless(with_sites(family, PoissonDiskLevels{.separation = Rational(1, 2)}));
    problem.solution = everywhere("1 + z/2");
    std::vector<LevelResult> levels;
    for (const int level : {0, 1, 2}) levels.push_back(solve_level(problem, level, sphere_route(1)).result);
    for (const LevelResult& level : levels) {
      EXPECT_DOUBLE_EQ(level.mesh_size, std::ldexp(0.5, -level.level));
      EXPECT_FALSE(level.discretisation_error);
      EXPECT_GE(level.uniform_error->value, level.node_error->value / 4);
      EXPECT_EQ(level.elements, level.unknowns);
      EXPECT_NEAR(level.piece_means.front().second.value, 1, 0.1);
      EXPECT_TRUE(level.norm_K.guaranteed);
    }
    // Maximal sets of the density 0.7/separation^2, by area.
    EXPECT_NEAR(static_cast<double>(levels[2].unknowns) / static_cast<double>(levels[1].unknowns), 4, 0.5);
    EXPECT_LT(levels[2].uniform_error->value, 0.7 * levels[0].uniform_error->value) << name(family);
    EXPECT_LT(levels[2].node_error->radius, 0.1 * levels[2].node_error->value);
    // Direct sites are not in E: u - Ku of u = 1 + z/2 is 1/2 + z/2.
    const LevelOutcome outcome = solve_level(problem, 0, sphere_route(1));
    for (const NodeValue& node : outcome.nodes) EXPECT_NEAR(node.emission, 0.5 + node.point.z / 2, 1e-14);
  }
}

TEST(MeshlessLevel, HasTheSolutionAtTheSitesWhereTheInterpolationIsSolved) {
  // u = 1 is in the span of a partition of unity: what is left at the sites is what point lights leave.
  Meshless basis = with_sites(MeshlessFamily::lehtinen, PoissonDiskLevels{.separation = Rational(1, 3)});
  basis.basis.radius.neighbour = 3;
  basis.coefficients = CoefficientRule::interpolated;
  const LevelResult result = solve_level(meshless(basis), 0, sphere_route(1)).result;
  EXPECT_LT(result.node_error->value, 0.02);
}

TEST(MeshlessLevel, CountsWhatIllConditionedInterpolationLeaves) {
  // With rho = 0 the interpolant of u is u at the sites: what is seen there is rounding alone, of smooth
  // elements of which dozens overlap.
  Meshless basis = own("exp(-r^2/2)", std::nullopt);
  basis.basis.normalise = Normalisation::none;
  basis.basis.distance = SiteDistance::euclidean;
  basis.basis.radius.neighbour = 60;
  basis.coefficients = CoefficientRule::interpolated;
  basis.weights = WeightRule::mean_density;
  basis.sites = PoissonDiskLevels{.separation = Rational(1, 3)};
  for (const char* solver : {"direct", "neumann"}) {
    Problem problem = meshless(basis);
    problem.reflectivity = everywhere("0");
    problem.solution = everywhere("exp(x)");
    problem.solver.name = solver;
    const OperatorRoute nothing = [](const Surface&, const SurfaceFunction&) {
      return [](const SurfacePoint<double>&) { return Approximation{0, 0}; };
    };
    const Approximation error = *solve_level(problem, 0, nothing).result.node_error;
    EXPECT_GT(error.value, 1e-12) << solver;
    EXPECT_LE(error.value, error.radius) << solver;
    EXPECT_LT(error.radius, 1e-3) << solver;
  }
}

TEST(MeshlessLevel, IsTheSameForAnyNumberOfThreads) {
  const Problem problem =
      with_emission(meshless(with_sites(MeshlessFamily::lehtinen, UniformLevels{.count = 150})), "1 + x");
  const LevelOutcome many = solve_level(problem, 0, no_route);
  const ThreadLimit limit(1);
  const LevelOutcome one = solve_level(problem, 0, no_route);
  for (std::size_t i = 0; i < many.nodes.size(); ++i)
    EXPECT_EQ(many.nodes[i].u_n.value, one.nodes[i].u_n.value);
  ASSERT_EQ(many.result.piece_means.size(), one.result.piece_means.size());
  for (std::size_t i = 0; i < one.result.piece_means.size(); ++i)
    EXPECT_EQ(many.result.piece_means[i].second.value, one.result.piece_means[i].second.value);
}

TEST(MeshlessLevel, RefusesSitesThatMakeNoBasis) {
  const auto said = [](const Meshless& basis) {
    return fault_of([&] { solve_level(with_emission(meshless(basis), "1"), 0, no_route); });
  };
  const InputFault few = said(with_sites(MeshlessFamily::lehtinen, UniformLevels{.count = 10}));
  EXPECT_EQ(few.pointer, "/basis");
  EXPECT_THAT(few.problem, HasSubstr("at least 11 sites; there are 10"));
  EXPECT_THAT(said(with_sites(MeshlessFamily::gaussian, PoissonDiskLevels{.separation = 3})).problem,
              HasSubstr("there are 1"));
  EXPECT_EQ(
      said(with_sites(MeshlessFamily::shepard, PoissonDiskLevels{.separation = Rational(1, 100000)})).pointer,
      "/basis/sites");
  // Elements that end before the next site begins.
  Meshless narrow = own("exp(-r^2)", Rational(1, 10));
  const InputFault gap = said(narrow);
  EXPECT_EQ(gap.pointer, "/basis");
  EXPECT_THAT(gap.problem, HasSubstr("no site is in reach"));
  Meshless plane = with_sites(MeshlessFamily::shepard, UniformLevels{});
  plane.weights = WeightRule::plane;
  EXPECT_EQ(said(plane).pointer, "/basis/weights");
  EXPECT_EQ(said(own("0", std::nullopt)).pointer, "/basis");
}

TEST(MeshlessLevel, RefusesReflectionsThatGrow) {
  // Gauss' elements add up to about 20, and each is taken for the value at its site.
  const Problem problem =
      meshless(with_sites(MeshlessFamily::gaussian, PoissonDiskLevels{.separation = Rational(1, 4)}));
  for (const char* solver : {"direct", "neumann"}) {
    Problem asked = problem;
    asked.solver.name = solver;
    try {
      solve_level(asked, 0, no_route);
      ADD_FAILURE() << "solved";
    } catch (const AccuracyNotReached& refusal) {
      EXPECT_THAT(refusal.what(), HasSubstr("the iteration diverges: the spectral radius"));
    }
  }
}

TEST(MeshlessCheck, RefusesWhatDoesNotGoWithMeshlessBases) {
  const Problem good = meshless(basis_of(MeshlessFamily::shepard));
  EXPECT_NO_THROW(check(good, plenty));
  const auto pointer = [](const Problem& problem) {
    return fault_of([&] { check(problem, plenty); }).pointer;
  };
  Problem problem = good;
  problem.geometry = InterpolatedGeometry{};
  EXPECT_EQ(pointer(problem), "/geometry/interpolated");
  for (const char* solver : {"gmres", "verified"}) {
    problem = good;
    problem.solver.name = solver;
    EXPECT_EQ(pointer(problem), "/solver/name");
  }
  problem = good;
  problem.surface.name = "two_squares";
  problem.reflectivity = everywhere("1");
  EXPECT_EQ(pointer(problem), "/reflectivity");
  problem = good;
  std::get<Meshless>(problem.method).basis.normalise = Normalisation::none;
  EXPECT_EQ(pointer(problem), "/basis/normalise");
  problem = good;
  std::get<Meshless>(problem.method).basis.radius.neighbour = 0;
  EXPECT_EQ(pointer(problem), "/basis/radius/neighbour");
  problem = good;
  std::get<Meshless>(problem.method).sites = PoissonDiskLevels{.separation = 0};
  EXPECT_EQ(pointer(problem), "/basis/sites/poisson_disk");
  problem = good;
  std::get<Meshless>(problem.method).sites = UniformLevels{.count = 0};
  EXPECT_EQ(pointer(problem), "/basis/sites/uniform");
  problem = good;
  problem.triangulation.levels = {0, 12};
  EXPECT_EQ(pointer(problem), "/triangulation/levels/1");
  // rho that reaches 1 is found at a site.
  Problem bright = with_emission(good, "1");
  bright.reflectivity = everywhere("1 + 0*x");
  EXPECT_EQ(fault_of([&] { solve_level(bright, 0, no_route); }).pointer, "/reflectivity");
}

TEST(MeshlessBasisOfAProblem, HalvesWhatLiesBetweenSites) {
  const SiteLevels apart = PoissonDiskLevels{.separation = 3, .seed = 7};
  const auto at_two = std::get<PoissonDiskSites>(*sites_at_level(apart, 2));
  EXPECT_EQ(at_two.separation, 0.75);
  EXPECT_EQ(at_two.seed, 7U);
  EXPECT_EQ(site_spacing(apart, 1, 100), 1.5);
  const SiteLevels anywhere = UniformLevels{.count = 25};
  EXPECT_EQ(std::get<UniformSites>(*sites_at_level(anywhere, 3)).count, 25U * 64);
  EXPECT_DOUBLE_EQ(site_spacing(anywhere, 1, 100), 1);
  EXPECT_FALSE(sites_at_level(anywhere, 26));
  EXPECT_NEAR(surface_area(surface_of(sample_problem("sphere"))), 4 * std::numbers::pi, 1e-4);
  EXPECT_DOUBLE_EQ(surface_area(surface_of(sample_problem("cube"))), 6);
}

}  // namespace
}  // namespace radcert
