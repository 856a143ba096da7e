// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/node_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radcert/collocation/nodes.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::by_piece;
using testing::everywhere;
using testing::fault_of;
using ::testing::HasSubstr;

std::vector<CollocationPoint<double>> nodes_of(const Surface& surface, double inset) {
  return collocation_nodes<double>(surface, triangulate(surface, 0), InsetBasis<double>(1, inset));
}

TEST(ValuesAtNodes, AreTheExpressionOfThePieceAtThePoint) {
  const Surface surface = two_piece(2);
  const std::vector<CollocationPoint<double>> nodes = nodes_of(surface, 0.125);
  const std::vector<double> values =
      values_at_nodes(by_piece({{"upper", "x + 2*y + 4*z"}, {"*", "-x"}}), "/solution", surface, nodes);
  ASSERT_EQ(values.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vector<double>& p = nodes[i].point;
    EXPECT_EQ(values[i], nodes[i].at.chart == 0 ? -p.x : p.x + 2 * p.y + 4 * p.z);
  }
}

TEST(ValuesAtNodes, RefusesAnInfiniteValueNamingTheNode) {
  // On the west face x = 0, and its first node is number 0 with (s,t) = (y,z) = (1/8, 1/8).
  const Surface surface = cube();
  const InputFault fault =
      fault_of([&] { values_at_nodes(everywhere("1/x"), "/solution", surface, nodes_of(surface, 0.125)); });
  EXPECT_EQ(fault.pointer, "/solution");
  EXPECT_EQ(fault.value, "1/x");
  EXPECT_THAT(fault.problem, HasSubstr("infinite at node 0 (0, 0.125, 0.125) on piece west"));
}

TEST(ValuesAtNodes, RefusesWhatIsNotANumberBelowThePieceThatStatesIt) {
  const Surface surface = cube();
  const auto refusal = [&](const PiecewiseExpression& function) {
    return fault_of([&] { values_at_nodes(function, "/emission", surface, nodes_of(surface, 0.125)); });
  };
  const InputFault named = refusal(by_piece({{"*", "1"}, {"ceiling", "log(-z)"}}));
  EXPECT_EQ(named.pointer, "/emission/ceiling");
  EXPECT_THAT(named.problem,
              HasSubstr("not a number at node 30 "));  // ten triangles of three nodes come before
  const InputFault rest = refusal(by_piece({{"west", "1"}, {"*", "sqrt(-x)"}}));
  EXPECT_EQ(rest.pointer, "/emission/*");
  EXPECT_THAT(rest.problem, HasSubstr("on piece east"));
}

TEST(ReflectivityAtNodes, AdmitsTheClosedUnitInterval) {
  const Surface surface = two_piece(2);
  const std::vector<CollocationPoint<double>> nodes = nodes_of(surface, 0);  // nodes at x = 0 and x = 1
  const std::vector<double> rho = reflectivity_at_nodes(everywhere("x"), surface, nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_EQ(rho[i], nodes[i].point.x);
}

TEST(ReflectivityAtNodes, RefusesValuesOutsideNamingTheNode) {
  const Surface surface = two_piece(2);
  for (const char* text : {"x + 1/8", "y - 1/4"}) {
    const InputFault fault =
        fault_of([&] { reflectivity_at_nodes(everywhere(text), surface, nodes_of(surface, 0)); });
    EXPECT_EQ(fault.pointer, "/reflectivity");
    EXPECT_EQ(fault.value, text);
    EXPECT_THAT(fault.problem, HasSubstr(" at node "));
    EXPECT_THAT(fault.problem, HasSubstr(" on piece lower"));
    EXPECT_THAT(fault.allowed, HasSubstr("[0, 1]"));
  }
}

}  // namespace
}  // namespace radcert
