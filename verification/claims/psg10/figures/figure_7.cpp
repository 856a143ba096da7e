// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/sampling.h"
#include "verification/claims/psg10/figures/figures.h"
#include "verification/claims/psg10/figures/panels.h"

namespace radcert::verification::psg10 {

Figure draw_figure_7(const FigureWish& wish, const FigureProgress& progress) {
  const LitRoom room = lit_room();
  const RayCaster caster = caster_of(room);
  progress(0, "the sites");
  const RadialBasis basis = accepted(
      RadialBasis::make(accepted(poisson_disk_sites(room.scene.surface(),
                                                    {.separation = room_separation(wish), .seed = wish.seed}),
                                 wish),
                        lehtinen_basis()),
      wish);
  const SiteSet& sites = basis.sites();
  // The site of the left wall that is nearest to a point of it.
  const Vector<double> wanted{0, 1.5, 1.25};
  std::size_t column = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (const double d = norm(sites.points[i] - wanted); sites.normals[i].x > 0.5 && d < nearest)
      nearest = d, column = i;
  progress(0.05, "the weights");
  const std::vector<double> weights = integrate_basis(basis, room.scene.surface(), for_pictures).weights;
  progress(0.3, "the transfer matrix");
  transfer_memory(sites.size(), 1).require(wish.memory);
  const Matrix<double> matrix = point_light_transfer(room.scene, sites, weights);
  const auto lit = matrix.column(column);
  const double white = wish.white.value_or(0.008);
  progress(0.6, "rays");
  Sheet sheet = sheet_of(wish, 2, 1);
  Figure figure{.shows =
                    "psg10, figure 7: a scene, and its radiance by light that the element at X sends out, "
                    "scattered once: a column of the transfer matrix",
                .facts = {{"scene", "lit_room"},
                          {"basis", "Lehtinen"},
                          {"separation", room_separation(wish)},
                          {"seed", wish.seed},
                          {"sites", sites.size()},
                          {"column", column},
                          {"weight of the element", weights[column]},
                          {"white", white}}};
  const ImageRegion left = sheet.panel(0, 0, "the scene");
  (void)show_scene(sheet, left, room.camera, wish, caster,
                   seen_by_headlight(room.scene, room.camera.position),
                   {.outline = 0.8, .outline_colour = dark_line});
  mark(sheet.image, left, room.camera, sites[column], 0.08);
  const ImageRegion right = sheet.panel(1, 0, "light of the element at X, scattered once");
  add_counts(figure, "radiance",
             show_scene(sheet, right, room.camera, wish, caster, combination(basis, lit),
                        {.scale = {.high = white}}));
  mark(sheet.image, right, room.camera, sites[column], 0.08);
  figure.sheet = std::move(sheet);
  return figure;
}

}  // namespace radcert::verification::psg10
