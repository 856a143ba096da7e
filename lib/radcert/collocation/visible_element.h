// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/quadrature/collocation_point_block.h"
#include "radcert/quadrature/element_integrator.h"
#include "radcert/triangulation/triangulation.h"
#include "radcert/visibility/surface_scene.h"

namespace radcert {

/// The parts that the nodes see, of one chart after the other.
/// Maths     node i -> the parts of the chart that are seen from v_i
/// Source    [ac98, (1)]
/// Requires  scene and nodes outlive this
/// Result    exact as PointView says
/// Limits    for one thread
class NodeSights {
public:
  NodeSights(const SurfaceScene& scene, std::span<const CollocationPoint<double>> nodes);

  /// Makes `chart` the one that is looked at.
  void look_at(std::size_t chart);
  [[nodiscard]] const ChartView& of(std::size_t node) const { return seen_[node]; }

private:
  const SurfaceScene& scene_;
  std::vector<PointView> views_;
  std::optional<std::size_t> chart_;
  std::vector<ChartView> seen_;
};

/// The collocation integrals of a block of nodes over what they see of one element.
/// Maths     value[j] = Int_Delta G(v_i,Q) V(v_i,Q) l_j(Q) dS_Q
/// Source    [ac98, (40)] with the V of (1)
/// Requires  sights that look at the element's chart, a plane one
/// Result    a part that is seen is cut to the element in its parameters and integrated triangle by triangle,
///           as ElementIntegrator does; where all of the element is seen, or nothing, the integral is that
///           without V, or 0. radius counts the rounding of corners
void integrate_visible(const ParameterTriangle& triangle, const CollocationPointBlock<double>& block,
                       std::span<const CollocationPoint<double>> nodes, const NodeSights& sights,
                       const Chart& chart, ElementIntegrator<double>& element,
                       BlockIntegral<double>& integral);

}  // namespace radcert
