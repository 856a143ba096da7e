// SPDX-License-Identifier: GPL-3.0-or-later

// The comparison of the bases with the solution of (21): sphere and disk, R = N.
//
// Checked      separation 3 over 6 sets of sites (20 beyond quick), weights integrated; the light that was
//              scattered at least once (total, all of it in the basis) and at least twice (indirect).
//              Errors are root mean squares by area, over 60 parallels and 80 circles at 64 azimuths each.
//              conclusion_accuracy_sphere, _disk: the error of Lehtinen's basis over that of Shepard's,
//              geometric mean over the sets, by both readings of R that section VII allows, N and A^-1 N
//              (one for Shepard's, A = I): what they do not agree on is open. _both, R = N: on the one and
//              on the other; _scene, R = N: over the whole scene by area, w_j integrated or area/n.
//              Rejected: the Gaussian basis. conclusion_images: the oscillation of Lehtinen's basis over
//              Shepard's, the root mean square of what is left on each circle when its mean is taken away;
//              rejected for radii to the third other. conclusion_oscillation: the systematic error, that
//              of the mean over azimuths and sets, over the oscillation, for either part and share: the
//              statement does not say of which. section_8_shepard, _lehtinen: the reflections do not grow,
//              by a proved bound of the spectral radius, and the errors are at most 3/10 of those of a
//              black answer; rejected for half of the light. section_8_same_values: the error of
//              Lehtinen's basis at separation 3/4 over that at 3, and over that of a black answer; the
//              order of its geometric mean over the sets at 3, 3/2 and 3/4, 24, 12 and 4 sets at quick and
//              20 each beyond, with twice its standard error: at least 3/2 at the kink of the radiance on
//              the sphere, and 1/2 at its jump on the disk, in the root mean square. Rejected: the
//              Gaussian basis, and half of the light. _shepard: its orders fall from one separation to the
//              next, so that the error may tend to 0 or, if they go on falling by the same factor, to a
//              number: open. section_8_gaussian: the error of the Gaussian basis, with w_j = area/n, for
//              which the reflections do not grow, over that of a black answer. figure_12: a bound of the
//              spectral radius of R for the Gaussian basis as (12), (17) and section VII have it, on the
//              side of 1 on which it lies, and for the two other bases.
// Not checked  Shepard's basis with a radius; other scenes; figures 11 to 13 themselves: the pictures are
//              not at hand, and no number of them is printed, so that figure_11 and figure_13 are open.

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/sampling.h"
#include "verification/claims/psg10/picture_at_hand.h"
#include "verification/claims/psg10/scenes/profile_errors.h"
#include "verification/claims/psg10/scenes/sphere_over_disk.h"
#include "verification/claims/psg10/spectral_radius.h"
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

enum class Family { shepard, lehtinen, gaussian };

/// A basis, and how it is used.
struct Basis {
  Family family = Family::shepard;
  CoefficientRule coefficients = CoefficientRule::as_values;
  std::size_t neighbour = 10;
  double power = 0.9;
  WeightRule weights = WeightRule::integrated;
  auto operator<=>(const Basis&) const = default;
};

constexpr Basis shepard_as_printed{};
constexpr Basis lehtinen_as_printed{.family = Family::lehtinen};
/// With w_j = area/n, for which the reflections do not grow.
constexpr Basis gaussian_of_mean_density{.family = Family::gaussian, .weights = WeightRule::mean_density};
constexpr Basis lehtinen_interpolated{.family = Family::lehtinen,
                                      .coefficients = CoefficientRule::interpolated};
constexpr Basis lehtinen_to_the_third{.family = Family::lehtinen, .neighbour = 3};

constexpr Basis of_mean_density(Basis basis) {
  basis.weights = WeightRule::mean_density;
  return basis;
}
constexpr Basis by_half_the_light(Basis basis) {
  basis.power /= 2;
  return basis;
}

RadialBasisChoice radial_choice(Family family) {
  switch (family) {
    case Family::shepard: return shepard_basis();
    case Family::lehtinen: return lehtinen_basis();
    case Family::gaussian: break;
  }
  RadialBasisChoice choice = gaussian_basis();
  // Some sets have sites of the sphere without ten others at a finite distance.
  choice.radius.too_few = TooFewNeighbours::farthest;
  return choice;
}

