// SPDX-License-Identifier: GPL-3.0-or-later
#define EIGEN_DONT_PARALLELIZE
#include "radcert/solve/verified_system.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "radcert/core/checked.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/real.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/solve/product.h"
#include "radcert/solve/rounding/accurate_dot.h"
#include "radcert/solve/rounding/rounding.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// No product that underflows is off by more.
constexpr double underflow = std::numeric_limits<double>::denorm_min();
/// Enough for a handful of roundings.
constexpr double upward = 1 + 8 * unit;
/// The columns of a product of matrices that a thread takes at a time.
constexpr std::size_t columns_at_a_time = 64;

const WorkLimit steps_to_weights("solve/verified_system: steps to weights", 40, 0,
                                 "refused, with the least bound found");
const WorkLimit refinements("solve/verified_system: refinements", 20, 0, "a wider radius");
const WorkLimit steps_of_a_bound("solve/verified_system: steps of a bound", 60, 0,
                                 "a wider radius: each step's is one");

using Values = std::vector<double>;

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

Eigen::Map<Eigen::MatrixXd> columns(Matrix<double>& a, std::size_t begin, std::size_t end) {
  return {a.column(begin).data(), index(a.rows()), index(end - begin)};
}

/// sum_j |a_ij| x_j for x >= 0, rounded up.
Values sizes_times(const Matrix<double>& a, std::span<const double> x) {
  Values y(a.rows());
  multiply_sizes(a, x, y);
  const auto n = static_cast<double>(a.columns());
  for (double& value : y) value = value * upward_of_sums(a.columns()) + n * underflow;
  return y;
}

Values sizes(std::span<const double> x) {
  Values y(x.begin(), x.end());
  for (double& value : y) value = std::abs(value);
  return y;
}

/// max_i x_i / w_i for x >= 0, rounded up, or infinity.
double largest_ratio(std::span<const double> x, std::span<const double> w) {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double ratio = x[i] / w[i];
    if (!std::isfinite(ratio)) return infinity;
    largest = std::max(largest, ratio);
  }
  return largest * upward + underflow;
}

bool all_finite(std::span<const double> x) {
  return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
}

bool are_radii(std::span<const double> x) {
  return std::all_of(x.begin(), x.end(), [](double value) { return value >= 0 && std::isfinite(value); });
}

}  // namespace

/// R, as Gaussian elimination with partial pivoting rounds it.
void VerifiedSystem::invert() {
  const std::size_t n = size();
  Eigen::MatrixXd a = -columns(k_, 0, n);
  a.diagonal().array() += 1;
  const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> lu(a);
  inverse_ = Matrix<double>::uninitialised(n, n);
  parallel_for(n, columns_at_a_time, [&](std::size_t begin, std::size_t end) {
    const auto identity = Eigen::MatrixXd::Identity(index(n), index(n));
    columns(inverse_, begin, end) = lu.solve(identity.middleCols(index(begin), index(end - begin)));
  });
}

/// The sizes of I - R + R k as the machine computes it, with what the sums with I and R round; what R k
/// rounds is left to defect_times.
void VerifiedSystem::bound_defect() {
  const std::size_t n = size();
  defect_ = Matrix<double>::uninitialised(n, n);
  parallel_for(n, columns_at_a_time, [&](std::size_t begin, std::size_t end) {
    columns(defect_, begin, end).noalias() = columns(inverse_, 0, n) * columns(k_, begin, end);
    for (std::size_t j = begin; j < end; ++j) {
      const std::span<double> column = defect_.column(j);
      const std::span<const double> inverse_column = inverse_.column(j);
      for (std::size_t i = 0; i < n; ++i) {
        const double difference = column[i] - inverse_column[i];
        const double entry = i == j ? 1 + difference : difference;
        const double rounded_before = i == j ? unit * std::abs(difference) : 0.0;
        column[i] = (std::abs(entry) + rounded_before) * upward;
      }
    }
  });
}

