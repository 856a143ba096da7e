// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/exchange_area.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/scalar/pack_functions.h"

namespace radcert {

namespace {

using Point = Vector<double>;

constexpr double rounding = 0x1p-52;

const WorkLimit deepest("factors/exchange_area: halvings of an edge", 60, 0,
                        "the difference of two rules goes into the radius");
const WorkLimit most_halvings("factors/exchange_area: halvings of an edge in all", 4096, 0,
                              "the difference of two rules goes into the radius");
const WorkLimit most_points("factors/exchange_area: points of a rule for far polygons", 12, 2,
                            "the rate of convergence reached goes into the radius");

// The rule on an edge: eight points fill a pack.
struct EdgeRule {
  EdgeRule() {
    const IntervalRule<double> rule = gauss_rule<double>(Pack::lanes, IntervalWeight::one);
    nodes = Pack::load(rule.nodes.data());
    weights = Pack::load(rule.weights.data());
  }
  Pack nodes;
  Pack weights;
};

const EdgeRule& edge_rule() {
  static const EdgeRule rule;
  return rule;
}

/// Int_0^1 I(s) ds for one pair of edges; the unit of length is near the largest distance. The inner integral
/// is that over b: of the difference of two antiderivatives rounding leaves an error over |b|, which the
/// longer edge keeps small.
class EdgePair {
public:
  EdgePair(const Point& difference, const Point& a, const Point& b)
      : length_(norm(b)),
        direction_((1 / length_) * b),
        difference_(difference),
        a_(a),
        forward_(dot(difference, direction_)),
        forward_a_(dot(a, direction_)),
        across_(cross(difference, direction_)),
        across_a_(cross(a, direction_)) {}

  [[nodiscard]] Approximation integral() {
    // At most three inner ends; those that are none stand at 1 and make empty parts.
    std::array<double, 5> ends{0, 1, 1, 1, 1};
    std::size_t count = 1;
    const auto part = [&](double s) {
      if (s > 0 && s < 1) ends[count] = s;
      ++count;
    };
    const double squared_a = dot(a_, a_);
    const auto beside_end_of_b = [&](Singularity& one, const Point& from_end) {
      one = {-dot(from_end, a_) / squared_a, norm(cross(from_end, a_)) / squared_a};
      part(one.foot);
    };
    beside_end_of_b(singular_[0], difference_);
    beside_end_of_b(singular_[1], difference_ - length_ * direction_);
    const double squared_across = dot(across_a_, across_a_);
    if (squared_across > 0) {
      const double foot = -dot(across_, across_a_) / squared_across;
      part(foot);
      // Beside b what both angles have there cancels.
      const double tau = -(forward_ + foot * forward_a_);
      if (tau < 0 && tau + length_ > 0)
        singular_[2] = {foot, norm(cross(across_, across_a_)) / squared_across};
    }
    for (std::size_t i = 1; i < 4; ++i)
      for (std::size_t k = i; k > 1 && ends[k] < ends[k - 1]; --k) std::swap(ends[k], ends[k - 1]);
    Approximation sum = Approximation::exact(0);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      if (ends[k] < ends[k + 1])
        sum += over(ends[k], ends[k + 1], by_rule(ends[k], ends[k + 1]), deepest.value());
    sum.radius += rounded();
    return sum;
  }

private:
  /// In the units of I, of which A F takes |a.b| / (4 pi): below what rounding leaves.
  static constexpr double tolerance = 0x1p-52;
  /// Halves of analytic cells are 2^16 times as accurate as the whole, those at a singular end s log s four
  /// times: a quarter of the difference is never less than their error by much, and cells are accepted early
  /// enough by sixteen times.
  static constexpr double acceptance = 16 * tolerance;

  /// I is singular at foot +- i height.
  struct Singularity {
    double foot = 0;
    double height = 0;
  };

  /// Whether two rules may agree on a cell by chance. A cell that is shorter than its distance from the
  /// singularities is resolved, and one that has them at an end, or as good as there, errs as s log s does.
  /// Between the two the difference changes its sign several times as the singularities move away. On cells
  /// shorter than 2^-17 s log s itself is below the acceptance.
  [[nodiscard]] bool may_agree_by_chance(double from, double to) const {
    const double length = to - from;
    if (length < 0x1p-17) return false;
    return std::any_of(singular_.begin(), singular_.end(), [&](const Singularity& one) {
      const double beside = std::max({from - one.foot, one.foot - to, 0.0});
      return one.height > 0x1p-10 * length && beside * beside + one.height * one.height < length * length;
    });
  }

  /// Of a rule on all of [0,1]: the logarithms and angles err by a few roundings, tau and rho by those of the
  /// unit of length.
  [[nodiscard]] double rounded() const { return 4 * rounding * (largest_ + 1) / length_; }

