// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/scalar/ball.h"
#include "radcert/surface/chart.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The vertices of a triangle of parameters, and its area.
[[nodiscard]] std::array<ParameterPoint<Ball>, 3> vertices_of(const ParameterTriangle& triangle);
[[nodiscard]] Ball area_of(const std::array<ParameterPoint<Ball>, 3>& vertices);

/// An interpolation node of a cluster.
/// Maths     weight = |D_s F x D_t F| times the area of the cluster in the parameter plane: the mean over the
///           cluster of f weight is its part of Int f dS
struct EnclosedNode {
  Frame<Ball> frame;
  Ball weight;
};

/// The exact_interpolation_nodes of a degree in a cluster.
/// Requires  a chart that is known in balls
[[nodiscard]] std::vector<EnclosedNode> enclosed_nodes(const Chart& chart, const ParameterTriangle& triangle,
                                                       int degree);

}  // namespace radcert
