// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/ellipsoid/ellipsoid_enclosure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/continuous/upward.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"
#include "radcert/polynomial/rules/gauss.h"

namespace radcert {

const WorkLimit most_harmonics("continuous/ellipsoid_enclosure: degree of harmonics", most_sphere_degree, 2,
                               "a wider enclosure, with its reason");
const WorkLimit most_products("continuous/ellipsoid_enclosure: millions of products", 4000000, 1,
                              "a wider enclosure or none, with its reason");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// M d: 1/cos is 2.8.
constexpr double cover_angle = 1.2;

/// P_l^m of mean square 1 with its factor sqrt(2 - [m = 0]), by l l + l + m.
std::vector<double> harmonic_values(int degree, double z) {
  const auto count = static_cast<std::size_t>(degree + 1);
  std::vector<double> out(count * count);
  const double sine = std::sqrt((1 - z) * (1 + z));
  double first = 1;
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) first *= sine * std::sqrt(m == 1 ? 3.0 : (2.0 * m + 1) / (2.0 * m));
    double before = 0;
    double now = first;
    double b_now = 0;
    for (int l = m; l <= degree; ++l) {
      out[static_cast<std::size_t>(l * l + l + m)] = now;
      const double n = l + 1;
      const double b_next = std::sqrt((n * n - m * m) / (4 * n * n - 1));
      before = std::exchange(now, (z * now - b_now * before) / b_next);
      b_now = b_next;
    }
  }
  return out;
}

/// The points of a product rule that is exact for twice a degree, and harmonics from values there.
class HarmonicAnalysis {
public:
  explicit HarmonicAnalysis(int degree)
      : degree_(degree),
        around_(static_cast<std::size_t>(2 * degree + 2)),
        rule_(gauss_rule<double>(degree + 1, IntervalWeight::one)) {
    for (double& node : rule_.nodes) node = 2 * node - 1;
    for (const double z : rule_.nodes) {
      const double sine = std::sqrt((1 - z) * (1 + z));
      for (std::size_t j = 0; j < around_; ++j)
        points_.push_back({sine * std::cos(longitude(j)), sine * std::sin(longitude(j)), z});
    }
  }
  [[nodiscard]] const std::vector<Vector<double>>& points() const { return points_; }
  /// Of the mean over the sphere.
  [[nodiscard]] double weight(std::size_t place) const {
    return rule_.weights[place / around_] / static_cast<double>(around_);
  }
  [[nodiscard]] std::vector<double> harmonics(const std::vector<double>& values) const {
    const auto count = static_cast<std::size_t>(degree_ + 1);
    std::vector<double> out(count * count);
    for (std::size_t i = 0; i < rule_.nodes.size(); ++i) {
      const std::vector<double> legendre = harmonic_values(degree_, rule_.nodes[i]);
      for (int m = 0; m <= degree_; ++m) {
        double cosines = 0;
        double sines = 0;
        for (std::size_t j = 0; j < around_; ++j) {
          const double value = values[i * around_ + j] * weight(i * around_ + j);
          cosines += value * std::cos(m * longitude(j));
          sines += value * std::sin(m * longitude(j));
        }
        for (int l = m; l <= degree_; ++l) {
          const double p = legendre[static_cast<std::size_t>(l * l + l + m)];
          out[static_cast<std::size_t>(l * l + l + m)] += p * cosines;
          if (m > 0) out[static_cast<std::size_t>(l * l + l - m)] += p * sines;
        }
      }
    }
    return out;
  }

private:
  [[nodiscard]] double longitude(std::size_t j) const {
    return 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(around_);
  }
  int degree_;
  std::size_t around_;
  IntervalRule<double> rule_;
  std::vector<Vector<double>> points_;
};

/// One value, padded to the packs that a density takes.
double value_at(const EllipsoidDensity& w, const Vector<double>& p) {
  const Vector<double> unit = (1 / norm(p)) * p;
  const Vector<Pack> at{unit.x, unit.y, unit.z};
  return w({at, at})[0].lane(0);
}
double value_at(const SpherePolynomial& f, const Vector<double>& p) {
  const Vector<double> unit = (1 / norm(p)) * p;
  const Vector<Pack> at{unit.x, unit.y, unit.z};
  return f({at, at})[0].lane(0);
}

/// T v and q at points.
struct Samples {
  std::vector<double> transported;  ///< T v
  std::vector<double> residual;     ///< T v - q
  double largest = 0;               ///< |residual|, rounded
  double bound = 0;                 ///< of |residual|, proved
};

