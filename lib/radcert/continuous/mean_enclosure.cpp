// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/mean_enclosure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "radcert/continuous/graded_elements.h"
#include "radcert/continuous/observer_cells.h"
#include "radcert/continuous/residual.h"
#include "radcert/continuous/sector.h"
#include "radcert/continuous/trial_functions.h"
#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"

namespace radcert {

const WorkLimit most_layers("continuous/mean_enclosure: layers of elements", 8, 2,
                            "a wider enclosure, with its reason");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double upward = 1 + 0x1p-40;

/// The problem in double: function 0 is that of E, function 1 + k that of the mean over piece k.
struct Discrete {
  SectorScene scene;
  PanelData data;
  std::vector<double> piece_area;

  explicit Discrete(const PolyhedronProblem& problem) : scene(problem.panels) {
    const std::size_t panels = scene.panels().size();
    std::size_t pieces = 0;
    for (const Panel& panel : scene.panels()) pieces = std::max(pieces, panel.piece + 1);
    data.emissions.assign(pieces + 1, std::vector<double>(panels));
    piece_area.resize(pieces);
    for (std::size_t j = 0; j < panels; ++j) {
      const std::size_t piece = problem.panels[j].piece;
      data.reflectivity.push_back(problem.reflectivity[j].to_double());
      data.emissions[0][j] = problem.emission[j].to_double();
      data.emissions[1 + piece][j] = data.reflectivity[j];
      piece_area[piece] += scene.area(j);
    }
    // All functions are of one size: what bounds them bounds them together.
    double largest = 0;
    for (const double e : data.emissions[0]) largest = std::max(largest, std::abs(e));
    if (largest > 0) std::frexp(largest, &exponent);
    for (double& e : data.emissions[0]) e = std::ldexp(e, -exponent);
  }
  int exponent = 0;  ///< E and u are 2^exponent times those of function 0
};

/// Int (E + rho q_0) over the pieces, with a bound of what rounding does.
struct TrialMeans {
  std::vector<double> integrals;
  double rounding = 0;
};

TrialMeans integrals_of_v(const Discrete& discrete, std::span<const SectorElement> elements,
                          const SectorFunctions& q) {
  TrialMeans out{.integrals = std::vector<double>(discrete.piece_area.size()), .rounding = 0};
  double sizes = 0;
  const SectorScene& scene = discrete.scene;
  for (std::size_t j = 0; j < scene.panels().size(); ++j) {
    const double term = discrete.data.emissions[0][j] * scene.area(j);
    out.integrals[scene.panels()[j].piece] += term;
    sizes += std::abs(term);
  }
  const auto powers = static_cast<std::size_t>(q.degree() + 1);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Sector& sector = scene.sectors()[elements[e].sector];
    const SectorBox& box = elements[e].box;
    const std::span<const double> c = q.of(e, 0);
    // Int P_0(y) (1-t) and Int P_1(y) (1-t): 1 - t = 1 - t_m - (t_1 - t_0)/2 y
    const double second = powers > 1 ? c[1] * (box.t1 - box.t0) / 6 : 0;
    const double scale =
        discrete.data.reflectivity[sector.panel] * sector.jacobian * (box.s1 - box.s0) * (box.t1 - box.t0);
    out.integrals[scene.panels()[sector.panel].piece] += scale * (c[0] * (1 - box.middle_t()) - second);
    sizes += scale * (std::abs(c[0]) * (1 - box.middle_t()) + std::abs(second));
  }
  const auto terms = static_cast<double>(elements.size() + scene.panels().size() + 16);
  out.rounding = terms * unit_roundoff<double>() * sizes * upward;
  return out;
}

/// The elements and functions of one mesh.
struct Trial {
  std::vector<SectorElement> elements;
  SectorFunctions q;
  SectorFunctions w;
  Smoothness smoothness;

  Trial(const Discrete& discrete, int layers, int degree)
      : elements(graded_elements(discrete.scene, layers)),
        q(trial_functions(discrete.scene, elements, discrete.data, degree, 5e-4 * std::pow(4.0, -layers))),
        w(densities(discrete.scene, elements, discrete.data, q)),
        smoothness(discrete.scene, elements, w, q) {}
};

/// What cells miss by their rules, before any sample is taken.
struct Missed {
  double norm = 0;
  double product = 0;
};

Missed missed_by(const Discrete& discrete, const Trial& trial, std::span<const ObserverCell> cells) {
  double squares = 0;
  double products = 0;
  for (const ObserverCell& cell : cells) {
    const Sector& sector = discrete.scene.sectors()[trial.elements[cell.element].sector];
    const double area = sector.jacobian * cell.box.weight();
    const double rho = discrete.data.reflectivity[sector.panel];
    if (cell.nodes_s == 0) {
      const double largest = trial.smoothness.residual_size(cell.element);
      squares += rho * area * largest * largest;
      products += area * largest * trial.smoothness.density_size(cell.element);
    } else {
      squares += 4 * rho * area * cell.interpolation * cell.interpolation;
      products += area * cell.quadrature;
    }
  }
  return {std::sqrt(squares), products};
}

/// Cells whose rules miss about this much in all.
struct Plan {
  std::vector<ObserverCell> cells;
  CellDemand demand;
  bool is_kept = true;  ///< whether they miss no more than ten times what they may
};

