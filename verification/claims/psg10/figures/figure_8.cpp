// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/expression/parse.h"
#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/sampling.h"
#include "verification/claims/psg10/figures/figures.h"
#include "verification/claims/psg10/figures/panels.h"

namespace radcert::verification::psg10 {
namespace {

/// What figure 8 shows of the light.
struct LightShown {
  std::string_view title;
  RadialBasisChoice basis;
  CoefficientRule coefficients = CoefficientRule::as_values;
  std::string_view remark;  ///< where it is not as the paper has it
  bool direct_alone = false;
};

LightShown direct_light() {
  return {.title = "direct light", .basis = lehtinen_basis(), .remark = "", .direct_alone = true};
}
LightShown by_shepard() { return {.title = "Shepard's basis", .basis = shepard_basis(), .remark = ""}; }
LightShown by_gauss() {
  // G(4 r), up to r = 1: radii of a quarter.
  RadialBasisChoice basis = gaussian_basis();
  basis.mother =
      expression_mother(parse_expression("exp(-8*r^2)", ExpressionVariables::radius).value(), Rational(1));
  basis.radius.too_few = TooFewNeighbours::farthest;
  return {.title = "Gaussian basis, radii/4, interpolated",
          .basis = std::move(basis),
          .coefficients = CoefficientRule::interpolated,
          .remark =
              "radii are a quarter of the paper's and coefficients interpolate: with the paper's the "
              "iteration diverges"};
}
LightShown by_lehtinen() { return {.title = "Lehtinen's basis", .basis = lehtinen_basis(), .remark = ""}; }

void draw_lamp(Image& image, const ImageRegion& panel, const LitRoom& room, const RayCaster& caster) {
  const PinholeCamera camera(fitted_to(room.camera, panel));
  const auto at = camera.image_of(room.lamp.at, panel);
  const auto hit = caster.first(camera.position(), room.lamp.at);
  if (!at || (hit && hit->distance < 1)) return;
  const double radius = std::max(1.5, as_double(panel.height) / 90);
  draw_disc(image, panel, *at, radius, grey(0.3));
  draw_disc(image, panel, *at, 0.8 * radius, grey(1));
}

/// Draws a panel of figure 8.
void show_light(Sheet& sheet, const ImageRegion& panel, const LightShown& shown, const LitRoom& room,
                const FigureWish& wish, Figure& figure) {
  const RayCaster caster = caster_of(room);
  const double white = wish.white.value_or(1);
  const std::string title(shown.title);
  const PoissonDiskSites sites{.separation = room_separation(wish), .seed = wish.seed};
  std::function<PointValue()> value;
  if (shown.direct_alone && wish.exact_direct) {
    value =
        shared([&](const LitPoint& at) { return std::optional(direct_radiance(room.scene, room.lamp, at)); });
  } else if (shown.direct_alone) {
    const RadialBasis basis = accepted(
        RadialBasis::make(accepted(poisson_disk_sites(room.scene.surface(), sites), wish), shown.basis),
        wish);
    std::vector<double> emission(basis.size());
    parallel_for(basis.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        emission[i] = direct_radiance(room.scene, room.lamp,
                                      {.site = basis.sites()[i], .chart = basis.sites().at[i].chart});
    });
    figure.facts.emplace_back(title + ", sites", basis.size());
    value = combination(basis, emission);
  } else {
    const TransferChoice choice{.meshless = {.basis = shown.basis, .sites = sites},
                                .coefficients = shown.coefficients,
                                .integration = for_pictures};
    require_memory(room.scene, sites, wish);
    const LightTransfer transfer = accepted(LightTransfer::make(room.scene, choice), wish);
    const LightSolution solution = accepted(transfer.solve(room.lamp), wish);
    figure.facts.emplace_back(title + ", sites", transfer.basis().size());
    figure.facts.emplace_back(title + ", spectral radius", transfer.sums().spectral_radius);
    figure.facts.emplace_back(title + ", reflections", solution.reflections);
    if (!shown.remark.empty()) figure.facts.emplace_back(title, std::string(shown.remark));
    if (wish.exact_direct) {
      value = [make = combination(transfer.basis(), solution.indirect), &room] {
        return [indirect = make(), &room](const LitPoint& at) {
          std::optional<double> radiance = indirect(at);
          if (radiance) *radiance += direct_radiance(room.scene, room.lamp, at);
          return radiance;
        };
      };
    } else {
      value = combination(transfer.basis(), solution.total);
    }
  }
  add_counts(figure, title,
             show_scene(sheet, panel, room.camera, wish, caster, value, {.scale = {.high = white}},
                        !wish.exact_direct));
  draw_lamp(sheet.image, panel, room, caster);
}

Figure draw_figure_8_of(const FigureWish& wish, const FigureProgress& progress,
                        std::span<const LightShown> all) {
  const LitRoom room = lit_room();
  const std::size_t columns = all.size() > 1 ? 2 : 1;
  Sheet sheet = sheet_of(wish, columns, all.size() / columns);
  Figure figure{.shows = "psg10, figure 8: a room lit by a lamp, ",
                .facts = {{"scene", "lit_room"},
                          {"separation", room_separation(wish)},
                          {"seed", wish.seed},
                          {"white", wish.white.value_or(1)},
                          {"direct light", wish.exact_direct ? "exact" : "in the basis"}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    progress(as_double(k) / as_double(all.size()), std::string(all[k].title));
    show_light(sheet, sheet.panel(k % columns, k / columns, all[k].title), all[k], room, wish, figure);
    figure.shows += (k == 0 ? "" : "; ") + std::string(all[k].title);
  }
  figure.sheet = std::move(sheet);
  return figure;
}

}  // namespace

Figure draw_figure_8(const FigureWish& wish, const FigureProgress& progress) {
  const std::array<LightShown, 4> all{direct_light(), by_shepard(), by_gauss(), by_lehtinen()};
  return draw_figure_8_of(wish, progress, all);
}
Figure draw_figure_8_direct(const FigureWish& wish, const FigureProgress& progress) {
  return draw_figure_8_of(wish, progress, std::array{direct_light()});
}
Figure draw_figure_8_shepard(const FigureWish& wish, const FigureProgress& progress) {
  return draw_figure_8_of(wish, progress, std::array{by_shepard()});
}
Figure draw_figure_8_gaussian(const FigureWish& wish, const FigureProgress& progress) {
  return draw_figure_8_of(wish, progress, std::array{by_gauss()});
}
Figure draw_figure_8_lehtinen(const FigureWish& wish, const FigureProgress& progress) {
  return draw_figure_8_of(wish, progress, std::array{by_lehtinen()});
}

}  // namespace radcert::verification::psg10
