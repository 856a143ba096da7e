// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/smoothness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/continuous/elements/analytic_error.h"
#include "radcert/continuous/occlusion/penumbra.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// The larger half axes of the ellipses that are tried, in units of half the line.
constexpr std::array<double, 20> axes{1.02, 1.06, 1.12, 1.2, 1.35, 1.5, 1.75, 2,   2.5,  3.2,
                                      4.2,  5.6,  8,    12,  20,   40,  100,  400, 2000, 20000};

/// One number an ellipse.
using Bounds = std::array<double, axes.size()>;

Bounds product(const Bounds& a, const Bounds& b) {
  Bounds out{};
  for (std::size_t k = 0; k < axes.size(); ++k) out[k] = a[k] * b[k];
  return out;
}

/// What rules of n nodes make of a bound in an ellipse, by n - 1.
using FactorsByNodes = std::array<double, most_gauss_nodes>;

struct EllipseFactors {
  std::array<FactorsByNodes, axes.size()> interpolation;
  std::array<FactorsByNodes, axes.size()> quadrature;
};

const EllipseFactors& factors() {
  static const EllipseFactors table = [] {
    EllipseFactors made{};
    for (std::size_t k = 0; k < axes.size(); ++k)
      for (std::size_t n = 1; n <= most_gauss_nodes; ++n) {
        const double rho = axes[k] + std::sqrt(axes[k] * axes[k] - 1);
        made.interpolation[k][n - 1] = polynomial_error_factor(static_cast<int>(n), rho);
        made.quadrature[k][n - 1] = gauss_mean_error_factor(static_cast<int>(n), rho);
      }
    return made;
  }();
  return table;
}

/// The least bound times factor over the ellipses, for each rule.
FactorsByNodes least_products(const Bounds& bounds, const std::array<FactorsByNodes, axes.size()>& factors) {
  FactorsByNodes least;
  least.fill(infinity);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (!(bounds[k] < infinity)) continue;
    for (std::size_t n = 0; n < least.size(); ++n) {
      const double product = bounds[k] * factors[k][n];
      least[n] = product < least[n] ? product : least[n];
    }
  }
  for (double& error : least) error *= upward;
  return least;
}

/// What rules miss of a function within bounds.
/// Maths     density: bounds of w and the area element
RuleErrors rule_errors(const Bounds& bounds, const Bounds& density) {
  return {.interpolation = least_products(bounds, factors().interpolation),
          .quadrature = least_products(product(bounds, density), factors().quadrature)};
}

/// What rules miss where a part of the function, `rest` at most, is not within the bounds of `errors`.
void lower(RuleErrors& to, const RuleErrors& errors, double rest, double w_size) {
  for (std::size_t n = 0; n < most_gauss_nodes; ++n) {
    to.interpolation[n] = std::min(to.interpolation[n], (errors.interpolation[n] + rest) * upward);
    to.quadrature[n] = std::min(to.quadrature[n], (errors.quadrature[n] + 2 * w_size * rest) * upward);
  }
}

void add(RuleErrors& to, const RuleErrors& errors) {
  for (std::size_t n = 0; n < most_gauss_nodes; ++n) {
    to.interpolation[n] += errors.interpolation[n];
    to.quadrature[n] += errors.quadrature[n];
  }
}

/// Of a function within the bounds that is a polynomial of a degree below `exact`.
void add_interpolation(RuleErrors& errors, const Bounds& bounds, std::size_t exact) {
  const FactorsByNodes least = least_products(bounds, factors().interpolation);
  for (std::size_t n = 0; n < std::min(exact - 1, least.size()); ++n) errors.interpolation[n] += least[n];
}

void add_quadrature(RuleErrors& errors, const Bounds& bounds) {
  const FactorsByNodes least = least_products(bounds, factors().quadrature);
  for (std::size_t n = 0; n < least.size(); ++n) errors.quadrature[n] += least[n];
}

/// A bound of T_j w in an ellipse where Q slides, and of xi T_j 1.
double slid(double half, double reach, double axis, const SlidSizes& w, double xi) {
  const double part = slide_part(half, reach, axis);
  return slide_bound(part) * (w.at(part) + xi);
}

}  // namespace

