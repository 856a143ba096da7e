// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/ellipsoid.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/surface/catalogue_parameters.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {
namespace {

// The eight charts; `piece` names the one smooth piece they form.
std::vector<Chart> ellipsoid_charts(const Rational& a, const Rational& b, const Rational& c,
                                    const std::string& piece) {
  const ChartStructure structure{
      .quadric = Quadric{.squares = {1 / (a * a), 1 / (b * b), 1 / (c * c)}, .linear = {{0, 0, 0}, -1}},
      .revolution = a == b ? std::optional(z_axis()) : std::nullopt};
  std::vector<Chart> charts;
  for (const int z : {1, -1})
    for (const int y : {1, -1})
      for (const int x : {1, -1}) {
        const bool right_handed = x * y * z > 0;  // then D_s F x D_t F points outwards
        std::string name = "octant_";
        for (const int sign : {x, y, z}) name += sign > 0 ? 'p' : 'm';
        charts.push_back(make_exact_chart<EllipsoidOctant>(
            {.name = std::move(name),
             .piece = piece,
             .domain = ChartDomain::unit_triangle,
             .orientation =
                 right_handed ? Orientation::against_the_cross_product : Orientation::along_the_cross_product,
             .structure = structure},
            a, b, c, Octant{x, y, z}));
      }
  return charts;
}

}  // namespace

Surface ellipsoid(const Rational& a, const Rational& b, const Rational& c) {
  expects(a > Rational(0) && b > Rational(0) && c > Rational(0), "a, b, c > 0", named("a", a), named("b", b),
          named("c", c));
  Surface surface;
  surface.name = "ellipsoid";
  surface.parameters = {{"a", a}, {"b", b}, {"c", c}};
  surface.charts = ellipsoid_charts(a, b, c, "ellipsoid");
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  return surface;
}

std::optional<Vector<Ball>> octant_axes(const Chart& chart) {
  if (!chart.is_known_in_balls()) return std::nullopt;
  const ChartIn<Ball>& formula = chart.in<Ball>();
  using Octants = BallsWithImage<EllipsoidOctant, Rational, Rational, Rational, Octant>;
  if (dynamic_cast<const Octants*>(&formula) == nullptr) return std::nullopt;
  return Vector<Ball>{formula.frame({0, 0}).point.x, formula.frame({1, 0}).point.y,
                      formula.frame({0, 1}).point.z};
}

Surface sphere() {
  Surface surface;
  surface.name = "sphere";
  surface.charts = ellipsoid_charts(1, 1, 1, "sphere");
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  return surface;
}

SurfaceDescription ellipsoid_entry() {
  return {.name = "ellipsoid",
          .summary = "the ellipsoid with half axes a, b, c, eight charts [ac98, section 3]",
          .parameters = {positive_length("a", "1", "the half axis along x"),
                         positive_length("b", "2", "the half axis along y"),
                         positive_length("c", "5", "the half axis along z")},
          .pieces = {"ellipsoid"},
          .build = [](std::span<const Rational> v) { return ellipsoid(v[0], v[1], v[2]); }};
}

}  // namespace radcert
