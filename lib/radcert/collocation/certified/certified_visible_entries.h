// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "radcert/collocation/certified/certified_entries.h"
#include "radcert/core/outcome.h"
#include "radcert/geometry/vector.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"
#include "radcert/visibility/scene.h"

namespace radcert {

/// A plane element as a part of a triangle of a scene.
/// Maths     corner (s,t) is the point c_0 + s (c_1 - c_0) + t (c_2 - c_0) of the triangle with corners c
/// Requires  s, t >= 0, s + t <= 1, the corners counterclockwise in (s,t)
/// Result    exact
struct SceneElement {
  std::size_t triangle = 0;
  std::array<ParameterPoint<Rational>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
};

/// The collocation matrix of a scene whose parts hide each other, proved.
/// Maths     |entries(i, k p + j) - rho(v_i)/pi Int_{Delta_k} G(v_i,Q) V(v_i,Q) l_j(Q) dS_Q| <= radius(i, k p
///           + j), p functions an element, the nodes as in certified_entries
/// Source    what a node sees of a triangle is cut into convex parts in exact arithmetic (PointView,
///           exact_corners), these are cut to the element, exactly too, and PlaneElement integrates the
///           functions of the element over each
/// Requires  elements as SceneElement says; functions of degree at most 8; a reflectivity a node, finite and
///           taken as exact; else ContractViolation. scene_faults(scene.mesh()) is empty
/// Result    radii of about 1e-14 max |l_j| of what the node sees of the element, times reflectivity/pi, as
///           where nothing is hidden. Exactly 0 but for underflow where nothing is seen. Refused as
///           certified_entries refuses. The same bits for any number of threads; Interrupted when asked to
///           stop
/// Limits    a part costs some milliseconds, at high degree more: it is prepared for one node. A node on
///           another element's edge, off its plane, is a ContractViolation
Outcome<CertifiedEntries> certified_visible_entries(const Scene& scene,
                                                    std::span<const SceneElement> elements,
                                                    const LagrangeFunctions& functions,
                                                    std::span<const double> reflectivity);

/// The same of a mesh, with the reflectivity 1: the elements of a triangulation, their nodes in the order of
/// the charts' parameters.
/// Requires  a mesh, a triangulation of it; functions of degree at most 8, else ContractViolation
/// Result    as above. Refused too where the inner normals run against the charts' cross products and the
///           nodes or their functions are not symmetric to an exchange of two corners
Outcome<CertifiedEntries> certified_mesh_entries(const Surface& mesh, const Triangulation& triangulation,
                                                 const LagrangeFunctions& functions);

}  // namespace radcert