/// H w, rounded up: the defect as computed, the n roundings of each entry of R k, and the radii of k.
Values VerifiedSystem::defect_times(std::span<const double> w) const {
  Values image = sizes_times(defect_, w);
  Values inner = sizes_times(k_, w);
  const double rounding = rounding_of_sums(size());
  for (double& value : inner) value = value * rounding * upward + underflow;
  if (k_radius_.rows() > 0) {
    const Values moved = sizes_times(k_radius_, w);
    for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = (inner[i] + moved[i]) * upward;
  }
  const Values outer = sizes_times(inverse_, inner);
  double sum = 0;
  for (const double weight : w) sum += weight;
  // Of each entry of R k, n products may have underflowed.
  const double underflows = static_cast<double>(size()) * underflow * (2 * sum + 2);
  for (std::size_t i = 0; i < image.size(); ++i) image[i] = (image[i] + outer[i] + underflows) * upward;
  return image;
}

/// The power method for H, from |R| (|A| 1) >= |R A| 1, about 1.
void VerifiedSystem::find_weights() {
  const long most_steps = steps_to_weights.value();
  constexpr double small_enough = 1.0 / 16;
  const std::size_t n = size();
  Values row_sums = sizes_times(k_, Values(n, 1.0));
  for (double& value : row_sums) value += 1;
  Values w = sizes_times(inverse_, row_sums);
  theta_ = infinity;
  for (int step = 0; step < most_steps; ++step) {
    const double largest = *std::max_element(w.begin(), w.end());
    for (double& weight : w) weight /= largest;
    if (!(*std::min_element(w.begin(), w.end()) >= std::numeric_limits<double>::min()) || !all_finite(w))
      return;
    const Values image = defect_times(w);
    const double theta = largest_ratio(image, w);
    if (step == 0 || theta < theta_) {
      theta_ = theta;
      weights_ = w;
    }
    if (theta_ < small_enough || !std::isfinite(theta)) return;
    for (std::size_t i = 0; i < n; ++i) w[i] = image[i] + theta / 2 * w[i];
  }
}

/// The most that the radii of k and e change the residual of x.
Values VerifiedSystem::data_radius(std::span<const double> x, std::span<const double> e_radius) const {
  Values radius(e_radius.begin(), e_radius.end());
  radius.resize(size());
  if (k_radius_.rows() == 0) return radius;
  const Values moved = sizes_times(k_radius_, sizes(x));
  for (std::size_t i = 0; i < size(); ++i) radius[i] = (radius[i] + moved[i]) * upward;
  return radius;
}

/// The residual of x and R times it.
Values VerifiedSystem::corrections(std::span<const double> x, std::span<const double> e,
                                   std::span<double> residual) const {
  accurate_residual(k_, x, e, residual);
  Values correction(size());
  multiply(inverse_, residual, correction);
  return correction;
}

