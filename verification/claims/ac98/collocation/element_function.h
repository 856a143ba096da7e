// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "radcert/study/study.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/framework/finding.h"

namespace radcert::verification::ac98 {

/// A function that is a polynomial on each element, given by its values at the nodes of a solved level.
/// Maths     u_n(m_k(x)) = sum_j u_n(v_kj) l_j(x)
/// Source    [ac98, (39)]
/// Requires  the level belongs to the problem, whose geometry is exact
/// Result    rounded
class ElementFunction {
public:
  ElementFunction(const Problem& problem, const LevelOutcome& level);

  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] const std::vector<ParameterTriangle>& triangles() const { return triangles_; }
  [[nodiscard]] std::size_t nodes_per_element() const { return nodes_per_element_; }
  /// The node of an element.
  [[nodiscard]] SurfacePoint<double> node(std::size_t element, std::size_t index) const;
  [[nodiscard]] double node_value(std::size_t element, std::size_t index) const {
    return values_[element * nodes_per_element_ + index];
  }
  /// Changes a value at a node.
  void add_to_node(std::size_t element, std::size_t index, double change) {
    values_[element * nodes_per_element_ + index] += change;
  }
  /// The value at a point of the parameter plane, taken as one of the element.
  [[nodiscard]] double operator()(std::size_t element, const ParameterPoint<double>& at) const;
  /// Int_S G(P,Q) u_n(Q) dS_Q, element by element through the reference layer.
  [[nodiscard]] Approximation integral(const SurfacePoint<double>& p) const;

private:
  Surface surface_;
  std::vector<ParameterTriangle> triangles_;
  int degree_;
  double inset_;
  std::size_t nodes_per_element_;
  std::vector<double> values_;
};

/// The error of the iterated solution at points of S.
/// Maths     |hat u_n - u| = |K (u_n - u)|, hat u_n = E + K u_n
/// Source    [ac98, (42)]
/// Requires  a problem with `solution` and exact geometry, and a level of it
/// Result    the radius is that of both integrals, K u by the route; an estimate
class IteratedError {
public:
  IteratedError(const OperatorRoute& route, const Problem& problem, const LevelOutcome& level);
  IteratedError(const IteratedError&) = delete;
  IteratedError& operator=(const IteratedError&) = delete;

  [[nodiscard]] const ElementFunction& u_n() const { return u_n_; }
  [[nodiscard]] Approximation operator()(const SurfacePoint<double>& p) const;

private:
  ElementFunction u_n_;
  SurfaceFunction u_;
  PiecewiseExpression reflectivity_;
  AppliedOperator of_u_;
};

}  // namespace radcert::verification::ac98
