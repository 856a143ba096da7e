// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/picture/camera.h"
#include "radcert/picture/image.h"

namespace radcert {

/// A line through points, with smooth edges.
/// Maths     coverage of a pixel: 1/2 + width/2 - distance of its middle from the line, cut off to [0,1]; for
///           lines thinner than a pixel times the width
/// Requires  width > 0, opacity in [0,1], finite points, else ContractViolation
/// Result    joints and crossings of the line with itself are not darker than the rest; what lies outside of
///           `within` is left out
/// Limits    round ends
void draw_line(Image& image, const ImageRegion& within, std::span<const ImagePoint> points, double width,
               const Colour& colour, double opacity = 1);

/// A filled circle with a smooth edge; the same requirements.
void draw_disc(Image& image, const ImageRegion& within, const ImagePoint& middle, double radius,
               const Colour& colour, double opacity = 1);

/// A region in one colour.
void fill(Image& image, const ImageRegion& region, const Colour& colour);

}  // namespace radcert
