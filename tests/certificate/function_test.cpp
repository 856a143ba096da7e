// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of functions: what bounds them, piece by piece and together.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/certificate/cell_supremum.h"
#include "radcert/certificate/check.h"
#include "radcert/certificate/function_facts.h"
#include "radcert/certificate/gauss_rule.h"
#include "radcert/continuous/function_enclosure.h"
#include "radcert/core/contract.h"
#include "tests/certificate/samples.h"
#include "tests/repeats.h"

namespace radcert::certificate {
namespace {

using radcert::test::Draw;
using radcert::test::rounded;
constexpr std::size_t all = 1U << 30U;

/// sum c_kl P_k(x) P_l(y).
double value(const std::vector<double>& c, int n_s, int n_t, double x, double y) {
  const std::vector<double> p_x = legendre(n_s - 1, x);
  const std::vector<double> p_y = legendre(n_t - 1, y);
  double sum = 0;
  for (std::size_t k = 0; k < p_x.size(); ++k)
    for (std::size_t l = 0; l < p_y.size(); ++l) sum += c[k * p_y.size() + l] * p_x[k] * p_y[l];
  return sum;
}

template <class Function>
double supremum_of(const Function& f, int n_s, int n_t, double radius) {
  std::vector<double> values;
  for (const double x : gauss_rule(n_s).near_nodes)
    for (const double y : gauss_rule(n_t).near_nodes) values.push_back(f(x, y));
  return cell_supremum(values, radius, n_s, n_t);
}

TEST(CellSupremum, IsJustAboveTheLargestValue) {
  Draw draw(41);
  for (int n_s = 1; n_s <= most_cell_nodes; n_s += 3)
    for (int n_t = 1; n_t <= most_cell_nodes; n_t += 5) {
      std::vector<double> c;
      for (int k = 0; k < n_s * n_t; ++k) c.push_back(draw() - 0.5);
      double most = 0;
      constexpr int points = 150;
      for (int a = 0; a <= points; ++a)
        for (int b = 0; b <= points; ++b) {
          const auto at = [](int k) { return -std::cos(std::numbers::pi * k / points); };
          most = std::max(most, std::abs(value(c, n_s, n_t, at(a), at(b))));
        }
      const double found =
          supremum_of([&](double x, double y) { return value(c, n_s, n_t, x, y); }, n_s, n_t, 0);
      EXPECT_GE(found, most) << n_s << " " << n_t;
      EXPECT_LE(found, 1.05 * most) << n_s << " " << n_t;
    }
}

TEST(CellSupremum, HoldsForTheLargestPolynomialsBetweenPoints) {
  const auto chebyshev = [](int k, double x) { return std::cos(k * std::acos(std::clamp(x, -1.0, 1.0))); };
  for (int n = 1; n <= most_cell_nodes; ++n)
    for (int k = 0; k < n; ++k) {
      const double found = supremum_of(
          [&](double x, double y) { return chebyshev(k, x) * chebyshev(n - 1 - k, y); }, k + 1, n - k, 0);
      EXPECT_GE(found, 1) << n << " " << k;
      EXPECT_LE(found, 1.045) << n << " " << k;
    }
}

/// Values that are all off by the radius, in the worst signs.
TEST(CellSupremum, CoversTheRadiusOfTheValues) {
  for (const int n : {1, 2, 5, 9, 16}) {
    double most = 0;
    for (int a = 0; a <= 2000; ++a) {
      double sum = 0;
      for (int i = 0; i < n; ++i) {
        double product = 1;
        const std::vector<double>& x = gauss_rule(n).near_nodes;
        for (int k = 0; k < n; ++k)
          if (k != i)
            product *= (-1 + 1e-3 * a - x[static_cast<std::size_t>(k)]) /
                       (x[static_cast<std::size_t>(i)] - x[static_cast<std::size_t>(k)]);
        sum += std::abs(product);
      }
      most = std::max(most, sum);
    }
    EXPECT_GE(interpolation_norm(n), most) << n;
    EXPECT_LE(interpolation_norm(n), 1.05 * most) << n;
    const std::vector<double> zeros(static_cast<std::size_t>(n * n));
    EXPECT_GE(cell_supremum(zeros, 1, n, n), most * most * (1 - 1e-3)) << n;
  }
}

TEST(CellSupremum, IsInfiniteWhereAValueIsNotKnown) {
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity()})
    for (const std::size_t k : {0U, 1U, 3U}) {
      std::vector<double> values(4, 0.5);
      values[k] = wrong;
      EXPECT_EQ(cell_supremum(values, 0, 2, 2), std::numeric_limits<double>::infinity());
    }
}

