// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/element_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "radcert/certificate/cell_supremum.h"
#include "radcert/certificate/gauss_rule.h"
#include "radcert/scalar/pack.h"

namespace radcert::certificate {

const WorkLimit most_checked_cells("certificate/element_check: cells of an element", 20000, 0,
                                   "parts that are not looked into: the claim is not verified");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = 0x1p-53;
constexpr int deepest = 120;

}  // namespace

/// A part of an element with its rule, and what that leaves.
struct ElementCheck::Cell {
  Box box;
  int nodes_s = 0;  ///< 0: not looked into
  int nodes_t = 0;
  std::optional<EdgeClosing> closing = std::nullopt;
  double norm_left = 0;         ///< sup-like: times |X|^(1/2)
  double product_left = 0;      ///< times |X| sup|w_k|
  double largest_left = 0;      ///< of sup |t_0|
  double least_mass = 0;        ///< of its view
  Shade shade = {};             ///< with half of kernels that are seen in part
  std::vector<Seen> seen = {};  ///< from the points of values
};

struct ElementCheck::Plan {
  std::vector<Cell> cells;
  double norm = 0;            ///< what cells leave of a norm, with what is not looked into
  double product = 0;         ///< and of a product
  std::vector<double> norms;  ///< the same by function
};

/// Cuts one element.
class ElementCheck::Cutter {
public:
  Cutter(const ElementCheck& check, std::size_t element, double norm, double product,
         const Allowance& allowance)
      : lines_(check.lines_),
        densities_(check.densities_),
        kernels_(check.kernels_),
        sight_(check.sight_),
        shades_(check.shades_),
        allowance_(allowance),
        elements_(check.certificate_.elements),
        element_(element),
        place_(check.lines_.triangle_place(element)),
        triangle_(check.lines_.triangle(element)),
        norm_(norm),
        product_(product),
        rho_(check.densities_.reflectivity(element)),
        density_(check.densities_.size_of_w(element)) {
    for (std::size_t k = 0; k < densities_.count(); ++k)
      residual_ = std::max(residual_, densities_.largest_of(k) + densities_.q_size_of(element, k));
    for (std::size_t k = 1; k < densities_.count(); ++k)
      shade_density_ = std::max(
          shade_density_, densities_.size_of(element, k) / room(allowance.product_room, k - 1) * upward);
    plan_.norms.resize(densities_.count());
    is_of_function_ = check.certificate_.of_function();
    has_closing_ = triangle_.beyond &&
                   sight_.face_each_other(triangle_.face, check.scene_.triangles()[*triangle_.beyond].face);
    least_nodes_ = densities_.degree() + 1;
    const Element& x = check.certificate_.elements[element];
    add({.s0 = x.s0, .s1 = x.s1, .t0 = x.t0, .t1 = x.t1}, 0);
  }
  [[nodiscard]] Plan take() && { return std::move(plan_); }

private:
  [[nodiscard]] double area(const Box& box) const {
    return triangle_.jacobian * (box.s1 - box.s0) * (box.t1 - box.t0) * (1 - box.middle_t()) * upward;
  }
  [[nodiscard]] double root(const Box& box) const { return std::sqrt(rho_ * area(box)) * upward; }

