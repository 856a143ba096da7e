// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/quadrature/collocation_point.h"
#include "radcert/quadrature/samples.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The collocation nodes of a triangulation.
/// Maths     v_{k,j} = m_k(q_j), element by element, j in the order of the basis
/// Source    [ac98, (36)]; [m06, (13)]
/// Requires  a TriangleBasis, or what one is made of
/// Result    node k * basis.size() + j belongs to element k; an inset of 0 repeats a node in every element
///           that has it: the repeated unknowns have equal equations and so equal values
template <Real R, template <Field> class Basis>
std::vector<CollocationPoint<R>> collocation_nodes(const Surface& surface, const Triangulation& triangulation,
                                                   const Basis<R>& basis) {
  std::vector<CollocationPoint<R>> nodes;
  nodes.reserve(triangulation.triangles.size() * basis.size());
  const std::vector<Barycentric<R>> reference = basis.nodes();
  for (const ParameterTriangle& triangle : triangulation.triangles)
    for (const Barycentric<R>& q : reference) {
      const ElementPart<R> element = whole_element<R>(triangle);
      ParameterPoint<R> at =
          q.x[0] * element.vertices[0] + q.x[1] * element.vertices[1] + q.x[2] * element.vertices[2];
      nodes.push_back(collocation_point<R>(surface, {triangle.chart, at}));
    }
  return nodes;
}

}  // namespace radcert
