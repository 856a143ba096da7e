// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/polyhedron_facts.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "radcert/certificate/face_polynomial.h"
#include "radcert/certificate/occlusion/solid_facts.h"
#include "radcert/geometry/plane.h"
#include "radcert/geometry/plane_polygon.h"

namespace radcert::certificate {
namespace {

std::string face_pointer(std::size_t face) { return "/problem/faces/" + std::to_string(face); }

/// A point as something that has an order.
using Key = std::array<Rational, 3>;
Key key(const Vector<Rational>& p) { return {p.x, p.y, p.z}; }

/// Of one face: the test of convexity takes the square of it.
constexpr std::size_t most_corners = 2000;

std::optional<Refusal> polygon_fault(const Face& face, std::size_t number) {
  const std::string pointer = face_pointer(number) + "/corners";
  const Vector<Rational> normal = normal_of(face);
  if (is_zero(normal)) return Refusal{pointer, "the first three corners lie on a line"};
  const std::size_t n = face.corners.size();
  if (n > most_corners)
    return Refusal{pointer, "are more than are looked at, " + std::to_string(most_corners)};
  for (std::size_t i = 0; i < n; ++i) {
    const Vector<Rational>& a = face.corners[i];
    const Vector<Rational>& b = face.corners[(i + 1) % n];
    if (dot(normal, a - face.corners[0]).sign() != 0)
      return Refusal{pointer + "/" + std::to_string(i), "does not lie in the plane of its face"};
    // Every other corner strictly to the left of the side: strictly convex, and run through once.
    for (std::size_t k = 0; k < n; ++k)
      if (k != i && k != (i + 1) % n && dot(normal, cross(b - a, face.corners[k] - a)).sign() <= 0)
        return Refusal{pointer + "/" + std::to_string(k),
                       "makes the face a polygon that is not strictly convex"};
  }
  return std::nullopt;
}

/// A face in the plane of another one.
PolygonLoop in_plane_of(const Face& frame, const Face& face) {
  PolygonLoop loop;
  for (const Vector<Rational>& corner : face.corners)
    loop.push_back(coordinates(corner - frame.corners[0], frame.corners[1] - frame.corners[0],
                               frame.corners[2] - frame.corners[0]));
  return loop;
}

/// Whether a side of a convex polygon has all of another one on its other side.
bool parts(const PolygonLoop& polygon, const PolygonLoop& other) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ParameterPoint<Rational>& a = polygon[i];
    const ParameterPoint<Rational> side = polygon[(i + 1) % polygon.size()] - a;
    if (std::all_of(other.begin(), other.end(),
                    [&](const ParameterPoint<Rational>& p) { return cross(side, p - a).sign() <= 0; }))
      return true;
  }
  return false;
}

/// The faces of one plane, and the facet of the hull that they have to fill.
struct Facet {
  std::vector<std::size_t> faces;
  std::vector<Vector<Rational>> corners;
};

Plane plane_of(const Face& face) {
  return {face.corners[0], face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]};
}

std::optional<Refusal> facet_fault(const PolyhedronCertificate& c, Facet& facet) {
  const Face& frame = c.faces[facet.faces.front()];
  const std::string pointer = face_pointer(facet.faces.front());
  const Vector<Rational> normal = normal_of(frame);
  PolygonLoop points;
  for (const Face& face : c.faces)
    for (const Vector<Rational>& p : face.corners)
      if (dot(normal, p - frame.corners[0]).sign() == 0)
        points.push_back(coordinates(p - frame.corners[0], frame.corners[1] - frame.corners[0],
                                     frame.corners[2] - frame.corners[0]));
  const PolygonLoop hull = convex_hull(points);
  std::vector<PolygonLoop> loops;
  Rational area = 0;
  for (const std::size_t k : facet.faces) {
    loops.push_back(in_plane_of(frame, c.faces[k]));
    area += doubled_area(loops.back());
  }
  if (!(area == doubled_area(hull)))
    return Refusal{pointer, "with the faces of its plane it is not a whole facet of the hull"};
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!parts(loops[i], loops[j]) && !parts(loops[j], loops[i]))
        return Refusal{face_pointer(facet.faces[i]), "overlaps face " + std::to_string(facet.faces[j])};
  for (const ParameterPoint<Rational>& at : hull)
    facet.corners.push_back(frame.corners[0] + at.s * (frame.corners[1] - frame.corners[0]) +
                            at.t * (frame.corners[2] - frame.corners[0]));
  return std::nullopt;
}