TransferChoice choice_of(const Basis& basis, double separation, std::uint64_t seed) {
  TransferChoice choice{.meshless = {.basis = radial_choice(basis.family),
                                     .sites = PoissonDiskSites{.separation = separation, .seed = seed}},
                        .coefficients = basis.coefficients,
                        .integration = {.relative_error = 1e-3, .most_points = 100'000}};
  choice.weights = basis.weights;
  if (basis.family == Family::lehtinen) choice.meshless.basis.radius.neighbour = basis.neighbour;
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

SolvedSet solve_set(const Basis& basis, double separation, std::uint64_t seed) {
  static const LightScene scene = sphere_over_disk_light_scene().value();
  const LightTransfer transfer = LightTransfer::make(scene, choice_of(basis, separation, seed)).value();
  const LightSolution solution =
      transfer.solve(ParallelLight{.towards = {0, 0, 1}, .power = basis.power}).value();
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
const SolvedSet& solved_set(const Basis& basis, double separation, std::uint64_t seed) {
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
  Comparison(const Basis& basis, double separation, std::uint64_t sets) {
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

/// From the least to the largest that the readings of a statement give.
Approximation over_readings(const std::vector<Approximation>& readings) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Approximation& reading : readings) {
    low = std::min(low, reading.value - reading.radius);
    high = std::max(high, reading.value + reading.radius);
  }
  return {.value = low + (high - low) / 2, .radius = (high - low) / 2};
}

/// The error of an answer that is black everywhere.
double black(Part part, Share share) {
  return profile_errors([](const LitPoint&) { return std::optional(0.0); }, profile(truth(), part, share), 1)
      .l2;
}

/// The error of the worst set over that of a black answer.
Approximation of_black(const SetErrors& errors, Part part, Share share) {
  double largest = 0;
  for (const ProfileErrors& set : errors.sets) largest = std::max(largest, set.l2);
  return {.value = largest / black(part, share), .radius = 0};
}

const AtMost near_the_solution{
    .value = 0.3,
    .slack = 0,
    .why = "three tenths of the error of a black answer, for either part and share"};

std::uint64_t sets_of(const Bench& bench) { return bench.budget == Budget::quick ? 6 : 20; }

const AtMost no_more{.value = 1, .slack = 0, .why = ""};

constexpr std::array<Part, 2> parts{Part::sphere, Part::disk};
constexpr std::array<Share, 2> shares{Share::total, Share::indirect};

}  // namespace

namespace {

Finding accuracy_on(Part part, const Bench& bench) {
  const Comparison shepard(shepard_as_printed, 3, sets_of(bench));
  const Comparison lehtinen(lehtinen_as_printed, 3, sets_of(bench));
  const Comparison interpolated(lehtinen_interpolated, 3, sets_of(bench));
  Finding finding;
  for (const Share share : shares) {
    const SetErrors of_shepard = shepard.errors(part, share);
    const Approximation by_values = ratio(lehtinen.errors(part, share), of_shepard, &ProfileErrors::l2);
    const Approximation solved = ratio(interpolated.errors(part, share), of_shepard, &ProfileErrors::l2);
    finding.require(
        "error of Lehtinen's basis over that of Shepard's, R = N to R = A^-1 N, " + words(part, share),
        no_more, over_readings({by_values, solved}));
    finding.remark("the same by R = N, " + words(part, share), by_values);
    finding.remark("the same by R = A^-1 N, " + words(part, share), solved);
  }
  const Comparison gaussian(gaussian_of_mean_density, 3, 4);
  finding.control("error of the Gaussian basis over that of Shepard's, w_j = area/n, disk, total", no_more,
                  ratio(gaussian.errors(Part::disk, Share::total), shepard.errors(Part::disk, Share::total),
                        &ProfileErrors::l2));
  return finding;
}

}  // namespace

Finding conclusion_accuracy_disk(const Bench& bench) { return accuracy_on(Part::disk, bench); }
Finding conclusion_accuracy_sphere(const Bench& bench) { return accuracy_on(Part::sphere, bench); }

Finding conclusion_accuracy_both(const Bench& bench) {
  const Comparison shepard(shepard_as_printed, 3, sets_of(bench));
  const Comparison lehtinen(lehtinen_as_printed, 3, sets_of(bench));
  const Comparison gaussian(gaussian_of_mean_density, 3, 4);
  const auto over_shepard = [&](const Comparison& basis, Part part) {
    return ratio(basis.errors(part, Share::total), shepard.errors(part, Share::total), &ProfileErrors::l2);
  };
  Finding finding;
  for (const Part part : parts)
    finding.require("error of Lehtinen's basis over that of Shepard's, " + words(part, Share::total), no_more,
                    over_shepard(lehtinen, part));
  finding.control("error of the Gaussian basis over that of Shepard's, w_j = area/n, disk, total", no_more,
                  over_shepard(gaussian, Part::disk));
  return finding;
}

Finding conclusion_accuracy_scene(const Bench& bench) {
  // Sphere and disk have the areas 100 pi and 1600 pi.
  const auto on_scene = [](const Comparison& basis, Share share) {
    SetErrors all = basis.errors(Part::sphere, share);
    const SetErrors of_disk = basis.errors(Part::disk, share);
    for (std::size_t k = 0; k < all.sets.size(); ++k) {
      const double sphere = all.sets[k].l2;
      const double disk = of_disk.sets[k].l2;
      all.sets[k].l2 = std::sqrt((sphere * sphere + 16 * disk * disk) / 17);
    }
    return all;
  };
  const Comparison by_integrals(shepard_as_printed, 3, sets_of(bench));
  Finding finding;
  for (const bool is_integrated : {true, false}) {
    const auto with_weights = [&](const Basis& basis) {
      return Comparison(is_integrated ? basis : of_mean_density(basis), 3, sets_of(bench));
    };
    const Comparison shepard = with_weights(shepard_as_printed);
    const Comparison lehtinen = with_weights(lehtinen_as_printed);
    const auto of = [&](Share share) {
      return ratio(on_scene(lehtinen, share), on_scene(shepard, share), &ProfileErrors::l2);
    };
    const std::string weights = is_integrated ? "w_j integrated" : "w_j = area/n";
    finding.require("error of Lehtinen's basis over that of Shepard's, the scene, total, " + weights, no_more,
                    of(Share::total));
    finding.remark("the same of the light scattered at least twice, " + weights, of(Share::indirect));
  }
  const Comparison gaussian(gaussian_of_mean_density, 3, 4);
  finding.control(
      "error of the Gaussian basis over that of Shepard's, the scene, total, w_j = area/n", no_more,
      ratio(on_scene(gaussian, Share::total), on_scene(by_integrals, Share::total), &ProfileErrors::l2));
  return finding;
}

Finding conclusion_images(const Bench& bench) {
  const Comparison shepard(shepard_as_printed, 3, sets_of(bench));
  const Comparison lehtinen(lehtinen_as_printed, 3, sets_of(bench));
  Finding finding;
  for (const Part part : parts)
    for (const Share share : shares)
      finding.require(
          "oscillation of Lehtinen's basis over that of Shepard's, " + words(part, share), no_more,
          ratio(lehtinen.errors(part, share), shepard.errors(part, share), &ProfileErrors::oscillation));
  const Comparison narrow(lehtinen_to_the_third, 3, sets_of(bench));
  finding.control(
      "oscillation of Lehtinen's basis, radii to the third other, over that of Shepard's, sphere, "
      "total",
      no_more,
      ratio(narrow.errors(Part::sphere, Share::total), shepard.errors(Part::sphere, Share::total),
            &ProfileErrors::oscillation));
  return finding;
}

Finding conclusion_oscillation(const Bench& bench) {
  const auto share_of = [](const SetErrors& errors) {
    return Approximation{.value = errors.systematic / errors.oscillation,
                         .radius = errors.scatter / errors.oscillation};
  };
  const Comparison shepard(shepard_as_printed, 3, sets_of(bench));
  Finding finding;
  std::vector<Approximation> readings;
  for (const Part part : parts)
    for (const Share share : shares) {
      readings.push_back(share_of(shepard.errors(part, share)));
      finding.remark("systematic error over oscillation, Shepard's basis, " + words(part, share),
                     readings.back());
    }
  finding.require("systematic error over oscillation, Shepard's basis, over both parts and shares", no_more,
                  over_readings(readings));
  const Comparison lehtinen(lehtinen_as_printed, 3, sets_of(bench));
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

/// Those whose orders are remarked on, step by step.
std::vector<Refinement> refinements(const Bench& bench) {
  if (bench.budget == Budget::quick) return {{3, 4}, {1.5, 4}};
  if (bench.budget == Budget::standard) return {{3, 20}, {2, 20}, {1.5, 20}, {1, 20}};
  return {{3, 20}, {2, 20}, {1.5, 20}, {1, 20}, {0.7, 20}};
}

/// Those that halve, of which an order is made.
std::vector<Refinement> halvings(const Bench& bench) {
  if (bench.budget == Budget::quick) return {{3, 24}, {1.5, 12}, {0.75, 4}};
  return {{3, 20}, {1.5, 20}, {0.75, 20}};
}

std::string words(const Basis& basis) {
  switch (basis.family) {
    case Family::shepard: return "Shepard's basis";
    case Family::lehtinen: return "Lehtinen's basis";
    case Family::gaussian: break;
  }
  return "the Gaussian basis";
}

/// The exponent of the separation with which an error falls by a factor.
Approximation order_of(const Approximation& fall, double fine, double coarse) {
  const double step = std::log(fine / coarse);
  return {.value = std::log(fall.value) / step,
          .radius = std::log1p(fall.radius / fall.value) / std::abs(step)};
}

/// In the root mean square, of a mean over the separation s: a kink is blurred by s over a width s, a jump by
/// 1 over a width s. Slower than these are 1/2 and 0, where nothing falls.
Order order_of_kink() { return Order::at_least(1.5, 0.5); }
Order order_of_jump() { return Order::at_least(0.5, 0); }

/// The order of the geometric mean over the sets in the separation, that mean with twice its standard error.
ObservedOrder order_in_separation(const Basis& basis, const std::vector<Refinement>& steps, Part part,
                                  Share share) {
  LevelErrors errors;
  for (const Refinement& step : steps) {
    const SetErrors of = Comparison(basis, step.separation, step.sets).errors(part, share);
    SetErrors one = of;
    for (ProfileErrors& set : one.sets) set.l2 = 1;
    errors.mesh_sizes.push_back(step.separation);
    errors.errors.push_back(ratio(of, one, &ProfileErrors::l2));
  }
  return observed_order(errors);
}

/// The error at the finest separation over that at the coarsest, and the orders on the way.
void converges(Finding& finding, const Bench& bench) {
  const std::vector<Refinement> steps = halvings(bench);
  const Refinement& first = steps.front();
  const Refinement& last = steps.back();
  const Comparison coarsest(lehtinen_as_printed, first.separation, first.sets);
  const Comparison finest(lehtinen_as_printed, last.separation, last.sets);
  const std::string separation = shortest(last.separation);
  for (const Part part : parts)
    for (const Share share : shares) {
      const std::string of = ", " + words(part, share);
      finding.require("error at separation " + separation + " over that at 3" + of, no_more,
                      ratio(finest.errors(part, share), coarsest.errors(part, share), &ProfileErrors::l2));
      finding.require(
          "error at separation " + separation + " over that of a black answer, the worst set" + of,
          near_the_solution, of_black(finest.errors(part, share), part, share));
      if (share == Share::total)
        finding.require("order from separation 3 to " + separation + of,
                        part == Part::sphere ? order_of_kink() : order_of_jump(),
                        order_in_separation(lehtinen_as_printed, steps, part, share));
    }
}

/// The orders from each separation to the next.
void remark_orders(Finding& finding, const Basis& basis, const Bench& bench) {
  const std::vector<Refinement> steps = refinements(bench);
  for (const Part part : parts)
    for (const Share share : shares)
      for (std::size_t k = 1; k < steps.size(); ++k) {
        const Refinement& coarse = steps[k - 1];
        const Refinement& fine = steps[k];
        const Approximation fall =
            ratio(Comparison(basis, fine.separation, fine.sets).errors(part, share),
                  Comparison(basis, coarse.separation, coarse.sets).errors(part, share), &ProfileErrors::l2);
        finding.remark("order from separation " + shortest(coarse.separation) + " to " +
                           shortest(fine.separation) + ", " + words(basis) + ", " + words(part, share),
                       order_of(fall, fine.separation, coarse.separation));
      }
}

/// Between what the error tends to if its order stays as it is, 0, and if the order falls by the same factor
/// at each step, as from the first of three separations in geometric progression to the last, over that of a
/// black answer.
Approximation limit_of_error(const std::array<SetErrors, 3>& errors, Part part, Share share) {
  const double first = std::log(ratio(errors[1], errors[0], &ProfileErrors::l2).value);
  const double second = std::log(ratio(errors[2], errors[1], &ProfileErrors::l2).value);
  const double factor = second / first;
  double mean = 0;
  for (const ProfileErrors& set : errors[2].sets) mean += set.l2 / static_cast<double>(errors[2].sets.size());
  // An order that is seen to grow says as little as one error alone.
  const bool slows_down = first < 0 && 0 < factor && factor < 1;
  const double slowed = slows_down ? mean * std::exp(second * factor / (1 - factor)) : mean;
  const double most = slowed / black(part, share);
  return {.value = most / 2, .radius = most / 2};
}

Finding solution_of(const Basis& basis, const Bench& bench) {
  const Comparison compared(basis, 3, sets_of(bench));
  const AtMost contracts{.value = 1, .slack = 0, .why = "(6) converges"};
  Finding finding;
  double bound = 0;
  for (const SolvedSet* set : compared.sets()) bound = std::max(bound, set->spectral_radius_bound);
  finding.require("spectral radius of R in each of the sets, at most", contracts,
                  Approximation::proved(bound, 0));
  const Comparison dim(by_half_the_light(basis), 3, 1);
  const Comparison wrong(gaussian_of_mean_density, 3, 1);
  for (const Part part : parts)
    for (const Share share : shares) {
      finding.require("error of the worst set over that of a black answer, " + words(part, share),
                      near_the_solution, of_black(compared.errors(part, share), part, share));
      finding.control("the same by half of the light, one set, " + words(part, share), near_the_solution,
                      of_black(dim.errors(part, share), part, share));
    }
  finding.control("the same for the Gaussian basis with w_j = area/n, one set, disk, total",
                  near_the_solution,
                  of_black(wrong.errors(Part::disk, Share::total), Part::disk, Share::total));
  return finding;
}

}  // namespace

Finding section_8_shepard(const Bench& bench) { return solution_of(shepard_as_printed, bench); }
Finding section_8_lehtinen(const Bench& bench) { return solution_of(lehtinen_as_printed, bench); }

namespace {

Finding figure_of(const Basis& basis) {
  Finding finding;
  for (const Part part : parts)
    finding.require("error of the figure's curves over that of a black answer, " + words(part, Share::total),
                    near_the_solution, read_off_the_picture());
  finding.control("the same of ours by half of the light, one set, sphere, total", near_the_solution,
                  of_black(Comparison(by_half_the_light(basis), 3, 1).errors(Part::sphere, Share::total),
                           Part::sphere, Share::total));
  return finding;
}

}  // namespace

Finding figure_11(const Bench&) { return figure_of(shepard_as_printed); }
Finding figure_13(const Bench&) { return figure_of(lehtinen_as_printed); }

Finding section_8_same_values(const Bench& bench) {
  Finding finding;
  converges(finding, bench);
  remark_orders(finding, lehtinen_as_printed, bench);
  const SetErrors fine = Comparison(gaussian_of_mean_density, 1.5, 4).errors(Part::disk, Share::total);
  finding.control("error at separation 1.5 over that of a black answer, the Gaussian basis, disk, total",
                  near_the_solution, of_black(fine, Part::disk, Share::total));
  finding.control("order from separation 6 to 1.5, Lehtinen's basis by half of the light, disk, total",
                  order_of_jump(),
                  order_in_separation(by_half_the_light(lehtinen_as_printed), {{6, 4}, {3, 4}, {1.5, 4}},
                                      Part::disk, Share::total));
  return finding;
}

Finding section_8_same_values_shepard(const Bench& bench) {
  const std::uint64_t sets = bench.budget == Budget::quick ? 2 : 20;
  const Equals none{.value = 0, .slack = 0, .why = "the same values"};
  Finding finding;
  for (const Part part : parts) {
    std::array<SetErrors, 3> errors;
    const std::array<double, 3> separations{3, 1.5 * std::numbers::sqrt2, 1.5};
    for (std::size_t k = 0; k < errors.size(); ++k)
      errors[k] = Comparison(shepard_as_printed, separations[k], sets).errors(part, Share::total);
    finding.require("what the error tends to, over that of a black answer, " + words(part, Share::total),
                    none, limit_of_error(errors, part, Share::total));
  }
  if (bench.budget != Budget::quick) remark_orders(finding, shepard_as_printed, bench);
  finding.control(
      "error at separation 3 by half of the light, over that of a black answer, disk, total", none,
      of_black(Comparison(by_half_the_light(shepard_as_printed), 3, 1).errors(Part::disk, Share::total),
               Part::disk, Share::total));
  return finding;
}

Finding section_8_gaussian(const Bench&) {
  const auto error = [](const Basis& basis, double separation) {
    return of_black(Comparison(basis, separation, 4).errors(Part::disk, Share::total), Part::disk,
                    Share::total);
  };
  const std::string of = " over that of a black answer, disk, total, ";
  Finding finding;
  for (const double separation : {3.0, 1.5}) {
    const std::string at = "error at separation " + shortest(separation) + of;
    finding.require(at + "the Gaussian basis, w_j = area/n", near_the_solution,
                    error(gaussian_of_mean_density, separation));
    for (const Basis& basis : {shepard_as_printed, lehtinen_as_printed})
      finding.instead(at + words(basis), near_the_solution, error(basis, separation));
  }
  finding.control("error at separation 3" + of + "Lehtinen's basis by half of the light", near_the_solution,
                  error(by_half_the_light(lehtinen_as_printed), 3));
  return finding;
}

Finding figure_12(const Bench&) {
  const LightScene scene = sphere_over_disk_light_scene().value();
  enum class Weights { integrated, of_plane, of_neighbours };
  const auto radius = [&](const RadialBasisChoice& choice, std::uint64_t seed, Weights rule) {
    const RadialBasis basis =
        RadialBasis::make(
            make_sites(scene.surface(), PoissonDiskSites{.separation = 3, .seed = seed}).value(), choice)
            .value();
    const std::vector<double> weights =
        rule == Weights::integrated
            ? integrate_basis(basis, scene.surface(), {.relative_error = 1e-3, .most_points = 100'000})
                  .weights
        : rule == Weights::of_plane ? plane_weights(basis).value()
                                    : neighbour_weights(basis).value();
    return proved_spectral_radius(point_light_transfer(scene, basis.sites(), weights));
  };
  const RadialBasisChoice gaussian = radial_choice(Family::gaussian);
  RadialBasisChoice nine = gaussian;
  nine.radius.neighbour = 9;
  const AtMost converges{.value = 1, .slack = 0, .why = "(6) converges"};
  Finding finding;
  for (const std::uint64_t seed : {1U, 2U, 3U})
    finding.require(
        "bound of the spectral radius of R, w_j integrated over the scene, sites " + std::to_string(seed),
        converges, radius(gaussian, seed, Weights::integrated));
  finding.require("the same, radii to the ninth other, sites 1", converges,
                  radius(nine, 1, Weights::integrated));
  finding.require("the same, w_j = pi alpha^2/10, sites 1", converges,
                  radius(gaussian, 1, Weights::of_neighbours));
  finding.instead("the same, Shepard's basis, w_j integrated, sites 1", converges,
                  radius(shepard_basis(), 1, Weights::integrated));
  finding.instead("the same, Lehtinen's basis, w_j integrated, sites 1", converges,
                  radius(lehtinen_basis(), 1, Weights::integrated));
  finding.control("the same, w_j integrated over the plane, sites 1", converges,
                  radius(gaussian, 1, Weights::of_plane));
  return finding;
}

}  // namespace radcert::verification::psg10
