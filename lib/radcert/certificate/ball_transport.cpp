// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/ball_transport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/certificate/gauss_rule.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/pack.h"

namespace radcert::certificate {

const WorkLimit most_source_parts("certificate/ball_transport: parts of elements for a group of points",
                                  4000000, 0, "no radius: the claim is not verified");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = 0x1p-53;
/// Of P - Q.
constexpr double difference_error = 0x1p-44;
constexpr int most_source_nodes = 12;
/// Degrees of certificates are at most 12.
constexpr std::size_t most_powers = 16;
constexpr double smallest_part = 0x1p-42;

/// A rule for one parameter of a part; nodes 0: none is good enough.
struct Rule {
  int nodes = 0;
  double error = infinity;
};

/// What one parameter of a part is to its rule.
struct PartLines {
  double distance = 0;  ///< of the points from the middles of the lines, at least
  double half = 0;      ///< |e|, at most
  double part = 1;      ///< half length relative to that of the element
  double jacobian = 0;  ///< (1-t) on the ellipse is at most 1 + jacobian A of its mean
};

double sum_of_axes(double axis) { return axis + std::sqrt(std::max(0.0, axis * axis - 1)); }

}  // namespace

BallTransport::BallTransport(const PolyhedronCertificate& certificate, const Scene& scene,
                             const Densities& densities, const LineBounds& lines)
    : certificate_(certificate), scene_(scene), densities_(densities), lines_(lines) {}

/// The sum over a group of points: parts that are far are summed for many points with one rule.
class BallTransport::Sum {
public:
  Sum(const BallTransport& transport, const Observers& observers, double tolerance)
      : certificate_(transport.certificate_),
        scene_(transport.scene_),
        densities_(transport.densities_),
        lines_(transport.lines_),
        observers_(observers),
        tolerance_(tolerance),
        stride_(densities_.stride()),
        row_(padded<double>(densities_.powers())),
        own_(scene_.triangles()[observers.triangle]),
        errors_(observers.s.size()),
        terms_(observers.s.size()),
        heights_(observers.s.size()),
        values_(observers.s.size() * stride_) {
    expects(densities_.powers() <= most_powers, "a degree below most_powers",
            named("powers", densities_.powers()));
    for (std::size_t p = 0; p < observers.s.size(); ++p)
      points_.push_back(own_.point(observers.s[p].value(), observers.t[p].value()));
  }

  /// All of it where no parts are named.
  void add_face(std::size_t face, std::span<const SourcePart> seen = {}) {
    const Scene::Heights& over = scene_.heights(observers_.triangle, face);
    highest_ = 0;
    height_error_ = 0;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const BoundedDouble height = over.at(observers_.s[p], observers_.t[p]);
      heights_[p] = height.value();
      highest_ = larger_bound(highest_, height.value() + height.error());
      height_error_ = larger_bound(height_error_, height.error());
    }
    std::vector<SourcePart> parts(seen.begin(), seen.end());
    if (parts.empty())
      for (const std::size_t e : lines_.elements_of(face)) {
        const Element& x = certificate_.elements[e];
        parts.push_back({e, {.s0 = x.s0, .s1 = x.s1, .t0 = x.t0, .t1 = x.t1}});
      }
    add(0, points_.size(), std::move(parts));
  }

  [[nodiscard]] Values take() && {
    Values out{.values = std::move(values_), .radii = {}};
    const double size = densities_.largest();
    for (std::size_t p = 0; p < points_.size(); ++p) {
      // Terms are not negative times a function, and sum to T 1 <= 1 and the errors at most.
      const double mass = 1 + errors_[p];
      out.radii.push_back((errors_[p] + mass * (density_error_ + (terms_[p] + 64) * unit * size)) * upward);
    }
    return out;
  }

