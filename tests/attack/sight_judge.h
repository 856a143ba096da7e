// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"
#include "tests/scalar/draw.h"

/// A judge of exchange areas with occlusion that knows triangles, planes through points and doubles, and
/// nothing of the library's occluders, bodies, cells or events: the flux of what points of a triangle see of
/// another, in closed form past all other triangles one by one, averaged over lattices of points, each
/// shifted at random. The shifts' spread says how far the mean may be off.
namespace radcert::attack {

struct SampledArea {
  double value = 0;
  double deviation = 0;  ///< of the mean, from the spread of the shifts
  double rounding = 0;   ///< of the flux of a point, some units
};

class SightJudge {
public:
  explicit SightJudge(const TriangleMesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto c = mesh.corners(t);
      triangles_.push_back({point(c[0]), point(c[1]), point(c[2])});
    }
  }

  /// A_i F_ij from points of the triangle i, so many for each of the shifts.
  [[nodiscard]] SampledArea exchange_area(std::size_t i, std::size_t j, int points, Draw& draw) const {
    const Triangle& receiver = triangles_[i];
    const Vec normal = cross(receiver[1] - receiver[0], receiver[2] - receiver[0]);
    const double size = std::sqrt(dot(normal, normal));
    std::array<double, shifts> means{};
    for (double& mean : means) {
      const double first = draw.unit();
      const double second = draw.unit();
      for (int k = 0; k < points; ++k) {
        // The plastic number's lattice, folded onto the triangle.
        double s = fraction(first + 0.7548776662466927 * k);
        double t = fraction(second + 0.5698402909980532 * k);
        if (s + t > 1) {
          s = 1 - s;
          t = 1 - t;
        }
        const Vec p = receiver[0] + s * (receiver[1] - receiver[0]) + t * (receiver[2] - receiver[0]);
        mean += flux(p, (1 / size) * normal, i, j) / points;
      }
    }
    SampledArea out;
    for (const double mean : means) out.value += mean / shifts;
    double spread = 0;
    for (const double mean : means) spread += (mean - out.value) * (mean - out.value);
    const double scale = size / 2 / std::numbers::pi;
    return {scale * out.value, scale * std::sqrt(spread / (shifts * (shifts - 1))),
            0x1p-46 * scale * (thinness(i) + thinness(j))};
  }

private:
  /// By what the rounding of a normal grows: the square of the longest side over the area.
  [[nodiscard]] double thinness(std::size_t t) const {
    const Triangle& c = triangles_[t];
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, dot(c[(k + 1) % 3] - c[k], c[(k + 1) % 3] - c[k]));
    const Vec normal = cross(c[1] - c[0], c[2] - c[0]);
    return 2 * longest / std::sqrt(dot(normal, normal));
  }

  static constexpr int shifts = 16;
  struct Vec {
    double x = 0;
    double y = 0;
    double z = 0;
  };
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator*(double c, const Vec& a) { return {c * a.x, c * a.y, c * a.z}; }
  static double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static Vec cross(const Vec& a, const Vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  static Vec point(const Vector<double>& p) { return {p.x, p.y, p.z}; }
  static double fraction(double x) { return x - std::floor(x); }

  using Triangle = std::array<Vec, 3>;
  using Polygon = std::vector<Vec>;

  /// What of a polygon has normal . Q >= offset.
  static Polygon clipped(const Polygon& polygon, const Vec& normal, double offset) {
    Polygon out;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec& a = polygon[k];
      const Vec& b = polygon[(k + 1) % polygon.size()];
      const double here = dot(normal, a) - offset;
      const double there = dot(normal, b) - offset;
      if (here >= 0) out.push_back(a);
      if ((here < 0) != (there < 0) && here != 0 && there != 0)
        out.push_back(a + (here / (here - there)) * (b - a));
    }
    if (out.size() < 3) out.clear();
    return out;
  }
  static bool outside(const Polygon& polygon, const Vec& normal) {
    return std::all_of(polygon.begin(), polygon.end(), [&](const Vec& p) { return dot(normal, p) <= 0; });
  }

  [[nodiscard]] double flux(const Vec& p, const Vec& unit_normal, std::size_t from, std::size_t to) const {
    const Triangle& source = triangles_[to];
    const Vec facing = cross(source[1] - source[0], source[2] - source[0]);
    if (dot(facing, p - source[0]) <= 0) return 0;
    Polygon whole{source[0] - p, source[1] - p, source[2] - p};
    std::vector<Polygon> seen{clipped(whole, unit_normal, 0)};
    for (std::size_t t = 0; t < triangles_.size() && !seen.empty(); ++t) {
      if (t == from || t == to) continue;
      const Triangle& other = triangles_[t];
      const std::array<Vec, 3> ray{other[0] - p, other[1] - p, other[2] - p};
      Vec plane = cross(ray[1] - ray[0], ray[2] - ray[0]);
      const double height = dot(plane, ray[0]);
      if (height == 0) continue;
      const double sign = height > 0 ? 1 : -1;
      bool passes = false;
      for (std::size_t k = 0; k < 3 && !passes; ++k)
        passes = outside(whole, sign * cross(ray[k], ray[(k + 1) % 3]));
      if (passes) continue;
      std::vector<Polygon> next;
      for (Polygon& piece : seen) {
        std::vector<Polygon> parts;
        Polygon rest = piece;
        const auto cut = [&](const Vec& inwards, double offset) {
          if (rest.empty()) return;
          Polygon outside = clipped(rest, -1.0 * inwards, -offset);
          if (!outside.empty()) parts.push_back(std::move(outside));
          rest = clipped(rest, inwards, offset);
        };
        for (std::size_t k = 0; k < 3; ++k) cut(sign * cross(ray[k], ray[(k + 1) % 3]), 0);
        cut(sign * plane, sign * height);
        // Where nothing is hidden the piece stays whole.
        if (rest.empty())
          next.push_back(std::move(piece));
        else
          for (Polygon& part : parts) next.push_back(std::move(part));
      }
      seen = std::move(next);
    }
    double sum = 0;
    for (const Polygon& piece : seen)
      for (std::size_t k = 0; k < piece.size(); ++k) {
        const Vec& a = piece[k];
        const Vec& b = piece[(k + 1) % piece.size()];
        const Vec across = cross(a, b);
        const double length = std::sqrt(dot(across, across));
        if (length > 0) sum -= std::atan2(length, dot(a, b)) * dot(unit_normal, across) / length / 2;
      }
    return sum;
  }

  std::vector<Triangle> triangles_;
};

}  // namespace radcert::attack
