// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/figures/figures.h"

namespace radcert::verification::psg10 {

const std::vector<FigureKind>& figure_kinds() {
  const auto in_the_room = [](std::string_view name, std::string_view summary, auto* make) {
    return FigureKind{.name = name,
                      .summary = summary,
                      .width = 800,
                      .height = 620,
                      .has_separation = true,
                      .has_seed = true,
                      .has_direct = true,
                      .has_white = true,
                      .has_rays = true,
                      .make = make};
  };
  static const std::vector<FigureKind> all = [&] {
    std::vector<FigureKind> kinds{
        {"figure_3", "a scene and 1000 sites on it", 640, 1000, false, true, false, false, true,
         draw_figure_3},
        {"figure_5", "the two distances of sites, as 1/(1+d)", 1200, 460, false, false, false, false, true,
         draw_figure_5},
        {"figure_6", "the elements of the three bases on a line, and what interpolates four values", 0, 0,
         false, false, false, false, false, draw_figure_6},
        {"figure_7", "a scene, and a column of its transfer matrix", 1200, 480, true, true, false, true, true,
         draw_figure_7},
        in_the_room("figure_8", "a room lit by a lamp: the four pictures that follow, together",
                    draw_figure_8),
        in_the_room("figure_8_direct", "its direct light", draw_figure_8_direct),
        in_the_room("figure_8_shepard", "all its light by Shepard's basis", draw_figure_8_shepard),
        in_the_room("figure_8_gaussian", "the same by the Gaussian basis, changed as below",
                    draw_figure_8_gaussian),
        in_the_room("figure_8_lehtinen", "the same by Lehtinen's basis", draw_figure_8_lehtinen),
        {"figure_9", "the sphere over the disk, and its sites", 1200, 480, true, true, false, true, true,
         draw_figure_9}};
    kinds[4].width = 1200;
    kinds[4].height = 960;
    return kinds;
  }();
  return all;
}

}  // namespace radcert::verification::psg10
