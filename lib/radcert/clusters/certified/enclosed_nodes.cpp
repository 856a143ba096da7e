// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/enclosed_nodes.h"

#include "radcert/clusters/certified/interpolation_bounds.h"

namespace radcert {

std::array<ParameterPoint<Ball>, 3> vertices_of(const ParameterTriangle& triangle) {
  std::array<ParameterPoint<Ball>, 3> v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = {Ball(triangle.vertices[i].s), Ball(triangle.vertices[i].t)};
  return v;
}

Ball area_of(const std::array<ParameterPoint<Ball>, 3>& vertices) {
  return abs(cross(vertices[1] - vertices[0], vertices[2] - vertices[0])) / Ball(2);
}

std::vector<EnclosedNode> enclosed_nodes(const Chart& chart, const ParameterTriangle& triangle, int degree) {
  const std::array<ParameterPoint<Ball>, 3> v = vertices_of(triangle);
  const ParameterPoint<Ball> first = v[1] - v[0];
  const ParameterPoint<Ball> second = v[2] - v[0];
  const Ball area = area_of(v);
  std::vector<EnclosedNode> nodes;
  for (const ParameterPoint<double>& x : exact_interpolation_nodes(degree)) {
    Frame<Ball> frame = chart.in<Ball>().frame(v[0] + Ball(x.s) * first + Ball(x.t) * second);
    Ball weight = area * area_element(frame);
    nodes.push_back({std::move(frame), std::move(weight)});
  }
  return nodes;
}

}  // namespace radcert