  Pack antiderivative(const Pack& tau, const Pack& rho) {
    const Pack square = max(tau * tau + rho * rho, Pack(0x1p-1000));
    const Pack value = tau * fast_log(square) + Pack(2) * rho * fast_atan2(tau, rho);
    largest_ = std::max(largest_, abs(value).largest());
    return value;
  }

  double by_rule(double from, double to) {
    const Pack s = Pack(from) + Pack(to - from) * edge_rule().nodes;
    const Pack x = Pack(across_.x) + s * Pack(across_a_.x);
    const Pack y = Pack(across_.y) + s * Pack(across_a_.y);
    const Pack z = Pack(across_.z) + s * Pack(across_a_.z);
    const Pack rho = max(sqrt(x * x + y * y + z * z), Pack(0x1p-500));
    const Pack tau = -(Pack(forward_) + s * Pack(forward_a_));
    const Pack inner = antiderivative(tau + Pack(length_), rho) - antiderivative(tau, rho);
    return (to - from) / length_ * (inner * edge_rule().weights).sum();
  }

  Approximation over(double from, double to, double whole, long depth) {
    const double middle = from + (to - from) / 2;
    const double low = by_rule(from, middle);
    const double high = by_rule(middle, to);
    const double difference = std::abs(low + high - whole);
    const bool counts = !may_agree_by_chance(from, to);
    if (counts && difference <= acceptance) return {low + high, difference / 4};
    // Two values that differ by no more than their roundings do not come nearer to each other: what the rules
    // differ by without rounding is at most four times a rule's.
    const double rounded_here = (to - from) * rounded();
    if (counts && difference <= 2 * rounded_here) return {low + high, rounded_here};
    // That a quarter will do is not known where the cells are not what the argument takes them for.
    if (depth == 0 || halvings_ == 0) return {low + high, difference};
    --halvings_;
    Approximation sum = over(from, middle, low, depth - 1);
    sum += over(middle, to, high, depth - 1);
    return sum;
  }

  double length_;
  Point direction_;
  Point difference_;
  Point a_;
  double forward_;
  double forward_a_;
  Point across_;
  Point across_a_;
  std::array<Singularity, 3> singular_{};
  double largest_ = 0;
  long halvings_ = most_halvings.value();
};

/// Points of a rule on a polygon, padded to whole packs by points of no weight.
struct PolygonPoints {
  std::vector<double> x, y, z, weight;
};

PolygonPoints points_on(const FacetCorners& polygon, int order) {
  static const std::vector<TriangleRule<double>> rules = [] {
    std::vector<TriangleRule<double>> all;
    for (int k = 1; k <= 12; ++k) all.push_back(conical_rule<double>(k, Grading::none));
    return all;
  }();
  const TriangleRule<double>& rule = rules[static_cast<std::size_t>(order - 1)];
  PolygonPoints points;
  const std::size_t count = padded<double>(rule.points.size() * (polygon.size() - 2));
  points.x.reserve(count);
  points.y.reserve(count);
  points.z.reserve(count);
  points.weight.reserve(count);
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Point& origin = polygon[0];
    const Point first = polygon[k] - origin;
    const Point second = polygon[k + 1] - origin;
    const double element = norm(cross(first, second));
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const auto& at = rule.points[i].x;
      points.x.push_back(origin.x + at[1] * first.x + at[2] * second.x);
      points.y.push_back(origin.y + at[1] * first.y + at[2] * second.y);
      points.z.push_back(origin.z + at[1] * first.z + at[2] * second.z);
      points.weight.push_back(element * rule.weights[i]);
    }
  }
  while (points.x.size() < count) {
    points.x.push_back(points.x.front());
    points.y.push_back(points.y.front());
    points.z.push_back(points.z.front());
    points.weight.push_back(0);
  }
  return points;
}

/// The order at which the bound of product rules is below rounding, and that bound relative to the value.
struct FarOrder {
  int order;
  double relative_error;
};

FarOrder far_order(double distance, double first, double second) {
  // A coordinate on one polygon ranges over at most its radius to both sides of its middle, and the kernel is
  // singular no nearer than the distance of the middles less the other radius: the Bernstein ellipse through
  // that point. A rule of n points errs by 64/15 M rho^(-2n) / (1 - rho^-2); its size M near the foci of a
  // smaller ellipse is some times the value.
  const double z = (distance - std::min(first, second)) / std::max(first, second);
  const double rho = z + std::sqrt(std::max(z * z - 1, 0.0));
  constexpr double growth = 16;
  constexpr double wanted = 0x1p-47;
  const auto most = static_cast<int>(most_points.value());
  int order = 2;
  double error = growth * std::pow(rho, -2.0 * order);
  while (error > wanted && order < most) error = growth * std::pow(rho, -2.0 * ++order);
  return {order, error};
}

