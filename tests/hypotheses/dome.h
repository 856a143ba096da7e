// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/chart.h"
#include "radcert/surface/surface.h"

namespace radcert::sample {

/// z = 1 - (x^2 + 2 y^2) / 4 + dent x^3 over the unit square, convex up to dent = 1/12.
template <Field R>
class Dome {
public:
  explicit Dome(const Rational& dent) : dent_(from_rational<R>(dent)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const R quarter = from_rational<R>(Rational(1, 4));
    return {s, t, R(1) - quarter * (s * s + R(2) * (t * t)) + dent_ * (s * s * s)};
  }

private:
  R dent_;
};

/// A dome that states nothing of itself, above a floor that it does not meet.
inline Surface dome_over_floor(const Rational& dent) {
  Surface surface;
  surface.name = "dome";
  surface.charts.push_back(
      make_rectangle({.name = "floor", .piece = "floor"}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  surface.charts.push_back(make_chart<Dome>(
      {.name = "dome", .piece = "dome", .orientation = Orientation::against_the_cross_product}, dent));
  surface.diagonals.assign(2, Diagonal::main);
  return surface;
}

}  // namespace radcert::sample
