// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/edge_closure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/elements/gauss_tables.h"

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

/// A bound of |f'| on [-1,1], f = sum c_j P_j.
/// Maths     P_j' = sum (2k+1) P_k over k = j-1, j-3, ...: |f'| <= sum_k (2k+1) |c_(k+1) + c_(k+3) + ...|
double derivative_size(std::span<const double> c) {
  double sum = 0;
  double size = 0;
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    double coefficient = 0;
    for (std::size_t j = k + 1; j < c.size(); j += 2) {
      coefficient += c[j];
      size += static_cast<double>(2 * k + 1) * std::abs(c[j]);
    }
    sum += static_cast<double>(2 * k + 1) * std::abs(coefficient);
  }
  return sum + 16 * unit_roundoff<double>() * size;
}

/// A Lipschitz constant of the functions on an element.
/// Maths     in each variable by derivative_size;  |grad s| <= q/((1-t) |b-a|), q the longer leg over the
///           height H: 1/q is the least sine of the angle between lines s = const and the side;  |grad t| =
///           1/H;  x = 2 s/width, y = 2 t/depth
double lipschitz(const SectorScene& scene, const SectorElement& element, const SectorFunctions& w,
                 std::size_t number) {
  const auto powers = static_cast<std::size_t>(w.degree() + 1);
  double slope_x = 0;
  double slope_y = 0;
  std::vector<double> line(powers);
  for (std::size_t k = 0; k < w.count(); ++k) {
    const std::span<const double> c = w.of(number, k);
    double of_x = 0;
    double of_y = 0;
    for (std::size_t i = 0; i < powers; ++i) {
      for (std::size_t j = 0; j < powers; ++j) line[j] = c[j * powers + i];
      of_x += derivative_size(line);
      for (std::size_t j = 0; j < powers; ++j) line[j] = c[i * powers + j];
      of_y += derivative_size(line);
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
  return (slope_x * 2 / (box.s1 - box.s0) * (leg / height) / ((1 - box.t1) * length) +
          slope_y * 2 / (box.t1 - box.t0) / height) *
         upward;
}

/// The place of a parameter in an element's box, in [-1,1].
double place(double parameter, double from, double to) {
  return std::clamp((2 * parameter - from - to) / (to - from), -1.0, 1.0);
}

/// Two elements beside one another, and the part of their border that they share.
struct Border {
  const SectorElement& one;
  const SectorElement& other;
  bool along_s = false;  ///< t = const
  double from = 0;
  double to = 0;
};

/// max |f - g| on a border, f and g one of the functions on either side.
/// Maths     a polynomial of the degree of w: sum |c_i| of its Legendre coefficients, by interpolation
double jump(const SectorFunctions& w, const Border& border, std::size_t one, std::size_t other) {
  const ElementInterpolation interpolation(w.degree() + 1, 1);
  const auto powers = static_cast<std::size_t>(w.degree() + 1);
  std::vector<double> p_s(powers);
  std::vector<double> p_t(powers);
  const auto value = [&](std::size_t element, const SectorBox& box, std::size_t k, double s, double t) {
    legendre_values<double>(place(s, box.s0, box.s1), p_s);
    legendre_values<double>(place(t, box.t0, box.t1), p_t);
    const std::span<const double> c = w.of(element, k);
    double sum = 0;
    for (std::size_t i = 0; i < powers; ++i)
      for (std::size_t j = 0; j < powers; ++j) sum += c[i * powers + j] * p_s[i] * p_t[j];
    return sum;
  };
  const SectorBox& a = border.one.box;
  const SectorBox& b = border.other.box;
  double most = 0;
  std::vector<double> differences(powers);
  std::vector<double> coefficients(powers);
  for (std::size_t k = 0; k < w.count(); ++k) {
    const std::vector<double>& nodes = gauss_on_interval(w.degree() + 1).nodes;
    for (std::size_t i = 0; i < powers; ++i) {
      const double at = 0.5 * (border.from + border.to) + 0.5 * (border.to - border.from) * nodes[i];
      differences[i] = border.along_s ? value(one, a, k, at, a.t1) - value(other, b, k, at, b.t0)
                                      : value(one, a, k, a.s1, at) - value(other, b, k, b.s0, at);
    }
    interpolation.coefficients(differences, 1, coefficients);
    const double size = size_in_ellipse(polynomial_sizes(w, one, k, k + 1).by_s, 1) +
                        size_in_ellipse(polynomial_sizes(w, other, k, k + 1).by_s, 1);
    // Values are off by those of P_i and their sums; places by 4 u, with a slope of i^2 at most.
    const double off = 64 * static_cast<double>(powers * powers) * unit_roundoff<double>() * size;
    double sum = interpolation.rounding(size, off);
    for (const double c : coefficients) sum += std::abs(c);
    most = std::max(most, sum);
  }
  return most * upward;
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
        const SectorBox side{.s0 = s0, .s1 = s1, .t0 = t0, .t1 = t1};
        around_[i].push_back(side_of(scene, elements[e].sector, side));
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
  }
  for (std::size_t e = 0; e < elements.size(); ++e) lipschitz_[e] = lipschitz(scene, elements[e], w, e);
  neighbourhoods_.resize(elements.size());
  for (const std::optional<std::size_t>& mirror : mirror_)
    if (mirror) neighbourhoods_[*mirror] = neighbourhood(*mirror, w);
}

EdgeClosure::Neighbourhood EdgeClosure::neighbourhood(std::size_t element, const SectorFunctions& w) const {
  const SectorElement& own = elements_[element];
  const std::size_t panel = scene_.sectors()[own.sector].panel;
  const std::size_t first = scene_.first_sector(panel);
  const std::size_t sectors = scene_.first_sector(panel + 1) - first;
  const auto next = [&](std::size_t sector) { return first + (sector - first + 1) % sectors; };
  const auto meet = [](double a0, double a1, double b0, double b1) { return a0 <= b1 && b0 <= a1; };
  const auto share = [&](const SectorElement& f, const SectorElement& g) {
    const bool in_t = meet(f.box.t0, f.box.t1, g.box.t0, g.box.t1);
    if (f.box.t1 == 1 && g.box.t1 == 1) return true;
    if (f.sector == g.sector) return in_t && meet(f.box.s0, f.box.s1, g.box.s0, g.box.s1);
    return in_t && ((next(f.sector) == g.sector && f.box.s1 == 1 && g.box.s0 == 0) ||
                    (next(g.sector) == f.sector && g.box.s1 == 1 && f.box.s0 == 0));
  };
  Neighbourhood out;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const bool on_panel = scene_.sectors()[elements_[e].sector].panel == panel;
    if (!on_panel || !share(own, elements_[e])) continue;
    out.elements.push_back(e);
    out.lipschitz = std::max(out.lipschitz, lipschitz_[e]);
  }
  for (const std::size_t one : out.elements)
    for (const std::size_t other : out.elements) {
      const SectorElement& f = elements_[one];
      const SectorElement& g = elements_[other];
      const bool above = f.sector == g.sector && f.box.t1 == g.box.t0;
      const bool beside =
          (f.sector == g.sector && f.box.s1 == g.box.s0) ||
          (f.sector != g.sector && next(f.sector) == g.sector && f.box.s1 == 1 && g.box.s0 == 0);
      Border border{.one = f, .other = g, .along_s = above};
      border.from = above ? std::max(f.box.s0, g.box.s0) : std::max(f.box.t0, g.box.t0);
      border.to = above ? std::min(f.box.s1, g.box.s1) : std::min(f.box.t1, g.box.t1);
      if (!(above || beside) || !(border.from < border.to)) continue;
      const SectorBox side =
          above ? SectorBox{.s0 = border.from, .s1 = border.to, .t0 = f.box.t1, .t1 = f.box.t1}
                : SectorBox{.s0 = f.box.s1, .s1 = f.box.s1, .t0 = border.from, .t1 = border.to};
      out.jumps.push_back({side_of(scene_, f.sector, side), jump(w, border, one, other)});
    }
  return out;
}