/// The lines of a cell in one parameter.
struct Smoothness::Cell {
  std::size_t element = 0;
  SectorBox box;
  Vector<double> from;  ///< the middles of the lines run from here
  Vector<double> to;
  Vector<double> half_from;  ///< half of the line there, and at the other end
  Vector<double> half_to;
  double part = 0;         ///< half length relative to that of the element
  double mirror_part = 0;  ///< and to that of the mirror
  double jacobian_part = 0;
  bool along_edge = false;  ///< lines t = const
  double from_edge = 0;     ///< of lines s = const: the middle of t in units of half the line

  [[nodiscard]] Vector<double> middle() const { return 0.5 * (from + to); }
  [[nodiscard]] std::array<Vector<double>, 4> corners() const {
    return {from - half_from, from + half_from, to + half_to, to - half_to};
  }
  [[nodiscard]] double half_of_middles() const { return 0.5 * norm(to - from) * upward; }
  [[nodiscard]] double half(double slack) const {
    return std::max(norm(half_from), norm(half_to)) * upward + slack;
  }
};

Smoothness::Smoothness(const SectorScene& scene, std::span<const SectorElement> elements,
                       const SectorFunctions& w, const SectorFunctions& q, const EdgeClosure& closure)
    : scene_(scene),
      elements_(elements),
      closure_(closure),
      continuation_(scene, elements, w),
      panel_size_(scene.panels().size()),
      slid_size_(scene.panels().size()),
      turned_size_(scene.sectors().size()),
      sides_(scene.sectors().size() * scene.panels().size()) {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const std::size_t panel = scene.sectors()[elements[e].sector].panel;
    w_sizes_.push_back(polynomial_sizes(w, e, 0, w.count()));
    q_sizes_.push_back(polynomial_sizes(q, e, 0, q.count()));
    w_size_.push_back(size_in_ellipse(w_sizes_.back().by_s, 1));
    q_size_.push_back(size_in_ellipse(q_sizes_.back().by_s, 1));
    panel_size_[panel] = std::max(panel_size_[panel], w_size_.back());
    slid_size_[panel].include(w, e);
    size_ = std::max(size_, w_size_.back());
    largest_q_ = std::max(largest_q_, q_size_.back());
  }
  for (std::size_t i = 0; i < scene.sectors().size(); ++i) {
    const std::optional<std::size_t> opposite = scene.opposite(i);
    if (opposite) turned_size_[i] = panel_size_[scene.sectors()[*opposite].panel];
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const std::size_t other = elements[e].sector;
      const SectorBox& box = elements[e].box;
      if (other == opposite && box.t0 == 0)
        turned_size_[i] = std::max(turned_size_[i], size_around(w, e, turned_along, turned_across));
    }
    for (std::size_t j = 0; j < scene.panels().size(); ++j)
      if (scene.parallel(i, j)) sides_[i * scene.panels().size() + j] = sides_across(scene, elements, i, j);
  }
}

Smoothness::Cell Smoothness::across_t(std::size_t element, const SectorBox& box) const {
  const SectorElement& own = elements_[element];
  const Sector& sector = scene_.sectors()[own.sector];
  const Vector<double> side = 0.5 * (box.s1 - box.s0) * (sector.b - sector.a);
  Cell cell{.element = element,
            .box = box,
            .from = sector.point(box.middle_s(), box.t0),
            .to = sector.point(box.middle_s(), box.t1),
            .half_from = (1 - box.t0) * side,
            .half_to = (1 - box.t1) * side,
            .part = (box.s1 - box.s0) / (own.box.s1 - own.box.s0),
            .along_edge = true};
  if (const std::optional<std::size_t> mirror = closure_.mirror(element)) {
    const SectorBox& across = elements_[*mirror].box;
    cell.mirror_part = (box.s1 - box.s0) / (across.s1 - across.s0);
  }
  return cell;
}

Smoothness::Cell Smoothness::across_s(std::size_t element, const SectorBox& box) const {
  const SectorElement& own = elements_[element];
  const Sector& sector = scene_.sectors()[own.sector];
  const double half = 0.5 * (box.t1 - box.t0);
  return {.element = element,
          .box = box,
          .from = sector.point(box.s0, box.middle_t()),
          .to = sector.point(box.s1, box.middle_t()),
          .half_from = half * (sector.c - sector.point(box.s0, 0)),
          .half_to = half * (sector.c - sector.point(box.s1, 0)),
          .part = (box.t1 - box.t0) / (own.box.t1 - own.box.t0),
          .jacobian_part = half / (1 - box.middle_t()),
          .along_edge = false,
          .from_edge = box.middle_t() / half};
}

