// SPDX-License-Identifier: GPL-3.0-or-later

// The comparison of the bases with the solution of (21): sphere and disk, R = N.
//
// Checked      separation 3 over 6 sets of sites (20 beyond quick), weights integrated; the light that was
//              scattered at least once (total, all of it in the basis) and at least twice (indirect). Errors
//              are root mean squares by area, over 60 parallels and 80 circles at 64 azimuths each.
//              conclusion_accuracy_*: the error of Lehtinen's basis over that of Shepard's, geometric mean
//              over the sets. conclusion_images: the oscillation of Lehtinen's basis over Shepard's, the root
//              mean square of what is left on each circle when its mean is taken away.
//              conclusion_oscillation: the systematic error, that of the mean over azimuths and sets, over
//              the oscillation. figure_11, figure_13: the reflections do not grow, by a proved bound of the
//              spectral radius, and the errors are no more than a drawing shows. section_8_same_values: the
//              error at the finest separation over that at 3: 3 and 3/2 over 4 sets at quick, 3, 2, 3/2, 1
//              over 20 at standard, to 7/10 at full. The order between separations is a remark.
//              section_8_gaussian: the same of the Gaussian basis, with w_j = area/n, for which the
//              reflections do not grow. figure_12: the spectral radius of R for the Gaussian basis as (12),
//              (17) and section VII have it.
// Not checked  Shepard's basis with a radius; other scenes; the figures themselves, of which no number is
// printed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/sampling.h"
#include "verification/claims/psg10/scenes/profile_errors.h"
#include "verification/claims/psg10/scenes/sphere_over_disk.h"
#include "verification/claims/psg10/sphere_over_disk/solution.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr std::size_t azimuths = 64;

enum class Part { sphere, disk };
enum class Share { total, indirect };

std::string words(Part part, Share share) {
  return std::string(part == Part::sphere ? "sphere" : "disk") +
         (share == Share::total ? ", total" : ", indirect");
}

std::vector<ProfilePoint> profile(const SphereOverDisk<double>& truth, Part part, Share share) {
  const auto value = [share](const Radiance<double>& radiance) {
    return share == Share::total ? radiance.total() : radiance.indirect;
  };
  return part == Part::sphere ? sphere_profile(5, 20, 60, [&](double t) { return value(truth.sphere(t)); })
                              : disk_profile(40, 80, [&](double u) { return value(truth.disk(u)); });
}

enum class Basis { shepard, lehtinen, gaussian };

