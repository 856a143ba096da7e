// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/shadow_exchange.h"

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/enclosure/polygon_integral.h"
#include "radcert/scalar/functions/taylor_model.h"
#include "radcert/scalar/real.h"

namespace radcert {

namespace {

using Point = Vector<Rational>;

/// normal.X + constant, on space.
struct Height {
  Point normal;
  Rational constant;
  Rational operator()(const Point& p) const { return dot(normal, p) + constant; }
};

Height plane_through(const Point& a, const Point& b, const Point& c) {
  const Point normal = cross(b - a, c - a);
  return {normal, -dot(normal, a)};
}

/// A side of a shadow: from `at` along a line through two fixed points, in the sense in which P sees the
/// shadow counterclockwise.
struct ShadowSide {
  Point at;
  Point from;
  Point to;
};
using Shadow = std::vector<ShadowSide>;

/// The part where the height is at least 0; its new side is the given line.
Shadow cut(const Shadow& shadow, const Height& height, const Point& from, const Point& to) {
  Shadow out;
  for (std::size_t k = 0; k < shadow.size(); ++k) {
    const ShadowSide& here = shadow[k];
    const ShadowSide& next = shadow[(k + 1) % shadow.size()];
    const Rational h = height(here.at);
    const Rational h_next = height(next.at);
    if (h.sign() >= 0) {
      if (h.sign() == 0 && h_next.sign() < 0)
        out.push_back({here.at, from, to});
      else
        out.push_back(here);
    }
    if (h.sign() * h_next.sign() < 0) {
      const Point at = here.at + (h / (h - h_next)) * (next.at - here.at);
      if (h.sign() > 0)
        out.push_back({at, from, to});
      else
        out.push_back({at, here.from, here.to});
    }
  }
  if (out.size() < 3) out.clear();
  return out;
}

/// The receiver with its parameters: P = origin + s first + t second.
struct ReceiverPlane {
  Point origin;
  Point first;
  Point second;
  [[nodiscard]] Point point(const ParameterPoint<Rational>& at) const {
    return origin + at.s * first + at.t * second;
  }
};

ParameterPoint<Rational> middle(const ParameterPolygon& cell) {
  ParameterPoint<Rational> sum;
  for (const ParameterPoint<Rational>& p : cell) sum = sum + p;
  return Rational(1, static_cast<long>(cell.size())) * sum;
}

/// Both sides of a line that passes through the inside of a cell; one cell otherwise.
std::vector<ParameterPolygon> split(const ParameterPolygon& cell, const ReceiverPlane& plane,
                                    const Height& height) {
  std::vector<Rational> heights;
  bool above = false;
  bool below = false;
  for (const ParameterPoint<Rational>& corner : cell) {
    heights.push_back(height(plane.point(corner)));
    above = above || heights.back().sign() > 0;
    below = below || heights.back().sign() < 0;
  }
  if (!above || !below) return {cell};
  std::array<ParameterPolygon, 2> parts;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const std::size_t next = (k + 1) % cell.size();
    if (heights[k].sign() >= 0) parts[0].push_back(cell[k]);
    if (heights[k].sign() <= 0) parts[1].push_back(cell[k]);
    if (heights[k].sign() * heights[next].sign() >= 0) continue;
    const ParameterPoint<Rational> at =
        cell[k] + (heights[k] / (heights[k] - heights[next])) * (cell[next] - cell[k]);
    parts[0].push_back(at);
    parts[1].push_back(at);
  }
  return {parts[0], parts[1]};
}

/// The formula of b on a cell in one arithmetic.
template <Real R>
class ShadowIn {
public:
  /// `at` is a point within the cell: which way corners lie does not change on it.
  ShadowIn(const ReceiverPlane& plane, const Shadow& shadow, const Point& at) {
    const Point receiver = cross(plane.first, plane.second);
    const std::size_t count = shadow.size();
    const auto normal = [&](std::size_t k) {
      return cross(shadow[k].from - at, shadow[k].to - shadow[k].from);
    };
    for (std::size_t k = 0; k < count; ++k) {
      // (A - P) x (B - A) = (A - origin) x (B - A) - s first x (B - A) - t second x (B - A).
      const ShadowSide& side = shadow[k];
      const Point along = side.to - side.from;
      const Point constant = cross(side.from - plane.origin, along);
      const Point by_s = -cross(plane.first, along);
      const Point by_t = -cross(plane.second, along);
      const std::size_t before = (k + count - 1) % count;
      const bool fixed = shadow[before].to == side.from;
      const int sense = fixed ? 1 : dot(cross(normal(before), normal(k)), side.at - at).sign();
      sides_.push_back({in(constant), in(by_s), in(by_t), from_rational<R>(dot(receiver, constant)),
                        from_rational<R>(dot(receiver, by_s)), from_rational<R>(dot(receiver, by_t)), fixed,
                        sense, in(side.from - plane.origin)});
    }
    first_ = in(plane.first);
    second_ = in(plane.second);
    largest_ = sqrt(from_rational<R>(dot(receiver, receiver)));
  }

