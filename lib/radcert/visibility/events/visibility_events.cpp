// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/events/visibility_events.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane.h"
#include "radcert/visibility/events/event_edges.h"
#include "radcert/visibility/events/event_plane.h"

namespace radcert {

const WorkLimit most_event_pencils("visibility/visibility_events: pencils of lines", 20000, 1, "refused");

namespace {

/// A pencil of lines, and what light of the events that are sought passes: its centre and, if there is one,
/// an edge from the end of `from` to that of `to`.
struct Pencil {
  PencilFrame frame;
  std::vector<std::size_t> at_centre;  ///< the triangles that the centre is a point of
  const EventEdge* edge = nullptr;
  int derivative = 2;
};

/// Which of three forms the events of a pencil may have.
struct Forms {
  bool from_centre = false;  ///< light begins at the centre and passes the edge
  bool from_edge = false;    ///< light begins at the edge and passes the centre
  bool from_beyond = false;  ///< light begins elsewhere on a source and passes both

  [[nodiscard]] bool any() const { return from_centre || from_edge || from_beyond; }
};

/// The events of a plane: of pencils in it.
class EventsOfPlane {
public:
  EventsOfPlane(const Scene& scene, const EventEdges& edges, const EventQuestion& question, PlaneSigns signs)
      : scene_(&scene),
        edges_(&edges),
        question_(&question),
        signs_(std::move(signs)),
        crosses_source_(crosses_source()) {}

  [[nodiscard]] const PlaneSigns& signs() const { return signs_; }

  /// Whether a pencil through points of these triangles, with that edge, may have events at all.
  [[nodiscard]] Forms possible_forms(const std::vector<std::size_t>& at_centre, const EventEdge* edge) const {
    const bool touches = edge == nullptr || touches_edge(*edge);
    return {.from_centre = touches && shines_any(at_centre),
            .from_edge = edge != nullptr && edge->source,
            .from_beyond = touches && crosses_source_};
  }

  void append_to(std::vector<EventSegment>& segments, const Pencil& pencil) const {
    const Forms forms = possible_forms(pencil.at_centre, pencil.edge);
    if (!forms.any()) return;
    const EventPlane plane(*scene_, *edges_, signs_, pencil.frame);
    const Sources sources{.at_centre = source_normals(plane, pencil.at_centre),
                          .at_edge = pencil.edge != nullptr ? source_normals(plane, pencil.edge->triangles)
                                                            : std::vector<ParameterPoint<Rational>>()};
    const auto append = [&](std::size_t place, const Rational& from, const Rational& to) {
      const PlaneCrossing& crossing = plane.crossings()[place];
      segments.push_back({.triangle = crossing.triangle,
                          .from = plane.place(EventPlane::direction(from), crossing),
                          .to = plane.place(EventPlane::direction(to), crossing),
                          .derivative = pencil.derivative});
    };
    const std::vector<Rational> turns = plane.turns();
    std::map<std::size_t, Rational> begun;  // by place of a crossing: where its segment begins
    for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
      const PencilPoint direction = EventPlane::direction(Rational(1, 2) * (turns[k] + turns[k + 1]));
      const std::vector<std::size_t> lit =
          lit_along(plane, direction, forms, sources, pencil.edge != nullptr);
      for (auto it = begun.begin(); it != begun.end();) {
        if (std::find(lit.begin(), lit.end(), it->first) != lit.end()) {
          ++it;
          continue;
        }
        append(it->first, it->second, turns[k]);
        it = begun.erase(it);
      }
      for (const std::size_t place : lit) begun.try_emplace(place, turns[k]);
    }
    for (const auto& [place, from] : begun) append(place, from, turns.back());
  }

