// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/ellipsoid/ellipsoid_transport.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "radcert/continuous/upward.h"
#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/scalar/ball.h"

namespace radcert {

const WorkLimit most_sphere_nodes("continuous/ellipsoid_transport: nodes of a rule", 262144, 16,
                                  "no rule: nothing is said about the solution, with the reason");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = unit_roundoff<double>();
constexpr double displaced = sphere_displacement / unit;
/// Strips that are tried: parts of the widest.
constexpr int strips = 48;

constexpr std::size_t group = 2 * Pack::lanes;

/// 4 + 4/(4n^2-1) times exp(-2 n tau) / (1 - exp(-2 tau)).
double gauss_factor(double n, double tau) {
  return (4 + 4 / (4 * n * n - 1)) * std::max(std::exp(-2 * n * tau), 1e-300) / -std::expm1(-2 * tau) *
         upward;
}

/// How many nodes a rule has, and what it misses at most.
struct RowChoice {
  std::size_t nodes = 0;
  double error = 0;
};

/// About the least n >= 2 that misses at most `allowed`; 0 where that is more than `most`. The error is the
/// bound times error(n, tau), which falls off as exp(-rate n tau).
template <class Bound, class Error>
RowChoice least_nodes(double strip, const Bound& bound, const Error& error, double rate, double allowed,
                      double most) {
  double best = infinity;
  double best_tau = 0;
  for (int k = 1; k < strips; ++k) {
    const double tau = strip * k / strips;
    const double size = bound(tau);
    if (!(size >= 0)) continue;
    const double needed = size > 0 ? std::log1p(size / allowed) / (rate * tau) : 0;
    if (needed < best) {
      best = needed;
      best_tau = tau;
    }
  }
  if (!(best <= most)) return {};
  const double size = bound(best_tau);
  for (double n = std::max(2.0, std::floor(best)); n <= most; n += 1) {
    const double missed = size > 0 ? error(n, best_tau) * size * upward : 0;
    if (missed <= allowed) return {static_cast<std::size_t>(n), missed};
  }
  return {};
}

/// cos and sin of 2 pi j / n, rounded.
struct Circle {
  std::vector<double> cosines, sines;
};
Circle circle(std::size_t n) {
  Circle out;
  for (std::size_t j = 0; j < n; ++j) {
    const Ball angle = Ball(Rational(static_cast<long>(2 * j), static_cast<long>(n))) * Ball::pi();
    out.cosines.push_back(cos(angle).to_double());
    out.sines.push_back(sin(angle).to_double());
  }
  return out;
}

/// p/|p| and two unit vectors across it and each other, within 5 u, 18 u and 26 u of the exact ones.
/// Maths     a normalised vector is within 5 u of that of what was rounded. The axis of the least coordinate
///           makes a vector product of at least the length 0.81: 2 * 5 u / 0.81 + 5 u < 18 u; its product
///           with p: 5 u + 18 u + 3 u
struct Frame {
  Vector<double> pole, first, second;
};
Frame frame_at(const Vector<double>& p) {
  Frame out;
  out.pole = (1 / norm(p)) * p;
  const double x = std::abs(p.x);
  const double y = std::abs(p.y);
  const double z = std::abs(p.z);
  const Vector<double> axis = x <= y && x <= z ? Vector<double>{1, 0, 0}
                              : y <= z         ? Vector<double>{0, 1, 0}
                                               : Vector<double>{0, 0, 1};
  out.first = cross(axis, out.pole);
  out.first = (1 / norm(out.first)) * out.first;
  out.second = cross(out.pole, out.first);
  return out;
}

Vector<Pack> packs_of(const Vector<double>& v) { return {v.x, v.y, v.z}; }

/// Nodes first, ..., first + 7 of a rule about a pole: q, and (p - q)/|p - q|.
/// Maths     37 u in s: (18^2 + 26^2)^(1/2) u, 2 u of the table, 3 u of sums; as much more in q and d: 42 u
struct NodePacks {
  Vector<Pack> point, direction;
};
NodePacks nodes_about(const Frame& frame, const SphereRule& rule, std::size_t first) {
  const Pack cosine = Pack::load(&rule.cos_phi[first]);
  const Pack sine = Pack::load(&rule.sin_phi[first]);
  const Vector<Pack> s = cosine * packs_of(frame.first) + sine * packs_of(frame.second);
  const Vector<Pack> pole = packs_of(frame.pole);
  return {Pack::load(&rule.cos_psi[first]) * pole + Pack::load(&rule.sin_psi[first]) * s,
          Pack::load(&rule.sin_half[first]) * pole - Pack::load(&rule.cos_half[first]) * s};
}

Pack squared_norm(const Vector<Pack>& scales, const Vector<Pack>& v) {
  const Vector<Pack> scaled{scales.x * v.x, scales.y * v.y, scales.z * v.z};
  return dot(scaled, scaled);
}

/// asinh(sin(psi) sinh(tau)): how far a rotation about the pole takes a point off the sphere.
double off_the_sphere(double sine, double tau) { return std::asinh(sine * std::sinh(tau)) * upward; }

}  // namespace

