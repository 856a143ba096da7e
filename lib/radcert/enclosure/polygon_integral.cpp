// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/polygon_integral.h"

#include "radcert/core/contract.h"

namespace radcert {

std::vector<SquareMap> fan(const ParameterPolygon& polygon, const ParameterPoint<Rational>& apex) {
  std::vector<SquareMap> maps;
  int sense = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ParameterPoint<Rational> first = polygon[k] - apex;
    const ParameterPoint<Rational> along = polygon[(k + 1) % polygon.size()] - polygon[k];
    const ParameterPoint<Rational> after =
        polygon[(k + 2) % polygon.size()] - polygon[(k + 1) % polygon.size()];
    const int sign = cross(first, along).sign();
    for (const int turn : {sign, cross(along, after).sign()}) {
      expects(turn == 0 || sense == 0 || turn == sense, "a convex polygon and a point of it",
              named("corner", k));
      if (turn != 0) sense = turn;
    }
    if (sign == 0) continue;
    maps.push_back({.apex = apex, .first = first, .along = along});
  }
  expects(!maps.empty(), "a polygon with an area", named("corners", polygon.size()));
  return maps;
}

std::vector<SquareMap> square_maps(const ParameterPolygon& polygon) {
  expects(polygon.size() >= 3, "three corners or more", named("corners", polygon.size()));
  if (polygon.size() == 4 && polygon[0] + polygon[2] == polygon[1] + polygon[3] &&
      cross(polygon[1] - polygon[0], polygon[3] - polygon[0]).sign() != 0) {
    return {{.apex = polygon[0],
             .first = polygon[1] - polygon[0],
             .along = polygon[3] - polygon[0],
             .parallelogram = true}};
  }
  return fan(polygon, polygon[0]);
}

}  // namespace radcert
