// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/line_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace radcert::certificate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// 1 + sqrt(2), rounded up.
constexpr double slid_growth = 2.41422;
constexpr const std::array<double, 16>& axes = ellipse_axes;
using Bounds = EllipseBounds;

double sum_of_axes(double axis) { return axis + std::sqrt(axis * axis - 1); }

/// 2 R^(1-N)/(R-1), by axis and N - 1.
const std::array<PolynomialErrors, axes.size()>& factors() {
  static const std::array<PolynomialErrors, axes.size()> table = [] {
    std::array<PolynomialErrors, axes.size()> made{};
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const double sum = sum_of_axes(axes[k]);
      for (std::size_t n = 0; n < made[k].size(); ++n)
        made[k][n] = 2 * std::pow(sum, -static_cast<double>(n)) / (sum - 1) * upward;
    }
    return made;
  }();
  return table;
}

/// sum sizes[i] R^i where z = m + h w lies in a part of [-1,1], w in the ellipse of that axis: |z-1| <= 1 - m
/// - h + h |w-1|, |z+1| <= 1 + m - h + h |w+1|, so that half their sum is at most 1 + h (axis - 1).
double size_around(const std::vector<double>& sizes, double half, double axis) {
  const double growth = sum_of_axes((1 + half * (axis - 1)) * upward) * upward;
  double sum = 0;
  for (std::size_t i = sizes.size(); i-- > 0;) sum = sum * growth + sizes[i];
  return sum * upward;
}

double low(const BoundedDouble& x) { return x.value() - x.error(); }
double high(const BoundedDouble& x) { return x.value() + x.error(); }
double size(const BoundedDouble& x) { return std::abs(x.value()) + x.error(); }

/// The lines of a box in one parameter.
struct Lines {
  Vector<double> centre;
  double spread = 0;  ///< of the middles of lines from there
  double half = 0;    ///< |e| at most
};

Lines lines_of(const SideTriangle& triangle, const Box& box, bool in_s) {
  const BoxLines lines = box_lines(triangle, box, in_s);
  return {.centre = 0.5 * (lines.from + lines.to),
          .spread = 0.5 * norm(lines.to - lines.from) * upward + slack,
          .half = lines.half};
}

}  // namespace

BoxLines box_lines(const SideTriangle& triangle, const Box& box, bool in_s) {
  const Vector<double> from =
      in_s ? triangle.point(box.middle_s(), box.t0) : triangle.point(box.s0, box.middle_t());
  const Vector<double> to =
      in_s ? triangle.point(box.middle_s(), box.t1) : triangle.point(box.s1, box.middle_t());
  const double longest = in_s ? (1 - box.t0) * triangle.length
                              : std::max(norm(triangle.inward - box.s0 * triangle.along),
                                         norm(triangle.inward - box.s1 * triangle.along)) +
                                    slack;
  const double width = in_s ? box.s1 - box.s0 : box.t1 - box.t0;
  return {.from = from, .to = to, .half = 0.5 * width * longest * upward};
}

PolynomialErrors polynomial_errors(const EllipseBounds& bounds) {
  PolynomialErrors out{};
  for (std::size_t n = 0; n < out.size(); ++n) {
    double least = infinity;
    for (std::size_t k = 0; k < axes.size(); ++k) least = std::min(least, bounds[k] * factors()[k][n]);
    out[n] = least * upward;
  }
  return out;
}