TEST(CellSupremum, RefusesNumbersOfNodesThatItHasNoTableOf) {
  EXPECT_THROW(static_cast<void>(cell_supremum(std::vector<double>(17), 0, 17, 1)), ContractViolation);
  EXPECT_THROW(static_cast<void>(cell_supremum(std::vector<double>(3), 0, 2, 2)), ContractViolation);
}

/// T 1_B(a)(P) on the unit cube for P on its floor, by rules about each vertex.
double mass_on_cube(double a, double x, double y) {
  const GaussRule& rule = gauss_rule(20);
  double sum = 0;
  for (int v = 0; v < 8; ++v) {
    const std::array<double, 3> vertex{static_cast<double>(v & 1), static_cast<double>(v >> 1 & 1),
                                       static_cast<double>(v >> 2 & 1)};
    // Two walls at each vertex; and the ceiling at the upper ones.
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == 2 && vertex[2] == 0) continue;
      const std::size_t one = (axis + 1) % 3;
      const std::size_t two = (axis + 2) % 3;
      for (std::size_t m = 0; m < 20; ++m)
        for (std::size_t l = 0; l < 20; ++l) {
          const double q = 0.5 * a * (1 + rule.near_nodes[m]);
          const double phi = 0.25 * std::numbers::pi * (1 + rule.near_nodes[l]);
          std::array<double, 3> at = vertex;
          at[one] += (vertex[one] == 0 ? 1 : -1) * q * std::cos(phi);
          at[two] += (vertex[two] == 0 ? 1 : -1) * q * std::sin(phi);
          const std::array<double, 3> d{at[0] - x, at[1] - y, at[2]};
          const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
          sum += 0.5 * a * 0.25 * std::numbers::pi * rule.near_weights[m] * rule.near_weights[l] * q *
                 std::abs(d[2] * d[axis]) / (squared * squared) * std::numbers::inv_pi;
        }
    }
  }
  return sum;
}

TEST(VertexMass, BoundsWhatTheNeighbourhoodsOfVerticesSend) {
  const VertexMass mass(test::bare_certificate("cube", 1, 0, 1));
  double closest = 0;
  Draw draw(42);
  for (int n = 0; n < 300; ++n) {
    const double d = 0.01 + 0.6 * draw() * draw();
    const double angle = 0.5 * std::numbers::pi * draw();
    const double x = d * std::cos(angle);
    const double y = d * std::sin(angle);
    if (std::hypot(x - 1, y) < d || std::hypot(x, y - 1) < d || x > 1 || y > 1) continue;
    const double a = d * (0.05 + 0.75 * draw());
    const double exact = mass_on_cube(a, x, y);
    const double bound = mass(Rational::exactly(a), Rational::exactly(d)).upper_double();
    EXPECT_GE(bound, exact) << a << " " << x << " " << y;
    closest = std::max(closest, exact / bound);
  }
  EXPECT_GT(closest, 0.6);
}

TEST(VertexMass, IsPutTogetherAsItIsStated) {
  // A face of the unit cube has four vertices in its plane, and four at the height 1; h = 1.
  const VertexMass mass(test::bare_certificate("cube", 1, 0, 1));
  const auto half_cone = [](double sine) {
    return (std::asin(sine) - sine * std::sqrt(1 - sine * sine)) / std::numbers::pi;
  };
  for (const auto& [a, d] : {std::pair(0.125, 0.25), std::pair(0.125, 0.625), std::pair(0.25, 0.5),
                             std::pair(0.0625, 0.75), std::pair(0.001953125, 0.125)}) {
    const double expected = half_cone(a / d) + 3 * half_cone(2 * a / std::max(2 * d, 1.0)) + 4 * a * a;
    const Ball found = mass(Rational::exactly(a), Rational::exactly(d));
    EXPECT_NEAR(found.to_double(), std::min(1.0, expected), 1e-12) << a << " " << d;
  }
}

