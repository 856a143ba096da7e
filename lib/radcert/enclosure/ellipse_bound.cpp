// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/ellipse_bound.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "radcert/core/contract.h"

namespace radcert {

namespace {

struct Range {
  double low;
  double high;
  double width() const { return high - low; }
  double middle() const { return low + (high - low) / 2; }
  double least_size() const { return low > 0 ? low : (high < 0 ? -high : 0); }
};

/// A part of the half ellipse times the other side, each side of the cell scaled to [-1, 1].
struct EllipseBox {
  Range real;
  Range imag;
  Range other;
  double bound = 0;
  const char* failure = nullptr;
  int depth = 0;
  /// The largest bound first, and of the boxes without a bound the smallest: it tells soonest that the budget
  /// will not do.
  bool operator<(const EllipseBox& another) const {
    return bound != another.bound ? bound < another.bound : depth < another.depth;
  }
};

/// An interval as its middle and half its length.
struct Side {
  double middle;
  double half;
};

Side side(double low, double high) { return {low + (high - low) / 2, (high - low) / 2}; }

struct Cover {
  const SquareFunction& f;
  SquareAxis axis;
  Side complex;
  Side other;
  double long_axis;
  double short_axis;

  /// Slightly more than the ellipse, so that rounding drops no box that touches it.
  bool meets_the_ellipse(const EllipseBox& box) const {
    constexpr double margin = 1e-9;
    const double x = box.real.least_size() / long_axis;
    const double y = box.imag.least_size() / short_axis;
    return x * x + y * y <= 1 + margin;
  }

  /// The value in the disks around a box. They are made larger by more than the rounding of their middles and
  /// radii.
  void evaluate(EllipseBox& box) const {
    constexpr double up = 1 + 0x1p-30;
    const double rounding_of_complex = 0x1p-50 * (std::abs(complex.middle) + complex.half * long_axis);
    const double rounding_of_other = 0x1p-50 * (std::abs(other.middle) + other.half);
    const double radius =
        std::sqrt(box.real.width() * box.real.width() + box.imag.width() * box.imag.width()) / 2;
    const TaylorModel z = TaylorModel::variable_u(
        {.real = complex.middle + complex.half * box.real.middle(), .imag = complex.half * box.imag.middle()},
        complex.half * radius * up + rounding_of_complex);
    const TaylorModel t =
        TaylorModel::variable_v({.real = other.middle + other.half * box.other.middle()},
                                other.half * (box.other.width() / 2) * up + rounding_of_other);
    const TaylorModel value = axis == SquareAxis::x ? f.in_models(z, t) : f.in_models(t, z);
    box.bound = value.magnitude_bound();
    box.failure = value.is_finite() ? nullptr : value.failure().data();
  }
};

/// Halves the longest side.
std::pair<EllipseBox, EllipseBox> halves(const EllipseBox& box) {
  EllipseBox low = box;
  ++low.depth;
  EllipseBox high = low;
  const auto cut = [&](Range EllipseBox::*side) {
    const double middle = (box.*side).middle();
    (low.*side).high = middle;
    (high.*side).low = middle;
  };
  if (box.real.width() >= std::max(box.imag.width(), box.other.width())) {
    cut(&EllipseBox::real);
  } else {
    cut(box.imag.width() >= box.other.width() ? &EllipseBox::imag : &EllipseBox::other);
  }
  return {low, high};
}

}  // namespace

EllipseBound bound_on_ellipse(const SquareFunction& f, const SquareCell& cell, SquareAxis axis, double rho,
                              long budget) {
  expects(rho > 1 && budget >= 1, "rho > 1, budget >= 1", named("rho", rho), named("budget", budget));
  const Side x = side(cell.x_low, cell.x_high);
  const Side y = side(cell.y_low, cell.y_high);
  // The half axes are rounded up by more than their rounding.
  constexpr double up = 1 + 0x1p-50;
  const Cover cover{.f = f,
                    .axis = axis,
                    .complex = axis == SquareAxis::x ? x : y,
                    .other = axis == SquareAxis::x ? y : x,
                    .long_axis = (rho + 1 / rho) / 2 * up,
                    .short_axis = (rho - 1 / rho) / 2 * up};

  EllipseBox middle{.real = {0, 0}, .imag = {0, 0}, .other = {0, 0}};
  cover.evaluate(middle);
  EllipseBound result{.bound = HUGE_VAL, .evaluations = 1, .failure = middle.failure};
  if (middle.failure != nullptr) return result;
  constexpr double close_enough = 16;
  // Boxes of equal size at this depth would be four times as many as the budget.
  const int deepest = std::ilogb(static_cast<double>(budget)) + 2;

  std::priority_queue<EllipseBox> boxes;
  EllipseBox whole{
      .real = {-cover.long_axis, cover.long_axis}, .imag = {0, cover.short_axis}, .other = {-1, 1}};
  cover.evaluate(whole);
  ++result.evaluations;
  boxes.push(whole);
  while (boxes.top().bound > close_enough * middle.bound && result.evaluations + 2 <= budget) {
    const EllipseBox worst = boxes.top();
    if (worst.failure != nullptr && worst.depth >= deepest) break;
    boxes.pop();
    const auto [first, second] = halves(worst);
    for (EllipseBox part : {first, second}) {
      if (!cover.meets_the_ellipse(part)) continue;
      cover.evaluate(part);
      ++result.evaluations;
      boxes.push(part);
    }
  }
  result.bound = boxes.top().bound;
  result.failure = boxes.top().failure;
  return result;
}

}  // namespace radcert
