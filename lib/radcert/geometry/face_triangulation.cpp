// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/face_triangulation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "radcert/core/errors.h"
#include "radcert/geometry/orientation.h"

namespace radcert {
namespace {

using PlanePoint = ParameterPoint<double>;

// Cutting off ears takes a number of steps between the square and the cube of it.
constexpr std::size_t most_corners = 10000;

[[noreturn]] void refuse_face(std::size_t face, const std::string& problem, const std::string& allowed) {
  throw InputError({.pointer = "face " + std::to_string(face + 1), .problem = problem, .allowed = allowed});
}

/// The corners with the coordinate left out in which the face is thinnest; the order keeps the sense of rotation.
std::vector<PlanePoint> projection(const std::vector<Vector<double>>& corners) {
  Vector<double> normal;  // Newell's: the sum of the cross products along the boundary
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal = normal + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  const double x = std::abs(normal.x);
  const double y = std::abs(normal.y);
  const double z = std::abs(normal.z);
  std::vector<PlanePoint> points;
  for (const Vector<double>& p : corners)
    points.push_back(z >= x && z >= y ? PlanePoint{p.x, p.y}
                     : x >= y         ? PlanePoint{p.y, p.z}
                                      : PlanePoint{p.z, p.x});
  const double turn = z >= x && z >= y ? normal.z : x >= y ? normal.x : normal.y;
  if (turn < 0)
    for (PlanePoint& p : points) p = {p.t, p.s};  // seen from the other side: counterclockwise
  return points;
}

bool segments_meet(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  const int abc = orientation(a, b, c);
  const int abd = orientation(a, b, d);
  const int cda = orientation(c, d, a);
  const int cdb = orientation(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  const auto within = [](const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
    return std::min(p.s, q.s) <= r.s && r.s <= std::max(p.s, q.s) && std::min(p.t, q.t) <= r.t &&
           r.t <= std::max(p.t, q.t);
  };
  return (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d)) || (cda == 0 && within(c, d, a)) ||
         (cdb == 0 && within(c, d, b));
}

/// No two edges meet but neighbours at their corner, and neighbours do not run back over each other.
bool is_simple(const std::vector<PlanePoint>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const PlanePoint& next = p[(i + 1) % n];
    const PlanePoint& after = p[(i + 2) % n];
    const PlanePoint back = p[i] - next;
    const PlanePoint on = after - next;
    if (orientation(p[i], next, after) == 0 && back.s * on.s + back.t * on.t >= 0) return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && segments_meet(p[i], next, p[j], p[(j + 1) % n])) return false;
  }
  return true;
}

/// Ears of a simple polygon that runs counterclockwise: triples of places.
std::optional<std::vector<VertexTriple>> ears(const std::vector<PlanePoint>& points) {
  if (!is_simple(points)) return std::nullopt;
  std::vector<std::size_t> left(points.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<VertexTriple> triangles;
  const auto is_ear = [&](std::size_t i) {
    const std::size_t n = left.size();
    const std::size_t before = left[(i + n - 1) % n];
    const std::size_t here = left[i];
    const std::size_t after = left[(i + 1) % n];
    if (orientation(points[before], points[here], points[after]) <= 0) return false;
    for (const std::size_t other : left) {
      if (other == before || other == here || other == after) continue;
      if (orientation(points[before], points[here], points[other]) >= 0 &&
          orientation(points[here], points[after], points[other]) >= 0 &&
          orientation(points[after], points[before], points[other]) >= 0)
        return false;
    }
    return true;
  };
  while (left.size() > 3) {
    std::size_t i = 0;
    while (i < left.size() && !is_ear(i)) ++i;
    if (i == left.size()) return std::nullopt;
    const std::size_t n = left.size();
    triangles.push_back({left[(i + n - 1) % n], left[i], left[(i + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (orientation(points[left[0]], points[left[1]], points[left[2]]) <= 0) return std::nullopt;
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

/// Whether all corners lie in one plane exactly.
bool is_plane(const std::vector<Vector<double>>& corners) {
  std::size_t off = 2;
  while (off < corners.size() && collinear(corners[0], corners[1], corners[off])) ++off;
  for (std::size_t i = 2; off < corners.size() && i < corners.size(); ++i)
    if (orientation(corners[0], corners[1], corners[off], corners[i]) != 0) return false;
  return true;
}

}  // namespace

TriangulatedFaces triangulate_faces(const MeshFile& file) {
  TriangulatedFaces result;
  TriangleMesh& mesh = result.mesh;
  mesh.vertices = file.vertices;
  mesh.group_names = file.group_names;
  const auto add = [&](const VertexTriple& triangle, std::size_t face) {
    mesh.triangles.push_back(triangle);
    mesh.group.push_back(file.group[face]);
    mesh.face.push_back(face);
  };
  for (std::size_t face = 0; face < file.face_count(); ++face) {
    const std::size_t begin = file.face_begin[face];
    const std::size_t count = file.face_begin[face + 1] - begin;
    if (count == 3) {
      add({file.corner[begin], file.corner[begin + 1], file.corner[begin + 2]}, face);
      continue;
    }
    if (count > most_corners)
      refuse_face(face, "has " + std::to_string(count) + " corners",
                  "faces of at most " + std::to_string(most_corners) + " corners");
    ++result.cut_faces;
    std::vector<Vector<double>> corners;
    for (std::size_t i = 0; i < count; ++i) corners.push_back(file.vertices[file.corner[begin + i]]);
    if (!is_plane(corners)) result.bent_faces.push_back(face);
    const auto triangles = ears(projection(corners));
    if (!triangles)
      refuse_face(face, "has " + std::to_string(count) + " corners that bound no simple polygon",
                  "faces whose sides do not meet but at their corners");
    for (const VertexTriple& t : *triangles)
      add({file.corner[begin + t[0]], file.corner[begin + t[1]], file.corner[begin + t[2]]}, face);
  }
  return result;
}

}  // namespace radcert
