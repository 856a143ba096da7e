// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/search/damped_least_squares.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace radcert {
namespace {

using Vector = Eigen::VectorXd;
using EigenMatrix = Eigen::MatrixXd;

Eigen::Map<const Vector> values_of(const FunctionsThere& there) {
  return {there.values.data(), static_cast<Eigen::Index>(there.values.size())};
}

double square_of(const FunctionsThere& there) { return values_of(there).squaredNorm(); }

std::vector<double> next_point(const std::vector<double>& x, const FunctionsThere& here, double damping) {
  const auto functions = static_cast<Eigen::Index>(here.values.size());
  const auto unknowns = static_cast<Eigen::Index>(x.size());
  const Eigen::Map<const EigenMatrix> derivatives(here.derivatives.column(0).data(), functions, unknowns);
  EigenMatrix system(functions + unknowns, unknowns);
  system << derivatives, std::sqrt(damping) * EigenMatrix::Identity(unknowns, unknowns);
  Vector right = Vector::Zero(system.rows());
  right.head(functions) = -values_of(here);
  const Vector step = system.householderQr().solve(right);
  std::vector<double> next = x;
  for (std::size_t k = 0; k < next.size(); ++k) next[k] += step[static_cast<Eigen::Index>(k)];
  return next;
}

}  // namespace

bool damped_least_squares(std::vector<double>& x,
                          const std::function<FunctionsThere(const std::vector<double>&)>& functions,
                          double solved, int most_steps) {
  constexpr int most_trials = 8;
  constexpr double least_damping = 1e-14;
  FunctionsThere here = functions(x);
  double square = square_of(here);
  double damping = 1e-2;
  for (int step = 0; step < most_steps && square > solved; ++step) {
    bool descends = false;
    for (int trial = 0; trial < most_trials && !descends; ++trial) {
      std::vector<double> next = next_point(x, here, damping);
      FunctionsThere there = functions(next);
      const double square_there = square_of(there);
      descends = square_there < square;
      if (descends) {
        x = std::move(next);
        here = std::move(there);
        square = square_there;
      } else {
        damping *= 4;
      }
    }
    if (!descends) break;
    damping = std::max(damping / 5, least_damping);
  }
  return square <= solved;
}

}  // namespace radcert
