// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/critical_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/scalar/functions/taylor_series.h"

namespace radcert {

namespace {

using Exact = Vector<Rational>;
using Bounded = Vector<BoundedDouble>;

constexpr double nowhere = std::numeric_limits<double>::infinity();
/// More than the roundings of the few operations that make up a bound.
constexpr double up = 1 + 0x1p-45;

double low(const BoundedDouble& x) { return x.value() - x.error() - 0x1p-51 * std::abs(x.value()); }
double high(const BoundedDouble& x) { return x.value() + x.error() + 0x1p-51 * std::abs(x.value()); }
double largest(const BoundedDouble& x) { return (std::abs(x.value()) + x.error()) * up; }

struct Place {
  Exact exact;
  Bounded bounded;
};

Place place(const Exact& p) {
  const auto in = [](const Rational& q) { return Constants<BoundedDouble>::from_rational(q); };
  return {p, {in(p.x), in(p.y), in(p.z)}};
}

/// det(y - x, c - x, d - x): its sign is that of the exact number, and 0 is 0.
BoundedDouble volume(const Place& x, const Place& y, const Place& c, const Place& d) {
  const BoundedDouble rough = dot(y.bounded - x.bounded, cross(c.bounded - x.bounded, d.bounded - x.bounded));
  if (std::abs(rough.value()) > 2 * rough.error()) return rough;
  const Rational exact = dot(y.exact - x.exact, cross(c.exact - x.exact, d.exact - x.exact));
  return exact.sign() == 0 ? BoundedDouble(0) : Constants<BoundedDouble>::from_rational(exact);
}

/// The values of a linear function at both ends.
struct Linear {
  BoundedDouble from;
  BoundedDouble to;
  [[nodiscard]] BoundedDouble at(double t) const {
    if (t == 0 || is_zero()) return from;
    if (t == 1) return to;
    return BoundedDouble::exactly(1 - t) * from + BoundedDouble::exactly(t) * to;
  }
  [[nodiscard]] Linear within(double begin, double end) const { return {at(begin), at(end)}; }
  [[nodiscard]] bool is_zero() const { return certainly_zero(from) && certainly_zero(to); }
  friend Linear operator-(const Linear& a, const Linear& b) { return {a.from - b.from, a.to - b.to}; }
};

enum class Sign { none, positive, negative, unknown };

/// Of all of some numbers, zeros allowed; none: all are 0.
template <class... Numbers>
Sign sign(const Numbers&... x) {
  const bool up_to = ((x.value() + x.error() <= 0) && ...);
  const bool down_to = ((x.value() - x.error() >= 0) && ...);
  if (up_to) return down_to ? Sign::none : Sign::negative;
  return down_to ? Sign::positive : Sign::unknown;
}
Sign sign(const Linear& x) { return sign(x.from, x.to); }
Sign opposite(Sign x) {
  return x == Sign::positive ? Sign::negative : (x == Sign::negative ? Sign::positive : x);
}

/// The Bernstein coefficients of a product of linear functions.
std::array<BoundedDouble, 3> product(const Linear& a, const Linear& b) {
  const BoundedDouble half = BoundedDouble::exactly(0.5);
  return {a.from * b.from, half * (a.from * b.to + a.to * b.from), a.to * b.to};
}

constexpr std::size_t at_start = static_cast<std::size_t>(-1);
constexpr std::size_t at_end = static_cast<std::size_t>(-2);

/// Where the moment about a side vanishes: s = p / d on an interval of t.
struct Crossing {
  std::size_t side = at_start;
  Linear p;
  Linear d;
  double low = 0;
  double high = 0;
  double middle = 0;
  friend bool operator==(const Crossing& a, const Crossing& b) { return a.side == b.side; }
};

Crossing start_crossing() { return {at_start, {0, 0}, {1, 1}, 0, 0, 0}; }
Crossing end_crossing() { return {at_end, {1, 1}, {1, 1}, 1, 1, 1}; }

/// p_x d_y - p_y d_x: the sign of s_x - s_y times that of d_x d_y.
std::array<BoundedDouble, 3> difference(const Crossing& x, const Crossing& y) {
  std::array<BoundedDouble, 3> a = product(x.p, y.d);
  const std::array<BoundedDouble, 3> b = product(y.p, x.d);
  for (std::size_t k = 0; k < 3; ++k) a[k] = a[k] - b[k];
  return a;
}

bool certainly_before(const Crossing& x, const Crossing& y) {
  if (x == y) return false;
  if (x.high <= y.low) return true;
  if (x.low >= y.high) return false;
  const std::array<BoundedDouble, 3> n = difference(x, y);
  const Sign of_difference = sign(n[0], n[1], n[2]);
  const bool same = sign(x.d) == sign(y.d);
  return of_difference == (same ? Sign::negative : Sign::positive);
}

/// s > each of `after` and s < each of `before`.
struct Range {
  std::vector<Crossing> after;
  std::vector<Crossing> before;
  [[nodiscard]] double low() const {
    double out = -nowhere;
    for (const Crossing& x : after) out = std::max(out, x.low);
    return out;
  }
  [[nodiscard]] double high() const {
    double out = nowhere;
    for (const Crossing& x : before) out = std::min(out, x.high);
    return out;
  }
};

/// What is certainly implied by the others is left out.
void simplify(Range& range) {
  const auto thin = [](std::vector<Crossing>& list, auto weaker) {
    for (std::size_t k = 0; k < list.size();) {
      bool implied = false;
      for (std::size_t l = 0; l < list.size() && !implied; ++l)
        implied = l != k && (weaker(list[k], list[l]) || (l < k && list[l] == list[k]));
      if (implied) {
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
      } else {
        ++k;
      }
    }
  };
  thin(range.after, [](const Crossing& x, const Crossing& y) { return certainly_before(x, y); });
  thin(range.before, [](const Crossing& x, const Crossing& y) { return certainly_before(y, x); });
}

/// A polygon: a screen, the source or the receiver.
enum class Role { screen, source, receiver };
struct Body {
  Role role = Role::screen;
  std::vector<std::size_t> corners;
  std::size_t first_side = 0;
};
struct Side {
  std::size_t from = 0;
  std::size_t to = 0;
  std::size_t body = 0;
};

constexpr int degree = 8;
using Series = TaylorSeries<degree>;

}  // namespace

class CriticalLines::Lines {
public:
  Lines(const ExactCorners& receiver, const ExactCorners& source, const std::vector<ExactCorners>& screens,
        const ContourEdge& edge, const ContourEdge::Part& part)
      : from_(place(edge.from)), to_(place(edge.to)), seen_(part.seen), whole_(part.whole) {
    for (const std::size_t k : edge.apart) add_body(Role::screen, screens[k]);
    if (edge.source_is_apart) add_body(Role::source, source);
    source_is_apart_ = edge.source_is_apart;
    add_body(Role::receiver, part.receiver);
    const Exact exact_normal = cross(receiver[1] - receiver[0], receiver[2] - receiver[0]);
    normal_ = place(exact_normal).bounded;
    origin_ = place(receiver[0]).bounded;
    edge_vector_ = place(edge.to - edge.from).bounded;
    const auto height = [&](const Exact& p) {
      return Constants<BoundedDouble>::from_rational(dot(exact_normal, p - receiver[0]));
    };
    height_ = {height(edge.from), height(edge.to)};
    for (const Place& p : places_) corner_height_.push_back(height(p.exact));
    // Both ends of each pair of a corner and a side.
    moments_.resize(places_.size() * sides_.size());
    for (std::size_t y = 0; y < places_.size(); ++y)
      for (std::size_t c = 0; c < sides_.size(); ++c) {
        if (y == sides_[c].from || y == sides_[c].to) continue;
        const Place& start = places_[sides_[c].from];
        const Place& end = places_[sides_[c].to];
        moments_[y * sides_.size() + c] = {volume(from_, places_[y], start, end),
                                           volume(to_, places_[y], start, end)};
      }
    in_plane_.resize(sides_.size() * sides_.size());
    meets_edge_.resize(sides_.size());
    for (std::size_t c = 0; c < sides_.size(); ++c) {
      const Place& start = places_[sides_[c].from];
      const Place& end = places_[sides_[c].to];
      meets_edge_[c] = certainly_zero(volume(from_, to_, start, end));
      for (std::size_t k = 0; k < c; ++k) {
        const bool in_plane =
            sides_[k].body != sides_[c].body &&
            certainly_zero(volume(places_[sides_[k].from], places_[sides_[k].to], start, end));
        in_plane_[k * sides_.size() + c] = in_plane;
        in_plane_[c * sides_.size() + k] = in_plane;
      }
    }
    for (const Body& body : bodies_)
      for (std::size_t j = 0; j < body.corners.size(); ++j) {
        // det(X - C, v, Z - C), Z the next corner.
        const Side& side = sides_[body.first_side + j];
        const Place& next = places_[body.corners[(j + 2) % body.corners.size()]];
        inside_.push_back({volume(places_[side.from], from_, places_[side.to], next),
                           volume(places_[side.from], to_, places_[side.to], next)});
      }
    const std::vector<std::size_t>& corners = bodies_.back().corners;
    Bounded sum;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      sum = sum + cross(places_[corners[k]].bounded - places_[corners[0]].bounded,
                        places_[corners[k + 1]].bounded - places_[corners[0]].bounded);
    const double length = std::sqrt(largest(dot(edge_vector_, edge_vector_))) * up;
    const double twice_area = std::sqrt(largest(dot(sum, sum))) * up;
    most_ = length * std::sqrt(twice_area / 2 / std::numbers::pi) * up;
  }