  R operator()(const ParameterPoint<R>& at) const {
    const std::size_t count = sides_.size();
    const Vector<R> p = at.s * first_ + at.t * second_;
    std::vector<Vector<R>> n;
    n.reserve(count);
    for (const Side& side : sides_) n.push_back(side.constant + at.s * side.by_s + at.t * side.by_t);
    std::vector<Vector<R>> corner;
    corner.reserve(count);
    for (std::size_t k = 0; k < count; ++k)
      corner.push_back(sides_[k].fixed ? sides_[k].from - p
                                       : R(sides_[k].sense) * cross(n[(k + count - 1) % count], n[k]));
    R sum(0);
    for (std::size_t k = 0; k < count; ++k) {
      const Side& side = sides_[k];
      const Vector<R>& next = corner[(k + 1) % count];
      const R square = dot(n[k], n[k]);
      const R seen = side.seen + at.s * side.seen_by_s + at.t * side.seen_by_t;
      if constexpr (std::is_same_v<R, Ball>) {
        // P may lie on the side's line: an angle is at most pi, a cosine at most 1.
        if (!certainly_positive(square)) {
          sum = sum + widened(R(0), pi<R>() * largest_);
          continue;
        }
      }
      const R length = sqrt(square);
      sum = sum + angle(dot(corner[k], next), dot(cross(corner[k], next), n[k]) / length) * (seen / length);
    }
    return -sum / R(2);
  }

private:
  struct Side {
    Vector<R> constant;
    Vector<R> by_s;
    Vector<R> by_t;
    R seen;  ///< n_R.n_k, in the same way
    R seen_by_s;
    R seen_by_t;
    bool fixed;  ///< the side begins where the one before ends, at a corner of occluder or source
    int sense;   ///< else at sense n_(k-1) x n_k
    Vector<R> from;
  };
  static Vector<R> in(const Point& p) {
    return {from_rational<R>(p.x), from_rational<R>(p.y), from_rational<R>(p.z)};
  }
  /// In [0, pi], by whichever quotient is bounded.
  static R angle(const R& along, const R& across) {
    if (certainly_positive(along)) return atan(across / along);
    if (certainly_positive(across)) return pi<R>() / R(2) - atan(along / across);
    if constexpr (std::is_same_v<R, Ball>) {
      if (!certainly_negative(along)) return hull(R(0), pi<R>());
    }
    return pi<R>() + atan(across / along);
  }
  std::vector<Side> sides_;
  Vector<R> first_;
  Vector<R> second_;
  R largest_;
};

/// The same in those arithmetics that integral_over_polygon asks for.
class ShadowFormula {
public:
  ShadowFormula(const ReceiverPlane& plane, const Shadow& shadow, const Point& at)
      : in_balls_(plane, shadow, at), in_models_(plane, shadow, at) {}
  template <class R>
  R operator()(const ParameterPoint<R>& at) const {
    if constexpr (std::is_same_v<R, Ball>) {
      return in_balls_(at);
    } else {
      return in_models_(at);
    }
  }

private:
  ShadowIn<Ball> in_balls_;
  ShadowIn<TaylorModel> in_models_;
};

class ShadowIntegral {
public:
  ShadowIntegral(const ExactCorners& receiver, const ExactCorners& source, const ExactCorners& occluder)
      : plane_{receiver[0], receiver[1] - receiver[0], receiver[2] - receiver[0]},
        source_(source),
        occluder_(occluder),
        occluder_plane_(plane_through(occluder[0], occluder[1], occluder[2])) {
    ParameterPolygon whole;
    for (const Point& corner : receiver) whole.push_back(parameters(corner));
    cells_.push_back(std::move(whole));
    cut_all(occluder_plane_);
    for (std::size_t k = 0; k < occluder.size(); ++k) {
      const Point& from = occluder[k];
      const Point& to = occluder[(k + 1) % occluder.size()];
      for (const Point& corner : source) cut_where_seen(corner, corner, from, to);
    }
    for (std::size_t k = 0; k < source.size(); ++k) {
      const Point& from = source[k];
      const Point& to = source[(k + 1) % source.size()];
      for (const Point& corner : occluder) cut_where_seen(from, to, corner, corner);
    }
  }

