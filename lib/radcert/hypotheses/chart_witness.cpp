// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/chart_witness.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "radcert/core/work_limit.h"
#include "radcert/hypotheses/chart_patch.h"

namespace radcert {
namespace {

const WorkLimit witness_bits("hypotheses/chart_witness: bits of a witness", 192, BallPrecision::smallest_bits,
                             "no witness: the pair of points refutes nothing");
const WorkLimit lattice_points("hypotheses/chart_witness: points of the lattices", 1500, 1,
                               "fewer pairs of points are looked at: what they miss stays undecided");
/// A product of a lattice below the rounding of its points in doubles would be confirmed by chance only.
constexpr double rounding = 1e-13;
/// Halvings of a step that is at most as long as the domain: beyond it doubles do not tell parameters apart
/// well.
const WorkLimit halvings("hypotheses/chart_witness: halvings of a step", 40, 0,
                         "no witness: the surface stays undecided");

struct LatticePoint {
  std::size_t chart;
  ParameterPoint<double> at;
  Vector<double> point;
  Vector<double> unit_normal;
};

bool is_finite(const Vector<double>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::vector<LatticePoint> lattice_of(const Surface& surface) {
  // 2, 4 or 8 intervals a side: (n + 1)^2 points a chart.
  int intervals = 8;
  const auto points = [&](int n) {
    return surface.chart_count() * static_cast<std::size_t>(n + 1) * static_cast<std::size_t>(n + 1);
  };
  while (intervals > 2 && points(intervals) > lattice_points.count()) intervals /= 2;
  std::vector<LatticePoint> lattice;
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    for (int i = 0; i <= intervals; ++i)
      for (int j = 0; j <= intervals; ++j) {
        const ParameterPoint<double> at{static_cast<double>(i) / intervals,
                                        static_cast<double>(j) / intervals};
        if (!is_in_domain(at, surface.charts[chart].facts().domain)) continue;
        const Frame<double> frame = surface.charts[chart].in<double>().frame(at);
        const Vector<double> normal = unit_normal(frame);
        if (is_finite(frame.point) && is_finite(normal))
          lattice.push_back({.chart = chart, .at = at, .point = frame.point, .unit_normal = normal});
      }
  return lattice;
}

double diagonal_of(const std::vector<LatticePoint>& lattice) {
  if (lattice.empty()) return 0;
  Vector<double> low = lattice.front().point;
  Vector<double> high = low;
  for (const LatticePoint& each : lattice) {
    low = {std::min(low.x, each.point.x), std::min(low.y, each.point.y), std::min(low.z, each.point.z)};
    high = {std::max(high.x, each.point.x), std::max(high.y, each.point.y), std::max(high.z, each.point.z)};
  }
  return norm(high - low);
}

ParameterPoint<double> centre_of(const Surface& surface, std::size_t chart) {
  const double third = surface.charts[chart].facts().domain == ChartDomain::unit_square ? 0.5 : 0.25;
  return {third, third};
}

/// The direction in which N . D^2 F is least, where that is negative.
std::optional<ParameterPoint<double>> hollow_direction(const Chart& chart, const LatticePoint& p) {
  const ChartIn<double>& formula = chart.in<double>();
  const auto half_second = [&](double s, double t) {
    return dot(formula.chord_along(p.at, {s, t}, 0.0).bend_p, p.unit_normal);
  };
  try {
    const double ss = half_second(1, 0);
    const double tt = half_second(0, 1);
    const double st = (half_second(1, 1) - half_second(1, -1)) / 4;
    const double least = (ss + tt) / 2 - std::hypot((ss - tt) / 2, st);
    if (!(least < 0)) return std::nullopt;
    // The eigenvector of the symmetric form, by the half angle.
    const double angle = std::atan2(2 * st, ss - tt) / 2;
    return ParameterPoint<double>{-std::sin(angle), std::cos(angle)};
  } catch (const ContractViolation&) {  // a chart without chords along rays
    return std::nullopt;
  }
}

std::optional<ChartWitness> dent_at(const Surface& surface, const LatticePoint& p) {
  const auto direction = hollow_direction(surface.charts[p.chart], p);
  if (!direction) return std::nullopt;
  double step = 0.5;
  for (int k = 0; k < halvings.value() / 2; ++k, step /= 2)
    for (const double along : {step, -step}) {
      const ParameterPoint<double> q = p.at + along * *direction;
      if (!is_in_domain(q, surface.charts[p.chart].facts().domain)) continue;
      if (auto found = witness_at(surface, p.chart, p.at, p.chart, q)) return found;
    }
  return std::nullopt;
}

std::optional<ChartWitness> crease_at(const Surface& surface, const LatticePoint& p, const LatticePoint& q) {
  double step = 0.5;
  for (int k = 0; k < halvings.value(); ++k, step /= 2) {
    const ParameterPoint<double> inner_p = p.at + step * (centre_of(surface, p.chart) - p.at);
    const ParameterPoint<double> inner_q = q.at + step * (centre_of(surface, q.chart) - q.at);
    if (auto found = witness_at(surface, p.chart, inner_p, q.chart, inner_q)) return found;
  }
  return witness_at(surface, p.chart, p.at, q.chart, q.at);
}

}  // namespace

std::optional<ChartWitness> witness_at(const Surface& surface, std::size_t chart_p,
                                       const ParameterPoint<double>& p, std::size_t chart_q,
                                       const ParameterPoint<double>& q) {
  if (!has_balls(surface.charts[chart_p]) || !has_balls(surface.charts[chart_q])) return std::nullopt;
  const BallPrecision precision(witness_bits.value());
  const Frame<Ball> at_p = surface.charts[chart_p].in<Ball>().frame({Ball(p.s), Ball(p.t)});
  const Frame<Ball> at_q = surface.charts[chart_q].in<Ball>().frame({Ball(q.s), Ball(q.t)});
  const Ball product = dot(at_q.point - at_p.point, at_p.area_normal);
  if (!certainly_negative(product)) return std::nullopt;
  return ChartWitness{.chart_p = chart_p,
                      .at_p = {Rational::exactly(p.s), Rational::exactly(p.t)},
                      .chart_q = chart_q,
                      .at_q = {Rational::exactly(q.s), Rational::exactly(q.t)},
                      .p = at_p.point,
                      .q = at_q.point,
                      .inner_normal = at_p.area_normal,
                      .product = product};
}

std::optional<ChartWitness> witness_on_lattices(const Surface& surface) {
  const std::vector<LatticePoint> lattice = lattice_of(surface);
  const double diagonal = diagonal_of(lattice);
  const LatticePoint* deepest_p = nullptr;
  const LatticePoint* deepest_q = nullptr;
  double least = 0;
  for (const LatticePoint& p : lattice)
    for (const LatticePoint& q : lattice) {
      const Vector<double> difference = q.point - p.point;
      const double product = dot(difference, p.unit_normal);
      if (product > -rounding * diagonal) continue;
      const double sine = product / norm(difference);
      if (sine >= least) continue;
      least = sine;
      deepest_p = &p;
      deepest_q = &q;
    }
  if (deepest_p == nullptr) return std::nullopt;
  return witness_at(surface, deepest_p->chart, deepest_p->at, deepest_q->chart, deepest_q->at);
}

std::optional<ChartWitness> witness_nearby(const Surface& surface) {
  const std::vector<LatticePoint> lattice = lattice_of(surface);
  const double diagonal = diagonal_of(lattice);
  for (const LatticePoint& p : lattice)
    if (auto found = dent_at(surface, p)) return found;
  for (const LatticePoint& p : lattice)
    for (const LatticePoint& q : lattice) {
      if (p.chart == q.chart || norm(q.point - p.point) > rounding * diagonal) continue;
      if (auto found = crease_at(surface, p, q)) return found;
    }
  return std::nullopt;
}

double relative_depth(const Surface& surface, const ChartWitness& witness) {
  const BallPrecision precision(witness_bits.value());
  const Ball depth = -witness.product / norm(witness.inner_normal);
  return depth.to_double() / diagonal_of(lattice_of(surface));
}

}  // namespace radcert
