// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/observer_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/continuous/transport.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"

namespace radcert {

const WorkLimit deepest_cell("continuous/observer_cells: halvings of an element", 80, 0,
                             "a strip that is not looked into");

const WorkLimit most_cells("continuous/observer_cells: cells of an element", 20000, 0,
                           "strips that are not looked into");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double upward = 1 + 0x1p-40;
/// A cell whose rule would need more is cut.
constexpr int most_cell_nodes = 12;
/// The larger half axes of the ellipses that are tried, in units of half the line.
constexpr std::array<double, 20> axes{1.02, 1.06, 1.12, 1.2, 1.35, 1.5, 1.75, 2,   2.5,  3.2,
                                      4.2,  5.6,  8,    12,  20,   40,  100,  400, 2000, 20000};
/// Where Q slides, both parameters of its element stay in the unit disk: the real segment that is as long as Q
/// moves lies in the element, and the disk about it goes to a disk about a part of [-1,1], as x and y are affine
/// or quotients of affine functions of the way. There |P_i| <= (1 + sqrt(2))^i.
constexpr double slid_growth = 2.4143;
/// Where Q turns: A + sqrt(A^2 - 1) for A = 3/2 and A = 2.
constexpr double turned_along = 2.6181;
constexpr double turned_across = 3.7321;

using Bounds = std::array<double, axes.size()>;

double rho(double axis) { return axis + std::sqrt(axis * axis - 1); }

struct Powers {
  std::array<std::array<double, axes.size()>, most_gauss_nodes> interpolation;
  std::array<std::array<double, axes.size()>, most_gauss_nodes> quadrature;
};

const Powers& powers() {
  static const Powers table = [] {
    Powers made{};
    for (std::size_t n = 1; n <= most_gauss_nodes; ++n)
      for (std::size_t a = 0; a < axes.size(); ++a) {
        const double r = rho(axes[a]);
        const auto count = static_cast<double>(n);
        made.interpolation[n - 1][a] = 2 * std::pow(r, 1 - count) / (r - 1) * upward;
        made.quadrature[n - 1][a] =
            (2 + 2 / (4 * count * count - 1)) * std::pow(r, -2 * count) / (1 - 1 / (r * r)) * upward;
      }
    return made;
  }();
  return table;
}

/// A bound of the functions on an element where |P_i(x)| <= along^i and |P_j(y)| <= across^j.
double size_around(const SectorFunctions& w, std::size_t element, double along, double across) {
  const auto powers = static_cast<std::size_t>(w.degree() + 1);
  double largest = 0;
  for (std::size_t k = 0; k < w.count(); ++k) {
    const std::span<const double> c = w.of(element, k);
    double sum = 0;
    for (std::size_t i = powers; i-- > 0;) {
      double inner = 0;
      for (std::size_t j = powers; j-- > 0;) inner = inner * across + std::abs(c[i * powers + j]);
      sum = sum * along + inner;
    }
    largest = std::max(largest, sum);
  }
  return largest * upward;
}

double least(const Bounds& bounds, const std::array<double, axes.size()>& factors) {
  double best = infinity;
  for (std::size_t a = 0; a < axes.size(); ++a) best = std::min(best, bounds[a] * factors[a]);
  return best;
}

}  // namespace

namespace {

void add_piece(RuleErrors& errors, const Bounds& bounds, const Bounds& growth) {
  Bounds times_density{};
  for (std::size_t a = 0; a < axes.size(); ++a) times_density[a] = bounds[a] * growth[a];
  for (std::size_t n = 0; n < most_gauss_nodes; ++n) {
    errors.interpolation[n] += least(bounds, powers().interpolation[n]) * upward;
    errors.quadrature[n] += least(times_density, powers().quadrature[n]) * upward;
  }
}

}  // namespace

