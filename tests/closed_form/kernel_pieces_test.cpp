// SPDX-License-Identifier: GPL-3.0-or-later
// What PlaneElement's rules are made of, each by itself.
#include "radcert/closed_form/kernel_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/scalar/ball_precision.h"

namespace radcert {
namespace {

PieceCorner corner_at(double x, double y, double level) {
  PieceCorner corner;
  corner.x.head = x;
  corner.y.head = y;
  corner.level.head = level;
  return corner;
}

/// A right-angled triangle with the legs `size` at (x, y).
KernelPiece piece_at(double x, double y, double size, double level) {
  KernelPiece piece;
  piece.corner = {corner_at(x, y, level), corner_at(x + size, y, level), corner_at(x, y + size, level)};
  for (std::size_t k = 0; k < 3; ++k) piece.corner[k].barycentric[k] = 1;
  piece.double_area = size * size;
  return piece;
}

TEST(FittingRule, LeavesATailWithinWhatIsNeeded) {
  // Gegenbauer's series at the cosine 1, where it is largest, term by term.
  double closest = 0;
  for (double ratio = 0.02; ratio < 0.6; ratio *= 1.1)
    for (double needed = 1e-16; needed < 1e-2; needed *= 3)
      for (const int degree : {0, 1, 4, 8}) {
        const PaddedRule* rule = fitting_rule(ratio, needed, degree);
        if (rule == nullptr) continue;
        const int exact_to = 2 * rule->points - 1 - degree - 1;
        double tail = 0;
        for (int k = exact_to + 400; k > exact_to; --k)
          tail += (k + 1.0) * (k + 2.0) * (k + 3.0) / 6 * std::pow(ratio, k);
        EXPECT_LE(tail, needed * (1 + 1e-12)) << ratio << " " << needed << " " << degree;
        closest = std::max(closest, tail / needed);
      }
  EXPECT_GT(closest, 0.8);
}

// Put together from what the header states: the pieces' truncations sum to what is allowed.
TEST(FittingRule, SharesWhatIsAllowedAmongThePieces) {
  std::array pieces{piece_at(0.25, 0.5, 0.125, 3), piece_at(-2, 1, 0.5, 0.125), piece_at(4, 4, 1, 20)};
  double area = 0;
  for (KernelPiece& piece : pieces) {
    piece.corner[1].level.head /= 4;
    piece.corner[2].level.head = 0;
    measure(piece, 1);
    area += piece.double_area / 2;
  }
  constexpr double allowed = 1e-9;
  constexpr double size = 7;
  double truncation = 0;
  for (const KernelPiece& piece : pieces) {
    const double tail = needed_tail(piece, allowed, area, size);
    const double largest_numerator = piece.corner[0].level.head;
    truncation +=
        2 * (piece.double_area / 2) * largest_numerator * std::pow(piece.distance, -4) * tail * size;
  }
  EXPECT_LE(truncation, allowed * (1 + 1e-14));
  EXPECT_GE(truncation, allowed * (1 - 1e-14));
}

TEST(KernelPiece, IsWithinItsRadiusOfItsCentre) {
  std::mt19937 draw(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    KernelPiece piece;
    double x = 0;
    double y = 0;
    for (PieceCorner& corner : piece.corner) {
      corner = corner_at(number(draw), number(draw), 1);
      x += corner.x.head / 3;
      y += corner.y.head / 3;
    }
    const double height = 0.1 + std::abs(number(draw));
    measure(piece, height * height);
    double farthest = 0;
    for (const PieceCorner& corner : piece.corner)
      farthest = std::max(farthest, std::hypot(corner.x.head - x, corner.y.head - y));
    EXPECT_GE(piece.radius, farthest);
    EXPECT_LE(piece.radius, farthest * (1 + 1e-12));
    EXPECT_LE(piece.distance, std::hypot(x, y, height));
    EXPECT_GE(piece.distance, std::hypot(x, y, height) * (1 - 1e-12));
  }
}

TEST(PieceSums, KeepWhatIsSmallBesideTheTotal) {
  // A piece, and a hundred thousand of which each is below the last place of the total.
  const PaddedRule* rule = fitting_rule(0.1, 1e-10, 0);
  ASSERT_NE(rule, nullptr);
  const KernelPiece large = piece_at(0, 0, 0.01, 1);
  const KernelPiece small = piece_at(0, 0, 0.01, 1e-17);
  PieceSums alone(0);
  alone.add(large, *rule, 1);
  PieceSums sums(0);
  sums.add(large, *rule, 1);
  constexpr int many = 100000;
  for (int k = 0; k < many; ++k) sums.add(small, *rule, 1);
  const auto added = static_cast<double>((sums.moment(0) - alone.moment(0)) / alone.moment(0));
  EXPECT_NEAR(added, many * 1e-17, 1e-15);
}

// A triangle that is small against the height: what is behind, from the side of the plane that sees it.
TEST(IntegralBehind, ContainsWhatTheTangentPlaneHides) {
  double closest = 0;
  for (const long depth : {1L, 4L, 64L, 4096L}) {
    const Rational lowest(1, 256 * depth);
    const Rational largest(1, 64);
    const Rational wide(1, 128);
    const PlanePolygon polygon =
        plane_polygon({Vector<Rational>{-lowest, -wide, 0}, {largest, 0, 0}, {-lowest, wide, 0}}).value();
    PlanePolynomial<Rational> one(0);
    one(0, 0) = 1;
    const BallPrecision precision(256);
    const Ball exact = point_to_polygon({0, 0, 1}, {-1, 0, 0}, polygon, one);
    const double area = (wide * (largest + lowest)).to_double();
    const double bound = integral_behind(area, lowest.to_double(), largest.to_double(), 1);
    EXPECT_TRUE(certainly_at_most(abs(exact), Ball(bound))) << depth;
    closest = std::max(closest, abs(exact).lower_double() / bound);
  }
  EXPECT_GT(closest, 0.3);
}

Vector<Rational> drawn_corner(std::mt19937& draw, double size) {
  std::uniform_int_distribution<long> number(-100000, 100000);
  const Rational scale = Rational::exactly(size) / 100003;
  return {scale * number(draw), scale * number(draw), Rational(number(draw) + 100001, 70001)};
}

DoubleDouble rounded(const Rational& x) { return double_double(Mpfr<50>(x)); }

/// A rule of one pack, of which one node counts.
PaddedRule one_node(const std::array<Rational, 3>& node, const Rational& weight) {
  PaddedRule rule;
  rule.points = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    rule.barycentric[k].assign(Pack::lanes, 0);
    rule.barycentric[k][0] = node[k].to_double();
  }
  rule.weights.assign(Pack::lanes, 0);
  rule.weights[0] = weight.to_double();
  return rule;
}

// A single summand: no sum rounds, only the product with the area does.
TEST(PieceSums, SummandsAreWithinTheirRoundings) {
  std::mt19937 draw(6);
  std::uniform_int_distribution<long> share(1, 1000);
  double closest = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const Rational height(share(draw), 301);
    const Vector<Rational> about = drawn_corner(draw, 3);
    std::array<Vector<Rational>, 3> corner;
    KernelPiece piece;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = about + drawn_corner(draw, 0.5);
      piece.corner[k].x = rounded(corner[k].x);
      piece.corner[k].y = rounded(corner[k].y);
      piece.corner[k].level = rounded(corner[k].z);
      piece.corner[k].barycentric[k] = 1;
    }
    const auto across = [&corner](std::size_t k) {
      return ParameterPoint<Rational>{corner[k].x - corner[0].x, corner[k].y - corner[0].y};
    };
    const Rational double_area = abs(cross(across(1), across(2)));
    piece.double_area = double_area.to_double();
    const double rounded_height = height.to_double();
    const double squared_height = rounded_height * rounded_height;
    measure(piece, squared_height);
    const double ratio = piece.radius / piece.distance;
    if (ratio > 0.4) continue;
    std::array<Rational, 3> node{share(draw), share(draw), share(draw)};
    const Rational whole = node[0] + node[1] + node[2];
    Vector<Rational> at;
    for (std::size_t k = 0; k < 3; ++k) {
      node[k] = node[k] / whole;
      at = at + node[k] * corner[k];
    }
    const Rational weight(share(draw), 2003);
    PieceSums sums(0);
    sums.add(piece, one_node(node, weight), squared_height);
    const double found = static_cast<double>(sums.moment(0)) * rounded_height;
    const Rational w = at.x * at.x + at.y * at.y + height * height;
    const Rational exact = double_area * at.z * weight * height / (w * w);
    const double off = (abs(Rational::exactly(found) - exact) / exact).to_double() * 0x1p53;
    // That of the area, and of the result here.
    const double allowed = PieceSums::summand_roundings(ratio) + 2;
    EXPECT_LE(off, allowed) << trial;
    closest = std::max(closest, off / allowed);
  }
  EXPECT_GT(closest, 0.1);
  RecordProperty("closest", std::to_string(closest));
}

