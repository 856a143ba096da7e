// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/surface/surface.h"

namespace radcert::verification::ac98 {

/// A function of the points of space.
using SpaceFunction = double (*)(const Vector<double>& point);

/// A point of an element, with what a rule needs of it.
struct ElementSample {
  std::array<double, 3> x{};  ///< barycentric coordinates in the element: the values of the linear functions
  Vector<double> point;
  Vector<double> normal;  ///< inner, with the length of the rule's weight times the area element
  double value = 0;       ///< of the element's function
};

/// The corners of a triangle in barycentric coordinates of an element.
using PartCorners = std::array<std::array<double, 3>, 3>;

/// An element of a surface, or of its interpolant, with the points of a rule on it.
/// Result    rounded
/// Limits    refers to the chart, which must outlive it
class CurvedElement {
public:
  /// order: of the conical rule on the whole element and on the parts that it is divided into.
  CurvedElement(const ChartIn<double>& chart, const std::array<ParameterPoint<double>, 3>& triangle,
                SpaceFunction function, int order);

  [[nodiscard]] Frame<double> at(const std::array<double, 3>& x) const {
    return chart_->frame(x[0] * triangle_[0] + x[1] * triangle_[1] + x[2] * triangle_[2]);
  }
  /// The samples of a rule on a part of it.
  [[nodiscard]] std::vector<ElementSample> by(const PartCorners& corners,
                                              const TriangleRule<double>& rule) const;
  [[nodiscard]] const std::vector<ElementSample>& samples() const { return samples_; }
  [[nodiscard]] double diameter() const { return diameter_; }
  [[nodiscard]] int order() const { return order_; }

private:
  const ChartIn<double>* chart_;
  std::array<ParameterPoint<double>, 3> triangle_;
  SpaceFunction function_;
  int order_;
  std::vector<ElementSample> samples_;
  double diameter_ = 0;
};

/// Int G x_i dS, x_i the barycentric coordinates, and behind them Int G f dS.
using ElementSums = std::array<double, 4>;

/// The integrals over elements from one point, with a given normal there.
/// Maths     over: divided until a part is no larger than its distance.  around: triangles that collapse at
///           the point, in whose coordinates (l,t) with x = (1 - l, l (1 - t), l t) the product of G and the
///           Jacobian's factor l is analytic up to l = 0, whatever the normal at the point is
///           order: of either Gauss rule; from a node near a side the angle along that side is less smooth
///           than from a vertex
/// Requires  over: a point off the element; around: the point of the element with these coordinates
/// Result    rounded, without an estimate: compare two orders
class FromPoint {
public:
  FromPoint(const Vector<double>& point, const Vector<double>& normal) : point_(point), normal_(normal) {}

  [[nodiscard]] ElementSums over(const CurvedElement& element) const;
  [[nodiscard]] ElementSums around(const CurvedElement& element, const std::array<double, 3>& x,
                                   int order) const;

private:
  ElementSums divided(const CurvedElement& element, const PartCorners& corners, double diameter) const;
  ElementSums sum(const std::vector<ElementSample>& samples) const;

  Vector<double> point_;
  Vector<double> normal_;
};

}  // namespace radcert::verification::ac98
