// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "tests/galerkin/setting.h"

namespace radcert {
namespace {

TEST(LocalFunctions, AreOrthonormalWithTheirWeight) {
  const SurfaceWeight weight = [](std::size_t, const Vector<double>& p) { return 1 / (0.5 + p.x / 4); };
  for (int degree = 0; degree <= 4; ++degree) {
    const GalerkinSetting setting(ellipsoid(1, 1, 1), 1, degree, weight);
    const TriangleRule<double> rule = conical_rule<double>(24, Grading::none);
    for (std::size_t k = 0; k < setting.functions.elements(); k += 7) {
      const ParameterTriangle& triangle = setting.triangulation.triangles[k];
      const auto& v = triangle.vertices;
      const ChartIn<double>& chart = setting.surface.charts[triangle.chart].in<double>();
      const std::size_t p = setting.functions.functions();
      Matrix<double> mass(p, p);
      for (std::size_t q = 0; q < rule.weights.size(); ++q) {
        const Frame<double> frame = chart.frame(triangle.at(rule.points[q].x));
        const double w = rule.weights[q] * cross(v[1] - v[0], v[2] - v[0]) * area_element(frame) *
                         weight(triangle.chart, frame.point);
        const std::vector<double> psi = setting.at(k, rule.points[q]);
        for (std::size_t a = 0; a < p; ++a)
          for (std::size_t b = 0; b < p; ++b) mass(a, b) += w * psi[a] * psi[b];
      }
      for (std::size_t a = 0; a < p; ++a)
        for (std::size_t b = 0; b < p; ++b)
          EXPECT_NEAR(mass(a, b), a == b ? 1 : 0, setting.functions.defect(k) + 1e-13)
              << "degree " << degree << " element " << k;
      EXPECT_LT(setting.functions.defect(k), 1e-5);
    }
  }
}

TEST(LocalFunctions, SpanThePolynomialsOfTheirDegree) {
  // The projection of a polynomial of the parameters, here of the coordinates of a plane, is itself.
  const auto f = [](const Vector<double>& p) { return 1 + p.x - 2 * p.y * p.z + p.x * p.x; };
  const GalerkinSetting setting(cube(), 1, 2);
  const std::vector<double> x = setting.moments(f);
  const Barycentric<double> at{{0.25, 0.125, 0.625}};
  for (std::size_t k = 0; k < setting.functions.elements(); ++k) {
    const std::vector<double> psi = setting.at(k, at);
    double sum = 0;
    for (std::size_t a = 0; a < psi.size(); ++a) sum += x[k * psi.size() + a] * psi[a];
    const ParameterTriangle& triangle = setting.triangulation.triangles[k];
    const Vector<double> p =
        setting.surface.charts[triangle.chart].in<double>().frame(triangle.at(at.x)).point;
    EXPECT_NEAR(sum, f(p), 1e-12) << k;
  }
}

}  // namespace
}  // namespace radcert
