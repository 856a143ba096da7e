// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_transfers.h"

#include <algorithm>
#include <optional>

#include "radcert/clusters/cluster_points.h"
#include "radcert/clusters/mode_products.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/triangle_modes.h"

namespace radcert {
namespace {

/// The coordinates of a point in a triangle of its plane.
Barycentric<double> coordinates_in(const ParameterTriangle& triangle, const ParameterPoint<double>& p) {
  const auto& [a, b, c] = triangle.vertices;
  const double whole = cross(b - a, c - a);
  const double at_b = cross(p - a, c - a) / whole;
  const double at_c = cross(b - a, p - a) / whole;
  return {{1 - at_b - at_c, at_b, at_c}};
}

double share_of(const ParameterTriangle& part, const ParameterTriangle& whole) {
  return parameter_area(part) / parameter_area(whole);
}

/// The tables of a leaf from those of one element.
LeafTables leaf_tables(const ClusterTree& tree, std::size_t leaf, const LeafTables& of_element, int degree) {
  const ParameterTriangle& frame = tree.leaves()[leaf];
  const std::size_t elements = tree.elements_of_leaf();
  const std::size_t p = of_element.unknowns;
  const std::size_t modes = mode_count(degree);
  LeafTables out(elements * p, degree);
  out.moments_of_one.assign(padded<double>(modes), 0.0);
  for (std::size_t k = 0; k < elements; ++k) {
    const ParameterTriangle element = tree.element(leaf * elements + k);
    const ModeTransfer transfer(frame, element, degree);
    for (std::size_t n = 0; n < modes; ++n) {
      // The mean over the element is that times D_0 = 1.
      out.moments_of_one[n] += transfer.up(n, 0);
      for (std::size_t j = 0; j < p; ++j)
        for (std::size_t m = 0; m < modes; ++m) {
          out.moments(n, k * p + j) += transfer.up(n, m) * of_element.moments(m, j);
          out.absolute_moments(n, k * p + j) += transfer.up(n, m) * of_element.absolute_moments(m, j);
          out.values(k * p + j, n) += of_element.values(j, m) * transfer.down(m, n);
        }
    }
  }
  return out;
}

}  // namespace

ModeTransfer::ModeTransfer(const ParameterTriangle& from, const ParameterTriangle& to, int degree) {
  const ModeInterpolation& interpolation = ModeTables::instance().interpolation(degree);
  const std::size_t modes = mode_count(degree);
  const std::size_t rows = padded<double>(modes);
  Matrix<double> values(modes, modes);
  std::vector<double> at_node(modes);
  for (std::size_t a = 0; a < modes; ++a) {
    triangle_modes<double>(degree, coordinates_in(from, to.at(interpolation.nodes[a].x)), at_node);
    for (std::size_t n = 0; n < modes; ++n) values(a, n) = at_node[n];
  }
  down = Matrix<double>(rows, modes);
  std::vector<const double*> x;
  std::vector<double*> y;
  for (std::size_t n = 0; n < modes; ++n) {
    x.push_back(values.column(n).data());
    y.push_back(down.column(n).data());
  }
  add_mode_product(interpolation.modes_of_values, rows, modes, x, y);
  up = Matrix<double>(rows, modes);
  const double share = share_of(to, from);
  for (std::size_t n = 0; n < modes; ++n)
    for (std::size_t m = 0; m < modes; ++m) up(n, m) = share * down(m, n);
}

ClusterTransfers::ClusterTransfers(const ClusterTree& tree, const TriangleBasis<double>& basis,
                                   std::span<const int> degrees)
    : is_uniform_(tree.is_uniform()) {
  const int degree = std::max(0, degrees.back());
  if (is_uniform_) {
    leaves_.emplace_back(basis, tree.refinements(), degree);
    return;
  }
  transfers_.resize(tree.levels());
  for (std::size_t l = 1; l < tree.levels(); ++l) {
    if (degrees[l - 1] < 0) continue;
    const std::vector<ParameterTriangle>& clusters = tree.level(l);
    std::vector<std::optional<ModeTransfer>> found(clusters.size());
    parallel_for(clusters.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        found[i].emplace(tree.level(l - 1)[i / 4], clusters[i], degrees[l - 1]);
    });
    for (std::optional<ModeTransfer>& each : found) transfers_[l].push_back(*std::move(each));
  }
  const LeafTables of_element(basis, 0, degree);
  std::vector<std::optional<LeafTables>> found(tree.leaves().size());
  parallel_for(found.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i].emplace(leaf_tables(tree, i, of_element, degree));
  });
  for (std::optional<LeafTables>& each : found) leaves_.push_back(*std::move(each));
}

void ClusterTransfers::count(MemoryPlan& plan) const {
  if (is_uniform_) return;
  std::size_t numbers = 0;
  for (const auto& level : transfers_)
    for (const ModeTransfer& each : level) numbers += 2 * each.up.rows() * each.up.columns();
  for (const LeafTables& each : leaves_)
    numbers += 2 * each.moments.rows() * each.moments.columns() + each.values.rows() * each.values.columns();
  plan.add("matrices between clusters", numbers, sizeof(double));
}

}  // namespace radcert
