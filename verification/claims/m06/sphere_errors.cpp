// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/sphere_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "radcert/core/parallel.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::m06 {
namespace {

struct Remainders {
  double coarse = 0;  ///< integrals by two rules, over twice the area of an element
  double fine = 0;
  double least = 0;  ///< of the sample
  double largest = 0;
};

Remainders sum_of(const Remainders& a, const Remainders& b) {
  return {a.coarse + b.coarse, a.fine + b.fine, std::min(a.least, b.least), std::max(a.largest, b.largest)};
}

class OnElement {
public:
  OnElement(const Surface& surface, const TriangleBasis<double>& basis, Solution u)
      : surface_(&surface), basis_(&basis), u_(u) {}

  Remainders operator()(const ParameterTriangle& element) const {
    const InterpolationRemainder rest(*surface_, element, *basis_, u_);
    const ChartIn<double>& chart = surface_->charts[element.chart].in<double>();
    const auto by_rule = [&](const TriangleRule<double>& rule) {
      double sum = 0;
      for (std::size_t k = 0; k < rule.points.size(); ++k) {
        const ParameterPoint<double> at = element.at(rule.points[k].x);
        const Frame<double> frame = chart.frame(at);
        sum += rule.weights[k] * rest(at, frame.point) * area_element(frame);
      }
      return sum;
    };
    Remainders part{.coarse = by_rule(coarse_), .fine = by_rule(fine_)};
    for (const Barycentric<double>& x : sample_) {
      const ParameterPoint<double> at = element.at(x.x);
      const double value = rest(at, chart.frame(at).point);
      part.least = std::min(part.least, value);
      part.largest = std::max(part.largest, value);
    }
    return part;
  }

private:
  const Surface* surface_;
  const TriangleBasis<double>* basis_;
  Solution u_;
  TriangleRule<double> coarse_ = conical_rule<double>(8, Grading::none);
  TriangleRule<double> fine_ = conical_rule<double>(10, Grading::none);
  std::vector<Barycentric<double>> sample_ = inset_nodes<double>(8, 0);
};

}  // namespace

double fourth_power(const Vector<double>& q) { return q.x * q.x * q.x * q.x; }

SphereErrors errors_on_the_sphere(const TriangleBasis<double>& basis, Solution u,
                                  const std::vector<int>& levels) {
  const Surface surface = sphere();
  const OnElement on_element(surface, basis, u);
  std::vector<Remainders> of_levels;
  for (const int level : levels) {
    std::vector<ParameterTriangle> elements = triangulate(surface, level).triangles;
    std::erase_if(elements, [](const ParameterTriangle& t) { return t.chart != 0; });
    // Element by element: the sums are of the size of an element's error, and so is their rounding.
    Remainders sum = parallel_reduce_ordered(
        elements.size(), 64, Remainders{},
        [&](std::size_t begin, std::size_t end) {
          Remainders part;
          for (std::size_t k = begin; k < end; ++k) part = sum_of(part, on_element(elements[k]));
          return part;
        },
        sum_of);
    const double per_area = std::ldexp(1.0, -2 * level) / (std::numbers::pi / 2);
    sum.coarse *= per_area;
    sum.fine *= per_area;
    of_levels.push_back(sum);
  }
  // Rounding of u <= 1, some units in the last place at each point.
  constexpr double rounding = 1e-15;
  std::size_t next = 0;
  const LevelErrors nodes = over_levels(levels, [&](int) {
    const Remainders& sum = of_levels.at(next++);
    return Approximation{.value = std::abs(sum.fine), .radius = std::abs(sum.fine - sum.coarse) + rounding};
  });
  next = 0;
  const LevelErrors uniform = over_levels(levels, [&](int) {
    const Remainders& sum = of_levels.at(next++);
    return Approximation{.value = std::max(sum.largest + sum.fine, -(sum.least + sum.fine)), .radius = 0};
  });
  return {.nodes = nodes, .uniform = uniform};
}

}  // namespace radcert::verification::m06
