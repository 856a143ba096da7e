// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/certificate/certificate.h"
#include "radcert/study/guarantee.h"
#include "radcert/study/guarantee_context.h"
#include "radcert/study/result.h"

namespace radcert {

/// Enclosed means or values of a solution, with what proves them.
struct CertifiedSolution {
  LevelResult level;
  SolutionEnclosure enclosure;
  certificate::Certificate certificate;  ///< encloses a little less narrowly
};

/// Encloses the means of u over the pieces, its values at points or, on an ellipsoid, u itself, and keeps
/// what proves it for certificate::check.
/// Maths     solve_within for three quarters of the width, and polyhedron_certificate or
///           ellipsoid_certificate; on a polyhedron, where that is wider than asked for, both for less
/// Requires  what check_guarantee lets pass, and nothing that stands in the way of a certificate, else
///           InputError
/// Result    as solve_within; where the certificate is wider than the width, the enclosure says so
[[nodiscard]] CertifiedSolution certified_solution(const Problem& problem, const Guarantee& guarantee,
                                                   const GuaranteeContext& context = {});

/// Refuses what certified_solution cannot do.
void check_certified(const Problem& problem, const Guarantee& guarantee);

}  // namespace radcert
