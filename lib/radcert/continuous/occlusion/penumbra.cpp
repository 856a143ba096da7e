// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/occlusion/penumbra.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "radcert/continuous/transport/source_rule.h"

namespace radcert {
namespace {

/// T 1 of a part that is seen, at most: height/D is the cosine at either end, D the distance.
double mass_of(const SeenPart& part, double height, double other_height) {
  const double distance = part.least_distance();
  if (!(distance > 0)) return 1;
  const double cosines = std::min(1.0, height / distance) * std::min(1.0, other_height / distance);
  return std::min(1.0, std::numbers::inv_pi * part.area * cosines / (distance * distance) * upward);
}

/// The largest height of points above the plane of a panel, rounded up.
double height_above(const SectorScene& scene, std::size_t panel, std::span<const Vector<double>> points) {
  const Vector<double>& at = scene.sectors()[scene.first_sector(panel)].a;
  double highest = 0;
  for (const Vector<double>& p : points) highest = std::max(highest, dot(scene.normal(panel), p - at));
  return highest + 4 * displacement * scene.extent();
}

/// A bound of |f'| on [-1,1] for f = sum c_i P_i, from |c_i|.
/// Maths     |P_i'| <= i (i+1)/2
double slope_size(std::span<const double> sizes) {
  double sum = 0;
  for (std::size_t i = 1; i < sizes.size(); ++i)
    sum += 0.5 * static_cast<double>(i * (i + 1)) * std::abs(sizes[i]);
  return sum * upward;
}

}  // namespace

PanelView view_of_panel(const SectorScene& scene, std::size_t panel, std::span<const Vector<double>> hull,
                        std::size_t other) {
  const PanelView view = scene.sight().view(panel, other);
  if (view != PanelView::partly) return view;
  std::vector<Vector<double>> corners;
  for (std::size_t s = scene.first_sector(other); s < scene.first_sector(other + 1); ++s)
    corners.push_back(scene.sectors()[s].a);
  return PanelSight::Lookout(scene.sight(), panel, hull, other).view(corners);
}

Penumbra::Penumbra(const SectorScene& scene, std::span<const SectorElement> elements,
                   const SectorFunctions& w)
    : scene_(scene), elements_(elements), w_(w) {
  for (std::size_t e = 0; e < elements.size(); ++e)
    while (first_element_.size() <= scene.sectors()[elements[e].sector].panel) first_element_.push_back(e);
  while (first_element_.size() <= scene.panels().size()) first_element_.push_back(elements.size());
  if (scene.sight().is_open()) return;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (std::size_t k = 0; k < w.count(); ++k) {
      const PolynomialSizes sizes = polynomial_sizes(w, e, k, k + 1);
      slope_s_.push_back(slope_size(sizes.by_s));
      slope_t_.push_back(slope_size(sizes.by_t));
      size_.push_back(size_in_ellipse(sizes.by_s, 1));
    }
  }
}

SeenPanel Penumbra::seen(std::size_t panel, std::span<const Vector<double>> hull, std::size_t other,
                         double least_mass) const {
  const PanelView view = view_of_panel(scene_, panel, hull, other);
  if (view == PanelView::none) return {};
  std::vector<PartOfElement> parts;
  for (std::size_t e = first_element_[other]; e < first_element_[other + 1]; ++e)
    parts.push_back({e, elements_[e].box});
  if (view == PanelView::whole) return {.whole = std::move(parts), .shaded = {}};
  return look(panel, hull, other, parts, least_mass);
}

SeenPanel Penumbra::look(std::size_t panel, std::span<const Vector<double>> hull, std::size_t other,
                         std::span<const PartOfElement> parts, double least_mass) const {
  SeenPanel out;
  const ObserverBall ball = ball_about(hull, scene_.extent());
  const double height = height_above(scene_, other, hull);
  PanelSight::Lookout lookout(scene_.sight(), panel, hull, other);
  struct Waiting {
    PartOfElement part;
    PanelSight::Lookout::MayHide may_hide;
  };
  std::vector<Waiting> waiting;
  for (const PartOfElement& part : parts) waiting.push_back({part, PanelSight::Lookout::all});
  while (!waiting.empty()) {
    auto [part, may_hide] = waiting.back();
    waiting.pop_back();
    const SectorElement& element = elements_[part.element];
    const std::array<Vector<double>, 4> corners = corners_of(scene_.sectors()[element.sector], part.box);
    const PanelView view = lookout.view(corners, may_hide);
    if (view == PanelView::none) continue;
    if (view == PanelView::whole) {
      out.whole.push_back(part);
      continue;
    }
    const SeenPart seen = seen_part(scene_, element, part.box, ball);
    const double mass = mass_of(seen, height, height_above(scene_, panel, corners));
    if (mass <= least_mass || std::max(seen.half_s, seen.half_t) <= 0.5 * ball.radius) {
      out.shaded.push_back({part, mass});
      continue;
    }
    PartOfElement lower = part;
    PartOfElement upper = part;
    if (seen.half_s >= seen.half_t)
      lower.box.s1 = upper.box.s0 = part.box.middle_s();
    else
      lower.box.t1 = upper.box.t0 = part.box.middle_t();
    waiting.push_back({lower, may_hide});
    waiting.push_back({upper, may_hide});
  }
  return out;
}

