// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/meshless/light_scene.h"
#include "radcert/meshless/light_source.h"
#include "radcert/picture/camera.h"
#include "radcert/surface/surface.h"

namespace radcert::verification::psg10 {

/// A room with a lamp, to look at.
struct LitRoom {
  LightScene scene;
  PointLight lamp;
  CameraPose camera;  ///< before the front wall, of which one sees the back: it lets through
};

/// A small room: two blocks, turned, a column from the floor to the ceiling, and a lamp under a square shade.
/// Maths     [0,4] x [0,4] x [0,3]; all coordinates multiples of 1/16, so that the doubles are exact; a
///           conforming mesh without faults, closed, of pieces floor, ceiling, back, front, left, right,
///           tall, low, column, shade; albedo constant on each, from 0.1 to 0.8, its mean by area about 0.6
/// Source    designed for radcert, in the manner of [psg10, figure 8]
/// Result    the lamp of intensity 5/2 is at (2, 1.75, 2.1875), below the shade, which keeps its light off
///           most of the ceiling
/// Limits    the lamp is a point without a bulb: shadows are sharp
[[nodiscard]] LitRoom lit_room();

}  // namespace radcert::verification::psg10
