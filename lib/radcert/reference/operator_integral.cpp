// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/operator_integral.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/reference/kronrod_rule.h"

namespace radcert::reference {
namespace {

using Parameters = ParameterPoint<double>;
using Point = Vector<double>;

constexpr double roundoff = unit_roundoff<double>();
constexpr double tolerance = 4e-14;         // what the adaptive rule aims at, relative to Int |G u|
constexpr std::size_t region_limit = 4000;  // a density that is not smooth must not run for ever
constexpr int grading_power = 6;            // in s = z^6 the powers s^(1/2) and s^(1/3) are analytic
constexpr double far_away = 0.9;            // in radii of a part: farther off a plain product rule is cheaper
constexpr double rounding = 32 * roundoff;  // of one G J u and of its share in the sum, relatively

struct SinhCosh {
  double sinh;
  double cosh;
};

SinhCosh sinh_cosh(double x) {
  const double e = std::expm1(x);  // one call for both, and no digits lost at small x
  const double f = e / (1 + e);
  return {0.5 * (e + f), 1 + 0.5 * (e - f)};
}

double integer_power(double x, int n) {
  double result = 1;
  for (int k = 0; k < n; ++k) result *= x;
  return result;
}

double size(const Point& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

// --- Polygons of the parameter plane -------------------------------------------------------------------------------

/// A convex polygon, counterclockwise, of a few vertices.
struct Polygon {
  std::array<Parameters, 8> vertex{};
  std::size_t count = 0;

  void add(const Parameters& v) { vertex[count++] = v; }
  const Parameters& operator[](std::size_t i) const { return vertex[i % count]; }
};

Polygon whole_domain(ChartDomain domain) {
  Polygon polygon;
  polygon.add({0, 0});
  polygon.add({1, 0});
  if (domain == ChartDomain::unit_square) polygon.add({1, 1});
  polygon.add({0, 1});
  return polygon;
}

Polygon counterclockwise(const std::array<Parameters, 3>& triangle) {
  const bool clockwise = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0;
  Polygon polygon;
  polygon.add(triangle[0]);
  polygon.add(triangle[clockwise ? 2 : 1]);
  polygon.add(triangle[clockwise ? 1 : 2]);
  return polygon;
}

/// The part with sign (s - cut) >= 0.
Polygon clipped(const Polygon& polygon, double cut, double sign) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Parameters& v = polygon[i];
    const Parameters& next = polygon[i + 1];
    const double here = sign * (v.s - cut);
    const double there = sign * (next.s - cut);
    if (here >= 0) part.add(v);
    if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
      const double l = here / (here - there);
      part.add({cut, v.t + l * (next.t - v.t)});
    }
  }
  if (part.count < 3) part.count = 0;
  return part;
}

/// Coordinates in the tangent plane in which distances are those of space: x = A w, A upper triangular.
struct TangentPlane {
  Point first;  // orthonormal
  Point second;
  double ss;
  double st;
  double tt;

  TangentPlane(const Point& tangent_s, const Point& tangent_t) {
    ss = norm(tangent_s);
    first = (1 / ss) * tangent_s;
    st = dot(first, tangent_t);
    const Point rest = tangent_t - st * first;
    tt = norm(rest);
    second = (1 / tt) * rest;
  }
  Parameters coordinates(const Parameters& w) const { return {ss * w.s + st * w.t, tt * w.t}; }
  Parameters parameters(const Parameters& x) const {
    const double t = x.t / tt;
    return {(x.s - st * t) / ss, t};
  }
  Parameters projection(const Point& x) const { return {dot(first, x), dot(second, x)}; }
  double determinant() const { return ss * tt; }
};

double length(const Parameters& x) { return std::hypot(x.s, x.t); }
double inner(const Parameters& x, const Parameters& y) { return x.s * y.s + x.t * y.t; }

/// The point of a segment of the parameter plane nearest to the origin of `plane`'s coordinates shifted by `target`.
Parameters nearest_on_side(const Parameters& from, const Parameters& to, const Parameters& centre,
                           const Parameters& target, const TangentPlane& plane) {
  const Parameters side = plane.coordinates(to - from);
  const double squared = inner(side, side);
  if (squared == 0) return from;
  const Parameters start = plane.coordinates(from - centre);
  const double l = std::clamp(inner(target - start, side) / squared, 0.0, 1.0);
  return l == 1 ? to : from + l * (to - from);
}

