// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/goals.h"
#include "radcert/continuous/transport/shaded_values.h"
#include "radcert/continuous/transport/source_rule.h"
#include "radcert/continuous/transport/transport.h"
#include "radcert/core/work_limit.h"

namespace radcert {

const WorkLimit most_dual_elements("continuous/point_values: elements for the kernels of points", 20000, 1,
                                   "a wider enclosure, with its reason");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A point, as the kernel needs it.
struct Observer {
  std::size_t panel = 0;
  Vector<double> at;
  std::vector<Approximation> emissions;
  double reflectivity = 0;
  int exponent = 0;  ///< j is taken 2^-exponent times
};

/// What polynomials miss of a kernel on an element, that part of it to which lines in either parameter bring
/// it; infinite if unknown.
struct KernelErrors {
  double in_s = 0;
  double in_t = 0;
};

double least_error(double distance, double half, double height, int nodes) {
  double best = infinity;
  for (const double share : {0.3, 0.5, 0.7, 0.8}) {
    const double reach = share * distance;
    const double axis = reach / half;
    if (!(axis > 1.02)) continue;
    const double rho = axis + std::sqrt(axis * axis - 1);
    const double bound = std::numbers::inv_pi * kernel_in_ellipse(distance, reach, height);
    best = std::min(best, 2 * bound * std::pow(rho, 1 - nodes) / (rho - 1) * upward);
  }
  return best;
}

class PointValues final : public Goals {
public:
  PointValues(const SectorScene& scene, Reflectivity reflectivity, const std::vector<ValueGoal>& points)
      : scene_(scene), reflectivity_(std::move(reflectivity)) {
    for (const ValueGoal& goal : points) {
      Observer observer{.panel = goal.point.panel,
                        .at = scene.place(goal.point.at),
                        .emissions = goal.emissions,
                        .reflectivity = goal.reflectivity};
      double largest = 0;
      for (const Sector& sector : scene.sectors()) {
        const double d = std::max(distance(observer.at, sector.a, sector.b),
                                  std::abs(dot(scene.normal(sector.panel), observer.at - sector.a)));
        if (facing(observer.panel, sector.panel) && d > 0) largest = std::max(largest, 1 / (d * d));
      }
      if (largest > 0 && std::isfinite(largest)) std::frexp(largest, &observer.exponent);
      observers_.push_back(observer);
    }
  }

  [[nodiscard]] std::size_t count() const override { return observers_.size(); }
  [[nodiscard]] bool depend_on_u() const override {
    return std::any_of(observers_.begin(), observers_.end(),
                       [](const Observer& observer) { return observer.reflectivity > 0; });
  }
  [[nodiscard]] double radius(double wanted) const override {
    double least = infinity;
    for (const Observer& observer : observers_)
      least = std::min(least, std::ldexp(wanted / observer.reflectivity, -observer.exponent));
    return least;
  }

  [[nodiscard]] int exponent(std::size_t k) const override { return observers_[k].exponent; }
  [[nodiscard]] int least_degree() const override { return 5; }
  [[nodiscard]] std::vector<SectorElement> refined(std::vector<SectorElement> elements, int degree,
                                                   double allowed) const override {
    std::vector<SectorElement> out;
    const double share = allowed / std::sqrt(static_cast<double>(2 * elements.size()));
    for (const SectorElement& element : elements)
      if (element.box.t0 == 0)
        refine_at_edge(element, degree, share, out);
      else
        refine(element, degree, share, out);
    return out;
  }

  DualErrors put_duals(std::span<const SectorElement> elements, SectorFunctions& emissions) const override {
    const ElementReflectivity rho(reflectivity_, scene_, elements);
    const int degree = emissions.degree() - rho.degree();
    const std::size_t first = emissions.count() - count();
    const ElementInterpolation interpolation(degree + 1);
    DualErrors out{.left = std::vector<double>(count()),
                   .polynomials = SectorFunctions(elements.size(), count(), degree),
                   .left_on_elements = std::vector<double>(elements.size() * count())};
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (std::size_t k = 0; k < count(); ++k) {
        if (reflects(elements[e], observers_[k]) == PanelView::none) continue;
        const std::span<double> dual = out.polynomials->of(e, k);
        const double own = put(interpolation, elements[e], observers_[k], degree, dual);
        out.left[k] += own * own;
        out.left_on_elements[e * count() + k] = own;
        rho.add_product(e, dual, emissions.of(e, first + k));
        out.rounding = std::max(out.rounding, rho.rounding(e, {}, dual));
      }
    const double terms = static_cast<double>(elements.size()) * unit_roundoff<double>();
    for (double& sum : out.left) sum = std::sqrt(sum) * (1 + terms) * upward;
    return out;
  }

