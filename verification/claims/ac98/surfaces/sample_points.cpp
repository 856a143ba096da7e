// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/sample_points.h"

#include <random>

#include "radcert/polynomial/inset_basis.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert::verification::ac98 {

std::vector<SurfacePoint<double>> collocation_points(const Surface& surface, int level,
                                                     const Rational& inset) {
  std::vector<SurfacePoint<double>> points;
  const InsetBasis<double> basis(1, inset.to_double());
  for (const ParameterTriangle& triangle : triangulate(surface, level).triangles)
    for (const Barycentric<double>& node : basis.nodes())
      points.push_back({triangle.chart, triangle.at(node.x)});
  return points;
}

std::vector<SurfacePoint<double>> random_points(const Surface& surface, std::size_t per_chart,
                                                std::uint64_t seed) {
  std::mt19937_64 stream(seed);
  const auto uniform = [&] { return static_cast<double>(stream() >> 11) * 0x1p-53; };
  std::vector<SurfacePoint<double>> points;
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart) {
    const bool triangle = surface.charts[chart].facts().domain == ChartDomain::unit_triangle;
    for (std::size_t i = 0; i < per_chart; ++i) {
      double s = uniform();
      double t = uniform();
      if (i % 3 == 0) s *= 0.05;
      if (triangle && s + t > 1) {
        s = 1 - s;
        t = 1 - t;
      }
      constexpr double border = 0.01;
      const double largest = triangle ? 1 - 3 * border : 1 - 2 * border;
      points.push_back({chart, {border + largest * s, border + largest * t}});
    }
  }
  return points;
}

Vector<Rational> sphere_point(const Rational& u, const Rational& v) {
  const Rational inverse = 1 / (1 + u * u + v * v);
  return {2 * u * inverse, 2 * v * inverse, (1 - u * u - v * v) * inverse};
}

}  // namespace radcert::verification::ac98
