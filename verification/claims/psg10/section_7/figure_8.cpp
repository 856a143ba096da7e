// SPDX-License-Identifier: GPL-3.0-or-later

// A room by the bases, with ten iterations.
//
// Checked      lit_room(), sites 0.4 apart, w_j the integral of phi_j, R = N. Ten iterations of (19) from 0
//              against the solution, at all sites, in 255 grey levels of the screen's curve, white the
//              radiance 1: Shepard's and Lehtinen's bases. Three iterations are rejected. The same room by
//              the Gaussian basis as (12), (17) have it: the spectral radius of R, by a proved bound on the
//              side of 1 on which it lies; Shepard's and Lehtinen's contract. Rejected: weights as on a
//              plane. figure_8_direct: the room's direct light at 4000 points anywhere, as it is, by rays,
//              and in Lehtinen's basis, in the root mean square, and in the median, which the shadows' edges
//              leave alone. Rejected: all light in the place of the direct light.
// Not checked  figures 7 and 8 themselves: the pictures are not at hand, and nothing is said of their scenes;
//              so the entries of the figures are open. The radiance between the sites, of which the bases
//              make means.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/sampling.h"
#include "radcert/picture/image.h"
#include "verification/claims/psg10/picture_at_hand.h"
#include "verification/claims/psg10/scenes/lit_room.h"
#include "verification/claims/psg10/spectral_radius.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr double separation = 0.4;

const AtMost unseen{
    .value = 255.0 / 50, .slack = 0, .why = "a fiftieth of the screen's range, a contrast that is just seen"};
const AtMost converges{.value = 1, .slack = 0, .why = "(6) converges"};

TransferChoice choice_of(const RadialBasisChoice& basis, std::uint64_t seed) {
  return {.meshless = {.basis = basis, .sites = PoissonDiskSites{.separation = separation, .seed = seed}},
          .integration = {.relative_error = 1e-3, .most_points = 100'000}};
}

/// The largest difference that some iterations of (19) leave, in grey levels.
Approximation levels_left(const LightTransfer& transfer, const LightSolution& solution, int iterations) {
  const Matrix<double>& r = transfer.matrix();
  const std::size_t n = solution.total.size();
  std::vector<double> lambda(n);
  for (int step = 0; step < iterations; ++step) {
    std::vector<double> next = solution.emission;
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) next[i] += r(i, j) * lambda[j];
    lambda = std::move(next);
  }
  constexpr double levels = 255;
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i)
    largest = std::max(largest, levels * std::abs(screen_value(solution.total[i]) - screen_value(lambda[i])));
  // The slope of the screen's curve is at most 12.92.
  return {.value = largest, .radius = levels * 12.92 * solution.error_bound};
}

