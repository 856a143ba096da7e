// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/ellipsoid/ellipsoid_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::certificate {

const WorkLimit most_circle_degree("certificate/ellipsoid_check: degree on great circles", 400, 2,
                                   "nothing is known between points: the residual is not verified");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = 0x1p-53;
constexpr double slightly = 1 + 0x1p-40;
/// L h: half of its square is what points leave of the largest value.
constexpr double angle = 1.05;
/// Of reflectivities, whose values cost little: half of its square is a small part of what is left below 1.
double narrow_angle(const Rational& stated) {
  const double gap = (Rational(1) - stated).to_double();
  return std::clamp(std::sqrt(0.006 * gap), 0.01, 0.03);
}
/// Distances are this much smaller than what bounds take them for: points are rounded.
constexpr double for_rounding = 1e-9;

Pack packed(double x) { return {x}; }

Vector<Pack> packs_of(const Vector<double>& v) {
  const Vector<double> p = (1 / norm(v)) * v;
  return {packed(p.x), packed(p.y), packed(p.z)};
}

std::optional<Rational> constant_of(const std::vector<Monomial>& f) {
  Rational sum = 0;
  for (const Monomial& monomial : f) {
    if (monomial.coefficient.sign() == 0) continue;
    if (monomial.powers != std::array<int, 3>{}) return std::nullopt;
    sum += monomial.coefficient;
  }
  return sum;
}

std::optional<Refusal> surface_fault(const EllipsoidCertificate& c) {
  const std::array<const Rational*, 3> axes{&c.half_axes.x, &c.half_axes.y, &c.half_axes.z};
  for (std::size_t k = 0; k < axes.size(); ++k)
    if (axes[k]->sign() <= 0) return Refusal{"/problem/half_axes/" + std::to_string(k), "is not positive"};
  return std::nullopt;
}

/// That sup |rho| <= what is stated < 1, and that no point looked at shows rho < 0.
std::optional<Refusal> reflectivity_fault(const EllipsoidCertificate& c) {
  const std::string pointer = "/largest_reflectivity";
  const Rational& stated = c.largest_reflectivity;
  if (stated.sign() < 0 || stated >= Rational(1)) return Refusal{pointer, "is not from 0 to below 1"};
  const Refusal negative{"/problem/reflectivity", "is negative"};
  if (const std::optional<Rational> constant = constant_of(c.reflectivity)) {
    if (constant->sign() < 0) return negative;
    if (abs(*constant) > stated) return Refusal{pointer, "is less than the reflectivity"};
    return std::nullopt;
  }
  const StretchedPolynomial rho(c.reflectivity, c.half_axes);
  if (!rho.is_finite()) return Refusal{"/problem/reflectivity", "is beyond the range of double"};
  const BetweenPoints between{
      .degree = rho.degree(), .distance = narrow_angle(stated) / rho.degree(), .left = 0, .slope_left = 0};
  const SphereCover cover(between.distance * (1 - for_rounding));
  double least = infinity;
  double largest = -infinity;
  for (std::size_t row = 0; row < cover.rows(); ++row)
    for (std::size_t k = 0; k < cover.count(row); ++k) {
      const double value = rho(packs_of(cover.point(row, k))).lane(0);
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
  if (least + rho.error(8 * unit) < 0) return negative;
  // rho - middle, at points half in size, and so everywhere no more than what the stated bound leaves.
  const double middle = 0.5 * (least + largest);
  const double half = (0.5 * (largest - least) + rho.error(8 * unit)) * slightly;
  const double left = ((Rational(stated) - abs(Rational::exactly(middle))).to_double()) / slightly;
  if (!(half <= between.at_points(left))) return Refusal{pointer, "is not shown to bound the reflectivity"};
  return std::nullopt;
}

std::optional<Refusal> points_fault(const EllipsoidCertificate& c) {
  for (std::size_t k = 0; k < c.points.size(); ++k) {
    const Vector<Rational>& at = c.points[k];
    const Vector<Rational> p{at.x / c.half_axes.x, at.y / c.half_axes.y, at.z / c.half_axes.z};
    if (!(dot(p, p) == Rational(1)))
      return Refusal{"/problem/points/" + std::to_string(k), "does not lie on the surface"};
  }
  return std::nullopt;
}

std::optional<Refusal> range_fault(const EllipsoidCertificate& c) {
  const SphereDensity density(c);
  if (!density.emission.is_finite() || !(density.rest(0) + std::abs(density.constant()) < infinity))
    return Refusal{"/problem/emission", "is beyond the range of double"};
  return std::nullopt;
}

std::optional<Refusal> bound_fault(const EllipsoidCertificate& c) {
  const Rational& s = c.largest_reflectivity;
  if (s * Rational::exactly(c.residual) > c.bound * (Rational(1) - s))
    return Refusal{"/bound", "is less than what follows from the residual"};
  if (c.of == OnEllipsoid::function && Rational(2) * c.bound > c.width)
    return Refusal{"/width", "is less than twice the bound"};
  return std::nullopt;
}

std::optional<Refusal> enclosures_fault(const EllipsoidCertificate& c) {
  const std::vector<Ball> found = enclosed(c);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Enclosure& stated = c.enclosures[k];
    const std::string pointer = (c.of == OnEllipsoid::mean ? "/means/" : "/values/") + std::to_string(k);
    if (!certainly_at_most(abs(found[k] - Ball(stated.midpoint)), Ball(stated.radius)))
      return Refusal{pointer, "with its radius does not hold what the bound proves, " + found[k].to_text(12)};
    if (Rational(2) * stated.radius > c.width)
      return Refusal{pointer, "is wider than the width that is stated"};
  }
  return std::nullopt;
}

