// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/cubature/square_maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "radcert/reference/cubature/gauss_rule.h"
#include "radcert/reference/cubature/sinh_cosh.h"

namespace radcert::reference {
namespace {

TEST(SinhCosh, AreThoseOfTheLibrary) {
  for (double x = -45; x <= 45; x += 0.0137) {
    const SinhCosh value = sinh_cosh(x);
    EXPECT_NEAR(value.cosh.lane(3) / std::cosh(x), 1, 1e-15) << x;
    EXPECT_NEAR(value.sinh.lane(5) / std::cosh(x), std::tanh(x), 1e-15) << x;
  }
  const SinhCosh far = sinh_cosh(700.0);
  EXPECT_NEAR(far.cosh.lane(0) / std::cosh(700.0), 1, 1e-15);
  EXPECT_EQ(sinh_cosh(0.0).sinh.lane(0), 0);
}

TEST(Spacing, GoesFrom0To1WithItsSlope) {
  const std::vector<Spacing> all{{},
                                 {.kind = Spacing::Kind::power},
                                 Spacing::centred(0, 1e-3),
                                 Spacing::centred(0, 2),
                                 Spacing::centred(0.3, 1e-8),
                                 Spacing::centred(1, 0.1)};
  for (const Spacing& g : all) {
    EXPECT_NEAR(g(0.0).position.lane(0), 0, 1e-15);
    EXPECT_NEAR(g(1.0).position.lane(7), 1, 1e-14);
    for (double x = 0.05; x < 1; x += 0.1) {
      constexpr double step = 1e-6;
      const double difference = (g(x + step).position.lane(0) - g(x - step).position.lane(0)) / (2 * step);
      EXPECT_NEAR(g(x).slope.lane(1), difference, 1e-6 * (1 + std::abs(difference))) << x;
    }
  }
}

/// Int over the image of s^a t^b, with parameters counted from `apex`, by one product rule.
template <class Map>
double moment(const Map& map, const Spacing& spacing, const Parameters& apex, int a, int b) {
  const GaussRule& rule = GaussRule::of(GaussRule::largest);
  double sum = 0;
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const Line<Pack> line = map.line(rule.nodes()[i]);
    for (std::size_t j = 0; j < rule.size(); ++j) {
      const Spacing::Values g = spacing(rule.nodes()[j]);
      const Pack r = line.start + line.extent * g.position;
      Pack area = line.factor * line.extent * g.slope;
      if (Map::from_one_point) area = area * r;
      const double s = apex.s + (line.base.s + r * line.direction.s).lane(0);
      const double t = apex.t + (line.base.t + r * line.direction.t).lane(0);
      sum += rule.weights()[i] * rule.weights()[j] * area.lane(0) * std::pow(s, a) * std::pow(t, b);
    }
  }
  return sum;
}

TEST(SquareMaps, CoverTheirImageOnce) {
  // The triangle (0,0), (1,0), (0,1) has the moments a! b! / (a + b + 2)!.
  const auto truth = [](int a, int b) {
    return std::tgamma(a + 1) * std::tgamma(b + 1) / std::tgamma(a + b + 3);
  };
  const Collapse collapse{{1, 0}, {-1, 1}, 1};
  const double height = std::sqrt(0.5);
  const double end = std::asinh(1.0);
  Sector sector{};
  sector.normal = {height, height};
  sector.tangent = {-height, height};
  sector.height = height;
  sector.start = -end;
  sector.extent = 2 * end;
  sector.density = 1;
  Sector from_the_end = sector;
  from_the_end.spacing = {.kind = Spacing::Kind::power};
  from_the_end.from_end = true;
  Sector graded = sector;
  graded.spacing = Spacing::centred(0, 0.1);
  Slab slab{};
  slab.graded = true;
  slab.to_z = slab.to_s = 1;
  slab.upper_from = 1;
  slab.apex = {0.25, 0.5};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      EXPECT_NEAR(moment(collapse, {}, {0, 0}, a, b), truth(a, b), 1e-14);
      EXPECT_NEAR(moment(sector, Spacing::centred(0, 0.1), {0, 0}, a, b), truth(a, b), 1e-14);
      EXPECT_NEAR(moment(from_the_end, {.kind = Spacing::Kind::power}, {0, 0}, a, b), truth(a, b), 1e-14);
      EXPECT_NEAR(moment(graded, {}, {0, 0}, a, b), truth(a, b), 1e-14);
      EXPECT_NEAR(moment(slab, Spacing::centred(0.4, 0.2), slab.apex, a, b), truth(a, b), 1e-14);
    }
}

}  // namespace
}  // namespace radcert::reference