/// The point of the polygon nearest to centre + A^-1 target, in the metric of the tangent plane.
Parameters nearest_in_polygon(const Polygon& polygon, const Parameters& centre, const Parameters& target,
                              const TangentPlane& plane) {
  const Parameters goal = centre + plane.parameters(target);
  bool inside = true;
  for (std::size_t i = 0; i < polygon.count; ++i)
    inside = inside && cross(polygon[i + 1] - polygon[i], goal - polygon[i]) >= 0;
  if (inside) return goal;
  Parameters best = polygon[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Parameters candidate = nearest_on_side(polygon[i], polygon[i + 1], centre, target, plane);
    const double distance = length(plane.coordinates(candidate - centre) - target);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

/// A point of the polygon about as near to P as any. Any point would give the right integral, this one gives it cheaply.
Parameters nearest_to(const Point& p, const ChartIn<double>& chart, const Polygon& polygon) {
  Parameters best = (1.0 / static_cast<double>(polygon.count)) * [&] {
    Parameters sum{0, 0};
    for (std::size_t i = 0; i < polygon.count; ++i) sum = sum + polygon[i];
    return sum;
  }();
  Frame<double> frame = chart.frame(best);
  double distance = norm(frame.point - p);
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Frame<double> other = chart.frame(polygon[i]);
    if (norm(other.point - p) >= distance) continue;
    best = polygon[i];
    frame = other;
    distance = norm(other.point - p);
  }
  for (int step = 0; step < 30; ++step) {
    const TangentPlane plane(frame.tangent_s, frame.tangent_t);
    const Parameters goal = nearest_in_polygon(polygon, best, plane.projection(p - frame.point), plane);
    Parameters move = goal - best;
    bool nearer = false;
    for (int halving = 0; halving < 8 && !nearer; ++halving, move = 0.5 * move) {
      const Parameters candidate = halving == 0 ? goal : best + move;
      const Frame<double> other = chart.frame(candidate);
      const double candidate_distance = norm(other.point - p);
      if (candidate_distance >= distance) continue;
      nearer = true;
      best = candidate;
      frame = other;
      distance = candidate_distance;
    }
    if (!nearer || length(plane.coordinates(move)) < 1e-3 * distance) break;
  }
  return best;
}

// --- Integrands: G J u at the parameters apex + w ---------------------------------------------------------------------

struct Sample {
  double value;
  double noise;  // a bound for its rounding beside the relative one
};

struct Target {
  const Density* density;
  std::size_t chart;
  ChartDomain domain;
  Parameters apex;

  Parameters at(const Parameters& w) const {
    const Parameters sum = apex + w;
    return {std::clamp(sum.s, 0.0, 1.0), std::clamp(sum.t, 0.0, 1.0)};
  }
  double u(const Parameters& at, const Point& point) const { return (*density)({chart, at}, point); }
};

/// Another chart, flat: Q - P = offset + DF w loses no digits if the offset has lost none, and (P-Q).n_Q is constant.
struct FlatIntegrand {
  Target target;
  Point origin;  // F(0,0)
  Point tangent_s;
  Point tangent_t;
  Point normal_p;
  Point offset;         // F(apex) - P
  double height;        // (P-Q).n_Q J
  double area;          // J
  double offset_error;  // of `offset`

  Sample operator()(const Parameters& w) const {
    const Point d = offset + (w.s * tangent_s + w.t * tangent_t);
    const double squared = dot(d, d);
    const double cosine_p = dot(d, normal_p);
    const Parameters at = target.at(w);
    const double weight = target.u(at, origin + (at.s * tangent_s + at.t * tangent_t)) / (squared * squared);
    const double shift = offset_error + 4 * roundoff * std::sqrt(squared);
    return {cosine_p * height * weight,
            2 * shift * (area * std::abs(cosine_p) + std::abs(height) + area * shift) * std::abs(weight)};
  }
};

/// Another chart, curved: points of space are subtracted.
struct CurvedIntegrand {
  Target target;
  const ChartIn<double>* chart;
  Point p;
  Point normal_p;
  double size_of_p;

  Sample operator()(const Parameters& w) const {
    const Parameters at = target.at(w);
    const Frame<double> frame = chart->frame(at);
    const Point d = frame.point - p;
    const double squared = dot(d, d);
    const double weight = target.u(at, frame.point) / (squared * squared);
    const double cosine_p = dot(d, normal_p);
    const double cosine_q = -dot(d, frame.area_normal);
    const double area = area_element(frame);
    const double shift = 2 * roundoff *
                         (size_of_p + norm(frame.point) + norm(frame.tangent_s) * at.s +
                          norm(frame.tangent_t) * at.t + 2 * std::sqrt(squared));
    return {cosine_p * cosine_q * weight,
            shift * (area * std::abs(cosine_p) + std::abs(cosine_q) + area * shift) * std::abs(weight)};
  }
};

/// P's own chart: the chord loses no digits up to the diagonal.
struct ChordIntegrand {
  Target target;
  const ChartIn<double>* chart;
  Parameters p;
  Parameters offset;  // apex - p
  Point normal_p;

  Sample operator()(const Parameters& w) const {
    // Rounding must not carry the point over the border of the domain: a power has no value beyond its singular line.
    const Parameters step{std::clamp(offset.s + w.s, -p.s, 1 - p.s),
                          std::clamp(offset.t + w.t, -p.t, 1 - p.t)};
    const Parameters at = p + step;
    const Frame<double> frame = chart->frame(at);
    const Chord<double> chord = chart->chord(p, step);
    const double value = target.u(at, frame.point);
    const double squared = dot(chord.difference, chord.difference);
    const double bend_p = dot(chord.bend_p, normal_p) / squared;
    const double bend_q = dot(chord.bend_q, frame.area_normal) / squared;
    const double spread =
        size(chord.bend_p) * std::abs(bend_q) + size(chord.bend_q) * area_element(frame) * std::abs(bend_p);
    return {bend_p * bend_q * value, 4 * roundoff * spread / squared * std::abs(value)};
  }
};

// --- Maps of the unit square onto parts of the parameter plane, w and area element -----------------------------------

struct MapPoint {
  Parameters w;
  double area;
};

/// A triangle with a corner at the origin, collapsed: w = r (corner + x side).
struct Collapse {
  Parameters corner;
  Parameters side;
  double area;

  struct Line {
    Parameters end;
    double area;
    MapPoint at(double r) const { return {r * end, r * area}; }
  };
  Line line(double x) const { return {corner + x * side, area}; }
};

/// A triangle with a corner at the origin in polar coordinates of the tangent plane, r up to the side at distance h:
/// the angle by tan(angle) = sinh(y), so that a near side is no more trouble than a far one, and r = delta sinh(x),
/// which spreads a peak of width delta at the origin. Both are analytic in a strip about the real line of width pi/2.
struct Sector {
  enum class Radial : std::uint8_t { linear, sinh, power };
  enum class Graded : std::uint8_t { no, at_start, at_end };

  Parameters normal;   // of the side, in parameters for unit length in space
  Parameters tangent;  // along the side
  double height;       // distance h of the side
  double start;        // in y
  double end;
  double extent;
  double delta;
  double inner_radius;
  double density;  // parameter area for unit area in space
  Radial radial;
  Graded graded;

  struct Line {
    Parameters direction;
    double radius;
    double delta;
    double from;
    double extent;
    double factor;
    Radial radial;

    MapPoint at(double x) const {
      double r = 0;
      double slope = 0;
      switch (radial) {
        case Radial::linear:
          r = x * radius;
          slope = radius;
          break;
        case Radial::sinh: {
          const SinhCosh value = sinh_cosh(from + x * extent);
          r = delta * value.sinh;
          slope = delta * value.cosh * extent;
          break;
        }
        case Radial::power: {
          const double lower = integer_power(x, grading_power - 1);
          r = radius * lower * x;
          slope = radius * grading_power * lower;
          break;
        }
      }
      return {r * direction, r * slope * factor};
    }
  };

  Line line(double x) const {
    double position = start + x * extent;
    double slope = extent;
    if (graded != Graded::no) {
      const double z = graded == Graded::at_start ? x : 1 - x;
      const double lower = integer_power(z, grading_power - 1);
      position = graded == Graded::at_start ? start + lower * z * extent : end - lower * z * extent;
      slope *= grading_power * lower;
    }
    const SinhCosh y = sinh_cosh(position);
    Line line{};
    line.direction = (1 / y.cosh) * (normal + y.sinh * tangent);
    line.radius = height * y.cosh;
    line.radial = radial;
    line.factor = slope / y.cosh * density;
    if (radial == Radial::sinh) {
      const double to = std::asinh(line.radius / delta);
      line.delta = delta;
      line.from = std::min(to, std::asinh(inner_radius / delta));
      line.extent = to - line.from;
    }
    return line;
  }
};

/// A trapezium from_s <= s <= to_s between two straight lines, s = z^k graded towards s = 0 or linear, t linear or spread
/// about `centre` by t = centre + delta sinh(y).
struct Slab {
  double from_z;
  double to_z;
  bool graded;
  double from_s;
  double to_s;
  double lower_from;
  double lower_to;
  double upper_from;
  double upper_to;
  double centre;
  double delta;  // 0: linear
  Parameters apex;

  struct Line {
    double w_s;
    double from;
    double extent;
    double delta;
    double shift;
    double factor;

    MapPoint at(double x) const {
      const double y = from + x * extent;
      if (delta == 0) return {{w_s, y + shift}, factor * extent};
      const SinhCosh value = sinh_cosh(y);
      return {{w_s, delta * value.sinh + shift}, factor * extent * delta * value.cosh};
    }
  };

  Line line(double x) const {
    const double z = from_z + x * (to_z - from_z);
    const double power = graded ? integer_power(z, grading_power - 1) : 1;
    const double s = graded ? power * z : z;
    const double l = (s - from_s) / (to_s - from_s);
    const double lower = lower_from + l * (lower_to - lower_from) - centre;
    const double upper = upper_from + l * (upper_to - upper_from) - centre;
    Line line{};
    line.w_s = s - apex.s;
    line.shift = centre - apex.t;
    line.delta = delta;
    line.from = delta == 0 ? lower : std::asinh(lower / delta);
    line.extent = (delta == 0 ? upper : std::asinh(upper / delta)) - line.from;
    line.factor = (to_z - from_z) * (graded ? grading_power * power : 1);
    return line;
  }
};

// --- The adaptive rule ----------------------------------------------------------------------------------------------

struct Region {
  std::uint32_t map;
  std::uint32_t integrand;
  double x;
  double y;
  double width;
  double height;
  double value;
  double absolute;
  double noise;
  double error_x;
  double error_y;
  double priority;

  double error() const { return error_x + error_y; }
};

enum class MapKind : std::uint8_t { collapse, sector, slab };
enum class IntegrandKind : std::uint8_t { flat, curved, chord };

template <class Kind>
struct Place {
  Kind kind;
  std::size_t index;
};

class Integral {
public:
  Integral() : rule_(rule()) {}

  std::uint32_t add(const FlatIntegrand& f) { return add(integrands_, flat_, f, IntegrandKind::flat); }
  std::uint32_t add(const CurvedIntegrand& f) { return add(integrands_, curved_, f, IntegrandKind::curved); }
  std::uint32_t add(const ChordIntegrand& f) { return add(integrands_, chord_, f, IntegrandKind::chord); }
  void add(const Collapse& map, std::uint32_t integrand) {
    first(add(maps_, collapse_, map, MapKind::collapse), integrand);
  }
  void add(const Sector& map, std::uint32_t integrand) {
    first(add(maps_, sector_, map, MapKind::sector), integrand);
  }
  void add(const Slab& map, std::uint32_t integrand) {
    first(add(maps_, slab_, map, MapKind::slab), integrand);
  }
  void add_unseen(double radius) { unseen_ += radius; }

  Estimate estimate() {
    const auto less = [](const Region& a, const Region& b) { return a.priority < b.priority; };
    std::make_heap(regions_.begin(), regions_.end(), less);
    double error = 0;
    double allowed = 0;  // rounding bounds what is worth asking for
    const auto allowance = [](const Region& region) { return tolerance * region.absolute + region.noise; };
    const auto resum = [&] {
      error = allowed = 0;
      for (const Region& region : regions_) {
        error += region.error();
        allowed += allowance(region);
      }
    };
    resum();
    while (!regions_.empty() && regions_.size() < region_limit) {
      if (error <= allowed) {
        resum();
        if (error <= allowed) break;
      }
      if (regions_.front().priority == 0) break;
      std::pop_heap(regions_.begin(), regions_.end(), less);
      Region low = regions_.back();
      regions_.pop_back();
      error -= low.error();
      allowed -= allowance(low);
      Region high = low;
      if (low.error_x > low.error_y) {
        low.width *= 0.5;
        high.width -= low.width;
        high.x += low.width;
      } else {
        low.height *= 0.5;
        high.height -= low.height;
        high.y += low.height;
      }
      for (Region region : {low, high}) {
        apply(region);
        error += region.error();
        allowed += allowance(region);
        regions_.push_back(region);
        std::push_heap(regions_.begin(), regions_.end(), less);
      }
    }
    Estimate result;
    double noise = unseen_;
    double carry = 0;
    for (const Region& region : regions_) {
      const double sum = result.value + region.value;
      carry += std::abs(result.value) >= std::abs(region.value) ? (result.value - sum) + region.value
                                                                : (region.value - sum) + result.value;
      result.value = sum;
      result.absolute += region.absolute;
      noise += region.noise + region.error();
    }
    result.value += carry;
    result.radius = noise + rounding * result.absolute;
    return result;
  }

private:
  static const KronrodRule& rule() {
    static const KronrodRule the_rule;
    return the_rule;
  }

  template <class Kind, class Item>
  static std::uint32_t add(std::vector<Place<Kind>>& places, std::vector<Item>& items, const Item& item,
                           Kind kind) {
    places.push_back({kind, items.size()});
    items.push_back(item);
    return static_cast<std::uint32_t>(places.size() - 1);
  }

  void first(std::uint32_t map, std::uint32_t integrand) {
    Region region{};
    region.map = map;
    region.integrand = integrand;
    region.width = region.height = 1;
    apply(region);
    regions_.push_back(region);
  }

  template <class Action>
  auto with_integrand(std::uint32_t integrand, const Action& action) const {
    const Place<IntegrandKind>& place = integrands_[integrand];
    switch (place.kind) {
      case IntegrandKind::flat: return action(flat_[place.index]);
      case IntegrandKind::curved: return action(curved_[place.index]);
      default: return action(chord_[place.index]);
    }
  }

  void apply(Region& region) const {
    const Place<MapKind>& place = maps_[region.map];
    with_integrand(region.integrand, [&](const auto& f) {
      switch (place.kind) {
        case MapKind::collapse: return apply(collapse_[place.index], f, region);
        case MapKind::sector: return apply(sector_[place.index], f, region);
        case MapKind::slab: return apply(slab_[place.index], f, region);
      }
    });
  }

  template <class Map, class Integrand>
  void apply(const Map& map, const Integrand& f, Region& region) const {
    constexpr std::size_t n = KronrodRule::size;
    const KronrodRule::Samples& nodes = rule_.nodes();
    const KronrodRule::Samples& weights = rule_.weights();
    KronrodRule::Samples profile_x{};
    KronrodRule::Samples profile_y{};
    double absolute = 0;
    double noise = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto line = map.line(region.x + nodes[i] * region.width);
      double row = 0;
      double row_absolute = 0;
      double row_noise = 0;
      for (std::size_t j = 0; j < n; ++j) {
        const MapPoint point = line.at(region.y + nodes[j] * region.height);
        const Sample sample = f(point.w);
        const double value = sample.value * point.area;
        row += weights[j] * value;
        row_absolute += weights[j] * std::abs(value);
        row_noise += weights[j] * sample.noise * std::abs(point.area);
        profile_y[j] += weights[i] * value;
      }
      profile_x[i] = row;
      absolute += weights[i] * row_absolute;
      noise += weights[i] * row_noise;
    }
    const double area = region.width * region.height;
    region.value = area * rule_.integral(profile_x);
    region.absolute = area * absolute;
    region.noise = area * noise;
    region.error_x = area * rule_.error(profile_x);
    region.error_y = area * rule_.error(profile_y);
    expects(std::isfinite(region.absolute) && std::isfinite(region.noise), "G u is finite off P",
            named("integral of |G u| over a part", region.absolute));
    // No bisection lowers an error that is rounding.
    const bool is_rounding = region.error() <= 2 * region.noise + 8 * roundoff * region.absolute;
    const bool is_tiny = region.width < 1e-12 || region.height < 1e-12;
    region.priority = is_rounding || is_tiny ? 0 : region.error();
  }

  const KronrodRule& rule_;
  std::vector<FlatIntegrand> flat_;
  std::vector<CurvedIntegrand> curved_;
  std::vector<ChordIntegrand> chord_;
  std::vector<Collapse> collapse_;
  std::vector<Sector> sector_;
  std::vector<Slab> slab_;
  std::vector<Place<IntegrandKind>> integrands_;
  std::vector<Place<MapKind>> maps_;
  std::vector<Region> regions_;
  double unseen_ = 0;
};

