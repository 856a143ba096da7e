// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"

namespace radcert {

/// A point together with a direction.
/// Maths     p = (p^, p->), a point of space and a unit vector, in Gamma = R^3 x S^2
/// Source    [psg10, section III]
/// Requires  normal has length 1, up to rounding
/// Result    plain data; a site of a surface has the inner normal there
/// Limits    two sites may share a point: those of both sides of an edge
template <Field R>
struct Site {
  Vector<R> point;
  Vector<R> normal;
};

/// The site of a surface at parameters of a chart.
template <Real R>
Site<R> site_at(const Surface& surface, const SurfacePoint<R>& at) {
  const Frame<R> frame = surface.charts[at.chart].template in<R>().frame(at.at);
  return {frame.point, unit_normal(frame)};
}

/// Sites of one surface, array by array.
/// Maths     P = (p_1, ..., p_n)
/// Source    [psg10, section V], the element centroids
/// Requires  arrays of the same length
/// Result    plain data; at[i] names the chart and the parameters of which points[i], normals[i] are the
///           rounded images
struct SiteSet {
  std::vector<Vector<double>> points;
  std::vector<Vector<double>> normals;
  std::vector<SurfacePoint<double>> at;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] Site<double> operator[](std::size_t i) const { return {points[i], normals[i]}; }
  void add(const Site<double>& site, const SurfacePoint<double>& where) {
    points.push_back(site.point);
    normals.push_back(site.normal);
    at.push_back(where);
  }
};

}  // namespace radcert
