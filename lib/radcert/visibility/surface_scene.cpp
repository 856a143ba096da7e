// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/surface_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

/// Whether the inner normals run against the cross products of the charts; a mesh has one orientation.
bool runs_against(const Surface& surface) {
  return surface.charts.front().facts().orientation == Orientation::against_the_cross_product;
}

const TriangleMesh& mesh_of(const Surface& surface) {
  expects(surface.mesh != nullptr && surface.chart_count() == surface.mesh->triangles.size() &&
              !surface.charts.empty(),
          "a surface that is a mesh", named("surface", surface.name));
  return *surface.mesh;
}

TriangleMesh facing_inwards(const Surface& surface) {
  TriangleMesh mesh = mesh_of(surface);
  if (runs_against(surface))
    for (VertexTriple& corners : mesh.triangles) std::swap(corners[1], corners[2]);
  return mesh;
}

/// The distance from p to the segment from a to b.
double distance_to(const Vector<double>& p, const Vector<double>& a, const Vector<double>& b) {
  const Vector<double> along = b - a;
  const double length_squared = dot(along, along);
  const double at = length_squared > 0 ? std::clamp(dot(p - a, along) / length_squared, 0.0, 1.0) : 0.0;
  return norm(p - (a + at * along));
}

}  // namespace

SurfaceScene::SurfaceScene(const Surface& surface)
    : exchanged_(!mesh_of(surface).triangles.empty() && runs_against(surface)),
      scene_(facing_inwards(surface)) {}

PointView SurfaceScene::view(std::size_t chart, const Vector<double>& point,
                             const Vector<double>& normal) const {
  return PointView(scene_, {.point = point, .normal = normal, .triangle = chart});
}

ChartView SurfaceScene::seen(PointView& view, std::size_t chart) const {
  VisibleRegion region = view.region(chart);
  ChartView seen{.sight = region.sight, .parts = {}};
  if (region.sight != Sight::part) return seen;
  for (VisiblePart& part : region.parts) {
    if (exchanged_) {
      for (ParameterPoint<double>& corner : part.corners) std::swap(corner.s, corner.t);
      std::reverse(part.corners.begin(), part.corners.end());
    }
    seen.parts.push_back(std::move(part.corners));
  }
  return seen;
}

double strip_bound(const Vector<double>& p, const ChartIn<double>& chart,
                   std::span<const ParameterPoint<double>> corners) {
  const Frame<double> frame = chart.frame(corners[0]);
  const double height = std::abs(dot(p - frame.point, unit_normal(frame)));
  const double width = 0x1p-50 * (norm(frame.tangent_s) + norm(frame.tangent_t));
  double bound = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector<double> a = chart.frame(corners[k]).point;
    const Vector<double> b = chart.frame(corners[(k + 1) % corners.size()]).point;
    const double distance = std::max(distance_to(p, a, b), height);
    if (distance > 0) bound += width * norm(b - a) * height / (distance * distance * distance);
  }
  return bound;
}

}  // namespace radcert
