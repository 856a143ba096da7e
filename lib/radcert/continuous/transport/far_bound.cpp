// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/far_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/continuous/elements/analytic_error.h"
#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/transport/source_rule.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = unit_roundoff<double>();
/// a/D. n nodes leave about (2 a/h)^-n (D-a)^-3, which is least near n/(n+3).
constexpr double part_of_distance = 0.75;

}  // namespace

FarBound::FarBound(double distance, double half, double height, double mass) {
  const double reach = part_of_distance * distance;
  const double axis = reach / half;
  if (!(axis > 2)) {
    most_ = slope_ = infinity;
    return;
  }
  rho_ = (axis + std::sqrt(axis * axis - 1)) / upward;
  most_ = mass * kernel_in_ellipse(distance, reach, height) * upward;
  slope_ = mass * kernel_in_ellipse(distance, 2 * half, height) * upward;
}

double FarBound::of_polynomials(int nodes) const {
  if (most_ == 0 || !(most_ < infinity)) return most_;
  return polynomial_error_factor(nodes, rho_) * most_ * upward;
}

int FarBound::needed(double allowed) const {
  if (most_ == 0) return 1;
  if (!(most_ < infinity)) return most_gauss_nodes + 1;
  // Interpolation multiplies it by (1+l) l, about.
  constexpr double of_interpolation = 20;
  const double needed = 1 + std::log(2 * of_interpolation * most_ / ((rho_ - 1) * allowed)) / std::log(rho_);
  return needed <= most_gauss_nodes ? static_cast<int>(std::ceil(std::max(needed, 1.0)))
                                    : most_gauss_nodes + 1;
}

void FarError::add(const FarBound& of_s, const FarBound& of_t, int nodes_s, int nodes_t) {
  in_s += of_s.of_polynomials(nodes_s);
  in_t += of_t.of_polynomials(nodes_t);
  slope += of_s.of_slope() + of_t.of_slope();
  ++parts;
}

double FarError::of_interpolant(const LagrangeTable& table_s, const LagrangeTable& table_t, double off,
                                double size) const {
  const double l_s = table_s.largest();
  const double l_t = table_t.largest();
  const double roundings = 8 * static_cast<double>(table_s.nodes() + table_t.nodes()) * unit;
  const double added = 1 + 2 * static_cast<double>(parts) * unit;
  return (((1 + l_s) * in_s + l_s * (1 + l_t) * in_t + 16 * unit * slope) * added +
          l_s * l_t * (off + roundings * (size + off))) *
         upward;
}

}  // namespace radcert