EllipsoidShape::EllipsoidShape(const Vector<Rational>& half_axes) {
  expects(half_axes.x.sign() > 0 && half_axes.y.sign() > 0 && half_axes.z.sign() > 0, "half axes > 0");
  const Rational largest = std::max({half_axes.x, half_axes.y, half_axes.z});
  const Rational a = std::min({half_axes.x, half_axes.y, half_axes.z}) / largest;
  axes_ = {(half_axes.x / largest).to_double(), (half_axes.y / largest).to_double(),
           (half_axes.z / largest).to_double()};
  smallest_ = a.to_double() / upward;
  least_ = (a * a).to_double() / upward;
  spread_ = (Rational(1) - a * a).to_double() * upward;
  determinant_ = axes_.x * axes_.y * axes_.z;
}

double EllipsoidShape::margin(double tau, double across) const {
  const double s = std::sinh(tau);
  return std::max(0.0, (least_ - spread_ * s * s * across * upward) / upward - 8 * unit * least_);
}

double EllipsoidShape::widest(double across) const {
  constexpr double most = 6;
  const double part = spread_ * across;
  if (!(part > 0)) return most;
  return std::min(most, std::asinh(std::sqrt(least_ / part)));
}

std::array<Pack, 2> EllipsoidDensity::operator()(const SpherePoints& at) const {
  const std::array<Pack, 2> e = emission(at);
  const std::array<Pack, 2> rho = reflectivity(at);
  const std::array<Pack, 2> q = reflected(at);
  return {fma(rho[0], q[0], e[0]), fma(rho[1], q[1], e[1])};
}

double EllipsoidDensity::rounding() const {
  const double product = reflectivity.largest() * reflected.largest();
  return (emission.rounding() + reflectivity.largest() * reflected.rounding() +
          reflectivity.rounding() * (reflected.largest() + reflected.rounding()) +
          2 * unit * (emission.largest() + product)) *
         upward;
}

double EllipsoidDensity::constant() const {
  return emission.constant() + reflectivity.constant() * reflected.constant();
}

double EllipsoidDensity::variation(double tau) const {
  const double rho = std::abs(reflectivity.constant());
  const double q = std::abs(reflected.constant());
  const double rho_varies = reflectivity.variation(tau);
  const double q_varies = reflected.variation(tau);
  const double rounding = 3 * unit * (std::abs(emission.constant()) + rho * q);
  return (emission.variation(tau) + rho * q_varies + q * rho_varies + rho_varies * q_varies + rounding) *
         upward;
}

double EllipsoidDensity::largest() const { return (std::abs(constant()) + variation(0)) * upward; }

double EllipsoidDensity::cost() const {
  const auto terms = [](const SpherePolynomial& f) { return (f.degree() + 1.0) * (f.degree() + 1.0); };
  return 32 + terms(emission) + terms(reflectivity) + terms(reflected);
}