double EdgeClosure::distance_around(std::size_t sector, const Vector<double>& point) const {
  return least_distance(point, around_[sector]);
}

double EdgeClosure::clearance(std::size_t sector, const Vector<double>& from,
                              const Vector<double>& to) const {
  const double slack = 4 * displacement * scene_.extent();
  return distance_around(sector, 0.5 * (from + to)) / upward - 0.5 * norm(to - from) * upward - slack;
}

EdgeClosure::Nearby EdgeClosure::nearby(std::size_t element, const SectorBox& box, double to_others,
                                        double slope, std::span<const Jump> jumps) const {
  const std::size_t own = elements_[element].sector;
  const Sector& sector = scene_.sectors()[own];
  const std::size_t other = scene_.sectors()[*scene_.opposite(own)].panel;
  const double slack = 4 * displacement * scene_.extent();
  const Vector<double> from = sector.point(box.s0, 0);
  const Vector<double> to = sector.point(box.s1, 0);
  const double around = 0.5 * norm(to - from) * upward + slack;
  const double d = to_others / upward - around;
  Nearby nearby{.bound = infinity, .jumps = 0, .distance = to_others};
  const double reach = box.t1 * std::max(norm(sector.c - from), norm(sector.c - to)) * upward + slack;
  const Vector<double>& n = scene_.normal(other);
  const double height = box.t1 * std::max(dot(n, sector.c - from), dot(n, sector.c - to)) * upward + slack;
  if (!(d > 4 * reach)) return nearby;
  const double rings = (scene_.before(sector.panel, other) ? 2 : 1) * height;
  const double logarithm = std::max(0.0, std::log((d - reach) / rings)) * upward;
  double of_jumps = 0;
  for (const Jump& jump : jumps) {
    const double to_border = distance(0.5 * (from + to), jump.border.from, jump.border.to) / upward - around;
    const double beyond = to_border - reach;
    of_jumps += jump.size * (beyond > rings ? rings / beyond * upward : 1);
    if (!(to_border > 0)) nearby.jumps += jump.size;
  }
  nearby.bound =
      (of_jumps + slope * (reach + rings * (1 + logarithm)) + rings / (d - reach) * 2 * beyond_[own]) *
      upward;
  return nearby;
}

