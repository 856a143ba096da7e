// SPDX-License-Identifier: GPL-3.0-or-later

// The comparison of the bases with the solution of (21): sphere and disk, separation 3, R = N.
//
// Checked      each over 6 sets of sites (20 beyond quick), weights integrated; the light that was scattered at least once
//              (total, all of it in the basis) and at least twice (indirect). Errors are root mean squares by area, over 60
//              parallels and 80 circles at 64 azimuths each.
//              conclusion_accuracy_*: the error of Lehtinen's basis over that of Shepard's, geometric mean over the sets.
//              conclusion_images: the oscillation of Lehtinen's basis over Shepard's, the root mean square of what is left
//              on each circle when its mean is taken away. conclusion_oscillation: the systematic error, that of the mean
//              over azimuths and sets, over the oscillation.
//              section_8_same_values: the error at separation 2 over that at 4.
//              figure_12: the spectral radius of R for the Gaussian basis as (12), (17) and section VII have it.
// Not checked  Shepard's basis with a radius; other scenes; the figures themselves, of which no number is printed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/profile_errors.h"
#include "radcert/meshless/sampling.h"
#include "radcert/reference/sphere_over_disk.h"
#include "verification/claims/psg10/checks.h"

namespace radcert::verification::psg10 {
namespace {

constexpr std::size_t azimuths = 64;

enum class Part { sphere, disk };
enum class Share { total, indirect };

std::string words(Part part, Share share) {
  return std::string(part == Part::sphere ? "sphere" : "disk") +
         (share == Share::total ? ", total" : ", indirect");
}

std::vector<ProfilePoint> profile(const reference::SphereOverDisk<double>& truth, Part part, Share share) {
  const auto value = [share](const reference::Radiance<double>& radiance) {
    return share == Share::total ? radiance.total() : radiance.indirect;
  };
  return part == Part::sphere ? sphere_profile(5, 20, 60, [&](double t) { return value(truth.sphere(t)); })
                              : disk_profile(40, 80, [&](double u) { return value(truth.disk(u)); });
}

TransferChoice choice_of(const RadialBasisChoice& basis, double separation, std::uint64_t seed) {
  return {.meshless = {.basis = basis, .sites = PoissonDiskSites{.separation = separation, .seed = seed}},
          .integration = {.relative_error = 1e-3, .most_points = 100'000}};
}

/// Errors over several sets of sites.
struct SetErrors {
  std::vector<ProfileErrors> sets;
  double systematic = 0;   ///< root mean square, by area, of the mean over circles and sets
  double scatter = 0;      ///< of that mean: its standard error, likewise
  double oscillation = 0;  ///< root mean square over the sets
};

/// Solves once for each set, and looks at any part.
class Comparison {
public:
  Comparison(const RadialBasisChoice& basis, double separation, std::uint64_t sets) {
    const LightScene scene = sphere_over_disk_light_scene().value();
    const Light light = ParallelLight{.towards = {0, 0, 1}, .power = 0.9};
    for (std::uint64_t seed = 1; seed <= sets; ++seed) {
      transfers_.push_back(LightTransfer::make(scene, choice_of(basis, separation, seed)).value());
      solutions_.push_back(transfers_.back().solve(light).value());
    }
  }

  [[nodiscard]] SetErrors errors(Part part, Share share) const {
    const std::vector<ProfilePoint> points = profile(truth(), part, share);
    SetErrors result;
    std::vector<double> mean(points.size());
    double squares = 0;
    for (std::size_t k = 0; k < transfers_.size(); ++k) {
      const std::vector<double>& coefficients =
          share == Share::total ? solutions_[k].total : solutions_[k].indirect;
      result.sets.push_back(
          profile_errors([&](const LitPoint& at) { return transfers_[k].basis().at(at.site, coefficients); },
                         points, azimuths));
      const ProfileErrors& set = result.sets.back();
      for (std::size_t i = 0; i < points.size(); ++i) mean[i] += set.circles[i].mean / count();
      squares += set.oscillation * set.oscillation / count();
    }
    result.oscillation = std::sqrt(squares);
    double area = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      area += points[i].area;
      result.systematic += points[i].area * std::pow(mean[i] - points[i].truth, 2);
      for (const ProfileErrors& set : result.sets)
        result.scatter +=
            points[i].area * std::pow(set.circles[i].mean - mean[i], 2) / (count() * (count() - 1));
    }
    result.scatter = std::sqrt(result.scatter / area);
    result.systematic = std::sqrt(result.systematic / area);
    return result;
  }

private:
  static const reference::SphereOverDisk<double>& truth() {
    static const reference::SphereOverDisk<double> solution({}, {.nodes = 16, .points = 24});
    return solution;
  }
  [[nodiscard]] double count() const { return static_cast<double>(transfers_.size()); }

  std::vector<LightTransfer> transfers_;
  std::vector<LightSolution> solutions_;
};

/// The geometric mean of ratios set by set, and twice the standard error of its logarithm as the radius.
Measured ratio(const SetErrors& over, const SetErrors& under, double ProfileErrors::*error) {
  const auto count = static_cast<double>(over.sets.size());
  double sum = 0;
  double squares = 0;
  for (std::size_t k = 0; k < over.sets.size(); ++k) {
    const double logarithm = std::log(over.sets[k].*error / (under.sets[k].*error));
    sum += logarithm;
    squares += logarithm * logarithm;
  }
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean) / (count - 1));
  return {.value = std::exp(mean), .radius = std::exp(mean) * std::expm1(2 * deviation)};
}

std::uint64_t sets_of(const Bench& bench) { return bench.budget == Budget::quick ? 6 : 20; }

const AtMost no_more{.value = 1, .slack = 0, .why = ""};

constexpr std::array<Part, 2> parts{Part::sphere, Part::disk};
constexpr std::array<Share, 2> shares{Share::total, Share::indirect};

}  // namespace

