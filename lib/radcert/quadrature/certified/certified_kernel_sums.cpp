// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/certified/certified_kernel_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/work_limit.h"
#include "radcert/geometry/plane_polygon.h"
#include "radcert/quadrature/certified/disk_bound.h"
#include "radcert/quadrature/certified/integral_from_within.h"
#include "radcert/quadrature/certified/kernel_disk.h"
#include "radcert/quadrature/certified/kernel_rule.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// More than the roundings of any bound below: each takes fewer than 2^12 operations on positive numbers.
constexpr double up = 1 + 0x1p-40;
constexpr double down = 1 - 0x1p-40;
/// Of the balls: they are rounded to doubles in the end, and nothing cancels before.
constexpr long ball_bits = 64;

constexpr std::size_t order_count = GaussOrders::orders.size();
/// A point of another element's inside is resolved long before.
const WorkLimit deepest("quadrature/certified_kernel_sums: quarterings of an element", 16, 0,
                        "refused, with the point and the element");

/// The places of those ellipses for which there is a Taylor model of their own.
constexpr std::array<std::size_t, 5> modelled{0, 2, 5, 8, 10};

/// A triangle within an element by the barycentric coordinates of its corners, which are exact: whole numbers
/// over 2^depth.
struct SquarePart {
  std::array<Barycentric<double>, 3> corners{{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  int depth = 0;
};

Barycentric<double> midpoint(const Barycentric<double>& a, const Barycentric<double>& b) {
  return {{(a.x[0] + b.x[0]) / 2, (a.x[1] + b.x[1]) / 2, (a.x[2] + b.x[2]) / 2}};
}

std::array<SquarePart, 4> quarters(const SquarePart& cell) {
  const auto& [a, b, c] = cell.corners;
  const Barycentric<double> ab = midpoint(a, b);
  const Barycentric<double> bc = midpoint(b, c);
  const Barycentric<double> ca = midpoint(c, a);
  const int depth = cell.depth + 1;
  return {{{{{a, ab, ca}}, depth}, {{{ab, b, bc}}, depth}, {{{ca, bc, c}}, depth}, {{{ab, bc, ca}}, depth}}};
}

ElementCorners exact_corners(const ParameterTriangle& triangle) {
  ElementCorners corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = {Rational::exactly(triangle.vertices[i].s), Rational::exactly(triangle.vertices[i].t)};
  return corners;
}

/// A double that enters exactly.
template <Field R>
R exact_value(double value) {
  if constexpr (std::same_as<R, BoundedDouble>) {
    return BoundedDouble::exactly(value);
  } else {
    return R(value);
  }
}

/// The unit square onto a triangle within an element.
/// Maths     barycentric coordinates apex + x (first + y along), parameters their sum over the corners;
///           Jacobian x determinant
template <Field R>
struct SquareToElement {
  std::array<ParameterPoint<R>, 3> corners;
  std::array<R, 3> apex;
  std::array<R, 3> first;
  std::array<R, 3> along;
  R determinant;

  SquareToElement(const ElementCorners& element, const SquarePart& cell)
      : determinant(from_rational<R>(power(Rational(1, 4), cell.depth) *
                                     abs(cross(element[1] - element[0], element[2] - element[0])))) {
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = {from_rational<R>(element[i].s), from_rational<R>(element[i].t)};
      apex[i] = exact_value<R>(cell.corners[0].x[i]);
      first[i] = exact_value<R>(cell.corners[1].x[i] - cell.corners[0].x[i]);
      along[i] = exact_value<R>(cell.corners[2].x[i] - cell.corners[1].x[i]);
    }
  }

  Barycentric<R> barycentric(const R& x, const R& y) const {
    return {{apex[0] + x * (first[0] + y * along[0]), apex[1] + x * (first[1] + y * along[1]),
             apex[2] + x * (first[2] + y * along[2])}};
  }
  ParameterPoint<R> parameters(const Barycentric<R>& b) const {
    return b.x[0] * corners[0] + b.x[1] * corners[1] + b.x[2] * corners[2];
  }
};

/// From which distance on a rule will do.
struct Reach {
  double distance = infinity;
  double error = infinity;  ///< d^2 times the error of the integral, for every d that is not less
};

/// The points in doubles.
struct Points {
  std::vector<Vector<double>> position;
  std::vector<Vector<double>> normal;
  std::vector<ParameterPoint<double>> at;
  KernelRule::PointErrors errors;
};

Vector<BoundedDouble> bounded_vector(const Vector<Ball>& v) {
  return {bounded(v.x), bounded(v.y), bounded(v.z)};
}

/// False where a point is so far outside a triangle that rounding cannot matter.
bool may_contain(const std::array<ParameterPoint<double>, 3>& triangle, const ParameterPoint<double>& p) {
  const double area = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  constexpr double margin = 1e-6;
  for (std::size_t k = 0; k < 3; ++k) {
    const ParameterPoint<double> side = triangle[(k + 1) % 3] - triangle[k];
    const double beyond = cross(side, p - triangle[k]) / area;
    if (beyond < -margin) return false;
  }
  return true;
}

}  // namespace

