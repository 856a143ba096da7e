// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/light_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "radcert/meshless/surface_cells.h"
#include "radcert/visibility/surface_scene.h"
#include "radcert/visibility/visibility.h"

namespace radcert {
namespace {

bool fits(const Vector<double>& v) {
  return std::abs(v.x) <= Scene::largest_coordinate && std::abs(v.y) <= Scene::largest_coordinate &&
         std::abs(v.z) <= Scene::largest_coordinate;
}

bool is_allowed(const RoundBlocker& blocker) {
  if (const auto* ball = std::get_if<BallBlocker>(&blocker.shape))
    return fits(ball->centre) && ball->radius >= 0 && ball->radius <= Scene::largest_coordinate;
  const auto& disk = *std::get_if<DiskBlocker>(&blocker.shape);
  return fits(disk.centre) && fits(disk.normal) && dot(disk.normal, disk.normal) > 0 && disk.radius >= 0 &&
         disk.radius <= Scene::largest_coordinate;
}

bool stands_between(const RoundBlocker& blocker, const Vector<double>& p, const Vector<double>& q) {
  if (const auto* ball = std::get_if<BallBlocker>(&blocker.shape)) return hides(*ball, p, q);
  return hides(*std::get_if<DiskBlocker>(&blocker.shape), p, q);
}

/// The diagonal of a box about the surface, sampled on cells of curved charts, and half as much again.
double sampled_reach(const Surface& surface) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector<double> low{infinity, infinity, infinity};
  Vector<double> high{-infinity, -infinity, -infinity};
  const auto cells = cells_below(surface, infinity, std::numeric_limits<std::size_t>::max());
  for (const SurfaceCell& cell : *cells)
    for (const Vector<double>& image : cell.images) {
      low = {std::min(low.x, image.x), std::min(low.y, image.y), std::min(low.z, image.z)};
      high = {std::max(high.x, image.x), std::max(high.y, image.y), std::max(high.z, image.z)};
    }
  return 1.5 * norm(high - low);
}

}  // namespace

struct LightScene::Parts {
  Surface surface;
  std::vector<double> albedo;  ///< a chart
  std::vector<RoundBlocker> blockers;
  std::vector<std::vector<bool>> owns;  ///< of each blocker, which charts are its skin
  std::unique_ptr<const SurfaceScene> mesh;
  double reach = 0;

  [[nodiscard]] std::optional<std::size_t> triangle(std::size_t chart) const {
    return mesh ? std::optional(chart) : std::nullopt;
  }
};

LitPoint lit_point(const Surface& surface, const SurfacePoint<double>& at) {
  return {.site = site_at(surface, at), .chart = at.chart};
}

LightScene::LightScene(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}

Outcome<LightScene> LightScene::make(Surface surface, std::vector<double> albedo,
                                     std::vector<RoundBlocker> blockers) {
  const std::size_t charts = surface.chart_count();
  if (charts == 0) return because("the surface has no chart");
  if (albedo.size() == 1) albedo.assign(charts, albedo.front());
  if (albedo.size() != charts)
    return because("there are " + std::to_string(albedo.size()) + " albedos for " + std::to_string(charts) +
                   " charts; allowed: one, or one a chart");
  for (const double beta : albedo)
    if (!(beta >= 0 && beta < 1))
      return because("the albedo " + shortest(beta) +
                     " is not in [0, 1): a surface scatters less than arrives");
  const bool is_mesh = surface.mesh != nullptr;
  if (!surface.unoccluded && !is_mesh && blockers.empty())
    return because("the curved surface " + quotation(surface.name) +
                   " hides parts of itself: say by which balls and disks, or take a mesh of it");
  auto parts = std::make_shared<Parts>();
  for (const RoundBlocker& blocker : blockers) {
    if (!is_allowed(blocker)) return because("a ball or disk in the way has numbers that are not allowed");
    std::vector<bool> owns(charts, false);
    for (std::size_t k = 0; k < charts; ++k)
      owns[k] = !blocker.piece.empty() && surface.charts[k].facts().piece == blocker.piece;
    if (!blocker.piece.empty() && std::find(owns.begin(), owns.end(), true) == owns.end())
      return because("the surface has no piece " + quotation(blocker.piece) + " to be the skin of a blocker");
    parts->owns.push_back(std::move(owns));
  }
  parts->reach = sampled_reach(surface);
  if (is_mesh && !surface.unoccluded) parts->mesh = std::make_unique<const SurfaceScene>(surface);
  parts->surface = std::move(surface);
  parts->albedo = std::move(albedo);
  parts->blockers = std::move(blockers);
  return LightScene(std::move(parts));
}

const Surface& LightScene::surface() const { return parts_->surface; }
double LightScene::albedo(std::size_t chart) const { return parts_->albedo[chart]; }
double LightScene::reach() const { return parts_->reach; }

bool LightScene::visible(const LitPoint& p, const LitPoint& q) const {
  for (std::size_t k = 0; k < parts_->blockers.size(); ++k)
    if (!parts_->owns[k][p.chart] && !parts_->owns[k][q.chart] &&
        stands_between(parts_->blockers[k], p.site.point, q.site.point))
      return false;
  return !parts_->mesh || radcert::visible(parts_->mesh->scene(), {p.site.point, parts_->triangle(p.chart)},
                                           {q.site.point, parts_->triangle(q.chart)});
}

bool LightScene::visible(const LitPoint& p, const Vector<double>& from) const {
  for (std::size_t k = 0; k < parts_->blockers.size(); ++k)
    if (!parts_->owns[k][p.chart] && stands_between(parts_->blockers[k], p.site.point, from)) return false;
  return !parts_->mesh || radcert::visible(parts_->mesh->scene(), {p.site.point, parts_->triangle(p.chart)},
                                           {from, std::nullopt});
}

}  // namespace radcert
