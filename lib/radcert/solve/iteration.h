// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "radcert/core/files/kept_numbers.h"
#include "radcert/core/outcome.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/system_matrix.h"

namespace radcert {

/// The least relative tolerance that can be demanded of an iteration in double.
inline constexpr double least_tolerance = 0x1p-51;

/// A vector and a bound of its distance from the solution.
struct IterativeSolution {
  std::vector<double> values;
  std::size_t iterations = 0;
  double error_bound = 0;  ///< >= max_i |u_i - v_i|, proved
};

/// The best that an iteration came to that did not reach its goal.
struct NotReached {
  std::size_t iterations = 0;
  double error_bound = 0;  ///< infinite where the iteration ran over the largest numbers
  double size = 0;         ///< max_i |v_i|
};

/// How residuals become corrections.
/// Requires  one application shrinks ||r||_w by the contraction's theta at least, but for rounding, as
///           v <- v + r does: the number of steps is planned from it
struct Correction {
  /// A residual becomes a correction, in place; gives the number of iterations that took, in all no more than
  /// the steps that are planned from theta. `goal`: a size ||r||_w of the residual that is small enough.
  std::function<std::size_t(std::span<double> residual, double goal)> apply;
  /// The corrections v <- v + r of the Neumann series that one application is worth at most.
  std::size_t reflections = 1;
};

/// Corrects v until its error bound is small enough.
/// Maths     from v = e: r = e - (I - K) v, v <- v + (correction of r), until the bound ||r||_w/(1 - theta)
///           of max |u - v| is at most `tolerance` max |v|. Without a tolerance: until ||r||_w <= 2 u
///           ||v||_w, about what rounding the solution to double leaves, or rounding stops the descent
/// Source    iterative refinement: Higham, Accuracy and Stability of Numerical Algorithms (2002), chapter 12
/// Requires  a contraction of k; finite e of k's size; tolerance absent or in [least_tolerance, 1)
/// Result    a vector whose bound keeps to the goal, the bound made of a residual computed after the last
///           correction and of the rounding errors of that residual. NotReached: when ||r||_w has not halved
///           over m corrections with ((1 + theta)/2)^m <= 1/2, where v <- v + r would without rounding make
///           it a quarter, or after as many as theta plans, or at once where it plans more than 10^6 single
///           reflections; without a tolerance, then, only if ||r||_w also exceeds what rounding can do, 4 u
///           (1 + theta)/(1 - theta) ||v||_w, an operator's rounding added. The same bits for any number of
///           ranks and threads; Interrupted when asked to stop. After each correction the first rank keeps v
///           and how far the descent has come: an iteration of the same system that finds them goes on from
///           there, to the same bits
/// Limits    a bound of the error of the linear system alone, whose matrix and right-hand side are taken as
///           exact. For an operator a bound as far as its rounding() is one
Outcome<IterativeSolution, NotReached> iterate(const SystemProducts& k, const Contraction& contraction,
                                               std::span<const double> e, std::optional<double> tolerance,
                                               const Correction& correction, KeptNumbers* kept = nullptr);

/// Bounds of |r_i|, given the computed residual of v.
/// Maths     |r_i| + u |r_i| + ((n + 4) u)^2 (|e_i| + |v_i| + theta w_i ||v||_w), which bounds (|K| |v|)_i
///           too; with an operator rounding() max|v| more
/// Source    accurate_residual
/// Requires  vectors of the contraction's size; `residual` from accurate_residual
/// Result    rounded up
/// Limits    as accurate_residual
std::vector<double> residual_bounds(const SystemProducts& k, const Contraction& contraction,
                                    std::span<const double> v, std::span<const double> e,
                                    std::span<const double> residual);

}  // namespace radcert
