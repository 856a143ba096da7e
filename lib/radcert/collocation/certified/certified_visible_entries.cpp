// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/certified_visible_entries.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "radcert/closed_form/plane_element.h"
#include "radcert/collocation/certified/exchanged_corners.h"
#include "radcert/collocation/convex_polygon.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_polygon.h"
#include "radcert/scalar/real.h"
#include "radcert/visibility/point_view.h"
#include "radcert/visibility/surface_scene.h"

namespace radcert {
namespace {

using Point = ParameterPoint<Rational>;
using Polygon = ConvexPolygon<Rational>;
using Polynomials = std::vector<PlanePolynomial<Rational>>;

const Polygon& unit_triangle() {
  static const Polygon corners{{0, 0}, {1, 0}, {0, 1}};
  return corners;
}

void check(const Scene& scene, const SceneElement& element) {
  expects(element.triangle < scene.triangle_count(), "a triangle of the scene",
          named("triangle", element.triangle), named("count", scene.triangle_count()));
  for (const Point& corner : element.corners)
    expects(corner.s.sign() >= 0 && corner.t.sign() >= 0 && corner.s + corner.t <= Rational(1),
            "an element within its triangle", named("triangle", element.triangle));
  const auto& [a, b, c] = element.corners;
  expects(cross(b - a, c - a).sign() > 0, "an element that runs counterclockwise",
          named("triangle", element.triangle));
}

ExactTriangle in_space(const Scene& scene, const SceneElement& element) {
  const auto corners = scene.corners(element.triangle);
  const Vector<Rational> origin = exactly(corners[0]);
  const Vector<Rational> first = exactly(corners[1]) - origin;
  const Vector<Rational> second = exactly(corners[2]) - origin;
  ExactTriangle out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = origin + element.corners[k].s * first + element.corners[k].t * second;
  return out;
}

/// A scene and the nodes on it in a unit of length in which all are doubles and a scene takes them.
struct Scaled {
  Rational scale;
  Scene scene;
  std::vector<ExactNode> nodes;
};

Outcome<Scaled> scaled(const Scene& scene, ExactNodes nodes) {
  const auto size = [](const Vector<double>& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  };
  double largest = 0;
  for (const ExactNode& node : nodes.nodes) largest = std::max(largest, size(node.point));
  for (const Vector<double>& v : scene.mesh().vertices)
    largest = std::max(largest, size(v) * nodes.scale.to_double());
  if (!std::isfinite(largest)) return because("there is no unit of length in which every vertex is a double");
  // A power of two changes no digit.
  const int shift = -std::ilogb(largest);
  const Rational unit = nodes.scale * power(Rational(2), shift);
  for (ExactNode& node : nodes.nodes)
    node.point = {std::ldexp(node.point.x, shift), std::ldexp(node.point.y, shift),
                  std::ldexp(node.point.z, shift)};
  TriangleMesh mesh = scene.mesh();
  for (Vector<double>& v : mesh.vertices) {
    const Vector<Rational> exact = unit * exactly(v);
    v = {exact.x.to_double(), exact.y.to_double(), exact.z.to_double()};
    if (exactly(v) != exact) return because("there is no unit of length in which every vertex is a double");
  }
  return Scaled{unit, Scene(std::move(mesh)), std::move(nodes.nodes)};
}

/// An element, whole and in parts.
class Element {
public:
  Element(const SceneElement& place, const ExactTriangle& corners, const Rational& scale,
          const Polynomials& functions, std::span<const double> sizes)
      : place_(place.corners),
        origin_(scale * corners[0]),
        first_(scale * (corners[1] - corners[0])),
        second_(scale * (corners[2] - corners[0])),
        functions_(functions),
        sizes_(sizes),
        whole_(of(unit_triangle())) {}

  [[nodiscard]] const PlaneElement& whole() const { return whole_; }
  /// What a convex polygon of the triangle's parameters has in common with the element, in the element's
  /// parameters.
  [[nodiscard]] Polygon common(const Polygon& part) const {
    const Point u = place_[1] - place_[0];
    const Point v = place_[2] - place_[0];
    const Rational area = cross(u, v);
    Polygon rest;
    for (const Point& corner : part) {
      const Point from = corner - place_[0];
      rest.push_back({cross(from, v) / area, cross(u, from) / area});
    }
    return clipped(std::move(rest), std::span<const Point>(unit_triangle()));
  }
  [[nodiscard]] PlaneElement of(const Polygon& part) const {
    return {plane_polygon(origin_, first_, second_, {part}).value(), functions_, PlaneElement::usual_accuracy,
            sizes_};
  }

private:
  std::array<Point, 3> place_;
  Vector<Rational> origin_;
  Vector<Rational> first_;
  Vector<Rational> second_;
  const Polynomials& functions_;
  std::span<const double> sizes_;
  PlaneElement whole_;
};

/// The integrals of an element's functions, and what each is off by at most.
struct Integrals {
  std::vector<double> values;
  double error = 0;
};

/// Over all parts of an element that are seen.
class VisibleIntegrals {
public:
  VisibleIntegrals(const Element& element, const ExactNode& node, const IntegralErrors& errors,
                   std::size_t count)
      : element_(element), node_(node), errors_(errors), part_(count) {}

