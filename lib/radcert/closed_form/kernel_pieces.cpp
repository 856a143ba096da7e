// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/kernel_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/scalar/mpfr_real.h"

namespace radcert {

namespace {

PaddedRule conical(int points) {
  using Wide = Mpfr<50>;
  const IntervalRule<Wide> outer = gauss_rule<Wide>(points, IntervalWeight::variable);
  const IntervalRule<Wide> inner = gauss_rule<Wide>(points, IntervalWeight::one);
  PaddedRule rule;
  rule.points = points;
  const auto append = [&rule](const Wide& c0, const Wide& c1, const Wide& c2, const Wide& weight) {
    rule.barycentric[0].push_back(c0.to_double());
    rule.barycentric[1].push_back(c1.to_double());
    rule.barycentric[2].push_back(c2.to_double());
    rule.weights.push_back(weight.to_double());
  };
  for (std::size_t i = 0; i < outer.nodes.size(); ++i) {
    for (std::size_t j = 0; j < inner.nodes.size(); ++j) {
      append(Wide(1) - outer.nodes[i], outer.nodes[i] * (Wide(1) - inner.nodes[j]),
             outer.nodes[i] * inner.nodes[j], outer.weights[i] * inner.weights[j]);
    }
  }
  while (rule.weights.size() % Pack::lanes != 0) append(1, 0, 0, 0);
  return rule;
}

const std::vector<PaddedRule>& rules() {
  static const std::vector<PaddedRule> all = [] {
    std::vector<PaddedRule> made;
    for (const int points : {3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 20, 24, 28, 34, 40}) {
      made.push_back(conical(points));
    }
    return made;
  }();
  return all;
}

PieceCorner middle(const PieceCorner& a, const PieceCorner& b) {
  PieceCorner c;
  c.x = between(a.x, b.x, 0.5);
  c.y = between(a.y, b.y, 0.5);
  c.level = between(a.level, b.level, 0.5);
  for (std::size_t k = 0; k < 3; ++k) c.barycentric[k] = 0.5 * (a.barycentric[k] + b.barycentric[k]);
  return c;
}

/// Where a side is cut.
struct Cut {
  PieceCorner corner;
  double from_seen = 0;    ///< the part of the side from the corner that is seen to the cut
  double from_unseen = 0;  ///< the other part
};

Cut cut(const PieceCorner& seen, const PieceCorner& unseen) {
  const DoubleDouble drop = seen.level - unseen.level;
  const DoubleDouble share = seen.level / drop;
  const DoubleDouble rest = -unseen.level / drop;
  Cut result;
  result.corner.x = between(seen.x, unseen.x, share);
  result.corner.y = between(seen.y, unseen.y, share);
  for (std::size_t k = 0; k < 3; ++k) {
    // Both corners are corners of the triangle that is cut: one product at most is not zero, or both are the
    // same number.
    result.corner.barycentric[k] = rest.head * seen.barycentric[k] + share.head * unseen.barycentric[k];
  }
  result.from_seen = share.head;
  result.from_unseen = rest.head;
  return result;
}

}  // namespace

const PaddedRule* fitting_rule(double ratio, double needed, int degree) {
  if (!(needed > 0)) return nullptr;
  const double log_ratio = std::log(ratio);
  const double log_needed = std::log(needed);
  for (const PaddedRule& rule : rules()) {
    const int m = 2 * rule.points - 1 - degree - 1;
    // Beyond degree m the terms fall at least by this factor.
    const double fall = ratio * (m + 5.0) / (m + 2.0);
    constexpr double slowest = 0.95;
    if (m < 1 || fall > slowest) continue;
    const double coefficient = (m + 2.0) * (m + 3.0) * (m + 4.0) / (6 * (1 - fall));
    if (std::log(coefficient) + (m + 1) * log_ratio <= log_needed) return &rule;
  }
  return nullptr;
}

void append_visible(const KernelPiece& piece, std::vector<KernelPiece>& to) {
  std::array<bool, 3> seen{};
  int count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    seen[k] = piece.corner[k].level.head >= 0;
    count += seen[k] ? 1 : 0;
  }
  if (count == 0) return;
  if (count == 3) {
    to.push_back(piece);
    return;
  }
  std::size_t odd = 0;  // the corner on the other side than the two others
  while (seen[odd] != (count == 1)) ++odd;
  const PieceCorner& a = piece.corner[odd];
  const PieceCorner& b = piece.corner[(odd + 1) % 3];
  const PieceCorner& c = piece.corner[(odd + 2) % 3];
  const auto append = [&](const PieceCorner& p, const PieceCorner& q, const PieceCorner& r, double share) {
    KernelPiece part = piece;
    part.corner = {p, q, r};
    part.double_area = piece.double_area * share;
    part.whole = false;
    part.cut = true;
    to.push_back(part);
  };
  if (count == 1) {
    const Cut on_b = cut(a, b);
    const Cut on_c = cut(a, c);
    append(a, on_b.corner, on_c.corner, on_b.from_seen * on_c.from_seen);
  } else {
    const Cut on_b = cut(b, a);
    const Cut on_c = cut(c, a);
    append(b, c, on_c.corner, on_c.from_seen);
    append(b, on_c.corner, on_b.corner, on_b.from_seen * on_c.from_unseen);
  }
}