  [[nodiscard]] double most() const { return most_; }
  [[nodiscard]] std::size_t side_count() const { return sides_.size(); }

  [[nodiscard]] EdgeContribution on(double begin, double end, const std::vector<std::size_t>& sides,
                                    double wanted) const {
    EdgeContribution out;
    const double length = end - begin;
    const Interval t{begin, end, begin + length / 2};
    std::vector<Traced> traces;
    cut_ = &out.cut;
    for (const std::size_t k : sides) {
      const Role role = bodies_[sides_[k].body].role;
      for (const bool near : {true, false}) {
        if (near ? role == Role::source : role == Role::receiver || !source_is_apart_) continue;
        Trace trace = trace_of(k, near, t);
        if (trace.is_empty()) continue;
        if (out.sides.empty() || out.sides.back() != k) out.sides.push_back(k);
        for (const auto& [x, y] : trace.unordered) out.error += between(x, y, k, near, t);
        for (const auto& [low, high] : trace.loose) out.error += stretch(high - low, low, high, k, near, t);
        traces.push_back({k, near, std::move(trace)});
      }
    }
    const double share = length / (4 * std::numbers::pi) * up;
    // What is to be halved for the order's sake needs no value.
    const bool bounded = out.error * share <= wanted;
    if (bounded)
      for (const Traced& traced : traces) add(traced.trace, traced.side, traced.near, t, out);
    out.error *= share;
    // Half an interval's length for Taylor's variable, and the factor before the integral.
    const BoundedDouble factor = BoundedDouble::exactly(-length / 8) / Constants<BoundedDouble>::pi();
    out.value = factor * out.value;
    if (!bounded) out.error = nowhere;
    const double most = most_ * length * std::max(std::abs(seen_), std::abs(seen_ - whole_)) * up;
    if (!(out.error + out.value.error() < most)) {
      out.value = 0;
      out.error = most;
    }
    return out;
  }

private:
  struct Interval {
    double begin;
    double end;
    double middle;
  };

