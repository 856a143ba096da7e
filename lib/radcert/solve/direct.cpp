// SPDX-License-Identifier: GPL-3.0-or-later
#define EIGEN_DONT_PARALLELIZE
#include "radcert/solve/direct.h"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {

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
