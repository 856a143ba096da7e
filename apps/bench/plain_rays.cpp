// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace radcert::bench {
namespace {

using Point = Vector<double>;

struct Triangle {
  Point corner;
  Point first;  ///< from the corner to the others
  Point second;
  std::size_t group;
};

/// The distance along a ray, or infinity.
double distance_along(const Triangle& triangle, const Point& eye, const Point& step) {
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  const Point across = cross(step, triangle.second);
  const double determinant = dot(triangle.first, across);
  if (determinant == 0) return nowhere;
  const Point from_corner = eye - triangle.corner;
  const double u = dot(from_corner, across) / determinant;
  if (u < 0 || u > 1) return nowhere;
  const Point other = cross(from_corner, triangle.first);
  const double v = dot(step, other) / determinant;
  if (v < 0 || u + v > 1) return nowhere;
  const double distance = dot(triangle.second, other) / determinant;
  return distance > 1e-9 ? distance : nowhere;
}

}  // namespace

PlainRow plain_factor_row(const TriangleMesh& mesh, std::size_t group, std::size_t rays) {
  std::vector<Triangle> triangles;
  std::vector<std::size_t> members;
  std::vector<double> areas;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto c = mesh.corners(k);
    triangles.push_back({c[0], c[1] - c[0], c[2] - c[0], mesh.group[k]});
    if (mesh.group[k] != group) continue;
    members.push_back(k);
    areas.push_back(norm(cross(triangles[k].first, triangles[k].second)));
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(0, 1);
  std::discrete_distribution<std::size_t> member(areas.begin(), areas.end());
  std::vector<std::size_t> hits(mesh.group_names.size(), 0);
  for (std::size_t ray = 0; ray < rays; ++ray) {
    const Triangle& from = triangles[members[member(random)]];
    const double root = std::sqrt(number(random));
    const double part = number(random);
    const Point eye = from.corner + (root * (1 - part)) * from.first + (root * part) * from.second;
    const Point outward = cross(from.first, from.second);
    const Point normal = (1 / norm(outward)) * outward;
    const Point side = (1 / norm(from.first)) * from.first;
    const double angle = 2 * std::numbers::pi * number(random);
    const double sine = std::sqrt(number(random));
    const Point step = (sine * std::cos(angle)) * side + (sine * std::sin(angle)) * cross(normal, side) +
                       std::sqrt(1 - sine * sine) * normal;
    double nearest = std::numeric_limits<double>::infinity();
    const Triangle* met = nullptr;
    for (const Triangle& triangle : triangles) {
      const double distance = distance_along(triangle, eye, step);
      if (distance < nearest) {
        nearest = distance;
        met = &triangle;
      }
    }
    if (met != nullptr && dot(cross(met->first, met->second), step) < 0) ++hits[met->group];
  }
  PlainRow row;
  for (const std::size_t count : hits) {
    const double share = static_cast<double>(count) / static_cast<double>(rays);
    row.factors.push_back(share);
    row.errors.push_back(std::sqrt(share * (1 - share) / static_cast<double>(rays)));
  }
  return row;
}

}  // namespace radcert::bench
