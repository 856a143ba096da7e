// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/panel.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/geometry/hull/convex_hull_triangles.h"
#include "radcert/geometry/plane.h"
#include "radcert/geometry/plane_polygon.h"

namespace radcert {
namespace {

/// Coordinates of a plane: two of the three of space, in an order in which the inner normal points to the
/// viewer.
class Projection {
public:
  explicit Projection(const Vector<Rational>& normal) {
    const Rational x = abs(normal.x);
    const Rational y = abs(normal.y);
    const Rational z = abs(normal.z);
    dropped_ = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    flipped_ = (dropped_ == 0 ? normal.x : dropped_ == 1 ? normal.y : normal.z).sign() < 0;
  }
  [[nodiscard]] ParameterPoint<Rational> operator()(const Vector<Rational>& p) const {
    ParameterPoint<Rational> at = dropped_ == 0   ? ParameterPoint<Rational>{p.y, p.z}
                                  : dropped_ == 1 ? ParameterPoint<Rational>{p.z, p.x}
                                                  : ParameterPoint<Rational>{p.x, p.y};
    if (flipped_) swap(at.s, at.t);
    return at;
  }

private:
  int dropped_;
  bool flipped_;
};

Panel panel_of(std::size_t piece, std::vector<Vector<Rational>> corners, const Vector<Rational>& normal) {
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : corners) sum = sum + corner;
  const Rational share(1, static_cast<long>(corners.size()));
  return {.piece = piece, .corners = std::move(corners), .centre = share * sum, .normal = normal};
}

Plane plane_of(const std::vector<Vector<Rational>>& corners) {
  return {corners[0], corners[1] - corners[0], corners[2] - corners[0]};
}

/// In one plane, and on one side of it.
bool look_alike(const Panel& a, const Panel& b) {
  return dot(a.normal, b.normal).sign() > 0 && in_one_plane(a, b);
}

/// The one panel of coplanar ones, where their union is convex.
std::optional<Panel> union_of(const std::vector<const Panel*>& parts) {
  const Panel& first = *parts.front();
  const Projection projected(first.normal);
  PolygonLoop points;
  std::vector<Vector<Rational>> in_space;
  Rational area = 0;  // twice
  for (const Panel* part : parts) {
    PolygonLoop loop;
    for (const Vector<Rational>& corner : part->corners) loop.push_back(projected(corner));
    area += doubled_area(loop);
    points.insert(points.end(), loop.begin(), loop.end());
    in_space.insert(in_space.end(), part->corners.begin(), part->corners.end());
  }
  const PolygonLoop hull = convex_hull(points);
  if (!(doubled_area(hull) == area)) return std::nullopt;
  std::vector<Vector<Rational>> corners;
  for (const ParameterPoint<Rational>& at : hull)
    corners.push_back(
        in_space[static_cast<std::size_t>(std::find(points.begin(), points.end(), at) - points.begin())]);
  return panel_of(first.piece, std::move(corners), first.normal);
}

/// Those of one kind as one panel, where their union is convex.
/// Requires  are_one(k, l): k and l are of one kind, which is of one piece and one plane
template <class AreOne>
std::vector<Panel> united(const std::vector<Panel>& parts, const AreOne& are_one) {
  std::vector<Panel> panels;
  std::vector<bool> taken(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (taken[k]) continue;
    std::vector<const Panel*> kind;
    for (std::size_t l = k; l < parts.size(); ++l)
      if (!taken[l] && are_one(k, l)) {
        taken[l] = true;
        kind.push_back(&parts[l]);
      }
    if (std::optional<Panel> whole = union_of(kind))
      panels.push_back(std::move(*whole));
    else
      for (const Panel* part : kind) panels.push_back(*part);
  }
  return panels;
}

/// Coplanar ones of a piece as one panel, where their union is convex.
std::vector<Panel> united(const std::vector<Panel>& parts) {
  return united(parts, [&](std::size_t k, std::size_t l) {
    return parts[k].piece == parts[l].piece && look_alike(parts[k], parts[l]);
  });
}

/// The signs of n.(c - a) over the corners c of a panel, for the plane through a with the normal n.
struct Sides {
  bool before = false;
  bool behind = false;
};

Sides sides_of(const std::vector<Vector<Rational>>& corners, const Panel& plane) {
  Sides sides;
  for (const Vector<Rational>& corner : corners) {
    const int sign = dot(plane.normal, corner - plane.corners[0]).sign();
    sides.before = sides.before || sign > 0;
    sides.behind = sides.behind || sign < 0;
  }
  return sides;
}

/// The part of a convex polygon on one side of a plane that crosses it.
std::vector<Vector<Rational>> part_of(const std::vector<Vector<Rational>>& corners, const Panel& plane,
                                      int side) {
  std::vector<Vector<Rational>> part;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<Rational>& from = corners[i];
    const Vector<Rational>& to = corners[(i + 1) % corners.size()];
    const Rational at_from = dot(plane.normal, from - plane.corners[0]);
    const Rational at_to = dot(plane.normal, to - plane.corners[0]);
    if (at_from.sign() * side >= 0) part.push_back(from);
    if (at_from.sign() * at_to.sign() < 0) part.push_back(from + (at_from / (at_from - at_to)) * (to - from));
  }
  return part;
}

