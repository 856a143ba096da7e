// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/interpolated_chart.h"

#include <utility>

namespace radcert {
namespace {

Vector<Rational> exactly(const Vector<double>& v) {
  return {Rational::exactly(v.x), Rational::exactly(v.y), Rational::exactly(v.z)};
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
  if (degree == 1) facts.plane = Plane(exactly(corner), exactly(from_corner[2]), exactly(from_corner[1]));
  return make_chart<LatticePolynomial>(std::move(facts), degree, corner, from_corner);
}

}  // namespace radcert
