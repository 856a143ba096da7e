// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/iteration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
constexpr double infinity = std::numeric_limits<double>::infinity();

void bound_residual(const SystemProducts& k, const Contraction& contraction, std::span<const double> v,
                    std::span<const double> e, std::span<const double> residual, std::span<double> bounds) {
  const VectorParts parts = k.parts();
  const double product_rounding = k.rounding() * parts.size_of(v);
  const auto n = static_cast<double>(parts.whole());
  const double second_order = (n + 4) * unit * ((n + 4) * unit);
  const double underflow = 8 * n * std::numeric_limits<double>::denorm_min();
  const double product_size = contraction.theta() * contraction.norm(v);
  const std::span<const double> w = contraction.weights();
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double terms = std::abs(e[i]) + std::abs(v[i]) + product_size * w[i];
    bounds[i] = (1 + 8 * unit) * std::abs(residual[i]) +
                ((1 + 16 * unit) * second_order * terms + underflow) + product_rounding;
  }
}

/// The number of steps that bring a residual from one size to another, each shrinking it by theta, and some
/// for rounding.
std::size_t planned_steps(double theta, double from, double to) {
  constexpr double spare = 16;
  constexpr double most = 1e12;
  if (!(from > to) || !(theta > 0)) return static_cast<std::size_t>(spare);
  const double steps = to > 0 ? std::ceil(std::log(to / from) / std::log(theta)) : most;
  return static_cast<std::size_t>(std::min(most, steps + spare));
}

/// The number of corrections over which a residual that has not halved says that no more is to be had.
std::size_t patience(double theta, std::size_t reflections) {
  constexpr double most = 1e12;
  const double steps = std::min(most, std::ceil(std::log(0.5) / std::log((1 + theta) / 2)));
  return std::max<std::size_t>(2, static_cast<std::size_t>(steps) / reflections + 1);
}

/// More reflections one by one are not begun.
constexpr std::size_t most_reflections = 1000000;

/// The goals of an iteration and how far it is from them.
struct Descent {
  const VectorParts& parts;
  const Contraction& contraction;
  std::optional<double> tolerance;
  double rounding;  ///< of a product, in parts of max|v|

  /// What the rounding of products alone leaves of a residual, as ||r||_w.
  double product_rounding(std::span<const double> v) const {
    return rounding == 0 ? 0 : rounding * parts.size_of(v) / contraction.least_weight();
  }

  /// The size of the residual at which v is good enough.
  double goal(std::span<const double> v) const {
    if (tolerance) return *tolerance * (1 - 32 * unit) * (1 - contraction.theta()) * parts.size_of(v);
    return 2 * unit * contraction.norm(v) + 2 * product_rounding(v);
  }
  bool reached(std::span<const double> v, double residual) const {
    if (!std::isfinite(residual)) return false;
    if (!tolerance) return residual <= goal(v);
    return contraction.inverse_bound(residual) <= *tolerance * (1 - 4 * unit) * parts.size_of(v);
  }
  /// Whether no more than rounding is left, where no tolerance asks for more.
  bool left_to_rounding(std::span<const double> v, double residual) const {
    const double theta = contraction.theta();
    return !tolerance && std::isfinite(residual) &&
           residual <= 4 * unit * (1 + theta) / (1 - theta) * contraction.norm(v) + 4 * product_rounding(v);
  }
};

}  // namespace

std::vector<double> residual_bounds(const SystemProducts& k, const Contraction& contraction,
                                    std::span<const double> v, std::span<const double> e,
                                    std::span<const double> residual) {
  std::vector<double> bounds(v.size());
  bound_residual(k, contraction, v, e, residual, bounds);
  return bounds;
}

Outcome<IterativeSolution, NotReached> iterate(const SystemProducts& k, const Contraction& contraction,
                                               std::span<const double> e, std::optional<double> tolerance,
                                               const Correction& correction) {
  expects(e.size() == k.rows() && contraction.weights().size() == k.rows(),
          "a right-hand side and a contraction of the matrix's size", named("rows", k.rows()),
          named("size", e.size()));
  expects(!tolerance || (*tolerance >= least_tolerance && *tolerance < 1),
          "a tolerance in [least_tolerance, 1)", named("tolerance", tolerance.value_or(0)));
  const VectorParts parts = k.parts();
  const Descent descent{.parts = parts, .contraction = contraction, .tolerance = tolerance, .rounding = k.rounding()};
  std::vector<double> v(e.begin(), e.end());
  if (parts.size_of(e) == 0) return IterativeSolution{.values = std::move(v)};

  std::vector<double> r(v.size());
  std::vector<double> bounds(v.size());
  std::vector<double> best = v;
  double best_residual = infinity;
  const std::size_t patient_steps = patience(contraction.theta(), correction.reflections);
  double mark = infinity;
  std::size_t marked_at = 0;
  std::size_t iterations = 0;
  std::size_t planned = 0;
  for (std::size_t step = 0;; ++step) {
    k.accurate_residual(v, e, r);
    bound_residual(k, contraction, v, e, r, bounds);
    const double residual = contraction.norm(bounds);
    if (residual < best_residual) {
      best_residual = residual;
      best = v;
    }
    if (descent.reached(v, residual))
      return IterativeSolution{.values = std::move(v),
                               .iterations = iterations,
                               .error_bound = contraction.inverse_bound(residual)};
    // v grows from e to u, or shrinks, by 1 + theta <= 2 at most.
    if (step == 0)
      planned = planned_steps(contraction.theta(), residual, descent.goal(v) / 2) + patient_steps;
    if (step == 0 && correction.reflections == 1 && planned > most_reflections) break;
    if (residual <= mark / 2) {
      mark = residual;
      marked_at = step;
    }
    if (!std::isfinite(residual) || step == planned || step - marked_at >= patient_steps) break;
    iterations += correction.apply(r, descent.goal(v));
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += r[i];
  }
  const double error_bound = contraction.inverse_bound(best_residual);
  const double size = parts.size_of(best);
  if (descent.left_to_rounding(best, best_residual))
    return IterativeSolution{.values = std::move(best), .iterations = iterations, .error_bound = error_bound};
  return because(NotReached{.iterations = iterations, .error_bound = error_bound, .size = size});
}

}  // namespace radcert
