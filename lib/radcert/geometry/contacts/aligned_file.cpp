// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/aligned_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/geometry/contacts/near_contacts.h"
#include "radcert/geometry/contacts/place.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {
namespace {

constexpr double same_direction = 1e-3;
constexpr std::size_t most_directions = 256;
/// Of the precision: how far coordinates of one plane may be apart, 2 by their roundings; where the mesh is
/// turned, by those of three coordinates and of the directions.
constexpr double apart = 2.5;
constexpr double apart_when_turned = 8;

/// The rows are the axes of the room.
using Rotation = std::array<Vector<double>, 3>;

constexpr Rotation identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Vector<double> unit(const Vector<double>& v) { return (1 / norm(v)) * v; }

double extent_of(const MeshFile& file) {
  double extent = 0;
  for (const Vector<double>& v : file.vertices)
    extent = std::max({extent, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return extent;
}

/// The normal of a face, as long as its area where `scale` is a unit of length.
Vector<double> area_of(const MeshFile& file, std::size_t face, double scale) {
  const std::size_t first = file.face_begin[face];
  const std::size_t last = file.face_begin[face + 1];
  const Vector<double>& origin = file.vertices[file.corner[first]];
  Vector<double> sum{};
  const auto side = [&](std::size_t k) { return scale * (file.vertices[file.corner[k]] - origin); };
  for (std::size_t k = first + 1; k + 1 < last; ++k) sum = sum + cross(side(k), side(k + 1));
  return 0.5 * sum;
}

/// Faces whose normals have one direction, up to the sign.
struct Direction {
  Vector<double> first;  ///< of its largest face
  Vector<double> sum;    ///< of all, by area
};

/// By the largest face, the largest first.
std::vector<Direction> directions(const MeshFile& file) {
  // Squares of areas are in the range of double whatever the unit of the file is.
  const double scale = std::ldexp(1.0, -std::ilogb(std::max(extent_of(file), 1e-300)));
  std::vector<Vector<double>> areas;
  for (std::size_t f = 0; f < file.face_count(); ++f)
    if (const Vector<double> area = area_of(file, f, scale); norm(area) > 0) areas.push_back(area);
  std::stable_sort(areas.begin(), areas.end(),
                   [](const auto& a, const auto& b) { return norm(a) > norm(b); });
  std::vector<Direction> found;
  for (const Vector<double>& area : areas) {
    const Vector<double> normal = unit(area);
    const auto same = std::find_if(found.begin(), found.end(), [&](const Direction& d) {
      return norm(cross(d.first, normal)) < same_direction;
    });
    if (same != found.end())
      same->sum = dot(same->first, area) > 0 ? same->sum + area : same->sum - area;
    else if (found.size() < most_directions)
      found.push_back({normal, area});
  }
  return found;
}

/// The axes of the room; none where no two directions are at right angles.
std::optional<Rotation> axes_of(const MeshFile& file) {
  const std::vector<Direction> found = directions(file);
  const auto by_area = [](const Direction& a, const Direction& b) { return norm(a.sum) < norm(b.sum); };
  const auto largest = std::max_element(found.begin(), found.end(), by_area);
  if (largest == found.end()) return std::nullopt;
  const Vector<double> a = unit(largest->sum);
  std::optional<Vector<double>> second;
  for (const Direction& other : found)
    if (std::abs(dot(a, unit(other.sum))) < same_direction && (!second || norm(other.sum) > norm(*second)))
      second = other.sum;
  if (!second) return std::nullopt;
  const Vector<double> b = unit(*second - dot(a, *second) * a);
  return Rotation{a, b, cross(a, b)};
}

/// The rotation with these axes, in any order and sense, that turns least.
Rotation nearest_rotation(const Rotation& axes) {
  Rotation best = identity;
  double largest = -4;
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      Rotation made;
      double trace = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        made[k] = ((signs >> k & 1U) != 0 ? -1.0 : 1.0) * axes[order[k]];
        trace += place_of(made[k])[k];
      }
      if (dot(made[0], cross(made[1], made[2])) > 0 && trace > largest) {
        largest = trace;
        best = made;
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

double degrees_of(const Rotation& r) {
  const double cosine = 0.5 * (r[0].x + r[1].y + r[2].z - 1);
  const Vector<double> sine{0.5 * (r[2].y - r[1].z), 0.5 * (r[0].z - r[2].x), 0.5 * (r[1].x - r[0].y)};
  return std::atan2(norm(sine), cosine) * 180 / std::numbers::pi;
}

/// One value for each run of values that follow each other within a tolerance; false where a run is longer.
bool make_equal(std::vector<double>& values, double tolerance, bool was_turned) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first + 1;
    while (last < order.size() && values[order[last]] - values[order[last - 1]] <= tolerance) ++last;
    const double low = values[order[first]];
    const double high = values[order[last - 1]];
    if (high - low > tolerance) return false;
    double one = low + 0.5 * (high - low);
    if (!was_turned && low < high) {
      // The value that most have is the author's.
      std::map<double, std::size_t> count;
      for (std::size_t k = first; k < last; ++k) ++count[values[order[k]]];
      one = std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) {
              return a.second < b.second;
            })->first;
    }
    for (std::size_t k = first; k < last; ++k) values[order[k]] = one;
    first = last;
  }
  return true;
}