std::optional<Refusal> closedness_fault(const std::vector<Facet>& facets) {
  std::map<std::pair<Key, Key>, std::pair<int, std::size_t>> edges;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const std::vector<Vector<Rational>>& corners = facets[f].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      auto& [count, from] = edges[{key(corners[i]), key(corners[(i + 1) % corners.size()])}];
      ++count;
      from = f;
    }
  }
  for (const auto& [edge, found] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (found.first != 1 || back == edges.end() || back->second.first != 1)
      return Refusal{face_pointer(facets[found.second].faces.front()),
                     "has an edge that no other face has: the surface is not closed"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> surface_fault(const PolyhedronCertificate& c) {
  for (std::size_t k = 0; k < c.faces.size(); ++k)
    if (std::optional<Refusal> fault = polygon_fault(c.faces[k], k)) return fault;
  std::vector<bool> has_face(c.pieces.size());
  for (const Face& face : c.faces) has_face[face.piece] = true;
  for (std::size_t k = 0; k < c.pieces.size(); ++k)
    if (!has_face[k]) return Refusal{"/problem/pieces/" + std::to_string(k), "has no face"};
  if (!is_convex(c)) return solid_fault(c);
  std::vector<Facet> facets;
  for (std::size_t k = 0; k < c.faces.size(); ++k) {
    const Face& face = c.faces[k];
    const Vector<Rational> normal = normal_of(face);
    bool is_solid = false;
    for (const Face& other : c.faces)
      for (const Vector<Rational>& p : other.corners) {
        is_solid = is_solid || dot(normal, p - face.corners[0]).sign() > 0;
      }
    if (!is_solid) return Refusal{face_pointer(k), "has the whole surface in its plane"};
    const auto same = std::find_if(facets.begin(), facets.end(), [&](const Facet& facet) {
      return same_plane(plane_of(c.faces[facet.faces.front()]), plane_of(face));
    });
    if (same == facets.end())
      facets.push_back({.faces = {k}, .corners = {}});
    else
      same->faces.push_back(k);
  }
  for (Facet& facet : facets)
    if (std::optional<Refusal> fault = facet_fault(c, facet)) return fault;
  return closedness_fault(facets);
}

std::optional<Refusal> reflectivity_fault(const PolyhedronCertificate& c) {
  for (std::size_t k = 0; k < c.faces.size(); ++k) {
    const Rational& rho = c.faces[k].reflectivity;
    if (rho.sign() < 0 || rho >= Rational(1))
      return Refusal{face_pointer(k) + "/reflectivity", "is not from 0 to below 1"};
    const std::vector<std::vector<Rational>>& varying = c.faces[k].varying_reflectivity;
    if (!varying.empty() && !lies_within(c.faces[k], varying, rho))
      return Refusal{face_pointer(k) + "/reflectivity",
                     "is not shown to lie from 0 to the largest one that is stated"};
  }
  return std::nullopt;
}

std::optional<Refusal> tiling_fault(const PolyhedronCertificate& c) {
  std::vector<std::vector<std::vector<std::size_t>>> by_side;
  for (const Face& face : c.faces) by_side.emplace_back(face.corners.size());
  for (std::size_t e = 0; e < c.elements.size(); ++e) {
    const Element& x = c.elements[e];
    if (!(0 <= x.s0 && x.s0 < x.s1 && x.s1 <= 1 && 0 <= x.t0 && x.t0 < x.t1 && x.t1 <= 1))
      return Refusal{"/elements/" + std::to_string(e), "is no rectangle of parameters from 0 to 1"};
    by_side[x.face][x.side].push_back(e);
  }
  for (std::size_t k = 0; k < by_side.size(); ++k)
    for (std::size_t side = 0; side < by_side[k].size(); ++side) {
      std::vector<std::size_t>& own = by_side[k][side];
      std::sort(own.begin(), own.end(), [&](std::size_t a, std::size_t b) {
        return c.elements[a].t0 != c.elements[b].t0 ? c.elements[a].t0 < c.elements[b].t0 : a < b;
      });
      Rational area = 0;
      for (std::size_t i = 0; i < own.size(); ++i) {
        const Element& x = c.elements[own[i]];
        area += (Rational::exactly(x.s1) - Rational::exactly(x.s0)) *
                (Rational::exactly(x.t1) - Rational::exactly(x.t0));
        for (std::size_t j = i + 1; j < own.size() && c.elements[own[j]].t0 < x.t1; ++j) {
          const Element& y = c.elements[own[j]];
          if (y.s0 < x.s1 && x.s0 < y.s1)
            return Refusal{"/elements/" + std::to_string(own[j]),
                           "overlaps element " + std::to_string(own[i])};
        }
      }
      if (!(area == Rational(1)))
        return Refusal{face_pointer(k), "is not covered by its elements at side " + std::to_string(side)};
    }
  return std::nullopt;
}

}  // namespace radcert::certificate
