// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/rounding/euclidean_norm.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/solve/rounding/rounding.h"

namespace radcert {
namespace {

/// ||2^-exponent a||.
double scaled_norm(std::span<const double> a, int exponent) {
  double sum = 0;
  for (const double value : a) {
    const double scaled = std::ldexp(value, -exponent);
    sum += scaled * scaled;
  }
  return std::sqrt(sum);
}

}  // namespace

int binary_exponent(std::span<const double> a) {
  double largest = 0;
  for (const double value : a) {
    if (!std::isfinite(value)) return 0;
    largest = std::max(largest, std::abs(value));
  }
  return largest > 0 ? std::ilogb(largest) : 0;
}

double euclidean_norm(std::span<const double> a) {
  const int exponent = binary_exponent(a);
  return std::ldexp(scaled_norm(a, exponent), exponent);
}

double euclidean_norm_from_above(std::span<const double> a) {
  const int exponent = binary_exponent(a);
  return scaled_from_above(scaled_norm(a, exponent) * upward_of_sums(a.size() + 2), exponent);
}

double scaled_from_above(double x, int exponent) {
  const double y = std::ldexp(x, exponent);
  // Back again is exact, since y has no more digits than x.
  return std::ldexp(y, -exponent) < x ? y + std::numeric_limits<double>::denorm_min() : y;
}

}  // namespace radcert
