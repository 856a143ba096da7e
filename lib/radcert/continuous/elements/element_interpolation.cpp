// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/element_interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/lagrange_table.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/core/contract.h"

namespace radcert {
namespace {

/// (2i+1)/2 w_m P_i(x_m), by i, m.
std::vector<double> to_coefficients(int nodes) {
  const IntervalRule<double>& rule = gauss_on_interval(nodes);
  const std::size_t n = rule.nodes.size();
  std::vector<double> out(n * n);
  std::vector<double> values(n);
  for (std::size_t m = 0; m < n; ++m) {
    legendre_values<double>(rule.nodes[m], values);
    for (std::size_t i = 0; i < n; ++i)
      out[i * n + m] = (static_cast<double>(i) + 0.5) * rule.weights[m] * values[i];
  }
  return out;
}

}  // namespace

ElementInterpolation::ElementInterpolation(int nodes_s, int nodes_t)
    : nodes_s_(static_cast<std::size_t>(nodes_s)),
      nodes_t_(static_cast<std::size_t>(nodes_t)),
      in_s_(to_coefficients(nodes_s)),
      in_t_(to_coefficients(nodes_t)) {}

std::vector<Vector<double>> ElementInterpolation::points(const Sector& sector, const SectorBox& box) const {
  std::vector<Vector<double>> out;
  for (const double x : gauss_on_interval(static_cast<int>(nodes_s_)).nodes)
    for (const double y : gauss_on_interval(static_cast<int>(nodes_t_)).nodes)
      out.push_back(sector.point(box.middle_s() + 0.5 * (box.s1 - box.s0) * x,
                                 box.middle_t() + 0.5 * (box.t1 - box.t0) * y));
  return out;
}

void ElementInterpolation::coefficients(std::span<const double> values, std::size_t stride,
                                        std::span<double> out) const {
  std::vector<double> half(nodes_s_ * nodes_t_);
  for (std::size_t m = 0; m < nodes_s_; ++m)
    for (std::size_t j = 0; j < nodes_t_; ++j) {
      double sum = 0;
      for (std::size_t l = 0; l < nodes_t_; ++l)
        sum += in_t_[j * nodes_t_ + l] * values[(m * nodes_t_ + l) * stride];
      half[m * nodes_t_ + j] = sum;
    }
  for (std::size_t i = 0; i < nodes_s_; ++i)
    for (std::size_t j = 0; j < nodes_t_; ++j) {
      double sum = 0;
      for (std::size_t m = 0; m < nodes_s_; ++m) sum += in_s_[i * nodes_s_ + m] * half[m * nodes_t_ + j];
      out[i * nodes_t_ + j] = sum;
    }
}

double ElementInterpolation::rounding(double size, double off) const {
  const auto n = static_cast<double>(nodes_s_);
  const auto m = static_cast<double>(nodes_t_);
  const double k = n > m ? n : m;
  return n * n * m * m * (64 * k * k * unit_roundoff<double>() * size + off) * upward;
}

double lebesgue_constant(int nodes) {
  expects(nodes >= 1 && nodes <= most_gauss_nodes, "1 <= nodes <= most_gauss_nodes", named("nodes", nodes));
  static const std::array<double, most_gauss_nodes + 1> table = [] {
    std::array<double, most_gauss_nodes + 1> made{};
    for (int n = 1; n <= most_gauss_nodes; ++n) {
      const double step = std::numbers::pi / (8 * n);
      double largest = 0;
      for (int k = 0; k <= 8 * n; ++k)
        largest = std::max(largest, LagrangeTable(n, {.middle = std::cos(k * step), .half = 0}, 1).largest());
      made[static_cast<std::size_t>(n)] = largest / std::cos(0.5 * (n - 1) * step) * upward;
    }
    return made;
  }();
  return table[static_cast<std::size_t>(nodes)];
}

namespace {

constexpr std::size_t parts = 4;
constexpr std::size_t most_powers = most_gauss_nodes;

/// A_ik of each part of [-1,1], k <= i.
using PartTable = std::array<std::array<std::array<double, most_powers>, most_powers>, parts>;
const PartTable& part_table() {
  static const PartTable table = [] {
    PartTable made{};
    const IntervalRule<double>& rule = gauss_on_interval(most_gauss_nodes);
    std::vector<double> whole(most_powers);
    std::vector<double> own(most_powers);
    for (std::size_t part = 0; part < parts; ++part)
      for (std::size_t m = 0; m < rule.nodes.size(); ++m) {
        legendre_values<double>(rule.nodes[m], own);
        legendre_values<double>(-1 + (static_cast<double>(2 * part + 1) + rule.nodes[m]) / parts, whole);
        for (std::size_t i = 0; i < most_powers; ++i)
          for (std::size_t k = 0; k <= i; ++k)
            made[part][i][k] += (static_cast<double>(k) + 0.5) * rule.weights[m] * whole[i] * own[k];
      }
    return made;
  }();
  return table;
}

}  // namespace

double supremum(std::span<const double> coefficients, std::size_t of_x, std::size_t of_y) {
  expects(of_x <= most_powers && of_y <= most_powers && coefficients.size() == of_x * of_y,
          "coefficients by powers up to most_gauss_nodes", named("coefficients", coefficients.size()));
  double size = 0;
  for (const double c : coefficients) size += std::abs(c);
  double largest = 0;
  std::vector<double> half(of_x * of_y);
  for (const auto& in_x : part_table()) {
    std::fill(half.begin(), half.end(), 0.0);
    for (std::size_t i = 0; i < of_x; ++i)
      for (std::size_t k = 0; k <= i; ++k)
        for (std::size_t j = 0; j < of_y; ++j) half[k * of_y + j] += in_x[i][k] * coefficients[i * of_y + j];
    for (const auto& in_y : part_table()) {
      double sum = 0;
      for (std::size_t k = 0; k < of_x; ++k) {
        std::array<double, most_powers> own{};
        for (std::size_t j = 0; j < of_y; ++j)
          for (std::size_t l = 0; l <= j; ++l) own[l] += in_y[j][l] * half[k * of_y + j];
        for (const double c : own) sum += std::abs(c);
      }
      largest = std::max(largest, sum);
    }
  }
  // Errors of A in one and in both variables, with n sums and products in either.
  const auto n = static_cast<double>(std::max(of_x, of_y));
  const double of_table = n * n * (20 * n * n + 64) * unit_roundoff<double>();
  const double off =
      2 * n * n * of_table + of_table * of_table + n * n * n * n * 2 * (n + 2) * unit_roundoff<double>();
  return std::min(size, largest + off * size) * upward;
}

}  // namespace radcert
