// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/formats/plot/convergence_plot.h"
#include "radcert/study/experiment.h"

namespace radcert {

/// An error of some combinations of an experiment against the mesh size or the unknowns.
/// Requires  a result of collect for each combination, in their order; places in experiment.combinations
[[nodiscard]] Plot combinations_plot(const Experiment& experiment, std::span<const Result> results,
                                     std::span<const std::size_t> places, const ErrorKind& kind,
                                     ErrorAgainst against);

/// The plots of an experiment.
/// Maths     each of error_kinds() against h, against the unknowns, and against alpha
/// Requires  a result of collect for each combination, in their order
/// Result    against h and the unknowns, where a combination has two levels: combinations_plot of all.
///           Against alpha, where at least three combinations differ in nothing else: a curve for each of the
///           others' choices and each level, the superconvergent alphas marked
/// Limits    orders of uniform_error heed no radius: it has none
[[nodiscard]] std::vector<NamedPlot> experiment_plots(const Experiment& experiment,
                                                      std::span<const Result> results);

}  // namespace radcert
