// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/reference/cubature/gauss_rule.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/real.h"

namespace radcert::reference {

/// A rectangle of the unit square of a part, and what a product of two Gauss rules says of the integral over
/// it.
/// Maths     [y, y + height] x [x, x + width], y the number of a line, x the place on it; `lines` times
///           `points` points
/// Result    value with the estimates of its errors across and along the lines, the integral of the absolute
///           value, and a bound `noise` for its rounding
struct Region {
  std::size_t part;
  std::size_t lines;
  std::size_t points;
  double y;
  double x;
  double height;
  double width;
  double value;
  double absolute;
  double noise;
  GaussRule::Error across;
  GaussRule::Error along;

  double error() const { return across.value + along.value; }
  /// No refinement lowers an error that is rounding.
  bool is_final() const {
    constexpr double unit = unit_roundoff<double>();
    return error() <= 2 * noise + 8 * unit * absolute || width < 1e-12 || height < 1e-12;
  }
};

/// The `caution` of RegionSums::finish where an integrand is analytic.
inline constexpr std::size_t usual_caution = 4;

/// The sums that make a region's figures, line by line.
/// Maths     sums with the weights of both rules; the profiles are the integrals along each line and across
///           the lines at each place
/// Requires  every line added once; lines of padded<double>(region.points) values, finite also where the
///           weight is zero
/// Result    finish() fills in value, absolute, noise, across and along
class RegionSums {
public:
  explicit RegionSums(const Region& region)
      : across_(GaussRule::of(region.lines)), along_(GaussRule::of(region.points)) {}

  struct Term {
    Pack value;
    Pack noise;  // >= 0
  };
  /// term(k): the values at the places k to k + 7 of the line.
  template <class OfPlace>
  void add_line(std::size_t line, const OfPlace& term) {
    Pack sum = 0.0;
    Pack absolute = 0.0;
    Pack noise = 0.0;
    const double weight_across = across_.weights()[line];
    for (std::size_t k = 0; k < along_.size(); k += Pack::lanes) {
      const Term t = term(k);
      const Pack weight = Pack::load(along_.weights().data() + k);
      sum = fma(weight, t.value, sum);
      absolute = fma(weight, abs(t.value), absolute);
      noise = fma(weight, t.noise, noise);
      double* const profile = profile_along_.data() + k;
      fma(t.value, weight_across, Pack::load(profile)).store(profile);
    }
    profile_across_[line] = sum.sum();
    absolute_ = fma(absolute, weight_across, absolute_);
    noise_ = fma(noise, weight_across, noise_);
  }

  /// The fall of the coefficients of n samples is continued over 2 n / `caution` degrees, see
  /// GaussRule::error.
  void finish(Region& region, std::size_t caution) const {
    const double area = region.width * region.height;
    region.value = area * across_.integral(profile_across_);
    region.absolute = area * absolute_.sum();
    region.noise = area * noise_.sum();
    const auto error = [&](const GaussRule& rule, const GaussRule::Samples& profile) {
      const GaussRule::Error e = rule.error(profile, (rule.size() + caution / 2) / caution);
      return GaussRule::Error{area * e.value, e.decay};
    };
    region.across = error(across_, profile_across_);
    region.along = error(along_, profile_along_);
  }

private:
  const GaussRule& across_;
  const GaussRule& along_;
  GaussRule::Samples profile_across_{};
  GaussRule::Samples profile_along_{};
  Pack absolute_ = 0.0;
  Pack noise_ = 0.0;
};

}  // namespace radcert::reference
