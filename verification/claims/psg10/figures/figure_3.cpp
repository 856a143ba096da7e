// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/sampling.h"
#include "verification/claims/psg10/figures/figures.h"
#include "verification/claims/psg10/figures/panels.h"

namespace radcert::verification::psg10 {

Figure draw_figure_3(const FigureWish& wish, const FigureProgress& progress) {
  const LitRoom room = lit_room();
  const RayCaster caster = caster_of(room);
  Sheet sheet = sheet_of(wish, 1, 2);
  progress(0.1, "the scene");
  const ImageRegion upper = sheet.panel(0, 0, "the scene");
  const Paint plain{.outline = 0.8, .outline_colour = dark_line};
  (void)show_scene(sheet, upper, room.camera, wish, caster,
                   seen_by_headlight(room.scene, room.camera.position), plain);
  progress(0.6, "the sites");
  constexpr std::size_t count = 1000;
  const SiteSet sites = uniform_sites(room.scene.surface(), {.count = count, .seed = wish.seed}).value();
  const ImageRegion lower = sheet.panel(0, 1, "1000 sites anywhere on it; pale: on what is not seen");
  const Paint faint{.scale = {.low = -12, .high = 1}, .outline = 0.5, .outline_colour = dark_line};
  (void)show_scene(sheet, lower, room.camera, wish, caster,
                   seen_by_headlight(room.scene, room.camera.position), faint);
  const std::size_t seen = draw_sites(sheet.image, lower, room.camera, caster, sites);
  return {
      .shows = "psg10, figure 3: a scene and sites that are anywhere on it with equal chance by area",
      .facts = {{"scene", "lit_room"}, {"sites", sites.size()}, {"sites seen", seen}, {"seed", wish.seed}},
      .sheet = std::move(sheet)};
}

}  // namespace radcert::verification::psg10