/// Joins vertices that are equal now; says which face loses a corner by that.
std::optional<std::size_t> join_vertices(MeshFile& file) {
  std::map<Place, std::size_t> first;
  std::vector<std::size_t> renumbered;
  std::vector<Vector<double>> kept;
  for (const Vector<double>& v : file.vertices) {
    const auto [found, is_new] = first.emplace(place_of(v), kept.size());
    if (is_new) kept.push_back(v);
    renumbered.push_back(found->second);
  }
  file.joined_corners += file.vertices.size() - kept.size();
  file.vertices = std::move(kept);
  for (std::size_t& corner : file.corner) corner = renumbered[corner];
  for (std::size_t f = 0; f < file.face_count(); ++f) {
    std::vector<std::size_t> corners(
        file.corner.begin() + static_cast<std::ptrdiff_t>(file.face_begin[f]),
        file.corner.begin() + static_cast<std::ptrdiff_t>(file.face_begin[f + 1]));
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) return f;
  }
  return std::nullopt;
}

}  // namespace

Outcome<AlignedFile> aligned(MeshFile file) {
  const std::optional<Rotation> axes = axes_of(file);
  if (!axes) return because("no two directions of its faces are at right angles");
  const double extent = extent_of(file);
  const double precision = std::max(rounding_of(file.precision.unit, extent), 0x1p-50 * extent);
  Rotation rotation = nearest_rotation(*axes);
  double turn = 0;
  for (std::size_t k = 0; k < 3; ++k) turn = std::max(turn, norm(rotation[k] - identity[k]));
  const bool is_turned = turn * extent > apart_when_turned * precision;
  if (!is_turned) rotation = identity;
  AlignedFile out{.file = {}, .degrees = is_turned ? degrees_of(rotation) : 0};
  std::array<std::vector<double>, 3> coordinates;
  for (const Vector<double>& v : file.vertices)
    for (std::size_t k = 0; k < 3; ++k) coordinates[k].push_back(dot(rotation[k], v));
  std::array<std::vector<double>, 3> equal = coordinates;
  for (std::vector<double>& values : equal)
    if (!make_equal(values, (is_turned ? apart_when_turned : apart) * precision, is_turned))
      return because("coordinates follow each other more closely than the precision of the file, " +
                     nearest_text(precision, DecimalForm::general(2)) + ", tells them apart");
  for (std::size_t i = 0; i < file.vertices.size(); ++i) {
    const Vector<double> turned{coordinates[0][i], coordinates[1][i], coordinates[2][i]};
    file.vertices[i] = {equal[0][i], equal[1][i], equal[2][i]};
    out.moved = std::max(out.moved, norm(file.vertices[i] - turned));
  }
  // A difference and its norm are right to some 2^-51 of it, what the turn has brought a corner to, where it
  // moves something, to 9 2^-53 of the extent.
  if (out.moved > 0) out.moved = out.moved * (1 + 0x1p-48) + (is_turned ? 0x1p-49 * extent : 0);
  if (const std::optional<std::size_t> face = join_vertices(file))
    return because(file.face_text(*face) + " is no larger than the precision of the file");
  out.file = std::move(file);
  return out;
}

}  // namespace radcert