LineBounds::LineBounds(const PolyhedronCertificate& certificate, const Scene& scene,
                       const Densities& densities)
    : certificate_(certificate),
      scene_(scene),
      densities_(densities),
      of_face_(scene.faces()),
      slid_size_(scene.faces()) {
  for (std::size_t e = 0; e < certificate.elements.size(); ++e) {
    const Element& x = certificate.elements[e];
    triangle_.push_back(scene.triangle(x.face, x.side));
    of_face_[x.face].push_back(e);
    const SideTriangle& own = scene.triangles()[triangle_.back()];
    const Box box{.s0 = x.s0, .s1 = x.s1, .t0 = x.t0, .t1 = x.t1};
    quadrilaterals_.emplace_back(own, scene.normal(x.face), box);
    area_.push_back(own.jacobian * (x.s1 - x.s0) * (x.t1 - x.t0) * (1 - box.middle_t()) * upward);
    size_.push_back(densities.size_of_w(e));
    const std::span<const double> w = densities.w(e);
    for (std::size_t k = 0; k < densities.count(); ++k) {
      double sum = 0;
      for (std::size_t i = densities.stride(); i < w.size(); i += densities.stride())
        sum += std::abs(w[i + k]);
      mean_.push_back(w[k]);
      rest_.push_back((sum + densities.coefficient_error(e)) * upward);
    }
    slid_size_[x.face] = std::max(slid_size_[x.face], densities.size(e, slid_growth, slid_growth));
  }
}

double LineBounds::nearest_border(std::size_t triangle, const SourcePart& part,
                                  const Vector<double>& c) const {
  const Box& x = part.box;
  const SideTriangle& other = scene_.triangles()[triangle_[part.element]];
  double nearest = infinity;
  for (const double s : {x.s0, x.s1})
    nearest = std::min(nearest, segment_distance(c, other.point(s, x.t0), other.point(s, x.t1)));
  if (scene_.aligned(triangle, triangle_[part.element])) return nearest;
  for (const double t : {x.t0, x.t1})
    nearest = std::min(nearest, segment_distance(c, other.point(x.s0, t), other.point(x.s1, t)));
  return nearest;
}

double LineBounds::slide_reach(std::size_t triangle, std::size_t face, std::span<const SourcePart> parts,
                               const Vector<double>& c) const {
  double nearest = infinity;
  for (const std::size_t e : of_face_[face]) {
    const Element& x = certificate_.elements[e];
    const SourcePart whole{e, {.s0 = x.s0, .s1 = x.s1, .t0 = x.t0, .t1 = x.t1}};
    nearest = std::min(nearest, nearest_border(triangle, whole, c));
  }
  for (const SourcePart& part : parts) nearest = std::min(nearest, nearest_border(triangle, part, c));
  return nearest - slack;
}

Bounds LineBounds::bounds(std::size_t element, const Box& box, bool in_s, std::size_t face,
                          std::span<const SourcePart> parts, const Bounds& xi) const {
  const std::size_t place = triangle_[element];
  const Lines lines = lines_of(scene_.triangles()[place], box, in_s);
  const Scene::Heights& over = scene_.heights(place, face);
  const auto height = [&](double s, double t) {
    return over.at(BoundedDouble::exactly(s), BoundedDouble::exactly(t));
  };
  const BoundedDouble one = in_s ? height(box.middle_s(), box.t0) : height(box.s0, box.middle_t());
  const BoundedDouble two = in_s ? height(box.middle_s(), box.t1) : height(box.s1, box.middle_t());
  const double lowest = std::min(low(one), low(two)) / upward;
  const double highest = std::max(high(one), high(two)) * upward;
  const double tilt = (in_s ? 0.5 * (box.s1 - box.s0) * (1 - box.t0) * size(over.along)
                            : 0.5 * (box.t1 - box.t0) *
                                  std::max(size(over.inward - BoundedDouble::exactly(box.s0) * over.along),
                                           size(over.inward - BoundedDouble::exactly(box.s1) * over.along))) *
                      upward;
  Bounds summed{};
  Bounds largest{};
  Bounds raised{};
  const auto add = [&](const Quadrilateral& y, double area, double size) {
    const double d = std::max(y.distance(lines.centre) - lines.spread, lowest);
    double mass = 1;
    if (d > 0)
      mass = std::min(1.0, area * std::min(highest, d) * std::numbers::inv_pi / (d * d * d) * upward);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const double a = axes[k] * lines.half;
      const double q = a < 0.99 * d ? d / (d - a) : infinity;
      const double sent = q * q * q * q * (size + xi[k]);
      summed[k] += mass * sent;
      largest[k] = std::max(largest[k], sent);
      const double over_plane = std::max(0.0, highest) + axes[k] * tilt;
      raised[k] += d > 0 ? area * over_plane * std::numbers::inv_pi / (d * d * d) * sent : infinity;
    }
  };
  if (parts.empty())
    for (const std::size_t y : of_face_[face]) add(quadrilaterals_[y], area_[y], size_[y]);
  for (const SourcePart& part : parts) {
    const SideTriangle& own = triangle(part.element);
    const Box& x = part.box;
    add(Quadrilateral(own, scene_.normal(face), x),
        own.jacobian * (x.s1 - x.s0) * (x.t1 - x.t0) * (1 - x.middle_t()) * upward, size_[part.element]);
  }
  const bool slides = in_s && scene_.parallel(place, face);
  const double reach = slides ? slide_reach(place, face, parts, lines.centre) - lines.spread : 0;
  Bounds out{};
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const double turned = tilt == 0 ? 1 : lowest > 0 ? 1 + axes[k] * tilt / lowest : infinity;
    out[k] = turned * std::min(summed[k], largest[k]) * upward;
    if (!(out[k] <= raised[k] * upward)) out[k] = raised[k] * upward;
    if (!(out[k] >= 0)) out[k] = infinity;
    const double a = axes[k] * lines.half;
    if (!slides || !(a < reach)) continue;
    const double b = lines.half * std::sqrt(axes[k] * axes[k] - 1);
    const double squared = b * b / (reach * reach - a * a) * upward;
    if (squared < 0.98)
      out[k] = std::min(out[k], std::sqrt(1 + squared) / ((1 - squared) * (1 - squared)) *
                                    (slid_size_[face] + xi[k]) * upward);
  }
  return out;
}

