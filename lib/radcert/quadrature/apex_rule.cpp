// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/apex_rule.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "radcert/core/lazy_table.h"
#include "radcert/core/work_limit.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/quadrature/bernstein.h"
#include "radcert/quadrature/even_shape.h"

namespace radcert {
namespace {

/// Where the orders start for the finest tolerance, and for any; fewer where the chart changes evenly over
/// the whole element. Elsewhere rules of few points may agree on what both miss.
constexpr int first_order_at_finest = 6;
constexpr int smallest_first_order = 4;
constexpr int least_order_even = 3;
/// The largest number of points in a variable.
template <Real R>
constexpr int finest = std::is_same_v<R, double> ? 34 : 100;
constexpr int order_step_even = 3;
constexpr int order_step = 6;
/// The finer rule has this many points more in each variable. Where the chart is not analytic, or does not
/// change evenly, the rules converge so slowly that fewer leave an error larger than the difference.
constexpr int check_step_even = 1;
constexpr int check_step_analytic = 2;
constexpr int check_step_slow = 6;
/// The least Bernstein ellipse of an interval of m, and of one of the argument of sinh.
constexpr double admissible_ellipse = 3.0;
constexpr double admissible_ellipse_stretched = 1.9;
const WorkLimit deepest_bisection("quadrature/apex_rule: bisections of a side", 60, 0,
                                  "all that the element may hold joins the radius");
const WorkLimit deepest_halving("quadrature/apex_rule: halvings of a rectangle", 40, 0,
                                "all that the element may hold joins the radius");
const WorkLimit most_rectangles("quadrature/apex_rule: rectangles", 1000, 0,
                                "all that the element may hold joins the radius");

/// Points of [0,1] with their distances from both ends, free of cancellation; padded to whole blocks by zero
/// weights.
template <Real R>
struct Nodes {
  std::size_t count = 0;
  std::vector<R> from_zero;
  std::vector<R> from_one;
  std::vector<R> weights;
};

/// Gauss-Legendre on [0,1]; graded: x = B(y), B' = 51480 y^7 (1-y)^7, so that powers of the distance from
/// either end become eight times as smooth. 51480 = 1/Beta(8,8).
template <Real R>
Nodes<R> make_nodes(int points, bool graded) {
  const IntervalRule<R> gauss = gauss_rule<R>(graded ? 2 * points : points, IntervalWeight::one);
  // B(y) = y^8 sum_k C(7+k, 7) (1-y)^k, k = 0..7: the distribution function of Beta(8,8).
  const auto from_end = [](const R& y) {
    R sum = R(0);
    R term = R(1);
    for (int k = 0; k < 8; ++k) {
      sum += term;
      term = term * (R(1) - y) * R(8 + k) / R(k + 1);
    }
    return power(y, 8) * sum;
  };
  Nodes<R> nodes;
  for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
    const R& y = gauss.nodes[i];
    nodes.from_zero.push_back(graded ? from_end(y) : y);
    nodes.from_one.push_back(graded ? from_end(R(1) - y) : R(1) - y);
    nodes.weights.push_back(graded ? gauss.weights[i] * R(51480) * power(y * (R(1) - y), 7)
                                   : gauss.weights[i]);
  }
  nodes.count = nodes.weights.size();
  for (std::size_t i = nodes.count; i < padded<R>(nodes.count); ++i) {
    nodes.from_zero.push_back(nodes.from_zero.back());
    nodes.from_one.push_back(nodes.from_one.back());
    nodes.weights.push_back(R(0));
  }
  return nodes;
}

template <Real R>
const Nodes<R>& nodes(int points, bool graded) {
  constexpr std::size_t sizes = finest<R> + 1;
  constexpr int most_graded = std::is_same_v<R, double> ? 32 : 80;
  static LazyTable<Nodes<R>, 2 * sizes> tables;
  const int n = graded ? std::min(points, most_graded) : points;
  return tables.at((graded ? sizes : 0) + static_cast<std::size_t>(n),
                   [&] { return make_nodes<R>(n, graded); });
}

/// Both ends of [0,1] and its middle.
template <Real R>
const Nodes<R>& three_points() {
  static const Nodes<R> points{.count = 3,
                               .from_zero = {R(0), R(1) / R(2), R(1)},
                               .from_one = {R(1), R(1) / R(2), R(0)},
                               .weights = {R(1), R(1), R(1)}};
  return points;
}

/// Where the rays from the collocation point through the side (a, b) enter or leave the element.
enum class Extent {
  to_side,      ///< from p itself to the side: p lies in the element
  up_to_side,   ///< from another side to this one, the far one
  beyond_side,  ///< from this side, the near one, to another
};

/// What the rays from the collocation point through a side (a, b) meet of the element.
/// Maths     p + l ((1-m) (a-p) + m (b-p)), 0 <= m <= 1, l between 1 and cut(m), the place of the other
///           side's line on the ray: cut(m) = offset / ((1-m) slope_a + m slope_b); 0 where p lies in the
///           element
template <Real R>
struct ApexTriangle {
  ParameterPoint<R> to_a;  ///< a - p
  ParameterPoint<R> to_b;
  Barycentric<R> at_p;  ///< in the element's coordinates
  Barycentric<R> at_a;
  Barycentric<R> at_b;
  Extent extent = Extent::to_side;
  R offset{};   ///< n . (c - p) for the other side's line through c, normal to n
  R slope_a{};  ///< n . (a - p)
  R slope_b{};

