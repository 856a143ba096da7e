// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/mesh_surface.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_classes.h"
#include "radcert/surface/catalogue/rectangle.h"

namespace radcert {
namespace {

/// Whether every number of `of` has triangles of one plane only. Triangle t counts for the numbers of(t).
class OnePlane {
public:
  OnePlane(std::size_t count, const PlaneClasses& planes) : planes_(planes), plane_(count) {}
  void add(std::size_t number, std::size_t triangle) {
    std::optional<std::size_t>& plane = plane_[number];
    if (plane && *plane != planes_.of_triangle[triangle]) holds_ = false;
    plane = planes_.of_triangle[triangle];
  }
  [[nodiscard]] bool holds() const { return holds_; }

private:
  const PlaneClasses& planes_;
  std::vector<std::optional<std::size_t>> plane_;
  bool holds_ = true;
};

}  // namespace

Surface mesh_surface(const std::string& name, const TriangleMesh& mesh,
                     std::span<const std::size_t> piece_of_triangle, std::span<const std::string> piece_names,
                     const MeshFacts& facts) {
  expects(piece_of_triangle.size() == mesh.triangles.size(), "a piece for each triangle",
          named("pieces", piece_of_triangle.size()));
  const PlaneClasses planes = plane_classes(mesh);
  OnePlane by_piece(piece_names.size(), planes);
  OnePlane by_vertex(mesh.vertices.size(), planes);
  std::size_t shown = 0;
  for (const std::size_t piece : piece_of_triangle) {
    expects(piece <= shown, "pieces numbered in the order in which triangles show them",
            named("piece", piece));
    shown = std::max(shown, piece + 1);
  }
  Surface surface;
  surface.name = name;
  surface.closed = facts.closed;
  surface.unoccluded = facts.unoccluded;
  surface.mesh = std::make_shared<const TriangleMesh>(mesh);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const std::size_t piece = piece_of_triangle[k];
    expects(piece < piece_names.size(), "a piece with a name", named("piece", piece));
    by_piece.add(piece, k);
    for (const std::size_t vertex : mesh.triangles[k]) by_vertex.add(vertex, k);
    const auto corners = mesh.corners(k);
    const Vector<Rational> origin = exactly(corners[0]);
    const Vector<Rational> first = exactly(corners[1]) - origin;
    const Vector<Rational> second = exactly(corners[2]) - origin;
    ChartFacts chart{.name = piece_names[piece] + "/" + std::to_string(k),
                     .piece = piece_names[piece],
                     .domain = ChartDomain::unit_triangle,
                     .orientation = facts.orientation,
                     .plane = Plane(origin, first, second)};
    surface.charts.push_back(make_chart<Rectangle>(std::move(chart), origin, first, second));
  }
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.charts_join_smoothly = by_piece.holds();
  surface.pieces_meet_at_angle = !by_vertex.holds();
  return surface;
}

}  // namespace radcert
