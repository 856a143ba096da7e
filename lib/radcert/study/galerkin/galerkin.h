// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "radcert/core/memory_plan.h"
#include "radcert/study/operator_route.h"

namespace radcert {

struct Problem;
struct LevelOutcome;
struct Surface;

/// Galerkin's method with polynomials on each triangle, without continuity.
/// Maths     V_h: the piecewise polynomials of a degree r in the parameters. On S+, where rho > 0, u_n in V_h
///           with
///             a(u_n, v) = Int_S+ E v / rho dS + 1/pi Int_S+ v Int_S0 G u_n dS dS for all v in V_h,
///             a(u, v) = Int_S+ u v / rho dS - 1/pi Int_S+ Int_S+ v(P) G(P,Q) u(Q) dS_Q dS_P;
///           on S0, the pieces with rho = 0, where u = E, u_n is the projection of E in L2.
///           a is symmetric, and a(v,v) >= (1 - rho_max) Int v^2/rho dS >= (1/rho_max - 1) Int v^2 dS:
///           Int_S G(P,Q) V(P,Q) dS_Q <= pi at almost every P, since each direction shows one point at most
///           and the cosine's integral over the hemisphere is pi; G V is symmetric and not negative, so that
///           by Schur's test its operator over pi has a norm of at most 1 in L2; hence a(v,v) >= Int v^2/rho
///           - Int v^2, and v^2 <= rho_max v^2/rho.
///           Energy. u_n maximises 2 b(v) - a(v,v) over V_h, b(v) = a(u,v) the right-hand side, since that is
///           a(u,u) - a(u - v, u - v). Its value there is a(u_n,u_n) = b(u_n). So with nested spaces, by
///           refinement or by degree, b(u_n) grows, and is at most b(u) = a(u,u). Where S0 is empty and E is
///           c_k rho on the piece k, b(v) = sum c_k Int_k v: with one emitting piece of constant rho and E
///           the mean of u_n over the emitter grows, and never exceeds that of u. What is needed of S0 is
///           that E there is in all of the spaces: then b is the same for all
/// Source    Galerkin's method: Atkinson, The Numerical Solution of Integral Equations of the Second Kind,
///           1997, 3.3; Schur's test: the same, with weights 1; the energy is ours, as in the Ritz method
struct Galerkin {
  int degree = 1;  ///< 0 to 4
};

/// The largest degree of the spaces.
inline constexpr int largest_galerkin_degree = 4;

/// Refuses what Galerkin's method does not allow in a problem; see check(problem).
/// Maths     0 <= degree <= 4, exact geometry, a surface whose parts do not hide each other, solver and
///           operator left open or named as there are; rho < 1 everywhere, and rho > 0 everywhere on a piece
///           or 0 on all of it, proved by balls; a plan within `memory_limit` bytes at every level
void check(const Problem& problem, const Galerkin& method, const Surface& surface,
           std::uint64_t memory_limit);

/// An upper bound below 1 of the reflectivity on a surface, proved by balls.
/// Requires  a problem that was checked
[[nodiscard]] double reflectivity_bound(const Problem& problem, const Surface& surface);

/// The memory of one level: the matrix, 8 n^2 bytes for n unknowns, points of rules that are kept, vectors.
[[nodiscard]] MemoryPlan galerkin_plan(const Galerkin& method, std::uint64_t elements);

/// Solves a problem by Galerkin's method at one level.
/// Maths     see Galerkin. In functions that are orthonormal with the weight 1/rho the system is (I - A) x =
///           b, x^T (I - A) x >= (1 - rho_max) x^T x for exact integrals, definiteness_as_stored for those at
///           hand, solved by conjugate gradients. With the residual r of the computed x, entries and masses
///           off by no more than eta in the 2-norm and b by delta, |x - exact| <= (|r| + eta |x| + delta) /
///           ((1 - rho_max)(1 - eta)), which bounds the L2 norm of the error of u_n, since 1/rho >= 1
/// Requires  a checked problem with this method
/// Result    nodes: a lattice inside each element, at which u_n, u and E are told; node_error = max over them
///           of |u - u_n|; discretisation_error is absent. E = u - Ku at the points of the load's rule.
///           The same bits for any number of threads. Throws AccuracyNotReached where a row of a closed
///           surface does not sum to that of Int G = pi within its radius, where the radii of the integrals
///           leave nothing of 1 - rho_max, or numbers run over the range of double; InputError naming a point
///           where an expression is not finite; Interrupted when asked to stop
/// Limits    radii are estimates, since those of the integrals are
[[nodiscard]] LevelOutcome solve(const Problem& problem, const Galerkin& method, int level,
                                 const OperatorRoute& route);

}  // namespace radcert