  /// Whether lines of the plane in free space may touch an edge that lies in it and go on.
  [[nodiscard]] bool touches_edge(const EventEdge& edge) const {
    if (!edge.convex) return false;
    const auto on = [&](int sign) {
      return std::any_of(edge.opposite.begin(), edge.opposite.end(),
                         [&](std::size_t w) { return signs_[w] == sign; });
    };
    return !(on(1) && on(-1));
  }

private:
  /// The normals of sources as EventPlane::normal has them.
  struct Sources {
    std::vector<ParameterPoint<Rational>> at_centre;
    std::vector<ParameterPoint<Rational>> at_edge;
  };

  [[nodiscard]] bool shines_any(const std::vector<std::size_t>& triangles) const {
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](std::size_t t) { return question_->source[t].has_value(); });
  }

  [[nodiscard]] bool crosses_source() const {
    for (std::size_t t = 0; t < scene_->triangle_count(); ++t) {
      if (!question_->source[t]) continue;
      const auto& [a, b, c] = scene_->vertices(t);
      const auto [least, most] = std::minmax({signs_[a], signs_[b], signs_[c]});
      if (least < 0 && most > 0) return true;
    }
    return false;
  }

  [[nodiscard]] std::vector<ParameterPoint<Rational>> source_normals(
      const EventPlane& plane, const std::vector<std::size_t>& triangles) const {
    std::vector<ParameterPoint<Rational>> normals;
    for (const std::size_t t : triangles)
      if (question_->source[t]) normals.push_back(plane.normal(t));
    return normals;
  }

  /// Whether a line leaves one of the planes with these normals on its front, or runs in it.
  [[nodiscard]] static bool leaves(const std::vector<ParameterPoint<Rational>>& normals,
                                   const PencilPoint& direction, int way) {
    return std::any_of(normals.begin(), normals.end(), [&](const ParameterPoint<Rational>& n) {
      return way * (direction.x * n.s + direction.y * n.t).sign() >= 0;
    });
  }

  /// The crossings that light of one of the forms arrives at along a line between two turns.
  [[nodiscard]] std::vector<std::size_t> lit_along(const EventPlane& plane, const PencilPoint& direction,
                                                   const Forms& forms, const Sources& sources,
                                                   bool has_edge) const {
    std::vector<std::size_t> lit;
    const auto shines = [&](std::size_t place) {
      return question_->source[plane.crossings()[place].triangle].has_value();
    };
    if (!forms.from_centre && !forms.from_edge) {
      const std::vector<std::size_t> met = plane.met(direction);
      if (std::none_of(met.begin(), met.end(), shines)) return lit;
    }
    const std::optional<SightEnd> forwards = plane.end(direction, 1);
    const std::optional<SightEnd> backwards = plane.end(direction, -1);
    const bool passes_edge = !has_edge || (forwards && forwards->distance > Rational(1));
    const bool reaches_edge = has_edge && (!forwards || forwards->distance >= Rational(1));
    const auto front = [&](const std::optional<SightEnd>& end, int way) {
      return end && end->crossing && plane.crossings()[*end->crossing].faces(direction, way);
    };
    const bool front_forwards = front(forwards, 1);
    const bool front_backwards = front(backwards, -1);
    const bool both = forms.from_beyond && passes_edge && front_forwards && front_backwards;
    const bool from_centre = forms.from_centre && passes_edge;
    const auto light = [&](const SightEnd& end) {
      if (question_->receives[plane.crossings()[*end.crossing].triangle]) lit.push_back(*end.crossing);
    };
    if (front_forwards &&
        ((from_centre && leaves(sources.at_centre, direction, 1)) || (both && shines(*backwards->crossing))))
      light(*forwards);
    const bool from_edge = forms.from_edge && reaches_edge && leaves(sources.at_edge, direction, -1);
    if (front_backwards && (from_edge || (both && shines(*forwards->crossing)) ||
                            (!has_edge && from_centre && leaves(sources.at_centre, direction, -1))))
      light(*backwards);
    return lit;
  }

  const Scene* scene_;
  const EventEdges* edges_;
  const EventQuestion* question_;
  PlaneSigns signs_;
  bool crosses_source_;
};

/// Collects the events of a question, plane by plane.
class EventSearch {
public:
  EventSearch(const Scene& scene, const EventQuestion& question)
      : scene_(scene), question_(question), edges_(scene, question.source) {}