Bounds LineBounds::on_ellipses(std::size_t element, const Box& box, bool in_s, std::size_t face) const {
  return bounds(element, box, in_s, face, {}, {});
}

PolynomialErrors LineBounds::left(std::size_t element, const Box& box, bool in_s, const EdgeClosing* closing,
                                  const View* view, double constant) const {
  const std::size_t own = triangle(element).face;
  Bounds xi{};
  xi.fill(constant);
  if (closing != nullptr)
    for (std::size_t k = 0; k < axes.size(); ++k)
      xi[k] = size_around(closing->edge_sizes, closing->part, in_s ? axes[k] : 1);
  PolynomialErrors out{};
  const auto add = [&](std::size_t j, std::span<const SourcePart> parts) {
    if (closing != nullptr && closing->face == j) return;
    const PolynomialErrors of_face = polynomial_errors(bounds(element, box, in_s, j, parts, xi));
    for (std::size_t n = 0; n < out.size(); ++n) out[n] += of_face[n];
  };
  if (view != nullptr) {
    for (const View::OfFace& seen : view->faces) add(seen.face, seen.parts);
    return out;
  }
  for (std::size_t j = 0; j < scene_.faces(); ++j)
    if (!scene_.coplanar(own, j)) add(j, {});
  return out;
}

std::optional<std::size_t> LineBounds::element_beyond(std::size_t element, double s0, double s1) const {
  const std::optional<std::size_t> beyond = triangle(element).beyond;
  if (!beyond) return std::nullopt;
  for (const std::size_t y : of_face_[scene_.triangles()[*beyond].face]) {
    const Element& other = certificate_.elements[y];
    if (triangle_[y] == *beyond && other.t0 == 0 && other.s0 <= 1 - s1 && 1 - s0 <= other.s1) return y;
  }
  return std::nullopt;
}

double LineBounds::lipschitz(std::size_t element) const {
  const Element& y = certificate_.elements[element];
  if (!(y.t1 < 1)) return infinity;
  const SideTriangle& own = triangle(element);
  const Densities::Slopes slopes = densities_.slopes(element);
  const double leg = (norm(own.inward) + slack) / own.height;
  const double length = own.length / upward;
  const double along = ((1 + leg) / length + 1 / own.height) / (1 - y.t1);
  return (slopes.in_x * 2 / (y.s1 - y.s0) * along + slopes.in_y * 2 / (y.t1 - y.t0) / own.height) * upward;
}

