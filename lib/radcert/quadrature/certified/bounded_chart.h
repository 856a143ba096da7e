// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// A ball as a double with a bound; the bound is infinite where the ball has failed.
[[nodiscard]] BoundedDouble bounded(const Ball& x);
/// A ball that contains the number; failed where the bound is infinite.
[[nodiscard]] Ball ball_around(const BoundedDouble& x);

/// A chart's formula in doubles that carry bounds of their errors.
/// Maths     F, its tangents and its divided differences along rays, as ChartIn
/// Source    running error analysis, see BoundedDouble. Where the exact image of the chart is a polynomial of
///           at most degree 12, its monomials; elsewhere the chart's formula in balls, around the number and
///           its bound
/// Requires  parameters whose exact values lie in the domain; the chart has a formula in balls and outlives
///           this object
/// Result    the exact values are within the bounds, which are infinite where the formula is not proved to
///           have a value
/// Limits    some ten times faster than balls for polynomials; elsewhere as fast as these
class BoundedChart {
public:
  static constexpr std::size_t highest_degree = 12;

  explicit BoundedChart(const Chart& chart);

  /// Whether a point costs little.
  [[nodiscard]] bool is_polynomial() const { return polynomials_.has_value(); }
  [[nodiscard]] Frame<BoundedDouble> frame(const ParameterPoint<BoundedDouble>& at) const;
  /// As ChartIn::chord_along.
  [[nodiscard]] Chord<BoundedDouble> chord_along(const ParameterPoint<BoundedDouble>& p,
                                                 const ParameterPoint<BoundedDouble>& direction,
                                                 const BoundedDouble& step) const;

private:
  struct Monomial {
    BoundedDouble coefficient;
    std::size_t power_of_s = 0;
    std::size_t power_of_t = 0;
  };
  using Polynomial = std::vector<Monomial>;

  static std::optional<std::array<Polynomial, 3>> polynomials(const Chart& chart);
  template <Field T>
  Vector<T> image(const T& s, const T& t) const;

  const Chart& chart_;
  std::optional<std::array<Polynomial, 3>> polynomials_;
  std::size_t degree_ = 0;
};

}  // namespace radcert