  /// The planes through a vertex and an edge. Whether the limit of work allows all.
  [[nodiscard]] bool look_at_edges(VisibilityEvents& events) const {
    std::vector<std::pair<const EventEdge*, std::size_t>> pairs;
    for (const EventEdge& edge : edges_.edges) {
      if (!edge.source && !edge.convex) continue;
      for (const std::size_t vertex : edges_.corners) {
        if (collinear(scene_.vertex(vertex), scene_.vertex(edge.from), scene_.vertex(edge.to))) continue;
        // Before any is looked at, so that a mesh of too many is refused at once.
        if (++events.pencils > most_event_pencils.count()) return false;
        pairs.emplace_back(&edge, vertex);
      }
    }
    for (const auto& [edge, vertex] : pairs) {
      throw_if_interrupted();
      const Vector<double>& at = scene_.vertex(vertex);
      const EventsOfPlane plane(
          scene_, edges_, question_,
          plane_signs(scene_, edges_, at, scene_.vertex(edge->from), scene_.vertex(edge->to)));
      plane.append_to(events.segments, {.frame = frame(exactly(at), *edge),
                                        .at_centre = edges_.triangles_at[vertex],
                                        .edge = edge,
                                        .derivative = has_edge_at(plane, vertex) ? 1 : 2});
    }
    return true;
  }

  /// The planes of faces.
  [[nodiscard]] bool look_at_faces(VisibilityEvents& events) const {
    std::set<std::size_t> seen;
    for (std::size_t t = 0; t < scene_.triangle_count(); ++t) {
      if (!seen.insert(scene_.plane(t)).second) continue;
      throw_if_interrupted();
      const auto [a, b, c] = scene_.corners(t);
      const EventsOfPlane plane(scene_, edges_, question_, plane_signs(scene_, edges_, a, b, c));
      std::vector<const EventEdge*> sides;
      for (const EventEdge& edge : edges_.edges)
        if (in(plane, edge) && EventEdges::counts(edge) && (edge.source || plane.touches_edge(edge)))
          sides.push_back(&edge);
      const Vector<Rational> first = exactly(b) - exactly(a);
      const Vector<Rational> second = exactly(c) - exactly(a);
      for (const Centre& centre : centres(plane, Plane(exactly(a), first, second), sides)) {
        for (const EventEdge* side : sides) {
          if (!plane.possible_forms(centre.triangles, side).any()) continue;
          PencilFrame through = frame(centre.at, *side);
          if (is_zero(cross(through.from, through.to))) continue;
          if (++events.pencils > most_event_pencils.count()) return false;
          plane.append_to(
              events.segments,
              {.frame = std::move(through), .at_centre = centre.triangles, .edge = side, .derivative = 1});
        }
        if (!centre.of_face) continue;
        for (const Vector<Rational>& other : {second, -second}) {
          if (++events.pencils > most_event_pencils.count()) return false;
          plane.append_to(events.segments, {.frame = {centre.at, first, other},
                                            .at_centre = centre.triangles,
                                            .edge = nullptr,
                                            .derivative = 1});
        }
      }
    }
    return true;
  }

private:
  /// A point of a face's plane at which lines in the plane may be stopped.
  struct Centre {
    Vector<Rational> at;
    std::vector<std::size_t> triangles;
    bool of_face = false;  ///< an end of a side of a face in the plane
  };

  [[nodiscard]] PencilFrame frame(const Vector<Rational>& centre, const EventEdge& edge) const {
    return {.centre = centre,
            .from = exactly(scene_.vertex(edge.from)) - centre,
            .to = exactly(scene_.vertex(edge.to)) - centre};
  }

  [[nodiscard]] static bool in(const EventsOfPlane& plane, const EventEdge& edge) {
    return plane.signs()[edge.from] == 0 && plane.signs()[edge.to] == 0;
  }