  [[nodiscard]] static double room(const std::vector<double>& rooms, std::size_t k) {
    return rooms.empty() ? 1 : rooms[k];
  }
  /// What shade leaves of a norm, relative to the room for it.
  [[nodiscard]] double of_norm(const Shade& shade) const {
    double most = 0;
    for (std::size_t k = 0; k < shade.radii.size(); ++k)
      most = std::max(most, shade.radii[k] / room(allowance_.norm_room, k));
    return most * upward;
  }
  [[nodiscard]] double of_product(const Shade& shade) const {
    return shade.radii.empty() ? 0 : shade_density_ * shade.radii[0] * upward;
  }
  [[nodiscard]] bool is_small(const Box& box, const Shade& shade) const {
    return root(box) * of_norm(shade) <= 0.5 * norm_ && area(box) * of_product(shade) <= 0.5 * product_ &&
           rho_ * shade.radii[0] <= 0.5 * allowance_.largest;
  }
  /// Shaded parts that send no more than this are not worth being halved.
  [[nodiscard]] double least_mass(const Box& box) const {
    constexpr double share = 0.005;
    const double size = densities_.largest();
    return std::min({1e-3, share * norm_ / (root(box) * size),
                     share * product_ / (area(box) * std::max(shade_density_, 1e-6) * size),
                     share * allowance_.largest / (rho_ * size)});
  }
  /// sup of all V j_k.
  [[nodiscard]] double largest_kernel(const Box& box, std::span<const Seen> seen) const {
    double most = 0;
    for (std::size_t k = 0; k < seen.size(); ++k)
      if (seen[k] != Seen::none) most = std::max(most, kernels_.size(k, place_, box));
    return most;
  }
  /// Counts with the shade how far V j_k may be from half of G/pi.
  void put_kernels(const Box& box, std::span<const Seen> seen, Shade& shade) const {
    for (std::size_t k = 0; k < seen.size(); ++k)
      if (seen[k] == Seen::partly) {
        double& radius = shade.radii[1 + k];
        radius = (radius + 0.5 * kernels_.size(k, place_, box)) * upward;
      }
  }
  /// xi of a closing takes the place of constants.
  [[nodiscard]] Shade shade_at_edge(const Box& box, const View& view, const EdgeClosing& closing) const {
    if (!closing.at) return shades_.at_edge(view.shaded, closing.element, 1 - box.s1, 1 - box.s0);
    const Element& beyond = elements_[closing.element];
    const double end = closing.at->value() < 0 ? beyond.s0 : beyond.s1;
    return shades_.at_edge(view.shaded, closing.element, end, end);
  }

  void accept(Cell cell) {
    const double by_rules = root(cell.box) * (cell.norm_left + of_norm(cell.shade));
    plan_.norm += by_rules * by_rules * upward;
    for (std::size_t k = 0; k < plan_.norms.size(); ++k) {
      const double own =
          root(cell.box) * (cell.norm_left + (cell.shade.radii.empty() ? 0 : cell.shade.radii[k])) * upward;
      plan_.norms[k] += own * own * upward;
    }
    cell.largest_left = (cell.largest_left + (cell.shade.radii.empty() ? 0 : cell.shade.radii[0])) * upward;
    plan_.product += area(cell.box) * (density_ * cell.product_left + of_product(cell.shade)) * upward;
    plan_.cells.push_back(std::move(cell));
  }

  [[nodiscard]] bool is_little(const Box& box, double sup, double part) const {
    return root(box) * sup <= part * norm_ && area(box) * density_ * sup <= part * product_ &&
           rho_ * sup <= part * allowance_.largest;
  }
  /// Whether nothing need be known of a box but the size of its residual.
  [[nodiscard]] bool is_negligible(const Box& box, double residual) const {
    return root(box) * residual <= norm_ && area(box) * density_ * residual <= product_ &&
           rho_ * residual <= allowance_.claim;
  }

  /// The least number of nodes that is enough in one parameter; 0 where there is none. What is left of
  /// largest values is larger by interpolation in the other one.
  [[nodiscard]] int nodes(const PolynomialErrors& left, const Box& box, bool in_s, double other = 1) const {
    for (int n = least_nodes_; n <= most_cell_nodes; ++n) {
      const double error = left[static_cast<std::size_t>(n - 1)];
      if (2 * error * root(box) <= 0.4 * norm_ &&
          2 * product_error(left, n, in_s) * area(box) * density_ <= 0.4 * product_ &&
          rho_ * other * (1 + interpolation_norm(n)) * error <= 0.4 * allowance_.largest)
        return n;
    }
    return 0;
  }
  [[nodiscard]] int nodes_t(const PolynomialErrors& left, const Box& box, int nodes_s) const {
    return nodes(left, box, false, interpolation_norm(nodes_s == 0 ? most_cell_nodes : nodes_s));
  }
  [[nodiscard]] double product_error(const PolynomialErrors& left, int n, bool in_s) const {
    const int exact = 2 * n - densities_.degree() - (in_s ? 0 : 1);
    return left[static_cast<std::size_t>(std::clamp(exact, 1, static_cast<int>(left.size())) - 1)];
  }