/// An emission as a certificate of a density without q.
EllipsoidCertificate emission_alone(const EllipsoidCertificate& c) {
  EllipsoidCertificate out;
  out.half_axes = c.half_axes;
  out.emission = c.emission;
  out.cosines = out.sines = {0};
  return out;
}

Ball enclosing_ball(const Approximation& x) {
  return std::isfinite(x.radius) ? widened(Ball(x.value), Ball(x.radius)) : Ball::failed("there is no rule");
}

/// What the values of t are looked at with.
class Residual {
public:
  explicit Residual(const EllipsoidCertificate& c)
      : certificate_(c),
        stretch_(c.half_axes),
        density_(c),
        between_(between_points(stretch_, density_, c.residual)),
        allowed_(between_.degree > 0 ? between_.at_points(c.residual) : -1),
        transport_(stretch_, density_, 0.01 * c.residual),
        of_q_(density_.q.error(8 * unit)),
        cover_(between_.degree > 0 ? between_.distance * (1 - for_rounding) : 1) {}

  [[nodiscard]] const SphereCover& cover() const { return cover_; }

  [[nodiscard]] std::optional<Refusal> fault(std::size_t row) const {
    const auto refused = [&](const std::string& says) {
      return Refusal{"/residual", "claims " + shortest(certificate_.residual) + ", and " + says};
    };
    if (!(allowed_ > 0)) return refused("nothing is proved between points");
    for (std::size_t k = 0; k < cover_.count(row); ++k) {
      const double size = bound_at(cover_.point(row, k));
      if (size <= allowed_) continue;
      if (!(size < infinity)) return refused("nothing is proved at a point");
      return refused(upper_text(size, DecimalForm::general(6)) +
                     " is proved at a point, where no more than " +
                     upper_text(allowed_, DecimalForm::general(6)) + " shows that");
    }
    return std::nullopt;
  }

  /// Of |t| at a point.
  [[nodiscard]] double bound_at(const Vector<double>& p) const {
    const Approximation sent = transport_(p);
    const double t = std::abs(sent.value - density_.q(packs_of(p)).lane(0));
    return (t * slightly + sent.radius + of_q_ + 4 * unit * std::abs(sent.value)) * slightly;
  }
  /// What t may be off.
  [[nodiscard]] double radius_at(const Vector<double>& p) const { return transport_(p).radius + of_q_; }

private:
  const EllipsoidCertificate& certificate_;
  EllipsoidStretch stretch_;
  SphereDensity density_;
  BetweenPoints between_;
  double allowed_;
  RayTransport transport_;
  double of_q_;
  SphereCover cover_;
};

}  // namespace

SphereCover::SphereCover(double distance) {
  expects(distance >= 1e-4 && distance <= 1, "1e-4 <= distance <= 1", named("distance", distance));
  // Half of the square each for the colatitude and the longitude.
  const double part = distance / std::numbers::sqrt2 / slightly;
  const auto rows = static_cast<std::size_t>(std::ceil(std::numbers::pi / (2 * part)));
  const double step = std::numbers::pi / static_cast<double>(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const double lower = static_cast<double>(row) * step;
    const bool holds_equator = lower <= std::numbers::pi / 2 && lower + step >= std::numbers::pi / 2;
    const double sine = holds_equator ? 1 : std::max(std::sin(lower), std::sin(lower + step));
    counts_.push_back(static_cast<std::size_t>(std::ceil(std::numbers::pi * sine * slightly / part)));
  }
}