Point unit_normal(const FacetCorners& polygon) {
  const Point area = vector_area(polygon);
  return (1 / norm(area)) * area;
}

}  // namespace

Roundness roundness(const FacetCorners& polygon) {
  Roundness out;
  for (const Point& p : polygon) out.centre = out.centre + (1.0 / static_cast<double>(polygon.size())) * p;
  for (const Point& p : polygon) out.radius = std::max(out.radius, norm(p - out.centre));
  return out;
}

Vector<double> vector_area(const FacetCorners& polygon) {
  Point sum;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    sum = sum + cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return 0.5 * sum;
}

Approximation exchange_area_by_contours(const FacetCorners& first, const FacetCorners& second) {
  expects(first.size() >= 3 && second.size() >= 3, "polygons have three corners or more",
          named("corners", std::min(first.size(), second.size())));
  double largest = 0;
  for (const Point& p : first)
    for (const Point& q : second) largest = std::max(largest, norm(p - q));
  // A power of two changes no digits.
  const double unit = std::exp2(std::ceil(std::log2(largest)));
  const auto along = [unit](const FacetCorners& polygon, std::size_t k) {
    return (1 / unit) * (polygon[(k + 1) % polygon.size()] - polygon[k]);
  };
  Approximation sum = Approximation::exact(0);
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t k = 0; k < second.size(); ++k) {
      const Point a = along(first, i);
      const Point b = along(second, k);
      const double product = dot(a, b);
      if (product == 0) continue;
      const Point difference = (1 / unit) * (first[i] - second[k]);
      const Approximation pair = dot(a, a) <= dot(b, b) ? EdgePair(difference, a, b).integral()
                                                        : EdgePair(-difference, b, a).integral();
      sum += {product * pair.value, std::abs(product) * pair.radius};
    }
  const double factor = unit * unit / (4 * std::numbers::pi);
  return {std::max(factor * sum.value, 0.0), factor * sum.radius};
}

Approximation exchange_area_by_rules(const FacetCorners& first, const FacetCorners& second) {
  const Roundness p = roundness(first);
  const Roundness q = roundness(second);
  const double distance = norm(p.centre - q.centre);
  expects(distance > p.radius + q.radius, "the polygons are far from each other",
          named("distance", distance));
  const FarOrder far = far_order(distance, p.radius, q.radius);
  const PolygonPoints from = points_on(first, far.order);
  const PolygonPoints to = points_on(second, far.order);
  const Point n = unit_normal(first);
  const Point m = unit_normal(second);
  const Vector<Pack> minus_normal_p{-n.x, -n.y, -n.z};
  const Vector<Pack> normal_q{m.x, m.y, m.z};
  Pack sum(0);
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    if (from.weight[i] == 0) continue;
    Pack inner(0);
    for (std::size_t k = 0; k < to.x.size(); k += Pack::lanes) {
      const Vector<Pack> difference{Pack(from.x[i]) - Pack::load(&to.x[k]),
                                    Pack(from.y[i]) - Pack::load(&to.y[k]),
                                    Pack(from.z[i]) - Pack::load(&to.z[k])};
      inner += Pack::load(&to.weight[k]) * kernel_terms<Pack>(difference, minus_normal_p, normal_q).value();
    }
    sum += Pack(from.weight[i]) * inner;
  }
  const double value = std::max(sum.sum() / std::numbers::pi, 0.0);
  // Near a plane of grazing both cosines cancel: the roundings are those of cosines of size one. A cross
  // product of differences up to 2 r errs by 32 units of r^2, of which a vector area takes half for each
  // triangle: of a sliver that is much, in the normal as in the weights.
  const auto relative = [](const FacetCorners& polygon, double radius, double area) {
    return static_cast<double>(polygon.size() - 2) * radius * radius / area;
  };
  const double first_area = norm(vector_area(first));
  const double second_area = norm(vector_area(second));
  const double largest_value = first_area * second_area / (std::numbers::pi * distance * distance);
  const double slivers = relative(first, p.radius, first_area) + relative(second, q.radius, second_area);
  return {value, value * far.relative_error + (8 + 16 * slivers) * rounding * largest_value};
}

Approximation exchange_area(const FacetCorners& first, const FacetCorners& second) {
  const Roundness p = roundness(first);
  const Roundness q = roundness(second);
  const bool far = norm(p.centre - q.centre) > far_ratio * (p.radius + q.radius);
  // Without a normal in doubles there are the contours.
  const auto is_plane = [](const FacetCorners& polygon, double radius) {
    return norm(vector_area(polygon)) > 0x1p-40 * radius * radius;
  };
  if (far && is_plane(first, p.radius) && is_plane(second, q.radius))
    return exchange_area_by_rules(first, second);
  return exchange_area_by_contours(first, second);
}

}  // namespace radcert