  /// A closing that leaves little. Of a function also one at the end of an element beyond: its norms are as
  /// good without.
  [[nodiscard]] std::optional<EdgeClosing> closing_of(const Box& box) const {
    std::optional<EdgeClosing> closing = lines_.closing(element_, box);
    if (closing && is_little(box, closing->beside, 0.5)) return closing;
    if (!is_of_function_) return std::nullopt;
    closing = lines_.closing_at_end(element_, box);
    if (closing && is_little(box, closing->beside - closing->jump, 0.5)) return closing;
    return std::nullopt;
  }
  [[nodiscard]] bool would_close_if_short(const Box& box) const {
    if (is_little(box, lines_.short_beside(element_, box), 0.5)) return true;
    if (!is_of_function_) return false;
    const std::optional<double> end = lines_.nearest_end(element_, box);
    if (!end || *end < box.s0 || *end > box.s1) return false;
    Box shorter = box;
    shorter.s0 = shorter.s1 = *end;
    const std::optional<EdgeClosing> closing = lines_.closing_at_end(element_, shorter);
    return closing && is_little(box, closing->beside - closing->jump, 0.5);
  }

  bool try_rules(const Box& box, const PolynomialErrors& in_s, const PolynomialErrors& in_t,
                 std::optional<EdgeClosing> closing, const Shade& shade, const std::vector<Seen>& seen) {
    const int of_s = nodes(in_s, box, true);
    const int of_t = nodes_t(in_t, box, of_s);
    if (of_s == 0 || of_t == 0) return false;
    const double beside = closing ? closing->beside : 0;
    const double e_s = in_s[static_cast<std::size_t>(of_s - 1)];
    const double e_t = in_t[static_cast<std::size_t>(of_t - 1)];
    accept({.box = box,
            .nodes_s = of_s,
            .nodes_t = of_t,
            .closing = std::move(closing),
            .norm_left = (2 * (e_s + e_t) + beside) * upward,
            .product_left =
                (2 * (product_error(in_s, of_s, true) + product_error(in_t, of_t, false)) + beside) * upward,
            .largest_left = ((1 + interpolation_norm(of_s)) * e_s +
                             interpolation_norm(of_s) * (1 + interpolation_norm(of_t)) * e_t + beside) *
                            upward,
            .least_mass = least_mass(box),
            .shade = shade,
            .seen = seen});
    return true;
  }

  /// What polynomials leave of T w, or of F, and of the kernels of points.
  [[nodiscard]] PolynomialErrors left(const Box& box, bool in_s, const EdgeClosing* closing, const View& view,
                                      const Shade& shade, std::span<const Seen> seen) const {
    PolynomialErrors out = lines_.left(element_, box, in_s, closing, &view, shade.largest_constant);
    if (kernels_.count() == 0) return out;
    const PolynomialErrors more = kernels_.left(place_, box, in_s, seen);
    for (std::size_t n = 0; n < out.size(); ++n) out[n] = (out[n] + more[n]) * upward;
    return out;
  }

  void add(const Box& box, int depth) {
    const std::vector<Seen> seen = kernels_.seen({element_, box});
    const double residual = (residual_ + largest_kernel(box, seen)) * upward;
    // At a vertex no smaller box has a smaller largest residual.
    const bool is_at_vertex = is_of_function_ && box.t0 == 0 && (box.s0 == 0 || box.s1 == 1);
    if (is_negligible(box, residual) || is_at_vertex || depth >= deepest ||
        plan_.cells.size() >= most_checked_cells.count()) {
      accept({.box = box, .norm_left = residual, .product_left = residual, .largest_left = residual});
      return;
    }
    const View view = sight_.view(place_, box, least_mass(box));
    const double length = (box.s1 - box.s0) * triangle_.length;
    const double height = (box.t1 - box.t0) * norm(triangle_.inward - box.middle_s() * triangle_.along);
    if (box.t0 == 0 && has_closing_) {
      bool cuts_s = false;
      std::optional<EdgeClosing> closing = closing_of(box);
      if (closing) {
        Shade shade = shade_at_edge(box, view, *closing);
        put_kernels(box, seen, shade);
        if (is_small(box, shade)) {
          const PolynomialErrors in_s = left(box, true, &*closing, view, shade, seen);
          const PolynomialErrors in_t = left(box, false, &*closing, view, shade, seen);
          if (try_rules(box, in_s, in_t, closing, shade, seen)) return;
          const int of_s = nodes(in_s, box, true);
          cuts_s = of_s == 0 && nodes_t(in_t, box, of_s) != 0;
        } else {
          cuts_s = length >= height;
        }
      } else {
        cuts_s = would_close_if_short(box);
      }
      cut(box, cuts_s, cuts_s ? box.middle_s() : box.t1 / 4, depth);
      return;
    }
    Shade shade = shades_.of(view.shaded);
    put_kernels(box, seen, shade);
    if (!is_small(box, shade)) {
      const bool cuts_s = length >= height;
      cut(box, cuts_s, cuts_s ? box.middle_s() : box.middle_t(), depth);
      return;
    }
    const PolynomialErrors in_s = left(box, true, nullptr, view, shade, seen);
    const PolynomialErrors in_t = left(box, false, nullptr, view, shade, seen);
    if (try_rules(box, in_s, in_t, std::nullopt, shade, seen)) return;
    // An edge whose sides have not the same ends, other than one between faces of one plane.
    if (box.t0 == 0 && !std::isfinite(in_t.back())) {
      cut(box, false, box.t1 / 4, depth);
      return;
    }
    const int of_s = nodes(in_s, box, true);
    const bool lacks_s = of_s == 0;
    const bool lacks_t = nodes_t(in_t, box, of_s) == 0;
    const bool cuts_s = lacks_s && (!lacks_t || length >= height);
    cut(box, cuts_s, cuts_s ? box.middle_s() : box.middle_t(), depth);
  }

