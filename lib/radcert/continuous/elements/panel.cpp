// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/panel.h"

#include <algorithm>
#include <array>
#include <optional>
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

struct PlaneCorners {
  std::size_t piece;
  std::vector<Vector<Rational>> corners;  ///< counterclockwise seen from the inside
  Vector<Rational> normal;
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

/// And on one side of it.
bool in_one_plane(const PlaneCorners& a, const PlaneCorners& b) {
  return dot(a.normal, b.normal).sign() > 0 && same_plane(plane_of(a.corners), plane_of(b.corners));
}

/// The one panel of coplanar charts, where their union is convex.
std::optional<Panel> union_of(const std::vector<const PlaneCorners*>& charts) {
  const PlaneCorners& first = *charts.front();
  const Projection projected(first.normal);
  PolygonLoop points;
  std::vector<Vector<Rational>> in_space;
  Rational area = 0;  // twice
  for (const PlaneCorners* chart : charts) {
    PolygonLoop loop;
    for (const Vector<Rational>& corner : chart->corners) loop.push_back(projected(corner));
    area += doubled_area(loop);
    points.insert(points.end(), loop.begin(), loop.end());
    in_space.insert(in_space.end(), chart->corners.begin(), chart->corners.end());
  }
  const PolygonLoop hull = convex_hull(points);
  if (!(doubled_area(hull) == area)) return std::nullopt;
  std::vector<Vector<Rational>> corners;
  for (const ParameterPoint<Rational>& at : hull)
    corners.push_back(
        in_space[static_cast<std::size_t>(std::find(points.begin(), points.end(), at) - points.begin())]);
  return panel_of(first.piece, std::move(corners), first.normal);
}

/// Coplanar ones of a piece as one panel, where their union is convex.
std::vector<Panel> united(const std::vector<PlaneCorners>& charts) {
  std::vector<Panel> panels;
  std::vector<bool> taken(charts.size());
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (taken[k]) continue;
    std::vector<const PlaneCorners*> coplanar;
    for (std::size_t l = k; l < charts.size(); ++l)
      if (!taken[l] && charts[l].piece == charts[k].piece && in_one_plane(charts[k], charts[l])) {
        taken[l] = true;
        coplanar.push_back(&charts[l]);
      }
    if (std::optional<Panel> whole = union_of(coplanar))
      panels.push_back(std::move(*whole));
    else
      for (const PlaneCorners* chart : coplanar)
        panels.push_back(panel_of(chart->piece, chart->corners, chart->normal));
  }
  return panels;
}

/// Twice the area of a panel's projection.
Rational projected_area(const Panel& panel, const Projection& projected) {
  PolygonLoop loop;
  for (const Vector<Rational>& corner : panel.corners) loop.push_back(projected(corner));
  return doubled_area(loop);
}

}  // namespace

Outcome<std::vector<Panel>> convex_panels(const Surface& surface) {
  std::vector<PlaneCorners> charts;
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
    PlaneCorners corners{.piece = surface.piece_of(k), .corners = {}, .normal = plane->normal()};
    for (const ParameterPoint<Rational>& at : loop) corners.corners.push_back(plane->point(at));
    charts.push_back(std::move(corners));
  }
  return united(charts);
}

Outcome<std::vector<Panel>> closing_panels(const std::vector<Panel>& panels, std::size_t piece) {
  std::vector<Vector<Rational>> points;
  for (const Panel& panel : panels) points.insert(points.end(), panel.corners.begin(), panel.corners.end());
  std::vector<PlaneCorners> triangles;
  for (const std::array<Vector<Rational>, 3>& t : convex_hull_triangles(points))
    triangles.push_back(
        {.piece = piece, .corners = {t.begin(), t.end()}, .normal = cross(t[1] - t[0], t[2] - t[0])});
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

bool in_one_plane(const Panel& a, const Panel& b) {
  return same_plane(plane_of(a.corners), plane_of(b.corners));
}

}  // namespace radcert
