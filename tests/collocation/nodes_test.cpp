// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert {
namespace {

TEST(CollocationNodes, AreOneABasisFunctionAndElement) {
  for (const Surface& surface : {two_piece(2), cube(), sphere()})
    for (int level = 0; level <= 2; ++level)
      for (int degree = 0; degree <= 4; ++degree) {
        const Triangulation triangulation = triangulate(surface, level);
        const InsetBasis<double> basis(degree, 0.125);
        const auto nodes = collocation_nodes<double>(surface, triangulation, basis);
        EXPECT_EQ(nodes.size(), triangulation.triangles.size() * basis.size());
      }
}

TEST(CollocationNodes, StandAtTheBasisNodesOfTheirElements) {
  // Level 0 of the sphere: vertices (0,0), (1,0), (0,1), so that (s,t) = (x_2, x_3), with no rounding.
  const Surface surface = sphere();
  const InsetBasis<double> basis(2, 0.125);
  const std::vector<Barycentric<double>> q = basis.nodes();
  const auto nodes = collocation_nodes<double>(surface, triangulate(surface, 0), basis);
  ASSERT_EQ(nodes.size(), 48U);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_EQ(nodes[i].at.chart, i / 6);
    EXPECT_EQ(nodes[i].at.at, (ParameterPoint<double>{q[i % 6].x[1], q[i % 6].x[2]}));
  }
}

TEST(CollocationNodes, AreImagesOfTheirParametersWithUnitNormals) {
  for (const Surface& surface : {two_piece(Rational(3, 2)), box(1, 2, 5), ellipsoid(1, 2, 5)}) {
    const Triangulation triangulation = triangulate(surface, 1);
    for (const CollocationPoint<double>& node :
         collocation_nodes<double>(surface, triangulation, InsetBasis<double>(1, 1.0 / 6))) {
      const Frame<double> frame = surface.charts[node.at.chart].in<double>().frame(node.at.at);
      EXPECT_EQ(node.point, frame.point);
      EXPECT_NEAR(norm(node.normal), 1, 4e-16);
      EXPECT_GT(dot(node.normal, frame.area_normal), 0);
    }
  }
}

TEST(CollocationNodes, OnTheSphereHaveTheInwardNormal) {
  for (const CollocationPoint<double>& node :
       collocation_nodes<double>(sphere(), triangulate(sphere(), 1), InsetBasis<double>(2, 0.1))) {
    EXPECT_NEAR(norm(node.point), 1, 4e-16);
    EXPECT_LT(norm(node.point + node.normal), 2e-15);
  }
}

TEST(CollocationNodes, AreRepeatedOnCommonVerticesExactlyWhenTheInsetIsZero) {
  const Surface surface = cube();
  const Triangulation triangulation = triangulate(surface, 1);
  const auto distinct = [&](double inset) {
    std::vector<std::array<double, 3>> places;
    for (const CollocationPoint<double>& node :
         collocation_nodes<double>(surface, triangulation, InsetBasis<double>(1, inset)))
      places.push_back({static_cast<double>(node.at.chart), node.at.at.s, node.at.at.t});
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places.size();
  };
  EXPECT_EQ(distinct(0.125), 144U);
  EXPECT_EQ(distinct(0), 54U);  // nine vertices a face
}

}  // namespace
}  // namespace radcert
