// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_points.h"

#include <algorithm>
#include <cmath>

namespace radcert {

void ClusterPoints::resize(std::size_t size) {
  for (std::vector<double>* each : {&x_, &y_, &z_, &normal_x_, &normal_y_, &normal_z_, &weight_})
    each->resize(size);
}

std::size_t ClusterPoints::add(std::size_t count) {
  const std::size_t first = size();
  resize(first + padded<double>(count));
  return first;
}

double parameter_area(const ParameterTriangle& triangle) {
  const ParameterPoint<double> a = triangle.vertices[1] - triangle.vertices[0];
  const ParameterPoint<double> b = triangle.vertices[2] - triangle.vertices[0];
  return std::abs(a.s * b.t - a.t * b.s) / 2;
}

void ClusterPoints::place(std::size_t first, const Chart& chart, const ParameterTriangle& cluster,
                          std::span<const Barycentric<double>> points) {
  const ChartIn<Pack>& formula = chart.in<Pack>();
  const double area = parameter_area(cluster);
  for (std::size_t block = 0; block < points.size(); block += Pack::lanes) {
    ParameterPoint<Pack> at;
    for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
      const ParameterPoint<double> p = cluster.at(points[std::min(block + lane, points.size() - 1)].x);
      at.s.set_lane(lane, p.s);
      at.t.set_lane(lane, p.t);
    }
    const Frame<Pack> frame = formula.frame(at);
    const Vector<Pack>& n = frame.area_normal;
    const Pack element = sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    const std::size_t place = first + block;
    frame.point.x.store(&x_[place]);
    frame.point.y.store(&y_[place]);
    frame.point.z.store(&z_[place]);
    (n.x / element).store(&normal_x_[place]);
    (n.y / element).store(&normal_y_[place]);
    (n.z / element).store(&normal_z_[place]);
    (Pack(area) * element).store(&weight_[place]);
    for (std::size_t lane = 0; lane < Pack::lanes; ++lane)
      if (block + lane >= points.size()) weight_[place + lane] = 0;
  }
}

}  // namespace radcert
