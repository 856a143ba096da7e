// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/transport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/transport/source_rule.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/scalar/pack.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// A range of the points, halved until one is left.
struct PointRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  ObserverBall ball;
  std::size_t halves = 0;  ///< the place of the first half in the list, the second after it; 0: none
  double error = 0;        ///< of the parts that are summed for these points together
  double terms = 0;
};

std::size_t in_whole_packs(std::size_t size) { return (size + Pack::lanes - 1) / Pack::lanes * Pack::lanes; }

/// A part of an element, and how much of it is counted.
struct Part {
  std::size_t element = 0;
  SectorBox box;
  double share = 1;
};

}  // namespace

Transport::Transport(const SectorScene& scene, std::span<const SectorElement> elements,
                     const SectorFunctions& functions)
    : scene_(scene),
      elements_(elements),
      powers_(static_cast<std::size_t>(functions.degree() + 1)),
      count_(functions.count()),
      stride_(count_ == 1 ? 1 : in_whole_packs(count_)),
      coefficients_(elements.size() * powers_ * (count_ == 1 ? in_whole_packs(powers_) : powers_ * stride_)),
      penumbra_(scene, elements, functions) {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const std::size_t panel = scene.sectors()[elements[e].sector].panel;
    while (first_element_.size() <= panel) first_element_.push_back(e);
    sizes_.push_back(polynomial_sizes(functions, e, 0, functions.count()));
    element_size_.push_back(size_in_ellipse(sizes_.back().by_s, 1));
    size_ = std::max(size_, element_size_.back());
    if (count_ == 1)
      for (std::size_t i = 0; i < powers_; ++i)
        for (std::size_t j = 0; j < powers_; ++j)
          coefficients_[(e * powers_ + j) * in_whole_packs(powers_) + i] =
              functions.of(e, 0)[i * powers_ + j];
    for (std::size_t k = 0; k < count_ && count_ > 1; ++k)
      for (std::size_t i = 0; i < functions.size(); ++i)
        coefficients_[(e * functions.size() + i) * stride_ + k] = functions.of(e, k)[i];
  }
  while (first_element_.size() <= scene.panels().size()) first_element_.push_back(elements.size());
}

/// The sum over one group of points: what is far is summed for all points by one rule, what is near for
/// fewer.
class Transport::Sum {
public:
  Sum(const Transport& transport, const ObserverGroup& group, double tolerance)
      : transport_(transport),
        scene_(transport.scene_),
        panel_(group.panel),
        points_(group.points),
        hull_(group.hull),
        least_mass_(group.least_mass),
        by_points_(group.by_points),
        tolerance_(tolerance),
        powers_(transport.powers_),
        stride_(transport.stride_),
        values_(points_.size() * stride_),
        legendre_s_(most_source_nodes * powers_),
        legendre_t_(most_source_nodes * powers_),
        contracted_(std::max(powers_ * stride_, in_whole_packs(powers_))),
        packs_of_s_(2 * powers_),
        packs_of_t_(2 * powers_) {
    ranges_.push_back({.begin = 0, .end = points_.size(), .ball = ball_of(0, points_.size())});
    for (std::size_t r = 0; r < ranges_.size(); ++r) {
      const std::size_t begin = ranges_[r].begin;
      const std::size_t end = ranges_[r].end;
      if (end - begin < 2) continue;
      const std::size_t middle = begin + (end - begin) / 2;
      ranges_[r].halves = ranges_.size();
      ranges_.push_back({.begin = begin, .end = middle, .ball = ball_of(begin, middle)});
      ranges_.push_back({.begin = middle, .end = end, .ball = ball_of(middle, end)});
    }
  }

  void add_panel(std::size_t panel) {
    look_at(panel);
    if (!by_points_ || view_of_panel(scene_, panel_, hull_, panel) == PanelView::whole) {
      add_parts(0, seen_parts(panel, hull_));
      return;
    }
    for (std::size_t r = 0; r < ranges_.size(); ++r)
      if (ranges_[r].halves == 0) add_parts(r, seen_parts(panel, points_.subspan(ranges_[r].begin, 1)));
  }

