// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/kernel_pieces.h"

#include <algorithm>
#include <cmath>

#include "radcert/polynomial/gauss.h"
#include "radcert/polynomial/plane_polynomial.h"

namespace radcert {

namespace {

PaddedRule conical(int points) {
  const IntervalRule<double> outer = gauss_rule<double>(points, IntervalWeight::variable);
  const IntervalRule<double> inner = gauss_rule<double>(points, IntervalWeight::one);
  PaddedRule rule;
  rule.points = points;
  for (std::size_t i = 0; i < outer.nodes.size(); ++i) {
    for (std::size_t j = 0; j < inner.nodes.size(); ++j) {
      rule.first.push_back(outer.nodes[i] * (1 - inner.nodes[j]));
      rule.second.push_back(outer.nodes[i] * inner.nodes[j]);
      rule.weights.push_back(outer.weights[i] * inner.weights[j]);
    }
  }
  while (rule.weights.size() % Pack::lanes != 0) {
    rule.first.push_back(0);
    rule.second.push_back(0);
    rule.weights.push_back(0);
  }
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

PieceCorner between(const PieceCorner& a, const PieceCorner& b, double s) {
  PieceCorner c;
  c.x = between(a.x, b.x, s);
  c.y = between(a.y, b.y, s);
  c.level = a.level + s * (b.level - a.level);
  for (std::size_t k = 0; k < 3; ++k) {
    c.barycentric[k] = a.barycentric[k] + s * (b.barycentric[k] - a.barycentric[k]);
  }
  return c;
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
    seen[k] = piece.corner[k].level >= 0;
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
  const double from_b = b.level / (b.level - a.level);
  const double from_c = c.level / (c.level - a.level);
  const double towards_b = a.level / (a.level - b.level);
  const double towards_c = a.level / (a.level - c.level);
  const auto append = [&](const PieceCorner& p, const PieceCorner& q, const PieceCorner& r, double share) {
    KernelPiece part = piece;
    part.corner = {p, q, r};
    part.double_area = piece.double_area * share;
    part.whole = false;
    to.push_back(part);
  };
  PieceCorner on_b = count == 1 ? between(a, b, towards_b) : between(b, a, from_b);
  PieceCorner on_c = count == 1 ? between(a, c, towards_c) : between(c, a, from_c);
  on_b.level = 0;
  on_c.level = 0;
  if (count == 1) {
    append(a, on_b, on_c, towards_b * towards_c);
  } else {
    append(b, c, on_c, from_c);
    append(b, on_c, on_b, from_b * towards_c);
  }
}

void append_quarters(const KernelPiece& piece, std::vector<KernelPiece>& to) {
  const auto& [a, b, c] = piece.corner;
  const PieceCorner ab = between(a, b, 0.5);
  const PieceCorner bc = between(b, c, 0.5);
  const PieceCorner ca = between(c, a, 0.5);
  const std::array<std::array<PieceCorner, 3>, 4> parts{
      {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}};
  for (const auto& part : parts) {
    KernelPiece quarter = piece;
    quarter.corner = part;
    quarter.double_area = piece.double_area / 4;
    quarter.whole = false;
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
  const auto side = [](const Twofold& from, const Twofold& to) {
    return Pack((to.head - from.head) + (to.tail - from.tail));
  };
  const Pack x0(a.x.head);
  const Pack y0(a.y.head);
  const Pack x1 = side(a.x, b.x);
  const Pack x2 = side(a.x, c.x);
  const Pack y1 = side(a.y, b.y);
  const Pack y2 = side(a.y, c.y);
  const Pack area(piece.double_area);
  const std::array<Pack, 3> levels{Pack(a.level), Pack(b.level), Pack(c.level)};
  std::array<std::array<Pack, 3>, 3> barycentric;
  for (std::size_t k = 0; k < 3; ++k) {
    barycentric[k] = {Pack(a.barycentric[k]), Pack(b.barycentric[k]), Pack(c.barycentric[k])};
  }
  const std::size_t packs = rule.weights.size() / Pack::lanes;
  for (std::size_t start = 0; start < packs; start += rule_block) {
    std::array<Pack, most_monomials> block;
    for (std::size_t k = 0; k < count; ++k) block[k] = Pack(0);
    const std::size_t stop = std::min(packs, start + rule_block);
    for (std::size_t n = start; n < stop; ++n) {
      const Pack l1 = Pack::load(rule.first.data() + n * Pack::lanes);
      const Pack l2 = Pack::load(rule.second.data() + n * Pack::lanes);
      const Pack l0 = (Pack(1) - l1) - l2;
      const Pack x = fma(x1, l1, x2 * l2) + x0;
      const Pack y = fma(y1, l1, y2 * l2) + y0;
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
          lambda[k] = fma(barycentric[k][1], l1, fma(barycentric[k][2], l2, barycentric[k][0] * l0));
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