Samples sample(const EllipsoidTransport& transport, const SpherePolynomial& q,
               const std::vector<Vector<double>>& points) {
  Samples out{.transported = std::vector<double>(points.size()),
              .residual = std::vector<double>(points.size())};
  std::vector<double> bounds(points.size());
  parallel_for(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Approximation transported = transport(points[i]);
      out.transported[i] = transported.value;
      out.residual[i] = transported.value - value_at(q, points[i]);
      bounds[i] = (std::abs(out.residual[i]) + transported.radius + q.rounding()) * upward;
    }
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    out.largest = std::max(out.largest, std::abs(out.residual[i]));
    out.bound = std::isfinite(bounds[i]) ? std::max(out.bound, bounds[i]) : infinity;
    if (!std::isfinite(out.bound)) break;
  }
  return out;
}

/// A point counts as a few hundred thousand products at least: what it takes in memory.
bool is_too_much(double points, const EllipsoidTransport& transport, const EllipsoidDensity& v) {
  constexpr double least = 4e5;
  const double products = static_cast<double>(transport.nodes()) * v.cost();
  return points * std::max(least, products) > 1e6 * static_cast<double>(most_products.value());
}

Outcome<ReflectivityBound> bound_of_reflectivity(const EllipsoidProblem& problem,
                                                 const SpherePolynomial& rho) {
  if (const std::optional<Rational> constant = problem.reflectivity.is_constant()) {
    if (constant->sign() < 0 || !(*constant < Rational(1)))
      return because("the reflectivity is not in [0,1)");
    if (constant->sign() == 0) return ReflectivityBound{.largest = 0, .gap = 1};
    constexpr double least = std::numeric_limits<double>::min();
    return ReflectivityBound{.largest = std::max(constant->to_double() * upward, least),
                             .gap = (Rational(1) - *constant).to_double() / upward,
                             .seen = constant->to_double() / upward};
  }
  if (rho.degree() > most_reflectivity_degree)
    return because("the degree of the reflectivity is more than " + std::to_string(most_reflectivity_degree));
  const double distance = 0.05 / std::max(1, rho.degree());
  double least = infinity;
  double largest = -infinity;
  for (const Vector<double>& p : sphere_cover(distance)) {
    const double value = value_at(rho, p);
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  const double middle = 0.5 * (least + largest);
  const double half = 0.5 * (largest - least) * upward + 2 * rho.rounding();
  const double norm = (std::abs(middle) + bound_between(half, rho.degree(), distance)) * upward;
  if (!(norm < 1)) return because("the reflectivity is not shown to be below 1 everywhere");
  if (least < -rho.rounding()) return because("the reflectivity is negative at a point");
  return ReflectivityBound{
      .largest = norm, .gap = (1 - norm) / upward, .seen = std::max(0.0, largest - rho.rounding()) / upward};
}

/// q of one degree, as good as it happens to be.
class Trial {
public:
  Trial(const EllipsoidShape& shape, SpherePolynomial emission, SpherePolynomial reflectivity)
      : shape_(shape),
        v_{.emission = std::move(emission), .reflectivity = std::move(reflectivity), .reflected = {}} {}

  [[nodiscard]] const EllipsoidDensity& v() const { return v_; }
  [[nodiscard]] double residual() const { return residual_; }
  [[nodiscard]] std::size_t nodes() const { return nodes_; }
  /// Whether the residual is no larger than what is known of it.
  [[nodiscard]] bool is_rounding() const { return residual_ <= radius_; }

  /// Repeats q <- T v, and moves q by a constant so that Int rho t dS vanishes, until t falls no more.
  /// Result    refused where T v has no rule, or the work is too much
  Outcome<void> improve(int degree, double tolerance) {
    const HarmonicAnalysis analysis(degree);
    harmonics_.resize(static_cast<std::size_t>((degree + 1) * (degree + 1)));
    std::vector<double> best = harmonics_;
    double least = infinity;
    for (bool falls = true; falls;) {
      v_.reflected = SpherePolynomial(degree, harmonics_);
      const double level = std::min({least, residual_, v_.largest()});
      const EllipsoidTransport transport(shape_, v_, std::max(tolerance, 3e-3 * level));
      if (!transport.exists()) return because("too many nodes would integrate over the ellipsoid");
      if (is_too_much(static_cast<double>(analysis.points().size()), transport, v_))
        return because("too much work for polynomials of degree " + std::to_string(degree));
      nodes_ = transport.nodes();
      const Samples samples = sample(transport, v_.reflected, analysis.points());
      if (!std::isfinite(samples.bound)) return because("numbers beyond the range of double");
      falls = samples.largest < 0.5 * least;
      if (samples.largest < least) {
        least = samples.largest;
        radius_ = samples.bound - samples.largest;
        best = harmonics_;
      }
      harmonics_ = analysis.harmonics(samples.transported);
      harmonics_[0] += shift(analysis, samples);
    }
    harmonics_ = std::move(best);
    residual_ = least;
    v_.reflected = SpherePolynomial(degree, harmonics_);
    return {};
  }

private:
  /// The constant that the error of q has beside t: Int (t + c)(1 - rho) = Int t.
  [[nodiscard]] double shift(const HarmonicAnalysis& analysis, const Samples& samples) const {
    const Vector<double>& a = shape_.axes();
    double numerator = 0;
    double denominator = 0;
    for (std::size_t i = 0; i < samples.residual.size(); ++i) {
      const Vector<double>& p = analysis.points()[i];
      const double area = analysis.weight(i) * norm(Vector<double>{p.x / a.x, p.y / a.y, p.z / a.z});
      const double rho = value_at(v_.reflectivity, p);
      numerator += area * rho * samples.residual[i];
      denominator += area * (1 - rho);
    }
    return numerator / denominator;
  }

  const EllipsoidShape& shape_;
  EllipsoidDensity v_;
  std::vector<double> harmonics_{0};
  double residual_ = infinity;
  double radius_ = infinity;
  std::size_t nodes_ = 0;
};

Approximation mean_of(const EllipsoidProblem& problem, const EllipsoidShape& shape,
                      const EllipsoidEnclosure& found, double wanted) {
  const double tolerance = 0.01 * std::max(wanted, found.bound);
  const Approximation of_v = surface_mean(shape, found.v, tolerance);
  Approximation mean = Approximation::proved(of_v.value, (of_v.radius + found.bound) * upward);
  const std::optional<Rational> rho = problem.reflectivity.is_constant();
  if (!rho) return mean;
  const double gap = (Rational(1) - *rho).to_double();
  const EllipsoidDensity emission{.emission = found.v.emission, .reflectivity = {}, .reflected = {}};
  const Approximation of_e = surface_mean(shape, emission, tolerance * gap);
  const double value = of_e.value / gap;
  const double radius = (of_e.radius / gap + 4 * unit_roundoff<double>() * std::abs(value)) * upward;
  if (std::isfinite(value) && radius < mean.radius) mean = Approximation::proved(value, radius);
  return mean;
}

/// The degree after this one: where the residual, which falls off by a factor a degree, is small enough.
int next_degree(int degree, double residual, int last_degree, double last_residual, double goal) {
  const double slope = std::log(last_residual / residual) / (degree - last_degree);
  const double missing = std::log(residual / goal);
  const double steps = slope > 0 && missing > 0 ? missing / slope : 2;
  return degree + static_cast<int>(std::clamp(std::ceil(steps), 2.0, static_cast<double>(degree)));
}

}  // namespace