  [[nodiscard]] std::vector<Approximation> of_density(const Trial& trial, double allowed,
                                                      std::size_t emission) const override {
    const bool is_open = trial.scene.sight().is_open();
    const SectorFunctions functions = is_open ? trial.w : with_one(trial.w, trial.elements.size());
    const Transport transport(trial.scene, trial.elements, functions);
    std::vector<Approximation> out;
    for (const Observer& observer : observers_) {
      const auto [value, radius] = is_open ? sent(transport, observer, emission)
                                           : sent_past_panels(transport, trial, observer, emission,
                                                              std::ldexp(allowed, observer.exponent));
      out.push_back(Approximation::proved(std::ldexp(value, -observer.exponent),
                                          std::ldexp(radius + trial.rounding, -observer.exponent) * upward));
    }
    return out;
  }

  [[nodiscard]] Approximation number(std::size_t k, const Approximation& functional,
                                     std::size_t emission) const override {
    const Observer& observer = observers_[k];
    const double rho = observer.reflectivity;
    if (rho == 0) return observer.emissions[emission];
    const double value = std::ldexp(rho * functional.value, observer.exponent);
    const Approximation reflected{.value = value,
                                  .radius = std::ldexp(rho * functional.radius, observer.exponent) * upward +
                                            4 * unit_roundoff<double>() * std::abs(value),
                                  .guaranteed = functional.guaranteed};
    return observer.emissions[emission] + reflected;
  }

private:
  static constexpr double tolerance = 1e-14;

  /// A value of T w and its radius.
  static std::pair<double, double> sent(const Transport& transport, const Observer& observer,
                                        std::size_t function) {
    const Transport::Values found = transport({.panel = observer.panel, .points = {observer.at}}, tolerance);
    return {found.values[function], found.radius};
  }

  /// The same where parts hide each other, by functions with 1: what is seen in part is cut until little is
  /// left of it.
  static std::pair<double, double> sent_past_panels(const Transport& transport, const Trial& trial,
                                                    const Observer& observer, std::size_t function,
                                                    double allowed) {
    constexpr double most_mass = 0x1p-20;
    constexpr double least_mass = 0x1p-36;  // some hundred thousand parts along a shadow's border
    const double size = trial.smoothness.size();
    for (double mass = most_mass;; mass /= 16) {
      const Transport::Values found = transport(
          {.panel = observer.panel, .points = {observer.at}, .hull = {observer.at}, .least_mass = mass},
          std::clamp(1e-4 * allowed / size, tolerance, 1e-6));
      const ShadedValues values = half_shaded(trial.penumbra, found, size);
      const double shade = values.shade[function];
      if (shade <= allowed || mass <= least_mass)
        return {values.values.values[function], (values.values.radius + shade) * upward};
    }
  }

  [[nodiscard]] bool facing(std::size_t panel, std::size_t other) const {
    return panel != other && !scene_.coplanar(panel, other);
  }

  /// How much a point sees of an element.
  [[nodiscard]] PanelView view(const SectorElement& element, const Observer& observer) const {
    const Sector& sector = scene_.sectors()[element.sector];
    if (!facing(observer.panel, sector.panel)) return PanelView::none;
    const PanelView of_panels = scene_.sight().view(observer.panel, sector.panel);
    if (of_panels != PanelView::partly) return of_panels;
    const std::array<Vector<double>, 4> corners = corners_of(sector, element.box);
    return PanelSight::Lookout(scene_.sight(), observer.panel, {&observer.at, 1}, sector.panel).view(corners);
  }