Plan plan_cells(const Discrete& discrete, const Trial& trial, const Missed& allowed) {
  Plan plan;
  double count = 40.0 * static_cast<double>(trial.elements.size());
  Missed aim = allowed;
  constexpr int tries = 4;
  for (int k = 0; k < tries; ++k) {
    plan.demand = {.interpolation = aim.norm / std::sqrt(count), .quadrature = aim.product / count};
    plan.cells = observer_cells(discrete.scene, trial.elements, trial.smoothness, plan.demand);
    const Missed found = missed_by(discrete, trial, plan.cells);
    plan.is_kept = found.norm <= 10 * allowed.norm && found.product <= 10 * allowed.product;
    if (found.norm <= allowed.norm && found.product <= allowed.product) break;
    aim.norm *= std::min(1.0, 0.9 * allowed.norm / found.norm);
    aim.product *= std::min(1.0, 0.9 * allowed.product / found.product);
  }
  return plan;
}

/// Where nothing reflects, u = E.
MeanEnclosure means_of_emission(const PolyhedronProblem& problem, const Discrete& discrete) {
  MeanEnclosure found;
  const auto sectors = static_cast<double>(discrete.scene.sectors().size());
  for (std::size_t k = 0; k < discrete.piece_area.size(); ++k) {
    double value = 0;
    double size = 0;
    for (std::size_t j = 0; j < problem.panels.size(); ++j) {
      if (problem.panels[j].piece != k) continue;
      const double share = discrete.scene.area(j) / discrete.piece_area[k];
      value += share * problem.emission[j].to_double();
      size += share * std::abs(problem.emission[j].to_double());
    }
    found.means.push_back(
        Approximation::proved(value, (sectors + 8) * unit_roundoff<double>() * size * upward));
    found.width = std::max(found.width, 2 * found.means.back().radius);
  }
  found.last.width = found.width;
  return found;
}

}  // namespace

MeanEnclosure enclose_means(const PolyhedronProblem& problem, double wanted,
                            const std::function<void(const EnclosureProgress&)>& progress) {
  expects(wanted > 0, "wanted > 0");
  const Discrete discrete(problem);
  const std::size_t pieces = discrete.piece_area.size();
  if (std::all_of(problem.reflectivity.begin(), problem.reflectivity.end(),
                  [](const Rational& rho) { return rho.sign() == 0; }))
    return means_of_emission(problem, discrete);
  const double smallest_area = *std::min_element(discrete.piece_area.begin(), discrete.piece_area.end());
  const double radius = std::ldexp(0.5 * wanted, -discrete.exponent) * smallest_area;
  const Rational largest = *std::max_element(problem.reflectivity.begin(), problem.reflectivity.end());
  const double gap = (Rational(1) - largest).to_double() / upward;
  expects(gap > 0, "rho < 1");
  const auto sectors = static_cast<double>(discrete.scene.sectors().size());

  MeanEnclosure best;
  best.width = infinity;
  best.means.assign(pieces, Approximation::proved(0, infinity));
  std::size_t samples = 0;
  for (int layers = 2; layers <= most_layers.value(); ++layers) {
    const int degree = layers - 1;
    const Trial trial(discrete, layers, degree);
    const std::vector<double> expected =
        expected_norms(discrete.scene, trial.elements, discrete.data, trial.w, trial.q, trial.smoothness);
    const double norm_0 = 1.2 * expected[0];
    const double norm_k = 1.2 * *std::max_element(expected.begin() + 1, expected.end());
    // What rules may miss, m: (norm_0 + m)(norm_k + m)/(1-s) is to leave a part of the radius for the rest.
    const double affordable = 0.7 * radius * gap;
    const double sum = 0.5 * (norm_0 + norm_k);
    const double m = std::sqrt(std::max(0.0, sum * sum - norm_0 * norm_k + affordable)) - sum;
    const double smaller = std::min(norm_0, norm_k);
    const bool enough = m >= 0.25 * smaller;
    const bool last = layers == most_layers.value();
    if (!enough && !last && layers > 2) continue;
    const double allowed_norm = enough ? m : smaller;
    const double allowed_product = std::max(0.07 * radius, 0.05 * norm_0 * norm_k / gap);
    const Plan plan = plan_cells(discrete, trial, {allowed_norm, allowed_product});
    // Cells that come to their limits are worth no samples, and finer elements would not help them.
    if (!plan.is_kept) {
      best.hindrance = "too many cells: the polyhedron is too thin, or its edges are too sharp";
      break;
    }
    const ResidualSums sums = residual_sums(discrete.scene, trial.elements, discrete.data, trial.w, trial.q,
                                            trial.smoothness, plan.cells, plan.demand);
    samples += sums.samples;
    const TrialMeans v = integrals_of_v(discrete, trial.elements, trial.q);
    best.width = 0;
    for (std::size_t k = 0; k < pieces; ++k) {
      const double area = discrete.piece_area[k];
      const double goal = sums.norms[0] * sums.norms[1 + k] / gap;
      const double value =
          std::ldexp((v.integrals[k] + sums.products[1 + k].value) / area, discrete.exponent);
      const double off =
          std::ldexp((goal + sums.products[1 + k].radius + v.rounding) / area * upward, discrete.exponent) +
          (64 + sectors) * unit_roundoff<double>() * std::abs(value);
      if (std::isfinite(value) && off >= 0 && off < best.means[k].radius)
        best.means[k] = Approximation::proved(value, off);
      best.width = std::max(best.width, 2 * best.means[k].radius);
    }
    best.last = {.layers = layers,
                 .degree = degree,
                 .elements = trial.elements.size(),
                 .unknowns = trial.elements.size() * trial.q.size(),
                 .mesh_size = mesh_size(discrete.scene, trial.elements),
                 .samples = samples,
                 .width = best.width,
                 .residual = sums.norms[0]};
    if (progress) progress(best.last);
    if (best.width <= wanted) return best;
  }
  if (!best.hindrance.empty()) return best;
  best.hindrance = "the residual of polynomials of degree " + std::to_string(best.last.degree) + " on " +
                   std::to_string(best.last.layers) + " layers of elements";
  return best;
}

}  // namespace radcert