double LineBounds::oscillation(std::size_t element, std::span<const double> xi) const {
  double most = 0;
  for (std::size_t k = 0; k < densities_.count(); ++k) {
    const std::size_t at = element * densities_.count() + k;
    most = std::max(most, std::abs(mean_[at] - xi[k]) + rest_[at]);
  }
  return most * upward;
}

double LineBounds::sent(std::size_t element, const Box& box, std::size_t face, double lipschitz, double reach,
                        double distance, std::vector<Oscillation> oscillations) const {
  const double rings = 2 * box.t1 * high(scene_.heights(triangle_[element], face).inward) * upward;
  if (!(distance > 4 * reach && rings > 0)) return infinity;
  const double way = distance - reach;
  const double masses = std::min(way, rings * (1 + std::max(0.0, std::log(way / rings)) * upward));
  double sum = lipschitz * (reach + masses);
  std::sort(oscillations.begin(), oscillations.end(),
            [](const Oscillation& a, const Oscillation& b) { return a.distance < b.distance; });
  double largest = 0;
  for (const Oscillation& own : oscillations) {
    if (!(own.size > largest)) continue;
    sum += (own.size - largest) * std::min(1.0, rings / (std::max(own.distance, distance) - reach)) * upward;
    largest = own.size;
  }
  return sum * upward;
}

double LineBounds::beside(std::size_t element, const Box& box, std::size_t beyond, double half) const {
  const SideTriangle& own = triangle(element);
  const SideTriangle& other = triangle(beyond);
  const Element& y = certificate_.elements[beyond];
  if (!(y.t1 < 1)) return infinity;
  const Vector<double> middle = own.point(box.middle_s(), 0);
  double d = infinity;
  for (const double s : {y.s0, y.s1})
    d = std::min(d, segment_distance(middle, other.point(s, 0), other.point(s, y.t1)));
  d = std::min(d, segment_distance(middle, other.point(y.s0, y.t1), other.point(y.s1, y.t1)));
  d -= half + 2 * slack;
  const double reach =
      box.t1 * std::max(norm(own.inward - box.s0 * own.along), norm(own.inward - box.s1 * own.along)) *
          upward +
      slack;
  const double slope = lipschitz(beyond);
  const OnEdge at_middle = on_edge(beyond, 1 - box.middle_s());
  // xi is not that of the middle on all of the box.
  const double moved = slope * (half + slack) + at_middle.error;
  std::vector<Oscillation> oscillations;
  for (const std::size_t z : of_face_[other.face])
    oscillations.push_back({z == beyond ? d : quadrilaterals_[z].distance(middle) - half - 2 * slack,
                            oscillation(z, at_middle.w) + moved});
  return sent(element, box, other.face, slope, reach, d, std::move(oscillations));
}

LineBounds::OnEdge LineBounds::on_edge(std::size_t element, double s) const {
  const Element& y = certificate_.elements[element];
  OnEdge out;
  out.place = (BoundedDouble::exactly(s) - BoundedDouble::exactly(y.s0) +
               (BoundedDouble::exactly(s) - BoundedDouble::exactly(y.s1))) /
              (BoundedDouble::exactly(y.s1) - BoundedDouble::exactly(y.s0));
  const LegendreTable along(densities_.degree(), std::vector<BoundedDouble>{out.place});
  const LegendreTable across(densities_.degree(), std::vector<BoundedDouble>{BoundedDouble(-1)});
  out.error = densities_.error(element, along, across);
  out.w.resize(densities_.stride());
  Densities::values(densities_.w(element), densities_.stride(), along.values.data(), across.values.data(),
                    densities_.powers(), out.w);
  return out;
}