  /// Twice its area in the parameter plane, that of the triangle (p, a, b).
  R size() const {
    using std::abs;
    return abs(cross(to_a, to_b));
  }
};

/// What runs along a side (a, b): m itself, or, stretched, x of m = foot + height sinh x.
/// Maths     |DF(p) w|^2 on the side is |DF(p) (b-a)|^2 ((m-foot)^2 + height^2), a multiple of cosh^2 x: of
///           its zeros, m = foot +- i height, those of cosh are left, x = +- i pi/2 and farther ones. The
///           ray's direction is w = w_c + (m-c) (b-a), c the point of [0,1] next to the foot
template <Real R>
class SideVariable {
public:
  SideVariable() = default;
  SideVariable(const Vector<R>& start, const Vector<R>& side, bool stretched) : stretched_(stretched) {
    const R squared = dot(side, side);
    foot_ = -dot(start, side) / squared;
    height_ = norm(cross(start, side)) / squared;
    reference_ = std::min(std::max(foot_, R(0)), R(1));
  }

  R first() const { return inverse(R(0)); }
  R last() const { return inverse(R(1)); }
  /// The place of the ray c, 0 <= c <= 1.
  const R& reference() const { return reference_; }
  /// m - c of a value of the variable.
  R from_reference(const R& x) const {
    using std::exp;
    if (!stretched_) return x - reference_;
    const R e = exp(x);
    return (foot_ - reference_) + height_ / R(2) * (e - R(1) / e);
  }
  /// dm/dx.
  R slope(const R& x) const {
    using std::exp;
    if (!stretched_) return R(1);
    const R e = exp(x);
    return height_ / R(2) * (e + R(1) / e);
  }
  /// The pole of a kernel, of positive imaginary part.
  std::complex<double> pole() const {
    if (stretched_) return {0, std::numbers::pi / 2};
    return {nearest_double<R>(foot_), nearest_double<R>(height_)};
  }
  /// The value that belongs to m.
  R inverse(const R& m) const {
    using std::abs;
    using std::log;
    using std::sqrt;
    if (!stretched_) return m;
    const R y = (m - foot_) / height_;
    const R size = abs(y);
    const R x = log(size + sqrt(R(1) + y * y));
    return y < R(0) ? R(-x) : x;
  }

private:
  bool stretched_ = false;
  R foot_{};
  R height_{};
  R reference_{};
};

/// A rectangle of the variables: l from 0 at the cut to 1 at the side, and that of the side.
template <Real R>
struct Rectangle {
  R l0, l1, x0, x1;
};

/// The numbers of points in both variables.
struct Orders {
  int radial;
  int across;
};

/// The points of a rule on a rectangle: w, barycentric coordinates, weights; padded to whole blocks.
template <Real R>
struct ApexPoints {
  std::vector<R> w_s, w_t, weight;
  std::array<std::vector<R>, 3> at;
  std::size_t count = 0;