Vector<double> SphereCover::point(std::size_t row, std::size_t place) const {
  const double colatitude =
      (static_cast<double>(row) + 0.5) * std::numbers::pi / static_cast<double>(counts_.size());
  const double longitude =
      2 * std::numbers::pi * static_cast<double>(place) / static_cast<double>(counts_[row]);
  return {std::sin(colatitude) * std::cos(longitude), std::sin(colatitude) * std::sin(longitude),
          std::cos(colatitude)};
}

double BetweenPoints::at_points(double bound) const {
  const double part = 0.5 * (degree * distance) * (degree * distance) * slightly;
  return (bound * (1 - part) - ((2 + part) * left + distance * slope_left) * slightly) / slightly;
}

BetweenPoints between_points(const EllipsoidStretch& stretch, const SphereDensity& density, double residual) {
  constexpr int strips = 60;
  std::vector<std::pair<double, double>> bounds;
  for (int k = 1; k < strips; ++k) {
    const double s = stretch.widest() * k / strips;
    const double bound = transported_around(stretch, density, s);
    if (bound < infinity) bounds.emplace_back(s, bound);
  }
  for (int degree = std::max(1, density.q.degree()); degree <= most_circle_degree.value(); ++degree) {
    BetweenPoints best;
    double least = infinity;
    for (const auto& [s, bound] : bounds) {
      const double falls = std::exp(-s);
      const double rest = -std::expm1(-s);
      BetweenPoints tried{.degree = degree, .distance = std::min(1.0, angle / degree)};
      tried.left = 2 * bound * std::exp(-degree * s) / std::expm1(s) * slightly;
      tried.slope_left = 2 * bound * std::exp(-(degree + 1) * s) * ((degree + 1) - degree * falls) /
                         (rest * rest) * slightly;
      const double cost = 3 * tried.left + tried.distance * tried.slope_left;
      if (cost < least) {
        least = cost;
        best = tried;
      }
    }
    constexpr double share = 1.0 / 30;
    if (least <= share * residual) return best;
  }
  return {};
}

std::vector<Ball> enclosed(const EllipsoidCertificate& c) {
  std::vector<Ball> out;
  if (c.of == OnEllipsoid::function) return out;
  const Ball bound(c.bound);
  if (c.of == OnEllipsoid::values) {
    const TurnedPolynomial q(c.degree, c.cosines, c.sines);
    for (const Vector<Rational>& at : c.points) {
      const Vector<Rational> p{at.x / c.half_axes.x, at.y / c.half_axes.y, at.z / c.half_axes.z};
      out.push_back(
          widened(Ball(value_of(c.emission, at)) + Ball(value_of(c.reflectivity, at)) * q.at(p), bound));
    }
    return out;
  }
  const EllipsoidStretch stretch(c.half_axes);
  const SphereDensity w(c);
  constexpr double of_rounding = 1e-14;
  const double tolerance =
      std::max(0.01 * c.bound.to_double(), of_rounding * (std::abs(w.constant()) + w.rest(0)));
  Ball mean = widened(enclosing_ball(mean_over_surface(stretch, w, tolerance)), bound);
  if (const std::optional<Rational> rho = constant_of(c.reflectivity); rho && *rho < Rational(1)) {
    const SphereDensity emission(emission_alone(c));
    const Ball own =
        enclosing_ball(mean_over_surface(stretch, emission, tolerance)) / Ball(Rational(1) - *rho);
    if (!(own.radius() >= mean.radius())) mean = own;
  }
  out.push_back(mean);
  return out;
}

double room_for_check(const EllipsoidCertificate& c) {
  if (c.largest_reflectivity.sign() == 0) return 0;
  // What points leave multiplies it by less than this.
  constexpr double factor = 3;
  return factor * Residual(c).radius_at({1, 0, 0});
}

std::size_t part_count(const EllipsoidCertificate& c) {
  if (surface_fault(c) || c.largest_reflectivity.sign() == 0) return 1;
  const BetweenPoints between = between_points(EllipsoidStretch(c.half_axes), SphereDensity(c), c.residual);
  return between.degree > 0 ? SphereCover(between.distance * (1 - for_rounding)).rows() : 1;
}

Report check(const EllipsoidCertificate& c, const Part& part, const CheckListener& progress) {
  Report report;
  for (const auto& fault :
       {&surface_fault, &reflectivity_fault, &points_fault, &range_fault, &bound_fault, &enclosures_fault}) {
    report.refusal = fault(c);
    if (report.refusal) return report;
  }
  if (c.largest_reflectivity.sign() == 0) {
    // u = E, whatever the residual.
    report.looked_at = {0};
    return report;
  }
  const Residual residual(c);
  report.looked_at = chosen_elements(residual.cover().rows(), part);
  report.refusal = first_fault(
      report.looked_at, [&](std::size_t row) { return residual.fault(row); }, progress);
  return report;
}

}  // namespace radcert::certificate
