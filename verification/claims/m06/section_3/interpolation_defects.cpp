// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/section_3/interpolation_defects.h"

#include <vector>

namespace radcert::verification::m06 {
namespace {

struct PlanePoint {
  Ball x;
  Ball y;
};

Ball monomial(const PlanePoint& at, int a, int b) { return power(at.x, a) * power(at.y, b); }

// Both halves, or the one triangle.
std::vector<PlanePoint> places(const Barycentric<Ball>& q, Region region, Halves halves) {
  const Ball s = q.x[2];
  const Ball t = q.x[1];
  if (region == Region::triangle) return {{s, t}};
  if (halves == Halves::mirrored) return {{s, t}, {-s, t}};
  const Ball half = Ball(1) / Ball(2);
  return {{s - half, t - half}, {half - s, half - t}};
}

}  // namespace

Ball largest_defect(const TriangleBasis<Ball>& basis, Region region, int total_degree, Halves halves) {
  const std::vector<Barycentric<Ball>> nodes = basis.nodes();
  // Phi L g has the degree total_degree + r at most; the rule is exact up to 2 order - 1.
  const TriangleRule<Ball> rule = conical_rule<Ball>((total_degree + basis.degree()) / 2 + 1, Grading::none);
  std::vector<std::vector<Ball>> values;
  for (const Barycentric<Ball>& q : rule.points) {
    values.emplace_back(basis.size());
    basis.values(q, std::span<Ball>(values.back()));
  }
  Ball largest = 0;
  for (int of_g = 0; of_g <= total_degree; ++of_g)
    for (int d = 0; d <= of_g; ++d) {
      // (I - L) g at the points of the rule, on each half.
      std::vector<std::vector<Ball>> left_over;
      for (std::size_t p = 0; p < rule.points.size(); ++p) {
        left_over.emplace_back();
        const std::vector<PlanePoint> here = places(rule.points[p], region, halves);
        for (std::size_t half = 0; half < here.size(); ++half) {
          Ball rest = monomial(here[half], of_g - d, d);
          for (std::size_t j = 0; j < nodes.size(); ++j)
            rest -= monomial(places(nodes[j], region, halves)[half], of_g - d, d) * values[p][j];
          left_over.back().push_back(rest);
        }
      }
      const int of_phi = total_degree - of_g;
      for (int b = 0; b <= of_phi; ++b) {
        Ball sum = 0;
        for (std::size_t p = 0; p < rule.points.size(); ++p) {
          const std::vector<PlanePoint> here = places(rule.points[p], region, halves);
          for (std::size_t half = 0; half < here.size(); ++half)
            sum += rule.weights[p] * monomial(here[half], of_phi - b, b) * left_over[p][half];
        }
        largest = max(largest, abs(sum));
      }
    }
  return largest;
}

}  // namespace radcert::verification::m06