// --- Decompositions -------------------------------------------------------------------------------------------------

void add_triangles(Integral& integral, std::uint32_t integrand, const Polygon& polygon) {
  for (std::size_t i = 1; i + 1 < polygon.count; ++i) {
    const Parameters corner = polygon[i] - polygon[0];
    const Parameters side = polygon[i + 1] - polygon[i];
    integral.add(Collapse{corner, side, cross(corner, side)}, integrand);
  }
}

struct Spread {
  double centre = 0;
  double delta = 0;
};

void add_slabs(Integral& integral, std::uint32_t integrand, const Polygon& polygon, const Parameters& apex,
               bool graded, const Spread& spread) {
  std::array<double, 8> cut{};
  for (std::size_t i = 0; i < polygon.count; ++i) cut[i] = polygon[i].s;
  std::sort(cut.begin(), cut.begin() + static_cast<std::ptrdiff_t>(polygon.count));
  for (std::size_t k = 0; k + 1 < polygon.count; ++k) {
    if (!(cut[k] < cut[k + 1])) continue;
    const double middle = cut[k] + 0.5 * (cut[k + 1] - cut[k]);
    Slab slab{};
    slab.graded = graded;
    slab.from_s = cut[k];
    slab.to_s = cut[k + 1];
    slab.from_z = graded ? std::pow(slab.from_s, 1.0 / grading_power) : slab.from_s;
    slab.to_z = graded ? std::pow(slab.to_s, 1.0 / grading_power) : slab.to_s;
    slab.centre = spread.centre;
    slab.delta = spread.delta;
    slab.apex = apex;
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const Parameters& a = polygon[i];
      const Parameters& b = polygon[i + 1];
      const bool lower = a.s < middle && b.s > middle;  // counterclockwise: the lower sides run to the right
      const bool upper = a.s > middle && b.s < middle;
      if (!lower && !upper) continue;
      const double slope = (b.t - a.t) / (b.s - a.s);
      const double from = a.t + (slab.from_s - a.s) * slope;
      const double to = a.t + (slab.to_s - a.s) * slope;
      (lower ? slab.lower_from : slab.upper_from) = from;
      (lower ? slab.lower_to : slab.upper_to) = to;
    }
    integral.add(slab, integrand);
  }
}

