// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "radcert/picture/rendering.h"
#include "verification/claims/psg10/figures/figures.h"
#include "verification/claims/psg10/figures/panels.h"

namespace radcert::verification::psg10 {

Figure draw_figure_5(const FigureWish& wish, const FigureProgress& progress) {
  const LitRoom room = lit_room();
  const RayCaster caster = caster_of(room);
  const Site<double> q{.point = {2.375, 4, 1.25}, .normal = {0, -1, 0}};
  const auto euclidean = [q](const LitPoint& at) -> std::optional<double> {
    return 1 / (1 + norm(at.site.point - q.point));
  };
  const auto normal_sensitive = [q](const LitPoint& at) -> std::optional<double> {
    // Infinite where the normals are not within 90 degrees.
    const double cosine = std::max(0.0, dot(at.site.normal, q.normal));
    return cosine == 0 ? 0 : 1 / (1 + norm(at.site.point - q.point) / cosine);
  };
  const Paint paint{.scale = {.kind = ColourScale::Kind::map, .low = 0, .high = 1},
                    .outline = 0.6,
                    .outline_colour = grey(0.5)};
  Sheet sheet = sheet_of(wish, 2, 1, true);
  Figure figure{.shows =
                    "psg10, figure 5: 1/(1 + distance from X), Euclidean and by (15), with points "
                    "in its numerator",
                .facts = {{"scene", "lit_room"}, {"X", "(2.375, 4, 1.25), on the back wall"}}};
  progress(0.1, "Euclidean");
  const ImageRegion left = sheet.panel(0, 0, "1/(1+d), d the Euclidean distance from X");
  add_counts(figure, "Euclidean",
             show_scene(sheet, left, room.camera, wish, caster, shared(euclidean), paint));
  mark(sheet.image, left, room.camera, q, 0.08);
  progress(0.55, "normal-sensitive");
  const ImageRegion right = sheet.panel(1, 0, "the same by (15), sensitive to normals");
  add_counts(figure, "normal-sensitive",
             show_scene(sheet, right, room.camera, wish, caster, shared(normal_sensitive), paint));
  mark(sheet.image, right, room.camera, q, 0.08);
  sheet.add_scale(right, paint.scale);
  figure.sheet = std::move(sheet);
  return figure;
}

}  // namespace radcert::verification::psg10
