// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>

#include "radcert/geometry/vector.h"
#include "radcert/surface/surface_point.h"

namespace radcert::reference {

/// Points of one chart, side by side: point i has the parameters s[i], t[i] and the coordinates x[i], y[i],
/// z[i].
/// Maths     (x, y, z)[i] = F_chart(s[i], t[i])
/// Requires  spans of one length
/// Result    holds what it is given
/// Limits    the coordinates are rounded, and on a flat chart those of its rounded coefficients
struct PointBlock {
  std::size_t chart;
  std::span<const double> s;
  std::span<const double> t;
  std::span<const double> x;
  std::span<const double> y;
  std::span<const double> z;

  std::size_t size() const { return s.size(); }
};

/// A density u on a surface, from a function of a block of points or from one of a single point.
/// Maths     values[i] = u at point i, given both by its parameters and by its coordinates
/// Requires  a function void(PointBlock, values) or double(SurfacePoint, coordinates); safe to call from
///           several threads where the integrals are
/// Result    values in the order of the points
/// Limits    a function of a single point costs a call a point
class Density {
public:
  using OfBlock = std::function<void(const PointBlock& points, std::span<double> values)>;

  Density() = default;
  template <std::invocable<const PointBlock&, std::span<double>> Function>
  Density(Function of_block) : of_block_(std::move(of_block)) {}  // NOLINT(google-explicit-constructor)
  template <std::invocable<const SurfacePoint<double>&, const Vector<double>&> Function>
  Density(Function of_point)  // NOLINT(google-explicit-constructor)
      : of_block_([of_point = std::move(of_point)](const PointBlock& points, std::span<double> values) {
          for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = of_point(SurfacePoint<double>{points.chart, {points.s[i], points.t[i]}},
                                 Vector<double>{points.x[i], points.y[i], points.z[i]});
        }) {}

  explicit operator bool() const { return static_cast<bool>(of_block_); }
  void operator()(const PointBlock& points, std::span<double> values) const { of_block_(points, values); }
  double operator()(const SurfacePoint<double>& q, const Vector<double>& point) const {
    double value = 0;
    of_block_({q.chart, {&q.at.s, 1}, {&q.at.t, 1}, {&point.x, 1}, {&point.y, 1}, {&point.z, 1}},
              {&value, 1});
    return value;
  }

private:
  OfBlock of_block_;
};

}  // namespace radcert::reference