  [[nodiscard]] std::optional<Ball> enclosed(OccludingSide side, const ShadowDemand& demand) const {
    struct Part {
      const ParameterPolygon* cell;
      Shadow shadow;
    };
    std::vector<Part> parts;
    for (const ParameterPolygon& cell : cells_) {
      const Point at = plane_.point(middle(cell));
      const int height = occluder_plane_(at).sign();
      if (height == 0 || (side == OccludingSide::front && height < 0)) continue;
      Shadow shadow = shadow_from(at, height);
      if (!shadow.empty()) parts.push_back({&cell, std::move(shadow)});
    }
    Ball sum = 0;
    for (const Part& part : parts) {
      const Point at = plane_.point(middle(*part.cell));
      const ShadowFormula formula(plane_, part.shadow, at);
      const Demand share{.radius = demand.radius / static_cast<double>(parts.size()),
                         .work_limit = demand.work_limit / static_cast<long>(parts.size()) + 1};
      const Enclosure integral = integral_over_polygon(formula, *part.cell, share);
      const Ball reached = integral ? integral->value : integral.reason().reached;
      if (!reached.is_finite()) return std::nullopt;
      sum += reached;
    }
    return sum / Ball::pi();
  }

private:
  /// (s,t) of a point of the receiver's plane, by Cramer's rule along the axis that leaves the largest
  /// determinant.
  [[nodiscard]] ParameterPoint<Rational> parameters(const Point& p) const {
    const Point n = cross(plane_.first, plane_.second);
    const Rational square = dot(n, n);
    const Point d = p - plane_.origin;
    return {dot(cross(d, plane_.second), n) / square, dot(cross(plane_.first, d), n) / square};
  }

  void cut_all(const Height& height) {
    std::vector<ParameterPolygon> next;
    for (const ParameterPolygon& cell : cells_)
      for (ParameterPolygon& part : split(cell, plane_, height)) next.push_back(std::move(part));
    cells_ = std::move(next);
  }

  /// Cuts along the plane of a corner and a side (one of the two segments is a point): where a segment from a
  /// point of the source through one of the occluder ends on the receiver's plane is a segment, and cells
  /// that it misses stay whole.
  void cut_where_seen(const Point& source_from, const Point& source_to, const Point& occluder_from,
                      const Point& occluder_to) {
    const bool corner_of_source = source_from == source_to;
    const Height height = corner_of_source ? plane_through(source_from, occluder_from, occluder_to)
                                           : plane_through(source_from, source_to, occluder_from);
    if (height.normal == Point{}) return;
    const auto first = image(source_from, occluder_from);
    const auto last = image(source_to, occluder_to);
    std::vector<ParameterPolygon> next;
    for (const ParameterPolygon& cell : cells_) {
      if (first && last && misses(*first, *last, cell)) {
        next.push_back(cell);
        continue;
      }
      for (ParameterPolygon& part : split(cell, plane_, height)) next.push_back(std::move(part));
    }
    cells_ = std::move(next);
  }

