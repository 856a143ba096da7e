// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/functions/taylor_model.h"

namespace radcert {

/// A function on the unit square, in balls and in Taylor models.
/// Maths     f : [0,1]^2 -> R; where the model of f over a product of two disks is finite, f is analytic
///           there, bounded by the model's norm
/// Source    one formula in two arithmetics: see TaylorModel
/// Requires  both enclose one function, which is real for real arguments; may be called from several threads
///           at once
struct SquareFunction {
  std::function<Ball(const Ball&, const Ball&)> in_balls;
  std::function<TaylorModel(const TaylorModel&, const TaylorModel&)> in_models;
};

/// From a formula: a class with  template <class R> R operator()(const R& x, const R& y) const, or a generic
/// lambda.
template <class Formula>
SquareFunction square_function(Formula formula) {
  return {.in_balls = [formula](const Ball& x, const Ball& y) -> Ball { return formula(x, y); },
          .in_models = [formula](const TaylorModel& x, const TaylorModel& y) -> TaylorModel {
            return formula(x, y);
          }};
}

/// A rectangle [x_low, x_high] x [y_low, y_high] in the unit square.
struct SquareCell {
  double x_low = 0;
  double x_high = 1;
  double y_low = 0;
  double y_high = 1;
};

/// The variable of a SquareFunction that leaves the real line.
enum class SquareAxis { x, y };

}  // namespace radcert
