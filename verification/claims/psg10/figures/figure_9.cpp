// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <numbers>

#include "radcert/meshless/light_solution.h"
#include "verification/claims/psg10/figures/figures.h"
#include "verification/claims/psg10/figures/panels.h"
#include "verification/claims/psg10/scenes/sphere_over_disk.h"

namespace radcert::verification::psg10 {

Figure draw_figure_9(const FigureWish& wish, const FigureProgress& progress) {
  const LightScene scene = sphere_over_disk_light_scene().value();
  const std::array<RoundBlocker, 2> bodies{
      {{.shape = BallBlocker{.centre = {0, 0, 20}, .radius = 5}, .piece = "sphere"},
       {.shape = DiskBlocker{.centre = {0, 0, 0}, .normal = {0, 0, 1}, .radius = 40}, .piece = "disk"}}};
  const RayCaster caster = RayCaster::make(scene.surface(), bodies).value();
  const CameraPose pose{
      .position = {0, -95, 45}, .look_at = {0, 0, 5}, .vertical_angle = std::numbers::pi / 4.5};
  const double separation = wish.separation.value_or(3);
  const ParallelLight light{.towards = {0, 0, 1}, .power = 0.9};
  progress(0, "the solution");
  const TransferChoice choice{
      .meshless = {.basis = lehtinen_basis(),
                   .sites = PoissonDiskSites{.separation = separation, .seed = wish.seed}},
      .integration = for_pictures};
  require_memory(scene, {.separation = separation, .seed = wish.seed}, wish);
  const LightTransfer transfer = accepted(LightTransfer::make(scene, choice), wish);
  const LightSolution solution = accepted(transfer.solve(light), wish);
  const double white = wish.white.value_or(1);
  Sheet sheet = sheet_of(wish, 2, 1);
  Figure figure{
      .shows = "psg10, figure 9: the sphere over the disk, and sites with a least distance from each other",
      .facts = {{"scene", "sphere_over_disk"},
                {"separation", separation},
                {"seed", wish.seed},
                {"sites", transfer.basis().size()},
                {"white", white},
                {"light", "direct exact, the rest in Lehtinen's basis"}}};
  progress(0.5, "rays");
  const ImageRegion left = sheet.panel(0, 0, "lit from above");
  const auto make = [indirect = combination(transfer.basis(), solution.indirect), &scene, &light] {
    return [of_point = indirect(), &scene, &light](const LitPoint& at) {
      std::optional<double> radiance = of_point(at);
      if (radiance) *radiance += direct_radiance(scene, light, at);
      return radiance;
    };
  };
  const Colour night = grey(0.02);
  add_counts(figure, "radiance",
             show_scene(sheet, left, pose, wish, caster, make,
                        {.scale = {.high = white}, .background = night}, false));
  const ImageRegion right = sheet.panel(1, 0, "its sites; pale: not seen");
  (void)show_scene(sheet, right, pose, wish, caster, seen_by_headlight(scene, pose.position),
                   {.scale = {.low = -12, .high = 1}, .outline = 0.7, .outline_colour = dark_line});
  const std::size_t seen = draw_sites(sheet.image, right, pose, caster, transfer.basis().sites());
  figure.facts.emplace_back("sites seen", seen);
  figure.sheet = std::move(sheet);
  return figure;
}

}  // namespace radcert::verification::psg10
