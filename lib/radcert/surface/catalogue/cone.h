// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/surface/catalogue/disk.h"
#include "radcert/surface/exact_chart.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A quarter of the mantle of a truncated cone about the z-axis.
/// Maths     F(s,t) = (+-r(t) x, +-r(t) y, h t),  (x,y) = arc_point(s),  r(t) = radius + (top - radius) t
/// Source    see arc_point
/// Requires  radius, top, h > 0
/// Result    see ChartOf; straight in t
/// Limits    a chart up to an apex, top = 0, would have vanishing area normals there: no chart of a cone is smooth at its apex
template <Field R>
class ConeMantle {
public:
  ConeMantle(const Rational& radius, const Rational& top, const Rational& height, const Quadrant& quadrant)
      : radius_(from_rational<R>(radius)),
        growth_(from_rational<R>(top - radius)),
        height_(from_rational<R>(height)),
        x_(quadrant.x),
        y_(quadrant.y) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const ArcPoint<T> arc = arc_point<R>(s);
    const T radius = radius_ + growth_ * t;
    return {x_ * (radius * arc.x), y_ * (radius * arc.y), height_ * t};
  }

private:
  R radius_;
  R growth_;
  R height_;
  R x_;
  R y_;
};

/// The boundary of a truncated cone: two disks and the mantle between them.
/// Maths     sqrt(x^2 + y^2) <= radius + (top - radius) z/height,  0 <= z <= height
/// Source    -
/// Requires  radius, top, height > 0, else ContractViolation
/// Result    pieces floor, ceiling (z = 0, height) and mantle, four charts each
/// Limits    truncated: at an apex the surface has no normal, so that it is no corner of smooth pieces in the sense of
///           [ac98, (13)-(14)], which the quadrature and every statement on orders assume
inline Surface cone(const Rational& radius, const Rational& top, const Rational& height) {
  expects(radius > Rational(0) && top > Rational(0) && height > Rational(0), "radius, top, height > 0",
          named("radius", radius), named("top", top), named("height", height));
  Surface surface;
  surface.name = "cone";
  surface.parameters = {{"radius", radius}, {"top", top}, {"height", height}};
  surface.charts = disk_charts("floor", radius, 0, Facing::up);
  for (Chart& chart : disk_charts("ceiling", top, height, Facing::down))
    surface.charts.push_back(std::move(chart));
  const Rational growth = (top - radius) / height;
  ChartStructure structure{.quadric = Quadric{.squares = {1, 1, 0},
                                              .linear = {{0, 0, 0}, 0},
                                              .nappe = AffineForm{{0, 0, growth}, radius}},
                           .revolution = z_axis()};
  if (top == radius) structure.ruling = Vector<Rational>{0, 0, height};
  for (const Quadrant& quadrant : quadrants())  // right-handed: D_s F x D_t F points outwards
    surface.charts.push_back(make_exact_chart<ConeMantle>(
        {.name = "mantle/" + quadrant.name(),
         .piece = "mantle",
         .orientation = quadrant.is_right_handed() ? Orientation::against_the_cross_product
                                                   : Orientation::along_the_cross_product,
         .structure = structure},
        radius, top, height, quadrant));
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  surface.pieces_meet_at_angle = true;
  return surface;
}

}  // namespace radcert
