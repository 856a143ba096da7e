// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/chart_growth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "radcert/core/contract.h"
#include "radcert/scalar/ball_precision.h"

namespace radcert {
namespace {

/// Far more than the roundings of the few operations that follow a bound.
constexpr double up = 1 + 0x1p-40;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// From a polydisk to the next.
constexpr double step = 1.25;
/// Polydisks beyond this one are left out: charts that are analytic so far bend too little to matter.
constexpr double farthest_reach = 4096;

/// Lie's norm of a complex vector.
double lie_norm(const ComplexDouble& x, const ComplexDouble& y, const ComplexDouble& z) {
  const Vector<double> u{x.real, y.real, z.real};
  const Vector<double> v{x.imag, y.imag, z.imag};
  return std::sqrt(dot(u, u) + dot(v, v) + 2 * norm(cross(u, v))) * up;
}

bool is_finite(const Vector<TaylorModel>& v) { return v.x.is_finite() && v.y.is_finite() && v.z.is_finite(); }

/// Half the width of a triangle's box, seen from its middle.
double half_width(const std::array<double, 3>& of_vertices, double middle) {
  double half = 0;
  for (const double x : of_vertices) half = std::max(half, std::abs(x - middle) * up);
  return half;
}

}  // namespace

double ChartGrowth::Sizes::from(int m, double q) const {
  double sum = 0;
  for (int k = TaylorModel::highest_degree; k >= m; --k)
    sum += of_order[static_cast<std::size_t>(k)] * std::pow(q, k);
  const double by_coefficients = std::pow(q, m) / (1 - q) * up;
  return (sum + rest * std::min<double>(m + 1, by_coefficients)) * up;
}

ChartGrowth::Sizes ChartGrowth::sizes_of(const TaylorModel& model) {
  Sizes sizes{.rest = model.remainder()};
  for (int k = 0; k <= TaylorModel::highest_degree; ++k)
    for (int i = 0; i <= k; ++i) {
      const ComplexDouble c = model.coefficient(i, k - i);
      sizes.of_order[static_cast<std::size_t>(k)] += std::hypot(c.real, c.imag) * up;
    }
  return sizes;
}

ChartGrowth::Sizes ChartGrowth::sizes_of(const Vector<TaylorModel>& model) {
  Sizes sizes;
  for (int k = 0; k <= TaylorModel::highest_degree; ++k)
    for (int i = 0; i <= k; ++i)
      sizes.of_order[static_cast<std::size_t>(k)] += lie_norm(
          model.x.coefficient(i, k - i), model.y.coefficient(i, k - i), model.z.coefficient(i, k - i));
  sizes.rest =
      std::numbers::sqrt2 * std::hypot(model.x.remainder(), model.y.remainder(), model.z.remainder()) * up;
  return sizes;
}

ChartGrowth::ChartGrowth(const Chart& chart, const ParameterTriangle& triangle) {
  expects(chart.is_known_in_balls(), "a chart that is known in balls", named("chart", chart.facts().name));
  const BallPrecision precision(BallPrecision::default_bits);
  const auto& v = triangle.vertices;
  const std::array<double, 3> s{v[0].s, v[1].s, v[2].s};
  const std::array<double, 3> t{v[0].t, v[1].t, v[2].t};
  const auto [least_s, largest_s] = std::minmax_element(s.begin(), s.end());
  const auto [least_t, largest_t] = std::minmax_element(t.begin(), t.end());
  middle_ = {std::midpoint(*least_s, *largest_s), std::midpoint(*least_t, *largest_t)};
  const double half_s = half_width(s, middle_.s);
  const double half_t = half_width(t, middle_.t);
  const bool is_flat = chart.facts().flat_in().has_value();
  for (double reach = step; reach <= farthest_reach; reach *= step) {
    const Frame<TaylorModel> frame =
        chart.in<TaylorModel>().frame({TaylorModel::variable_u({.real = middle_.s}, reach * half_s * up),
                                       TaylorModel::variable_v({.real = middle_.t}, reach * half_t * up)});
    const TaylorModel area = area_element(frame);
    const Vector<TaylorModel> normal = unit_normal(frame);
    if (!(is_finite(frame.point) && area.is_finite() && is_finite(normal))) break;
    polydisks_.push_back({.reach = reach,
                          .point = sizes_of(frame.point),
                          .normal = is_flat ? Sizes() : sizes_of(normal),
                          .area = sizes_of(area)});
  }
}

double ChartGrowth::limit() const { return polydisks_.empty() ? 0 : polydisks_.back().reach; }

ChartGrowth::Bounds ChartGrowth::at(double g) const {
  Bounds least{.bend = infinity, .turn = infinity, .area = infinity};
  for (const Polydisk& polydisk : polydisks_) {
    if (!(g < polydisk.reach)) continue;
    const double q = g / polydisk.reach;
    least.bend = std::min(least.bend, polydisk.point.from(2, q));
    least.turn = std::min(least.turn, polydisk.normal.from(1, q));
    least.area = std::min(least.area, polydisk.area.from(0, q));
  }
  return least;
}

}  // namespace radcert