ObserverLines Smoothness::lines(const Cell& cell, std::size_t panel) const {
  const double slack = 4 * displacement * scene_.extent();
  const Vector<double>& n = scene_.normal(panel);
  const Sector& first = scene_.sectors()[scene_.first_sector(panel)];
  const double height_from = dot(n, cell.from - first.a);
  const double height_to = dot(n, cell.to - first.a);
  double radius = 0;
  double beside = -infinity;  // beyond a side of the panel, in its plane
  for (std::size_t s = scene_.first_sector(panel); s < scene_.first_sector(panel + 1); ++s) {
    radius = std::max(radius, norm(scene_.sectors()[s].a - first.c));
    beside = std::max(beside, std::min(scene_.beyond_side(s, cell.from), scene_.beyond_side(s, cell.to)));
  }
  const double to_panel =
      std::max(norm(cell.middle() - first.c) - cell.half_of_middles() - radius, beside) - slack;
  ObserverLines lines{
      .half = cell.half(slack),
      .distance = 0,
      .height = std::min(height_from, height_to) - slack,
      .highest = std::max(height_from, height_to) + slack,
      .turned = std::max(std::abs(dot(n, cell.half_from)), std::abs(dot(n, cell.half_to))) + slack,
      .mass = 1,
      .area = scene_.area(panel) * upward,
      .rings = scene_.before(scene_.sectors()[elements_[cell.element].sector].panel, panel)};
  lines.rings = lines.rings && !(to_panel > lines.highest || beside > slack);
  lines.distance = std::max(lines.height, to_panel);
  if (to_panel > 0)
    lines.mass = std::min(1.0, std::numbers::inv_pi * scene_.area(panel) *
                                   std::min(1.0, lines.highest / to_panel) / (to_panel * to_panel) * upward);
  return lines;
}

double Smoothness::reach_of_slide(const Cell& cell, std::span<const ElementSide> sides) const {
  return least_distance(cell.middle(), sides) / upward - cell.half_of_middles() -
         4 * displacement * scene_.extent();
}

/// How far Q may turn about the edge that the lines of a cell come from; 0: not at all.
/// Maths     r = d/(4 (1+q)), d the clearance of the points where the lines meet the edge, H the height of
///           the opposite sector, q the quotient of its longer leg and H. The parameters of Q are then off
///           those of x by at most 1/2 in x, since d is at most half the width of the element, and by 1 in y,
///           which is -1 at x, since d is at most the element's depth, over which the perpendicular to the
///           edge meets one of its sides: |P_i(x)| <= (3/2 + (5/4)^(1/2))^i,
///           |P_j(y)| <= (2 + 3^(1/2))^j
double Smoothness::reach_of_turn(const Cell& cell) const {
  const std::size_t sector = elements_[cell.element].sector;
  if (cell.along_edge || !scene_.opposite(sector)) return 0;
  const Sector& opposite = scene_.sectors()[*scene_.opposite(sector)];
  const double slack = 4 * displacement * scene_.extent();
  const double clearance = closure_.clearance(sector, cell.from - cell.from_edge * cell.half_from,
                                              cell.to - cell.from_edge * cell.half_to);
  const double height = opposite.jacobian / (norm(opposite.b - opposite.a) + slack) / upward;
  const double leg = std::max(norm(opposite.c - opposite.a), norm(opposite.c - opposite.b)) * upward + slack;
  return clearance / (4 * (1 + leg / height)) / upward;
}

/// What a cell sees of each panel.
std::vector<PanelView> Smoothness::seen_from(const Cell& cell) const {
  const std::size_t panels = scene_.panels().size();
  if (scene_.sight().is_open()) return std::vector<PanelView>(panels, PanelView::whole);
  const Sector& sector = scene_.sectors()[elements_[cell.element].sector];
  const std::array<Vector<double>, 4> hull = corners_of(sector, cell.box);
  std::vector<PanelView> views;
  for (std::size_t j = 0; j < panels; ++j) views.push_back(view_of_panel(scene_, sector.panel, hull, j));
  return views;
}

