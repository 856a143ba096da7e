// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <vector>

#include "radcert/enclosure/square_integral.h"
#include "radcert/geometry/vector.h"

namespace radcert {

/// A convex polygon of a parameter plane by its corners, in order of either sense.
using ParameterPolygon = std::vector<ParameterPoint<Rational>>;

/// A piece of a polygon as the image of the unit square.
/// Maths     (s,t) = apex + x (first + y along), a triangle with the side apex squeezed to a point: Jacobian
///           x |first x along|; or, where `parallelogram`, apex + x first + y along: Jacobian |first x along|
/// Source    Duffy's map
/// Requires  first x along != 0
/// Result    exact
struct SquareMap {
  ParameterPoint<Rational> apex;
  ParameterPoint<Rational> first;
  ParameterPoint<Rational> along;
  bool parallelogram = false;
};

/// The triangles from a point of a convex polygon to its sides; sides through the point have none.
/// ContractViolation where the polygon is not convex, the point not in it, or there is no area.
[[nodiscard]] std::vector<SquareMap> fan(const ParameterPolygon& polygon,
                                         const ParameterPoint<Rational>& apex);
/// One parallelogram, where the polygon is one; else the fan from its first corner.
[[nodiscard]] std::vector<SquareMap> square_maps(const ParameterPolygon& polygon);

/// A map in one arithmetic.
template <Real R>
struct SquareMapIn {
  explicit SquareMapIn(const SquareMap& map)
      : apex(in(map.apex)),
        first(in(map.first)),
        along(in(map.along)),
        determinant(from_rational<R>(abs(cross(map.first, map.along)))),
        parallelogram(map.parallelogram),
        smallest(in(smallest_of(map))) {}

  /// Where a triangle: the point is apex + x direction(y).
  ParameterPoint<R> direction(const R& y) const { return first + y * along; }
  ParameterPoint<R> point(const R& x, const R& y) const {
    const ParameterPoint<R> at = parallelogram ? apex + x * first + y * along : apex + x * direction(y);
    return {within(at.s, smallest.s), within(at.t, smallest.t)};
  }
  R jacobian(const R& x) const { return parallelogram ? determinant : x * determinant; }

  static ParameterPoint<R> in(const ParameterPoint<Rational>& p) {
    return {from_rational<R>(p.s), from_rational<R>(p.t)};
  }

  ParameterPoint<R> apex;
  ParameterPoint<R> first;
  ParameterPoint<R> along;
  R determinant;
  bool parallelogram;
  ParameterPoint<R> smallest;  ///< of the image's coordinates

private:
  static ParameterPoint<Rational> smallest_of(const SquareMap& map) {
    ParameterPoint<Rational> smallest = map.apex;
    const auto include = [&smallest](const ParameterPoint<Rational>& p) {
      smallest = {std::min(smallest.s, p.s), std::min(smallest.t, p.t)};
    };
    include(map.apex + map.first);
    include(map.apex + map.first + map.along);
    if (map.parallelogram) include(map.apex + map.along);
    return smallest;
  }
  /// A wide ball that rounding has taken below the smallest value is brought back: s = 0 may be where a root
  /// ends.
  static R within(const R& coordinate, const R& least) {
    if constexpr (std::same_as<R, Ball>) {
      if (!certainly_at_most(least, coordinate))
        return hull(max(coordinate.lower(), least), coordinate.upper());
    }
    return coordinate;
  }
};

/// The integral of a function over a convex polygon, enclosed.
/// Maths     Int f(s,t) ds dt
/// Source    integral_over_squares
/// Requires  three corners or more, not all on a line, else ContractViolation; f a class with
///           template <class R> R operator()(const ParameterPoint<R>& at) const;  for R = Ball, TaylorModel,
///           real for real arguments
/// Result    see integral_over_squares
/// Limits    see integral_over_squares
template <class Formula>
[[nodiscard]] Enclosure integral_over_polygon(const Formula& f, const ParameterPolygon& polygon,
                                              const Demand& demand) {
  std::vector<SquareFunction> functions;
  for (const SquareMap& map : square_maps(polygon)) {
    functions.push_back(
        {.in_balls = [f, in = SquareMapIn<Ball>(map)](
                         const Ball& x, const Ball& y) { return in.jacobian(x) * f(in.point(x, y)); },
         .in_models = [f, in = SquareMapIn<TaylorModel>(map)](
                          const TaylorModel& x,
                          const TaylorModel& y) { return in.jacobian(x) * f(in.point(x, y)); }});
  }
  return integral_over_squares(functions, demand);
}

}  // namespace radcert
