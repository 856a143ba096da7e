// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "radcert/geometry/mesh_defects.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_classes.h"
#include "radcert/visibility/whole_vector.h"

namespace radcert {
namespace {

bool fits(double coordinate) { return std::abs(coordinate) <= Scene::largest_coordinate; }
bool fits(const Vector<double>& v) { return fits(v.x) && fits(v.y) && fits(v.z); }

std::string words_of(const Vector<double>& v) {
  return "(" + shortest(v.x) + ", " + shortest(v.y) + ", " + shortest(v.z) + ")";
}

std::string words_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto corners = mesh.corners(triangle);
  return "triangle " + std::to_string(triangle) + " " + words_of(corners[0]) + " " + words_of(corners[1]) +
         " " + words_of(corners[2]);
}

/// The number of the first vertex with the same coordinates, for each.
std::vector<std::size_t> first_equal_vertices(const std::vector<Vector<double>>& vertices) {
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t k) { return std::tie(vertices[k].x, vertices[k].y, vertices[k].z); };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<std::size_t> first(vertices.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? first[order[k - 1]] : order[k];
  return first;
}

std::vector<VertexTriple> joined(const TriangleMesh& mesh) {
  const std::vector<std::size_t> first = first_equal_vertices(mesh.vertices);
  std::vector<VertexTriple> triangles = mesh.triangles;
  for (VertexTriple& t : triangles)
    for (std::size_t& v : t) v = first[v];
  return triangles;
}

/// A number for each plane as a set: that of its class, or of the class that looks the other way, whichever
/// is less.
std::vector<std::size_t> planes_of(const TriangleMesh& mesh) {
  const PlaneClasses classes = plane_classes(mesh);
  // One triangle of each class, then the same turned round.
  TriangleMesh both;
  both.vertices = mesh.vertices;
  for (const std::size_t k : classes.first_triangle) both.triangles.push_back(mesh.triangles[k]);
  for (const std::size_t k : classes.first_triangle) {
    const VertexTriple& t = mesh.triangles[k];
    both.triangles.push_back({t[0], t[2], t[1]});
  }
  const std::vector<std::size_t> seen = plane_classes(both).of_triangle;
  const std::size_t count = classes.count();
  std::vector<std::size_t> planes(mesh.triangles.size());
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const std::size_t own = classes.of_triangle[k];
    planes[k] = std::min(own, seen[count + own]);
  }
  return planes;
}

TriangleMesh checked(TriangleMesh mesh) {
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    for (const std::size_t v : mesh.triangles[k])
      expects(v < mesh.vertices.size() && fits(mesh.vertices[v]),
              "vertices that are there, with coordinates of at most 2^100", named("triangle", k));
    const auto [a, b, c] = mesh.corners(k);
    expects(!collinear(a, b, c), "triangles that are not degenerate", named("triangle", k));
  }
  return mesh;
}

int exponent_of(const TriangleMesh& mesh) {
  int exponent = std::numeric_limits<int>::max();
  for (const VertexTriple& t : mesh.triangles)
    for (const std::size_t v : t) exponent = std::min(exponent, lowest_exponent(mesh.vertices[v]));
  return exponent;
}

}  // namespace

Scene::Scene(TriangleMesh mesh)
    : mesh_(checked(std::move(mesh))),
      vertices_(joined(mesh_)),
      plane_(planes_of(mesh_)),
      tree_(triangle_boxes(mesh_)),
      lowest_exponent_(exponent_of(mesh_)) {}

std::vector<SceneFault> scene_faults(const TriangleMesh& mesh) {
  std::vector<SceneFault> faults;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    for (const std::size_t v : mesh.triangles[k])
      expects(v < mesh.vertices.size(), "vertices that are there", named("triangle", k), named("vertex", v));
    const auto corners = mesh.corners(k);
    if (!std::all_of(corners.begin(), corners.end(), [](const auto& v) { return fits(v); }))
      faults.push_back({SceneFaultKind::not_finite, k, k,
                        words_of(mesh, k) + " has a coordinate that is not finite or beyond 2^100"});
  }
  if (!faults.empty()) return faults;
  TriangleMesh sound;
  sound.vertices = mesh.vertices;
  const std::vector<VertexTriple> vertices = joined(mesh);
  std::vector<std::size_t> number;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto [a, b, c] = mesh.corners(k);
    if (collinear(a, b, c)) {
      faults.push_back(
          {SceneFaultKind::degenerate, k, k, words_of(mesh, k) + " has its corners on one line"});
    } else {
      sound.triangles.push_back(vertices[k]);
      number.push_back(k);
    }
  }
  const std::vector<std::size_t> planes = planes_of(sound);
  for (const auto& [i, j] : crossing_triangles(sound, most_crossings.count())) {
    const std::size_t first = number[i];
    const std::size_t second = number[j];
    VertexTriple s = sound.triangles[i];
    VertexTriple t = sound.triangles[j];
    std::sort(s.begin(), s.end());
    std::sort(t.begin(), t.end());
    const std::string both = words_of(mesh, first) + " and " + words_of(mesh, second);
    if (s == t) {
      faults.push_back({SceneFaultKind::doubled, first, second,
                        both + " have the same corners: no thickness, or one face twice"});
    } else if (planes[i] == planes[j]) {
      faults.push_back(
          {SceneFaultKind::overlapping, first, second, both + " lie in one plane and overlap or touch"});
    } else {
      faults.push_back({SceneFaultKind::crossing, first, second, both + " cross or touch"});
    }
  }
  std::stable_sort(faults.begin(), faults.end(),
                   [](const SceneFault& a, const SceneFault& b) { return a.kind < b.kind; });
  return faults;
}

}  // namespace radcert
