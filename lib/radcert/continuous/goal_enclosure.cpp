// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/goal_enclosure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/goals.h"
#include "radcert/continuous/observer_cells.h"
#include "radcert/continuous/residual.h"
#include "radcert/continuous/scaled_problem.h"
#include "radcert/continuous/trial.h"
#include "radcert/continuous/trial_functions.h"
#include "radcert/core/contract.h"

namespace radcert {

const WorkLimit most_layers("continuous/goal_enclosure: layers of elements", 8, 2,
                            "a wider enclosure, with its reason");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Of what is wanted: its products with bounds stay within double.
constexpr double largest_radius = 1e100;

/// What cells miss by their rules, before any sample is taken.
struct Missed {
  double norm = 0;
  double product = 0;
  double shade = 0;  ///< of products
};

Missed missed_by(const Trial& trial, std::span<const ObserverCell> cells) {
  double squares = 0;
  double products = 0;
  double shade = 0;
  for (const ObserverCell& cell : cells) {
    const double area = trial.sector(cell.element).jacobian * cell.box.weight();
    const double rho = trial.rho(cell.element);
    if (cell.is_strip()) {
      const double largest = trial.smoothness.residual_size(cell.element);
      squares += rho * area * largest * largest;
      products += area * largest * trial.smoothness.density_size(cell.element);
    } else {
      const double beside = 2 * cell.interpolation + cell.shade;
      squares += rho * area * beside * beside;
      products += area * cell.quadrature;
      shade += area * cell.shade_of_mean;
    }
  }
  return {std::sqrt(squares), products, shade};
}

/// Cells whose rules miss about this much in all.
struct Plan {
  std::vector<ObserverCell> cells;
  CellDemand demand;
  bool is_kept = true;  ///< whether they miss no more than ten times what they may
};

Plan plan_cells(const Trial& trial, const Missed& allowed, MeshWork& work) {
  Plan plan;
  double count = 40.0 * static_cast<double>(trial.elements.size());
  Missed aim = allowed;
  constexpr int tries = 4;
  for (int k = 0; k < tries; ++k) {
    plan.demand = {.interpolation = aim.norm / std::sqrt(count),
                   .quadrature = aim.product / count,
                   .shade = aim.shade / count};
    work.begin_plan();
    plan.cells = observer_cells(trial, plan.demand, [&] { work.add_planned(); });
    const Missed found = missed_by(trial, plan.cells);
    plan.is_kept = found.norm <= 10 * allowed.norm && found.product <= 10 * allowed.product;
    if (found.norm <= allowed.norm && found.product <= allowed.product && found.shade <= allowed.shade) break;
    // Limits of the cells' number were met: smaller demands would meet them again.
    if (!(found.norm <= 1000 * allowed.norm && found.product <= 1000 * allowed.product)) break;
    aim.norm *= std::min(1.0, 0.9 * allowed.norm / found.norm);
    aim.product *= std::min(1.0, 0.9 * allowed.product / found.product);
    // Twice as many cells leave, each, about a third as much.
    if (found.shade > 0) aim.shade *= std::min(1.0, std::pow(0.9 * allowed.shade / found.shade, 1.5));
  }
  return plan;
}

/// Rounds coefficients so that the first of the 16 hexadecimal digits of their bits hold them.
/// Maths     d digits hold sign, exponent and 4 d - 12 bits of the fraction: a coefficient moves by no more
///           than 2^-(4d-11) of itself, d the least number for which that is at most `allowed`
void shorten(SectorFunctions& functions, double allowed) {
  constexpr int fraction = 52;
  int bits = 4;
  while (bits < fraction && std::ldexp(0.5, -bits) > allowed) bits += 4;
  const auto dropped = static_cast<unsigned>(fraction - bits);
  if (dropped == 0) return;
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  for (double& c : functions.all())
    c = std::bit_cast<double>((std::bit_cast<std::uint64_t>(c) + half) >> dropped << dropped);
}

/// The functions of a certificate, q_0 and q_k, or q_k + j_kh where the j_kh are given; q is what they leave
/// after they were shortened.
SectorFunctions shortened(SectorFunctions& q, const DualErrors& duals, double allowed) {
  if (!duals.polynomials) {
    shorten(q, allowed);
    return q;
  }
  const SectorFunctions& j = *duals.polynomials;
  const std::size_t elements = q.all().size() / (q.count() * q.size());
  SectorFunctions out = q;
  const auto each = [&](const auto& act) {
    for (std::size_t e = 0; e < elements; ++e)
      for (std::size_t k = 0; k < j.count(); ++k)
        for (std::size_t i = 0; i < q.size(); ++i) act(e, k, i);
  };
  each([&](std::size_t e, std::size_t k, std::size_t i) { out.of(e, 1 + k)[i] += j.of(e, k)[i]; });
  shorten(out, allowed);
  q = out;
  each([&](std::size_t e, std::size_t k, std::size_t i) { q.of(e, 1 + k)[i] -= j.of(e, k)[i]; });
  return out;
}

Approximation scaled(const Approximation& x, int exponent) {
  return {std::ldexp(x.value, exponent), std::ldexp(x.radius, exponent), x.guaranteed};
}

class Search {
public:
  Search(const ScaledProblem& data, const Goals& goals, double wanted, bool with_proof)
      : data_(data),
        goals_(goals),
        wanted_(wanted),
        with_proof_(with_proof),
        radius_(std::min(goals.radius(0.5 * std::ldexp(wanted, -data.exponent)), largest_radius)) {
    best_.width = infinity;
    best_.numbers.assign(data.emissions() * goals.count(), Approximation::proved(0, infinity));
  }