  void cut(const Box& box, bool in_s, double at, int depth) {
    Box lower = box;
    Box upper = box;
    if (in_s)
      lower.s1 = upper.s0 = at;
    else
      lower.t1 = upper.t0 = at;
    add(lower, depth + 1);
    add(upper, depth + 1);
  }

  const LineBounds& lines_;
  const Densities& densities_;
  const PointKernels& kernels_;
  const Sight& sight_;
  const Shades& shades_;
  const Allowance& allowance_;
  const std::vector<Element>& elements_;
  std::size_t element_;
  std::size_t place_;  ///< of its triangle
  const SideTriangle& triangle_;
  double norm_;
  double product_;
  double rho_;
  double density_;
  double shade_density_ = 0;  ///< of products, relative to the room for them
  double residual_ = 0;
  bool has_closing_ = false;
  bool is_of_function_ = false;
  int least_nodes_ = 1;
  Plan plan_;
};

ElementCheck::ElementCheck(const PolyhedronCertificate& certificate, const Scene& scene,
                           const Densities& densities, const LineBounds& lines,
                           const BallTransport& transport, const PointKernels& kernels, const Sight& sight,
                           const Shades& shades)
    : certificate_(certificate),
      scene_(scene),
      densities_(densities),
      lines_(lines),
      transport_(transport),
      kernels_(kernels),
      sight_(sight),
      shades_(shades) {}

ElementCheck::Plan ElementCheck::plan(std::size_t element, const Allowance& allowance) const {
  Allowance share{allowance.norm / 10, allowance.product / 100};
  Plan best;
  // What shade leaves falls with the square root of a cell's share, or less.
  const int tries = sight_.is_open() ? 5 : 8;
  const double order = sight_.is_open() ? 1 : 2;
  for (int k = 0; k < tries; ++k) {
    Plan found = Cutter(*this, element, share.norm, share.product, allowance).take();
    found.norm = std::sqrt(found.norm);
    for (double& norm_of_k : found.norms) norm_of_k = std::sqrt(norm_of_k);
    const bool is_good = found.norm <= allowance.norm && found.product <= allowance.product;
    const double too_much = std::max(found.norm / allowance.norm, found.product / allowance.product);
    best = std::move(found);
    if (is_good || best.cells.size() >= most_checked_cells.count()) break;
    share.norm *= std::min(1.0, std::pow(0.7 * allowance.norm / best.norm, order));
    share.product *= std::min(1.0, std::pow(0.7 * allowance.product / best.product, order));
    if (!(too_much < infinity)) break;
  }
  return best;
}

