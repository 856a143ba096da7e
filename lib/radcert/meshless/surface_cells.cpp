// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/surface_cells.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {
namespace {

Vector<double> image(const Surface& surface, std::size_t chart, const ParameterPoint<double>& at) {
  return surface.charts[chart].in<double>().frame(at).point;
}

double squared(const Vector<double>& v) { return dot(v, v); }

// The side of this number joins corners k and k + 1.
std::size_t longest_side(const SurfaceCell& cell) {
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double here = squared(cell.images[(k + 1) % 3] - cell.images[k]);
    if (here > length) {
      length = here;
      longest = k;
    }
  }
  return longest;
}

}  // namespace

ParameterPoint<double> SurfaceCell::at(const Surface& surface, double a, double b) const {
  ParameterPoint<double> p = corners[0] + a * (corners[1] - corners[0]) + b * (corners[2] - corners[0]);
  p = {std::clamp(p.s, 0.0, 1.0), std::clamp(p.t, 0.0, 1.0)};
  if (surface.charts[chart].facts().domain == ChartDomain::unit_triangle) p.t = std::min(p.t, 1 - p.s);
  return p;
}

double SurfaceCell::parameter_area() const {
  return std::abs(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
}

double SurfaceCell::longest_chord() const {
  const std::size_t k = longest_side(*this);
  return norm(images[(k + 1) % 3] - images[k]);
}

double SurfaceCell::deviation(const Surface& surface) const {
  if (surface.charts[chart].facts().plane) return 0;
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Vector<double> middle = image(surface, chart, 0.5 * (corners[k] + corners[next]));
    largest = std::max(largest, norm(middle - 0.5 * (images[k] + images[next])));
  }
  return largest;
}

std::pair<SurfaceCell, SurfaceCell> SurfaceCell::halves(const Surface& surface) const {
  const std::size_t k = longest_side(*this);
  const std::size_t next = (k + 1) % 3;
  const ParameterPoint<double> middle = 0.5 * (corners[k] + corners[next]);
  const Vector<double> there = image(surface, chart, middle);
  SurfaceCell first = *this;
  SurfaceCell second = *this;
  first.corners[next] = middle;
  first.images[next] = there;
  second.corners[k] = middle;
  second.images[k] = there;
  return {first, second};
}

std::optional<std::vector<SurfaceCell>> cells_below(const Surface& surface, double h, std::size_t most) {
  expects(h > 0, "h > 0", named("h", h));
  struct Pending {
    SurfaceCell cell;
    int divisions;  ///< still due whatever the chords
  };
  // Four halvings make quarters of the coarse sides: no chord of the catalogue's charts then spans more than
  // a small arc.
  constexpr int first_divisions = 4;
  std::vector<SurfaceCell> cells;
  for (const ParameterTriangle& triangle : triangulate(surface, 0).triangles) {
    SurfaceCell whole{.chart = triangle.chart, .corners = triangle.vertices, .images = {}};
    for (std::size_t k = 0; k < 3; ++k) whole.images[k] = image(surface, whole.chart, whole.corners[k]);
    const bool plane = surface.charts[whole.chart].facts().plane.has_value();
    std::vector<Pending> pending{{whole, plane ? 0 : first_divisions}};
    while (!pending.empty()) {
      const Pending next = pending.back();
      pending.pop_back();
      if (next.divisions <= 0 && next.cell.longest_chord() < h) {
        cells.push_back(next.cell);
        if (cells.size() > most) return std::nullopt;
        continue;
      }
      if (cells.size() + pending.size() > most) return std::nullopt;
      const auto [first, second] = next.cell.halves(surface);
      pending.push_back({second, next.divisions - 1});
      pending.push_back({first, next.divisions - 1});
    }
  }
  return cells;
}

}  // namespace radcert