/// The lines of a cell in one parameter.
struct Smoothness::Line {
  Vector<double> from;  ///< the middles of the lines run from here
  Vector<double> to;
  Vector<double> half_from;  ///< half of the line there, and at the other end
  Vector<double> half_to;
  double part = 0;         ///< half length relative to that of the element
  double mirror_part = 0;  ///< and to that of the mirror
  double jacobian_part = 0;
  bool slides = false;
  double from_edge = 0;  ///< of lines across: the middle of t in units of half the line
};

Smoothness::Smoothness(const SectorScene& scene, std::span<const SectorElement> elements,
                       const SectorFunctions& w, const SectorFunctions& q)
    : scene_(scene),
      elements_(elements),
      panel_size_(scene.panels().size()),
      slid_size_(scene.panels().size()),
      sides_(scene.sectors().size() * scene.panels().size()),
      around_(scene.sectors().size()),
      turned_size_(scene.sectors().size()) {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const std::size_t panel = scene.sectors()[elements[e].sector].panel;
    w_sizes_.push_back(polynomial_sizes(w, e, 0, w.count()));
    q_sizes_.push_back(polynomial_sizes(q, e, 0, q.count()));
    w_size_.push_back(size_in_ellipse(w_sizes_.back().by_s, 1));
    q_size_.push_back(size_in_ellipse(q_sizes_.back().by_s, 1));
    panel_size_[panel] = std::max(panel_size_[panel], w_size_.back());
    slid_size_[panel] = std::max(slid_size_[panel], size_around(w, e, slid_growth, slid_growth));
    size_ = std::max(size_, w_size_.back());
    largest_q_ = std::max(largest_q_, q_size_.back());
    if (elements[e].box.t0 == 0) lowest_layer_ = std::min(lowest_layer_, elements[e].box.t1);
  }
  for (std::size_t i = 0; i < scene.sectors().size(); ++i)
    for (std::size_t j = 0; j < scene.panels().size(); ++j) {
      if (!scene.parallel(i, j)) continue;
      std::vector<Side>& sides = sides_[i * scene.panels().size() + j];
      const auto add = [&](const Vector<double>& from, const Vector<double>& to) {
        sides.push_back({from, to});
      };
      std::vector<bool> aligned;
      for (std::size_t k = scene.first_sector(j); k < scene.first_sector(j + 1); ++k)
        aligned.push_back(scene.aligned(i, k));
      for (const SectorElement& element : elements) {
        const Sector& sector = scene.sectors()[element.sector];
        if (sector.panel != j) continue;
        const SectorBox& box = element.box;
        add(sector.point(box.s0, box.t0), sector.point(box.s0, box.t1));
        add(sector.point(box.s1, box.t0), sector.point(box.s1, box.t1));
        if (aligned[element.sector - scene.first_sector(j)]) continue;
        add(sector.point(box.s0, box.t0), sector.point(box.s1, box.t0));
        add(sector.point(box.s0, box.t1), sector.point(box.s1, box.t1));
      }
    }
  for (std::size_t i = 0; i < scene.sectors().size(); ++i) {
    if (!scene.opposite(i)) continue;
    const std::size_t opposite = *scene.opposite(i);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const Sector& sector = scene.sectors()[elements[e].sector];
      if (sector.panel != scene.sectors()[opposite].panel) continue;
      const SectorBox& box = elements[e].box;
      const auto add = [&](double s0, double t0, double s1, double t1) {
        around_[i].push_back({sector.point(s0, t0), sector.point(s1, t1)});
      };
      add(box.s0, box.t0, box.s0, box.t1);
      add(box.s1, box.t0, box.s1, box.t1);
      add(box.s0, box.t1, box.s1, box.t1);
      const bool at_edge = elements[e].sector == opposite && box.t0 == 0;
      if (!at_edge) add(box.s0, box.t0, box.s1, box.t0);
      if (!at_edge) continue;
      turned_size_[i] = std::max(turned_size_[i], size_around(w, e, turned_along, turned_across));
    }
    turned_size_[i] = std::max(turned_size_[i], panel_size_[scene.sectors()[opposite].panel]);
  }
  prepare_edges(w);
}