struct Polar {
  double delta = 0;         // 0: the integrand is analytic in r from 0 on
  double inner_radius = 0;  // nothing nearer than that is integrated
  double bound = 0;         // of |G u| there
  bool graded = false;      // s^a in the integrand and the apex on s = 0
};

void add_sectors(Integral& integral, std::uint32_t integrand, const Polygon& polygon, const Parameters& apex,
                 const TangentPlane& plane, const Polar& polar) {
  double diameter = 0;
  for (std::size_t i = 0; i < polygon.count; ++i)
    diameter = std::max(diameter, length(plane.coordinates(polygon[i] - apex)));
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Parameters a = plane.coordinates(polygon[i] - apex);
    const Parameters b = plane.coordinates(polygon[i + 1] - apex);
    const double side = length(b - a);
    if (side == 0) continue;
    const Parameters tangent = (1 / side) * (b - a);
    const Parameters normal{tangent.t, -tangent.s};
    const double height = inner(length(a) < length(b) ? a : b, normal);
    if (height <= 4 * roundoff * diameter) continue;  // the apex lies on this side
    Sector sector{};
    sector.normal = plane.parameters(normal);
    sector.tangent = plane.parameters(tangent);
    sector.height = height;
    sector.start = std::asinh(inner(a, tangent) / height);
    sector.end = std::asinh(inner(b, tangent) / height);
    sector.extent = sector.end - sector.start;
    sector.delta = polar.delta;
    sector.inner_radius = polar.inner_radius;
    sector.density = 1 / plane.determinant();
    sector.radial = polar.graded      ? Sector::Radial::power
                    : polar.delta > 0 ? Sector::Radial::sinh
                                      : Sector::Radial::linear;
    if (polar.graded && polygon[i].s == 0) sector.graded = Sector::Graded::at_start;
    if (polar.graded && polygon[i + 1].s == 0) sector.graded = Sector::Graded::at_end;
    integral.add(sector, integrand);
    if (polar.inner_radius > 0) {
      const double angle = std::atan(inner(b, tangent) / height) - std::atan(inner(a, tangent) / height);
      integral.add_unseen(polar.bound * 0.5 * angle * polar.inner_radius * polar.inner_radius);
    }
  }
}

