// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/figures/panels.h"

#include <array>
#include <vector>

namespace radcert::verification::psg10 {

Sheet sheet_of(const FigureWish& wish, std::size_t columns, std::size_t rows, bool has_scale) {
  return Sheet({.width = wish.width,
                .height = wish.height,
                .columns = columns,
                .rows = rows,
                .has_words = wish.has_words,
                .has_scale = has_scale});
}

CameraPose fitted_to(CameraPose pose, const ImageRegion& panel) {
  constexpr double wanted = 4.0 / 3;  // width over height
  const double least = wanted * as_double(panel.height) / as_double(panel.width);
  pose.vertical_angle = 2 * std::atan(std::max(1.0, least) * std::tan(pose.vertical_angle / 2));
  return pose;
}

RayCaster caster_of(const LitRoom& room) { return RayCaster::make(room.scene.surface()).value(); }

std::function<PointValue()> shared(PointValue value) {
  return [value = std::move(value)] { return value; };
}

std::function<PointValue()> seen_by_headlight(const LightScene& scene, const Vector<double>& eye) {
  return shared([&scene, eye](const LitPoint& at) -> std::optional<double> {
    const Vector<double> step = eye - at.site.point;
    constexpr double least = 0.25;
    return scene.albedo(at.chart) * (least + (1 - least) * dot(step, at.site.normal) / norm(step));
  });
}

void mark(Image& image, const ImageRegion& panel, const CameraPose& pose, const Site<double>& site,
          double size) {
  const PinholeCamera camera(fitted_to(pose, panel));
  const bool lies = std::abs(site.normal.z) > std::max(std::abs(site.normal.x), std::abs(site.normal.y));
  const Vector<double> along = cross(site.normal, lies ? Vector<double>{0, 1, 0} : Vector<double>{0, 0, 1});
  const Vector<double> first = (size / norm(along)) * along;
  const Vector<double> second = cross(site.normal, first);
  for (const Vector<double>& end : {first + second, first - second}) {
    const auto a = camera.image_of(site.point - end, panel);
    const auto b = camera.image_of(site.point + end, panel);
    if (!a || !b) continue;
    const std::array<ImagePoint, 2> line{*a, *b};
    const double width = std::max(1.5, as_double(panel.height) / 160);
    draw_line(image, panel, line, 2 * width, grey(1));
    draw_line(image, panel, line, width, mark_colour);
  }
}

std::size_t draw_sites(Image& image, const ImageRegion& panel, const CameraPose& pose,
                       const RayCaster& caster, const SiteSet& sites) {
  const PinholeCamera camera(fitted_to(pose, panel));
  const double radius = std::max(1.0, as_double(panel.height) / 200);
  std::vector<std::size_t> in_front;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (caster.sees(camera.position(), sites[i])) {
      in_front.push_back(i);
      continue;
    }
    if (const auto at = camera.image_of(sites.points[i], panel))
      draw_disc(image, panel, *at, 0.8 * radius, {0.2, 0.4, 0.8}, 0.75);
  }
  for (const std::size_t i : in_front)
    if (const auto at = camera.image_of(sites.points[i], panel))
      draw_disc(image, panel, *at, radius, mark_colour);
  return in_front.size();
}

Seen show_scene(Sheet& sheet, const ImageRegion& panel, const CameraPose& pose, const FigureWish& wish,
                const RayCaster& caster, const std::function<PointValue()>& value, const Paint& paint,
                bool smooth) {
  return show(sheet.image,
              {.camera = fitted_to(pose, panel), .picture = panel, .samples = wish.samples, .smooth = smooth},
              caster, value, paint);
}

void add_counts(Figure& figure, const std::string& name, const Seen& seen) {
  const double all = as_double(std::max<std::size_t>(seen.values, 1));
  figure.facts.emplace_back(name + ", least value", seen.least);
  figure.facts.emplace_back(name + ", largest value", seen.largest);
  figure.facts.emplace_back(name + ", part above the scale", as_double(seen.above) / all);
  figure.facts.emplace_back(name + ", part below it", as_double(seen.below) / all);
  figure.facts.emplace_back(name + ", part without a value", as_double(seen.without_value) / all);
}

double room_separation(const FigureWish& wish) { return wish.separation.value_or(0.2); }

void require_memory(const LightScene& scene, const PoissonDiskSites& sites, const FigureWish& wish) {
  transfer_memory(accepted(poisson_disk_sites(scene.surface(), sites), wish).size(), 2).require(wish.memory);
}

}  // namespace radcert::verification::psg10
