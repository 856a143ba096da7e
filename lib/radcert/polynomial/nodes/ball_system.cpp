// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/ball_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "radcert/polynomial/nodes/symmetric_system.h"

namespace radcert {

bool newton(std::span<Ball* const> unknowns, const std::function<BallResiduals()>& residuals) {
  constexpr int most_steps = 12;
  constexpr double at_rest = 1e-100;
  constexpr double enough = 1e-70;
  double last = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most_steps && last > at_rest; ++k) {
    const BallResiduals at = residuals();
    const std::optional<Matrix<Ball>> inverse = approximate_inverse(at.derivatives);
    if (!inverse) return false;
    last = 0;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      Ball step(0);
      for (std::size_t j = 0; j < unknowns.size(); ++j) step -= (*inverse)(i, j) * at.values[j];
      *unknowns[i] = (*unknowns[i] + step).midpoint();
      last = std::max(last, std::abs(step.midpoint().to_double()));
    }
    if (!(last < 1)) return false;
  }
  return last < enough;
}

Outcome<void> krawczyk(std::span<Ball* const> centre, std::span<Ball* const> box, const Rational& radius,
                       const BallResiduals& at_centre, const std::function<BallResiduals()>& over_box) {
  const std::optional<Matrix<Ball>> inverse = approximate_inverse(at_centre.derivatives);
  if (!inverse) return because("the derivative has no inverse at the nodes");
  const Ball half_width(radius);
  for (Ball* unknown : box) *unknown = widened(*unknown, half_width);
  const BallResiduals over = over_box();
  const std::size_t n = centre.size();
  for (std::size_t i = 0; i < n; ++i) {
    Ball shift(0);
    for (std::size_t k = 0; k < n; ++k) shift -= (*inverse)(i, k) * at_centre.values[k];
    for (std::size_t j = 0; j < n; ++j) {
      Ball entry(i == j ? 1 : 0);
      for (std::size_t k = 0; k < n; ++k) entry -= (*inverse)(i, k) * over.derivatives(k, j);
      shift += entry * widened(Ball(0), half_width);
    }
    if (!certainly_less(abs(shift), half_width))
      return because("the image of the box does not lie inside it: no zero is proved within " +
                     radius.to_text());
    *box[i] = *centre[i] + shift;
  }
  return {};
}

}  // namespace radcert
