// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/scenes/sphere_over_disk.h"

#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue/disk.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/exact_chart.h"

namespace radcert::verification::psg10 {
namespace {

/// One eighth of a sphere at a height.
template <Field R>
class RaisedOctant {
public:
  RaisedOctant(const Rational& radius, const Rational& height, const Rational& x, const Rational& y,
               const Rational& z)
      : octant_(radius, radius, radius, Octant{.x = x.sign(), .y = y.sign(), .z = z.sign()}),
        height_(from_rational<R>(height)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const Vector<T> p = octant_(s, t);
    return {p.x, p.y, height_ + p.z};
  }

private:
  EllipsoidOctant<R> octant_;
  R height_;
};

}  // namespace

Surface sphere_over_disk_surface(const Rational& radius, const Rational& disk_radius,
                                 const Rational& height) {
  expects(radius > Rational(0) && radius < height && radius < disk_radius,
          "0 < radius < height, radius < disk_radius", named("radius", radius), named("height", height),
          named("disk_radius", disk_radius));
  Surface surface;
  surface.name = "sphere_over_disk";
  surface.parameters = {{"radius", radius}, {"disk_radius", disk_radius}, {"height", height}};
  for (const int z : {1, -1})
    for (const int y : {1, -1})
      for (const int x : {1, -1}) {
        std::string name = "sphere/";
        for (const int sign : {x, y, z}) name += sign > 0 ? 'p' : 'm';
        // D_s F x D_t F points out of the ball where x y z > 0, and light is outside.
        ChartFacts facts{.name = std::move(name),
                         .piece = "sphere",
                         .domain = ChartDomain::unit_triangle,
                         .orientation = x * y * z > 0 ? Orientation::along_the_cross_product
                                                      : Orientation::against_the_cross_product};
        facts.structure.revolution = z_axis();
        surface.charts.push_back(make_exact_chart<RaisedOctant>(std::move(facts), radius, height, Rational(x),
                                                                Rational(y), Rational(z)));
      }
  for (Chart& chart : disk_charts("disk", disk_radius, 0, Facing::up))
    surface.charts.push_back(std::move(chart));
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.unoccluded = false;
  return surface;
}

Outcome<LightScene> sphere_over_disk_light_scene(double albedo, const Rational& radius,
                                                 const Rational& disk_radius, const Rational& height) {
  Surface surface = sphere_over_disk_surface(radius, disk_radius, height);
  return LightScene::make(
      std::move(surface), {albedo},
      {{.shape = BallBlocker{.centre = {0, 0, height.to_double()}, .radius = radius.to_double()},
        .piece = "sphere"},
       {.shape = DiskBlocker{.centre = {0, 0, 0}, .normal = {0, 0, 1}, .radius = disk_radius.to_double()},
        .piece = "disk"}});
}

}  // namespace radcert::verification::psg10
