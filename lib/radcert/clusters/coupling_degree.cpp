// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/coupling_degree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/clusters/mode_tables.h"
#include "radcert/clusters/triangle_modes.h"
#include "radcert/kernel/geometric_kernel.h"

namespace radcert {
namespace {

/// What interpolation in both clusters, and aliasing, add to projection: so that the sum over a row is
/// covered five times. Far less than the Lebesgue constants allow, since errors that oscillate do not add up.
constexpr double interpolation_factor = 3;

/// What the distance asks for is often more than the modes do: a pair is looked at while it asks for at most
/// so many times the largest degree.
constexpr double degrees_promised = 1.5;
/// A look at fewer degrees says little of a G that is small because the clusters are nearly in one plane.
constexpr int least_look = 6;
/// So many degrees are looked at beyond the one that the distance asks for.
constexpr int degrees_beyond = 2;

const std::array<Barycentric<double>, ClusterOutlines::samples>& sample_points() {
  static const std::array<Barycentric<double>, ClusterOutlines::samples> points{
      Barycentric<double>{{1, 0, 0}},
      Barycentric<double>{{0, 1, 0}},
      Barycentric<double>{{0, 0, 1}},
      Barycentric<double>{{0, 0.5, 0.5}},
      Barycentric<double>{{0.5, 0, 0.5}},
      Barycentric<double>{{0.5, 0.5, 0}},
      Barycentric<double>{{1.0 / 3, 1.0 / 3, 1.0 / 3}},
      Barycentric<double>{{0.625, 0.25, 0.125}}};
  return points;
}

/// What lies beyond the degrees that were looked at: a geometric series from the last two of them, with the
/// ratio of these to the two before, or the expected one where that is larger.
double beyond(const std::vector<double>& by_degree, double expected_ratio) {
  const std::size_t last = by_degree.size() - 1;
  const double now = by_degree[last] + by_degree[last - 1];
  const double before = last >= 3 ? by_degree[last - 2] + by_degree[last - 3] : now;
  constexpr double slowest = 0.9;
  const double ratio = std::min(slowest, std::max(expected_ratio, before > 0 ? std::sqrt(now / before) : 0));
  return now * ratio / (1 - ratio);
}

Vector<Pack> broadcast(const Vector<double>& v) { return {Pack(v.x), Pack(v.y), Pack(v.z)}; }

}  // namespace

ClusterOutlines::ClusterOutlines(const std::vector<Chart>& charts,
                                 const std::vector<ParameterTriangle>& clusters)
    : charts_(charts), clusters_(clusters) {
  points_.add(clusters.size() * samples);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const std::size_t first = i * samples;
    points_.place(first, charts[clusters[i].chart], clusters[i], sample_points());
    constexpr std::size_t centroid = 6;
    const Vector<double> centre = points_.point(first + centroid);
    double radius = 0;
    for (std::size_t q = 0; q < samples; ++q)
      radius = std::max(radius, norm(points_.point(first + q) - centre));
    centres_.push_back(centre);
    radii_.push_back(radius);
  }
}

double CouplingLook::rate(std::size_t a, std::size_t b) const {
  const double distance = norm(outlines_.centre(a) - outlines_.centre(b));
  const double x = (distance - outlines_.radius(b)) / outlines_.radius(a);
  return x > 1 ? x + std::sqrt(x * x - 1) : 1;
}

std::optional<int> CouplingLook::degree_by_distance(std::size_t a, std::size_t b) const {
  constexpr std::size_t samples = ClusterOutlines::samples;
  const ClusterPoints& points = outlines_.points();
  const double rho = std::min(rate(a, b), rate(b, a));
  constexpr double least_rate = 2;
  if (!(rho >= least_rate)) return std::nullopt;
  double largest = 0;
  for (std::size_t q = 0; q < samples; ++q) {
    const Vector<Pack> normal = broadcast(-points.normal(a * samples + q));
    const Vector<Pack> difference = broadcast(points.point(a * samples + q)) - points.points(b * samples);
    const Pack g = abs(kernel_terms<Pack>(difference, normal, points.normals(b * samples)).value());
    largest = std::max(largest, (g * points.weights(b * samples)).largest());
    largest = std::max(largest, (g * Pack(points.weight(a * samples + q))).largest());
  }
  const double size = 8 / (rho - 1) * largest / pi<double>() * demand_.functions_size;
  if (size <= demand_.share) return 0;
  const double degree = std::ceil(std::log(size / demand_.share) / std::log(rho));
  if (!(degree <= degrees_promised * demand_.largest_degree)) return std::nullopt;
  return std::min(demand_.largest_degree, static_cast<int>(degree));
}

