// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "origin.h"
#include "radcert/formats/plot/plot.h"

namespace radcert::app {

/// The files of plots: each as NAME.svg and NAME.tex, and plot.tex with all of them; none without a plot.
Files plot_files(const std::filesystem::path& folder, std::span<const NamedPlot> plots);

}  // namespace radcert::app
