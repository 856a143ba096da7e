// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified_kernel_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/enclosure/gauss_legendre.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/scalar/pack.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// More than the roundings of any bound below: each takes fewer than 2^12 operations on positive numbers.
constexpr double up = 1 + 0x1p-40;
constexpr double down = 1 - 0x1p-40;
/// Of the balls: they are rounded to doubles in the end, and nothing cancels before.
constexpr long ball_bits = 64;

/// The orders of the product rules and the ellipses that bound their errors.
constexpr std::array<int, 12> orders{2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 17, 20};
constexpr std::array<double, 11> rhos{2, 3, 4, 5.5, 7.5, 10, 14, 20, 30, 50, 100};
/// The places of those for which there is a Taylor model of their own.
constexpr std::array<std::size_t, 5> modelled{0, 2, 5, 8, 10};

double upper_norm(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z) * up; }

/// A double and a bound of its distance from a number.
struct Rounded {
  double value;
  double error;
};

Rounded rounded(const Ball& x) {
  const double value = x.to_double();
  return {value, (unit * std::abs(value) + x.radius()) * up + std::numeric_limits<double>::min()};
}

struct RoundedVector {
  Vector<double> value;
  double error;  ///< of its length
};

RoundedVector rounded(const Vector<Ball>& v) {
  const Rounded x = rounded(v.x);
  const Rounded y = rounded(v.y);
  const Rounded z = rounded(v.z);
  return {{x.value, y.value, z.value}, upper_norm(x.error, y.error, z.error)};
}

template <Real R>
Vector<R> taken_into(const Vector<Ball>& v) {
  return {R(v.x), R(v.y), R(v.z)};
}

