// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/certified/kernel_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/scalar/real.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// More than the roundings of any bound below: each takes fewer than 2^12 operations on positive numbers.
constexpr double up = 1 + 0x1p-40;

}  // namespace

RoundedVector rounded(const Vector<BoundedDouble>& v) {
  const double error =
      std::sqrt(v.x.error() * v.x.error() + v.y.error() * v.y.error() + v.z.error() * v.z.error()) * up +
      std::numeric_limits<double>::min();
  const bool known = std::isfinite(error) && std::isfinite(v.x.value() + v.y.value() + v.z.value());
  if (!known) return {{0, 0, 0}, infinity};
  return {{v.x.value(), v.y.value(), v.z.value()}, error};
}

void KernelRule::begin(int order) {
  order_ = order;
  data_.clear();
  mass_.assign(functions_, 0.0);
  mass_error_.assign(functions_, 0.0);
  position_error_ = 0;
  normal_error_ = 0;
}

void KernelRule::add(const Vector<BoundedDouble>& position, const Vector<BoundedDouble>& normal,
                     std::span<const BoundedDouble> weighted) {
  const RoundedVector at = rounded(position);
  const RoundedVector n = rounded(normal);
  position_error_ = larger_bound(position_error_, at.error);
  normal_error_ = larger_bound(normal_error_, n.error);
  data_.insert(data_.end(), {at.value.x, at.value.y, at.value.z, n.value.x, n.value.y, n.value.z});
  for (std::size_t j = 0; j < functions_; ++j) {
    data_.push_back(weighted[j].value());
    mass_[j] += std::abs(weighted[j].value()) + weighted[j].error();
    mass_error_[j] += weighted[j].error() + std::numeric_limits<double>::min();
  }
}

template <std::size_t Fixed>
[[gnu::always_inline]] inline void KernelRule::take_sums_of(const Points& points, Sums& result) const {
  const std::size_t p = Fixed == 0 ? functions_ : Fixed;
  for (std::size_t j = 0; j < p; ++j) result.sum[j] = Pack(0);
  const Vector<Pack> minus_normal = -points.normal;
  Pack nearest(std::numeric_limits<double>::max());
  Pack cosine_p(0);
  Pack cosine_q(0);
  std::array<Pack, Fixed == 0 ? most_functions : Fixed> row;
  const double* at = data_.data();
  for (int a = 0; a < order_; ++a) {
    for (std::size_t j = 0; j < p; ++j) row[j] = Pack(0);
    for (int b = 0; b < order_; ++b) {
      const Vector<Pack> d{points.position.x - Pack(at[0]), points.position.y - Pack(at[1]),
                           points.position.z - Pack(at[2])};
      const KernelTerms<Pack> g =
          kernel_terms<Pack>(d, minus_normal, {Pack(at[3]), Pack(at[4]), Pack(at[5])});
      const Pack inverse = Pack(1) / g.squared_distance;
      const Pack kernel = g.scaled_value();
      nearest = min(nearest, g.squared_distance);
      cosine_p = max(cosine_p, g.from_p * (g.from_p * inverse));
      cosine_q = max(cosine_q, g.from_q * (g.from_q * inverse));
      for (std::size_t j = 0; j < p; ++j) row[j] = fma(kernel, Pack(at[geometry + j]), row[j]);
      at += geometry + p;
    }
    for (std::size_t j = 0; j < p; ++j) result.sum[j] += row[j];
  }
  result.nearest = nearest;
  result.cosine_p = cosine_p;
  result.cosine_q = cosine_q;
}

void KernelRule::take_sums(const Points& points, Sums& sums) const {
  switch (functions_) {
    case 1: return take_sums_of<1>(points, sums);
    case 2: return take_sums_of<2>(points, sums);
    case 3: return take_sums_of<3>(points, sums);
    case 4: return take_sums_of<4>(points, sums);
    case 6: return take_sums_of<6>(points, sums);
    case 7: return take_sums_of<7>(points, sums);
    default: return take_sums_of<0>(points, sums);
  }
}

void KernelRule::rounding(const Sums& sums, std::size_t lane, const PointErrors& points,
                          std::span<double> error) const {
  const double displaced = (position_error_ + points.position) * up;
  // The computed r is off by displaced, and by less than 4 u of itself.
  const double least = std::sqrt(sums.nearest.lane(lane)) * (1 - 8 * unit) - displaced;
  constexpr double small = 1e-4;  // so that products of errors are within the slack
  constexpr double slack = 1 + 8 * small;
  if (!(least > 0) || !(displaced < small * least)) {
    std::fill(error.begin(), error.end(), infinity);
    return;
  }
  const double delta = displaced / least * up + 2 * unit;
  const double theta_p = (delta + points.normal + 4 * unit) * slack;
  const double theta_q = (delta + normal_error_ + 4 * unit) * slack;
  const double c_p = std::sqrt(sums.cosine_p.lane(lane)) * slack + theta_p;
  const double c_q = std::sqrt(sums.cosine_q.lane(lane)) * slack + theta_q;
  const double relative = 2 * (2 * delta + 4 * unit) + unit * (9 + 2 * order_);
  const double inverse = 1 / (least * least) * up;
  const double of_mass =
      (theta_p * c_q + theta_q * c_p + theta_p * theta_q + c_p * c_q * relative) * inverse * slack;
  const double of_mass_error = c_p * c_q * inverse * slack;
  for (std::size_t j = 0; j < functions_; ++j)
    error[j] = (of_mass * mass_[j] + of_mass_error * mass_error_[j]) * up;
}

}  // namespace radcert