  GoalEnclosure operator()(const SearchContext& context) {
    if (!data_.reflects || !goals_.depend_on_u()) return of_emission();
    for (int layers = 2; layers <= most_layers.value(); ++layers) {
      if (!try_layers(layers, context)) continue;
      if (!best_.hindrance.empty()) return best_;
      if (context.progress) context.progress(best_.last);
      if (best_.width <= wanted_) return best_;
    }
    best_.hindrance = "the residual of polynomials of degree " + std::to_string(best_.last.degree) + " on " +
                      std::to_string(best_.last.layers) + " layers of elements";
    return best_;
  }

private:
  /// Functions of E and of the goals on elements beside q of a degree, and what they are off by.
  struct Emissions {
    SectorFunctions functions;
    DualErrors duals;
  };
  [[nodiscard]] Emissions emissions(std::span<const SectorElement> elements, int degree) const {
    const int of_w = degree + data_.reflectivity.degree();
    Emissions out{.functions = SectorFunctions(elements.size(), data_.emissions() + goals_.count(), of_w),
                  .duals = {}};
    for (std::size_t i = 0; i < data_.emissions(); ++i) {
      const SectorFunctions f =
          plane_functions(data_.emission(i), data_.scene, elements, 1, of_w, data_.exponent);
      for (std::size_t e = 0; e < elements.size(); ++e)
        std::copy(f.of(e, 0).begin(), f.of(e, 0).end(), out.functions.of(e, i).begin());
    }
    out.duals = goals_.put_duals(elements, out.functions);
    return out;
  }

  /// Where nothing reflects, u = E.
  GoalEnclosure of_emission() {
    const std::vector<SectorElement> whole = graded_elements(data_.scene, 1);
    const int degree = data_.trial_degree(0);
    const Emissions given = emissions(whole, degree);
    const Trial trial(data_.scene, data_.reflectivity, whole, given.functions,
                      SectorFunctions(whole.size(), given.functions.count(), degree), given.duals.rounding);
    best_.width = 0;
    for (std::size_t i = 0; i < data_.emissions(); ++i) {
      const std::vector<Approximation> found = goals_.of_density(trial, 0.1 * radius_, i);
      for (std::size_t k = 0; k < goals_.count(); ++k) take(i, k, found[k]);
    }
    best_.last.width = best_.width;
    return best_;
  }

