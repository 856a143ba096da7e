// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/certificate/part.h"
#include "radcert/certificate/polyhedron_certificate.h"

namespace radcert::certificate {

/// Sums of the claims, and the means or values that follow from them; of a function nothing.
/// Maths     norms[k] = (sum norms_k^2)^(1/2), products and radii as sums; the mean over piece k is (Int_k
///           w_0 + products[k] +- (radii[k] + norms[0] norms[1+k]/(1 - max rho)))/area. Theorem: B =
///           rho^(1/2) T rho^(1/2) is self-adjoint in L2 and not longer than s = max rho, by Schur's test
///           with T >= 0 symmetric and T 1 = 1. u - w_0 = (I - rho T)^-1 rho t_0, so that with j = 1 on piece
///           k, y = j + q_k: Int j (u - w_0) = (rho^(1/2) j, (I-B)^-1 rho^(1/2) t_0) and (I-B)^-1 rho^(1/2) j
///           = rho^(1/2) y + (I-B)^-1 rho^(1/2) t_k; w_k = rho y. Values: with j = V G(P,.)/pi and y = q_k,
///           (I-B) rho^(1/2) y = rho^(1/2) (j - t_k), t_k = T w_k + j - y, and u(P) = E + rho Int j u at P
/// Requires  surface_fault, reflectivity_fault, points_fault, tiling_fault found nothing
/// Result    sums rounded outwards; the mean's radius bounds everything
struct Summed {
  Sums sums;
  std::vector<Enclosure> enclosures;
};
[[nodiscard]] Summed summed(const PolyhedronCertificate& certificate);

/// Checks a certificate, by means that share no function with the search that made it.
/// Maths     surface_fault, reflectivity_fault, points_fault, tiling_fault; of the elements that are looked
///           at, the claims by ElementCheck; the stated sums are those of the claims or wider, the means or
///           values those of summed or wider, the width is no less than twice the largest radius; of a
///           function function_fault. All claims together prove the means, values or bounds. Where parts hide
///           each other T w is enclosed on cells of elements from what all points of a cell see for certain
///           (Sight); what some of them may not see is closed by T 1 = 1 with constants near w there, and
///           bounded (Shade)
/// Requires  lists of the lengths that PolyhedronCertificate states, finite numbers
/// Result    no refusal: what was looked at is proved, and the means are, if all claims hold. Depends on the
///           certificate and the part alone, whatever the number of threads
/// Limits    a claim that holds by less than the bounds here are generous is refused, as is one about shade
///           that most_checked_cells cells of an element do not prove. Both take Gauss rules: the search of
///           densities at nodes, this of moments of the kernel (BallTransport), which a test holds against
///           closed forms in balls
[[nodiscard]] Report check(const PolyhedronCertificate& certificate, const Part& part,
                           const CheckListener& progress = {});

}  // namespace radcert::certificate