/// What the closure needs of elements at edges.
void Smoothness::prepare_edges(const SectorFunctions& w) {
  const auto powers = static_cast<std::size_t>(w.degree() + 1);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const SectorBox& box = elements_[e].box;
    mirror_.emplace_back();
    edge_sizes_.emplace_back();
    lipschitz_.push_back(infinity);
    const std::optional<std::size_t> opposite = scene_.opposite(elements_[e].sector);
    if (box.t0 != 0 || !opposite) continue;
    for (std::size_t other = 0; other < elements_.size(); ++other) {
      const SectorElement& mirror = elements_[other];
      if (mirror.sector == *opposite && mirror.box.t0 == 0 && mirror.box.s0 == 1 - box.s1 &&
          mirror.box.s1 == 1 - box.s0)
        mirror_[e] = other;
    }
    std::vector<double> sizes(powers);
    double slope_x = 0;
    double slope_y = 0;
    for (std::size_t k = 0; k < w.count(); ++k) {
      const std::span<const double> c = w.of(e, k);
      double of_x = 0;
      double of_y = 0;
      for (std::size_t i = 0; i < powers; ++i) {
        double at_edge = 0;
        double error = 0;
        for (std::size_t j = 0; j < powers; ++j) {
          const double value = std::abs(c[i * powers + j]);
          at_edge += j % 2 == 0 ? c[i * powers + j] : -c[i * powers + j];
          error += value;
          of_x += value * static_cast<double>(i * (i + 1)) / 2;
          of_y += value * static_cast<double>(j * (j + 1)) / 2;
        }
        sizes[i] = std::max(sizes[i], std::abs(at_edge) + 64 * unit_roundoff<double>() * error);
      }
      slope_x = std::max(slope_x, of_x);
      slope_y = std::max(slope_y, of_y);
    }
    edge_sizes_.back() = sizes;
    // |grad s| <= (1 + q)/((1 - t) |b - a|), |grad t| = 1/H; x = 2 s/width, y = 2 t/depth.
    const Sector& sector = scene_.sectors()[elements_[e].sector];
    const double slack = 4 * displacement * scene_.extent();
    const double length = norm(sector.b - sector.a) / upward - slack;
    const double height = sector.jacobian / (norm(sector.b - sector.a) + slack) / upward;
    const double leg = std::max(norm(sector.c - sector.a), norm(sector.c - sector.b)) * upward + slack;
    if (box.t1 < 1 && length > 0)
      lipschitz_.back() = (slope_x * 2 / (box.s1 - box.s0) * (1 + leg / height) / ((1 - box.t1) * length) +
                           slope_y * 2 / box.t1 / height) *
                          upward;
  }
}

/// How far Q may turn about points of an edge.
/// Maths     r = min(d/(4 (1+q)), H T/2), d the distance of the points from the sides around, H the height of
///           the opposite sector, T its lowest layer, q the quotient of its longer leg and H. The parameters
///           of Q are then off those of x by at most 1/2 in x, since d is at most half the width of the
///           element, and by 1 in y, which is -1 at x: |P_i(x)| <= (3/2 + (5/4)^(1/2))^i, |P_j(y)| <= (2 +
///           3^(1/2))^j
double Smoothness::reach_of_turn(std::size_t sector, const Vector<double>& from,
                                 const Vector<double>& to) const {
  if (!scene_.opposite(sector)) return 0;
  const Sector& opposite = scene_.sectors()[*scene_.opposite(sector)];
  const double slack = 4 * displacement * scene_.extent();
  const Vector<double> middle = 0.5 * (from + to);
  double nearest = infinity;
  for (const Side& side : around_[sector]) nearest = std::min(nearest, distance(middle, side.from, side.to));
  nearest = nearest / upward - 0.5 * norm(to - from) * upward - slack;
  const double height = opposite.jacobian / (norm(opposite.b - opposite.a) + slack) / upward;
  const double leg = std::max(norm(opposite.c - opposite.a), norm(opposite.c - opposite.b)) * upward + slack;
  return std::min(nearest / (4 * (1 + leg / height)), 0.5 * height * lowest_layer_) / upward;
}

