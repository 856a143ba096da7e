// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "radcert/core/outcome.h"
#include "radcert/quadrature/certified/element_functions.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// Integrals of the kernel times functions over one element after the other, from many points, in doubles
/// with proved radii.
/// Maths     Int_{Delta_k} G(P_i,Q) f_j(Q) dS_Q
/// Source    ours. A triangle of parameters is the image of the unit square under Duffy's map, and a product
///           Gauss rule has the error of gauss_error_factor for bounds on Bernstein ellipses,
///           integral_over_squares. One Taylor model of the chart over (disk around the ellipse) x (side)
///           bounds the integrand for all P that are far enough: in it Q = c + l + e, c its centre, l its
///           terms up to the first order in the complex variable z, e the others. l = a + z b with real
///           vectors a and b, so (c + l - P)^2 is a real quadratic in z whose zeros have the modulus |c + a -
///           P| / |b|, and |(c + l - P)^2| >= (d - L)^2 for d = |c - P| and L >= |l|; then with E >= |e|
///             |(Q - P)^2| >= S = (d - L)^2 - 2 (d + L) E - E^2,   |G J| <= (d + L + E)^2 |n_Q J| / S^2,
///           and d^2 times that falls with d. Triangles too near to P are divided into four. In the element
///           that contains P the kernel is chord_kernel along the rays from P: IntegralFromWithin. Roundings:
///           see KernelRule and BoundedChart
/// Requires  surface, triangulation and functions outlive it; the surface unoccluded, from 1 to 45 functions,
///           points by parameters in the domains of their charts, 0 < demand, else ContractViolation; lengths
///           between 1e-60 and 1e60
/// Result    radii such that their sum over all elements and functions is of the size of the demand, unless
///           rounding is larger: they hold in any case, and the caller adds them up. The same bits from any
///           thread
/// Limits    V = 1. A point on the border of an element of another chart, and a chart that is not analytic on
///           an element, is refused
class CertifiedKernelSums {
public:
  CertifiedKernelSums(const Surface& surface, const Triangulation& triangulation,
                      const ElementFunctions& functions, std::span<const SurfacePoint<Rational>> points,
                      double demand);
  CertifiedKernelSums(CertifiedKernelSums&&) noexcept;
  CertifiedKernelSums& operator=(CertifiedKernelSums&&) noexcept;
  ~CertifiedKernelSums();

  /// The integrals over element k: values and radii of function j at place j points + i. ContractViolation
  /// unless the spans have that size. Refused with what stood in the way.
  [[nodiscard]] Outcome<void> element(std::size_t k, std::span<double> values,
                                      std::span<double> radius) const;
  /// The same from some of the points, by their numbers: from number i of these at place j size + i.
  [[nodiscard]] Outcome<void> element(std::size_t k, std::span<const std::uint32_t> points,
                                      std::span<double> values, std::span<double> radius) const;

private:
  class Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace radcert