  /// How much of what an element reflects goes to a point.
  [[nodiscard]] PanelView reflects(const SectorElement& element, const Observer& observer) const {
    const std::size_t panel = scene_.sectors()[element.sector].panel;
    return reflectivity_.largest(panel) > 0 ? view(element, observer) : PanelView::none;
  }

  /// Of (Int rho (j - j_h)^2)^(1/2) of any point, on an element.
  [[nodiscard]] KernelErrors errors(const SectorElement& element, int degree) const {
    KernelErrors worst;
    for (const Observer& observer : observers_) {
      const KernelErrors own = errors(element, observer, degree);
      worst.in_s = std::max(worst.in_s, own.in_s);
      worst.in_t = std::max(worst.in_t, own.in_t);
    }
    return worst;
  }

  /// Maths     where X is seen in part half of what interpolation misses and of sup |j|, |X|^(1/2) <= (4 h_s
  ///           h_t)^(1/2) <= h_s + h_t, h half lengths of X
  [[nodiscard]] KernelErrors errors(const SectorElement& element, const Observer& observer,
                                    int degree) const {
    const PanelView view = reflects(element, observer);
    if (view == PanelView::none) return {};
    const SeenPart part = seen(element, observer);
    KernelErrors out = missed_by_interpolation(element, observer, part, degree);
    if (view == PanelView::whole) return out;
    const double largest = largest_kernel(element, observer, part);
    out.in_s = 0.5 * (out.in_s + largest * part.half_s) * upward;
    out.in_t = 0.5 * (out.in_t + largest * part.half_t) * upward;
    return out;
  }
  /// Maths     rho^(1/2) |X|^(1/2) times twice what interpolation misses of G/pi
  [[nodiscard]] KernelErrors missed_by_interpolation(const SectorElement& element, const Observer& observer,
                                                     const SeenPart& part, int degree) const {
    const std::size_t panel = scene_.sectors()[element.sector].panel;
    const double scale =
        std::ldexp(2 * std::sqrt(part.area * reflectivity_.largest(panel)), -observer.exponent) * upward;
    const double height = height_over(panel, observer);
    return {.in_s = scale * least_error(part.to_s, part.half_s, height, degree + 1),
            .in_t = scale * least_error(part.to_t, part.half_t, height, degree + 1)};
  }
  /// sup rho^(1/2) G/pi on an element.
  [[nodiscard]] double largest_kernel(const SectorElement& element, const Observer& observer,
                                      const SeenPart& part) const {
    const std::size_t panel = scene_.sectors()[element.sector].panel;
    const double distance = part.least_distance();
    if (!(distance > 0)) return infinity;
    const double largest =
        std::numbers::inv_pi * kernel_in_ellipse(distance, 0, height_over(panel, observer)) * upward;
    return std::ldexp(std::sqrt(reflectivity_.largest(panel)) * largest, -observer.exponent) * upward;
  }

  [[nodiscard]] SeenPart seen(const SectorElement& element, const Observer& observer) const {
    return seen_part(scene_, element, element.box,
                     {.centre = observer.at, .radius = displacement * scene_.extent()});
  }

  [[nodiscard]] double height_over(std::size_t panel, const Observer& observer) const {
    const Sector& sector = scene_.sectors()[scene_.first_sector(panel)];
    return dot(scene_.normal(panel), observer.at - sector.a) + 64 * unit_roundoff<double>() * scene_.extent();
  }

