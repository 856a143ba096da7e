// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/plane_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/core/contract.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Point = Vector<double>;
using Polynomial = PlanePolynomial<Rational>;
using Functions = std::shared_ptr<const TriangleFunctions>;
using Corners = PlaneTriangle::Corners;

Vector<Rational> exactly(const Point& a) {
  return {Rational::exactly(a.x), Rational::exactly(a.y), Rational::exactly(a.z)};
}

std::vector<Polynomial> monomials(int degree) {
  std::vector<Polynomial> all;
  for (int n = 0; n <= degree; ++n) {
    for (int j = 0; j <= n; ++j) {
      Polynomial q(n);
      q(n - j, j) = 1;
      all.push_back(q);
    }
  }
  return all;
}

Functions prepared(const std::vector<Polynomial>& functions) {
  return std::make_shared<const TriangleFunctions>(functions);
}

/// Interpolates at (1/6, 1/6), (2/3, 1/6), (1/6, 2/3).
std::vector<Polynomial> inset_functions() {
  std::vector<Polynomial> all(3, Polynomial(1));
  all[0](0, 0) = Rational(5, 3);
  all[0](1, 0) = all[0](0, 1) = -2;
  all[1](0, 0) = all[2](0, 0) = Rational(-1, 3);
  all[1](1, 0) = all[2](0, 1) = 2;
  return all;
}

double largest(const Polynomial& q) {
  double size = 0;
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; i + j <= 16; ++j) {
      size = std::max(size, std::abs(q.value(Rational(i, 16), Rational(j, 16)).to_double()));
    }
  }
  return size;
}

std::string shown(const Point& a) {
  return std::to_string(a.x) + " " + std::to_string(a.y) + " " + std::to_string(a.z);
}

class Sweep {
public:
  explicit Sweep(const std::vector<Polynomial>& functions)
      : functions_(functions), shared_(prepared(functions)) {
    for (const Polynomial& q : functions) {
      degree_ = std::max(degree_, q.degree());
      sizes_.push_back(largest(q));
    }
  }

  /// Compares with balls: the error of what is served is at most accuracy Int |G| max |q|.
  void check(const Corners& c, double accuracy, const Point& p, const Point& normal) {
    const PlaneTriangle triangle(c, shared_, accuracy);
    std::vector<double> values(functions_.size(), 1.0);
    ++asked;
    if (!triangle.integrals(p, normal, values)) {
      for (const double value : values) ASSERT_EQ(value, 0);
      return;
    }
    ++served;
    const PlanePolygon polygon = plane_polygon(exactly(c[0]), exactly(c[1]) - exactly(c[0]),
                                               exactly(c[2]) - exactly(c[0]), {{{0, 0}, {1, 0}, {0, 1}}})
                                     .value();
    const BallPrecision precision(320);
    const std::vector<Ball> moments =
        point_to_polygon_moments<Ball>(exactly(p), exactly(normal), polygon, degree_);
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      Ball exact;
      for (std::size_t n = 0; n < functions_[k].coefficients().size(); ++n) {
        exact += Ball(functions_[k].coefficients()[n]) * moments[n];
      }
      const double size = abs(moments[0]).upper_double() * sizes_[k];
      ASSERT_LE(exact.radius(), 1e-18 * size);
      const double error = abs(Ball(values[k]) - exact).upper_double();
      ASSERT_LE(error, accuracy * size)
          << "P = " << shown(p) << ", n = " << shown(normal) << ", function " << k;
      if (size > 0) worst = std::max(worst, error / size);
    }
  }

  int asked = 0;
  int served = 0;
  double worst = 0;

private:
  std::vector<Polynomial> functions_;
  Functions shared_;
  std::vector<double> sizes_;
  int degree_ = 0;
};

Point direction(Draw& draw) {
  const double z = 2 * draw.unit() - 1;
  const double turn = 2 * std::numbers::pi * draw.unit();
  const double flat = std::sqrt(1 - z * z);
  return {flat * std::cos(turn), flat * std::sin(turn), z};
}

const Corners oblique{Point{0.1, 0, 0}, {1, 0.1, 0.2}, {0.3, 1, 0.1}};
const Corners thin{Point{0, 0, 0}, {0.3, 0.02, 0}, {1, 0, 0}};

