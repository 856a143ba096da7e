// SPDX-License-Identifier: GPL-3.0-or-later
#define EIGEN_DONT_PARALLELIZE
#include "radcert/solve/power_series.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/parallel.h"
#include "radcert/scalar/real.h"
#include "radcert/solve/neumann.h"
#include "radcert/solve/product.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();

/// Columns that are multiplied at a time: the same for every number of threads.
constexpr std::size_t panel = 64;

/// More than n roundings of a sum of n products, and of the few operations around it, can do to one part.
double rounding_of_sums(std::size_t n) { return 2 * (static_cast<double>(n) + 8) * unit; }

/// More than sums of n products, and the few operations around them, lose in an entry below the normal range:
/// a product is off by half of the least number there, sums by nothing.
double underflow_of_sums(std::size_t n) {
  return 8 * static_cast<double>(n) * std::numeric_limits<double>::denorm_min();
}

/// The same of sums that begin with e: where that is 0 all terms are.
double underflow_of_sums(std::span<const double> e) {
  const bool is_zero = std::all_of(e.begin(), e.end(), [](double value) { return value == 0; });
  return is_zero ? 0 : underflow_of_sums(e.size());
}

double row_norm(const Matrix<double>& a) {
  const std::vector<double> ones(a.columns(), 1.0);
  std::vector<double> sums(a.rows());
  multiply_sizes(a, ones, sums);
  return *std::max_element(sums.begin(), sums.end()) * (1 + rounding_of_sums(a.columns()));
}

double largest(std::span<const double> x) {
  double size = 0;
  for (const double value : x) size = std::max(size, std::abs(value));
  return size;
}

Matrix<double> squared(const Matrix<double>& a) {
  const std::size_t n = a.rows();
  MemoryPlan().add("a power of the transfer matrix", n * n, sizeof(double)).require(available_memory());
  Matrix<double> product = Matrix<double>::uninitialised(n, n);
  const auto whole = static_cast<Eigen::Index>(n);
  const Eigen::Map<const Eigen::MatrixXd> left(a.column(0).data(), whole, whole);
  parallel_for(n, panel, [&](std::size_t begin, std::size_t end) {
    const auto columns = static_cast<Eigen::Index>(end - begin);
    const Eigen::Map<const Eigen::MatrixXd> right(a.column(begin).data(), whole, columns);
    Eigen::Map<Eigen::MatrixXd> part(product.column(begin).data(), whole, columns);
    part.noalias() = left * right;
  });
  return product;
}

bool has_negative_entry(const Matrix<double>& a) {
  for (std::size_t j = 0; j < a.columns(); ++j)
    for (const double entry : a.column(j))
      if (entry < 0) return true;
  return false;
}

}  // namespace

const WorkLimit most_matrix_squarings("solve/power_series: squarings", 4, 0,
                                      "refused: no power was shown to contract");

Outcome<NeumannSeries, NoPowerContracts> NeumannSeries::make(Matrix<double> r, long most_squarings) {
  expects(r.rows() == r.columns() && r.rows() > 0, "a square matrix", named("rows", r.rows()),
          named("columns", r.columns()));
  NeumannSeries series;
  series.r_ = std::move(r);
  series.size_ = row_norm(series.r_);
  const std::size_t n = series.r_.rows();
  const bool is_signed = has_negative_entry(series.r_);
  double least = std::numeric_limits<double>::infinity();
  double size = series.size_;
  for (int squarings = 0;; ++squarings) {
    const Matrix<double>& k = series.k_ ? *series.k_ : series.r_;
    Outcome<Contraction, NoContraction> contraction =
        find_contraction(k, std::vector<double>(n, series.radius_));
    if (contraction) {
      series.contraction_ = *std::move(contraction);
      return series;
    }
    least = std::min(least, std::pow(contraction.reason().theta, 1 / static_cast<double>(series.power_)));
    if (!is_signed || squarings >= most_squarings || !std::isfinite(size * size))
      return because(NoPowerContracts{.power = series.power_,
                                      .theta = least,
                                      .diverges = !is_signed && contraction.reason().radius_from_below >= 1});
    // |fl(K^2) - K^2| <= gamma |K| |K|, and K is off by radius_: (K + E)^2 - K^2 = E K + K E + E^2.
    series.k_ = squared(k);
    series.radius_ = (rounding_of_sums(n) * size * size + static_cast<double>(n) * underflow_of_sums(n) +
                      2 * size * series.radius_ + series.radius_ * series.radius_) *
                     (1 + 8 * unit);
    series.power_ *= 2;
    size = row_norm(*series.k_);
  }
}

