// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "radcert/meshless/light_scene.h"
#include "radcert/meshless/radial_basis.h"
#include "radcert/picture/camera.h"
#include "radcert/picture/image.h"
#include "radcert/picture/ray_caster.h"

namespace radcert {

/// Which colour a number has.
/// Maths     x = (value - low) / (high - low);  light: the amount of light x, by the transfer function of
///           sRGB;  map: map_colour(x)
/// Requires  low < high, both finite
/// Result    plain data
/// Limits    what is below low looks like low, above high like high
struct ColourScale {
  enum class Kind : std::uint8_t { light, map };
  Kind kind = Kind::light;
  double low = 0;
  double high = 1;  ///< of radiance: the white

  [[nodiscard]] Colour colour(double value) const;
};

/// A number for a point of the surface; nothing where it has none.
using PointValue = std::function<std::optional<double>(const LitPoint&)>;

/// How a scene is shown.
struct View {
  CameraPose camera;
  ImageRegion picture;
  std::size_t samples = 2;  ///< samples^2 rays a pixel, on a fixed grid
  bool smooth = false;      ///< one value a pixel does for all of its rays that meet one face
};

/// How numbers become pixels.
struct Paint {
  ColourScale scale{};
  Colour background = grey(1);
  Colour without_value{1, 0, 1};  ///< so that nobody takes it for a number
  double outline = 0;             ///< opacity of a line where one face ends and another begins
  Colour outline_colour = grey(0);
};

/// Counts of what the rays of a picture met, and the range of its values.
struct Seen {
  std::size_t nothing = 0;        ///< rays that meet no face
  std::size_t values = 0;         ///< values that were looked up
  std::size_t without_value = 0;  ///< of them those at points that have none
  std::size_t below = 0;          ///< the scale
  std::size_t above = 0;
  double least = 0;  ///< of all values; 0 where there is none
  double largest = 0;
};

/// Shows a number on the surface by casting rays.
/// Maths     a pixel is the mean of the colours, as light, of samples^2 rays through the middles of equal
///           squares
/// Requires  1 <= samples <= 16, a region of the image, opacity in [0,1], finite values; else
///           ContractViolation. `make` is called once a group of rows, by the thread that uses what it gives
/// Result    the pixels of view.picture are written; where the view is smooth, of the rays of a pixel that
///           meet one face one, about the middle, has its value looked up, the others are given its colour.
///           The same bytes for any number of threads. Interrupted when asked to stop
/// Limits    the eye on no face: see RayCaster
Seen show(Image& image, const View& view, const RayCaster& caster, const std::function<PointValue()>& make,
          const Paint& paint);

/// A combination of a basis as a number for `show`: what gives a PointValue with room of its own.
[[nodiscard]] std::function<PointValue()> combination(const RadialBasis& basis,
                                                      std::span<const double> coefficients);

}  // namespace radcert