  /// Whether an edge that counts and ends at the vertex lies in the plane.
  [[nodiscard]] bool has_edge_at(const EventsOfPlane& plane, std::size_t vertex) const {
    return std::any_of(edges_.edges.begin(), edges_.edges.end(), [&](const EventEdge& edge) {
      return (edge.from == vertex || edge.to == vertex) && in(plane, edge) && EventEdges::counts(edge);
    });
  }

  [[nodiscard]] std::vector<Centre> centres(const EventsOfPlane& plane, const Plane& face,
                                            const std::vector<const EventEdge*>& sides) const {
    std::vector<Centre> all;
    if (sides.empty()) return all;
    const PlaneSigns& signs = plane.signs();
    for (const std::size_t v : edges_.corners)
      if (signs[v] == 0)
        all.push_back({.at = exactly(scene_.vertex(v)),
                       .triangles = edges_.triangles_at[v],
                       .of_face = std::any_of(sides.begin(), sides.end(), [&](const EventEdge* side) {
                         return side->from == v || side->to == v;
                       })});
    for (const EventEdge& edge : edges_.edges) {
      if (!edge.source && !edge.convex) continue;
      if (signs[edge.from] * signs[edge.to] >= 0) continue;
      const Vector<Rational> from = exactly(scene_.vertex(edge.from));
      const Vector<Rational> along = exactly(scene_.vertex(edge.to)) - from;
      const Rational part = (face.offset() - dot(face.normal(), from)) / dot(face.normal(), along);
      all.push_back({.at = from + part * along, .triangles = edge.triangles, .of_face = false});
    }
    return all;
  }

  const Scene& scene_;
  const EventQuestion& question_;
  EventEdges edges_;
};

/// A line of a triangle's parameter plane, n . (s,t) = offset, scaled so that equal lines have equal numbers.
using Line = std::array<Rational, 3>;

Line line_of(const EventSegment& segment) {
  const ParameterPoint<Rational> along = segment.to - segment.from;
  const Rational& scale = along.t.sign() != 0 ? along.t : along.s;
  const ParameterPoint<Rational> n{along.t / scale, -along.s / scale};
  return {n.s, n.t, n.s * segment.from.s + n.t * segment.from.t};
}

bool before(const ParameterPoint<Rational>& a, const ParameterPoint<Rational>& b) {
  return a.s != b.s ? a.s < b.s : a.t < b.t;
}

/// Segments of one line that overlap or touch become one.
std::vector<EventSegment> united(std::vector<EventSegment> segments) {
  std::map<std::pair<std::size_t, Line>, std::vector<EventSegment>> by_line;
  for (EventSegment& segment : segments) {
    if (before(segment.to, segment.from)) std::swap(segment.from, segment.to);
    by_line[{segment.triangle, line_of(segment)}].push_back(std::move(segment));
  }
  std::vector<EventSegment> out;
  for (auto& [line, along] : by_line) {
    std::sort(along.begin(), along.end(),
              [](const EventSegment& a, const EventSegment& b) { return before(a.from, b.from); });
    for (std::size_t k = 0; k < along.size(); ++k) {
      if (k == 0 || before(out.back().to, along[k].from)) {
        out.push_back(std::move(along[k]));
        continue;
      }
      if (before(out.back().to, along[k].to)) out.back().to = along[k].to;
      out.back().derivative = std::min(out.back().derivative, along[k].derivative);
    }
  }
  return out;
}

}  // namespace

Outcome<VisibilityEvents> visibility_events(const Scene& scene, const EventQuestion& question) {
  expects(
      question.source.size() == scene.triangle_count() && question.receives.size() == scene.triangle_count(),
      "an entry for each triangle", named("triangles", scene.triangle_count()));
  const EventSearch search(scene, question);
  VisibilityEvents events;
  if (!search.look_at_edges(events) || !search.look_at_faces(events))
    return because("more than " + std::to_string(most_event_pencils.value()) + " pencils of lines");
  events.segments = united(std::move(events.segments));
  return events;
}

}  // namespace radcert