void append_quarters(const KernelPiece& piece, std::vector<KernelPiece>& to) {
  const auto& [a, b, c] = piece.corner;
  const PieceCorner ab = middle(a, b);
  const PieceCorner bc = middle(b, c);
  const PieceCorner ca = middle(c, a);
  const std::array<std::array<PieceCorner, 3>, 4> parts{
      {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}};
  for (const auto& part : parts) {
    KernelPiece quarter = piece;
    quarter.corner = part;
    quarter.double_area = piece.double_area / 4;
    quarter.whole = false;
    ++quarter.halvings;
    to.push_back(quarter);
  }
}

void measure(KernelPiece& piece, double squared_height) {
  constexpr double rounding = 0x1p-48;
  const auto& [a, b, c] = piece.corner;
  const double x = (a.x.head + b.x.head + c.x.head) / 3;
  const double y = (a.y.head + b.y.head + c.y.head) / 3;
  piece.distance = std::sqrt(x * x + y * y + squared_height) * (1 - rounding);
  double squared_radius = 0;
  for (const PieceCorner& corner : piece.corner) {
    const double dx = corner.x.head - x;
    const double dy = corner.y.head - y;
    squared_radius = std::max(squared_radius, dx * dx + dy * dy);
  }
  piece.radius = std::sqrt(squared_radius) * (1 + rounding) + rounding * piece.distance;
}

double needed_tail(const KernelPiece& piece, double allowed, double area, double size) {
  const double squared = piece.distance * piece.distance;
  const double level =
      std::max({piece.corner[0].level.head, piece.corner[1].level.head, piece.corner[2].level.head});
  if (!(level > 0)) return std::numeric_limits<double>::infinity();
  return allowed * squared * squared / (2 * area * level * size);
}

double integral_behind(double area, double lowest, double largest, double height) {
  constexpr double rounding = 1.4;  // of the largest level, and of these products
  const double part = area * std::min(1.0, 2 * lowest / largest);
  return rounding * (lowest / height) * (part / (height * height));
}

/// A level: its tail left out 1, nodes 1, products and sums 3; weight 2; division 1; area 1, and 4 where it
/// is cut; height 1, length of the normal 3, the result 1. The distance: the edges 5 of a length of at most 2
/// ratio D, over a distance of (1 - ratio) D, and the sum 1. Its square w: twice that, the roundings of
/// squares and their sum 2, the squared height 3 of h^2 / w, which exceeds what the distance leaves of 3 w by
/// at most 1.5. The square of w doubles these, and 1.
double PieceSums::summand_roundings(double ratio) {
  const double distance = 10 * ratio / (1 - ratio) + 1;
  return 5 + 2 + 1 + 5 + 5.2 + 2 * (2 * distance + 3.5) + 1;
}

/// A block, the area 1, the lanes 3, the coefficient 1, the compensated total and the sums in long double;
/// and for every factor of a Bernstein polynomial the node 1, a product 1, and in a part of a triangle 2 for
/// its coordinates in all of it, which are nowhere above 1 and have the sum 1 also half computed.
double PieceSums::sum_roundings(int degree, bool whole) {
  static_assert(std::numeric_limits<long double>::digits >= 64);
  return static_cast<double>(rule_block - 1) + 5.2 + (whole ? 2 : 4) * degree;
}

PieceSums::PieceSums(int degree) : degree_(degree), count_(PlanePolynomial<double>::size_of(degree)) {
  clear();
}