RuleErrors Smoothness::along(std::size_t element, const Line& line, bool closed) const {
  const SectorElement& own = elements_[element];
  const std::size_t panel = scene_.sectors()[own.sector].panel;
  const std::vector<double>& w_sizes = line.slides ? w_sizes_[element].by_s : w_sizes_[element].by_t;
  const std::vector<double>& q_sizes = line.slides ? q_sizes_[element].by_s : q_sizes_[element].by_t;
  const double slack = 4 * displacement * scene_.extent();
  const double half = std::max(norm(line.half_from), norm(line.half_to)) * upward + slack;
  const Vector<double> middle = 0.5 * (line.from + line.to);
  const double half_middles = 0.5 * norm(line.to - line.from) * upward;

  Bounds growth{};
  Bounds of_q{};
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const double around = ellipse_around(line.part, axes[a]);
    growth[a] = size_in_ellipse(w_sizes, around) * (1 + line.jacobian_part * axes[a]);
    // What does not depend on the variable is met by any rule.
    of_q[a] = size_in_ellipse(q_sizes, around) - q_sizes[0];
  }
  const double turn = line.slides ? 0
                                  : reach_of_turn(own.sector, line.from - line.from_edge * line.half_from,
                                                  line.to - line.from_edge * line.half_to);
  RuleErrors errors;
  for (std::size_t n = 1; n <= most_gauss_nodes; ++n)
    if (n < q_sizes.size())
      errors.interpolation[n - 1] += least(of_q, powers().interpolation[n - 1]) * upward;
  // Of xi, and of xi less what rules meet.
  Bounds xi{};
  if (closed) {
    const std::vector<double>& sizes = edge_sizes_[*mirror_[element]];
    Bounds moving{};
    for (std::size_t a = 0; a < axes.size(); ++a) {
      xi[a] = line.slides ? size_in_ellipse(sizes, ellipse_around(line.mirror_part, axes[a]))
                          : size_in_ellipse(sizes, 1);
      moving[a] = line.slides ? xi[a] - sizes[0] : 0;
    }
    for (std::size_t n = 1; n <= most_gauss_nodes; ++n) {
      if (n < sizes.size() && line.slides)
        errors.interpolation[n - 1] += least(moving, powers().interpolation[n - 1]) * upward;
      Bounds times_density{};
      for (std::size_t a = 0; a < axes.size(); ++a) times_density[a] = xi[a] * growth[a];
      errors.quadrature[n - 1] += least(times_density, powers().quadrature[n - 1]) * upward;
    }
  }

  for (std::size_t j = 0; j < scene_.panels().size(); ++j) {
    if (j == panel || scene_.coplanar(j, panel)) continue;
    if (closed && j == scene_.sectors()[*scene_.opposite(own.sector)].panel) continue;
    const Vector<double>& n = scene_.normal(j);
    const Sector& first = scene_.sectors()[scene_.first_sector(j)];
    const double height_from = dot(n, line.from - first.a);
    const double height_to = dot(n, line.to - first.a);
    const double d = std::min(height_from, height_to) - slack;
    const double highest = std::max(height_from, height_to) + slack;
    const double turned = std::max(std::abs(dot(n, line.half_from)), std::abs(dot(n, line.half_to))) + slack;
    double reach = 0;
    for (const Vector<double>& corner : {first.a, first.b}) reach = std::max(reach, norm(corner - first.c));
    for (std::size_t s = scene_.first_sector(j) + 1; s < scene_.first_sector(j + 1); ++s)
      reach = std::max(reach, norm(scene_.sectors()[s].a - first.c));
    const double to_panel = norm(middle - first.c) - half_middles - reach - slack;
    const double distance_to = std::max(d, to_panel);
    double mass = 1;
    if (to_panel > 0)
      mass = std::min(mass, std::numbers::inv_pi * scene_.area(j) * std::min(1.0, highest / to_panel) /
                                (to_panel * to_panel) * upward);
    const double rings = scene_.before(panel, j) ? 2 : 1;
    Bounds bounds{};
    double radius = 0;
    const bool may_turn = turn > 0 && j == scene_.sectors()[*scene_.opposite(own.sector)].panel;
    const bool may_slide = line.slides && scene_.parallel(own.sector, j);
    if (may_slide) {
      radius = infinity;
      for (const Side& side : sides_[own.sector * scene_.panels().size() + j])
        radius = std::min(radius, distance(middle, side.from, side.to));
      radius = radius / upward - half_middles - slack;
    }
    for (std::size_t k = 0; k < axes.size(); ++k) {
      bounds[k] = infinity;
      const double a = half * axes[k];
      if (d > 0 && a < distance_to) {
        const double gap = distance_to - a;
        const double quotient = distance_to / gap;
        const double by_nearest = quotient * quotient * quotient * quotient * mass;
        const double by_rings = rings * highest * (1 + a / gap + a * a / (3 * gap * gap)) / gap;
        bounds[k] =
            (1 + turned * axes[k] / d) * std::min(by_nearest, by_rings) * (panel_size_[j] + xi[k]) * upward;
      }
      if (may_slide && a < radius) {
        const double b = half * std::sqrt(axes[k] * axes[k] - 1);
        const double squared = b * b / (radius * radius - a * a) * upward;
        if (squared < 1)
          bounds[k] = std::min(bounds[k], std::sqrt(1 + squared) / ((1 - squared) * (1 - squared)) *
                                              (slid_size_[j] + xi[k]) * upward);
      }
    }
    if (may_turn)
      for (std::size_t k = 0; k < axes.size(); ++k) {
        if (!(axes[k] < line.from_edge)) continue;
        const double size = half * (line.from_edge + axes[k]);
        for (const double times : {3.0, 5.0, 9.0, 20.0}) {
          const double logarithm = std::log(turn / (times * size));
          if (!(logarithm > 0)) continue;
          const double ratio = (times + 1) / (times - 1);
          const double far =
              ratio * ratio * ratio * ratio * std::hypot(1, 0.5 * std::numbers::pi / logarithm);
          bounds[k] = std::min(bounds[k], (1 + 2 * far / (times - 1)) * turned_size_[own.sector] * upward);
        }
      }
    add_piece(errors, bounds, growth);
  }
  return errors;
}

