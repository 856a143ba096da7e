// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "radcert/core/digest.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/hypotheses/mesh_survey.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/surface/catalogue.h"

namespace radcert {

namespace {

/// Names, in the file format, of surfaces whose parts hide each other.
const std::vector<std::string> occluded_surfaces = {"torus", "sphere_over_disk", "concentric_spheres"};

/// What a problem with a mesh may state beside the file.
const std::vector<std::string> mesh_keys = {"file", "angle", "repair", "front", "digest"};

Rational read_angle(const JsonReader& surface) {
  const std::string allowed = "an angle in degrees, from 0 to 180";
  const auto given = surface.find("angle");
  if (!given) return Rational::exactly(default_sharp_degrees);
  const Rational angle = given->rational(allowed);
  if (angle.sign() < 0 || angle > Rational(180)) given->refuse("is outside the range", allowed);
  return angle;
}

std::vector<std::string> read_repair(const JsonReader& surface) {
  const std::vector<std::string> known(repair_words.begin(), repair_words.end());
  std::vector<std::string> words;
  if (const auto given = surface.find("repair"))
    for (const JsonReader& word : given->elements("a list of " + listed(known)))
      words.push_back(word.word(known));
  return words;
}

FrontRule read_front(const JsonReader& surface) {
  const auto given = surface.find("front");
  if (!given) return FrontRule::automatic;
  const std::vector<std::string> known(front_words.begin(), front_words.end());
  const auto at = std::find(known.begin(), known.end(), given->word(known));
  return static_cast<FrontRule>(at - known.begin());
}

SurfaceChoice read_mesh(const JsonReader& surface, const JsonReader& file,
                        const std::filesystem::path& folder) {
  surface.require_object(mesh_keys);
  const std::string& name = file.string("the name of a mesh file, relative to the problem's folder");
  const Rational angle = read_angle(surface);
  const std::vector<std::string> repair = read_repair(surface);
  const FrontRule front = read_front(surface);
  const std::filesystem::path path = folder / name;
  if (!is_mesh_file_name(name)) file.refuse("has no name of a mesh file", "names in " + mesh_file_endings());
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    file.refuse("is not there", "a mesh file, its name relative to the problem's folder");
  const MeshSurvey survey = survey_mesh(path, angle.to_double(), repair_named(repair), front);
  require_digest(surface, survey.digest);
  if (const auto fault =
          mesh_surface_fault(name, survey, "\"front\": \"right-hand\" or \"left-hand\" beside the file"))
    file.refuse(fault->problem, fault->allowed);
  return mesh_surface_choice(name, survey, angle, repair, front);
}

Rational default_value(const ParameterDescription& parameter) {
  return Rational::parse(parameter.default_text).value();
}

}  // namespace

std::optional<InputFault> mesh_surface_fault(const std::string& name, const MeshSurvey& survey,
                                             const std::string& front_allowed) {
  const std::optional<std::string> obstacle = survey.obstacle();
  if (survey.degrees_turned > 0)
    return InputFault{
        .source = name,
        .problem = "was turned by " + nearest_text(survey.degrees_turned, DecimalForm::general(6)) +
                   " degrees by repair align, and a problem's x, y, z are those of its file",
        .allowed = "the file that radcert surface " + name + " --repair align --write FILE.obj writes"};
  if (survey.needs_front()) return InputFault{.source = name, .problem = *obstacle, .allowed = front_allowed};
  if (!obstacle) return std::nullopt;
  return InputFault{
      .source = name,
      .problem = *obstacle,
      .allowed =
          "a mesh of triangles that neither cross nor run against each other; see radcert surface " + name};
}

SurfaceChoice mesh_surface_choice(const std::string& name, const MeshSurvey& survey, const Rational& angle,
                                  const std::vector<std::string>& repair, FrontRule front) {
  return {.name = name,
          .parameters = {},
          .mesh = MeshChoice{.file = name,
                             .digest = survey.digest,
                             .angle = angle,
                             .repair = repair,
                             .mended = survey.mended,
                             .remarks = survey.remarks,
                             .surface = std::make_shared<const Surface>(survey.surface(name)),
                             .front = front}};
}

std::vector<std::string> surface_names() {
  std::vector<std::string> names;
  for (const SurfaceDescription& surface : surface_catalogue())
    if (surface.unoccluded) names.push_back(surface.name);
  return names;
}

void require_digest(const JsonReader& object, const std::string& digest) {
  const auto given = object.find("digest");
  if (!given) return;
  const std::string& text = given->string("the digest of the file");
  if (text == digest) return;
  given->refuse(is_digest(text) ? "is not that of the file: it has changed"
                                : "is no SHA-256 digest: whether the file has changed cannot be told",
                digest);
}

SurfaceChoice read_surface(const JsonReader& surface, const std::filesystem::path& folder) {
  if (surface.value().members() == nullptr) surface.refuse("is " + surface.value().kind(), "an object");
  const std::vector<std::string> available = surface_names();
  if (const auto file = surface.find("file")) return read_mesh(surface, *file, folder);
  const JsonReader named = surface.at("name", "one of " + listed(available));
  for (const std::string& occluded : occluded_surfaces)
    if (named.value().string() && *named.value().string() == occluded)
      named.refuse(
          "has curved parts that hide each other: visibility of curved parts is not available in this "
          "version, only of "
          "plane triangles",
          listed(available) + ", or {\"file\": a mesh of it}");
  const std::string& name = named.word(available);

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
  // Of charts of a program's own the name says what they are; no file has them.
  if (surface.mesh && surface.mesh->surface->mesh) {
    out.set("file", surface.mesh->file);
    out.set("angle", exact_json(surface.mesh->angle));
    out.set("repair", json_array(surface.mesh->repair));
    out.set("front", std::string(front_words[static_cast<std::size_t>(surface.mesh->front)]));
    out.set("digest", surface.mesh->digest);
    return out;
  }
  out.set("name", surface.name);
  for (const SurfaceParameter& parameter : surface.parameters)
    out.set(parameter.name, exact_json(parameter.value));
  return out;
}

}  // namespace radcert