void ElementCheck::add_cell(std::size_t element, const Cell& cell, const Allowance& allowance,
                            std::size_t cells, ResidualBounds& sums, std::vector<double>& squares) const {
  const std::size_t count = densities_.count();
  const Box& box = cell.box;
  const SideTriangle& triangle = lines_.triangle(element);
  const double area =
      triangle.jacobian * (box.s1 - box.s0) * (box.t1 - box.t0) * (1 - box.middle_t()) * upward;
  const double rho = densities_.reflectivity(element);
  const double of_product = cell.product_left + (cell.shade.radii.empty() ? 0 : cell.shade.radii[0]) * upward;
  for (std::size_t k = 1; k < count; ++k)
    sums.radii[k - 1] += area * densities_.size_of(element, k) * of_product * upward;
  if (cell.nodes_s == 0) {
    sums.largest = std::max(sums.largest, rho * cell.largest_left * upward);
    return;
  }

  const Element& whole = certificate_.elements[element];
  const GaussRule& rule_s = gauss_rule(cell.nodes_s);
  const GaussRule& rule_t = gauss_rule(cell.nodes_t);
  const double half_s = 0.5 * (box.s1 - box.s0);
  const double half_t = 0.5 * (box.t1 - box.t0);
  const auto place = [](double middle, double half, double x) {
    return BoundedDouble::exactly(middle) + BoundedDouble::exactly(half) * BoundedDouble(x, unit);
  };
  std::vector<BoundedDouble> at_s;
  std::vector<BoundedDouble> at_t;
  for (const double x : rule_s.near_nodes) at_s.push_back(place(box.middle_s(), half_s, x));
  for (const double x : rule_t.near_nodes) at_t.push_back(place(box.middle_t(), half_t, x));
  Observers observers{.triangle = lines_.triangle_place(element), .s = {}, .t = {}};
  for (const BoundedDouble& s : at_s)
    for (const BoundedDouble& t : at_t) {
      observers.s.push_back(s);
      observers.t.push_back(t);
    }
  const double size = densities_.largest();
  // Each cell alike, or each part of the element alike, whichever asks for less.
  const double density = densities_.size_of_w(element);
  const double all = triangle.jacobian * (whole.s1 - whole.s0) * (whole.t1 - whole.t0);
  const auto number = static_cast<double>(cells);
  const double by_cell = std::min(0.3 * allowance.norm / std::sqrt(number * rho * area),
                                  0.3 * allowance.product / (number * area * density));
  const double by_area =
      std::min(0.2 * allowance.norm / std::sqrt(rho * all), 0.2 * allowance.product / (all * density));
  const double of_largest =
      0.3 * allowance.largest / (rho * interpolation_norm(cell.nodes_s) * interpolation_norm(cell.nodes_t));
  const double tolerance = std::min({1e-3, std::max(by_cell, by_area) / size, of_largest / size});
  const std::optional<std::size_t> without =
      cell.closing ? std::optional<std::size_t>(cell.closing->face) : std::nullopt;
  const View view = sight_.view(observers.triangle, box, cell.least_mass);
  BallTransport::Values sent = transport_(observers, tolerance, without, &view);

  const auto within = [](double from, double to, const std::vector<BoundedDouble>& at) {
    std::vector<BoundedDouble> out;
    for (const BoundedDouble& x : at)
      out.push_back((BoundedDouble(2) * x - BoundedDouble::exactly(from) - BoundedDouble::exactly(to)) /
                    (BoundedDouble::exactly(to) - BoundedDouble::exactly(from)));
    return out;
  };
  const LegendreTable p_s(densities_.degree(), within(whole.s0, whole.s1, at_s));
  const LegendreTable p_t(densities_.degree(), within(whole.t0, whole.t1, at_t));
  const double off = densities_.error(element, p_s, p_t);
  const std::size_t stride = densities_.stride();
  const std::size_t powers = densities_.powers();
  std::vector<double> w(stride);
  std::vector<double> q(stride);
  std::vector<double> xi(stride);
  double xi_off = 0;
  double xi_size = 0;
  std::vector<double> edge_s;
  std::vector<double> edge_t;
  if (cell.closing) {
    const Element& beyond = certificate_.elements[cell.closing->element];
    std::vector<BoundedDouble> mirrored;
    for (const BoundedDouble& s : at_s) mirrored.push_back(BoundedDouble(1) - s);
    const std::vector<BoundedDouble> places = cell.closing->at
                                                  ? std::vector<BoundedDouble>(at_s.size(), *cell.closing->at)
                                                  : within(beyond.s0, beyond.s1, mirrored);
    const LegendreTable p_xi(densities_.degree(), places);
    const LegendreTable p_edge(densities_.degree(), std::vector<BoundedDouble>{BoundedDouble(-1)});
    xi_off = densities_.error(cell.closing->element, p_xi, p_edge);
    for (const double x : cell.closing->edge_sizes) xi_size += x;
    xi_size = xi_size * upward + xi_off;
    edge_s = p_xi.values;
    edge_t = p_edge.values;
  } else if (!cell.shade.constants.empty()) {
    std::copy(cell.shade.constants.begin(), cell.shade.constants.begin() + static_cast<std::ptrdiff_t>(count),
              xi.begin());
    xi_size = cell.shade.largest_constant * upward;
  }
  const bool has_xi = cell.closing || !cell.shade.constants.empty();
  std::vector<double> shifts = cell.shade.shifts;
  shifts.resize(count);
  for (const double shift : shifts) xi_size = std::max(xi_size, std::abs(shift));
  double q_size = 0;
  for (std::size_t k = 0; k < count; ++k) q_size = std::max(q_size, densities_.q_size_of(element, k));
  std::vector<double> terms(count);
  std::vector<double> products(count);
  std::vector<BoundedDouble> kernels(count);  // 0 for function 0, and of means
  std::vector<double> firsts;                 // t_0, of a function alone
  double firsts_off = 0;
  for (std::size_t i = 0; i < at_s.size(); ++i) {
    if (cell.closing)
      Densities::values(densities_.w(cell.closing->element), stride, &edge_s[i * powers], edge_t.data(),
                        powers, xi);
    for (std::size_t j = 0; j < at_t.size(); ++j) {
      const std::size_t p = i * at_t.size() + j;
      Densities::values(densities_.w(element), stride, &p_s.values[i * powers], &p_t.values[j * powers],
                        powers, w);
      Densities::values(densities_.q(element), stride, &p_s.values[i * powers], &p_t.values[j * powers],
                        powers, q);
      const double* const found = &sent.values[p * stride];
      // F = sum T_i w + xi (1 - sum T_i 1): radii of both, and of xi.
      const double rest = 1 - found[densities_.constant()];
      double radius = sent.radii[p] + off + 8 * unit * (size + q_size);
      if (has_xi)
        radius += xi_size * sent.radii[p] + xi_off * (std::abs(rest) + sent.radii[p]) + 8 * unit * xi_size;
      radius *= upward;
      const double weight = triangle.jacobian * half_s * half_t * (1 - at_t[j].value()) *
                            rule_s.near_weights[i] * rule_t.near_weights[j];
      const double weight_error = 64 * unit + 2 * at_t[j].error() / (1 - at_t[j].value());
      for (std::size_t k = 0; k < kernels_.count(); ++k) {
        if (cell.seen[k] == Seen::none) continue;
        const BoundedDouble whole_kernel = kernels_.at(k, observers.triangle, at_s[i], at_t[j]);
        kernels[1 + k] =
            cell.seen[k] == Seen::whole ? whole_kernel : BoundedDouble::exactly(0.5) * whole_kernel;
      }
      const auto t = [&](std::size_t k) {
        return found[k] + (has_xi ? xi[k] * rest : 0) + shifts[k] + (kernels[k].value() - q[k]);
      };
      const double first = t(0);
      if (certificate_.of_function()) {
        firsts.push_back(first);
        firsts_off = std::isfinite(radius) ? std::max(firsts_off, radius) : infinity;
      }
      for (std::size_t k = 0; k < count; ++k) {
        if (densities_.vanishes(k)) continue;
        const double of_kernel = kernels[k].error() + 4 * unit * std::abs(kernels[k].value());
        const double most = std::abs(t(k)) + radius + of_kernel;
        squares[k] += weight * (1 + weight_error) * rho * most * most * upward;
        if (k == 0) continue;
        products[k] += weight * w[k] * first;
        // Radii, and the rounding of the weight, the product and the sum.
        const double own = std::abs(w[k]) * radius + off * (std::abs(first) + radius) +
                           weight_error * std::abs(w[k]) * std::abs(first);
        sums.radii[k - 1] += weight * own * upward;
        terms[k] += weight * std::abs(w[k] * first);
      }
    }
  }
  if (certificate_.of_function()) {
    const double found = cell_supremum(firsts, firsts_off, cell.nodes_s, cell.nodes_t);
    sums.largest = std::max(sums.largest, rho * (found + cell.largest_left) * upward);
  }
  // Of a sum of as many terms.
  const double order = (static_cast<double>(at_s.size() * at_t.size()) + 16) * unit;
  for (std::size_t k = 1; k < count; ++k) {
    sums.products[k - 1] += products[k];
    sums.radii[k - 1] += terms[k] * order * upward;
  }
}