Smoothness::Line Smoothness::line_s(std::size_t element, const SectorBox& box) const {
  const SectorElement& own = elements_[element];
  const Sector& sector = scene_.sectors()[own.sector];
  const Vector<double> side = 0.5 * (box.s1 - box.s0) * (sector.b - sector.a);
  Line line{.from = sector.point(box.middle_s(), box.t0),
            .to = sector.point(box.middle_s(), box.t1),
            .half_from = (1 - box.t0) * side,
            .half_to = (1 - box.t1) * side,
            .part = (box.s1 - box.s0) / (own.box.s1 - own.box.s0),
            .slides = true};
  if (mirror_[element]) {
    const SectorBox& mirror = elements_[*mirror_[element]].box;
    line.mirror_part = (box.s1 - box.s0) / (mirror.s1 - mirror.s0);
  }
  return line;
}

Smoothness::Line Smoothness::line_t(std::size_t element, const SectorBox& box) const {
  const SectorElement& own = elements_[element];
  const Sector& sector = scene_.sectors()[own.sector];
  const double half = 0.5 * (box.t1 - box.t0);
  return {.from = sector.point(box.s0, box.middle_t()),
          .to = sector.point(box.s1, box.middle_t()),
          .half_from = half * (sector.c - sector.point(box.s0, 0)),
          .half_to = half * (sector.c - sector.point(box.s1, 0)),
          .part = (box.t1 - box.t0) / (own.box.t1 - own.box.t0),
          .jacobian_part = half / (1 - box.middle_t()),
          .slides = false,
          .from_edge = box.middle_t() / half};
}

