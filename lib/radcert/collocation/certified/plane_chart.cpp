// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/plane_chart.h"

#include <algorithm>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"
#include "radcert/surface/affine_image.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {
namespace {

using Polynomial = PlanePolynomial<Rational>;

/// Of degree 0 where the function is constant.
Polynomial affine(const Rational& value, const Rational& by_s, const Rational& by_t) {
  if (by_s.sign() == 0 && by_t.sign() == 0) return constant_polynomial(value);
  return affine_polynomial(value, by_s, by_t);
}

std::optional<Polynomial> quotient(const Polynomial& a, const Polynomial& b) {
  if (b.degree() > 0 || b(0, 0).sign() == 0) return std::nullopt;
  return product(a, constant_polynomial(Rational(1) / b(0, 0)));
}

/// Powers of constants beyond this are left to arithmetics that round.
constexpr long largest_exponent = 64;

std::optional<Polynomial> whole_power(const Polynomial& a, long n, int largest_degree) {
  if (n < -largest_exponent || n > largest_exponent) return std::nullopt;
  if (n < 0) {
    const std::optional<Polynomial> inverse = quotient(constant_polynomial(Rational(1)), a);
    return inverse ? whole_power(*inverse, -n, largest_degree) : std::nullopt;
  }
  if (a.degree() == 0) return constant_polynomial(power(a(0, 0), n));
  if (n * a.degree() > largest_degree) return std::nullopt;
  Polynomial result = constant_polynomial(Rational(1));
  for (long k = 0; k < n; ++k) result = product(result, a);
  return result;
}

}  // namespace

Vector<Rational> PlaneChart::normal() const {
  const Vector<Rational> n = cross(first, second);
  return orientation == Orientation::along_the_cross_product ? n : Rational(-1) * n;
}

PlaneChart PlaneChart::over(const std::array<ParameterPoint<Rational>, 3>& v) const {
  const Vector<Rational> corner = point(v[0]);
  return {.origin = corner,
          .first = point(v[1]) - corner,
          .second = point(v[2]) - corner,
          .orientation = orientation};
}

std::optional<PlaneChart> plane_chart(const Surface& surface, std::size_t chart) {
  expects(chart < surface.chart_count(), "a chart of the surface", named("chart", chart));
  const ChartFacts& facts = surface.charts[chart].facts();
  if (!facts.plane) return std::nullopt;
  if (surface.mesh) {
    const auto corners = surface.mesh->corners(chart);
    const Vector<Rational> origin = exactly(corners[0]);
    return PlaneChart{.origin = origin,
                      .first = exactly(corners[1]) - origin,
                      .second = exactly(corners[2]) - origin,
                      .orientation = facts.orientation};
  }
  const ExactImage* formula = exact_image(surface.charts[chart].in<Ball>());
  if (formula == nullptr) return std::nullopt;
  const std::optional<AffineImage> image = affine_image(formula->image());
  if (!image) return std::nullopt;
  return PlaneChart{.origin = image->origin,
                    .first = image->first,
                    .second = image->second,
                    .orientation = facts.orientation};
}

PlanePolygon polygon_of(const PlaneChart& chart, PolygonLoop loop) {
  const bool along = chart.orientation == Orientation::along_the_cross_product;
  if (!along)
    for (ParameterPoint<Rational>& corner : loop) std::swap(corner.s, corner.t);
  Outcome<PlanePolygon> polygon = plane_polygon(chart.origin, along ? chart.first : chart.second,
                                                along ? chart.second : chart.first, {std::move(loop)});
  expects(polygon.has_value(), "a polygon", named("fault", polygon ? "" : polygon.reason()));
  return std::move(polygon).value();
}

PlanePolynomial<Rational> on_polygon_of(const PlaneChart& chart, const PlanePolynomial<Rational>& q) {
  if (chart.orientation == Orientation::along_the_cross_product) return q;
  Polynomial swapped(q.degree());
  for (int i = 0; i <= q.degree(); ++i)
    for (int j = 0; i + j <= q.degree(); ++j) swapped(j, i) = q(i, j);
  return swapped;
}

std::optional<PlanePolynomial<Rational>> polynomial_on_plane(const Expression& f,
                                                             const Vector<Rational>& origin,
                                                             const Vector<Rational>& first,
                                                             const Vector<Rational>& second,
                                                             int largest_degree) {
  expects(f.variables() == ExpressionVariables::space, "an expression in x, y, z", named("text", f.text()));
  expects(largest_degree >= 0, "largest_degree >= 0", named("largest_degree", largest_degree));
  const std::array<Polynomial, 3> variables{affine(origin.x, first.x, second.x),
                                            affine(origin.y, first.y, second.y),
                                            affine(origin.z, first.z, second.z)};
  std::vector<Polynomial> values;
  values.reserve(f.nodes().size());
  for (const ExpressionNode& node : f.nodes()) {
    const auto operand = [&](int place) -> const Polynomial& {
      return values[static_cast<std::size_t>(place)];
    };
    std::optional<Polynomial> value;
    switch (node.kind) {
      case ExpressionKind::literal: value = constant_polynomial(node.literal); break;
      case ExpressionKind::variable: value = variables[static_cast<std::size_t>(node.variable)]; break;
      case ExpressionKind::negate:
        value = product(operand(node.left), constant_polynomial(Rational(-1)));
        break;
      case ExpressionKind::add: value = sum(operand(node.left), Rational(1), operand(node.right)); break;
      case ExpressionKind::subtract:
        value = sum(operand(node.left), Rational(-1), operand(node.right));
        break;
      case ExpressionKind::multiply:
        if (operand(node.left).degree() + operand(node.right).degree() <= largest_degree)
          value = product(operand(node.left), operand(node.right));
        break;
      case ExpressionKind::divide: value = quotient(operand(node.left), operand(node.right)); break;
      case ExpressionKind::power:
        if (node.whole_exponent)
          value = whole_power(operand(node.left), *node.whole_exponent, largest_degree);
        break;
      default: break;
    }
    if (!value || value->degree() > largest_degree) return std::nullopt;
    values.push_back(std::move(*value));
  }
  return values.back();
}

}  // namespace radcert
