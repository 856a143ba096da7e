// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/claims/psg10/figures/figure.h"

namespace radcert::verification::psg10 {

Figure draw_figure_3(const FigureWish& wish, const FigureProgress& progress);
Figure draw_figure_5(const FigureWish& wish, const FigureProgress& progress);
Figure draw_figure_6(const FigureWish& wish, const FigureProgress& progress);
Figure draw_figure_7(const FigureWish& wish, const FigureProgress& progress);
Figure draw_figure_8(const FigureWish& wish, const FigureProgress& progress);
Figure draw_figure_8_direct(const FigureWish& wish, const FigureProgress& progress);
Figure draw_figure_8_shepard(const FigureWish& wish, const FigureProgress& progress);
Figure draw_figure_8_gaussian(const FigureWish& wish, const FigureProgress& progress);
Figure draw_figure_8_lehtinen(const FigureWish& wish, const FigureProgress& progress);
Figure draw_figure_9(const FigureWish& wish, const FigureProgress& progress);

}  // namespace radcert::verification::psg10
