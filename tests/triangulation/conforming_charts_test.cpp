// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/triangulation/conforming_charts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert {
namespace {

using testing::HasSubstr;

TEST(ConformingCharts, HoldForWhatIsMadeHere) {
  for (const Surface& surface : {cube(), sphere(), two_piece(2)})
    for (int level = 0; level <= 3; ++level)
      for (const double grading : {1.0, 1.5, 3.0})
        EXPECT_TRUE(conforming(surface, triangulate(surface, level, {.diagonals = {}, .grading = grading})))
            << surface.name << " level " << level << " grading " << grading;
}

TEST(ConformingCharts, SeeAMovedVertexAMissingAndADoubledTriangle) {
  const Surface surface = cube();
  const Triangulation good = triangulate(surface, 2);
  Triangulation moved = good;
  moved.triangles[5].vertices[1].s += 0x1p-60 + 0x1p-40;
  EXPECT_THAT(conforming(surface, moved).reason(), HasSubstr("chart " + surface.charts[0].facts().name));
  Triangulation missing = good;
  missing.triangles.pop_back();
  EXPECT_THAT(conforming(surface, missing).reason(), HasSubstr(surface.charts.back().facts().name));
  Triangulation doubled = good;
  doubled.triangles.push_back(good.triangles[7]);
  EXPECT_THAT(conforming(surface, doubled).reason(), HasSubstr("T3"));
  Triangulation lost = good;
  lost.triangles[0].chart = surface.chart_count();
  EXPECT_THROW(static_cast<void>(conforming(surface, lost)), ContractViolation);
}

}  // namespace
}  // namespace radcert