TEST(VertexMass, GrowsWithTheRadiusAndFallsWithTheDistance) {
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const VertexMass mass(test::bare_certificate(name, 1, 0, 1));
    double before = 0;
    for (int k = 0; k <= 20; ++k) {
      const double now = mass(Rational(k, 40), Rational(1, 2)).upper_double();
      EXPECT_GE(now, before) << name;
      before = now;
    }
    // Half of a ball that touches the observer fills half of what it sees; within it there may be all.
    EXPECT_GE(before, 0.5);
    EXPECT_LE(before, 1);
    EXPECT_EQ(mass(Rational(501, 1000), Rational(1, 2)).to_double(), 1);
    EXPECT_GT(mass(Rational(1, 10), Rational(1, 5)).upper_double(),
              mass(Rational(1, 10), Rational(3, 10)).upper_double());
  }
}

/// A furnace with u = 1, q_0 = 1 - d: w_0 = 1 - d/2, rho t_0 = d/4, and |u - w_0| = d/2 is what follows.
/// At vertices more is claimed where it is to be checked: there |t_0| <= sup|w_0| + sup|q_0| alone is known.
PolyhedronCertificate furnace(const std::string& surface, double d, double slack, bool is_checked = false) {
  PolyhedronCertificate c = test::furnace_certificate(surface, d, 0, 1, 0);
  c.coefficients.resize(c.elements.size());
  for (std::size_t e = 0; e < c.elements.size(); ++e) {
    const Element& x = c.elements[e];
    const bool is_at_vertex = x.t0 == 0 && (x.s0 == 0 || x.s1 == 1);
    c.claims[e] = {.largest = is_checked && is_at_vertex ? 1.01 * (1 - 0.75 * d) : slack * 0.25 * d};
  }
  c.sums = {};
  c.enclosures.clear();
  c.outside = Rational(1, 2);
  for (const Rational& distance : {Rational(1), Rational(1, 2), Rational(1, 4), Rational(0)})
    c.by_distance.push_back({.outside = distance, .sup = 0});
  const std::vector<Rational> bounds = bounds_by_distance(c);
  for (std::size_t m = 0; m < bounds.size(); ++m) c.by_distance[m].sup = bounds[m];
  c.width = Rational(2) * bounds[1];
  return c;
}

TEST(FunctionFault, FindsTheErrorOfAConstantResidual) {
  const PolyhedronCertificate c = furnace("tetrahedron", 0.25, 1);
  EXPECT_FALSE(function_fault(c));
  for (const BoundAtDistance& bound : c.by_distance) {
    EXPECT_GE(bound.sup, Rational(1, 8));
    EXPECT_LE(bound.sup, Rational(1, 8) * Rational(100001, 100000));
  }
}

/// With one distance, by hand: Y_1 = R_1/(1 - s), and (1 - s) Y_0 = R_0 + s m (Y_1 - Y_0), m the mass of the
/// neighbourhoods of vertices.
TEST(FunctionFault, CountsWhatTheVerticesSend) {
  PolyhedronCertificate c = furnace("tetrahedron", 0.25, 1);
  for (std::size_t e = 0; e < c.elements.size(); ++e)
    c.claims[e].largest =
        c.elements[e].t0 == 0 && (c.elements[e].s0 == 0 || c.elements[e].s1 == 1) ? 1 : 0.01;
  c.by_distance = {{.outside = 1, .sup = 0}, {.outside = 0, .sup = 0}};
  c.outside = 1;
  const std::vector<Rational> bounds = bounds_by_distance(c);
  const double mass = VertexMass(c)(1, 1).to_double();
  EXPECT_GT(mass, 0.5);
  EXPECT_NEAR(bounds[1].to_double(), 2, 1e-5);
  EXPECT_NEAR(bounds[0].to_double(), (0.01 + 0.5 * mass * 2) / (0.5 + 0.5 * mass), 1e-4);
  c.by_distance[0].sup = bounds[0];
  c.by_distance[1].sup = bounds[1];
  c.width = 10;
  EXPECT_FALSE(function_fault(c));
  c.by_distance[0].sup *= Rational(9999, 10000);
  EXPECT_TRUE(function_fault(c));
}