  /// The interpolant of j on an element, and (Int rho (j - j_h)^2)^(1/2) there.
  double put(const ElementInterpolation& interpolation, const SectorElement& element,
             const Observer& observer, int degree, std::span<double> coefficients) const {
    const Sector& sector = scene_.sectors()[element.sector];
    const double height = dot(scene_.normal(sector.panel), observer.at - sector.a);
    const double seen_share = reflects(element, observer) == PanelView::whole ? 1 : 0.5;
    const double scale = std::ldexp(seen_share * std::numbers::inv_pi, -observer.exponent);
    std::vector<double> values;
    double largest = 0;
    for (const Vector<double>& q : interpolation.points(sector, element.box)) {
      const Vector<double> way = q - observer.at;
      const double squared = dot(way, way);
      values.push_back(scale * dot(scene_.normal(observer.panel), way) * height / (squared * squared));
      largest = std::max(largest, std::abs(values.back()));
    }
    interpolation.coefficients(values, 1, coefficients);
    const SeenPart part = seen(element, observer);
    const double least = part.least_distance();
    if (!(least > least_kernel_distance * scene_.extent())) return infinity;
    const double off = scale * kernel_rounding * scene_.extent() / (least * least * least);
    const KernelErrors missed = missed_by_interpolation(element, observer, part, degree);
    const double of_view =
        seen_share < 1 ? 0.5 * std::sqrt(part.area) * largest_kernel(element, observer, part) : 0;
    const double rho = reflectivity_.largest(sector.panel);
    return (seen_share * (missed.in_s + missed.in_t) + of_view +
            std::sqrt(part.area * rho) * interpolation.rounding(largest, off)) *
           upward;
  }

  /// Whether an element is cut no more: there are too many, or it is as small as the roundings of points.
  [[nodiscard]] static bool is_last(const SectorElement& element, const std::vector<SectorElement>& so_far) {
    constexpr double smallest = 0x1p-40;
    const SectorBox& box = element.box;
    return box.s1 - box.s0 < smallest || box.t1 - box.t0 < smallest ||
           so_far.size() >= most_dual_elements.count();
  }

  /// Cuts an element where the kernels ask for it.
  void refine(const SectorElement& element, int degree, double share, std::vector<SectorElement>& out) const {
    const KernelErrors here = errors(element, degree);
    if (here.in_s + here.in_t <= share || is_last(element, out))
      out.push_back(element);
    else if (here.in_s >= here.in_t)
      for (const SectorElement& half : halves_in_s(element)) refine(half, degree, share, out);
    else
      for (const SectorElement& half : halves_in_t(element)) refine(half, degree, share, out);
  }

  /// The same at an edge: both sides are first cut alike along it, so that EdgeClosure finds them.
  void refine_at_edge(const SectorElement& element, int degree, double share,
                      std::vector<SectorElement>& out) const {
    double in_s = errors(element, degree).in_s;
    if (const std::optional<std::size_t> opposite = scene_.opposite(element.sector)) {
      const SectorBox& box = element.box;
      const SectorElement mirror{*opposite, {.s0 = 1 - box.s1, .s1 = 1 - box.s0, .t0 = 0, .t1 = box.t1}};
      in_s = std::max(in_s, errors(mirror, degree).in_s);
    }
    if (in_s <= 0.5 * share || is_last(element, out))
      refine_depth(element, degree, share, out);
    else
      for (const SectorElement& half : halves_in_s(element)) refine_at_edge(half, degree, share, out);
  }

  void refine_depth(const SectorElement& element, int degree, double share,
                    std::vector<SectorElement>& out) const {
    if (errors(element, degree).in_t <= 0.5 * share || is_last(element, out)) {
      out.push_back(element);
      return;
    }
    const std::array<SectorElement, 2> halves = halves_in_t(element);
    refine_depth(halves[0], degree, share, out);
    refine(halves[1], degree, share, out);
  }

  [[nodiscard]] static std::array<SectorElement, 2> halves_in_s(const SectorElement& element) {
    std::array<SectorElement, 2> halves{element, element};
    halves[0].box.s1 = halves[1].box.s0 = element.box.middle_s();
    return halves;
  }
  [[nodiscard]] static std::array<SectorElement, 2> halves_in_t(const SectorElement& element) {
    std::array<SectorElement, 2> halves{element, element};
    halves[0].box.t1 = halves[1].box.t0 = element.box.middle_t();
    return halves;
  }

  const SectorScene& scene_;
  Reflectivity reflectivity_;
  std::vector<Observer> observers_;
};

}  // namespace

std::unique_ptr<Goals> point_values(const SectorScene& scene, const Reflectivity& reflectivity,
                                    const std::vector<ValueGoal>& points) {
  return std::make_unique<PointValues>(scene, reflectivity, points);
}

}  // namespace radcert
