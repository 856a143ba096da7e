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

namespace {

/// How far an iteration has come.
struct IterationState {
  std::vector<double> v;
  std::vector<double> best;
  double best_residual = infinity;
  double mark = infinity;  ///< the residual that was last halved
  std::size_t marked_at = 0;
  std::size_t iterations = 0;
  std::size_t planned = 0;
  std::size_t step = 0;

  static constexpr const char* name = "iteration";
  static constexpr std::size_t counts = 6;

  /// Together: where the one is kept, all are.
  void keep(KeptNumbers& kept, const VectorParts& parts, std::size_t next_step) const {
    std::vector<double> all = parts.at_first(v);
    const std::vector<double> all_best = parts.at_first(best);
    if (!parts.ranks().is_first()) return;
    all.insert(all.end(), all_best.begin(), all_best.end());
    for (const std::size_t count : {marked_at, iterations, planned, next_step})
      all.push_back(static_cast<double>(count));
    all.push_back(best_residual);
    all.push_back(mark);
    kept.keep(name, all);
  }

  /// Whether there was a state of so many entries, which this becomes then.
  bool find(KeptNumbers& kept, const VectorParts& parts) {
    std::optional<std::vector<double>> all;
    if (parts.ranks().is_first()) all = kept.find(name);
    const std::size_t n = parts.whole();
    const bool fits = all && all->size() == 2 * n + counts;
    const std::span<const double> given = fits ? std::span<const double>(*all) : std::span<const double>();
    const std::vector<double> numbers = parts.ranks().numbers_from_first(given.subspan(fits ? 2 * n : 0));
    const auto of_v = parts.from_first(given.first(fits ? n : 0));
    const auto of_best = parts.from_first(fits ? given.subspan(n, n) : given);
    if (numbers.size() != counts || !of_v || !of_best) return false;
    v = *of_v;
    best = *of_best;
    std::size_t at = 0;
    for (std::size_t* count : {&marked_at, &iterations, &planned, &step})
      *count = static_cast<std::size_t>(numbers[at++]);
    best_residual = numbers[at++];
    mark = numbers[at];
    return true;
  }
};

}  // namespace

Outcome<IterativeSolution, NotReached> iterate(const SystemProducts& k, const Contraction& contraction,
                                               std::span<const double> e, std::optional<double> tolerance,
                                               const Correction& correction, KeptNumbers* kept) {
  expects(e.size() == k.rows() && contraction.weights().size() == k.rows(),
          "a right-hand side and a contraction of the matrix's size", named("rows", k.rows()),
          named("size", e.size()));
  expects(!tolerance || (*tolerance >= least_tolerance && *tolerance < 1),
          "a tolerance in [least_tolerance, 1)", named("tolerance", tolerance.value_or(0)));
  const VectorParts parts = k.parts();
  const Descent descent{
      .parts = parts, .contraction = contraction, .tolerance = tolerance, .rounding = k.rounding()};
  IterationState at{.v = {e.begin(), e.end()}, .best = {e.begin(), e.end()}};
  if (parts.size_of(e) == 0) return IterativeSolution{.values = std::move(at.v)};
  if (kept != nullptr) at.find(*kept, parts);

  std::vector<double> r(at.v.size());
  std::vector<double> bounds(at.v.size());
  const std::size_t patient_steps = patience(contraction.theta(), correction.reflections);
  for (;; ++at.step) {
    k.accurate_residual(at.v, e, r);
    bound_residual(k, contraction, at.v, e, r, bounds);
    const double residual = contraction.norm(bounds);
    if (residual < at.best_residual) {
      at.best_residual = residual;
      at.best = at.v;
    }
    if (descent.reached(at.v, residual))
      return IterativeSolution{.values = std::move(at.v),
                               .iterations = at.iterations,
                               .error_bound = contraction.inverse_bound(residual)};
    // v grows from e to u, or shrinks, by 1 + theta <= 2 at most.
    if (at.step == 0)
      at.planned = planned_steps(contraction.theta(), residual, descent.goal(at.v) / 2) + patient_steps;
    if (at.step == 0 && correction.reflections == 1 && at.planned > most_reflections) break;
    if (residual <= at.mark / 2) {
      at.mark = residual;
      at.marked_at = at.step;
    }
    if (!std::isfinite(residual) || at.step == at.planned || at.step - at.marked_at >= patient_steps) break;
    at.iterations += correction.apply(r, descent.goal(at.v));
    for (std::size_t i = 0; i < at.v.size(); ++i) at.v[i] += r[i];
    if (kept != nullptr) at.keep(*kept, parts, at.step + 1);
  }
  const double error_bound = contraction.inverse_bound(at.best_residual);
  const double size = parts.size_of(at.best);
  if (descent.left_to_rounding(at.best, at.best_residual))
    return IterativeSolution{
        .values = std::move(at.best), .iterations = at.iterations, .error_bound = error_bound};
  return because(NotReached{.iterations = at.iterations, .error_bound = error_bound, .size = size});
}

}  // namespace radcert