  void resize(std::size_t points) {
    count = points;
    for (std::vector<R>* each : {&w_s, &w_t, &weight, &at[0], &at[1], &at[2]})
      each->resize(padded<R>(points));
  }
  void pad() {
    for (std::size_t i = count; i < weight.size(); ++i) {
      for (std::vector<R>* each : {&w_s, &w_t, &at[0], &at[1], &at[2]}) (*each)[i] = (*each)[count - 1];
      weight[i] = R(0);
    }
  }
};

template <Real R>
class ApexIntegrator {
public:
  ApexIntegrator(const CollocationPoint<R>& p, const Chart& chart, const ElementShape& shape,
                 const TriangleBasis<R>& basis, const Tolerance& tolerance)
      : p_(p),
        formula_(chart.in<B>()),
        basis_(basis),
        tolerance_(tolerance),
        shape_(shape),
        singular_(chart.facts().singular != SingularLine::none),
        even_(!singular_ && shape.unevenness < uneven_for_few_points),
        slow_(singular_),
        at_p_(chart.in<R>().frame(p.at.at)) {}

  CheckedSums<R> integrate(const ApexTriangle<R>& triangle) {
    CheckedSums<R> result(basis_.size());
    const ParameterPoint<R> along_side = triangle.to_b - triangle.to_a;
    side_ = SideVariable<R>(along(triangle.to_a), along(along_side), even_);
    integrate_sides(triangle, side_.first(), side_.last(), 0, result);
    return result;
  }

private:
  using B = typename Block<R>::Type;

  /// One value of the side's variable.
  struct Ray {
    ParameterPoint<R> w;  ///< to the side
    R weight;
    R cut;
    std::array<R, 3> at;  ///< barycentric coordinates on the side
  };

  /// Bisects the side until its Bernstein ellipse stays clear of the poles.
  void integrate_sides(const ApexTriangle<R>& triangle, const R& x0, const R& x1, int depth,
                       CheckedSums<R>& result) {
    const double rho = ellipse(triangle, x0, x1);
    if (!(rho >= (even_ ? admissible_ellipse_stretched : admissible_ellipse))) {
      if (depth >= deepest_bisection_) {
        result.complete = false;
        return;
      }
      const R middle = (x0 + x1) / R(2);
      integrate_sides(triangle, x0, middle, depth + 1, result);
      integrate_sides(triangle, middle, x1, depth + 1, result);
      return;
    }
    integrate_rectangle(triangle, {R(0), R(1), x0, x1}, rho, 0, result);
  }

  /// The smaller ellipse about [x0,x1] of those through the zeros of |DF(p) w|^2 and through the pole of the
  /// cut.
  double ellipse(const ApexTriangle<R>& triangle, const R& x0, const R& x1) const {
    const auto middle = nearest_double<R>((x0 + x1) / R(2));
    const auto half = nearest_double<R>((x1 - x0) / R(2));
    const double rho = bernstein_radius((side_.pole() - middle) / half);
    if (triangle.extent == Extent::to_side) return rho;
    const R change = triangle.slope_a - triangle.slope_b;
    if (change == R(0)) return rho;
    const auto pole_of_cut = nearest_double<R>(side_.inverse(triangle.slope_a / change));
    return std::min(rho, bernstein_radius({(pole_of_cut - middle) / half, 0}));
  }

  Vector<R> along(const ParameterPoint<R>& w) const { return w.s * at_p_.tangent_s + w.t * at_p_.tangent_t; }

