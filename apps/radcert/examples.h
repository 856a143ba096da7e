// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace radcert::app {

/// A problem of apps/examples/01_solve or an experiment of apps/examples/experiments, embedded at build.
struct Example {
  std::string_view name;  ///< the file's name without number and extension
  std::string_view text;
};

/// In the order of their numbers; the first is the example of a problem.
std::span<const Example> examples();

/// Experiments, by their names; the first is the example of an experiment.
std::span<const Example> experiment_examples();

}  // namespace radcert::app
