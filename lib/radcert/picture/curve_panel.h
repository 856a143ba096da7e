// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radcert/picture/camera.h"
#include "radcert/picture/image.h"
#include "radcert/picture/rendering.h"

namespace radcert {

/// A curve through points (x, y) of a panel.
struct PanelCurve {
  std::vector<ImagePoint> points{};  ///< in the units of the axes, y upwards
  Colour colour{};
  double width = 1;  ///< in hundredths of the panel's height
};

/// Curves over two linear axes.
struct CurvePanel {
  std::string title{};
  std::string x_name{};
  std::string y_name{};
  double low_x = 0;
  double high_x = 1;
  double low_y = 0;
  double high_y = 1;
  std::vector<PanelCurve> curves{};  ///< later ones lie above
  std::vector<ImagePoint> marks{};   ///< dots, above all curves
};

/// Draws curves with a frame, ticks and their numbers.
/// Maths     none
/// Source    -
/// Requires  low_x < high_x, low_y < high_y, finite points, names of printable ASCII, a region of the image,
///           else ContractViolation
/// Result    the curves are cut off at the frame; ticks as axis_ticks; a thin line at y = 0 if it is within
/// Limits    in a region of less than some 150 by 100 pixels there is no room for numbers and words, and none
///           are drawn
void draw_panel(Image& image, const ImageRegion& region, const CurvePanel& panel);

/// Draws a bar with the colours of a scale and its numbers to the right of it.
/// Maths     linear from low, below, to high, above
/// Source    -
/// Requires  a region of the image, else ContractViolation
/// Result    the bar is as wide as the numbers are high; nothing where the region is too small for them
/// Limits    -
void draw_scale(Image& image, const ImageRegion& region, const ColourScale& scale, double text_height);

}  // namespace radcert