namespace {

Finding accuracy_on(Part part, const Bench& bench) {
  const Comparison shepard(shepard_basis(), 3, sets_of(bench));
  const Comparison lehtinen(lehtinen_basis(), 3, sets_of(bench));
  Finding finding;
  for (const Share share : shares)
    finding.require("error of Lehtinen's basis over that of Shepard's, " + words(part, share), no_more,
                    ratio(lehtinen.errors(part, share), shepard.errors(part, share), &ProfileErrors::l2));
  finding.control("error of Shepard's basis over that of Lehtinen's, disk, indirect", no_more,
                  ratio(shepard.errors(Part::disk, Share::indirect),
                        lehtinen.errors(Part::disk, Share::indirect), &ProfileErrors::l2));
  return finding;
}

}  // namespace

Finding conclusion_accuracy_disk(const Bench& bench) { return accuracy_on(Part::disk, bench); }
Finding conclusion_accuracy_sphere(const Bench& bench) { return accuracy_on(Part::sphere, bench); }

Finding conclusion_images(const Bench& bench) {
  const Comparison shepard(shepard_basis(), 3, sets_of(bench));
  const Comparison lehtinen(lehtinen_basis(), 3, sets_of(bench));
  Finding finding;
  for (const Part part : parts)
    for (const Share share : shares)
      finding.require(
          "oscillation of Lehtinen's basis over that of Shepard's, " + words(part, share), no_more,
          ratio(lehtinen.errors(part, share), shepard.errors(part, share), &ProfileErrors::oscillation));
  finding.control("oscillation of Shepard's basis over that of Lehtinen's, sphere, total", no_more,
                  ratio(shepard.errors(Part::sphere, Share::total),
                        lehtinen.errors(Part::sphere, Share::total), &ProfileErrors::oscillation));
  return finding;
}

Finding conclusion_oscillation(const Bench& bench) {
  const auto share_of = [](const SetErrors& errors) {
    return Measured{.value = errors.systematic / errors.oscillation,
                    .radius = errors.scatter / errors.oscillation};
  };
  const Comparison shepard(shepard_basis(), 3, sets_of(bench));
  Finding finding;
  for (const Part part : parts)
    for (const Share share : shares)
      finding.require("systematic error over oscillation, Shepard's basis, " + words(part, share), no_more,
                      share_of(shepard.errors(part, share)));
  const Comparison lehtinen(lehtinen_basis(), 3, sets_of(bench));
  finding.control("systematic error over oscillation, Lehtinen's basis, sphere, total", no_more,
                  share_of(lehtinen.errors(Part::sphere, Share::total)));
  return finding;
}

Finding section_8_same_values(const Bench& bench) {
  const std::uint64_t sets = bench.budget == Budget::quick ? 4 : 10;
  Finding finding;
  const Comparison coarse_lehtinen(lehtinen_basis(), 4, sets);
  const Comparison fine_lehtinen(lehtinen_basis(), 2, sets);
  const Comparison coarse_shepard(shepard_basis(), 4, sets);
  const Comparison fine_shepard(shepard_basis(), 2, sets);
  for (const Part part : parts)
    for (const Share share : shares) {
      finding.require(
          "error at separation 2 over that at 4, Lehtinen's basis, " + words(part, share), no_more,
          ratio(fine_lehtinen.errors(part, share), coarse_lehtinen.errors(part, share), &ProfileErrors::l2));
      finding.require(
          "error at separation 2 over that at 4, Shepard's basis, " + words(part, share), no_more,
          ratio(fine_shepard.errors(part, share), coarse_shepard.errors(part, share), &ProfileErrors::l2));
    }
  finding.control("error at separation 4 over that at 2, Lehtinen's basis, sphere, total", no_more,
                  ratio(coarse_lehtinen.errors(Part::sphere, Share::total),
                        fine_lehtinen.errors(Part::sphere, Share::total), &ProfileErrors::l2));
  return finding;
}

Finding figure_12(const Bench&) {
  const LightScene scene = sphere_over_disk_light_scene().value();
  const auto radius = [&](std::uint64_t seed, bool integrated) {
    // Some sets have sites of the sphere without ten others at a finite distance.
    RadialBasisChoice choice = gaussian_basis();
    choice.radius.too_few = TooFewNeighbours::farthest;
    const RadialBasis basis =
        RadialBasis::make(
            make_sites(scene.surface(), PoissonDiskSites{.separation = 3, .seed = seed}).value(), choice)
            .value();
    const std::vector<double> weights =
        integrated ? integrate_basis(basis, scene.surface(), {.relative_error = 1e-3, .most_points = 100'000})
                         .weights
                   : plane_weights(basis).value();
    const TransferSums sums = transfer_sums(point_light_transfer(scene, basis.sites(), weights));
    return Measured{.value = sums.spectral_radius, .radius = 1e-3};
  };
  const AtMost converges{.value = 1, .slack = 0, .why = "(6) converges"};
  Finding finding;
  for (const std::uint64_t seed : {1U, 2U, 3U})
    finding.require("spectral radius of R, w_j integrated over the scene, sites " + std::to_string(seed),
                    converges, radius(seed, true));
  finding.control("spectral radius of R, w_j integrated over the plane", converges, radius(1, false));
  return finding;
}

}  // namespace radcert::verification::psg10
