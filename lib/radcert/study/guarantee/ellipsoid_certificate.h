// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/certificate/ellipsoid/ellipsoid_certificate.h"
#include "radcert/continuous/ellipsoid/ellipsoid_enclosure.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// What encloses the solution on an ellipsoid as something that can be checked again.
/// Maths     q with the nearest doubles for its coefficients. The residual is the one that the search has
///           proved, wider: by a tenth, by what the coefficients are rounded, and by what a check takes for
///           its own errors. Then it is rounded up to a few decimals; sup |rho| is stated a little wider
///           where rho is no constant
/// Requires  what enclose_on_ellipsoid has found for the problem, a finite bound; points on the surface for
///           values, else none
/// Result    bound, enclosures and width follow exactly from the residual, as certificate::enclosed has them
[[nodiscard]] certificate::EllipsoidCertificate ellipsoid_certificate(
    const EllipsoidProblem& problem, const EllipsoidEnclosure& found, const std::string& piece,
    certificate::OnEllipsoid of, const std::vector<Vector<Rational>>& points);

}  // namespace radcert
