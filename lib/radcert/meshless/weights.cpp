// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/meshless/surface_cells.h"
#include "radcert/polynomial/rules/conical_rule.h"

namespace radcert {
namespace {

/// Sums over the cells of one size.
struct CellSums {
  std::vector<double> weights;
  double area = 0;
  double uncovered = 0;
};

CellSums sum_over(const RadialBasis& basis, const Surface& surface, std::span<const SurfaceCell> cells,
                  const TriangleRule<double>& rule) {
  // Each chunk has its own n sums: few chunks.
  constexpr std::size_t chunks = 32;
  const std::size_t grain = std::max<std::size_t>(1, (cells.size() + chunks - 1) / chunks);
  const auto part = [&](std::size_t begin, std::size_t end) {
    CellSums sums{.weights = std::vector<double>(basis.size(), 0.0)};
    BasisValues room;
    for (std::size_t k = begin; k < end; ++k) {
      const SurfaceCell& cell = cells[k];
      const ChartIn<double>& chart = surface.charts[cell.chart].in<double>();
      // The rule's weights sum to 1/2.
      const double scale = 2 * cell.parameter_area();
      for (std::size_t i = 0; i < rule.points.size(); ++i) {
        const Frame<double> frame = chart.frame(cell.at(surface, rule.points[i].x[1], rule.points[i].x[2]));
        const double weight = scale * rule.weights[i] * area_element(frame);
        sums.area += weight;
        if (!basis.evaluate({frame.point, unit_normal(frame)}, room)) {
          sums.uncovered += weight;
          continue;
        }
        for (std::size_t j = 0; j < room.size(); ++j)
          sums.weights[room.sites()[j]] += weight * room.values()[j];
      }
    }
    return sums;
  };
  const auto add = [](CellSums total, CellSums next) {
    for (std::size_t j = 0; j < total.weights.size(); ++j) total.weights[j] += next.weights[j];
    total.area += next.area;
    total.uncovered += next.uncovered;
    return total;
  };
  return parallel_reduce_ordered(cells.size(), grain,
                                 CellSums{.weights = std::vector<double>(basis.size(), 0.0)}, part, add);
}

/// Every cell cut into four.
std::vector<SurfaceCell> quartered(const Surface& surface, std::span<const SurfaceCell> cells) {
  std::vector<SurfaceCell> quarters;
  quarters.reserve(4 * cells.size());
  for (const SurfaceCell& cell : cells) {
    const auto [first, second] = cell.halves(surface);
    for (const SurfaceCell& half : {first, second}) {
      const auto [third, fourth] = half.halves(surface);
      quarters.push_back(third);
      quarters.push_back(fourth);
    }
  }
  return quarters;
}

double mean_magnitude(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += std::abs(value);
  return sum / static_cast<double>(values.size());
}

}  // namespace

const WorkLimit most_integration_points(
    "meshless/weights: points of an integration", 20'000'000, 1,
    "errors as large as the last cells tell, infinite where none were compared");

Outcome<Ball> plane_integral(const MotherFunction& mother) {
  const Ball two_pi = Ball(2) * Ball::pi();
  switch (mother.kind) {
    case MotherKind::gaussian: {
      if (!mother.support) return two_pi;
      const Ball support(*mother.support);
      return two_pi * (Ball(1) - exp(-(support * support) / Ball(2)));
    }
    case MotherKind::spline: {
      const Rational s = mother.support && *mother.support < Rational(1) ? *mother.support : Rational(1);
      const Rational s2 = s * s;
      return two_pi * Ball(s2 * (Rational(1, 2) - Rational(3, 4) * s2 + Rational(2, 5) * s2 * s));
    }
    case MotherKind::shepard: return because("the integral of 1/r^2 over the plane diverges at 0");
    case MotherKind::own:
    case MotherKind::expression: break;
  }
  return because("the mother function " + mother.to_text() + " has no plane integral in closed form");
}

Outcome<std::vector<double>> plane_weights(const RadialBasis& basis) {
  if (!basis.choice().radius.neighbour)
    return because("plane weights are of elements with a radius of their own, not of absolute distances");
  const Outcome<Ball> constant = plane_integral(basis.choice().mother);
  if (!constant) return because(constant.reason());
  std::vector<double> weights(basis.radii().begin(), basis.radii().end());
  for (double& weight : weights) weight *= weight * constant->to_double();
  return weights;
}

Outcome<std::vector<double>> neighbour_weights(const RadialBasis& basis, std::size_t m) {
  Outcome<std::vector<double>> weights =
      neighbour_radii(basis.sites(), basis.choice().distance, m, basis.choice().radius.too_few);
  if (weights)
    for (double& weight : *weights) weight *= weight * std::numbers::pi / static_cast<double>(m);
  return weights;
}

std::vector<double> mean_density_weights(const RadialBasis& basis, double area) {
  expects(area > 0, "an area > 0", named("area", area));
  std::vector<double> weights(basis.size(), area / static_cast<double>(basis.size()));
  return weights;
}

BasisIntegrals integrate_basis(const RadialBasis& basis, const Surface& surface,
                               const IntegrationDemand& demand) {
  expects(demand.relative_error > 0 && demand.most_points > 0, "a positive demand",
          named("relative_error", demand.relative_error), named("most_points", demand.most_points));
  // Four points a cell, exact to degree 3.
  const TriangleRule<double> rule = conical_rule<double>(2, Grading::none);
  const std::size_t points_a_cell = rule.points.size();
  std::optional<std::vector<SurfaceCell>> cells =
      cells_below(surface, std::numeric_limits<double>::infinity(), demand.most_points);
  expects(cells.has_value() && !cells->empty(), "a surface with charts, and points enough for them",
          named("surface", surface.name));
  double area = 0;
  for (const SurfaceCell& cell : *cells)
    area += cell.parameter_area() *
            area_element(surface.charts[cell.chart].in<double>().frame(cell.at(surface, 1.0 / 3, 1.0 / 3)));
  // The mean distance of neighbours: elements change over no less.
  const double spacing = std::sqrt(area / static_cast<double>(basis.size()));
  if (std::optional<std::vector<SurfaceCell>> finer =
          cells_below(surface, spacing, demand.most_points / points_a_cell))
    cells = std::move(finer);

  BasisIntegrals result;
  CellSums coarse = sum_over(basis, surface, *cells, rule);
  result.points = points_a_cell * cells->size();
  result.errors.assign(basis.size(), std::numeric_limits<double>::infinity());
  while (!result.reached && result.points + 4 * points_a_cell * cells->size() <= demand.most_points) {
    *cells = quartered(surface, *cells);
    CellSums fine = sum_over(basis, surface, *cells, rule);
    result.points += points_a_cell * cells->size();
    const double allowed = demand.relative_error * mean_magnitude(fine.weights);
    // Each sum has at most as many terms as there are points.
    const double rounding = 0x1p-52 * static_cast<double>(points_a_cell * cells->size());
    // One difference may be small by chance: that of all elements is added.
    double squares = 0;
    for (std::size_t j = 0; j < basis.size(); ++j)
      squares += (fine.weights[j] - coarse.weights[j]) * (fine.weights[j] - coarse.weights[j]);
    const double typical = std::sqrt(squares / static_cast<double>(basis.size()));
    result.reached = true;
    for (std::size_t j = 0; j < basis.size(); ++j) {
      result.errors[j] =
          std::abs(fine.weights[j] - coarse.weights[j]) + typical + rounding * std::abs(fine.weights[j]);
      result.reached = result.reached && result.errors[j] <= allowed;
    }
    result.area_error = std::abs(fine.area - coarse.area) + rounding * fine.area;
    coarse = std::move(fine);
  }
  result.weights = std::move(coarse.weights);
  result.area = coarse.area;
  result.uncovered_area = coarse.uncovered;
  return result;
}

}  // namespace radcert
