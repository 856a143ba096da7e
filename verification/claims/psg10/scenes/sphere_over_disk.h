// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/meshless/light_scene.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/surface.h"

namespace radcert::verification::psg10 {

/// The scene of section VIII: a sphere above a disk, with the centre on the disk's axis.
/// Maths     pieces `sphere`, |x - (0,0,height)| = radius, lit outside, and `disk`, z = 0, lit above
/// Source    [psg10, section VIII]
/// Requires  0 < radius < height, radius < disk_radius, else ContractViolation
/// Result    eight charts and four; not closed
/// Limits    no sites on the disk's lower side
[[nodiscard]] Surface sphere_over_disk_surface(const Rational& radius = 5, const Rational& disk_radius = 40,
                                               const Rational& height = 20);
/// The same with both in the way of the light. Refused: an albedo outside [0,1).
[[nodiscard]] Outcome<LightScene> sphere_over_disk_light_scene(double albedo = 0.9,
                                                               const Rational& radius = 5,
                                                               const Rational& disk_radius = 40,
                                                               const Rational& height = 20);

}  // namespace radcert::verification::psg10
