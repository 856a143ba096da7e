// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/whole_number.h"

namespace radcert {

/// A vector of whole numbers, for directions: what counts is its ray.
struct WholeVector {
  WholeNumber x;
  WholeNumber y;
  WholeNumber z;

  friend WholeVector operator-(const WholeVector& a, const WholeVector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend WholeVector operator+(const WholeVector& a, const WholeVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  WholeVector operator-() const { return {-x, -y, -z}; }
};

/// The products a . b and a x b, exactly.
inline WholeNumber dot(const WholeVector& a, const WholeVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline WholeVector cross(const WholeVector& a, const WholeVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The least exponent of the lowest binary digits of the coordinates, see lowest_exponent.
[[nodiscard]] int lowest_exponent(const Vector<double>& v);

/// A vector times 2^(-exponent), see WholeNumber::scaled.
[[nodiscard]] WholeVector scaled(const Vector<double>& v, int exponent);

/// A vector of this direction, its largest coordinate between 2^63 and 2^64 and each within 1.
/// Requires  not zero, else ContractViolation
[[nodiscard]] Vector<long double> leading_digits(const WholeVector& v);

/// The same vector in rational numbers, exactly.
[[nodiscard]] Vector<Rational> to_rational(const WholeVector& v);

}  // namespace radcert