private:
  void add(std::size_t begin, std::size_t end, std::vector<SourcePart> parts) {
    Vector<double> least = points_[begin];
    Vector<double> largest = least;
    for (std::size_t p = begin; p < end; ++p) {
      const Vector<double>& at = points_[p];
      least = {std::min(least.x, at.x), std::min(least.y, at.y), std::min(least.z, at.z)};
      largest = {std::max(largest.x, at.x), std::max(largest.y, at.y), std::max(largest.z, at.z)};
    }
    const Vector<double> centre = 0.5 * (least + largest);
    double radius = 0;
    for (std::size_t p = begin; p < end; ++p) radius = std::max(radius, norm(points_[p] - centre));
    radius += slack;
    std::vector<SourcePart> for_halves;
    while (!parts.empty()) {
      const SourcePart part = parts.back();
      parts.pop_back();
      const SideTriangle& triangle = lines_.triangle(part.element);
      const Box& box = part.box;
      const Element& whole = certificate_.elements[part.element];
      const Vector<double> start = triangle.inward - box.s0 * triangle.along;
      const Vector<double> finish = triangle.inward - box.s1 * triangle.along;
      const double s = box.middle_s();
      const double t = box.middle_t();
      const PartLines in_s{
          .distance =
              segment_distance(centre, triangle.point(s, box.t0), triangle.point(s, box.t1)) - radius - slack,
          .half = 0.5 * (box.s1 - box.s0) * (1 - box.t0) * triangle.length * upward,
          .part = (box.s1 - box.s0) / (whole.s1 - whole.s0) * upward};
      const PartLines in_t{
          .distance =
              segment_distance(centre, triangle.point(box.s0, t), triangle.point(box.s1, t)) - radius - slack,
          .half = 0.5 * (box.t1 - box.t0) * (std::max(norm(start), norm(finish)) + slack) * upward,
          .part = (box.t1 - box.t0) / (whole.t1 - whole.t0) * upward,
          .jacobian = 0.5 * (box.t1 - box.t0) / (1 - t) * upward};
      const double near = std::max(in_s.distance, in_t.distance);
      if (end - begin > 1 && radius > 0.25 * (near + radius)) {
        for_halves.push_back(part);
        continue;
      }
      const double area = triangle.jacobian * (box.s1 - box.s0) * (box.t1 - box.t0) * (1 - t) * upward;
      const double share =
          near > 0 ? std::min(1.0, area * std::min(1.0, highest_ / near) / (near * near)) : 1;
      const double allowed = tolerance_ * densities_.largest() *
                             std::max(0.25 * share, 0.1 / static_cast<double>(certificate_.elements.size()));
      const Rule rule_s = rule(in_s, area, part.element, true, allowed);
      const Rule rule_t = rule(in_t, area, part.element, false, allowed);
      if (rule_s.nodes > 0 && rule_t.nodes > 0) {
        const double r = std::max(in_s.distance - in_s.half, in_t.distance - in_t.half);
        // Of the weights' factor 1 - t, relative to it.
        const double last = t + 0.5 * (box.t1 - box.t0) * gauss_rule(rule_t.nodes).near_nodes.back();
        const double weight = 4 * unit / (1 - last);
        const double kernel = r >= 1024 * difference_error
                                  ? area * std::numbers::inv_pi * densities_.size(part.element) /
                                        (r * r * r) *
                                        (highest_ * (8 * difference_error / r + weight) + 2 * height_error_)
                                  : infinity;
        const double error = (rule_s.error + rule_t.error + kernel) * upward;
        for (std::size_t p = begin; p < end; ++p) errors_[p] += error;
        add_moments(part, rule_s.nodes, rule_t.nodes, begin, end);
        continue;
      }
      if (++cuts_ > most_parts_) {
        for (std::size_t p = begin; p < end; ++p) errors_[p] = infinity;
        break;
      }
      const bool cuts_s = rule_s.nodes == 0 && (rule_t.nodes > 0 || in_s.half >= in_t.half);
      if ((cuts_s ? box.s1 - box.s0 : box.t1 - box.t0) < smallest_part) {
        for (std::size_t p = begin; p < end; ++p) errors_[p] = infinity;
        continue;
      }
      SourcePart lower = part;
      SourcePart upper = part;
      if (cuts_s)
        lower.box.s1 = upper.box.s0 = s;
      else
        lower.box.t1 = upper.box.t0 = t;
      parts.push_back(lower);
      parts.push_back(upper);
    }
    contract(begin, end);
    if (for_halves.empty()) return;
    const std::size_t middle = begin + (end - begin) / 2;
    add(begin, middle, for_halves);
    add(middle, end, std::move(for_halves));
  }

  /// The least rule that is good enough.
  [[nodiscard]] Rule rule(const PartLines& line, double area, std::size_t element, bool in_s,
                          double allowed) const {
    Rule best;
    for (const double share : {0.45, 0.65, 0.8}) {
      const double a = share * line.distance;
      const double axis = a / line.half / upward;
      if (!(axis > 1.02)) continue;
      const double growth = sum_of_axes((1 + line.part * (axis - 1)) * upward) * upward;
      const double density = densities_.size(element, in_s ? growth : 1, in_s ? 1 : growth);
      const double gap = line.distance - a;
      const double kernel = (line.distance + a) * highest_ / (gap * gap * gap * gap);
      const double sum = sum_of_axes(axis) / upward;
      const double bound = 3 * area * std::numbers::inv_pi * kernel * (1 + line.jacobian * axis) * density /
                           (1 - 1 / (sum * sum)) * upward;
      if (!(bound < infinity)) continue;
      const double needed = bound > 0 ? std::log(bound / allowed) / (2 * std::log(sum)) : 1;
      if (!(needed <= most_source_nodes)) continue;
      const int nodes = std::max(1, static_cast<int>(std::ceil(needed)));
      const double error = bound * std::pow(sum, -2 * nodes) * upward;
      if (best.nodes == 0 || nodes < best.nodes || (nodes == best.nodes && error < best.error))
        best = {nodes, error};
    }
    return best;
  }

  /// Adds Int G P_i P_j over a part to the moments of its element, for points begin, ..., end - 1.
  /// Maths     along a line of nodes t = t_b Q moves by s (1 - t_b) along: Q - P and n_P.(Q-P) are affine in
  ///           s. m_i = sum_a W_a G P_i(x_a) on the line, then M_ij += sum_b W_b (1 - t_b) m_i P_j(y_b).
  ///           Lines of all points go side by side in the first sum, all j in the second
  void add_moments(const SourcePart& part, int nodes_s, int nodes_t, std::size_t begin, std::size_t end) {
    const std::size_t powers = densities_.powers();
    if (element_ != part.element) {
      contract(begin, end);
      element_ = part.element;
      moments_.assign((end - begin) * powers * row_, 0);
    }
    const Element& whole = certificate_.elements[part.element];
    const SideTriangle& triangle = lines_.triangle(part.element);
    const Box& box = part.box;
    const LegendreTable p_s = table(box.s0, box.s1, whole.s0, whole.s1, nodes_s);
    const LegendreTable p_t = table(box.t0, box.t1, whole.t0, whole.t1, nodes_t);
    density_error_ = larger_bound(density_error_, densities_.error(part.element, p_s, p_t));
    const GaussRule& rule_s = gauss_rule(nodes_s);
    const GaussRule& rule_t = gauss_rule(nodes_t);
    const double half_s = 0.5 * (box.s1 - box.s0);
    const double half_t = 0.5 * (box.t1 - box.t0);
    const double scale = triangle.jacobian * half_s * half_t * std::numbers::inv_pi;
    std::array<Vector<double>, most_source_nodes> starts;
    std::array<double, most_source_nodes> shrinkage{};
    std::array<double, static_cast<std::size_t>(most_source_nodes) * padded<double>(most_powers)> weighted{};
    const std::size_t lines = rule_t.near_nodes.size();
    for (std::size_t b = 0; b < lines; ++b) {
      const double t = box.middle_t() + half_t * rule_t.near_nodes[b];
      starts[b] = triangle.point(0, t);
      shrinkage[b] = 1 - t;
      const double weight = scale * (1 - t) * rule_t.near_weights[b];
      for (std::size_t j = 0; j < powers; ++j) weighted[b * row_ + j] = weight * p_t.values[b * powers + j];
    }
    const Vector<double>& n = scene_.normal(own_.face);
    const Vector<double>& along = triangle.along;
    const double rises = dot(n, along);
    const std::size_t all = (end - begin) * lines;
    const std::size_t room = padded<double>(all);
    on_lines_.resize(powers * room);
    std::array<double, Pack::lanes> x{};
    std::array<double, Pack::lanes> y{};
    std::array<double, Pack::lanes> z{};
    std::array<double, Pack::lanes> height{};
    std::array<double, Pack::lanes> shrinks{};
    std::array<Pack, most_powers> on_lines{};
    for (std::size_t first = 0; first < all; first += Pack::lanes) {
      // Beyond the last line there is nothing: a height of 0 at the same place.
      for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
        const std::size_t line = std::min(first + lane, all - 1);
        const std::size_t p = begin + line / lines;
        const Vector<double> way = starts[line % lines] - points_[p];
        x[lane] = way.x;
        y[lane] = way.y;
        z[lane] = way.z;
        height[lane] = first + lane < all ? heights_[p] : 0;
        shrinks[lane] = shrinkage[line % lines];
      }
      const Pack from_x = Pack::load(x.data());
      const Pack from_y = Pack::load(y.data());
      const Pack from_z = Pack::load(z.data());
      const Pack before = fma(from_x, Pack(n.x), fma(from_y, Pack(n.y), from_z * Pack(n.z)));
      const Pack behind = Pack::load(height.data());
      const Pack shrunk = Pack::load(shrinks.data());
      std::fill_n(on_lines.begin(), powers, Pack(0.0));
      for (std::size_t a = 0; a < rule_s.near_nodes.size(); ++a) {
        const Pack way = shrunk * Pack(box.middle_s() + half_s * rule_s.near_nodes[a]);
        const Pack dx = fma(way, Pack(along.x), from_x);
        const Pack dy = fma(way, Pack(along.y), from_y);
        const Pack dz = fma(way, Pack(along.z), from_z);
        const Pack squared = fma(dx, dx, fma(dy, dy, dz * dz));
        const Pack cosines = fma(way, Pack(rises), before) * behind;
        const Pack kernel = Pack(rule_s.near_weights[a]) * cosines / (squared * squared);
        for (std::size_t i = 0; i < powers; ++i)
          on_lines[i] = fma(kernel, Pack(p_s.values[a * powers + i]), on_lines[i]);
      }
      for (std::size_t i = 0; i < powers; ++i) on_lines[i].store(&on_lines_[i * room + first]);
    }
    for (std::size_t p = 0; p < end - begin; ++p)
      for (std::size_t i = 0; i < powers; ++i) {
        const double* const m = &on_lines_[i * room + p * lines];
        for (std::size_t j = 0; j < row_; j += Pack::lanes) {
          double* const to = &moments_[(p * powers + i) * row_ + j];
          Pack sum = Pack::load(to);
          for (std::size_t b = 0; b < lines; ++b)
            sum = fma(Pack(m[b]), Pack::load(&weighted[b * row_ + j]), sum);
          sum.store(to);
        }
      }
    const auto summed = static_cast<double>(rule_s.near_nodes.size() * lines + 4);
    for (std::size_t p = begin; p < end; ++p) terms_[p] += summed;
  }

  /// Adds sum c_ij M_ij of the element at hand to the values, and forgets its moments.
  void contract(std::size_t begin, std::size_t end) {
    if (!element_) return;
    const std::size_t powers = densities_.powers();
    const std::span<const double> w = densities_.w(*element_);
    for (std::size_t p = begin; p < end; ++p) {
      const double* const moments = &moments_[(p - begin) * powers * row_];
      for (std::size_t lane = 0; lane < stride_; lane += Pack::lanes) {
        Pack sum(0.0);
        for (std::size_t i = 0; i < powers; ++i)
          for (std::size_t j = 0; j < powers; ++j)
            sum = fma(Pack(moments[i * row_ + j]), Pack::load(w.data() + (i * powers + j) * stride_ + lane),
                      sum);
        double* const to = &values_[p * stride_ + lane];
        (Pack::load(to) + sum).store(to);
      }
      terms_[p] += static_cast<double>(powers * powers);
    }
    element_.reset();
  }

  [[nodiscard]] LegendreTable table(double from, double to, double whole_from, double whole_to,
                                    int nodes) const {
    // Both boxes are dyadic: these are exact, or rounded by far less than a node.
    const double middle = ((from - whole_from) - (whole_to - to)) / (whole_to - whole_from);
    const double half = (to - from) / (whole_to - whole_from);
    std::array<BoundedDouble, most_source_nodes> places;
    const std::vector<double>& rule = gauss_rule(nodes).near_nodes;
    for (std::size_t i = 0; i < rule.size(); ++i)
      places[i] =
          BoundedDouble(middle, 4 * unit) + BoundedDouble(half, 2 * unit) * BoundedDouble(rule[i], unit);
    return {densities_.degree(), std::span(places).first(rule.size())};
  }

  const PolyhedronCertificate& certificate_;
  const Scene& scene_;
  const Densities& densities_;
  const LineBounds& lines_;
  const Observers& observers_;
  double tolerance_;
  std::size_t stride_;
  std::size_t row_;  ///< of moments: the powers of t
  const SideTriangle& own_;
  std::vector<Vector<double>> points_;
  std::vector<double> errors_;  ///< by point
  std::vector<double> terms_;
  std::vector<double> heights_;  ///< over the plane of the face at hand
  double highest_ = 0;
  double height_error_ = 0;
  const std::size_t most_parts_ = most_source_parts.count();
  std::size_t cuts_ = 0;
  double density_error_ = 0;  ///< the largest on the elements so far
  std::vector<double> values_;
  std::optional<std::size_t> element_;  ///< whose moments are at hand
  std::vector<double> moments_;         ///< by point, i, j, a row of j padded
  std::vector<double> on_lines_;        ///< by i, point, line
};

BallTransport::Values BallTransport::operator()(const Observers& observers, double tolerance,
                                                std::optional<std::size_t> without, const View* view) const {
  Sum sum(*this, observers, tolerance);
  if (view != nullptr) {
    for (const View::OfFace& seen : view->faces)
      if (seen.face != without) sum.add_face(seen.face, seen.parts);
    return std::move(sum).take();
  }
  const std::size_t own = scene_.triangles()[observers.triangle].face;
  for (std::size_t face = 0; face < scene_.faces(); ++face)
    if (face != without && !scene_.coplanar(face, own)) sum.add_face(face);
  return std::move(sum).take();
}

}  // namespace radcert::certificate
