// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/level_geometry.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "radcert/clusters/cluster_tree.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/checked.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/study/collocation/collocation.h"
#include "radcert/study/collocation/matrix_form.h"
#include "radcert/study/events/event_triangulation.h"
#include "radcert/triangulation/conforming_charts.h"
#include "radcert/triangulation/interpolated_surface.h"

namespace radcert {
namespace {

NodedSurface noded(Surface surface, Triangulation triangulation, const TriangleBasis<double>& basis) {
  NodedSurface result{.surface = std::move(surface), .triangulation = std::move(triangulation), .nodes = {}};
  result.nodes = collocation_nodes(result.surface, result.triangulation, basis);
  return result;
}

/// Fourth powers of distances, down to 2^-44 of the coordinates, and areas must be in the range of double.
void require_scale(const std::vector<CollocationPoint<double>>& nodes) {
  constexpr double least = 0x1p-200;
  constexpr double most = 0x1p200;
  double largest = 0;
  for (const CollocationPoint<double>& node : nodes)
    largest = std::max({largest, std::abs(node.point.x), std::abs(node.point.y), std::abs(node.point.z)});
  if (largest >= least && largest <= most) return;
  throw InputError(
      {.pointer = "/surface",
       .value = shortest(largest),
       .problem = "is the largest coordinate of a node: G is not found in double at such a scale",
       .allowed = "a surface whose largest coordinate is between 1e-60 and 1e60"});
}

}  // namespace

std::optional<LevelClusters> clusters_of_level(const Problem& problem, int level, const Ranks& ranks) {
  const Surface surface = surface_of(problem);
  const TriangulationOptions options = triangulation_options(problem, surface);
  const std::uint64_t functions = function_count(triangle_basis_of(problem.method));
  const std::optional<std::uint64_t> elements = triangle_count(surface, level, options);
  if (!elements || !takes_clusters(problem, saturated_product(*elements, functions))) return std::nullopt;
  const int refinements = std::min(level, leaf_refinements(functions));
  const int leaves = level - refinements;
  ClusterTree tree =
      options.grading != 1
          ? ClusterTree::graded(triangulate(surface, level, options), level, refinements).value()
          : ClusterTree::above(triangulate(surface, leaves, options), leaves, refinements).value();
  if (const std::size_t most = ClusterPart::most_ranks(tree); ranks.count() > most)
    throw InputError({.source = "the number of ranks",
                      .value = std::to_string(ranks.count()),
                      .problem = "is more than the subtrees of clusters at level " + std::to_string(level),
                      .allowed = "at most " + std::to_string(most) + ", or finer levels alone"});
  const ClusterPart part(tree, ranks);
  return LevelClusters{std::move(tree), part};
}

LevelGeometry::LevelGeometry(const Problem& problem, int level, const TriangleBasis<double>& basis,
                             const std::optional<ElementRange>& part) {
  Surface surface = surface_of(problem);
  const TriangulationOptions options = triangulation_options(problem, surface);
  Triangulation triangulation =
      part ? triangulate_part(surface, level, options, *part) : triangulate(surface, level, options);
  // Symmetric refinement keeps what the coarsest triangles are, and is exact down to 2^-51.
  constexpr int exact_levels = 50;
  const Outcome<void> fits =
      conforming(surface, part && level <= exact_levels ? triangulate(surface, 0, options) : triangulation);
  if (!fits)
    throw InputError(
        {.pointer = "/triangulation",
         .value = "level " + std::to_string(level),
         .problem = "makes no triangulation whose triangles double tells apart: " + fits.reason(),
         .allowed = "a lower level, or a grading nearer to 1"});
  mesh_size_ = radcert::mesh_size(triangulation);
  if (!problem.geometry) {
    data_ = noded(std::move(surface), std::move(triangulation), basis);
    require_scale(data_.nodes);
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
  require_scale(data_.nodes);
}

LevelResult level_header(const Problem& problem, int level, const LevelSizes& sizes) {
  LevelResult header;
  header.level = level;
  header.elements = sizes.elements;
  header.unknowns = sizes.unknowns;
  header.mesh_size = sizes.mesh_size;
  header.matrix_form = takes_clusters(problem, sizes.unknowns) ? "h2" : "dense";
  header.solver = problem.solver.name;
  header.planned_bytes = level_plan(problem, header.elements).total();
  return header;
}

}  // namespace radcert
