// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/scalar/real.h"
#include "verification/framework/finding.h"

namespace radcert::verification {

// The inequalities behind the lemmas that bound Int Phi (I - L) f, with their constants and for all
// functions. |D^k f| is the largest derivative of order k, |d|_1 = |d_x| + |d_y|, and || || the norm of L^1
// of the region.
//
// 1. On [0,1], f - mean f = Int k(s,t) f'(t) dt with k = t before s and t - 1 after it. Int |k(s,t)| ds =
//    2t(1 - t) <= 1/2, as 1/2 less it is (1 - 2t)^2/2. So ||f - mean f|| <= (1/2) ||f'||.
// 2. On a parallelogram with sides a and b, M_a and M_b the means along them, Phi - M_a M_b Phi = (Phi - M_a
//    Phi) + M_a (Phi - M_b Phi) and ||M_a|| <= 1. So ||Phi - mean Phi|| <= (1/2) ||a.grad Phi|| + (1/2)
//    ||b.grad Phi||.
// 3. Let phi_i be the polynomial of degree i whose derivatives up to the order i have the means of those of
//    Phi. 2. once more for each derivative gives ||Phi - phi_i|| <= sum_j c_j ||(a.grad)^(i+1-j) (b.grad)^j
//    Phi||, with the c_j of Pascal's triangle over 2^(i+1). Their sum is 1, so that ||Phi - phi_i|| <= (S
//    h)^(i+1) || |D^(i+1) Phi| || where |a|_1, |b|_1 <= S h. Further phi_1 - phi_0 = g.(Q - centre), g the
//    mean of grad Phi, so that ||phi_1 - phi_0|| <= (S h/2) || |D Phi| ||, by Int_0^1 |s - 1/2| ds = 1/4.
// 4. On a triangle with these two sides the same for i = 0: continued by its mirror image in the parameters,
//    (s,t) -> (1 - t, 1 - s), which does not move the third side, Phi is continuous on the parallelogram,
//    with the same mean value and with both derivatives exchanged.
//
// 5. p_k the Taylor polynomial of f about a point of a convex region: |f - p_k| <= |d|_1^(k+1)/(k+1)! max
//    |D^(k+1) f|, by Int_0^1 (1 - t)^k/k! dt = 1/(k+1)! and the binomial theorem. |d|_1 is convex: over a
//    polygon it is largest at a vertex.
//
// For Phi in W^(i+1,1) by density of the smooth functions, which is not proved here.

/// What a functional leaves of a function on [0,1], as an integral of the derivative.
/// Maths     f(s) - F(f) = Int_0^s before(t) f'(t) dt + Int_s^1 after(t) f'(t) dt
struct MeanValueKernel {
  RationalPolynomial before;
  RationalPolynomial after;
};

/// The kernel for the mean value: t and t - 1.
[[nodiscard]] MeanValueKernel mean_value_kernel();
/// The kernel for the value at 0: 1 and 0.
[[nodiscard]] MeanValueKernel end_value_kernel();
/// How many of the conditions fail under which integration by parts leaves f(s) - Int_0^1 f.
/// Maths     before' = after' = 1, before(0) = after(1) = 0, before - after = 1
[[nodiscard]] Rational failing_conditions(const MeanValueKernel& kernel);
/// The integral of the kernel's size over s, as a polynomial of t.
/// Maths     Int_0^1 |k(s,t)| ds = |before(t)| (1 - t) + |after(t)| t
/// Requires  before >= 0 >= after on [0,1], both of degree <= 1, else ContractViolation
/// Result    exact
[[nodiscard]] RationalPolynomial column(const MeanValueKernel& kernel);

/// c_j in ||Phi - phi_i|| <= sum_j c_j ||(a.grad)^(i+1-j) (b.grad)^j Phi||, 3. above.
/// Requires  degree >= 0, else ContractViolation
/// Result    exact, degree + 2 numbers
[[nodiscard]] std::vector<Rational> mean_value_factors(int degree);
/// The same for phi_1 - phi_0, half of the sum of both: Int_0^1 |s - 1/2| ds times 2.
[[nodiscard]] Rational mean_slope_factor();

/// Int_0^1 (1 - t)^k/k! dt, by k integrations: 1/(k+1)!.
/// Requires  degree >= 0, else ContractViolation
/// Result    exact
[[nodiscard]] Rational taylor_factor(int degree);

/// Requires the lines of 1. to 4. of a finding, with phi_i up to this degree: exact, each with a control.
void require_mean_values(Finding& finding, int degree);

/// What bounds the terms of Int Phi (I - L) f, over (1 + norm of L) h^(degree+1+gained).
/// Maths     r = degree, p_k the Taylor polynomials about one point, and L p_r = p_r. gained = 1, where Int
///           L' p_(r+1) = 0, L' = I - L: Int Phi L'f = Int (Phi - phi_0) L'(f - p_r) + phi_0 Int L'(f -
///           p_(r+1)). gained = 2, where Int phi_1 L' p_(r+1) = 0 = Int L' p_(r+2): Int Phi L'f = Int (Phi -
///           phi_1) L'(f - p_r) + Int (phi_1 - phi_0) L'(f - p_(r+1)) + phi_0 Int L'(f - p_(r+2)). By 1. to
///           5., with |a|_1, |b|_1 <= side h and |d|_1 <= reach h: |Int Phi L'f| <= (1 + norm of L)
///           h^(r+1+gained) sum_j c_j || |D^(gained-j) Phi| || max |D^(r+1+j) f|
/// Requires  degree >= 0, gained = 1 or 2, else ContractViolation
/// Result    c_0, ..., c_gained: the largest is a constant for the product of the sum of the norms of Phi and
///           the largest of the derivatives of f
template <Field R>
[[nodiscard]] std::vector<R> interpolation_factors(int degree, int gained, const R& side, const R& reach) {
  expects(degree >= 0 && (gained == 1 || gained == 2), "degree >= 0, gained = 1 or 2",
          named("degree", degree), named("gained", gained));
  std::vector<R> taylor;
  for (int j = 0; j <= gained; ++j)
    taylor.push_back(R(taylor_factor(degree + j)) * power(reach, degree + 1 + j));
  std::vector<R> of_phi;
  Rational sum = 0;
  for (const Rational& c : mean_value_factors(gained - 1)) sum += c;
  of_phi.push_back(R(sum) * power(side, gained));
  if (gained == 2) of_phi.push_back(R(mean_slope_factor()) * side);
  of_phi.push_back(R(1));
  for (std::size_t j = 0; j < taylor.size(); ++j) taylor[j] = taylor[j] * of_phi[j];
  return taylor;
}

}  // namespace radcert::verification
