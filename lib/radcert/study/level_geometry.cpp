// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/level_geometry.h"

#include <utility>

#include "radcert/collocation/nodes.h"
#include "radcert/core/contract.h"
#include "radcert/triangulation/conforming_charts.h"
#include "radcert/triangulation/interpolated_surface.h"

namespace radcert {
namespace {

TriangulationOptions options_of(const Problem& problem, const Surface& surface) {
  TriangulationOptions options;
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

NodedSurface noded(Surface surface, Triangulation triangulation, const TriangleBasis<double>& basis) {
  NodedSurface result{.surface = std::move(surface), .triangulation = std::move(triangulation), .nodes = {}};
  result.nodes = collocation_nodes(result.surface, result.triangulation, basis);
  return result;
}

}  // namespace

LevelGeometry::LevelGeometry(const Problem& problem, int level, const TriangleBasis<double>& basis) {
  Surface surface = surface_of(problem);
  Triangulation triangulation = triangulate(surface, level, options_of(problem, surface));
  const Outcome<void> fits = conforming(surface, triangulation);
  expects(fits.has_value(), "a triangulation with T1-T3", named("fault", fits ? "" : fits.reason()));
  mesh_size_ = radcert::mesh_size(triangulation);
  if (!problem.geometry) {
    data_ = noded(std::move(surface), std::move(triangulation), basis);
    return;
  }
  InterpolatedSurface interpolated = interpolate(surface, triangulation, problem.geometry->degree);
  NodedSurface interpolant =
      noded(std::move(interpolated.surface), std::move(interpolated.triangulation), basis);
  if (problem.geometry->data == DataPoints::interpolant) {
    data_ = std::move(interpolant);
  } else {
    data_ = noded(std::move(surface), std::move(triangulation), basis);
    interpolant_ = std::move(interpolant);
  }
}

}  // namespace radcert
