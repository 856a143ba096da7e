// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "radcert/expression/expression.h"
#include "radcert/geometry/plane_polygon.h"
#include "radcert/geometry/vector.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A plane chart, known exactly.
/// Maths     F(s,t) = origin + s first + t second
/// Source    the formula of the chart in exact arithmetic, or the vertices of the mesh
/// Requires  made by plane_chart
/// Result    exact
struct PlaneChart {
  Vector<Rational> origin;
  Vector<Rational> first;
  Vector<Rational> second;
  Orientation orientation = Orientation::along_the_cross_product;

  Vector<Rational> point(const ParameterPoint<Rational>& at) const {
    return origin + at.s * first + at.t * second;
  }
  /// Of the direction of the inner normal, not of unit length.
  Vector<Rational> normal() const;
  /// The part over a triangle of the parameter plane, as the chart with the corners v_1, v_2, v_3 at (0,0),
  /// (1,0), (0,1).
  PlaneChart over(const std::array<ParameterPoint<Rational>, 3>& v) const;
};

/// The exact formula of a chart.
/// Maths     (F(0,0), F(1,0), F(0,1)) of an affine F give its three vectors
/// Source    ExactImage, or the vertices of a mesh
/// Requires  a chart of the surface, else ContractViolation
/// Result    exact; nothing where the chart is not affine or its formula is not known in exact arithmetic
std::optional<PlaneChart> plane_chart(const Surface& surface, std::size_t chart);

/// A part of a plane chart as a polygon, and a function of the chart's parameters as one of the polygon's.
/// Maths     the polygon over `loop`; its parameters are (s,t), or (t,s) where the chart's orientation is
///           against the cross product: its normal is the inner one
/// Requires  a loop that plane_polygon takes, else ContractViolation
/// Result    exact
PlanePolygon polygon_of(const PlaneChart& chart, PolygonLoop loop);
PlanePolynomial<Rational> on_polygon_of(const PlaneChart& chart, const PlanePolynomial<Rational>& q);

/// An expression on a plane as a polynomial of the parameters, where it is one.
/// Maths     (s,t) -> f(origin + s first + t second)
/// Source    the tree of the expression, node by node: numbers, variables, + - * and whole powers, and
///           division by what is constant on the plane
/// Requires  an expression in x, y, z; 0 <= largest_degree, else ContractViolation
/// Result    exact; nothing where the tree has another operation, divides by zero or exceeds the degree on
///           the way
/// Limits    no simplification: x^9 - x^9 is of degree 9. With first = second = 0 it is the exact value at a
///           point
std::optional<PlanePolynomial<Rational>> polynomial_on_plane(const Expression& f,
                                                             const Vector<Rational>& origin,
                                                             const Vector<Rational>& first,
                                                             const Vector<Rational>& second,
                                                             int largest_degree);

}  // namespace radcert
