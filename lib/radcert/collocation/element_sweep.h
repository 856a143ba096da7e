// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "radcert/collocation/visible_element.h"
#include "radcert/core/contract.h"
#include "radcert/quadrature/element_integrator.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The integrals of all basis functions over elements, as seen from points of the surface, block by block.
/// Maths     (i, k) -> Int_{Delta_k} G(P_i,Q) V(P_i,Q) l_j(Q) dS_Q for every j
/// Source    [ac98, (40)]
/// Requires  in double surfaces that are unoccluded, where V = 1, and meshes; beyond double unoccluded
///           surfaces, else ContractViolation. No point on an edge at which pieces meet at an angle. What is
///           passed in outlives this
/// Result    as ElementIntegrator and integrate_visible say; several threads may sweep over elements of their
///           own
template <Real R>
class ElementSweep {
public:
  ElementSweep(const Surface& surface, const Triangulation& triangulation, const TriangleBasis<R>& basis,
               std::span<const CollocationPoint<R>> points, const Tolerance& tolerance)
      : surface_(surface),
        triangulation_(triangulation),
        points_(points),
        scheme_(std::make_shared<const IntegrationScheme<R>>(surface, basis, tolerance)),
        blocks_(observer_blocks(points)) {
    if (surface.unoccluded) return;
    expects(std::is_same_v<R, double>, "an unoccluded surface beyond double", named("surface", surface.name));
    scene_.emplace(surface);
  }

  /// Calls take(block, k, integral) for the elements begin <= k < end one after the other, and of each for
  /// every block of points.
  template <class Take>
  void over(std::size_t begin, std::size_t end, const Take& take) const {
    BlockIntegral<R> integral;
    std::optional<NodeSights> sights;
    for (std::size_t k = begin; k < end; ++k) {
      const ParameterTriangle& triangle = triangulation_.triangles[k];
      ElementIntegrator<R> element(scheme_, triangle);
      for (const CollocationPointBlock<R>& block : blocks_) {
        integrate(triangle, block, element, sights, integral);
        take(block, k, integral);
      }
    }
  }

private:
  void integrate(const ParameterTriangle& triangle, const CollocationPointBlock<R>& block,
                 ElementIntegrator<R>& element, std::optional<NodeSights>& sights,
                 BlockIntegral<R>& integral) const {
    if constexpr (std::is_same_v<R, double>) {
      if (scene_) {
        if (!sights) sights.emplace(*scene_, points_);
        sights->look_at(triangle.chart);
        integrate_visible(triangle, block, points_, *sights, surface_.charts[triangle.chart], element,
                          integral);
        return;
      }
    }
    element.integrate(block, points_, integral);
  }

  const Surface& surface_;
  const Triangulation& triangulation_;
  std::span<const CollocationPoint<R>> points_;
  std::shared_ptr<const IntegrationScheme<R>> scheme_;
  std::vector<CollocationPointBlock<R>> blocks_;
  std::optional<SurfaceScene> scene_;  ///< that hides parts of an occluded surface; none where V = 1
};

}  // namespace radcert
