// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests/solution_at.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
#include "radcert/reference/nearest_point.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/reference/polygon.h"

namespace radcert::app {

namespace {

/// Where a point lies.
struct Place {
  std::size_t element = 0;
  ParameterPoint<double> at;
  Vector<double> point;
  double distance = std::numeric_limits<double>::infinity();
};

/// The elements of a level with a ball about each.
class Elements {
public:
  explicit Elements(const NodedSurface& level) : level_(level) {
    Vector<double> low = level.nodes.front().point;
    Vector<double> high = low;
    for (const ParameterTriangle& triangle : level.triangulation.triangles) {
      const ChartIn<double>& chart = level.surface.charts[triangle.chart].in<double>();
      constexpr double third = 1.0 / 3;
      const Vector<double> centre = chart.frame(triangle.at({third, third, third})).point;
      double radius = 0;
      for (const ParameterPoint<double>& corner : triangle.vertices) {
        const Vector<double> p = chart.frame(corner).point;
        radius = std::max(radius, norm(p - centre));
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
      centres_.push_back(centre);
      radii_.push_back(radius);
    }
    extent_ = norm(high - low);
  }

  [[nodiscard]] double extent() const { return extent_; }

  [[nodiscard]] Place nearest(const Vector<double>& p) const {
    // A curved element may leave the ball about its corners: by no more than its radius again.
    constexpr double slack = 2;
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(centres_.size());
    for (std::size_t k = 0; k < centres_.size(); ++k)
      order.emplace_back(norm(p - centres_[k]) - slack * radii_[k], k);
    std::sort(order.begin(), order.end());
    Place best;
    for (const auto& [least, k] : order) {
      if (least > best.distance) break;
      const ParameterTriangle& triangle = level_.triangulation.triangles[k];
      const ChartIn<double>& chart = level_.surface.charts[triangle.chart].in<double>();
      const ParameterPoint<double> at =
          reference::nearest_to(p, chart, reference::counterclockwise(triangle.vertices));
      const Vector<double> point = chart.frame(at).point;
      const double distance = norm(point - p);
      if (distance < best.distance || (distance == best.distance && k < best.element))
        best = {.element = k, .at = at, .point = point, .distance = distance};
    }
    return best;
  }

private:
  const NodedSurface& level_;
  std::vector<Vector<double>> centres_;
  std::vector<double> radii_;
  double extent_ = 0;
};

std::string point_text(const Vector<double>& p) {
  return "(" + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")";
}

[[noreturn]] void refuse_point(const AskedPoint& asked, const std::string& problem,
                               const std::string& allowed) {
  throw InputError(
      {.pointer = asked.where, .value = point_text(asked.point), .problem = problem, .allowed = allowed});
}

/// The chart that a point names, by its own name or by that of a piece of one chart.
std::size_t chart_of(const Surface& surface, const AskedPoint& asked) {
  std::vector<std::size_t> found;
  std::string names;
  for (std::size_t k = 0; k < surface.charts.size(); ++k) {
    const ChartFacts& facts = surface.charts[k].facts();
    if ((asked.chart ? facts.name : facts.piece) != (asked.chart ? *asked.chart : *asked.piece)) continue;
    names += (found.empty() ? "" : ", ") + facts.name;
    found.push_back(k);
  }
  if (found.size() == 1) return found.front();
  const std::string name = asked.chart ? *asked.chart : *asked.piece;
  if (!found.empty())
    throw InputError({.pointer = asked.where,
                      .value = name,
                      .problem = "is a piece of " + std::to_string(found.size()) + " charts",
                      .allowed = "a column chart, with " + names});
  for (std::size_t k = 0; k < surface.charts.size() && names.size() < 400; ++k)
    names += (k == 0 ? "" : ", ") + surface.charts[k].facts().name;
  throw InputError({.pointer = asked.where,
                    .value = name,
                    .problem = std::string("is no ") + (asked.chart ? "chart" : "piece") + " of the surface",
                    .allowed = asked.chart ? names : listed(surface.piece_names())});
}

SurfacePlace place_by_parameters(const SolutionLevel& level, const AskedPoint& asked) {
  const std::size_t chart = chart_of(level.surface().surface, asked);
  const std::optional<SurfacePlace> place = level.place_of(chart, asked.at);
  if (place) return *place;
  const bool square = level.surface().surface.charts[chart].facts().domain == ChartDomain::unit_square;
  throw InputError({.pointer = asked.where,
                    .value = "(" + shortest(asked.at.s) + ", " + shortest(asked.at.t) + ")",
                    .problem = "is outside the domain of its chart",
                    .allowed = square ? "parameters s and t in [0, 1]"
                                      : "parameters s and t of at least 0 with a sum of at most 1"});
}

}  // namespace

AskedPlaces places_of(const SolutionLevel& level, std::span<const AskedPoint> points, double tolerance,
                      Progress& told) {
  if (!(tolerance >= 0 && tolerance <= 1))
    throw InputError(
        {.source = "tolerance", .value = shortest(tolerance), .allowed = "a number from 0 to 1"});
  const Elements elements(level.surface());
  AskedPlaces out{.places = std::vector<SurfacePlace>(points.size()),
                  .distances = std::vector<double>(points.size())};
  std::atomic<std::size_t> done = 0;
  parallel_for(points.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const AskedPoint& asked = points[i];
      if (asked.chart || asked.piece) {
        out.places[i] = place_by_parameters(level, asked);
      } else {
        const Vector<double>& p = asked.point;
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
          refuse_point(asked, "is not finite", "finite coordinates");
        const Place found = elements.nearest(p);
        if (!(found.distance <= tolerance * elements.extent()))
          refuse_point(asked, "is off the surface, by " + shortest(found.distance),
                       "points within tolerance = " + shortest(tolerance) + " of its extent " +
                           shortest(elements.extent()));
        out.places[i] = {.element = found.element, .at = found.at};
        out.distances[i] = found.distance;
      }
      told.say(static_cast<double>(++done) / static_cast<double>(points.size()), "points");
    }
  });
  return out;
}

std::vector<ValueAt> solution_at(const Problem& problem, const LevelOutcome& outcome,
                                 std::span<const Vector<double>> points, const AtChoice& choice,
                                 Progress& told) {
  const SolutionLevel level(problem, outcome);
  std::vector<AskedPoint> asked;
  for (std::size_t i = 0; i < points.size(); ++i)
    asked.push_back({.where = "points/" + std::to_string(i), .point = points[i]});
  const AskedPlaces found = places_of(level, asked, choice.tolerance, told);
  for (std::size_t i = 0; choice.iterated && i < asked.size(); ++i)
    if (level.is_on_edge(found.places[i]))
      refuse_point(asked[i], "lies on an edge, where the iterate has no one value",
                   "points inside faces, or iterated=False");
  std::vector<ValueAt> out = level.values_at(found.places, choice.iterated, reference::applied_operator);
  for (std::size_t i = 0; i < out.size(); ++i) out[i].distance = found.distances[i];
  return out;
}

}  // namespace radcert::app