SphereRule sphere_rule(const SphereBounds& bounds, double tolerance) {
  const auto most = static_cast<double>(most_sphere_nodes.value());
  // The mean is the integral over 4 pi.
  const RowChoice in_psi = least_nodes(
      bounds.meridian_strip, bounds.meridian, [](double n, double tau) { return 0.5 * gauss_factor(n, tau); },
      2, 0.5 * tolerance, most / 2);
  SphereRule out;
  if (in_psi.nodes == 0) return out;
  const IntervalRule<Ball> gauss = legendre_rule(static_cast<int>(in_psi.nodes));
  out.error = in_psi.error;
  double left = most;
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < in_psi.nodes; ++i) {
    const Ball& x = gauss.nodes[i];
    const double weight = gauss.weights[i].to_double();
    const double sine = sqrt(Ball(1) - x * x).to_double();
    const double sin_half = sqrt((Ball(1) - x) * Ball(Rational(1, 2))).to_double();
    const double cos_half = sqrt((Ball(1) + x) * Ball(Rational(1, 2))).to_double();
    const double half = cos_half * cos_half * upward;
    const double sine_above = sine * upward;
    const RowChoice row = least_nodes(
        bounds.row_strip(sine_above, half), [&](double tau) { return bounds.row(tau, sine_above, half); },
        [](double n, double tau) { return upward / std::expm1(n * tau); }, 1, 0.25 * tolerance, left);
    if (row.nodes == 0) return {};
    left -= static_cast<double>(row.nodes);
    out.error += weight * row.error * upward;
    if (circles.size() <= row.nodes) circles.resize(row.nodes + 1);
    Circle& angles = circles[row.nodes];
    if (angles.cosines.empty()) angles = circle(row.nodes);
    const double cosine = x.to_double();
    for (std::size_t j = 0; j < row.nodes; ++j) {
      out.cos_psi.push_back(cosine);
      out.sin_psi.push_back(sine);
      out.cos_half.push_back(cos_half);
      out.sin_half.push_back(sin_half);
      out.cos_phi.push_back(angles.cosines[j]);
      out.sin_phi.push_back(angles.sines[j]);
      out.weights.push_back(weight / (2 * static_cast<double>(row.nodes)));
    }
  }
  out.error *= upward;
  out.nodes = out.weights.size();
  while (out.weights.size() % group != 0) {
    for (std::vector<double>* const values :
         {&out.cos_psi, &out.sin_psi, &out.cos_half, &out.sin_half, &out.cos_phi, &out.sin_phi}) {
      const double last = values->back();
      values->push_back(last);
    }
    out.weights.push_back(0);
  }
  return out;
}

EllipsoidTransport::EllipsoidTransport(const EllipsoidShape& shape, const EllipsoidDensity& density,
                                       double tolerance)
    : shape_(shape),
      density_(density),
      constant_(density.constant()),
      variation_((density.variation(0) + density.rounding()) * upward),
      rounding_(density.rounding()) {
  const auto kernel = [&](double margin) { return margin > 0 ? 1 / (margin * margin) : infinity; };
  const SphereBounds bounds{
      .meridian_strip = 2 * shape.widest(),
      .meridian = [&](double tau) { return density.variation(tau) * kernel(shape.margin(0.5 * tau)); },
      .row_strip = [&](double, double half) { return shape.widest(half); },
      .row =
          [&](double tau, double sine, double half) {
            return density.variation(off_the_sphere(sine, tau)) * kernel(shape.margin(tau, half));
          }};
  rule_ = sphere_rule(bounds, tolerance / shape.determinant());
}

