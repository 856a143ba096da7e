// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/sphere_over_disk/solution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::verification::psg10 {
namespace {

/// The rounds of Neumann's series contract by less than (radius/height)^2 albedo^2; this many serve down to
/// contractions of 0.99.
const WorkLimit most_rounds("psg10/sphere_over_disk/solution: rounds of Neumann's series", 12000, 1,
                            "no solution: AccuracyNotReached with the last change");

template <Real R>
R cosine_of_latitude(const R& t) {
  using std::sqrt;
  return sqrt((R(1) - t) * (R(1) + t));
}

template <Real R>
R magnitude(const R& x) {
  return larger_of(x, -x);
}

}  // namespace

bool allows(const SphereOverDiskScene& scene) {
  return scene.radius.sign() > 0 && scene.radius < scene.height && scene.radius < scene.disk_radius &&
         scene.albedo.sign() >= 0 && scene.albedo < Rational(1) && scene.intensity.sign() >= 0;
}

template <Real R>
R azimuth_kernel(const SceneNumbers<R>& scene, const R& u, const R& t) {
  using std::atan;
  using std::sqrt;
  const R& r = scene.radius;
  const R& h = scene.height;
  const R a = u * cosine_of_latitude(t);
  const R b = h * t + r;
  if (certainly_at_most(a, b)) return R(0);
  const R tangent = u * u + h * h - r * r;
  const R sum = tangent + R(2) * r * (b + a);
  const R difference = tangent + R(2) * r * (b - a);
  const R delta = sum * difference;
  const R squares = (a - b) * (a + b);
  const R height = h + r * t;
  const R factor = R(2) * r * squares - b * tangent;
  if (certainly_at_most(b, -a)) return R(2) * height * factor / (delta * sqrt(delta));
  const R integral = R(2) / sqrt(delta) * atan(sqrt(sum * (a - b) / (difference * (a + b))));
  return R(2) * height / (pi<R>() * delta) * (factor * integral + sqrt(squares));
}

template <Real R>
HorizonLatitudes<R> horizon_latitudes(const SceneNumbers<R>& scene, const R& u) {
  using std::sqrt;
  const R& r = scene.radius;
  const R& h = scene.height;
  const R root = u * sqrt(h * h + u * u - r * r);
  const R square = h * h + u * u;
  return {.whole = (-h * r - root) / square, .last = (root - h * r) / square};
}

template <Real R>
SphereOverDisk<R>::SphereOverDisk(const SphereOverDiskScene& scene, const SphereOverDiskRule& rule)
    : scene_(scene) {
  using std::sin;
  expects(allows(scene), "0 < radius < height, radius < disk_radius, 0 <= albedo < 1, 0 <= intensity",
          named("radius", scene.radius), named("height", scene.height),
          named("disk_radius", scene.disk_radius), named("albedo", scene.albedo),
          named("intensity", scene.intensity));
  expects(2 <= rule.nodes, "2 <= nodes", named("nodes", rule.nodes));
  expects(2 <= rule.points && rule.points <= 192, "2 <= points <= 192", named("points", rule.points));
  distances_ = {R(0), scene_.radius, scene_.disk_radius};
  const HorizonLatitudes<R> rim = horizon_latitudes(scene_, scene_.disk_radius);
  const HorizonLatitudes<R> shadow = horizon_latitudes(scene_, scene_.radius);
  // The plane that touches the sphere at the equator touches the circle u = r, so that shadow.last is 0.
  latitudes_ = {R(-1), rim.whole, shadow.whole, R(0), rim.last, R(1)};
  const R half_turn = pi<R>() / R(2);
  for (int j = 0; j < rule.nodes; ++j) {
    const R phase = half_turn * R(2 * j + 1) / R(rule.nodes);
    const R sine = sin(phase / R(2));
    nodes_.push_back(sine * sine);
    barycentric_.push_back(j % 2 == 0 ? sin(phase) : -sin(phase));
  }
  const IntervalRule<R> gauss = gauss_rule<R>(rule.points, IntervalWeight::one);
  for (std::size_t k = 0; k < gauss.nodes.size(); ++k) {
    const R sine = sin(half_turn * gauss.nodes[k]);
    squared_sines_.push_back(sine * sine);
    gauss_weights_.push_back(half_turn * sin(R(2) * half_turn * gauss.nodes[k]) * gauss.weights[k]);
  }
  // Above the last latitude nothing of the disk is seen.
  for (std::size_t i = 0; i + 2 < latitudes_.size(); ++i)
    sphere_.push_back({latitudes_[i], latitudes_[i + 1], std::vector<R>(nodes_.size(), R(0))});
  for (std::size_t i = 0; i + 1 < distances_.size(); ++i)
    disk_.push_back({distances_[i], distances_[i + 1], std::vector<R>(nodes_.size(), R(0))});
  solve();
}

