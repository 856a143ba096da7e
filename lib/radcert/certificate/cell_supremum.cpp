// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/cell_supremum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "radcert/certificate/gauss_rule.h"
#include "radcert/certificate/scene.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/ball.h"

namespace radcert::certificate {
namespace {

constexpr int points_a_node = 8;

/// l_i at the zeros of T_N.
struct LagrangeGrid {
  std::size_t points = 0;
  std::vector<double> values = {};  ///< by point, node
  double error = 0;                 ///< of each of them
  double largest_sum = 0;           ///< of |values| at a point
  double cosine = 0;                ///< of (n-1) pi/(2N), from below
};

LagrangeGrid lagrange_grid(int n) {
  const GaussRule& rule = gauss_rule(n);
  const auto nodes = static_cast<std::size_t>(n);
  LagrangeGrid grid{.points = points_a_node * nodes};
  std::vector<std::vector<Ball>> at_nodes;
  for (const Ball& x : rule.nodes) at_nodes.push_back(legendre(n - 1, x));
  const Ball step = Ball::pi() / Ball(2 * points_a_node * n);
  for (std::size_t a = 0; a < grid.points; ++a) {
    const std::vector<Ball> here = legendre(n - 1, cos(Ball(static_cast<int>(2 * a + 1)) * step));
    double sum = 0;
    for (std::size_t i = 0; i < nodes; ++i) {
      Ball value(0);
      for (std::size_t k = 0; k < nodes; ++k)
        value += Ball(Rational(static_cast<long>(2 * k + 1), 2)) * at_nodes[i][k] * here[k];
      value *= rule.weights[i];
      const double near = value.to_double();
      grid.error = std::max(grid.error, abs(value - Ball(near)).upper_double());
      grid.values.push_back(near);
      sum += std::abs(near);
    }
    grid.largest_sum = std::max(grid.largest_sum, sum * upward);
  }
  grid.cosine = cos(Ball(n - 1) * step).to_double() / upward;
  return grid;
}

const LagrangeGrid& grid_of(int n) {
  static const std::vector<LagrangeGrid> grids = [] {
    std::vector<LagrangeGrid> all;
    for (int count = 1; count <= most_cell_nodes; ++count) all.push_back(lagrange_grid(count));
    return all;
  }();
  return grids[static_cast<std::size_t>(n - 1)];
}

}  // namespace

double interpolation_norm(int n) {
  expects(n >= 1 && n <= most_cell_nodes, "1 <= n <= most_cell_nodes", named("n", n));
  const LagrangeGrid& grid = grid_of(n);
  return (grid.largest_sum + n * grid.error) / grid.cosine * upward;
}

double cell_supremum(std::span<const double> values, double radius, int nodes_s, int nodes_t) {
  expects(nodes_s >= 1 && nodes_s <= most_cell_nodes, "1 <= n_s <= most_cell_nodes", named("n_s", nodes_s));
  expects(nodes_t >= 1 && nodes_t <= most_cell_nodes, "1 <= n_t <= most_cell_nodes", named("n_t", nodes_t));
  const auto n_s = static_cast<std::size_t>(nodes_s);
  const auto n_t = static_cast<std::size_t>(nodes_t);
  expects(values.size() == n_s * n_t, "n_s n_t values", named("values", values.size()));
  const LagrangeGrid& in_s = grid_of(nodes_s);
  const LagrangeGrid& in_t = grid_of(nodes_t);
  double size = 0;
  for (const double x : values) {
    if (!std::isfinite(x)) return std::numeric_limits<double>::infinity();
    size = std::max(size, std::abs(x));
  }
  double largest = 0;
  std::vector<double> line(n_t);
  for (std::size_t a = 0; a < in_s.points; ++a) {
    std::fill(line.begin(), line.end(), 0.0);
    for (std::size_t i = 0; i < n_s; ++i)
      for (std::size_t j = 0; j < n_t; ++j) line[j] += in_s.values[a * n_s + i] * values[i * n_t + j];
    for (std::size_t b = 0; b < in_t.points; ++b) {
      double p = 0;
      for (std::size_t j = 0; j < n_t; ++j) p += in_t.values[b * n_t + j] * line[j];
      largest = std::max(largest, std::abs(p));
    }
  }
  // Radii of the values, errors of the l_i, and n_s + n_t sums and products.
  const double sum_s = in_s.largest_sum + static_cast<double>(nodes_s) * in_s.error;
  const double sum_t = in_t.largest_sum + static_cast<double>(nodes_t) * in_t.error;
  const double of_tables =
      static_cast<double>(nodes_s) * in_s.error * sum_t + static_cast<double>(nodes_t) * in_t.error * sum_s;
  const double of_sums = static_cast<double>(nodes_s + nodes_t + 8) * 0x1p-53 * sum_s * sum_t;
  const double off = sum_s * sum_t * radius + (of_tables + of_sums) * size;
  return (largest + off) / (in_s.cosine * in_t.cosine) * upward;
}

}  // namespace radcert::certificate
