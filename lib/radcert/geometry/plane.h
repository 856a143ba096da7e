// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// Whether all three coordinates are 0.
[[nodiscard]] bool is_zero(const Vector<Rational>& v);

/// A plane with rational coefficients, for decisions that must not depend on rounding.
/// Maths     { X : normal . X = offset }
/// Requires  normal != 0, else ContractViolation
/// Result    equality of planes as sets, exact
/// Limits    the normal is not of unit length (a unit normal is rarely rational)
class Plane {
public:
  /// The plane through `origin` spanned by two independent directions.
  Plane(const Vector<Rational>& origin, const Vector<Rational>& first, const Vector<Rational>& second);

  const Vector<Rational>& normal() const { return normal_; }
  const Rational& offset() const { return offset_; }
  friend bool same_plane(const Plane& a, const Plane& b);

private:
  Vector<Rational> normal_;
  Rational offset_;
};

/// Whether two planes are equal as sets, exactly.
bool same_plane(const Plane& a, const Plane& b);

}  // namespace radcert