Outcome<VerifiedSolution> VerifiedSystem::solve(std::span<const double> e,
                                                std::span<const double> e_radius) const {
  const std::size_t n = size();
  expects(e.size() == n && all_finite(e), "a finite right-hand side of the system's size", named("rows", n),
          named("size", e.size()));
  expects(e_radius.empty() || (e_radius.size() == n && are_radii(e_radius)),
          "a radius >= 0 for every entry of the right-hand side, or none", named("rows", n),
          named("radii", e_radius.size()));
  Values x(n);
  Values residual(n);
  multiply(inverse_, e, x);
  Values correction = corrections(x, e, residual);
  const long most_refinements = refinements.value();
  double distance = largest_ratio(sizes(correction), weights_);
  for (int step = 0; step < most_refinements && distance > 0; ++step) {
    Values refined = x;
    for (std::size_t i = 0; i < n; ++i) refined[i] += correction[i];
    Values refined_residual(n);
    Values refined_correction = corrections(refined, e, refined_residual);
    const double refined_distance = largest_ratio(sizes(refined_correction), weights_);
    if (!(refined_distance < distance)) break;
    const bool is_last = refined_distance > distance / 2;
    x = std::move(refined);
    residual = std::move(refined_residual);
    correction = std::move(refined_correction);
    distance = refined_distance;
    if (is_last) break;
  }

  // What the residual may be off by, see accurate_residual; |r| <= (|computed| + second order) / (1 - u).
  const Values radius = data_radius(x, e_radius);
  const Values products = sizes_times(k_, sizes(x));
  const double terms = static_cast<double>(n) + 4;
  const double second_order = (terms * unit) * (terms * unit);
  const double rounding = rounding_of_sums(n);
  Values off(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double size = (std::abs(e[i]) + std::abs(x[i]) + products[i]) * upward;
    const double inexact = unit * std::abs(residual[i]) + second_order * size + 8 * terms * underflow;
    off[i] = (inexact * upward + radius[i] + rounding * std::abs(residual[i])) * upward + underflow;
  }
  Values z = sizes_times(inverse_, off);
  const double underflows = static_cast<double>(n) * underflow;
  for (std::size_t i = 0; i < n; ++i) z[i] = (z[i] + std::abs(correction[i]) + underflows) * upward;

  const double size = largest_ratio(z, weights_) / (1 - theta_) * upward;
  Values bound(n);
  for (std::size_t i = 0; i < n; ++i) bound[i] = size * weights_[i] * upward + underflow;
  const long most_steps = steps_of_a_bound.value();
  constexpr double hardly_less = 0.99;
  bool is_shrinking = true;
  for (int step = 0; step < most_steps && is_shrinking; ++step) {
    const Values image = defect_times(bound);
    is_shrinking = false;
    for (std::size_t i = 0; i < n; ++i) {
      const double next = (z[i] + image[i]) * upward;
      is_shrinking = is_shrinking || next < hardly_less * bound[i];
      bound[i] = std::min(bound[i], next);
    }
  }
  if (!all_finite(x) || !all_finite(bound))
    return because("the solution or its bound exceeds the largest numbers");
  return VerifiedSolution{.values = std::move(x), .radius = std::move(bound)};
}

Outcome<VerifiedSystem> verified_system(Matrix<double> k, Matrix<double> k_radius) {
  const std::size_t n = k.rows();
  expects(n == k.columns() && n > 0 && n <= longest_sum, "a square matrix", named("rows", n),
          named("columns", k.columns()));
  expects(k_radius.rows() == k_radius.columns() && (k_radius.rows() == 0 || k_radius.rows() == n),
          "a radius for every entry, or none", named("rows", k_radius.rows()),
          named("columns", k_radius.columns()));
  for (std::size_t j = 0; j < n; ++j)
    expects(all_finite(k.column(j)) && (k_radius.rows() == 0 || are_radii(k_radius.column(j))),
            "finite entries and radii >= 0", named("column", j));
  VerifiedSystem system;
  system.k_ = std::move(k);
  system.k_radius_ = std::move(k_radius);
  system.invert();
  for (std::size_t j = 0; j < n; ++j)
    if (!all_finite(system.inverse_.column(j))) return because("I - K is singular to working precision");
  system.bound_defect();
  system.find_weights();
  if (!(system.theta_ < 1))
    return because(
        "no approximate inverse R of I - K could be shown to have || I - R (I - K) || < 1; the least bound "
        "was " +
        upper_text(system.theta_, DecimalForm::general(6)));
  return system;
}

LinearSolver verified_system_entry() {
  return {
      .name = "verified",
      .summary = "elimination in balls: every error at the nodes is proved, or the reason why not is given",
      .plan = [](MemoryPlan& plan, std::uint64_t n) {
        plan.add("radii, inverse and defect of I - K, and a copy to work on",
                 saturated_product(saturated_product(n, n), 4), sizeof(double));
      }};
}

}  // namespace radcert
