// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/scenes/lit_room.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "radcert/geometry/plane_polygon.h"
#include "radcert/geometry/polygon_triangulation.h"
#include "radcert/surface/mesh_surface.h"

namespace radcert::verification::psg10 {
namespace {

/// A point of the floor plan.
struct PlanPoint {
  Rational x;
  Rational y;
};

Rational sixteenths(int n) { return {n, 16}; }

/// The four corners middle +- a +- b, a = (u, v), b = (-v, u), counterclockwise; in sixteenths.
std::vector<PlanPoint> square_plan(int middle_x, int middle_y, int u, int v) {
  std::vector<PlanPoint> plan;
  for (const auto& [x, y] : {std::pair(-u + v, -v - u), {u + v, v - u}, {u - v, v + u}, {-u - v, -v + u}})
    plan.push_back({sixteenths(middle_x + x), sixteenths(middle_y + y)});
  return plan;
}

/// Eight corners about a middle, counterclockwise: at distances of far beside the axes and near from them; in
/// sixteenths.
std::vector<PlanPoint> octagon_plan(int middle_x, int middle_y, int far, int near) {
  std::vector<PlanPoint> plan;
  for (const auto& [x, y] : {std::pair(far, -near),
                             {far, near},
                             {near, far},
                             {-near, far},
                             {-far, near},
                             {-far, -near},
                             {-near, -far},
                             {near, -far}})
    plan.push_back({sixteenths(middle_x + x), sixteenths(middle_y + y)});
  return plan;
}

/// Puts plane faces together to one mesh; each runs counterclockwise as seen from where light is.
class Faces {
public:
  /// Begins a piece: what is added belongs to it.
  void piece(const std::string& name) { names_.push_back(name); }

  void polygon(const std::vector<Vector<Rational>>& corners) { add(plane_polygon(corners).value()); }

  /// origin + s first + t second within the first loop, out of the others; seen from the side of first x
  /// second.
  void with_holes(const Vector<Rational>& origin, const Vector<Rational>& first,
                  const Vector<Rational>& second, std::vector<PolygonLoop> loops) {
    add(plane_polygon(origin, first, second, std::move(loops)).value());
  }

  /// The sides of a column over a plan that runs counterclockwise, seen from outside.
  void sides(const std::vector<PlanPoint>& plan, const Rational& low, const Rational& high) {
    for (std::size_t k = 0; k < plan.size(); ++k) {
      const PlanPoint& a = plan[k];
      const PlanPoint& b = plan[(k + 1) % plan.size()];
      polygon({{a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, high}, {a.x, a.y, high}});
    }
  }

  /// The plan at a height, seen from above, or from below.
  void lid(std::vector<PlanPoint> plan, const Rational& height, bool from_above) {
    if (!from_above) std::reverse(plan.begin(), plan.end());
    std::vector<Vector<Rational>> corners;
    corners.reserve(plan.size());
    for (const PlanPoint& p : plan) corners.push_back({p.x, p.y, height});
    polygon(corners);
  }

  [[nodiscard]] Surface surface(const std::string& name) const {
    return mesh_surface(name, mesh_, pieces_, names_,
                        {.orientation = Orientation::along_the_cross_product, .closed = true});
  }

private:
  void add(const PlanePolygon& face) {
    const PlaneTriangulation cut = triangulate(face);
    std::vector<std::size_t> places;
    places.reserve(cut.vertices.size());
    for (const ParameterPoint<Rational>& at : cut.vertices) {
      const Vector<Rational> exact = face.point(at);
      const std::array<double, 3> p{exact.x.to_double(), exact.y.to_double(), exact.z.to_double()};
      const auto [found, is_new] = places_.try_emplace(p, mesh_.vertices.size());
      if (is_new) mesh_.vertices.push_back({p[0], p[1], p[2]});
      places.push_back(found->second);
    }
    for (const VertexTriple& t : cut.triangles) {
      mesh_.triangles.push_back({places[t[0]], places[t[1]], places[t[2]]});
      pieces_.push_back(names_.size() - 1);
    }
  }

