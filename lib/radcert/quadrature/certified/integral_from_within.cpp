// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/certified/integral_from_within.h"

#include <string>

#include "radcert/core/work_limit.h"
#include "radcert/kernel/geometric_kernel.h"

namespace radcert {
namespace {

/// More than the roundings of any bound below: each takes fewer than 2^12 operations on positive numbers.
constexpr double up = 1 + 0x1p-40;
const WorkLimit deepest("quadrature/integral_from_within: halvings of a square", 24, 0,
                        "refused, with the element");

template <Field R>
ParameterPoint<R> taken_into(const ParameterPoint<Rational>& p) {
  return {from_rational<R>(p.s), from_rational<R>(p.t)};
}

}  // namespace

IntegralFromWithin::IntegralFromWithin(const Chart& chart, const BoundedChart& bounded, std::size_t index,
                                       const ElementCorners& corners, const ElementFunctions& functions,
                                       const GaussOrders& gauss)
    : chart_(chart),
      bounded_(bounded),
      index_(index),
      corners_(corners),
      functions_(functions),
      gauss_(gauss),
      function_values_(functions.size()) {}

template <Field R>
IntegralFromWithin::Piece<R> IntegralFromWithin::piece(const SquareMap& map, const Vector<R>& normal) const {
  Piece<R> result{.apex = taken_into<R>(map.apex),
                  .first = taken_into<R>(map.first),
                  .along = taken_into<R>(map.along),
                  .determinant = from_rational<R>(abs(cross(map.first, map.along))),
                  .apex_in_element = {},
                  .first_in_element = {},
                  .along_in_element = {},
                  .normal = normal};
  const Rational area = cross(corners_[1] - corners_[0], corners_[2] - corners_[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const ParameterPoint<Rational>& origin = corners_[(i + 1) % 3];
    const ParameterPoint<Rational> side = corners_[(i + 2) % 3] - origin;
    result.apex_in_element.x[i] = from_rational<R>(cross(side, map.apex - origin) / area);
    result.first_in_element.x[i] = from_rational<R>(cross(side, map.first) / area);
    result.along_in_element.x[i] = from_rational<R>(cross(side, map.along) / area);
  }
  return result;
}

template <Field R>
IntegralFromWithin::Value<R> IntegralFromWithin::value(const Piece<R>& piece, const R& x, const R& y) const {
  const auto& formula = [this]() -> const auto& {
    if constexpr (std::same_as<R, BoundedDouble>) {
      return bounded_;
    } else {
      return chart_.in<R>();
    }
  }
  ();
  const ParameterPoint<R> direction = piece.first + y * piece.along;
  const ParameterPoint<R> at = piece.apex + x * direction;
  const Frame<R> frame = formula.frame(at);
  const R kernel =
      chord_kernel(formula.chord_along(piece.apex, direction, x), piece.normal, frame.area_normal);
  Barycentric<R> in_element;
  for (std::size_t i = 0; i < 3; ++i)
    in_element.x[i] =
        piece.apex_in_element.x[i] + x * (piece.first_in_element.x[i] + y * piece.along_in_element.x[i]);
  return {x * piece.determinant * kernel, {in_element, index_, at, frame.point}};
}

/// The lowest order that keeps an axis' part of the error within the allowance.
IntegralFromWithin::AxisRule IntegralFromWithin::rule_for(const Piece<TaylorModel>& piece,
                                                          const SquareCell& cell, SquareAxis axis,
                                                          double allowance) {
  const double area = (cell.x_high - cell.x_low) * (cell.y_high - cell.y_low) / 2;
  AxisRule best;
  for (std::size_t r = 0; r < GaussOrders::ellipses.size(); ++r) {
    const Disks disks = disks_around(cell, axis, GaussOrders::ellipses[r]);
    const Value<TaylorModel> f = value(piece, disks.x, disks.y);
    if (!f.kernel.is_finite()) {
      obstacle_ = f.kernel.failure().data();
      break;
    }
    const double bound = f.kernel.magnitude_bound() * functions_.bound(f.at) * area * up;
    std::size_t m = 0;
    while (m < GaussOrders::orders.size() && !(gauss_.factors[m][r] * bound * up <= allowance)) ++m;
    const bool better = m < best.order;
    if (better) best = {m, gauss_.factors[m][r] * bound * up};
    if (!better && best.found()) break;
  }
  return best;
}

bool IntegralFromWithin::add(const Pieces& pieces, const SquareCell& cell, double allowance, int depth,
                             std::span<BoundedDouble> sums) {
  const AxisRule x = rule_for(pieces.in_models, cell, SquareAxis::x, allowance / 2);
  const AxisRule y = rule_for(pieces.in_models, cell, SquareAxis::y, allowance / 2);
  if (x.found() && y.found()) {
    add_rule(pieces.in_doubles, cell, x, y, sums);
    return true;
  }
  if (depth >= deepest.value()) return false;
  SquareCell low = cell;
  SquareCell high = cell;
  const bool longer_in_y = cell.y_high - cell.y_low >= cell.x_high - cell.x_low;
  if (!y.found() && (x.found() || longer_in_y)) {
    low.y_high = high.y_low = (cell.y_low + cell.y_high) / 2;
  } else {
    low.x_high = high.x_low = (cell.x_low + cell.x_high) / 2;
  }
  return add(pieces, low, allowance / 2, depth + 1, sums) &&
         add(pieces, high, allowance / 2, depth + 1, sums);
}

void IntegralFromWithin::add_rule(const Piece<BoundedDouble>& piece, const SquareCell& cell,
                                  const AxisRule& in_x, const AxisRule& in_y, std::span<BoundedDouble> sums) {
  const GaussOrders::Rule& rule_x = gauss_.rules[in_x.order];
  const GaussOrders::Rule& rule_y = gauss_.rules[in_y.order];
  // The cells' sides are powers of two: these are exact.
  const BoundedDouble low_x = BoundedDouble::exactly(cell.x_low);
  const BoundedDouble low_y = BoundedDouble::exactly(cell.y_low);
  const BoundedDouble side_x = BoundedDouble::exactly(cell.x_high - cell.x_low);
  const BoundedDouble side_y = BoundedDouble::exactly(cell.y_high - cell.y_low);
  for (std::size_t a = 0; a < rule_x.nodes.size(); ++a) {
    const BoundedDouble x = low_x + side_x * rule_x.nodes[a];
    const BoundedDouble weight_x = rule_x.weights[a] * side_x * side_y;
    for (std::size_t b = 0; b < rule_y.nodes.size(); ++b) {
      const Value<BoundedDouble> f = value(piece, x, low_y + side_y * rule_y.nodes[b]);
      const BoundedDouble weighted = weight_x * rule_y.weights[b] * f.kernel;
      functions_.values(f.at, function_values_);
      for (std::size_t j = 0; j < sums.size(); ++j) sums[j] = sums[j] + weighted * function_values_[j];
    }
  }
  const double error = (in_x.error + in_y.error) * up;
  for (BoundedDouble& sum : sums) sum = {sum.value(), (sum.error() + error) * up};
}

Outcome<void> IntegralFromWithin::integrals(const ParameterPoint<Rational>& p, const Vector<Ball>& normal,
                                            double allowance, std::span<BoundedDouble> sums) {
  for (BoundedDouble& sum : sums) sum = 0;
  const Vector<TaylorModel> in_models{TaylorModel(normal.x), TaylorModel(normal.y), TaylorModel(normal.z)};
  const Vector<BoundedDouble> in_doubles{bounded(normal.x), bounded(normal.y), bounded(normal.z)};
  for (const SquareMap& map : fan({corners_.begin(), corners_.end()}, p)) {
    const Pieces pieces{piece<TaylorModel>(map, in_models), piece<BoundedDouble>(map, in_doubles)};
    if (!add(pieces, {}, allowance, 0, sums))
      return because("the integral over an element of chart " + chart_.facts().name +
                     " from a point of it was not enclosed" +
                     (obstacle_ == nullptr ? std::string() : std::string(": ") + obstacle_));
  }
  return {};
}

}  // namespace radcert
