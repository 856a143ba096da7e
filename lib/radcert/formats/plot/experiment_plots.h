// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "radcert/formats/plot/svg_plot.h"
#include "radcert/study/experiment.h"

namespace radcert {

/// A plot and the name of its file, without the extension.
struct NamedPlot {
  std::string name;
  Plot plot;
};

/// The plots of an experiment.
/// Maths     each of error_kinds() against h, against the unknowns, and against alpha
/// Source    -
/// Requires  a result of collect for each combination, in their order
/// Result    against h and the unknowns, where a combination has two levels: a series a combination, its fitted order with
///           halfwidth in the name. Against alpha, where at least three combinations differ in nothing else: a series for each of
///           the others' choices and each level, the superconvergent alphas marked
/// Limits    orders of uniform_error are of all levels: it has no radius. Levels with an error of zero are left out. Order +- halfwidth is the spread of the slopes, no guarantee
[[nodiscard]] std::vector<NamedPlot> experiment_plots(const Experiment& experiment,
                                                      std::span<const Result> results);

}  // namespace radcert
