// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/edge_closure.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// max over the functions of |sum_j c_ij P_j(-1)|, by i.
std::vector<double> sizes_on_edge(const SectorFunctions& w, std::size_t element) {
  const auto powers = static_cast<std::size_t>(w.degree() + 1);
  std::vector<double> sizes(powers);
  for (std::size_t k = 0; k < w.count(); ++k) {
    const std::span<const double> c = w.of(element, k);
    for (std::size_t i = 0; i < powers; ++i) {
      double at_edge = 0;
      double size = 0;
      for (std::size_t j = 0; j < powers; ++j) {
        at_edge += j % 2 == 0 ? c[i * powers + j] : -c[i * powers + j];
        size += std::abs(c[i * powers + j]);
      }
      sizes[i] = std::max(sizes[i], std::abs(at_edge) + 64 * unit_roundoff<double>() * size);
    }
  }
  return sizes;
}

/// A Lipschitz constant of the functions on an element at an edge.
/// Maths     |P_i'| <= i(i+1)/2;  |grad s| <= (1+q)/((1-t) |b-a|), q the longer leg over the height H, and |grad
///           t| = 1/H;  x = 2 s/width, y = 2 t/depth
double lipschitz(const SectorScene& scene, const SectorElement& element, const SectorFunctions& w,
                 std::size_t number) {
  const auto powers = static_cast<std::size_t>(w.degree() + 1);
  double slope_x = 0;
  double slope_y = 0;
  for (std::size_t k = 0; k < w.count(); ++k) {
    const std::span<const double> c = w.of(number, k);
    double of_x = 0;
    double of_y = 0;
    for (std::size_t i = 0; i < powers; ++i)
      for (std::size_t j = 0; j < powers; ++j) {
        const double value = std::abs(c[i * powers + j]);
        of_x += value * static_cast<double>(i * (i + 1)) / 2;
        of_y += value * static_cast<double>(j * (j + 1)) / 2;
      }
    slope_x = std::max(slope_x, of_x);
    slope_y = std::max(slope_y, of_y);
  }
  const Sector& sector = scene.sectors()[element.sector];
  const SectorBox& box = element.box;
  const double slack = 4 * displacement * scene.extent();
  const double length = norm(sector.b - sector.a) / upward - slack;
  const double height = sector.jacobian / (norm(sector.b - sector.a) + slack) / upward;
  const double leg = std::max(norm(sector.c - sector.a), norm(sector.c - sector.b)) * upward + slack;
  if (!(box.t1 < 1 && length > 0)) return infinity;
  return (slope_x * 2 / (box.s1 - box.s0) * (1 + leg / height) / ((1 - box.t1) * length) +
          slope_y * 2 / box.t1 / height) *
         upward;
}

}  // namespace

EdgeClosure::EdgeClosure(const SectorScene& scene, std::span<const SectorElement> elements,
                         const SectorFunctions& w)
    : scene_(scene),
      elements_(elements),
      around_(scene.sectors().size()),
      beyond_(scene.sectors().size()),
      mirror_(elements.size()),
      edge_sizes_(elements.size()),
      lipschitz_(elements.size(), infinity) {
  for (std::size_t i = 0; i < scene.sectors().size(); ++i) {
    if (!scene.opposite(i)) continue;
    const std::size_t opposite = *scene.opposite(i);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const Sector& sector = scene.sectors()[elements[e].sector];
      if (sector.panel != scene.sectors()[opposite].panel) continue;
      beyond_[i] = std::max(beyond_[i], size_around(w, e, 1, 1));
      const SectorBox& box = elements[e].box;
      const auto add = [&](double s0, double t0, double s1, double t1) {
        around_[i].push_back({sector.point(s0, t0), sector.point(s1, t1)});
      };
      add(box.s0, box.t0, box.s0, box.t1);
      add(box.s1, box.t0, box.s1, box.t1);
      add(box.s0, box.t1, box.s1, box.t1);
      const bool at_edge = elements[e].sector == opposite && box.t0 == 0;
      if (!at_edge) add(box.s0, box.t0, box.s1, box.t0);
    }
  }
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const SectorBox& box = elements[e].box;
    const std::optional<std::size_t> opposite = scene.opposite(elements[e].sector);
    if (box.t0 != 0 || !opposite) continue;
    for (std::size_t other = 0; other < elements.size(); ++other) {
      const SectorElement& mirror = elements[other];
      if (mirror.sector == *opposite && mirror.box.t0 == 0 && mirror.box.s0 == 1 - box.s1 &&
          mirror.box.s1 == 1 - box.s0)
        mirror_[e] = other;
    }
    edge_sizes_[e] = sizes_on_edge(w, e);
    lipschitz_[e] = lipschitz(scene, elements[e], w, e);
  }
}

double EdgeClosure::distance_around(std::size_t sector, const Vector<double>& point) const {
  double nearest = infinity;
  for (const Side& side : around_[sector]) nearest = std::min(nearest, distance(point, side.from, side.to));
  return nearest;
}

double EdgeClosure::clearance(std::size_t sector, const Vector<double>& from,
                              const Vector<double>& to) const {
  const double slack = 4 * displacement * scene_.extent();
  return distance_around(sector, 0.5 * (from + to)) / upward - 0.5 * norm(to - from) * upward - slack;
}

EdgeClosure::Nearby EdgeClosure::nearby(std::size_t element, const SectorBox& box) const {
  const std::size_t own = elements_[element].sector;
  const Sector& sector = scene_.sectors()[own];
  const std::size_t other = scene_.sectors()[*scene_.opposite(own)].panel;
  const double slack = 4 * displacement * scene_.extent();
  const Vector<double> from = sector.point(box.s0, 0);
  const Vector<double> to = sector.point(box.s1, 0);
  const double d = clearance(own, from, to);
  Nearby nearby{.bound = infinity, .distance = distance_around(own, 0.5 * (from + to))};
  const double reach = box.t1 * std::max(norm(sector.c - from), norm(sector.c - to)) * upward + slack;
  const Vector<double>& n = scene_.normal(other);
  const double height = box.t1 * std::max(dot(n, sector.c - from), dot(n, sector.c - to)) * upward + slack;
  if (!(d > 4 * reach)) return nearby;
  const double rings = scene_.before(sector.panel, other) ? 2 : 1;
  const double slope = lipschitz_[*mirror_[element]];
  double bound = 3 * slope * reach;
  double from_here = 2 * reach;
  for (; 2 * from_here + reach <= d; from_here *= 2)
    bound += std::min(1.0, rings * height / from_here) * slope * (2 * from_here + reach);
  bound += std::min(1.0, rings * height / from_here) * 2 * beyond_[own];
  nearby.bound = bound * upward;
  return nearby;
}

}  // namespace radcert
