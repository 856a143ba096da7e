// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "radcert/certificate/ball_transport.h"
#include "radcert/certificate/densities.h"
#include "radcert/certificate/element_check.h"
#include "radcert/certificate/line_bounds.h"
#include "radcert/certificate/occlusion/shade.h"
#include "radcert/certificate/occlusion/sight.h"
#include "radcert/certificate/scene.h"
#include "radcert/core/parallel.h"
#include "tests/certificate/samples.h"
#include "tests/repeats.h"

namespace radcert::certificate {
namespace {

using test::Draw;

constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

std::string text_of(const Report& report) {
  return report.refusal ? report.refusal->pointer + ": " + report.refusal->says : "verified";
}

/// The part that is this element.
Part part_with(std::size_t element, std::size_t count) {
  Part part{.elements = 1, .seed = {}};
  for (int k = 0;; ++k) {
    part.seed = std::to_string(k);
    const std::vector<std::size_t> chosen = chosen_elements(count, part);
    if (std::find(chosen.begin(), chosen.end(), element) != chosen.end()) return part;
  }
}

bool holds(const Enclosure& mean, const Rational& value) { return abs(mean.midpoint - value) <= mean.radius; }

PolyhedronProblem one_face_emits() {
  return test::constant_problem("tetrahedron", Rational(1, 2), {1, 0, 0, 0});
}

const PolyhedronCertificate& small() {
  static const PolyhedronCertificate made = test::certified_solution(one_face_emits(), "tetrahedron", 0.3);
  return made;
}

TEST(Check, VerifiesWhatTheSearchFound) {
  const Report report = check(small(), {.elements = all, .seed = {}});
  EXPECT_FALSE(report.refusal) << text_of(report);
  EXPECT_EQ(report.looked_at.size(), small().elements.size());
  EXPECT_LE(small().width, Rational(2, 5));
  // Light that is emitted leaves by absorption: Int (1/rho - 1) u = Int E/rho, faces alike.
  Rational middle = 0;
  Rational radius = 0;
  for (const Enclosure& mean : small().enclosures) {
    middle += mean.midpoint;
    radius += mean.radius;
  }
  EXPECT_LE(abs(middle - Rational(2)), radius);
}

TEST(Check, VerifiesOnesInFurnaces) {
  for (const auto& [name, rho] :
       {std::pair("tetrahedron", Rational(1, 4)), std::pair("cube", Rational(2, 3))}) {
    const PolyhedronProblem furnace = test::constant_problem(name, rho, {Rational(1) - rho});
    const PolyhedronCertificate c = test::certified_solution(furnace, name, 0.4);
    for (const Enclosure& mean : c.enclosures) EXPECT_TRUE(holds(mean, 1)) << name;
    const Report report = check(c, {.elements = 6, .seed = "furnace"});
    EXPECT_FALSE(report.refusal) << name << " " << text_of(report);
  }
}

TEST(Check, VerifiesFacesThatReflectDifferentlyAndPolynomials) {
  PolyhedronProblem problem = test::constant_problem("box", Rational(3, 10), {1, 0, 2});
  problem.reflectivity[1] = Rational(0);
  problem.reflectivity[4] = Rational(7, 10);
  problem.emission[2] = PlanePolynomial<Rational>(2);
  problem.emission[2](0, 0) = Rational(1);
  problem.emission[2](1, 0) = Rational(-1, 3);
  problem.emission[2](1, 1) = Rational(1, 2);
  const PolyhedronCertificate c = test::certified_solution(problem, "box", 1.5);
  const Report report = check(c, {.elements = 8, .seed = "box"});
  EXPECT_FALSE(report.refusal) << text_of(report);
}

TEST(Check, TakesTheEmissionWhereNothingReflects) {
  const PolyhedronProblem dark = test::constant_problem("cube", 0, {1, 2, 3, 4, 5, 6});
  const PolyhedronCertificate c = polyhedron_certificate(dark, test::names_of("cube"), nullptr);
  EXPECT_FALSE(check(c, {.elements = all, .seed = {}}).refusal);
  for (std::size_t k = 0; k < c.faces.size(); ++k)
    EXPECT_TRUE(holds(c.enclosures[c.faces[k].piece], c.faces[k].emission[0][0]));
  EXPECT_LT(c.width, Rational::exactly(1e-12));
}

/// By hand: faces of the area a, S = 4 a, d = b = 1/4.
TEST(Summed, IsWhatTheTheoremSays) {
  const PolyhedronCertificate c = test::furnace_certificate("tetrahedron", 0.25, 0.25, 1.2, 0.02);
  double area = 0;
  for (const Element& x : c.elements) area += test::element_area(c, x);
  const double a = area / 4;
  const double first = 1.2 * 0.125 * std::sqrt(area / 2);
  const double dual = 0.625 * std::sqrt(area / 2);
  for (std::size_t k = 0; k < c.pieces.size(); ++k) {
    EXPECT_NEAR(c.sums.norms[0], first, 1e-12 * first);
    EXPECT_NEAR(c.sums.norms[1 + k], dual, 1e-12 * dual);
    EXPECT_NEAR(c.sums.products[k], 0.125 * a, 1e-12 * a);
    EXPECT_NEAR(c.sums.radii[k], 0.02 * area, 1e-12 * area);
    EXPECT_NEAR(c.enclosures[k].midpoint.to_double(), 1, 1e-12);
    const double radius = (0.02 * area + 2 * first * dual) / a;
    EXPECT_NEAR(c.enclosures[k].radius.to_double(), radius, 1e-6 * radius);
    EXPECT_GE(c.enclosures[k].radius.to_double(), radius * (1 - 1e-12));
  }
}

/// The residual of u = 1 - d in a furnace is d/2 on every face: claims hold just above that, and not below.
TEST(Check, IsSharpWhereResidualsAreKnown) {
  for (const std::string name : {"tetrahedron", "cube"}) {
    const Part part{.elements = 3, .seed = "sharp"};
    const Report above = check(test::furnace_certificate(name, 0.25, 0.25, 1.02, 1e-3), part);
    EXPECT_FALSE(above.refusal) << name << " " << text_of(above);
    EXPECT_TRUE(check(test::furnace_certificate(name, 0.25, 0.25, 0.999, 1e-3), part).refusal) << name;
    PolyhedronCertificate shifted = test::furnace_certificate(name, 0.25, 0.25, 1.02, 1e-3);
    const std::size_t e = chosen_elements(shifted.elements.size(), part)[1];
    shifted.claims[e].products[1] += 1.05 * shifted.claims[e].radii[1];
    shifted.sums.radii[1] *= 1.05;
    shifted.enclosures[1].radius *= Rational(2);
    shifted.width *= Rational(2);
    const Report report = check(shifted, part);
    ASSERT_TRUE(report.refusal) << name;
    EXPECT_EQ(report.refusal->pointer, "/claims/" + std::to_string(e) + "/products/1");
  }
}

/// Of a value: u = 1 is within what is stated, 1 - d/4 and the product of the norms over 1 - s = 1/2. In a
/// room T w is what it is by T 1 = 1, whatever the point sees for certain.
TEST(Summed, OfValuesIsWhatTheTheoremSays) {
  for (const std::string name : {"tetrahedron", "cube", "l_room"}) {
    const PolyhedronCertificate c = test::furnace_value_certificate(name, 0.25, 1.02, 1e-3);
    double area = 0;
    double kernel = 0;
    double own = 0;
    for (const Element& x : c.elements) {
      area += test::element_area(c, x);
      const double norm = x.face == c.points[0].face ? 0 : test::kernel_norm(c, c.points[0], x);
      if (norm == 0)
        own += 1e-4;
      else
        kernel += norm * norm;
    }
    const double first = 1.02 * 0.125 * std::sqrt(area / 2);
    const double dual = std::sqrt(1.02 * 1.02 * kernel / 2 + own);
    ASSERT_EQ(c.enclosures.size(), 1U);
    EXPECT_NEAR(c.enclosures[0].midpoint.to_double(), 1 - 0.0625, 1e-6);
    const double radius = 0.5 * (1e-3 * area + 2 * first * dual);
    EXPECT_NEAR(c.enclosures[0].radius.to_double(), radius, 1e-5 * radius);
    EXPECT_TRUE(holds(c.enclosures[0], 1));
  }
}

TEST(Check, IsSharpForTheKernelsOfPoints) {
  for (const std::string name : {"tetrahedron", "cube"}) {
    const Part part{.elements = 5, .seed = "kernels"};
    const PolyhedronCertificate below = test::furnace_value_certificate(name, 0.25, 1.02, 0.02);
    const Report above = check(below, part);
    EXPECT_FALSE(above.refusal) << name << " " << text_of(above);
    int tried = 0;
    for (const std::size_t e : chosen_elements(below.elements.size(), part)) {
      if (below.elements[e].face == below.points[0].face) continue;
      ++tried;
      PolyhedronCertificate one = below;
      one.claims[e].norms[1] *= 0.98 / 1.02;
      const Report report = check(one, part_with(e, one.elements.size()));
      ASSERT_TRUE(report.refusal) << name;
      EXPECT_EQ(report.refusal->pointer, "/claims/" + std::to_string(e) + "/norms/1");
      if (tried == 2) break;
    }
  }
}

TEST(Check, VerifiesValuesThatASearchFound) {
  PolyhedronProblem furnace = test::constant_problem("tetrahedron", Rational(1, 4), {Rational(3, 4)});
  furnace.reflectivity[2] = Rational(0);
  furnace.emission[2] = constant_polynomial(Rational(1));
  const std::vector<SolutionPoint> points{{1, furnace.panels[1].centre}, {2, furnace.panels[2].centre}};
  const GoalEnclosure found = enclose_values(furnace, points, 0.5, {}, true);
  const PolyhedronCertificate c =
      polyhedron_certificate(furnace, test::names_of("tetrahedron"), found.proof.get(), points);
  ASSERT_EQ(c.enclosures.size(), 2U);
  for (const Enclosure& value : c.enclosures) EXPECT_TRUE(holds(value, 1));
  // Black, it is lit by nothing but itself.
  EXPECT_LT(c.enclosures[1].radius, Rational::exactly(1e-12));
  EXPECT_LT(c.width, Rational::exactly(1.0));
  const Report report = check(c, {.elements = 8, .seed = "values"});
  EXPECT_FALSE(report.refusal) << text_of(report);
}

TEST(Check, TakesValuesWhereNothingIsReflected) {
  PolyhedronProblem problem = test::constant_problem("tetrahedron", Rational(1, 4), {1, 2});
  problem.reflectivity[1] = Rational(0);
  const std::vector<SolutionPoint> points{{1, problem.panels[1].centre}};
  const GoalEnclosure found = enclose_values(problem, points, 0.2, {}, true);
  const PolyhedronCertificate c =
      polyhedron_certificate(problem, test::names_of("tetrahedron"), found.proof.get(), points);
  EXPECT_TRUE(holds(c.enclosures[0], 2));
  EXPECT_FALSE(check(c, {.elements = all, .seed = {}}).refusal);
}

/// Int_X w_k t_0 = w_k |X| d/2 where the functions are constants; cells at edges are closed.
TEST(ElementCheck, EnclosesProductsThatAreKnown) {
  const PolyhedronCertificate c = test::furnace_certificate("cube", 0.25, 0.25, 1.2, 0.02);
  const Scene scene(c);
  const Densities densities(c);
  const LineBounds lines(c, scene, densities);
  const BallTransport transport(c, scene, densities, lines);
  const Sight sight(c, scene);
  const PointKernels kernels(c, scene, densities, sight);
  const Shades shades(c, densities);
  const ElementCheck elements(c, scene, densities, lines, transport, kernels, sight, shades);
  const double scale = std::ldexp(1.0, -2 * scene.exponent() - densities.exponent());
  for (const std::size_t e : {std::size_t{1}, std::size_t{3}}) {
    const double area = test::element_area(c, c.elements[e]);
    const ResidualBounds found = elements.bounds(e, {.norm = 1e-2, .product = 1e-5 * area * scale});
    for (std::size_t k = 0; k < c.pieces.size(); ++k) {
      EXPECT_LE(std::abs(found.products[k] - c.claims[e].products[k] * scale), found.radii[k])
          << e << " " << k;
      EXPECT_LE(found.radii[k], 1e-4 * area * scale) << e << " " << k;
    }
  }
}

/// A change of one number of a kind, after which something that the certificate says is false, or not what
/// follows.
struct Change {
  std::string what;
  std::size_t element = 0;  ///< whose claim is false, where no exact part of the check sees it
};

constexpr std::size_t kinds_of_change = 14;

Change change(PolyhedronCertificate& c, std::size_t kind, Draw& draw) {
  const auto sign = [&] { return draw() < 0.5 ? -1.0 : 1.0; };
  const std::size_t e = draw.below(c.elements.size());
  const std::size_t k = draw.below(c.pieces.size());
  const std::size_t face = draw.below(c.faces.size());
  const auto on_face = [&] {
    std::size_t element = 0;
    while (c.elements[element].face != face) ++element;
    return element;
  };
  const std::string at = " " + std::to_string(e) + " " + std::to_string(k) + " " + std::to_string(face);
  switch (kind) {
    case 0: {
      const std::size_t place = draw.below(c.coefficients.size());
      c.coefficients[place] += sign() * 0.5;
      return {"coefficient" + at, place / (c.powers() * c.powers()) % c.elements.size()};
    }
    case 1: {
      Vector<Rational>& corner = c.faces[face].corners[draw.below(c.faces[face].corners.size())];
      (draw() < 0.5 ? corner.x : corner.z) += Rational(1, 1 + static_cast<long>(draw.below(1000)));
      return {"corner" + at};
    }
    case 2: {
      // A residual of 0 is never claimed; half of the first one is less than there is.
      const std::size_t function = draw.below(c.functions());
      c.claims[e].norms[function] *= draw() < 0.5 ? 1.01 : function == 0 ? 0.5 : 0;
      return {"norm" + at, e};
    }
    case 3: c.claims[e].products[k] += sign() * 3 * c.claims[e].radii[k]; return {"product" + at, e};
    case 4: c.claims[e].radii[k] *= draw() < 0.5 ? 0 : 1.5; return {"radius" + at, e};
    case 5:
      c.sums.norms[draw.below(c.functions())] *= draw() < 0.5 ? 0.999 : 1.2;
      return {"sum of norms" + at};
    case 6: c.sums.products[k] += sign() * 0.01 * c.sums.radii[k]; return {"sum of products" + at};
    case 7: c.sums.radii[k] *= draw() < 0.5 ? 0.999 : 1.01; return {"sum of radii" + at};
    case 8: c.enclosures[k].midpoint += Rational::exactly(sign() * 1e-6); return {"midpoint" + at};
    case 9: c.enclosures[k].radius *= Rational(999999, 1000000); return {"radius of a mean" + at};
    case 10: c.width *= Rational(999, 1000); return {"width" + at};
    case 11:
      c.faces[face].reflectivity += Rational::exactly(sign() * 0.1);
      return {"reflectivity" + at, on_face()};
    case 12:
      c.faces[face].emission[0][0] += Rational::exactly(sign() * 0.1);
      return {"emission" + at, on_face()};
    default:
      (draw() < 0.5 ? c.elements[e].t1 : c.elements[e].s0) *= 0.5;
      if (c.elements[e].s0 == 0) c.elements[e].s0 = 0x1p-10;
      return {"element" + at};
  }
}

/// The same of a value.
constexpr std::size_t kinds_of_change_of_a_value = 9;

Change change_of_a_value(PolyhedronCertificate& c, std::size_t kind, Draw& draw) {
  const auto sign = [&] { return draw() < 0.5 ? -1.0 : 1.0; };
  const std::size_t own = c.points[0].face;
  std::size_t e = draw.below(c.elements.size());
  while (c.elements[e].face == own) e = draw.below(c.elements.size());
  const std::string at = " " + std::to_string(e);
  switch (kind) {
    case 0:
      c.points[0].at.x += Rational(1, 1 + static_cast<long>(draw.below(1000)));
      return {"point off its face"};
    case 1: {
      // Along the face: another kernel, larger on some element.
      const std::vector<Vector<Rational>>& p = c.faces[own].corners;
      const Point before = c.points[0];
      c.points[0].at = before.at + Rational::exactly(sign() * 0.1) * (p[1] - p[0]);
      while (c.elements[e].face == own || test::kernel_norm(c, c.points[0], c.elements[e]) <
                                              1.3 * test::kernel_norm(c, before, c.elements[e]))
        e = draw.below(c.elements.size());
      return {"point" + at, e};
    }
    case 2: c.points[0].face = (own + 1) % c.faces.size(); return {"face of the point"};
    case 3: c.coefficients[c.elements.size() + e] += sign() * 0.5; return {"dual" + at, e};
    case 4: c.claims[e].norms[1] *= draw() < 0.5 ? 0.7 : 1.01; return {"norm" + at, e};
    case 5: c.claims[e].products[0] += sign() * 3 * c.claims[e].radii[0]; return {"product" + at, e};
    case 6: c.enclosures[0].midpoint += Rational::exactly(sign() * 1e-5); return {"midpoint"};
    case 7: c.enclosures[0].radius *= Rational(9999, 10000); return {"radius"};
    default: c.sums.norms[1] *= draw() < 0.5 ? 0.999 : 1.2; return {"sum of norms"};
  }
}

TEST(Check, RefusesAnyNumberChanged) {
  const PolyhedronCertificate whole = test::furnace_certificate("tetrahedron", 0.25, 0.25, 1.2, 0.02);
  // Unchanged it holds.
  ASSERT_FALSE(check(whole, {.elements = 6, .seed = "unchanged"}).refusal);
  Draw draw(31);
  for (std::size_t n = 0; n < test::repeats(2 * kinds_of_change); ++n) {
    PolyhedronCertificate c = whole;
    const Change changed = change(c, n % kinds_of_change, draw);
    // The element itself is refused, and not one that the change happens to reach as well.
    const Report report = check(c, part_with(changed.element, c.elements.size()));
    EXPECT_TRUE(report.refusal) << changed.what;
  }
}

TEST(Check, RefusesAnyNumberChangedPastOccluders) {
  const PolyhedronCertificate whole = test::furnace_certificate("l_room", 0.25, 0.25, 1.2, 0.02);
  ASSERT_FALSE(check(whole, {.elements = 3, .seed = "unchanged"}).refusal);
  Draw draw(41);
  for (std::size_t n = 0; n < test::repeats(2 * kinds_of_change); ++n) {
    PolyhedronCertificate c = whole;
    const Change changed = change(c, n % kinds_of_change, draw);
    const Report report = check(c, part_with(changed.element, c.elements.size()));
    EXPECT_TRUE(report.refusal) << changed.what;
  }
}

TEST(Check, VerifiesMeansPastOccluders) {
  const PolyhedronProblem room = test::constant_problem("l_room", Rational(1, 2), {0, 0, 1, 0});
  const PolyhedronCertificate c = test::certified_solution(room, "l_room", 1);
  const Report report = check(c, {.elements = 2, .seed = "room"});
  EXPECT_FALSE(report.refusal) << text_of(report);
  // The same claims about a room of four times the height, where an element's residual is small beside what
  // arrives there.
  PolyhedronCertificate higher = c;
  for (Face& face : higher.faces)
    for (Vector<Rational>& p : face.corners) p.z *= Rational(4);
  test::put_sums(higher);
  ASSERT_FALSE(check(higher, {.elements = 0, .seed = {}}).refusal);
  const auto precision = [&](std::size_t e) {
    return std::abs(c.coefficient(0, e, 0, 0)) * std::sqrt(test::element_area(c, c.elements[e])) /
           c.claims[e].norms[0];
  };
  std::size_t best = 0;
  for (std::size_t e = 0; e < c.elements.size(); ++e)
    if (precision(e) > precision(best)) best = e;
  EXPECT_FALSE(check(c, part_with(best, c.elements.size())).refusal);
  EXPECT_TRUE(check(higher, part_with(best, c.elements.size())).refusal);
}

TEST(Check, RefusesAnyNumberOfAValueChanged) {
  const PolyhedronCertificate whole = test::furnace_value_certificate("tetrahedron", 0.25, 1.2, 0.02);
  ASSERT_FALSE(check(whole, {.elements = 4, .seed = "unchanged"}).refusal);
  Draw draw(37);
  for (std::size_t n = 0; n < test::repeats(kinds_of_change_of_a_value); ++n) {
    PolyhedronCertificate c = whole;
    const Change changed = change_of_a_value(c, n % kinds_of_change_of_a_value, draw);
    const Report report = check(c, part_with(changed.element, c.elements.size()));
    EXPECT_TRUE(report.refusal) << changed.what;
  }
}

TEST(Check, LooksAtTheSameElementsForTheSameSeed) {
  const std::vector<std::size_t> one = chosen_elements(100, {.elements = 10, .seed = "a"});
  EXPECT_EQ(one, chosen_elements(100, {.elements = 10, .seed = "a"}));
  EXPECT_NE(one, chosen_elements(100, {.elements = 10, .seed = "b"}));
  EXPECT_EQ(one.size(), 10U);
  EXPECT_TRUE(std::is_sorted(one.begin(), one.end()));
  EXPECT_EQ(chosen_elements(7, {.elements = all, .seed = {}}).size(), 7U);
}

TEST(Check, SaysTheSameForAnyNumberOfThreads) {
  PolyhedronCertificate c = test::furnace_certificate("tetrahedron", 0.25, 0.25, 1.2, 0.02);
  const Part part{.elements = 10, .seed = "threads"};
  const std::vector<std::size_t> chosen = chosen_elements(c.elements.size(), part);
  for (const std::size_t k : {std::size_t{2}, std::size_t{5}, std::size_t{9}})
    c.claims[chosen[k]].norms[0] *= 1e-3;
  const Report many = check(c, part);
  const ThreadLimit limit(1);
  const Report one = check(c, part);
  ASSERT_TRUE(many.refusal && one.refusal);
  EXPECT_EQ(text_of(many), text_of(one));
}

}  // namespace
}  // namespace radcert::certificate
