// SPDX-License-Identifier: GPL-3.0-or-later

// Random centroids on surfaces that cannot be seen.
//
// Checked      1000 sites of lit_room(), each anywhere with equal chance by area, seen from the lamp: the
//              part of them that is turned away or hidden is that of 20000 other points, to within three
//              standard errors. So hidden surfaces are sampled as others are. Rejected: the sites that are
//              seen alone.
// Not checked  figure 3 itself: the picture is not at hand, and its entry is open.

#include <cmath>

#include "radcert/meshless/sampling.h"
#include "verification/claims/psg10/picture_at_hand.h"
#include "verification/claims/psg10/scenes/lit_room.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

bool is_seen(const LitRoom& room, const SiteSet& sites, std::size_t k) {
  const LitPoint at{.site = sites[k], .chart = sites.at[k].chart};
  return dot(room.lamp.at - at.site.point, at.site.normal) > 0 && room.scene.visible(at, room.lamp.at);
}

/// The part of the sites that is not seen.
Approximation hidden(const LitRoom& room, const SiteSet& sites) {
  double count = 0;
  for (std::size_t k = 0; k < sites.size(); ++k)
    if (!is_seen(room, sites, k)) count += 1;
  return {.value = count / static_cast<double>(sites.size()), .radius = 0};
}

SiteSet sites_anywhere(const LitRoom& room, std::size_t count, std::uint64_t seed) {
  return uniform_sites(room.scene.surface(), {.count = count, .seed = seed}).value();
}

/// The sites that are seen.
SiteSet seen_alone(const LitRoom& room, const SiteSet& sites) {
  SiteSet seen;
  for (std::size_t k = 0; k < sites.size(); ++k)
    if (is_seen(room, sites, k)) seen.add(sites[k], sites.at[k]);
  return seen;
}

/// The part of the surface that is not seen, as far as 20000 points tell, and what 1000 may differ by.
Equals by_area(const LitRoom& room) {
  constexpr std::size_t sites = 1000;
  const double part = hidden(room, sites_anywhere(room, 20 * sites, 2)).value;
  return {.value = part,
          .slack = 3 * std::sqrt(part * (1 - part) * (1 + 0.05) / sites),
          .why = "three standard errors of 1000 sites and of 20000"};
}

}  // namespace

Finding section_5_hidden_sites(const Bench&) {
  const LitRoom room = lit_room();
  const SiteSet sites = sites_anywhere(room, 1000, 1);
  Finding finding;
  finding.require("part of 1000 sites that the lamp does not see", by_area(room), hidden(room, sites));
  finding.control("the same of those that it sees", by_area(room), hidden(room, seen_alone(room, sites)));
  return finding;
}

Finding figure_3(const Bench&) {
  const LitRoom room = lit_room();
  Finding finding;
  finding.require("part of the sites of figure 3 that are not seen", by_area(room), read_off_the_picture());
  finding.control("part of the sites of a room that are not seen, those alone that are", by_area(room),
                  hidden(room, seen_alone(room, sites_anywhere(room, 1000, 1))));
  return finding;
}

}  // namespace radcert::verification::psg10