  /// A side's visible parts on an interval of t: F counts `count` times at each crossing.
  struct Trace {
    int orientation = 0;
    double first = 0;  ///< nothing beyond is counted
    double last = 1;
    std::vector<std::pair<Crossing, int>> terms{};
    std::vector<std::pair<Crossing, Crossing>> unordered{};
    std::vector<std::pair<double, double>> loose{};  ///< of which it is not known whether they are seen
    [[nodiscard]] bool is_empty() const { return terms.empty() && unordered.empty() && loose.empty(); }
  };

  /// Notes where a linear function changes its sign within an interval.
  void cut_at(const Linear& x, const Interval& t) const {
    const double share = x.from.value() / (x.from.value() - x.to.value());
    if (*cut_ == 0 && share > 0 && share < 1) *cut_ = t.begin + share * (t.end - t.begin);
  }

  struct Traced {
    std::size_t side;
    bool near;
    Trace trace;
  };

  void add_body(Role role, const ExactCorners& polygon) {
    Body body{.role = role, .corners = {}, .first_side = sides_.size()};
    for (const Exact& p : polygon) {
      const auto at =
          std::find_if(places_.begin(), places_.end(), [&](const Place& other) { return other.exact == p; });
      body.corners.push_back(static_cast<std::size_t>(at - places_.begin()));
      if (at == places_.end()) places_.push_back(place(p));
    }
    const std::size_t count = body.corners.size();
    for (std::size_t k = 0; k < count; ++k)
      sides_.push_back({body.corners[k], body.corners[(k + 1) % count], bodies_.size()});
    bodies_.push_back(std::move(body));
  }

  [[nodiscard]] const Linear& moment(std::size_t corner, std::size_t side) const {
    return moments_[corner * sides_.size() + side];
  }

