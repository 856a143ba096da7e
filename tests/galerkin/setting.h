// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "radcert/galerkin/galerkin_matrix.h"
#include "radcert/polynomial/rules/conical_rule.h"

namespace radcert {

/// A triangulated surface with the orthonormal functions of a degree on it.
struct GalerkinSetting {
  Surface surface;
  Triangulation triangulation;
  LocalFunctions functions;

  GalerkinSetting(
      Surface s, int level, int degree,
      const SurfaceWeight& weight = [](std::size_t, const Vector<double>&) { return 1.0; })
      : surface(std::move(s)),
        triangulation(triangulate(surface, level)),
        functions(surface, triangulation, InsetBasis<double>(degree, 0.5 / (degree + 2)), weight) {}

  GalerkinMatrix matrix(double tolerance) const {
    return galerkin_matrix(PairIntegrals(surface, triangulation, functions, tolerance), functions.functions(),
                           std::vector<bool>(functions.elements(), true));
  }

  /// psi_a of an element at a point of it.
  std::vector<double> at(std::size_t element, const Barycentric<double>& x) const {
    const std::size_t p = functions.functions();
    std::vector<double> l(p);
    functions.basis().values(x, l);
    std::vector<double> psi(p);
    for (std::size_t a = 0; a < p; ++a)
      for (std::size_t c = 0; c < p; ++c) psi[a] += functions.coefficients(element)(a, c) * l[c];
    return psi;
  }

  /// Int f psi_a dS over all elements, by a rule of high order; f takes the point.
  template <class Function>
  std::vector<double> moments(const Function& f, int order = 20) const {
    const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
    std::vector<double> out;
    for (std::size_t k = 0; k < functions.elements(); ++k) {
      const ParameterTriangle& triangle = triangulation.triangles[k];
      const auto& v = triangle.vertices;
      const ChartIn<double>& chart = surface.charts[triangle.chart].in<double>();
      std::vector<double> sums(functions.functions());
      for (std::size_t q = 0; q < rule.weights.size(); ++q) {
        const Frame<double> frame = chart.frame(triangle.at(rule.points[q].x));
        const double weight =
            rule.weights[q] * cross(v[1] - v[0], v[2] - v[0]) * area_element(frame) * f(frame.point);
        const std::vector<double> psi = at(k, rule.points[q]);
        for (std::size_t a = 0; a < sums.size(); ++a) sums[a] += weight * psi[a];
      }
      out.insert(out.end(), sums.begin(), sums.end());
    }
    return out;
  }
};

}  // namespace radcert
