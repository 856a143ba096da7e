// SPDX-License-Identifier: GPL-3.0-or-later
// What PlaneElement's rules are made of, each by itself.
#include "radcert/closed_form/kernel_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

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

}  // namespace
}  // namespace radcert