  /// The enclosure of number k of an emission from that of J_k, for E times 2^-exponent, if it is better.
  void take(std::size_t emission, std::size_t k, const Approximation& functional) {
    const Approximation number = goals_.number(k, scaled(functional, data_.exponent), emission);
    Approximation& best = best_.numbers[emission * goals_.count() + k];
    if (std::isfinite(number.value) && number.radius >= 0 && number.radius < best.radius) best = number;
    best_.width = std::max(best_.width, 2 * best.radius);
  }

  /// One mesh; false where it is passed over, since its residuals would be too large.
  bool try_layers(int layers, const SearchContext& context) {
    const int degree = data_.trial_degree(std::max(layers - 1, goals_.least_degree()));
    // About what the residuals of a cube come to on so many layers; the systems are solved far better.
    const double usual = 0.05 * std::pow(4.0, -layers);
    const double tolerance = 0.01 * usual;
    const double allowed = std::max(usual, std::min(0.1, 0.35 * radius_ * data_.gap / usual));
    std::vector<SectorElement> elements =
        goals_.refined(graded_elements(data_.scene, layers), degree, allowed);
    EnclosureProgress begun{.layers = layers, .degree = degree, .elements = elements.size()};
    begun.samples = best_.last.samples;
    begun.width = best_.width;
    MeshWork work(context, begun);
    const Emissions given = emissions(elements, degree);
    for (const double left : given.duals.left)
      if (!(left <= 10 * allowed)) {
        best_.hindrance = "too many elements would carry the kernel of a point near an edge";
        return true;
      }
    SectorFunctions q = kept_functions(work, given.functions.count(), degree, elements.size(), [&] {
      return trial_functions(data_.scene, elements, data_.reflectivity, given.functions, tolerance);
    });
    // Any functions will do, and those of a certificate are written down.
    std::optional<SectorFunctions> written;
    if (with_proof_) written = shortened(q, given.duals, tolerance);
    const Trial trial(data_.scene, data_.reflectivity, std::move(elements), given.functions, std::move(q),
                      given.duals.rounding);
    const std::vector<double> expected = expected_norms(trial);
    const std::size_t emissions = data_.emissions();
    const double norm_0 =
        1.2 * *std::max_element(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(emissions));
    double norm_k = 0;
    for (std::size_t k = 0; k < goals_.count(); ++k)
      norm_k = std::max(norm_k, 1.2 * expected[emissions + k] + given.duals.left[k]);
    // What rules may miss, m: (norm_0 + m)(norm_k + m)/(1-s) is to leave a part of the radius for the rest.
    const bool is_open = data_.scene.sight().is_open();
    const double affordable = (is_open ? 0.7 : 0.25) * radius_ * data_.gap;
    const double sum = 0.5 * (norm_0 + norm_k);
    const double m = std::sqrt(std::max(0.0, sum * sum - norm_0 * norm_k + affordable)) - sum;
    const double smaller = std::min(norm_0, norm_k);
    const bool enough = m >= 0.25 * smaller;
    const bool last = layers == most_layers.value();
    if (!enough && !last && layers > 2) return false;
    const double allowed_norm = enough ? m : smaller;
    const double allowed_product = std::max(0.07 * radius_, 0.05 * norm_0 * norm_k / data_.gap);
    const Plan plan =
        plan_cells(trial, {.norm = allowed_norm, .product = allowed_product, .shade = 0.5 * radius_}, work);
    // Cells that come to their limits are worth no samples, and finer elements would not help them.
    if (!plan.is_kept) {
      best_.hindrance = "too many cells: the polyhedron is too thin, or its edges are too sharp";
      return true;
    }
    work.begin(plan.cells.size());
    const ResidualSums sums = residual_sums(trial, plan.cells, plan.demand, with_proof_, &work, emissions);
    best_.width = 0;
    std::vector<double> radii;
    for (std::size_t i = 0; i < emissions; ++i) {
      const std::vector<Approximation> of_density = goals_.of_density(trial, 0.1 * radius_, i);
      for (std::size_t k = 0; k < goals_.count(); ++k) {
        const std::size_t dual = emissions + k;
        const double goal = sums.norms[i] * (sums.norms[dual] + given.duals.left[k]) / data_.gap * upward;
        const Approximation functional =
            of_density[k] + sums.products[i * trial.w.count() + dual] + Approximation::proved(0, goal);
        radii.push_back(functional.radius);
        take(i, k, functional);
      }
    }
    if (with_proof_) {
      GoalProof proof{.elements = trial.elements,
                      .q = *std::move(written),
                      .exponent = data_.exponent,
                      .exponents = {},
                      .residuals = sums.elements,
                      .norms = sums.norms,
                      .radii = std::move(radii),
                      .wanted = radius_};
      for (std::size_t k = 0; k < goals_.count(); ++k) {
        proof.exponents.push_back(goals_.exponent(k));
        proof.norms[1 + k] += given.duals.left[k];
        if (!given.duals.polynomials) continue;
        for (std::size_t e = 0; e < proof.residuals.size(); ++e)
          proof.residuals[e].norms[1 + k] += given.duals.left_on_elements[e * goals_.count() + k];
      }
      best_.proof = std::make_shared<const GoalProof>(std::move(proof));
    }
    best_.last = {.layers = layers,
                  .degree = degree,
                  .elements = trial.elements.size(),
                  .unknowns = trial.elements.size() * trial.q.size(),
                  .mesh_size = mesh_size(data_.scene, trial.elements),
                  .samples = best_.last.samples + sums.samples,
                  .width = best_.width,
                  .residual = *std::max_element(sums.norms.begin(),
                                                sums.norms.begin() + static_cast<std::ptrdiff_t>(emissions))};
    return true;
  }