RuleErrors Smoothness::along_s(std::size_t element, const SectorBox& box) const {
  return along(element, line_s(element, box), false);
}
RuleErrors Smoothness::along_t(std::size_t element, const SectorBox& box) const {
  return along(element, line_t(element, box), false);
}
RuleErrors Smoothness::along_s_closed(std::size_t element, const SectorBox& box) const {
  return along(element, line_s(element, box), true);
}
RuleErrors Smoothness::along_t_closed(std::size_t element, const SectorBox& box) const {
  return along(element, line_t(element, box), true);
}

Smoothness::Nearby Smoothness::nearby(std::size_t element, const SectorBox& box) const {
  const SectorElement& own = elements_[element];
  const Sector& sector = scene_.sectors()[own.sector];
  const std::size_t other = scene_.sectors()[*scene_.opposite(own.sector)].panel;
  const double slack = 4 * displacement * scene_.extent();
  const Vector<double> from = sector.point(box.s0, 0);
  const Vector<double> to = sector.point(box.s1, 0);
  const Vector<double> middle = 0.5 * (from + to);
  double d = infinity;
  for (const Side& side : around_[own.sector]) d = std::min(d, distance(middle, side.from, side.to));
  const Nearby none{.bound = infinity, .distance = d};
  d = d / upward - 0.5 * norm(to - from) * upward - slack;
  const double reach = box.t1 * std::max(norm(sector.c - from), norm(sector.c - to)) * upward + slack;
  const Vector<double>& n = scene_.normal(other);
  const double height = box.t1 * std::max(dot(n, sector.c - from), dot(n, sector.c - to)) * upward + slack;
  if (!(d > 4 * reach)) return none;
  const double rings = scene_.before(sector.panel, other) ? 2 : 1;
  const double slope = lipschitz_[*mirror_[element]];
  double bound = 3 * slope * reach;
  double from_here = 2 * reach;
  for (; 2 * from_here + reach <= d; from_here *= 2)
    bound += std::min(1.0, rings * height / from_here) * slope * (2 * from_here + reach);
  bound += std::min(1.0, rings * height / from_here) * 2 * panel_size_[other];
  return {.bound = bound * upward, .distance = none.distance};
}

namespace {

/// The cells of one element.
class ElementCells {
public:
  ElementCells(const SectorScene& scene, const SectorElement& element, std::size_t number,
               const Smoothness& smoothness, const CellDemand& demand)
      : sector_(scene.sectors()[element.sector]), number_(number), smoothness_(smoothness), demand_(demand) {
    add(element.box, 0);
  }
  std::vector<ObserverCell> take() && { return std::move(cells_); }

private:
  /// Takes the cell where rules meet the demand, with what `beside` bounds where the cell is closed.
  bool accept(const SectorBox& box, double area, const RuleErrors& in_s, const RuleErrors& in_t,
              std::optional<double> beside) {
    const double more = beside.value_or(0);
    const double density = smoothness_.density_size(number_);
    if (!(0.5 * more * std::sqrt(area) <= 0.25 * demand_.interpolation &&
          more * density * area <= 0.5 * demand_.quadrature))
      return false;
    const int nodes_s = nodes(in_s, area);
    const int nodes_t = nodes(in_t, area);
    if (nodes_s == 0 || nodes_t == 0) return false;
    const auto s = static_cast<std::size_t>(nodes_s - 1);
    const auto t = static_cast<std::size_t>(nodes_t - 1);
    cells_.push_back({.element = number_,
                      .box = box,
                      .nodes_s = nodes_s,
                      .nodes_t = nodes_t,
                      .closed = beside.has_value(),
                      .interpolation = in_s.interpolation[s] + in_t.interpolation[t] + 0.5 * more,
                      .quadrature = in_s.quadrature[s] + in_t.quadrature[t] + more * density});
    return true;
  }

