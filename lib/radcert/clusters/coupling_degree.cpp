// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/coupling_degree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "radcert/clusters/mode_tables.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/triangle_modes.h"

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

/// A geometric series from the last two terms, with the ratio of these to the two before, or the expected one
/// where that is larger.
double series_beyond(double last, double before_last, double before, double first, double expected_ratio) {
  const double now = last + before_last;
  const double earlier = before + first;
  constexpr double slowest = 0.9;
  const double ratio =
      std::min(slowest, std::max(expected_ratio, earlier > 0 ? std::sqrt(now / earlier) : 0));
  return now * ratio / (1 - ratio);
}

/// A mode of what is seen of a cluster, as a target's and as a source's.
struct ModeSums {
  Pack target{0.0};
  Pack source{0.0};
};

std::pair<ModeSums, ModeSums> mode_sums(const double* row, const double* next_row, const Pack* kernel,
                                        const Pack* weighted, std::size_t nodes) {
  ModeSums one;
  ModeSums other;
  for (std::size_t node = 0; node < nodes; ++node) {
    const Pack factor(row[node]);
    const Pack next_factor(next_row[node]);
    one.target = fma(factor, kernel[node], one.target);
    one.source = fma(factor, weighted[node], one.source);
    other.target = fma(next_factor, kernel[node], other.target);
    other.source = fma(next_factor, weighted[node], other.source);
  }
  return {one, other};
}

std::vector<std::uint32_t> numbers_below(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

Vector<Pack> broadcast(const Vector<double>& v) { return {Pack(v.x), Pack(v.y), Pack(v.z)}; }

}  // namespace

ModeSizes::ModeSizes(std::span<const Barycentric<double>> points)
    : of_mode(mode_count(largest_mode_degree), 0.0), of_degree(largest_mode_degree + 1, 0.0) {
  std::vector<double> modes(of_mode.size());
  const auto take = [&](const Barycentric<double>& x) {
    triangle_modes<double>(largest_mode_degree, x, modes);
    for (std::size_t m = 0, n = 0; m < of_degree.size(); ++m) {
      double squares = 0;
      for (std::size_t i = 0; i <= m; ++i, ++n) {
        of_mode[n] = std::max(of_mode[n], std::abs(modes[n]));
        squares += modes[n] * modes[n];
      }
      of_degree[m] = std::max(of_degree[m], std::sqrt(squares));
    }
  };
  for (const Barycentric<double>& x : points) take(x);
  if (!points.empty()) return;
  constexpr int lattice = 40;
  for (int a = 0; a <= lattice; ++a)
    for (int b = 0; a + b <= lattice; ++b)
      take({{double(a) / lattice, double(b) / lattice, double(lattice - a - b) / lattice}});
}

ClusterOutlines::ClusterOutlines(const std::vector<Chart>& charts,
                                 const std::vector<ParameterTriangle>& clusters)
    : ClusterOutlines(charts, clusters, numbers_below(clusters.size())) {}

ClusterOutlines::ClusterOutlines(const std::vector<Chart>& charts,
                                 const std::vector<ParameterTriangle>& clusters,
                                 std::span<const std::uint32_t> wanted)
    : charts_(charts), clusters_(clusters), place_(clusters.size()) {
  points_.add(wanted.size() * samples);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const ParameterTriangle& cluster = clusters[wanted[i]];
    place_[wanted[i]] = static_cast<std::uint32_t>(i);
    const std::size_t first = i * samples;
    points_.place(first, charts[cluster.chart], cluster, sample_points());
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
  const std::size_t first_a = outlines_.first(a);
  const std::size_t first_b = outlines_.first(b);
  const double rho = std::min(rate(a, b), rate(b, a));
  constexpr double least_rate = 2;
  if (!(rho >= least_rate)) return std::nullopt;
  double largest = 0;
  for (std::size_t q = 0; q < samples; ++q) {
    const Vector<Pack> normal = broadcast(-points.normal(first_a + q));
    const Vector<Pack> difference = broadcast(points.point(first_a + q)) - points.points(first_b);
    const Pack g = abs(kernel_terms<Pack>(difference, normal, points.normals(first_b)).value());
    largest = std::max(largest, (g * points.weights(first_b)).largest());
    largest = std::max(largest, (g * Pack(points.weight(first_a + q))).largest());
  }
  const double size = 8 / (rho - 1) * largest / pi<double>() * demand_.functions_size;
  if (size <= demand_.share) return 0;
  const double degree = std::ceil(std::log(size / demand_.share) / std::log(rho));
  if (!(degree <= degrees_promised * demand_.largest_degree)) return std::nullopt;
  return std::min(demand_.largest_degree, static_cast<int>(degree));
}

