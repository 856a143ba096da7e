// SPDX-License-Identifier: GPL-3.0-or-later
#define EIGEN_DONT_PARALLELIZE
#include "radcert/solve/direct.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "radcert/core/checked.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/real.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/solve/rounding/accurate_dot.h"

namespace radcert {
namespace {

/// From the residual to u leads a contraction of all matrices within the radii. Where there is none:
/// (I - K) d = r for every such K gives |d| <= N (|r| + row_radius |d|), N the norm of the inverse of the
/// matrix at hand.
Outcome<LinearSolution> eliminate(const LinearSystem& system) {
  constexpr double unit = unit_roundoff<double>();
  const DirectSolver solver(system.k.entries());
  LinearSolution found{.values = solver.solve(system.e)};
  const std::vector<double>& u = found.values;
  const std::vector<double> ku = accurate_product(system.k.entries(), u);
  std::vector<double> residual(u.size());
  for (std::size_t i = 0; i < u.size(); ++i)
    residual[i] = std::abs(system.e[i] - (u[i] - ku[i])) + unit * (std::abs(u[i]) + 4 * std::abs(ku[i]));
  const std::vector<double> bounds = defects(system, u, std::move(residual));
  if (system.contraction != nullptr) {
    found.radius = system.contraction->inverse_bound(system.contraction->norm(bounds));
    return found;
  }
  const auto largest = [](std::span<const double> sizes) {
    return *std::max_element(sizes.begin(), sizes.end());
  };
  const double inverse = solver.inverse_norm();
  const double moved = inverse * largest(system.row_radius);
  if (!(moved < 1))
    return because("the collocation matrix is known within " + upper_text(largest(system.row_radius)) +
                   " a row, and the inverse of I - K_n has the norm " +
                   nearest_text(inverse, DecimalForm::general(4)) +
                   ": the matrices within the radii are not all regular");
  found.radius = inverse * largest(bounds) / (1 - moved);
  return found;
}

}  // namespace

LinearSolver direct_entry() {
  return {.name = "direct",
          .summary = "elimination; radii are estimates",
          .eliminate = eliminate,
          .plan = [](MemoryPlan& plan, std::uint64_t n) {
            plan.add("factors of I - K", saturated_product(n, n), sizeof(double));
          }};
}

/// The factors take the place of the matrix.
struct DirectSolver::Factors {
  explicit Factors(Eigen::MatrixXd a) : place(std::move(a)), lu(place) {}
  Eigen::MatrixXd place;
  Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> lu;
};

DirectSolver::DirectSolver(const Matrix<double>& k) {
  expects(k.rows() == k.columns() && k.rows() > 0, "a square matrix", named("rows", k.rows()),
          named("columns", k.columns()));
  const auto n = static_cast<Eigen::Index>(k.rows());
  Eigen::MatrixXd a(n, n);
  for (std::size_t j = 0; j < k.columns(); ++j) {
    const std::span<const double> column = k.column(j);
    for (std::size_t i = 0; i < column.size(); ++i)
      a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = (i == j ? 1.0 : 0.0) - column[i];
  }
  factors_ = std::make_unique<Factors>(std::move(a));
}

DirectSolver::~DirectSolver() = default;
DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;

std::vector<double> DirectSolver::solve(std::span<const double> e) const {
  const Eigen::Index n = factors_->lu.rows();
  expects(static_cast<Eigen::Index>(e.size()) == n, "a right-hand side of the matrix's size",
          named("size", e.size()));
  const Eigen::VectorXd u = factors_->lu.solve(Eigen::Map<const Eigen::VectorXd>(e.data(), n));
  return {u.data(), u.data() + n};
}

double DirectSolver::inverse_norm() const {
  const Eigen::Index n = factors_->lu.rows();
  constexpr Eigen::Index columns_at_a_time = 64;
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(n);
  for (Eigen::Index first = 0; first < n; first += columns_at_a_time) {
    const Eigen::Index count = std::min(columns_at_a_time, n - first);
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(n, count);
    for (Eigen::Index j = 0; j < count; ++j) unit(first + j, j) = 1;
    const Eigen::MatrixXd columns = factors_->lu.solve(unit);
    sums += columns.cwiseAbs().rowwise().sum();
  }
  return sums.maxCoeff();
}

}  // namespace radcert
