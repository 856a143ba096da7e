// SPDX-License-Identifier: GPL-3.0-or-later

// "Most of the time" as operations, which no machine changes: a pair of sites has two entries of R. Of the
// kernel that both share q - p takes 3 operations, |q - p|^2 and two cosines 5 each, the product of the
// cosines, |q - p|^4 and the quotient 1 each, and each entry 3 products besides: 27. If the sites face
// each other, a ray goes through a tree of boxes, and each box and each triangle that it looks at counts
// for one operation, though none takes so few. An iteration takes a product and a sum for each entry: 40
// for a pair in ten iterations.
//
// Checked      section_7_building: for lit_room(), sites 0.8 and 0.4 apart, that ten iterations take no
//              more than that, on the average over all pairs. A ray that is cut off is not counted, as it
//              may end early. Rejected: a room of the same size with nothing in the way, which needs no
//              rays, and the paper's scene, a sphere over a disk, of whose sites few face each other.
// Not checked  what else takes time: sites, weights, bases, and rays to the lamp; the time of one
//              operation against another; rays through another tree.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "radcert/geometry/box_tree.h"
#include "radcert/meshless/sampling.h"
#include "radcert/meshless/transfer_matrix.h"
#include "radcert/surface/catalogue.h"
#include "verification/claims/psg10/scenes/lit_room.h"
#include "verification/claims/psg10/scenes/sphere_over_disk.h"
#include "verification/claims/psg10/section_7/sites_on_scene.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr double of_kernel = 27;
constexpr double of_ten_iterations = 40;
// A ball and a disk, a quadratic equation each.
constexpr double of_round_blockers = 50;

// Whether a segment meets a box.
bool meets(const Vector<double>& p, const Vector<double>& q, const BoundingBox& box) {
  double first = 0;
  double last = 1;
  const auto cut = [&](double from, double to, double low, double high) {
    const double step = to - from;
    if (step == 0) {
      if (from < low || from > high) last = -1;
      return;
    }
    const double a = (low - from) / step;
    const double b = (high - from) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  };
  cut(p.x, q.x, box.low.x, box.high.x);
  cut(p.y, q.y, box.low.y, box.high.y);
  cut(p.z, q.z, box.low.z, box.high.z);
  return first <= last;
}

// Operations of the rays between facing sites that see each other, over the number of pairs.
double of_rays(const LightScene& scene, const SiteSet& sites) {
  if (scene.surface().unoccluded) return 0;
  const bool is_mesh = scene.surface().mesh != nullptr;
  const BoxTree tree(is_mesh ? triangle_boxes(*scene.surface().mesh) : std::vector<BoundingBox>{});
  double operations = 0;
  for (std::size_t j = 0; j < sites.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const LitPoint p{.site = sites[i], .chart = sites.at[i].chart};
      const LitPoint q{.site = sites[j], .chart = sites.at[j].chart};
      if (!(site_kernel(p.site, q.site) > 0) || !scene.visible(p, q)) continue;
      if (!is_mesh) operations += of_round_blockers;
      tree.visit_leaves(
          [&](const BoundingBox& box) {
            ++operations;
            return meets(p.site.point, q.site.point, box);
          },
          [&](std::size_t begin, std::size_t end) {
            operations += static_cast<double>(end - begin);
            return true;
          });
    }
  const auto n = static_cast<double>(sites.size());
  return operations / (n * (n - 1) / 2);
}

// Operations of ten iterations less those of building R, for a pair of sites.
Approximation iterations_less_building(const LightScene& scene, const SiteSet& sites) {
  return {.value = of_ten_iterations - of_kernel - of_rays(scene, sites), .radius = 0};
}

}  // namespace

Finding section_7_building(const Bench&) {
  const AtMost less{.value = 0, .slack = 0, .why = "building R takes as many operations or more"};
  const LightScene room = lit_room().scene;
  const LightScene empty =
      LightScene::make(find_surface("box")->make(std::array{Rational(4), Rational(4), Rational(3)}), {0.6})
          .value();
  const auto sites = [](const LightScene& scene, double separation) {
    return poisson_disk_sites(scene.surface(), {.separation = separation, .seed = 1}).value();
  };
  const std::string what = "operations of ten iterations less those of building R, for a pair of sites, ";
  const Approximation coarse = iterations_less_building(room, sites(room, 0.8));
  Finding finding;
  finding.require(what + "lit_room(), sites 0.8 apart", less, coarse);
  finding.require(what + "lit_room(), sites 0.4 apart", less,
                  iterations_less_building(room, sites(room, 0.4)));
  finding.control(what + "an empty room, sites 0.8 apart", less,
                  iterations_less_building(empty, sites(empty, 0.8)));
  finding.control(what + "the paper's scene, separation 3", less,
                  iterations_less_building(sphere_over_disk_light_scene().value(), sites_on_scene(1)));
  finding.show(coarse);
  return finding;
}

}  // namespace radcert::verification::psg10