TEST(FunctionFault, SeesBoundsThatAreTooSmall) {
  const PolyhedronCertificate whole = furnace("tetrahedron", 0.25, 1);
  for (std::size_t m = 0; m < whole.by_distance.size(); ++m) {
    PolyhedronCertificate c = whole;
    c.by_distance[m].sup *= Rational(9999, 10000);
    EXPECT_TRUE(function_fault(c)) << m;
  }
  for (std::size_t e = 0; e < whole.elements.size(); ++e) {
    PolyhedronCertificate c = whole;
    c.claims[e].largest *= 1.0001;
    EXPECT_TRUE(function_fault(c)) << e;
  }
  PolyhedronCertificate c = whole;
  c.width *= Rational(9999, 10000);
  EXPECT_EQ(function_fault(c)->pointer, "/width");
  c = whole;
  c.outside = Rational(1, 3);
  EXPECT_EQ(function_fault(c)->pointer, "/function/outside");
  c = whole;
  std::swap(c.by_distance[0].outside, c.by_distance[1].outside);
  EXPECT_TRUE(function_fault(c));
  c = whole;
  c.by_distance.pop_back();
  EXPECT_TRUE(function_fault(c));
}

/// One element has a larger residual: all bounds at distances that it reaches hold it.
TEST(FunctionFault, TakesAnElementsClaimAtAllDistancesThatItReaches) {
  const PolyhedronCertificate whole = furnace("tetrahedron", 0.25, 1);
  const double plain = 0.0625;
  for (std::size_t e = 0; e < whole.elements.size(); ++e) {
    PolyhedronCertificate c = whole;
    c.claims[e].largest = 1;
    const Element& x = c.elements[e];
    const std::vector<Vector<Rational>>& p = c.faces[x.face].corners;
    Vector<double> centre{0, 0, 0};
    for (const Vector<Rational>& corner : p) centre = centre + (1.0 / 3) * rounded(corner);
    double farthest = 0;
    for (int i = 0; i <= 16; ++i)
      for (int j = 0; j <= 16; ++j) {
        const double s = x.s0 + (x.s1 - x.s0) * i / 16;
        const double t = x.t0 + (x.t1 - x.t0) * j / 16;
        const Vector<double> at =
            (1 - t) * (1 - s) * rounded(p[x.side]) + (1 - t) * s * rounded(p[(x.side + 1) % 3]) + t * centre;
        double nearest = 10;
        for (const Face& face : c.faces)
          for (const Vector<Rational>& corner : face.corners)
            nearest = std::min(nearest, norm(at - rounded(corner)));
        farthest = std::max(farthest, nearest);
      }
    for (std::size_t m = 0; m < c.by_distance.size(); ++m) c.by_distance[m].sup = bounds_by_distance(c)[m];
    c.width = 10;
    EXPECT_FALSE(function_fault(c));
    for (const BoundAtDistance& bound : c.by_distance)
      EXPECT_GE(bound.sup.to_double(), bound.outside.to_double() <= farthest - 1e-12 ? 1 : 2 * plain) << e;
  }
}

std::string text_of(const Report& report) {
  return report.refusal ? report.refusal->pointer + " " + report.refusal->says : "";
}

TEST(CheckOfAFunction, IsSharpWhereResidualsAreKnown) {
  const Part part{.elements = 12, .seed = "function"};
  const Report above = check(furnace("tetrahedron", 0.25, 1.1, true), part);
  EXPECT_FALSE(above.refusal) << text_of(above);
  EXPECT_TRUE(check(furnace("tetrahedron", 0.25, 0.999, true), part).refusal);
  // At a vertex that is known which is known of any function.
  PolyhedronCertificate c = furnace("tetrahedron", 0.25, 1.1, true);
  c.claims[2].largest *= 0.99 / 1.01;
  ASSERT_EQ(c.elements[2].t0, 0);
  ASSERT_EQ(c.elements[2].s0, 0);
  EXPECT_EQ(check(c, {.elements = all, .seed = {}}).refusal->pointer, "/claims/2/largest");
}

