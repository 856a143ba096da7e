// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/certified_exchange.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/closed_form/polygon_to_polygon.h"
#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"
#include "radcert/factors/contour_exchange.h"
#include "radcert/factors/shadow_exchange.h"
#include "radcert/geometry/orientation.h"

namespace radcert {

namespace {

ExactCorners exact_corners(const FacetCorners& polygon) {
  ExactCorners out;
  for (const Vector<double>& corner : polygon) out.push_back(exactly(corner));
  return out;
}

/// What of a polygon lies in front of the plane of another.
ExactCorners in_front(const ExactCorners& polygon, const ExactCorners& other) {
  const Vector<Rational> normal = cross(other[1] - other[0], other[2] - other[0]);
  ExactCorners out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector<Rational>& next = polygon[(k + 1) % polygon.size()];
    const Rational here = dot(normal, polygon[k] - other[0]);
    const Rational there = dot(normal, next - other[0]);
    if (here.sign() >= 0) out.push_back(polygon[k]);
    if (here.sign() * there.sign() < 0)
      out.push_back(polygon[k] + (here / (here - there)) * (next - polygon[k]));
  }
  return out;
}

/// Polygons with their exact area, by the root of a rational number.
Ball area_of(const ExactCorners& triangle) {
  const Vector<Rational> normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  return sqrt(Ball(dot(normal, normal) / 4));
}

/// What one solid keeps back, and its faces that may stand between.
struct Solid {
  Ball kept_back = 0;
  std::vector<std::size_t> faces{};
};

/// Solids in groups: a segment between the triangles meets those of one group only.
std::vector<std::vector<const Solid*>> groups(const FacetScene& scene, std::size_t first, std::size_t second,
                                              const std::map<std::size_t, Solid>& solids) {
  const auto meet = [&](const Solid& a, const Solid& b) {
    return std::any_of(a.faces.begin(), a.faces.end(), [&](std::size_t k) {
      return std::any_of(b.faces.begin(), b.faces.end(),
                         [&](std::size_t l) { return scene.may_hide_together(k, l, first, second); });
    });
  };
  std::vector<std::vector<const Solid*>> out;
  for (const auto& [number, solid] : solids) {
    std::vector<const Solid*> group{&solid};
    std::vector<std::vector<const Solid*>> rest;
    for (std::vector<const Solid*>& other : out) {
      const bool joined =
          std::any_of(other.begin(), other.end(), [&](const Solid* one) { return meet(*one, solid); });
      if (joined) {
        group.insert(group.end(), other.begin(), other.end());
      } else {
        rest.push_back(std::move(other));
      }
    }
    rest.push_back(std::move(group));
    out = std::move(rest);
  }
  return out;
}

}  // namespace

const WorkLimit most_evaluations_of_a_shadow("factors/certified_exchange: evaluations of a shadow", 60'000, 1,
                                             "the ball reached, or all between nothing and the whole");

Ball certified_area(const FacetScene& scene, std::size_t triangle) {
  const Ball area = area_of(exact_corners(scene.facet(triangle)));
  return scene.unit() == Rational(1) ? area : area * Ball(scene.unit() * scene.unit());
}

Ball certified_exchange_area(const FacetScene& scene, std::size_t first, std::size_t second,
                             const FacetPair& pair, const CertifiedDemand& demand) {
  if (pair.sight == PairSight::nothing || pair.sight == PairSight::hidden) return 0;
  const ExactCorners a = exact_corners(scene.facet(first));
  const ExactCorners b = exact_corners(scene.facet(second));
  const Ball area = area_of(a);
  const Ball unoccluded = area * polygon_to_polygon(plane_polygon(a).value(), plane_polygon(b).value());
  if (pair.sight == PairSight::whole) return unoccluded;

  const bool first_receives = scene.area(first) <= scene.area(second);
  const ExactCorners receiver = first_receives ? in_front(a, b) : in_front(b, a);
  const ExactCorners source = first_receives ? in_front(b, a) : in_front(a, b);
  const double radius = demand.radius * std::min(scene.area(first), scene.area(second));
  const Ball nothing = 0;
  const Ball anything = hull(nothing, unoccluded);
  std::vector<ExactCorners> screens;
  for (const std::size_t k : pair.occluders) screens.push_back(exact_corners(scene.occluders()[k].corners));
  // From either side, for sides that stand on the receiver's plane.
  for (const bool swapped : {false, true})
    if (const std::optional<Ball> seen =
            contour_exchange_area(swapped ? source : receiver, swapped ? receiver : source, screens,
                                  unoccluded, {.radius = radius, .work_limit = demand.work_limit}))
      return intersection(*seen, anything);

  // Each shadow may come out twice as wide as was asked for.
  const double shadows = 2 * static_cast<double>(pair.occluders.size());
  const ShadowDemand each{.radius = radius / shadows, .work_limit = demand.work_limit};
  std::map<std::size_t, Solid> solids;
  for (const std::size_t k : pair.occluders) {
    throw_if_interrupted();
    const ConvexOccluder& occluder = scene.occluders()[k];
    const OccludingSide side =
        scene.solid_is_body(occluder.solid) ? OccludingSide::front : OccludingSide::both;
    const std::optional<Ball> shadow =
        shadow_exchange_area(receiver, source, exact_corners(occluder.corners), side, each);
    Solid& solid = solids[occluder.solid];
    solid.kept_back += shadow ? *shadow : anything;
    solid.faces.push_back(k);
  }
  Ball value = unoccluded;
  for (const std::vector<const Solid*>& group : groups(scene, first, second, solids)) {
    Ball all = 0;
    Ball largest = 0;
    for (const Solid* solid : group) {
      all += solid->kept_back;
      largest = max(largest, solid->kept_back);
    }
    value -= group.size() == 1 ? all : hull(all, largest);
  }
  return intersection(value, anything);
}

}  // namespace radcert