/// Twice the area of a panel's projection.
Rational projected_area(const Panel& panel, const Projection& projected) {
  PolygonLoop loop;
  for (const Vector<Rational>& corner : panel.corners) loop.push_back(projected(corner));
  return doubled_area(loop);
}

bool lies_inside(const Vector<Rational>& point, const Vector<Rational>& from, const Vector<Rational>& to) {
  return is_zero(cross(to - from, point - from)) && dot(to - from, point - from).sign() > 0 &&
         dot(from - to, point - to).sign() > 0;
}

/// Both parts of a panel that is cut from a point inside its side i to one of its corners.
std::pair<Panel, Panel> cut_from(const Vector<Rational>& point, std::size_t i, const Panel& panel) {
  const std::size_t n = panel.corners.size();
  const auto part = [&](std::size_t first, std::size_t last) {
    std::vector<Vector<Rational>> corners{point};
    for (std::size_t k = first; k <= last; ++k) corners.push_back(panel.corners[k % n]);
    return panel_of(panel.piece, std::move(corners), panel.normal);
  };
  const Projection projected(panel.normal);
  std::pair<Panel, Panel> best;
  Rational largest = 0;
  for (std::size_t to = i + 2; to < i + n; ++to) {
    std::pair<Panel, Panel> parts(part(i + 1, to), part(to, i + n));
    const Rational smaller =
        std::min(projected_area(parts.first, projected), projected_area(parts.second, projected));
    if (smaller <= largest) continue;
    largest = smaller;
    best = std::move(parts);
  }
  return best;
}

/// The ends of sides that are no other panel's side the other way round.
std::vector<Vector<Rational>> ends_without_match(const std::vector<Panel>& panels) {
  using Side = std::array<Rational, 6>;
  const auto side = [](const Vector<Rational>& a, const Vector<Rational>& b) {
    return Side{a.x, a.y, a.z, b.x, b.y, b.z};
  };
  std::set<Side> sides;
  const auto visit = [&](const auto& visitor) {
    for (const Panel& panel : panels)
      for (std::size_t i = 0; i < panel.corners.size(); ++i)
        visitor(panel.corners[i], panel.corners[(i + 1) % panel.corners.size()]);
  };
  visit([&](const Vector<Rational>& a, const Vector<Rational>& b) { sides.insert(side(a, b)); });
  std::vector<Vector<Rational>> ends;
  visit([&](const Vector<Rational>& a, const Vector<Rational>& b) {
    if (!sides.contains(side(b, a))) ends.insert(ends.end(), {a, b});
  });
  return ends;
}

}  // namespace

Outcome<std::vector<Panel>> convex_panels(const Surface& surface) {
  std::vector<Panel> charts;
  for (std::size_t k = 0; k < surface.chart_count(); ++k) {
    const ChartFacts& facts = surface.charts[k].facts();
    const std::optional<PlaneChart> plane = plane_chart(surface, k);
    if (!plane)
      return because("chart " + std::to_string(k) + " of piece " + facts.piece +
                     " is not plane, or its plane is not known in exact arithmetic");
    std::vector<ParameterPoint<Rational>> loop{{0, 0}, {1, 0}, {0, 1}};
    if (facts.domain == ChartDomain::unit_square) loop = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    if (plane->orientation != Orientation::along_the_cross_product)
      std::reverse(loop.begin() + 1, loop.end());
    std::vector<Vector<Rational>> corners;
    for (const ParameterPoint<Rational>& at : loop) corners.push_back(plane->point(at));
    charts.push_back(panel_of(surface.piece_of(k), std::move(corners), plane->normal()));
  }
  return united(charts);
}