std::optional<double> LineBounds::nearest_end(std::size_t element, const Box& box) const {
  const std::optional<std::size_t> beyond = triangle(element).beyond;
  if (!beyond) return std::nullopt;
  std::optional<double> nearest;
  for (const std::size_t y : of_face_[scene_.triangles()[*beyond].face]) {
    const Element& other = certificate_.elements[y];
    if (triangle_[y] != *beyond || other.t0 != 0) continue;
    // As a parameter of this side: exact, for parameters have 40 bits.
    for (const double s : {1 - other.s0, 1 - other.s1})
      if (s > 0 && s < 1 && (!nearest || std::abs(s - box.middle_s()) < std::abs(*nearest - box.middle_s())))
        nearest = s;
  }
  return nearest;
}

std::optional<EdgeClosing> LineBounds::closing_at_end(std::size_t element, const Box& box) const {
  const std::optional<double> end = box.t0 == 0 ? nearest_end(element, box) : std::nullopt;
  if (!end) return std::nullopt;
  const SideTriangle& own = triangle(element);
  const std::size_t beyond = *own.beyond;
  const std::size_t face = scene_.triangles()[beyond].face;
  const Vector<double> x = own.point(*end, 0);
  const double s = 1 - *end;
  EdgeClosing closing{.face = face, .edge_sizes = {}};
  OnEdge xi;
  double slope = 0;
  double distance = infinity;
  std::vector<std::size_t> at_end;
  for (const std::size_t y : of_face_[face]) {
    const Element& other = certificate_.elements[y];
    if (triangle_[y] != beyond || other.t0 != 0 || !(other.s0 <= s && s <= other.s1)) {
      distance = std::min(distance, quadrilaterals_[y].distance(x) - slack);
      continue;
    }
    slope = std::max(slope, lipschitz(y));
    OnEdge there = on_edge(y, s);
    if (at_end.empty()) {
      closing.element = y;
      closing.at = there.place;
      xi = std::move(there);
    } else {
      for (std::size_t k = 0; k < densities_.count(); ++k)
        closing.jump =
            std::max(closing.jump, (std::abs(there.w[k] - xi.w[k]) + there.error + xi.error) * upward);
    }
    at_end.push_back(y);
  }
  if (at_end.empty()) return std::nullopt;
  double size = 0;
  for (std::size_t k = 0; k < densities_.count(); ++k) size = std::max(size, std::abs(xi.w[k]));
  closing.edge_sizes = {(size + xi.error) * upward};
  std::vector<Oscillation> oscillations;
  for (const std::size_t z : of_face_[face]) {
    const bool is_there = std::find(at_end.begin(), at_end.end(), z) != at_end.end();
    oscillations.push_back(
        {is_there ? distance : quadrilaterals_[z].distance(x) - slack, oscillation(z, xi.w) + xi.error});
  }
  double reach = 0;
  for (const double at : {box.s0, box.s1})
    for (const double t : {box.t0, box.t1}) reach = std::max(reach, norm(own.point(at, t) - x));
  closing.beside = (closing.jump + sent(element, box, face, slope, reach * upward + slack, distance,
                                        std::move(oscillations))) *
                   upward;
  return closing;
}

std::optional<EdgeClosing> LineBounds::closing(std::size_t element, const Box& box) const {
  if (box.t0 != 0) return std::nullopt;
  const std::optional<std::size_t> y = element_beyond(element, box.s0, box.s1);
  if (!y) return std::nullopt;
  const Element& other = certificate_.elements[*y];
  const double half = 0.5 * (box.s1 - box.s0) * triangle(element).length * upward;
  return EdgeClosing{.face = other.face,
                     .element = *y,
                     .edge_sizes = densities_.edge_sizes(*y),
                     .part = (box.s1 - box.s0) / (other.s1 - other.s0) * upward,
                     .beside = beside(element, box, *y, half)};
}

double LineBounds::short_beside(std::size_t element, const Box& box) const {
  const std::optional<std::size_t> y = element_beyond(element, box.middle_s(), box.middle_s());
  return y ? beside(element, box, *y, 0) : infinity;
}

}  // namespace radcert::certificate
