// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/fine_levels.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "radcert/clusters/cluster_operator.h"
#include "radcert/core/contract.h"
#include "radcert/core/files/result_store.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/reference/operator_integral.h"
#include "tests/verification/fixtures.h"

namespace radcert::verification {
namespace {

// Fine levels are solved as they are asked for, and of no other source.
class NoLevels final : public LevelSource {
public:
  LevelOutcome level(const Problem&, int) override { throw std::logic_error("a level was asked for"); }
};

FineStudy cube_study() {
  return {.problem = flat_problem({0}), .first = 1, .last = 2, .tolerance = Rational(1, 1000), .order = 4};
}

TEST(ToleranceOfALevel, IsAPowerOfTenThatFallsWithTheErrors) {
  FineStudy study = cube_study();
  study.last = 9;
  EXPECT_EQ(tolerance_at(study, 1), Rational(1, 1000));
  EXPECT_EQ(tolerance_at(study, 2), Rational(1, 100000));
  EXPECT_EQ(tolerance_at(study, 3), Rational(1, 1000000));
  for (int level = 1; level <= 12; ++level) {
    const Rational wanted = study.tolerance / power(Rational(16), level - 1);
    const Rational tolerance = tolerance_at(study, level);
    const bool finest = tolerance.to_double() == ClusterTolerance::finest;
    EXPECT_TRUE(finest || tolerance <= wanted) << level;
    EXPECT_TRUE(10 * tolerance > wanted) << level;
  }
  EXPECT_EQ(tolerance_at(study, 12).to_double(), ClusterTolerance::finest);
  EXPECT_THROW(static_cast<void>(tolerance_at(study, 0)), ContractViolation);
}

TEST(FineLevels, AreTheFiguresOfSolvedLevelsAndAreKept) {
  const test::TemporaryFolder folder;
  const FineStudy study = cube_study();
  const std::vector<LevelFigure> figures{node_error_figure(), discretisation_error_figure()};
  NoLevels none;
  std::vector<LevelErrors> first;
  {
    ResultStore store(folder.path());
    const OperatorRoute route = [](const Surface& surface, const SurfaceFunction& u) {
      return reference::applied_operator(surface, u);
    };
    first =
        fine_levels({.budget = Budget::full, .route = route, .levels = none, .store = store}, study, figures);
    for (const int level : {1, 2}) {
      const LevelResult solved = solve_level(study.problem, level, route).result;
      const auto k = static_cast<std::size_t>(level - 1);
      EXPECT_EQ(first[0].errors[k].value, solved.node_error->value);
      EXPECT_EQ(first[0].errors[k].radius, solved.node_error->radius);
      EXPECT_EQ(first[1].errors[k].value, solved.discretisation_error->value);
    }
    EXPECT_EQ(first[0].mesh_sizes[0], 2 * first[0].mesh_sizes[1]);
  }
  ResultStore store(folder.path());
  const std::vector<LevelErrors> again =
      fine_levels({.budget = Budget::full, .route = {}, .levels = none, .store = store}, study, figures);
  for (std::size_t i = 0; i < figures.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(again[i].errors[k].value, first[i].errors[k].value);
}

}  // namespace
}  // namespace radcert::verification