  /// Parts of elements of one panel.
  void add_sources(std::size_t panel, std::span<const PartOfElement> sources) {
    look_at(panel);
    std::vector<Part> parts;
    for (const PartOfElement& source : sources) parts.push_back({source.element, source.box});
    add_parts(0, std::move(parts));
  }

  [[nodiscard]] std::vector<ShadedPart> take_shaded() { return std::move(shaded_); }

  /// Truncation, and what rounding adds to it: points, kernel, functions, sums.
  [[nodiscard]] double radius() const {
    double error = 0;
    double terms = 0;
    std::vector<std::pair<double, double>> above(ranges_.size());
    for (std::size_t r = 0; r < ranges_.size(); ++r) {
      above[r].first += ranges_[r].error;
      above[r].second += ranges_[r].terms;
      error = std::max(error, above[r].first);
      terms = std::max(terms, above[r].second);
      if (ranges_[r].halves == 0) continue;
      above[ranges_[r].halves] = above[r];
      above[ranges_[r].halves + 1] = above[r];
    }
    const auto powers = static_cast<double>(powers_);
    const double relative = (32 * powers * powers + terms + 64) * unit_roundoff<double>();
    // No part has fewer terms than one.
    error *= 1 + terms * unit_roundoff<double>();
    return (error + 2 * (transport_.size_ + error) * relative) * upward;
  }
  [[nodiscard]] double value(std::size_t point, std::size_t k) const { return values_[point * stride_ + k]; }

private:
  /// The heights of the points over the plane of a panel.
  void look_at(std::size_t panel) {
    const Sector& sector = scene_.sectors()[scene_.first_sector(panel)];
    const Vector<double>& n = scene_.normal(panel);
    heights_.clear();
    double highest = 0;
    for (const Vector<double>& p : points_) {
      heights_.push_back(dot(n, p - sector.a));
      highest = std::max(highest, heights_.back());
    }
    height_ = highest + 64 * unit_roundoff<double>() * scene_.extent();
  }

  /// The parts of a panel that send anything to a hull.
  [[nodiscard]] std::vector<Part> seen_parts(std::size_t panel, std::span<const Vector<double>> hull) {
    const auto sends = [&](std::size_t e) { return transport_.element_size_[e] > 0; };
    std::vector<Part> parts;
    const SeenPanel seen = transport_.penumbra_.seen(panel_, hull, panel, least_mass_);
    for (const PartOfElement& part : seen.whole)
      if (sends(part.element)) parts.push_back({part.element, part.box});
    for (const ShadedPart& shaded : seen.shaded)
      if (sends(shaded.part.element)) {
        parts.push_back({shaded.part.element, shaded.part.box, 0.5});
        shaded_.push_back(shaded);
      }
    return parts;
  }

  [[nodiscard]] ObserverBall ball_of(std::size_t begin, std::size_t end) const {
    return ball_about(points_.subspan(begin, end - begin), scene_.extent());
  }

  /// Sums over parts of a panel for a range of points. A part is cut where it is large beside its distance;
  /// it is left to the halves of the range where the range is.
  void add_parts(std::size_t r, std::vector<Part> parts) {
    std::vector<Part> for_halves;
    while (!parts.empty()) {
      const Part part = parts.back();
      parts.pop_back();
      const SectorElement& element = transport_.elements_[part.element];
      const PolynomialSizes& sizes = transport_.sizes_[part.element];
      const SeenPart box = seen_part(scene_, element, part.box, ranges_[r].ball);
      const double near = std::max(box.to_s, box.to_t);
      if (ranges_[r].halves > 0 && ranges_[r].ball.radius > 0.55 * (near + ranges_[r].ball.radius)) {
        for_halves.push_back(part);
        continue;
      }
      // What the part contributes, about; a part that is small beside all others need not be relatively good.
      const double share =
          near > 0 ? std::min(1.0, box.area * std::min(1.0, height_ / near) / (near * near)) : 1;
      const double allowed = tolerance_ * transport_.size_ *
                             std::max(0.25 * share, 0.1 / static_cast<double>(transport_.elements_.size()));
      const RuleChoice in_s = rule_in_s(box, height_, sizes.by_s, allowed);
      const RuleChoice in_t = rule_in_t(box, height_, sizes.by_t, allowed);
      if (in_s.nodes > 0 && in_t.nodes > 0) {
        const double least = box.least_distance();
        const double kernel_error = least > least_kernel_distance * scene_.extent()
                                        ? std::numbers::inv_pi * box.area *
                                              transport_.element_size_[part.element] * kernel_rounding *
                                              scene_.extent() / (least * least * least)
                                        : infinity;
        ranges_[r].error += in_s.error + in_t.error + kernel_error;
        if (stride_ == 1)
          add_nodes_of_one(part, in_s.nodes, in_t.nodes);
        else
          add_nodes(part, in_s.nodes, in_t.nodes);
        constexpr std::size_t block = 1024;
        if (x_.size() >= block) flush(r);
        continue;
      }
      cut(part, in_s.nodes == 0 && (in_t.nodes > 0 || box.half_s >= box.half_t), r, parts);
    }
    flush(r);
    if (for_halves.empty()) return;
    add_parts(ranges_[r].halves, for_halves);
    add_parts(ranges_[r].halves + 1, std::move(for_halves));
  }

