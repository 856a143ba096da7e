// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/interpolated_chart.h"

#include <algorithm>
#include <utility>

#include "radcert/surface/exact_chart.h"

namespace radcert {
namespace {

Vector<Rational> exactly(const Vector<double>& v) {
  return {Rational::exactly(v.x), Rational::exactly(v.y), Rational::exactly(v.z)};
}

/// The plane of an element's corners, the images of (0,0), (1,0) and (0,1).
Plane plane_of_corners(const Vector<double>& corner, const std::vector<Vector<double>>& from_corner,
                       int degree) {
  return {exactly(corner), exactly(from_corner.back()),
          exactly(from_corner[static_cast<std::size_t>(degree)])};
}

/// Whether no difference leaves the plane.
bool all_along(const Plane& plane, const std::vector<Vector<double>>& differences) {
  return std::all_of(differences.begin(), differences.end(), [&plane](const Vector<double>& d) {
    return dot(plane.normal(), exactly(d)).sign() == 0;
  });
}

}  // namespace

Chart interpolated_chart(const Chart& chart, const std::array<ParameterPoint<double>, 3>& vertices,
                         int degree, std::string name) {
  using Polynomial = LatticePolynomial<double>;
  expects(Polynomial::smallest_degree <= degree && degree <= Polynomial::largest_degree, "1 <= degree <= 6",
          named("degree", degree));
  const ChartIn<double>& formula = chart.in<double>();
  const ParameterPoint<double> along_s = vertices[1] - vertices[0];
  const ParameterPoint<double> along_t = vertices[2] - vertices[0];
  const Vector<double> corner = formula.frame(vertices[0]).point;
  std::vector<Vector<double>> from_corner;
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; a + b <= degree; ++b)
      from_corner.push_back(formula
                                .chord(vertices[0], (static_cast<double>(a) / degree) * along_s +
                                                        (static_cast<double>(b) / degree) * along_t)
                                .difference);
  ChartFacts facts{.name = std::move(name),
                   .piece = chart.facts().piece,
                   .domain = ChartDomain::unit_triangle,
                   .orientation = chart.facts().orientation};
  if (degree == 1) {
    facts.plane = plane_of_corners(corner, from_corner, degree);
  } else if (chart.facts().flat_in()) {
    const Plane plane = plane_of_corners(corner, from_corner, degree);
    if (all_along(plane, from_corner)) facts.plane_of_disk = plane;
  }
  return make_exact_chart<LatticePolynomial>(std::move(facts), degree, corner, from_corner);
}

}  // namespace radcert
