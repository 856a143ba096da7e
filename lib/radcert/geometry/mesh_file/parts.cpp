// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_file/parts.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/control_characters.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/scalar/decimal.h"
#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

// Fourth powers of distances must neither overflow nor lose digits to underflow.
constexpr double largest_coordinate = 1e60;
constexpr const char* coordinate_allowed =
    "a decimal number such as -1.5e-3, 0 or of a size from 5e-324 to 1e60";

/// The digits of a printed number from the first that is not zero.
std::size_t printed_digits(std::string_view text) {
  std::size_t digits = 0;
  for (const char c : text) {
    if (c == 'e' || c == 'E') break;
    if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
  }
  return digits;
}

/// What a decimal may differ by from the double nearest to it.
double half_a_unit_in_the_last_place(double value) {
  return value == 0
             ? 0
             : std::max(std::ldexp(1.0, std::ilogb(value) - 53), std::numeric_limits<double>::denorm_min());
}

/// Whether a decimal is this double.
bool is_exactly(std::string_view text, double value) {
  const Outcome<Rational> decimal = Rational::parse(text);
  return decimal && *decimal == Rational::exactly(value);
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::uint64_t number_in(const std::string& place) {
  std::uint64_t number = 0;
  const std::size_t begin = place.find_first_of("0123456789");
  std::from_chars(place.data() + std::min(begin, place.size()), place.data() + place.size(), number);
  return number;
}

}  // namespace

void refuse_mesh(const std::string& place, std::optional<std::string> value, const std::string& problem,
                 const std::string& allowed) {
  throw InputError({.pointer = place, .value = std::move(value), .problem = problem, .allowed = allowed});
}

double MeshBuilder::coordinate(std::string_view text, const std::string& place) {
  if (!is_decimal(text)) {
    const std::string word = lower(text);
    const bool endless = word.find("nan") != std::string::npos || word.find("inf") != std::string::npos;
    refuse_mesh(place, std::string(text), endless ? "is not finite" : "is no decimal number",
                coordinate_allowed);
  }
  const bool is_zero = printed_digits(text) == 0;  // whatever the exponent
  const std::optional<double> value =
      is_zero ? 0.0 : parse_double(text.starts_with('+') ? text.substr(1) : text);
  if (!value || (*value == 0 && !is_zero))
    refuse_mesh(place, std::string(text), "is no number that a double holds", coordinate_allowed);
  most_digits_ = std::max(most_digits_, printed_digits(text));
  const double half_a_place = half_a_unit_in_the_last_place(*value);
  if (half_a_place > mesh_.precision.rounding && !is_exactly(text, *value))
    mesh_.precision.rounding = half_a_place;
  return coordinate(*value, place);
}

double MeshBuilder::coordinate(double value, const std::string& place) const {
  if (!std::isfinite(value)) refuse_mesh(place, shortest(value), "is not finite", coordinate_allowed);
  if (std::abs(value) > largest_coordinate)
    refuse_mesh(place, shortest(value), "is too large", coordinate_allowed);
  return value;
}

void MeshBuilder::end_face(const std::string& place) {
  const std::size_t begin = mesh_.face_begin.back();
  const std::size_t corners = mesh_.corner.size() - begin;
  if (corners < 3)
    refuse_mesh(place, std::to_string(corners), "corners make no face", "faces of at least 3 corners");
  mesh_.unit_of_place = place.substr(0, place.find(' '));
  mesh_.face_place.push_back(number_in(place));
  mesh_.face_begin.push_back(mesh_.corner.size());
  const auto [found, is_new] = group_places_.try_emplace(group_, mesh_.group_names.size());
  mesh_.group.push_back(found->second);
  if (!is_new) return;
  if (has_control_characters(group_))
    refuse_mesh(place, group_, "is a group's name with control characters", "names of printable characters");
  mesh_.group_names.push_back(group_);
}