Approximation EllipsoidTransport::operator()(const Vector<double>& p) const {
  if (!rule_.exists()) return Approximation::proved(0, infinity);
  const Frame frame = frame_at(p);
  const Vector<Pack> axes = packs_of(shape_.axes());
  const Pack constant(constant_);
  std::array<Pack, 2> masses{Pack(0.0), Pack(0.0)};
  std::array<Pack, 2> sums{Pack(0.0), Pack(0.0)};
  for (std::size_t first = 0; first < rule_.weights.size(); first += group) {
    const NodePacks low = nodes_about(frame, rule_, first);
    const NodePacks high = nodes_about(frame, rule_, first + Pack::lanes);
    const std::array<Pack, 2> w = density_({low.point, high.point});
    const std::array<Pack, 2> squared{squared_norm(axes, low.direction), squared_norm(axes, high.direction)};
    for (std::size_t i = 0; i < 2; ++i) {
      const Pack mass = Pack::load(&rule_.weights[first + i * Pack::lanes]) / (squared[i] * squared[i]);
      masses[i] += mass;
      sums[i] = fma(mass, w[i] - constant, sums[i]);
    }
  }
  const Vector<double>& a = shape_.axes();
  const double scale =
      shape_.determinant() / norm(Vector<double>{frame.pole.x / a.x, frame.pole.y / a.y, frame.pole.z / a.z});
  const double mass = scale * (masses[0] + masses[1]).sum();
  const double part = scale * (sums[0] + sums[1]).sum();
  const double value = constant_ + part;
  // |A d| is off by the displacement and is at least a: 2 * 2 * displaced / a, and 20 for axes, squares and
  // sums, in the kernel; weights and products 8; each sum one unit a group.
  const double smallest = shape_.smallest();
  const double relative =
      unit * (4.1 * displaced / smallest + 28 + static_cast<double>(rule_.weights.size() / group + 8));
  // |A^-1 p| >= 1 is off by 5 u / a and 6 u, the determinant by 5 u.
  const double of_scale = unit * (5.1 / smallest + 20);
  const double radius = 1.001 * mass * (rounding_ + variation_ * (relative + 2 * unit)) +
                        of_scale * std::abs(part) + unit * (std::abs(value) + std::abs(part)) +
                        1.001 * shape_.determinant() * rule_.error;
  if (!(relative < 1e-4) || !std::isfinite(value) || !(radius >= 0))
    return Approximation::proved(0, infinity);
  return Approximation::proved(value, radius * upward);
}

double bound_around(const EllipsoidShape& shape, const EllipsoidDensity& density, double tau) {
  const double margin = shape.margin(tau);
  if (!(margin > 0)) return infinity;
  return 1.001 * shape.determinant() * shape.smallest() * density.variation(tau) /
         (margin * margin * std::sqrt(margin));
}

double harmonic_tail(const EllipsoidShape& shape, const EllipsoidDensity& density, int degree) {
  const double l = degree;
  const double step = std::sqrt((2 * l + 5) / (2 * l + 3)) * upward;
  double best = infinity;
  for (int k = 1; k < strips; ++k) {
    const double tau = shape.widest() * k / strips;
    const double ratio = step * std::exp(-tau) * upward;
    const double bound = bound_around(shape, density, tau);
    if (!(ratio < 1) || !(bound < infinity)) continue;
    const double first =
        std::sqrt(2 * l + 3) * 2 * bound * std::max(std::exp(-l * tau), 1e-300) / std::expm1(tau);
    best = std::min(best, first / (1 - ratio) * 1.001);
  }
  return best;
}