  const ScaledProblem& data_;
  const Goals& goals_;
  double wanted_;
  bool with_proof_;
  double radius_;  ///< for J_k
  GoalEnclosure best_;
};

}  // namespace

GoalEnclosure enclose_means(const PolyhedronProblem& problem, double wanted, const SearchContext& context,
                            bool with_proof) {
  expects(wanted > 0 && std::isfinite(wanted), "0 < wanted < infinity", named("wanted", wanted));
  const ScaledProblem data(problem);
  expects(!with_proof || data.emissions() == 1, "one emission beside a proof");
  const std::unique_ptr<Goals> goals = piece_means(data.scene, data.reflectivity);
  return Search(data, *goals, wanted, with_proof)(context);
}

GoalEnclosure enclose_values(const PolyhedronProblem& problem, const std::vector<SolutionPoint>& points,
                             double wanted, const SearchContext& context, bool with_proof) {
  expects(wanted > 0 && std::isfinite(wanted), "0 < wanted < infinity", named("wanted", wanted));
  const ScaledProblem data(problem);
  expects(!with_proof || data.emissions() == 1, "one emission beside a proof");
  std::vector<ValueGoal> asked;
  for (const SolutionPoint& point : points) {
    const ParameterPoint<Rational> at = plane_coordinates(problem.panels[point.panel], point.at);
    std::vector<Approximation> emissions;
    for (std::size_t i = 0; i < data.emissions(); ++i) {
      const double value = data.emission(i)[point.panel].value(at.s, at.t).to_double();
      emissions.push_back(Approximation::proved(
          value, unit_roundoff<double>() * std::abs(value) + std::numeric_limits<double>::denorm_min()));
    }
    asked.push_back(
        {.point = point,
         .emissions = std::move(emissions),
         .reflectivity = problem.reflectivity[point.panel].polynomial.value(at.s, at.t).to_double()});
  }
  const std::unique_ptr<Goals> goals = point_values(data.scene, data.reflectivity, asked);
  return Search(data, *goals, wanted, with_proof)(context);
}

}  // namespace radcert