Outcome<std::vector<Panel>> closing_panels(const std::vector<Panel>& panels, std::size_t piece) {
  std::vector<Vector<Rational>> points;
  for (const Panel& panel : panels) points.insert(points.end(), panel.corners.begin(), panel.corners.end());
  std::vector<Panel> triangles;
  for (const std::array<Vector<Rational>, 3>& t : convex_hull_triangles(points))
    triangles.push_back(panel_of(piece, {t.begin(), t.end()}, cross(t[1] - t[0], t[2] - t[0])));
  if (triangles.empty()) return because("it lies in one plane");
  std::vector<Panel> closing;
  for (Panel& face : united(triangles)) {
    const Projection projected(face.normal);
    Rational covered = 0;
    for (const Panel& panel : panels)
      if (in_one_plane(face, panel)) covered += projected_area(panel, projected);
    if (covered.sign() == 0)
      closing.push_back(std::move(face));
    else if (!(covered == projected_area(face, projected)))
      return because("a face of its convex hull belongs to it in part alone");
  }
  return closing;
}

Outcome<std::vector<Panel>> cut_panels(const std::vector<Panel>& panels, std::size_t most) {
  const std::string too_many =
      "the planes of its faces cut them into more than " + std::to_string(most) + " parts";
  std::vector<Panel> parts;
  for (const Panel& panel : panels) {
    std::vector<std::vector<Vector<Rational>>> pieces{panel.corners};
    for (const Panel& plane : panels) {
      std::vector<std::vector<Vector<Rational>>> cut;
      for (std::vector<Vector<Rational>>& piece : pieces) {
        const Sides sides = sides_of(piece, plane);
        if (sides.before && sides.behind) {
          cut.push_back(part_of(piece, plane, 1));
          cut.push_back(part_of(piece, plane, -1));
        } else {
          cut.push_back(std::move(piece));
        }
      }
      pieces = std::move(cut);
      if (parts.size() + pieces.size() > 10 * most) return because(too_many);
    }
    for (std::vector<Vector<Rational>>& piece : pieces)
      parts.push_back(panel_of(panel.piece, std::move(piece), panel.normal));
  }
  std::vector<std::vector<bool>> before;
  for (const Panel& part : parts) {
    before.emplace_back();
    for (const Panel& plane : panels) before.back().push_back(sides_of(part.corners, plane).before);
  }
  std::vector<Panel> out = united(parts, [&](std::size_t k, std::size_t l) {
    return parts[k].piece == parts[l].piece && before[k] == before[l] && look_alike(parts[k], parts[l]);
  });
  if (out.size() > most) return because(too_many);
  return out;
}

std::vector<Panel> with_edges_matched(std::vector<Panel> panels) {
  const std::vector<Vector<Rational>> points = ends_without_match(panels);
  for (std::size_t k = 0; k < panels.size();) {
    const Panel& panel = panels[k];
    std::optional<std::pair<Panel, Panel>> parts;
    for (std::size_t i = 0; i < panel.corners.size() && !parts; ++i) {
      const Vector<Rational>& to = panel.corners[(i + 1) % panel.corners.size()];
      const auto inside = std::find_if(points.begin(), points.end(), [&](const Vector<Rational>& point) {
        return lies_inside(point, panel.corners[i], to);
      });
      if (inside != points.end()) parts = cut_from(*inside, i, panel);
    }
    if (!parts) {
      ++k;
      continue;
    }
    panels[k] = std::move(parts->first);
    panels.insert(panels.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::move(parts->second));
  }
  return panels;
}

bool in_one_plane(const Panel& a, const Panel& b) {
  return same_plane(plane_of(a.corners), plane_of(b.corners));
}

}  // namespace radcert
