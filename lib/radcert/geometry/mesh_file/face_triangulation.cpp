// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_file/face_triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "radcert/core/errors.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/polygon_triangulation.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

// So many bent faces are told of, one by one.
constexpr std::size_t most_told = 100;

[[noreturn]] void refuse_face(const std::string& face, const std::string& problem,
                              const std::string& allowed) {
  throw InputError({.pointer = face, .problem = problem, .allowed = allowed});
}

/// Whether all corners lie in one plane exactly.
bool is_plane(const std::vector<Vector<double>>& corners) {
  std::size_t off = 2;
  while (off < corners.size() && collinear(corners[0], corners[1], corners[off])) ++off;
  for (std::size_t i = 2; off < corners.size() && i < corners.size(); ++i)
    if (orientation(corners[0], corners[1], corners[off], corners[i]) != 0) return false;
  return true;
}

Rational square(const Rational& x) { return x * x; }

/// A length by its square, rounded up to two digits.
std::string length_text(const Rational& squared) {
  return widened(Ball(0), sqrt(Ball(squared))).decimal(1).radius;
}

/// How far the corners of a bent face lie from a plane: "0.29, which is 0.17 of the diagonal of its box".
std::string bend_text(const std::vector<Vector<double>>& corners) {
  std::vector<Vector<Rational>> p;
  double largest = 0;
  for (const Vector<double>& c : corners) {
    largest = std::max({largest, std::abs(c.x), std::abs(c.y), std::abs(c.z)});
    p.push_back({Rational::exactly(c.x), Rational::exactly(c.y), Rational::exactly(c.z)});
  }
  Vector<Rational> mean;
  Vector<Rational> normal;
  for (std::size_t i = 0; i < p.size(); ++i) {
    mean = mean + p[i];
    if (i > 0 && i + 1 < p.size()) normal = normal + cross(p[i] - p[0], p[i + 1] - p[0]);
  }
  const Rational share = 1 / Rational(p.size());
  mean = {mean.x * share, mean.y * share, mean.z * share};
  const Rational length = dot(normal, normal);
  if (length == 0) return "far";  // their cross products cancel: no plane is near
  Rational farthest = 0;
  Vector<Rational> low = p[0];
  Vector<Rational> high = p[0];
  for (const Vector<Rational>& q : p) {
    farthest = std::max(farthest, square(dot(normal, q - mean)) / length);
    low = {std::min(low.x, q.x), std::min(low.y, q.y), std::min(low.z, q.z)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y), std::max(high.z, q.z)};
  }
  const Rational diagonal = dot(high - low, high - low);
  std::string out = length_text(farthest) + ", which is " + length_text(farthest / diagonal) +
                    " of the diagonal of its box";
  // Rounding moves a coordinate by half a unit in the last place of the largest at most: both corner and
  // plane.
  const Rational unit = Rational::exactly(largest) / power(Rational(2), 53);
  if (farthest <= square(4 * unit)) out += ", as rounding to double leaves of a plane face";
  return out;
}

/// "from vertex 7 to 9", for the sides that the triangles have and the face has not.
std::string diagonal_text(const std::vector<VertexTriple>& triangles, std::span<const std::size_t> face) {
  std::string out;
  const std::size_t n = face.size();
  for (const VertexTriple& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t from = t[i];
      const std::size_t to = t[(i + 1) % 3];
      if (from > to || to == from + 1 || (from == 0 && to == n - 1)) continue;
      out += (out.empty() ? "from vertex " : ", ") + std::to_string(face[from]) + " to " +
             std::to_string(face[to]);
    }
  return out;
}

[[noreturn]] void refuse_bent(const MeshFile& file, std::size_t face, std::size_t count,
                              const std::vector<Vector<double>>& corners) {
  refuse_face(file.face_text(face),
              "has " + std::to_string(count) + " corners that do not lie in one plane, up to " +
                  bend_text(corners) + ": the diagonals would decide what the surface is",
              "faces that are exactly plane, or triangles; --repair triangulate, or triangulate in the list "
              "repair of "
              "a problem's surface, cuts bent faces and says along which diagonals");
}

}  // namespace

TriangulatedFaces triangulate_faces(const MeshFile& file, BentFaces bent) {
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
    ++result.cut_faces;
    std::vector<Vector<double>> corners;
    for (std::size_t i = 0; i < count; ++i) corners.push_back(file.vertices[file.corner[begin + i]]);
    const auto triangles = polygon_triangles(corners);
    const bool is_bent = !is_plane(corners);
    if (is_bent && bent == BentFaces::refused) refuse_bent(file, face, count, corners);
    if (!triangles)
      refuse_face(file.face_text(face),
                  "has " + std::to_string(count) + " corners that bound no simple polygon",
                  "faces whose sides do not meet but at their corners");
    if (is_bent) result.bent_faces.push_back(face);
    if (is_bent && result.bent_faces.size() <= most_told)
      result.diagonals.push_back(file.face_text(face) + ", bent up to " + bend_text(corners) + ": cut " +
                                 diagonal_text(*triangles, std::span(file.corner).subspan(begin, count)));
    for (const VertexTriple& t : *triangles)
      add({file.corner[begin + t[0]], file.corner[begin + t[1]], file.corner[begin + t[2]]}, face);
  }
  if (result.bent_faces.size() > most_told)
    result.diagonals.push_back("and " + std::to_string(result.bent_faces.size() - most_told) +
                               " more bent faces, cut in the same way");
  return result;
}

}  // namespace radcert