  void integrate_rectangle(const ApexTriangle<R>& triangle, const Rectangle<R>& area, double rho, int depth,
                           CheckedSums<R>& result) {
    if (++rectangles_ > most_rectangles_) {
      result.complete = false;
      return;
    }
    Evenness evenness{shape_.turn, shape_.unevenness, shape_.unevenness};
    if (!even_) {
      evenness = evenness_of(triangle, area);
      if (evenness.largest() >= uneven_for_any_rule) {
        if (depth >= deepest_halving_) {
          result.complete = false;
          return;
        }
        for (const Rectangle<R>& half :
             evenness.along_l >= evenness.along_x ? halves_along_l(area) : halves_along_x(area))
          integrate_rectangle(triangle, half, rho, depth + 1, result);
        return;
      }
    }
    // Where a part of the element is steep, its neighbours are not yet smooth for a rule of few points.
    slow_ = slow_ || evenness.largest() >= uneven_for_close_rules;
    const Orders first = first_orders(evenness, rho);
    const int step = slow_ ? check_step_slow : even_ ? check_step_even : check_step_analytic;
    KernelSums<R> coarse = sums(triangle, area, first, false);
    Orders orders{first.radial + step, first.across + std::max(step, across_step(rho))};
    while (true) {
      CheckedSums<R> fine(sums(triangle, area, orders, true));
      if (compare(fine, coarse)) {
        result += fine;
        return;
      }
      // The next rule is finer in both variables, or the two would agree on what one of them leaves out.
      const int more = even_ ? order_step_even : order_step;
      if (std::max(orders.radial, orders.across) + more > finest<R>) {
        if (depth >= deepest_halving_) {
          result.complete = false;
          return;
        }
        for (const Rectangle<R>& half : halves(triangle, area, orders, fine.sums))
          integrate_rectangle(triangle, half, rho, depth + 1, result);
        return;
      }
      coarse = fine.sums;
      orders = {orders.radial + more, orders.across + more};
    }
  }

  /// How the chart's normal changes over a rectangle.
  struct Evenness {
    double turn;     ///< the largest change, relative to the largest normal
    double along_l;  ///< unevenness
    double along_x;
    [[nodiscard]] double largest() const { return std::max(along_l, along_x); }
  };

  /// The orders that the error model asks for. Along a ray the chord's square has zeros where the chart has
  /// turned by about i: the normal turns by `turn` over the element, rho is taken as 16/turn; a part of
  /// the normal that grows quadratically, by 4 unevenness, asks for 4/sqrt(unevenness).
  Orders first_orders(const Evenness& evenness, double rho) const {
    constexpr int last = finest<R> - check_step_slow;
    const int across = points_for(rho, basis_.degree(), tolerance_.intended_truncation());
    if (!even_) return {first_order(tolerance_), std::clamp(across, smallest_first_order, last)};
    constexpr double least_rate = 1.5;
    constexpr double largest_rate = 1e4;
    const double rate = std::clamp(
        std::min(16 / std::max(evenness.turn, 1e-4), 4 / std::sqrt(std::max(evenness.largest(), 1e-8))),
        least_rate, largest_rate);
    const int radial = points_for(rate, basis_.degree() + 1, tolerance_.intended_truncation());
    return {std::clamp(radial, least_order_even, last), std::clamp(across, least_order_even + 1, last)};
  }

  /// Along rays of an element over which the chart changes less evenly.
  static int first_order(const Tolerance& tolerance) {
    const double digits =
        std::log(tolerance.intended_truncation()) / std::log(Tolerance().intended_truncation());
    return std::max(smallest_first_order, static_cast<int>(std::ceil(digits * first_order_at_finest)));
  }

  static int across_step(double rho) {
    constexpr double steep = 5;
    return rho >= steep ? 1 : 2;
  }

  static std::array<Rectangle<R>, 2> halves_along_l(const Rectangle<R>& area) {
    const R l = (area.l0 + area.l1) / R(2);
    return {Rectangle<R>{area.l0, l, area.x0, area.x1}, Rectangle<R>{l, area.l1, area.x0, area.x1}};
  }
  static std::array<Rectangle<R>, 2> halves_along_x(const Rectangle<R>& area) {
    const R x = (area.x0 + area.x1) / R(2);
    return {Rectangle<R>{area.l0, area.l1, area.x0, x}, Rectangle<R>{area.l0, area.l1, x, area.x1}};
  }

