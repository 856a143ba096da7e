// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/transfer_matrix.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/solve/product.h"

namespace radcert {
namespace {

/// A square of 64 by 64 entries and its mirror image stay in the first-level cache: 64 KiB together.
constexpr std::size_t tile = 64;

double largest(std::span<const double> x) {
  double size = 0;
  for (const double value : x) size = std::max(size, std::abs(value));
  return size;
}

}  // namespace

double site_kernel(const Site<double>& p, const Site<double>& q) {
  const KernelTerms<double> g = kernel_terms<double>(p.point - q.point, -p.normal, q.normal);
  return g.from_p > 0 && g.from_q > 0 ? g.scaled_value() : 0;
}

MemoryPlan transfer_memory(std::size_t sites, std::size_t matrices) {
  MemoryPlan plan;
  plan.add("transfer matrices of " + std::to_string(sites) + " sites", static_cast<std::uint64_t>(matrices),
           static_cast<std::uint64_t>(sites) * sites * sizeof(double));
  return plan;
}

Matrix<double> point_light_transfer(const LightScene& scene, const SiteSet& sites,
                                    std::span<const double> weights) {
  std::vector<double> albedos;
  for (const SurfacePoint<double>& at : sites.at) {
    expects(at.chart < scene.surface().chart_count(), "sites of the scene's surface",
            named("chart", at.chart));
    albedos.push_back(scene.albedo(at.chart));
  }
  return point_light_transfer(scene, sites, albedos, weights);
}

Matrix<double> point_light_transfer(const LightScene& scene, const SiteSet& sites,
                                    std::span<const double> albedos, std::span<const double> weights) {
  const std::size_t n = sites.size();
  expects(weights.size() == n && albedos.size() == n, "a weight and an albedo for each site",
          named("weights", weights.size()), named("albedos", albedos.size()), named("sites", n));
  for (const SurfacePoint<double>& at : sites.at)
    expects(at.chart < scene.surface().chart_count(), "sites of the scene's surface",
            named("chart", at.chart));
  transfer_memory(n, 1).require(available_memory());
  Matrix<double> matrix = Matrix<double>::uninitialised(n, n);
  constexpr double constant = std::numbers::inv_pi;

  const auto fill = [&](std::size_t rows, std::size_t columns) {
    const std::size_t last_row = std::min(n, (rows + 1) * tile);
    const std::size_t last_column = std::min(n, (columns + 1) * tile);
    for (std::size_t j = columns * tile; j < last_column; ++j) {
      const LitPoint q{.site = sites[j], .chart = sites.at[j].chart};
      for (std::size_t i = rows * tile; i < last_row; ++i) {
        if (i > j) break;
        const LitPoint p{.site = sites[i], .chart = sites.at[i].chart};
        double kernel = i == j ? 0 : site_kernel(p.site, q.site);
        if (kernel > 0 && !scene.visible(p, q)) kernel = 0;
        matrix(i, j) = constant * albedos[i] * kernel * weights[j];
        matrix(j, i) = constant * albedos[j] * kernel * weights[i];
      }
    }
  };
  // Pairs of tiles with the first not behind the second, column after column.
  const std::size_t tiles = (n + tile - 1) / tile;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  pairs.reserve(tiles * (tiles + 1) / 2);
  for (std::size_t column = 0; column < tiles; ++column)
    for (std::size_t row = 0; row <= column; ++row) pairs.emplace_back(row, column);
  parallel_for(pairs.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) fill(pairs[k].first, pairs[k].second);
  });
  return matrix;
}

TransferSums transfer_sums(const Matrix<double>& r) {
  const std::size_t n = r.rows();
  expects(n > 0 && r.columns() == n, "a square matrix", named("rows", n), named("columns", r.columns()));
  TransferSums sums;
  for (std::size_t j = 0; j < n; ++j) sums.largest_entry = std::max(sums.largest_entry, largest(r.column(j)));
  expects(std::isfinite(sums.largest_entry), "finite entries", named("largest", sums.largest_entry));
  std::vector<double> x(n, 1.0);
  std::vector<double> image(n);
  multiply(r, x, image);
  for (std::size_t i = 0; i < n; ++i)
    if (std::abs(image[i]) > sums.largest_row_sum) {
      sums.largest_row_sum = std::abs(image[i]);
      sums.row = i;
    }
  // Constants may be an eigenvector: multiples of the golden section, modulo 1, are far from every smooth
  // one.
  for (std::size_t i = 0; i < n; ++i) {
    const double multiple = std::numbers::phi * static_cast<double>(i);
    x[i] = 0.5 + multiple - std::floor(multiple);
  }
  constexpr int steps = 30;
  constexpr int counted = 10;
  double logarithm = 0;
  for (int step = 0; step < steps; ++step) {
    multiply(r, x, image);
    const double growth = largest(image);
    if (growth == 0) return sums;
    if (step >= steps - counted) logarithm += std::log(growth);
    for (std::size_t i = 0; i < n; ++i) x[i] = image[i] / growth;
  }
  sums.spectral_radius = std::exp(logarithm / counted);
  return sums;
}

}  // namespace radcert