void MeshBuilder::join_vertices() {
  const std::vector<Vector<double>>& all = mesh_.vertices;
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return std::tie(all[i].x, all[i].y, all[i].z); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto first = key(a);
    const auto second = key(b);
    return first != second ? first < second : a < b;
  });
  // Of equal vertices the first in the file stands for all.
  std::vector<std::size_t> first(all.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? first[order[k - 1]] : order[k];
  std::vector<std::size_t> renumbered(all.size());
  std::vector<Vector<double>> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (first[i] == i) {
      renumbered[i] = kept.size();
      kept.push_back(all[i]);
    } else {
      renumbered[i] = renumbered[first[i]];
    }
  }
  mesh_.joined_corners = all.size() - kept.size();
  for (std::size_t& corner : mesh_.corner) corner = renumbered[corner];
  mesh_.vertices = std::move(kept);
}

MeshFile MeshBuilder::finish(const std::string& format, std::optional<int> bits) {
  if (mesh_.vertices.empty()) refuse_mesh("", std::nullopt, "has no vertices", "a mesh with faces");
  if (mesh_.face_count() == 0) refuse_mesh("", std::nullopt, "has no faces", "a mesh with faces");
  // As the file counts its vertices.
  const std::size_t first = format == "OBJ" ? 1 : 0;
  std::vector<std::size_t> sorted;
  for (std::size_t k = 0; k < mesh_.face_count(); ++k) {
    const auto begin = mesh_.corner.begin() + static_cast<std::ptrdiff_t>(mesh_.face_begin[k]);
    const auto end = mesh_.corner.begin() + static_cast<std::ptrdiff_t>(mesh_.face_begin[k + 1]);
    const std::string place = mesh_.unit_of_place + " " + std::to_string(mesh_.face_place[k]);
    sorted.assign(begin, end);
    std::sort(sorted.begin(), sorted.end());
    if (sorted.back() >= mesh_.vertices.size())
      refuse_mesh(place, std::to_string(sorted.back() + first),
                  "is the index, counted from " + std::to_string(first) + ", of a vertex that is not there",
                  "indices from " + std::to_string(first) + " to " +
                      std::to_string(mesh_.vertices.size() - 1 + first));
    const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
    // Joined corners of an STL triangle are a degenerate face, which is reported as such.
    if (repeated != sorted.end() && mesh_.joined_corners == 0)
      refuse_mesh(place, std::to_string(*repeated + first),
                  "is the index, counted from " + std::to_string(first) + ", of two corners of one face",
                  "faces whose corners are different vertices");
  }
  double largest = 0;
  for (const Vector<double>& v : mesh_.vertices)
    largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const double ulp_of_double = std::ldexp(1.0, std::ilogb(std::max(largest, 1e-300)) - 53);
  mesh_.precision.unit = ulp_of_double;
  if (bits) {
    mesh_.precision.unit = std::ldexp(ulp_of_double, 53 - *bits);
    mesh_.precision.words = *bits == 24 ? "32-bit floats" : "doubles";
  } else {
    const auto digits = static_cast<double>(std::max<std::size_t>(most_digits_, 1));
    if (largest > 0)
      mesh_.precision.unit =
          std::max(ulp_of_double, 0.5 * std::pow(10.0, std::floor(std::log10(largest)) - digits + 1));
    mesh_.precision.words = "printed with " + std::to_string(std::max<std::size_t>(most_digits_, 1)) +
                            (most_digits_ > 1 ? " digits" : " digit");
  }
  mesh_.format = format;
  return std::move(mesh_);
}

std::optional<std::vector<std::string_view>> TextLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    ++number_;
    if (comment_ != '\0') line = line.substr(0, line.find(comment_));
    line_ = line;
    std::vector<std::string_view> words;
    constexpr std::string_view blanks = " \t\r\f\v";
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
      const std::size_t stop = std::min(line.find_first_of(blanks, at), line.size());
      words.push_back(line.substr(at, stop - at));
      at = line.find_first_not_of(blanks, stop);
    }
    if (!words.empty()) return words;
  }
  return std::nullopt;
}

void require_number(std::string_view text, const std::string& place) {
  if (!is_decimal(text)) refuse_mesh(place, std::string(text), "is no decimal number", "numbers");
}

long long whole_number(std::string_view text, const std::string& place, const std::string& allowed) {
  long long number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    refuse_mesh(place, std::string(text), "is no whole number", allowed);
  return number;
}

}  // namespace radcert
