// SPDX-License-Identifier: GPL-3.0-or-later

// The sums for the integrals, and the matrix for the sums.
//
// Checked      (22), (23): with points in the middles of equal parts, so that R/n, pi/m and 2 pi/k are the
//              weights of a rule, the sums approach the solution of (21) like n^-2 for n = m = k = 40, 80,
//              160 (and 320 beyond quick), numbers for which no ring straddles the shadow's rim: by the
//              order of the root mean square over the points, and for (23) of the largest error. A
//              midpoint rule errs by c n^-2, and by some n^-5/2 at the horizon, which the kernel crosses
//              with the power 3/2: the largest error of (22) is one there or not, as the latitudes fall,
//              so that its order oscillates. With the ends among the points the order is 1, which is
//              rejected. The fixed point of lambda <- epsilon + R lambda that this is seen on solves (22)
//              and (23), their sums typed in anew with lengths and cosines by the law of cosines; rejected
//              where a latitude is moved and for half of F. (25): the matrix of (22)-(23) has R/n 2 pi/k
//              u_j in M and pi/m 2 pi/k r^2 cos zeta_i in N besides beta and the sums; without them the
//              iteration diverges, also for half of F, and where F is so small that it converges, a
//              quarter, it does so to other values; rejected with u_j in M alone. With these factors
//              lambda contracts and solves (22), (23).
// Not checked  another form factor F, which changes all figures: see papers/psg10/errata.md.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/claims/psg10/sum_errors.h"
#include "verification/framework/check.h"
#include "verification/framework/observed_order.h"

namespace radcert::verification::psg10 {
namespace {

SumReading reading_with(int n, Spacing spacing) {
  return {.rings = n, .parallels = n, .azimuths = n, .spacing = spacing};
}

/// The order of an error in 1/n, n = 40, 80, ...; sum_errors knows errors to 1e-13. Beside n^-2 there is
/// n^-5/2.
ObservedOrder order_of(double SumErrors::*which, Spacing spacing, int finest) {
  constexpr double known_to = 1e-13;
  LevelErrors errors;
  for (int n = 40; n <= finest; n *= 2) {
    errors.mesh_sizes.push_back(1.0 / n);
    errors.errors.push_back({.value = sum_errors(reading_with(n, spacing)).*which, .radius = known_to});
  }
  return observed_order(errors, {.next = 0.5});
}

/// The largest difference between the sides of (22) and (23) for r = 5, h = 20, R = 40, beta = mu = 9/10, n =
/// m = k. The radius is one rounding of a number of the order of 1 for each of the n^2 terms.
Approximation residual(const SumSolution& sums) {
  constexpr double pi = std::numbers::pi;
  constexpr double beta = 0.9;
  const std::size_t n = sums.distances.size();
  // a: squared distance of the points, b: (q - p).n_p; from u^2 + (h + r sin)^2 + (r cos)^2 - 2 u r cos
  // cos(tau).
  const auto factor_sum = [&](double zeta, double u) {
    double sum = 0;
    for (std::size_t s = 0; s < n; ++s) {
      const double tau = 2 * pi * (static_cast<double>(s) + 0.5) / static_cast<double>(n);
      const double level = 20 + 5 * std::sin(zeta);
      const double a = u * u + level * level + 25 * std::cos(zeta) * std::cos(zeta) -
                       10 * u * std::cos(zeta) * std::cos(tau);
      const double b = (u * u + 400 - 25 - a) / 10;
      sum += b > 0 ? b * level / (pi * a * a) : 0.0;
    }
    return 2 * pi / static_cast<double>(n) * sum;
  };
  double largest = 0;
  const double step = 1 / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0.81 * std::max(0.0, std::sin(sums.latitudes[i]));
    for (std::size_t j = 0; j < n; ++j)
      sum += beta * 40 * step * sums.disk[j] * sums.distances[j] *
             factor_sum(sums.latitudes[i], sums.distances[j]);
    largest = std::max(largest, std::abs(sum - sums.sphere[i]));
  }
  for (std::size_t j = 0; j < n; ++j) {
    double sum = sums.distances[j] >= 5 ? 0.81 : 0.0;
    for (std::size_t i = 0; i < n; ++i)
      sum += beta * pi * step * sums.sphere[i] * 25 * std::cos(sums.latitudes[i]) *
             factor_sum(sums.latitudes[i], sums.distances[j]);
    largest = std::max(largest, std::abs(sum - sums.disk[j]));
  }
  return {.value = largest, .radius = static_cast<double>(n * n) * std::numeric_limits<double>::epsilon()};
}

/// The factor by which the changes of lambda grow in an iteration, over two of them: R takes disk to sphere
/// and back. The radius is the difference from the iteration before.
Approximation growth(const SumReading& reading) {
  constexpr int iterations = 16;
  const SumSolution sums = sum_solution({}, reading, iterations, 0);
  const auto last = sums.changes.end();
  const double now = std::sqrt(last[-1] / last[-3]);
  const double before = std::sqrt(last[-2] / last[-4]);
  return {.value = now, .radius = std::abs(now - before)};
}

/// The largest difference between two fixed points. The radius is what more iterations may change where each
/// changes half as much as the one before, or less.
Approximation difference(const SumReading& first, const SumReading& second) {
  constexpr int iterations = 100;
  const SumSolution a = sum_solution({}, first, iterations, 1e-14);
  const SumSolution b = sum_solution({}, second, iterations, 1e-14);
  double largest = 0;
  for (std::size_t i = 0; i < a.sphere.size(); ++i)
    largest = std::max(largest, std::abs(a.sphere[i] - b.sphere[i]));
  for (std::size_t j = 0; j < a.disk.size(); ++j)
    largest = std::max(largest, std::abs(a.disk[j] - b.disk[j]));
  return {.value = largest, .radius = a.changes.back() + b.changes.back()};
}

}  // namespace

