// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/contour_exchange.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"
#include "radcert/factors/contour_edges.h"
#include "radcert/factors/critical_lines.h"

namespace radcert {

namespace {

using Point = Vector<Rational>;

/// What of a polygon lies in front of a plane; nothing where that has no area or the polygon lies in it.
ExactCorners in_front(const ExactCorners& polygon, const ExactPlane& plane) {
  ExactCorners out;
  bool rises = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point& next = polygon[(k + 1) % polygon.size()];
    const Rational here = plane.height(polygon[k]);
    const Rational there = plane.height(next);
    rises = rises || here.sign() > 0;
    if (here.sign() >= 0) out.push_back(polygon[k]);
    if (here.sign() * there.sign() < 0)
      out.push_back(polygon[k] + (here / (here - there)) * (next - polygon[k]));
  }
  return rises && out.size() >= 3 ? out : ExactCorners{};
}

/// Lengths of about 1, near the origin: by a power of two, exactly.
class Placing {
public:
  explicit Placing(const ExactCorners& receiver, const ExactCorners& source) : origin_(receiver[0]) {
    double largest = 0;
    for (const ExactCorners* polygon : {&receiver, &source})
      for (const Point& p : *polygon)
        for (const Rational& x : {p.x - origin_.x, p.y - origin_.y, p.z - origin_.z})
          largest = std::max(largest, std::abs(x.to_double()));
    exponent_ = std::ilogb(largest) + 1;
    for (int k = 0; k < std::abs(exponent_); ++k) unit_ = exponent_ > 0 ? unit_ * 2 : unit_ / 2;
  }
  [[nodiscard]] ExactCorners operator()(const ExactCorners& polygon) const {
    ExactCorners out;
    for (const Point& p : polygon) out.push_back((1 / unit_) * (p - origin_));
    return out;
  }
  [[nodiscard]] double length() const { return std::ldexp(1.0, exponent_); }

private:
  Point origin_;
  Rational unit_ = 1;
  int exponent_ = 0;
};

struct Piece {
  double begin;
  double end;
  EdgeContribution contribution;
  [[nodiscard]] double error() const { return contribution.error + contribution.value.error(); }
  /// The largest error first, then the first piece.
  friend bool operator<(const Piece& a, const Piece& b) {
    return a.error() != b.error() ? a.error() < b.error() : a.begin > b.begin;
  }
};

struct Reached {
  BoundedDouble value;
  double error = 0;
};

constexpr double shortest = 0x1p-44;

/// Halves, or what is before a place of change, after it, and a short piece about it: multiples of
/// `shortest`.
std::vector<double> parts(const Piece& piece) {
  const double place = std::floor(piece.contribution.cut / shortest) * shortest;
  if (place - shortest > piece.begin && place + 2 * shortest < piece.end)
    return {piece.begin, place - shortest, place + 2 * shortest, piece.end};
  const double middle = std::round((piece.begin + (piece.end - piece.begin) / 2) / shortest) * shortest;
  return {piece.begin, middle, piece.end};
}

/// One edge: until the error is at most the demanded one, or the work is done.
Reached contribution(const CriticalLines& lines, double demanded, long& work) {
  std::priority_queue<Piece> pieces;
  const auto piece = [&](double begin, double end, const std::vector<std::size_t>& sides) {
    --work;
    return Piece{begin, end, lines.on(begin, end, sides, demanded)};
  };
  Reached out;
  pieces.push(piece(0, 1, lines.sides()));
  double error = pieces.top().error();
  while (!pieces.empty() && error > demanded && work > 0) {
    throw_if_interrupted();
    const Piece worst = pieces.top();
    pieces.pop();
    error -= worst.error();
    const std::vector<double> ends = parts(worst);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      Piece part = piece(ends[k], ends[k + 1], worst.contribution.sides);
      error += part.error();
      // Done with: what is shortest, and what is of no account.
      const double length = part.end - part.begin;
      if (length >= 2 * shortest && part.error() > demanded * length / 1024) {
        pieces.push(std::move(part));
      } else {
        out.value = out.value + part.contribution.value;
        out.error += part.contribution.error;
      }
    }
  }
  for (; !pieces.empty(); pieces.pop()) {
    out.value = out.value + pieces.top().contribution.value;
    out.error += pieces.top().contribution.error;
  }
  // A sum of fewer than 2^30 terms.
  out.error *= 1 + 0x1p-20;
  return out;
}

}  // namespace

const WorkLimit most_contour_pieces("factors/contour_exchange: pieces of edges", 400'000, 1,
                                    "the ball reached");

std::optional<Ball> contour_exchange_area(const ExactCorners& receiver, const ExactCorners& source,
                                          const std::vector<ExactCorners>& screens, const Ball& unoccluded,
                                          const ContourDemand& demand) {
  expects(receiver.size() >= 3 && source.size() >= 3, "polygons have three corners or more",
          named("receiver", receiver.size()), named("source", source.size()));
  expects(demand.radius > 0, "radius > 0", named("radius", demand.radius));
  const Placing placed(receiver, source);
  const ExactCorners ground = placed(receiver);
  const ExactCorners light = placed(source);
  const ExactPlane ground_plane(ground);
  const ExactPlane light_plane(light);
  std::vector<ExactCorners> between;
  for (const ExactCorners& screen : screens) {
    ExactCorners part = in_front(placed(screen), ground_plane);
    if (!part.empty()) part = in_front(part, light_plane);
    if (!part.empty()) between.push_back(std::move(part));
  }
  const auto edges = contour_edges(ground, light, between);
  if (!edges) return std::nullopt;
  double length = 0;
  const auto weight = [](const ContourEdge& edge) {
    const Point u = edge.to - edge.from;
    return std::sqrt(dot(u, u).to_double());
  };
  for (const ContourEdge& edge : *edges) length += weight(edge) * static_cast<double>(edge.parts.size());
  const double unit = placed.length();
  double left = demand.radius / (unit * unit);
  long work = demand.work_limit;
  Ball sum = 0;
  for (const ContourEdge& edge : *edges)
    for (const ContourEdge::Part& part : edge.parts) {
      // What one edge leaves of its share the others may use.
      const CriticalLines lines(ground, light, between, edge, part);
      const double share = left * weight(edge) / length;
      long part_of_work = std::max(1L, static_cast<long>(static_cast<double>(work) * weight(edge) / length));
      work -= part_of_work;
      const Reached reached = contribution(lines, share, part_of_work);
      work += part_of_work;
      const double error = (reached.value.error() + reached.error) * (1 + 0x1p-50);
      left = std::max(left - error, left * (1 - weight(edge) / length) / 2);
      length -= weight(edge);
      sum += widened(Ball(reached.value.value()), Ball(error));
    }
  return unoccluded + Ball(unit) * Ball(unit) * sum;
}

}  // namespace radcert