/// The Gaussian basis as (12), (17) have it.
RadialBasis gaussian_on(const LitRoom& room, std::uint64_t seed) {
  RadialBasisChoice choice = gaussian_basis();
  // The shade's narrow sides have few sites within 90 degrees.
  choice.radius.too_few = TooFewNeighbours::farthest;
  const SiteChoice sites = PoissonDiskSites{.separation = separation, .seed = seed};
  return RadialBasis::make(make_sites(room.scene.surface(), sites).value(), choice).value();
}
std::vector<double> integrated(const LitRoom& room, const RadialBasis& basis) {
  return integrate_basis(basis, room.scene.surface(), {.relative_error = 1e-3, .most_points = 100'000})
      .weights;
}
Approximation radius_with(const LitRoom& room, const RadialBasis& basis, const std::vector<double>& weights) {
  return proved_spectral_radius(point_light_transfer(room.scene, basis.sites(), weights));
}

std::uint64_t sets_of(const Bench& bench) { return bench.budget == Budget::quick ? 2 : 5; }

}  // namespace

Finding section_7_ten_iterations(const Bench& bench) {
  const LitRoom room = lit_room();
  Finding finding;
  for (const auto& [name, basis] :
       {std::pair(std::string("Shepard"), shepard_basis()), {"Lehtinen", lehtinen_basis()}})
    for (std::uint64_t seed = 1; seed <= sets_of(bench); ++seed) {
      const LightTransfer transfer = LightTransfer::make(room.scene, choice_of(basis, seed)).value();
      const LightSolution solution = transfer.solve(room.lamp).value();
      const std::string where = name + ", sites " + std::to_string(seed);
      finding.require("grey levels missing after ten iterations, " + where, unseen,
                      levels_left(transfer, solution, 10));
      if (seed == 1)
        finding.control("the same after three, " + where, unseen, levels_left(transfer, solution, 3));
    }
  return finding;
}

Finding figure_8(const Bench&) {
  const LitRoom room = lit_room();
  const LightTransfer transfer = LightTransfer::make(room.scene, choice_of(lehtinen_basis(), 1)).value();
  Finding finding;
  finding.require("grey levels between figure 8 and a room by these bases", unseen, read_off_the_picture());
  finding.control("grey levels between the room by all light and by that of the lamp alone", unseen,
                  levels_left(transfer, transfer.solve(room.lamp).value(), 1));
  return finding;
}

Finding figure_8_direct(const Bench&) {
  const LitRoom room = lit_room();
  const LightTransfer transfer = LightTransfer::make(room.scene, choice_of(lehtinen_basis(), 1)).value();
  const LightSolution solution = transfer.solve(room.lamp).value();
  const SiteSet points = uniform_sites(room.scene.surface(), {.count = 4000, .seed = 2}).value();
  // Direct light as it is, and the difference from that in the basis, at points anywhere.
  std::vector<double> exact;
  std::vector<double> apart;
  std::vector<double> reflected;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const LitPoint at{.site = points[k], .chart = points.at[k].chart};
    const auto all = transfer.radiance(solution, room.lamp, at);
    const auto indirect = transfer.basis().at(at.site, solution.indirect);
    const auto in_basis = transfer.basis().at(at.site, solution.emission);
    if (!all || !indirect || !in_basis) continue;
    exact.push_back(*all - *indirect);
    reflected.push_back(*indirect);
    apart.push_back(std::abs(*in_basis - exact.back()));
  }
  const auto root_mean_square = [](const std::vector<double>& numbers) {
    double squares = 0;
    for (const double number : numbers) squares += number * number;
    return std::sqrt(squares / static_cast<double>(numbers.size()));
  };
  const double scale = root_mean_square(exact);
  const double largest_part = root_mean_square(apart) / scale;
  std::sort(apart.begin(), apart.end());
  const AtMost tenth{.value = 0.1, .slack = 0, .why = "a tenth of the direct light's root mean square"};
  Finding finding;
  finding.require("direct light in Lehtinen's basis less direct light, root mean square", tenth,
                  Approximation{.value = largest_part, .radius = 0});
  finding.instead("the same, the median: away from the shadows' edges", tenth,
                  Approximation{.value = apart[apart.size() / 2] / scale, .radius = 0});
  finding.control("the light of all reflections less direct light, root mean square", tenth,
                  Approximation{.value = root_mean_square(reflected) / scale, .radius = 0});
  return finding;
}

Finding figure_7(const Bench&) {
  const LitRoom room = lit_room();
  const SiteSet sites =
      poisson_disk_sites(room.scene.surface(), {.separation = separation, .seed = 1}).value();
  const Matrix<double> columns =
      point_light_transfer(room.scene, sites, std::vector<double>(sites.size(), separation * separation));
  // The root of the sum of squares of a column less another one, over that of the column.
  const auto difference = [&](std::size_t k, std::size_t other) {
    double apart = 0;
    double whole = 0;
    for (std::size_t i = 0; i < columns.rows(); ++i) {
      apart += std::pow(columns(i, k) - columns(i, other), 2);
      whole += std::pow(columns(i, k), 2);
    }
    return Approximation{.value = std::sqrt(apart / whole), .radius = 0};
  };
  const AtMost alike{.value = 0.3, .slack = 0, .why = "three tenths of what a black picture is off by"};
  Finding finding;
  finding.require("the radiance of figure 7 less that of a column of R", alike, read_off_the_picture());
  finding.control("the radiance of a column of R for a room less that of another site's", alike,
                  difference(0, sites.size() - 1));
  return finding;
}

Finding section_7_gaussian(const Bench& bench) {
  const LitRoom room = lit_room();
  Finding finding;
  for (std::uint64_t seed = 1; seed <= sets_of(bench); ++seed) {
    const RadialBasis basis = gaussian_on(room, seed);
    finding.require("bound of the spectral radius of R, w_j integrated, sites " + std::to_string(seed),
                    converges, radius_with(room, basis, integrated(room, basis)));
    if (seed == 1)
      finding.control("the same, w_j integrated over the plane", converges,
                      radius_with(room, basis, plane_weights(basis).value()));
  }
  for (const auto& [name, basis] :
       {std::pair(std::string("Shepard"), shepard_basis()), {"Lehtinen", lehtinen_basis()}}) {
    const LightTransfer transfer = LightTransfer::make(room.scene, choice_of(basis, 1)).value();
    finding.instead("bound of the spectral radius of R, w_j integrated, sites 1, " + name, converges,
                    proved_spectral_radius(transfer.matrix()));
  }
  return finding;
}

Finding figure_8_gaussian(const Bench&) {
  const LitRoom room = lit_room();
  const RadialBasis basis = gaussian_on(room, 1);
  Finding finding;
  finding.require("the spectral radius of R for the scene, the sites and the radii of figure 8", converges,
                  read_off_the_picture());
  finding.control("the same for a room of radcert's own, w_j integrated over the plane", converges,
                  radius_with(room, basis, plane_weights(basis).value()));
  return finding;
}

}  // namespace radcert::verification::psg10
