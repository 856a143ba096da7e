// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/element_interpolation.h"

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/tensor_legendre.h"

namespace radcert {

ElementInterpolation::ElementInterpolation(int nodes)
    : nodes_(static_cast<std::size_t>(nodes)), to_coefficients_(nodes_ * nodes_) {
  const IntervalRule<double>& rule = gauss_on_interval(nodes);
  std::vector<double> values(nodes_);
  for (std::size_t m = 0; m < nodes_; ++m) {
    legendre_values<double>(rule.nodes[m], values);
    for (std::size_t i = 0; i < nodes_; ++i)
      to_coefficients_[i * nodes_ + m] = (static_cast<double>(i) + 0.5) * rule.weights[m] * values[i];
  }
}

std::vector<Vector<double>> ElementInterpolation::points(const Sector& sector, const SectorBox& box) const {
  const IntervalRule<double>& rule = gauss_on_interval(static_cast<int>(nodes_));
  std::vector<Vector<double>> out;
  for (const double x : rule.nodes)
    for (const double y : rule.nodes)
      out.push_back(sector.point(box.middle_s() + 0.5 * (box.s1 - box.s0) * x,
                                 box.middle_t() + 0.5 * (box.t1 - box.t0) * y));
  return out;
}

void ElementInterpolation::coefficients(std::span<const double> values, std::size_t stride,
                                        std::span<double> out) const {
  std::vector<double> half(nodes_ * nodes_);
  for (std::size_t m = 0; m < nodes_; ++m)
    for (std::size_t j = 0; j < nodes_; ++j) {
      double sum = 0;
      for (std::size_t l = 0; l < nodes_; ++l)
        sum += to_coefficients_[j * nodes_ + l] * values[(m * nodes_ + l) * stride];
      half[m * nodes_ + j] = sum;
    }
  for (std::size_t i = 0; i < nodes_; ++i)
    for (std::size_t j = 0; j < nodes_; ++j) {
      double sum = 0;
      for (std::size_t m = 0; m < nodes_; ++m) sum += to_coefficients_[i * nodes_ + m] * half[m * nodes_ + j];
      out[i * nodes_ + j] = sum;
    }
}

double ElementInterpolation::rounding(double size, double off) const {
  const auto n = static_cast<double>(nodes_);
  return n * n * n * n * (64 * n * n * unit_roundoff<double>() * size + off) * upward;
}

}  // namespace radcert