Finding equation_22(const Bench& bench) {
  const Order two = Order::is(2);
  const int finest = bench.budget == Budget::quick ? 160 : 320;
  const std::string of = ", n = 40 to ";
  Finding finding;
  const ObservedOrder sphere = order_of(&SumErrors::sphere_mean, Spacing::midpoints, finest);
  finding.require("order of the error of (22), root mean square" + of + std::to_string(finest), two, sphere);
  finding.require("order of the error of (23), root mean square" + of + std::to_string(finest), two,
                  order_of(&SumErrors::disk_mean, Spacing::midpoints, finest));
  finding.require("order of the error of (23), the largest" + of + std::to_string(finest), two,
                  order_of(&SumErrors::disk, Spacing::midpoints, finest));
  for (int n = 40; n <= finest; n *= 2)
    finding.remark("largest error of (22) times n^2, n = " + std::to_string(n),
                   {.value = sum_errors(reading_with(n, Spacing::midpoints)).sphere * n * n, .radius = 1e-8});
  finding.control("order of the error of (22), the ends among the points, root mean square" + of + "160", two,
                  order_of(&SumErrors::sphere_mean, Spacing::with_ends, 160));
  const Equals zero{
      .value = 0,
      .slack = 1e-12,
      .why = "sums of some thousand terms of the order of 1, and an iteration that stands still"};
  SumReading reading = reading_with(40, Spacing::midpoints);
  SumSolution sums = sum_solution({}, reading, 100, 1e-16);
  finding.require("left less right side of (22) and (23), largest, n = 40", zero, residual(sums));
  sums.sphere[0] += 1e-6;
  finding.control("the same with one latitude moved by 1e-6", zero, residual(sums));
  reading.form_factor = Rational(1, 2);
  finding.control("the same for the solution with half of F", zero,
                  residual(sum_solution({}, reading, 100, 1e-16)));
  return finding;
}

Finding equation_25(const Bench&) {
  const AtMost contracts{.value = 1, .slack = 0, .why = "an iteration that converges"};
  SumReading printed{.weights = SumWeights::as_in_the_text};
  Finding finding;
  finding.require("growth of the changes of lambda in an iteration with the sums (22)-(23)", contracts,
                  growth({}));
  finding.require("growth of the changes of lambda in an iteration with (25)", contracts, growth(printed));
  printed.form_factor = Rational(1, 2);
  finding.require("the same with half of F", contracts, growth(printed));
  finding.control("the same, (25) with u_j in M alone", contracts,
                  growth({.weights = SumWeights::with_the_radii}));
  // With a quarter of F, G of section II alone, (25) converges, to something else.
  const Equals zero{.value = 0, .slack = 0.01, .why = "a hundredth of the axis of figure 10"};
  printed.form_factor = Rational(1, 4);
  const SumReading meant{.form_factor = Rational(1, 4)};
  finding.require("lambda by (25) less lambda by (22)-(23), largest, a quarter of F", zero,
                  difference(printed, meant));
  finding.instead("left less right side of (22) and (23), largest, for lambda by their matrix, n = 100", zero,
                  residual(sum_solution({}, {}, 100, 1e-14)));
  finding.control("lambda by (22)-(23), half of F, less that, largest", zero,
                  difference({.form_factor = Rational(1, 2)}, meant));
  return finding;
}

}  // namespace radcert::verification::psg10
