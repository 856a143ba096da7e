// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/sphere_over_disk/cubature.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/geometry/vector.h"

namespace radcert::verification::psg10 {
namespace {

/// x = 1/(1 + exp(-pi sinh s)) on (0,1), s in whole multiples of the step as far as the weights are above
/// rounding.
template <Real R>
struct DoubleExponentialRule {
  std::vector<R> nodes;
  std::vector<R> weights;

  explicit DoubleExponentialRule(int points_a_unit) {
    using std::exp;
    // The weight falls like exp(-pi sinh |s|).
    const double reach = std::asinh(-std::log(nearest_double(unit_roundoff<R>())) / 3.14);
    const int last = static_cast<int>(std::ceil(reach * points_a_unit));
    for (int k = -last; k <= last; ++k) {
      const R s = R(k) / R(points_a_unit);
      const R growth = exp(s);
      const R angle = pi<R>() * (growth - R(1) / growth) / R(2);
      const R fall = exp(-angle);
      const R x = R(1) / (R(1) + fall);
      nodes.push_back(x);
      weights.push_back(pi<R>() * (growth + R(1) / growth) / R(2) * fall * x * x / R(points_a_unit));
    }
  }

  template <class F>
  R operator()(const R& from, const R& to, const F& f) const {
    if (!certainly_less(from, to)) return R(0);
    R sum(0);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      sum = multiply_add(weights[k], f(from + (to - from) * nodes[k]), sum);
    return (to - from) * sum;
  }
};

/// Int cos cos'/(pi d^2) dtau over the azimuths at which the points face each other.
template <Real R>
R azimuth_integral(const SceneNumbers<R>& scene, const R& u, const R& t,
                   const DoubleExponentialRule<R>& rule) {
  using std::atan;
  using std::cos;
  using std::sin;
  using std::sqrt;
  const R c = sqrt((R(1) - t) * (R(1) + t));
  const Vector<R> on_disk{u, R(0), R(0)};
  // normal . (q - p) = c u cos tau - (t height + radius), and tan(tau/2)^2 = (1 - cos tau)/(1 + cos tau).
  const R ahead = c * u - (t * scene.height + scene.radius);
  const R behind = c * u + (t * scene.height + scene.radius);
  if (!certainly_positive(ahead)) return R(0);
  const R limit = certainly_positive(behind) ? R(2) * atan(sqrt(ahead / behind)) : pi<R>();
  const R half = rule(R(0), limit, [&](const R& tau) {
    const Vector<R> normal{c * cos(tau), c * sin(tau), t};
    const Vector<R> on_sphere = Vector<R>{R(0), R(0), scene.height} + scene.radius * normal;
    const Vector<R> to_disk = on_disk - on_sphere;
    const R square = dot(to_disk, to_disk);
    return larger_of(R(0), dot(to_disk, normal)) * on_sphere.z / (square * square);
  });
  return R(2) * half / pi<R>();
}

/// The sum of a rule over the pieces between some ends, in ascending order.
template <Real R, class F>
R over_pieces(std::vector<R> ends, const DoubleExponentialRule<R>& rule, const F& f) {
  std::sort(ends.begin(), ends.end());
  const std::size_t count = rule.nodes.size();
  std::vector<R> terms((ends.size() - 1) * count, R(0));
  parallel_for(terms.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const R& from = ends[i / count];
      const R length = ends[i / count + 1] - from;
      if (certainly_positive(length))
        terms[i] = length * rule.weights[i % count] * f(from + length * rule.nodes[i % count]);
    }
  });
  R sum(0);
  for (const R& term : terms) sum = sum + term;
  return sum;
}

}  // namespace

template <Real R>
R indirect_on_sphere(const SphereOverDisk<R>& solution, const R& t, int points_a_unit) {
  using std::sqrt;
  expects(1 <= points_a_unit, "1 <= points_a_unit", named("points_a_unit", points_a_unit));
  const SceneNumbers<R>& scene = solution.scene();
  const DoubleExponentialRule<R> rule(points_a_unit);
  std::vector<R> ends(solution.distances().begin(), solution.distances().end());
  // The tangent plane meets the disk's plane at this distance from the axis.
  const R plane = scene.height * t + scene.radius;
  const R away = larger_of(plane, -plane);
  const R c = sqrt((R(1) - t) * (R(1) + t));
  if (certainly_less(away, scene.disk_radius * c)) ends.push_back(away / c);
  return scene.albedo * over_pieces(ends, rule, [&](const R& u) {
           const R kernel = azimuth_integral(scene, u, t, rule);
           return certainly_zero(kernel) ? R(0) : solution.disk(u).total() * u * kernel;
         });
}

template <Real R>
R indirect_on_disk(const SphereOverDisk<R>& solution, const R& u, int points_a_unit) {
  using std::sqrt;
  expects(1 <= points_a_unit, "1 <= points_a_unit", named("points_a_unit", points_a_unit));
  const SceneNumbers<R>& scene = solution.scene();
  const DoubleExponentialRule<R> rule(points_a_unit);
  std::vector<R> ends = solution.latitudes();
  // The sphere seen from the point: its centre at the polar angle phi from the vertical, its limb at the
  // angle psi from the far point as seen from the centre; the limb's highest and lowest latitudes have the
  // sines -cos(phi +- psi).
  const R distance = sqrt(u * u + scene.height * scene.height);
  const R cos_psi = scene.radius / distance;
  const R sin_psi = sqrt((R(1) - cos_psi) * (R(1) + cos_psi));
  const R product = scene.height / distance * cos_psi;
  const R other = u / distance * sin_psi;
  ends.push_back(-product - other);
  ends.push_back(other - product);
  return scene.albedo * scene.radius * scene.radius * over_pieces(ends, rule, [&](const R& t) {
           const R kernel = azimuth_integral(scene, u, t, rule);
           return certainly_zero(kernel) ? R(0) : solution.sphere(t).total() * kernel;
         });
}

template double indirect_on_sphere<double>(const SphereOverDisk<double>&, const double&, int);
template Mpfr<50> indirect_on_sphere<Mpfr<50>>(const SphereOverDisk<Mpfr<50>>&, const Mpfr<50>&, int);
template double indirect_on_disk<double>(const SphereOverDisk<double>&, const double&, int);
template Mpfr<50> indirect_on_disk<Mpfr<50>>(const SphereOverDisk<Mpfr<50>>&, const Mpfr<50>&, int);

}  // namespace radcert::verification::psg10