  /// The moments about a side of the lines through X and the ends of side k, p and q, on an interval.
  struct Moments {
    Linear p;
    Linear q;
    bool proportional = false;
  };
  /// Where the lines of two sides meet, or that of a side and the edge's, the moments are proportional and
  /// s_c constant: both moments vanish where X passes the plane of the two, or the side's line. Then the
  /// values at that end of the interval stand for all, at which they are larger.
  [[nodiscard]] Moments moments(std::size_t k, std::size_t c, const Interval& t) const {
    const Linear& p = moment(sides_[k].from, c);
    const Linear& q = moment(sides_[k].to, c);
    Moments out{p.within(t.begin, t.end), q.within(t.begin, t.end), false};
    out.proportional = in_plane_[k * sides_.size() + c] || meets_edge_[c];
    if (out.proportional && sign(out.p) != Sign::unknown && sign(out.q) != Sign::unknown) {
      const bool last = std::abs(out.p.to.value()) + std::abs(out.q.to.value()) >
                        std::abs(out.p.from.value()) + std::abs(out.q.from.value());
      const BoundedDouble one = last ? out.p.to : out.p.from;
      const BoundedDouble other = last ? out.q.to : out.q.from;
      out.p = {one, one};
      out.q = {other, other};
    }
    return out;
  }

  /// (X - C) x v for the X at t.
  [[nodiscard]] Bounded plane_normal(std::size_t side, double t) const {
    const Bounded& c = places_[sides_[side].from].bounded;
    const Bounded v = places_[sides_[side].to].bounded - c;
    return cross(from_.bounded + BoundedDouble::exactly(t) * edge_vector_ - c, v);
  }

  /// Whether the normals of two planes that are one point to one side. Either turns over only where X passes
  /// its side's line, and so the plane of its body: not within the interval.
  [[nodiscard]] Sign sense(std::size_t side, std::size_t other, const Interval& t) const {
    for (const std::size_t k : {side, other}) {
      const Linear inside = inside_[k].within(t.begin, t.end);
      const Sign found = sign(inside);
      if (found == Sign::positive || found == Sign::negative) continue;
      cut_at(inside, t);
      return Sign::unknown;
    }
    return sign(dot(plane_normal(side, t.middle), plane_normal(other, t.middle)));
  }

  /// For which s the moments about all sides of a body have this sign.
  struct Meeting {
    bool is_empty = false;
    bool is_unknown = false;
    Range range{};
  };

  /// The side k is traced; `outwards`: the sign of the moment about a side in line with it, beside the trace
  /// where the side's own body, if a screen, is not, or, if receiver or source, is.
  [[nodiscard]] Meeting meeting(std::size_t body, Sign wanted, std::size_t k, int orientation, bool near,
                                const Interval& t) const {
    Meeting out;
    const Body& other = bodies_[body];
    const Role mine = bodies_[sides_[k].body].role;
    for (std::size_t j = 0; j < other.corners.size(); ++j) {
      const std::size_t c = other.first_side + j;
      const Linear& at_from = moment(sides_[k].from, c);
      const Linear& at_to = moment(sides_[k].to, c);
      if (at_from.is_zero() && at_to.is_zero()) {
        const Sign g = orientation == 0 ? Sign::unknown : sense(k, c, t);
        if (g == Sign::unknown || g == Sign::none) {
          out.is_unknown = true;
          continue;
        }
        const bool positive = (g == Sign::positive) == ((orientation > 0) == near);
        const bool on_seen_side = (wanted == Sign::positive) == positive;
        bool met = on_seen_side;
        if (other.role == Role::screen) {
          // Of screens that cover one another's border the first counts.
          if (mine == Role::screen) met = on_seen_side || body < sides_[k].body;
        } else {
          met = on_seen_side && mine == Role::receiver;
        }
        if (met) continue;
        out.is_empty = true;
        return out;
      }
      const auto [p, q, proportional] = moments(k, c, t);
      Sign of_p = sign(p);
      Sign of_q = sign(q);
      if (wanted == Sign::negative) {
        of_p = opposite(of_p);
        of_q = opposite(of_q);
      }
      const auto none_above = [](Sign x) { return x == Sign::negative || x == Sign::none; };
      const auto none_below = [](Sign x) { return x == Sign::positive || x == Sign::none; };
      if (none_above(of_p) && none_above(of_q)) {
        out.is_empty = true;
        return out;
      }
      if (none_below(of_p) && none_below(of_q)) continue;
      Crossing crossing{.side = c, .p = p, .d = p - q};
      const Sign of_d = sign(crossing.d);
      if (of_d == Sign::unknown) cut_at(proportional && of_p == Sign::unknown ? p : crossing.d, t);
      const BoundedDouble first = crossing.p.from / crossing.d.from;
      const BoundedDouble last = crossing.p.to / crossing.d.to;
      crossing.low = std::min(low(first), low(last));
      crossing.high = std::max(high(first), high(last));
      if ((of_d != Sign::positive && of_d != Sign::negative) || !std::isfinite(crossing.low) ||
          !std::isfinite(crossing.high)) {
        out.is_unknown = true;
        continue;
      }
      crossing.middle = (p.from.value() + p.to.value()) / (crossing.d.from.value() + crossing.d.to.value());
      if (!std::isfinite(crossing.middle)) {
        out.is_unknown = true;
        continue;
      }
      // The moment times its wanted sign grows with s where p - q is negative.
      const bool grows = of_d != wanted;
      (grows ? out.range.after : out.range.before).push_back(crossing);
    }
    simplify(out.range);
    return out;
  }

