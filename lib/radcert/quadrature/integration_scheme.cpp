// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/integration_scheme.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/polynomial/largest_values.h"
#include "radcert/quadrature/even_shape.h"
#include "radcert/quadrature/flat_rule_bound.h"

namespace radcert {
namespace {

/// Largest and mean values of |l_j| as a lattice shows them: they choose what a rule may leave out, and enter
/// no radius.
template <Real R>
struct Sizes {
  std::vector<R> largest;
  std::vector<R> mean;

  /// Over the points k/48, |k| = 48: the vertices are among them.
  explicit Sizes(const TriangleBasis<R>& basis) : largest(basis.size(), R(0)), mean(basis.size(), R(0)) {
    using std::abs;
    constexpr int steps = 48;
    const int points = (steps + 1) * (steps + 2) / 2;
    std::vector<R> values(basis.size());
    for (int i = 0; i <= steps; ++i)
      for (int k = 0; i + k <= steps; ++k) {
        const Barycentric<R> x{{R(i) / R(steps), R(k) / R(steps), R(steps - i - k) / R(steps)}};
        basis.values(x, values);
        for (std::size_t j = 0; j < values.size(); ++j) {
          largest[j] = std::max(largest[j], static_cast<R>(abs(values[j])));
          mean[j] += abs(values[j]) / R(points);
        }
      }
  }

  double least_ratio() const {
    double least = 1;
    for (std::size_t j = 0; j < mean.size(); ++j)
      least = std::min(least, nearest_double(R(mean[j] / largest[j])));
    return least;
  }
};

/// The largest |D_s F| |D_t F| / |D_s F x D_t F| at corners and in the middles of the domain and of its
/// sides, off a singular line; at one place if F is affine. At least 1; infinite where the chart degenerates.
/// Each component of D_s F x D_t F is off by 4 u |D_s F| |D_t F| at most where the tangents are off by u.
template <Real R>
R largest_normal_loss(const Chart& chart) {
  const int first = chart.facts().singular == SingularLine::none ? 0 : 1;
  const int last = chart.facts().plane ? 0 : 2;
  R largest = R(1);
  for (int i = first; i <= std::max(first, last); ++i)
    for (int k = 0; k <= last; ++k) {
      const R t = R(k) / R(2);
      const R s = chart.facts().domain == ChartDomain::unit_triangle ? R(i) / R(2) * (R(1) - t) : R(i) / R(2);
      if (first == 1 && s == R(0)) continue;
      const Frame<R> frame = chart.in<R>().frame({s, t});
      const R loss = norm(frame.tangent_s) * norm(frame.tangent_t) / area_element(frame);
      if (!(loss <= largest)) largest = loss;
      if (!(largest >= R(1))) return largest;  // no number
    }
  return largest;
}

/// The finer of two rules has this much more order; more where they converge slowly. Odd: two sets of samples
/// are told apart by the parity of their orders.
constexpr int check_step_analytic = 1;
constexpr int check_step_slow = 3;

/// The least eta from which the bound is within `truncation`, to 1 %.
double least_distance_by_bound(int order, int degree, double truncation) {
  double too_near = 1;
  double enough = 1e9;
  if (flat_rule_bound(order, degree, enough) > truncation) return HUGE_VAL;
  while (enough > 1.01 * too_near) {
    const double middle = std::sqrt(too_near * enough);
    (flat_rule_bound(order, degree, middle) <= truncation ? enough : too_near) = middle;
  }
  return enough;
}

/// The eta of the ellipse for which points_for asks for this order.
double least_distance_by_model(int order, int degree, double truncation) {
  const int analytic = order - (degree + 1) / 2;
  if (analytic < 1) return HUGE_VAL;
  const double rho = std::pow(truncation, -0.5 / analytic);
  return (rho + 1 / rho) / 2;
}

/// The first order whose least distance is reached.
int first_within(const std::vector<double>& least_distance, double eta) {
  const auto found = std::find_if(least_distance.begin(), least_distance.end(),
                                  [eta](double least) { return least <= eta; });
  return static_cast<int>(found - least_distance.begin());
}

}  // namespace

template <Real R>
IntegrationScheme<R>::IntegrationScheme(const Surface& surface, const TriangleBasis<R>& basis,
                                        const Tolerance& tolerance)
    : surface_(surface), basis_(basis), tolerance_(tolerance) {
  expects(tolerance.entry() >= Tolerance::finest_of<R>(), "a tolerance that the arithmetic can hold",
          named("tolerance", tolerance.entry()));
  const Sizes<R> sizes(basis);
  largest_values_ = largest_values(basis);
  flat_truncation_ = tolerance.converged() * sizes.least_ratio();
  for (const Chart& chart : surface.charts) normal_loss_.push_back(largest_normal_loss<R>(chart));
  std::vector<std::size_t> first_of_plane;
  for (std::size_t a = 0; a < surface.charts.size(); ++a) {
    if (!surface.charts[a].facts().plane) {
      plane_.push_back(no_plane);
      continue;
    }
    const auto same = std::find_if(first_of_plane.begin(), first_of_plane.end(), [&](std::size_t b) {
      return in_one_plane(surface.charts[a], surface.charts[b]);
    });
    plane_.push_back(same == first_of_plane.end() ? a : *same);
    if (plane_.back() == a) first_of_plane.push_back(a);
  }
  for (int order = 0; order <= ConicalRules<R>::largest_order; ++order) {
    const bool exists = order >= ConicalRules<R>::smallest_order;
    least_distance_by_bound_.push_back(
        exists ? least_distance_by_bound(order, basis.degree(), flat_truncation_) : HUGE_VAL);
    least_distance_by_model_.push_back(
        exists ? least_distance_by_model(order, basis.degree(), tolerance.intended_truncation()) : HUGE_VAL);
  }
}

template <Real R>
int IntegrationScheme<R>::check_step(const ChartFacts& chart, double unevenness) {
  const bool is_slow = chart.singular != SingularLine::none || unevenness >= uneven_for_close_rules;
  return is_slow ? check_step_slow : check_step_analytic;
}

template <Real R>
int IntegrationScheme<R>::order_by_model(double eta) const {
  return std::min(first_within(least_distance_by_model_, eta),
                  ConicalRules<R>::largest_order - check_step_slow);
}

template <Real R>
FarRule IntegrationScheme<R>::far_rule(const ChartFacts& chart, double eta, double unevenness) const {
  const int coarse = order_by_model(eta);
  const int fine = coarse + check_step(chart, unevenness);
  if (!chart.plane) return {fine, coarse};
  const int bounded = first_within(least_distance_by_bound_, eta);
  if (bounded <= ConicalRules<R>::largest_order && bounded * bounded <= coarse * coarse + fine * fine)
    return {bounded, std::nullopt};
  return {fine, coarse};
}

template class IntegrationScheme<double>;
template class IntegrationScheme<Mpfr<50>>;

}  // namespace radcert
