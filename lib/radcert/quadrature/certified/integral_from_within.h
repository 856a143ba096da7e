// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/enclosure/polygon_integral.h"
#include "radcert/quadrature/certified/bounded_chart.h"
#include "radcert/quadrature/certified/element_functions.h"
#include "radcert/quadrature/certified/gauss_orders.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// The corners of an element in the parameters of its chart.
using ElementCorners = std::array<ParameterPoint<Rational>, 3>;

/// The integrals of the kernel times functions over an element, from points of the element.
/// Maths     Int_Delta G(P,Q) f_j(Q) dS_Q, P in Delta
/// Source    the element falls into triangles with the apex P, each the image of the unit square under
///           Duffy's map; with Q - P = x D(x, y) along the rays from P the kernel is chord_kernel, analytic
///           up to P. Rectangles that have no rule of the orders there are bisected
/// Requires  all that it is made from outlives it; P by its parameters, in the element; n_P of unit length; 0
///           < allowance
/// Result    the integrals within the bounds, to which truncation adds at most the allowance. Refused where
///           the chart or a function is not analytic on the element
/// Limits    V = 1. One object serves one thread
class IntegralFromWithin {
public:
  IntegralFromWithin(const Chart& chart, const BoundedChart& bounded, std::size_t index,
                     const ElementCorners& corners, const ElementFunctions& functions,
                     const GaussOrders& gauss);

  [[nodiscard]] Outcome<void> integrals(const ParameterPoint<Rational>& p, const Vector<Ball>& normal,
                                        double allowance, std::span<BoundedDouble> sums);

private:
  /// One triangle of the fan around P.
  template <Field R>
  struct Piece {
    ParameterPoint<R> apex;
    ParameterPoint<R> first;
    ParameterPoint<R> along;
    R determinant;
    Barycentric<R> apex_in_element;
    Barycentric<R> first_in_element;
    Barycentric<R> along_in_element;
    Vector<R> normal;
  };
  /// The kernel, times the Jacobian.
  template <Field R>
  struct Value {
    R kernel;
    ElementPoint<R> at;
  };
  struct Pieces {
    Piece<TaylorModel> in_models;
    Piece<BoundedDouble> in_doubles;
  };
  /// The place of a rule in GaussOrders; none: `order` is their number.
  struct AxisRule {
    std::size_t order = GaussOrders::orders.size();
    double error = 0;
    [[nodiscard]] bool found() const { return order < GaussOrders::orders.size(); }
  };

  template <Field R>
  Piece<R> piece(const SquareMap& map, const Vector<R>& normal) const;
  template <Field R>
  Value<R> value(const Piece<R>& piece, const R& x, const R& y) const;
  AxisRule rule_for(const Piece<TaylorModel>& piece, const SquareCell& cell, SquareAxis axis,
                    double allowance);
  bool add(const Pieces& pieces, const SquareCell& cell, double allowance, int depth,
           std::span<BoundedDouble> sums);
  void add_rule(const Piece<BoundedDouble>& piece, const SquareCell& cell, const AxisRule& in_x,
                const AxisRule& in_y, std::span<BoundedDouble> sums);

  const Chart& chart_;
  const BoundedChart& bounded_;
  std::size_t index_;
  ElementCorners corners_;
  const ElementFunctions& functions_;
  const GaussOrders& gauss_;
  std::vector<BoundedDouble> function_values_;
  const char* obstacle_ = nullptr;  ///< the last operation of which a model had no value
};

}  // namespace radcert