  void add(const SectorBox& box, long depth_of_cuts) {
    const double area = sector_.jacobian * box.weight();
    const bool at_edge = box.t0 == 0;
    const double largest = smoothness_.residual_size(number_);
    const bool small = largest * std::sqrt(area) <= demand_.interpolation &&
                       area * smoothness_.density_size(number_) * largest <= demand_.quadrature;
    if (small || depth_of_cuts >= deepest_cell.value() || cells_.size() >= most_cells.count()) {
      cells_.push_back({.element = number_, .box = box});
      return;
    }
    SectorBox lower = box;
    SectorBox upper = box;
    const bool closes = at_edge && smoothness_.mirror(number_).has_value();
    if (at_edge) {
      const Smoothness::Nearby nearby = closes ? smoothness_.nearby(number_, box) : Smoothness::Nearby{};
      if (closes && accept(box, area, smoothness_.along_s_closed(number_, box),
                           smoothness_.along_t_closed(number_, box), nearby.bound))
        return;
      const double length = (box.s1 - box.s0) * norm(sector_.b - sector_.a);
      const double depth = box.t1 * norm(sector_.c - sector_.point(box.middle_s(), 0));
      if (closes && length > nearby.distance && length > 4 * depth) {
        lower.s1 = upper.s0 = box.middle_s();
        add(lower, depth_of_cuts + 1);
        add(upper, depth_of_cuts + 1);
        return;
      }
      lower.t1 = upper.t0 = box.t1 / 4;
      add(lower, depth_of_cuts + 2);
      add(upper, depth_of_cuts + 1);
      return;
    }
    const RuleErrors in_s = smoothness_.along_s(number_, box);
    const RuleErrors in_t = smoothness_.along_t(number_, box);
    if (accept(box, area, in_s, in_t, std::nullopt)) return;
    const int nodes_s = nodes(in_s, area);
    const int nodes_t = nodes(in_t, area);
    const bool cut_s = nodes_s == 0 && (nodes_t > 0 || box.s1 - box.s0 >= box.t1 - box.t0);
    if (cut_s)
      lower.s1 = upper.s0 = box.middle_s();
    else
      lower.t1 = upper.t0 = box.middle_t();
    add(lower, depth_of_cuts + 1);
    add(upper, depth_of_cuts + 1);
  }

  /// The least number of nodes that meets half the demand; 0 where there is none.
  [[nodiscard]] int nodes(const RuleErrors& errors, double area) const {
    for (int n = 1; n <= most_cell_nodes; ++n) {
      const auto k = static_cast<std::size_t>(n - 1);
      if (errors.interpolation[k] * std::sqrt(area) <= 0.5 * demand_.interpolation &&
          errors.quadrature[k] * area <= 0.5 * demand_.quadrature)
        return n;
    }
    return 0;
  }

  const Sector& sector_;
  std::size_t number_;
  const Smoothness& smoothness_;
  const CellDemand& demand_;
  std::vector<ObserverCell> cells_;
};

}  // namespace

std::vector<ObserverCell> observer_cells(const SectorScene& scene, std::span<const SectorElement> elements,
                                         const Smoothness& smoothness, const CellDemand& demand) {
  return parallel_reduce_ordered(
      elements.size(), 1, std::vector<ObserverCell>(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<ObserverCell> cells;
        for (std::size_t e = begin; e < end; ++e) {
          std::vector<ObserverCell> own = ElementCells(scene, elements[e], e, smoothness, demand).take();
          cells.insert(cells.end(), own.begin(), own.end());
        }
        return cells;
      },
      [](std::vector<ObserverCell> all, std::vector<ObserverCell> more) {
        all.insert(all.end(), more.begin(), more.end());
        return all;
      });
}

}  // namespace radcert
