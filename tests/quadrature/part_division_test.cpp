// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/part_division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace radcert {
namespace {

using Part = ElementPart<double>;

Vector<double> image(const ParameterPoint<double>& at) { return {at.s, at.t, 0}; }

std::array<Vector<double>, 3> images(const Part& part) {
  return {image(part.vertices[0]), image(part.vertices[1]), image(part.vertices[2])};
}

double doubled_area(const Part& part) {
  return cross(part.vertices[1] - part.vertices[0], part.vertices[2] - part.vertices[0]);
}

Part triangle(const ParameterPoint<double>& a, const ParameterPoint<double>& b,
              const ParameterPoint<double>& c) {
  return whole_element<double>({0, {{a, b, c}}});
}

/// Of three orders of the corners: what is apex, foot or longest side must not depend on them.
std::vector<Part> turned(const Part& part) { return {part, part.rotated(1), part.rotated(2)}; }

/// Divided until each part is far from p, as a rule wants it; how many parts that are.
std::size_t far_parts(const Part& part, const Vector<double>& p) {
  PartDivision<double> division;
  std::vector<Part> pending{part};
  std::size_t far = 0;
  while (!pending.empty() && pending.size() < 20'000) {
    const Part next = pending.back();
    pending.pop_back();
    const std::array<Vector<double>, 3> at = images(next);
    const Vector<double> centre = 1.0 / 3 * (at[0] + at[1] + at[2]);
    double radius = 0;
    for (const Vector<double>& corner : at) radius = std::max(radius, norm(corner - centre));
    if (norm(p - centre) >= 1.8 * radius) {
      ++far;
      continue;
    }
    for (const Part& smaller : division.divide(next, at, p)) pending.push_back(smaller);
  }
  return pending.empty() ? far : 20'000;
}

TEST(PartDivision, CoversThePartAndKeepsCornersTogether) {
  const Vector<double> p{0.25, 0.0625, 1e-3};
  for (const Part& whole : {triangle({0, 0}, {0.5, 0}, {0.25, 0.75}),         // neither thin nor flat
                            triangle({0, 0}, {0x1p-12, 0}, {0, 1}),           // a short side
                            triangle({0, 0}, {0.75, 0}, {0.3125, 0x1p-8}),    // none, the foot inside
                            triangle({0, 0}, {1, 1}, {0.5, 0.5 + 0x1p-20})})  // along a diagonal
    for (const Part& part : turned(whole)) {
      PartDivision<double> division;
      double area = 0;
      std::size_t count = 0;
      for (const Part& smaller : division.divide(part, images(part), p)) {
        ++count;
        EXPECT_GT(doubled_area(smaller), 0);
        area += doubled_area(smaller);
        for (std::size_t k = 0; k < 3; ++k) {
          const std::array<double, 3>& x = smaller.corners[k].x;
          const ParameterPoint<double> at =
              x[0] * whole.vertices[0] + x[1] * whole.vertices[1] + x[2] * whole.vertices[2];
          EXPECT_EQ(at, smaller.vertices[k]);
          EXPECT_EQ(x[0] + x[1] + x[2], 1);
        }
        EXPECT_EQ(smaller.doubled_area, doubled_area(smaller));
      }
      EXPECT_GE(count, 2U);
      EXPECT_EQ(area, doubled_area(part));
    }
}

TEST(PartDivision, BisectsTheLongestSideOfWhatIsNotThin) {
  PartDivision<double> division;
  const Part part = triangle({0, 0}, {1, 0}, {0.25, 0.5});
  const std::span<const Part> halves = division.divide(part, images(part), {0, 0, 1});
  ASSERT_EQ(halves.size(), 2U);
  EXPECT_EQ(halves[0].vertices[2], (ParameterPoint<double>{0.5, 0}));
  EXPECT_EQ(halves[1].vertices[1], (ParameterPoint<double>{0.5, 0}));
}

TEST(PartDivision, LeavesFewPartsOfThinTriangles) {
  // Bisection of longest sides alone leaves more than 10 000 of the last.
  for (const double width : {1e-1, 1e-3, 1e-5, 1e-7})
    for (const double middle : {0.0, 0.02, 0.1, 0.3, 0.5, 0.707})
      for (const double place : {0.0, 0.01, 0.34, 0.61, 1.0})
        for (const double distance : {0.1, 1e-4, 1e-8}) {
          // With the middle corner above that share of the longest side, P at that share of it.
          const Part part = triangle({0, 0}, {1, 0}, {middle, width});
          const double scales = std::log2(1 / width) + std::log2(std::max(1.0, width / distance));
          for (const Part& one : turned(part))
            EXPECT_LE(far_parts(one, {place, -distance, distance}), 40 + 60 * scales)
                << width << " " << middle << " " << place << " " << distance;
        }
}

TEST(PartDivision, EndsWhereThePointIsACornerOrThePartHasNoLength) {
  PartDivision<double> division;
  const Part thin = triangle({0, 0}, {1, 0}, {0, 1e-9});
  EXPECT_LE(division.divide(thin, images(thin), {1, 0, 0}).size(), 210U);
  // P on what has no width, at its apex, at its end and between.
  for (const double width : {0.0, 1e-300, 1e-30, 1e-17})
    for (const double place : {0.0, 1e-9, 1.0 / 3, 0.75, 1.0}) {
      const Part line = triangle({0, 0}, {1, 0}, {0, width});
      for (const Part& part : turned(line)) {
        const std::size_t count = division.divide(part, images(part), {place, 0, 0}).size();
        EXPECT_GE(count, 2U);
        EXPECT_LE(count, 420U) << width << " " << place;
      }
    }
  const double nan = std::nan("");
  EXPECT_LE(division.divide(thin, images(thin), {nan, 0, 0}).size(), 4U);
  const Part point = triangle({0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5});
  EXPECT_EQ(division.divide(point, images(point), {0.5, 0.5, 0}).size(), 2U);
}

}  // namespace
}  // namespace radcert
