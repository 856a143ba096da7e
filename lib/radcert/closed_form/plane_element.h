// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "radcert/geometry/plane_polygon.h"
#include "radcert/geometry/vector.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// A plane polygon prepared for the radiosity integrals of many points: doubles with a bounded error.
/// Maths     Int G(P,Q) q_k(Q) dS_Q over what P sees of the polygon, for all functions q_k at once, as
///           point_to_polygon: without 1/pi, negative where P lies behind the polygon
/// Source    KernelMoments in BoundedDouble; Gauss rules over pieces that are small against their distance
///           from P (fitting_rule), also where P's tangent plane cuts the polygon; balls where neither bound
///           suffices
/// Requires  at least one function, each of degree at most 8 and not zero, 1e-14 <= accuracy <= 1e-3, and no
///           sizes or a positive one a function, else ContractViolation; p and normal as point_to_polygon
///           demands them, taken as exact numbers
/// Result    |result - exact| <= accuracy (Int |G| dS) max |q_k| over the polygon, whatever P: always, by a
///           bound computed with the value, or by a ball; 2^-1074 more where that is not a normal number.
///           With sizes: sizes[k] >= max |q_k| in its place, such as the maximum over an element of which the
///           polygon is a part. The same bits for the same numbers, in any order and from any thread
/// Limits    a ball costs a hundred to a thousand closed forms. It is needed very close to an edge or a
///           corner and where the polygon is cut there, where P's height is less than about 1e-14 of the
///           coordinates, which is all that double-doubles know of it, from degree 3 on between the reach of
///           the closed form and that of the rules, and for functions whose Bernstein coefficients are
///           several times their maximum: then the rules' roundings are not within the bound
class PlaneElement {
public:
  static constexpr int largest_degree = 8;
  static constexpr double usual_accuracy = 1e-14;
  static constexpr double largest_accuracy = 1e-3;
  /// How a value was found.
  enum class Route { zero, closed_form, rule, ball };

  PlaneElement(const PlanePolygon& polygon, std::vector<PlanePolynomial<Rational>> functions,
               double accuracy = usual_accuracy, std::span<const double> sizes = {});
  PlaneElement(PlaneElement&&) noexcept;
  PlaneElement& operator=(PlaneElement&&) noexcept;
  ~PlaneElement();

  [[nodiscard]] std::size_t function_count() const;
  /// One integral a function; ContractViolation unless values has that size; AccuracyNotReached where balls
  /// of 2^14 bits do not enclose one to the accuracy.
  Route integrals(const Vector<double>& p, const Vector<double>& normal, std::span<double> values) const;

private:
  class Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace radcert