/// A triangle within an element by the barycentric coordinates of its corners, which are exact: whole numbers over 2^depth.
struct Cell {
  std::array<Barycentric<double>, 3> corners{{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  int depth = 0;
};

Barycentric<double> midpoint(const Barycentric<double>& a, const Barycentric<double>& b) {
  return {{(a.x[0] + b.x[0]) / 2, (a.x[1] + b.x[1]) / 2, (a.x[2] + b.x[2]) / 2}};
}

std::array<Cell, 4> quarters(const Cell& cell) {
  const auto& [a, b, c] = cell.corners;
  const Barycentric<double> ab = midpoint(a, b);
  const Barycentric<double> bc = midpoint(b, c);
  const Barycentric<double> ca = midpoint(c, a);
  const int depth = cell.depth + 1;
  return {{{{{a, ab, ca}}, depth}, {{{ab, b, bc}}, depth}, {{{ca, bc, c}}, depth}, {{{ab, bc, ca}}, depth}}};
}

using ExactCorners = std::array<ParameterPoint<Rational>, 3>;

ExactCorners exact_corners(const ParameterTriangle& triangle) {
  ExactCorners corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = {Rational::exactly(triangle.vertices[i].s), Rational::exactly(triangle.vertices[i].t)};
  return corners;
}

/// The unit square onto a triangle within an element.
/// Maths     barycentric coordinates apex + x (first + y along), parameters their sum over the corners; Jacobian x determinant
template <Real R>
struct SquareToElement {
  std::array<ParameterPoint<R>, 3> corners;
  std::array<R, 3> apex;
  std::array<R, 3> first;
  std::array<R, 3> along;
  R determinant;

  SquareToElement(const ExactCorners& element, const Cell& cell)
      : determinant(from_rational<R>(power(Rational(1, 4), cell.depth) *
                                     abs(cross(element[1] - element[0], element[2] - element[0])))) {
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = {from_rational<R>(element[i].s), from_rational<R>(element[i].t)};
      apex[i] = R(cell.corners[0].x[i]);
      first[i] = R(cell.corners[1].x[i] - cell.corners[0].x[i]);
      along[i] = R(cell.corners[2].x[i] - cell.corners[1].x[i]);
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

/// A Taylor model's variables over the disk around the ellipse of one side of a rectangle, and over the other side. The disks
/// are made larger than rounding.
struct Disks {
  TaylorModel x;
  TaylorModel y;
};

Disks disks_around(const SquareCell& cell, SquareAxis axis, double rho) {
  const auto side = [](double low, double high, double factor, bool complex) {
    const double half = (high - low) / 2;
    const double radius = half * factor * up + 0x1p-50 * (std::abs(low) + std::abs(high));
    const ComplexDouble centre{.real = low + half};
    return complex ? TaylorModel::variable_u(centre, radius) : TaylorModel::variable_v(centre, radius);
  };
  const double longest = (rho + 1 / rho) / 2;
  const bool in_x = axis == SquareAxis::x;
  return {side(cell.x_low, cell.x_high, in_x ? longest : 1, in_x),
          side(cell.y_low, cell.y_high, in_x ? 1 : longest, !in_x)};
}

/// What a Taylor model says of the integrand for all P that are far enough: see CertifiedKernelSums.
struct DiskBound {
  std::size_t rho;
  double linear;  ///< L
  double rest;    ///< E
  double weight;  ///< of |area normal| times Jacobian times max |f_j|

  /// d^2 times the bound of the integrand, infinity where there is none.
  double scaled(double d) const {
    const double nearest = (d - linear) * down;
    if (!(nearest > 0)) return infinity;
    const double farthest = (d + linear) * up;
    const double least = nearest * nearest * down - (2 * farthest * rest + rest * rest) * up;
    if (!(least > 0)) return infinity;
    const double ratio = (farthest + rest) * d / least;
    return ratio * ratio * weight * up;
  }
};

/// The factors of gauss_error_factor by order and ellipse, as doubles rounded up.
using ErrorFactors = std::array<std::array<double, rhos.size()>, orders.size()>;

ErrorFactors error_factors() {
  ErrorFactors factors{};
  for (std::size_t m = 0; m < orders.size(); ++m)
    for (std::size_t r = 0; r < rhos.size(); ++r)
      factors[m][r] = gauss_error_factor(orders[m], rhos[r]).upper_double();
  return factors;
}

/// From which distance on a rule will do.
struct Reach {
  double distance = infinity;
  double error = infinity;  ///< d^2 times the error of the integral, for every d that is not less
};

/// The points in doubles, padded to whole packs.
struct Points {
  std::vector<Vector<double>> position;
  std::vector<Vector<double>> normal;
  std::vector<ParameterPoint<double>> at;
  double position_error = 0;
  double normal_error = 0;
};

/// The nodes of a product rule on a cell, in doubles.
struct Samples {
  static constexpr std::size_t geometry = 6;
  int order = 0;
  std::vector<double> data;  ///< a node: position, unit normal, weight times area element times f_j for all j
  std::vector<double> mass;  ///< sum of the sizes of the last, for each j
  std::vector<double> mass_error;
  double position_error = 0;
  double normal_error = 0;
};

/// The points of one pack.
struct PackOfPoints {
  Vector<Pack> position;
  Vector<Pack> normal;
};

constexpr std::size_t most_functions = 45;

/// The sums of a rule for eight points.
struct PackSums {
  std::array<Pack, most_functions> sum;
  Pack nearest;   ///< least computed |Q - P|^2
  Pack cosine_p;  ///< largest computed ((Q - P).n_P)^2 / |Q - P|^2
  Pack cosine_q;
};

template <std::size_t Fixed>
[[gnu::always_inline]] inline void take_sums_of(const Samples& samples, std::size_t functions,
                                                const PackOfPoints& points, PackSums& result) {
  const std::size_t p = Fixed == 0 ? functions : Fixed;
  for (std::size_t j = 0; j < p; ++j) result.sum[j] = Pack(0);
  Pack nearest(std::numeric_limits<double>::max());
  Pack cosine_p(0);
  Pack cosine_q(0);
  std::array<Pack, Fixed == 0 ? most_functions : Fixed> row;
  const double* at = samples.data.data();
  for (int a = 0; a < samples.order; ++a) {
    for (std::size_t j = 0; j < p; ++j) row[j] = Pack(0);
    for (int b = 0; b < samples.order; ++b) {
      const Vector<Pack> d{Pack(at[0]) - points.position.x, Pack(at[1]) - points.position.y,
                           Pack(at[2]) - points.position.z};
      const Pack along_p = fma(d.x, points.normal.x, fma(d.y, points.normal.y, d.z * points.normal.z));
      const Pack along_q = fma(d.x, Pack(at[3]), fma(d.y, Pack(at[4]), d.z * Pack(at[5])));
      const Pack squared = fma(d.x, d.x, fma(d.y, d.y, d.z * d.z));
      const Pack inverse = Pack(1) / squared;
      const Pack scaled_p = along_p * inverse;
      const Pack scaled_q = along_q * inverse;
      const Pack kernel = -(scaled_p * scaled_q);
      nearest = min(nearest, squared);
      cosine_p = max(cosine_p, along_p * scaled_p);
      cosine_q = max(cosine_q, along_q * scaled_q);
      for (std::size_t j = 0; j < p; ++j) row[j] = fma(kernel, Pack(at[Samples::geometry + j]), row[j]);
      at += Samples::geometry + p;
    }
    for (std::size_t j = 0; j < p; ++j) result.sum[j] += row[j];
  }
  result.nearest = nearest;
  result.cosine_p = cosine_p;
  result.cosine_q = cosine_q;
}

void take_sums(const Samples& samples, std::size_t functions, const PackOfPoints& points, PackSums& result) {
  switch (functions) {
    case 1: return take_sums_of<1>(samples, functions, points, result);
    case 3: return take_sums_of<3>(samples, functions, points, result);
    case 6: return take_sums_of<6>(samples, functions, points, result);
    default: return take_sums_of<0>(samples, functions, points, result);
  }
}

/// What rounding does to the sums of a rule for one point.
/// Maths     d = Q - P with r = |d| >= least; the computed d is off by delta r, (Q-P).n by theta r, r^2 by 2 delta + 4 u of
///           itself. A product of kernel and weight then by at most weight / r^2 times
///             theta_P c_Q + theta_Q c_P + theta_P theta_Q + c_P c_Q (2 (relative error of r^2) + u (9 + additions)),
///           c_P, c_Q at least the exact and computed cosines; and what the weights themselves are off by times c_P c_Q / r^2
/// Source    Higham, Accuracy and Stability of Numerical Algorithms, 2002, 3.1; 3 u for a scalar product in space; a sum by
///           rows passes each term through 2 order additions
struct RoundingFactors {
  double of_mass;
  double of_mass_error;

  RoundingFactors(const Samples& samples, const Points& points, double nearest, double cosine_p,
                  double cosine_q) {
    const double displaced = (samples.position_error + points.position_error) * up;
    // The computed r is off by displaced, and by less than 4 u of itself.
    const double least = std::sqrt(nearest) * (1 - 8 * unit) - displaced;
    constexpr double small = 1e-4;  // so that products of errors are within the slack
    constexpr double slack = 1 + 8 * small;
    if (!(least > 0) || !(displaced < small * least)) {
      of_mass = of_mass_error = infinity;
      return;
    }
    const double delta = displaced / least * up + 2 * unit;
    const double theta_p = (delta + points.normal_error + 4 * unit) * slack;
    const double theta_q = (delta + samples.normal_error + 4 * unit) * slack;
    const double c_p = std::sqrt(cosine_p) * slack + theta_p;
    const double c_q = std::sqrt(cosine_q) * slack + theta_q;
    const double relative = 2 * (2 * delta + 4 * unit) + unit * (9 + 2 * samples.order);
    const double inverse = 1 / (least * least) * up;
    of_mass = (theta_p * c_q + theta_q * c_p + theta_p * theta_q + c_p * c_q * relative) * inverse * slack;
    of_mass_error = c_p * c_q * inverse * slack;
  }
};

/// Whether a point is in a triangle, its border included.
bool contains(const ExactCorners& triangle, const ParameterPoint<Rational>& p) {
  int sense = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int sign = cross(triangle[(k + 1) % 3] - triangle[k], p - triangle[k]).sign();
    if (sign == 0) continue;
    if (sense != 0 && sign != sense) return false;
    sense = sign;
  }
  return true;
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
        demand_(demand),
        factors_(error_factors()) {
    const BallPrecision precision(ball_bits);
    for (const SurfacePoint<Rational>& name : names_) {
      expects(name.chart < surface.chart_count(), "a chart of the surface", named("chart", name.chart));
      expects(in_domain(surface.charts[name.chart].facts().domain, name.at), "a point of its chart's domain",
              named("s", name.at.s), named("t", name.at.t));
      const Frame<Ball> frame = frame_of(name);
      const RoundedVector position = rounded(frame.point);
      const RoundedVector normal = rounded(unit_normal(frame));
      points_.position.push_back(position.value);
      points_.normal.push_back(normal.value);
      points_.at.push_back({name.at.s.to_double(), name.at.t.to_double()});
      points_.position_error = std::max(points_.position_error, position.error);
      points_.normal_error = std::max(points_.normal_error, normal.error);
    }
  }

  class Visit;

  void expects_place(std::size_t k, std::size_t values, std::size_t radii) const {
    const std::size_t places = names_.size() * functions_.size();
    expects(k < triangulation_.triangles.size() && values == places && radii == places,
            "an element, and a place for each function and point", named("element", k),
            named("values", values), named("radii", radii));
  }

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
  double demand_;
  ErrorFactors factors_;
  Points points_;
};

/// One element and all points.
class CertifiedKernelSums::Prepared::Visit {
public:
  Visit(const Prepared& all, std::size_t k, std::span<double> values, std::span<double> radius)
      : all_(all),
        functions_(all.functions_.size()),
        triangle_(all.triangulation_.triangles[k]),
        chart_(all.surface_.charts[triangle_.chart]),
        corners_(exact_corners(triangle_)),
        values_(values),
        radius_(radius),
        function_values_(functions_) {}

  std::string run() {
    std::fill(values_.begin(), values_.end(), 0.0);
    std::fill(radius_.begin(), radius_.end(), 0.0);
    std::vector<std::uint32_t> outside;
    for (std::size_t i = 0; i < all_.names_.size(); ++i) {
      const SurfacePoint<Rational>& name = all_.names_[i];
      if (in_same_plane(name.chart)) continue;
      if (name.chart == triangle_.chart && may_contain(triangle_.vertices, all_.points_.at[i]) &&
          contains(corners_, name.at)) {
        if (!around(i)) return why_;
        continue;
      }
      outside.push_back(static_cast<std::uint32_t>(i));
    }
    lists_.resize(deepest + 2);
    from(Cell{}, outside);
    for (double& r : radius_) r *= up;
    return why_;
  }

private:
  /// A point of another element's inside is resolved long before.
  static constexpr int deepest = 16;
  static constexpr int deepest_around = 24;

  bool in_same_plane(std::size_t chart) const {
    return chart == triangle_.chart ? chart_.facts().flat_in().has_value()
                                    : in_one_plane(all_.surface_.charts[chart], chart_);
  }

  void add(std::size_t i, std::size_t j, double value, double error) {
    const std::size_t place = j * all_.names_.size() + i;
    values_[place] += value;
    radius_[place] += error + unit * std::abs(values_[place]);
  }

  // ---- points outside the element ----

  void from(const Cell& cell, std::span<const std::uint32_t> list) {
    if (list.empty() || !why_.empty()) return;
    if (cell.depth > deepest) {
      const SurfacePoint<Rational>& name = all_.names_[list.front()];
      why_ = "the integral over an element of chart " + chart_.facts().name + " from the point (" +
             name.at.s.to_text() + ", " + name.at.t.to_text() + ") of chart " +
             all_.surface_.charts[name.chart].facts().name + " was not enclosed: " +
             (blocked_ != nullptr ? blocked_ : "the point is on or too near to the element's border");
      return;
    }
    find_reaches(cell);
    std::vector<std::uint32_t>& near = lists_[static_cast<std::size_t>(cell.depth)];
    near.clear();
    std::array<std::vector<std::uint32_t>, orders.size()> by_order;
    for (const std::uint32_t i : list) {
      const double d = distance(i);
      std::size_t m = 0;
      while (m < orders.size() && !(d >= reach_[m].distance)) ++m;
      (m < orders.size() ? by_order[m] : near).push_back(i);
    }
    // A rule's nodes in balls cost as much as so many points of a rule.
    constexpr double cost_of_samples = 2000;
    for (std::size_t m = 0; m < orders.size(); ++m) {
      if (by_order[m].empty()) continue;
      std::size_t next = m + 1;
      while (next < orders.size() && by_order[next].empty()) ++next;
      if (next < orders.size()) {
        const double here = orders[m] * orders[m];
        const double there = orders[next] * orders[next];
        const auto count = static_cast<double>(by_order[m].size());
        if (count * there < (count + cost_of_samples) * here) {
          by_order[next].insert(by_order[next].end(), by_order[m].begin(), by_order[m].end());
          continue;
        }
      }
      by_rule(cell, m, by_order[m]);
    }
    if (near.empty()) return;
    const std::vector<std::uint32_t> kept = near;
    for (const Cell& quarter : quarters(cell)) from(quarter, kept);
  }

  /// At most |c - P|.
  double distance(std::size_t i) const {
    const double computed = norm(all_.points_.position[i] - centre_);
    return (computed * (1 - 8 * unit) - all_.points_.position_error) * down;
  }

  /// Adds the bounds for the ellipses after `from` and up to `to` from one model, over the disk around the last: for smaller
  /// disks the coefficients of z^i fall with the i-th power of the radius. False where there is none.
  bool add_disk_bounds(const SquareToElement<TaylorModel>& map, SquareAxis axis, std::size_t from,
                       std::size_t to, std::vector<DiskBound>& bounds, bool& has_centre) {
    const Disks disks = disks_around({}, axis, rhos[to]);
    const Barycentric<TaylorModel> b = map.barycentric(disks.x, disks.y);
    const ParameterPoint<TaylorModel> at = map.parameters(b);
    const Frame<TaylorModel> frame = chart_.in<TaylorModel>().frame(at);
    const TaylorModel jacobian = disks.x * map.determinant;
    const double weight =
        jacobian.magnitude_bound() *
        upper_norm(frame.area_normal.x.magnitude_bound(), frame.area_normal.y.magnitude_bound(),
                   frame.area_normal.z.magnitude_bound()) *
        all_.functions_.bound({b, {triangle_.chart, at, frame.point}}) * up;
    const std::array<const TaylorModel*, 3> f{&frame.point.x, &frame.point.y, &frame.point.z};
    for (const TaylorModel* component : f)
      if (!component->is_finite()) {
        obstacle_ = component->failure().data();
        return false;
      }
    if (!std::isfinite(weight)) return false;
    if (!has_centre) {
      centre_ = {f[0]->centre().real, f[1]->centre().real, f[2]->centre().real};
      has_centre = true;
    }
    constexpr auto powers = static_cast<std::size_t>(TaylorModel::highest_degree + 1);
    std::array<double, powers> linear{};  // lengths of the real vectors, by the power of z
    std::array<std::array<double, 3>, powers> rest{};
    const std::array<double, 3> centre{centre_.x, centre_.y, centre_.z};
    for (std::size_t i = 0; i < powers; ++i)
      for (std::size_t j = 0; i + j < powers; ++j) {
        std::array<double, 3> real{};
        for (std::size_t c = 0; c < 3; ++c) {
          const ComplexDouble a = f[c]->coefficient(static_cast<int>(i), static_cast<int>(j));
          if (i + j == 0) {
            rest[i][c] += std::abs(a.real - centre[c]) * up + std::abs(a.imag);
          } else if (i >= 2) {
            rest[i][c] += std::abs(a.real) + std::abs(a.imag);
          } else {
            real[c] = a.real;
            rest[i][c] += std::abs(a.imag);
          }
        }
        linear[i] += upper_norm(real[0], real[1], real[2]);
      }
    for (std::size_t rho = from; rho <= to; ++rho) {
      const double smaller = rho == to ? 1 : (rhos[rho] + 1 / rhos[rho]) / (rhos[to] + 1 / rhos[to]) * up;
      std::array<double, 3> others{f[0]->remainder(), f[1]->remainder(), f[2]->remainder()};
      double scale = 1;
      for (std::size_t i = 0; i < powers; ++i, scale *= smaller)
        for (std::size_t c = 0; c < 3; ++c) others[c] += rest[i][c] * scale;
      bounds.push_back({.rho = rho,
                        .linear = (linear[0] + linear[1] * smaller) * up,
                        .rest = upper_norm(others[0], others[1], others[2]) * up,
                        .weight = weight});
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
        least = std::min(least, all_.factors_[order][bound.rho] * bound.scaled(d) * up);
      sum += least;
    }
    return sum / 2 * up;
  }

  void find_reaches(const Cell& cell) {
    reach_.fill(Reach{});
    const SquareToElement<TaylorModel> map(corners_, cell);
    std::array<std::vector<DiskBound>, 2> bounds;
    bool has_centre = false;
    for (const SquareAxis axis : {SquareAxis::x, SquareAxis::y}) {
      std::vector<DiskBound>& side = bounds[axis == SquareAxis::x ? 0 : 1];
      std::size_t rho = 0;
      for (const std::size_t last : modelled) {
        if (!add_disk_bounds(map, axis, rho, last, side, has_centre)) break;
        rho = last + 1;
      }
      blocked_ = side.empty() ? obstacle_ : nullptr;
      if (side.empty()) return;
    }
    // The first disks are little more than the cell: the integrand's weight there is about twice its area.
    const double smallest = std::max(bounds[0].front().linear, bounds[1].front().linear);
    const double allowance = share * all_.demand_ / static_cast<double>(functions_) *
                             std::min(bounds[0].front().weight, bounds[1].front().weight) / 2;
    constexpr double farthest = 1e4;
    double beyond = farthest * smallest;
    for (std::size_t m = 0; m < orders.size(); ++m) {
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

  void sample(const Cell& cell, int order) {
    const BallPrecision precision(ball_bits);
    const std::shared_ptr<const EnclosedGaussRule> rule = enclosed_gauss_rule(order);
    const SquareToElement<Ball> map(corners_, cell);
    const ChartIn<Ball>& formula = chart_.in<Ball>();
    samples_.order = order;
    samples_.data.clear();
    samples_.mass.assign(functions_, 0.0);
    samples_.mass_error.assign(functions_, 0.0);
    samples_.position_error = 0;
    samples_.normal_error = 0;
    const auto m = static_cast<std::size_t>(order);
    for (std::size_t a = 0; a < m; ++a) {
      const Ball x = (1 + rule->nodes[a]) / 2;
      for (std::size_t b = 0; b < m; ++b) {
        const Ball y = (1 + rule->nodes[b]) / 2;
        const Barycentric<Ball> in_element = map.barycentric(x, y);
        const ParameterPoint<Ball> at = map.parameters(in_element);
        const Frame<Ball> frame = formula.frame(at);
        const Ball area = area_element(frame);
        const RoundedVector position = rounded(frame.point);
        const RoundedVector normal = rounded((1 / area) * frame.area_normal);
        samples_.position_error = std::max(samples_.position_error, position.error);
        samples_.normal_error = std::max(samples_.normal_error, normal.error);
        samples_.data.insert(samples_.data.end(), {position.value.x, position.value.y, position.value.z,
                                                   normal.value.x, normal.value.y, normal.value.z});
        all_.functions_.values({in_element, {triangle_.chart, at, frame.point}}, function_values_);
        const Ball weight = rule->weights[a] * rule->weights[b] * x * map.determinant * area / 4;
        for (std::size_t j = 0; j < functions_; ++j) {
          const Rounded w = rounded(weight * function_values_[j]);
          samples_.data.push_back(w.value);
          samples_.mass[j] += std::abs(w.value);
          samples_.mass_error[j] += w.error;
        }
      }
    }
    for (std::size_t j = 0; j < functions_; ++j) {
      samples_.mass_error[j] *= up;
      samples_.mass[j] = (samples_.mass[j] + samples_.mass_error[j]) * up;
    }
  }

  void by_rule(const Cell& cell, std::size_t m, std::span<const std::uint32_t> list) {
    sample(cell, orders[m]);
    PackSums sums;
    PackOfPoints points;
    for (std::size_t begin = 0; begin < list.size(); begin += Pack::lanes) {
      const std::size_t count = std::min(Pack::lanes, list.size() - begin);
      for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
        const std::size_t i = list[begin + std::min(lane, count - 1)];
        const Vector<double>& position = all_.points_.position[i];
        const Vector<double>& normal = all_.points_.normal[i];
        points.position.x.set_lane(lane, position.x);
        points.position.y.set_lane(lane, position.y);
        points.position.z.set_lane(lane, position.z);
        points.normal.x.set_lane(lane, normal.x);
        points.normal.y.set_lane(lane, normal.y);
        points.normal.z.set_lane(lane, normal.z);
      }
      take_sums(samples_, functions_, points, sums);
      for (std::size_t lane = 0; lane < count; ++lane) {
        const std::size_t i = list[begin + lane];
        const double d = distance(i);
        const double truncated = reach_[m].error / (d * d) * up;
        const RoundingFactors rounding(samples_, all_.points_, sums.nearest.lane(lane),
                                       sums.cosine_p.lane(lane), sums.cosine_q.lane(lane));
        for (std::size_t j = 0; j < functions_; ++j) {
          const double error = truncated + rounding.of_mass * samples_.mass[j] +
                               rounding.of_mass_error * samples_.mass_error[j];
          add(i, j, sums.sum[j].lane(lane), error);
        }
      }
    }
  }

  // ---- points of the element ----

  /// One triangle of the fan around P.
  template <Real R>
  struct AroundPoint {
    SquareMapIn<R> map;
    std::array<R, 3> apex;  ///< the same in barycentric coordinates
    std::array<R, 3> first;
    std::array<R, 3> along;
    Vector<R> normal;

    Barycentric<R> barycentric(const R& x, const R& y) const {
      return {{apex[0] + x * (first[0] + y * along[0]), apex[1] + x * (first[1] + y * along[1]),
               apex[2] + x * (first[2] + y * along[2])}};
    }
  };

  template <Real R>
  struct AroundValue {
    R kernel;  ///< times the Jacobian
    ElementPoint<R> at;
  };

  template <Real R>
  AroundPoint<R> around_point(const SquareMap& map, const Vector<Ball>& normal) const {
    AroundPoint<R> result{SquareMapIn<R>(map), {}, {}, {}, taken_into<R>(normal)};
    const Rational area = cross(corners_[1] - corners_[0], corners_[2] - corners_[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      const ParameterPoint<Rational>& origin = corners_[(i + 1) % 3];
      const ParameterPoint<Rational> side = corners_[(i + 2) % 3] - origin;
      result.apex[i] = from_rational<R>(cross(side, map.apex - origin) / area);
      result.first[i] = from_rational<R>(cross(side, map.first) / area);
      result.along[i] = from_rational<R>(cross(side, map.along) / area);
    }
    return result;
  }

  template <Real R>
  AroundValue<R> value(const AroundPoint<R>& piece, const R& x, const R& y) const {
    const ChartIn<R>& formula = chart_.in<R>();
    const ParameterPoint<R> at = piece.map.point(x, y);
    const Frame<R> frame = formula.frame(at);
    const R kernel = chord_kernel(formula.chord_along(piece.map.apex, piece.map.direction(y), x),
                                  piece.normal, frame.area_normal);
    return {piece.map.jacobian(x) * kernel, {piece.barycentric(x, y), {triangle_.chart, at, frame.point}}};
  }

  struct AxisRule {
    int order = 0;  ///< 0: none will do
    double error = infinity;
  };

  /// The lowest order that keeps an axis' part of the error within the allowance.
  AxisRule rule_for(const AroundPoint<TaylorModel>& piece, const SquareCell& cell, SquareAxis axis,
                    double allowance) {
    const double area = (cell.x_high - cell.x_low) * (cell.y_high - cell.y_low) / 2;
    AxisRule best;
    for (std::size_t rho = 0; rho < rhos.size(); ++rho) {
      const Disks disks = disks_around(cell, axis, rhos[rho]);
      const AroundValue<TaylorModel> f = value(piece, disks.x, disks.y);
      if (!f.kernel.is_finite()) {
        obstacle_ = f.kernel.failure().data();
        break;
      }
      const double bound = f.kernel.magnitude_bound() * all_.functions_.bound(f.at) * area * up;
      std::size_t m = 0;
      while (m < orders.size() && !(all_.factors_[m][rho] * bound * up <= allowance)) ++m;
      const bool better = m < orders.size() && (best.order == 0 || orders[m] < best.order);
      if (better) best = {orders[m], all_.factors_[m][rho] * bound * up};
      if (!better && best.order != 0) break;
    }
    return best;
  }

  struct AroundPiece {
    AroundPoint<TaylorModel> in_models;
    AroundPoint<Ball> in_balls;
  };

  bool around(std::size_t i) {
    const BallPrecision precision(ball_bits);
    const Vector<Ball> normal = unit_normal(all_.frame_of(all_.names_[i]));
    const ParameterPolygon polygon(corners_.begin(), corners_.end());
    std::vector<Ball> sums(functions_);
    const double allowance = share * all_.demand_ / static_cast<double>(functions_);
    for (const SquareMap& map : fan(polygon, all_.names_[i].at)) {
      const AroundPiece piece{around_point<TaylorModel>(map, normal), around_point<Ball>(map, normal)};
      add_around(piece, {}, allowance, 0, sums);
    }
    if (!why_.empty()) return false;
    for (std::size_t j = 0; j < functions_; ++j) {
      const Rounded sum = rounded(sums[j]);
      add(i, j, sum.value, sum.error);
    }
    return true;
  }

  void add_around(const AroundPiece& piece, const SquareCell& cell, double allowance, int depth,
                  std::vector<Ball>& sums) {
    if (!why_.empty()) return;
    const AxisRule x = rule_for(piece.in_models, cell, SquareAxis::x, allowance / 2);
    const AxisRule y = rule_for(piece.in_models, cell, SquareAxis::y, allowance / 2);
    if (x.order == 0 || y.order == 0) {
      if (depth == deepest_around) {
        why_ = "the integral over an element of chart " + chart_.facts().name +
               " from a point of it was not enclosed" + (obstacle_ != nullptr ? ": " : "") +
               (obstacle_ != nullptr ? obstacle_ : "");
        return;
      }
      SquareCell low = cell;
      SquareCell high = cell;
      const bool longer_in_y = cell.y_high - cell.y_low >= cell.x_high - cell.x_low;
      if (y.order == 0 && (x.order != 0 || longer_in_y)) {
        low.y_high = high.y_low = (cell.y_low + cell.y_high) / 2;
      } else {
        low.x_high = high.x_low = (cell.x_low + cell.x_high) / 2;
      }
      add_around(piece, low, allowance / 2, depth + 1, sums);
      add_around(piece, high, allowance / 2, depth + 1, sums);
      return;
    }
    const std::shared_ptr<const EnclosedGaussRule> in_x = enclosed_gauss_rule(x.order);
    const std::shared_ptr<const EnclosedGaussRule> in_y = enclosed_gauss_rule(y.order);
    const Ball half_x = (Ball(cell.x_high) - Ball(cell.x_low)) / 2;
    const Ball half_y = (Ball(cell.y_high) - Ball(cell.y_low)) / 2;
    for (std::size_t a = 0; a < in_x->nodes.size(); ++a) {
      const Ball at_x = Ball(cell.x_low) + half_x * (1 + in_x->nodes[a]);
      for (std::size_t b = 0; b < in_y->nodes.size(); ++b) {
        const Ball at_y = Ball(cell.y_low) + half_y * (1 + in_y->nodes[b]);
        const AroundValue<Ball> f = value(piece.in_balls, at_x, at_y);
        const Ball weighted = in_x->weights[a] * in_y->weights[b] * half_x * half_y * f.kernel;
        all_.functions_.values(f.at, function_values_);
        for (std::size_t j = 0; j < functions_; ++j) sums[j] = fma(weighted, function_values_[j], sums[j]);
      }
    }
    const Ball error = Ball(x.error) + Ball(y.error);
    for (Ball& sum : sums) sum = widened(sum, error);
  }

  /// Of the demand for one part of one integral, d^2 and the cell's weight divided out: the sum of weight / d^2 over a surface is
  /// of the size 2 pi log(1/h).
  static constexpr double share = 1.0 / 64;

  const Prepared& all_;
  std::size_t functions_;
  const ParameterTriangle& triangle_;
  const Chart& chart_;
  ExactCorners corners_;
  std::span<double> values_;
  std::span<double> radius_;
  std::vector<Ball> function_values_;
  std::vector<std::vector<std::uint32_t>> lists_;
  std::array<Reach, orders.size()> reach_{};
  Vector<double> centre_;
  Samples samples_;
  std::string why_;
  const char* obstacle_ = nullptr;  ///< the last operation of which a model had no value
  const char* blocked_ = nullptr;   ///< the same where a cell had no bound at all
};

CertifiedKernelSums::CertifiedKernelSums(const Surface& surface, const Triangulation& triangulation,
                                         const ElementFunctions& functions,
                                         std::span<const SurfacePoint<Rational>> points, double demand) {
  expects(surface.unoccluded, "an unoccluded surface", named("surface", surface.name));
  expects(functions.size() >= 1 && functions.size() <= most_functions, "from 1 to 45 functions",
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

std::string CertifiedKernelSums::element(std::size_t k, std::span<double> values,
                                         std::span<double> radius) const {
  prepared_->expects_place(k, values.size(), radius.size());
  return Prepared::Visit(*prepared_, k, values, radius).run();
}

}  // namespace radcert