Approximation EllipsoidEnclosure::at(const Vector<double>& p) const {
  expects(norm(p) >= 0.5 && norm(p) <= 2, "1/2 <= |p| <= 2", named("|p|", norm(p)));
  const double value = value_at(v, p);
  const double radius = (bound + v.rounding()) * upward;
  if (!std::isfinite(value) || !(radius >= 0)) return Approximation::proved(0, infinity);
  return Approximation::proved(value, radius);
}

Outcome<ErrorBound> bound_of_error(const EllipsoidShape& shape, const EllipsoidDensity& v,
                                   const ReflectivityBound& rho, double target) {
  const double factor = rho.largest / rho.gap * upward;
  const double of_residual = target / factor;
  const EllipsoidTransport transport(shape, v, 0.01 * of_residual);
  if (!transport.exists()) return because("too many nodes would integrate over the ellipsoid");
  int degree = std::max(v.reflected.degree(), 2);
  double tail = harmonic_tail(shape, v, degree);
  const auto distance = [&] { return cover_angle / degree; };
  const auto too_many = [&] {
    return is_too_much(4 * std::numbers::pi / (distance() * distance()), transport, v);
  };
  while (!(tail <= 0.02 * of_residual) && !too_many()) tail = harmonic_tail(shape, v, ++degree);
  if (too_many()) return because("too many points would show what lies between them");
  const std::vector<Vector<double>> points = sphere_cover(distance());
  const Samples samples = sample(transport, v.reflected, points);
  const double residual = (bound_between(samples.bound + tail, degree, distance()) + tail) * upward;
  const double bound = factor * residual * upward;
  if (!std::isfinite(bound)) return because("numbers beyond the range of double");
  return ErrorBound{.bound = bound, .samples = points.size(), .nodes = transport.nodes()};
}

