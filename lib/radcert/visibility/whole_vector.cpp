// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/whole_vector.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {

int lowest_exponent(const Vector<double>& v) {
  return std::min({lowest_exponent(v.x), lowest_exponent(v.y), lowest_exponent(v.z)});
}

WholeVector scaled(const Vector<double>& v, int exponent) {
  return {WholeNumber::scaled(v.x, exponent), WholeNumber::scaled(v.y, exponent),
          WholeNumber::scaled(v.z, exponent)};
}

Vector<long double> leading_digits(const WholeVector& v) {
  constexpr std::size_t word = 64;
  const std::size_t bits = std::max({v.x.bit_count(), v.y.bit_count(), v.z.bit_count()});
  expects(bits > 0, "a direction that is not zero");
  if (bits <= word) {
    const long double up = std::ldexp(1.0L, static_cast<int>(word - bits));
    return {up * v.x.shifted_down(0), up * v.y.shifted_down(0), up * v.z.shifted_down(0)};
  }
  return {v.x.shifted_down(bits - word), v.y.shifted_down(bits - word), v.z.shifted_down(bits - word)};
}

Vector<Rational> to_rational(const WholeVector& v) {
  return {v.x.to_rational(), v.y.to_rational(), v.z.to_rational()};
}

}  // namespace radcert
