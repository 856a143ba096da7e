// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/picture/image.h"

namespace radcert {

/// A colour of the perceptual space OKLab, as light.
/// Maths     l, m, s are cubes of sums of lightness, a, b; red, green, blue sums of l, m, s
/// Source    B. Ottosson, A perceptual color space for image processing, 2020
/// Result    rounded; parts outside [0,1] where sRGB has no such colour
[[nodiscard]] Colour colour_of_oklab(double lightness, double a, double b);

/// A colour for a number, so that equal steps look equal and larger ones brighter.
/// Maths     OKLab lightness linear in x, from 0, black, to 0.97; the hue turns from violet by blue, teal and
///           green to yellow
/// Source    the idea of viridis (S. van der Walt, N. Smith, 2015); control points of its own
/// Requires  not NaN, else ContractViolation
/// Result    within sRGB; x below 0 as 0, above 1 as 1; the luminance increases with x
[[nodiscard]] Colour map_colour(double x);

}  // namespace radcert