TransferChoice choice_of(Basis basis, double separation, std::uint64_t seed) {
  TransferChoice choice{.meshless = {.basis = basis == Basis::shepard ? shepard_basis() : lehtinen_basis(),
                                     .sites = PoissonDiskSites{.separation = separation, .seed = seed}},
                        .integration = {.relative_error = 1e-3, .most_points = 100'000}};
  if (basis == Basis::gaussian) {
    choice.meshless.basis = gaussian_basis();
    // Some sets have sites of the sphere without ten others at a finite distance.
    choice.meshless.basis.radius.too_few = TooFewNeighbours::farthest;
    choice.weights = WeightRule::mean_density;
  }
  return choice;
}

/// One set of sites, solved and looked at.
struct SolvedSet {
  std::array<std::array<ProfileErrors, 2>, 2> errors;  ///< by part and share
  double spectral_radius_bound = 0;                    ///< of R, proved

  [[nodiscard]] const ProfileErrors& of(Part part, Share share) const {
    return errors[part == Part::sphere ? 0 : 1][share == Share::total ? 0 : 1];
  }
};

const SphereOverDisk<double>& truth() {
  static const SphereOverDisk<double> solution({}, {.nodes = 16, .points = 24});
  return solution;
}

SolvedSet solve_set(Basis basis, double separation, std::uint64_t seed) {
  static const LightScene scene = sphere_over_disk_light_scene().value();
  const LightTransfer transfer = LightTransfer::make(scene, choice_of(basis, separation, seed)).value();
  const LightSolution solution = transfer.solve(ParallelLight{.towards = {0, 0, 1}, .power = 0.9}).value();
  SolvedSet set{.errors = {}, .spectral_radius_bound = transfer.series().spectral_radius_bound()};
  for (const Part part : {Part::sphere, Part::disk})
    for (const Share share : {Share::total, Share::indirect}) {
      const std::vector<double>& coefficients = share == Share::total ? solution.total : solution.indirect;
      set.errors[part == Part::sphere ? 0 : 1][share == Share::total ? 0 : 1] =
          profile_errors([&](const LitPoint& at) { return transfer.basis().at(at.site, coefficients); },
                         profile(truth(), part, share), azimuths);
    }
  return set;
}

/// Each set of sites is solved once, whichever statements ask for it.
const SolvedSet& solved_set(Basis basis, double separation, std::uint64_t seed) {
  static std::mutex mutex;
  static std::map<std::tuple<Basis, double, std::uint64_t>, SolvedSet> sets;
  const std::scoped_lock lock(mutex);
  const auto [place, is_new] = sets.try_emplace({basis, separation, seed});
  if (is_new) {
    try {
      place->second = solve_set(basis, separation, seed);
    } catch (...) {
      sets.erase(place);
      throw;
    }
  }
  return place->second;
}

/// Errors over several sets of sites.
struct SetErrors {
  std::vector<ProfileErrors> sets;
  double systematic = 0;   ///< root mean square, by area, of the mean over circles and sets
  double scatter = 0;      ///< of that mean: its standard error, likewise
  double oscillation = 0;  ///< root mean square over the sets
};

/// A basis on several sets of sites.
class Comparison {
public:
  Comparison(Basis basis, double separation, std::uint64_t sets) {
    for (std::uint64_t seed = 1; seed <= sets; ++seed) sets_.push_back(&solved_set(basis, separation, seed));
  }

  [[nodiscard]] const std::vector<const SolvedSet*>& sets() const { return sets_; }

  [[nodiscard]] SetErrors errors(Part part, Share share) const {
    const std::vector<ProfilePoint> points = profile(truth(), part, share);
    SetErrors result;
    std::vector<double> mean(points.size());
    double squares = 0;
    for (const SolvedSet* solved : sets_) {
      result.sets.push_back(solved->of(part, share));
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
  [[nodiscard]] double count() const { return static_cast<double>(sets_.size()); }

  std::vector<const SolvedSet*> sets_;
};

/// The geometric mean of ratios set by set, and twice the standard error of its logarithm as the radius; over
/// the sets that both have.
Approximation ratio(const SetErrors& over, const SetErrors& under, double ProfileErrors::*error) {
  const std::size_t common = std::min(over.sets.size(), under.sets.size());
  const auto count = static_cast<double>(common);
  double sum = 0;
  double squares = 0;
  for (std::size_t k = 0; k < common; ++k) {
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
  const Comparison shepard(Basis::shepard, 3, sets_of(bench));
  const Comparison lehtinen(Basis::lehtinen, 3, sets_of(bench));
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
  const Comparison shepard(Basis::shepard, 3, sets_of(bench));
  const Comparison lehtinen(Basis::lehtinen, 3, sets_of(bench));
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
    return Approximation{.value = errors.systematic / errors.oscillation,
                         .radius = errors.scatter / errors.oscillation};
  };
  const Comparison shepard(Basis::shepard, 3, sets_of(bench));
  Finding finding;
  for (const Part part : parts)
    for (const Share share : shares)
      finding.require("systematic error over oscillation, Shepard's basis, " + words(part, share), no_more,
                      share_of(shepard.errors(part, share)));
  const Comparison lehtinen(Basis::lehtinen, 3, sets_of(bench));
  finding.control("systematic error over oscillation, Lehtinen's basis, sphere, total", no_more,
                  share_of(lehtinen.errors(Part::sphere, Share::total)));
  return finding;
}

namespace {

/// A separation and how many sets of sites of it are looked at.
struct Refinement {
  double separation = 3;
  std::uint64_t sets = 4;
};

std::vector<Refinement> refinements(Basis basis, const Bench& bench) {
  if (bench.budget == Budget::quick || basis == Basis::gaussian) return {{3, 4}, {1.5, 4}};
  if (bench.budget == Budget::standard) return {{3, 20}, {2, 20}, {1.5, 20}, {1, 20}};
  return {{3, 20}, {2, 20}, {1.5, 20}, {1, 20}, {0.7, 20}};
}

std::string words(Basis basis) {
  switch (basis) {
    case Basis::shepard: return "Shepard's basis";
    case Basis::lehtinen: return "Lehtinen's basis";
    case Basis::gaussian: break;
  }
  return "the Gaussian basis";
}

/// The error at the finest separation over that at the coarsest, and the orders on the way.
void converges(Finding& finding, Basis basis, const Bench& bench) {
  const std::vector<Refinement> steps = refinements(basis, bench);
  std::vector<Comparison> comparisons;
  for (const Refinement& step : steps) comparisons.emplace_back(basis, step.separation, step.sets);
  for (const Part part : parts)
    for (const Share share : shares) {
      const std::string of = ", " + words(basis) + ", " + words(part, share);
      const SetErrors coarsest = comparisons.front().errors(part, share);
      finding.require("error at separation " + shortest(steps.back().separation) + " over that at 3" + of,
                      no_more, ratio(comparisons.back().errors(part, share), coarsest, &ProfileErrors::l2));
      for (std::size_t k = 1; k < steps.size(); ++k) {
        const Approximation fall = ratio(comparisons[k].errors(part, share),
                                         comparisons[k - 1].errors(part, share), &ProfileErrors::l2);
        const double step = std::log(steps[k].separation / steps[k - 1].separation);
        finding.remark("order from separation " + shortest(steps[k - 1].separation) + " to " +
                           shortest(steps[k].separation) + of,
                       {.value = std::log(fall.value) / step,
                        .radius = std::log1p(fall.radius / fall.value) / std::abs(step)});
      }
    }
}

Finding figure_of(Basis basis, const Bench& bench) {
  const Comparison compared(basis, 3, sets_of(bench));
  const AtMost contracts{.value = 1, .slack = 0, .why = "(6) converges"};
  const AtMost near{
      .value = 0.1, .slack = 0, .why = "an eighth of the largest radiance, 0.83: what a drawing shows"};
  Finding finding;
  double bound = 0;
  for (const SolvedSet* set : compared.sets()) bound = std::max(bound, set->spectral_radius_bound);
  finding.require("spectral radius of R, the largest of the sets", contracts,
                  Approximation{.value = bound, .radius = 0});
  for (const Part part : parts)
    for (const Share share : shares) {
      const SetErrors errors = compared.errors(part, share);
      double largest = 0;
      for (const ProfileErrors& set : errors.sets) largest = std::max(largest, set.l2);
      finding.require("error of the worst set, " + words(part, share), near,
                      Approximation{.value = largest, .radius = 0});
    }
  const SetErrors wrong = Comparison(Basis::gaussian, 3, 1).errors(Part::disk, Share::total);
  finding.control("error of the Gaussian basis with w_j = area/n, disk, total", near,
                  Approximation{.value = wrong.sets.front().l2, .radius = 0});
  return finding;
}

}  // namespace

Finding figure_11(const Bench& bench) { return figure_of(Basis::shepard, bench); }
Finding figure_13(const Bench& bench) { return figure_of(Basis::lehtinen, bench); }

Finding section_8_same_values(const Bench& bench) {
  Finding finding;
  converges(finding, Basis::lehtinen, bench);
  converges(finding, Basis::shepard, bench);
  finding.control(
      "error at separation 3 over that at 1.5, Lehtinen's basis, sphere, total", no_more,
      ratio(Comparison(Basis::lehtinen, 3, 4).errors(Part::sphere, Share::total),
            Comparison(Basis::lehtinen, 1.5, 4).errors(Part::sphere, Share::total), &ProfileErrors::l2));
  return finding;
}

Finding section_8_gaussian(const Bench&) {
  const AtMost same_values{
      .value = 0.9, .slack = 0, .why = "the largest radiance there is: an error above it is no value at all"};
  const auto error = [](Basis basis, double separation) {
    double largest = 0;
    for (const ProfileErrors& set : Comparison(basis, separation, 4).errors(Part::disk, Share::total).sets)
      largest = std::max(largest, set.l2);
    return Approximation{.value = largest, .radius = 0};
  };
  Finding finding;
  for (const double separation : {3.0, 1.5})
    finding.require("error at separation " + shortest(separation) + ", w_j = area/n, disk, total",
                    same_values, error(Basis::gaussian, separation));
  double squares = 0;
  double area = 0;
  for (const ProfilePoint& at : profile(truth(), Part::disk, Share::total)) {
    squares += at.area * at.truth * at.truth;
    area += at.area;
  }
  finding.control("error of three times the solution, disk, total", same_values,
                  Approximation{.value = 2 * std::sqrt(squares / area), .radius = 0});
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
    return Approximation{.value = sums.spectral_radius, .radius = 1e-3};
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
