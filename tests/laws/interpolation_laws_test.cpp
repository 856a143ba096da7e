// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/laws/interpolation_laws.h"

#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "tests/surface/default_surface.h"

namespace radcert::laws {
namespace {

constexpr int largest_degree = 6;

std::vector<Surface> surfaces() {
  std::vector<Surface> all = sample::default_surfaces();
  all.push_back(two_piece(Rational(3, 2)));  // not analytic on s = 0
  return all;
}

TEST(InterpolationLaws, HoldOnTheLatticeAndAcrossSidesForEverySurfaceOfTheCatalogue) {
  for (const Surface& surface : surfaces()) {
    const Triangulation triangulation = triangulate(surface, 1);
    for (int degree = 1; degree <= largest_degree; ++degree) {
      EXPECT_TRUE(interpolates_on_the_lattice(surface, triangulation, degree, 1e-15));
      EXPECT_TRUE(joins_continuously(interpolate(surface, triangulation, degree), 2e-15));
      EXPECT_TRUE(is_fully_described(interpolate(surface, triangulation, degree).surface));
    }
  }
}

TEST(InterpolationLaws, MakePolynomialSurfacesTheirOwnInterpolants) {
  // S(p) for whole p is polynomial of degree p; affine charts are their own interpolants at every degree.
  for (int p = 1; p <= largest_degree; ++p)
    for (int degree = 1; degree <= largest_degree; ++degree) {
      const Surface surface = two_piece(p);
      EXPECT_EQ(static_cast<bool>(is_its_own_interpolant(surface, triangulate(surface, 1), degree, 1e-13)),
                degree >= p)
          << "p = " << p << ", degree " << degree;
    }
  for (const char* name : {"cube", "two_squares"}) {
    const Surface surface = find_surface(name)->make({});
    EXPECT_TRUE(is_its_own_interpolant(surface, triangulate(surface, 1), 1, 1e-15));
  }
}

TEST(InterpolationLaws, RejectAnotherTriangulationAndAnotherDegree) {
  const Surface roof = two_piece(3);
  const InterpolatedSurface interpolant = interpolate(roof, triangulate(roof, 1), 2);
  EXPECT_GT(interpolation_error(roof, triangulate(roof, 0), interpolate(roof, triangulate(roof, 0), 2)).point,
            interpolation_error(roof, triangulate(roof, 1), interpolant).point);
  // Elements of different degrees do not fit together.
  InterpolatedSurface patched = interpolant;
  const InterpolatedSurface flatter = interpolate(roof, triangulate(roof, 1), 1);
  patched.surface.charts.back() = flatter.surface.charts.back();
  EXPECT_TRUE(joins_continuously(interpolant, 1e-15));
  EXPECT_FALSE(joins_continuously(patched, 1e-15));
}

}  // namespace
}  // namespace radcert::laws