  [[nodiscard]] Trace trace_of(std::size_t k, bool near, const Interval& t) const {
    Trace out;
    const std::size_t own = sides_[k].body;
    const Role role = bodies_[own].role;
    const Sign inside = sign(inside_[k].within(t.begin, t.end));
    const int inside_sign = inside == Sign::positive ? 1 : (inside == Sign::negative ? -1 : 0);
    bool is_unknown = inside_sign == 0;
    if (is_unknown) cut_at(inside_[k].within(t.begin, t.end), t);
    switch (role) {
      case Role::screen: out.orientation = near ? inside_sign : -inside_sign; break;
      case Role::source: out.orientation = inside_sign; break;
      case Role::receiver: out.orientation = -inside_sign; break;
    }
    Range seen{{start_crossing()}, {end_crossing()}};
    std::vector<Range> hidden;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (b == own || bodies_[b].role == Role::screen) continue;
      const bool below = (bodies_[b].role == Role::receiver) == near;
      const Meeting met = meeting(b, below ? Sign::negative : Sign::positive, k, out.orientation, near, t);
      if (met.is_empty) return whole_or(out, k, near);
      is_unknown = is_unknown || met.is_unknown;
      seen.after.insert(seen.after.end(), met.range.after.begin(), met.range.after.end());
      seen.before.insert(seen.before.end(), met.range.before.begin(), met.range.before.end());
    }
    simplify(seen);
    if (seen.low() >= seen.high()) return whole_or(out, k, near);
    std::vector<Range> undecided;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (b == own || bodies_[b].role != Role::screen) continue;
      for (const Sign wanted : {Sign::positive, Sign::negative}) {
        Meeting met = meeting(b, wanted, k, out.orientation, near, t);
        if (met.is_empty || met.range.low() >= met.range.high()) continue;
        (met.is_unknown ? undecided : hidden).push_back(std::move(met.range));
      }
    }
    if (!merge(seen, hidden)) return whole_or(out, k, near);
    const double first = std::max(seen.low(), 0.0);
    const double last = std::min(seen.high(), 1.0);
    if (!is_of_whole(k, near)) {
      out.first = first;
      out.last = last;
    }
    if (is_unknown) {
      out.loose.emplace_back(first, last);
    } else {
      for (const Range& h : undecided)
        if (!lies_beside(h, seen) && h.low() < last && h.high() > first)
          out.loose.emplace_back(std::max(first, h.low()), std::min(last, h.high()));
      count(seen, hidden, out);
    }
    subtract_whole(out, k, near);
    return out;
  }

  /// Nothing is seen of the side; of the whole that is taken away.
  [[nodiscard]] Trace whole_or(Trace out, std::size_t k, bool near) const {
    subtract_whole(out, k, near);
    return out;
  }

  [[nodiscard]] bool is_of_whole(std::size_t k, bool near) const {
    return whole_ != 0 && near && bodies_[sides_[k].body].role == Role::receiver;
  }

  void subtract_whole(Trace& out, std::size_t k, bool near) const {
    if (!is_of_whole(k, near)) return;
    for (const auto& [at, count] :
         {std::pair(start_crossing(), -whole_), std::pair(end_crossing(), whole_)}) {
      const auto found = std::find_if(out.terms.begin(), out.terms.end(),
                                      [&, c = at](const auto& term) { return term.first == c; });
      if (found == out.terms.end()) {
        out.terms.emplace_back(at, count);
      } else {
        found->second += count;
      }
    }
    // What is hidden nowhere has no terms.
    std::erase_if(out.terms, [](const auto& term) { return term.second == 0; });
  }

  /// Whether x is certainly implied: at most a lower end of `list` (`after`), or at least an upper one.
  static bool implied_by(const Crossing& x, const std::vector<Crossing>& list, bool after) {
    return std::any_of(list.begin(), list.end(), [&](const Crossing& y) {
      return x == y || (after ? certainly_before(x, y) : certainly_before(y, x));
    });
  }

  static bool lies_beside(const Range& h, const Range& seen) {
    return std::any_of(h.after.begin(), h.after.end(),
                       [&](const Crossing& x) { return implied_by(x, seen.before, false); }) ||
           std::any_of(h.before.begin(), h.before.end(),
                       [&](const Crossing& x) { return implied_by(x, seen.after, true); });
  }

  /// Leaves out what cannot matter; false where nothing is seen.
  static bool merge(Range& seen, std::vector<Range>& hidden) {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t k = 0; k < hidden.size(); ++k) {
        Range& h = hidden[k];
        std::erase_if(h.after, [&](const Crossing& x) { return implied_by(x, seen.after, true); });
        std::erase_if(h.before, [&](const Crossing& x) { return implied_by(x, seen.before, false); });
        const bool empty = std::any_of(h.after.begin(), h.after.end(),
                                       [&](const Crossing& x) { return implied_by(x, h.before, false); });
        bool used = empty || lies_beside(h, seen);
        if (!used) {
          if (h.after.empty() && h.before.empty()) return false;
          if (h.after.empty() && h.before.size() == 1) {
            seen.after.push_back(h.before.front());
            used = true;
          } else if (h.before.empty() && h.after.size() == 1) {
            seen.before.push_back(h.after.front());
            used = true;
          }
          if (used) simplify(seen);
        }
        if (used) {
          hidden.erase(hidden.begin() + static_cast<std::ptrdiff_t>(k));
          changed = true;
          break;
        }
        // An end within another range may as well be that one's.
        for (std::size_t l = 0; l < hidden.size() && !changed; ++l) {
          const Range& cover = hidden[l];
          if (l == k || cover.after.size() > 1 || cover.before.size() > 1) continue;
          const auto covered = [&](const Crossing& x) {
            return (cover.after.empty() || certainly_before(cover.after.front(), x)) &&
                   (cover.before.empty() || certainly_before(x, cover.before.front()));
          };
          const bool first = h.after.size() == 1 && covered(h.after.front());
          const bool last = h.before.size() == 1 && covered(h.before.front());
          if (first && last) {
            hidden.erase(hidden.begin() + static_cast<std::ptrdiff_t>(k));
            changed = true;
          } else if (first) {
            h.after = cover.after;
            changed = true;
          } else if (last) {
            h.before = cover.before;
            changed = true;
          }
        }
        if (changed) break;
      }
      for (const Crossing& x : seen.after)
        for (const Crossing& y : seen.before)
          if (x == y || certainly_before(y, x)) return false;
    }
    return true;
  }

  /// By the order in the middle, where what is seen begins and ends.
  void count(const Range& seen, const std::vector<Range>& hidden, Trace& out) const {
    std::vector<Crossing> all;
    const auto collect = [&](const Range& range) {
      for (const auto* list : {&range.after, &range.before})
        for (const Crossing& x : *list)
          if (std::find(all.begin(), all.end(), x) == all.end()) all.push_back(x);
    };
    collect(seen);
    for (const Range& range : hidden) collect(range);
    std::stable_sort(all.begin(), all.end(),
                     [](const Crossing& a, const Crossing& b) { return a.middle < b.middle; });
    // Where no order in doubles contradicts a certain one.
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size(); ++j)
        if (!certainly_before(all[i], all[j])) out.unordered.emplace_back(all[i], all[j]);
    std::size_t passed = 0;
    const auto holds = [&](const Range& range) {
      const auto is_passed = [&](const Crossing& x) {
        return static_cast<std::size_t>(std::find(all.begin(), all.end(), x) - all.begin()) < passed;
      };
      return std::all_of(range.after.begin(), range.after.end(), is_passed) &&
             std::none_of(range.before.begin(), range.before.end(), is_passed);
    };
    int before = 0;
    for (passed = 0; passed <= all.size(); ++passed) {
      const bool visible = holds(seen) && std::none_of(hidden.begin(), hidden.end(), holds);
      const int now = visible ? seen_ : 0;
      if (now != before) out.terms.emplace_back(all[passed - 1], now - before);
      before = now;
    }
  }

  /// F for the crossings of a side on an interval, as a function of y, t = middle + half y. Polynomials are
  /// taken together before they are bounded, as common factors may be small.
  /// Maths     With A = X - C, D = d n.A - p n.v and N = p v.T - d A.T:  Y - X = (p v - d A) / d and
  ///           h - h_Y = D / d, so that x = h N / D and |P - X|^2 = h^2 (N^2 + |m|^2 D^2) / (D^2 |T|^2)
  class Primitive {
  public:
    Primitive(const Lines& lines, std::size_t side, const Interval& t) {
      const BoundedDouble half = BoundedDouble::exactly((t.end - t.begin) / 2);
      const BoundedDouble middle = BoundedDouble::exactly(t.middle);
      const auto vector = [&](const Bounded& a, const Bounded& b) {
        const auto linear = [&](const BoundedDouble& constant, const BoundedDouble& slope) {
          return Series::linear(constant + middle * slope, half * slope);
        };
        return Vector<Series>{linear(a.x, b.x), linear(a.y, b.y), linear(a.z, b.z)};
      };
      const auto constant = [](const Bounded& x) {
        return Vector<Series>{Series(x.x), Series(x.y), Series(x.z)};
      };
      const Bounded& c = lines.places_[lines.sides_[side].from].bounded;
      const Bounded v = lines.places_[lines.sides_[side].to].bounded - c;
      const Bounded& u = lines.edge_vector_;
      const Bounded& n = lines.normal_;
      const Bounded start = lines.from_.bounded - c;
      const Vector<Series> m = vector(cross(start, v), cross(u, v));
      const Vector<Series> along = vector(cross(n, cross(start, v)), cross(n, cross(u, v)));
      const Vector<Series> a = vector(start, u);
      above_ = dot(a, constant(n));
      rise_ = Series(dot(n, v));
      a_along_ = dot(a, along);
      v_along_ = dot(constant(v), along);
      square_ = dot(m, m);
      const Linear h = lines.height_.within(t.begin, t.end);
      const Series height = linear(h);
      const Series along_square = dot(along, along);
      const Series weight = dot(constant(u), along);
      here_ = Shared(height, along_square, weight, square_);
      everywhere_ =
          Shared(height.everywhere(), along_square.everywhere(), weight.everywhere(), square_.everywhere());
    }

    /// Int F dy over [-1, 1].
    [[nodiscard]] BoundedDouble integral(const Crossing& crossing) const {
      const Series p = linear(crossing.p);
      const Series d = linear(crossing.d);
      Series below = d * above_ - p * rise_;
      Series over = p * v_along_ - d * a_along_;
      if (below[0].value() < 0) {
        below = -below;
        over = -over;
      }
      const Series square = over * over + square_ * (below * below);
      const Series value = here_.value(over, below, square);
      const Series rest = everywhere_.value(over.everywhere(), below.everywhere(), square.everywhere());
      BoundedDouble out = BoundedDouble(2) * rest[degree] / BoundedDouble(degree + 1);
      for (int j = 0; j < degree; j += 2)
        out = out + BoundedDouble(2) * value[static_cast<std::size_t>(j)] / BoundedDouble(j + 1);
      return out;
    }

  private:
    [[nodiscard]] static Series linear(const Linear& x) {
      const BoundedDouble half = BoundedDouble::exactly(0.5);
      return Series::linear(half * (x.from + x.to), half * (x.to - x.from));
    }

    /// What the crossings of a side have in common, in the middle or everywhere.
    struct Shared {
      Shared() = default;
      Shared(const Series& h, const Series& along_square, const Series& weight, const Series& m_square)
          : factor(weight * h / along_square),
            logarithm(Series(BoundedDouble(2)) * log(h) - log(along_square) - Series(BoundedDouble(2))),
            length(sqrt(m_square)) {}
      [[nodiscard]] Series value(const Series& over, const Series& below, const Series& square) const {
        const Series quotient = over / below;
        const Series two(BoundedDouble(2));
        return factor * (quotient * (logarithm + log(square) - two * log(below)) +
                         two * (length * atan(quotient / length)));
      }
      Series factor;     ///< h u . T / |T|^2
      Series logarithm;  ///< 2 log h - log |T|^2 - 2
      Series length;     ///< |m|
    };

    Series above_;    ///< n . A
    Series rise_;     ///< n . v
    Series a_along_;  ///< A . T
    Series v_along_;  ///< v . T
    Series square_;   ///< |m|^2
    Shared here_;
    Shared everywhere_;
  };

  void add(const Trace& trace, std::size_t k, bool near, const Interval& t, EdgeContribution& out) const {
    if (trace.terms.empty()) return;
    const Primitive primitive(*this, k, t);
    BoundedDouble sum(0);
    for (const auto& [crossing, count] : trace.terms)
      sum = sum + BoundedDouble(trace.orientation * count) * primitive.integral(crossing);
    // Of a side of next to no length the sum is not known well, but small.
    constexpr double coarse = 0x1p-20;
    if (!(sum.error() < coarse)) {
      const double most = stretch(trace.last - trace.first, trace.first, trace.last, k, near, t);
      if (!(sum.error() < 2 * most)) {
        out.error += most;
        return;
      }
    }
    out.value = out.value + sum;
  }

  /// Three times a bound of |Int log |P - X|^2 u . dP| between two crossings wherever y comes before x, which
  /// is counted the other way round.
  /// Proof     s_x - s_y is at most the largest Bernstein coefficient of its numerator over the least
  ///           denominators. P(s_x) - P(s_y) = -(s_x - s_y) h T / ((h - h_x) (h - h_y)), h_x the height of
  ///           Y(s_x); bilinear in t and s, h - h_Y(s) is between its values in the corners
  [[nodiscard]] double between(const Crossing& x, const Crossing& y, std::size_t k, bool near,
                               const Interval& t) const {
    // Only where y comes first.
    const bool same = sign(x.d) == sign(y.d);
    double numerator = 0;
    for (const BoundedDouble& n : difference(x, y)) numerator = std::max(numerator, high(same ? n : -n));
    if (numerator == 0) return 0;
    const auto least = [](const Linear& d) { return std::min(d.from.smallest_size(), d.to.smallest_size()); };
    const double gap = numerator / (least(x.d) * least(y.d)) * up;
    return 3 * stretch(gap, std::min(x.low, y.low), std::max(x.high, y.high), k, near, t) * up;
  }

  /// A bound of |Int log |P - X|^2 u . dP| over a part of a side, of at most such a length in s, within two
  /// bounds of s.
  [[nodiscard]] double stretch(double gap, double first, double last, std::size_t k, bool near,
                               const Interval& t) const {
    const BoundedDouble& low_end = corner_height_[sides_[k].from];
    const BoundedDouble& high_end = corner_height_[sides_[k].to];
    const Linear height = height_.within(t.begin, t.end);
    double nearest = nowhere;
    const Sign wanted = near ? Sign::positive : Sign::negative;
    for (const double s : {first, last})
      for (const BoundedDouble& h : {height.from, height.to}) {
        const BoundedDouble rise = BoundedDouble::exactly(s) * (high_end - low_end);
        const BoundedDouble above = h - low_end - rise;
        if (sign(above) != wanted) return nowhere;
        nearest = std::min(nearest, above.smallest_size());
      }
    const double most_height = std::max(largest(height.from), largest(height.to));
    const double least_height = std::min(height.from.smallest_size(), height.to.smallest_size());
    const std::array<Bounded, 2> m{plane_normal(k, t.begin), plane_normal(k, t.end)};
    const auto length = [](const Bounded& v) { return std::sqrt(largest(dot(v, v))) * up; };
    const double along = std::max(length(cross(normal_, m[0])), length(cross(normal_, m[1])));
    const double step = gap * most_height * along / (nearest * nearest) * up;
    // |P - X| = h |Y - X| / |h - h_Y| <= h |Y - X| / nearest, and at least h / |n|.
    const double normal_length = length(normal_);
    double farthest = 0;
    const Bounded& c = places_[sides_[k].from].bounded;
    const Bounded v = places_[sides_[k].to].bounded - c;
    for (const double s : {first, last})
      for (const double where : {t.begin, t.end})
        farthest = std::max(farthest, length(c + BoundedDouble::exactly(s) * v - from_.bounded -
                                             BoundedDouble::exactly(where) * edge_vector_));
    const double largest_log = std::log(most_height * farthest / nearest);
    const double least_log = std::log(least_height / normal_length);
    const double logarithm = 2 * std::max(std::abs(largest_log), std::abs(least_log)) * up + 0x1p-40;
    const double bound = step * logarithm * length(edge_vector_) * up;
    return bound >= 0 ? bound : nowhere;
  }

  Place from_;
  Place to_;
  int seen_;
  int whole_;
  bool source_is_apart_ = true;
  Bounded edge_vector_;
  Bounded normal_;
  Bounded origin_;
  Linear height_;
  std::vector<Place> places_;
  std::vector<BoundedDouble> corner_height_;
  std::vector<Body> bodies_;  ///< the receiver is the last
  std::vector<Side> sides_;
  std::vector<Linear> moments_;
  std::vector<Linear> inside_;
  std::vector<bool> in_plane_;    ///< for pairs of sides of different bodies
  std::vector<bool> meets_edge_;  ///< the side's line and the edge's lie in one plane
  double most_ = 0;
  mutable double* cut_ = nullptr;
};

CriticalLines::CriticalLines(const ExactCorners& receiver, const ExactCorners& source,
                             const std::vector<ExactCorners>& screens, const ContourEdge& edge,
                             const ContourEdge::Part& part)
    : lines_(std::make_unique<Lines>(receiver, source, screens, edge, part)) {}
CriticalLines::~CriticalLines() = default;
CriticalLines::CriticalLines(CriticalLines&&) noexcept = default;
CriticalLines& CriticalLines::operator=(CriticalLines&&) noexcept = default;

std::vector<std::size_t> CriticalLines::sides() const {
  std::vector<std::size_t> out(lines_->side_count());
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

EdgeContribution CriticalLines::on(double begin, double end, const std::vector<std::size_t>& sides,
                                   double wanted) const {
  expects(0 <= begin && begin < end && end <= 1, "an interval within [0, 1]", named("begin", begin),
          named("end", end));
  return lines_->on(begin, end, sides, wanted);
}

double CriticalLines::most_per_length() const { return lines_->most(); }

}  // namespace radcert