TEST(PlaneTriangle, StaysWithinItsAccuracyWholeAndCut) {
  Draw draw(21);
  for (int degree = 0; degree <= 3; ++degree) {
    Sweep whole(monomials(degree));
    Sweep cut(monomials(degree));
    for (const Corners& c : {oblique, thin, Corners{oblique[2], oblique[1], oblique[0]}}) {
      for (const double distance : {1e-6, 1e-3, 0.03, 0.1, 0.3, 0.6, 1.0, 2.0, 10.0}) {
        for (int i = 0; i < 6; ++i) {
          const double share = draw.unit();
          // Over the inside, an edge, a corner, and beside.
          Point foot = c[0] + share * (c[1] - c[0]);
          if (i == 1) foot = c[0];
          if (i > 1) foot = foot + (0.2 + 0.2 * i * draw.unit()) * (c[2] - foot);
          const Point p = foot + distance * direction(draw);
          const double accuracy = i % 2 == 0 ? 1e-13 : 1e-14;
          const Point to_centre = (1.0 / 3) * (c[0] + c[1] + c[2]) - p;
          whole.check(c, accuracy, p, 3.0 * to_centre);
          cut.check(c, accuracy, p, direction(draw));
        }
      }
    }
    RecordProperty("worst" + std::to_string(degree), std::to_string(1e16 * std::max(whole.worst, cut.worst)));
    RecordProperty("served" + std::to_string(degree), whole.served);
    EXPECT_GT(whole.served, degree == 0 ? 70 : 20);
    EXPECT_GT(cut.served, degree == 0 ? 70 : 40);
  }
}

/// Two adjacent faces of a cube in squares of side 1/8 halved by diagonals; the observers are the nodes of one at the triangles
/// of the other, nearer than 1.35 radii. Turned, the tangent plane meets the element up to a rounding.
TEST(PlaneTriangle, ServesAdjacentFacesOfACube) {
  const auto exact = [](double x, double y, double z) { return Point{x, y, z}; };
  const auto turned = [](double x, double y, double z) {
    return Point{0.6 * x - 0.8 * y, 0.48 * x + 0.36 * y - 0.8 * z, 0.64 * x + 0.48 * y + 0.6 * z};
  };
  for (int degree = 0; degree <= 2; ++degree) {
    for (int turn = 0; turn < 2; ++turn) {
      Sweep sweep(degree == 1 ? inset_functions() : monomials(degree));
      const auto place = [&](double x, double y, double z) {
        return turn == 0 ? exact(x, y, z) : turned(x, y, z);
      };
      constexpr double side = 0.125;
      for (const int upper : {0, 1}) {
        for (const double column : {3.0, 4.0}) {
          const double x = upper == 0 ? 0 : side;
          const Corners c{place(x, (column + upper) * side, 0), place(side - x, (column + upper) * side, 0),
                          place(x, (column + 1 - upper) * side, 0)};
          const Point centre = (1.0 / 3) * (c[0] + c[1] + c[2]);
          const double radius = std::max({norm(c[0] - centre), norm(c[1] - centre), norm(c[2] - centre)});
          const Point inward = place(1, 0, 0) - place(0, 0, 0);
          for (int row = 0; row < 3; ++row) {
            for (int across = 0; across < 8; ++across) {
              for (const auto& node :
                   {std::array{1.0 / 6, 1.0 / 6}, {2.0 / 3, 1.0 / 6}, {1.0 / 6, 2.0 / 3}}) {
                const Point p = place(0, (across + node[0]) * side, (row + node[1]) * side);
                if (norm(p - centre) < 1.35 * radius) sweep.check(c, 1e-13, p, inward);
              }
            }
          }
        }
      }
      RecordProperty("served" + std::to_string(degree), sweep.served);
      EXPECT_GT(sweep.asked, 10);
      // Monomials of degree 2 ask for more than their largest coefficient says: max |s t| = 1/4.
      EXPECT_GE(4 * sweep.served, (degree == 0 ? 4 : degree == 1 ? 2 : 1) * sweep.asked);
    }
  }
}

struct Look {
  Point p;
  Point normal;
};

/// Some see all of the triangle, some a part, some nothing.
std::vector<Look> looks(std::uint64_t seed, std::size_t count) {
  Draw draw(seed);
  std::vector<Look> all(count);
  for (Look& look : all) {
    look.p = Point{draw.unit(), draw.unit(), 0.05} + 0.5 * draw.unit() * direction(draw);
    look.normal = draw.below(2) == 0 ? direction(draw) : Point{0.4, 0.4, 0.1} - look.p;
  }
  return all;
}

TEST(PlaneTriangle, GivesTheSameBitsAloneAndInABlock) {
  for (int degree = 0; degree <= 3; ++degree) {
    const PlaneTriangle triangle(oblique, prepared(monomials(degree)), 1e-13);
    const std::size_t count = triangle.function_count();
    const std::vector<Look> all = looks(22, 400);
    std::vector<Pack> block(count);
    std::vector<double> alone(count);
    for (std::size_t start = 0; start < all.size(); start += Pack::lanes) {
      Vector<Pack> p;
      Vector<Pack> normal;
      for (std::size_t i = 0; i < Pack::lanes; ++i) {
        const Look& look = all[start + i];
        p.x.set_lane(i, look.p.x);
        p.y.set_lane(i, look.p.y);
        p.z.set_lane(i, look.p.z);
        normal.x.set_lane(i, look.normal.x);
        normal.y.set_lane(i, look.normal.y);
        normal.z.set_lane(i, look.normal.z);
      }
      const unsigned served = triangle.integrals(p, normal, block);
      for (std::size_t i = 0; i < Pack::lanes; ++i) {
        const bool good = triangle.integrals(all[start + i].p, all[start + i].normal, alone);
        ASSERT_EQ(good, (served >> i & 1U) != 0);
        for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(alone[k], block[k].lane(i));
      }
    }
  }
}

