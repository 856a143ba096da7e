// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/triangle_basis.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert::verification::m06 {

/// A function on S, by the point of space.
using Solution = double (*)(const Vector<double>& q);

/// What interpolation on one element leaves.
/// Maths     u - P_n u
/// Source    [m06, (15)]
/// Requires  a basis of degree 5 or less, else ContractViolation
/// Result    by the parameters and the point of space, which must belong together
/// Limits    refers to the element and the basis, which must outlive it
class InterpolationRemainder {
public:
  InterpolationRemainder(const Surface& surface, const ParameterTriangle& element,
                         const TriangleBasis<double>& basis, Solution u)
      : element_(&element), basis_(&basis), u_(u), area_(twice_area(element)) {
    expects(basis.nodes().size() <= most_functions, "a basis of degree 5 or less",
            named("functions", basis.nodes().size()));
    for (const Barycentric<double>& q : basis.nodes())
      at_nodes_.push_back(u_(surface.charts[element.chart].in<double>().frame(element.at(q.x)).point));
  }

  double operator()(const ParameterPoint<double>& at, const Vector<double>& q) const {
    const auto& v = element_->vertices;
    const double x2 = cross(at - v[0], v[2] - v[0]) / area_;
    const double x3 = cross(v[1] - v[0], at - v[0]) / area_;
    std::array<double, most_functions> space{};
    const std::span<double> values = std::span<double>(space).first(at_nodes_.size());
    basis_->values({{1 - x2 - x3, x2, x3}}, values);
    double rest = u_(q);
    for (std::size_t j = 0; j < values.size(); ++j) rest -= at_nodes_[j] * values[j];
    return rest;
  }

private:
  static constexpr std::size_t most_functions = 21;

  static double twice_area(const ParameterTriangle& t) {
    return cross(t.vertices[1] - t.vertices[0], t.vertices[2] - t.vertices[0]);
  }

  const ParameterTriangle* element_;
  const TriangleBasis<double>* basis_;
  Solution u_;
  double area_;
  std::vector<double> at_nodes_;
};

}  // namespace radcert::verification::m06
