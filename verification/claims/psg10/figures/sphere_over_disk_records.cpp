// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/figures/sphere_over_disk_records.h"

#include <array>
#include <charconv>

#include "radcert/core/errors.h"
#include "radcert/formats/table/csv.h"
#include "verification/claims/psg10/sphere_over_disk/estimate.h"

namespace radcert::verification::psg10 {

namespace {

constexpr int most_curve_points = 100000;

/// The scene of the arguments; what they forbid together is refused here.
SphereOverDiskScene scene_of(const SphereOverDiskWish& wish) {
  const SphereOverDiskScene scene = sphere_over_disk_scene(wish.arguments);
  const std::string above = "a number > radius, which is " + scene.radius.to_text();
  if (scene.height <= scene.radius)
    throw InputError({.source = "--set height", .value = scene.height.to_text(), .allowed = above});
  if (scene.disk_radius <= scene.radius)
    throw InputError({.source = "--set disk_radius", .value = scene.disk_radius.to_text(), .allowed = above});
  return scene;
}

SphereOverDiskPoint point_of(const std::string& text, const SphereOverDiskScene& scene) {
  const std::string latitudes = "a latitude in [-pi/2, pi/2]";
  const std::string distances = "a distance from the axis in [0, " + scene.disk_radius.to_text() + "]";
  const bool on_sphere = text.starts_with("B:");
  if (!on_sphere && !text.starts_with("D:"))
    throw InputError({.source = "--at",
                      .value = text,
                      .allowed = "B:LATITUDE, " + latitudes + ", or D:DISTANCE, " + distances});
  const std::string place = text.substr(2);
  SphereOverDiskPoint point{
      .part = on_sphere ? SphereOverDiskPoint::Part::sphere : SphereOverDiskPoint::Part::disk, .place = 0};
  if (on_sphere && (place == "pi/2" || place == "-pi/2")) {
    point.poles = place == "pi/2" ? 1 : -1;
    return point;
  }
  const Outcome<Rational> number = Rational::parse(place);
  if (number) point.place = *number;
  if (!number || !allows(scene, point))
    throw InputError({.source = on_sphere ? "--at B" : "--at D",
                      .value = place,
                      .allowed = on_sphere ? latitudes + "; pi/2 and -pi/2 are the poles" : distances});
  return point;
}

std::string place_text(const SphereOverDiskPoint& point) {
  if (point.poles != 0) return point.poles > 0 ? "pi/2" : "-pi/2";
  return point.place.to_text();
}

}  // namespace

std::vector<ReferenceRecord> sphere_over_disk_records(const SphereOverDiskWish& wish) {
  const SphereOverDiskScene scene = scene_of(wish);
  if (wish.digits > most_sphere_over_disk_digits)
    throw InputError({.source = "--digits",
                      .value = std::to_string(wish.digits),
                      .allowed = "for " + std::string(sphere_over_disk_name) + " a whole number from 1 to " +
                                 std::to_string(most_sphere_over_disk_digits)});
  std::vector<SphereOverDiskPoint> points;
  for (const std::string& at : wish.at) points.push_back(point_of(at, scene));
  const auto found = estimate(scene, points, wish.digits);
  if (!found)
    throw AccuracyNotReached(
        std::string(sphere_over_disk_name),
        "a radius of 1e-" + std::to_string(wish.digits) + " was not reached; " + found.reason());
  std::vector<ReferenceRecord> records;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool on_sphere = points[i].part == SphereOverDiskPoint::Part::sphere;
    ReferenceRecord record;
    record.name = sphere_over_disk_name;
    const auto parameters = sphere_over_disk_parameters();
    for (std::size_t k = 0; k < parameters.size(); ++k)
      record.parameters.emplace_back(parameters[k].name, wish.arguments[k].to_text());
    record.parameters.emplace_back(on_sphere ? "latitude" : "distance", place_text(points[i]));
    record.digits = wish.digits;
    record.formula = on_sphere ? "B(zeta) = B*(zeta) + beta Int D cos cos'/(pi d^2) over the disk"
                               : "D(u) = D*(u) + beta Int B cos cos'/(pi d^2) over the sphere";
    record.source = "psg10 (20)-(21)";
    record.routes = {{sphere_over_disk_route(), (*found)[i].total},
                     {sphere_over_disk_second_route(), (*found)[i].second}};
    record.guaranteed = false;
    records.push_back(std::move(record));
  }
  return records;
}

std::string sphere_over_disk_csv(const SphereOverDiskWish& wish) {
  int count = 0;
  const auto [end, error] =
      std::from_chars(wish.points.data(), wish.points.data() + wish.points.size(), count);
  if (error != std::errc() || end != wish.points.data() + wish.points.size() || count < 2 ||
      count > most_curve_points)
    throw InputError({.source = "--points",
                      .value = wish.points,
                      .allowed = "a whole number from 2 to " + std::to_string(most_curve_points)});
  static constexpr std::array<std::string_view, 6> columns = {"curve", "place",    "lit",
                                                              "total", "emission", "indirect"};
  CsvTable table(columns);
  for (const CurvePoint& point : curves(scene_of(wish), count)) {
    const std::array<JsonValue, columns.size()> row = {
        point.part == SphereOverDiskPoint::Part::sphere ? "B" : "D",
        point.place,
        point.lit,
        point.total,
        point.emission,
        point.indirect};
    table.add(row);
  }
  return table.text();
}

}  // namespace radcert::verification::psg10
