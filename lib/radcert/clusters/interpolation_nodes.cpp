// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/interpolation_nodes.h"

#include <array>
#include <cmath>
#include <numbers>

#include "radcert/core/contract.h"
#include "radcert/polynomial/triangle_modes.h"

namespace radcert {
namespace {

/// The n + 1 Gauss-Lobatto-Legendre points of [0,1], ascending: its ends and the zeros of P_n', by Newton's
/// method from the points of Chebyshev; one half for n = 0.
std::vector<long double> lobatto_points(int n) {
  if (n == 0) return {0.5L};
  std::vector<long double> points;
  for (int k = 0; k <= n; ++k) {
    long double z = -std::cos(std::numbers::pi_v<long double> * k / n);
    constexpr int steps = 12;
    for (int step = 0; step < steps && k > 0 && k < n; ++step) {
      long double before = 1;
      long double now = z;
      for (int m = 1; m < n; ++m) {
        const long double next = ((2 * m + 1) * z * now - m * before) / (m + 1);
        before = now;
        now = next;
      }
      // (1 - z^2) P' = n (P_(n-1) - z P_n) and (1 - z^2) P'' = 2 z P' - n (n+1) P_n.
      const long double first = n * (before - z * now) / (1 - z * z);
      const long double second = (2 * z * first - static_cast<long double>(n) * (n + 1) * now) / (1 - z * z);
      z -= first / second;
    }
    points.push_back((1 + z) / 2);
  }
  points.front() = 0;
  points.back() = 1;
  return points;
}

}  // namespace

std::vector<Barycentric<double>> interpolation_nodes(int degree) {
  expects(0 <= degree && degree <= largest_mode_degree, "0 <= degree <= 22", named("degree", degree));
  std::vector<std::vector<long double>> g;
  for (int n = 0; n <= degree; ++n) g.push_back(lobatto_points(n));
  const auto point = [&g](int n, int k) {
    return g[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
  };
  std::vector<Barycentric<double>> nodes;
  for (int first = degree; first >= 0; --first)
    for (int second = degree - first; second >= 0; --second) {
      const std::array<int, 3> a{first, second, degree - first - second};
      std::array<long double, 3> sum{};
      long double weights = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const int rest = degree - a[i];
        const long double weight = point(degree, rest);
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        sum[j] += weight * point(rest, a[j]);
        sum[k] += weight * point(rest, a[k]);
        weights += weight;
      }
      Barycentric<double> node;
      for (std::size_t i = 0; i < 3; ++i) node.x[i] = static_cast<double>(sum[i] / weights);
      nodes.push_back(node);
    }
  return nodes;
}

}  // namespace radcert
