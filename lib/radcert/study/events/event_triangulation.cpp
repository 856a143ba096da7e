// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/events/event_triangulation.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/geometry/cut/cut_triangle.h"
#include "radcert/visibility/events/visibility_events.h"
#include "radcert/visibility/surface_scene.h"

namespace radcert {
namespace {

[[noreturn]] void refuse(const std::string& problem, const std::string& allowed) {
  refuse_input("/triangulation/events", "true", problem, allowed);
}

void require_events(const Problem& problem, const Surface& surface) {
  if (!problem.emission)
    refuse("is not for a given solution: its smoothness is its own", "an emission, or no events");
  if (find_triangle_basis(problem.method) == nullptr)
    refuse("is not for a basis without elements", "a basis on triangles, or no events");
  if (problem.geometry) refuse("is not for interpolated geometry", "exact geometry, or no events");
  if (problem.triangulation.grading != Rational(1)) refuse("stands beside a grading", "one of them");
  for (const Chart& chart : surface.charts)
    if (!chart.facts().plane)
      refuse("is not for the chart " + chart.facts().name + ", which is curved",
             "a closed mesh whose parts hide each other, or no events");
  if (surface.unoccluded || surface.mesh == nullptr)
    refuse("finds none on " + surface.name + ", where nothing hides anything",
           "a closed mesh whose parts hide each other, or no events");
  if (!surface.closed)
    refuse("is not for " + surface.name + ", which has open edges",
           "a closed mesh whose parts hide each other, or no events");
}

bool vanishes(const PiecewiseExpression& function, const std::string& piece) {
  const PiecewiseExpression::Case& part = function.case_on(piece);
  const std::optional<Rational> constant = part.expression.is_constant();
  return !part.own && constant && constant->sign() == 0;
}

/// Bounds a reflectivity from above.
Rational largest(const PiecewiseExpression& reflectivity, const std::string& piece) {
  return reflectivity.on(piece).is_constant().value_or(Rational(1));
}

EventQuestion question_of(const Problem& problem, const Surface& surface,
                          const std::optional<Rational>& secondary) {
  Rational most = 0;
  for (const std::string& piece : surface.piece_names())
    most = std::max(most, largest(problem.reflectivity, piece));
  const auto reflects_enough = [&](const std::string& piece) {
    return secondary && largest(problem.reflectivity, piece) > *secondary * (Rational(1) - most);
  };
  std::map<std::pair<std::string, std::string>, std::size_t> numbers;  // by the formulas of E and rho
  EventQuestion question;
  for (const Chart& chart : surface.charts) {
    const std::string& piece = chart.facts().piece;
    question.receives.push_back(!vanishes(problem.reflectivity, piece));
    question.source.emplace_back();
    if (vanishes(*problem.emission, piece) && !reflects_enough(piece)) continue;
    const PiecewiseExpression::Case& emission = problem.emission->case_on(piece);
    const std::pair formulas{emission.own ? "on " + emission.piece : emission.expression.text(),
                             secondary ? problem.reflectivity.on(piece).text() : std::string()};
    question.source.back() = numbers.try_emplace(formulas, numbers.size()).first->second;
  }
  return question;
}

}  // namespace

EventCut event_cut(const Problem& problem, const Surface& surface, const std::optional<Rational>& secondary) {
  require_events(problem, surface);
  const SurfaceScene scene(surface);
  const EventQuestion question = question_of(problem, surface, secondary);
  const Outcome<VisibilityEvents> events = visibility_events(scene.scene(), question);
  if (!events) refuse("is refused: " + events.reason(), "a mesh of fewer faces, or no events");
  std::vector<std::vector<PlaneSegment>> on(surface.chart_count());
  EventCut cut{.secondary = secondary};
  for (const EventSegment& segment : events->segments) {
    on[segment.triangle].push_back({scene.on_chart(segment.from), scene.on_chart(segment.to)});
    if (segment.derivative == 1) ++cut.kinks;
  }
  std::vector<ParameterTriangle> coarse;
  for (std::size_t chart = 0; chart < on.size(); ++chart) {
    const auto parts = cut_triangle(on[chart]);
    if (!parts)
      refuse("cannot cut the chart " + surface.charts[chart].facts().name + ": " + parts.reason(),
             "another mesh, fewer sources, or no events");
    for (const auto& corners : *parts) coarse.push_back({.chart = chart, .vertices = corners});
    if (!on[chart].empty()) ++cut.charts;
  }
  cut.source_triangles = static_cast<std::size_t>(std::count_if(
      question.source.begin(), question.source.end(), [](const auto& each) { return each.has_value(); }));
  cut.pencils = events->pencils;
  cut.segments = events->segments.size();
  cut.coarse = std::make_shared<const std::vector<ParameterTriangle>>(std::move(coarse));
  return cut;
}

TriangulationOptions triangulation_options(const Problem& problem, const Surface& surface) {
  TriangulationOptions options;
  if (problem.triangulation.events) {
    options.coarse = problem.triangulation.events->coarse;
    return options;
  }
  options.grading = problem.triangulation.grading.to_double();
  if (problem.triangulation.pattern.empty()) return options;
  std::vector<Diagonal> diagonals = surface.diagonals;
  for (std::size_t j = 0; j < surface.charts.size(); ++j) {
    const auto assign = [&](const std::string& piece) {
      for (const auto& [name, diagonal] : problem.triangulation.pattern)
        if (name == piece) diagonals[j] = diagonal;
    };
    assign("*");
    assign(surface.charts[j].facts().piece);
  }
  options.diagonals = std::move(diagonals);
  return options;
}

}  // namespace radcert
