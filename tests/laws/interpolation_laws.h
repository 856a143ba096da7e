// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "radcert/triangulation/interpolated_surface.h"
#include "tests/laws/surface_laws.h"

namespace radcert::laws {

/// What an interpolated element differs by from the element: the errors (87), (88) and (90) of [ac98] over a
/// sample of it, derivatives with respect to the element's own barycentric coordinates.
struct InterpolationError {
  double point = 0;
  double derivative = 0;
  double normal = 0;
};

inline InterpolationError interpolation_error(const Surface& surface, const Triangulation& triangulation,
                                              const InterpolatedSurface& interpolant) {
  InterpolationError largest;
  for (std::size_t k = 0; k < triangulation.triangles.size(); ++k) {
    const ParameterTriangle& element = triangulation.triangles[k];
    const ParameterTriangle& image = interpolant.triangulation.triangles[k];
    const ChartIn<double>& chart = surface.charts[element.chart].in<double>();
    const ChartIn<double>& other = interpolant.surface.charts[image.chart].in<double>();
    for (const ParameterPoint<double>& at : points_of_the_domain(ChartDomain::unit_triangle)) {
      const std::array<double, 3> x{1 - at.s - at.t, at.s, at.t};
      const Frame<double> f = chart.frame(element.at(x));
      const Frame<double> g = other.frame(image.at(x));
      largest.point = std::max(largest.point, norm(f.point - g.point));
      for (const std::size_t i : {1U, 2U}) {
        const auto along = [&](const Frame<double>& frame, const ParameterTriangle& triangle) {
          const ParameterPoint<double> w = triangle.vertices[i] - triangle.vertices[0];
          return w.s * frame.tangent_s + w.t * frame.tangent_t;
        };
        largest.derivative = std::max(largest.derivative, norm(along(f, element) - along(g, image)));
      }
      largest.normal = std::max(largest.normal, norm(unit_normal(f) - unit_normal(g)));
    }
  }
  return largest;
}

/// The interpolant is the surface itself: points, derivatives and normals agree up to rounding.
inline ::testing::AssertionResult is_its_own_interpolant(const Surface& surface,
                                                         const Triangulation& triangulation, int degree,
                                                         double tolerance) {
  const InterpolationError error =
      interpolation_error(surface, triangulation, interpolate(surface, triangulation, degree));
  if (error.point <= tolerance && error.derivative <= tolerance && error.normal <= tolerance)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << surface.name << ", degree " << degree << ": points differ by " << error.point
         << ", derivatives by " << error.derivative << ", normals by " << error.normal;
}

/// The interpolant agrees with the surface on the lattice of each element, corners and sides with it.
inline ::testing::AssertionResult interpolates_on_the_lattice(const Surface& surface,
                                                              const Triangulation& triangulation, int degree,
                                                              double tolerance) {
  const InterpolatedSurface interpolant = interpolate(surface, triangulation, degree);
  if (interpolant.triangulation.triangles.size() != triangulation.triangles.size())
    return ::testing::AssertionFailure() << interpolant.triangulation.triangles.size() << " elements";
  for (std::size_t k = 0; k < triangulation.triangles.size(); ++k) {
    const ParameterTriangle& element = triangulation.triangles[k];
    const ParameterTriangle& image = interpolant.triangulation.triangles[k];
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b) {
        const double s = static_cast<double>(a) / degree;
        const double t = static_cast<double>(b) / degree;
        const std::array<double, 3> x{1 - s - t, s, t};
        const Vector<double> p = surface.charts[element.chart].in<double>().frame(element.at(x)).point;
        const Vector<double> q =
            interpolant.surface.charts[image.chart].in<double>().frame(image.at(x)).point;
        if (!(norm(p - q) <= tolerance * (1 + norm(p))))
          return ::testing::AssertionFailure()
                 << surface.name << ", degree " << degree << ", element " << k << " is " << norm(p - q)
                 << " off at (" << a << ", " << b << ")";
      }
  }
  return ::testing::AssertionSuccess();
}

/// Elements that share two vertices in space share the side between them.
inline ::testing::AssertionResult joins_continuously(const InterpolatedSurface& interpolant,
                                                     double tolerance) {
  struct Side {
    Vector<double> from;
    Vector<double> to;
    std::array<Vector<double>, 5> between;
  };
  std::vector<Side> sides;
  for (const ParameterTriangle& element : interpolant.triangulation.triangles) {
    const ChartIn<double>& chart = interpolant.surface.charts[element.chart].in<double>();
    for (std::size_t i = 0; i < 3; ++i) {
      const ParameterPoint<double>& from = element.vertices[i];
      const ParameterPoint<double> along = element.vertices[(i + 1) % 3] - from;
      Side side{.from = chart.frame(from).point, .to = chart.frame(from + along).point, .between = {}};
      for (std::size_t j = 0; j < 5; ++j)
        side.between[j] = chart.frame(from + (static_cast<double>(j + 1) / 6) * along).point;
      sides.push_back(side);
    }
  }
  int shared = 0;
  for (const Side& a : sides)
    for (const Side& b : sides) {
      if (norm(a.from - b.to) > 1e-9 || norm(a.to - b.from) > 1e-9) continue;
      ++shared;
      for (std::size_t j = 0; j < 5; ++j)
        if (!(norm(a.between[j] - b.between[4 - j]) <= tolerance * (1 + norm(a.from))))
          return ::testing::AssertionFailure()
                 << interpolant.surface.name << ": a gap of " << norm(a.between[j] - b.between[4 - j]);
    }
  if (shared == 0) return ::testing::AssertionFailure() << "no two elements share a side";
  return ::testing::AssertionSuccess();
}

}  // namespace radcert::laws