  /// The normals at three times three points of a rectangle.
  Evenness evenness_of(const ApexTriangle<R>& triangle, const Rectangle<R>& area) {
    place(triangle, area, three_points<R>(), three_points<R>());
    std::array<Vector<R>, 9> normal;
    for (std::size_t at = 0; at < points_.weight.size(); at += Block<R>::lanes) {
      const Frame<B> frame = formula_.frame(parameters(at));
      for (std::size_t lane = 0; lane < Block<R>::lanes && at + lane < normal.size(); ++lane)
        normal[at + lane] = {Block<R>::lane(frame.area_normal.x, lane),
                             Block<R>::lane(frame.area_normal.y, lane),
                             Block<R>::lane(frame.area_normal.z, lane)};
    }
    R along_l = R(0);
    R along_x = R(0);
    R largest = R(0);
    R change = R(0);
    for (std::size_t k = 0; k < 3; ++k) {
      along_l = std::max(along_l, unevenness(normal[k], normal[3 + k], normal[6 + k]));
      along_x = std::max(along_x, unevenness(normal[3 * k], normal[3 * k + 1], normal[3 * k + 2]));
    }
    for (const Vector<R>& each : normal) {
      largest = std::max(largest, norm(each));
      change = std::max(change, norm(each - normal[4]));
    }
    const double turn = largest > R(0) ? 2 * nearest_double<R>(change / largest) : HUGE_VAL;
    return {turn, nearest_double<R>(along_l), nearest_double<R>(along_x)};
  }

  /// The rectangle cut across the variable in which fewer points cost more.
  std::array<Rectangle<R>, 2> halves(const ApexTriangle<R>& triangle, const Rectangle<R>& area,
                                     const Orders& orders, const KernelSums<R>& best) {
    const R by_l = largest_difference(sums(triangle, area, {orders.radial / 2, orders.across}, false), best);
    const R by_x = largest_difference(sums(triangle, area, {orders.radial, orders.across / 2}, false), best);
    return by_l > by_x ? halves_along_l(area) : halves_along_x(area);
  }

  static R largest_difference(const KernelSums<R>& a, const KernelSums<R>& b) {
    using std::abs;
    R largest = R(0);
    for (std::size_t j = 0; j < a.functions; ++j) largest = std::max(largest, abs(a.value[j] - b.value[j]));
    return largest;
  }

  /// Notes the differences; true if they are negligible beside what has been summed up so far.
  bool compare(CheckedSums<R>& fine, const KernelSums<R>& coarse) {
    using std::abs;
    R largest_difference = R(0);
    R noise = R(0);
    for (std::size_t j = 0; j < basis_.size(); ++j) {
      fine.difference[j] = abs(fine.sums.value[j] - coarse.value[j]);
      largest_difference = std::max(largest_difference, fine.difference[j]);
      largest_size_ = std::max(largest_size_, fine.sums.size[j]);
      noise = std::max(noise, R(4) * unit_roundoff<R>() * fine.sums.tilt[j]);
    }
    share_largest_difference(fine, R(tolerance_.intended_truncation()));
    return largest_difference <= R(tolerance_.converged()) * largest_size_ + noise;
  }