std::vector<PartOfElement> Penumbra::may_be_shaded(std::size_t panel) const {
  std::vector<PartOfElement> parts;
  for (std::size_t j = 0; j < scene_.panels().size(); ++j) {
    if (scene_.sight().view(panel, j) != PanelView::partly) continue;
    for (std::size_t e = first_element_[j]; e < first_element_[j + 1]; ++e)
      parts.push_back({e, elements_[e].box});
  }
  return parts;
}

std::vector<ShadedPart> Penumbra::shaded(std::size_t panel, std::span<const Vector<double>> hull,
                                         std::span<const PartOfElement> parts, double least_mass) const {
  std::vector<ShadedPart> out;
  while (!parts.empty()) {
    const std::size_t other = panel_of(parts.front());
    std::size_t count = 0;
    while (count < parts.size() && panel_of(parts[count]) == other) ++count;
    const SeenPanel seen = look(panel, hull, other, parts.first(count), least_mass);
    out.insert(out.end(), seen.shaded.begin(), seen.shaded.end());
    parts = parts.subspan(count);
  }
  return out;
}

void Penumbra::Values::add(const Penumbra& of, std::size_t element, const PartOfInterval& in_s,
                           const PartOfInterval& in_t) {
  const std::size_t count = of.w_.count();
  const auto powers = static_cast<std::size_t>(of.w_.degree() + 1);
  std::vector<double> p_s(powers);
  std::vector<double> p_t(powers);
  legendre_values<double>(in_s.middle, p_s);
  legendre_values<double>(in_t.middle, p_t);
  for (std::size_t k = 0; k < count; ++k) {
    const std::span<const double> c = of.w_.of(element, k);
    double sum = 0;
    for (std::size_t i = 0; i < powers; ++i)
      for (std::size_t j = 0; j < powers; ++j) sum += c[i * powers + j] * p_s[i] * p_t[j];
    middle.push_back(sum);
    const double rounding =
        64 * static_cast<double>(powers * powers) * unit_roundoff<double>() * of.size(element, k);
    const std::size_t own = element * count + k;
    spread.push_back((of.slope_s_[own] * in_s.half + of.slope_t_[own] * in_t.half + rounding) * upward);
  }
}

Penumbra::Values Penumbra::values(std::span<const ShadedPart> shaded) const {
  Values out;
  for (const ShadedPart& own : shaded) {
    const SectorBox& whole = elements_[own.part.element].box;
    out.add(*this, own.part.element, part_in_s(own.part.box, whole), part_in_t(own.part.box, whole));
  }
  return out;
}

Penumbra::Rest Penumbra::rest(std::span<const ShadedPart> shaded) const {
  const std::size_t count = w_.count();
  const Values found = values(shaded);
  std::vector<double> constants(count);
  double all = 0;
  for (std::size_t p = 0; p < shaded.size(); ++p) {
    all += shaded[p].mass;
    for (std::size_t k = 0; k < count; ++k) constants[k] += shaded[p].mass * found.middle[p * count + k];
  }
  if (all > 0)
    for (double& c : constants) c /= all;
  return rest(shaded, found, std::move(constants), std::vector<double>(count));
}

Penumbra::Rest Penumbra::rest_at_edge(std::span<const ShadedPart> shaded, std::size_t element,
                                      const SectorBox& part) const {
  Values edge;
  edge.add(*this, element, part_in_s(part, elements_[element].box), {.middle = -1, .half = 0});
  return rest(shaded, values(shaded), std::move(edge.middle), edge.spread);
}

Penumbra::Rest Penumbra::rest(std::span<const ShadedPart> shaded, const Values& values,
                              std::vector<double> constants, std::span<const double> spread) const {
  const std::size_t count = w_.count();
  Rest out{.constants = std::move(constants), .bounds = std::vector<double>(count)};
  for (std::size_t p = 0; p < shaded.size(); ++p)
    for (std::size_t k = 0; k < count; ++k)
      out.bounds[k] += 0.5 * shaded[p].mass *
                       (std::abs(values.middle[p * count + k] - out.constants[k]) +
                        values.spread[p * count + k] + spread[k]);
  for (double& bound : out.bounds)
    bound *= (1 + static_cast<double>(shaded.size()) * unit_roundoff<double>()) * upward;
  return out;
}

}  // namespace radcert
