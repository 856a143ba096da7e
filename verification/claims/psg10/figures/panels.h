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
#include "radcert/picture/drawing.h"
#include "radcert/picture/ray_caster.h"
#include "radcert/picture/rendering.h"
#include "radcert/picture/sheet.h"
#include "verification/claims/psg10/figures/figure.h"
#include "verification/claims/psg10/scenes/lit_room.h"

namespace radcert::verification::psg10 {

inline constexpr Colour dark_line = grey(0);
inline constexpr Colour mark_colour{0.8, 0.05, 0.02};

inline double as_double(std::size_t n) { return static_cast<double>(n); }

/// The sheet that a figure is wanted on.
[[nodiscard]] Sheet sheet_of(const FigureWish& wish, std::size_t columns, std::size_t rows,
                             bool has_scale = false);

/// The pose with an angle so wide that a panel which is narrower than the scene wants it still shows all from
/// left to right.
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

/// Shows a number on the surface in a panel, as all of it is seen from there. `smooth`: see View.
Seen show_scene(Sheet& sheet, const ImageRegion& panel, const CameraPose& pose, const FigureWish& wish,
                const RayCaster& caster, const std::function<PointValue()>& value, const Paint& paint,
                bool smooth = true);

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
