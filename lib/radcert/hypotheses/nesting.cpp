// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/nesting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/geometry/orientation.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

/// One connected part of the mesh.
struct Component {
  std::vector<std::size_t> triangles;
  Vector<double> least{};
  Vector<double> greatest{};

  [[nodiscard]] bool has_in_its_box(const Vector<double>& p) const {
    return least.x <= p.x && p.x <= greatest.x && least.y <= p.y && p.y <= greatest.y && least.z <= p.z &&
           p.z <= greatest.z;
  }
};

std::vector<Component> components_of(const TriangleMesh& mesh, const MeshTopology& topology) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Vector<double> beyond{infinity, infinity, infinity};
  std::vector<Component> components(topology.component_count,
                                    {.triangles = {}, .least = beyond, .greatest = -beyond});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Component& component = components[topology.component[t]];
    component.triangles.push_back(t);
    for (const Vector<double>& corner : mesh.corners(t)) {
      component.least = {std::min(component.least.x, corner.x), std::min(component.least.y, corner.y),
                         std::min(component.least.z, corner.z)};
      component.greatest = {std::max(component.greatest.x, corner.x),
                            std::max(component.greatest.y, corner.y),
                            std::max(component.greatest.z, corner.z)};
    }
  }
  return components;
}

/// The solid angle of a triangle, positive where it runs clockwise as seen from p.
double solid_angle(const std::array<Vector<double>, 3>& corners, const Vector<double>& p) {
  const int side = orientation(corners[0], corners[1], corners[2], p);
  const Vector<double> a = corners[0] - p;
  const Vector<double> b = corners[1] - p;
  const Vector<double> c = corners[2] - p;
  const double la = norm(a);
  const double lb = norm(b);
  const double lc = norm(c);
  const double sine = std::abs(dot(a, cross(b, c)));
  const double cosine = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return -side * 2 * std::atan2(sine, cosine);
}

/// How often a component winds about a point off it.
long winding_number(const TriangleMesh& mesh, const Component& component, const Vector<double>& p) {
  if (!component.has_in_its_box(p)) return 0;
  double angle = 0;
  for (const std::size_t t : component.triangles) angle += solid_angle(mesh.corners(t), p);
  return std::lround(angle / (4 * pi<double>()));
}

}  // namespace

std::vector<std::size_t> misoriented_components(const TriangleMesh& mesh, const MeshTopology& topology,
                                                Orientation orientation, LightOf light) {
  const long outwards = orientation == Orientation::against_the_cross_product ? 1 : -1;
  const std::vector<Component> components = components_of(mesh, topology);
  TriangleMesh part{.vertices = mesh.vertices, .triangles = {}, .group = {}, .group_names = {}, .face = {}};
  std::vector<std::size_t> faulty;
  for (const Component& own : components) {
    part.triangles.clear();
    for (const std::size_t t : own.triangles) part.triangles.push_back(mesh.triangles[t]);
    long inside = outwards * volume_sign(part) > 0 ? 1 : 0;
    const Vector<double>& vertex = mesh.vertices[part.triangles.front()[0]];
    for (const Component& other : components)
      if (&other != &own) inside += outwards * winding_number(mesh, other, vertex);
    if (inside != (light == LightOf::rooms ? 1 : 0)) faulty.push_back(own.triangles.front());
  }
  std::sort(faulty.begin(), faulty.end());
  return faulty;
}

std::size_t outermost_components(const TriangleMesh& mesh, const MeshTopology& topology) {
  const std::vector<Component> components = components_of(mesh, topology);
  return static_cast<std::size_t>(
      std::count_if(components.begin(), components.end(), [&](const Component& own) {
        const Vector<double>& vertex = mesh.vertices[mesh.triangles[own.triangles.front()][0]];
        return std::all_of(components.begin(), components.end(), [&](const Component& other) {
          return &other == &own || winding_number(mesh, other, vertex) == 0;
        });
      }));
}

}  // namespace radcert
