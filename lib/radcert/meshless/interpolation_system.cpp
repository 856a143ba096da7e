// SPDX-License-Identifier: GPL-3.0-or-later
#define EIGEN_DONT_PARALLELIZE
#include "radcert/meshless/interpolation_system.h"

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

const WorkLimit most_corners("meshless/interpolation_system: corners that a condition is sought at", 5, 1,
                             "a lower bound all the same, and it is called one");

// Above this, elimination fills the rest and a dense matrix is faster.
constexpr double dense_from = 0.2;

Eigen::Map<const Eigen::VectorXd> vector(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

std::vector<double> numbers(const Eigen::VectorXd& vector) {
  return {vector.data(), vector.data() + vector.size()};
}

}  // namespace

struct InterpolationSystem::Parts {
  SparseMatrix matrix;
  Eigen::SparseLU<SparseMatrix> sparse;
  Eigen::PartialPivLU<Eigen::MatrixXd> dense;
  bool is_dense = false;

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& f) const {
    if (is_dense) return dense.solve(f);
    return sparse.solve(f);
  }
  // Eigen's transposed view of sparse factors does not take them as constant.
  [[nodiscard]] Eigen::VectorXd solve_transposed(const Eigen::VectorXd& f) const {
    if (is_dense) return dense.transpose().solve(f);
    return const_cast<Eigen::SparseLU<SparseMatrix>&>(sparse).transpose().solve(f);
  }
};

InterpolationSystem::InterpolationSystem(std::unique_ptr<const Parts> parts) : parts_(std::move(parts)) {}
InterpolationSystem::~InterpolationSystem() = default;
InterpolationSystem::InterpolationSystem(InterpolationSystem&&) noexcept = default;
InterpolationSystem& InterpolationSystem::operator=(InterpolationSystem&&) noexcept = default;

Outcome<InterpolationSystem> InterpolationSystem::make(const RadialBasis& basis) {
  std::vector<Triplet> entries;
  BasisValues row;
  for (std::size_t i = 0; i < basis.size(); ++i) {
    if (!basis.evaluate(basis.sites()[i], row))
      return because("the basis has no value at its site " + std::to_string(i));
    for (std::size_t k = 0; k < row.size(); ++k)
      if (row.values()[k] != 0)
        entries.emplace_back(static_cast<int>(i), static_cast<int>(row.sites()[k]), row.values()[k]);
  }
  auto parts = std::make_unique<Parts>();
  const auto n = static_cast<Eigen::Index>(basis.size());
  parts->matrix.resize(n, n);
  parts->matrix.setFromTriplets(entries.begin(), entries.end());
  const auto full = static_cast<double>(n) * static_cast<double>(n);
  parts->is_dense = static_cast<double>(parts->matrix.nonZeros()) > dense_from * full;
  if (parts->is_dense) {
    parts->dense.compute(Eigen::MatrixXd(parts->matrix));
    const Eigen::VectorXd pivots = parts->dense.matrixLU().diagonal();
    if (!pivots.allFinite() || (pivots.array() == 0).any())
      return because("the interpolation matrix is singular");
  } else {
    parts->sparse.compute(parts->matrix);
    if (parts->sparse.info() != Eigen::Success) return because("the interpolation matrix is singular");
  }
  return InterpolationSystem(std::unique_ptr<const Parts>(std::move(parts)));
}

std::vector<double> InterpolationSystem::solve(std::span<const double> f) const {
  expects(static_cast<Eigen::Index>(f.size()) == parts_->matrix.rows(), "a value for each site",
          named("values", f.size()));
  return numbers(parts_->solve(vector(f)));
}

void InterpolationSystem::solve_columns(Matrix<double>& matrix) const {
  parallel_for(matrix.columns(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const std::vector<double> column = solve(matrix.column(j));
      std::copy(column.begin(), column.end(), matrix.column(j).begin());
    }
  });
}

std::vector<double> InterpolationSystem::residual(std::span<const double> c,
                                                  std::span<const double> f) const {
  const SparseMatrix& a = parts_->matrix;
  expects(static_cast<Eigen::Index>(f.size()) == a.rows() && f.size() == c.size(), "a value for each site",
          named("values", f.size()), named("coefficients", c.size()));
  std::vector<long double> left(f.begin(), f.end());
  for (Eigen::Index j = 0; j < a.outerSize(); ++j)
    for (SparseMatrix::InnerIterator at(a, j); at; ++at)
      left[static_cast<std::size_t>(at.row())] -=
          static_cast<long double>(at.value()) * c[static_cast<std::size_t>(j)];
  return {left.begin(), left.end()};
}

std::vector<double> InterpolationSystem::term_sizes(std::span<const double> c) const {
  const SparseMatrix& a = parts_->matrix;
  expects(static_cast<Eigen::Index>(c.size()) == a.rows(), "a coefficient for each site",
          named("coefficients", c.size()));
  return numbers(a.cwiseAbs() * vector(c).cwiseAbs());
}

// The 1-norm of the inverse: |A^-1 x|_1 is convex, so its maximum over the unit ball is at a corner e_j; the
// gradient shows which.
double InterpolationSystem::condition() const {
  const SparseMatrix& a = parts_->matrix;
  double norm = 0;
  for (Eigen::Index j = 0; j < a.outerSize(); ++j) norm = std::max(norm, a.col(j).cwiseAbs().sum());
  const Eigen::Index n = a.rows();
  Eigen::VectorXd x = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
  double inverse_norm = 0;
  Eigen::Index corner = -1;
  const long most_steps = most_corners.value();
  for (long step = 0; step < most_steps; ++step) {
    const Eigen::VectorXd y = parts_->solve(x);
    const double here = y.lpNorm<1>();
    if (step > 0 && here <= inverse_norm) break;
    inverse_norm = here;
    const Eigen::VectorXd sign = y.unaryExpr([](double v) { return v < 0 ? -1.0 : 1.0; });
    const Eigen::VectorXd gradient = parts_->solve_transposed(sign);
    Eigen::Index next = 0;
    const double steepest = gradient.cwiseAbs().maxCoeff(&next);
    if (next == corner || steepest <= gradient.dot(x)) break;
    corner = next;
    x.setZero();
    x(corner) = 1;
  }
  return norm * inverse_norm;
}

}  // namespace radcert