TEST(CheckOfAFunction, RefusesAnyNumberChanged) {
  const PolyhedronCertificate whole = furnace("tetrahedron", 0.25, 1.1, true);
  const Part part{.elements = 16, .seed = "changed"};
  const std::vector<std::size_t> chosen = chosen_elements(whole.elements.size(), part);
  const auto refuses = [&](const PolyhedronCertificate& c) { return check(c, part).refusal.has_value(); };
  ASSERT_FALSE(refuses(whole));
  Draw draw(43);
  constexpr std::size_t kinds = 8;
  for (std::size_t n = 0; n < test::repeats(2 * kinds); ++n) {
    PolyhedronCertificate c = whole;
    const double sign = draw() < 0.5 ? -1 : 1;
    std::size_t e = chosen[draw.below(chosen.size())];
    while (c.claims[e].largest > 0.1) e = chosen[draw.below(chosen.size())];
    const std::size_t face = draw.below(c.faces.size());
    switch (n % kinds) {
      case 0: c.coefficients[e] -= 0.2; break;
      case 1: c.claims[e].largest *= sign < 0 ? 0.9 : 1.01; break;
      case 2: c.by_distance[draw.below(4)].sup *= Rational(999, 1000); break;
      case 3: c.by_distance[1 + draw.below(3)].outside = 1; break;
      case 4: c.width *= Rational(999, 1000); break;
      case 5: c.faces[face].reflectivity += Rational(1, 10); break;
      case 6: c.faces[face].emission[0][0] += Rational(1, 10); break;
      default: c.faces[face].corners[draw.below(3)].x += Rational(1, 1 + static_cast<long>(draw.below(99)));
    }
    EXPECT_TRUE(refuses(c)) << n % kinds << " " << e << " " << face;
  }
}

TEST(CheckOfAFunction, VerifiesWhatASearchFound) {
  PolyhedronProblem problem =
      test::constant_problem("tetrahedron", Rational(2, 5), {1, 0, Rational(1, 2), 0});
  problem.reflectivity[3] = Rational(0);
  const FunctionEnclosure found = enclose_function(problem, 2, 0.05, {}, true);
  ASSERT_TRUE(found.proof);
  const PolyhedronCertificate c = polyhedron_certificate(problem, test::names_of("tetrahedron"), *found.proof,
                                                         Rational(2), Rational(1, 20));
  EXPECT_LE(c.width, Rational(3));
  const Report report = check(c, {.elements = 12, .seed = "search"});
  EXPECT_FALSE(report.refusal) << text_of(report);
}

/// Without a search for cells that prove what is false by far.
TEST(CheckOfAFunction, RefusesTinyClaimsAtOnce) {
  for (const double claim : {1e-3, 1e-9, 1e-14, 1e-300, 0.0}) {
    PolyhedronCertificate c = furnace("tetrahedron", 0.25, 1.1, true);
    for (Claim& own : c.claims) own.largest = std::min(own.largest, claim);
    const Report report = check(c, {.elements = all, .seed = {}});
    ASSERT_TRUE(report.refusal) << claim;
    EXPECT_EQ(report.refusal->pointer, "/claims/0/largest") << report.refusal->pointer;
  }
}

TEST(CheckOfAFunction, IsSharpPastOccluders) {
  const Part part{.elements = 6, .seed = "rooms"};
  for (const std::string name : {"l_room", "cube_in_a_cube"}) {
    const Report above = check(furnace(name, 0.25, 1.2, true), part);
    EXPECT_FALSE(above.refusal) << name << text_of(above);
    EXPECT_TRUE(check(furnace(name, 0.25, 0.999, true), part).refusal) << name;
  }
}

}  // namespace
}  // namespace radcert::certificate
