// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/picture/png.h"
#include "radcert/picture/rendering.h"
#include "radcert/picture/sheet.h"
#include "radcert/surface/mesh_surface.h"
#include "radcert/visibility/scene.h"
#include "requests/solve_request.h"
#include "work.h"

namespace radcert::python {

namespace {

/// What Python says of a picture.
struct Wanted {
  std::array<double, 3> position;
  std::array<double, 3> look_at;
  std::array<double, 3> up;
  double angle = 0;
  std::array<std::int64_t, 2> size;
  std::int64_t samples = 2;
  std::optional<double> low;
  std::optional<double> high;
  std::string scale;
  std::string of;
  bool words = true;
};

[[noreturn]] void refuse(const std::string& place, const std::string& value, const std::string& allowed) {
  throw InputError({.source = "picture", .pointer = "/" + place, .value = value, .allowed = allowed});
}

Vector<double> point_of(const std::array<double, 3>& p, const std::string& place) {
  for (const double x : p)
    if (!(std::abs(x) <= Scene::largest_coordinate))
      refuse(place, std::to_string(x), "finite numbers that are not larger than those of a mesh");
  return {p[0], p[1], p[2]};
}

CameraPose pose_of(const Wanted& wanted) {
  const CameraPose pose{.position = point_of(wanted.position, "position"),
                        .look_at = point_of(wanted.look_at, "look_at"),
                        .up = point_of(wanted.up, "up"),
                        .vertical_angle = wanted.angle};
  if (!(wanted.angle > 0) || !(wanted.angle < std::numbers::pi))
    refuse("angle", std::to_string(wanted.angle), "an angle between 0 and pi, in radians");
  const Vector<double> forward = pose.look_at - pose.position;
  if (!(norm(forward) > 0)) refuse("look_at", "the position", "another point than the position");
  if (!(norm(cross(forward, pose.up)) > 0))
    refuse("up", "along the line of sight", "a direction across the line of sight");
  return pose;
}

std::size_t side_of(std::int64_t side) {
  if (side < 64 || side > 4096) refuse("size", std::to_string(side), "pixels, from 64 to 4096");
  return static_cast<std::size_t>(side);
}

/// The least length of a scale, in units of its larger end.
constexpr double narrowest = 1e-6;

ColourScale scale_of(const Wanted& wanted, const std::vector<ElementValue>& elements) {
  if (wanted.scale != "map" && wanted.scale != "light") refuse("scale", wanted.scale, "map, light");
  double least = elements.front().corner_values[0];
  double largest = least;
  for (const ElementValue& element : elements)
    for (const double value : element.corner_values) {
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
  const bool light = wanted.scale == "light";
  const double low = wanted.low.value_or(light ? 0 : least);
  // One colour for all where u_n is one number but for rounding; a narrower scale has no room for its ticks.
  const auto has_room = [&](double end) {
    return end - low > narrowest * std::max(std::abs(low), std::abs(end));
  };
  const double high = wanted.high.value_or(has_room(largest) ? largest : low + std::max(1.0, std::abs(low)));
  if (!std::isfinite(low) || !std::isfinite(high) || !has_room(high))
    refuse("high", std::to_string(high), "finite numbers, low below high by a millionth of them and more");
  return {.kind = light ? ColourScale::Kind::light : ColourScale::Kind::map, .low = low, .high = high};
}

/// The plane triangles between the corners of the elements, and of which element each is.
struct Facets {
  TriangleMesh mesh;
  std::vector<std::size_t> element;
};

Facets facets_of(const LevelOutcome& level) {
  std::vector<std::optional<Vector<double>>> normals(level.elements.size());
  for (const NodeValue& node : level.nodes)
    if (node.element < normals.size() && !normals[node.element]) normals[node.element] = node.normal;
  Facets out;
  out.mesh.group_names = {""};
  for (std::size_t i = 0; i < level.elements.size(); ++i) {
    auto [a, b, c] = level.elements[i].corners;
    const Vector<double> across = cross(b - a, c - a);
    // Elements at a pole may be flat between their corners.
    if (!(norm(across) > 0) || !normals[i]) continue;
    if (dot(across, *normals[i]) < 0) std::swap(b, c);
    const std::size_t first = out.mesh.vertices.size();
    out.mesh.vertices.insert(out.mesh.vertices.end(), {a, b, c});
    out.mesh.triangles.push_back({first, first + 1, first + 2});
    out.mesh.group.push_back(0);
    out.mesh.face.push_back(out.element.size());
    out.element.push_back(i);
  }
  return out;
}

/// Linear between the values at the corners.
double value_at(const ElementValue& element, const Vector<double>& p) {
  const auto& [a, b, c] = element.corners;
  const Vector<double> across = cross(b - a, c - a);
  const double whole = dot(across, across);
  const double of_b = dot(cross(p - a, c - a), across) / whole;
  const double of_c = dot(cross(b - a, p - a), across) / whole;
  const auto& [u_a, u_b, u_c] = element.corner_values;
  return (1 - of_b - of_c) * u_a + of_b * u_b + of_c * u_c;
}

/// The elements with the values that are shown at their corners.
std::vector<ElementValue> shown_elements(const LevelOutcome& level, const std::string& of) {
  if (level.elements.empty())
    throw InputError({.source = "picture",
                      .problem = "has no elements to show",
                      .allowed = "a solution on triangles, of one run and not of an experiment"});
  std::vector<ElementValue> elements = level.elements;
  if (of == "u_n") return elements;
  if (of != "iterated") refuse("of", of, "u_n, iterated");
  for (ElementValue& element : elements) {
    if (!element.iterated) refuse("of", of, "u_n, or a problem with \"iterated\": true");
    element.corner_values = *element.iterated;
  }
  return elements;
}

std::string picture_of(const LevelOutcome& level, const Wanted& wanted) {
  const std::vector<ElementValue> elements = shown_elements(level, wanted.of);
  const CameraPose pose = pose_of(wanted);
  const std::size_t width = side_of(wanted.size[0]);
  const std::size_t height = side_of(wanted.size[1]);
  if (wanted.samples < 1 || wanted.samples > 8)
    refuse("samples", std::to_string(wanted.samples), "a whole number from 1 to 8");
  const ColourScale scale = scale_of(wanted, elements);
  const Facets facets = facets_of(level);
  const std::vector<std::size_t> piece(facets.element.size(), 0);
  const std::vector<std::string> names{"all"};
  const Outcome<RayCaster> caster = RayCaster::make(mesh_surface(
      "picture", facets.mesh, piece, names, {.orientation = Orientation::along_the_cross_product}));
  if (!caster)
    throw InputError({.source = "picture", .problem = caster.reason(), .allowed = "plane elements"});
  Sheet sheet({.width = width, .height = height, .has_words = wanted.words, .has_scale = wanted.words});
  const std::string shown = wanted.of == "u_n" ? "u_n" : "E + K u_n";
  const ImageRegion panel = sheet.panel(0, 0, wanted.words ? shown : "");
  const PointValue value = [&](const LitPoint& at) -> std::optional<double> {
    return value_at(elements[facets.element[at.chart]], at.site.point);
  };
  show(sheet.image, {.camera = pose, .picture = panel, .samples = static_cast<std::size_t>(wanted.samples)},
       caster.value(), [&] { return value; }, {.scale = scale});
  const std::string description = shown + " by radcert";
  if (!wanted.words) return png_bytes(sheet.image, description);
  sheet.add_scale(panel, scale);
  return sheet.svg_text(description);
}

}  // namespace

void add_pictures(py::module_& module) {
  module.def(
      "picture",
      [](const app::Solution& solution, std::size_t place, const std::array<double, 3>& position,
         const std::array<double, 3>& look_at, const std::array<double, 3>& up, double angle,
         const std::array<std::int64_t, 2>& size, std::int64_t samples, std::optional<double> low,
         std::optional<double> high, const std::string& scale, const std::string& of, bool words,
         const py::object& progress) {
        if (place >= solution.levels.size())
          refuse("level", std::to_string(place),
                 "a place among " + std::to_string(solution.levels.size()) + " levels");
        const Wanted wanted{.position = position,
                            .look_at = look_at,
                            .up = up,
                            .angle = angle,
                            .size = size,
                            .samples = samples,
                            .low = low,
                            .high = high,
                            .scale = scale,
                            .of = of,
                            .words = words};
        return py::bytes(
            compute(progress, [&](Progress&) { return picture_of(solution.levels[place], wanted); }));
      },
      py::arg("solution"), py::arg("place"), py::arg("position"), py::arg("look_at"), py::arg("up"),
      py::arg("angle"), py::arg("size"), py::arg("samples"), py::arg("low"), py::arg("high"),
      py::arg("scale"), py::arg("of"), py::arg("words"), py::arg("progress"));
}

}  // namespace radcert::python
