// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/interpolation_bounds.h"

#include <algorithm>
#include <cmath>

#include "radcert/clusters/interpolation_nodes.h"
#include "radcert/clusters/mode_products.h"
#include "radcert/clusters/mode_tables.h"
#include "radcert/core/lazy_table.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

constexpr std::size_t degrees = largest_mode_degree + 1;
/// More than the roundings of the few operations that follow a bound.
constexpr double up = 1 + 0x1p-40;

/// Samples lie in so many steps a degree along each quarter of a circle.
constexpr int steps_a_degree = 6;

std::vector<ParameterPoint<double>> exact_nodes(int degree) {
  std::vector<ParameterPoint<double>> nodes;
  for (const Barycentric<double>& x : interpolation_nodes(degree)) {
    ParameterPoint<double> node{std::max(0.0, x.x[1]), std::max(0.0, x.x[2])};
    while (Rational(1) < Rational::exactly(node.s) + Rational::exactly(node.t)) {
      double& larger = node.s > node.t ? node.s : node.t;
      larger = std::nextafter(larger, 0.0);
    }
    nodes.push_back(node);
  }
  return nodes;
}

ParameterPoint<BoundedDouble> exactly(const ParameterPoint<double>& x) {
  return {BoundedDouble::exactly(x.s), BoundedDouble::exactly(x.t)};
}

double upper(const BoundedDouble& x) { return (std::abs(x.value()) + x.error()) * up; }

/// The largest of bounds of sum_a |(W^T D)_a| at points.
/// Maths     for D known within errors, sums of k products in double are off by at most (k + 2) u |W|^T |D|
///           beside |W|^T errors
class LargestSum {
public:
  explicit LargestSum(int degree)
      : degree_(degree),
        w_(ModeTables::instance().interpolation(degree).values_of_modes_transposed),
        sizes_(w_.rows(), w_.columns()) {
    for (std::size_t j = 0; j < w_.columns(); ++j)
      for (std::size_t i = 0; i < w_.rows(); ++i) sizes_(i, j) = std::abs(w_(i, j));
  }
  void take(const Barycentric<BoundedDouble>& x) {
    const std::size_t k = mode_count(degree_);
    std::vector<BoundedDouble> modes(k);
    triangle_modes<BoundedDouble>(degree_, x, modes);
    const double rounding = (static_cast<double>(k) + 2) * 0x1p-53;
    std::vector<double> middle;
    std::vector<double> off;
    for (const BoundedDouble& mode : modes) {
      middle.push_back(mode.value());
      off.push_back((mode.error() + rounding * std::abs(mode.value())) * up);
    }
    values_.push_back(std::move(middle));
    errors_.push_back(std::move(off));
    constexpr std::size_t at_a_time = 64;
    if (values_.size() == at_a_time) sum();
  }
  double largest() {
    sum();
    return largest_;
  }

private:
  void sum() {
    const std::size_t k = mode_count(degree_);
    for (std::size_t point = 0; point < values_.size(); point += 4) {
      const std::size_t count = std::min<std::size_t>(4, values_.size() - point);
      std::vector<std::vector<double>> value(count, std::vector<double>(w_.rows(), 0.0));
      std::vector<std::vector<double>> error = value;
      std::vector<const double*> from;
      std::vector<double*> to;
      std::vector<const double*> from_errors;
      std::vector<double*> to_errors;
      for (std::size_t c = 0; c < count; ++c) {
        from.push_back(values_[point + c].data());
        to.push_back(value[c].data());
        from_errors.push_back(errors_[point + c].data());
        to_errors.push_back(error[c].data());
      }
      add_mode_product(w_, w_.rows(), k, from, to);
      add_mode_product(sizes_, w_.rows(), k, from_errors, to_errors);
      for (std::size_t c = 0; c < count; ++c) {
        double sizes = 0;
        for (std::size_t a = 0; a < k; ++a) sizes += (std::abs(value[c][a]) + error[c][a]) * up;
        largest_ = std::max(largest_, sizes * up);
      }
    }
    values_.clear();
    errors_.clear();
  }

  int degree_;
  const Matrix<double>& w_;
  Matrix<double> sizes_;
  std::vector<std::vector<double>> values_;
  std::vector<std::vector<double>> errors_;
  double largest_ = 0;
};

InterpolationBounds make_bounds(int degree) {
  const Matrix<double>& w = ModeTables::instance().interpolation(degree).modes_of_values;
  const std::size_t k = mode_count(degree);
  InterpolationBounds bounds;
  std::vector<BoundedDouble> modes(k);

  LargestSum sum(degree);
  const int steps = std::max(1, steps_a_degree * degree);
  const BoundedDouble step = Constants<BoundedDouble>::pi() / BoundedDouble(2 * steps);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const BoundedDouble theta = BoundedDouble(i) * step;
      const BoundedDouble phi = BoundedDouble(j) * step;
      const BoundedDouble x = sin(theta) * cos(phi);
      const BoundedDouble y = sin(theta) * sin(phi);
      sum.take(barycentric_of<BoundedDouble>({x * x, y * y}));
    }
  // Along a parallel and a meridian every point is within two halves of a step, pi/(2 steps) in all.
  const double cosine = degree == 0 ? 1 : std::cos(std::acos(-1.0) / steps_a_degree) * (1 - 0x1p-40);
  bounds.stored = sum.largest() / cosine * up;

  double largest_row = 0;
  for (const ParameterPoint<double>& node : exact_interpolation_nodes(degree)) {
    const std::size_t a = static_cast<std::size_t>(&node - exact_interpolation_nodes(degree).data());
    triangle_modes<BoundedDouble>(degree, barycentric_of(exactly(node)), modes);
    double row = 0;
    for (std::size_t b = 0; b < k; ++b) {
      BoundedDouble y = a == b ? BoundedDouble(-1) : BoundedDouble(0);
      for (std::size_t n = 0; n < k; ++n) y = y + modes[n] * BoundedDouble::exactly(w(n, b));
      row += upper(y);
    }
    largest_row = std::max(largest_row, row * up);
  }
  expects(largest_row < 0x1p-10, "an inverse of the values at the nodes", named("off by", largest_row));
  bounds.exact = bounds.stored / (1 - largest_row) * up;
  bounds.inverse = largest_row / (1 - largest_row) * up;
  double largest_column = 0;
  for (std::size_t a = 0; a < k; ++a) {
    double squares = 0;
    for (std::size_t n = 0; n < k; ++n) squares += w(n, a) * w(n, a);
    bounds.mean_size.push_back(std::sqrt(squares) * up);
    largest_column = std::max(largest_column, bounds.mean_size.back());
  }
  const double moved = largest_column * static_cast<double>(k) * bounds.inverse * up;
  for (double& size : bounds.mean_size) size = (size + moved) * up;
  return bounds;
}

}  // namespace

const std::vector<ParameterPoint<double>>& exact_interpolation_nodes(int degree) {
  static LazyTable<std::vector<ParameterPoint<double>>, degrees> table;
  expects(0 <= degree && degree <= largest_mode_degree, "0 <= degree <= 22", named("degree", degree));
  return table.at(static_cast<std::size_t>(degree), [degree] { return exact_nodes(degree); });
}

const InterpolationBounds& interpolation_bounds(int degree) {
  static LazyTable<InterpolationBounds, degrees> table;
  expects(0 <= degree && degree <= largest_mode_degree, "0 <= degree <= 22", named("degree", degree));
  return table.at(static_cast<std::size_t>(degree), [degree] { return make_bounds(degree); });
}

}  // namespace radcert