TEST(PlaneTriangle, DoesNotDependOnUnits) {
  const Functions functions = prepared(monomials(1));
  const PlaneTriangle triangle(oblique, functions, 1e-13);
  std::vector<double> values(3);
  std::vector<double> others(3);
  for (const double scale : {0x1p-40, 0x1p30}) {
    const PlaneTriangle scaled({scale * oblique[0], scale * oblique[1], scale * oblique[2]}, functions,
                               1e-13);
    for (const Look& look : looks(23, 100)) {
      const bool served = triangle.integrals(look.p, look.normal, values);
      EXPECT_EQ(scaled.integrals(scale * look.p, 0x1p20 * look.normal, others), served);
      EXPECT_EQ(values, others);
    }
  }
}

TEST(PlaneTriangle, AddsUpOverPartsAndFunctions) {
  const Point middle = 0.5 * (oblique[1] + oblique[2]);
  const Functions one = prepared(monomials(0));
  const PlaneTriangle whole(oblique, one, 1e-13);
  const PlaneTriangle first({oblique[0], oblique[1], middle}, one, 1e-13);
  const PlaneTriangle second({oblique[0], middle, oblique[2]}, one, 1e-13);
  const PlaneTriangle inset(oblique, prepared(inset_functions()), 1e-13);
  int compared = 0;
  for (const Look& look : looks(24, 200)) {
    std::array<double, 1> a{};
    std::array<double, 1> b{};
    std::array<double, 1> c{};
    std::array<double, 3> parts{};
    const bool served = whole.integrals(look.p, look.normal, a);
    if (served && first.integrals(look.p, look.normal, b) && second.integrals(look.p, look.normal, c)) {
      EXPECT_NEAR(a[0], b[0] + c[0], 2e-13 * std::abs(a[0]));
      ++compared;
    }
    if (served && inset.integrals(look.p, look.normal, parts)) {
      EXPECT_NEAR(a[0], parts[0] + parts[1] + parts[2], 1e-12 * std::abs(a[0]));
      ++compared;
    }
  }
  EXPECT_GT(compared, 150);
}

TEST(PlaneTriangle, RefusesWhatItCannotBound) {
  const Functions functions = prepared(monomials(1));
  const PlaneTriangle triangle({Point{0, 0, 0}, {1, 0, 0}, {0.25, 1, 0}}, functions, 1e-13);
  std::vector<double> values(3, 1.0);
  EXPECT_TRUE(triangle.integrals({0.3, 0.3, 1}, {0, 0, 1}, values));
  EXPECT_EQ(values, std::vector<double>(3, 0.0));
  EXPECT_TRUE(triangle.integrals({0.3, 0.3, 0.5}, {0, 0, -1}, values));
  EXPECT_FALSE(triangle.integrals({0.3, 0.3, 0}, {0, 0, -2}, values));
  EXPECT_FALSE(triangle.integrals({0.5, 0, 0}, {0, 1, 1}, values));
  EXPECT_FALSE(triangle.integrals({1e9, 1e9, 1}, {-1, -1, 0}, values));
  EXPECT_FALSE(triangle.integrals({0.3, 0.3, 0.5}, {0, 0, 0}, values));
  EXPECT_FALSE(triangle.integrals({0.3, 0.3, HUGE_VAL}, {0, 0, -1}, values));
  EXPECT_EQ(values, std::vector<double>(3, 0.0));
  const PlaneTriangle line({Point{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, functions, 1e-13);
  EXPECT_FALSE(line.integrals({0, 0, 1}, {0, 0, -1}, values));
  std::vector<double> few(2);
  EXPECT_THROW((void)triangle.integrals({0, 0, 1}, {0, 0, -1}, few), ContractViolation);
  EXPECT_THROW(PlaneTriangle(oblique, nullptr), ContractViolation);
  EXPECT_THROW(PlaneTriangle(oblique, functions, 0), ContractViolation);
  EXPECT_THROW(TriangleFunctions({}), ContractViolation);
  EXPECT_THROW(TriangleFunctions({Polynomial(4)}), ContractViolation);
  EXPECT_THROW(TriangleFunctions({Polynomial(1)}), ContractViolation);
}

}  // namespace
}  // namespace radcert
