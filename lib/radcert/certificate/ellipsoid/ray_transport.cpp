// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/ellipsoid/ray_transport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "radcert/scalar/bounded_double.h"
#include "radcert/scalar/pack.h"

namespace radcert::certificate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = 0x1p-53;
constexpr double generous = 1 + 0x1p-8;
constexpr double largest_kappa = 1e4;

/// The inner normal at A p and two unit vectors across it and each other.
/// Maths     p is normalised within 5 u and A^-1 p, |A^-1 p| >= 1, off by 5 kappa u and 5 units of its size:
///           n within N = (5 kappa + 10) u. The axis of the least coordinate makes a vector product of at
///           least the length 0.81: first within 1.24 N + 5 u, second within 2.24 N + 9 u
struct RayFrame {
  Vector<double> p, normal, first, second;
};
RayFrame frame_at(const Vector<double>& at, const Vector<double>& inverse) {
  RayFrame out;
  out.p = (1 / norm(at)) * at;
  const Vector<double> turned{inverse.x * out.p.x, inverse.y * out.p.y, inverse.z * out.p.z};
  out.normal = (-1 / norm(turned)) * turned;
  const Vector<double>& n = out.normal;
  const double x = std::abs(n.x);
  const double y = std::abs(n.y);
  const double z = std::abs(n.z);
  Vector<double> across = x <= y && x <= z ? Vector<double>{0, n.z, -n.y}
                          : y <= z         ? Vector<double>{-n.z, 0, n.x}
                                           : Vector<double>{n.y, -n.x, 0};
  out.first = (1 / norm(across)) * across;
  out.second = cross(out.normal, out.first);
  return out;
}

/// Eight of a rule's points.
Vector<Pack> points_from(const std::vector<Vector<double>>& points, std::size_t first) {
  std::array<double, Pack::lanes> x{};
  std::array<double, Pack::lanes> y{};
  std::array<double, Pack::lanes> z{};
  for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
    x[lane] = points[first + lane].x;
    y[lane] = points[first + lane].y;
    z[lane] = points[first + lane].z;
  }
  return {Pack::load(x.data()), Pack::load(y.data()), Pack::load(z.data())};
}

/// How far a computed q is from the exact one.
/// Maths     e = sin(psi/2) (cos phi first + sin phi second) + cos(psi/2) n: ((1.24 N + 5 u)^2 + (2.24 N + 9
///           u)^2 + N^2)^(1/2) + 10 u <= 2.8 N + 21 u, coordinates of the rule and sums included. d = A^-1 e
///           is off by kappa times that and 3 u of its size, |d| >= 1; the reflection moves by 4 times the
///           angle of d, as much as p, 5 u, and rounds by 24 u: 3 u of p.d, 3 u of d.d and 1 of the quotient,
///           twice, 2 of the product, 1 of the difference, each for numbers of at most 2
double displacement(double kappa) {
  const double of_normal = 5 * kappa + 10;
  return unit * (4 * (kappa * (2.8 * of_normal + 21) + 3) + 29) * generous;
}

}  // namespace

RayTransport::RayTransport(const EllipsoidStretch& stretch, const SphereDensity& density, double tolerance)
    : stretch_(stretch), density_(density), constant_(density.constant()), radius_(infinity) {
  if (!(stretch.kappa() <= largest_kappa)) return;
  rule_ = polar_rule(
      {.meridian_strip = 2 * stretch.widest(),
       .meridian = [&](double s) { return density.rest(2 * stretch.turned(0.5 * s)); },
       .row_strip =
           [&](double sine) { return std::min(8.0, std::asinh(std::sinh(stretch.widest()) / sine)); },
       .row =
           [&](double s, double sine) {
             const double by = std::asinh(sine * std::sinh(s)) * (1 + 0x1p-40);
             return density.rest(2 * stretch.turned(by));
           }},
      tolerance, true);
  if (!exists()) return;
  // w, the difference from c, weights and the sum of as many packs.
  const double rest = density.rest(0);
  const double off = density.error(displacement(stretch.kappa()));
  const auto packs = static_cast<double>(rule_.points.size() / Pack::lanes);
  radius_ =
      (rule_.error + off + unit * (packs + 24) * (rest + off) + 2 * unit * (std::abs(constant_) + rest)) *
      generous;
}

