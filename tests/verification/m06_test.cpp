// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/files/result_store.h"
#include "tests/verification/fixtures.h"
#include "verification/claims/ac98/collocation/sphere_collocation.h"
#include "verification/claims/m06/named_problems.h"
#include "verification/claims/m06/section_3/interpolation_error.h"
#include "verification/claims/m06/sphere_errors.h"
#include "verification/framework/level_errors.h"
#include "verification/framework/reading/paper.h"

namespace radcert::verification::m06 {
namespace {

// Levels with a node error of 3 h^2 on the piece "a" and of h^3 on "b", h = 2^-level.
class MadeUpLevels final : public LevelSource {
public:
  LevelOutcome level(const Problem& problem, int level) override {
    LevelOutcome outcome = made_up_level(problem, level);
    const double h = outcome.result.mesh_size;
    outcome.result.uniform_error =
        Approximation{.value = h, .radius = std::numeric_limits<double>::infinity(), .guaranteed = false};
    for (const auto& [piece, error] :
         {std::pair<std::string, double>{"a", 3 * h * h}, std::pair<std::string, double>{"b", h * h * h}}) {
      NodeValue node;
      node.piece = piece;
      node.u = 1;
      node.u_n.value = piece == "a" ? 1 + error : 1 - error;
      outcome.nodes.push_back(node);
    }
    return outcome;
  }
};

class OverLevels : public testing::Test {
protected:
  MadeUpLevels levels_;
  ResultStore store_;
  Bench bench_{.budget = Budget::standard, .route = {}, .levels = levels_, .store = store_};
  Problem problem_ = flat_problem({0, 1, 2, 3});
};

TEST_F(OverLevels, OrdersAreThePowersOfTheErrors) {
  const std::vector<int> levels = levels_from(1, 3);
  const auto exponent = [](const LevelErrors& errors) { return observed_order(errors).exponent.value; };
  EXPECT_NEAR(exponent(uniform_errors(bench_, problem_, levels)), 1, 1e-14);
  EXPECT_NEAR(exponent(node_errors(bench_, problem_, levels)), 2, 1e-14);
  EXPECT_NEAR(exponent(discretisation_errors(bench_, problem_, levels)), 2, 1e-14);
  const auto on = [](const std::string& piece) {
    return [piece](const NodeValue& node, const ParameterTriangle&) { return node.piece == piece; };
  };
  const LevelErrors on_a = node_errors(bench_, problem_, levels, on("a"));
  EXPECT_DOUBLE_EQ(on_a.errors.back().value, 3.0 / 64);
  EXPECT_NEAR(exponent(on_a), 2, 1e-12);
  EXPECT_NEAR(exponent(node_errors(bench_, problem_, levels, on("b"))), 3, 1e-12);
}

TEST_F(OverLevels, QuickLeavesOutTheLastLevel) {
  EXPECT_EQ(levels_for(problem_, Budget::quick), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(levels_for(problem_, Budget::full), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_THROW(static_cast<void>(levels_for(flat_problem({0, 1}), Budget::quick)), ContractViolation);
  EXPECT_EQ(levels_of_an_order(flat_problem({0, 1, 2, 3, 4}), Budget::quick), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(levels_of_an_order(flat_problem({0, 1, 2, 3, 4}), Budget::full), (std::vector<int>{1, 2, 3, 4}));
}

TEST(ProblemsOfMicula, AreReadAndSmooth) {
  for (const char* name : {"two_piece_r0", "sphere_r1", "ellipsoid_r2", "two_piece_symmetric"})
    EXPECT_FALSE(surface_of(problem_named(name)).pieces_meet_at_angle) << name;
  EXPECT_THROW(static_cast<void>(problem_named("none")), ContractViolation);
}

// The mean of x^4 over the sphere is 1/5; the rule of the centroids at level 0 has 1/9.
TEST(SphereErrors, AreThoseOfTheCentroidOfAnOctant) {
  const SphereErrors errors = errors_on_the_sphere(chosen_nodes(0), fourth_power, {0, 1});
  EXPECT_NEAR(errors.nodes.errors[0].value, 1.0 / 5 - 1.0 / 9, 1e-6);
  EXPECT_NEAR(errors.nodes.errors[0].value, 0.0888888888, errors.nodes.errors[0].radius + 1e-9);
  // At a vertex: 1 - 1/9, and the error of the mean.
  EXPECT_NEAR(errors.uniform.errors[0].value, 1 - 1.0 / 9 + 4.0 / 45, 1e-6);
}

// By closed forms of the weights, in balls.
TEST(SphereErrors, AreThoseOfTheExactWeights) {
  const BallPrecision precision(128);
  const SphereErrors errors = errors_on_the_sphere(chosen_nodes(1), fourth_power, {2, 3});
  for (const int level : {2, 3}) {
    const Approximation& ours = errors.nodes.errors.at(static_cast<std::size_t>(level) - 2);
    const ac98::SphereCollocation method(ac98::symmetric_octant(level), Rational(1, 6));
    const Ball mean = method.mean([](const Vector<Ball>& q) { return power(q.x, 4); });
    EXPECT_NEAR(ours.value, abs(Ball(Rational(1, 5)) - mean).to_double(), ours.radius) << level;
    EXPECT_LT(ours.radius, 1e-9);
  }
}

// r = 0, by hand: (I - L) x = x - 1/3 on the triangle, x -+ 1/6 about the centre of the square.
TEST(InterpolationErrors, AreThoseOfTheCentroid) {
  const InterpolationError error(0);
  EXPECT_TRUE(error(Over::triangle, {0, 0}, {1, 0}).is_zero());
  EXPECT_EQ(error(Over::triangle, {1, 0}, {1, 0}), RationalPolynomial(Rational(1, 36)));
  EXPECT_TRUE(error(Over::square, {0, 0}, {0, 1}).is_zero());
  EXPECT_EQ(error(Over::square, {0, 0}, {1, 1}), RationalPolynomial(Rational(-1, 36)));
}

// With Phi = 1 they are the defects of the rule, with the other sign.
TEST(InterpolationErrors, AreTheDefectsOfTheRule) {
  for (const int r : {1, 2, 3}) {
    const InterpolationError error(r);
    const InsetFamily family(r);
    for (int b = 0; b <= r + 2; ++b)
      for (const Rational& alpha : {Rational(1, 7), Rational(1, 10)})
        EXPECT_EQ(error(Over::triangle, {0, 0}, {r + 2 - b, b})(alpha),
                  -power(1 - 3 * alpha, r) * family.defect(Region::triangle, {r + 2 - b, b})(alpha))
            << r << " " << b;
  }
}

// L reproduces polynomials of degree r, whatever Phi is; a half turn takes what is odd to its opposite.
TEST(InterpolationErrors, VanishUpToTheDegreeAndForOddTotalDegreesOnTheSquare) {
  for (const int r : {1, 2, 3}) {
    const InterpolationError error(r);
    EXPECT_EQ(error.coefficients_left(Over::kite, 1, r, {}), 0) << r;
    EXPECT_NE(error.coefficients_left(Over::kite, 1, r + 1, {}), 0) << r;
    EXPECT_EQ(error.coefficients_left(Over::square, r % 2 == 0 ? 0 : 1, r + 1, {}), 0) << r;
  }
  EXPECT_THROW(static_cast<void>(InterpolationError(1)(Over::square, {2, 0}, {0, 0})), ContractViolation);
}

}  // namespace
}  // namespace radcert::verification::m06
