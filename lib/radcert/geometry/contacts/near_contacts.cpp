// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/near_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/plane_classes.h"

namespace radcert {
namespace {

constexpr double next_to_nothing = 1e-9;  // of the diagonal
constexpr double infinity = std::numeric_limits<double>::infinity();

using Corners = std::array<Vector<double>, 3>;

Vector<double> front_of(const Corners& c, bool right_hand) {
  const Vector<double> normal = cross(c[1] - c[0], c[2] - c[0]);
  return ((right_hand ? 1 : -1) / norm(normal)) * normal;
}

struct Heights {
  double least;
  double largest;
};

/// Of corners above a plane.
Heights heights(const Corners& corners, const Vector<double>& normal, const Vector<double>& origin) {
  Heights out{infinity, -infinity};
  for (const Vector<double>& p : corners) {
    const double height = dot(normal, p - origin);
    out = {std::min(out.least, height), std::max(out.largest, height)};
  }
  return out;
}

/// Whether no line across a side of `one`, in its plane, leaves less than `least` of common width.
bool overlap_along_sides(const Corners& one, const Corners& other, const Vector<double>& normal,
                         double least) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<double> side = one[(k + 1) % 3] - one[k];
    const Vector<double> across = (1 / norm(side)) * cross(normal, side);
    const Heights a = heights(one, across, one[k]);
    const Heights b = heights(other, across, one[k]);
    if (std::min(a.largest, b.largest) - std::max(a.least, b.least) <= least) return false;
  }
  return true;
}

/// The mean of the corners of what one triangle has over another: it is cut along the other's sides.
Vector<double> amid_overlap(const Corners& one, const Corners& other, const Vector<double>& normal_of_other) {
  std::vector<Vector<double>> polygon(one.begin(), one.end());
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<double> across = cross(normal_of_other, other[(k + 1) % 3] - other[k]);
    std::vector<Vector<double>> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector<double>& next = polygon[(i + 1) % polygon.size()];
      const double here = dot(across, polygon[i] - other[k]);
      const double there = dot(across, next - other[k]);
      if (here >= 0) left.push_back(polygon[i]);
      if ((here < 0) != (there < 0))
        left.push_back(polygon[i] + (here / (here - there)) * (next - polygon[i]));
    }
    if (left.empty()) break;  // rounded away: what there was lies on this side
    polygon = std::move(left);
  }
  Vector<double> sum;
  for (const Vector<double>& p : polygon) sum = sum + p;
  return (1 / static_cast<double>(polygon.size())) * sum;
}

}  // namespace

std::vector<NearContact> near_contacts(const TriangleMesh& mesh, bool right_hand, double precision) {
  const BoxTree tree(triangle_boxes(mesh));
  if (mesh.triangles.empty()) return {};
  const PlaneClasses planes = plane_classes(mesh);
  const double diagonal = norm(tree.box().high - tree.box().low);
  const double rounding = 1e-12 * diagonal;
  const double of_file = rounded_gap(rounding_of(precision, diagonal));
  const double most = std::max(next_to_nothing * diagonal, of_file);
  std::map<std::pair<std::size_t, std::size_t>, NearContact> found;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners here = mesh.corners(t);
    const Vector<double> front = front_of(here, right_hand);
    BoundingBox around = box_about(here);
    const Vector<double> margin{most, most, most};
    around = {around.low - margin, around.high + margin};
    const auto meets = [&](const BoundingBox& box) { return !apart(box, around); };
    static_cast<void>(tree.visit(meets, [&](std::size_t u) {
      if (u <= t || planes.of_triangle[u] == planes.of_triangle[t]) return true;
      const Corners there = mesh.corners(u);
      const Vector<double> back = front_of(there, right_hand);
      if (dot(front, back) >= 0) return true;
      const Heights above = heights(there, front, here[0]);
      const Heights below = heights(here, back, there[0]);
      // Rounding may put a corner of a slanted face behind a plane before which the others lie. A small
      // triangle's plane may be far off where a large one ends, on either side: then the other plane tells,
      // if what it tells is no rounding.
      const auto gap_of = [&](const Heights& h) {
        return h.largest > -h.least && h.largest <= most ? h.largest : infinity;
      };
      const double gap = std::min(gap_of(above), gap_of(below));
      if (!(gap <= most) || (std::max(gap_of(above), gap_of(below)) == infinity && gap <= rounding))
        return true;
      if (!overlap_along_sides(here, there, front, most) || !overlap_along_sides(there, here, back, most))
        return true;
      const auto groups = std::minmax(mesh.group[t], mesh.group[u]);
      NearContact& contact = found[{groups.first, groups.second}];
      if (contact.pairs++ > 0 && contact.gap <= gap) return true;
      contact.one = mesh.group_names[groups.first];
      contact.other = mesh.group_names[groups.second];
      contact.gap = gap;
      contact.may_be_rounding = gap <= of_file;
      contact.at = amid_overlap(here, there, right_hand ? back : -back);
      return true;
    }));
  }
  std::vector<NearContact> out;
  for (auto& [groups, contact] : found) out.push_back(std::move(contact));
  return out;
}

}  // namespace radcert