void CouplingLook::look(std::size_t a, std::size_t b, int degree, Profile& profile) {
  const ModeTables& tables = ModeTables::instance();
  const ModeInterpolation& interpolation = tables.interpolation(degree);
  const std::size_t k = interpolation.nodes.size();
  nodes_.clear();
  nodes_.add(k);
  nodes_.place(0, outlines_.chart(a), outlines_.triangle(a), interpolation.nodes);
  constexpr std::size_t samples = ClusterOutlines::samples;
  const std::size_t seen = b * samples;
  const Vector<Pack> from = outlines_.points().points(seen);
  const Vector<Pack> normal = -outlines_.points().normals(seen);
  const Pack weight = outlines_.points().weights(seen);
  if (kernel_.size() < k) kernel_.resize(k);
  for (std::size_t i = 0; i < k; ++i)
    kernel_[i] =
        kernel_terms<Pack>(from - broadcast(nodes_.point(i)), normal, broadcast(nodes_.normal(i))).value();

  profile.as_target.assign(static_cast<std::size_t>(degree) + 1, 0);
  profile.as_source.assign(static_cast<std::size_t>(degree) + 1, 0);
  std::size_t n = 0;
  for (int m = 0; m <= degree; ++m) {
    Pack sizes(0.0);
    Pack target_squares(0.0);
    Pack squares(0.0);
    for (int i = 0; i <= m; ++i, ++n) {
      Pack target(0.0);
      Pack source(0.0);
      const double* row = interpolation.values_of_modes_transposed.column(n).data();
      for (std::size_t node = 0; node < k; ++node) {
        const Pack factor(row[node]);
        target = fma(factor, kernel_[node], target);
        source = fma(factor * Pack(nodes_.weight(node)), kernel_[node], source);
      }
      sizes += abs(target) * Pack(tables.largest_value(n));
      target_squares += target * target;
      squares += source * source;
    }
    const Pack by_squares = Pack(std::pow(m + 1, 1.5)) * sqrt(target_squares);
    profile.as_target[static_cast<std::size_t>(m)] = (min(sizes, by_squares) * weight).sum() / samples;
    profile.as_source[static_cast<std::size_t>(m)] = std::sqrt(squares.largest());
  }
}

std::optional<CouplingDegree> CouplingLook::operator()(std::size_t a, std::size_t b) {
  const std::optional<int> first = degree_by_distance(a, b);
  if (!first) return std::nullopt;
  const double ratio = 1 / std::min(rate(a, b), rate(b, a));
  const double factor = interpolation_factor * demand_.functions_size / pi<double>();
  const int most = demand_.largest_degree + degrees_beyond;
  constexpr int step = 3;
  for (int degree = std::clamp(*first + degrees_beyond, least_look, most);;
       degree = std::min(degree + step, most)) {
    look(a, b, degree, in_a_);
    look(b, a, degree, in_b_);
    const auto last = static_cast<std::size_t>(degree);
    std::optional<CouplingDegree> best;
    double target_a = beyond(in_a_.as_target, ratio);
    double target_b = beyond(in_b_.as_target, ratio);
    double source_a = std::pow(beyond(in_a_.as_source, ratio), 2);
    double source_b = std::pow(beyond(in_b_.as_source, ratio), 2);
    for (std::size_t p = last; p-- > 0;) {
      target_a += in_a_.as_target[p + 1];
      target_b += in_b_.as_target[p + 1];
      source_a += std::pow(in_a_.as_source[p + 1], 2);
      source_b += std::pow(in_b_.as_source[p + 1], 2);
      const CouplingDegree found{.degree = static_cast<int>(p),
                                 .error_a = factor * (target_a + std::sqrt(source_b)),
                                 .error_b = factor * (target_b + std::sqrt(source_a))};
      if (!(std::max(found.error_a, found.error_b) <= demand_.share)) break;
      if (found.degree <= demand_.largest_degree && p + degrees_beyond <= last) best = found;
    }
    if (best || degree == most) return best;
  }
}

}  // namespace radcert
