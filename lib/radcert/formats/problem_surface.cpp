// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/formats/problem_parts.h"
#include "radcert/surface/catalogue.h"

namespace radcert {

namespace {

/// Names that the file format knows and this version does not serve.
const std::vector<std::string> planned_surfaces = {"spherical_cap",  "cylinder",    "cone",
                                                   "paraboloid_cap", "tetrahedron", "octahedron"};

/// Names that the file format knows of surfaces parts of which hide others.
const std::vector<std::string> occluded_surfaces = {"torus", "sphere_over_disk", "concentric_spheres"};

std::vector<std::string> available_surfaces() {
  std::vector<std::string> names;
  for (const SurfaceDescription& surface : surface_catalogue()) names.push_back(surface.name);
  return names;
}

Rational default_value(const ParameterDescription& parameter) {
  return Rational::parse(parameter.default_text).value();
}

}  // namespace

SurfaceChoice read_surface(const JsonReader& surface) {
  if (surface.value().members() == nullptr) surface.refuse("is " + surface.value().kind(), "an object");
  const std::vector<std::string> available = available_surfaces();
  if (const auto file = surface.find("file"))
    file->refuse("names a mesh, which is not available in this version",
                 "the key name with one of " + listed(available));
  const JsonReader named = surface.at("name", "one of " + listed(available));
  for (const std::string& occluded : occluded_surfaces)
    if (named.value().string() && *named.value().string() == occluded)
      named.refuse("needs visibility, which is not available in this version", listed(available));
  const std::string& name = named.word(available, planned_surfaces);

  const SurfaceDescription& description = *find_surface(name);
  std::vector<std::string> keys{"name"};
  for (const ParameterDescription& parameter : description.parameters) keys.push_back(parameter.name);
  surface.require_object(keys);

  SurfaceChoice choice{.name = name, .parameters = {}};
  for (const ParameterDescription& parameter : description.parameters) {
    SurfaceParameter given{.name = parameter.name, .value = default_value(parameter)};
    if (const auto place = surface.find(parameter.name)) {
      const std::string allowed =
          parameter.requirement + ", as a number or as a decimal or fraction in a string";
      given.value = place->rational(allowed);
      if (!parameter.admits(given.value)) place->refuse("is outside the range", allowed);
    }
    choice.parameters.push_back(given);
  }
  return choice;
}

JsonValue exact_json(const Rational& value) {
  const Rational largest(std::int64_t{1} << 53);
  if (value.is_integer() && abs(value) <= largest) return *value.to_long();
  return value.to_text();
}

JsonValue surface_json(const SurfaceChoice& surface) {
  JsonValue out = JsonValue::object();
  out.set("name", surface.name);
  for (const SurfaceParameter& parameter : surface.parameters)
    out.set(parameter.name, exact_json(parameter.value));
  return out;
}

}  // namespace radcert