void CouplingLook::look(std::size_t a, std::size_t b, int degree, View& view) const {
  const ModeInterpolation& interpolation = ModeTables::instance().interpolation(degree);
  const std::size_t k = interpolation.nodes.size();
  view.nodes.clear();
  view.nodes.add(k);
  view.nodes.place(0, outlines_.chart(a), outlines_.triangle(a), interpolation.nodes);
  const std::size_t seen = outlines_.first(b);
  const Vector<Pack> from = outlines_.points().points(seen);
  const Vector<Pack> normal = -outlines_.points().normals(seen);
  view.weight = outlines_.points().weights(seen);
  if (view.kernel.size() < k) {
    view.kernel.resize(k);
    view.weighted.resize(k);
  }
  for (std::size_t i = 0; i < k; ++i) {
    view.kernel[i] =
        kernel_terms<Pack>(from - broadcast(view.nodes.point(i)), normal, broadcast(view.nodes.normal(i)))
            .value();
    view.weighted[i] = Pack(view.nodes.weight(i)) * view.kernel[i];
  }
  view.degree = degree;
  view.by_degree.assign(static_cast<std::size_t>(degree) + 1, std::nullopt);
}

const CouplingLook::Contribution& CouplingLook::contribution(View& view, std::size_t degree) const {
  std::optional<Contribution>& known = view.by_degree[degree];
  if (known) return *known;
  const ModeInterpolation& interpolation = ModeTables::instance().interpolation(view.degree);
  const std::size_t k = interpolation.nodes.size();
  Pack sizes(0.0);
  Pack target_squares(0.0);
  Pack squares(0.0);
  const auto add = [&](const ModeSums& mode, std::size_t n) {
    sizes += abs(mode.target) * Pack(sizes_.of_mode[n]);
    target_squares += mode.target * mode.target;
    squares += mode.source * mode.source;
  };
  const auto row = [&](std::size_t n) { return interpolation.values_of_modes_transposed.column(n).data(); };
  const std::size_t first = degree * (degree + 1) / 2;
  const std::size_t end = first + degree + 1;
  for (std::size_t n = first; n < end; n += 2) {
    // Two modes at a time, lest each sum wait for its last term.
    const std::size_t next = std::min(n + 1, end - 1);
    const auto [one, other] = mode_sums(row(n), row(next), view.kernel.data(), view.weighted.data(), k);
    add(one, n);
    if (next > n) add(other, next);
  }
  const Pack by_squares = Pack(sizes_.of_degree[degree]) * sqrt(target_squares);
  constexpr double samples = ClusterOutlines::samples;
  return known.emplace(Contribution{.as_target = (min(sizes, by_squares) * view.weight).sum() / samples,
                                    .as_source = std::sqrt(squares.largest())});
}

CouplingLook::Contribution CouplingLook::beyond(View& view, double expected_ratio) const {
  const std::size_t last = view.by_degree.size() - 1;
  const auto of = [&](double Contribution::*which) {
    return series_beyond(contribution(view, last).*which, contribution(view, last - 1).*which,
                         contribution(view, last - 2).*which, contribution(view, last - 3).*which,
                         expected_ratio);
  };
  return {.as_target = of(&Contribution::as_target), .as_source = of(&Contribution::as_source)};
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
    const Contribution rest_a = beyond(in_a_, ratio);
    const Contribution rest_b = beyond(in_b_, ratio);
    double target_a = rest_a.as_target;
    double target_b = rest_b.as_target;
    double source_a = std::pow(rest_a.as_source, 2);
    double source_b = std::pow(rest_b.as_source, 2);
    for (std::size_t p = last; p-- > 0;) {
      const Contribution& left_a = contribution(in_a_, p + 1);
      const Contribution& left_b = contribution(in_b_, p + 1);
      target_a += left_a.as_target;
      target_b += left_b.as_target;
      source_a += std::pow(left_a.as_source, 2);
      source_b += std::pow(left_b.as_source, 2);
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
