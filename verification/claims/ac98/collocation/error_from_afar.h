// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/scalar/approximation.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert::verification::ac98 {

/// The u that is interpolated here.
/// Maths     exp(x + y/2 - z/3)
[[nodiscard]] double wave(const Vector<double>& q);

/// What linear interpolation misses on one element.
/// Maths     (u - P_n u)(q) = sum_j (u(q) - u(q_j)) l_j(q), as the l_j have the sum 1: without cancelling
///           the constant part of u, which is much larger than the difference on fine elements
/// Source    [ac98, (33)-(34)]
/// Requires  0 <= alpha < 1/3; the surface outlives this
class InterpolationError {
public:
  InterpolationError(const Surface& surface, const ParameterTriangle& element, double alpha);
  double operator()(const SurfacePoint<double>& q, const Vector<double>& point) const;
  [[nodiscard]] const Surface& surface() const { return *surface_; }
  [[nodiscard]] const ParameterTriangle& element() const { return element_; }

private:
  const Surface* surface_;
  ParameterTriangle element_;
  double alpha_;
  std::array<double, 3> at_nodes_{};
};

/// What interpolation on the elements moves K u at P by.
/// Maths     Int G(P,Q) (u - P_n u)(Q) dS_Q over the elements: by the library's cubature where P is within a
///           size of an element's centroid, by product rules of two orders elsewhere
/// Result    the radius is the difference of both orders, or what the cubature estimates; the same bits for
///           any number of threads
[[nodiscard]] Approximation error_seen_from(const Surface& surface, const SurfacePoint<double>& p,
                                            const std::vector<ParameterTriangle>& elements, double alpha);

}  // namespace radcert::verification::ac98
