// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/occlusion/solid_facts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/work_limit.h"

namespace radcert::certificate {

/// A ray of a small prime's direction is in general position unless the surface was made against it.
const WorkLimit most_rays("certificate/solid_facts: rays from a face", 20, 1,
                          "the surface is not verified: it may be no boundary of a body");

namespace {

std::string face_pointer(std::size_t face) { return "/problem/faces/" + std::to_string(face); }

/// The least and the largest sign of points over a plane.
struct Signs {
  int least = 1;
  int largest = -1;
};

Signs signs_over(const Vector<Rational>& at, const Vector<Rational>& normal, const Face& face) {
  Signs out;
  for (const Vector<Rational>& p : face.corners) {
    const int sign = dot(normal, p - at).sign();
    out.least = std::min(out.least, sign);
    out.largest = std::max(out.largest, sign);
  }
  return out;
}

/// Whether a side of a face has all of another one of its plane on its outer side.
bool parts(const Face& face, const Face& other) {
  const Vector<Rational> normal = normal_of(face);
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Vector<Rational> outward =
        cross(face.corners[(i + 1) % face.corners.size()] - face.corners[i], normal);
    if (signs_over(face.corners[i], outward, other).least >= 0) return true;
  }
  return false;
}

std::optional<Refusal> crossing_fault(const PolyhedronCertificate& c) {
  for (std::size_t f = 0; f < c.faces.size(); ++f) {
    const Face& face = c.faces[f];
    const Vector<Rational> normal = normal_of(face);
    for (std::size_t g = 0; g < c.faces.size(); ++g) {
      if (g == f) continue;
      const Signs signs = signs_over(face.corners[0], normal, c.faces[g]);
      if (signs.least < 0 && signs.largest > 0)
        return Refusal{face_pointer(g), "has corners on both sides of the plane of face " +
                                            std::to_string(f) + ": the surface is neither convex nor cut"};
      if (signs.least == 0 && signs.largest == 0 && !parts(face, c.faces[g]) && !parts(c.faces[g], face))
        return Refusal{face_pointer(g), "overlaps face " + std::to_string(f)};
    }
  }
  return std::nullopt;
}

/// A point as something that has an order.
using Key = std::array<Rational, 3>;
Key key(const Vector<Rational>& p) { return {p.x, p.y, p.z}; }

std::optional<Refusal> edges_fault(const PolyhedronCertificate& c) {
  std::map<Key, Vector<Rational>> corners;
  for (const Face& face : c.faces)
    for (const Vector<Rational>& p : face.corners) corners.emplace(key(p), p);
  struct Directed {
    long count = 0;
    std::size_t face = 0;
  };
  std::map<std::pair<Key, Key>, Directed> edges;
  for (std::size_t f = 0; f < c.faces.size(); ++f) {
    const std::vector<Vector<Rational>>& p = c.faces[f].corners;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vector<Rational>& from = p[i];
      const Vector<Rational> edge = p[(i + 1) % p.size()] - from;
      const Rational whole = dot(edge, edge);
      std::vector<std::pair<Rational, Key>> on{{Rational(0), key(from)}, {whole, key(from + edge)}};
      for (const auto& [name, at] : corners) {
        const Rational along = dot(edge, at - from);
        if (along.sign() <= 0 || along >= whole) continue;
        const Vector<Rational> beside = cross(edge, at - from);
        if (beside.x.sign() == 0 && beside.y.sign() == 0 && beside.z.sign() == 0)
          on.emplace_back(along, name);
      }
      std::sort(on.begin(), on.end());
      for (std::size_t k = 0; k + 1 < on.size(); ++k) {
        Directed& own = edges[{on[k].second, on[k + 1].second}];
        ++own.count;
        own.face = f;
      }
    }
  }
  for (const auto& [edge, found] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second.count != found.count)
      return Refusal{face_pointer(found.face),
                     "has an edge that no other face has: the surface is not closed"};
  }
  return std::nullopt;
}

/// What a ray makes of a face: crossings with their sign, or nothing where it meets the border.
std::optional<long> crossings(const Face& face, const Vector<Rational>& normal, const Vector<Rational>& from,
                              const Vector<Rational>& way) {
  const Rational turned = dot(normal, way);
  // Parallel to it: a ray in its plane would begin in it, where the faces of one plane lie beside each other.
  if (turned.sign() == 0) return 0;
  const Rational at = dot(normal, face.corners[0] - from) / turned;
  if (at.sign() <= 0) return 0;
  const Vector<Rational> met = from + at * way;
  bool is_on_border = false;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Vector<Rational>& a = face.corners[i];
    const Vector<Rational>& b = face.corners[(i + 1) % face.corners.size()];
    const int sign = dot(normal, cross(b - a, met - a)).sign();
    if (sign < 0) return 0;
    is_on_border = is_on_border || sign == 0;
  }
  if (is_on_border) return std::nullopt;
  return turned.sign() < 0 ? 1 : -1;
}

std::optional<Refusal> inside_fault(const PolyhedronCertificate& c) {
  std::vector<Vector<Rational>> normals;
  for (const Face& face : c.faces) normals.push_back(normal_of(face));
  for (std::size_t f = 0; f < c.faces.size(); ++f) {
    const Face& face = c.faces[f];
    Vector<Rational> sum;
    for (const Vector<Rational>& p : face.corners) sum = sum + p;
    const Vector<Rational> from = Rational(1, static_cast<long>(face.corners.size())) * sum;
    const Vector<Rational>& n = normals[f];
    const Vector<Rational> scaled = (Rational(1) / std::max({abs(n.x), abs(n.y), abs(n.z)})) * n;
    std::optional<long> winding;
    for (long k = 1; k <= most_rays.value() && !winding; ++k) {
      // Half as long as the normal at most: the ray leaves to the front.
      const Vector<Rational> way =
          scaled + Vector<Rational>{Rational(k, 101), Rational(k * k, 1009), Rational(-k * k, 2003)};
      if (dot(way, n).sign() <= 0) continue;
      long crossed = 0;
      bool is_general = true;
      for (std::size_t g = 0; g < c.faces.size() && is_general; ++g) {
        if (g == f) continue;
        const std::optional<long> own = crossings(c.faces[g], normals[g], from, way);
        is_general = own.has_value();
        crossed += own.value_or(0);
      }
      if (is_general) winding = crossed;
    }
    if (!winding) return Refusal{face_pointer(f), "has no ray that meets no edge, of those that were tried"};
    if (*winding != 1)
      return Refusal{face_pointer(f),
                     "is not seen from the inside of one body: what lies before it is "
                     "enclosed " +
                         std::to_string(*winding) + " times"};
  }
  return std::nullopt;
}

}  // namespace

bool is_convex(const PolyhedronCertificate& c) {
  for (const Face& face : c.faces) {
    const Vector<Rational> normal = normal_of(face);
    for (const Face& other : c.faces)
      if (signs_over(face.corners[0], normal, other).least < 0) return false;
  }
  return true;
}

std::optional<Refusal> solid_fault(const PolyhedronCertificate& c) {
  for (const auto& fault : {&crossing_fault, &edges_fault, &inside_fault})
    if (std::optional<Refusal> found = fault(c)) return found;
  return std::nullopt;
}

}  // namespace radcert::certificate