class CertifiedKernelSums::Prepared {
public:
  Prepared(const Surface& surface, const Triangulation& triangulation, const ElementFunctions& functions,
           std::span<const SurfacePoint<Rational>> points, double demand)
      : surface_(surface),
        triangulation_(triangulation),
        functions_(functions),
        names_(points.begin(), points.end()),
        demand_(demand) {
    const BallPrecision precision(ball_bits);
    for (const Chart& chart : surface.charts) bounded_.emplace_back(chart);
    for (const SurfacePoint<Rational>& name : names_) {
      expects(name.chart < surface.chart_count(), "a chart of the surface", named("chart", name.chart));
      expects(in_domain(surface.charts[name.chart].facts().domain, name.at), "a point of its chart's domain",
              named("s", name.at.s), named("t", name.at.t));
      const Frame<Ball> frame = frame_of(name);
      const RoundedVector position = rounded(bounded_vector(frame.point));
      const RoundedVector normal = rounded(bounded_vector(unit_normal(frame)));
      points_.position.push_back(position.value);
      points_.normal.push_back(normal.value);
      points_.at.push_back({name.at.s.to_double(), name.at.t.to_double()});
      all_points_.push_back(static_cast<std::uint32_t>(all_points_.size()));
      points_.errors.position = larger_bound(points_.errors.position, position.error);
      points_.errors.normal = larger_bound(points_.errors.normal, normal.error);
    }
  }

  class Visit;

  void expects_place(std::size_t k, std::span<const std::uint32_t> points, std::size_t values,
                     std::size_t radii) const {
    const std::size_t places = points.size() * functions_.size();
    expects(k < triangulation_.triangles.size() && values == places && radii == places,
            "an element, and a place for each function and point", named("element", k),
            named("values", values), named("radii", radii));
    for (const std::uint32_t i : points)
      expects(i < names_.size(), "the number of a point", named("number", i), named("points", names_.size()));
  }
  const std::vector<std::uint32_t>& all_points() const { return all_points_; }

private:
  static bool in_domain(ChartDomain domain, const ParameterPoint<Rational>& at) {
    if (at.s.sign() < 0 || at.t.sign() < 0) return false;
    return domain == ChartDomain::unit_square ? at.s <= 1 && at.t <= 1 : at.s + at.t <= 1;
  }
  Frame<Ball> frame_of(const SurfacePoint<Rational>& name) const {
    return surface_.charts[name.chart].in<Ball>().frame({Ball(name.at.s), Ball(name.at.t)});
  }

  const Surface& surface_;
  const Triangulation& triangulation_;
  const ElementFunctions& functions_;
  std::vector<SurfacePoint<Rational>> names_;
  std::vector<std::uint32_t> all_points_;  ///< their numbers
  double demand_;
  GaussOrders gauss_;
  std::vector<BoundedChart> bounded_;  ///< by chart
  Points points_;
};

/// One element and some points, which are called here by their places among these.
class CertifiedKernelSums::Prepared::Visit {
public:
  Visit(const Prepared& all, std::size_t k, std::span<const std::uint32_t> points, std::span<double> values,
        std::span<double> radius)
      : all_(all),
        numbers_(points),
        functions_(all.functions_.size()),
        triangle_(all.triangulation_.triangles[k]),
        chart_(all.surface_.charts[triangle_.chart]),
        bounded_(all.bounded_[triangle_.chart]),
        corners_(exact_corners(triangle_)),
        values_(values),
        radius_(radius),
        function_values_(functions_),
        errors_(functions_),
        rule_(functions_),
        within_(chart_, bounded_, triangle_.chart, corners_, all.functions_, all.gauss_) {}

