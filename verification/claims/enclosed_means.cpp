// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/enclosed_means.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/expression/parse.h"
#include "radcert/formats/result/certificate_json.h"
#include "radcert/reference/continuous_means.h"
#include "radcert/reference/reference_value.h"

namespace radcert::verification {

Problem quartic_emission_on_the_cube(int degree, const Rational& alpha) {
  const auto everywhere = [](const std::string& text) {
    return PiecewiseExpression{.cases = {{"*", parse_expression(text).value()}}};
  };
  Problem problem;
  problem.surface = {.name = "cube", .parameters = {}};
  problem.triangulation.levels = {0};
  problem.method = Collocation{{.degree = degree, .alpha = alpha}};
  problem.reflectivity = everywhere("2/5");
  problem.emission = everywhere("(1 - z)^4");
  return problem;
}

Ball mean_over_the_floor() {
  const Outcome<std::vector<reference::EnclosedMean>> means =
      reference::enclose(*reference::find_continuous_scene("cube_quartic_rho_2/5"), intact_certificate, 0);
  expects(static_cast<bool>(means), "certificates that hold");
  const auto floor = std::find_if(means->begin(), means->end(), [](const reference::EnclosedMean& mean) {
    return mean.mean->name == "continuous_mean_cube_quartic_floor_rho_2/5";
  });
  expects(floor != means->end(), "the floor among the means");
  return floor->first.value;
}

LevelErrors floor_errors(const Bench& bench, const Problem& problem, const Ball& mean,
                         const std::vector<int>& levels) {
  return over_levels(levels, [&](int level) {
    const LevelOutcome outcome = bench.levels.level(problem, level);
    const auto& means = outcome.result.piece_means;
    const auto floor =
        std::find_if(means.begin(), means.end(), [](const auto& piece) { return piece.first == "floor"; });
    expects(floor != means.end(), "a floor", named("level", level));
    const double middle = mean.to_double();
    return Approximation{.value = std::abs(floor->second.value - middle),
                         .radius = floor->second.radius + abs(mean - Ball(middle)).upper_double(),
                         .guaranteed = false};
  });
}

double exponent_beside_right_angles(const Rational& reflectivity) {
  return reference::enclose(*reference::find_family("edge_exponent_90"), {reflectivity}, 8)
      .value()
      .first.value.to_double();
}

}  // namespace radcert::verification