RuleErrors Smoothness::along(const Cell& cell, bool closed) const {
  const SectorElement& own = elements_[cell.element];
  const std::size_t panel = scene_.sectors()[own.sector].panel;
  const std::optional<std::size_t> opposite = scene_.opposite(own.sector);
  const auto of = [&](const PolynomialSizes& sizes) -> std::span<const double> {
    return cell.along_edge ? sizes.by_s : sizes.by_t;
  };
  const std::span<const double> w_sizes = of(w_sizes_[cell.element]);
  const std::span<const double> q_sizes = of(q_sizes_[cell.element]);
  Bounds density{};  // w and the area element
  Bounds moving_q{};
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const double rho = ellipse_around(cell.part, axes[k]);
    density[k] = size_in_ellipse(w_sizes, rho) * (1 + cell.jacobian_part * axes[k]);
    // What does not depend on the variable is met by any rule.
    moving_q[k] = size_in_ellipse(q_sizes, rho) - q_sizes[0];
  }
  RuleErrors errors;
  add_interpolation(errors, moving_q, q_sizes.size());
  const std::vector<PanelView> views = seen_from(cell);
  Bounds xi{};
  if (closed) {
    const std::span<const double> sizes = closure_.edge_sizes(*closure_.mirror(cell.element));
    Bounds moving_xi{};
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const double rho = cell.along_edge ? ellipse_around(cell.mirror_part, axes[k]) : 1;
      xi[k] = size_in_ellipse(sizes, rho);
      moving_xi[k] = cell.along_edge ? xi[k] - sizes[0] : 0;
    }
    add_interpolation(errors, moving_xi, sizes.size());
  } else if (std::find(views.begin(), views.end(), PanelView::partly) != views.end()) {
    // c (1 - F 1) of Penumbra, |c| <= sup |w|.
    xi.fill(size_);
  }
  add_quadrature(errors, product(xi, density));

  const double turn = reach_of_turn(cell);
  for (std::size_t j = 0; j < scene_.panels().size(); ++j) {
    if (j == panel || scene_.coplanar(j, panel)) continue;
    const bool beyond_edge = opposite && j == scene_.sectors()[*opposite].panel;
    if ((closed && beyond_edge) || views[j] == PanelView::none) continue;
    const ObserverLines seen = lines(cell, j);
    const bool is_whole = views[j] == PanelView::whole;
    const bool may_slide = is_whole && cell.along_edge && scene_.parallel(own.sector, j);
    const double slide =
        may_slide ? reach_of_slide(cell, sides_[own.sector * scene_.panels().size() + j]) : 0;
    Bounds bounds{};
    for (std::size_t k = 0; k < axes.size(); ++k) {
      bounds[k] = tube_bound(seen, axes[k]) * (panel_size_[j] + xi[k]);
      if (may_slide) bounds[k] = std::min(bounds[k], slid(seen.half, slide, axes[k], slid_size_[j], xi[k]));
      if (is_whole && beyond_edge && turn > 0 && axes[k] < cell.from_edge)
        bounds[k] = std::min(bounds[k], turn_bound(seen.half * (cell.from_edge + axes[k]), turn) *
                                            (turned_size_[own.sector] + xi[k]));
    }
    RuleErrors of_panel = rule_errors(bounds, density);
    if (may_slide && beyond_edge)
      for (const EdgeContinuation::Continued& continued : continuation_.beyond(cell.element)) {
        const double reach = reach_of_slide(cell, continued.sides);
        if (!(reach > slide)) continue;
        SlidSizes sizes = continued.sizes;
        sizes.include(slid_size_[j]);
        for (std::size_t k = 0; k < axes.size(); ++k)
          bounds[k] = slid(seen.half, reach, axes[k], sizes, xi[k]);
        lower(of_panel, rule_errors(bounds, density),
              continuation_.rest(continued, cell.element, cell.corners()), w_size_[cell.element]);
      }
    add(errors, of_panel);
  }
  return errors;
}

RuleErrors Smoothness::along_s(std::size_t element, const SectorBox& box, bool closed) const {
  return along(across_t(element, box), closed);
}

RuleErrors Smoothness::along_t(std::size_t element, const SectorBox& box, bool closed) const {
  return along(across_s(element, box), closed);
}

}  // namespace radcert