  Outcome<void> run() {
    const BallPrecision precision(ball_bits);
    std::fill(values_.begin(), values_.end(), 0.0);
    std::fill(radius_.begin(), radius_.end(), 0.0);
    std::vector<bool> in_plane;
    for (std::size_t chart = 0; chart < all_.surface_.chart_count(); ++chart)
      in_plane.push_back(in_same_plane(chart));
    std::vector<std::uint32_t> outside;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const SurfacePoint<Rational>& name = all_.names_[numbers_[i]];
      if (in_plane[name.chart]) continue;
      if (name.chart == triangle_.chart && may_contain(triangle_.vertices, all_.points_.at[numbers_[i]]) &&
          contains(corners_, name.at)) {
        if (Outcome<void> found = from_within(i); !found) return found;
        continue;
      }
      outside.push_back(static_cast<std::uint32_t>(i));
    }
    Outcome<void> found = from(SquarePart{}, outside);
    for (double& r : radius_) r *= up;
    return found;
  }

private:
  bool in_same_plane(std::size_t chart) const {
    return chart == triangle_.chart ? chart_.facts().flat_in().has_value()
                                    : in_one_plane(all_.surface_.charts[chart], chart_);
  }

  void add(std::size_t i, std::size_t j, double value, double error) {
    const std::size_t place = j * numbers_.size() + i;
    const bool known = std::isfinite(value) && error >= 0;
    values_[place] += known ? value : 0;
    radius_[place] += (known ? error : infinity) + unit * std::abs(values_[place]);
  }

  Outcome<void> from_within(std::size_t i) {
    const SurfacePoint<Rational>& name = all_.names_[numbers_[i]];
    const Vector<Ball> normal = unit_normal(all_.frame_of(name));
    Outcome<void> found = within_.integrals(
        name.at, normal, share * all_.demand_ / static_cast<double>(functions_), function_values_);
    if (!found) return found;
    for (std::size_t j = 0; j < functions_; ++j)
      add(i, j, function_values_[j].value(), function_values_[j].error());
    return {};
  }

  Outcome<void> from(const SquarePart& cell, std::span<const std::uint32_t> list) {
    if (list.empty()) return {};
    throw_if_interrupted();
    if (cell.depth > deepest.value()) {
      const SurfacePoint<Rational>& name = all_.names_[numbers_[list.front()]];
      return because(
          "the integral over an element of chart " + chart_.facts().name + " from the point (" +
          name.at.s.to_text() + ", " + name.at.t.to_text() + ") of chart " +
          all_.surface_.charts[name.chart].facts().name + " was not enclosed: " +
          (blocked_ != nullptr ? blocked_ : "the point is on or too near to the element's border"));
    }
    find_reaches(cell);
    std::vector<std::uint32_t> near;
    std::array<std::vector<std::uint32_t>, order_count> by_order;
    for (const std::uint32_t i : list) {
      const double d = distance(i);
      std::size_t m = 0;
      while (m < order_count && !(d >= reach_[m].distance)) ++m;
      (m < order_count ? by_order[m] : near).push_back(i);
    }
    // A rule's nodes cost as much as so many points of a rule.
    const double cost_of_nodes = bounded_.is_polynomial() ? 200 : 2000;
    for (std::size_t m = 0; m < order_count; ++m) {
      if (by_order[m].empty()) continue;
      std::size_t next = m + 1;
      while (next < order_count && by_order[next].empty()) ++next;
      if (next < order_count) {
        const double here = GaussOrders::orders[m] * GaussOrders::orders[m];
        const double there = GaussOrders::orders[next] * GaussOrders::orders[next];
        const auto count = static_cast<double>(by_order[m].size());
        if (count * there < (count + cost_of_nodes) * here) {
          by_order[next].insert(by_order[next].end(), by_order[m].begin(), by_order[m].end());
          continue;
        }
      }
      by_rule(cell, m, by_order[m]);
    }
    if (near.empty()) return {};
    for (const SquarePart& quarter : quarters(cell))
      if (Outcome<void> found = from(quarter, near); !found) return found;
    return {};
  }

  /// At most |c - P|.
  double distance(std::size_t i) const {
    const double computed = norm(all_.points_.position[numbers_[i]] - centre_);
    return (computed * (1 - 8 * unit) - all_.points_.errors.position) * down;
  }

  /// Adds the bounds for the ellipses after `from` and up to `to` from one model, over the disk around the
  /// last: for smaller disks the coefficients of z^i fall with the i-th power of the radius. False where
  /// there is none.
  bool add_disk_bounds(const SquareToElement<TaylorModel>& map, SquareAxis axis, std::size_t from,
                       std::size_t to, std::vector<DiskBound>& bounds, bool& has_centre) {
    const Disks disks = disks_around({}, axis, GaussOrders::ellipses[to]);
    const Barycentric<TaylorModel> b = map.barycentric(disks.x, disks.y);
    const ParameterPoint<TaylorModel> at = map.parameters(b);
    const Frame<TaylorModel> frame = chart_.in<TaylorModel>().frame(at);
    const TaylorModel jacobian = disks.x * map.determinant;
    const double area = jacobian.magnitude_bound() * upper_norm(frame.area_normal.x.magnitude_bound(),
                                                                frame.area_normal.y.magnitude_bound(),
                                                                frame.area_normal.z.magnitude_bound());
    const ElementPoint<TaylorModel> place{b, triangle_.chart, at, frame.point};
    const double of_functions = all_.functions_.bound(place);
    const double weight = area * of_functions * up;
    const double allowed = area * all_.functions_.allowed(place, of_functions) * up;
    const std::array<const TaylorModel*, 3> f{&frame.point.x, &frame.point.y, &frame.point.z};
    for (const TaylorModel* component : f)
      if (!component->is_finite()) {
        obstacle_ = component->failure().data();
        return false;
      }
    if (!std::isfinite(weight)) {
      obstacle_ = "the function beside the kernel is not shown to be analytic there";
      function_fails_ = true;
      return false;
    }
    if (!has_centre) {
      centre_ = {f[0]->centre().real, f[1]->centre().real, f[2]->centre().real};
      has_centre = true;
    }
    const KernelDisk disk(frame.point, centre_);
    const auto longest = [](std::size_t r) {
      return GaussOrders::ellipses[r] + 1 / GaussOrders::ellipses[r];
    };
    for (std::size_t r = from; r <= to; ++r) {
      const double smaller = r == to ? 1 : longest(r) / longest(to) * up;
      bounds.push_back({.ellipse = r,
                        .linear = disk.linear(smaller),
                        .rest = disk.rest(smaller),
                        .weight = weight,
                        .allowed = allowed});
    }
    return true;
  }

  /// d^2 times the error of the rule at the distance d, an upper bound.
  double scaled_error(std::size_t order, double d,
                      const std::array<std::vector<DiskBound>, 2>& bounds) const {
    double sum = 0;
    for (const std::vector<DiskBound>& side : bounds) {
      double least = infinity;
      for (const DiskBound& bound : side)
        least = std::min(least, all_.gauss_.factors[order][bound.ellipse] * bound.scaled(d) * up);
      sum += least;
    }
    return sum / 2 * up;
  }

  void find_reaches(const SquarePart& cell) {
    reach_.fill(Reach{});
    function_fails_ = false;
    const SquareToElement<TaylorModel> map(corners_, cell);
    std::array<std::vector<DiskBound>, 2> bounds;
    bool has_centre = false;
    for (const SquareAxis axis : {SquareAxis::x, SquareAxis::y}) {
      std::vector<DiskBound>& side = bounds[axis == SquareAxis::x ? 0 : 1];
      std::size_t next = 0;
      for (const std::size_t last : modelled) {
        if (!add_disk_bounds(map, axis, next, last, side, has_centre)) break;
        next = last + 1;
      }
      blocked_ = side.empty() || function_fails_ ? obstacle_ : nullptr;
      if (side.empty()) return;
    }
    // The first disks are little more than the cell: the integrand's weight there is about twice its area.
    const double smallest = std::max(bounds[0].front().linear, bounds[1].front().linear);
    const double allowance = share * all_.demand_ / static_cast<double>(functions_) *
                             std::min(bounds[0].front().allowed, bounds[1].front().allowed) / 2;
    constexpr double farthest = 1e4;
    double beyond = farthest * smallest;
    for (std::size_t m = 0; m < order_count; ++m) {
      if (!(scaled_error(m, beyond, bounds) <= allowance)) continue;
      double low = smallest / 4;
      double high = beyond;
      while (high > 1.02 * low) {
        const double middle = std::sqrt(low * high);
        (scaled_error(m, middle, bounds) <= allowance ? high : low) = middle;
      }
      reach_[m] = {high, scaled_error(m, high, bounds)};
      beyond = high;
    }
  }

  void sample(const SquarePart& cell, std::size_t m) {
    const GaussOrders::Rule& rule = all_.gauss_.rules[m];
    const SquareToElement<BoundedDouble> map(corners_, cell);
    rule_.begin(GaussOrders::orders[m]);
    for (std::size_t a = 0; a < rule.nodes.size(); ++a) {
      const BoundedDouble& x = rule.nodes[a];
      const BoundedDouble weight_x = rule.weights[a] * x * map.determinant;
      for (std::size_t b = 0; b < rule.nodes.size(); ++b) {
        const Barycentric<BoundedDouble> in_element = map.barycentric(x, rule.nodes[b]);
        const ParameterPoint<BoundedDouble> at = map.parameters(in_element);
        const Frame<BoundedDouble> frame = bounded_.frame(at);
        const BoundedDouble area = norm(frame.area_normal);
        all_.functions_.values({in_element, triangle_.chart, at, frame.point}, function_values_);
        const BoundedDouble weight = weight_x * rule.weights[b] * area;
        for (BoundedDouble& value : function_values_) value = weight * value;
        rule_.add(frame.point, (1 / area) * frame.area_normal, function_values_);
      }
    }
  }

  void by_rule(const SquarePart& cell, std::size_t m, std::span<const std::uint32_t> list) {
    sample(cell, m);
    KernelRule::Sums sums;
    KernelRule::Points points;
    for (std::size_t begin = 0; begin < list.size(); begin += Pack::lanes) {
      const std::size_t count = std::min(Pack::lanes, list.size() - begin);
      for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
        const std::size_t i = numbers_[list[begin + std::min(lane, count - 1)]];
        const Vector<double>& position = all_.points_.position[i];
        const Vector<double>& normal = all_.points_.normal[i];
        points.position.x.set_lane(lane, position.x);
        points.position.y.set_lane(lane, position.y);
        points.position.z.set_lane(lane, position.z);
        points.normal.x.set_lane(lane, normal.x);
        points.normal.y.set_lane(lane, normal.y);
        points.normal.z.set_lane(lane, normal.z);
      }
      rule_.take_sums(points, sums);
      for (std::size_t lane = 0; lane < count; ++lane) {
        const std::size_t i = list[begin + lane];
        const double d = distance(i);
        const double truncated = reach_[m].error / (d * d) * up;
        rule_.rounding(sums, lane, all_.points_.errors, errors_);
        for (std::size_t j = 0; j < functions_; ++j)
          add(i, j, sums.sum[j].lane(lane), truncated + errors_[j]);
      }
    }
  }

  /// Of the demand for one part of one integral, d^2 and the cell's weight divided out: the sum of weight /
  /// d^2 over a surface is of the size 2 pi log(1/h).
  static constexpr double share = 1.0 / 64;

  const Prepared& all_;
  std::span<const std::uint32_t> numbers_;
  std::size_t functions_;
  const ParameterTriangle& triangle_;
  const Chart& chart_;
  const BoundedChart& bounded_;
  ElementCorners corners_;
  std::span<double> values_;
  std::span<double> radius_;
  std::vector<BoundedDouble> function_values_;
  std::vector<double> errors_;
  std::array<Reach, order_count> reach_{};
  Vector<double> centre_;
  KernelRule rule_;
  IntegralFromWithin within_;
  const char* obstacle_ = nullptr;  ///< the last operation of which a model had no value
  const char* blocked_ = nullptr;   ///< the same where a cell had no bound at all, or none of a function
  bool function_fails_ = false;
};