  [[nodiscard]] Integrals over(const std::vector<Polygon>& seen) {
    Rational area = 0;
    std::vector<Polygon> parts;
    for (const Polygon& polygon : seen) {
      Polygon part = element_.common(polygon);
      const Rational of_part = doubled_area(part);
      if (of_part.sign() == 0) continue;
      area += of_part;
      parts.push_back(std::move(part));
    }
    Integrals sum = nothing();
    if (area == Rational(1)) {
      add(element_.whole(), sum);
    } else {
      for (const Polygon& part : parts) add(element_.of(part), sum);
    }
    return sum;
  }
  [[nodiscard]] Integrals over_all() {
    Integrals sum = nothing();
    add(element_.whole(), sum);
    return sum;
  }
  [[nodiscard]] Integrals nothing() const {
    return {.values = std::vector<double>(part_.size(), 0.0), .error = 0};
  }

private:
  void add(const PlaneElement& part, Integrals& sum) {
    part.integrals(node_.point, node_.normal, part_);
    // The sums are rounded once a term, those of the radius twice.
    double size = 0;
    for (std::size_t j = 0; j < part_.size(); ++j) {
      sum.values[j] += part_[j];
      size = std::max(size, std::abs(sum.values[j]));
    }
    constexpr double unit = unit_roundoff<double>();
    sum.error = (sum.error + errors_.bound(part_) + unit * size) * (1 + 4 * unit);
  }

  const Element& element_;
  const ExactNode& node_;
  const IntegralErrors& errors_;
  std::vector<double> part_;
};

}  // namespace

Outcome<CertifiedEntries> certified_visible_entries(const Scene& scene,
                                                    std::span<const SceneElement> elements,
                                                    const LagrangeFunctions& functions,
                                                    std::span<const double> reflectivity) {
  const std::size_t p = functions.size();
  const std::size_t n = elements.size() * p;
  expects_collocation_data(functions, n, reflectivity);
  std::vector<ExactTriangle> corners;
  std::vector<std::vector<std::size_t>> of_triangle(scene.triangle_count());
  for (std::size_t k = 0; k < elements.size(); ++k) {
    check(scene, elements[k]);
    corners.push_back(in_space(scene, elements[k]));
    of_triangle[elements[k].triangle].push_back(k);
  }
  const Outcome<IntegralErrors> errors = IntegralErrors::of(functions);
  if (!errors) return because(errors.reason());
  Outcome<ExactNodes> nodes = exact_nodes(corners, functions);
  if (!nodes) return because(nodes.reason());
  const Outcome<Scaled> in_unit = scaled(scene, std::move(nodes).value());
  if (!in_unit) return because(in_unit.reason());

  const Polynomials polynomials = by_monomials(functions);
  const std::vector<double> sizes(p, errors->largest_value());
  std::vector<Element> prepared;
  prepared.reserve(elements.size());
  for (std::size_t k = 0; k < elements.size(); ++k)
    prepared.emplace_back(elements[k], corners[k], in_unit->scale, polynomials, sizes);

  CertifiedEntries result{.entries = Matrix<double>::uninitialised(n, n),
                          .radius = Matrix<double>::uninitialised(n, n)};
  parallel_for(n, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const ExactNode& node = in_unit->nodes[i];
      const Viewpoint from{.point = node.point, .normal = node.normal, .triangle = elements[i / p].triangle};
      PointView view(in_unit->scene, from);
      for (std::size_t triangle = 0; triangle < of_triangle.size(); ++triangle) {
        if (of_triangle[triangle].empty()) continue;
        const VisibleRegion region = view.region(triangle);
        std::vector<Polygon> seen;
        if (region.sight == Sight::part)
          for (const VisiblePart& part : region.parts)
            seen.push_back(exact_corners(in_unit->scene, from, triangle, part));
        for (const std::size_t k : of_triangle[triangle]) {
          VisibleIntegrals visible(prepared[k], node, *errors, p);
          const Integrals integrals = region.sight == Sight::nothing ? visible.nothing()
                                      : region.sight == Sight::whole ? visible.over_all()
                                                                     : visible.over(seen);
          for (std::size_t j = 0; j < p; ++j) {
            const Approximation entry =
                certified_entry(reflectivity[i], integrals.values[j], integrals.error);
            result.entries(i, k * p + j) = entry.value;
            result.radius(i, k * p + j) = entry.radius;
          }
        }
      }
    }
  });
  return result;
}

Outcome<CertifiedEntries> certified_mesh_entries(const Surface& mesh, const Triangulation& triangulation,
                                                 const LagrangeFunctions& functions) {
  const SurfaceScene scene(mesh);
  // The scene has s and t of the charts in the other order then.
  const bool exchange = mesh.charts.front().facts().orientation == Orientation::against_the_cross_product;
  const auto places = places_when_exchanged(functions);
  if (exchange && !places)
    return because(
        "the nodes and their functions are not symmetric to an exchange of two corners, as the mesh's "
        "normals ask");
  std::vector<SceneElement> elements;
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    SceneElement element{.triangle = triangle.chart};
    for (std::size_t c = 0; c < 3; ++c) {
      const ParameterPoint<double>& v = triangle.vertices[c];
      const Rational s = Rational::exactly(v.s);
      const Rational t = Rational::exactly(v.t);
      element.corners[exchange ? (3 - c) % 3 : c] = exchange ? Point{t, s} : Point{s, t};
    }
    elements.push_back(std::move(element));
  }
  Outcome<CertifiedEntries> found = certified_visible_entries(
      scene.scene(), elements, functions, std::vector<double>(elements.size() * functions.size(), 1.0));
  if (!found || !exchange) return found;
  return reordered(*found, std::vector<bool>(elements.size(), true), *places);
}

}  // namespace radcert
