// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/element_interpolation.h"

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/tensor_legendre.h"

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

}  // namespace radcert