double radius_of(const Polygon& polygon, const Parameters& apex, const TangentPlane& plane) {
  double radius = 0;
  for (std::size_t i = 0; i < polygon.count; ++i)
    radius = std::max(radius, length(plane.coordinates(polygon[i] - apex)));
  return radius;
}

/// The apex moved onto a side or a corner that is near enough: no slivers.
Parameters snapped(const Parameters& apex, const Polygon& polygon, const TangentPlane& plane, double reach) {
  const auto distance = [&](const Parameters& v) { return length(plane.coordinates(v - apex)); };
  for (std::size_t i = 0; i < polygon.count; ++i)
    if (distance(polygon[i]) <= 1.4 * reach) return polygon[i];
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Parameters foot = nearest_on_side(polygon[i], polygon[i + 1], apex, {0, 0}, plane);
    if (distance(foot) <= reach) return foot;
  }
  return apex;
}

/// The sum of a_i b_i as if in twice the precision [Ogita, Rump, Oishi 2005, Dot2].
template <std::size_t n>
double accurate_dot(const std::array<double, n>& a, const std::array<double, n>& b) {
  double sum = 0;
  double error = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double product = a[i] * b[i];
    const double product_error = std::fma(a[i], b[i], -product);
    const double next = sum + product;
    const double part = next - sum;
    error += ((sum - (next - part)) + (product - part)) + product_error;
    sum = next;
  }
  return sum + error;
}