Outcome<double> emission_bound(const EllipsoidProblem& problem) {
  const Outcome<SpherePolynomial> emission = SpherePolynomial::along(problem.emission, problem.half_axes);
  if (!emission) return because(emission.reason());
  return emission->largest();
}

Outcome<ReflectivityBound> reflectivity_bound(const EllipsoidProblem& problem) {
  const Outcome<SpherePolynomial> rho = SpherePolynomial::along(problem.reflectivity, problem.half_axes);
  if (!rho) return because(rho.reason());
  return bound_of_reflectivity(problem, *rho);
}

Outcome<EllipsoidEnclosure> enclose_on_ellipsoid(
    const EllipsoidProblem& problem, double wanted,
    const std::function<void(const EllipsoidProgress&)>& progress) {
  expects(wanted > 0, "wanted > 0", named("wanted", wanted));
  const Vector<Rational>& axes = problem.half_axes;
  if (axes.x.sign() <= 0 || axes.y.sign() <= 0 || axes.z.sign() <= 0)
    return because("a half axis is not positive");
  const Outcome<SpherePolynomial> emission = SpherePolynomial::along(problem.emission, axes);
  if (!emission) return because("the emission: " + emission.reason());
  const Outcome<SpherePolynomial> reflectivity = SpherePolynomial::along(problem.reflectivity, axes);
  if (!reflectivity) return because("the reflectivity: " + reflectivity.reason());
  const Outcome<ReflectivityBound> rho = bound_of_reflectivity(problem, *reflectivity);
  if (!rho) return because(rho.reason());
  const double factor = rho->largest / rho->gap;

  const EllipsoidShape shape(axes);
  Trial trial(shape, *emission, *reflectivity);
  EllipsoidEnclosure best{.v = trial.v()};
  if (factor == 0) {
    best.bound = 0;
    best.last.bound = 0;
    best.mean = mean_of(problem, shape, best, wanted);
    return best;
  }
  // Not 0, where a quotient with it would be no number.
  const double goal = std::max(wanted / factor, std::numeric_limits<double>::min());
  int last_degree = 0;
  double last_residual = infinity;
  for (int degree = 4; best.hindrance.empty();) {
    degree = std::min(degree, static_cast<int>(most_harmonics.value()));
    const Outcome<void> improved = trial.improve(degree, 0.003 * goal);
    if (!improved) {
      best.hindrance = improved.reason();
      break;
    }
    const double residual = trial.residual();
    const bool is_last = degree == most_harmonics.value();
    // The bound is 2.8 times the largest residual at points, which a finer set of points exceeds a little.
    const bool promises = 3.2 * residual <= 0.8 * goal;
    const bool is_rounding = trial.is_rounding();
    if (promises || is_last || is_rounding) {
      const Outcome<ErrorBound> bound =
          bound_of_error(shape, trial.v(), *rho, std::max(wanted, factor * residual));
      if (!bound) {
        best.hindrance = bound.reason();
        break;
      }
      if (bound->bound < best.bound) {
        best.v = trial.v();
        best.bound = bound->bound;
      }
      best.last = {.degree = degree,
                   .nodes = bound->nodes,
                   .samples = bound->samples,
                   .residual = residual,
                   .bound = best.bound};
    } else {
      best.last = {.degree = degree, .nodes = trial.nodes(), .residual = residual, .bound = best.bound};
    }
    if (progress) progress(best.last);
    if (best.bound <= wanted) break;
    if (is_rounding) best.hindrance = "the rounding of double";
    if (is_last) best.hindrance = "polynomials of degree " + std::to_string(degree) + " are not good enough";
    const int next = next_degree(degree, residual, last_degree, last_residual, 0.2 * goal);
    last_degree = degree;
    last_residual = residual;
    degree = next;
  }
  if (std::isfinite(best.bound)) best.mean = mean_of(problem, shape, best, wanted);
  return best;
}

}  // namespace radcert