CertifiedKernelSums::CertifiedKernelSums(const Surface& surface, const Triangulation& triangulation,
                                         const ElementFunctions& functions,
                                         std::span<const SurfacePoint<Rational>> points, double demand) {
  expects(surface.unoccluded, "an unoccluded surface", named("surface", surface.name));
  expects(functions.size() >= 1 && functions.size() <= KernelRule::most_functions, "from 1 to 45 functions",
          named("functions", functions.size()));
  expects(demand > 0 && std::isfinite(demand), "0 < demand", named("demand", demand));
  for (const ParameterTriangle& triangle : triangulation.triangles)
    expects(triangle.chart < surface.chart_count(), "a triangulation of the surface",
            named("chart", triangle.chart));
  prepared_ = std::make_unique<const Prepared>(surface, triangulation, functions, points, demand);
}

CertifiedKernelSums::CertifiedKernelSums(CertifiedKernelSums&&) noexcept = default;
CertifiedKernelSums& CertifiedKernelSums::operator=(CertifiedKernelSums&&) noexcept = default;
CertifiedKernelSums::~CertifiedKernelSums() = default;

Outcome<void> CertifiedKernelSums::element(std::size_t k, std::span<double> values,
                                           std::span<double> radius) const {
  return element(k, prepared_->all_points(), values, radius);
}

Outcome<void> CertifiedKernelSums::element(std::size_t k, std::span<const std::uint32_t> points,
                                           std::span<double> values, std::span<double> radius) const {
  prepared_->expects_place(k, points, values.size(), radius.size());
  return Prepared::Visit(*prepared_, k, points, values, radius).run();
}

}  // namespace radcert
