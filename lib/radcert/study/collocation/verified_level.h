// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/study/operator_route.h"
#include "radcert/study/problem.h"
#include "radcert/study/study.h"

namespace radcert {

/// Solves a problem at one level with a proof.
/// Maths     (I - K_n) d = K(I - P_n)u with d = u - u_n at the nodes, u given; (I - K_n) u_n = E, E given.
///           Entries of K_n, u, rho, E and Ku are enclosed at nodes that are known exactly: their elements
///           have vertices that are doubles, of a graded triangulation rounded ones, and their barycentric
///           coordinates are rational, or stand for irrational ones. d and u_n are enclosed for all systems
///           within the radii. With an interpolated geometry K_n is that of the interpolant, the data and Ku
///           are those of S
/// Source    [ac98, (40)-(41)]; certified_plane_entries and plane_operator where S is plane and u a
///           polynomial of at most degree 8 on it, certified_collocation elsewhere, certified_chart_entries
///           and certified_operator on interpolants; verified_system. Held as clusters, where `operator` is
///           h2, K_n is enclosed by its products, EnclosedClusters, and the solution found in doubles is
///           proved by contracting_solution: theta is then a norm of K_n itself, with R = I
/// Requires  a checked problem with solver `verified`; `level` need not be one of its levels
/// Result    discretisation_error and node_error are guaranteed: their radii bound what quadrature, rounding
///           and the solution of the system may have changed; so is the radius of u_n at each node. The
///           collocation system is proved to have one solution. The same bits for any number of threads.
///           Throws InputError as solve_level; AccuracyNotReached with the reason where a guarantee is not to
///           be had: a problem posed on an interpolant, or one whose points are rounded to double, a surface
///           that is not proved to lie in the boundary of a convex body, an expression that is not proved to
///           have its value, a reflectivity that is not proved to lie in [0,1] at the nodes or, where S is
///           closed or E given, below 1 on S; Interrupted when asked to stop. The radii are those that the
///           problem's quadrature tolerance asks for, or up to 64 times as wide where double holds no more
/// Limits    uniform_error, piece_means and, on open surfaces, norm_K are not proved. The superconvergent
///           alpha of an odd degree is the rational number within 10^-100 that stands for it, the irrational
///           coordinates of symmetric nodes have 60 digits and those of a file 70, and vertices of a graded
///           triangulation that are no doubles are the rounded ones, see grading_in_double;
///           require_known_layers refuses the level where that is another triangulation
LevelOutcome verified_level(const Problem& problem, int level, const OperatorRoute& route);

}  // namespace radcert
