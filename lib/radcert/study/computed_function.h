// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/ranks/ranks.h"
#include "radcert/quadrature/collocation_point.h"
#include "radcert/study/study.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The computed function u_n on a surface, whatever the method, element by element of a triangulation.
/// Maths     (k, x) -> u_n(m_k(x)), x barycentric in the element k
/// Requires  what an evaluator gives refers to what its maker refers to
/// Result    where several ranks have parts of the elements, the triangulation is the part here, and what is
///           said of u_n is of all parts; all ranks ask together then
/// Limits    may have two values on the sides of triangles
struct ComputedFunction {
  const Surface& surface;
  const Triangulation& triangulation;
  /// Makes a function for the use of one thread.
  std::function<std::function<double(std::size_t element, const Barycentric<double>& x)>()> evaluator;
  const Ranks& ranks = one_rank();
};

/// Looks at u_n at the points of every element with barycentric coordinates k/8, |k| = 8: 45 points each,
/// corners and sides included.
/// Maths     max |u(p) - u_n(p)| over the sample
/// Source    the sample is ours; [ac98, (50)]
/// Result    nothing if u is not finite at a point of the sample; a lower bound of the supremum
/// Limits    rounding is not estimated
[[nodiscard]] std::optional<Approximation> uniform_error(const ComputedFunction& u_n,
                                                         const PiecewiseExpression& solution);

/// Evaluates u_n over the same sample, for a method whose functions may refuse to have a value somewhere.
void require_values(const ComputedFunction& u_n);

/// The mean of u_n over each piece.
/// Maths     Int_piece u_n dS / Int_piece dS, by a conical rule of that order on each element
/// Result    pieces in the order of the surface, without radius
[[nodiscard]] std::vector<std::pair<std::string, Approximation>> piece_means(const ComputedFunction& u_n,
                                                                             int order);

/// Numbers with one estimated radius for all of them, or with none.
[[nodiscard]] std::vector<Approximation> with_radius(std::span<const double> values,
                                                     std::optional<double> radius);

/// The values of a level at its nodes.
struct NodalValues {
  std::span<const CollocationPoint<double>> nodes;
  std::size_t nodes_per_element = 1;
  std::span<const Approximation> u_n;
  std::span<const double> emission;
  std::span<const double> u;  ///< empty without `solution`
};

/// What every method says of u_n in numbers: uniform_error, mean_errors and piece_means.
/// Result    fills these fields of the result of this level and no others
/// Limits    rounded, not enclosed
void describe_numbers(const Problem& problem, const ComputedFunction& u_n, int mean_order,
                      LevelResult& result);

/// The fields of a level: the values at the nodes, and u_n at the elements' corners.
/// Requires  one rank; a value a node; `outcome` is of this level
void describe_fields(const ComputedFunction& u_n, const NodalValues& values, LevelOutcome& outcome);

/// Both: the description of u_n that every method gives once it is known.
void describe_level(const Problem& problem, const ComputedFunction& u_n, const NodalValues& values,
                    int mean_order, LevelOutcome& outcome);

}  // namespace radcert