  /// Where the ray from a point of the source through one of the occluder meets the receiver's plane, if
  /// beyond the latter.
  [[nodiscard]] std::optional<ParameterPoint<Rational>> image(const Point& source,
                                                              const Point& occluder) const {
    const Point n = cross(plane_.first, plane_.second);
    const Rational high = dot(n, source - plane_.origin);
    const Rational low = dot(n, occluder - plane_.origin);
    if (low.sign() < 0 || high <= low) return std::nullopt;
    return parameters(source + (high / (high - low)) * (occluder - source));
  }

  static bool misses(const ParameterPoint<Rational>& a, const ParameterPoint<Rational>& b,
                     const ParameterPolygon& cell) {
    const int sense = cross(cell[1] - cell[0], cell[2] - cell[0]).sign();
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const ParameterPoint<Rational> side = cell[(k + 1) % cell.size()] - cell[k];
      if (sense * cross(side, a - cell[k]).sign() <= 0 && sense * cross(side, b - cell[k]).sign() <= 0)
        return true;
    }
    return false;
  }

  /// The shadow as a point of a cell sees it; empty where it has no area.
  [[nodiscard]] Shadow shadow_from(const Point& at, int height) const {
    Shadow shadow;
    for (std::size_t k = 0; k < source_.size(); ++k)
      shadow.push_back({source_[k], source_[k], source_[(k + 1) % source_.size()]});
    shadow = beyond_occluder(shadow, height);
    for (std::size_t k = 0; k < occluder_.size() && !shadow.empty(); ++k) {
      const Point& from = height > 0 ? occluder_[k] : occluder_[(k + 1) % occluder_.size()];
      const Point& to = height > 0 ? occluder_[(k + 1) % occluder_.size()] : occluder_[k];
      const Height outwards = plane_through(at, from, to);
      shadow = cut(shadow, {-outwards.normal, -outwards.constant}, from, to);
    }
    Point area;
    for (std::size_t k = 1; k + 1 < shadow.size(); ++k)
      area = area + cross(shadow[k].at - shadow[0].at, shadow[k + 1].at - shadow[0].at);
    if (area == Point{}) shadow.clear();
    return shadow;
  }

  [[nodiscard]] Shadow beyond_occluder(const Shadow& shadow, int height) const {
    const Height beyond{Rational(-height) * occluder_plane_.normal,
                        Rational(-height) * occluder_plane_.constant};
    // The new side ends where the border crosses the plane: known after a first cut with any line.
    Shadow once = cut(shadow, beyond, Point{}, Point{});
    for (std::size_t k = 0; k < once.size(); ++k)
      if (once[k].from == once[k].to) {
        once[k].from = once[k].at;
        once[k].to = once[(k + 1) % once.size()].at;
      }
    return once;
  }

  ReceiverPlane plane_;
  const ExactCorners& source_;
  const ExactCorners& occluder_;
  Height occluder_plane_;
  std::vector<ParameterPolygon> cells_;
};

}  // namespace

const WorkLimit most_shadow_evaluations("factors/shadow_exchange: evaluations", 2'000'000, 1,
                                        "the ball reached, or none where nothing was bounded");

std::optional<Ball> shadow_exchange_area(const ExactCorners& receiver, const ExactCorners& source,
                                         const ExactCorners& occluder, OccludingSide side,
                                         const ShadowDemand& demand) {
  expects(receiver.size() >= 3 && source.size() >= 3 && occluder.size() >= 3,
          "polygons have three corners or more", named("receiver", receiver.size()),
          named("source", source.size()), named("occluder", occluder.size()));
  return ShadowIntegral(receiver, source, occluder).enclosed(side, demand);
}

}  // namespace radcert