void PieceSums::clear() {
  for (std::size_t k = 0; k < count_; ++k) totals_[k] = rests_[k] = Pack(0);
}

void PieceSums::add(const KernelPiece& piece, const PaddedRule& rule, double squared_height) {
  switch (degree_) {
    case 0: return add_in<0>(piece, rule, squared_height);
    case 1: return add_in<1>(piece, rule, squared_height);
    case 2: return add_in<2>(piece, rule, squared_height);
    default: return add_in<-1>(piece, rule, squared_height);
  }
}

/// A degree that the compiler knows keeps the sums in registers; -1 stands for any.
template <int known>
void PieceSums::add_in(const KernelPiece& piece, const PaddedRule& rule, double squared_height) {
  const int degree = known < 0 ? degree_ : known;
  const auto count = known < 0 ? count_ : static_cast<std::size_t>((known + 1) * (known + 2) / 2);
  const Pack h2(squared_height);
  const auto& [a, b, c] = piece.corner;
  const auto side = [](const DoubleDouble& from, const DoubleDouble& to) {
    return Pack((to.head - from.head) + (to.tail - from.tail));
  };
  const Pack x0(a.x.head);
  const Pack x0_tail(a.x.tail);
  const Pack y0(a.y.head);
  const Pack y0_tail(a.y.tail);
  const Pack x1 = side(a.x, b.x);
  const Pack x2 = side(a.x, c.x);
  const Pack y1 = side(a.y, b.y);
  const Pack y2 = side(a.y, c.y);
  const Pack area(piece.double_area);
  const std::array<Pack, 3> levels{Pack(a.level.head), Pack(b.level.head), Pack(c.level.head)};
  std::array<std::array<Pack, 3>, 3> barycentric;
  for (std::size_t k = 0; k < 3; ++k) {
    const double first = a.barycentric[k];
    barycentric[k] = {Pack(first), Pack(b.barycentric[k] - first), Pack(c.barycentric[k] - first)};
  }
  const std::size_t packs = rule.weights.size() / Pack::lanes;
  for (std::size_t start = 0; start < packs; start += rule_block) {
    std::array<Pack, most_monomials> block;
    for (std::size_t k = 0; k < count; ++k) block[k] = Pack(0);
    const std::size_t stop = std::min(packs, start + rule_block);
    for (std::size_t n = start; n < stop; ++n) {
      const Pack l0 = Pack::load(rule.barycentric[0].data() + n * Pack::lanes);
      const Pack l1 = Pack::load(rule.barycentric[1].data() + n * Pack::lanes);
      const Pack l2 = Pack::load(rule.barycentric[2].data() + n * Pack::lanes);
      const Pack x = fma(x1, l1, fma(x2, l2, x0_tail)) + x0;
      const Pack y = fma(y1, l1, fma(y2, l2, y0_tail)) + y0;
      const Pack w = fma(x, x, fma(y, y, h2));
      const Pack level = fma(levels[1], l1, fma(levels[2], l2, levels[0] * l0));
      const Pack g = level * Pack::load(rule.weights.data() + n * Pack::lanes) / (w * w);
      if (degree == 0) {
        block[0] += g;
        continue;
      }
      std::array<Pack, 3> lambda{l0, l1, l2};
      if (!piece.whole) {
        for (std::size_t k = 0; k < 3; ++k) {
          lambda[k] = fma(barycentric[k][1], l1, fma(barycentric[k][2], l2, barycentric[k][0]));
        }
      }
      std::array<Pack, most_monomials> products;
      products[0] = g;
      for (int power = 1; power <= degree; ++power) {
        const std::size_t before = PlanePolynomial<double>::size_of(power - 1);
        const auto without =
            static_cast<std::size_t>(power);  // as many of degree power - 1 are free of lambda_0
        for (std::size_t k = 0; k < without; ++k) {
          products[before + k] = products[before - without + k] * lambda[1];
        }
        products[before + without] = products[before - 1] * lambda[2];
        for (std::size_t k = 0; k < before; ++k) products[k] *= lambda[0];
      }
      for (std::size_t k = 0; k < count; ++k) block[k] += products[k];
    }
    for (std::size_t k = 0; k < count; ++k) {
      const Pack part = area * block[k];
      const Pack total = totals_[k] + part;
      const Pack added = total - totals_[k];
      rests_[k] += (totals_[k] - (total - added)) + (part - added);
      totals_[k] = total;
    }
  }
}

}  // namespace radcert