  void cut(const Part& part, bool in_s, std::size_t r, std::vector<Part>& parts) {
    const SectorBox& box = part.box;
    constexpr double smallest = 0x1p-44;
    if ((in_s ? box.s1 - box.s0 : box.t1 - box.t0) < smallest) {
      ranges_[r].error = infinity;
      return;
    }
    Part lower = part;
    Part upper = part;
    if (in_s)
      lower.box.s1 = upper.box.s0 = box.middle_s();
    else
      lower.box.t1 = upper.box.t0 = box.middle_t();
    parts.push_back(lower);
    parts.push_back(upper);
  }

  /// P_0, ..., P_degree of an element at the nodes of a rule on a part of it.
  void tabulate(const PartOfInterval& part, std::span<const double> nodes, std::vector<double>& table) const {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      legendre_values<double>(part.place(nodes[i]), std::span(table).subspan(i * powers_, powers_));
  }

  void add_nodes(const Part& part, int in_s, int in_t) {
    const SectorElement& element = transport_.elements_[part.element];
    const SectorBox& box = part.box;
    const Sector& sector = scene_.sectors()[element.sector];
    const IntervalRule<double>& rule_s = gauss_on_interval(in_s);
    const IntervalRule<double>& rule_t = gauss_on_interval(in_t);
    tabulate(part_in_s(box, element.box), rule_s.nodes, legendre_s_);
    tabulate(part_in_t(box, element.box), rule_t.nodes, legendre_t_);
    const double half_s = 0.5 * (box.s1 - box.s0);
    const double half_t = 0.5 * (box.t1 - box.t0);
    const double scale = part.share * std::numbers::inv_pi * sector.jacobian * half_s * half_t;
    const double* const c = transport_.coefficients_.data() + part.element * powers_ * powers_ * stride_;
    const std::size_t begin = x_.size();
    const std::size_t nodes = rule_s.nodes.size() * rule_t.nodes.size();
    x_.resize(begin + nodes);
    y_.resize(begin + nodes);
    z_.resize(begin + nodes);
    weights_.resize((begin + nodes) * stride_);
    std::size_t place = begin;
    for (std::size_t j = 0; j < rule_t.nodes.size(); ++j) {
      const double t = box.middle_t() + half_t * rule_t.nodes[j];
      for (std::size_t lane = 0; lane < stride_; lane += Pack::lanes)
        for (std::size_t i = 0; i < powers_; ++i) {
          Pack sum(0.0);
          for (std::size_t l = 0; l < powers_; ++l)
            sum = fma(Pack::load(c + (i * powers_ + l) * stride_ + lane), Pack(legendre_t_[j * powers_ + l]),
                      sum);
          sum.store(&contracted_[i * stride_ + lane]);
        }
      for (std::size_t i = 0; i < rule_s.nodes.size(); ++i, ++place) {
        const Vector<double> q = sector.point(box.middle_s() + half_s * rule_s.nodes[i], t);
        x_[place] = q.x;
        y_[place] = q.y;
        z_[place] = q.z;
        const double weight = scale * (1 - t) * rule_s.weights[i] * rule_t.weights[j];
        for (std::size_t lane = 0; lane < stride_; lane += Pack::lanes) {
          Pack sum(0.0);
          for (std::size_t l = 0; l < powers_; ++l)
            sum = fma(Pack::load(&contracted_[l * stride_ + lane]), Pack(legendre_s_[i * powers_ + l]), sum);
          (Pack(weight) * sum).store(&weights_[place * stride_ + lane]);
        }
      }
    }
  }