double ElementCheck::residual_inside(std::size_t element, double tolerance) const {
  constexpr int nodes = 4;
  const Element& whole = certificate_.elements[element];
  Observers observers{.triangle = lines_.triangle_place(element), .s = {}, .t = {}};
  std::vector<BoundedDouble> x;
  for (const double node : gauss_rule(nodes).near_nodes) x.push_back(BoundedDouble::exactly(node));
  const auto place = [](double from, double to, const BoundedDouble& at) {
    return BoundedDouble::exactly(0.5 * (from + to)) + BoundedDouble::exactly(0.5 * (to - from)) * at;
  };
  for (const BoundedDouble& s : x)
    for (const BoundedDouble& t : x) {
      observers.s.push_back(place(whole.s0, whole.s1, s));
      observers.t.push_back(place(whole.t0, whole.t1, t));
    }
  constexpr double least_mass = 1e-4;
  const View view = sight_.view(observers.triangle,
                                {.s0 = whole.s0, .s1 = whole.s1, .t0 = whole.t0, .t1 = whole.t1}, least_mass);
  const Shade shade = shades_.of(view.shaded);
  const double of_shade = std::abs(shade.constants[0]) + std::abs(shade.shifts[0]);
  const BallTransport::Values sent = transport_(observers, tolerance, std::nullopt, &view);
  const LegendreTable p(densities_.degree(), x);
  const double off = densities_.error(element, p, p);
  std::vector<double> q(densities_.stride());
  double most = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) {
      Densities::values(densities_.q(element), densities_.stride(), &p.values[i * densities_.powers()],
                        &p.values[j * densities_.powers()], densities_.powers(), q);
      const std::size_t at = i * x.size() + j;
      const double* const values = &sent.values[at * densities_.stride()];
      const double found =
          values[0] + shade.constants[0] * (1 - values[densities_.constant()]) + shade.shifts[0] - q[0];
      const double unknown =
          sent.radii[at] * (1 + std::abs(shade.constants[0])) + off + shade.radii[0] + 8 * unit * of_shade;
      most = std::max(most, (std::abs(found) - unknown) / upward);
    }
  return densities_.reflectivity(element) * most;
}

