// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/scalar/approximation.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/study/problem.h"

namespace radcert {

/// The proof of `verified`.
struct VerifiedReport {
  /// < 1: bounds a norm of I - R (I - K_n), so that I - K_n is regular; R an approximate inverse, I with h2
  double theta = 0;
};

/// What is known of the iterated solution uhat = E + K u_n of a level.
/// Maths     maxima over check points on every element, and over the nodes; see describe_iterated
/// Result    with `emission` there are no errors
/// Limits    maxima over a sample are lower bounds of the supremum
struct IteratedReport {
  std::uint64_t check_points = 0;
  std::optional<Approximation> u_n_error;                       ///< max |u - u_n| over the check points
  std::optional<Approximation> node_error;                      ///< max |u - uhat| over the nodes
  Approximation difference = Approximation::without_radius(0);  ///< max |uhat - u_n| over the check points
  std::optional<double> l2_error = std::nullopt;    ///< as that of u_n, by a rule of degree 2 an element
  std::optional<double> mean_error = std::nullopt;  ///< as that of u_n, by the same rule
  std::vector<std::pair<std::string, double>> piece_means = {};  ///< of uhat, by the same rule
  std::optional<double> ratio = std::nullopt;  ///< of iterated_error: the previous level's over this one's
  std::optional<double> u_n_ratio = std::nullopt;
  std::optional<double> order = std::nullopt;
  std::optional<double> u_n_order = std::nullopt;
};

/// One level of a study.
/// Maths     discretisation_error = max over the nodes of |K(I-P_n)u|, node_error = max over the nodes of |u
///           - u_n|, uniform_error = max of |u - u_n| over `uniform_sample`
/// Source    [ac98, section 5]
/// Result    with `emission` the three errors are absent
/// Limits    radii hold what quadrature, geometry and rounding may have changed; estimates unless they say
///           guaranteed
struct LevelResult {
  int level = 0;
  std::uint64_t elements = 0;
  std::uint64_t unknowns = 0;
  double mesh_size = 0;
  std::optional<Approximation> discretisation_error;
  std::optional<Approximation> node_error;
  std::optional<Approximation> uniform_error;
  /// (Int_S (u - u_n)^2 dS)^(1/2), by a rule on each element; without a radius but for Galerkin's method
  std::optional<Approximation> l2_error = std::nullopt;
  /// The largest |mean of u - u_n| over a piece, by that rule
  std::optional<Approximation> mean_error = std::nullopt;
  std::optional<Approximation> iterated_error = std::nullopt;  ///< max |u - uhat| over the check points
  std::optional<double> discretisation_ratio;                  ///< error_ratio of the previous level and this
  std::optional<double> node_ratio;
  std::optional<double> discretisation_order;  ///< log of the ratio over log of the mesh sizes' ratio
  std::optional<double> node_order;
  std::vector<std::pair<std::string, Approximation>> piece_means;  ///< mean of u_n over each piece
  /// The largest radius of u_n at a node: what quadrature, rounding and the solution of the system may have
  /// changed. Proved with `verified`, an estimate else; absent: not known.
  std::optional<double> solution_radius = std::nullopt;
  Approximation norm_K;
  std::string matrix_form = "dense";         ///< how the matrix was held: dense or h2, which `auto` chooses
  std::string solver = {};                   ///< the one that was taken, which `auto` chooses
  std::optional<IterationReport> iteration;  ///< of `gmres` and `neumann`
  std::optional<VerifiedReport> verified;    ///< of `verified`
  std::optional<IteratedReport> iterated = std::nullopt;  ///< where the problem asks for it
  std::uint64_t planned_bytes = 0;
};

/// A fitted order: slope of log error over log h, least squares, halfwidth from the spread of the successive
/// orders. See asymptotic_law for the levels that it begins with.
struct OrderFit {
  /// "discretisation_error", "node_error"; "l2_error" and "mean_error" with Galerkin's method; with the
  /// iterated solution "iterated_error" and "u_n_error" too
  std::string quantity;
  std::optional<double> order;
  std::optional<double> halfwidth;  ///< absent with two levels, which have one slope
  std::vector<int> levels;          ///< that took part
  std::vector<int> left_out;        ///< whose radius exceeds 5 % of their error
  /// Coarser than those that took part: before the problem's fit_from, or with slopes that are not steady yet
  std::vector<int> pre_asymptotic = {};
  std::string model = "h^p";
};

/// How long the parts of a level took, in seconds of the clock.
struct LevelTiming {
  double assembly_seconds = 0;
  double operator_seconds = 0;  ///< Ku by the second route
  double solve_seconds = 0;
  double iterated_seconds = 0;  ///< of K u_n at the check points
};

/// A problem solved over its levels.
/// Result    levels and timing in the order of the problem's levels; everything but timing is the same to the
///           bit on every run
struct Result {
  Problem problem;
  std::vector<LevelResult> levels;
  std::vector<OrderFit> orders;
  std::vector<LevelTiming> timing;
  std::optional<SolutionEnclosure> enclosure =
      std::nullopt;  ///< of a problem with a guarantee; `levels` has its mesh
};

}  // namespace radcert