  /// Writes the points of a product rule on a rectangle.
  void place(const ApexTriangle<R>& triangle, const Rectangle<R>& area, const Nodes<R>& l_nodes,
             const Nodes<R>& x_nodes) {
    const R& c = side_.reference();
    const R other = R(1) - c;
    const ParameterPoint<R> w_c = other * triangle.to_a + c * triangle.to_b;
    const ParameterPoint<R> w_side = triangle.to_b - triangle.to_a;
    const R slope_c = other * triangle.slope_a + c * triangle.slope_b;
    const R slope_side = triangle.slope_b - triangle.slope_a;
    std::array<R, 3> at_c;
    std::array<R, 3> at_side;
    for (std::size_t i = 0; i < 3; ++i) {
      at_c[i] = other * triangle.at_a.x[i] + c * triangle.at_b.x[i];
      at_side[i] = triangle.at_b.x[i] - triangle.at_a.x[i];
    }
    const R jacobian = triangle.size() * (area.l1 - area.l0) * (area.x1 - area.x0);
    points_.resize(l_nodes.count * x_nodes.count);
    rays_.resize(x_nodes.count);
    for (std::size_t k = 0; k < x_nodes.count; ++k) {
      const R x = area.x0 + (area.x1 - area.x0) * x_nodes.from_zero[k];
      const R m = side_.from_reference(x);
      Ray& ray = rays_[k];
      ray = {w_c + m * w_side, x_nodes.weights[k] * side_.slope(x) * jacobian, R(0), {}};
      R slope = slope_c + m * slope_side;
      for (std::size_t j = 0; j < 3; ++j) ray.at[j] = at_c[j] + m * at_side[j];
      if (!even_) {  // m itself: by its distances from both ends
        const R from_end = (R(1) - area.x1) + (area.x1 - area.x0) * x_nodes.from_one[k];
        ray.w = from_end * triangle.to_a + x * triangle.to_b;
        slope = from_end * triangle.slope_a + x * triangle.slope_b;
        for (std::size_t j = 0; j < 3; ++j)
          ray.at[j] = from_end * triangle.at_a.x[j] + x * triangle.at_b.x[j];
      }
      if (triangle.extent != Extent::to_side) ray.cut = triangle.offset / slope;
    }
    std::size_t e = 0;
    for (std::size_t i = 0; i < l_nodes.count; ++i) {
      const R from_cut = area.l0 + (area.l1 - area.l0) * l_nodes.from_zero[i];
      const R from_side = (R(1) - area.l1) + (area.l1 - area.l0) * l_nodes.from_one[i];
      for (const Ray& ray : rays_) {
        const R rest_of_cut = R(1) - ray.cut;
        const R length = triangle.extent == Extent::beyond_side ? R(-rest_of_cut) : rest_of_cut;
        const R l = from_side * ray.cut + from_cut;
        const R rest = from_side * rest_of_cut;
        points_.w_s[e] = l * ray.w.s;
        points_.w_t[e] = l * ray.w.t;
        points_.weight[e] = l * length * l_nodes.weights[i] * ray.weight;
        for (std::size_t j = 0; j < 3; ++j) points_.at[j][e] = rest * triangle.at_p.x[j] + l * ray.at[j];
        ++e;
      }
    }
    points_.pad();
  }

  /// w at a block of points.
  ParameterPoint<B> step(std::size_t at) const {
    using std::max;
    ParameterPoint<B> w{Block<R>::load(&points_.w_s[at]), Block<R>::load(&points_.w_t[at])};
    if (singular_) w.s = max(w.s, B(-p_.at.at.s));  // rounding must not cross the line s = 0
    return w;
  }
  ParameterPoint<B> parameters(std::size_t at) const {
    return ParameterPoint<B>{B(p_.at.at.s), B(p_.at.at.t)} + step(at);
  }

  /// Without bounds only the values are summed up: enough for a rule that others are compared with.
  KernelSums<R> sums(const ApexTriangle<R>& triangle, const Rectangle<R>& area, const Orders& orders,
                     bool with_bounds) {
    const Nodes<R>& l_nodes = nodes<R>(orders.radial, singular_);
    const Nodes<R>& x_nodes = nodes<R>(orders.across, singular_);
    place(triangle, area, l_nodes, x_nodes);
    const ParameterPoint<B> at_p{B(p_.at.at.s), B(p_.at.at.t)};
    const Vector<B> normal_p{B(p_.normal.x), B(p_.normal.y), B(p_.normal.z)};
    KernelSumsByLane<R> by_lane(basis_.size());
    std::array<B, KernelSums<R>::most_functions> values;
    for (std::size_t at = 0; at < points_.weight.size(); at += Block<R>::lanes) {
      const ParameterPoint<B> w = step(at);
      const Frame<B> q = formula_.frame(at_p + w);
      const Chord<B> chord = formula_.chord(at_p, w);
      const B weight = Block<R>::load(&points_.weight[at]);
      Barycentric<B> x;
      for (std::size_t j = 0; j < 3; ++j) x.x[j] = Block<R>::load(&points_.at[j][at]);
      basis_.values(x, std::span<B>(values));
      if (!with_bounds) {
        by_lane.add_values(weight * chord_kernel<B>(chord, normal_p, q.area_normal),
                           [&values](std::size_t j) -> const B& { return values[j]; });
        continue;
      }
      const RoundedKernel<B> g = rounded_kernel<B>(chord, normal_p, q.area_normal);
      by_lane.add(weight * g.value, weight * g.lean,
                  [&values](std::size_t j) -> const B& { return values[j]; });
    }
    return by_lane.sums(l_nodes.count + x_nodes.count);
  }

