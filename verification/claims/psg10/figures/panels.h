// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/sampling.h"
#include "radcert/picture/curve_panel.h"
#include "radcert/picture/drawing.h"
#include "radcert/picture/ray_caster.h"
#include "radcert/picture/rendering.h"
#include "verification/claims/psg10/figures/figure.h"
#include "verification/claims/psg10/scenes/lit_room.h"

namespace radcert::verification::psg10 {

inline constexpr Colour ink{0.02, 0.02, 0.02};
inline constexpr Colour dark_line = grey(0);
inline constexpr Colour mark_colour{0.8, 0.05, 0.02};

inline double as_double(std::size_t n) { return static_cast<double>(n); }
inline std::size_t pixels(double length) {
  return static_cast<std::size_t>(std::max(1.0, std::round(length)));
}

/// Panels in rows and columns, each with its title above, and a strip to the right of all.
class Sheet {
public:
  Sheet(const FigureWish& wish, std::size_t columns, std::size_t rows, bool with_scale)
      : image(wish.width, wish.height),
        text(std::clamp(std::min(as_double(wish.height / rows) / 34, as_double(wish.width / columns) / 42),
                        5.0, 36.0)),
        columns_(columns),
        rows_(rows),
        strip_(with_scale ? pixels(7 * text) : 0) {}

  /// Where the panel of a place is shown; its title is written.
  ImageRegion panel(std::size_t column, std::size_t row, std::string_view title) {
    const std::size_t gap = pixels(text);
    const std::size_t above = pixels(2.4 * text);
    const std::size_t width = part(image.width() - strip_, (columns_ + 1) * gap, columns_);
    const std::size_t height = part(image.height(), gap + rows_ * above, rows_);
    const ImageRegion region{.x = std::min(gap + column * (width + gap), image.width() - width),
                             .y = std::min(row * (height + above) + above, image.height() - height),
                             .width = width,
                             .height = height};
    if (text_width(text, title) <= as_double(width))
      draw_text(image, {as_double(region.x), as_double(region.y) - 0.7 * text}, text, title, ink);
    return region;
  }

  /// The colours of a scale, in the strip, as high as the panels.
  void scale(const ImageRegion& beside, const ColourScale& scale) {
    const std::size_t x = image.width() - strip_;
    draw_scale(image, {.x = x, .y = beside.y, .width = image.width() - x, .height = beside.height}, scale,
               text);
  }

  Image image;
  double text;  ///< height of capital letters

private:
  static std::size_t part(std::size_t whole, std::size_t taken, std::size_t count) {
    return whole > taken + count ? (whole - taken) / count : 1;
  }
  std::size_t columns_;
  std::size_t rows_;
  std::size_t strip_;
};

/// The pose with an angle so wide that a panel which is narrower than the scene wants it still shows all from left to right.
[[nodiscard]] CameraPose fitted_to(CameraPose pose, const ImageRegion& panel);

[[nodiscard]] RayCaster caster_of(const LitRoom& room);

/// The same number for every thread: a function that needs no room of its own.
[[nodiscard]] std::function<PointValue()> shared(PointValue value);

/// As if lit from the eye: the albedo, darker where a surface is seen aslant.
[[nodiscard]] std::function<PointValue()> seen_by_headlight(const LightScene& scene,
                                                            const Vector<double>& eye);

/// An X on the surface about a point, `size` from its middle to its ends.
void mark(Image& image, const ImageRegion& panel, const CameraPose& pose, const Site<double>& site,
          double size);

/// Sites as dots, those that are not seen small and pale.
/// Result    how many are seen
std::size_t draw_sites(Image& image, const ImageRegion& panel, const CameraPose& pose,
                       const RayCaster& caster, const SiteSet& sites);

/// What the rays found, for the record.
void add_counts(Figure& figure, const std::string& name, const Seen& seen);

[[nodiscard]] double room_separation(const FigureWish& wish);

/// Value, or InputError: sites and bases refuse what the user's separation brought about.
template <class T>
T accepted(Outcome<T> outcome, const FigureWish& wish) {
  if (!outcome)
    throw InputError({.source = "--separation",
                      .value = wish.separation ? std::optional(shortest(*wish.separation)) : std::nullopt,
                      .problem = "gives no picture: " + outcome.reason(),
                      .allowed = "another separation or seed"});
  return std::move(outcome).value();
}

/// Refuses sites whose transfer matrix does not fit, twice: the series is made of a copy.
void require_memory(const LightScene& scene, const PoissonDiskSites& sites, const FigureWish& wish);

/// How far the weights of a figure are integrated: errors below what a pixel shows.
inline constexpr IntegrationDemand for_pictures{.relative_error = 1e-2, .most_points = 400'000};

}  // namespace radcert::verification::psg10