ResidualBounds ElementCheck::bounds(std::size_t element, const Allowance& allowance) const {
  const std::size_t count = densities_.count();
  ResidualBounds sums{.norms = std::vector<double>(count),
                      .products = std::vector<double>(count - 1),
                      .radii = std::vector<double>(count - 1),
                      .doubts = std::vector<double>(count)};
  const Plan found = plan(element, allowance);
  std::vector<double> squares(count);
  double most = 0;
  for (const Cell& cell : found.cells) {
    add_cell(element, cell, allowance, found.cells.size(), sums, squares);
    for (const double x : sums.products) most = std::max(most, std::abs(x));
  }
  // Of sums of as many terms.
  const double of_sums = 1 + (most_nodes * most_nodes * static_cast<double>(found.cells.size()) + 16) * unit;
  for (std::size_t k = 0; k < count; ++k)
    sums.norms[k] = densities_.vanishes(k) ? 0 : (std::sqrt(squares[k]) + found.norms[k]) * of_sums * upward;
  for (std::size_t k = 0; k < count; ++k) {
    const double room = allowance.norm_room.empty() ? 1 : allowance.norm_room[k];
    sums.doubts[k] = 3 * found.norms[k] + allowance.norm * room;
  }
  if (densities_.vanishes(0)) sums.largest = 0;
  // The order in which cells are summed.
  const double order = (static_cast<double>(found.cells.size()) + 16) * unit * most;
  for (double& radius : sums.radii) radius = (radius + order) * of_sums * upward;
  return sums;
}

}  // namespace radcert::certificate
