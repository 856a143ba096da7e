// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <variant>

#include "radcert/geometry/vector.h"
#include "radcert/meshless/light_scene.h"

namespace radcert {

/// Light from a point at infinite distance.
struct ParallelLight {
  Vector<double> towards;  ///< the light, from the scene; of any length but 0
  double power = 1;        ///< that a surface across the light receives, per area
};

/// Light from a point, the same in all directions.
struct PointLight {
  Vector<double> at;
  double intensity = 1;  ///< power per area across the light at the distance 1
};

/// The emission of the surface, by place and normal.
struct SurfaceEmission {
  std::function<double(const LitPoint&)> radiance;
};

/// Where light comes from.
/// Source    [psg10, sections II and VIII]
/// Requires  see direct_radiance
/// Result    plain data
using Light = std::variant<ParallelLight, PointLight, SurfaceEmission>;

/// The radiance of a point by light that was scattered there for the first time: the emittance E of the
/// equation.
/// Maths     parallel: beta mu max(0, n.u), u the unit direction towards the light; point: beta I max(0,
///           n.(y-x))/|y-x|^3; 0 where something stands between; emission: what it says
/// Source    [psg10, (20)]; radiance as colour: a white surface across the light has mu
/// Requires  a direction that is not 0, numbers of at most Scene::largest_coordinate, a radiance that is
///           finite, else ContractViolation
/// Result    rounded; visibility is that of LightScene, for parallel light along a segment as long as four
///           times the scene's reach
/// Limits    blockers farther away than that hide no parallel light; a point light on the surface itself has
///           no value there: 0
[[nodiscard]] double direct_radiance(const LightScene& scene, const Light& light, const LitPoint& at);

}  // namespace radcert