Approximation surface_mean(const EllipsoidShape& shape, const EllipsoidDensity& density, double tolerance) {
  // The rule is for w - c and for 1, this so many times: a hundredth of the area is missed at most, and of
  // the mean no more than the tolerance.
  const double of_area_too = std::max(100 * tolerance, density.variation(0));
  const auto bound_with = [&](double tau) {
    return shape.margin(tau) > 0 ? (of_area_too + density.variation(tau)) * std::sqrt(std::cosh(2 * tau)) /
                                       shape.smallest() * upward
                                 : infinity;
  };
  const SphereRule rule = sphere_rule({.meridian_strip = shape.widest(),
                                       .meridian = bound_with,
                                       .row_strip = [&](double, double) { return shape.widest(); },
                                       .row = [&](double tau, double, double) { return bound_with(tau); }},
                                      tolerance);
  if (!rule.exists()) return Approximation::proved(0, infinity);
  const Frame frame{.pole = {0, 0, 1}, .first = {1, 0, 0}, .second = {0, 1, 0}};
  const Vector<double>& a = shape.axes();
  const Vector<Pack> inverse = packs_of({1 / a.x, 1 / a.y, 1 / a.z});
  const Pack constant(density.constant());
  Pack areas(0.0);
  Pack sums(0.0);
  for (std::size_t first = 0; first < rule.weights.size(); first += group) {
    const NodePacks low = nodes_about(frame, rule, first);
    const NodePacks high = nodes_about(frame, rule, first + Pack::lanes);
    const std::array<Pack, 2> w = density({low.point, high.point});
    const std::array<Pack, 2> stretch{sqrt(squared_norm(inverse, low.point)),
                                      sqrt(squared_norm(inverse, high.point))};
    for (std::size_t i = 0; i < 2; ++i) {
      const Pack area = Pack::load(&rule.weights[first + i * Pack::lanes]) * stretch[i];
      areas += area;
      sums = fma(area, w[i] - constant, sums);
    }
  }
  const double area = areas.sum();
  const double part = sums.sum() / area;
  // |A^-1 p| >= 1 is off by the displacement over a, and 12 units; weights 4; two units a group.
  const double relative =
      unit * (1.1 * displaced / shape.smallest() + 24 + static_cast<double>(2 * rule.weights.size() / group));
  const double of_area = 1.001 * (area * relative + rule.error / of_area_too);
  const double variation = density.variation(0) + density.rounding();
  const double of_sum =
      1.001 * (area * (density.rounding() + variation * (relative + 2 * unit)) + rule.error);
  const double value = density.constant() + part;
  const double radius =
      (of_sum + std::abs(part) * of_area) / (area - of_area) + 2 * unit * (std::abs(value) + std::abs(part));
  if (!(of_area < 0.5 * area) || !std::isfinite(value) || !(radius >= 0))
    return Approximation::proved(0, infinity);
  return Approximation::proved(value, radius * upward);
}

std::vector<Vector<double>> sphere_cover(double distance) {
  expects(distance >= 1e-4 && distance <= 1, "1e-4 <= distance <= 1", named("distance", distance));
  // The rows take half of the square; points are computed to a few units.
  const double within = distance * (1 - 1e-9);
  const double square = std::pow(std::sin(0.5 * within), 2);
  const auto rows = static_cast<std::size_t>(std::ceil(std::numbers::pi / (std::numbers::sqrt2 * within)));
  const double step = std::numbers::pi / static_cast<double>(rows);
  const double left = square - std::pow(std::sin(0.25 * step), 2);
  std::vector<Vector<double>> out;
  for (std::size_t i = 0; i < rows; ++i) {
    const double colatitude = (static_cast<double>(i) + 0.5) * step;
    const double sine = std::sin(colatitude);
    const double widest = sine * std::min(1.0, sine + 0.5 * step);
    const double half = std::asin(std::min(1.0, std::sqrt(left / widest)));  // of the longitudes between two
    const auto count = static_cast<std::size_t>(std::ceil(std::numbers::pi / (2 * half) * (1 + 1e-12)));
    for (std::size_t j = 0; j < count; ++j) {
      const double longitude = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(count);
      out.push_back({sine * std::cos(longitude), sine * std::sin(longitude), std::cos(colatitude)});
    }
  }
  return out;
}

double bound_between(double at_points, int degree, double distance) {
  constexpr double most = 1.5;
  expects(degree * distance < most, "degree * distance < 3/2", named("degree", degree));
  return at_points / std::cos(degree * distance) * upward;
}

}  // namespace radcert
