// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/study/efficiency.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"

namespace radcert {

/// One problem of an experiment.
struct Combination {
  std::string name;  ///< what is varied, in words: "inset of degree 1, alpha 1/6"
  std::vector<std::pair<std::string, std::size_t>> choice;  ///< of each varied key, the place in its list
  Problem problem;
};

/// Problems that differ in a few parts, to be compared.
/// Maths     the product of lists: each combination takes one element of every list, the last list running
///           fastest
/// Source    the file format radcert/experiment/1
/// Requires  every problem states its solution; no two problems are the same
/// Result    plain data
struct Experiment {
  std::string name;
  std::vector<std::string> varied;  ///< keys of a problem, in the order of the file
  std::vector<Combination> combinations;
};

/// The combinations that answer one question: the same integral equation, by different methods.
/// Maths     classes of combinations with the same choice of surface, reflectivity and solution; what is
///           posed on interpolants of S of one degree is a class of its own, since its surface is another
/// Requires  nothing
/// Result    places in experiment.combinations, ascending; the classes in the order of their first
/// Limits    errors of different classes say nothing about methods
[[nodiscard]] std::vector<std::vector<std::size_t>> questions(const Experiment& experiment);

/// An error of a level, by its name in the file formats.
struct ErrorKind {
  std::string name;
  std::optional<Approximation> LevelResult::*figure;
};

/// discretisation_error, node_error, uniform_error, l2_error, mean_error.
[[nodiscard]] const std::vector<ErrorKind>& error_kinds();

/// Whether an error belongs into plots of a study: in L2 and of means those of methods that give them a
/// radius, Galerkin's, lest every plot of collocation have five curves; every other error.
[[nodiscard]] bool is_for_plots(const ErrorKind& kind, std::span<const LevelResult> levels);

/// iterated_error, of problems that ask for the iterated solution.
[[nodiscard]] const ErrorKind& iterated_kind();

/// The levels of a result as points (unknowns, error); levels without a positive error are passed over.
/// Maths     (N_k, e_k)
/// Requires  nothing
/// Result    in the order of the levels
/// Limits    radii play no part
[[nodiscard]] std::vector<CostPoint> error_against_unknowns(const Result& result, const ErrorKind& kind);

/// The same against the seconds of a level: assembly and solution. What Ku costs, which only a stated
/// solution asks for, is no part of a method.
[[nodiscard]] std::vector<CostPoint> error_against_seconds(const Result& result, const ErrorKind& kind);

/// How the errors of a result fall with the unknowns: error ~ N^-order, over the levels of the order in h.
/// Maths     see power_law
/// Requires  a result of collect
/// Result    the fits of result.orders, in N; halfwidth absent with two levels
[[nodiscard]] std::vector<OrderFit> orders_in_unknowns(const Result& result);

}  // namespace radcert
