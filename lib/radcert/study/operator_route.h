// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "radcert/scalar/approximation.h"
#include "radcert/surface/surface_point.h"

namespace radcert {

struct Surface;
class SurfaceFunction;

/// The operator applied to one density.
/// Maths     P -> Int_S G(P,Q) u(Q) dS_Q
/// Source    [ac98, (2)]
/// Requires  safe to call from several threads at once
/// Result    as its maker says
using AppliedOperator = std::function<Approximation(const SurfacePoint<double>& p)>;

/// The second route to Ku, passed in from outside: this layer knows of no reference values.
/// Maths     (surface, u) -> (P -> Int_S G(P,Q) u(Q) dS_Q)
/// Requires  surface and u outlive what it returns
/// Result    shares no quadrature with the collocation matrix
using OperatorRoute = std::function<AppliedOperator(const Surface& surface, const SurfaceFunction& u)>;

}  // namespace radcert