EdgeClosure::Nearby EdgeClosure::nearby(std::size_t element, const SectorBox& box) const {
  const std::size_t own = elements_[element].sector;
  const Sector& sector = scene_.sectors()[own];
  const Vector<double> middle = 0.5 * (sector.point(box.s0, 0) + sector.point(box.s1, 0));
  return nearby(element, box, distance_around(own, middle), lipschitz_[*mirror_[element]], {});
}

EdgeClosure::Nearby EdgeClosure::nearby_across_borders(std::size_t element, const SectorBox& box) const {
  const std::size_t own = elements_[element].sector;
  const Sector& sector = scene_.sectors()[own];
  const Vector<double> middle = 0.5 * (sector.point(box.s0, 0) + sector.point(box.s1, 0));
  const Neighbourhood& around = neighbourhoods_[*mirror_[element]];
  const std::size_t panel = scene_.sectors()[elements_[*mirror_[element]].sector].panel;
  double nearest = infinity;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Sector& other = scene_.sectors()[elements_[e].sector];
    if (other.panel != panel ||
        std::find(around.elements.begin(), around.elements.end(), e) != around.elements.end())
      continue;
    const SectorBox& b = elements_[e].box;
    const std::array<Vector<double>, 4> corners{other.point(b.s0, b.t0), other.point(b.s1, b.t0),
                                                other.point(b.s1, b.t1), other.point(b.s0, b.t1)};
    for (std::size_t k = 0; k < corners.size(); ++k)
      nearest = std::min(nearest, distance(middle, corners[k], corners[(k + 1) % corners.size()]));
  }
  return nearby(element, box, nearest, around.lipschitz, around.jumps);
}

}  // namespace radcert
