// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain.h"

#include <array>
#include <cmath>
#include <vector>

#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/gauss.h"

namespace radcert::bench {
namespace {

constexpr int points_per_side = 10;
constexpr double far_enough = 2;
/// A piece of 2^-26 of the element's size that still holds or touches v_i is dropped: G is bounded on a
/// smooth piece, and the piece has 2^-52 of the element's area.
constexpr int deepest = 26;

using Corners = std::array<Barycentric<double>, 3>;

Barycentric<double> mix(const std::array<double, 3>& weights, const Corners& corners) {
  Barycentric<double> x;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < 3; ++i) x.x[i] += weights[c] * corners[c].x[i];
  return x;
}

class Element {
public:
  Element(const Surface& surface, const ParameterTriangle& triangle, const InsetBasis<double>& basis,
          const IntervalRule<double>& gauss)
      : surface_(surface), triangle_(triangle), basis_(basis), gauss_(gauss) {}

  std::vector<double> integrals(const Vector<double>& p, const Vector<double>& normal_p) const {
    std::vector<double> sums(basis_.size(), 0.0);
    cut_until_far({{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}}, p, normal_p, 0, sums);
    return sums;
  }

private:
  Vector<double> point(const Barycentric<double>& x) const { return frame(x).point; }

  Frame<double> frame(const Barycentric<double>& x) const {
    return surface_.charts[triangle_.chart].in<double>().frame(triangle_.at(x.x));
  }

  void cut_until_far(const Corners& corners, const Vector<double>& p, const Vector<double>& normal_p,
                     int depth, std::vector<double>& sums) const {
    const Vector<double> centre = point(mix({1.0 / 3, 1.0 / 3, 1.0 / 3}, corners));
    double radius = 0;
    for (const Barycentric<double>& corner : corners) radius = std::max(radius, norm(point(corner) - centre));
    if (norm(p - centre) > far_enough * radius) {
      by_gauss(corners, p, normal_p, sums);
      return;
    }
    if (depth == deepest) return;
    const std::array<Barycentric<double>, 3> middle{mix({0, 0.5, 0.5}, corners), mix({0.5, 0, 0.5}, corners),
                                                    mix({0.5, 0.5, 0}, corners)};
    cut_until_far({corners[0], middle[2], middle[1]}, p, normal_p, depth + 1, sums);
    cut_until_far({corners[1], middle[0], middle[2]}, p, normal_p, depth + 1, sums);
    cut_until_far({corners[2], middle[1], middle[0]}, p, normal_p, depth + 1, sums);
    cut_until_far(middle, p, normal_p, depth + 1, sums);
  }

  /// x = (1-s) c_0 + s ((1-t) c_1 + t c_2) with the weight s.
  void by_gauss(const Corners& corners, const Vector<double>& p, const Vector<double>& normal_p,
                std::vector<double>& sums) const {
    const auto at = [&](std::size_t c) { return triangle_.at(corners[c].x); };
    const double area = std::abs(cross(at(1) - at(0), at(2) - at(0)));
    std::vector<double> l(basis_.size());
    for (std::size_t a = 0; a < gauss_.nodes.size(); ++a)
      for (std::size_t b = 0; b < gauss_.nodes.size(); ++b) {
        const double s = gauss_.nodes[a];
        const double t = gauss_.nodes[b];
        const Barycentric<double> x = mix({1 - s, s * (1 - t), s * t}, corners);
        const Frame<double> q = frame(x);
        const double weight = gauss_.weights[a] * gauss_.weights[b] * s * area;
        const double g = geometric_kernel(p, normal_p, q.point, q.area_normal);
        basis_.values(x, l);
        for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += weight * g * l[j];
      }
  }

  const Surface& surface_;
  const ParameterTriangle& triangle_;
  const InsetBasis<double>& basis_;
  const IntervalRule<double>& gauss_;
};

}  // namespace

Matrix<double> plain_collocation_matrix(const Surface& surface, const Triangulation& triangulation,
                                        const InsetBasis<double>& basis) {
  const std::vector<ParameterTriangle>& triangles = triangulation.triangles;
  const std::vector<Barycentric<double>> nodes = basis.nodes();
  const std::size_t unknowns = triangles.size() * basis.size();
  const IntervalRule<double> gauss = gauss_rule<double>(points_per_side, IntervalWeight::one);
  Matrix<double> matrix(unknowns, unknowns);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const Element element(surface, triangles[k], basis, gauss);
    for (std::size_t i = 0; i < unknowns; ++i) {
      const ParameterTriangle& own = triangles[i / basis.size()];
      const Barycentric<double>& node = nodes[i % basis.size()];
      if (in_one_plane(surface.charts[own.chart], surface.charts[triangles[k].chart])) continue;
      const Frame<double> p = surface.charts[own.chart].in<double>().frame(own.at(node.x));
      const std::vector<double> integrals = element.integrals(p.point, unit_normal(p));
      for (std::size_t j = 0; j < basis.size(); ++j)
        matrix(i, k * basis.size() + j) = integrals[j] / pi<double>();
    }
  }
  return matrix;
}

}  // namespace radcert::bench