/// F(q) - F(p) for two affine charts, each coordinate correctly rounded but for a cancellation of 16 digits and more.
Point accurate_difference(const Frame<double>& f_q, const Parameters& q, const Frame<double>& f_p,
                          const Parameters& p) {
  const std::array<double, 6> factor{1, q.s, q.t, -1, -p.s, -p.t};
  const auto coordinate = [&](double Point::*x) {
    return accurate_dot<6>(
        {f_q.point.*x, f_q.tangent_s.*x, f_q.tangent_t.*x, f_p.point.*x, f_p.tangent_s.*x, f_p.tangent_t.*x},
        factor);
  };
  return {coordinate(&Point::x), coordinate(&Point::y), coordinate(&Point::z)};
}

/// What P brings along.
struct Collocation {
  const Surface* surface;
  SurfacePoint<double> p;
  Frame<double> frame;
  Point normal;
  const Density* density;
};

/// About the largest |G u| near P on a smooth piece, with a margin: sampled in eight directions.
double bound_near(const Collocation& at) {
  const ChartIn<double>& chart = at.surface->charts[at.p.chart].in<double>();
  constexpr double step = 1e-4;
  double greatest = 0;
  for (const int s : {-1, 0, 1})
    for (const int t : {-1, 0, 1}) {
      if (s == 0 && t == 0) continue;
      const Parameters w{step * s, step * t};
      const double g =
          chord_kernel(chart.chord(at.p.at, w), at.normal, unit_normal(chart.frame(at.p.at + w)));
      if (std::isfinite(g)) greatest = std::max(greatest, std::abs(g));
    }
  return 4 * greatest * std::abs((*at.density)(at.p, at.frame.point));
}