  /// A rule's nodes or weights, filled up to whole packs.
  using PaddedNodes = std::array<double, 2 * Pack::lanes>;
  static_assert(most_source_nodes <= static_cast<int>(2 * Pack::lanes));
  static PaddedNodes padded(const std::vector<double>& numbers) {
    PaddedNodes out{};
    std::copy(numbers.begin(), numbers.end(), out.begin());
    return out;
  }

  /// P_0, ..., P_degree of an element at padded nodes on a part of it, by pack, degree.
  void tabulate(const PartOfInterval& part, const PaddedNodes& nodes, std::size_t packs,
                std::vector<Pack>& table) const {
    for (std::size_t b = 0; b < packs; ++b)
      legendre_values<Pack>(Pack(part.middle) + Pack(part.half) * Pack::load(&nodes[b * Pack::lanes]),
                            std::span(table).subspan(b * powers_, powers_));
  }

  /// The same for one function, at as many nodes at a time as a pack has lanes.
  void add_nodes_of_one(const Part& part, int in_s, int in_t) {
    const SectorElement& element = transport_.elements_[part.element];
    const SectorBox& box = part.box;
    const Sector& sector = scene_.sectors()[element.sector];
    const auto nodes_s = static_cast<std::size_t>(in_s);
    const auto nodes_t = static_cast<std::size_t>(in_t);
    const std::size_t packs_s = in_whole_packs(nodes_s) / Pack::lanes;
    const PaddedNodes at_s = padded(gauss_on_interval(in_s).nodes);
    const PaddedNodes at_t = padded(gauss_on_interval(in_t).nodes);
    const PaddedNodes weights_s = padded(gauss_on_interval(in_s).weights);
    const PaddedNodes weights_t = padded(gauss_on_interval(in_t).weights);
    tabulate(part_in_s(box, element.box), at_s, packs_s, packs_of_s_);
    tabulate(part_in_t(box, element.box), at_t, in_whole_packs(nodes_t) / Pack::lanes, packs_of_t_);
    const double half_s = 0.5 * (box.s1 - box.s0);
    const double half_t = 0.5 * (box.t1 - box.t0);
    const double scale = part.share * std::numbers::inv_pi * sector.jacobian * half_s * half_t;
    const std::size_t padded_powers = in_whole_packs(powers_);
    const double* const c = transport_.coefficients_.data() + part.element * powers_ * padded_powers;
    const std::size_t begin = x_.size();
    const std::size_t nodes = nodes_s * nodes_t;
    const auto resize = [&](std::size_t size) {
      for (std::vector<double>* numbers : {&x_, &y_, &z_, &weights_}) numbers->resize(size);
    };
    resize(begin + nodes + Pack::lanes);
    for (std::size_t j = 0; j < nodes_t; ++j) {
      const double t = box.middle_t() + half_t * at_t[j];
      const Pack* const of_t = &packs_of_t_[j / Pack::lanes * powers_];
      for (std::size_t i = 0; i < padded_powers; i += Pack::lanes) {
        Pack sum(0.0);
        for (std::size_t l = 0; l < powers_; ++l)
          sum = fma(Pack::load(c + l * padded_powers + i), Pack(of_t[l].lane(j % Pack::lanes)), sum);
        sum.store(&contracted_[i]);
      }
      // What a pack has beyond the nodes of this line is written over by the next one, or taken away.
      for (std::size_t b = 0; b < packs_s; ++b) {
        const std::size_t place = begin + j * nodes_s + b * Pack::lanes;
        Pack sum(0.0);
        for (std::size_t l = 0; l < powers_; ++l)
          sum = fma(Pack(contracted_[l]), packs_of_s_[b * powers_ + l], sum);
        const Pack weight = Pack(scale * (1 - t) * weights_t[j]) * Pack::load(&weights_s[b * Pack::lanes]);
        (weight * sum).store(&weights_[place]);
        const Pack s = Pack(box.middle_s()) + Pack(half_s) * Pack::load(&at_s[b * Pack::lanes]);
        const Pack of_a = Pack(1 - t) * (Pack(1.0) - s);
        const Pack of_b = Pack(1 - t) * s;
        const auto coordinate = [&](double a, double b_, double c_) {
          return of_a * Pack(a) + of_b * Pack(b_) + Pack(t * c_);
        };
        coordinate(sector.a.x, sector.b.x, sector.c.x).store(&x_[place]);
        coordinate(sector.a.y, sector.b.y, sector.c.y).store(&y_[place]);
        coordinate(sector.a.z, sector.b.z, sector.c.z).store(&z_[place]);
      }
    }
    resize(begin + nodes);
  }

