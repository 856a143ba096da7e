// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot_files.h"

#include <vector>

#include "radcert/formats/plot/latex_plot.h"
#include "radcert/formats/plot/svg_plot.h"

namespace radcert::app {

Files plot_files(const std::filesystem::path& folder, std::span<const NamedPlot> plots) {
  Files files;
  std::vector<Plot> all;
  for (const NamedPlot& named : plots) {
    files.emplace_back(folder / (named.name + ".svg"), svg_text(named.plot));
    files.emplace_back(folder / (named.name + ".tex"), latex_plot_text(named.plot));
    all.push_back(named.plot);
  }
  if (!all.empty()) files.emplace_back(folder / "plot.tex", latex_plots_text(all));
  return files;
}

}  // namespace radcert::app