void add_own_chart(Integral& integral, const Collocation& at, const Polygon& polygon) {
  const Chart& chart = at.surface->charts[at.p.chart];
  const Parameters p = at.p.at;
  const TangentPlane plane(at.frame.tangent_s, at.frame.tangent_t);
  const auto integrand = [&](const Parameters& apex) {
    return integral.add(ChordIntegrand{.target = {at.density, at.p.chart, chart.facts().domain, apex},
                                       .chart = &chart.in<double>(),
                                       .p = p,
                                       .offset = apex - p,
                                       .normal_p = at.normal});
  };
  Polygon analytic = polygon;
  double scale = std::numeric_limits<double>::infinity();  // of the structure that a singular line makes
  const bool singular = chart.facts().singular == SingularLine::s_zero;
  if (singular) {
    const Spread spread{.centre = p.t, .delta = std::max(p.s * plane.ss / plane.tt, 1e-3 * (p.s == 0))};
    if (p.s == 0) {
      const Parameters nearest = nearest_in_polygon(polygon, p, {0, 0}, plane);
      if (nearest == p) {
        add_sectors(integral, integrand(p), polygon, p, plane, {.graded = true});
      } else {
        add_slabs(integral, integrand(p), polygon, p, true,
                  {.centre = p.t, .delta = length(plane.coordinates(nearest - p)) / plane.tt});
      }
      return;
    }
    const Polygon strip = clipped(polygon, 0.5 * p.s, -1);
    if (strip.count != 0) add_slabs(integral, integrand(p), strip, p, true, spread);
    analytic = clipped(polygon, 0.5 * p.s, 1);
    if (analytic.count == 0) return;
    scale = 0.5 * p.s * plane.ss;
  }
  Parameters apex = nearest_in_polygon(analytic, p, {0, 0}, plane);
  double distance = length(plane.coordinates(apex - p));
  if (distance < 4 * roundoff * (plane.ss + plane.tt)) distance = 0;
  if (distance > 0) apex = snapped(apex, analytic, plane, 0.25 * distance);
  if (distance > far_away * radius_of(analytic, apex, plane)) {
    if (singular) {
      add_slabs(integral, integrand(p), analytic, p, true, {});
    } else {
      add_triangles(integral, integrand(analytic[0]), analytic);
    }
    return;
  }
  const double delta = distance > 0 ? std::min(distance, scale) : std::isfinite(scale) ? scale : 0;
  add_sectors(integral, integrand(apex), analytic, apex, plane, {.delta = delta});
}

