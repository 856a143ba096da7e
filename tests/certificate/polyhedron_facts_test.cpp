// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/polyhedron_facts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/certificate/samples.h"

namespace radcert::certificate {
namespace {

using test::bare_certificate;

TEST(SurfaceFault, FindsNoneInConvexPolyhedra) {
  for (const std::string name : {"cube", "box", "tetrahedron", "octahedron"}) {
    const PolyhedronCertificate c = bare_certificate(name, 2, 1, 1);
    EXPECT_FALSE(surface_fault(c)) << name;
    EXPECT_FALSE(tiling_fault(c)) << name;
    EXPECT_FALSE(reflectivity_fault(c)) << name;
  }
}

TEST(SurfaceFault, TakesTwoFacesInOnePlane) {
  PolyhedronCertificate c = bare_certificate("cube", 2, 1, 1);
  const Face square = c.faces[0];
  Face one = square;
  Face other = square;
  one.corners = {square.corners[0], square.corners[1], square.corners[2]};
  other.corners = {square.corners[0], square.corners[2], square.corners[3]};
  c.faces[0] = one;
  c.faces.push_back(other);
  EXPECT_FALSE(surface_fault(c));
  c.faces.back() = one;
  EXPECT_TRUE(surface_fault(c));
}

TEST(SurfaceFault, SeesAnyCornerThatMoves) {
  for (const std::string name : {"cube", "tetrahedron"}) {
    const PolyhedronCertificate whole = bare_certificate(name, 2, 1, 1);
    for (std::size_t f = 0; f < whole.faces.size(); ++f)
      for (std::size_t i = 0; i < whole.faces[f].corners.size(); ++i)
        for (const Rational& by : {Rational(1, 1000000), Rational(-1, 7), Rational(-2)}) {
          PolyhedronCertificate c = whole;
          c.faces[f].corners[i].x += by;
          EXPECT_TRUE(surface_fault(c)) << name << " " << f << " " << i << " " << by.to_text();
        }
  }
}

TEST(SurfaceFault, EndsBeforeItLooksAtFacesOfManyCorners) {
  PolyhedronCertificate c = bare_certificate("cube", 2, 1, 1);
  c.faces[0].corners.clear();
  constexpr int many = 100000;
  for (int i = 0; i < many; ++i) c.faces[0].corners.push_back({i, Rational(i) * Rational(i), 0});
  ASSERT_TRUE(surface_fault(c));
  EXPECT_NE(surface_fault(c)->says.find("more than are looked at"), std::string::npos);
}

TEST(SurfaceFault, SeesWhatIsMissingTurnedOrTwice) {
  const PolyhedronCertificate whole = bare_certificate("cube", 2, 1, 1);
  for (std::size_t f = 0; f < whole.faces.size(); ++f) {
    PolyhedronCertificate missing = whole;
    missing.faces[f] = missing.faces[(f + 1) % whole.faces.size()];
    missing.faces[f].piece = whole.faces[f].piece;
    EXPECT_TRUE(surface_fault(missing)) << f;
    PolyhedronCertificate turned = whole;
    std::reverse(turned.faces[f].corners.begin(), turned.faces[f].corners.end());
    EXPECT_TRUE(surface_fault(turned)) << f;
    PolyhedronCertificate crossed = whole;
    std::swap(crossed.faces[f].corners[1], crossed.faces[f].corners[2]);
    EXPECT_TRUE(surface_fault(crossed)) << f;
  }
  // Every face seen from the outside.
  PolyhedronCertificate outside = whole;
  for (Face& face : outside.faces) std::reverse(face.corners.begin(), face.corners.end());
  EXPECT_TRUE(surface_fault(outside));
  // A piece without a face.
  PolyhedronCertificate nameless = whole;
  nameless.pieces.emplace_back("nothing");
  EXPECT_TRUE(surface_fault(nameless));
}

TEST(TilingFault, SeesGapsAndOverlaps) {
  const PolyhedronCertificate whole = bare_certificate("tetrahedron", 3, 1, 1);
  for (std::size_t e = 0; e < whole.elements.size(); ++e) {
    for (double Element::*const end : {&Element::s0, &Element::s1, &Element::t0, &Element::t1})
      for (const double by : {0x1p-40, -0x1p-40, 0.125}) {
        PolyhedronCertificate c = whole;
        c.elements[e].*end += by;
        EXPECT_TRUE(tiling_fault(c)) << e;
      }
    PolyhedronCertificate missing = whole;
    missing.elements.erase(missing.elements.begin() + static_cast<std::ptrdiff_t>(e));
    EXPECT_TRUE(tiling_fault(missing));
    PolyhedronCertificate twice = whole;
    twice.elements.push_back(whole.elements[e]);
    EXPECT_TRUE(tiling_fault(twice));
    // A gap and an overlap of one size.
    const Element& x = whole.elements[e];
    PolyhedronCertificate mirrored = whole;
    mirrored.elements[e].s0 = 1 - x.s1;
    mirrored.elements[e].s1 = 1 - x.s0;
    EXPECT_EQ(tiling_fault(mirrored).has_value(), x.s0 != 1 - x.s1) << e;
    PolyhedronCertificate elsewhere = whole;
    elsewhere.elements[e].side = (elsewhere.elements[e].side + 1) % 3;
    EXPECT_TRUE(tiling_fault(elsewhere));
  }
}

TEST(ReflectivityFault, SeesOneAndNegativeNumbers) {
  for (const Rational& rho : {Rational(1), Rational(-1, 1000000), Rational(3)}) {
    PolyhedronCertificate c = bare_certificate("cube", 2, 1, 1);
    c.faces[3].reflectivity = rho;
    EXPECT_TRUE(reflectivity_fault(c));
  }
}

}  // namespace
}  // namespace radcert::certificate
