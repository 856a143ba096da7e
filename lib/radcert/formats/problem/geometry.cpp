// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/formats/problem/problem_parts.h"

namespace radcert {

namespace {

constexpr int smallest_degree = 1;
constexpr int largest_degree = 6;
constexpr const char* geometry_allowed = "exact, or an object with the key interpolated";
constexpr const char* degree_allowed = "a whole number from 1 to 6: the degree of the interpolated surface";
constexpr const char* on_surface = "surface";
constexpr const char* on_interpolant = "interpolant";

}  // namespace

std::vector<std::string> data_point_names() { return {on_surface, on_interpolant}; }

std::optional<InterpolatedGeometry> read_geometry(const JsonReader& geometry) {
  if (geometry.value().string() != nullptr) {
    const std::vector<std::string> words = {"exact"};
    (void)geometry.word(words);
    return std::nullopt;
  }
  if (geometry.value().members() == nullptr)
    geometry.refuse("is " + geometry.value().kind(), geometry_allowed);
  geometry.require_object({"interpolated", "data"});
  InterpolatedGeometry interpolated;
  interpolated.degree = static_cast<int>(
      geometry.at("interpolated", degree_allowed).whole(smallest_degree, largest_degree, degree_allowed));
  if (const auto data = geometry.find("data"))
    interpolated.data =
        data->word(data_point_names()) == on_interpolant ? DataPoints::interpolant : DataPoints::surface;
  return interpolated;
}

JsonValue geometry_json(const std::optional<InterpolatedGeometry>& geometry) {
  if (!geometry) return "exact";
  JsonValue out = JsonValue::object();
  out.set("interpolated", geometry->degree);
  out.set("data", geometry->data == DataPoints::interpolant ? on_interpolant : on_surface);
  return out;
}

}  // namespace radcert