double NeumannSeries::spectral_radius_bound() const {
  return std::pow(contraction_.theta(), 1 / static_cast<double>(power_)) * (1 + 8 * unit);
}

std::optional<IterativeSolution> NeumannSeries::plain_series(const Matrix<double>& k,
                                                             std::span<const double> e,
                                                             double tolerance) const {
  const std::size_t n = e.size();
  const double theta = contraction_.theta();
  const double size_of_e = contraction_.norm(e);
  const double underflow = underflow_of_sums(e) / contraction_.least_weight();
  IterativeSolution solution{
      .values = std::vector<double>(e.begin(), e.end()), .iterations = 0, .error_bound = 0};
  std::vector<double> next(n);
  std::vector<double> step(n);
  while (true) {
    // x - v' = K (x - v') + K (v' - v) - rounding, |rounding| <= gamma (|K| |v| + |e|).
    const double rounding =
        rounding_of_sums(n) * (theta * contraction_.norm(solution.values) + size_of_e) + underflow;
    multiply(k, solution.values, next);
    for (std::size_t i = 0; i < n; ++i) {
      next[i] += e[i];
      step[i] = next[i] - solution.values[i];
    }
    std::swap(solution.values, next);
    ++solution.iterations;
    const double change = contraction_.norm(step) * (1 + 8 * unit);
    solution.error_bound = contraction_.inverse_bound((theta * change + rounding) * (1 + 8 * unit));
    if (!std::isfinite(solution.error_bound)) return std::nullopt;
    if (solution.error_bound <= tolerance * largest(solution.values)) return solution;
    if (!(theta * change > rounding)) return std::nullopt;
  }
}

Outcome<IterativeSolution, NotReached> NeumannSeries::solve(std::span<const double> e,
                                                            std::optional<double> tolerance) const {
  const std::size_t n = r_.rows();
  expects(e.size() == n, "a right-hand side of the matrix's size", named("size", e.size()));
  expects(!tolerance || (*tolerance >= least_tolerance && *tolerance < 1),
          "a tolerance in [2^-51, 1), or none", named("tolerance", tolerance.value_or(0)));
  const Matrix<double>& k = k_ ? *k_ : r_;
  std::vector<double> sum(e.begin(), e.end());
  std::vector<double> image(n);
  double radius_of_sum = 0;
  for (std::size_t m = 1; m < power_; ++m) {
    radius_of_sum = size_ * radius_of_sum + rounding_of_sums(n) * (size_ * largest(sum) + largest(e)) +
                    underflow_of_sums(e);
    multiply(r_, sum, image);
    for (std::size_t i = 0; i < n; ++i) sum[i] = e[i] + image[i];
  }
  std::optional<IterativeSolution> found;
  if (tolerance) found = plain_series(k, sum, *tolerance);
  if (!found) {
    Outcome<IterativeSolution, NotReached> accurate = solve_by_neumann(k, contraction_, sum, tolerance);
    if (!accurate) return accurate;
    found = *std::move(accurate);
  }
  if (power_ > 1) {
    // With the exact K and right-hand side the residual of what was found is larger by no more than this.
    const double size = largest(found->values) + found->error_bound;
    const std::vector<double> difference(n, (radius_of_sum + radius_ * size) * (1 + 8 * unit));
    found->error_bound += contraction_.inverse_bound(contraction_.norm(difference));
    found->iterations *= power_;
    if (!std::isfinite(found->error_bound))
      return because(NotReached{.iterations = found->iterations,
                                .error_bound = std::numeric_limits<double>::infinity(),
                                .size = largest(found->values)});
  }
  return *std::move(found);
}

}  // namespace radcert
