// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/edge/corner_exponent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int fewer_nodes = 41;
constexpr int more_nodes = 57;

/// A node of an arc between two axes: sines of its angle and of what is left to the right angle.
struct ArcNode {
  double sine;
  double cosine;
  double weight;
};

/// Tanh-sinh nodes on [0, pi/2]: the kernel is homogeneous at both ends, and these are dense there.
std::vector<ArcNode> arc_nodes(int count) {
  constexpr double reach = 2.6;
  const double step = 2 * reach / (count - 1);
  std::vector<ArcNode> nodes;
  for (int i = 0; i < count; ++i) {
    const double x = -reach + step * i;
    const double u = pi / 2 * std::sinh(x);
    const double low = 1 / (1 + std::exp(-2 * u));
    const double high = 1 / (1 + std::exp(2 * u));
    const double weight = pi / 2 * 2 * low * high * (pi / 2 * std::cosh(x)) * step;
    nodes.push_back({std::sin(pi / 2 * low), std::sin(pi / 2 * high), weight});
  }
  return nodes;
}

/// Int_0^inf R^(g+2)/(1 + R^2 - 2 R cos(a))^2 dR.
double radial_integral(double g, double sine, double cosine) {
  const double rest = pi - std::atan2(sine, cosine);
  const double power = 1 + g;
  const double slope =
      (-power * std::cos(power * rest) * sine - std::sin(power * rest) * cosine) / (sine * sine);
  return pi / (2 * std::sin(pi * g) * sine) * slope;
}

/// Of the direction (cos p, sin p) on a face: what the two others send to it, by the nodes. The face after it
/// has the direction (cos q, sin q) from the axis that p turns to, the one before it ends where p begins.
struct FaceKernels {
  std::vector<double> from_next;
  std::vector<double> from_previous;
};

FaceKernels kernels(const std::vector<ArcNode>& nodes, double g) {
  FaceKernels out;
  for (const ArcNode& p : nodes)
    for (const ArcNode& q : nodes) {
      // sin^2(a) without cancellation where the directions meet.
      const double next_sine = std::hypot(p.cosine, p.sine * q.sine);
      out.from_next.push_back(q.weight / pi * p.cosine * q.sine *
                              radial_integral(g, next_sine, p.sine * q.cosine));
      const double previous_sine = std::hypot(p.sine, p.cosine * q.cosine);
      out.from_previous.push_back(q.weight / pi * p.sine * q.cosine *
                                  radial_integral(g, previous_sine, p.cosine * q.sine));
    }
  return out;
}

double spectral_radius(const std::array<double, 3>& rho, double g, int count) {
  const std::vector<ArcNode> nodes = arc_nodes(count);
  const FaceKernels k = kernels(nodes, g);
  const std::size_t n = nodes.size();
  std::array<std::vector<double>, 3> f;
  f.fill(std::vector<double>(n, 1));
  double radius = 0;
  constexpr int iterations = 120;
  for (int step = 0; step < iterations; ++step) {
    std::array<std::vector<double>, 3> image;
    double largest = 0;
    for (std::size_t face = 0; face < 3; ++face) {
      const std::vector<double>& next = f.at((face + 1) % 3);
      const std::vector<double>& previous = f.at((face + 2) % 3);
      std::vector<double>& out = image.at(face);
      out.assign(n, 0);
      for (std::size_t i = 0; i < n; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < n; ++j)
          sum += k.from_next[i * n + j] * next[j] + k.from_previous[i * n + j] * previous[j];
        out[i] = rho.at(face) * sum;
        largest = std::max(largest, out[i]);
      }
    }
    // Two steps at once: with a black face the eigenvalue of the largest modulus comes with its opposite.
    const double before = radius;
    radius = largest;
    if (largest <= 0) return 0;
    for (auto& values : image)
      for (double& value : values) value /= largest;
    f = std::move(image);
    if (step + 1 == iterations) return std::sqrt(before * radius);
  }
  return radius;
}

void require(const std::array<double, 3>& rho) {
  for (const double r : rho) expects(r >= 0 && r < 1, "reflectivities in [0, 1)", named("reflectivity", r));
}

double exponent(const std::array<double, 3>& rho, int count) {
  double low = 1e-3;
  double high = 1 - 1e-3;
  if (spectral_radius(rho, high, count) <= 1) return 1;
  if (spectral_radius(rho, low, count) >= 1) return low;
  constexpr int halvings = 40;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (spectral_radius(rho, middle, count) >= 1 ? high : low) = middle;
  }
  return (low + high) / 2;
}

Approximation estimated(double value, double other) {
  // What a quarter fewer nodes change, and the power iteration.
  return {.value = value, .radius = 2 * std::abs(value - other) + 1e-6 * value};
}

}  // namespace

Approximation octant_spectral_radius(const std::array<double, 3>& reflectivities, double g) {
  require(reflectivities);
  expects(g > 0 && g < 1, "0 < g < 1", named("g", g));
  return estimated(spectral_radius(reflectivities, g, more_nodes),
                   spectral_radius(reflectivities, g, fewer_nodes));
}

Approximation octant_exponent(const std::array<double, 3>& reflectivities) {
  require(reflectivities);
  return estimated(exponent(reflectivities, more_nodes), exponent(reflectivities, fewer_nodes));
}

}  // namespace radcert
