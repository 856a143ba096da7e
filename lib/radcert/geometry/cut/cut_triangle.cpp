// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/cut/cut_triangle.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "radcert/core/contract.h"

namespace radcert {

const WorkLimit most_segments_of_a_cut("geometry/cut_triangle: segments", 600, 1, "refused");

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Corners = std::array<ParameterPoint<double>, 3>;

/// The nearest multiple of 2^-digits; of two the even one, so that 1 - x goes where x does.
double moved(const Rational& x) {
  // Between 2^22 and 2^23 doubles are the multiples of 2^-30, and their rounding is to even.
  constexpr long shift = 1L << (52 - digits_of_a_cut);
  return (x + Rational(shift)).to_double() - static_cast<double>(shift);
}

bool in_unit_triangle(const ParameterPoint<Rational>& p) {
  return p.s.sign() >= 0 && p.t.sign() >= 0 && p.s + p.t <= Rational(1);
}

bool before(const ParameterPoint<double>& a, const ParameterPoint<double>& b) {
  return a.s != b.s ? a.s < b.s : a.t < b.t;
}

/// Twice the area over the longest side.
double least_height(const Corners& v) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const ParameterPoint<double> side = v[(i + 1) % 3] - v[i];
    longest = std::max(longest, std::hypot(side.s, side.t));
  }
  return cross(v[1] - v[0], v[2] - v[0]) / longest;
}

}  // namespace

Outcome<std::vector<Corners>> cut_triangle(std::span<const PlaneSegment> segments) {
  if (segments.size() > most_segments_of_a_cut.count())
    return because("more than " + std::to_string(most_segments_of_a_cut.value()) + " segments to cut along");
  for (std::size_t k = 0; k < segments.size(); ++k)
    expects(in_unit_triangle(segments[k].from) && in_unit_triangle(segments[k].to),
            "segments within the unit triangle", named("segment", k));
  std::vector<PlaneSegment> all(segments.begin(), segments.end());
  const std::array<ParameterPoint<Rational>, 3> corners{
      ParameterPoint<Rational>{0, 0}, ParameterPoint<Rational>{1, 0}, ParameterPoint<Rational>{0, 1}};
  for (std::size_t i = 0; i < 3; ++i) all.push_back({corners[i], corners[(i + 1) % 3]});
  const SegmentArrangement arrangement = segment_arrangement(all);

  Delaunay delaunay;
  std::vector<Delaunay::Vertex_handle> vertices;
  for (const ParameterPoint<Rational>& point : arrangement.points) {
    const Kernel::Point_2 at(moved(point.s), moved(point.t));
    if (at.x() + at.y() > 1)
      return because("a point nearer to the side than 2^-" + std::to_string(digits_of_a_cut));
    vertices.push_back(delaunay.insert(at));
  }
  try {
    for (const auto& [from, to] : arrangement.segments)
      if (vertices[from] != vertices[to]) delaunay.insert_constraint(vertices[from], vertices[to]);
  } catch (const Delaunay::Intersection_of_constraints_exception&) {
    return because("segments that cross once their ends are moved to multiples of 2^-" +
                   std::to_string(digits_of_a_cut));
  }
  std::vector<Corners> parts;
  for (const auto face : delaunay.finite_face_handles()) {
    Corners part;
    for (int i = 0; i < 3; ++i) {
      const Kernel::Point_2& at = face->vertex(i)->point();
      part.at(static_cast<std::size_t>(i)) = {at.x(), at.y()};
    }
    std::rotate(part.begin(), std::min_element(part.begin(), part.end(), before), part.end());
    if (least_height(part) < least_height_of_a_cut)
      return because("a part that is thinner than 2^-20 of a side");
    parts.push_back(part);
  }
  std::sort(parts.begin(), parts.end(), [](const Corners& a, const Corners& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), before);
  });
  return parts;
}

}  // namespace radcert