template <Real R>
void SphereOverDisk<R>::add_piece(const R& from, const R& to, std::size_t panel,
                                  std::vector<Sample>& samples) const {
  if (!certainly_less(from, to)) return;
  for (std::size_t k = 0; k < squared_sines_.size(); ++k)
    samples.push_back({from + (to - from) * squared_sines_[k], (to - from) * gauss_weights_[k], panel});
}

/// The pieces of the disk that the sphere's point sees; the weights hold the kernel and the area.
template <Real R>
auto SphereOverDisk<R>::seen_from_sphere(const R& t) const -> std::vector<Sample> {
  std::vector<Sample> samples;
  const R b = scene_.height * t + scene_.radius;
  const R c = cosine_of_latitude(t);
  // The horizon lies on the disk if |b| < R c; without the comparison the quotient is not formed.
  const bool cut = certainly_less(magnitude(b), scene_.disk_radius * c);
  if (!cut && !certainly_negative(b)) return samples;
  const R horizon = cut ? magnitude(b) / c : scene_.disk_radius;
  for (std::size_t panel = 0; panel < disk_.size(); ++panel) {
    const R& from = disk_[panel].from;
    const R& to = disk_[panel].to;
    const R middle = smaller_of(larger_of(horizon, from), to);
    if (certainly_negative(b)) add_piece(from, middle, panel, samples);
    add_piece(middle, to, panel, samples);
  }
  for (Sample& sample : samples)
    sample.weight = sample.weight * sample.place * azimuth_kernel(scene_, sample.place, t);
  return samples;
}

/// The pieces of the sphere that the disk's point sees.
template <Real R>
auto SphereOverDisk<R>::seen_from_disk(const R& u) const -> std::vector<Sample> {
  std::vector<Sample> samples;
  const HorizonLatitudes<R> horizon = horizon_latitudes(scene_, u);
  for (std::size_t panel = 0; panel < sphere_.size(); ++panel) {
    const R& from = sphere_[panel].from;
    const R to = smaller_of(sphere_[panel].to, horizon.last);
    const R middle = smaller_of(larger_of(horizon.whole, from), to);
    add_piece(from, middle, panel, samples);
    add_piece(larger_of(middle, from), to, panel, samples);
  }
  const R area = scene_.radius * scene_.radius;
  for (Sample& sample : samples)
    sample.weight = sample.weight * area * azimuth_kernel(scene_, u, sample.place);
  return samples;
}

template <Real R>
R SphereOverDisk<R>::node(const Panel& panel, std::size_t j) const {
  using std::sin;
  const R sine = sin(pi<R>() / R(2) * nodes_[j]);
  return panel.from + (panel.to - panel.from) * sine * sine;
}

/// x with place = from + (to - from) sin^2(pi x/2).
template <Real R>
R SphereOverDisk<R>::angle(const Panel& panel, const R& place) const {
  using std::atan;
  using std::sqrt;
  const R before = place - panel.from;
  const R after = panel.to - place;
  if (!certainly_positive(before)) return R(0);
  if (!certainly_positive(after)) return R(1);
  return R(2) / pi<R>() * atan(sqrt(before / after));
}

template <Real R>
std::vector<R> SphereOverDisk<R>::lagrange(const Panel& panel, const R& place) const {
  const R x = angle(panel, place);
  std::vector<R> values(nodes_.size(), R(0));
  R sum(0);
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    const R difference = x - nodes_[j];
    if (certainly_zero(difference)) {
      std::fill(values.begin(), values.end(), R(0));
      values[j] = R(1);
      return values;
    }
    values[j] = barycentric_[j] / difference;
    sum = sum + values[j];
  }
  const R scale = R(1) / sum;
  for (R& value : values) value = value * scale;
  return values;
}

template <Real R>
R SphereOverDisk<R>::value(const Panel& panel, const R& place) const {
  const std::vector<R> functions = lagrange(panel, place);
  R sum(0);
  for (std::size_t j = 0; j < functions.size(); ++j) sum = multiply_add(functions[j], panel.values[j], sum);
  return sum;
}

