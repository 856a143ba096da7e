// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/sphere_over_disk/sums.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "radcert/core/contract.h"
#include "radcert/geometry/vector.h"

namespace radcert::verification::psg10 {
namespace {

std::vector<double> equally_spaced(double from, double to, int count, Spacing spacing) {
  std::vector<double> points;
  for (int i = 0; i < count; ++i) {
    const double share = spacing == Spacing::midpoints ? (i + 0.5) / count : i / (count - 1.0);
    points.push_back(from + (to - from) * share);
  }
  return points;
}

/// cos cos'/(pi d^2) between a point of the sphere and one of the disk; 0 where the sphere's point turns
/// away.
double form_factor(const SceneNumbers<double>& scene, double latitude, double azimuth, double distance) {
  const Vector<double> normal{std::cos(latitude) * std::cos(azimuth), std::cos(latitude) * std::sin(azimuth),
                              std::sin(latitude)};
  const Vector<double> on_sphere = Vector<double>{0, 0, scene.height} + scene.radius * normal;
  const Vector<double> to_disk = Vector<double>{distance, 0, 0} - on_sphere;
  const double square = dot(to_disk, to_disk);
  return std::max(0.0, dot(to_disk, normal)) * on_sphere.z / (std::numbers::pi * square * square);
}

double largest_change(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

SumSolution sum_solution(const SphereOverDiskScene& scene, const SumReading& reading, int iterations,
                         double tolerance) {
  expects(allows(scene), "a scene that allows() takes", named("radius", scene.radius));
  expects(std::min({reading.rings, reading.parallels, reading.azimuths}) >= 2, "at least 2 points each",
          named("rings", reading.rings), named("parallels", reading.parallels),
          named("azimuths", reading.azimuths));
  expects(iterations >= 1, "1 <= iterations", named("iterations", iterations));
  expects(tolerance >= 0, "0 <= tolerance", named("tolerance", tolerance));
  const SceneNumbers<double> numbers(scene);
  const double beta = numbers.albedo;
  constexpr double pi = std::numbers::pi;
  SumSolution out;
  out.latitudes = equally_spaced(-pi / 2, pi / 2, reading.parallels, reading.spacing);
  out.distances = equally_spaced(0, numbers.disk_radius, reading.rings, reading.spacing);
  const std::vector<double> azimuths = equally_spaced(0, 2 * pi, reading.azimuths, reading.spacing);
  const std::size_t m = out.latitudes.size();
  const std::size_t n = out.distances.size();

  // (20)
  std::vector<double> b_star;
  std::vector<double> d_star;
  for (const double zeta : out.latitudes)
    b_star.push_back(beta * numbers.intensity * std::max(0.0, std::sin(zeta)));
  for (const double u : out.distances) d_star.push_back(u >= numbers.radius ? beta * numbers.intensity : 0.0);

  // M and N of (24): M takes d to b, N takes b to d.
  std::vector<double> to_sphere(m * n);
  std::vector<double> to_disk(n * m);
  const double factor = reading.form_factor.to_double();
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      double sum = 0;
      for (const double tau : azimuths)
        sum += factor * form_factor(numbers, out.latitudes[i], tau, out.distances[j]);
      double from_disk = beta * sum;
      double from_sphere = beta * sum;
      if (reading.weights == SumWeights::of_the_sums) {
        const double turn = 2 * pi / reading.azimuths;
        from_disk *= turn * numbers.disk_radius / reading.rings * out.distances[j];
        from_sphere *=
            turn * pi / reading.parallels * numbers.radius * numbers.radius * std::cos(out.latitudes[i]);
      } else if (reading.weights == SumWeights::with_the_radii) {
        from_disk *= out.distances[j];
      }
      to_sphere[i * n + j] = from_disk;
      to_disk[j * m + i] = from_sphere;
    }

  out.sphere.assign(m, 0.0);
  out.disk.assign(n, 0.0);
  for (int step = 0; step < iterations; ++step) {
    std::vector<double> b = b_star;
    std::vector<double> d = d_star;
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        b[i] += to_sphere[i * n + j] * out.disk[j];
        d[j] += to_disk[j * m + i] * out.sphere[i];
      }
    out.changes.push_back(std::max(largest_change(b, out.sphere), largest_change(d, out.disk)));
    out.sphere = std::move(b);
    out.disk = std::move(d);
    if (out.changes.back() <= tolerance) break;
  }
  return out;
}

}  // namespace radcert::verification::psg10