void add_other_chart(Integral& integral, const Collocation& at, std::size_t index, const Polygon& polygon) {
  const Chart& own = at.surface->charts[at.p.chart];
  const Chart& chart = at.surface->charts[index];
  const ChartIn<double>& formula = chart.in<double>();
  const bool same_piece = own.facts().piece == chart.facts().piece;
  const bool flat = chart.facts().plane.has_value();
  const bool square = polygon.count == 4;

  Parameters apex = nearest_to(at.frame.point, formula, polygon);
  const Frame<double> origin = formula.frame({0, 0});
  const Frame<double> own_origin = own.in<double>().frame({0, 0});
  const auto difference = [&](const Parameters& q) {
    return flat && own.facts().plane ? accurate_difference(origin, q, own_origin, at.p.at)
                                     : formula.frame(q).point - at.frame.point;
  };
  Frame<double> frame = formula.frame(apex);
  TangentPlane plane(frame.tangent_s, frame.tangent_t);
  double delta = norm(difference(apex));
  const double extent = norm(frame.point) + norm(at.frame.point) + plane.ss + plane.tt;
  expects(delta > 0 || same_piece, "P off the edges where pieces meet", named("chart", chart.facts().name),
          named("s", at.p.at.s), named("t", at.p.at.t));

  const auto integrand = [&](const Parameters& a) -> std::uint32_t {
    const Target target{at.density, index, chart.facts().domain, a};
    if (!flat)
      return integral.add(CurvedIntegrand{.target = target,
                                          .chart = &formula,
                                          .p = at.frame.point,
                                          .normal_p = at.normal,
                                          .size_of_p = norm(at.frame.point)});
    const Point offset = difference(a);
    const bool exact = own.facts().plane.has_value();
    return integral.add(
        FlatIntegrand{.target = target,
                      .origin = origin.point,
                      .tangent_s = origin.tangent_s,
                      .tangent_t = origin.tangent_t,
                      .normal_p = at.normal,
                      .offset = offset,
                      .height = -dot(offset, origin.area_normal),
                      .area = area_element(origin),
                      .offset_error = exact ? 2 * roundoff * norm(offset) : 4 * roundoff * extent});
  };

  if (chart.facts().singular == SingularLine::s_zero) {
    const bool far = delta > far_away * radius_of(polygon, apex, plane);
    const Spread spread = far ? Spread{} : Spread{.centre = apex.t, .delta = delta / plane.tt};
    add_slabs(integral, integrand({0, 0}), polygon, {0, 0}, true, spread);
    return;
  }
  // Where one piece goes on smoothly G is bounded, but nearer than this rounding hides it: that disk is not integrated.
  const double blind = same_piece ? 1e-8 * extent : 0;
  Polar polar{.delta = std::max(delta, blind)};
  if (delta < blind) {
    polar.inner_radius = 0.3 * blind;
    polar.bound = bound_near(at);
  }
  // In the blind case P stays well inside that disk.
  apex = snapped(apex, polygon, plane, std::max(0.25 * delta, delta < blind ? 0.1 * blind : 0));
  if (delta > far_away * radius_of(polygon, apex, plane)) {
    if (square) {
      add_slabs(integral, integrand({0, 0}), polygon, {0, 0}, false, {});
    } else {
      add_triangles(integral, integrand(polygon[0]), polygon);
    }
    return;
  }
  frame = formula.frame(apex);
  plane = TangentPlane(frame.tangent_s, frame.tangent_t);
  add_sectors(integral, integrand(apex), polygon, apex, plane, polar);
}

void add_part(Integral& integral, const Collocation& at, std::size_t index, const Polygon& polygon) {
  const Chart& own = at.surface->charts[at.p.chart];
  if (index == at.p.chart) {
    if (!own.facts().plane) add_own_chart(integral, at, polygon);
  } else if (!in_one_plane(own, at.surface->charts[index])) {
    add_other_chart(integral, at, index, polygon);
  }
}

bool in_domain(const Parameters& x, ChartDomain domain) {
  constexpr double slack = 1e-13;  // corners of triangles are rounded
  if (!(x.s >= -slack && x.t >= -slack)) return false;
  return domain == ChartDomain::unit_triangle ? x.s + x.t <= 1 + slack : x.s <= 1 + slack && x.t <= 1 + slack;
}

Collocation collocation(const Surface& surface, const SurfacePoint<double>& p, const Density& u) {
  expects(p.chart < surface.chart_count(), "a chart of the surface", named("chart", p.chart));
  const Chart& chart = surface.charts[p.chart];
  expects(in_domain(p.at, chart.facts().domain), "P in the domain of its chart", named("s", p.at.s),
          named("t", p.at.t));
  expects(surface.unoccluded, "an unoccluded surface", named("surface", surface.name));
  expects(static_cast<bool>(u), "a density");
  const Frame<double> frame = chart.in<double>().frame(p.at);
  return {&surface, p, frame, unit_normal(frame), &u};
}

}  // namespace

Estimate operator_integral(const Surface& surface, const SurfacePoint<double>& p, const Density& u) {
  const Collocation at = collocation(surface, p, u);
  Integral integral;
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart)
    add_part(integral, at, chart, whole_domain(surface.charts[chart].facts().domain));
  return integral.estimate();
}

Estimate operator_integral(const Surface& surface, const SurfacePoint<double>& p, std::size_t chart,
                           const std::array<ParameterPoint<double>, 3>& triangle, const Density& u) {
  const Collocation at = collocation(surface, p, u);
  expects(chart < surface.chart_count(), "a chart of the surface", named("chart", chart));
  for (const Parameters& corner : triangle)
    expects(in_domain(corner, surface.charts[chart].facts().domain),
            "the triangle in the domain of its chart", named("s", corner.s), named("t", corner.t));
  Integral integral;
  add_part(integral, at, chart, counterclockwise(triangle));
  return integral.estimate();
}

}  // namespace radcert::reference