  const CollocationPoint<R>& p_;
  const ChartIn<B>& formula_;
  const TriangleBasis<R>& basis_;
  const Tolerance& tolerance_;
  ElementShape shape_;
  bool singular_;
  bool even_;  ///< whether the chart changes so evenly over the element that its parts need no look
  bool slow_;  ///< whether rules are compared at a greater distance
  Frame<R> at_p_;
  SideVariable<R> side_;
  ApexPoints<R> points_;
  std::vector<Ray> rays_;
  R largest_size_{};
  std::size_t rectangles_ = 0;
  const std::size_t most_rectangles_ = most_rectangles.count();
  const long deepest_bisection_ = deepest_bisection.value();
  const long deepest_halving_ = deepest_halving.value();
};

/// The lines of sight from p through the sides of the element.
template <Real R>
std::vector<ApexTriangle<R>> seen_from(const ParameterPoint<R>& p, const ElementPart<R>& element) {
  using std::abs;
  const auto& v = element.vertices;
  const R whole = cross(v[1] - v[0], v[2] - v[0]);
  // A triangle that thin is the rounding of a collocation point on the side's line: what it holds is below 16
  // u of the element's integral, and `rounding` allows for 60 u.
  const R negligible = R(16) * unit_roundoff<R>() * whole;
  Barycentric<R> at_p;
  std::array<R, 3> part;  // of side i: positive on its inner side
  std::size_t near_sides = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    part[i] = cross(v[i] - p, v[(i + 1) % 3] - p);
    if (part[i] < -negligible) ++near_sides;
    for (std::size_t c = 0; c < 3; ++c) at_p.x[c] += part[i] / whole * element.corners[(i + 2) % 3].x[c];
  }
  std::vector<ApexTriangle<R>> triangles;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    ApexTriangle<R> triangle{.to_a = v[i] - p,
                             .to_b = v[j] - p,
                             .at_p = at_p,
                             .at_a = element.corners[i],
                             .at_b = element.corners[j]};
    if (!(triangle.size() > negligible)) continue;
    const bool is_near = part[i] < R(0);
    if (near_sides == 1 && is_near) continue;   // the rays through the two far sides start at it
    if (near_sides == 2 && !is_near) continue;  // the rays through the two near sides end at it
    if (near_sides != 0) {
      std::size_t other = 0;  // the only side of the other kind
      for (std::size_t k = 0; k < 3; ++k)
        if ((part[k] < -negligible) != is_near && abs(part[k]) > negligible) other = k;
      const ParameterPoint<R> along = v[(other + 1) % 3] - v[other];
      triangle.extent = is_near ? Extent::beyond_side : Extent::up_to_side;
      triangle.offset = part[other];
      triangle.slope_a = cross(triangle.to_a, along);
      triangle.slope_b = cross(triangle.to_b, along);
    }
    triangles.push_back(triangle);
  }
  // The largest first: it sets the scale at which the others count as converged.
  std::sort(triangles.begin(), triangles.end(),
            [](const ApexTriangle<R>& a, const ApexTriangle<R>& b) { return a.size() > b.size(); });
  return triangles;
}

}  // namespace

template <Real R>
CheckedSums<R> integrate_around(const CollocationPoint<R>& p, const Chart& chart,
                                const ElementPart<R>& element, const ElementShape& shape,
                                const TriangleBasis<R>& basis, const Tolerance& tolerance) {
  ApexIntegrator<R> integrator(p, chart, shape, basis, tolerance);
  CheckedSums<R> result(basis.size());
  for (const ApexTriangle<R>& triangle : seen_from(p.at.at, element))
    result += integrator.integrate(triangle);
  return result;
}

template CheckedSums<double> integrate_around<double>(const CollocationPoint<double>&, const Chart&,
                                                      const ElementPart<double>&, const ElementShape&,
                                                      const TriangleBasis<double>&, const Tolerance&);
template CheckedSums<Mpfr<50>> integrate_around<Mpfr<50>>(const CollocationPoint<Mpfr<50>>&, const Chart&,
                                                          const ElementPart<Mpfr<50>>&, const ElementShape&,
                                                          const TriangleBasis<Mpfr<50>>&, const Tolerance&);

}  // namespace radcert