  /// Sums over the nodes that are collected, for the points of a range, and forgets them.
  void flush(std::size_t r) {
    if (x_.empty()) return;
    ranges_[r].terms += static_cast<double>(x_.size());
    while (x_.size() % Pack::lanes != 0) {
      x_.push_back(x_.back());
      y_.push_back(y_.back());
      z_.push_back(z_.back());
    }
    const std::size_t nodes = x_.size();
    weights_.resize(nodes * stride_);  // the new ones are 0
    std::size_t p = ranges_[r].begin;
    for (; p + 2 <= ranges_[r].end; p += 2) stride_ == 1 ? sum_of_one_for<2>(p) : sum_for<2>(p);
    if (p < ranges_[r].end) stride_ == 1 ? sum_of_one_for<1>(p) : sum_for<1>(p);
    x_.clear();
    y_.clear();
    z_.clear();
    weights_.clear();
  }

  /// Over the nodes at hand for so many points, the first of them named: they share what is read.
  template <std::size_t points>
  void sum_for(std::size_t first) {
    const std::size_t nodes = x_.size();
    kernel_.resize(points * nodes);
    const Vector<double>& n = scene_.normal(panel_);
    const Vector<Pack> minus_n{-n.x, -n.y, -n.z};
    for (std::size_t q = 0; q < points; ++q) {
      const Vector<double>& p = points_[first + q];
      const Vector<Pack> at{p.x, p.y, p.z};
      double* const kernel = &kernel_[q * nodes];
      for (std::size_t i = 0; i < nodes; i += Pack::lanes) {
        const Vector<Pack> difference{at.x - Pack::load(&x_[i]), at.y - Pack::load(&y_[i]),
                                      at.z - Pack::load(&z_[i])};
        const Pack inverse = reciprocal(fused_dot(difference, difference));
        (fused_dot(difference, minus_n) * (inverse * inverse)).store(kernel + i);
      }
    }
    for (std::size_t lane = 0; lane < stride_; lane += Pack::lanes) {
      std::array<Pack, points> even;
      std::array<Pack, points> odd;
      even.fill(Pack(0.0));
      odd.fill(Pack(0.0));
      const double* weights = weights_.data() + lane;
      for (std::size_t i = 0; i < nodes; i += 2) {
        const Pack weight = Pack::load(weights + i * stride_);
        const Pack next = Pack::load(weights + (i + 1) * stride_);
        for (std::size_t q = 0; q < points; ++q) {
          even[q] = fma(Pack(kernel_[q * nodes + i]), weight, even[q]);
          odd[q] = fma(Pack(kernel_[q * nodes + i + 1]), next, odd[q]);
        }
      }
      for (std::size_t q = 0; q < points; ++q) {
        double* const sum = &values_[(first + q) * stride_ + lane];
        fma(Pack(heights_[first + q]), even[q] + odd[q], Pack::load(sum)).store(sum);
      }
    }
  }