// All corners of the piece are at the foot, and its levels are 1: summands are the weights, exactly. Among
// all polynomials with Bernstein coefficients 1 and -1 there is the one for which all errors add up.
TEST(PieceSums, SumsAreWithinTheirRoundings) {
  std::mt19937 draw(7);
  std::uniform_int_distribution<long> share(0, 1L << 26U);
  const auto drawn_node = [&] {
    std::array<long, 2> cuts{share(draw), share(draw)};
    std::sort(cuts.begin(), cuts.end());
    const Rational unit = power(Rational(1, 2), 26);
    return std::array<Rational, 3>{unit * cuts[0], unit * (cuts[1] - cuts[0]),
                                   unit * ((1L << 26U) - cuts[1])};
  };
  for (const bool whole : {true, false}) {
    for (const int degree : {0, 1, 2, 5, 8}) {
      double closest = 0;
      for (int trial = 0; trial < 4; ++trial) {
        KernelPiece piece = piece_at(0, 0, 0, 1);
        std::array<std::array<Rational, 3>, 3> inside{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        piece.whole = whole;
        for (std::size_t c = 0; c < 3; ++c) {
          if (!whole) inside[c] = drawn_node();
          for (std::size_t k = 0; k < 3; ++k) piece.corner[c].barycentric[k] = inside[c][k].to_double();
        }
        piece.double_area = std::ldexp(static_cast<double>(draw() | 1U), 21) + draw();
        PaddedRule rule;
        std::vector<std::array<Rational, 3>> nodes;
        for (std::size_t n = 0; n < PieceSums::rule_block * Pack::lanes; ++n) {
          nodes.push_back(drawn_node());
          for (std::size_t k = 0; k < 3; ++k) rule.barycentric[k].push_back(nodes[n][k].to_double());
          // The first one of a lane is the largest: the others are lost to halves of its last place.
          rule.weights.push_back(
              std::ldexp(1 + draw() * 0x1p-32, n < Pack::lanes ? 0 : -static_cast<int>(draw() % 54)));
        }
        PieceSums sums(degree);
        sums.add(piece, rule, 1);
        Rational off;
        Rational sum;
        std::size_t place = 0;
        for (int m = 0; m <= degree; ++m) {
          for (int c = 0; c <= m; ++c) {
            Rational exact;
            for (std::size_t n = 0; n < nodes.size(); ++n) {
              std::array<Rational, 3> lambda;
              for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t i = 0; i < 3; ++i) lambda[k] += inside[i][k] * nodes[n][i];
              exact += Rational::exactly(rule.weights[n]) * power(lambda[0], degree - m) *
                       power(lambda[1], m - c) * power(lambda[2], c);
            }
            exact *= Rational::exactly(piece.double_area);
            Rational multinomial = 1;
            for (int k = 1; k <= degree; ++k) multinomial *= k;
            for (const int part : {degree - m, m - c, c})
              for (int k = 1; k <= part; ++k) multinomial /= k;
            const long double moment = sums.moment(place++);
            const auto head = static_cast<double>(moment);
            const auto tail = static_cast<double>(moment - static_cast<long double>(head));
            off += multinomial * abs(Rational::exactly(head) + Rational::exactly(tail) - exact);
            sum += multinomial * exact;
          }
        }
        const double found = (off / sum).to_double() * 0x1p53;
        const double allowed = PieceSums::sum_roundings(degree, whole);
        EXPECT_LE(found, allowed) << degree;
        closest = std::max(closest, found / allowed);
      }
      EXPECT_GT(closest, 0.02) << degree;
      RecordProperty((whole ? "whole" : "part") + std::to_string(degree), std::to_string(closest));
    }
  }
}

}  // namespace
}  // namespace radcert
