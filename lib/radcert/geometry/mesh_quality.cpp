// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

/// Of the largest coordinate: products of lengths stay within double when it is taken out.
int exponent_of(const TriangleMesh& mesh) {
  double largest = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    for (const Vector<double>& v : mesh.corners(k))
      largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? std::clamp(std::ilogb(largest), -1000, 1000) : 0;
}

}  // namespace

MeshQuality mesh_quality(const TriangleMesh& mesh) {
  expects(!mesh.triangles.empty(), "at least one triangle");
  MeshQuality quality;
  quality.shortest_side = std::numeric_limits<double>::infinity();
  const int exponent = exponent_of(mesh);
  const double scale = std::ldexp(1.0, -exponent);
  Vector<double> low = scale * mesh.corners(0)[0];
  Vector<double> high = low;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    std::array<Vector<double>, 3> corners = mesh.corners(k);
    for (Vector<double>& corner : corners) corner = scale * corner;
    std::array<Vector<double>, 3> side;
    std::array<double, 3> length;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<double>& v = corners[i];
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
      side[i] = corners[(i + 1) % 3] - v;
      length[i] = norm(side[i]);
      quality.shortest_side = std::min(quality.shortest_side, length[i]);
      quality.longest_side = std::max(quality.longest_side, length[i]);
    }
    const double doubled_area = norm(cross(side[0], side[1]));
    quality.area += doubled_area / 2;
    if (doubled_area == 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle =
          std::atan2(doubled_area, -dot(side[i], side[(i + 2) % 3])) * 180 / std::numbers::pi;
      quality.smallest_angle = std::min(quality.smallest_angle, angle);
      quality.largest_angle = std::max(quality.largest_angle, angle);
    }
    const double inscribed = doubled_area / (length[0] + length[1] + length[2]);
    const double aspect = std::max({length[0], length[1], length[2]}) / (2 * std::numbers::sqrt3 * inscribed);
    if (aspect > quality.largest_aspect) {
      quality.largest_aspect = aspect;
      quality.worst_triangle = k;
    }
  }
  quality.diagonal = norm(high - low);
  for (double* length : {&quality.shortest_side, &quality.longest_side, &quality.diagonal})
    *length = std::ldexp(*length, exponent);
  quality.area = std::ldexp(quality.area, 2 * exponent);
  return quality;
}

}  // namespace radcert