  /// The same for one function.
  template <std::size_t points>
  void sum_of_one_for(std::size_t first) {
    const Vector<double>& n = scene_.normal(panel_);
    const Vector<Pack> minus_n{-n.x, -n.y, -n.z};
    std::array<Vector<Pack>, points> at;
    std::array<Pack, points> sums;
    for (std::size_t q = 0; q < points; ++q) {
      const Vector<double>& p = points_[first + q];
      at[q] = {p.x, p.y, p.z};
      sums[q] = Pack(0.0);
    }
    for (std::size_t i = 0; i < x_.size(); i += Pack::lanes) {
      const Vector<Pack> from{Pack::load(&x_[i]), Pack::load(&y_[i]), Pack::load(&z_[i])};
      const Pack weight = Pack::load(&weights_[i]);
      for (std::size_t q = 0; q < points; ++q) {
        const Vector<Pack> difference{at[q].x - from.x, at[q].y - from.y, at[q].z - from.z};
        const Pack inverse = reciprocal(fused_dot(difference, difference));
        sums[q] = fma(fused_dot(difference, minus_n) * (inverse * inverse), weight, sums[q]);
      }
    }
    for (std::size_t q = 0; q < points; ++q)
      values_[first + q] = std::fma(heights_[first + q], sums[q].sum(), values_[first + q]);
  }

  const Transport& transport_;
  const SectorScene& scene_;
  std::size_t panel_;
  std::span<const Vector<double>> points_;
  std::span<const Vector<double>> hull_;
  double least_mass_;
  bool by_points_;
  std::vector<ShadedPart> shaded_;
  double tolerance_;
  std::size_t powers_;
  std::size_t stride_;
  std::vector<PointRange> ranges_;
  std::vector<double> values_;   ///< by point, function, functions filled up to whole packs
  std::vector<double> heights_;  ///< of the points over the plane of the panel at hand
  double height_ = 0;            ///< the largest of them, rounded up
  std::vector<double> x_, y_, z_;
  std::vector<double> weights_;  ///< by node, function
  std::vector<double> legendre_s_, legendre_t_, contracted_;
  std::vector<Pack> packs_of_s_, packs_of_t_;
  std::vector<double> kernel_;
};

bool Transport::reaches(std::size_t panel, std::size_t to) const {
  return panel != to && !scene_.coplanar(panel, to) && scene_.sight().view(to, panel) != PanelView::none;
}

Transport::Values Transport::taken(Sum& sum, std::size_t points) const {
  Values out{.values = {}, .radius = sum.radius(), .shaded = sum.take_shaded()};
  out.values.reserve(points * count_);
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t k = 0; k < count_; ++k) out.values.push_back(sum.value(p, k));
  return out;
}

Transport::Values Transport::operator()(const ObserverGroup& group, double tolerance,
                                        std::optional<std::size_t> without) const {
  Sum sum(*this, group, tolerance);
  for (std::size_t panel = 0; panel < scene_.panels().size(); ++panel)
    if (panel != without && reaches(panel, group.panel)) sum.add_panel(panel);
  return taken(sum, group.points.size());
}

std::vector<PartOfElement> Transport::sources(std::size_t panel, std::optional<std::size_t> without) const {
  std::vector<PartOfElement> out;
  for (std::size_t from = 0; from < scene_.panels().size(); ++from) {
    if (from == without || !reaches(from, panel)) continue;
    for (std::size_t e = first_element_[from]; e < first_element_[from + 1]; ++e)
      if (element_size_[e] > 0) out.push_back({e, elements_[e].box});
  }
  return out;
}

Transport::Values Transport::from(std::span<const PartOfElement> sources, const ObserverGroup& group,
                                  double tolerance) const {
  Sum sum(*this, group, tolerance);
  const auto panel_of = [&](const PartOfElement& part) {
    return scene_.sectors()[elements_[part.element].sector].panel;
  };
  while (!sources.empty()) {
    const std::size_t panel = panel_of(sources[0]);
    const auto end = std::find_if(sources.begin(), sources.end(),
                                  [&](const PartOfElement& part) { return panel_of(part) != panel; });
    const auto size = static_cast<std::size_t>(end - sources.begin());
    sum.add_sources(panel, sources.first(size));
    sources = sources.subspan(size);
  }
  return taken(sum, group.points.size());
}

}  // namespace radcert
