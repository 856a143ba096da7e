// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/solve/rounding/euclidean_norm.h"
#include "radcert/solve/rounding/rounding.h"

namespace radcert {

const WorkLimit conjugate_directions("solve/conjugate_gradients: directions", 2000, 1,
                                     "refused where the tolerance is not reached; else the bound is larger");

namespace {

constexpr double unit = unit_roundoff<double>();

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// On a right-hand side whose largest entry is between 1 and 2, or which is 0: of residuals from there to the
/// rounding of their products the squares are far above the least numbers.
class Descent {
public:
  Descent(const SystemProducts& k, std::span<const double> b, double lower)
      : k_(k), b_(b), lower_(lower), r_(b.begin(), b.end()) {
    solution_.values.assign(b.size(), 0);
    std::vector<double> sums(b.size());
    k.multiply_sizes(std::vector<double>(b.size(), 1.0), sums);
    const double largest = sums.empty() ? 0 : *std::max_element(sums.begin(), sums.end());
    row_sum_ = largest * upward_of_sums(b.size());
    measure();
  }

  /// One run of conjugate directions from the residual of v; false where the matrix is not positive definite.
  bool run() {
    const std::size_t n = b_.size();
    std::vector<double> r = r_;
    std::vector<double> direction = r;
    std::vector<double> product(n);
    double square = dot(r, r);
    // Beyond this the residual that is updated has no digits in common with that of v.
    const double goal = square * 0x1p-80;
    while (square > goal && solution_.iterations < conjugate_directions.count()) {
      k_.multiply(direction, product);
      for (std::size_t i = 0; i < n; ++i) product[i] = direction[i] - product[i];
      const double energy = dot(direction, product);
      if (!(energy > 0)) return false;
      const double step = square / energy;
      for (std::size_t i = 0; i < n; ++i) solution_.values[i] += step * direction[i];
      for (std::size_t i = 0; i < n; ++i) r[i] -= step * product[i];
      const double now = dot(r, r);
      ++solution_.iterations;
      const double keep = now / square;
      for (std::size_t i = 0; i < n; ++i) direction[i] = r[i] + keep * direction[i];
      square = now;
    }
    measure();
    return true;
  }

  [[nodiscard]] const DefiniteSolution& solution() const { return solution_; }

  /// The solution for 2^exponent b, given one for b. Numbers below the normal range are rounded: what v moves
  /// by, d at most in each entry, moves the residual by (1 + ||K||_2) d sqrt(n) at most.
  [[nodiscard]] DefiniteSolution rescaled(DefiniteSolution solution, int exponent) const {
    double moved = 0;
    for (double& value : solution.values) {
      const double scaled = std::ldexp(value, exponent);
      moved = std::max(moved, std::abs(std::ldexp(scaled, -exponent) - value));
      value = scaled;
    }
    if (moved > 0) {
      solution.residual += (1 + row_sum_) * std::sqrt(static_cast<double>(b_.size())) * moved;
      solution.residual *= upward_of_sums(8);
      bound(solution);
    }
    for (double* size : {&solution.residual, &solution.error_bound, &solution.energy_bound})
      *size = scaled_from_above(*size, exponent);
    return solution;
  }

private:
  /// The residual of v, and what it may be.
  void measure() {
    const std::size_t n = b_.size();
    k_.accurate_residual(solution_.values, b_, r_);
    const double r = euclidean_norm_from_above(r_);
    const double v = euclidean_norm_from_above(solution_.values);
    const double small = (static_cast<double>(n) + 4) * unit;
    double largest = 0;
    for (const double value : solution_.values) largest = std::max(largest, std::abs(value));
    const double of_operator = k_.rounding() * largest * std::sqrt(static_cast<double>(n));
    // Where b is not 0, ||b|| >= 1: of (n + 4)^2 u^2 ||b|| the residual takes (n + 3)^2 u^2 ||b||, and what
    // underflows, less than 8 (n + 4) 2^-1074 in an entry, is far below what is left.
    solution_.residual =
        (r * (1 + unit) + small * small * (euclidean_norm_from_above(b_) + v + row_sum_ * v) + of_operator) *
        upward_of_sums(8);
    bound(solution_);
  }

  void bound(DefiniteSolution& solution) const {
    solution.error_bound = solution.residual / lower_ * (1 + 2 * unit);
    solution.energy_bound = solution.residual / std::sqrt(lower_) * (1 + 4 * unit);
  }

  const SystemProducts& k_;
  std::span<const double> b_;
  double lower_;
  double row_sum_ = 0;
  std::vector<double> r_;
  DefiniteSolution solution_;
};

}  // namespace

Outcome<DefiniteSolution> solve_by_conjugate_gradients(const SystemProducts& k, std::span<const double> b,
                                                       double lower, std::optional<double> tolerance) {
  expects(k.rows() == b.size() && k.columns() == b.size(), "a right-hand side of the matrix's size",
          named("rows", k.rows()), named("entries", b.size()));
  expects(lower > 0, "a positive lower bound", named("lower", lower));
  expects(!tolerance || *tolerance > 0, "a positive tolerance");
  // A power of two moves no bit, and keeps squares away from the ends of the range.
  const int exponent = binary_exponent(b);
  std::vector<double> scaled(b.begin(), b.end());
  for (double& value : scaled) value = std::ldexp(value, -exponent);
  Descent descent(k, scaled, lower);
  DefiniteSolution best = descent.solution();
  // Only where b is 0 the residual is.
  const auto reached = [&] {
    return best.residual == 0 || (tolerance && best.error_bound <= *tolerance * euclidean_norm(best.values));
  };
  while (!reached()) {
    if (!descent.run()) return because("a direction shows that the matrix is not positive definite");
    const DefiniteSolution& now = descent.solution();
    if (!std::isfinite(now.error_bound)) return because("numbers run over the range of double");
    const bool has_halved = now.residual <= best.residual / 2;
    if (now.residual < best.residual) best = now;
    best.iterations = now.iterations;
    if (!has_halved || now.iterations >= conjugate_directions.count()) break;
  }
  best = descent.rescaled(std::move(best), exponent);
  if (!std::isfinite(best.error_bound)) return because("numbers run over the range of double");
  if (tolerance && !reached())
    return because("the error bound is " + upper_text(best.error_bound) + " in the 2-norm after " +
                   std::to_string(best.iterations) + " conjugate directions, and the solution has the size " +
                   nearest_text(euclidean_norm(best.values), DecimalForm::general(3)));
  return best;
}

}  // namespace radcert