template <Real R>
void SphereOverDisk<R>::solve() {
  const std::size_t n = nodes_.size();
  /// One equation: what the emission gives, and the weights of the unknowns.
  struct Row {
    R source;
    std::vector<R> weights;
  };
  const auto rows = [this, n](const std::vector<Panel>& targets, const std::vector<Panel>& sources,
                              const auto& samples_at, const auto& emission) {
    std::vector<Row> out(targets.size() * n, Row{R(0), std::vector<R>(sources.size() * n, R(0))});
    parallel_for(out.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Row& row = out[i];
        for (const Sample& sample : samples_at(node(targets[i / n], i % n))) {
          const R weight = scene_.albedo * sample.weight;
          row.source = row.source + weight * emission(sample);
          const std::vector<R> functions = lagrange(sources[sample.panel], sample.place);
          for (std::size_t j = 0; j < n; ++j) {
            R& entry = row.weights[sample.panel * n + j];
            entry = multiply_add(weight, functions[j], entry);
          }
        }
      }
    });
    return out;
  };
  const R lit = scene_.albedo * scene_.intensity;
  const std::vector<Row> of_sphere = rows(
      sphere_, disk_, [this](const R& t) { return seen_from_sphere(t); },
      [&lit](const Sample& sample) { return sample.panel == 0 ? R(0) : lit; });
  const std::vector<Row> of_disk = rows(
      disk_, sphere_, [this](const R& u) { return seen_from_disk(u); },
      [&lit](const Sample& sample) { return lit * larger_of(R(0), sample.place); });
  /// Puts the right-hand sides into the targets; the largest change.
  const auto update = [n](const std::vector<Row>& equations, const std::vector<Panel>& sources,
                          std::vector<Panel>& targets) {
    R largest(0);
    for (std::size_t i = 0; i < equations.size(); ++i) {
      R sum = equations[i].source;
      for (std::size_t j = 0; j < equations[i].weights.size(); ++j)
        sum = multiply_add(equations[i].weights[j], sources[j / n].values[j % n], sum);
      R& value = targets[i / n].values[i % n];
      largest = larger_of(largest, magnitude(sum - value));
      value = sum;
    }
    return largest;
  };
  R last(0);
  for (rounds_ = 1; rounds_ <= most_rounds.value(); ++rounds_) {
    const R sphere_change = update(of_sphere, disk_, sphere_);
    const R change = larger_of(sphere_change, update(of_disk, sphere_, disk_));
    // Rounding is reached where the change, small already, no longer falls.
    const bool small = certainly_at_most(change, R(1024) * unit_roundoff<R>() * lit);
    if (certainly_zero(change) || (small && !certainly_less(change, last))) return;
    last = change;
  }
  throw AccuracyNotReached("the sphere over the disk",
                           "the parts change by " +
                               nearest_text(nearest_double(last), DecimalForm::general(2)) + " in round " +
                               std::to_string(rounds_ - 1) + " of Neumann's series, the last one");
}

template <Real R>
Radiance<R> SphereOverDisk<R>::sphere(const R& t) const {
  expects(certainly_at_most(magnitude(t), R(1)), "-1 <= t <= 1", named("t", nearest_double(t)));
  const R lit = scene_.albedo * scene_.intensity;
  Radiance<R> out{.emission = lit * larger_of(R(0), t), .indirect = R(0)};
  for (const Sample& sample : seen_from_sphere(t)) {
    const R density = value(disk_[sample.panel], sample.place) + (sample.panel == 0 ? R(0) : lit);
    out.indirect = multiply_add(sample.weight, density, out.indirect);
  }
  out.indirect = scene_.albedo * out.indirect;
  return out;
}

template <Real R>
Radiance<R> SphereOverDisk<R>::disk(const R& u) const {
  expects(!certainly_negative(u) && certainly_at_most(u, scene_.disk_radius), "0 <= u <= disk_radius",
          named("u", nearest_double(u)));
  const R lit = scene_.albedo * scene_.intensity;
  Radiance<R> out{.emission = certainly_less(u, scene_.radius) ? R(0) : lit, .indirect = R(0)};
  for (const Sample& sample : seen_from_disk(u)) {
    const R density = value(sphere_[sample.panel], sample.place) + lit * larger_of(R(0), sample.place);
    out.indirect = multiply_add(sample.weight, density, out.indirect);
  }
  out.indirect = scene_.albedo * out.indirect;
  return out;
}

template double azimuth_kernel<double>(const SceneNumbers<double>&, const double&, const double&);
template Mpfr<50> azimuth_kernel<Mpfr<50>>(const SceneNumbers<Mpfr<50>>&, const Mpfr<50>&, const Mpfr<50>&);
template HorizonLatitudes<double> horizon_latitudes<double>(const SceneNumbers<double>&, const double&);
template HorizonLatitudes<Mpfr<50>> horizon_latitudes<Mpfr<50>>(const SceneNumbers<Mpfr<50>>&,
                                                                const Mpfr<50>&);
template class SphereOverDisk<double>;
template class SphereOverDisk<Mpfr<50>>;

}  // namespace radcert::verification::psg10