  TriangleMesh mesh_;
  std::map<std::array<double, 3>, std::size_t> places_;  ///< of vertices
  std::vector<std::size_t> pieces_;
  std::vector<std::string> names_;
};

/// The plan as a loop of parameters (x, y), or (y, x).
PolygonLoop loop_of(const std::vector<PlanPoint>& plan, bool exchanged) {
  PolygonLoop loop;
  loop.reserve(plan.size());
  for (const PlanPoint& p : plan)
    loop.push_back(exchanged ? ParameterPoint<Rational>{p.y, p.x} : ParameterPoint<Rational>{p.x, p.y});
  return loop;
}

Surface room_surface() {
  const Rational none(0);
  const Rational width(4);
  const Rational height(3);
  const std::vector<PlanPoint> whole{{none, none}, {width, none}, {width, width}, {none, width}};
  const std::vector<PlanPoint> tall = square_plan(19, 43, 9, 3);
  const std::vector<PlanPoint> low = square_plan(42, 26, 8, -3);
  const std::vector<PlanPoint> column = octagon_plan(51, 51, 5, 2);
  const std::vector<PlanPoint> shade = square_plan(32, 28, 8, 0);
  const Vector<Rational> along_x{1, 0, 0};
  const Vector<Rational> along_y{0, 1, 0};

  Faces faces;
  faces.piece("floor");
  faces.with_holes(
      {none, none, none}, along_x, along_y,
      {loop_of(whole, false), loop_of(tall, false), loop_of(low, false), loop_of(column, false)});
  faces.piece("ceiling");
  faces.with_holes({none, none, height}, along_y, along_x, {loop_of(whole, true), loop_of(column, true)});
  faces.piece("back");
  faces.polygon({{none, width, none}, {width, width, none}, {width, width, height}, {none, width, height}});
  faces.piece("front");
  faces.polygon({{none, none, none}, {none, none, height}, {width, none, height}, {width, none, none}});
  faces.piece("left");
  faces.polygon({{none, none, none}, {none, width, none}, {none, width, height}, {none, none, height}});
  faces.piece("right");
  faces.polygon({{width, none, none}, {width, none, height}, {width, width, height}, {width, width, none}});
  faces.piece("tall");
  faces.sides(tall, none, sixteenths(29));
  faces.lid(tall, sixteenths(29), true);
  faces.piece("low");
  faces.sides(low, none, sixteenths(13));
  faces.lid(low, sixteenths(13), true);
  faces.piece("column");
  faces.sides(column, none, height);
  faces.piece("shade");
  faces.lid(shade, sixteenths(38), false);
  faces.sides(shade, sixteenths(38), sixteenths(39));
  faces.lid(shade, sixteenths(39), true);
  return faces.surface("lit_room");
}

std::vector<double> albedos(const Surface& surface) {
  const std::map<std::string, double> of_piece{
      {"floor", 0.5},  {"ceiling", 0.8}, {"back", 0.7}, {"front", 0.7},  {"left", 0.35},
      {"right", 0.75}, {"tall", 0.75},   {"low", 0.6},  {"column", 0.7}, {"shade", 0.1}};
  std::vector<double> albedo;
  albedo.reserve(surface.chart_count());
  for (const Chart& chart : surface.charts) albedo.push_back(of_piece.at(chart.facts().piece));
  return albedo;
}

}  // namespace

LitRoom lit_room() {
  Surface surface = room_surface();
  std::vector<double> albedo = albedos(surface);
  return {.scene = LightScene::make(std::move(surface), std::move(albedo)).value(),
          .lamp = {.at = {2, 1.75, 2.1875}, .intensity = 2.5},
          .camera = {.position = {2.25, -4.75, 1.75}, .look_at = {2, 2, 1.4375}, .vertical_angle = 0.57}};
}

}  // namespace radcert::verification::psg10