Approximation RayTransport::operator()(const Vector<double>& p) const {
  if (!(radius_ < infinity)) return Approximation::proved(0, infinity);
  const RayFrame frame = frame_at(p, stretch_.inverse());
  const auto packs = [](const Vector<double>& v) { return Vector<Pack>{v.x, v.y, v.z}; };
  const Vector<Pack> first = packs(frame.first);
  const Vector<Pack> second = packs(frame.second);
  const Vector<Pack> normal = packs(frame.normal);
  const Vector<Pack> start = packs(frame.p);
  const Vector<Pack> inverse = packs(stretch_.inverse());
  const Pack constant(constant_);
  Pack sum(0.0);
  for (std::size_t k = 0; k < rule_.points.size(); k += Pack::lanes) {
    const Vector<Pack> local = points_from(rule_.points, k);
    const Vector<Pack> e = local.x * first + local.y * second + local.z * normal;
    const Vector<Pack> d{inverse.x * e.x, inverse.y * e.y, inverse.z * e.z};
    const Pack along = dot(start, d) / dot(d, d);
    const Vector<Pack> q = start - (along + along) * d;
    sum = fma(Pack::load(&rule_.weights[k]), density_(q) - constant, sum);
  }
  const double value = constant_ + sum.sum();
  return std::isfinite(value) ? Approximation::proved(value, radius_) : Approximation::proved(0, infinity);
}

double transported_around(const EllipsoidStretch& stretch, const SphereDensity& density, double s) {
  const double margin = stretch.margin(s);
  if (!(margin > 0)) return infinity;
  const double kappa = stretch.kappa() * stretch.kappa();
  return stretch.determinant() * kappa * kappa * density.rest(s) / (margin * margin * std::sqrt(margin)) *
         generous;
}

Approximation mean_over_surface(const EllipsoidStretch& stretch, const SphereDensity& density,
                                double tolerance) {
  if (!(stretch.kappa() <= largest_kappa)) return Approximation::proved(0, infinity);
  const double rest = density.rest(0);
  // One rule for |A^-1 p| (w - c) and, this many times, for |A^-1 p|, which is at least 1.
  const double of_area = std::max(rest, std::numeric_limits<double>::min());
  const auto bound = [&](double s) {
    if (!(stretch.margin(s) > 0)) return infinity;
    return (density.rest(s) + of_area) * stretch.kappa() * std::sqrt(std::cosh(2 * s)) * generous;
  };
  const PolarRule rule = polar_rule({.meridian_strip = stretch.widest(),
                                     .meridian = bound,
                                     .row_strip = [&](double) { return stretch.widest(); },
                                     .row = [&](double s, double) { return bound(s); }},
                                    std::min(tolerance, 0.01 * of_area), false);
  if (rule.nodes == 0) return Approximation::proved(0, infinity);
  const double off = density.error(8 * unit);
  const Vector<double>& inverse = stretch.inverse();
  const double constant = density.constant();
  BoundedDouble area;
  BoundedDouble sum;
  for (std::size_t k = 0; k < rule.nodes; k += Pack::lanes) {
    const Pack w = density(points_from(rule.points, k));
    for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
      const Vector<double>& p = rule.points[k + lane];
      const auto coordinate = [](double x, double by) {
        return BoundedDouble(x, 8 * unit) * BoundedDouble(by, 3 * unit * by);
      };
      const BoundedDouble x = coordinate(p.x, inverse.x);
      const BoundedDouble y = coordinate(p.y, inverse.y);
      const BoundedDouble z = coordinate(p.z, inverse.z);
      const double weight = rule.weights[k + lane];
      const BoundedDouble part = BoundedDouble(weight, 8 * unit * weight) * sqrt(x * x + y * y + z * z);
      area = area + part;
      sum = sum + part * (BoundedDouble(w.lane(lane), off) - BoundedDouble::exactly(constant));
    }
  }
  area = area + BoundedDouble(0, rule.error / of_area * generous);
  sum = sum + BoundedDouble(0, rule.error * generous);
  const BoundedDouble mean = BoundedDouble::exactly(constant) + sum / area;
  return std::isfinite(mean.value()) && mean.error() >= 0
             ? Approximation::proved(mean.value(), mean.error() * generous)
             : Approximation::proved(0, infinity);
}

}  // namespace radcert::certificate
